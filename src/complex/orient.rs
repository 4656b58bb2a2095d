//! Turning faces so that they agree, and point out of the material.

use super::closest::{cross, dot};
use super::hierarchy::{Hierarchy, Simplex, meets};
use super::measure::{Frame, Sum};
use super::skeleton::{Groups, Skeleton, filled};
use super::surface::Patches;
use super::{Complex, Point, Rows, fan, fans};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use crate::points::Bounds;
use crate::predicates::{Sign, coplanar_orientation, orient3d};

/// The number of steps between two ticks.
const BATCH: usize = 1 << 12;

impl Complex {
    /// The same complex with its faces turned so that neighbours agree and solids are inside.
    ///
    /// A *patch* is a set of faces connected across edges that two faces share. Where a patch can
    /// be oriented, its faces are made to agree. A patch that is closed by itself, a *shell*, then
    /// points out if an even number of other shells hold it, and in otherwise: it bounds
    /// a void. Shells are taken as disjoint; one that crosses another is put where one of its
    /// vertices lies. Any other patch, and a shell whose volume is no more than rounding,
    /// is turned whichever way turns fewer faces. Faces of a patch that cannot be oriented stay as
    /// they are. A turned face keeps its first vertex, and every attribute stays.
    ///
    /// Errors: those of the job, and [`Status::LimitExceeded`](crate::Status::LimitExceeded) past
    /// 2^31 - 1 sides of faces and facets. Cost: O(n log n); inclusion is decided exactly.
    pub fn oriented(&self, job: &Job) -> Result<Complex> {
        job.run(&[(Stage::Topology, 1.0)], |run| self.oriented_in(run))
    }

    /// [`Complex::oriented`] as a stage of a larger operation.
    pub(crate) fn oriented_in(&self, run: &Run<'_>) -> Result<Complex> {
        run.enter(Stage::Topology)?;
        let sides = self.faces.indices().len() + 12 * self.cells.len();
        // The skeleton, the patches, the shells' triangles, and the complex that is returned. Measured.
        let _charge = run.charge(160 * sides as u64 + 64 * self.vertices.len() as u64)?;
        let skeleton = Skeleton::new(self, run)?;
        let turned = turned_faces(self, &skeleton, run)?;
        let mut complex = self.clone();
        let mut faces = Rows::default();
        let mut ring: Vec<u32> = Vec::new();
        for (row, face) in self.faces.iter().enumerate() {
            if row % BATCH == 0 {
                run.poll()?;
            }
            let f = skeleton.face_of_row[row] as usize;
            ring.clear();
            ring.extend_from_slice(face);
            // A face listed twice may be listed either way.
            if turned[f] == runs_along(face, skeleton.ring(f)) {
                ring[1..].reverse();
            }
            faces.push(&ring)?;
        }
        complex.faces = faces;
        complex.triangles = fans(&complex.faces, run)?.0;
        Ok(complex)
    }
}

/// Whether two equal rings run the same way.
fn runs_along(ring: &[u32], other: &[u32]) -> bool {
    let n = ring.len();
    (0..n).any(|start| (0..n).all(|k| ring[k] == other[(start + k) % n]))
}

/// For each listed face whether it must be turned round.
fn turned_faces(complex: &Complex, skeleton: &Skeleton, run: &Run<'_>) -> Result<Vec<bool>> {
    let mut patches = Patches::new(skeleton, run)?;
    let faces = skeleton.listed;
    // By least face: how many faces agree with it less those that do not.
    let mut majority = filled(faces, 0i64, run)?;
    for f in run.watch(0..faces as u32) {
        let (patch, against) = patches.of(f?);
        majority[patch as usize] += if against { -1 } else { 1 };
    }
    let mut turn: Vec<bool> = run.try_vec(faces)?;
    turn.extend(majority.iter().map(|&m| m < 0));

    let shells = Shells::new(complex, skeleton, &mut patches, run)?;
    let least = shells.least_faces.len();
    for shell in 0..least {
        run.tick(shell, least)?;
        if let Some(outward) = shells.points_out(shell) {
            let solid = shells.depth(shell, run)?.is_multiple_of(2);
            turn[shells.least_faces[shell] as usize] = outward != solid;
        }
    }
    let mut turned: Vec<bool> = run.try_vec(faces)?;
    turned.extend((0..faces as u32).map(|f| {
        let (patch, against) = patches.of(f);
        patches.orientable(f) && against != turn[patch as usize]
    }));
    Ok(turned)
}

/// The patches that are closed by themselves, each oriented as its least face.
struct Shells {
    least_faces: Vec<u32>,
    /// The triangles of every shell, tagged with its number, for exact tests.
    triangles: Hierarchy<3>,
    /// The vertices of each shell, some more than once.
    vertices: Groups,
    positions: Vec<Point>,
    volumes: Vec<Volume>,
}

impl Shells {
    fn new(
        complex: &Complex,
        skeleton: &Skeleton,
        patches: &mut Patches,
        run: &Run<'_>,
    ) -> Result<Self> {
        let closed = closed_patches(skeleton, patches, run)?;
        run.poll()?;
        let least_faces: Vec<u32> =
            (0..skeleton.listed as u32).filter(|&f| closed[f as usize]).collect();
        let mut number = filled(skeleton.listed, NONE, run)?;
        for (i, &f) in least_faces.iter().enumerate() {
            number[f as usize] = i as u32;
        }
        let mut shell_of_face: Vec<u32> = run.try_vec(skeleton.listed)?;
        shell_of_face.extend((0..skeleton.listed as u32).map(|f| number[patches.of(f).0 as usize]));

        run.poll()?;
        let bounds = Bounds::of(complex.vertices.iter().copied());
        let frame = Frame::new(&bounds.unwrap_or(Bounds { min: [0.0; 3], max: [0.0; 3] }));
        let mut positions: Vec<Point> = run.try_vec(complex.vertices.len())?;
        positions.extend(complex.vertices.iter().map(|&p| frame.scaled(p)));

        let mut volumes = vec![Volume::default(); least_faces.len()];
        let mut triangles = Vec::new();
        for (f, &shell) in shell_of_face.iter().enumerate() {
            if f % BATCH == 0 {
                run.poll()?;
            }
            if shell == NONE {
                continue;
            }
            for t in fan(skeleton.ring(f)) {
                let relative = t.map(|v| frame.relative(complex.vertices[v as usize]));
                volumes[shell as usize].add(relative, patches.of(f as u32).1);
                if least_faces.len() > 1 {
                    let corners = t.map(|v| positions[v as usize]);
                    triangles.push(Simplex { corners, tag: shell });
                }
            }
        }
        let end = if skeleton.listed == 0 { 0 } else { skeleton.sides(skeleton.listed - 1).end };
        let shell_of_side = |s: usize| shell_of_face[skeleton.face_of_side[s] as usize];
        let mut vertices = Groups::new(least_faces.len(), end, shell_of_side, run)?;
        vertices.replace(|side| skeleton.tail(side));
        let triangles = Hierarchy::new(&triangles, &mut Room::new(run), run)?;
        Ok(Shells { least_faces, triangles, vertices, positions, volumes })
    }

    /// Whether the shell, oriented as its least face, points out, if its volume can tell.
    fn points_out(&self, shell: usize) -> Option<bool> {
        let Volume { signed, noise } = self.volumes[shell];
        let volume = signed.value();
        (volume.abs() > 32.0 * f64::EPSILON * noise).then_some(volume > 0.0)
    }

    /// The number of other shells that hold this one.
    fn depth(&self, shell: usize, run: &Run<'_>) -> Result<usize> {
        if self.least_faces.len() == 1 {
            return Ok(0);
        }
        // A vertex that touches no other shell, or else the first.
        let mut depth_of_first = None;
        for &v in self.vertices.get(shell) {
            run.poll()?;
            let (depth, touches) = self.depth_of_point(self.positions[v as usize], shell as u32);
            if !touches {
                return Ok(depth);
            }
            depth_of_first.get_or_insert(depth);
        }
        Ok(depth_of_first.unwrap_or(0))
    }

    /// The number of shells but one that hold a point, and whether the point may lie on one.
    fn depth_of_point(&self, q: Point, but: u32) -> (usize, bool) {
        // Everything above the point, and the point itself.
        let above = Bounds { min: q, max: [q[0], q[1], f64::MAX] };
        let itself = Bounds { min: q, max: q };
        let mut crossed: Vec<u32> = Vec::new();
        let mut touches = false;
        self.triangles.meeting(&above, |triangle| {
            if triangle.tag == but {
                return;
            }
            let [a, b, c] = &triangle.corners;
            let side = orient3d(a, b, c, &q);
            touches |= side.is_zero() && meets(&triangle.bounds(), &itself);
            let turn = turn_round(&q, &triangle.corners);
            if !turn.is_zero() && side == -turn {
                crossed.push(triangle.tag);
            }
        });
        crossed.sort_unstable();
        let odd = crossed.chunk_by(|s, t| s == t).filter(|run| run.len() % 2 == 1);
        (odd.count(), touches)
    }
}

/// Which way a triangle, seen from above, turns round a point, if at all.
///
/// The point counts as moved by an infinitesimal step along x and a far smaller one along y, so that
/// it lies on no edge; hence exactly one of the triangles that cover its neighbourhood once
/// turns round it. A point level with the triangle counts as above it, which is the same
/// perturbation with a first step along z.
fn turn_round(q: &Point, corners: &[Point; 3]) -> Sign {
    let flat = |p: &Point| [p[0], p[1], 0.0];
    let edge = |a: &Point, b: &Point| {
        let sign = coplanar_orientation(&flat(a), &flat(b), &flat(q));
        // The orientation falls with x where the edge goes up, and rises with y where it goes right.
        let steps = [sign, Sign::of(a[1] - b[1]), Sign::of(b[0] - a[0])];
        steps.into_iter().find(|sign| !sign.is_zero()).unwrap_or(Sign::Zero)
    };
    let [a, b, c] = corners;
    let turns = [edge(a, b), edge(b, c), edge(c, a)];
    if turns[0] == turns[1] && turns[1] == turns[2] { turns[0] } else { Sign::Zero }
}

/// Whether each patch, by its least face, can be oriented and is closed by itself.
fn closed_patches(skeleton: &Skeleton, patches: &mut Patches, run: &Run<'_>) -> Result<Vec<bool>> {
    let mut closed: Vec<bool> = run.try_vec(skeleton.listed)?;
    for f in run.watch(0..skeleton.listed as u32) {
        let f = f?;
        closed.push(patches.of(f).0 == f && patches.orientable(f));
    }
    let mut at: Vec<(u32, i32)> = Vec::new();
    for e in 0..skeleton.edges.len() {
        if e % BATCH == 0 {
            run.poll()?;
        }
        at.clear();
        for &side in skeleton.listed_sides_of_edge(e) {
            let (patch, against) = patches.of(skeleton.face_of_side[side as usize]);
            at.push((patch, if skeleton.is_forward(side) != against { 1 } else { -1 }));
        }
        at.sort_unstable();
        for sides in at.chunk_by(|s, t| s.0 == t.0) {
            // Each patch must run the edge equally often both ways.
            if sides.iter().map(|side| side.1).sum::<i32>() != 0 {
                closed[sides[0].0 as usize] = false;
            }
        }
    }
    Ok(closed)
}

/// A volume, six times over, and a bound on its rounding errors, in units of the last place.
#[derive(Clone, Copy, Default)]
struct Volume {
    signed: Sum,
    noise: f64,
}

impl Volume {
    fn add(&mut self, [a, b, c]: [Point; 3], against: bool) {
        let part = dot(a, cross(b, c));
        self.signed.add(if against { -part } else { part });
        self.noise += (dot(a, a) * dot(b, b) * dot(c, c)).sqrt();
    }
}

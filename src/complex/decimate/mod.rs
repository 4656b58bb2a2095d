//! Fewer triangles for the same surface: edges are contracted, the cheapest first.

mod deviation;
mod mesh;
mod quadric;

use super::measure::Frame;
use super::{Attribute, Complex, ComplexParts, Element, Rows};
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use crate::points::Bounds;
use crate::vector::{Vec3, add, cross, dot, sub};
use deviation::Deviation;
use mesh::{Mesh, Star};
use quadric::Quadric;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The cosine of the greatest angle by which a triangle may turn at once.
const TURN: f64 = 0.2;
/// Twice a triangle's area counts as none below this share of its longest side squared.
const NEEDLE: f64 = 1e-10;
/// What rounding may add to a distance, as a share of the largest coordinate.
const ROUNDING: f64 = 1e-12;

/// The settings of [`Complex::decimate`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DecimateOptions {
    /// The number of triangles to come down to; 0, the default, means as few as can be.
    pub triangles: usize,
    /// The greatest distance, in input units, that the surface may come away from what it was; none by default.
    /// With it the aim may be missed.
    pub max_error: Option<f64>,
}

impl Complex {
    /// The same surface with fewer triangles: edges are contracted in the order of the error that their quadrics tell
    /// (Garland and Heckbert 1997), until so many triangles are left or none can go.
    ///
    /// Faces become triangles first. Components, genus, boundary loops and orientation stay; no triangle turns
    /// over. Vertices on loose edges, on cells, on edges of more than two triangles, and vertices whose triangles are
    /// more than one fan stay as they are, with all edges at them. So do loose edges, cells, their attributes, and
    /// vertices that no triangle uses. Attributes of vertices and faces are left out: they no longer fit. Triangles
    /// with a vertex twice, which come from faces that do so, are left out too. Vertices keep their order.
    ///
    /// With [`DecimateOptions::max_error`] distances are measured, and a contraction that would exceed it is not
    /// made: from the vertices of the input and the centres of its triangles to the result, and from the vertices of the
    /// result, the centres of its triangles and the middles of their sides to the input. Between these points
    /// the surfaces may be a little further apart.
    ///
    /// Errors: [`Status::InvalidArgument`] when `max_error` is negative or not a number; those of the job. Cost:
    /// O(n log n) where no vertex has very many triangles; some three times that with `max_error`.
    pub fn decimate(&self, options: DecimateOptions, job: &Job) -> Result<Complex> {
        job.run(&[(Stage::Decimate, 1.0)], |run| self.decimate_in(options, run))
    }

    /// [`Complex::decimate`] as a stage of a larger operation.
    pub(crate) fn decimate_in(&self, options: DecimateOptions, run: &Run<'_>) -> Result<Complex> {
        run.enter(Stage::Decimate)?;
        if options.max_error.is_some_and(|limit| limit.is_nan() || limit < 0.0) {
            let message = "the greatest error must not be negative";
            return Err(Error::new(Status::InvalidArgument, message));
        }
        let Some(bounds) = Bounds::of(self.vertices.iter().copied()) else {
            return Ok(self.clone());
        };
        let frame = Frame::new(&bounds);
        let mut room = Room::new(run);
        let at = room.collect(self.vertices.iter().map(|&p| frame.scaled(p)))?;
        let mut fixed = room.filled(at.len(), false)?;
        for &v in self.edges.as_flattened().iter().chain(self.cells.indices()) {
            fixed[v as usize] = true;
        }
        let mut triangles = room.vec(self.triangles.len())?;
        for triangle in run.watch(&self.triangles) {
            let &[a, b, c] = triangle?;
            if a == b || b == c || c == a {
                [a, b, c].into_iter().for_each(|v| fixed[v as usize] = true);
            } else {
                triangles.push([a, b, c]);
            }
        }
        let deviation = match options.max_error {
            Some(limit) if limit.is_finite() => {
                let limit = limit * frame.scale + ROUNDING;
                Some(Deviation::new(&triangles, &at, limit, &mut room, run)?)
            }
            _ => None,
        };
        let mesh = Mesh::new(triangles, fixed, &mut room, run)?;
        let quadrics = quadrics(&mesh, &at, &mut room, run)?;
        let mut work = Work { mesh, at, quadrics, deviation, queue: BinaryHeap::new(), room };
        work.contract_to(options.triangles, run)?;
        let Work { mesh, at, .. } = work;
        self.assembled(&mesh, &at, &frame, run)
    }

    /// The complex that is left, its vertices in their order.
    fn assembled(&self, mesh: &Mesh, at: &[Vec3], frame: &Frame, run: &Run<'_>) -> Result<Complex> {
        let mut room = Room::new(run);
        // A vertex is gone if the input's triangles use it and those that are left do not.
        let mut number = room.filled(at.len(), 0u32)?;
        for &v in self.triangles.as_flattened() {
            number[v as usize] = NONE;
        }
        let kept = mesh.triangles.iter().filter(|t| t[0] != NONE);
        let rest = self.edges.as_flattened().iter().chain(self.cells.indices());
        for v in run.watch(kept.clone().flatten().chain(rest)) {
            number[*v? as usize] = 0;
        }
        let mut vertices = Vec::new();
        for v in run.watch(0..at.len()) {
            let v = v?;
            if number[v] == NONE {
                continue;
            }
            number[v] = vertices.len() as u32;
            let (before, now) = (self.vertices[v], at[v]);
            // What has not moved keeps every bit; what has may not leave the range of an f64, nor the plane.
            let mut p = before;
            if now != frame.scaled(before) {
                p = now.map(|x| (x / frame.scale).clamp(-f64::MAX, f64::MAX));
            }
            if self.dimension == 2 {
                p[2] = 0.0;
            }
            room.push(&mut vertices, p)?;
        }
        let mut faces = room.vec(mesh.count)?;
        for triangle in run.watch(kept) {
            faces.push(triangle?.map(|v| number[v as usize]));
        }
        let cells: Vec<u32> =
            room.collect(self.cells.indices().iter().map(|&v| number[v as usize]))?;
        let stays = |a: &&Attribute| matches!(a.element(), Element::Edge | Element::Cell);
        let parts = ComplexParts {
            dimension: self.dimension,
            vertices,
            faces: Rows::uniform_in(faces, &mut room)?,
            edges: room.collect(self.edges.iter().map(|e| e.map(|v| number[v as usize])))?,
            cells: Rows::new(self.cells.offsets().to_vec(), cells)?,
            cell_types: self.cell_types.clone(),
            attributes: self.attributes.iter().filter(stays).cloned().collect(),
        };
        Complex::sound_in(parts, run)
    }
}

/// The quadric of each vertex: the planes of its triangles, the lines of its boundary edges.
fn quadrics(mesh: &Mesh, at: &[Vec3], room: &mut Room<'_>, run: &Run<'_>) -> Result<Vec<Quadric>> {
    let mut quadrics: Vec<Quadric> = room.filled(at.len(), Quadric::default())?;
    for triangle in run.watch(&mesh.triangles) {
        let triangle = *triangle?;
        let corners = triangle.map(|v| at[v as usize]);
        let plane = Quadric::of_triangle(corners);
        for (v, p) in triangle.into_iter().zip(corners) {
            let quadric = &mut quadrics[v as usize];
            *quadric = quadric.plus(&plane.moved(sub(p, corners[0])));
        }
        for k in 0..3 {
            let (u, v) = (triangle[k], triangle[(k + 1) % 3]);
            if mesh.is_boundary(u, v) {
                for (u, v) in [(u, v), (v, u)] {
                    let line = Quadric::of_boundary(at[u as usize], at[v as usize]);
                    quadrics[u as usize] = quadrics[u as usize].plus(&line);
                }
            }
        }
    }
    Ok(quadrics)
}

/// An edge that may be contracted: the cost's bits, which order as it does, the ends, and how often they have changed.
type Candidate = Reverse<(u64, u32, u32, u32)>;

/// What changes while edges are contracted.
struct Work<'a> {
    mesh: Mesh,
    at: Vec<Vec3>,
    quadrics: Vec<Quadric>,
    deviation: Option<Deviation>,
    queue: BinaryHeap<Candidate>,
    room: Room<'a>,
}

impl Work<'_> {
    /// Contracts edges until so many triangles are left, or none can go.
    fn contract_to(&mut self, aim: usize, run: &Run<'_>) -> Result<()> {
        let start = self.mesh.count;
        let (mut star, mut near) = (Vec::new(), Vec::new());
        while self.mesh.count > aim {
            // An edge that was refused may be free now that others are gone: all come again, as long as that pays.
            let before = self.mesh.count;
            for u in run.watch(0..self.at.len() as u32) {
                let u = u?;
                self.mesh.neighbours(u, &mut star, &mut near);
                for &v in near.iter().filter(|&&v| v > u) {
                    self.offer(u, v)?;
                }
            }
            self.empty_queue(aim, start, run)?;
            if before - self.mesh.count <= before / 100 {
                break;
            }
        }
        Ok(())
    }

    fn empty_queue(&mut self, aim: usize, start: usize, run: &Run<'_>) -> Result<()> {
        let mut star = Star::default();
        let (mut around, mut near) = (Vec::new(), Vec::new());
        let mut after = Vec::new();
        let mut turn = 0usize;
        while self.mesh.count > aim
            && let Some(Reverse((_, u, v, stamp))) = self.queue.pop()
        {
            turn += 1;
            if turn.is_multiple_of(64) {
                run.tick(start - self.mesh.count, start - aim)?;
            }
            if stamp != self.stamp(u, v) || !self.mesh.contractible(u, v, &mut star) {
                continue;
            }
            let (quadric, _, p) = self.target(u, v);
            if !self.keeps_shape(u, v, p, &star, &mut after) {
                continue;
            }
            if let Some(deviation) = &mut self.deviation {
                let triangles = &self.mesh.triangles;
                let others = star.second.iter().filter(|&&t| !triangles[t as usize].contains(&u));
                let old = star.first.iter().chain(others).copied();
                if !deviation.allows(old, &after, p, run)? {
                    continue;
                }
            }
            self.mesh.contract(u, v, &star);
            self.quadrics[u as usize] = quadric.moved(sub(p, self.at[u as usize]));
            self.at[u as usize] = p;
            self.mesh.neighbours(u, &mut around, &mut near);
            for &w in &near {
                self.offer(u.min(w), u.max(w))?;
            }
        }
        Ok(())
    }

    fn stamp(&self, u: u32, v: u32) -> u32 {
        // Both only ever grow, so that the sum is the same only if both are.
        self.mesh.stamp[u as usize].wrapping_add(self.mesh.stamp[v as usize])
    }

    /// The quadric of both ends, about the first one; what contracting the edge costs, and where to.
    fn target(&self, u: u32, v: u32) -> (Quadric, f64, Vec3) {
        let (p, q) = (self.at[u as usize], self.at[v as usize]);
        let other = self.quadrics[v as usize].moved(sub(p, q));
        let sum = self.quadrics[u as usize].plus(&other);
        let (cost, x) = sum.target(sub(q, p));
        // Ends are taken as they are, so that they keep every bit.
        let x = if x == sub(q, p) { q } else { add(p, x) };
        (sum, cost, x)
    }

    fn offer(&mut self, u: u32, v: u32) -> Result<()> {
        if self.mesh.fixed[u as usize] || self.mesh.fixed[v as usize] {
            return Ok(());
        }
        if self.queue.len() == self.queue.capacity() {
            let extra = self.queue.len().max(64);
            let bytes = extra.saturating_mul(size_of::<Candidate>());
            self.room.keep(bytes)?;
            self.queue.try_reserve_exact(extra).map_err(|_| {
                Error::new(Status::OutOfMemory, format!("{bytes} bytes are not to be had"))
            })?;
        }
        let (_, cost, _) = self.target(u, v);
        self.queue.push(Reverse((cost.to_bits(), u, v, self.stamp(u, v))));
        Ok(())
    }

    /// Whether the triangles round an edge keep their direction when it is contracted to `p`, and none of them
    /// loses its area. Those without area are held against the sum of the others. Collects what they become.
    fn keeps_shape(
        &self,
        u: u32,
        v: u32,
        p: Vec3,
        star: &Star,
        after: &mut Vec<(u32, [Vec3; 3])>,
    ) -> bool {
        after.clear();
        let corners = |t: u32| self.mesh.triangles[t as usize].map(|w| self.at[w as usize]);
        let all = star.first.iter().chain(&star.second);
        let sum = all.clone().fold([0.0; 3], |sum, &t| add(sum, normal(&corners(t)).0));
        for &t in all {
            let triangle = self.mesh.triangles[t as usize];
            if triangle.contains(&u) && triangle.contains(&v) {
                continue;
            }
            let old = corners(t);
            let mut new = old;
            for (w, x) in triangle.into_iter().zip(&mut new) {
                if w == u || w == v {
                    *x = p;
                }
            }
            let ((n, had_area), (m, has_area)) = (normal(&old), normal(&new));
            let against = if had_area { n } else { sum };
            let bound = if had_area { TURN } else { -TURN };
            let turned = dot(m, against) < bound * (dot(m, m) * dot(against, against)).sqrt();
            if had_area && !has_area || has_area && turned {
                return false;
            }
            after.push((t, new));
        }
        true
    }
}

/// A vector along the normal of a triangle, twice as long as its area, and whether there is any to speak of.
fn normal([a, b, c]: &[Vec3; 3]) -> (Vec3, bool) {
    let (ab, bc, ca) = (sub(*b, *a), sub(*c, *b), sub(*a, *c));
    let n = cross(ab, bc);
    let longest = dot(ab, ab).max(dot(bc, bc)).max(dot(ca, ca));
    (n, dot(n, n) > NEEDLE * NEEDLE * longest * longest)
}

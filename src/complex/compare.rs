//! How far two complexes are apart: the two-sided distances.

use super::closest::{cross, dot, sub};
use super::hierarchy::{Hierarchy, Simplex};
use super::measure::{Frame, Sum};
use super::skeleton::Skeleton;
use super::{Complex, Point, fan};
use crate::error::{Error, Result, Status};
use crate::job::{Job, Room, Run, Stage};
use crate::points::Bounds;
use std::borrow::Cow;

/// The settings of [`compare`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CompareOptions {
    /// The number of samples on each side, 100,000 by default. With 0 the vertices serve.
    pub samples: usize,
    /// Chooses the samples. The same seed gives the same samples on every machine.
    pub seed: u64,
}

impl Default for CompareOptions {
    fn default() -> Self {
        CompareOptions { samples: 100_000, seed: 0 }
    }
}

/// The distances from points of one complex to the other, in input units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distances {
    /// The largest, over vertices and samples: no more than the one-sided Hausdorff distance, and
    /// closer to it the more samples there are.
    pub max: f64,
    /// The mean over the samples.
    pub mean: f64,
    /// The root of the mean square over the samples.
    pub rms: f64,
}

/// What [`compare`] found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Comparison {
    /// From the first complex to the second.
    pub a_to_b: Distances,
    /// From the second complex to the first.
    pub b_to_a: Distances,
    /// The diagonal of the smallest axis-parallel box that holds both complexes.
    pub diagonal: f64,
}

/// Compares two complexes as sets of points in space.
///
/// A complex with faces, loose edges or cells stands for the union of these; cells are solid, and
/// vertices that nothing uses play no part. Without any, its vertices are the set.
///
/// Distances are taken from every vertex of the set, and from samples: uniform by area on the
/// faces and on the skin of the cells; or, where there is no area, uniform by length on the
/// edges; or, where there is no length either, the vertices themselves. The nearest
/// point is found on triangles, edges and vertices, not among samples.
///
/// Errors: [`Status::TooFewPoints`] when a side has no vertex, [`Status::CoordinateRange`] when a
/// distance is beyond the range of an f64, those of the job. Cost: O((n + samples) log n).
pub fn compare(
    a: &Complex,
    b: &Complex,
    options: &CompareOptions,
    job: &Job,
) -> Result<Comparison> {
    job.run(&[(Stage::Query, 1.0)], |run| compare_in(a, b, options, run))
}

/// [`compare`] as a stage of a larger operation.
pub(crate) fn compare_in(
    a: &Complex,
    b: &Complex,
    options: &CompareOptions,
    run: &Run<'_>,
) -> Result<Comparison> {
    run.enter(Stage::Query)?;
    let used = [used_vertices(a, run)?, used_vertices(b, run)?];
    let place = |c: &'_ Complex, used: &[u32]| {
        Bounds::of(used.iter().map(|&v| c.vertices[v as usize]))
            .ok_or_else(|| Error::new(Status::TooFewPoints, "a complex to compare has no vertices"))
    };
    let (box_a, box_b) = (place(a, &used[0])?, place(b, &used[1])?);
    let corners = [box_a.min, box_a.max, box_b.min, box_b.max];
    let frame = Frame::new(&Bounds::of(corners.into_iter()).unwrap_or(box_a));
    let diagonal = Bounds::of(corners.into_iter().map(|p| frame.scaled(p)));
    let diagonal = diagonal.map_or(0.0, |bounds| bounds.diagonal()) / frame.scale;
    if !diagonal.is_finite() {
        let message = "the complexes are so large that distances are not numbers; rescale them";
        return Err(Error::new(Status::CoordinateRange, message));
    }
    let [used_a, used_b] = used;
    let a = Side::new(a, used_a, &frame, run)?;
    let b = Side::new(b, used_b, &frame, run)?;
    let mut progress = Progress { done: 0, total: a.steps(options) + b.steps(options) };
    Ok(Comparison {
        a_to_b: a.distances_to(&b, options, &mut progress, run)?,
        b_to_a: b.distances_to(&a, options, &mut progress, run)?,
        diagonal,
    })
}

/// The vertices that a face, edge or cell uses, ascending; all of them where there is none of these.
fn used_vertices(complex: &Complex, run: &Run<'_>) -> Result<Vec<u32>> {
    let rows = [complex.faces.indices(), complex.edges.as_flattened(), complex.cells.indices()];
    let none = rows.iter().all(|row| row.is_empty());
    let mut room = Room::new(run);
    let mut is_used = room.filled(complex.vertices.len(), none)?;
    for vertex in run.watch(rows.into_iter().flatten()) {
        is_used[*vertex? as usize] = true;
    }
    let mut used = Vec::new();
    for vertex in run.watch((0..is_used.len() as u32).filter(|&v| is_used[v as usize])) {
        room.push(&mut used, vertex?)?;
    }
    Ok(used)
}

/// How many distances there are to find.
struct Progress {
    done: usize,
    total: usize,
}

/// One complex as a set of points: what it is sampled on, and what is searched for the nearest point.
struct Side<'a> {
    complex: &'a Complex,
    frame: &'a Frame,
    used: Vec<u32>,
    /// The triangles of the faces and of the cells' skin.
    skin: Cow<'a, [[u32; 3]]>,
    points: Hierarchy<1>,
    segments: Hierarchy<2>,
    triangles: Hierarchy<3>,
    solids: Hierarchy<4>,
    /// The memory of the hierarchies.
    _room: Room<'a>,
}

impl<'a> Side<'a> {
    fn new(
        complex: &'a Complex,
        used: Vec<u32>,
        frame: &'a Frame,
        run: &'a Run<'a>,
    ) -> Result<Self> {
        let mut room = Room::new(run);
        let skin = match complex.cells.is_empty() {
            true => Cow::Borrowed(complex.triangles.as_slice()),
            false => Cow::Owned(skin(complex, &mut room, run)?),
        };
        let mut solids: Vec<[u32; 4]> = Vec::new();
        for cell in run.watch(complex.cells.iter()) {
            for tetrahedron in tetrahedra(cell?) {
                room.push(&mut solids, tetrahedron)?;
            }
        }
        let bare = skin.is_empty() && complex.edges.is_empty() && solids.is_empty();
        let points =
            room.collect(used[..if bare { used.len() } else { 0 }].iter().map(|&v| [v]))?;
        Ok(Side {
            points: hierarchy(complex, frame, &points, &mut room, run)?,
            segments: hierarchy(complex, frame, &complex.edges, &mut room, run)?,
            triangles: hierarchy(complex, frame, &skin, &mut room, run)?,
            solids: hierarchy(complex, frame, &solids, &mut room, run)?,
            complex,
            frame,
            used,
            skin,
            _room: room,
        })
    }

    /// The number of points that [`Side::distances_to`] visits.
    fn steps(&self, options: &CompareOptions) -> usize {
        self.used.len() + options.samples
    }

    fn corners<const N: usize>(&self, simplex: [u32; N]) -> [Point; N] {
        simplex.map(|v| self.frame.scaled(self.complex.vertices[v as usize]))
    }

    /// The scaled distance from a scaled point to the set.
    fn distance(&self, p: Point) -> f64 {
        let least = self.solids.distance_2(p, f64::INFINITY);
        let least = self.triangles.distance_2(p, least);
        let least = self.segments.distance_2(p, least);
        self.points.distance_2(p, least).sqrt()
    }

    fn distances_to(
        &self,
        other: &Side<'_>,
        options: &CompareOptions,
        progress: &mut Progress,
        run: &Run<'_>,
    ) -> Result<Distances> {
        let mut largest = 0f64;
        let mut measure = |p: Point| -> Result<f64> {
            progress.done += 1;
            if progress.done.is_multiple_of(64) {
                run.tick(progress.done, progress.total)?;
            }
            let distance = other.distance(p);
            largest = largest.max(distance);
            Ok(distance)
        };
        let mut at_vertices = Mean::default();
        for &v in &self.used {
            let [p] = self.corners([v]);
            at_vertices.add(measure(p)?);
        }
        let mut at_samples = Mean::default();
        self.sample(options, run, &mut |p| {
            at_samples.add(measure(p)?);
            Ok(())
        })?;
        let (mean, rms) = match at_samples.count {
            0 => at_vertices.value(),
            _ => at_samples.value(),
        };
        let [max, mean, rms] = [largest, mean, rms].map(|d| d / self.frame.scale);
        Ok(Distances { max, mean, rms })
    }

    /// Visits the samples, in an order that only the complex and the options decide.
    fn sample(
        &self,
        options: &CompareOptions,
        run: &Run<'_>,
        visit: &mut dyn FnMut(Point) -> Result<()>,
    ) -> Result<()> {
        let mut random = Random(options.seed);
        let triangles = self.skin.iter().map(|&t| self.corners(t));
        if spread(triangles, options.samples, &mut random, run, visit)? {
            return Ok(());
        }
        let segments = self.complex.edges.iter().map(|&e| self.corners(e));
        spread(segments, options.samples, &mut random, run, visit)?;
        Ok(())
    }
}

/// A simplex for each row of vertices.
fn hierarchy<const N: usize>(
    complex: &Complex,
    frame: &Frame,
    rows: &[[u32; N]],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Hierarchy<N>> {
    let simplex = |row: &[u32; N]| Simplex {
        corners: row.map(|v| frame.scaled(complex.vertices[v as usize])),
        tag: 0,
    };
    let simplices = Room::new(run).collect(rows.iter().map(simplex))?;
    Hierarchy::new(&simplices, room, run)
}

/// The triangles of the faces and of the facets that bound one cell only.
fn skin(complex: &Complex, room: &mut Room<'_>, run: &Run<'_>) -> Result<Vec<[u32; 3]>> {
    let skeleton = Skeleton::new(complex, run)?;
    let mut skin = Vec::new();
    for f in run.watch((0..skeleton.face_count()).filter(|&f| skeleton.cells_of_face(f).len() < 2))
    {
        for triangle in fan(skeleton.ring(f?)) {
            room.push(&mut skin, triangle)?;
        }
    }
    Ok(skin)
}

/// The tetrahedra that a fan in the base of a cell cuts it into.
fn tetrahedra(cell: &[u32]) -> impl Iterator<Item = [u32; 4]> {
    let base = &cell[..cell.len() - 1];
    let apex = cell[cell.len() - 1];
    fan(base).map(move |[a, b, c]| [a, b, c, apex])
}

/// Visits `count` points that are uniform by size on the simplices, segments or triangles: one in
/// each of `count` equal stretches of the total size. Returns whether there is any size at all.
fn spread<const N: usize>(
    simplices: impl Iterator<Item = [Point; N]> + Clone,
    count: usize,
    random: &mut Random,
    run: &Run<'_>,
    visit: &mut dyn FnMut(Point) -> Result<()>,
) -> Result<bool> {
    let mut total = 0.0;
    for (i, simplex) in simplices.clone().enumerate() {
        if i % (1 << 14) == 0 {
            run.poll()?;
        }
        total += size(&simplex);
    }
    if total == 0.0 {
        return Ok(false);
    }
    let mut rest = simplices.enumerate();
    let (mut current, mut begin, mut end) = ([[0.0; 3]; N], 0.0, 0.0);
    for i in 0..count {
        let target = (i as f64 + random.uniform()) / count as f64 * total;
        while end <= target
            && let Some((k, simplex)) = rest.next()
        {
            if k % (1 << 14) == 0 {
                run.poll()?;
            }
            current = simplex;
            begin = end;
            end += size(&current);
        }
        // Where in its simplex the target falls is uniform as well, and spread over the samples.
        let (into, width) = (target - begin, end - begin);
        let fraction = if into < width { (into / width).max(0.0) } else { 1.0 };
        visit(random.point(&current, fraction))?;
    }
    Ok(true)
}

/// The length of a segment, twice the area of a triangle.
fn size(corners: &[Point]) -> f64 {
    let side = |i: usize| sub(corners[i], corners[0]);
    let across = if corners.len() == 2 { side(1) } else { cross(side(1), side(2)) };
    dot(across, across).sqrt()
}

/// The generator splitmix64 (Steele, Lea, Flood 2014, *Fast splittable pseudorandom number
/// generators*).
struct Random(u64);

impl Random {
    /// Uniform in [0, 1), a multiple of 2^-53.
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A uniform point of a segment or triangle, given one of the uniform numbers that it takes
    /// (Turk 1990, *Generating random points in triangles*).
    fn point(&mut self, corners: &[Point], fraction: f64) -> Point {
        let (r, t) = (fraction.sqrt(), self.uniform());
        let weights = match corners.len() {
            2 => [1.0 - fraction, fraction, 0.0],
            _ => [1.0 - r, r * (1.0 - t), r * t],
        };
        std::array::from_fn(|axis| {
            corners.iter().zip(weights).fold(0.0, |sum, (c, w)| sum + w * c[axis])
        })
    }
}

/// Mean and root of the mean square of distances.
#[derive(Default)]
struct Mean {
    count: usize,
    distances: Sum,
    squares: Sum,
}

impl Mean {
    fn add(&mut self, distance: f64) {
        self.count += 1;
        self.distances.add(distance);
        self.squares.add(distance * distance);
    }

    fn value(&self) -> (f64, f64) {
        let count = self.count as f64;
        (self.distances.value() / count, (self.squares.value() / count).sqrt())
    }
}

//! Which balls can touch the boundary of their union, and which can cut which there: as their regular triangulation tells (Edelsbrunner 1995, *The union of balls and its dual shape*).

use super::Balls;
use crate::error::{Error, Result, Status};
use crate::job::{PART, Room, Run};
use crate::points::{COORDINATE_MIN, Points, PointsOptions};
use crate::triangulation::{Edges, Triangulation};
use crate::vector::{Vec3, dot, sub};
use std::sync::Arc;

/// The points round the balls: they make every set solid, and keep the hull away from it.
const CORNERS: usize = 8;
/// The most balls.
pub(super) const MOST: usize = crate::points::POINT_LIMIT - CORNERS;
/// The radius of the smallest ball that is meshed, in the largest coordinate: so what lies on its sphere differs in several bits.
const SMALLEST: f64 = 1.0 / (1u64 << 40) as f64;

/// The balls that are no smaller than can be meshed, in their regular triangulation.
///
/// A point of the union's boundary is on a sphere, and in no other ball, so no other ball has a lesser power there: it lies in the power cell of its ball, where it lies on two spheres in a
/// facet of the power diagram, on three on an edge. So balls that are hidden, or whose power cell does not meet their sphere, touch nothing; a sphere is covered by balls that are next to it in the triangulation, the
/// circle of two spheres by those next to both. `links` are the spheres that cut each other and are next to each other.
pub(super) struct Exposed {
    pub triangulation: Triangulation,
    /// The edges between balls of which the spheres cut each other in a circle, the lesser first.
    pub edges: Edges,
    /// For each vertex the vertices at the other ends of those edges: where its row begins.
    offsets: Vec<u32>,
    others: Vec<u32>,
    /// The number of each triangulated ball.
    numbers: Vec<u32>,
    /// Whether a vertex is hidden, or its ball lies in that of another.
    is_covered: Vec<bool>,
    radii: Vec<f64>,
}

impl Exposed {
    /// Cost: O(n log n) where the triangulation has O(n) cells.
    pub fn new(balls: &Balls, room: &mut Room<'_>, run: &Run<'_>) -> Result<Self> {
        let bounds = balls.bounds();
        let largest =
            bounds.min.into_iter().chain(bounds.max).fold(0.0, |a: f64, x| a.max(x.abs()));
        let smallest = (SMALLEST * largest).max(COORDINATE_MIN);
        let kept = (0..balls.len() as u32).filter(|&b| balls.radii[b as usize] >= smallest);
        let mut numbers = room.vec(balls.len())?;
        numbers.extend(kept);
        if numbers.is_empty() {
            let message =
                "all balls are too small beside their coordinates; move them nearer to the origin";
            return Err(Error::new(Status::CoordinateRange, message));
        }
        let margin = 2.0 * bounds.extent().into_iter().fold(0.0, f64::max);
        let row = |i: usize| match numbers.get(i) {
            Some(&ball) => balls.centers[ball as usize],
            None => [0, 1, 2].map(|k| match (i - numbers.len()) >> k & 1 {
                0 => bounds.min[k] - margin,
                _ => bounds.max[k] + margin,
            }),
        };
        let mut own = Room::new(run);
        let mut weights = own.vec(numbers.len() + CORNERS)?;
        weights.extend(numbers.iter().map(|&ball| balls.radii[ball as usize].powi(2)));
        weights.extend([0.0; CORNERS]);
        let options = PointsOptions::default();
        let points = Points::by_row_in(weights.len(), |i| Some(row(i)), options, run)?;
        let triangulation = Triangulation::regular_in(&Arc::new(points), &weights, run)?;
        let rows = triangulation.row_of_vertex();
        // Corners are balls of radius 0, which cut nothing.
        let radius =
            |&row: &u32| numbers.get(row as usize).map_or(0.0, |&b| balls.radii[b as usize]);
        let radii = room.collect(rows.iter().map(radius))?;
        let incidence = triangulation.incidence_in(run)?;
        let all = triangulation.edges_in(&incidence, run)?;
        drop(incidence);
        let mut exposed = Exposed {
            triangulation,
            edges: Edges::default(),
            offsets: Vec::new(),
            others: Vec::new(),
            numbers,
            is_covered: Vec::new(),
            radii,
        };
        exposed.link(all, room, run)?;
        Ok(exposed)
    }

    /// Keeps the edges of which the spheres cut each other, and finds them for each vertex.
    fn link(&mut self, all: Edges, room: &mut Room<'_>, run: &Run<'_>) -> Result<()> {
        let count = self.radii.len();
        let mut offsets = room.filled(count + 1, 0u32)?;
        let mut edges = Edges::default();
        let mut is_covered = room.filled(count, false)?;
        self.triangulation.hidden().iter().for_each(|&v| is_covered[v as usize] = true);
        for edge in run.watch(all.ends.into_iter().zip(all.cells)) {
            let (ends, cell) = edge?;
            let [(c, r), (d, s)] = ends.map(|v| self.ball(v));
            let way = sub(d, c);
            let distance = dot(way, way).sqrt();
            // A ball within another may have a power cell all the same, where neither reaches.
            is_covered[ends[0] as usize] |= distance <= s - r;
            is_covered[ends[1] as usize] |= distance <= r - s;
            if distance < r + s && distance > (r - s).abs() {
                room.push(&mut edges.ends, ends)?;
                room.push(&mut edges.cells, cell)?;
                ends.iter().for_each(|&v| offsets[v as usize + 1] += 1);
            }
        }
        for v in 0..count {
            offsets[v + 1] += offsets[v];
        }
        let mut next = Room::new(run).collect(offsets.iter().copied())?;
        let mut others = room.filled(2 * edges.ends.len(), 0)?;
        for ends in run.watch(&edges.ends) {
            let &[a, b] = ends?;
            for (v, other) in [(a, b), (b, a)] {
                others[next[v as usize] as usize] = other;
                next[v as usize] += 1;
            }
        }
        (self.edges, self.offsets, self.others) = (edges, offsets, others);
        self.is_covered = is_covered;
        Ok(())
    }

    /// The number of vertices of the triangulation.
    pub fn len(&self) -> usize {
        self.radii.len()
    }

    /// The centre and the radius of a vertex.
    pub fn ball(&self, vertex: u32) -> (Vec3, f64) {
        (self.triangulation.coords()[vertex as usize], self.radii[vertex as usize])
    }

    /// The ball of a vertex that is one and not within another.
    pub fn number(&self, vertex: u32) -> Option<u32> {
        let row = self.triangulation.row_of_vertex()[vertex as usize];
        self.numbers.get(row as usize).copied().filter(|_| !self.is_covered[vertex as usize])
    }

    /// The vertices next to one whose spheres cut its sphere.
    pub fn others(&self, vertex: u32) -> &[u32] {
        let v = vertex as usize;
        &self.others[self.offsets[v] as usize..self.offsets[v + 1] as usize]
    }

    /// The ranges of vertices that are worth a thread's while.
    pub fn parts(&self) -> Vec<std::ops::Range<usize>> {
        crate::job::parts_of(PART / 256, self.len())
    }
}

//! Normals at the vertices of a surface.

use super::measure::Frame;
use super::{Complex, Point};
use crate::error::Result;
use crate::job::{Job, Room, Run, Stage};
use crate::points::Bounds;
use crate::vector::{add, cross, dot, length, scale, sub, unit};

impl Complex {
    /// The normals of the surface at its vertices, of length 1: those of its discrete mean curvature (Meyer, Desbrun, Schröder, Barr 2003,
    /// *Discrete differential-geometry operators for triangulated 2-manifolds*, section 3.5: the sum of (cot a + cot b)(x - y) over the edges x y), turned as the
    /// faces turn; where the surface is flat, so that it has none, or the two differ by more than 60 degrees, the mean of the triangles' normals weighted by their
    /// angles. 0 for a vertex without a face that has an area.
    ///
    /// What only the coordinates' rounding makes counts for next to nothing: a mesh that is rotated about the origin, so that it is rounded anew, has the rotated normals, but for
    /// about 10^-6. Between a surface that is flat but for rounding and one that is clearly curved the normals change gradually.
    ///
    /// Errors: those of the job. Cost: O(size).
    pub fn vertex_normals(&self, job: &Job) -> Result<Vec<[f64; 3]>> {
        job.run(&[(Stage::Query, 1.0)], |run| {
            run.enter(Stage::Query)?;
            self.vertex_normals_in(run)
        })
    }

    fn vertex_normals_in(&self, run: &Run<'_>) -> Result<Vec<Point>> {
        let mut room = Room::new(run);
        let mut means = room.filled(self.vertices.len(), [0.0; 3])?;
        let Some(bounds) = Bounds::of(self.vertices.iter().copied()) else {
            return Ok(means);
        };
        let frame = Frame::new(&bounds);
        let mut curvatures = room.filled(self.vertices.len(), Curvature::default())?;
        for triangle in run.watch(self.triangles()) {
            let triangle = triangle?;
            let corners = triangle.map(|v| frame.scaled(self.vertices[v as usize]));
            let far = corners.map(length).into_iter().fold(0.0, f64::max);
            let sides = [[1, 2], [2, 0], [0, 1]].map(|[b, c]| sub(corners[c], corners[b]));
            let lengths = sides.map(length);
            let longest = lengths.into_iter().fold(0.0, f64::max);
            for i in 0..3 {
                let [a, b, c] = [0, 1, 2].map(|k| (i + k) % 3);
                let (u, v) = (sides[c], scale(sides[b], -1.0));
                let normal = cross(u, v);
                let sine = length(normal);
                if sine == 0.0 {
                    continue;
                }
                // The corners by the altitude: how much the normal turns when they are moved.
                let trust = (NOISE / (MOVED * far * longest / sine)).min(1.0);
                let angle = libm::atan2(sine, dot(u, v));
                let at = &mut means[triangle[a] as usize];
                *at = add(*at, scale(normal, trust * angle / sine));
                // The cotangent of the angle at a weighs the side opposite. Its derivative is the inverse of the squared sine.
                let cotangent = dot(u, v) / sine;
                let along = scale(sides[a], cotangent);
                let per_length = lengths[a] * (lengths[b] + lengths[c]) / sine;
                let moved = far * (cotangent.abs() + per_length * (lengths[b] * lengths[c] / sine));
                let [at_b, at_c] = [triangle[b], triangle[c]].map(|v| v as usize);
                curvatures[at_b].add(scale(along, -1.0), moved);
                curvatures[at_c].add(along, moved);
            }
        }
        for pair in run.watch(means.iter_mut().zip(&curvatures)) {
            let (mean, curvature) = pair?;
            *mean = unit(*mean);
            let size = length(curvature.sum);
            let direction = unit(curvature.sum);
            // Where the surface is a saddle the curvature points into it.
            let cosine = dot(direction, *mean);
            if cosine.abs() > 0.5 {
                let trust = (NOISE * size / (MOVED * curvature.moved)).min(1.0);
                let of_curvature = scale(direction, trust * cosine.signum());
                *mean = unit(add(of_curvature, scale(*mean, 1.0 - trust)));
            }
        }
        Ok(means)
    }
}

/// How far rounding moves a corner, relative to its distance from the origin, with something to spare: each coordinate is off by half a unit in its
/// last place when it is read and by a few when it was calculated, and what is calculated from it here adds less. Of distances, not of
/// coordinates, so that rotations about the origin do not change it.
const MOVED: f64 = 8.0 * f64::EPSILON;

/// What rounding may change in a normal. Of a direction that it changes by more, only so large a share is taken that no more is left of that.
const NOISE: f64 = 0.5e-6;

/// The discrete mean curvature at a vertex, times an area.
#[derive(Clone, Copy, Default)]
struct Curvature {
    sum: Point,
    /// How much the sum may change for each unit that the corners are moved, relative to their distances from the origin.
    moved: f64,
}

impl Curvature {
    fn add(&mut self, term: Point, moved: f64) {
        self.sum = add(self.sum, term);
        self.moved += moved;
    }
}

//! Normals at the vertices of a surface.

use super::{Complex, Point};
use crate::error::Result;
use crate::job::{Job, Room, Run, Stage};
use crate::vector::{add, cross, dot, length, scale, sub, unit};

impl Complex {
    /// The normals of the surface at its vertices, of length 1: those of its discrete mean curvature (Meyer, Desbrun, Schröder, Barr 2003,
    /// *Discrete differential-geometry operators for triangulated 2-manifolds*, section 3.5: the sum of (cot a + cot b)(x - y) over the edges x y), turned as the
    /// faces turn; where the surface is flat, so that it has none, or the two differ by more than 60 degrees, the mean of the triangles' normals weighted by their
    /// angles. 0 for a vertex without faces.
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
        let mut curvatures = room.filled(self.vertices.len(), [0.0; 3])?;
        let mut means = room.filled(self.vertices.len(), [0.0; 3])?;
        for triangle in run.watch(self.triangles()) {
            let triangle = triangle?;
            let corners = triangle.map(|v| self.vertices[v as usize]);
            for i in 0..3 {
                let [a, b, c] = [0, 1, 2].map(|k| (i + k) % 3);
                let (u, v) = (sub(corners[b], corners[a]), sub(corners[c], corners[a]));
                let normal = cross(u, v);
                let sine = length(normal);
                if sine == 0.0 {
                    continue;
                }
                let angle = libm::atan2(sine, dot(u, v));
                let at = &mut means[triangle[a] as usize];
                *at = add(*at, scale(normal, angle / sine));
                // The cotangent of the angle at a weighs the side opposite.
                let along = scale(sub(corners[b], corners[c]), dot(u, v) / sine);
                let [at_b, at_c] = [triangle[b], triangle[c]].map(|v| v as usize);
                curvatures[at_b] = add(curvatures[at_b], along);
                curvatures[at_c] = sub(curvatures[at_c], along);
            }
        }
        for pair in run.watch(means.iter_mut().zip(&curvatures)) {
            let (mean, &curvature) = pair?;
            *mean = unit(*mean);
            let curvature = unit(curvature);
            // Where the surface is a saddle the curvature points into it.
            let cosine = dot(curvature, *mean);
            if cosine.abs() > 0.5 {
                *mean = scale(curvature, cosine.signum());
            }
        }
        Ok(means)
    }
}

//! The check of poles against the triangulation that they come from.

use super::{Poles, clamp};
use crate::dual::circumcenter;
use crate::error::{ElementKind, Result};
use crate::index::NONE;
use crate::job::{Job, Stage};
use crate::predicates::{Sign, angle};
use crate::validation::Validation;

impl Poles {
    /// Checks that each pole is the circumcentre of its cell, that no Voronoi vertex of a sample
    /// is farther than its first pole, and none on the other side farther than its second.
    /// Errors: those of the job. Cost: that of choosing the poles again.
    pub fn validate(&self, job: &Job) -> Result<Validation> {
        job.run(&[(Stage::Validate, 1.0)], |run| {
            run.enter(Stage::Validate)?;
            let mut report = Validation::new();
            let t = &self.triangulation;
            let center_of = |cell: u32| {
                circumcenter(t.cells()[cell as usize].map(|v| t.coords()[v as usize]))
                    .map(|center| (center.position.map(clamp), center.radius_squared))
            };
            let mut used = vec![false; self.len()];
            for (pole, (&[x, y, z, r], &cell)) in
                self.balls.iter().zip(&self.cell_of_pole).enumerate()
            {
                if pole % 1024 == 0 {
                    run.tick(pole / 2, self.len())?;
                }
                let squared = self.radii_squared[pole];
                let right = r == squared.sqrt() && center_of(cell) == Some(([x, y, z], squared));
                report.check(right, ElementKind::Vertex, pole as u64, || {
                    format!("it is not the circumcentre of cell {cell}")
                });
            }
            let incidence = t.incidence_in(run)?;
            for (sample, &[first, second]) in self.pole_of_sample.iter().enumerate() {
                if sample % 256 == 0 {
                    run.tick(self.sample_count + sample, 2 * self.sample_count)?;
                }
                let s = &t.coords()[sample];
                let squared = |pole: u32| match pole {
                    NONE => f64::NEG_INFINITY,
                    pole => self.radii_squared[pole as usize],
                };
                for pole in [first, second].into_iter().filter(|&pole| pole != NONE) {
                    used[pole as usize] = true;
                }
                let [x, y, z, _] = match first {
                    NONE => [0.0; 4],
                    pole => self.balls[pole as usize],
                };
                let farthest = incidence.cells_of(sample as u32).iter().all(|&cell| {
                    let Some((position, radius_squared)) = center_of(cell) else { return false };
                    let across = angle(&[x, y, z], s, &position) == Sign::Negative;
                    radius_squared <= squared(first)
                        && (!across || radius_squared <= squared(second))
                });
                report.check(farthest, ElementKind::Vertex, sample as u64, || {
                    "a vertex of the sample's Voronoi cell is farther than its pole".into()
                });
            }
            for (pole, used) in used.into_iter().enumerate() {
                report.check(used, ElementKind::Vertex, pole as u64, || {
                    "it is the pole of no sample".into()
                });
            }
            Ok(report)
        })
    }
}

//! The check of poles: the farthest vertices, each once, in order.

use super::select::{is_farther, is_opposite};
use super::{Poles, position, sample_count};
use crate::dual::{Dual, DualOptions};
use crate::error::{ElementKind, Result};
use crate::index::NONE;
use crate::job::{Job, Run, Stage};
use crate::predicates::insphere;
use crate::validation::Validation;

impl Poles {
    /// Checks every invariant against the triangulation: each ball is the circumscribed sphere of its cell,
    /// the least of those that share it; each sample's poles are the farthest of all its cells' centres; no
    /// pole twice, none that no sample has; normals of length 1.
    ///
    /// Errors: those of the job. Cost: O(m), and a dual is built anew.
    pub fn validate(&self, job: &Job) -> Result<Validation> {
        let plan = [(Stage::Dual, 2.0), (Stage::Validate, 1.0)];
        job.run(&plan, |run| {
            let dual = Dual::new_in(&self.triangulation, DualOptions::default(), run)?;
            run.enter(Stage::Validate)?;
            let mut report = Validation::new();
            let (p, n) = (self.len(), sample_count(self.triangulation.points()));
            let complete = [self.radii_squared.len(), self.cell_of_pole.len()] == [p; 2]
                && self.touches_far_box.len() == p
                && [self.pole_of_sample.len(), self.normals.len()] == [n; 2]
                && self.cell_of_pole.iter().all(|&c| (c as usize) < dual.centers().len())
                && self
                    .pole_of_sample
                    .as_flattened()
                    .iter()
                    .all(|&i| i == NONE || (i as usize) < p);
            report.check(complete, ElementKind::Vertex, n as u64, || {
                "an array has the wrong length, or names a pole or a cell that does not exist"
                    .into()
            });
            if complete {
                self.check_balls(&dual, &mut report, run)?;
                self.check_samples(&dual, &mut report, run)?;
            }
            Ok(report)
        })
    }

    fn check_balls(&self, dual: &Dual, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let t = &*self.triangulation;
        let mut used = vec![false; self.len()];
        for &pole in self.pole_of_sample.as_flattened().iter().filter(|&&pole| pole != NONE) {
            used[pole as usize] = true;
        }
        let mut seen = vec![false; t.cells().len()];
        for (pole, &cell) in self.cell_of_pole.iter().enumerate() {
            if pole % 1024 == 0 {
                run.tick(pole, 2 * self.len())?;
            }
            let [x, y, z, radius] = self.balls[pole];
            let radius_squared = dual.radii_squared()[cell as usize];
            let right = [x, y, z] == position(dual, cell)
                && self.radii_squared[pole] == radius_squared
                && radius == radius_squared.sqrt();
            report.check(right, ElementKind::Vertex, pole as u64, || {
                format!("its ball is not the circumscribed sphere of cell {cell}")
            });
            report.check(used[pole], ElementKind::Vertex, pole as u64, || {
                "it is the pole of no sample".into()
            });
            // A walk over the cells that share the sphere. None is lesser, and none was on the walk of
            // another pole.
            let mut least = !std::mem::replace(&mut seen[cell as usize], true);
            let mut far = false;
            let mut stack = vec![cell];
            while let Some(current) = stack.pop() {
                least &= current >= cell;
                let corners = t.cells()[current as usize];
                far |= corners.iter().any(|&v| v as usize >= self.normals.len());
                for next in t.neighbors()[current as usize].into_iter().filter(|&c| c != NONE) {
                    if !seen[next as usize] && shares_sphere(dual, current, next) {
                        seen[next as usize] = true;
                        stack.push(next);
                    }
                }
            }
            report.check(least, ElementKind::Vertex, pole as u64, || {
                format!("cell {cell} is not the least with its sphere, or another pole has it")
            });
            report.check(
                far == self.touches_far_box[pole],
                ElementKind::Vertex,
                pole as u64,
                || "whether it touches the far box is wrong".into(),
            );
        }
        Ok(())
    }

    fn check_samples(&self, dual: &Dual, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let incidence = self.triangulation.incidence_in(run)?;
        for (sample, &[first, second]) in self.pole_of_sample.iter().enumerate() {
            if sample % 256 == 0 {
                run.tick(sample + self.normals.len(), 2 * self.normals.len())?;
            }
            let id = sample as u64;
            let normal = self.normals[sample];
            let length: f64 = normal.iter().map(|x| x * x).sum();
            report.check((length - 1.0).abs() < 1e-14, ElementKind::Vertex, id, || {
                "its normal is not of length 1".into()
            });
            let cells = incidence.cells_of(sample as u32);
            let farthest = |cells: &mut dyn Iterator<Item = u32>| {
                cells.fold(NONE, |best, cell| match is_farther(dual, cell, best) {
                    true => cell,
                    false => best,
                })
            };
            let unbounded = cells.iter().any(|&cell| {
                let corners = self.triangulation.cells()[cell as usize];
                (0..4).any(|i| corners[i] != sample as u32 && self.triangulation.is_hull(cell, i))
            });
            let expected = match unbounded {
                true => NONE,
                false => farthest(&mut cells.iter().copied()),
            };
            report.check(self.is_pole_at(dual, first, expected), ElementKind::Vertex, id, || {
                "its first pole is not the farthest vertex of its Voronoi cell".into()
            });
            let opposite = |&cell: &u32| is_opposite(dual, sample, cell, expected, normal);
            let expected = farthest(&mut cells.iter().copied().filter(opposite));
            report.check(self.is_pole_at(dual, second, expected), ElementKind::Vertex, id, || {
                "its second pole is not the farthest vertex opposite the first".into()
            });
        }
        Ok(())
    }

    /// Whether the pole is the centre of the cell, or both are none.
    fn is_pole_at(&self, dual: &Dual, pole: u32, cell: u32) -> bool {
        if pole == NONE || cell == NONE {
            return pole == cell;
        }
        let at = |v: u32| &self.triangulation.coords()[v as usize];
        let [a, b, c, d] = self.triangulation.cells()[self.cell_of_pole[pole as usize] as usize];
        let [x, y, z, _] = self.balls[pole as usize];
        let on_sphere = |v: u32| {
            [a, b, c, d].contains(&v) || insphere(at(a), at(b), at(c), at(d), at(v)).is_zero()
        };
        [x, y, z] == position(dual, cell)
            && self.triangulation.cells()[cell as usize].into_iter().all(on_sphere)
    }
}

/// Whether all vertices of the second cell lie on the sphere of the first.
fn shares_sphere(dual: &Dual, cell: u32, other: u32) -> bool {
    let t = dual.triangulation();
    let at = |v: u32| &t.coords()[v as usize];
    let [a, b, c, d] = t.cells()[cell as usize];
    let outside = |v: &u32| ![a, b, c, d].contains(v);
    t.cells()[other as usize]
        .into_iter()
        .filter(outside)
        .all(|v| insphere(at(a), at(b), at(c), at(d), at(v)).is_zero())
}

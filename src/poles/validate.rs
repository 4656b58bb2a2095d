//! The check of poles: the farthest vertices, each once, in order.

use super::select::is_farther;
use super::tangent::TangentPlane;
use super::{Omit, POLE_MAX, Poles, position, sample_count};
use crate::dual::{Dual, DualOptions, unit};
use crate::error::{ElementKind, Result};
use crate::index::NONE;
use crate::job::{Job, Run, Stage};
use crate::points::{Bounds, COORDINATE_MIN, order};
use crate::predicates::insphere;
use crate::validation::Validation;

impl Poles {
    /// Checks every invariant against the triangulation: each ball is the circumscribed sphere of its cell,
    /// the least of those that share it; each sample's poles are the farthest of all its cells' centres; no
    /// pole twice, none that no sample has; the samples on each ball and its object angle; spatial order; normals towards the first poles.
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
                && [self.samples_on_balls.len(), self.object_angles.len()] == [p; 2]
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
                self.check_order(&mut report, run)?;
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
            let mut samples: Vec<u32> = Vec::new();
            let mut least = !std::mem::replace(&mut seen[cell as usize], true);
            let mut far = false;
            let mut stack = vec![cell];
            while let Some(current) = stack.pop() {
                least &= current >= cell;
                let corners = t.cells()[current as usize];
                far |= corners.iter().any(|&v| v as usize >= self.normals.len());
                samples.extend(corners.iter().filter(|&&v| (v as usize) < self.normals.len()));
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
            samples.sort_unstable();
            samples.dedup();
            let right = self.samples_on_balls.row(pole) == samples && self.has_angle(pole);
            report.check(right, ElementKind::Vertex, pole as u64, || {
                "the samples on its ball are others, or its object angle is another".into()
            });
        }
        Ok(())
    }

    /// Whether the object angle is that of the longest chord between samples on the ball, as far as the rounding of the ball shows.
    fn has_angle(&self, pole: usize) -> bool {
        let (angle, radius) = (self.object_angles[pole], self.balls[pole][3]);
        let at = |v: u32| self.triangulation.coords()[v as usize];
        let chord = |a: u32, b: u32| {
            let [p, q] = [at(a), at(b)];
            (0..3).map(|k| (p[k] - q[k]) * (p[k] - q[k])).sum::<f64>().sqrt()
        };
        let samples = self.samples_on_balls.row(pole);
        let pairs = samples.iter().flat_map(|&a| samples.iter().map(move |&b| (a, b)));
        let longest = pairs.fold(0.0, |longest: f64, (a, b)| longest.max(chord(a, b)));
        let largest = self.balls[pole].iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        // A centre may have been moved into the range of predicates.
        let moved = COORDINATE_MIN + 16.0 * f64::EPSILON * largest;
        let slack = longest * (1e-12 + moved / radius);
        let is_told = slack < 0.1 * longest && largest < POLE_MAX;
        let found = 2.0 * radius * libm::sin(angle / 2.0);
        let is_angle = (0.0..=std::f64::consts::PI).contains(&angle);
        is_angle
            && (longest > 0.0 || angle == 0.0)
            && (!is_told || (found - longest).abs() <= slack)
    }

    /// Sorting the poles again must change nothing.
    fn check_order(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let place = |(&[x, y, z, _], &cell): (&[f64; 4], &u32)| ([x, y, z], cell);
        let mut sorted: Vec<_> = self.balls.iter().zip(&self.cell_of_pole).map(place).collect();
        if let Some(bounds) = Bounds::of(sorted.iter().map(|(center, _)| *center)) {
            order::sort(&mut sorted, &bounds, run)?;
        }
        let first = sorted.iter().zip(&self.cell_of_pole).position(|(a, cell)| a.1 != *cell);
        report.check(first.is_none(), ElementKind::Vertex, first.unwrap_or(0) as u64, || {
            "the poles are not in spatial order".into()
        });
        Ok(())
    }

    fn check_samples(&self, dual: &Dual, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let incidence = self.triangulation.incidence_in(run)?;
        for (sample, &[first, second]) in self.pole_of_sample.iter().enumerate() {
            if sample % 256 == 0 {
                run.tick(sample + self.normals.len(), 2 * self.normals.len())?;
            }
            let id = sample as u64;
            let cells = incidence.cells_of(sample as u32);
            let farthest = |cells: &mut dyn Iterator<Item = u32>| {
                cells.fold(NONE, |best, cell| match is_farther(dual, sample, cell, best) {
                    true => cell,
                    false => best,
                })
            };
            let to_infinity = self.direction_to_infinity(dual, sample as u32, cells);
            let normal = self.normals[sample];
            let towards = match to_infinity {
                Some(direction) => normal == direction,
                None => self.points_at(dual, normal, sample, farthest(&mut cells.iter().copied())),
            };
            report.check(towards, ElementKind::Vertex, id, || {
                "its normal is not the unit vector towards its first pole".into()
            });
            let expected = match to_infinity.is_some() {
                true => NONE,
                false => farthest(&mut cells.iter().copied()),
            };
            let plane = TangentPlane::new(dual, sample, expected, normal);
            let opposite = |&cell: &u32| plane.is_below(dual, sample as u32, cell);
            let opposite = farthest(&mut cells.iter().copied().filter(opposite));
            let is_kept = self.kept(dual, sample as u32, cells, [expected, opposite]);
            let right = |pole, cell, is_kept| match is_kept {
                // On the verge of being left out.
                None => pole == NONE || self.is_pole_at(dual, pole, cell),
                Some(true) => self.is_pole_at(dual, pole, cell),
                Some(false) => pole == NONE,
            };
            report.check(right(first, expected, is_kept[0]), ElementKind::Vertex, id, || {
                "its first pole is not the farthest vertex of its Voronoi cell".into()
            });
            report.check(right(second, opposite, is_kept[1]), ElementKind::Vertex, id, || {
                "its second pole is not the farthest vertex opposite the first".into()
            });
        }
        Ok(())
    }

    /// Whether the two poles of a sample are left in, given their cells; `None` where rounding decides that. By angles, as the paper
    /// has it.
    fn kept(&self, dual: &Dual, sample: u32, cells: &[u32], poles: [u32; 2]) -> [Option<bool>; 2] {
        if self.options.omit == Omit::Nothing {
            return [Some(true); 2];
        }
        let (s, n) = (self.triangulation.coords()[sample as usize], self.normals[sample as usize]);
        let mut bound = 0.0f64;
        for &cell in cells {
            let corners = self.triangulation.cells()[cell as usize];
            if corners.iter().any(|&v| v as usize >= self.normals.len()) {
                continue;
            }
            let v = [0, 1, 2].map(|k| dual.centers()[cell as usize][k] - s[k]);
            let distance = v.iter().map(|x| x * x).sum::<f64>().sqrt();
            let cosine = v.iter().zip(n).map(|(x, n)| x * n).sum::<f64>().abs() / distance;
            let beta = libm::acos(cosine.min(1.0));
            if beta > 2.0 * self.lambda {
                bound = bound.max(distance * libm::sin(beta - self.lambda) / self.lambda);
            }
        }
        let is_long = poles.map(|cell| match cell {
            NONE => Some(true),
            cell => {
                let distance = dual.radii_squared()[cell as usize].sqrt();
                let is_told = (distance - bound).abs() > 1e-6 * bound;
                is_told.then_some(distance > bound)
            }
        });
        match (self.options.omit, is_long) {
            (Omit::Both, [Some(true), Some(true)]) => [Some(true); 2],
            (Omit::Both, long) if long.contains(&Some(false)) => [Some(false); 2],
            (Omit::Both, _) => [None; 2],
            _ => is_long,
        }
    }

    /// The direction of the pole at infinity of a sample with the given cells, if it is on the hull.
    fn direction_to_infinity(&self, dual: &Dual, sample: u32, cells: &[u32]) -> Option<[f64; 3]> {
        let mut sum = None;
        for &cell in cells {
            let corners = self.triangulation.cells()[cell as usize];
            for facet in (0..4).filter(|&i| corners[i] != sample) {
                let ray = dual.rays().of_facet(cell, facet as u32);
                if let Some(direction) = dual.rays().directions().get(ray as usize) {
                    let before = sum.unwrap_or([0.0; 3]);
                    sum = Some([0, 1, 2].map(|k| before[k] + direction[k]));
                }
            }
        }
        sum.map(unit)
    }

    /// Whether the vector has length 1 and points from the sample at the centre of the cell, as far as the rounding of that
    /// shows.
    fn points_at(&self, dual: &Dual, normal: [f64; 3], sample: usize, cell: u32) -> bool {
        // Not the ball's centre, which is kept within the range of predicates.
        let center = dual.centers()[cell as usize];
        let s = self.triangulation.coords()[sample];
        let offset = [0, 1, 2].map(|k| center[k] - s[k]);
        let largest = |v: [f64; 3]| v.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
        // Where the centre rounds to the sample, or is beyond all floats, nothing more can be told.
        let rounding = f64::EPSILON * (1.0 + largest(center) / largest(offset));
        let is_told = rounding < 0.1 && largest(center) < f64::MAX;
        (length - 1.0).abs() <= 1e-15
            && (!is_told || {
                let towards = unit(offset);
                (0..3).all(|k| (normal[k] - towards[k]).abs() <= 4.0 * rounding)
            })
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

#[cfg(test)]
mod tests;

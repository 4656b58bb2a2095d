//! The check of the facets' attributes.

use super::Medial;
use crate::error::{ElementKind, Result};
use crate::job::{Job, Run, Stage};
use crate::poles::is_opposite;
use crate::validation::Validation;
use crate::vector::{cross, dot, length, sub, unit};

impl Medial {
    /// Checks umbrellas and conditions from the other side than they were made: round each Voronoi facet, whose polygon a tangent plane must
    /// cut twice or not at all, the triangles of the umbrellas of the dual edge's ends are found again, and the
    /// conditions from these; disks are checked by Euler's formula. Errors: those of the job. Cost: O(size of the dual).
    pub fn validate(&self, job: &Job) -> Result<Validation> {
        job.run(&[(Stage::Validate, 1.0)], |run| {
            run.enter(Stage::Validate)?;
            let mut report = Validation::new();
            self.check_facets(&mut report, run)?;
            self.check_disks(&mut report, run)?;
            Ok(report)
        })
    }

    fn check_facets(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let facets = self.facets()?;
        let t = self.dual.triangulation();
        let coords = t.coords();
        for facet in run.watch(0..facets.len()) {
            let facet = facet?;
            let ends = facets.edges()[facet];
            let ring = facets.ring(facet);
            let is_unbounded = facets.is_unbounded(facet);
            for (i, &end) in ends.iter().enumerate() {
                let rims = self.umbrellas.rims_of(end);
                let other = ends[1 - i];
                // The third corners of the triangles at the edge: successive cells share one.
                let sides = if is_unbounded { ring.len() - 1 } else { ring.len() };
                let mut cut = Vec::new();
                for k in 0..sides {
                    let [a, b] = [ring[k], ring[(k + 1) % ring.len()]];
                    if self.is_below(end, a) != self.is_below(end, b) {
                        let of_b = t.cells()[b as usize];
                        let shared = t.cells()[a as usize].into_iter();
                        cut.extend(shared.filter(|v| of_b.contains(v) && !ends.contains(v)));
                    }
                }
                let in_umbrella = |third: &u32| {
                    rims.contains(&[other, *third]) || rims.contains(&[*third, other])
                };
                let count = rims.iter().filter(|rim| rim.contains(&other)).count();
                let agree = cut.iter().all(in_umbrella)
                    && if is_unbounded { count >= cut.len() } else { count == cut.len() };
                let polygon = is_unbounded || cut.len() == 2 || cut.is_empty();
                report.check(agree && polygon, ElementKind::Edge, facet as u64, || {
                    format!(
                        "umbrella {end} has {count} triangles at the edge, {} are cut",
                        cut.len()
                    )
                });
                let (sine, ratio) = if count > 0 || rims.is_empty() {
                    (f64::NEG_INFINITY, f64::NEG_INFINITY)
                } else {
                    self.measured(end, sub(coords[other as usize], coords[end as usize]))
                };
                let is = (self.conditions.sines[facet][i], self.conditions.ratios[facet][i]);
                let right = near(is.0, sine) && near(is.1, ratio);
                report.check(right, ElementKind::Edge, facet as u64, || {
                    format!("from vertex {end} it has {is:?}, not {:?}", (sine, ratio))
                });
            }
        }
        Ok(())
    }

    /// The sine and the ratio of an edge, from the triangles' angles: another formula than that which made them.
    fn measured(&self, end: u32, edge: [f64; 3]) -> (f64, f64) {
        let coords = self.dual.triangulation().coords();
        let p = coords[end as usize];
        let (mut sine, mut ratio) = (f64::INFINITY, f64::INFINITY);
        for rim in self.umbrellas.rims_of(end) {
            let [u, v] = rim.map(|v| coords[v as usize]);
            // The corner with the largest angle: needles lose the least digits there.
            let corners = [[p, u, v], [u, v, p], [v, p, u]];
            let cosine = |[at, a, b]: [[f64; 3]; 3]| {
                let [a, b] = [a, b].map(|x| unit(sub(x, at)));
                dot(a, b)
            };
            let widest = corners.into_iter().min_by(|&a, &b| cosine(a).total_cmp(&cosine(b)));
            let [at, a, b] = widest.unwrap_or(corners[0]);
            let opposite = length(sub(b, a));
            let [a, b] = [a, b].map(|x| unit(sub(x, at)));
            let normal = cross(a, b);
            let volume = dot(normal, edge).abs();
            sine = sine.min(volume / length(normal) / length(edge));
            // A side by twice the sine of the angle opposite.
            ratio = ratio.min(2.0 * length(normal) * length(edge) / opposite);
        }
        (sine, ratio)
    }

    /// Whether the cell's centre lies below the tangent plane of the vertex.
    fn is_below(&self, vertex: u32, cell: u32) -> bool {
        let v = vertex as usize;
        is_opposite(&self.dual, v, cell, self.poles.cells[v], self.poles.normals[v])
    }

    fn check_disks(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        for sample in run.watch(0..self.umbrellas.is_disk().len()) {
            let sample = sample?;
            let rims = self.umbrellas.rims_of(sample as u32);
            let follows = |i: usize| rims[i][1] == rims[(i + 1) % rims.len()][0];
            let mut tails: Vec<u32> = rims.iter().map(|rim| rim[0]).collect();
            tails.sort_unstable();
            tails.dedup();
            let is_ring =
                rims.len() > 2 && tails.len() == rims.len() && (0..rims.len()).all(follows);
            let right = is_ring == self.umbrellas.is_disk()[sample];
            report.check(right, ElementKind::Vertex, sample as u64, || {
                "its umbrella is a disk where it should not be, or the other way round".into()
            });
        }
        Ok(())
    }
}

/// Whether two numbers agree but for rounding. Needles lose digits.
fn near(a: f64, b: f64) -> bool {
    a == b || (a - b).abs() <= 1e-6 * a.abs().max(b.abs()).max(1e-6)
}

//! The check of a dual: equal powers, outward rays, sound rings.

use super::center::power_of_two;
use super::{Dual, Facets};
use crate::error::{ElementKind, Result};
use crate::index::NONE;
use crate::job::{Job, Run, Stage};
use crate::predicates::UNIT;
use crate::predicates::double_double::Pairs;
use crate::validation::Validation;

/// Past this the squares of coordinates overflow, and powers are not checked.
const FAR: f64 = power_of_two(500);

impl Dual {
    /// Checks every invariant: each centre has the same power with respect to its cell's four vertices, the
    /// squared radius, as exactly as correct rounding of both promises; rays are normal to the
    /// facets of the hull, outward and of length 1; rings are sound, and every edge has one.
    ///
    /// Errors: those of the job. Cost: O(m).
    pub fn validate(&self, job: &Job) -> Result<Validation> {
        job.run(&[(Stage::Validate, 1.0)], |run| {
            run.enter(Stage::Validate)?;
            let mut report = Validation::new();
            let count = self.triangulation.cells().len();
            let complete = self.centers.len() == count && self.radii_squared.len() == count;
            report.check(complete, ElementKind::Cell, count as u64, || {
                "there must be one centre and one squared radius per cell".into()
            });
            if complete {
                self.check_centers(&mut report, run)?;
            }
            self.check_rays(&mut report, run)?;
            if let Some(facets) = &self.facets {
                self.check_facets(facets, &mut report, run)?;
            }
            Ok(report)
        })
    }

    fn check_centers(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let t = &*self.triangulation;
        for (cell, corners) in t.cells().iter().enumerate() {
            if cell % 4096 == 0 {
                run.tick(cell, t.cells().len())?;
            }
            let (center, radius_squared) = (self.centers[cell], self.radii_squared[cell]);
            let finite = center.iter().chain([&radius_squared]).all(|x| x.is_finite());
            report.check(finite, ElementKind::Cell, cell as u64, || {
                "its centre or squared radius is not finite".into()
            });
            let near = center.iter().all(|x| x.abs() <= FAR);
            for &vertex in corners.iter().filter(|_| finite && near) {
                let excess = excess_power(center, radius_squared, t.site(vertex));
                report.check(excess <= 1.0, ElementKind::Cell, cell as u64, || {
                    format!(
                        "its centre's power to vertex {vertex} is off the squared radius by \
                         {excess} times what rounding explains"
                    )
                });
            }
        }
        Ok(())
    }

    fn check_rays(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let t = &*self.triangulation;
        let mut rays = self.rays.facets().iter().zip(self.rays.directions());
        for (cell, neighbors) in t.neighbors().iter().enumerate() {
            if cell % 4096 == 0 {
                run.poll()?;
            }
            for facet in (0..4).filter(|&i| neighbors[i] == NONE) {
                let ray = rays.next();
                let right = ray.is_some_and(|(found, direction)| {
                    *found == [cell as u32, facet as u32]
                        && self.is_outward(cell as u32, facet, *direction)
                });
                report.check(right, ElementKind::Cell, cell as u64, || {
                    format!("facet {facet} on the hull has no ray normal to it and outward")
                });
            }
        }
        report.check(rays.next().is_none(), ElementKind::Cell, 0, || {
            "there is a ray without a facet of the hull".into()
        });
        Ok(())
    }

    /// Whether the direction has length 1, is normal to the facet, and leaves the cell.
    fn is_outward(&self, cell: u32, facet: usize, direction: [f64; 3]) -> bool {
        let t = &*self.triangulation;
        let at = |v: u32| t.coords()[v as usize];
        // Differences are exact, and so is the comparison up to its own 2^-100.
        let along = |from: u32, to: u32| {
            let [size, dot] = sizes(&Pairs::difference(at(to), at(from)), direction);
            (dot, size * 8.0 * UNIT)
        };
        let [x, y, z] = t.facet(cell, facet);
        let normal = [(x, y), (y, z), (z, x)].into_iter().all(|(from, to)| {
            let (dot, error) = along(from, to);
            dot.abs() <= error
        });
        let length: f64 = direction.iter().map(|x| x * x).sum();
        let (out, error) = along(t.cells()[cell as usize][facet], x);
        normal && (length - 1.0).abs() <= 16.0 * UNIT && out >= -error
    }

    fn check_facets(&self, facets: &Facets, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let count = facets.len();
        let complete = facets.offsets().len() == count + 1
            && facets.rays().len() == count
            && facets.offsets().windows(2).all(|pair| pair[0] <= pair[1])
            && facets.offsets().last().is_some_and(|&n| n as usize == facets.cells().len())
            && facets.cells().iter().all(|&c| (c as usize) < self.centers.len());
        report.check(complete, ElementKind::Edge, count as u64, || {
            "the rings are not complete".into()
        });
        if !complete {
            return Ok(());
        }
        // Every ring has different cells, all with its edge; so six entries per cell are all there are.
        let entries = self.triangulation.cells().len() * 6;
        report.check(facets.cells().len() == entries, ElementKind::Edge, count as u64, || {
            format!("the rings have {} cells, not {entries}", facets.cells().len())
        });
        let mut sorted = Vec::new();
        for (i, edge) in facets.edges().iter().enumerate() {
            if i % 4096 == 0 {
                run.tick(i, count)?;
            }
            let ascends = edge[0] < edge[1] && (i == 0 || facets.edges()[i - 1] < *edge);
            report.check(ascends, ElementKind::Edge, i as u64, || "it is out of order".into());
            sorted.clear();
            sorted.extend_from_slice(facets.ring(i));
            sorted.sort_unstable();
            let simple = !sorted.is_empty() && sorted.windows(2).all(|pair| pair[0] < pair[1]);
            let sound = simple && self.is_ring(facets, i);
            report.check(sound, ElementKind::Edge, i as u64, || {
                "its ring is not that of the cells round the edge".into()
            });
        }
        Ok(())
    }

    /// Whether ring `i` turns counterclockwise round its edge, from neighbour to neighbour, from its
    /// proper first cell, and ends as its rays say.
    fn is_ring(&self, facets: &Facets, i: usize) -> bool {
        let t = &*self.triangulation;
        let [a, b] = facets.edges()[i];
        let ring = facets.ring(i);
        // The two other vertices, k before l, of a cell that has the edge.
        let others = |cell: u32| {
            let corners = t.cells()[cell as usize];
            let slot = |v: u32| corners.iter().position(|&w| w == v);
            let (a, b) = (slot(a)?, slot(b)?);
            let mut rest = (0..4).filter(|&s| s != a && s != b);
            let (k, l) = (rest.next()?, rest.next()?);
            Some(match is_even([a, b, k, l]) {
                true => [k, l],
                false => [l, k],
            })
        };
        // Ahead lies the facet opposite k, behind the one opposite l.
        let ahead = |cell: u32| others(cell).map(|[k, _]| t.neighbors()[cell as usize][k]);
        let steps = ring.windows(2).all(|pair| ahead(pair[0]) == Some(pair[1]));
        let (first, last) = (ring[0], ring[ring.len() - 1]);
        let ends = match facets.rays()[i] {
            [NONE, NONE] => ahead(last) == Some(first) && ring.iter().all(|&c| c >= first),
            [entry, exit] => {
                let ray = |i: u32| self.rays.facets().get(i as usize).copied();
                let facet = |cell: u32, slot: usize| Some([cell, slot as u32]);
                others(first).is_some_and(|[_, l]| ray(entry) == facet(first, l))
                    && others(last).is_some_and(|[k, _]| ray(exit) == facet(last, k))
            }
        };
        steps && ends
    }
}

/// Whether the order of four different slots is an even permutation.
fn is_even(slots: [usize; 4]) -> bool {
    let inversions = (0..4).flat_map(|i| (i + 1..4).map(move |j| (i, j)));
    inversions.filter(|&(i, j)| slots[i] > slots[j]).count() % 2 == 0
}

/// The sum of |x| |y| and the sum of x y over the coordinates; the latter to about 2^-100 of the former.
fn sizes(x: &Pairs<3>, y: [f64; 3]) -> [f64; 2] {
    let products = x.mul(&Pairs::exact(y));
    let [a, b, c] = [0, 1, 2].map(|k| products.pick([k]));
    let sum = a.add(&b).add(&c).normalized();
    [products.hi.iter().map(|x| x.abs()).sum(), sum.hi[0]]
}

/// How far the power of the centre to the site is from the squared radius, in units of what the rounding
/// of both explains.
fn excess_power(center: [f64; 3], radius_squared: f64, [x, y, z, weight]: [f64; 4]) -> f64 {
    let offset = Pairs::difference(center, [x, y, z]);
    let squares = offset.mul(&offset);
    let [a, b, c] = [0, 1, 2].map(|k| squares.pick([k]));
    let power = a.add(&b).add(&c).sub(&Pairs::exact([weight]));
    let gap = power.sub(&Pairs::exact([radius_squared])).normalized().hi[0];
    // A coordinate is off by half an ulp, and so is the squared radius. The calculation itself is off by less
    // than 64u², and the smallest half ulp is that of subnormals.
    let explained: f64 = (0..3)
        .map(|k| (offset.hi[k].abs(), UNIT * center[k].abs()))
        .map(|(length, half)| half * (2.0 * length + half) + 64.0 * UNIT * UNIT * length * length)
        .sum();
    let explained = explained
        + (UNIT + 64.0 * UNIT * UNIT) * radius_squared.abs()
        + 64.0 * UNIT * UNIT * weight.abs()
        + f64::from_bits(1);
    gap.abs() / (explained * (1.0 + 16.0 * UNIT))
}

#[cfg(test)]
mod tests;

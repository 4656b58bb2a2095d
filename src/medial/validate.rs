//! The check of the facets' attributes.

use super::Medial;
use super::reach::norm;
use crate::error::{ElementKind, Result};
use crate::index::NONE;
use crate::job::{Job, Run, Stage};
use crate::poles::{FirstPoles, TangentPlane};
use crate::validation::Validation;
use crate::vector::{Vec3, cross, dot, length, sub, unit};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{ToPrimitive, float::FloatCore};
use std::array::from_fn;

impl Medial {
    /// Checks umbrellas and conditions from the other side than they were made: round each Voronoi facet, whose polygon a tangent plane must
    /// cut twice or not at all, the triangles of the umbrellas of the dual edge's ends are found again, and the
    /// conditions from these; disks are followed round. No Voronoi vertex of a sample may be farther than its pole; cells of one Voronoi vertex have one
    /// centre and one scale; and no corner of a facet is outside its reach, nor are all of them much farther than its nearest point. Errors: those of the job. Cost: that of
    /// [`Medial::new`].
    pub fn validate(&self, job: &Job) -> Result<Validation> {
        job.run(&[(Stage::Validate, 1.0)], |run| {
            run.enter(Stage::Validate)?;
            let mut report = Validation::new();
            self.check_facets(&mut report, run)?;
            self.check_disks(&mut report, run)?;
            self.check_cells(&mut report, run)?;
            self.check_reaches(&mut report, run)?;
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
                // Both are right to some 10^-13: the sine of 1, the ratio of itself.
                let right = is_near(is.0, sine, 1.0) && is_near(is.1, ratio, ratio);
                report.check(right, ElementKind::Edge, facet as u64, || {
                    format!("from vertex {end} it has {is:?}, not {:?}", (sine, ratio))
                });
            }
        }
        Ok(())
    }

    fn check_cells(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let t = self.dual.triangulation();
        let radius = |cell: u32| self.dual.radii_squared()[cell as usize];
        for cell in run.watch(0..t.cells().len()) {
            let cell = cell?;
            let corners = t.cells()[cell];
            for v in corners {
                let pole = self.poles.cells[v as usize];
                let right = pole == NONE
                    || (t.cells()[pole as usize].contains(&v)
                        && radius(pole) >= radius(cell as u32));
                report.check(right, ElementKind::Cell, cell as u64, || {
                    format!("its centre is farther from vertex {v} than the pole")
                });
            }
            let least = self.least_cell[cell] as usize;
            let same = self.dual.centers()[least] == self.dual.centers()[cell];
            let scale = |cell: usize| self.scales.get(cell).map(|x| x.to_bits());
            let right = least <= cell
                && self.least_cell[least] as usize == least
                && same
                && scale(least) == scale(cell);
            report.check(right, ElementKind::Cell, cell as u64, || {
                format!("cell {least} has not its Voronoi vertex")
            });
        }
        Ok(())
    }

    fn check_reaches(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let facets = self.facets()?;
        let coords = self.dual.triangulation().coords();
        for facet in run.watch(0..facets.len()) {
            let facet = facet?;
            let [p, q] = facets.edges()[facet].map(|v| coords[v as usize]);
            let middle = [0, 1, 2].map(|k| p[k] / 2.0 + q[k] / 2.0);
            let [nearest, farthest] = self.reaches[facet];
            let ring = facets.ring(facet);
            let at = |i: usize| self.dual.centers()[ring[i % ring.len()] as usize];
            let (mut least, mut most, mut rim) = (f64::INFINITY, 0.0f64, 0.0);
            for i in 0..ring.len() {
                let distance = norm(sub(at(i), middle));
                (least, most) = (least.min(distance), most.max(distance));
                rim += norm(sub(at(i + 1), at(i)));
            }
            // The middle and the differences are rounded once each; a few roundings more for the point of a side that is nearest.
            let rounding = 16.0 * f64::EPSILON * (norm(middle) + most);
            let is_unbounded = facets.is_unbounded(facet);
            // From no point of a bounded facet all its corners are farther than half round it.
            let not_too_near = is_unbounded || nearest + 0.5 * rim + rounding >= least;
            let end = if is_unbounded { f64::INFINITY } else { most };
            let right = nearest >= 0.0
                && nearest <= least + rounding
                && not_too_near
                && near(farthest, end);
            report.check(right, ElementKind::Edge, facet as u64, || {
                format!(
                    "its reach is {:?}, its corners {:?} away",
                    [nearest, farthest],
                    [least, most]
                )
            });
        }
        Ok(())
    }

    /// The sine and the ratio of an edge, from the triangles' angles: another formula than that which made them. Where that angle tells little in
    /// floats, from integers.
    fn measured(&self, end: u32, edge: Vec3) -> (f64, f64) {
        let coords = self.dual.triangulation().coords();
        let p = coords[end as usize];
        let (mut sine, mut ratio) = (f64::INFINITY, f64::INFINITY);
        for rim in self.umbrellas.rims_of(end) {
            let [u, v] = rim.map(|v| coords[v as usize]);
            // The corner with the largest angle: needles lose the least digits there.
            let corners = [[p, u, v], [u, v, p], [v, p, u]];
            let cosine = |[at, a, b]: [Vec3; 3]| {
                let [a, b] = [a, b].map(|x| unit(sub(x, at)));
                dot(a, b)
            };
            let widest = corners.into_iter().min_by(|&a, &b| cosine(a).total_cmp(&cosine(b)));
            let [at, a, b] = widest.unwrap_or(corners[0]);
            let opposite = length(sub(b, a));
            let normal = cross(unit(sub(a, at)), unit(sub(b, at)));
            let size = length(normal);
            let (its_sine, diameter) = match size > 0.01 {
                // A side by the sine of the angle opposite.
                true => (dot(normal, edge).abs() / size / length(edge), opposite / size),
                false => in_integers([p, u, v], edge),
            };
            sine = sine.min(its_sine);
            ratio = ratio.min(2.0 * length(edge) / diameter);
        }
        (sine, ratio)
    }

    /// Whether the cell's centre lies below the tangent plane of the vertex.
    fn is_below(&self, vertex: u32, cell: u32) -> bool {
        let v = vertex as usize;
        let FirstPoles { cells, normals } = &self.poles;
        TangentPlane::new(&self.dual, v, cells[v], normals[v]).is_below(&self.dual, vertex, cell)
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

/// The sine of the angle between an edge and a triangle's plane, and the diameter of its circumscribed circle, from exact products, each
/// of which is rounded once.
fn in_integers(corners: [Vec3; 3], edge: Vec3) -> (f64, f64) {
    // Everything is a multiple of 2^unit.
    let others = corners.iter().chain([&edge]).flatten().filter(|x| **x != 0.0);
    let unit = others.map(|x| i32::from(x.integer_decode().1)).min().unwrap_or(0);
    let integer = |x: f64| match x.integer_decode() {
        (0, ..) => BigInt::ZERO,
        (mantissa, power, sign) => (BigInt::from(mantissa) << (i32::from(power) - unit)) * sign,
    };
    let minus = |a: &Exact, b: &Exact| -> Exact { from_fn(|k| &a[k] - &b[k]) };
    let times = |a: &Exact, b: &Exact| -> BigInt { (0..3).map(|k| &a[k] * &b[k]).sum() };
    // A product of so many coordinates.
    let float = |x: BigInt, factors: i32| {
        let exact = match factors * unit {
            power @ 0.. => BigRational::from(x << power),
            power => BigRational::new_raw(x, BigInt::from(1) << -power),
        };
        exact.to_f64().unwrap_or(f64::NAN)
    };
    let size = |a: &Exact, factors: i32| float(times(a, a), 2 * factors).sqrt();
    let [p, u, v, edge] = [corners[0], corners[1], corners[2], edge].map(|p| p.map(integer));
    let [a, b] = [minus(&u, &p), minus(&v, &p)];
    let normal = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i]);
    let area = size(&normal, 2);
    let sine = float(times(&normal, &edge), 3).abs() / area / size(&edge, 1);
    // The product of the sides by twice the area.
    (sine, size(&minus(&u, &v), 1) * (size(&a, 1) * size(&b, 1) / area))
}

/// A point or a vector in integers.
type Exact = [BigInt; 3];

/// Whether two numbers differ by no more than 10^-12 of a size.
fn is_near(a: f64, b: f64, size: f64) -> bool {
    a == b || (a - b).abs() <= 1e-12 * size
}

/// Whether two numbers agree but for rounding. Needles lose digits.
fn near(a: f64, b: f64) -> bool {
    let size = a.abs().max(b.abs());
    a == b || (size.is_finite() && (a - b).abs() <= 1e-6 * size.max(1e-6))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dual::{Dual, DualOptions};
    use crate::medial::MedialOptions;
    use crate::sample::{SampleOptions, Shape, sample};
    use crate::{Points, Triangulation};
    use std::sync::Arc;

    fn medial() -> Medial {
        let job = Job::default();
        let options = SampleOptions { spacing: 0.25, ..Default::default() };
        let rows = sample(Shape::Torus, options, &job).unwrap().points().to_vec();
        let points = Arc::new(Points::new(&rows, Default::default(), &job).unwrap());
        let t = Arc::new(Triangulation::delaunay(&points, &job).unwrap());
        let dual = Arc::new(Dual::new(&t, DualOptions { facets: true }, &job).unwrap());
        let options = MedialOptions { scales: true, ..Default::default() };
        Medial::new(&dual, None, options, &job).unwrap()
    }

    fn is_valid(medial: &Medial) -> bool {
        medial.validate(&Job::default()).unwrap().is_valid()
    }

    /// Whether each of some changes is noticed, every one made to a sound structure.
    fn all_noticed(count: usize, change: impl Fn(&mut Medial, usize)) {
        let sound = medial();
        assert!(is_valid(&sound) && count > 0);
        for i in 0..count {
            let mut broken = sound.clone();
            change(&mut broken, i);
            assert!(!is_valid(&broken), "change {i}");
        }
    }

    #[test]
    fn another_condition_is_noticed() {
        all_noticed(40, |medial, i| {
            let sine = &mut medial.conditions.sines[29 * i][i % 2];
            *sine = if *sine < 0.0 { 0.5 } else { f64::NEG_INFINITY };
        });
        all_noticed(40, |medial, i| {
            let ratio = &mut medial.conditions.ratios[23 * i][i % 2];
            *ratio = if *ratio < 0.0 { 2.0 } else { 1.001 * *ratio };
        });
        // By little.
        all_noticed(40, |medial, i| {
            let sines = medial.conditions.sines.as_flattened_mut().iter_mut();
            *sines.filter(|sine| **sine >= 0.0).nth(29 * i).unwrap() += 1e-11;
        });
        all_noticed(40, |medial, i| {
            let ratios = medial.conditions.ratios.as_flattened_mut().iter_mut();
            *ratios.filter(|ratio| **ratio >= 0.0).nth(23 * i).unwrap() *= 1.0 + 1e-11;
        });
    }

    #[test]
    fn another_umbrella_is_noticed() {
        all_noticed(40, |medial, i| {
            let vertices = medial.umbrellas.is_disk.len() as u32;
            let end = &mut medial.umbrellas.rims[19 * i][i % 2];
            *end = (*end + 1) % vertices;
        });
        // A triangle too few, in the umbrella of one sample.
        all_noticed(20, |medial, i| {
            let end = medial.umbrellas.offsets[7 * i + 1] as usize;
            medial.umbrellas.rims.remove(end - 1);
            medial.umbrellas.offsets[7 * i + 1..].iter_mut().for_each(|offset| *offset -= 1);
        });
        all_noticed(20, |medial, i| medial.umbrellas.is_disk[5 * i] ^= true);
    }

    #[test]
    fn another_pole_or_scale_or_reach_is_noticed() {
        all_noticed(20, |medial, i| {
            // A vertex within the hull, and a lesser one of its cells.
            let inner = (0..medial.poles.cells.len()).filter(|&v| medial.poles.cells[v] != NONE);
            let v = inner.cycle().nth(3 * i).unwrap();
            let cells = medial.dual.triangulation().cells().iter();
            let radius = |cell: usize| medial.dual.radii_squared()[cell];
            let of_v = cells.enumerate().filter(|(_, corners)| corners.contains(&(v as u32)));
            let least = of_v.min_by(|a, b| radius(a.0).total_cmp(&radius(b.0))).unwrap().0;
            medial.poles.cells[v] = least as u32;
        });
        all_noticed(20, |medial, i| medial.least_cell[11 * i + 1] = 0);
        all_noticed(20, |medial, i| medial.reaches[13 * i][i % 2] = 123.0);
        all_noticed(20, |medial, i| medial.reaches[13 * i][0] -= 100.0);
        // A small facet far from the middle of its edge, said to have it.
        let facets = |medial: &Medial| {
            let small = |reach: &[f64; 2]| reach[1] < 1.02 * reach[0] && reach[0] > 0.0;
            let reaches = medial.reaches.iter().enumerate();
            reaches.filter(|(_, reach)| small(reach)).map(|(facet, _)| facet).collect::<Vec<_>>()
        };
        all_noticed(20, |medial, i| {
            let facets = facets(medial);
            let facet = facets[i * facets.len() / 20];
            medial.reaches[facet][0] = 0.0;
        });
    }

    #[test]
    fn a_last_bit_of_a_reach_is_no_problem() {
        let mut medial = medial();
        for reach in &mut medial.reaches {
            *reach = reach.map(f64::next_up);
        }
        assert!(is_valid(&medial));
    }
}

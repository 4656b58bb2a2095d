//! Centres of cells, correctly rounded: circumcentres and orthocentres, with their radii.
//!
//! With b, c, d the offsets of three vertices from the first one, a, the centre is a + N / 2D, where
//! D = b . (c x d), N = B (c x d) + C (d x b) + D' (b x c), and B = |b|² + w_a - w_b and so on. Three
//! stages give the f64 nearest to each coordinate and to the squared radius |N / 2D|² - w_a:
//!
//! 1. arithmetic in pairs of floats with an error bound; taken where every number within the bound
//!    rounds to the same f64 (Ziv 1991);
//! 2. integers of fixed width (`fixed.rs`), where the points lie on one grid that is not too fine for them;
//! 3. integers of any size (`exact.rs`).

use super::{exact, processor};
use crate::predicates::double_double::{Pairs, each};
use std::array::from_fn;
use std::cmp::Ordering;

/// Four points.
type Cell = [[f64; 3]; 4];

/// Where the power distances to four vertices agree, and what they are there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Center {
    /// The centre, each coordinate the f64 nearest to the exact one (ties to even).
    pub position: [f64; 3],
    /// The squared radius: the power of the centre with respect to each vertex, |p - a|² - w_a, the
    /// f64 nearest to the exact one. Negative where weights are large.
    pub radius_squared: f64,
}

/// The centre and squared radius of the sphere through four points; `None` if they are coplanar.
///
/// Every number is the f64 nearest to the exact one, or the largest finite f64 of its sign where the
/// exact one is larger still. So the result does not depend on the order of the points. The
/// coordinates must be finite. Cost: less than a microsecond; some ten where the points are so nearly
/// coplanar, or so far apart in scale, that pairs of floats do not suffice.
pub fn circumcenter(points: [[f64; 3]; 4]) -> Option<Center> {
    let [center] = centers::<1, true>(&[points], None, &[points[0]]);
    center
}

/// The centre and squared radius of the sphere orthogonal to four weighted points: the point x where
/// |x - p|² - w is the same for all four; `None` if they are coplanar.
///
/// See [`circumcenter`]; the weights must be finite too.
pub fn orthocenter(points: [[f64; 3]; 4], weights: [f64; 4]) -> Option<Center> {
    let [center] = centers::<1, true>(&[points], Some(&[weights]), &[points[0]]);
    center
}

/// The centres of `L` cells less their first points, each coordinate rounded once; see [`circumcenter`].
pub(crate) fn offsets<const L: usize>(cells: &[Cell; L]) -> [Option<[f64; 3]>; L] {
    centers::<L, false>(cells, None, &[[0.0; 3]; L]).map(|center| center.map(|c| c.position))
}

/// The order of the exact circumradii of two cells that are not flat and share their first point.
///
/// Cost: a fraction of a microsecond; some ten where they are equal to 90 bits.
pub(crate) fn radius_order(cells: [Cell; 2]) -> Ordering {
    Estimates::new::<false>(&cells, None)
        .radius_order()
        .unwrap_or_else(|| exact::radius_order(cells))
}

/// The centres of `L` cells with the first points taken for `bases`; see [`orthocenter`]. The squared radii
/// mean nothing without `RADIUS`.
pub(super) fn centers<const L: usize, const RADIUS: bool>(
    cells: &[Cell; L],
    weights: Option<&[[f64; 4]; L]>,
    bases: &[[f64; 3]; L],
) -> [Option<Center>; L] {
    let found = processor::estimate::<L, RADIUS>(cells, weights, bases);
    from_fn(|l| match found.sure[l] {
        true => Some(Center {
            position: found.position.map(|x| x[l]),
            radius_squared: found.radius_squared[l],
        }),
        false => exact::center::<RADIUS>(cells[l], weights.map(|weights| weights[l]), bases[l]),
    })
}

/// The centres as far as arithmetic in pairs of floats tells.
#[inline(always)]
pub(super) fn estimate<const L: usize, const RADIUS: bool, const FMA: bool>(
    cells: &[Cell; L],
    weights: Option<&[[f64; 4]; L]>,
    bases: &[[f64; 3]; L],
) -> Centers<L> {
    Estimates::new::<FMA>(cells, weights).centers::<RADIUS, FMA>(bases)
}

/// 2^-106, the square of the rounding unit u.
const UNIT_SQUARED: f64 = power_of_two(-106);
/// Where the largest coordinate difference lies between these two, nothing is scaled.
const NATURAL: [f64; 2] = [power_of_two(-60), power_of_two(60)];
/// Where it lies between these two, scaling keeps everything in range.
const SCALABLE: [f64; 2] = [power_of_two(-500), power_of_two(500)];
/// The largest lift, |b|² + |w_a - w_b|, and the largest weight, after scaling.
const LIFT_LIMIT: f64 = power_of_two(250);
/// More than all that underflow can add. An operation that underflows is wrong by 2^-1074; further
/// factors are below 2^252 (a lift) and 2^125 (a cross product), and there are fewer than 2^8.
const UNDERFLOW: f64 = power_of_two(-680);
/// The largest error of the determinant relative to itself with which the first stage goes on.
const DETERMINANT_ERROR: f64 = power_of_two(-20);

/// 2^`exponent`, for exponents of normal numbers.
pub(super) const fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

/// N / 2D of `L` cells in pairs of floats, with error bounds, all of it scaled by powers of two.
struct Estimates<const L: usize> {
    /// Normalised.
    offset: [Pairs<L>; 3],
    error: [[f64; L]; 3],
    /// The weights of the first points, times the squares of `scale`.
    weight: [f64; L],
    scale: [f64; L],
    /// Whether the sign of the determinant is certain, and everything is in range.
    certain: [bool; L],
}

impl<const L: usize> Estimates<L> {
    /// The bounds, in the terms of `predicates/double_double.rs`: differences are 1-loose with error
    /// 0, products of two (3, 8), entries of a cross product (4, 15), lifts (5, 24), with a
    /// difference of weights (6, 35), the determinant (8, 63), an entry of N (13, 153). So D is
    /// wrong by 63u² and N by 153u² times their sizes, the same formulas on absolute values, which are
    /// calculated in floats here; 66 and 160 leave room for the rounding of the sizes.
    #[inline(always)]
    fn new<const FMA: bool>(cells: &[Cell; L], weights: Option<&[[f64; 4]; L]>) -> Self {
        // No closures but in `each`: they may not become part of this function, see there.
        let mut edges = [[Pairs::default(); 3]; 3];
        for (i, edge) in edges.iter_mut().enumerate() {
            for (k, x) in edge.iter_mut().enumerate() {
                *x = Pairs::difference(each(|l| cells[l][i + 1][k]), each(|l| cells[l][0][k]));
            }
        }
        let mut largest = [0.0f64; L];
        for x in edges.as_flattened() {
            largest = each(|l| largest[l].max(x.hi[l].abs()));
        }
        let within = |l: usize, range: [f64; 2]| largest[l] >= range[0] && largest[l] <= range[1];
        let mut certain = [true; L];
        let mut scale = [1.0; L];
        if !(0..L).all(|l| within(l, NATURAL)) {
            for l in 0..L {
                certain[l] = within(l, SCALABLE);
                if certain[l] && !within(l, NATURAL) {
                    scale[l] = power_of_two(1023 - (largest[l].to_bits() >> 52) as i32);
                }
            }
            for x in edges.as_flattened_mut() {
                *x = x.scaled(scale);
            }
        }
        let mut lifts = [Pairs::default(); 3];
        for (lift, edge) in lifts.iter_mut().zip(&edges) {
            *lift = dot::<L, FMA>(edge, edge);
        }
        let mut lift_sizes = [lifts[0].hi, lifts[1].hi, lifts[2].hi];
        let mut weight = [0.0; L];
        if let Some(weights) = weights {
            weight = each(|l| weights[l][0] * scale[l] * scale[l]);
            for i in 0..3 {
                let gap = Pairs::difference(each(|l| weights[l][0]), each(|l| weights[l][i + 1]));
                let gap = gap.scaled(scale).scaled(scale);
                lifts[i] = lifts[i].add(&gap);
                lift_sizes[i] = each(|l| lift_sizes[i][l] + gap.hi[l].abs());
                for l in 0..L {
                    certain[l] &= lift_sizes[i][l] <= LIFT_LIMIT && weight[l].abs() <= LIFT_LIMIT;
                }
            }
        }
        let crosses = [
            cross::<L, FMA>(&edges[1], &edges[2]),
            cross::<L, FMA>(&edges[2], &edges[0]),
            cross::<L, FMA>(&edges[0], &edges[1]),
        ];
        let cross_sizes = [
            cross_size(&edges[1], &edges[2]),
            cross_size(&edges[2], &edges[0]),
            cross_size(&edges[0], &edges[1]),
        ];
        let determinant = dot::<L, FMA>(&edges[0], &crosses[0]).normalized();
        let determinant_error: [f64; L] = each(|l| {
            let size = edges[0][0].hi[l].abs() * cross_sizes[0][0][l]
                + edges[0][1].hi[l].abs() * cross_sizes[0][1][l]
                + edges[0][2].hi[l].abs() * cross_sizes[0][2][l];
            66.0 * UNIT_SQUARED * size + UNDERFLOW
        });
        for l in 0..L {
            certain[l] &= determinant_error[l] <= DETERMINANT_ERROR * determinant.hi[l].abs();
        }
        let inverse = each(|l| 0.5 / determinant.hi[l]);
        let divisor = determinant.scaled([2.0; L]);
        let (mut offset, mut error) = ([Pairs::default(); 3], [[0.0; L]; 3]);
        for k in 0..3 {
            let column = [crosses[0][k], crosses[1][k], crosses[2][k]];
            let numerator = dot::<L, FMA>(&lifts, &column).normalized();
            offset[k] = divide::<L, FMA>(&numerator, &divisor, inverse);
            // |N'/D' - N/D| <= (|N' - N| + |N'/D'| |D' - D|) / |D|, where |D| >= (1 - 2^-20) |D'|; then
            // the division's own error of 47u².
            error[k] = each(|l| {
                let size = lift_sizes[0][l] * cross_sizes[0][k][l]
                    + lift_sizes[1][l] * cross_sizes[1][k][l]
                    + lift_sizes[2][l] * cross_sizes[2][k][l];
                let quotient = offset[k].hi[l].abs();
                let numerator_error = 0.5 * (160.0 * UNIT_SQUARED * size + UNDERFLOW);
                (numerator_error + quotient * determinant_error[l])
                    * (2.0 * inverse[l].abs() * (1.0 + 4.0 * DETERMINANT_ERROR))
                    + 64.0 * UNIT_SQUARED * quotient
                    + UNDERFLOW
            });
        }
        Estimates { offset, error, weight, scale, certain }
    }

    /// The scaled squared radii and their errors: a square is wrong by 2 |x| e + e² for each coordinate x
    /// wrong by e; it is (5, 24), less the weight (6, 35), and the ends of the interval are rounded by 6u².
    #[inline(always)]
    fn powers<const FMA: bool>(&self) -> (Pairs<L>, [f64; L]) {
        let square = dot::<L, FMA>(&self.offset, &self.offset);
        let mut error = [UNDERFLOW; L];
        for k in 0..3 {
            let (own, size) = (self.error[k], self.offset[k].hi);
            let factor = 1.0 + DETERMINANT_ERROR;
            error = each(|l| error[l] + own[l] * (2.0 * size[l].abs() + own[l]) * factor);
        }
        let rounding = 48.0 * UNIT_SQUARED;
        let error = each(|l| error[l] + rounding * (square.hi[l] + self.weight[l].abs()));
        (square.sub(&Pairs::exact(self.weight)), error)
    }

    /// The rounded centres, the squared radii only with `RADIUS`, and whether the rounding of each number is certain.
    #[inline(always)]
    fn centers<const RADIUS: bool, const FMA: bool>(&self, bases: &[[f64; 3]; L]) -> Centers<L> {
        let unscale: [f64; L] = each(|l| 1.0 / self.scale[l]);
        let mut sure = self.certain;
        let mut position = [[0.0; L]; 3];
        // A sum with an exact number: 3u² of both sizes, and 2u² for the rounding of the two ends.
        for k in 0..3 {
            let base: [f64; L] = each(|l| bases[l][k]);
            let offset = self.offset[k].scaled(unscale);
            let error = each(|l| {
                self.error[k][l] * unscale[l]
                    + 8.0 * UNIT_SQUARED * (base[l].abs() + offset.hi[l].abs())
            });
            position[k] = round(&Pairs::exact(base).add(&offset), error, &mut sure);
        }
        let mut radius_squared = [0.0; L];
        if RADIUS {
            let (power, error) = self.powers::<FMA>();
            let power = round(&power, error, &mut sure);
            radius_squared = each(|l| power[l] * unscale[l] * unscale[l]);
            // Unscaling is exact unless the result is subnormal or infinite.
            for l in 0..L {
                sure[l] &= self.scale[l] == 1.0 || radius_squared[l].is_normal();
            }
        }
        Centers { position, radius_squared, sure }
    }
}

/// The centres of `L` cells.
pub(super) struct Centers<const L: usize> {
    /// Each coordinate of all of them.
    position: [[f64; L]; 3],
    radius_squared: [f64; L],
    /// Whether all numbers are certainly the right ones.
    sure: [bool; L],
}

impl Estimates<2> {
    /// The order of the two squared radii, where it is certain.
    fn radius_order(&self) -> Option<Ordering> {
        let (power, error) = self.powers::<false>();
        let [a, b] = [0, 1].map(|l| power.pick([l]));
        let gap = a.sub(&b).normalized().hi[0];
        // The difference of two (6, 35) is wrong by 13u² of their sum, and by the errors of both.
        let error = error[0] + error[1] + 16.0 * UNIT_SQUARED * (a.hi[0].abs() + b.hi[0].abs());
        let sure = self.certain == [true; 2] && self.scale[0] == self.scale[1];
        // A comparison with NaN is false: what overflows is decided exactly.
        (sure && gap.abs() > error * (1.0 + DETERMINANT_ERROR)).then_some(if gap > 0.0 {
            Ordering::Greater
        } else {
            Ordering::Less
        })
    }
}

#[inline(always)]
fn dot<const L: usize, const FMA: bool>(x: &[Pairs<L>; 3], y: &[Pairs<L>; 3]) -> Pairs<L> {
    let sum = x[0].times::<FMA>(&y[0]).add(&x[1].times::<FMA>(&y[1]));
    sum.add(&x[2].times::<FMA>(&y[2]))
}

/// The two other axes of each.
const OTHERS: [[usize; 2]; 3] = [[1, 2], [2, 0], [0, 1]];

#[inline(always)]
fn cross<const L: usize, const FMA: bool>(x: &[Pairs<L>; 3], y: &[Pairs<L>; 3]) -> [Pairs<L>; 3] {
    let mut cross = [Pairs::default(); 3];
    for (entry, [i, j]) in cross.iter_mut().zip(OTHERS) {
        *entry = x[i].times::<FMA>(&y[j]).sub(&x[j].times::<FMA>(&y[i]));
    }
    cross
}

#[inline(always)]
fn cross_size<const L: usize>(x: &[Pairs<L>; 3], y: &[Pairs<L>; 3]) -> [[f64; L]; 3] {
    let mut size = [[0.0; L]; 3];
    for (entry, [i, j]) in size.iter_mut().zip(OTHERS) {
        *entry = each(|l| (x[i].hi[l] * y[j].hi[l]).abs() + (x[j].hi[l] * y[i].hi[l]).abs());
    }
    size
}

/// The quotients of normalised numbers, normalised and wrong by at most 47u² of themselves; `inverse`
/// is 1 / `divisor.hi` rounded.
///
/// The first digit q is off by 4u of itself, so the remainder is 4u |x| in absolute value. The product
/// of the divisor with q is (3, 8), the difference from x (4, 15) for the magnitude 2 |x|: wrong by 30u² |x|.
/// Its two parts are added, wrong by 4u² |x|, and the second digit is off by 3u of itself,
/// 12u² |x / divisor|: 46u² and terms in u³.
#[inline(always)]
fn divide<const L: usize, const FMA: bool>(
    x: &Pairs<L>,
    divisor: &Pairs<L>,
    inverse: [f64; L],
) -> Pairs<L> {
    let hi: [f64; L] = each(|l| x.hi[l] * inverse[l]);
    let rest = x.sub(&divisor.times::<FMA>(&Pairs::exact(hi)));
    Pairs { hi, lo: each(|l| (rest.hi[l] + rest.lo[l]) * inverse[l]) }.normalized()
}

/// The floats nearest to the pairs; those stay `sure` where every number within the error rounds to the same finite
/// one. The error must leave room for the rounding of lo - error and lo + error.
#[inline(always)]
fn round<const L: usize>(x: &Pairs<L>, error: [f64; L], sure: &mut [bool; L]) -> [f64; L] {
    let low: [f64; L] = each(|l| x.hi[l] + (x.lo[l] - error[l]));
    let high: [f64; L] = each(|l| x.hi[l] + (x.lo[l] + error[l]));
    for l in 0..L {
        sure[l] &= low[l] == high[l] && low[l].is_finite();
    }
    // Adding 0 turns -0 into 0.
    each(|l| low[l] + 0.0)
}

#[cfg(test)]
mod tests;

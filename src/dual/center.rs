//! Centres of cells, correctly rounded: circumcentres and orthocentres, with their radii.
//!
//! With b, c, d the offsets of three vertices from the first one, a, the centre is a + N / 2D, where
//! D = b . (c x d), N = B (c x d) + C (d x b) + D' (b x c), and B = |b|² + w_a - w_b and so on. Three
//! stages give the f64 nearest to each coordinate and to the squared radius |N / 2D|² - w_a:
//!
//! 1. double-double arithmetic with an error bound; taken where every number within the bound
//!    rounds to the same f64 (Ziv 1991);
//! 2. a grid: where a result lies half way between two f64, or is 0, no error bound helps, but on
//!    lattices the result is a short number, and one can prove that it is right (`exact.rs`);
//! 3. integers of any size (`exact.rs`).

use super::double_double::{Dd, two_sum};
use super::exact;

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
/// coplanar, or so far apart in scale, that double-double arithmetic does not suffice.
pub fn circumcenter(points: [[f64; 3]; 4]) -> Option<Center> {
    solve(points, None, points[0])
}

/// The centre and squared radius of the sphere orthogonal to four weighted points: the point x where
/// |x - p|² - w is the same for all four; `None` if they are coplanar.
///
/// See [`circumcenter`]; the weights must be finite too.
pub fn orthocenter(points: [[f64; 3]; 4], weights: [f64; 4]) -> Option<Center> {
    solve(points, Some(weights), points[0])
}

/// The centre with the first point taken for `base`, and the squared radius.
fn solve(points: [[f64; 3]; 4], weights: Option<[f64; 4]>, base: [f64; 3]) -> Option<Center> {
    quickly(points, weights, base).or_else(|| exact::by_integers(points, weights, base))
}

/// The first two stages; `None` where they do not suffice.
fn quickly(points: [[f64; 3]; 4], weights: Option<[f64; 4]>, base: [f64; 3]) -> Option<Center> {
    let estimate = Estimate::new(points, weights)?;
    estimate.center(base).or_else(|| {
        let offset = estimate.offset.map(|x| x.scaled(1.0 / estimate.scale));
        exact::on_grid(points, weights, base, offset)
    })
}

/// 2^-106, the square of the rounding unit.
const UNIT_SQUARED: f64 = power_of_two(-106);
/// Where the largest coordinate difference lies between these two, nothing is scaled.
const NATURAL: [f64; 2] = [power_of_two(-60), power_of_two(60)];
/// Where it lies between these two, scaling keeps everything in range.
const SCALABLE: [f64; 2] = [power_of_two(-500), power_of_two(500)];
/// The largest difference of weights, after scaling.
const WEIGHT_LIMIT: f64 = power_of_two(250);
/// More than all that underflow can add. An operation that underflows is wrong by 2^-1074; further
/// factors are below 2^252 (a lift) and 2^125 (a cross product), and there are fewer than 2^8.
const UNDERFLOW: f64 = power_of_two(-680);
/// The largest error of the determinant relative to itself with which the first stage goes on.
const DETERMINANT_ERROR: f64 = power_of_two(-20);

/// 2^`exponent`, for exponents of normal numbers.
pub(super) const fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

/// N / 2D in double-double arithmetic, with error bounds, all of it scaled by a power of two.
struct Estimate {
    offset: [Dd; 3],
    error: [f64; 3],
    /// The weight of the first point, times the square of `scale`.
    weight: f64,
    scale: f64,
}

impl Estimate {
    /// `None` where the sign of the determinant is not certain, or something is out of range.
    ///
    /// The bounds: let every operation be wrong by at most 8u² times the same operation on absolute
    /// values (`double_double.rs`), and let k(z) count operations: 0 for an exact z, the larger
    /// one plus 1 for a sum, the sum plus 1 for a product. By induction the computed z is wrong by
    /// at most ((1 + 8u²)^k - 1) times its size, the same formula on absolute values. A difference of
    /// coordinates or weights has k = 0, an entry of a cross product 2, a lift 4, the
    /// determinant 5, an entry of N 9. So D is wrong by 40u² and N by 72u² times their sizes,
    /// which are computed in f64 here; 48 and 80 leave room for the rounding of the sizes.
    fn new([a, b, c, d]: [[f64; 3]; 4], weights: Option<[f64; 4]>) -> Option<Estimate> {
        let mut edges = [b, c, d].map(|p| difference(p, a));
        let largest = edges.iter().flatten().fold(0.0, |m: f64, x| m.max(x.hi.abs()));
        let within = |range: [f64; 2]| largest >= range[0] && largest <= range[1];
        let scale = match within(NATURAL) {
            true => 1.0,
            false if within(SCALABLE) => power_of_two(1023 - (largest.to_bits() >> 52) as i32),
            false => return None,
        };
        if scale != 1.0 {
            edges = edges.map(|edge| edge.map(|x| x.scaled(scale)));
        }
        let sizes = edges.map(|edge| edge.map(|x| x.hi.abs()));
        let mut lifts = edges.map(|edge| dot(edge, edge));
        let mut lift_sizes = lifts.map(|lift| lift.hi);
        let mut weight = 0.0;
        if let Some(weights) = weights {
            weight = weights[0] * scale * scale;
            for i in 0..3 {
                let gap = Dd::difference(weights[0], weights[i + 1]).scaled(scale).scaled(scale);
                lifts[i] = lifts[i].plus(gap);
                lift_sizes[i] += gap.hi.abs();
            }
            if !(weight.abs() <= WEIGHT_LIMIT && lift_sizes.iter().all(|&s| s <= WEIGHT_LIMIT)) {
                return None;
            }
        }
        let pairs = [(1, 2), (2, 0), (0, 1)];
        let crosses = pairs.map(|(i, j)| cross(edges[i], edges[j]));
        let cross_sizes = pairs.map(|(i, j)| cross_size(sizes[i], sizes[j]));
        let determinant = dot(edges[0], crosses[0]);
        let size: f64 = (0..3).map(|i| sizes[0][i] * cross_sizes[0][i]).sum();
        let determinant_error = 48.0 * UNIT_SQUARED * size + UNDERFLOW;
        let certain = determinant_error <= DETERMINANT_ERROR * determinant.hi.abs();
        if !certain {
            return None;
        }
        let inverse = 0.5 / determinant.hi;
        let divisor = determinant.scaled(2.0);
        let offset: [(Dd, f64); 3] = std::array::from_fn(|i| {
            let column = [crosses[0][i], crosses[1][i], crosses[2][i]];
            let size: f64 = (0..3).map(|k| lift_sizes[k] * cross_sizes[k][i]).sum();
            let quotient = divide(dot(lifts, column), divisor, inverse);
            // The quotient of wrong numbers, |N'/D' - N/D| <= (|N' - N| + |N'/D'| |D' - D|) / |D|,
            // where |D| >= (1 - 2^-20) |D'|; then the division's own error.
            let error = 0.5 * (80.0 * UNIT_SQUARED * size + UNDERFLOW)
                + quotient.hi.abs() * determinant_error;
            let error = error / determinant.hi.abs() * (1.0 + 4.0 * DETERMINANT_ERROR);
            (quotient, error + 64.0 * UNIT_SQUARED * quotient.hi.abs() + UNDERFLOW)
        });
        Some(Estimate { offset: offset.map(|o| o.0), error: offset.map(|o| o.1), weight, scale })
    }

    /// The rounded centre, if the rounding of each number is certain.
    fn center(&self, base: [f64; 3]) -> Option<Center> {
        let unscale = 1.0 / self.scale;
        let mut position = [0.0; 3];
        for i in 0..3 {
            let offset = self.offset[i].scaled(unscale);
            let sum = Dd { hi: base[i], lo: 0.0 }.plus(offset);
            let error =
                self.error[i] * unscale + 10.0 * UNIT_SQUARED * (base[i].abs() + offset.hi.abs());
            position[i] = sum.rounded_within(error)?;
        }
        // The square is wrong by 2 |x| e + e² for each coordinate x wrong by e, and k is 4.
        let square = dot(self.offset, self.offset);
        let power = square.minus(Dd { hi: self.weight, lo: 0.0 });
        let from_offset: f64 =
            (0..3).map(|i| self.error[i] * (2.0 * self.offset[i].hi.abs() + self.error[i])).sum();
        let error = from_offset * (1.0 + DETERMINANT_ERROR)
            + 40.0 * UNIT_SQUARED * (square.hi + self.weight.abs())
            + UNDERFLOW;
        let radius_squared = power.rounded_within(error)? * unscale * unscale;
        // Unscaling is exact unless the result is subnormal or infinite.
        let exact = self.scale == 1.0 || radius_squared.is_normal();
        exact.then_some(Center { position, radius_squared })
    }
}

#[inline(always)]
fn difference(p: [f64; 3], q: [f64; 3]) -> [Dd; 3] {
    std::array::from_fn(|i| Dd::difference(p[i], q[i]))
}

#[inline(always)]
fn dot(x: [Dd; 3], y: [Dd; 3]) -> Dd {
    x[0].times(y[0]).plus(x[1].times(y[1])).plus(x[2].times(y[2]))
}

#[inline(always)]
fn cross(x: [Dd; 3], y: [Dd; 3]) -> [Dd; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| x[i].times(y[j]).minus(x[j].times(y[i])))
}

#[inline(always)]
fn cross_size(x: [f64; 3], y: [f64; 3]) -> [f64; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| x[i] * y[j] + x[j] * y[i])
}

/// The quotient, wrong by at most 48u² of itself; `inverse` is 1 / `divisor.hi` rounded.
///
/// The first digit is off by 4u of itself: the remainder r is 4u |x| in absolute value. It is computed
/// with an error of 8u² |x| for the product and 6u² (2 |x|) for the difference; its low part, 4u² |x|,
/// is dropped; and the second digit is off by 3u of itself, 12u² |x / divisor|: 36u² in all.
#[inline(always)]
fn divide(x: Dd, divisor: Dd, inverse: f64) -> Dd {
    let first = x.hi * inverse;
    let remainder = x.minus(divisor.times(Dd { hi: first, lo: 0.0 }));
    two_sum(first, remainder.hi * inverse)
}

#[cfg(test)]
mod tests;

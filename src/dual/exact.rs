//! The exact stages behind the centres of cells: integers of fixed width where they suffice, or else of any size.

use super::center::{Center, power_of_two};
use super::fixed;
use crate::predicates::Sign;
use num_bigint::BigInt;
use num_traits::{Signed, ToPrimitive, Zero};
use std::array::from_fn;
use std::cmp::Ordering;

/// The mantissa and exponent of a finite f64: x = m 2^e, with m odd, or 0 and a large exponent.
fn decode(x: f64) -> (i64, i32) {
    let biased = ((x.to_bits() >> 52) & 0x7ff) as i32;
    let fraction = (x.to_bits() & ((1 << 52) - 1)) as i64;
    let mantissa = if biased == 0 { fraction } else { fraction | 1 << 52 };
    if mantissa == 0 {
        return (0, i32::MAX);
    }
    let zeros = mantissa.trailing_zeros();
    let sign = if x < 0.0 { -1 } else { 1 };
    (sign * (mantissa >> zeros), biased.max(1) - 1075 + zeros as i32)
}

/// The largest exponent e such that all coordinates are multiples of 2^e, and all weights of 2^2e.
fn unit_exponent(points: &[[f64; 3]; 4], weights: Option<[f64; 4]>, base: [f64; 3]) -> i32 {
    let weights = weights.into_iter().flatten().map(|w| decode(w).1.div_euclid(2));
    common_exponent(points).min(common_exponent(&[base])).min(weights.min().unwrap_or(i32::MAX))
}

/// The largest exponent e such that all coordinates are multiples of 2^e.
fn common_exponent(points: &[[f64; 3]]) -> i32 {
    points.iter().flatten().map(|&x| decode(x).1).min().unwrap_or(0).min(0x400)
}

/// A vector in integers, in a unit of its own.
type Integers = [BigInt; 3];

/// A point in units of 2^`exponent`.
fn place(point: [f64; 3], exponent: i32) -> Integers {
    point.map(|x| integer(x, exponent))
}

fn difference(a: &Integers, b: &Integers) -> Integers {
    from_fn(|k| &a[k] - &b[k])
}

fn product(a: &Integers, b: &Integers) -> BigInt {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn cross_product(a: &Integers, b: &Integers) -> Integers {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}

/// The centre in exact arithmetic, the squared radius only with `RADIUS`; `None` if the determinant is 0.
pub(super) fn center<const RADIUS: bool>(
    points: [[f64; 3]; 4],
    weights: Option<[f64; 4]>,
    base: [f64; 3],
) -> Option<Center> {
    let exponent = unit_exponent(&points, weights, base);
    fixed::center::<RADIUS>(&points, weights, base, exponent)
        .unwrap_or_else(|| by_integers(points, weights, base, exponent))
}

/// [`center`] in integers of any size.
#[cold]
fn by_integers(
    points: [[f64; 3]; 4],
    weights: Option<[f64; 4]>,
    base: [f64; 3],
    exponent: i32,
) -> Option<Center> {
    let solution = Solution::new(&points, weights, exponent);
    if solution.determinant.is_zero() {
        return None;
    }
    let divisor = &solution.determinant * 2;
    let position = from_fn(|k| {
        let base = integer(base[k], exponent) * &divisor;
        ratio(base + &solution.numerator[k], &divisor, exponent)
    });
    let square = product(&solution.numerator, &solution.numerator);
    let weight = weights.map_or(BigInt::zero(), |weights| integer(weights[0], 2 * exponent));
    let divisor = &divisor * &divisor;
    let radius_squared = ratio(square - weight * &divisor, &divisor, 2 * exponent);
    Some(Center { position, radius_squared })
}

/// N and D of `center.rs`, in units of 2^4e and 2^3e.
struct Solution {
    numerator: Integers,
    determinant: BigInt,
}

impl Solution {
    fn new(points: &[[f64; 3]; 4], weights: Option<[f64; 4]>, exponent: i32) -> Solution {
        let a = place(points[0], exponent);
        let edges = [1, 2, 3].map(|i| difference(&place(points[i], exponent), &a));
        let lifts: [BigInt; 3] = from_fn(|i| {
            let square = product(&edges[i], &edges[i]);
            match weights {
                Some(w) => square + integer(w[0], 2 * exponent) - integer(w[i + 1], 2 * exponent),
                None => square,
            }
        });
        let crosses = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| cross_product(&edges[i], &edges[j]));
        Solution {
            numerator: from_fn(|k| (0..3).map(|i| &lifts[i] * &crosses[i][k]).sum()),
            determinant: product(&edges[0], &crosses[0]),
        }
    }

    /// The way from the first point to the centre, of any length.
    fn direction(self) -> Integers {
        let negative = self.determinant.is_negative();
        self.numerator.map(|x| if negative { -x } else { x })
    }
}

/// The sign of p . q, where p and q are the centres of two cells less the first point, which they
/// share. The cells must not be flat.
#[cold]
pub(crate) fn dot_sign(p: [[f64; 3]; 4], q: [[f64; 3]; 4]) -> Sign {
    let cells = [p, q];
    let exponents = cells.map(|cell| unit_exponent(&cell, None, [0.0; 3]));
    fixed::dot_sign(&cells, exponents).unwrap_or_else(|| long_dot_sign(&cells, exponents))
}

/// [`dot_sign`] in integers of any size.
fn long_dot_sign(cells: &[[[f64; 3]; 4]; 2], exponents: [i32; 2]) -> Sign {
    let [p, q] = [0, 1].map(|i| Solution::new(&cells[i], None, exponents[i]).direction());
    sign_of(&product(&p, &q))
}

/// A vector from a point p, of any length.
#[derive(Clone, Copy)]
pub(crate) enum Way {
    /// To the centre of a cell, whose first point p is. The cell must not be flat.
    Center([[f64; 3]; 4]),
    /// Along the normal of three points, to the side from which they turn counterclockwise.
    Normal([[f64; 3]; 3]),
    /// To a point.
    Point([f64; 3]),
}

/// The sign of x x z . (q - p) for two vectors from p.
#[cold]
pub(crate) fn triple_sign(x: Way, z: Way, [p, q]: [[f64; 3]; 2]) -> Sign {
    let to = |q: [f64; 3]| {
        let exponent = common_exponent(&[p, q]);
        difference(&place(q, exponent), &place(p, exponent))
    };
    // Every vector in units of its own: lengths do not count.
    let vector = |way: Way| match way {
        Way::Center(cell) => {
            Solution::new(&cell, None, unit_exponent(&cell, None, [0.0; 3])).direction()
        }
        Way::Normal(corners) => normal(corners, common_exponent(&corners)),
        Way::Point(x) => to(x),
    };
    sign_of(&product(&cross_product(&vector(x), &vector(z)), &to(q)))
}

/// The order of |p| and |q|, where p and q are the centres of two cells less the first point, which they
/// share. The cells must not be flat.
#[cold]
pub(super) fn radius_order(cells: [[[f64; 3]; 4]; 2]) -> Ordering {
    let exponents = cells.each_ref().map(|cell| unit_exponent(cell, None, [0.0; 3]));
    let exponent = exponents[0].min(exponents[1]);
    fixed::radius_order(&cells, exponent).unwrap_or_else(|| long_radius_order(&cells, exponent))
}

/// [`radius_order`] in integers of any size.
fn long_radius_order(cells: &[[[f64; 3]; 4]; 2], exponent: i32) -> Ordering {
    let [p, q] = cells.each_ref().map(|cell| Solution::new(cell, None, exponent));
    let square = |p: &Solution| product(&p.numerator, &p.numerator);
    let (x, y) = (square(&p), square(&q));
    (x * &q.determinant * &q.determinant).cmp(&(y * &p.determinant * &p.determinant))
}

/// The sign of p . d, where p is the centre of a cell less its first point. The cell must not be
/// flat.
#[cold]
pub(crate) fn direction_sign(p: [[f64; 3]; 4], direction: [f64; 3]) -> Sign {
    let solution = Solution::new(&p, None, unit_exponent(&p, None, [0.0; 3]));
    let direction = place(direction, common_exponent(&[direction]));
    sign_of(&product(&solution.direction(), &direction))
}

fn sign_of(x: &BigInt) -> Sign {
    if x.is_positive() {
        Sign::Positive
    } else if x.is_negative() {
        Sign::Negative
    } else {
        Sign::Zero
    }
}

/// The cross product of b - a and c - a, each coordinate rounded once.
#[cold]
pub(super) fn cross(points: [[f64; 3]; 3]) -> [f64; 3] {
    let exponent = common_exponent(&points);
    normal(points, exponent).map(|x| ratio(x, &BigInt::from(1), 2 * exponent))
}

/// The cross product of b - a and c - a in units of 2^2e, where e is the exponent.
fn normal(points: [[f64; 3]; 3], exponent: i32) -> Integers {
    let [a, b, c] = points.map(|p| place(p, exponent));
    cross_product(&difference(&b, &a), &difference(&c, &a))
}

/// x / 2^`exponent`, which must be whole.
fn integer(x: f64, exponent: i32) -> BigInt {
    match decode(x) {
        (0, _) => BigInt::zero(),
        (mantissa, power) => BigInt::from(mantissa) << (power - exponent) as usize,
    }
}

/// The f64 nearest to (`numerator` / `denominator`) 2^`exponent`, ties to even, the largest finite
/// one instead of an infinity. The denominator must not be 0.
fn ratio(numerator: BigInt, denominator: &BigInt, exponent: i32) -> f64 {
    if numerator.is_zero() {
        return 0.0;
    }
    let negative = numerator.is_negative() != denominator.is_negative();
    let (numerator, denominator) = (numerator.abs(), denominator.abs());
    // The quotient gets 63 to 65 bits, as many as a u128 holds with ease, and a sticky last bit.
    let shift = 64 + denominator.bits() as i64 - numerator.bits() as i64;
    let (numerator, denominator) = match shift >= 0 {
        true => (numerator << shift as u64, denominator),
        false => (numerator, denominator << shift.unsigned_abs()),
    };
    let quotient = &numerator / &denominator;
    let sticky = &quotient * &denominator != numerator;
    let quotient = quotient.to_u128().unwrap_or(u128::MAX);
    let magnitude = assemble(quotient << 1 | u128::from(sticky), i64::from(exponent) - shift - 1);
    // Adding 0 turns -0 into 0.
    (if negative { -magnitude } else { magnitude }) + 0.0
}

/// The f64 nearest to `bits` 2^`exponent`, ties to even; `bits` has more than 60 bits, and its last
/// one stands for everything below it.
pub(super) fn assemble(bits: u128, exponent: i64) -> f64 {
    let top = i64::from(127 - bits.leading_zeros()) + exponent;
    // The exponent of the last bit of the result: 52 below the first one, or that of subnormals.
    let last = (top - 52).max(-1074);
    let drop = last - exponent;
    if drop > 127 {
        return 0.0;
    }
    let (kept, rest) = (bits >> drop, bits & ((1 << drop) - 1));
    let half = 1u128 << (drop - 1);
    let up = rest > half || (rest == half && kept & 1 == 1);
    // At most 2^53, so exact in an f64.
    let mantissa = (kept + u128::from(up)) as f64;
    if last > 971 {
        return f64::MAX;
    }
    // Two factors, because 2^-1074 is no normal number, and the first product must not round.
    let value = mantissa * power_of_two((last / 2) as i32) * power_of_two((last - last / 2) as i32);
    value.min(f64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dual::circumcenter;
    use crate::vector::{self, Vec3, dot, length, sub};
    use proptest::prelude::*;

    /// Points of a lattice with a rounded step, some moved by an ulp: radii are equal or nearly so.
    fn points() -> impl Strategy<Value = [[f64; 3]; 7]> {
        let coordinate = (0..4i32, 0..8u8).prop_map(|(x, moved)| match f64::from(x) * 0.1 {
            x if moved == 0 && x > 0.0 => x.next_up(),
            x => x,
        });
        prop::array::uniform7(prop::array::uniform3(coordinate))
    }

    /// Coordinates of all scales: some cells need one limb, some two, some more.
    fn scattered() -> impl Strategy<Value = [[f64; 3]; 7]> {
        let coordinate = (-1.0..1.0f64, 0..3i32, 1..30i32)
            .prop_map(|(x, kind, size)| x * power_of_two(-kind * size));
        prop::array::uniform7(prop::array::uniform3(coordinate))
    }

    fn agree([s, a, b, c, d, e, f]: [[f64; 3]; 7]) -> Result<[bool; 2], TestCaseError> {
        let cells = [[s, a, b, c], [s, d, e, f]];
        let exponents = cells.map(|cell| unit_exponent(&cell, None, [0.0; 3]));
        let exponent = exponents[0].min(exponents[1]);
        let flat = |cell: &_| Solution::new(cell, None, exponent).determinant.is_zero();
        prop_assume!(!cells.iter().any(flat));
        let order = fixed::radius_order(&cells, exponent);
        let sign = fixed::dot_sign(&cells, exponents);
        prop_assert!(order.is_none_or(|order| order == long_radius_order(&cells, exponent)));
        prop_assert!(sign.is_none_or(|sign| sign == long_dot_sign(&cells, exponents)));
        for (cell, weights) in
            [(cells[0], None), (cells[1], None), (cells[0], Some([a[0], b[0], c[0], d[0]]))]
        {
            let exponent = unit_exponent(&cell, weights, f);
            if let Some(center) = fixed::center::<true>(&cell, weights, f, exponent) {
                prop_assert_eq!(center, by_integers(cell, weights, f, exponent));
            }
        }
        Ok([order.is_some(), sign.is_some()])
    }

    proptest! {
        #[test]
        fn integers_of_fixed_and_of_any_width_agree(points in points()) {
            prop_assert_eq!(agree(points)?, [true; 2]);
        }

        #[test]
        fn a_triple_product_has_the_sign_of_that_in_floats_if_it_is_far_from_zero(
            [s, a, b, c, d, e, q] in points(),
        ) {
            let cells = [[s, a, b, c], [s, d, e, q]];
            let centers = cells.map(circumcenter);
            prop_assume!(centers.iter().all(Option::is_some));
            let [x, z] = centers.map(|center| sub(center.unwrap().position, s));
            let check = |found: Sign, z: Vec3, size: f64| {
                let turn = dot(vector::cross(x, z), sub(q, s));
                let is_far = turn.abs() > 1e-9 * size * length(x) * length(sub(q, s));
                !is_far || found == Sign::of(turn)
            };
            let turn = triple_sign(Way::Center(cells[0]), Way::Center(cells[1]), [s, q]);
            prop_assert!(check(turn, z, length(z)));
            prop_assert_eq!(triple_sign(Way::Center(cells[1]), Way::Center(cells[0]), [s, q]), -turn);
            prop_assert_eq!(triple_sign(Way::Center(cells[0]), Way::Center(cells[0]), [s, q]), Sign::Zero);
            let turn = triple_sign(Way::Center(cells[0]), Way::Normal([c, d, e]), [s, q]);
            let (u, v) = (sub(d, c), sub(e, c));
            prop_assert!(check(turn, vector::cross(u, v), length(u) * length(v)));
            prop_assert_eq!(triple_sign(Way::Center(cells[0]), Way::Normal([c, e, d]), [s, q]), -turn);
            let turn = triple_sign(Way::Center(cells[0]), Way::Point(c), [s, q]);
            prop_assert!(check(turn, sub(c, s), length(sub(c, s))));
            prop_assert_eq!(triple_sign(Way::Point(c), Way::Center(cells[0]), [s, q]), -turn);
        }

        #[test]
        fn they_agree_at_all_scales(points in scattered()) {
            agree(points)?;
        }
    }
}

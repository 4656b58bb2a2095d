//! Centres of cells in integers of fixed width: exact, on the stack, in a fraction of a microsecond.
//!
//! Everything is a multiple of 2^e, squares and weights of 2^2e. Let W be the number of limbs, of 64 bits each,
//! that hold a coordinate difference. If differences are below 2^(64 W - 4), coordinates below 2^(128 W - 5) and
//! weights below 2^(128 W - 6), then everything fits with its sign: lifts are below 2^(128 W - 4), entries of a cross
//! product below 2^(128 W - 7), of N below 2^(256 W - 9), D is below 2^(192 W - 9), so 2 D times a coordinate below
//! 2^(320 W - 13), the square of N below 2^(512 W - 16), and a weight times (2 D)² below 2^(512 W - 22).

use super::center::Center;
use super::exact::assemble;
use crate::predicates::Sign;
use crate::predicates::integer::{Int, width};
use std::array::from_fn;
use std::cmp::Ordering;

/// Four points.
type Cell = [[f64; 3]; 4];

/// Calls a function with the widths for the given limbs, the given ones for W = 1 or their double, or gives
/// `None` for more.
macro_rules! with_limbs {
    ($limbs:expr, $function:ident::<$($width:literal),*>($($argument:expr),*)) => {
        match $limbs {
            1 => Some($function::<$($width),*>($($argument),*)),
            2 => Some($function::<$({ 2 * $width }),*>($($argument),*)),
            _ => None,
        }
    };
}

/// W for points, the weights of the first four, and the exponent e.
fn limbs(points: &[[f64; 3]], weights: Option<[f64; 4]>, exponent: i32) -> i32 {
    let largest = |x: f64, y: f64| x.max(y.abs());
    let [mut reach, mut span] = [0.0f64; 2];
    for point in points {
        for k in 0..3 {
            reach = largest(reach, point[k]);
            span = largest(span, point[k] - points[0][k]);
        }
    }
    let weight = weights.into_iter().flatten().fold(0.0, largest);
    // A rounded difference may be a little less than the exact one.
    let bits = |x: f64, margin: i32, unit: i32| width(x).map_or(0, |width| width + margin - unit);
    let wide = bits(reach, 5, exponent).max(bits(weight, 6, 2 * exponent));
    ((bits(span, 5, exponent) + 63) / 64).max((wide + 127) / 128).max(1)
}

/// The centre, as far as it is asked for, in units of 2^`exponent`; see [`super::exact::center`]. `None` where
/// more limbs are needed, `Some(None)` where the cell is flat.
pub(super) fn center<const RADIUS: bool>(
    points: &Cell,
    weights: Option<[f64; 4]>,
    base: [f64; 3],
    exponent: i32,
) -> Option<Option<Center>> {
    let [a, b, c, d] = *points;
    let limbs = limbs(&[a, b, c, d, base], weights, exponent);
    with_limbs!(limbs, rounded::<1, 2, 3, 4, 5, 6, 8>(points, weights, base, exponent, RADIUS))
}

fn rounded<
    const W: usize,
    const W2: usize,
    const W3: usize,
    const W4: usize,
    const W5: usize,
    const W6: usize,
    const W8: usize,
>(
    points: &Cell,
    weights: Option<[f64; 4]>,
    base: [f64; 3],
    exponent: i32,
    with_radius: bool,
) -> Option<Center> {
    let Solution { numerator, determinant } =
        Solution::<W3, W4>::new::<W, W2>(points, weights, exponent);
    let divisor = determinant + determinant;
    if divisor.sign().is_zero() {
        return None;
    }
    let position = from_fn(|k| {
        let base: Int<W5> = divisor.times(Int::<W2>::of(base[k], exponent));
        ratio(base + numerator[k].widened(), divisor.widened(), exponent)
    });
    let radius_squared = with_radius.then(|| {
        let divisor: Int<W6> = divisor.times(divisor);
        let mut power: Int<W8> = square(&numerator);
        if let Some([weight, ..]) = weights {
            power = power - divisor.times(Int::<W2>::of(weight, 2 * exponent));
        }
        ratio(power, divisor.widened(), 2 * exponent)
    });
    Some(Center { position, radius_squared: radius_squared.unwrap_or(0.0) })
}

/// The sign of p . q, see [`super::exact::dot_sign`], if few limbs suffice.
pub(super) fn dot_sign(cells: &[Cell; 2], exponents: [i32; 2]) -> Option<Sign> {
    let limbs = [0, 1].map(|i| limbs(&cells[i], None, exponents[i]));
    with_limbs!(limbs[0].max(limbs[1]), dot_sign_by::<1, 2, 3, 4, 8>(cells, exponents))
}

fn dot_sign_by<
    const W: usize,
    const W2: usize,
    const W3: usize,
    const W4: usize,
    const W8: usize,
>(
    cells: &[Cell; 2],
    exponents: [i32; 2],
) -> Sign {
    let [p, q] = [0, 1].map(|i| Solution::<W3, W4>::new::<W, W2>(&cells[i], None, exponents[i]));
    let [x, y, z]: [Int<W8>; 3] = from_fn(|k| p.numerator[k].times(q.numerator[k]));
    let dot = (x + y + z).sign();
    match p.determinant.is_negative() == q.determinant.is_negative() {
        true => dot,
        false => -dot,
    }
}

/// The order of |p| and |q|, see [`super::exact::radius_order`], if few limbs suffice.
pub(super) fn radius_order(cells: &[Cell; 2], exponent: i32) -> Option<Ordering> {
    let limbs = [0, 1].map(|i| limbs(&cells[i], None, exponent));
    with_limbs!(limbs[0].max(limbs[1]), radius_order_by::<1, 2, 3, 4, 6, 8, 14>(cells, exponent))
}

fn radius_order_by<
    const W: usize,
    const W2: usize,
    const W3: usize,
    const W4: usize,
    const W6: usize,
    const W8: usize,
    const W14: usize,
>(
    cells: &[Cell; 2],
    exponent: i32,
) -> Ordering {
    let [p, q] =
        cells.each_ref().map(|cell| Solution::<W3, W4>::new::<W, W2>(cell, None, exponent));
    let side = |p: &Solution<W3, W4>, q: &Solution<W3, W4>| -> Int<W14> {
        square::<W4, W8>(&p.numerator).times::<W6, W14>(q.determinant.times(q.determinant))
    };
    match (side(&p, &q) - side(&q, &p)).sign() {
        Sign::Positive => Ordering::Greater,
        Sign::Zero => Ordering::Equal,
        Sign::Negative => Ordering::Less,
    }
}

/// N and D of `center.rs`, in units of 2^4e and 2^3e.
struct Solution<const W3: usize, const W4: usize> {
    numerator: [Int<W4>; 3],
    determinant: Int<W3>,
}

impl<const W3: usize, const W4: usize> Solution<W3, W4> {
    fn new<const W: usize, const W2: usize>(
        points: &Cell,
        weights: Option<[f64; 4]>,
        exponent: i32,
    ) -> Self {
        // Modulo 2^(64 W): what coordinates lose above that, their differences do not have.
        let edges: [[Int<W>; 3]; 3] = from_fn(|i| {
            from_fn(|k| Int::of(points[i + 1][k], exponent) - Int::of(points[0][k], exponent))
        });
        let weight = |i: usize, of: [f64; 4]| Int::of(of[i], 2 * exponent);
        let lifts: [Int<W2>; 3] = from_fn(|i| {
            let square = square(&edges[i]);
            weights.map_or(square, |w| square + (weight(0, w) - weight(i + 1, w)))
        });
        let cross = |i: usize, j: usize| -> [Int<W2>; 3] {
            [(1, 2), (2, 0), (0, 1)].map(|(p, q)| {
                edges[i][p].times::<W, W2>(edges[j][q]) - edges[i][q].times::<W, W2>(edges[j][p])
            })
        };
        let crosses = [cross(1, 2), cross(2, 0), cross(0, 1)];
        let numerator = from_fn(|k| {
            let [x, y, z]: [Int<W4>; 3] = from_fn(|i| lifts[i].times(crosses[i][k]));
            x + y + z
        });
        let [x, y, z]: [Int<W3>; 3] = from_fn(|k| edges[0][k].times(crosses[0][k]));
        Solution { numerator, determinant: x + y + z }
    }
}

/// The square of a vector's length.
fn square<const N: usize, const N2: usize>(vector: &[Int<N>; 3]) -> Int<N2> {
    let [x, y, z] = vector.map(|x| x.times(x));
    x + y + z
}

/// The f64 nearest to (`numerator` / `denominator`) 2^`exponent`, see [`super::exact::ratio`].
fn ratio<const N: usize>(numerator: Int<N>, denominator: Int<N>, exponent: i32) -> f64 {
    if numerator.sign().is_zero() {
        return 0.0;
    }
    let (bits, shift) = numerator.quotient(denominator);
    let magnitude = assemble(bits, i64::from(exponent) + i64::from(shift));
    let negative = numerator.is_negative() != denominator.is_negative();
    // Adding 0 turns -0 into 0.
    (if negative { -magnitude } else { magnitude }) + 0.0
}

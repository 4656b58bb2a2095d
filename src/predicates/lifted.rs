//! The sign of the lifted determinant: what insphere and the power test have in common.
//!
//! With differences from e, the determinant of the four rows
//!
//! ```text
//! (x, y, z, l),   l = x^2 + y^2 + z^2 - (w - w_e),   for the points a, b, c, d
//! ```
//!
//! is negative exactly when e lies below the hyperplane through the lifted a, b, c, d, that is,
//! inside their sphere, if abcd is positively oriented (Edelsbrunner, Shah 1996). It is expanded
//! by the minors of pairs of rows in the columns x, y and z, l (Laplace):
//!
//! ```text
//! xy(ab) zl(cd) - xy(ac) zl(bd) + xy(ad) zl(bc) + xy(bc) zl(ad) - xy(bd) zl(ac) + xy(cd) zl(ab)
//! ```
//!
//! # Bounds
//!
//! u = 2^-53 is the relative error of one rounding, either way: x = x' (1 + t) and
//! x' = x (1 + t) with |t| <= u for x' = fl(x), since nothing underflows (see [`super`]). Express
//! everything in the calculated differences x', y', z', w'. Then the exact determinant is a sum
//! of monomials x' y' z' times x'^2, y'^2, z'^2 or w', with one factor (1 + t) for each difference
//! in it, and the calculated one the sum of the same monomials with one factor for each rounding
//! that the monomial goes through. Those with a square have most of both:
//!
//! | step | roundings |
//! |---|---|
//! | the differences x', y', z' and twice that of the square | 5 |
//! | the square; the sums with the other two squares and with w' | 4 |
//! | the product and the difference of a minor in x, y | 2 |
//! | the product and the difference of a minor in z, l | 2 |
//! | the product of two minors | 1 |
//! | the sum of six such products, as ((1 + 3) - (2 + 4)) - (5 + 6) | 3 |
//!
//! Together 17, so that the error is at most 17 u / (1 - 17 u) times the permanent P: the sum of
//! |x' y' z'| L over the 24 terms, where L = x'^2 + y'^2 + z'^2 + |w'| in a row (Higham 2002,
//! section 3.1).
//!
//! - **Maximum.** P <= 24 X Y Z M, with the maxima of |x'|, |y'|, |z'| and L over the four rows:
//!   the error is at most 408 u X Y Z M. Calculating the bound takes at most 9 roundings, and one
//!   to add [`TINY`]: [`MAXIMUM_BOUND`] = 410 u leaves room for them.
//! - **Grid.** See [`exact_step`]: nothing is rounded.
//! - **Permanent.** P itself, calculated with at most 14 roundings of numbers that are not
//!   negative: [`PERMANENT_BOUND`] = 17.5 u leaves room for them.
//! - **Pairs.** By the rules of [`super::double_double`], looseness and error of each step are:
//!   differences (1, 0); squares (3, 8); their sums with the second square (4, 15), the third
//!   (5, 24), the weight (6, 35); products of x, y (3, 8), their differences (4, 15); products of
//!   z, l (8, 63), their differences (9, 80); products of minors (14, 171), their sums (15, 200),
//!   (16, 231), (17, 264). So the error is at most 264 u^2 P <= 6336 u^2 X Y Z M, and
//!   [`PAIRS_BOUND`] = 6400 u^2 leaves room for the rest. Adding the two parts of the pair rounds
//!   once more, relative to the result: that cannot change its sign. See also [`zero_step`].
//! - **Exact.** Integers: [`super::exact`].

use super::double_double::Pairs;
use super::exact;
use super::grid::{is_multiple, step};
use super::processor;
use super::sign::Sign;
use super::stages::{self, Stage};
use super::{UNIT, position};
use std::array::from_fn;

/// Times X Y Z M: bounds the error of the determinant in floats.
pub(super) const MAXIMUM_BOUND: f64 = 410.0 * UNIT;
/// Times the permanent: bounds the error of the determinant in floats.
pub(super) const PERMANENT_BOUND: f64 = 17.5 * UNIT;
/// Times X Y Z M: bounds the error of the determinant in pairs of floats.
pub(super) const PAIRS_BOUND: f64 = 6400.0 * UNIT * UNIT;
/// 2^-1000: added to a bound, it covers the bound's own underflow.
pub(super) const TINY: f64 = f64::from_bits((1023 - 1000) << 52);

/// Four values, one for each of the rows a, b, c, d.
type Column = [f64; 4];

/// The sign of the lifted determinant, times -1: positive when e is inside the sphere of the
/// positively oriented a, b, c, d. The weights are the fourth entries, and count only if
/// `WEIGHTED`.
#[inline(always)]
pub(super) fn conflict<const WEIGHTED: bool>(points: [&[f64; 4]; 5]) -> Sign {
    let determinant = determinant::<WEIGHTED>(points);
    if determinant.abs() > MAXIMUM_BOUND * product::<WEIGHTED>(points) + TINY {
        stages::count(Stage::Maximum);
        return -Sign::of(determinant);
    }
    processor::further::<WEIGHTED>(points, determinant)
}

/// [`conflict`] where a filter could not tell, given the determinant in floats: its bound may have been a looser one
/// than the first here.
#[inline(always)]
pub(super) fn further<const WEIGHTED: bool, const FMA: bool>(
    points: [&[f64; 4]; 5],
    determinant: f64,
) -> Sign {
    let product = product::<WEIGHTED>(points);
    if determinant.abs() > MAXIMUM_BOUND * product + TINY {
        stages::count(Stage::Maximum);
        return -Sign::of(determinant);
    }
    if on_grid::<WEIGHTED>(points, exact_step(product)) {
        stages::count(Stage::Grid);
        return -Sign::of(determinant);
    }
    if determinant.abs() > PERMANENT_BOUND * permanent::<WEIGHTED>(points) + TINY {
        stages::count(Stage::Permanent);
        return -Sign::of(determinant);
    }
    let determinant = pairs::<WEIGHTED, FMA>(points);
    if determinant.abs() > PAIRS_BOUND * product + TINY {
        stages::count(Stage::Pairs);
        return -Sign::of(determinant);
    }
    if on_grid::<WEIGHTED>(points, zero_step(product)) {
        stages::count(Stage::Pairs);
        return Sign::Zero;
    }
    stages::count(Stage::Exact);
    let weights = points.map(|p| p[3]);
    -exact::lifted_space(points.map(position), WEIGHTED.then_some(&weights))
}

/// The columns x, y, z, l, and L of the bounds.
#[inline(always)]
fn columns<const WEIGHTED: bool>(points: [&[f64; 4]; 5]) -> [Column; 5] {
    let [x, y, z, w] = differences(points);
    let square: Column = from_fn(|i| x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
    match WEIGHTED {
        true => [x, y, z, from_fn(|i| square[i] - w[i]), from_fn(|i| square[i] + w[i].abs())],
        false => [x, y, z, square, square],
    }
}

/// The determinant in floats.
#[inline(always)]
pub(super) fn determinant<const WEIGHTED: bool>(points: [&[f64; 4]; 5]) -> f64 {
    let [x, y, z, l, _] = columns::<WEIGHTED>(points);
    laplace::<false>([x, y, z, l])
}

/// X Y Z M.
#[inline(always)]
pub(super) fn product<const WEIGHTED: bool>(points: [&[f64; 4]; 5]) -> f64 {
    let [x, y, z, _, magnitude] = columns::<WEIGHTED>(points);
    largest(x) * largest(y) * largest(z) * largest(magnitude)
}

/// The permanent P in floats.
#[inline(always)]
pub(super) fn permanent<const WEIGHTED: bool>(points: [&[f64; 4]; 5]) -> f64 {
    let [x, y, z, w] = differences(points).map(|column| column.map(f64::abs));
    let weight = |i: usize| if WEIGHTED { w[i] } else { 0.0 };
    let magnitude = from_fn(|i| x[i] * x[i] + y[i] * y[i] + z[i] * z[i] + weight(i));
    laplace::<true>([x, y, z, magnitude])
}

/// The differences from the fifth point, by columns.
#[inline(always)]
fn differences([a, b, c, d, e]: [&[f64; 4]; 5]) -> [Column; 4] {
    from_fn(|i| [a[i] - e[i], b[i] - e[i], c[i] - e[i], d[i] - e[i]])
}

/// The greatest absolute value.
#[inline(always)]
fn largest(column: Column) -> f64 {
    let [a, b, c, d] = column.map(f64::abs);
    larger(larger(a, b), larger(c, d))
}

/// The larger of two numbers, neither a NaN.
#[inline(always)]
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The determinant of four columns, or their permanent.
#[inline(always)]
fn laplace<const PERMANENT: bool>([x, y, z, l]: [Column; 4]) -> f64 {
    let sub = |a: f64, b: f64| if PERMANENT { a + b } else { a - b };
    let minor = |p: &Column, q: &Column, i: usize, j: usize| sub(p[i] * q[j], p[j] * q[i]);
    // The minors of the rows ab, bc, cd, da, and of ac, bd.
    let ring = |p, q| -> Column { from_fn(|i| minor(p, q, i, (i + 1) % 4)) };
    let diagonal = |p, q| -> [f64; 2] { from_fn(|i| minor(p, q, i, i + 2)) };
    let (ring_xy, ring_zl) = (ring(&x, &y), ring(&z, &l));
    let (diagonal_xy, diagonal_zl) = (diagonal(&x, &y), diagonal(&z, &l));
    let sides: Column = from_fn(|i| ring_xy[i] * ring_zl[(i + 2) % 4]);
    let diagonals: [f64; 2] = from_fn(|i| diagonal_xy[i] * diagonal_zl[1 - i]);
    sub(sub(sides[0] + sides[2], sides[1] + sides[3]), diagonals[0] + diagonals[1])
}

/// The determinant in pairs of floats, with fused multiply-adds if `FMA`.
#[inline(always)]
pub(super) fn pairs<const WEIGHTED: bool, const FMA: bool>([a, b, c, d, e]: [&[f64; 4]; 5]) -> f64 {
    let column = |i: usize| Pairs::difference([a[i], b[i], c[i], d[i]], [e[i]; 4]);
    let [x, y, z] = [column(0), column(1), column(2)];
    let mut l = x.times::<FMA>(&x).add(&y.times::<FMA>(&y)).add(&z.times::<FMA>(&z));
    if WEIGHTED {
        l = l.sub(&column(3));
    }
    let sides = ring::<FMA>(&x, &y).times::<FMA>(&ring::<FMA>(&z, &l).pick([2, 3, 0, 1]));
    let diagonals = diagonal::<FMA>(&x, &y).times::<FMA>(&diagonal::<FMA>(&z, &l).pick([1, 0]));
    let sides = sides.pick([0, 1]).add(&sides.pick([2, 3]));
    let sides = sides.pick([0]).sub(&sides.pick([1]));
    let determinant = sides.sub(&diagonals.pick([0]).add(&diagonals.pick([1])));
    determinant.hi[0] + determinant.lo[0]
}

/// The minors of the rows ab, bc, cd, da in two columns.
#[inline(always)]
fn ring<const FMA: bool>(p: &Pairs<4>, q: &Pairs<4>) -> Pairs<4> {
    let next = [1, 2, 3, 0];
    p.times::<FMA>(&q.pick(next)).sub(&p.pick(next).times::<FMA>(q))
}

/// The minors of the rows ac and bd in two columns.
#[inline(always)]
fn diagonal<const FMA: bool>(p: &Pairs<4>, q: &Pairs<4>) -> Pairs<2> {
    let (p, p_next) = (p.pick([0, 1]), p.pick([2, 3]));
    p.times::<FMA>(&q.pick([2, 3])).sub(&p_next.times::<FMA>(&q.pick([0, 1])))
}

/// Whether the coordinates are multiples of 2^k, and the weights of 2^(2 k).
#[inline(always)]
pub(super) fn on_grid<const WEIGHTED: bool>(points: [&[f64; 4]; 5], k: i32) -> bool {
    let multiples = |p: &[f64; 4]| position(p).iter().all(|&x| is_multiple(x, k));
    points.iter().all(|p| multiples(p) && (!WEIGHTED || is_multiple(p[3], 2 * k)))
}

/// The step of a grid on which the determinant in floats is exact, for X Y Z M below 2^w.
///
/// In units of the grid all values are integers, and none is rounded if 2^5 X Y Z M <= 2^53: the
/// determinant is below 24 X Y Z M, and what leads to it is not larger, as X, Y, Z, M are at least
/// 1. (Where one of them is 0, a column is, and the determinant in floats is 0 as well.)
pub(super) fn exact_step(product: f64) -> i32 {
    step(product, 5 - 53, 5)
}

/// The step of a grid on which the determinant is zero if stage 3 cannot tell its sign.
///
/// Then it is a multiple of 2^(5 k), and at most 2 * 6400 * 2^-106 X Y Z M + 2^-999 in absolute
/// value. The first part is below 2^(w - 92.3) for X Y Z M < 2^w; if that is at most
/// 2^(5 k - 0.3), then the sum is below 2^(5 k), since k is at least -190.
pub(super) fn zero_step(product: f64) -> i32 {
    step(product, -92, 5)
}

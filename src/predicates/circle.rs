//! Inside or outside a circle in space, for four coplanar points.
//!
//! The points of a plane, lifted by l = |p - e|^2 - (w - w_e) with the distance taken in *space*,
//! lie on a paraboloid over that plane. Whether the lifted e is below the plane through the lifted
//! a, b, c does not depend on which affine coordinates the plane has: dropping the coordinate
//! along which the triangle is not seen edge-on multiplies the determinant of the rows (u, v, l)
//! by a constant that is not zero, whose sign is that of the projected orientation of abc over
//! its true one. So the product of this determinant and the projected orientation is positive
//! exactly when e is inside, whichever coordinate is dropped and whichever way abc turns.
//!
//! # Bound
//!
//! As in [`super::lifted`]: a monomial u' v' x'^2 passes through 4 differences, 4 roundings in l, the
//! product and the difference of a minor, a product with l, and 2 sums: 13 roundings, 6 terms.
//! The error is at most 78 u U V M; 80 u leaves room for the roundings of the bound.

use super::exact;
use super::lifted::{TINY, UNIT, larger};
use super::orient::orient2d;
use super::position;
use super::sign::Sign;

/// Positive when e is inside the circle (the power circle if `WEIGHTED`) of the coplanar a, b,
/// c, which are not collinear; zero on it.
pub(super) fn conflict<const WEIGHTED: bool>(points: [&[f64; 4]; 4]) -> Sign {
    let [a, b, c, _] = points;
    let row = |p: &[f64; 4], q: &[f64; 4]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    // The axis along which the triangle looks largest.
    let (p, q) = (row(b, a), row(c, a));
    let shadow = |i: usize| p[(i + 1) % 3] * q[(i + 2) % 3] - p[(i + 2) % 3] * q[(i + 1) % 3];
    let shadows = [shadow(0).abs(), shadow(1).abs(), shadow(2).abs()];
    let largest = if shadows[1] > shadows[0] { 1 } else { 0 };
    let largest = if shadows[2] > shadows[largest] { 2 } else { largest };
    // When the floats mislead, an axis along which it is edge-on may come first.
    for along in [largest, (largest + 1) % 3, (largest + 2) % 3] {
        let axes = [(along + 1) % 3, (along + 2) % 3];
        let turn = orient2d(position(a), position(b), position(c), axes);
        if !turn.is_zero() {
            return turn * projected::<WEIGHTED>(points, along);
        }
    }
    Sign::Zero
}

/// The sign of the determinant of the rows (u, v, l), without the coordinate along an axis.
fn projected<const WEIGHTED: bool>(points: [&[f64; 4]; 4], along: usize) -> Sign {
    let [a, b, c, e] = points;
    let row = |p: &[f64; 4]| {
        let d = [p[0] - e[0], p[1] - e[1], p[2] - e[2]];
        let weight = if WEIGHTED { p[3] - e[3] } else { 0.0 };
        let square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        [d[(along + 1) % 3], d[(along + 2) % 3], square - weight, square + weight.abs()]
    };
    let (p, q, r) = (row(a), row(b), row(c));
    let minor = |p: [f64; 4], q: [f64; 4]| p[0] * q[1] - p[1] * q[0];
    let determinant = (minor(p, q) * r[2] + minor(q, r) * p[2]) - minor(p, r) * q[2];
    let largest = |i: usize| larger(larger(p[i].abs(), q[i].abs()), r[i].abs());
    if determinant.abs() > 80.0 * UNIT * (largest(0) * largest(1) * largest(3)) + TINY {
        return Sign::of(determinant);
    }
    let weights = points.map(|p| p[3]);
    exact::lifted_plane(points.map(position), WEIGHTED.then_some(&weights), along)
}

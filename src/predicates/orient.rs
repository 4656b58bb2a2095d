//! Orientation of points in space and in the coordinate planes.
//!
//! # Bounds
//!
//! As in [`super::lifted`], with u = 2^-53 and the calculated differences x', y', z'. In space a
//! monomial x' y' z' has 3 differences, and goes through 2 products, the difference of a minor,
//! and 2 sums: 8 roundings, and the permanent has 6 terms. The error is at most 48 u X Y Z, with
//! the maxima of |x'|, |y'|, |z'|; 50 u leaves room for the roundings of the bound. In a plane it
//! is 2 + 1 + 1 = 4 roundings and 2 terms: at most 8 u X Y, and 9 u leaves room.

use super::UNIT;
use super::exact;
use super::grid::{is_multiple, step};
use super::lifted::larger;
use super::sign::Sign;

/// Times X Y Z: bounds the error of an orientation in floats.
pub(super) const ORIENT_BOUND: f64 = 50.0 * UNIT;

/// The orientation of a, b, c, d: the sign of the determinant of b - a, c - a, d - a.
///
/// Positive when b - a, c - a, d - a is a right-handed frame, zero when the points are coplanar.
/// Cost: a few nanoseconds, about a hundred for points that are nearly coplanar.
#[inline]
pub fn orient3d(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3], d: &[f64; 3]) -> Sign {
    let row = |p: &[f64; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
    let (p, q, r) = (row(b), row(c), row(d));
    let minor = |p: [f64; 3], q: [f64; 3]| p[0] * q[1] - p[1] * q[0];
    let determinant = (minor(p, q) * r[2] + minor(q, r) * p[2]) - minor(p, r) * q[2];
    let largest = |i: usize| larger(larger(p[i].abs(), q[i].abs()), r[i].abs());
    let product = largest(0) * largest(1) * largest(2);
    if determinant.abs() > ORIENT_BOUND * product {
        return Sign::of(determinant);
    }
    further([a, b, c, d], determinant, product)
}

/// The stages of [`orient3d`] after the first, given its determinant and X Y Z.
///
/// On a grid with 6 X Y Z below 2^53 cubes of the step, nothing was rounded; see
/// [`exact_step`](super::lifted::exact_step).
#[cold]
#[inline(never)]
fn further(points: [&[f64; 3]; 4], determinant: f64, product: f64) -> Sign {
    let k = step(product, 3 - 53, 3);
    if points.iter().all(|p| p.iter().all(|&x| is_multiple(x, k))) {
        return Sign::of(determinant);
    }
    exact::volume(points)
}

/// The orientation of a, b, c in the plane: the sign of the determinant of b - a, c - a.
///
/// Positive when a, b, c turn to the left, zero when they are collinear. Cost: as [`orient3d`].
pub fn orient2d(a: &[f64; 2], b: &[f64; 2], c: &[f64; 2]) -> Sign {
    let raised = |p: &[f64; 2]| [p[0], p[1], 0.0];
    projected(&raised(a), &raised(b), &raised(c), [0, 1])
}

/// The orientation of a, b, c projected on two axes.
fn projected(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3], axes: [usize; 2]) -> Sign {
    let row = |p: &[f64; 3]| axes.map(|axis| p[axis] - a[axis]);
    let (p, q) = (row(b), row(c));
    let determinant = p[0] * q[1] - p[1] * q[0];
    let largest = |i: usize| larger(p[i].abs(), q[i].abs());
    let product = largest(0) * largest(1);
    // Where the product is 0, all is on a line along an axis, and nothing was rounded.
    if determinant.abs() > 9.0 * UNIT * product || product == 0.0 {
        return Sign::of(determinant);
    }
    exact::area(a, b, c, axes)
}

/// The orientation of three points in the plane that holds them: the first that is not zero of
/// their orientations projected on the planes xy, yz and xz; zero when they are collinear.
///
/// Two triangles of one plane have the same sign exactly when they turn the same way. Cost: as
/// [`orient3d`].
pub fn coplanar_orientation(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3]) -> Sign {
    [[0, 1], [1, 2], [0, 2]]
        .into_iter()
        .map(|axes| projected(a, b, c, axes))
        .find(|sign| !sign.is_zero())
        .unwrap_or(Sign::Zero)
}

/// Whether three points lie on a line, exactly.
pub fn collinear(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3]) -> bool {
    coplanar_orientation(a, b, c).is_zero()
}

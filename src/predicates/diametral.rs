//! Inside or outside the smallest sphere through two or three points: what decides where distances to a set of points are critical.
//!
//! A sample on such a sphere is a tie. It is broken as those of the triangulation are (see [`super::perturb`]): every point has an infinitesimal weight,
//! negative, and the lexicographically larger the point the more it outweighs all others. Then the spheres are those orthogonal
//! to the weighted points, with their centres on the line or in the plane.
//!
//! # Bounds
//!
//! As in [`super::lifted`], in the calculated differences. For an edge a monomial has 2 differences, and goes through 1 product and 2
//! sums: 5 roundings, at most 5 u P for the permanent P, the same sum in absolute values. For a triangle it has 6 differences;
//! of the products and sums the lift takes 3, a minor 2, their product 1, the sum of the three vectors 2, the product with N, a minor
//! itself, 2 + 1, the sum of the coordinates 2: 19 roundings. 8 u and 24 u leave room for the roundings of the bounds.

use super::UNIT;
use super::exact;
use super::sign::Sign;

/// Times the permanent: bounds the error for an edge.
const EDGE_BOUND: f64 = 8.0 * UNIT;
/// Times the permanent: bounds the error for a triangle.
const TRIANGLE_BOUND: f64 = 24.0 * UNIT;
/// What is larger than this has not lost anything to underflow.
const LEAST: f64 = f64::from_bits((1023 - 900) << 52);

/// Whether r lies inside the smallest sphere through p and q, the angle at r of the triangle being obtuse; ties
/// broken by the perturbation. The three points must differ.
#[inline]
pub fn edge_conflict(p: &[f64; 3], q: &[f64; 3], r: &[f64; 3]) -> bool {
    let (mut sum, mut permanent) = (0.0, 0.0);
    for k in 0..3 {
        let product = (p[k] - r[k]) * (q[k] - r[k]);
        sum += product;
        permanent += product.abs();
    }
    // Nothing underflows: differences are multiples of 2^-212.
    if sum.abs() > EDGE_BOUND * permanent {
        return sum < 0.0;
    }
    match exact::edge_side([p, q, r]) {
        // Weights of p and q move the sphere over r; that of r itself keeps r out.
        Sign::Zero => p > r || q > r,
        sign => sign.is_negative(),
    }
}

/// Whether s lies inside the smallest sphere through p, q and r; ties broken by the perturbation. The four points must
/// not be coplanar.
///
/// The centre of the sphere through all four lies beyond the triangle then, seen from s.
#[inline]
pub fn triangle_conflict(p: &[f64; 3], q: &[f64; 3], r: &[f64; 3], s: &[f64; 3]) -> bool {
    let difference = |x: &[f64; 3]| [x[0] - p[0], x[1] - p[1], x[2] - p[2]];
    let [a, b, d] = [difference(q), difference(r), difference(s)];
    let square = |v: [f64; 3]| v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    let lifts = [square(a), square(b), square(d)];
    let (mut sum, mut permanent) = (0.0, 0.0);
    for (i, j) in [(0, 1), (1, 2), (2, 0)] {
        let minor = |u: [f64; 3], v: [f64; 3]| {
            let (x, y) = (u[i] * v[j], u[j] * v[i]);
            (x - y, x.abs() + y.abs())
        };
        let [(n, n_size), (bd, bd_size), (da, da_size)] = [minor(a, b), minor(b, d), minor(d, a)];
        sum += n * (lifts[2] * n + lifts[0] * bd + lifts[1] * da);
        permanent += n_size * (lifts[2] * n_size + lifts[0] * bd_size + lifts[1] * da_size);
    }
    // What overflows compares as false, or is infinite.
    if sum.abs() > TRIANGLE_BOUND * permanent + LEAST && permanent < f64::INFINITY {
        return sum < 0.0;
    }
    match exact::triangle_side([p, q, r, s]) {
        Sign::Zero => triangle_tie([p, q, r], s),
        sign => sign.is_negative(),
    }
}

/// The perturbed answer for a tie: from the lexicographically largest point down, `false` at s, and at a corner whether the foot of s in the
/// plane lies on the same side of the opposite edge as the corner, unless it lies on its line.
#[cold]
fn triangle_tie(corners: [&[f64; 3]; 3], s: &[f64; 3]) -> bool {
    let mut left = corners.map(|corner| corner > s);
    loop {
        let mut largest = None;
        for i in (0..3).filter(|&i| left[i]) {
            if largest.is_none_or(|j: usize| corners[i] > corners[j]) {
                largest = Some(i);
            }
        }
        let Some(i) = largest else { return false };
        match exact::foot_side([corners[i], corners[(i + 1) % 3], corners[(i + 2) % 3], s]) {
            Sign::Zero => left[i] = false,
            sign => return sign.is_positive(),
        }
    }
}

//! Where a ray from a sample leaves the sample's Voronoi cell.

use super::UNIT;
use super::exact;
use super::sign::Sign;
use std::cmp::Ordering;

/// Times the permanent: bounds the error. A monomial has 4 differences; the two dot products and squares take 3 roundings each besides, their product 1, the difference
/// 1: 12 at most. 16 leaves room for the roundings of the bound.
const EXIT_BOUND: f64 = 16.0 * UNIT;
/// What is larger than this has not lost anything to underflow.
const LEAST: f64 = f64::from_bits((1023 - 900) << 52);

/// Which of two planes the ray from p through x meets first: that between p and q (`Less`), or that between p and r. Planes that it meets at
/// infinity, or that lie behind it, come last, as if the ray went on there. The points q and r must differ from p. Exact.
pub fn exit_order(p: &[f64; 3], x: &[f64; 3], q: &[f64; 3], r: &[f64; 3]) -> Ordering {
    let difference = |x: &[f64; 3]| [x[0] - p[0], x[1] - p[1], x[2] - p[2]];
    let [u, a, b] = [difference(x), difference(q), difference(r)];
    let dot = |v: [f64; 3], w: [f64; 3]| v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
    let size = |v: [f64; 3]| v.map(f64::abs);
    let (aa, bb) = (dot(a, a), dot(b, b));
    // The ray meets the plane of q at |a|^2 / (2 u . a) times u.
    let difference = dot(u, a) * bb - dot(u, b) * aa;
    let permanent = dot(size(u), size(a)) * bb + dot(size(u), size(b)) * aa;
    let sign = match difference.abs() > EXIT_BOUND * permanent + LEAST && permanent < f64::INFINITY
    {
        true if difference > 0.0 => Sign::Positive,
        true => Sign::Negative,
        false => exact::exit_side([x, q, r, p]),
    };
    match sign {
        Sign::Positive => Ordering::Less,
        Sign::Zero => Ordering::Equal,
        Sign::Negative => Ordering::Greater,
    }
}

/// Whether the angle at p between the directions to x and to q is acute. Exact.
pub fn is_acute(p: &[f64; 3], x: &[f64; 3], q: &[f64; 3]) -> bool {
    exact::edge_side([x, q, p]).is_positive()
}

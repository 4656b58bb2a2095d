//! Inside or outside a sphere: insphere, and the power test for weighted points.

use super::lifted;
use super::sign::Sign;

/// Where e lies to the sphere through the positively oriented a, b, c, d: positive strictly
/// inside, zero on the sphere, negative outside.
///
/// For negatively oriented points the sign is opposite; for coplanar ones it says nothing of a
/// sphere.
#[inline]
pub fn insphere(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3], d: &[f64; 3], e: &[f64; 3]) -> Sign {
    let [a, b, c, d, e] = [a, b, c, d, e].map(|&[x, y, z]| [x, y, z, 0.0]);
    lifted::conflict::<false>([&a, &b, &c, &d, &e])
}

/// Where the weighted point e lies to the sphere orthogonal to the positively oriented a, b, c, d.
///
/// Points are rows (x, y, z, weight). Positive when the power distance |c - e|^2 - r^2 - w of e
/// to that sphere, of centre c and radius r, is negative: then e is in conflict with the cell.
/// Zero when e is orthogonal to the sphere as well. With equal weights it is [`insphere`]. Exact
/// for weights of either sign within the range of [`WEIGHT_MIN`](super::WEIGHT_MIN) and
/// [`WEIGHT_MAX`](super::WEIGHT_MAX). Source: Edelsbrunner, Shah 1996; CGAL calls it
/// `power_side_of_oriented_power_sphere`.
#[inline]
pub fn power_test(a: &[f64; 4], b: &[f64; 4], c: &[f64; 4], d: &[f64; 4], e: &[f64; 4]) -> Sign {
    lifted::conflict::<true>([a, b, c, d, e])
}

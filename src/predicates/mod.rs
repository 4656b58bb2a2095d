//! Exact predicates: every decision that a triangulation takes about coordinates.
//!
//! Each is the sign of a determinant. It is calculated in stages, in floats, in pairs of floats and
//! in integers, and each stage answers only where its sign is proved. So the answer is always
//! exact, and the first stage settles most tests. `docs/algorithms/predicates.md` describes the
//! stages, `lifted.rs` proves their bounds.
//!
//! # Range
//!
//! Coordinates are 0 or of absolute value within [2^-160, 2^200], that is,
//! [[`COORDINATE_MIN`](crate::points::COORDINATE_MIN),
//! [`COORDINATE_MAX`](crate::points::COORDINATE_MAX)]; weights 0 or within [2^-320, 2^400], that
//! is, [[`WEIGHT_MIN`], [`WEIGHT_MAX`]]. There nothing overflows or underflows:
//!
//! - Differences are at most 2^201, sums of three squares and a weight at most 3 * 2^402 + 2^401,
//!   and the largest determinant at most 24 * 2^603 * 2^404 < 2^1012.
//! - Coordinates are multiples of 2^-212, since the last of their 53 bits is worth at least that,
//!   and weights of 2^-372. A number rounded to 53 bits remains a multiple of any power of two
//!   that it was a multiple of, and so does the rounding error. So every value on the way to a
//!   determinant of three coordinates and one lifted value, high part or low, is a multiple of
//!   2^(-3 * 212 - 424) = 2^-1060. Floats of that size are exact down to 2^-1074.

pub(crate) mod around;
mod bisector;
mod diametral;
pub(crate) mod double_double;
mod exact;
mod grid;
pub(crate) mod integer;
pub(crate) mod lanes;
mod lifted;
mod orient;
mod perturb;
pub(crate) mod processor;
mod sign;
mod sphere;
#[cfg(feature = "count-stages")]
pub mod stages;
#[cfg(not(feature = "count-stages"))]
pub(crate) mod stages;

pub use bisector::{exit_order, is_acute};
pub use diametral::{edge_conflict, triangle_conflict};
pub use orient::{collinear, coplanar_orientation, orient2d, orient3d};
pub use perturb::{delaunay_conflict, regular_conflict};
pub(crate) use perturb::{in_conflict, settle};
pub use sign::Sign;
pub use sphere::{insphere, power_test};

/// The largest absolute weight: 2^400, the square of the largest coordinate.
pub const WEIGHT_MAX: f64 = f64::from_bits((1023 + 400) << 52);
/// The smallest absolute weight other than zero: 2^-320, the square of the smallest coordinate.
pub const WEIGHT_MIN: f64 = f64::from_bits((1023 - 320) << 52);
/// The unit of rounding, the relative error of one: 2^-53.
pub(crate) const UNIT: f64 = f64::EPSILON / 2.0;

/// The coordinates of a row (x, y, z, weight).
#[inline]
pub fn position(row: &[f64; 4]) -> &[f64; 3] {
    let [position @ .., _] = row;
    position
}

#[cfg(test)]
mod tests;

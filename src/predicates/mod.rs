//! Exact predicates: every decision that a triangulation takes about coordinates.
//!
//! Each is the sign of a determinant, calculated in stages: first in floats with a bound on the
//! error, then in pairs of floats, then in integers, and each stage answers only when its bound
//! proves the sign. So the answer is always exact, and the first stage settles most tests. See
//! `docs/algorithms/predicates.md` for the stages, `lifted.rs` for their bounds.
//!
//! # Range
//!
//! Coordinates are 0 or of absolute value within
//! [[`COORDINATE_MIN`](crate::points::COORDINATE_MIN),
//! [`COORDINATE_MAX`](crate::points::COORDINATE_MAX)] = [2^-160, 2^200], weights 0 or within
//! [[`WEIGHT_MIN`], [`WEIGHT_MAX`]] = [2^-320, 2^400]. There nothing overflows or underflows, up to
//! the largest determinant:
//!
//! - Differences are below 2^201, lifted values below 3 * 2^402 + 2^401 < 2^404, the determinant and
//!   every part of it below 24 * 2^603 * 2^404 < 2^1012.
//! - Coordinates are multiples of 2^-212, since the last of their 53 bits is worth at least that, and
//!   weights of 2^-372. A sum, difference or product of numbers, rounded to 53 bits, is a
//!   multiple of all that the exact one is a multiple of, and so is the rounding error. So every
//!   value that a determinant of three coordinates and one lifted value goes through, high or
//!   low, is a multiple of 2^(-3 * 212 - 424) = 2^-1060. A float of such a size is exact down to
//!   2^-1074.

mod circle;
pub(crate) mod double_double;
mod exact;
mod grid;
mod integer;
mod lifted;
mod orient;
mod perturb;
mod sign;
mod sphere;
#[cfg(feature = "count-stages")]
pub mod stages;
#[cfg(not(feature = "count-stages"))]
mod stages;

pub use orient::{collinear, coplanar_orientation, orient3d};
pub use perturb::{
    delaunay_conflict, delaunay_conflict_in_plane, regular_conflict, regular_conflict_in_plane,
};
pub use sign::Sign;
pub use sphere::{insphere, power_test};

/// The largest absolute weight: 2^400, the square of the largest coordinate.
pub const WEIGHT_MAX: f64 = f64::from_bits((1023 + 400) << 52);
/// The smallest absolute weight other than zero: 2^-320, the square of the smallest coordinate.
pub const WEIGHT_MIN: f64 = f64::from_bits((1023 - 320) << 52);

/// The coordinates of a row (x, y, z, weight).
#[inline]
pub fn position(row: &[f64; 4]) -> &[f64; 3] {
    let [position @ .., _] = row;
    position
}

#[cfg(test)]
mod tests;

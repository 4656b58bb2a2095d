//! What can have been missed in the plane.

use std::f64::consts::PI;

/// The largest object angle of a medial point that a circle of the plane can hold unnoticed: arcsin(L / 2R) + arcsin(L / d), in radians, where `gap` is L, the longest arc between
/// neighbours of Theta, `radius` is R, and `distance` is d, that of the point from the boundary.
///
/// That is theorem 10 of Stolpner and Whitesides, *Medial axis approximation with bounded error*, which needs a circle that the boundary does not enter, a point in the convex hull of
/// Theta, and L < 2R. The point then may have a larger object angle only if d < 2L, or one of the ways to its nearest points leaves the hull less than L from it, or less than L from
/// the nearest point. `None` where L >= 2R or d < 2L: then there is no claim.
pub fn largest_missed_angle(gap: f64, radius: f64, distance: f64) -> Option<f64> {
    let has_claim = gap >= 0.0 && gap < 2.0 * radius && distance >= 2.0 * gap && distance > 0.0;
    has_claim.then(|| libm::asin(gap / (2.0 * radius)) + libm::asin(gap / distance))
}

/// The least number of evenly spread samples of a circle with which no medial point of a larger object angle is missed at the distance of the circle's diameter, or farther away:
/// there both terms of the bound are the same.
pub(super) fn samples_for(angle: f64) -> usize {
    // Fewer leave a circle too little of a hull; more have no use.
    let count = (PI / libm::sin((0.5 * angle).min(0.5 * PI))).ceil();
    (count as usize).clamp(LEAST_SAMPLES, MOST_SAMPLES)
}

/// With fewer points the hull is too small, and dips too shallow, for a square to lie in it.
pub(super) const LEAST_SAMPLES: usize = 12;
/// Enough for any angle that rounding leaves of use.
pub(super) const MOST_SAMPLES: usize = 1 << 20;

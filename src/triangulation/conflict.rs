//! The one difference between Delaunay and regular triangulations: the conflict test.

use crate::predicates;

pub(super) use crate::predicates::position;

/// A point with its weight.
pub(super) type Site = [f64; 4];

/// Decides whether a point is in conflict with a positively oriented finite cell.
///
/// The answer includes the symbolic perturbation, so that there is no third case.
pub(super) trait Conflict {
    fn in_conflict(a: &Site, b: &Site, c: &Site, d: &Site, point: &Site) -> bool;
}

/// The point lies inside the cell's circumsphere.
pub(super) struct Delaunay;

impl Conflict for Delaunay {
    #[inline]
    fn in_conflict(a: &Site, b: &Site, c: &Site, d: &Site, point: &Site) -> bool {
        predicates::delaunay_conflict(a, b, c, d, point)
    }
}

/// The point's power distance to the cell's orthosphere is negative.
pub(super) struct Regular;

impl Conflict for Regular {
    #[inline]
    fn in_conflict(a: &Site, b: &Site, c: &Site, d: &Site, point: &Site) -> bool {
        predicates::regular_conflict(a, b, c, d, point)
    }
}

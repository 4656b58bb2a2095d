//! The one difference between Delaunay and regular triangulations: the conflict test.

use crate::predicates;

/// A point with its weight: x, y, z, weight. Half a cache line, and never in two of them.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(super) struct Site(pub [f64; 4]);

impl Site {
    /// The point without its weight.
    #[inline(always)]
    pub fn position(&self) -> &[f64; 3] {
        predicates::position(&self.0)
    }
}

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
        predicates::delaunay_conflict(&a.0, &b.0, &c.0, &d.0, &point.0)
    }
}

/// The point's power distance to the cell's orthosphere is negative.
pub(super) struct Regular;

impl Conflict for Regular {
    #[inline]
    fn in_conflict(a: &Site, b: &Site, c: &Site, d: &Site, point: &Site) -> bool {
        predicates::regular_conflict(&a.0, &b.0, &c.0, &d.0, &point.0)
    }
}

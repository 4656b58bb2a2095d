//! Where on a Voronoi edge a point lies.

use std::cmp::Ordering;

/// A place on a Voronoi edge: the share of the way that lies before it and the share that lies behind it, or on a ray the distance from its finite end, and infinity.
///
/// One end of an edge may be 2^50 times as far from the samples as the other. So both shares are kept, and the lesser one counts: places are told from each other as well near one end as near
/// the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Share {
    pub before: f64,
    pub behind: f64,
}

impl Share {
    pub const BEGIN: Share = Share { before: 0.0, behind: 1.0 };
    pub const END: Share = Share { before: 1.0, behind: 0.0 };

    /// Where the lengths to both ends have a ratio; the first end where there is no length. A zero has one sign, since places are put in order by their bits.
    pub fn of(before: f64, behind: f64) -> Self {
        let all = before + behind;
        if all == 0.0 {
            return Share::BEGIN;
        }
        Share { before: before / all + 0.0, behind: behind / all + 0.0 }
    }

    /// On a ray.
    pub fn on_ray(distance: f64) -> Self {
        Share { before: distance + 0.0, behind: f64::INFINITY }
    }

    /// The same place seen from the other end.
    pub fn reversed(self) -> Self {
        Share { before: self.behind, behind: self.before }
    }

    /// Whether the first end is the nearer one.
    pub fn is_near_begin(&self) -> bool {
        self.before <= self.behind
    }

    /// From the first end on.
    pub fn order(&self, other: &Share) -> Ordering {
        match [self, other].map(Share::is_near_begin) {
            [true, true] => self.before.total_cmp(&other.before),
            [false, false] => other.behind.total_cmp(&self.behind),
            [true, false] => Ordering::Less,
            [false, true] => Ordering::Greater,
        }
    }

    /// This place or another one, whichever comes first.
    pub fn min(self, other: Share) -> Share {
        if other.order(&self).is_lt() { other } else { self }
    }

    /// This place or another one, whichever comes last.
    pub fn max(self, other: Share) -> Share {
        if other.order(&self).is_gt() { other } else { self }
    }
}

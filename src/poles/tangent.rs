//! The tangent plane of a sample: the plane through it across its pole vector.

use super::select::seen_from;
use crate::dual::{Dual, direction_sign, dot_sign};
use crate::index::NONE;
use crate::predicates::{Sign, UNIT};
use crate::vector::Vec3;

/// The plane through a sample s across its pole vector v, with what tells quickly on which side of it the centre c of a
/// cell of the sample lies: the sign of (c - s) . v, where c and v are the exact ones.
///
/// Where the first pole is at infinity v is a given direction.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct TangentPlane {
    /// The cell of the first pole, or [`NONE`].
    first: u32,
    /// The rounded pole vector, or the direction.
    pole: Vec3,
    /// How far the product of the rounded c - s and v may be from the exact one: so much for each unit of the sum of
    /// the coordinates of c - s in absolute value, ...
    slack: f64,
    /// ... and so much besides.
    least_slack: f64,
}

impl TangentPlane {
    /// Of the sample whose first pole is the centre of a cell, or at infinity in a direction.
    pub fn new(dual: &Dual, sample: usize, first: u32, direction: Vec3) -> Self {
        let s = dual.triangulation().coords()[sample];
        let (pole, pole_error) = match first {
            NONE => (direction, [0.0; 3]),
            first => dual.center_from(first, s),
        };
        // With x for the rounded c - s, X for the exact one, likewise y and Y for the pole vector: since c is the nearest float,
        // |X - x| <= u (|c| + |x|) <= u |s| + 3u |x|, so that |X . Y - x . y| <= sum of |x| |Y - y| + (u |s| + 3u |x|) |Y|; rounding
        // x . y adds 4u |x| |y|.
        let (mut slack, mut least_slack) = (0.0f64, f64::MIN_POSITIVE);
        for k in 0..3 {
            let most = pole[k].abs() + pole_error[k];
            slack = slack.max(pole_error[k] + 8.0 * UNIT * most);
            least_slack += (UNIT * s[k].abs() + f64::from_bits(1)) * most;
        }
        // For the rounding of the slack itself, also where it is less than any float.
        let slack = slack * (1.0 + 16.0 * UNIT) + f64::from_bits(8);
        TangentPlane { first, pole, slack, least_slack: least_slack * (1.0 + 16.0 * UNIT) }
    }

    /// Whether the centre of a cell of the sample lies below the plane, on the side away from the pole.
    #[inline]
    pub fn is_below(&self, dual: &Dual, sample: u32, cell: u32) -> bool {
        let s = dual.triangulation().coords()[sample as usize];
        let c = dual.centers()[cell as usize];
        let x = [c[0] - s[0], c[1] - s[1], c[2] - s[2]];
        let product = x[0] * self.pole[0] + x[1] * self.pole[1] + x[2] * self.pole[2];
        let size = x[0].abs() + x[1].abs() + x[2].abs();
        // A comparison with NaN is false: what overflows is decided exactly, as what is too close. So is a centre that may be
        // farther away than any float.
        if product.abs() > size * self.slack + self.least_slack && size < f64::MAX / 4.0 {
            return product < 0.0;
        }
        self.sign(dual, sample, cell) == Sign::Negative
    }

    /// The exact sign of (c - s) . v.
    #[cold]
    fn sign(&self, dual: &Dual, sample: u32, cell: u32) -> Sign {
        let t = dual.triangulation();
        let seen = seen_from(t, sample, cell);
        match self.first {
            NONE => direction_sign(seen, self.pole),
            first => dot_sign(seen, seen_from(t, sample, first)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Points;
    use crate::dual::DualOptions;
    use crate::job::Job;
    use crate::triangulation::Triangulation;
    use proptest::prelude::*;
    use std::sync::Arc;

    proptest! {
        /// Points of a coarse lattice, moved by next to nothing and put far from the origin: many centres lie in tangent planes,
        /// or next to them.
        #[test]
        fn sides_are_exact(
            steps in prop::collection::vec([0..4i32, 0..4, 0..4, 0..3, 0..3, 0..3], 5..40),
            far in [-40..40i32, -40..40, -40..40],
            direction in [-2..3i32, -2..3, -2..3],
        ) {
            let far = far.map(|power| if power < 0 { 0.0 } else { f64::from(power).exp2() });
            let at = |s: [i32; 6]| [0, 1, 2].map(|k| {
                far[k] + f64::from(s[k]) + f64::from(s[k + 3]) * (far[k] + 1.0) * f64::EPSILON
            });
            let points: Vec<_> = steps.into_iter().map(at).collect();
            let Ok(points) = Points::new(&points, Default::default(), &Job::default()) else {
                return Ok(());
            };
            let t = Triangulation::delaunay(&Arc::new(points), &Job::default()).unwrap();
            let dual = Dual::new(&Arc::new(t), DualOptions::default(), &Job::default()).unwrap();
            let cells = dual.triangulation().cells();
            for first in [NONE, 0, cells.len() as u32 / 2] {
                let samples = match first {
                    NONE => cells[0],
                    first => cells[first as usize],
                };
                for sample in samples {
                    let plane =
                        TangentPlane::new(&dual, sample as usize, first, direction.map(f64::from));
                    for (cell, corners) in (0..).zip(cells) {
                        if corners.contains(&sample) {
                            let is_negative = plane.sign(&dual, sample, cell) == Sign::Negative;
                            prop_assert_eq!(plane.is_below(&dual, sample, cell), is_negative);
                        }
                    }
                }
            }
        }
    }
}

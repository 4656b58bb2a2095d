//! Directions: the normals of facets, and unit vectors.

use super::center::power_of_two;
use super::exact;
use crate::predicates::double_double::{Pairs, each};
use crate::vector::{Vec3, length};

/// The error of a normal's coordinate, relative to itself, past which integers decide.
const NORMAL_ERROR: f64 = power_of_two(-60);

/// The right-handed unit normal of a triangle that is not degenerate, each coordinate right to a few
/// 2^-53 of itself, however thin the triangle: so its products with the triangle's edges cancel as far
/// as rounding lets them.
pub(super) fn normal(points: [Vec3; 3]) -> Vec3 {
    let (cross, errors) = pairs(points);
    let accurate = |k: usize| errors[k] <= NORMAL_ERROR * cross[k].abs();
    match (0..3).all(accurate) {
        true => unit(cross),
        false => unit(exact::cross(points)),
    }
}

/// The cross product of b - a and c - a, for points a, b, c within the range of [`crate::points`]: right to 2^-42 of its own
/// length, however thin the triangle, if they are not exactly collinear.
#[cold]
pub(crate) fn cross(points: [Vec3; 3]) -> Vec3 {
    let (cross, errors) = pairs(points);
    match length(errors) <= power_of_two(-43) * length(cross) {
        true => cross,
        false => exact::cross(points),
    }
}

/// The cross product in pairs of floats, rounded, and a bound of each coordinate's error before that: 15u² of the same formula on
/// absolute values.
fn pairs([a, b, c]: [Vec3; 3]) -> (Vec3, Vec3) {
    let (u, v) = (Pairs::difference(b, a), Pairs::difference(c, a));
    let (forward, backward) = ([1, 2, 0], [2, 0, 1]);
    let cross = u.pick(forward).mul(&v.pick(backward)).sub(&u.pick(backward).mul(&v.pick(forward)));
    let errors = each(|k| {
        let [i, j] = [forward[k], backward[k]];
        let size = (u.hi[i] * v.hi[j]).abs() + (u.hi[j] * v.hi[i]).abs();
        size * 16.0 * power_of_two(-106)
    });
    (cross.normalized().hi, errors)
}

/// The vector divided by its length, which must not be 0 or infinite.
pub(crate) fn unit(vector: [f64; 3]) -> [f64; 3] {
    let largest = vector.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    // A power of two near the length: the squares neither overflow nor all underflow.
    let exponent = ((largest.to_bits() >> 52) as i32 - 1023).clamp(-1000, 1000);
    let scaled = vector.map(|x| x * power_of_two(-exponent));
    let length = scaled.iter().map(|x| x * x).sum::<f64>().sqrt();
    // Adding 0 turns -0 into 0.
    scaled.map(|x| x / length + 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The cross product in integers of any size, and its error beside its length.
    fn error(points: [Vec3; 3]) -> Option<f64> {
        let (found, right) = (cross(points), exact::cross(points));
        let size = length(right);
        (size > 0.0).then(|| length(each(|k| found[k] - right[k])) / size)
    }

    proptest! {
        /// Three points near a line, which lies anywhere, as near as rounding and a few more steps put them.
        #[test]
        fn a_cross_product_is_right_however_thin_the_triangle(
            at in prop::array::uniform3(-1.0..1.0f64),
            along in prop::array::uniform3(-1.0..1.0f64),
            places in prop::array::uniform3(-1.0..1.0f64),
            size in -100..100i32,
            off in 0..60i32,
        ) {
            let off = power_of_two(-off - 1);
            let point = |i: usize| each(|k| {
                let aside = if i == k { off } else { 0.0 };
                (at[k] + places[i] * along[k] + aside) * power_of_two(size)
            });
            let found = error([point(0), point(1), point(2)]);
            prop_assert!(found.is_none_or(|error| error < power_of_two(-42)), "{found:?}");
        }
    }

    #[test]
    fn the_thinnest_triangles_need_integers() {
        // A corner one ulp off a long side, and the cross product 2^-105 of the sides.
        let x = 1.0 + f64::EPSILON;
        let thin = [[0.0; 3], [x, 1.0, 0.0], [1.0, 1.0 - f64::EPSILON, 0.0]];
        let (found, errors) = pairs(thin);
        assert!(length(errors) > power_of_two(-43) * length(found));
        assert_eq!(cross(thin), [0.0, 0.0, -f64::EPSILON * f64::EPSILON]);
        assert_eq!(error(thin), Some(0.0));
        let far = thin.map(|p| p.map(|x| x * power_of_two(199)));
        assert_eq!(error(far), Some(0.0));
        let near = thin.map(|p| p.map(|x| x * power_of_two(-159)));
        assert_eq!(error(near), Some(0.0));
        assert_eq!(cross([[1.0, 2.0, 3.0]; 3]), [0.0; 3]);
    }
}

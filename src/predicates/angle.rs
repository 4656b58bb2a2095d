//! Acute, right or obtuse: the sign of a scalar product.
//!
//! As in [`super::lifted`], a product of two calculated differences passes through 2 roundings for
//! them, one for itself and 2 for the sums: the error is at most 5 u / (1 - 5 u) times the sum
//! of the absolute products, which is itself calculated with 3 roundings; 6 u leaves room.

use super::exact;
use super::lifted::{TINY, UNIT};
use super::sign::Sign;

/// The sign of (a - b) . (c - b): positive where the angle abc is acute, zero where it is right,
/// negative where it is obtuse. Exact for coordinates 0 or within [2^-160, 2^400] in absolute value.
pub fn angle(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3]) -> Sign {
    let product = |i: usize| (a[i] - b[i]) * (c[i] - b[i]);
    let [x, y, z] = [product(0), product(1), product(2)];
    let sum = x + y + z;
    if sum.abs() > 6.0 * UNIT * (x.abs() + y.abs() + z.abs()) + TINY {
        return Sign::of(sum);
    }
    exact::scalar(a, b, c)
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_rational::BigRational;
    use num_traits::{Signed, Zero};
    use proptest::prelude::*;

    fn by_rationals(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3]) -> Sign {
        let q = |x: f64| BigRational::from_float(x).unwrap();
        let sum = (0..3)
            .fold(BigRational::zero(), |sum, i| sum + (q(a[i]) - q(b[i])) * (q(c[i]) - q(b[i])));
        match (sum.is_positive(), sum.is_negative()) {
            (true, _) => Sign::Positive,
            (_, true) => Sign::Negative,
            _ => Sign::Zero,
        }
    }

    #[test]
    fn a_right_angle_is_right_to_the_last_bit() {
        let (a, b) = ([1.0 + f64::EPSILON, 1.0, 0.25], [0.0; 3]);
        let c = [1.0, -1.0 - f64::EPSILON, 0.0];
        assert_eq!(angle(&a, &b, &c), Sign::Zero);
        assert_eq!(angle(&a, &b, &[1.0, -1.0, 0.0]), Sign::Positive);
        assert_eq!(angle(&a, &b, &[1.0, -1.0 - 2.0 * f64::EPSILON, 0.0]), Sign::Negative);
        let far = [2f64.powi(400), -(2f64.powi(400)), 2f64.powi(-160)];
        assert_eq!(angle(&far, &b, &[1.0, 1.0, 1.0]), Sign::Positive);
        assert_eq!(angle(&far, &b, &[1.0, 1.0, -1.0]), Sign::Negative);
        assert_eq!(angle(&far, &b, &[1.0, 1.0, 0.0]), Sign::Zero);
    }

    proptest! {
        #[test]
        fn it_equals_the_rational_sign(
            points in prop::array::uniform3(prop::array::uniform3(-8i32..8)),
            scales in prop::array::uniform3(-60i32..60),
            ulps in 0u32..2,
        ) {
            let scaled = |i: usize| points[i].map(|x| f64::from(x) * 2f64.powi(scales[i] * (ulps as i32)));
            let [a, b, c] = [scaled(0), scaled(1), scaled(2)];
            prop_assert_eq!(angle(&a, &b, &c), by_rationals(&a, &b, &c));
        }
    }
}

//! Integers against big integers, pairs of floats against rationals.

use super::sets::{Random, anything, power_of_two};
use super::{CASES, rational};
use crate::predicates::Sign;
use crate::predicates::double_double::{Pairs, two_product_error, two_sum_error};
use crate::predicates::integer::{Int, lowest_bit, width};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use proptest::prelude::*;

/// The power of two as a rational.
fn power(k: i32) -> BigRational {
    let power = BigRational::from_integer(BigInt::from(1) << k.unsigned_abs());
    if k < 0 { power.recip() } else { power }
}

/// An integer below 2^bits in absolute value as a float, and as a big integer.
fn integer(bits: u32) -> impl Strategy<Value = (f64, BigInt)> {
    (-(1i64 << 53)..1 << 53, 0..=bits - 53).prop_map(|(mantissa, shift)| {
        let float = mantissa as f64 * power_of_two(shift as i32);
        (float, BigInt::from(mantissa) << shift)
    })
}

fn equals<const N: usize>(int: Int<N>, big: &BigInt) -> bool {
    int == of_big(big)
}

/// The same integer, put together from 32 bits at a time.
fn of_big<const N: usize>(big: &BigInt) -> Int<N> {
    let (sign, digits) = big.to_u32_digits();
    let magnitude = digits.iter().enumerate().fold(Int::of(0.0, 0), |sum: Int<N>, (i, &digit)| {
        sum + Int::of(f64::from(digit), 0).shifted(32 * i as i32)
    });
    if sign == num_bigint::Sign::Minus { -magnitude } else { magnitude }
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: if cfg!(miri) { 4 } else { 500 },
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn integers_calculate_as_big_integers_do(
        (x, big_x) in integer(180),
        (y, big_y) in integer(180),
        shift in 0..70,
    ) {
        let (a, b): (Int<3>, Int<3>) = (Int::of(x, 0), Int::of(y, 0));
        prop_assert!(equals(a, &big_x));
        prop_assert!(equals(a + b, &(&big_x + &big_y)));
        prop_assert!(equals(a - b, &(&big_x - &big_y)));
        prop_assert!(equals(-a, &-&big_x));
        let product: Int<6> = a.times(b);
        prop_assert!(equals(product, &(&big_x * &big_y)));
        let wide: Int<8> = product.times(Int::<2>::of(-3.0, 0));
        prop_assert!(equals(wide, &(&big_x * &big_y * -3)));
        prop_assert!(equals(wide.shifted(shift), &((&big_x * &big_y * -3) << shift)));
        let sign = match (&big_x * &big_y).signum() {
            zero if zero.is_zero() => Sign::Zero,
            sign if sign.is_negative() => Sign::Negative,
            _ => Sign::Positive,
        };
        prop_assert_eq!(product.sign(), sign);
    }
}

#[test]
fn a_float_is_its_units() {
    let mut random = Random(1);
    for _ in 0..CASES {
        let x = anything(&mut random, -300, 300);
        let Some(unit) = lowest_bit(x) else {
            assert_eq!((x, width(x)), (0.0, None));
            continue;
        };
        let units = rational(x) / power(unit);
        assert!(units.is_integer() && units.numer().bit(0), "{x:e} is odd in 2^{unit}");
        let width = width(x).expect("not zero");
        assert!(rational(x).abs() < power(width) && rational(x).abs() >= power(width - 1));
        let finer = random.below(70) as i32;
        let int: Int<2> = Int::of(x, unit - finer);
        assert!(equals(int, &(units.numer() << finer)), "{x:e} in 2^({unit} - {finer})");
    }
    let subnormal = 3.0 * f64::from_bits(1);
    assert_eq!((lowest_bit(subnormal), width(subnormal)), (Some(-1074), Some(-1072)));
}

#[test]
fn sums_and_products_of_floats_lose_nothing() {
    let mut random = Random(2);
    for _ in 0..CASES {
        let x = anything(&mut random, -212, 400);
        let y = if random.below(2) == 0 {
            anything(&mut random, -212, 400)
        } else {
            x * (1.0 + random.unit() * 1e-3)
        };
        let sum = rational(x + y) + rational(two_sum_error(x, y, x + y));
        assert_eq!(sum, rational(x) + rational(y), "{x:e} + {y:e}");
        let product = rational(x * y) + rational(two_product_error::<false>(x, y, x * y));
        assert_eq!(product, rational(x) * rational(y), "{x:e} * {y:e}");
    }
}

#[test]
fn pairs_keep_the_bounds_that_are_stated_for_them() {
    let mut random = Random(3);
    let value = |p: &Pairs<1>| rational(p.hi[0]) + rational(p.lo[0]);
    let unit = power(-53);
    for _ in 0..CASES {
        let mut float = |scale: f64| [scale * random.unit()];
        let a = Pairs::difference(float(1.0), float(1e-3));
        let b = Pairs::difference(float(1.0), float(1.0));
        // Sums of products that nearly cancel, as in determinants.
        let c = a.mul(&b);
        let d = Pairs::difference([c.hi[0] * 3.0], float(1e-12));
        let (va, vb, vd) = (value(&a), value(&b), value(&d));
        for (pair, exact, magnitude, looseness, error) in [
            (a.mul(&b), &va * &vb, (&va * &vb).abs(), 3, 8),
            (a.add(&b), &va + &vb, va.abs() + vb.abs(), 2, 3),
            (c.sub(&d), &va * &vb - &vd, (&va * &vb).abs() + vd.abs(), 4, 15),
            (c.mul(&d), &va * &vb * &vd, (&va * &vb * &vd).abs(), 5, 8 + 12 + 3 + 1),
        ] {
            // The bounds hold for the magnitudes of the high parts, to within a few units.
            let magnitude = magnitude * (rational(1.0) + rational(10.0) * &unit);
            let off = (value(&pair) - exact).abs();
            assert!(off <= rational(f64::from(error)) * &unit * &unit * &magnitude);
            let low = rational(pair.lo[0]).abs();
            assert!(low <= rational(f64::from(looseness)) * &unit * magnitude);
        }
    }
}

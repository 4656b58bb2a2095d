//! Integers of fixed widths, on the stack: the last stage of every predicate.
//!
//! A finite set of floats lies on a common grid of step 2^unit, so every determinant of them is
//! an integer times a power of two. Sums are calculated modulo 2^(64 N), products are twice as
//! wide as their factors: a result is right whenever it fits. No rounding, no range of exponents,
//! nothing on the heap.

use super::sign::Sign;
use std::array::from_fn;
use std::ops::{Add, Neg, Sub};

/// An integer modulo 2^(64 N), read as two's complement; least significant limb first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Int<const N: usize>([u64; N]);

impl<const N: usize> Int<N> {
    /// `x` divided by 2^unit, for an `x` that is a multiple of it.
    pub(crate) fn of(x: f64, unit: i32) -> Self {
        let mut limbs = [0; N];
        if x != 0.0 {
            let (mantissa, exponent) = decode(x);
            let shift = exponent - unit;
            // A negative shift drops zeros only, since `x` is a multiple of the unit.
            let (mantissa, shift) =
                if shift < 0 { (mantissa >> -shift, 0) } else { (mantissa, shift as usize) };
            let (limb, bit) = (shift / 64, shift % 64);
            let wide = u128::from(mantissa) << bit;
            if limb < N {
                limbs[limb] = wide as u64;
            }
            if limb + 1 < N {
                limbs[limb + 1] = (wide >> 64) as u64;
            }
        }
        if x < 0.0 { -Int(limbs) } else { Int(limbs) }
    }

    /// The integer times 2^shift, for a shift that is not negative.
    pub(super) fn shifted(self, shift: i32) -> Self {
        let (limb, bit) = (shift as usize / 64, shift % 64);
        let from = |i: usize| i.checked_sub(limb).map_or(0, |i| self.0[i]);
        Int(from_fn(|i| {
            let low = if i > 0 { from(i - 1) } else { 0 };
            let wide = (u128::from(from(i)) << 64) | u128::from(low);
            (wide >> (64 - bit)) as u64
        }))
    }

    /// Whether the integer is less than zero.
    pub(crate) fn is_negative(self) -> bool {
        self.0[N - 1] >> 63 != 0
    }

    /// The absolute value.
    fn magnitude(self) -> Self {
        if self.is_negative() { -self } else { self }
    }

    /// The least `k` with x < 2^k, for an x that is not negative.
    fn bits(self) -> i32 {
        (0..N)
            .rev()
            .find(|&i| self.0[i] != 0)
            .map_or(0, |i| 64 * i as i32 + 64 - self.0[i].leading_zeros() as i32)
    }

    /// The same integer in more limbs.
    pub(crate) fn widened<const M: usize>(self) -> Int<M> {
        const { assert!(M >= N) }
        let sign = if self.is_negative() { u64::MAX } else { 0 };
        Int(from_fn(|i| if i < N { self.0[i] } else { sign }))
    }

    /// The product, exactly: `R` is the sum of the lengths of the factors.
    pub(crate) fn times<const M: usize, const R: usize>(self, other: Int<M>) -> Int<R> {
        const { assert!(R == N + M) }
        let mut limbs = [0; R];
        for i in 0..N {
            let mut carry = 0;
            for j in 0..M {
                // At most (2^64 - 1)^2 + 2 (2^64 - 1) = 2^128 - 1: no overflow.
                let product = u128::from(self.0[i]) * u128::from(other.0[j]);
                let sum = product + u128::from(limbs[i + j]) + carry;
                limbs[i + j] = sum as u64;
                carry = sum >> 64;
            }
            limbs[i + M] = carry as u64;
        }
        // That was the product of the limbs without signs. A negative integer a of N limbs
        // reads a + 2^(64 N) there, and adds 2^(64 N) b to the product.
        let unsigned = Int(limbs);
        let high = |sign: bool, n: usize, of: &dyn Fn(usize) -> u64| {
            Int(from_fn(|i| if sign && i >= n { of(i - n) } else { 0 }))
        };
        unsigned
            - high(self.is_negative(), N, &|i| other.0[i])
            - high(other.is_negative(), M, &|i| self.0[i])
    }

    /// The absolute value of `self` / `divisor` as (q, e), nearly q 2^e: q has 63 bits or more, and its lowest bit
    /// stands for everything below it. Neither may be 0, and `self` must be below 2^(64 N - 1) in absolute value.
    ///
    /// One step of long division (Knuth, *The Art of Computer Programming* 2, 4.3.1): with the dividend shifted to
    /// 64 N - 1 bits and the divisor to 64 N, the first limbs tell the quotient but for two units.
    pub(crate) fn quotient(self, divisor: Self) -> (u128, i32) {
        let (dividend, divisor) = (self.magnitude(), divisor.magnitude());
        let shifts = [dividend.bits() + 1, divisor.bits()].map(|bits| 64 * N as i32 - bits);
        let (dividend, divisor) = (dividend.shifted(shifts[0]).0, divisor.shifted(shifts[1]).0);
        let below = |i: usize| if i > 0 { dividend[i - 1] } else { 0 };
        let top = u128::from(dividend[N - 1]) << 64 | u128::from(below(N - 1));
        let mut quotient = (top / u128::from(divisor[N - 1])) as u64;
        // The rest, of the dividend and a limb 0 below it, in N limbs and one above.
        let mut rest = [0; N];
        let mut borrow = 0;
        for i in 0..N {
            let product = u128::from(quotient) * u128::from(divisor[i]) + borrow;
            let (limb, under) = below(i).overflowing_sub(product as u64);
            rest[i] = limb;
            borrow = (product >> 64) + u128::from(under);
        }
        let mut above = i128::from(dividend[N - 1]) - borrow as i128;
        while above < 0 {
            quotient -= 1;
            let mut carry = 0;
            for i in 0..N {
                let sum = u128::from(rest[i]) + u128::from(divisor[i]) + carry;
                rest[i] = sum as u64;
                carry = sum >> 64;
            }
            above += carry as i128;
        }
        let inexact = rest.iter().any(|&limb| limb != 0);
        let bits = u128::from(quotient) << 1 | u128::from(inexact);
        (bits, shifts[1] - shifts[0] - 65)
    }

    /// The sign.
    pub(crate) fn sign(self) -> Sign {
        if self.is_negative() {
            Sign::Negative
        } else if self.0.iter().all(|&limb| limb == 0) {
            Sign::Zero
        } else {
            Sign::Positive
        }
    }
}

impl<const N: usize> Add for Int<N> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let mut carry = 0;
        Int(from_fn(|i| {
            let sum = u128::from(self.0[i]) + u128::from(other.0[i]) + carry;
            carry = sum >> 64;
            sum as u64
        }))
    }
}

impl<const N: usize> Neg for Int<N> {
    type Output = Self;

    fn neg(self) -> Self {
        Int([0; N]) - self
    }
}

impl<const N: usize> Sub for Int<N> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        // a - b = a + !b + 1 in two's complement.
        let mut carry = 1;
        Int(from_fn(|i| {
            let sum = u128::from(self.0[i]) + u128::from(!other.0[i]) + carry;
            carry = sum >> 64;
            sum as u64
        }))
    }
}

/// The magnitude of a finite non-zero float as (mantissa, exponent): mantissa * 2^exponent.
fn decode(x: f64) -> (u64, i32) {
    let bits = x.to_bits();
    let fraction = bits & ((1 << 52) - 1);
    match ((bits >> 52) & 0x7ff) as i32 {
        0 => (fraction, -1074),
        biased => (fraction | 1 << 52, biased - 1075),
    }
}

/// The exponent of the lowest bit set in `x`, or `None` for zero: `x` is a multiple of
/// 2^exponent, and of no higher power.
pub(super) fn lowest_bit(x: f64) -> Option<i32> {
    (x != 0.0).then(|| {
        let (mantissa, exponent) = decode(x);
        exponent + mantissa.trailing_zeros() as i32
    })
}

/// The least `k` with |x| < 2^k, or `None` for zero.
pub(crate) fn width(x: f64) -> Option<i32> {
    (x != 0.0).then(|| {
        let (mantissa, exponent) = decode(x);
        exponent + 64 - mantissa.leading_zeros() as i32
    })
}

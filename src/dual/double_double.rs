//! Double-double arithmetic: an unevaluated sum of two f64, about 106 bits.
//!
//! Only additions and multiplications that round to nearest are used, so that every machine gives
//! the same bits; nothing depends on fused operations. With u = 2^-53, and unless something
//! underflows or overflows, every operation here returns a value within 8u² (|x| o |y|) of the
//! exact x o y, where |x| o |y| is the same operation on absolute values with subtraction
//! replaced by addition. (Dekker 1971; Joldes, Muller, Popescu 2017, *Tight and rigorous error
//! bounds for basic building blocks of double-word arithmetic*: 7u² for the product without a
//! fused operation; the sum is argued at [`Dd::plus`].)

/// The unevaluated sum `hi + lo`. Invariant: `hi` is the f64 nearest to the sum.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dd {
    pub(super) hi: f64,
    pub(super) lo: f64,
}

/// The sum of two f64 without error (Knuth).
#[inline(always)]
pub(super) fn two_sum(a: f64, b: f64) -> Dd {
    let hi = a + b;
    let from_b = hi - a;
    let lo = (a - (hi - from_b)) + (b - from_b);
    Dd { hi, lo }
}

/// An f64 cut into two halves of 26 bits each (Veltkamp).
#[inline(always)]
fn split(a: f64) -> (f64, f64) {
    let shifted = 134_217_729.0 * a;
    let high = shifted - (shifted - a);
    (high, a - high)
}

/// The product of two f64 without error (Dekker).
#[inline(always)]
fn two_product(a: f64, b: f64) -> Dd {
    let hi = a * b;
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    let lo = ((ah * bh - hi) + ah * bl + al * bh) + al * bl;
    Dd { hi, lo }
}

impl Dd {
    /// The exact difference of two f64.
    #[inline(always)]
    pub(super) fn difference(a: f64, b: f64) -> Dd {
        two_sum(a, -b)
    }

    /// The sum. The low parts together, and the error of the high sum, are u (|x| + |y|) at most, up
    /// to a factor 1 + O(u); so the two additions that round are wrong by u² and 2u² (|x| + |y|).
    #[inline(always)]
    pub(super) fn plus(self, other: Dd) -> Dd {
        let high = two_sum(self.hi, other.hi);
        two_sum(high.hi, high.lo + (self.lo + other.lo))
    }

    /// The difference.
    #[inline(always)]
    pub(super) fn minus(self, other: Dd) -> Dd {
        self.plus(Dd { hi: -other.hi, lo: -other.lo })
    }

    /// The product.
    #[inline(always)]
    pub(super) fn times(self, other: Dd) -> Dd {
        let high = two_product(self.hi, other.hi);
        two_sum(high.hi, high.lo + (self.hi * other.lo + self.lo * other.hi))
    }

    /// The product with a power of two, exact unless it underflows or overflows.
    #[inline(always)]
    pub(super) fn scaled(self, power: f64) -> Dd {
        Dd { hi: self.hi * power, lo: self.lo * power }
    }

    /// The f64 that every number within `error` of this one rounds to, or `None` if they round to
    /// more than one, or to an infinity.
    ///
    /// `error` must exceed the true error by 2u² |self| at least, which covers the rounding of the
    /// two ends.
    #[inline(always)]
    pub(super) fn rounded_within(self, error: f64) -> Option<f64> {
        let low = self.hi + (self.lo - error);
        let high = self.hi + (self.lo + error);
        // Adding 0 turns -0 into 0.
        (low == high && low.is_finite()).then_some(low + 0.0)
    }
}

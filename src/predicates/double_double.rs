//! Pairs of floats, worth about 106 bits, several at a time.
//!
//! A pair (hi, lo) stands for hi + lo. Pairs are not normalised: `lo` may grow to a few ulps of
//! `hi`, which costs nothing in the bounds below and saves a step in every operation. With
//! u = 2^-53, and a magnitude A, a pair is *k-loose with error q* when it stands for a value v with
//! `|hi| <= A (1 + u)^k`, `|lo| <= k u A (1 + u)^k` and `|hi + lo - v| <= q u^2 A (1 + u)^k`. Then
//!
//! - [`Pairs::difference`] of two floats, and [`Pairs::exact`], are 1-loose with error 0;
//! - the sum of a k- and an m-loose pair with magnitudes A and B is, with n = max(k, m),
//!   (n + 1)-loose for A + B, with error max(q_k, q_m) + 2n + 1: TwoSum is exact, the sum of
//!   the low parts is rounded (n u (A + B) u), and so is its sum with the error of TwoSum
//!   ((n + 1) u (A + B) u);
//! - their product is (k + m + 1)-loose for A B, with error
//!   q_k + q_m + 3 (k + m) + k m + 1: TwoProduct is exact; the two cross products are rounded
//!   (k + m), so is their sum (k + m), and its sum with the error of TwoProduct (k + m + 1);
//!   the product of the low parts is left out (k m).
//!
//! The powers of (1 + u), and the products of q u^2 with anything small, are covered by the slack
//! that every user of these bounds leaves (k and q stay below 1000, so they amount to less than
//! one part in 10^10).
//!
//! Nothing underflows for inputs within the ranges of [`super`]: see there.

/// The array of a function's values.
///
/// Unlike those of the standard library it becomes part of its caller, so that it is compiled for the caller's
/// processor, see `processor.rs`.
#[inline(always)]
pub(crate) fn each<T: Copy + Default, const N: usize>(of: impl Fn(usize) -> T) -> [T; N] {
    let mut array = [T::default(); N];
    let mut i = 0;
    while i < N {
        array[i] = of(i);
        i += 1;
    }
    array
}

/// `L` unevaluated sums of two floats.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pairs<const L: usize> {
    pub(crate) hi: [f64; L],
    pub(crate) lo: [f64; L],
}

impl<const L: usize> Default for Pairs<L> {
    #[inline(always)]
    fn default() -> Self {
        Pairs { hi: [0.0; L], lo: [0.0; L] }
    }
}

impl<const L: usize> Pairs<L> {
    /// The exact differences `a - b`.
    #[inline(always)]
    pub(crate) fn difference(a: [f64; L], b: [f64; L]) -> Self {
        Self::of(|i| {
            let hi = a[i] - b[i];
            (hi, two_sum_error(a[i], -b[i], hi))
        })
    }

    #[inline(always)]
    fn of(pair: impl Fn(usize) -> (f64, f64)) -> Self {
        let mut pairs = Self::default();
        let mut i = 0;
        while i < L {
            (pairs.hi[i], pairs.lo[i]) = pair(i);
            i += 1;
        }
        pairs
    }

    /// The given floats.
    #[inline(always)]
    pub(crate) fn exact(hi: [f64; L]) -> Self {
        Pairs { hi, lo: [0.0; L] }
    }

    /// The same values with `hi` the float nearest to each: 1-loose for the value's own magnitude,
    /// with the error that they had.
    #[inline(always)]
    pub(crate) fn normalized(&self) -> Self {
        Self::of(|i| {
            let hi = self.hi[i] + self.lo[i];
            (hi, two_sum_error(self.hi[i], self.lo[i], hi))
        })
    }

    /// The products with powers of two, exact unless they underflow or overflow.
    #[inline(always)]
    pub(crate) fn scaled(&self, powers: [f64; L]) -> Self {
        Self::of(|i| (self.hi[i] * powers[i], self.lo[i] * powers[i]))
    }

    /// The pairs at the given places.
    #[inline(always)]
    pub(crate) fn pick<const M: usize>(&self, places: [usize; M]) -> Pairs<M> {
        Pairs { hi: each(|i| self.hi[places[i]]), lo: each(|i| self.lo[places[i]]) }
    }

    /// The sums.
    #[inline(always)]
    pub(crate) fn add(&self, other: &Self) -> Self {
        Self::of(|i| {
            let hi = self.hi[i] + other.hi[i];
            let error = two_sum_error(self.hi[i], other.hi[i], hi);
            (hi, error + (self.lo[i] + other.lo[i]))
        })
    }

    /// The differences.
    #[inline(always)]
    pub(crate) fn sub(&self, other: &Self) -> Self {
        self.add(&Pairs { hi: each(|i| -other.hi[i]), lo: each(|i| -other.lo[i]) })
    }

    /// The products.
    #[inline(always)]
    pub(crate) fn mul(&self, other: &Self) -> Self {
        self.times::<false>(other)
    }

    /// The same products by fused multiply-adds, if `FMA`: for functions that are compiled for processors
    /// which have them, see `processor.rs`. On others they would cost a call.
    #[inline(always)]
    pub(crate) fn times<const FMA: bool>(&self, other: &Self) -> Self {
        Self::of(|i| {
            let hi = self.hi[i] * other.hi[i];
            let error = two_product_error::<FMA>(self.hi[i], other.hi[i], hi);
            (hi, error + (self.hi[i] * other.lo[i] + self.lo[i] * other.hi[i]))
        })
    }
}

/// a + b - fl(a + b), exactly (Knuth 1969, section 4.2.2; Shewchuk 1997, theorem 7).
#[inline(always)]
pub(crate) fn two_sum_error(a: f64, b: f64, sum: f64) -> f64 {
    let b_virtual = sum - a;
    let a_virtual = sum - b_virtual;
    (a - a_virtual) + (b - b_virtual)
}

/// a * b - fl(a * b), exactly (Dekker 1971; Shewchuk 1997, theorem 18).
///
/// With a fused multiply-add the same value in one instruction: it changes the time, never the value.
#[inline(always)]
pub(crate) fn two_product_error<const FMA: bool>(a: f64, b: f64, product: f64) -> f64 {
    if FMA || cfg!(target_feature = "fma") {
        return a.mul_add(b, -product);
    }
    let (a_high, a_low) = split(a);
    let (b_high, b_low) = split(b);
    a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low)
}

/// The 26 high bits of a float, and the rest.
#[inline(always)]
fn split(x: f64) -> (f64, f64) {
    const SPLITTER: f64 = 134_217_729.0; // 2^27 + 1
    let scaled = SPLITTER * x;
    let high = scaled - (scaled - x);
    (high, x - high)
}

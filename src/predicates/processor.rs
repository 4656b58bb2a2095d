//! What is compiled twice, for every processor and for those with AVX2 and fused multiply-adds, and
//! chosen at run time: the same answers, sooner.
#![allow(unsafe_code)]

use super::lifted;
use super::sign::Sign;

/// What functions are compiled for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Processor {
    /// Every processor of the target.
    Any,
    /// Processors with AVX2, fused multiply-adds and a population count.
    #[cfg(target_arch = "x86_64")]
    Avx2,
}

impl Processor {
    /// The best that this machine can run. Cost: one load, after the first time.
    #[inline]
    pub fn detect() -> Self {
        #[cfg(target_arch = "x86_64")]
        if is_x86_feature_detected!("avx2")
            && is_x86_feature_detected!("fma")
            && is_x86_feature_detected!("popcnt")
        {
            return Processor::Avx2;
        }
        Processor::Any
    }
}

#[cfg(target_arch = "x86_64")]
pub(crate) use avx2::Avx2;

#[cfg(target_arch = "x86_64")]
mod avx2 {
    //! Lanes in one register.
    //!
    //! The processor must have AVX2 and FMA wherever a method is called. A value cannot be made anywhere else, except
    //! by the functions [`Lanes::of`], [`Lanes::splat`] and [`Lanes::columns`]: these are called only in what is generic
    //! over lanes, and that with `Avx2` only in functions compiled for these features, which can
    //! be called only where [`super::Processor::detect`] has found them.

    use super::super::lanes::{BEYOND, Lanes, PACKED};
    use std::arch::x86_64::*;

    /// Four floats in a register.
    #[derive(Clone, Copy)]
    pub(crate) struct Avx2(__m256d);

    /// Calls intrinsics that need nothing but the processor's features.
    macro_rules! avx2 {
        ($call:expr) => {
            // SAFETY: the processor has AVX2 and FMA, see above; there is no other condition.
            unsafe { $call }
        };
    }

    impl Lanes for Avx2 {
        type Mask = __m256d;

        #[inline(always)]
        fn of([a, b, c, d]: [f64; 4]) -> Self {
            Avx2(avx2!(_mm256_setr_pd(a, b, c, d)))
        }

        #[inline(always)]
        fn splat(x: f64) -> Self {
            Avx2(avx2!(_mm256_set1_pd(x)))
        }

        #[inline(always)]
        fn columns([a, b, c, d]: [&[f64; 3]; 4]) -> [Self; 3] {
            // SAFETY: the processor has AVX2; each load takes the first two of three floats.
            unsafe {
                let ac = _mm256_set_m128d(_mm_loadu_pd(c.as_ptr()), _mm_loadu_pd(a.as_ptr()));
                let bd = _mm256_set_m128d(_mm_loadu_pd(d.as_ptr()), _mm_loadu_pd(b.as_ptr()));
                let (x, y) = (_mm256_unpacklo_pd(ac, bd), _mm256_unpackhi_pd(ac, bd));
                let z = _mm256_setr_pd(a[2], b[2], c[2], d[2]);
                [Avx2(x), Avx2(y), Avx2(z)]
            }
        }

        #[inline(always)]
        fn array(self) -> [f64; 4] {
            let mut array = [0.0; 4];
            // SAFETY: the processor has AVX2; the array has room for four floats.
            unsafe { _mm256_storeu_pd(array.as_mut_ptr(), self.0) };
            array
        }

        #[inline(always)]
        fn add(self, other: Self) -> Self {
            Avx2(avx2!(_mm256_add_pd(self.0, other.0)))
        }

        #[inline(always)]
        fn sub(self, other: Self) -> Self {
            Avx2(avx2!(_mm256_sub_pd(self.0, other.0)))
        }

        #[inline(always)]
        fn mul(self, other: Self) -> Self {
            Avx2(avx2!(_mm256_mul_pd(self.0, other.0)))
        }

        #[inline(always)]
        fn mul_add(self, b: Self, c: Self) -> Self {
            Avx2(avx2!(_mm256_fmadd_pd(self.0, b.0, c.0)))
        }

        #[inline(always)]
        fn mul_sub(self, b: Self, c: Self) -> Self {
            Avx2(avx2!(_mm256_fmsub_pd(self.0, b.0, c.0)))
        }

        #[inline(always)]
        fn abs(self) -> Self {
            Avx2(avx2!(_mm256_andnot_pd(_mm256_set1_pd(-0.0), self.0)))
        }

        #[inline(always)]
        fn max(self, other: Self) -> Self {
            Avx2(avx2!(_mm256_max_pd(self.0, other.0)))
        }

        #[inline(always)]
        fn sqrt(self) -> Self {
            Avx2(avx2!(_mm256_sqrt_pd(self.0)))
        }

        #[inline(always)]
        fn turned<const BY: usize>(self) -> Self {
            Avx2(avx2!(match BY % 4 {
                0 => self.0,
                1 => _mm256_permute4x64_pd::<0b00_11_10_01>(self.0),
                2 => _mm256_permute4x64_pd::<0b01_00_11_10>(self.0),
                _ => _mm256_permute4x64_pd::<0b10_01_00_11>(self.0),
            }))
        }

        #[inline(always)]
        fn alternated(self) -> Self {
            Avx2(avx2!(_mm256_xor_pd(self.0, _mm256_setr_pd(0.0, -0.0, 0.0, -0.0))))
        }

        #[inline(always)]
        fn equal([a, b, c, d]: [u32; 4], index: u32) -> __m256d {
            avx2!({
                let indices = _mm_setr_epi32(a as i32, b as i32, c as i32, d as i32);
                let equal = _mm_cmpeq_epi32(indices, _mm_set1_epi32(index as i32));
                _mm256_castsi256_pd(_mm256_cvtepi32_epi64(equal))
            })
        }

        #[inline(always)]
        fn select(mask: __m256d, yes: Self, no: Self) -> Self {
            Avx2(avx2!(_mm256_blendv_pd(no.0, yes.0, mask)))
        }

        #[inline(always)]
        fn greater(self, other: Self) -> u32 {
            avx2!(_mm256_movemask_pd(_mm256_cmp_pd::<_CMP_GT_OQ>(self.0, other.0))) as u32
        }

        #[inline(always)]
        fn cell_beyond(cell: [u32; 4], slot: u32, point: u32) -> [u32; 4] {
            const BYTES: [__m128i; 4] = bytes_of(BEYOND);
            // SAFETY: the processor has AVX2; four numbers are as large as a register for them.
            unsafe {
                let cell = std::mem::transmute::<[u32; 4], __m128i>(cell);
                let turned = _mm_shuffle_epi8(cell, BYTES[slot as usize & 3]);
                let cell = _mm_blend_epi32::<1>(turned, _mm_set1_epi32(point as i32));
                std::mem::transmute::<__m128i, [u32; 4]>(cell)
            }
        }

        #[inline(always)]
        fn packed<T: Copy>(items: [T; 4], bits: u32) -> [T; 4] {
            const BYTES: [__m128i; 16] = bytes_of(PACKED);
            const { assert!(size_of::<T>() == 4) };
            // SAFETY: the processor has AVX2; four items are as large as a register for them, and what comes out are
            // whole items.
            unsafe {
                let items = std::mem::transmute_copy::<[T; 4], __m128i>(&items);
                let packed = _mm_shuffle_epi8(items, BYTES[bits as usize & 15]);
                std::mem::transmute_copy::<__m128i, [T; 4]>(&packed)
            }
        }
    }

    /// What brings the items of four bytes from the given places: the numbers of their bytes.
    const fn bytes_of<const N: usize>(places: [[usize; 4]; N]) -> [__m128i; N] {
        let mut bytes = [[0; 16]; N];
        let mut i = 0;
        while i < 16 * N {
            bytes[i / 16][i % 16] = (4 * places[i / 16][i % 16 / 4] + i % 4) as u8;
            i += 1;
        }
        // SAFETY: sixteen bytes are as large as a register for them.
        unsafe { std::mem::transmute_copy::<[[u8; 16]; N], [__m128i; N]>(&bytes) }
    }
}

/// [`lifted::further`] as fast as the processor can.
#[cold]
#[inline(never)]
pub(crate) fn further<const WEIGHTED: bool>(points: [&[f64; 4]; 5], determinant: f64) -> Sign {
    #[cfg(target_arch = "x86_64")]
    if Processor::detect() == Processor::Avx2 {
        // SAFETY: the processor has every feature that the function is compiled for; there is no other
        // condition.
        return unsafe { further_by_fma::<WEIGHTED>(points, determinant) };
    }
    lifted::further::<WEIGHTED, false>(points, determinant)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn further_by_fma<const WEIGHTED: bool>(points: [&[f64; 4]; 5], determinant: f64) -> Sign {
    lifted::further::<WEIGHTED, true>(points, determinant)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Coordinates of many sizes, also with few bits.
    fn points() -> impl Strategy<Value = [[f64; 4]; 5]> {
        let number = prop_oneof![
            (-100i32..100, -1.0..1.0f64).prop_map(|(e, x)| 2f64.powi(e) * x),
            -1.0..1.0f64,
            (-4i32..5).prop_map(f64::from),
        ];
        let point = [(); 4].map(|()| number.clone().boxed());
        [(); 5].map(|()| point.clone())
    }

    proptest! {
        #[test]
        fn the_processor_changes_no_bit(points in points()) {
            let rows = points.each_ref();
            // By instruction where there is one, else by a library: fused all the same.
            let (plain, fused) =
                (lifted::pairs::<false, false>(rows), lifted::pairs::<false, true>(rows));
            prop_assert_eq!(plain, fused);
            let (plain, fused) =
                (lifted::pairs::<true, false>(rows), lifted::pairs::<true, true>(rows));
            prop_assert_eq!(plain, fused);
            // From the stages after the first, too.
            let determinant = lifted::determinant::<true>(rows);
            prop_assert_eq!(
                further::<true>(rows, determinant),
                lifted::further::<true, false>(rows, determinant)
            );
        }
    }
}

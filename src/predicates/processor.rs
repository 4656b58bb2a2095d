//! What is compiled twice, for every processor and for those with AVX2 and fused multiply-adds, and
//! chosen at run time: the same values, sooner.
#![allow(unsafe_code)]

use super::lifted;

/// [`lifted::pairs`] as fast as the processor can.
#[inline(always)]
pub(super) fn pairs<const WEIGHTED: bool>(points: [&[f64; 4]; 5]) -> f64 {
    #[cfg(target_arch = "x86_64")]
    if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
        // SAFETY: the processor has every feature that the function is compiled for; there is no other
        // condition.
        return unsafe { pairs_by_fma::<WEIGHTED>(points) };
    }
    lifted::pairs::<WEIGHTED, false>(points)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn pairs_by_fma<const WEIGHTED: bool>(points: [&[f64; 4]; 5]) -> f64 {
    lifted::pairs::<WEIGHTED, true>(points)
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
            let expected = lifted::pairs::<false, false>(rows);
            prop_assert_eq!(pairs::<false>(rows), expected);
            let expected = lifted::pairs::<true, false>(rows);
            prop_assert_eq!(pairs::<true>(rows), expected);
        }
    }
}

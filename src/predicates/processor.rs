//! What is compiled twice, for every processor and for those with AVX2 and fused multiply-adds, and
//! chosen at run time: the same values, sooner.
#![allow(unsafe_code)]

use super::lifted;
use super::sign::Sign;

/// [`lifted::further`] as fast as the processor can.
#[cold]
#[inline(never)]
pub(super) fn further<const WEIGHTED: bool>(
    points: [&[f64; 4]; 5],
    determinant: f64,
    product: f64,
) -> Sign {
    #[cfg(target_arch = "x86_64")]
    if has_fma() {
        // SAFETY: the processor has every feature that the function is compiled for; there is no other
        // condition.
        return unsafe { further_by_fma::<WEIGHTED>(points, determinant, product) };
    }
    lifted::further::<WEIGHTED, false>(points, determinant, product)
}

#[cfg(target_arch = "x86_64")]
fn has_fma() -> bool {
    is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma")
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn further_by_fma<const WEIGHTED: bool>(
    points: [&[f64; 4]; 5],
    determinant: f64,
    product: f64,
) -> Sign {
    lifted::further::<WEIGHTED, true>(points, determinant, product)
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
            let (determinant, product) = lifted::floats::<true>(rows);
            prop_assert_eq!(
                further::<true>(rows, determinant, product),
                lifted::further::<true, false>(rows, determinant, product)
            );
        }
    }
}

//! What is compiled twice, for every processor and for those with AVX2 and fused multiply-adds: the same numbers,
//! sooner.
#![allow(unsafe_code)]

use super::center::{Centers, estimate as portable};
#[cfg(target_arch = "x86_64")]
use crate::predicates::processor::Processor;

/// The centres as far as arithmetic in pairs of floats tells, as fast as the processor can.
pub(super) fn estimate<const L: usize, const RADIUS: bool>(
    cells: &[[[f64; 3]; 4]; L],
    weights: Option<&[[f64; 4]; L]>,
    bases: &[[f64; 3]; L],
) -> Centers<L> {
    #[cfg(target_arch = "x86_64")]
    if Processor::detect() == Processor::Avx2 {
        // SAFETY: the processor has every feature that the function is compiled for; there is no other
        // condition.
        return unsafe { by_avx2::<L, RADIUS>(cells, weights, bases) };
    }
    portable::<L, RADIUS, false>(cells, weights, bases)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn by_avx2<const L: usize, const RADIUS: bool>(
    cells: &[[[f64; 3]; 4]; L],
    weights: Option<&[[f64; 4]; L]>,
    bases: &[[f64; 3]; L],
) -> Centers<L> {
    portable::<L, RADIUS, true>(cells, weights, bases)
}

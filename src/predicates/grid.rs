//! Points on a coarse grid, where floats calculate exactly.
//!
//! Lattices, quantised scans and CAD models are full of ties, which no bound on an error can
//! settle. But where all coordinates are multiples of some step, and few steps apart, a
//! determinant is a small integer times a power of the step.

use super::integer::width;

/// The finest step considered is 2^-190, so that its powers are normal numbers.
const FINEST: i32 = -190;

/// The exponent k of the finest step with `product` * 2^bits <= 2^(degree * k).
///
/// A determinant of that degree in coordinates that are multiples of 2^k is a multiple of
/// 2^(degree * k).
#[inline]
pub(super) fn step(product: f64, bits: i32, degree: i32) -> i32 {
    // The ceiling of the quotient. A coarser step is always right.
    width(product).map_or(FINEST, |width| -(-width - bits).div_euclid(degree)).max(FINEST)
}

/// Whether `x` is surely a multiple of 2^k; may be `false` for multiples above 2^(k + 52).
///
/// Adding 2^(52 + k) to |x| rounds to a multiple of 2^k, as all floats from there on are. If taking it away again leaves |x|, then
/// |x| is a difference of two such multiples: the subtraction is exact for |x| < 2^(53 + k), and
/// every float above is a multiple of 2^k. (The sum with a negative x may lie below 2^(52 + k), where floats are finer.)
#[inline]
pub(super) fn is_multiple(x: f64, k: i32) -> bool {
    let round = f64::from_bits(((1023 + 52 + k) as u64) << 52);
    (x.abs() + round) - round == x.abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn odd_halves_of_a_step_are_no_multiples_on_either_side_of_zero() {
        for k in [FINEST, -3, 0, 40] {
            let step = f64::from_bits(((1023 + k) as u64) << 52);
            for exponent in 0..54 {
                let size = f64::from_bits(((1023 + exponent) as u64) << 52);
                for (offset, sign) in
                    [(-1.5, 1.0), (-0.5, 1.0), (0.5, 1.0), (1.5, 1.0), (0.5, 0.75)]
                {
                    let x = step * (size * sign + offset);
                    let is_odd = (x / step).fract() != 0.0;
                    for x in [x, -x] {
                        assert!(!is_odd || !is_multiple(x, k), "{x:e} 2^{k}");
                    }
                }
                if exponent < 52 {
                    assert!(is_multiple(step * size, k) && is_multiple(-step * (size - 1.0), k));
                }
            }
        }
    }
}

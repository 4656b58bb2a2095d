//! The order of insertion: a biased randomised insertion order along the Hilbert curve.
//!
//! Amenta, Choi, Rote 2003, *Incremental constructions con BRIO*: every round inserts a random
//! share of the points, each about eight times the one before, in spatial order within the
//! round. The result does not depend on it, only the time does.

/// Bits of a vertex's random number that one round consumes: one in eight goes a round earlier.
const ROUND_BITS: u32 = 3;
/// The least number of points in the first round.
const FIRST_ROUND: usize = 1 << 10;

/// The number of rounds for this many vertices.
fn round_count(vertices: usize) -> u32 {
    let ratio = (vertices / FIRST_ROUND).max(1);
    ratio.ilog2() / ROUND_BITS + 1
}

/// The round of a vertex, counted from the last, which is 0.
fn rounds_before_last(vertex: u32, last: u32) -> u32 {
    (split_mix(u64::from(vertex)).trailing_zeros() / ROUND_BITS).min(last)
}

/// The random number of an index (Steele, Lea, Flood 2014, SplitMix64).
fn split_mix(index: u64) -> u64 {
    let mut z = index.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// Every vertex once, round by round, each round in spatial order. Costs no memory.
pub(super) fn insertion_order(vertices: usize) -> impl Iterator<Item = u32> {
    let last = round_count(vertices) - 1;
    (0..=last).rev().flat_map(move |round| {
        (0..vertices as u32).filter(move |&v| rounds_before_last(v, last) == round)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_vertex_comes_once_and_rounds_grow() {
        for n in [0, 1, 4, 1000, 100_000] {
            let mut order: Vec<u32> = insertion_order(n).collect();
            order.sort_unstable();
            assert_eq!(order, (0..n as u32).collect::<Vec<_>>());
        }
        let last = round_count(100_000) - 1;
        let mut sizes = vec![0usize; last as usize + 1];
        (0..100_000).for_each(|v| sizes[rounds_before_last(v, last) as usize] += 1);
        assert!(sizes.windows(2).all(|s| s[0] > 6 * s[1] && s[0] < 10 * s[1]), "{sizes:?}");
    }
}

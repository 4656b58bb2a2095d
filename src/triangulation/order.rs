//! The order of insertion: a biased randomised insertion order along the Hilbert curve.
//!
//! Amenta, Choi, Rote 2003, *Incremental constructions con BRIO*: every round inserts a random
//! share of the points, each about eight times the one before, in spatial order within the
//! round. The result does not depend on it, only the time does.

/// Bits of a vertex's random number that one round consumes: one in eight goes a round earlier.
const ROUND_BITS: u32 = 3;
/// The least number of points in the first round.
const FIRST_ROUND: usize = 1 << 10;

/// The rounds of insertion. They cost no memory.
#[derive(Clone, Copy)]
pub(super) struct Rounds {
    vertices: usize,
    /// The number of the first round; the last is round 0.
    first: u32,
}

impl Rounds {
    /// Rounds for this many vertices.
    pub fn new(vertices: usize) -> Self {
        let ratio = (vertices / FIRST_ROUND).max(1);
        Rounds { vertices, first: ratio.ilog2() / ROUND_BITS }
    }

    /// The rounds in the order of insertion.
    pub fn all(self) -> impl Iterator<Item = u32> {
        (0..=self.first).rev()
    }

    /// How many vertices a round has, about.
    pub fn expected_len(self, round: u32) -> usize {
        let before = self.vertices >> (ROUND_BITS * round);
        if round == self.first { before } else { before - (before >> ROUND_BITS) }
    }

    /// The vertices of a round, ascending, that is, in spatial order.
    pub fn vertices(self, round: u32) -> impl Iterator<Item = u32> + Send {
        (0..self.vertices as u32).filter(move |&v| self.round_of(v) == round)
    }

    fn round_of(self, vertex: u32) -> u32 {
        (split_mix(u64::from(vertex)).trailing_zeros() / ROUND_BITS).min(self.first)
    }
}

/// The random number of an index (Steele, Lea, Flood 2014, SplitMix64).
fn split_mix(index: u64) -> u64 {
    let mut z = index.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// Every vertex once, round by round, each round in spatial order.
pub(super) fn insertion_order(vertices: usize) -> impl Iterator<Item = u32> {
    let rounds = Rounds::new(vertices);
    rounds.all().flat_map(move |round| rounds.vertices(round))
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
        let rounds = Rounds::new(100_000);
        let sizes: Vec<usize> = rounds.all().map(|round| rounds.vertices(round).count()).collect();
        assert!(sizes.windows(2).all(|s| s[1] > 6 * s[0] && s[1] < 10 * s[0]), "{sizes:?}");
        for (round, &size) in rounds.all().zip(&sizes) {
            let expected = rounds.expected_len(round);
            assert!(size.abs_diff(expected) < expected / 8, "{round}: {size}, not {expected}");
        }
    }
}

//! The order of insertion: a biased randomised insertion order along the Hilbert curve.
//!
//! Amenta, Choi, Rote 2003, *Incremental constructions con BRIO*: every round inserts a random
//! share of the points, each about eight times the one before, in spatial order within the
//! round. The result does not depend on it, only the time does.
//!
//! Ours is as good as random: multiples of the golden ratio, modulo 1, are as evenly spread as can be, over any stretch of the curve
//! (Knuth, *The Art of Computer Programming* 3, 6.4). A round takes those that fall into an interval.

/// One in 2^3 vertices goes a round earlier.
const ROUND_BITS: u32 = 3;
/// The golden ratio, modulo 1, times 2^32.
const GOLDEN: u32 = 0x9e37_79b9;
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
        let end = u32::MAX.unbounded_shr(ROUND_BITS * round);
        let begin = if round == self.first { 0 } else { (end >> ROUND_BITS) + 1 };
        let width = end - begin;
        (0..self.vertices as u32)
            .filter(move |&v| v.wrapping_mul(GOLDEN).wrapping_sub(begin) <= width)
    }
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

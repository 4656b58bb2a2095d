//! The position of a grid cell along the Hilbert curve.
//!
//! Skilling 2004, *Programming the Hilbert curve*, transposes the axes level by level, from the coarsest bits to the finest.
//! What a level does to those below it is to exchange axes and to turn some round, and to turn the digits
//! round that come out: 96 states. So a table tells, for each state and the bits of two levels, the digits
//! and the next state.

/// Bits per axis of the grid; three times as many fit into a u64.
pub(super) const BITS: u32 = 21;

/// The number of states: six orders of the axes, each axis turned round or not, the digits too.
const STATES: usize = 6 * 8 * 2;
/// The bits of two levels.
const PAIRS: usize = 64;

/// The orders of three axes.
const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

/// What the levels above do to one: its axis i is axis `order[i]` of the grid, turned round if `turned[i]`; its digits are
/// turned round if `flipped`.
#[derive(Clone, Copy)]
struct State {
    order: [usize; 3],
    turned: [bool; 3],
    flipped: bool,
}

impl State {
    const fn of(number: usize) -> Self {
        let turned = [number & 1 != 0, number & 2 != 0, number & 4 != 0];
        State { order: ORDERS[number / 16], turned, flipped: number & 8 != 0 }
    }

    const fn number(self) -> usize {
        let mut order = 0;
        while ORDERS[order][0] != self.order[0] || ORDERS[order][1] != self.order[1] {
            order += 1;
        }
        let [a, b, c] = self.turned;
        16 * order + 8 * self.flipped as usize + 4 * c as usize + 2 * b as usize + a as usize
    }

    /// The digit of a level with the given bits, the first axis highest, and the state of the next level.
    const fn step(mut self, bits: usize) -> (usize, Self) {
        let mut axis = [false; 3];
        let mut i = 0;
        while i < 3 {
            axis[i] = (bits >> (2 - self.order[i]) & 1 != 0) != self.turned[i];
            i += 1;
        }
        let (order, turned) = (&mut self.order, &mut self.turned);
        i = 0;
        while i < 3 {
            if axis[i] {
                turned[0] = !turned[0];
            } else {
                (order[0], order[i]) = (order[i], order[0]);
                (turned[0], turned[i]) = (turned[i], turned[0]);
            }
            i += 1;
        }
        // The Gray code of the three.
        let second = axis[1] != axis[0];
        let third = axis[2] != second;
        let [a, b, c] = [axis[0] != self.flipped, second != self.flipped, third != self.flipped];
        self.flipped = self.flipped != third;
        (4 * a as usize + 2 * b as usize + c as usize, self)
    }
}

/// `TABLE[64 * state + bits]`: 64 times the next state, plus the digits, for the bits of two levels.
static TABLE: [u16; STATES * PAIRS] = {
    let mut table = [0; STATES * PAIRS];
    let mut entry = 0;
    while entry < table.len() {
        let (first, between) = State::of(entry / PAIRS).step(entry % PAIRS / 8);
        let (second, next) = between.step(entry % 8);
        table[entry] = (PAIRS * next.number() + 8 * first + second) as u16;
        entry += 1;
    }
    table
};

/// The position of a grid cell along the curve.
pub(super) fn hilbert([x, y, z]: [u32; 3]) -> u64 {
    let bits = spread(x) << 2 | spread(y) << 1 | spread(z);
    // The first of 22 levels is empty; its step from this state leads to the state without exchanges.
    let mut state = const { BEFORE_FIRST * PAIRS };
    let mut rank = 0;
    let mut shift = 3 * (BITS + 1);
    while shift > 0 {
        shift -= 6;
        let entry = TABLE[state + (bits >> shift) as usize % PAIRS];
        rank = (rank << 6) | (u64::from(entry) % PAIRS as u64);
        state = usize::from(entry) & !(PAIRS - 1);
    }
    rank
}

/// The state in which a level with no bits gives the digit 0, and leads to the state without exchanges.
const BEFORE_FIRST: usize = {
    let mut number = 0;
    loop {
        let (digit, next) = State::of(number).step(0);
        if digit == 0 && next.number() == 0 {
            break number;
        }
        number += 1;
    }
};

/// The bits of a number, two zeros between any two.
fn spread(x: u32) -> u64 {
    let mut x = u64::from(x);
    for (shift, mask) in [
        (32, 0x001f_0000_0000_ffff),
        (16, 0x001f_0000_ff00_00ff),
        (8, 0x100f_00f0_0f00_f00f),
        (4, 0x10c3_0c30_c30c_30c3),
        (2, 0x1249_2492_4924_9249),
    ] {
        x = (x | (x << shift)) & mask;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As Skilling writes it: the axes are transposed in place, then interleaved.
    fn skilling(mut axes: [u32; 3]) -> u64 {
        let top = 1u32 << (BITS - 1);
        let mut bit = top;
        while bit > 1 {
            let below = bit - 1;
            for i in 0..3 {
                if axes[i] & bit != 0 {
                    axes[0] ^= below;
                } else {
                    let swap = (axes[0] ^ axes[i]) & below;
                    axes[0] ^= swap;
                    axes[i] ^= swap;
                }
            }
            bit >>= 1;
        }
        axes[1] ^= axes[0];
        axes[2] ^= axes[1];
        let mut flip = 0;
        bit = top;
        while bit > 1 {
            if axes[2] & bit != 0 {
                flip ^= bit - 1;
            }
            bit >>= 1;
        }
        let [x, y, z] = axes.map(|axis| spread(axis ^ flip));
        x << 2 | y << 1 | z
    }

    #[test]
    fn the_table_does_what_skilling_writes() {
        let mut state = 1u64;
        for _ in 0..10_000 {
            let mut next = || {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                (state >> 40) as u32 % (1 << BITS)
            };
            let cell = [next(), next(), next()];
            assert_eq!(hilbert(cell), skilling(cell), "{cell:?}");
        }
    }

    #[test]
    fn neighbours_on_the_curve_are_neighbours_in_space() {
        // The first 4^3 steps of the curve fill a cube of side 4, one cell after the other.
        let mut cells: Vec<([u32; 3], u64)> = Vec::new();
        for x in 0..4 {
            for y in 0..4 {
                for z in 0..4 {
                    cells.push(([x, y, z], hilbert([x, y, z])));
                }
            }
        }
        cells.sort_by_key(|c| c.1);
        assert_eq!(cells.iter().map(|c| c.1).collect::<Vec<_>>(), (0..64).collect::<Vec<_>>());
        for pair in cells.windows(2) {
            let step: u32 = (0..3).map(|i| pair[0].0[i].abs_diff(pair[1].0[i])).sum();
            assert_eq!(step, 1, "{pair:?}");
        }
    }
}

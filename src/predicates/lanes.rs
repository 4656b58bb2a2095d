//! Four floats at once, for the filters that test a cell's four facets or neighbours together.

use std::array::from_fn;

/// Four floats, one for each slot of a cell.
///
/// Products with sums may be fused or not, as the processor likes: the error bounds of the filters
/// hold for both.
pub(crate) trait Lanes: Copy {
    /// Four truth values.
    type Mask: Copy;

    /// The given floats.
    fn of(x: [f64; 4]) -> Self;
    /// The same float four times.
    fn splat(x: f64) -> Self;
    /// The x, y and z of four positions.
    fn columns(rows: [&[f64; 3]; 4]) -> [Self; 3];
    /// The floats.
    fn array(self) -> [f64; 4];
    fn add(self, other: Self) -> Self;
    fn sub(self, other: Self) -> Self;
    fn mul(self, other: Self) -> Self;
    /// self * b + c.
    fn mul_add(self, b: Self, c: Self) -> Self;
    /// self * b - c.
    fn mul_sub(self, b: Self, c: Self) -> Self;
    fn abs(self) -> Self;
    /// The larger ones; no lane is a NaN.
    fn max(self, other: Self) -> Self;
    fn sqrt(self) -> Self;
    /// In lane i what was in lane i + `BY`, modulo 4.
    fn turned<const BY: usize>(self) -> Self;
    /// Lanes 1 and 3 with the other sign.
    fn alternated(self) -> Self;
    /// Where the indices are equal to one.
    fn equal(indices: [u32; 4], index: u32) -> Self::Mask;
    /// `yes` where the mask is true, else `no`.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// Bit i is set if lane i is greater than the other's.
    fn greater(self, other: Self) -> u32;
    /// The cell that a point makes with a facet of another cell, which lies on the other side of it: first the point, then the
    /// vertices but for the one in the slot. It has the other cell's orientation.
    fn cell_beyond(cell: [u32; 4], slot: u32, point: u32) -> [u32; 4];
    /// Those of four items of four bytes whose bits are set, in order; what follows them is any of the items.
    fn packed<T: Copy>(items: [T; 4], bits: u32) -> [T; 4];

    /// The largest of the four, four times.
    #[inline(always)]
    fn largest(self) -> Self {
        let pairs = self.max(self.turned::<2>());
        pairs.max(pairs.turned::<1>())
    }
}

/// The slots that [`Lanes::cell_beyond`] takes the vertices from; the first is replaced.
pub(super) const BEYOND: [[usize; 4]; 4] = [[0, 1, 3, 2], [0, 0, 2, 3], [0, 3, 1, 0], [0, 2, 0, 1]];

/// Where [`Lanes::packed`] takes the items from.
pub(super) const PACKED: [[usize; 4]; 16] = {
    let mut table = [[0; 4]; 16];
    let mut bits = 0;
    while bits < 16 {
        let (mut item, mut count) = (0, 0);
        while item < 4 {
            if bits >> item & 1 == 1 {
                table[bits][count] = item;
                count += 1;
            }
            item += 1;
        }
        bits += 1;
    }
    table
};

/// Lanes for any processor.
#[derive(Clone, Copy)]
pub(crate) struct Portable([f64; 4]);

impl Portable {
    #[inline(always)]
    fn zip(self, other: Self, of: impl Fn(f64, f64) -> f64) -> Self {
        Portable(from_fn(|i| of(self.0[i], other.0[i])))
    }
}

impl Lanes for Portable {
    type Mask = [bool; 4];

    #[inline(always)]
    fn of(x: [f64; 4]) -> Self {
        Portable(x)
    }

    #[inline(always)]
    fn splat(x: f64) -> Self {
        Portable([x; 4])
    }

    #[inline(always)]
    fn columns(rows: [&[f64; 3]; 4]) -> [Self; 3] {
        from_fn(|axis| Portable(from_fn(|i| rows[i][axis])))
    }

    #[inline(always)]
    fn array(self) -> [f64; 4] {
        self.0
    }

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, |a, b| a * b)
    }

    #[inline(always)]
    fn mul_add(self, b: Self, c: Self) -> Self {
        self.mul(b).add(c)
    }

    #[inline(always)]
    fn mul_sub(self, b: Self, c: Self) -> Self {
        self.mul(b).sub(c)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Portable(self.0.map(f64::abs))
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.zip(other, |a, b| if a > b { a } else { b })
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Portable(self.0.map(f64::sqrt))
    }

    #[inline(always)]
    fn turned<const BY: usize>(self) -> Self {
        Portable(from_fn(|i| self.0[(i + BY) % 4]))
    }

    #[inline(always)]
    fn alternated(self) -> Self {
        let [a, b, c, d] = self.0;
        Portable([a, -b, c, -d])
    }

    #[inline(always)]
    fn equal(indices: [u32; 4], index: u32) -> [bool; 4] {
        indices.map(|i| i == index)
    }

    #[inline(always)]
    fn select(mask: [bool; 4], yes: Self, no: Self) -> Self {
        Portable(from_fn(|i| if mask[i] { yes.0[i] } else { no.0[i] }))
    }

    #[inline(always)]
    fn greater(self, other: Self) -> u32 {
        (0..4).map(|i| u32::from(self.0[i] > other.0[i]) << i).sum()
    }

    #[inline(always)]
    fn cell_beyond(cell: [u32; 4], slot: u32, point: u32) -> [u32; 4] {
        let [_, b, c, d] = BEYOND[slot as usize & 3].map(|from| cell[from]);
        [point, b, c, d]
    }

    #[inline(always)]
    fn packed<T: Copy>(items: [T; 4], bits: u32) -> [T; 4] {
        PACKED[bits as usize & 15].map(|from| items[from])
    }
}

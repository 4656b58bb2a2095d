//! The determinants of all predicates in integer arithmetic: slow, simple, always right.
//!
//! Everything is scaled to integers first: coordinates to multiples of 2^unit, lifted values to
//! multiples of 2^lift_unit, so that the sign of the determinant does not change. Then the width
//! is chosen: W limbs of 64 bits for a difference, 2 W for a lifted value or a minor of two rows,
//! and so on. If differences are below 2^(64 W - 3) and lifted values below 2^(128 W - 3), then
//! everything fits with its sign: minors of two rows are below 2^(128 W - 5), of three below
//! 3 * 2^(192 W - 8), the lifted determinant below 3 * 2^(320 W - 9).

use super::integer::{Int, lowest_bit, width};
use super::sign::Sign;

/// Calls a function with the widths that a grid needs: the given ones for W = 1, or their
/// multiples.
///
/// W = 7 is enough within the ranges of [`super`], where coordinates are multiples of 2^-212 and
/// weights of 2^-372: [`Grid::of`] arrives at lifted values below 2^409 in multiples of 2^-424 at
/// least, and 409 + 424 <= 128 * 7 - 3.
macro_rules! with_width {
    ($grid:expr, $function:ident::<$($limbs:literal),*>($($argument:expr),*)) => {
        match $grid.limbs() {
            1 => $function::<$({ $limbs }),*>($($argument),*),
            2 => $function::<$({ 2 * $limbs }),*>($($argument),*),
            _ => $function::<$({ 7 * $limbs }),*>($($argument),*),
        }
    };
}

/// The grid on which the points of a predicate lie.
struct Grid {
    /// Coordinates are multiples of 2^unit.
    unit: i32,
    /// Squared coordinates and weights are multiples of 2^lift_unit.
    lift_unit: i32,
    /// Lifted values are below 2^lift_bits, as multiples of 2^lift_unit.
    lift_bits: i32,
}

impl Grid {
    /// The grid of points whose differences are taken from the last one. Without weights
    /// (`None`) they count as zero.
    fn of<const P: usize>(points: &[&[f64; 3]; P], weights: Option<&[f64; P]>) -> Grid {
        // |a - b| <= fl(|a - b|) (1 + 2^-53) < 2^(width + 1).
        let widest = |differences: &mut dyn Iterator<Item = f64>| {
            differences.filter_map(width).max().map(|k| k + 1)
        };
        let last = points[P - 1];
        let unit = points.iter().flat_map(|p| p.iter()).filter_map(|&x| lowest_bit(x)).min();
        let unit = unit.unwrap_or(0);
        let width = widest(&mut points.iter().flat_map(|p| (0..3).map(|i| p[i] - last[i])));
        let width = width.unwrap_or(unit);
        let (mut lift_unit, mut lift_width) = (2 * unit, 2 * width + 2);
        if let Some(weights) = weights {
            lift_unit = weights.iter().filter_map(|&w| lowest_bit(w)).fold(lift_unit, i32::min);
            let width = widest(&mut weights.iter().map(|w| w - weights[P - 1]));
            lift_width = width.map_or(lift_width, |k| k.max(lift_width)) + 1;
        }
        Grid { unit, lift_unit, lift_bits: lift_width - lift_unit }
    }

    /// W. Only lifted values need a look: they have two bits more than the squares of differences,
    /// so that these are below 2^(64 W - 3) where lifted values are below 2^(128 W - 3).
    fn limbs(&self) -> usize {
        match self.lift_bits {
            ..=125 => 1,
            126..=253 => 2,
            _ => 7,
        }
    }

    /// `p - origin` in multiples of 2^unit.
    fn difference<const N: usize>(&self, p: &[f64; 3], origin: &[f64; 3]) -> [Int<N>; 3] {
        std::array::from_fn(|i| Int::of(p[i], self.unit) - Int::of(origin[i], self.unit))
    }

    /// The lifted values |d|^2 - (w - w') in multiples of 2^lift_unit, for the differences `d`
    /// from the last point, whose weight w' is the last.
    fn lift<const N: usize, const N2: usize>(
        &self,
        rows: &[[Int<N>; 3]; 4],
        weights: Option<&[f64; 5]>,
    ) -> [Int<N2>; 4] {
        std::array::from_fn(|i| {
            let [x, y, z] = rows[i];
            let square: Int<N2> = x.times(x) + y.times(y) + z.times(z);
            let square = square.shifted(2 * self.unit - self.lift_unit);
            let weight = |w: f64| Int::of(w, self.lift_unit);
            weights.map_or(square, |w| square - (weight(w[i]) - weight(w[4])))
        })
    }
}

/// The determinant of the first two columns of two rows.
fn minor<const N: usize, const N2: usize>(a: [Int<N>; 3], b: [Int<N>; 3]) -> Int<N2> {
    a[0].times(b[1]) - a[1].times(b[0])
}

/// The determinant of three rows.
fn three<const N: usize, const N2: usize, const N3: usize>(
    a: [Int<N>; 3],
    b: [Int<N>; 3],
    c: [Int<N>; 3],
) -> Int<N3> {
    minor::<N, N2>(a, b).times(c[2]) - minor::<N, N2>(a, c).times(b[2])
        + minor::<N, N2>(b, c).times(a[2])
}

/// The sign of the determinant of the rows (p - e, |p - e|^2 - (w_p - w_e)) for the points p = a,
/// b, c, d.
#[cold]
pub(super) fn lifted_space(points: [&[f64; 3]; 5], weights: Option<&[f64; 5]>) -> Sign {
    fn sign<const W: usize, const W2: usize, const W3: usize, const W5: usize>(
        [a, b, c, d, e]: [&[f64; 3]; 5],
        weights: Option<&[f64; 5]>,
        grid: &Grid,
    ) -> Sign {
        let rows = [a, b, c, d].map(|p| grid.difference::<W>(p, e));
        let lifts = grid.lift::<W, W2>(&rows, weights);
        let cofactor = |i: usize, j: usize, k: usize, l: usize| -> Int<W5> {
            three::<W, W2, W3>(rows[i], rows[j], rows[k]).times(lifts[l])
        };
        let sum = cofactor(0, 1, 2, 3) - cofactor(0, 1, 3, 2) + cofactor(0, 2, 3, 1);
        (sum - cofactor(1, 2, 3, 0)).sign()
    }
    let grid = Grid::of(&points, weights);
    with_width!(grid, sign::<1, 2, 3, 5>(points, weights, &grid))
}

/// The sign of the determinant of the rows b - a, c - a, d - a.
#[cold]
pub(super) fn volume([a, b, c, d]: [&[f64; 3]; 4]) -> Sign {
    fn sign<const W: usize, const W2: usize, const W3: usize>(
        [b, c, d, a]: [&[f64; 3]; 4],
        grid: &Grid,
    ) -> Sign {
        let row = |p| grid.difference::<W>(p, a);
        three::<W, W2, W3>(row(b), row(c), row(d)).sign()
    }
    let points = [b, c, d, a];
    let grid = Grid::of(&points, None);
    with_width!(grid, sign::<1, 2, 3>(points, &grid))
}

/// The sign of the determinant of the rows b - a, c - a, projected on the two given axes.
#[cold]
pub(super) fn area(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3], axes: [usize; 2]) -> Sign {
    fn sign<const W: usize, const W2: usize>(
        [b, c, a]: [&[f64; 3]; 3],
        [i, j]: [usize; 2],
        grid: &Grid,
    ) -> Sign {
        let [b, c] = [b, c].map(|p| {
            let d = grid.difference::<W>(p, a);
            [d[i], d[j], d[3 - i - j]]
        });
        minor::<W, W2>(b, c).sign()
    }
    let points = [b, c, a];
    let grid = Grid::of(&points, None);
    with_width!(grid, sign::<1, 2>(points, axes, &grid))
}

/// The cross product.
fn cross<const N: usize, const N2: usize>(a: [Int<N>; 3], b: [Int<N>; 3]) -> [Int<N2>; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i].times(b[j]) - a[j].times(b[i]))
}

/// The scalar product.
fn dot<const N: usize, const M: usize, const R: usize>(a: [Int<N>; 3], b: [Int<M>; 3]) -> Int<R> {
    a[0].times(b[0]) + a[1].times(b[1]) + a[2].times(b[2])
}

/// The sign of (p - r) . (q - r).
#[cold]
pub(super) fn edge_side(points: [&[f64; 3]; 3]) -> Sign {
    fn sign<const W: usize, const W2: usize>([p, q, r]: [&[f64; 3]; 3], grid: &Grid) -> Sign {
        let row = |p| grid.difference::<W>(p, r);
        dot::<W, W, W2>(row(p), row(q)).sign()
    }
    let grid = Grid::of(&points, None);
    with_width!(grid, sign::<1, 2>(points, &grid))
}

/// The sign of (u . a) |b|^2 - (u . b) |a|^2 for u = x - p, a = q - p, b = r - p.
#[cold]
pub(super) fn exit_side(points: [&[f64; 3]; 4]) -> Sign {
    fn sign<const W: usize, const W2: usize, const W4: usize>(
        [x, q, r, p]: [&[f64; 3]; 4],
        grid: &Grid,
    ) -> Sign {
        let [u, a, b] = [x, q, r].map(|x| grid.difference::<W>(x, p));
        let [ua, ub, aa, bb] = [(u, a), (u, b), (a, a), (b, b)].map(|(v, w)| dot::<W, W, W2>(v, w));
        (ua.times::<W2, W4>(bb) - ub.times(aa)).sign()
    }
    let grid = Grid::of(&points, None);
    with_width!(grid, sign::<1, 2, 4>(points, &grid))
}

/// The sign of N . (|d|^2 a x b + |a|^2 b x d + |b|^2 d x a) with N = a x b, for a = q - p, b = r - p, d = s - p: the product of
/// |N|^2 and the power of s to the smallest sphere through p, q, r.
#[cold]
pub(super) fn triangle_side(points: [&[f64; 3]; 4]) -> Sign {
    fn sign<const W: usize, const W2: usize, const W4: usize, const W6: usize>(
        [q, r, s, p]: [&[f64; 3]; 4],
        grid: &Grid,
    ) -> Sign {
        let [a, b, d] = [q, r, s].map(|x| grid.difference::<W>(x, p));
        let [aa, bb, dd] = [a, b, d].map(|v| dot::<W, W, W2>(v, v));
        let normal = cross::<W, W2>(a, b);
        let (bd, da) = (cross::<W, W2>(b, d), cross::<W, W2>(d, a));
        let sum: [Int<W4>; 3] = std::array::from_fn(|k| {
            dd.times::<W2, W4>(normal[k]) + aa.times(bd[k]) + bb.times(da[k])
        });
        dot::<W2, W4, W6>(normal, sum).sign()
    }
    let [p, q, r, s] = points;
    let points = [q, r, s, p];
    let grid = Grid::of(&points, None);
    with_width!(grid, sign::<1, 2, 4, 6>(points, &grid))
}

/// The sign of the determinant of q - s, r - s, (q - p) x (r - p): positive where the foot of s in the plane of p, q, r lies on the same side of
/// the line q r as p.
#[cold]
pub(super) fn foot_side(points: [&[f64; 3]; 4]) -> Sign {
    fn sign<const W: usize, const W2: usize, const W4: usize>(
        [p, q, r, s]: [&[f64; 3]; 4],
        grid: &Grid,
    ) -> Sign {
        let row = |x, y| grid.difference::<W>(x, y);
        let normal = cross::<W, W2>(row(q, p), row(r, p));
        dot::<W2, W2, W4>(cross::<W, W2>(row(q, s), row(r, s)), normal).sign()
    }
    let grid = Grid::of(&points, None);
    with_width!(grid, sign::<1, 2, 4>(points, &grid))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a power crust rounds its poles to: 2^36 steps are the side of the sample's box, or up to twice
    /// that, and poles lie within some ten boxes.
    #[test]
    fn one_limb_holds_differences_of_rounded_poles() {
        let unit = 2f64.powi(-36);
        let limbs = |size: f64| {
            let corner =
                |i: i32| [i & 1, i >> 1 & 1, i >> 2].map(|bit| f64::from(bit) * size + unit);
            let points = [0, 1, 2, 4, 7].map(corner);
            // The least weight not 0, and the most: the square of the diagonal.
            let weights = [unit * unit, 3.0 * size * size, 0.0, size * size, unit * unit];
            Grid::of(&points.each_ref(), Some(&weights)).limbs()
        };
        assert_eq!(limbs(16.0), 1);
        assert_eq!(limbs(2f64.powi(23)), 1);
        assert_eq!(limbs(2f64.powi(25)), 2);
    }
}

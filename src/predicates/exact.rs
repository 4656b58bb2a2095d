//! The determinants of all predicates in integer arithmetic: slow, simple, always right.
//!
//! Everything is scaled to integers first: coordinates to multiples of 2^unit, lifted values to
//! multiples of 2^lift_unit, so that the sign of the determinant does not change. Then the widest
//! value that can occur is bounded, and the determinant is calculated in integers that hold it.

use super::integer::{Int, lowest_bit, width};
use super::sign::Sign;

/// Widths in limbs of 64 bits. The last is enough for every input within the ranges of
/// [`super`]: coordinates are multiples of 2^-212 below 2^200, so differences have at most 413
/// bits; lifted values are multiples of 2^-424 below 2^405, so at most 829 bits; their 24
/// products have 5 bits more, and one is for the sign: 3 * 413 + 829 + 5 + 1 = 2074 <= 64 * 33.
macro_rules! with_width {
    ($bits:expr, $function:ident($($argument:expr),*)) => {
        match $bits {
            ..=256 => $function::<4>($($argument),*),
            257..=512 => $function::<8>($($argument),*),
            _ => $function::<33>($($argument),*),
        }
    };
}

/// The grid on which the points of a predicate lie.
struct Grid {
    /// Coordinates are multiples of 2^unit.
    unit: i32,
    /// Squared coordinates and weights are multiples of 2^lift_unit.
    lift_unit: i32,
    /// Differences of coordinates are below 2^bits, as multiples of 2^unit.
    bits: i32,
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
        Grid { unit, lift_unit, bits: width - unit, lift_bits: lift_width - lift_unit }
    }

    /// `p - origin` in multiples of 2^unit.
    fn difference<const N: usize>(&self, p: &[f64; 3], origin: &[f64; 3]) -> [Int<N>; 3] {
        std::array::from_fn(|i| Int::of(p[i], self.unit) - Int::of(origin[i], self.unit))
    }

    /// The lifted values |d|^2 - (w - w') in multiples of 2^lift_unit, for the differences `d`
    /// from the last point, whose weight w' is the last.
    fn lift<const N: usize, const R: usize, const P: usize>(
        &self,
        rows: &[[Int<N>; 3]; R],
        weights: Option<&[f64; P]>,
    ) -> [Int<N>; R] {
        std::array::from_fn(|i| {
            let [x, y, z] = rows[i];
            let square = (x * x + y * y + z * z).shifted(2 * self.unit - self.lift_unit);
            let weight = |w: &[f64; P], i: usize| Int::of(w[i], self.lift_unit);
            weights.map_or(square, |w| square - (weight(w, i) - weight(w, P - 1)))
        })
    }
}

/// The determinant of two rows.
fn det2<const N: usize>(a: [Int<N>; 2], b: [Int<N>; 2]) -> Int<N> {
    a[0] * b[1] - a[1] * b[0]
}

/// The determinant of three rows.
fn det3<const N: usize>(a: [Int<N>; 3], b: [Int<N>; 3], c: [Int<N>; 3]) -> Int<N> {
    let minor = |p: [Int<N>; 3], q: [Int<N>; 3]| det2([p[0], p[1]], [q[0], q[1]]);
    minor(a, b) * c[2] - minor(a, c) * b[2] + minor(b, c) * a[2]
}

/// The sign of the determinant of the rows (p - e, |p - e|^2 - (w_p - w_e)) for the points p = a,
/// b, c, d.
#[cold]
pub(super) fn lifted_space(points: [&[f64; 3]; 5], weights: Option<&[f64; 5]>) -> Sign {
    fn sign<const N: usize>(
        [a, b, c, d, e]: [&[f64; 3]; 5],
        weights: Option<&[f64; 5]>,
        grid: &Grid,
    ) -> Sign {
        let rows = [a, b, c, d].map(|p| grid.difference::<N>(p, e));
        let [la, lb, lc, ld] = grid.lift(&rows, weights);
        let [a, b, c, d] = rows;
        let determinant =
            det3(a, b, c) * ld - det3(a, b, d) * lc + det3(a, c, d) * lb - det3(b, c, d) * la;
        determinant.sign()
    }
    let grid = Grid::of(&points, weights);
    with_width!(3 * grid.bits + grid.lift_bits + 6, sign(points, weights, &grid))
}

/// The sign of the determinant of the rows (p - e, |p - e|^2 - (w_p - w_e)) for the points p = a,
/// b, c, with p - e projected along the given axis, but its length taken in space.
#[cold]
pub(super) fn lifted_plane(
    points: [&[f64; 3]; 4],
    weights: Option<&[f64; 4]>,
    along: usize,
) -> Sign {
    fn sign<const N: usize>(
        [a, b, c, e]: [&[f64; 3]; 4],
        weights: Option<&[f64; 4]>,
        along: usize,
        grid: &Grid,
    ) -> Sign {
        let mut rows = [a, b, c].map(|p| grid.difference::<N>(p, e));
        let lifts = grid.lift(&rows, weights);
        for (row, lift) in rows.iter_mut().zip(lifts) {
            *row = [row[(along + 1) % 3], row[(along + 2) % 3], lift];
        }
        det3(rows[0], rows[1], rows[2]).sign()
    }
    let grid = Grid::of(&points, weights);
    with_width!(2 * grid.bits + grid.lift_bits + 4, sign(points, weights, along, &grid))
}

/// The sign of the determinant of the rows b - a, c - a, d - a.
#[cold]
pub(super) fn volume(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3], d: &[f64; 3]) -> Sign {
    fn sign<const N: usize>([b, c, d, a]: [&[f64; 3]; 4], grid: &Grid) -> Sign {
        let row = |p| grid.difference::<N>(p, a);
        det3(row(b), row(c), row(d)).sign()
    }
    let points = [b, c, d, a];
    let grid = Grid::of(&points, None);
    with_width!(3 * grid.bits + 4, sign(points, &grid))
}

/// The sign of the determinant of the rows b - a, c - a, projected on the two given axes.
#[cold]
pub(super) fn area(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3], axes: [usize; 2]) -> Sign {
    fn sign<const N: usize>([b, c, a]: [&[f64; 3]; 3], axes: [usize; 2], grid: &Grid) -> Sign {
        let row = |p| {
            let d = grid.difference::<N>(p, a);
            axes.map(|axis| d[axis])
        };
        det2(row(b), row(c)).sign()
    }
    let points = [b, c, a];
    let grid = Grid::of(&points, None);
    with_width!(2 * grid.bits + 2, sign(points, axes, &grid))
}

/// The sign of (a - b) . (c - b), for coordinates below 2^400: 2 * 613 + 3 <= 64 * 33 bits.
#[cold]
pub(super) fn scalar(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3]) -> Sign {
    fn sign<const N: usize>([a, c, b]: [&[f64; 3]; 3], grid: &Grid) -> Sign {
        let [p, q] = [a, c].map(|p| grid.difference::<N>(p, b));
        (p[0] * q[0] + p[1] * q[1] + p[2] * q[2]).sign()
    }
    let points = [a, c, b];
    let grid = Grid::of(&points, None);
    with_width!(2 * grid.bits + 3, sign(points, &grid))
}

//! Ties: conflicts under a symbolic perturbation.
//!
//! Sort all points lexicographically by x, y, z. The lifted coordinate of the k-th of n grows by
//! eps^(n - k + 1): each by infinitely more than any before it, as eps goes to 0. No tie is left,
//! and the order depends on nothing but coordinates, so the answer is a function of the set of
//! points (Devillers, Teillaud 2011; CGAL's triangulations use the same scheme and order).
//!
//! In the lifted determinant of a cell and e, the largest of the five points has the leading
//! monomial. Its coefficient is the orientation of the four others: for e that of the cell, so
//! that e is lifted out of the sphere; for a vertex of the cell that of the cell with e in the
//! vertex's place. The first that is not zero decides.

use super::around::Site;
use super::orient::orient3d;
use super::sign::Sign;
use super::stages::{self, Stage};
use super::{lifted, position, processor};

/// Whether e is in conflict with the positively oriented Delaunay cell abcd: inside its sphere,
/// ties broken by the perturbation.
///
/// The five points are distinct; their fourth entries are ignored. CGAL decides the same in
/// `Delaunay_triangulation_3`.
#[inline]
pub fn delaunay_conflict(
    a: &[f64; 4],
    b: &[f64; 4],
    c: &[f64; 4],
    d: &[f64; 4],
    e: &[f64; 4],
) -> bool {
    match lifted::conflict::<false>([a, b, c, d, e]) {
        Sign::Zero => perturbed([a, b, c, d], e),
        sign => sign.is_positive(),
    }
}

/// Whether the weighted point e is in conflict with the positively oriented regular cell abcd:
/// [`power_test`](super::power_test) positive, ties broken by the perturbation.
///
/// The five positions are distinct. CGAL decides the same in `Regular_triangulation_3`.
#[inline]
pub fn regular_conflict(
    a: &[f64; 4],
    b: &[f64; 4],
    c: &[f64; 4],
    d: &[f64; 4],
    e: &[f64; 4],
) -> bool {
    match lifted::conflict::<true>([a, b, c, d, e]) {
        Sign::Zero => perturbed([a, b, c, d], e),
        sign => sign.is_positive(),
    }
}

/// Whether a point is in conflict with a positively oriented cell, ties broken by the perturbation.
pub(crate) fn in_conflict<S: Site>(cell: [&S; 4], e: &S) -> bool {
    let ([a, b, c, d], e) = (cell.map(S::row), e.row());
    match S::WEIGHTED {
        true => regular_conflict(&a, &b, &c, &d, &e),
        false => delaunay_conflict(&a, &b, &c, &d, &e),
    }
}

/// [`in_conflict`] where a filter could not tell: from its lifted determinant, as in [`lifted`].
#[cold]
pub(crate) fn settle<S: Site>(cell: [&S; 4], e: &S, determinant: f64) -> bool {
    let ([a, b, c, d], e) = (cell.map(S::row), e.row());
    let points = [&a, &b, &c, &d, &e];
    let sign = match S::WEIGHTED {
        true => processor::further::<true>(points, determinant),
        false => processor::further::<false>(points, determinant),
    };
    match sign {
        Sign::Zero => perturbed([&a, &b, &c, &d], &e),
        sign => sign.is_positive(),
    }
}

/// The perturbed answer for a tie: from the lexicographically largest point down, `false` at e,
/// and at a vertex whether the cell with e in its place is positively oriented, unless it is flat.
#[cold]
fn perturbed(cell: [&[f64; 4]; 4], e: &[f64; 4]) -> bool {
    stages::count(Stage::Perturbed);
    let (cell, e) = (cell.map(position), position(e));
    let mut left =
        [greater(cell[0], e), greater(cell[1], e), greater(cell[2], e), greater(cell[3], e)];
    loop {
        // The largest vertex that is left; 4 stands for e.
        let mut largest = 4;
        for i in 0..4 {
            if left[i] && (largest == 4 || greater(cell[i], cell[largest])) {
                largest = i;
            }
        }
        if largest == 4 {
            return false;
        }
        let mut replaced = cell;
        replaced[largest] = e;
        let [a, b, c, d] = replaced;
        match orient3d(a, b, c, d) {
            Sign::Zero => left[largest] = false,
            sign => return sign.is_positive(),
        }
    }
}

/// Whether a position comes after another in the order by x, then y, then z. Without branches: on lattices
/// nothing foretells them.
#[inline(always)]
fn greater(p: &[f64; 3], q: &[f64; 3]) -> bool {
    let order = |i: usize| i32::from(p[i] > q[i]) - i32::from(p[i] < q[i]);
    4 * order(0) + 2 * order(1) + order(2) > 0
}

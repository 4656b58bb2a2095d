//! Ties: conflicts under a symbolic perturbation.
//!
//! Sort all points lexicographically by x, y, z. The lifted coordinate of the k-th of n grows by
//! eps^(n - k): each by infinitely more than any before it, as eps goes to 0. No tie is left, and the
//! order depends on nothing but coordinates, so the answer is a function of the set of points
//! (Devillers and Teillaud 2011, section 3; CGAL's triangulations use the same scheme and order).
//!
//! In the lifted determinant of a cell and e, the largest of the five points has the leading
//! monomial. Its coefficient is the orientation of the four others: for e that of the cell, so
//! that e is lifted out of the sphere; for a vertex of the cell that of the cell with e in
//! the vertex's place. The first that is not zero decides.

use super::orient::{coplanar_orientation, orient3d};
use super::sign::Sign;
use super::stages::{self, Stage};
use super::{circle, lifted, position};
use std::cmp::Ordering;

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
        Sign::Zero => perturbed_space([a, b, c, d], e),
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
        Sign::Zero => perturbed_space([a, b, c, d], e),
        sign => sign.is_positive(),
    }
}

/// Whether e, in the plane of the hull facet abc, is in conflict with the infinite cell on it:
/// inside the circle through a, b, c, ties broken by the perturbation.
///
/// The four points are distinct and coplanar, a, b, c not collinear, in either order; their fourth entries are
/// ignored.
pub fn delaunay_conflict_in_plane(a: &[f64; 4], b: &[f64; 4], c: &[f64; 4], e: &[f64; 4]) -> bool {
    match circle::conflict::<false>([a, b, c, e]) {
        Sign::Zero => perturbed_plane([a, b, c], e),
        sign => sign.is_positive(),
    }
}

/// Whether the weighted point e, in the plane of the hull facet abc, is in conflict with the
/// infinite cell on it: inside the power circle of a, b, c, ties broken by the perturbation.
///
/// The four positions are distinct and coplanar, a, b, c not collinear, in either order.
pub fn regular_conflict_in_plane(a: &[f64; 4], b: &[f64; 4], c: &[f64; 4], e: &[f64; 4]) -> bool {
    match circle::conflict::<true>([a, b, c, e]) {
        Sign::Zero => perturbed_plane([a, b, c], e),
        sign => sign.is_positive(),
    }
}

/// The perturbed answer for a tie of five points.
#[cold]
fn perturbed_space(cell: [&[f64; 4]; 4], e: &[f64; 4]) -> bool {
    let cell = cell.map(position);
    first_decided(cell, position(e), |[a, b, c, d]| orient3d(a, b, c, d))
}

/// The perturbed answer for a tie of four coplanar points.
#[cold]
fn perturbed_plane(facet: [&[f64; 4]; 3], e: &[f64; 4]) -> bool {
    let facet = facet.map(position);
    let [a, b, c] = facet;
    let turn = coplanar_orientation(a, b, c);
    first_decided(facet, position(e), |[a, b, c]| turn * coplanar_orientation(a, b, c))
}

/// Goes through the vertices and e from the lexicographically largest down: `false` at e, and at
/// a vertex whether the orientation with e in its place is positive, unless that is zero.
fn first_decided<'a, const V: usize>(
    vertices: [&'a [f64; 3]; V],
    e: &'a [f64; 3],
    orientation: impl Fn([&'a [f64; 3]; V]) -> Sign,
) -> bool {
    stages::count(Stage::Perturbed);
    let mut left = [true; V];
    loop {
        let vertices_left = (0..V).filter(|&i| left[i]);
        let largest = vertices_left.max_by(|&i, &j| lexicographic(vertices[i], vertices[j]));
        let Some(i) = largest.filter(|&i| lexicographic(vertices[i], e).is_gt()) else {
            return false;
        };
        let mut replaced = vertices;
        replaced[i] = e;
        match orientation(replaced) {
            Sign::Zero => left[i] = false,
            sign => return sign.is_positive(),
        }
    }
}

/// The order of positions by x, then y, then z. Finite coordinates are always comparable.
fn lexicographic(p: &[f64; 3], q: &[f64; 3]) -> Ordering {
    p.partial_cmp(q).unwrap_or(Ordering::Equal)
}

//! Filters that test the four neighbours of a cell, or its four facets, together.
//!
//! Let the rows r_i = (x, y, z, l) be those of [`super::lifted`] for the vertices of a cell, with
//! differences from the point e, and q_i the row of the vertex that the neighbour across facet i has
//! opposite to it. In the neighbour q_i stands in place of r_i; as it lies on the other side of the
//! facet, that turns the orientation round, so e is in conflict with the neighbour exactly when the
//! determinant of the rows with q_i in place of r_i is *positive*. Expanded by the row q_i it is
//!
//! ```text
//! (-1)^i (q.x det(y z l) - q.y det(x z l) + q.z det(x y l) - q.l det(x y z))
//! ```
//!
//! with determinants of the columns of r_(i+1), r_(i+2), r_(i+3), since turning four rows by one
//! place is an odd permutation. The minors of two rows in x, y and in z, l are shared by all four
//! neighbours; each lane does the rest for one.
//!
//! The vertex at infinity has the row (0, 0, 0, l) for any positive l: a point that moves away to
//! infinity is lifted infinitely more than it moves. The determinants of infinite cells are then
//! l times orientations, positive exactly beyond the hull facet.
//!
//! # Bounds
//!
//! As in [`super::lifted`], every monomial goes through 17 roundings at most: 5 of differences, 4 of
//! the square and its sums, 2 of a minor, 1 + 2 of the product with a third entry and two sums, 1
//! of the product with the fourth, and 2 of the sums of four. (Where q.l is the square, it goes
//! through them where the minor of z, l would.) Fused operations round less often. So the bound is
//! 408 u X Y Z M here too, with the maxima over all rows in the lane's determinant; we take them over
//! all of the cell's rows and q_i. Without weights, with S the largest x^2 + y^2 + z^2 = M, X Y Z is at most S^(3/2); that is
//! looser, but takes fewer steps. They round 9 times at most (4 for S^(3/2) by the square, 4 by M, and 1): that is covered as in
//! [`super::lifted`]. Poles lie on sheets, where it would leave too much open.
//! The l of the vertex at infinity is the M of some other row, and
//! not rounded. In the orientations, 8 roundings and 6 terms make 48 u X Y Z, as in [`super::orient`].

use super::lanes::Lanes;
use super::lifted::{MAXIMUM_BOUND, TINY};
use super::orient::ORIENT_BOUND;

/// A point of a triangulation, with or without a weight.
pub(crate) trait Site: Copy + Sync {
    /// Whether it has a weight.
    const WEIGHTED: bool;
    fn position(&self) -> &[f64; 3];
    /// The weight, 0 without one.
    fn weight(&self) -> f64;

    /// The position and the weight in one row.
    #[inline(always)]
    fn row(&self) -> [f64; 4] {
        let &[x, y, z] = self.position();
        [x, y, z, self.weight()]
    }
}

impl Site for [f64; 3] {
    const WEIGHTED: bool = false;

    #[inline(always)]
    fn position(&self) -> &[f64; 3] {
        self
    }

    #[inline(always)]
    fn weight(&self) -> f64 {
        0.0
    }
}

impl Site for [f64; 4] {
    const WEIGHTED: bool = true;

    #[inline(always)]
    fn position(&self) -> &[f64; 3] {
        super::position(self)
    }

    #[inline(always)]
    fn weight(&self) -> f64 {
        self[3]
    }
}

/// What the filter found of four neighbours; bit i and entry i are those of the neighbour across
/// facet i.
#[derive(Clone, Copy)]
pub(crate) struct Neighbors {
    /// In conflict, if the bit is not in `unsure`.
    pub conflict: u32,
    /// The filter cannot tell.
    pub unsure: u32,
    /// The determinants above: positive for a conflict.
    pub determinants: [f64; 4],
}

/// Tests whether a point is in conflict with the neighbours of a positively oriented cell.
///
/// `infinite` tells which vertex is at infinity, first of the cell, then of those opposite; in place of it
/// stands the point itself.
#[inline(always)]
pub(crate) fn neighbors_in_conflict<L: Lanes, S: Site>(
    cell: [&S; 4],
    opposite: [&S; 4],
    infinite: [L::Mask; 2],
    point: &S,
) -> Neighbors {
    let [x, y, z] = differences::<L, S>(cell, point);
    let [qx, qy, qz] = differences::<L, S>(opposite, point);
    let [s, l, m] = lifts(cell, [x, y, z], point);
    let [qs, ql, qm] = lifts(opposite, [qx, qy, qz], point);
    // At most one vertex of a cell is at infinity, so two lanes further there is a finite one.
    let finite = m.turned::<2>();
    let (l, m) = (L::select(infinite[0], finite, l), L::select(infinite[0], finite, m));
    let (ql, qm) = (L::select(infinite[1], m, ql), L::select(infinite[1], m, qm));

    let product = if S::WEIGHTED {
        let xy = x.abs().largest().max(qx.abs()).mul(y.abs().largest().max(qy.abs()));
        xy.mul(z.abs().largest().max(qz.abs()).mul(m.largest().max(qm)))
    } else {
        let s = s.largest().max(qs);
        s.mul(s.sqrt()).mul(s)
    };
    let bound = product.mul_add(L::splat(MAXIMUM_BOUND), L::splat(TINY));

    let (next_xy, second_xy) = minors(x, y);
    let (next_zl, second_zl) = minors(z, l);
    let of_x = three(y, next_zl, second_zl);
    let of_y = three(x, next_zl, second_zl);
    let of_z = three(l, next_xy, second_xy);
    let of_l = three(z, next_xy, second_xy);
    let determinant = qx.mul_sub(of_x, qy.mul(of_y)).add(qz.mul_sub(of_z, ql.mul(of_l)));
    let determinant = determinant.alternated();
    Neighbors {
        conflict: determinant.greater(bound),
        unsure: !determinant.abs().greater(bound) & 15,
        determinants: determinant.array(),
    }
}

/// Tests beyond which facets of a positively oriented finite cell a point lies: the bits of those
/// where it surely does, and of those where the filter cannot tell.
#[inline(always)]
pub(crate) fn beyond_facets<L: Lanes, S: Site>(cell: [&S; 4], point: &S) -> (u32, u32) {
    let [x, y, z] = differences::<L, S>(cell, point);
    let product = x.abs().largest().mul(y.abs().largest()).mul(z.abs().largest());
    let bound = product.mul(L::splat(ORIENT_BOUND));
    let (next_xy, second_xy) = minors(x, y);
    // The determinant of a conflict with the vertex at infinity across the facet, but for its sign.
    let inside = three(z, next_xy, second_xy).alternated();
    let unsure = !inside.abs().greater(bound) & 15;
    (!inside.greater(L::splat(0.0)) & 15 & !unsure, unsure)
}

/// The differences of positions from the point's, by columns.
#[inline(always)]
fn differences<L: Lanes, S: Site>(sites: [&S; 4], point: &S) -> [L; 3] {
    let [a, b, c, d] = sites;
    let [x, y, z] = L::columns([a.position(), b.position(), c.position(), d.position()]);
    let &[px, py, pz] = point.position();
    // Not by `map`: what the standard library compiles is not compiled for AVX2.
    [x.sub(L::splat(px)), y.sub(L::splat(py)), z.sub(L::splat(pz))]
}

/// The squares of the distances, the lifted values l, and L of the bounds: the sums of the absolute values.
#[inline(always)]
fn lifts<L: Lanes, S: Site>(sites: [&S; 4], [x, y, z]: [L; 3], point: &S) -> [L; 3] {
    let square = x.mul_add(x, y.mul_add(y, z.mul(z)));
    if !S::WEIGHTED {
        return [square; 3];
    }
    let [a, b, c, d] = sites;
    let weight = L::of([a.weight(), b.weight(), c.weight(), d.weight()]);
    let weight = weight.sub(L::splat(point.weight()));
    [square, square.sub(weight), square.add(weight.abs())]
}

/// The minors of the rows i, i + 1, and of the rows i, i + 2.
#[inline(always)]
fn minors<L: Lanes>(p: L, q: L) -> (L, L) {
    let next = p.mul_sub(q.turned::<1>(), p.turned::<1>().mul(q));
    let second = p.mul_sub(q.turned::<2>(), p.turned::<2>().mul(q));
    (next, second)
}

/// The determinants of the rows i + 1, i + 2, i + 3 in a third column and the two of the minors.
#[inline(always)]
fn three<L: Lanes>(column: L, next: L, second: L) -> L {
    let [a, b, c] = [column.turned::<1>(), column.turned::<2>(), column.turned::<3>()];
    let sum = a.mul_sub(next.turned::<2>(), b.mul(second.turned::<1>()));
    c.mul_add(next.turned::<1>(), sum)
}

#[cfg(test)]
mod tests {
    use super::super::lanes::Portable;
    #[cfg(target_arch = "x86_64")]
    use super::super::processor::{Avx2, Processor};
    use super::super::{Sign, in_conflict, orient3d};
    use super::*;
    use proptest::prelude::*;

    /// "At infinity".
    const INFINITE: u32 = 9;

    /// The filters' answers with the lanes of any processor and of this one; with index `at` at infinity, of the
    /// four vertices 0..4 and the four opposite, 4..8.
    fn filters<S: Site>(points: [&S; 8], at: u32, e: &S) -> Vec<(Neighbors, (u32, u32))> {
        fn filter<L: Lanes, S: Site>(points: [&S; 8], at: u32, e: &S) -> (Neighbors, (u32, u32)) {
            let index = |i: u32| if i == at { INFINITE } else { i };
            let cell = [0, 1, 2, 3].map(index);
            let opposite = [4, 5, 6, 7].map(index);
            let site = |i: u32| if i == INFINITE { e } else { points[i as usize] };
            let infinite = [L::equal(cell, INFINITE), L::equal(opposite, INFINITE)];
            let tests =
                neighbors_in_conflict::<L, S>(cell.map(site), opposite.map(site), infinite, e);
            (tests, beyond_facets::<L, S>([points[0], points[1], points[2], points[3]], e))
        }
        let mut answers = vec![filter::<Portable, S>(points, at, e)];
        #[cfg(target_arch = "x86_64")]
        if Processor::detect() == Processor::Avx2 {
            answers.push(filter::<Avx2, S>(points, at, e));
        }
        answers
    }

    /// Checks what the filters are sure of against the predicates, one cell at a time. Returns how many answers were sure.
    fn check<S: Site>(points: [&S; 8], at: u32, e: &S) -> u32 {
        let mut sure = 0;
        let position = |i: usize| points[i].position();
        for (tests, (beyond, unsure)) in filters(points, at, e) {
            for i in 0..4 {
                if at >= 4 && unsure >> i & 1 == 0 {
                    let mut corners = [0, 1, 2, 3].map(position);
                    corners[i] = e.position();
                    let [a, b, c, d] = corners;
                    let is_beyond = orient3d(a, b, c, d) == Sign::Negative;
                    assert_eq!(beyond >> i & 1 == 1, is_beyond, "facet {i}");
                    sure += 1;
                }
                if tests.unsure >> i & 1 == 1 {
                    continue;
                }
                let mut cell = [0, 1, 2, 3];
                cell[i] = 4 + i;
                let expected = match cell.iter().position(|&j| j == at as usize) {
                    // Two places exchanged, so that the cell is positive.
                    None => in_conflict([cell[1], cell[0], cell[2], cell[3]].map(|j| points[j]), e),
                    Some(slot) => {
                        let mut corners = cell.map(|j| points[j].position());
                        corners[slot] = e.position();
                        let [a, b, c, d] = corners;
                        orient3d(b, a, c, d) == Sign::Positive
                    }
                };
                assert_eq!(
                    tests.conflict >> i & 1 == 1,
                    expected,
                    "neighbour {i}, {at} at infinity"
                );
                sure += 1;
            }
        }
        sure
    }

    /// Points of a lattice, of a cube, and close to a plane.
    fn site() -> impl Strategy<Value = [f64; 4]> {
        let number = prop_oneof![(-3i32..4).prop_map(f64::from), -3.0..3.0f64, -1e-12..1e-12f64];
        [number.clone().boxed(), number.clone().boxed(), number.clone().boxed(), number.boxed()]
    }

    proptest! {
        #[test]
        fn what_the_filters_are_sure_of_is_true(points in [(); 9].map(|()| site().boxed()), at in 0u32..12) {
            let mut points = points;
            let of = |i: usize| points[i].position();
            match orient3d(of(0), of(1), of(2), of(3)) {
                Sign::Zero => return Ok(()),
                Sign::Negative => points.swap(0, 1),
                Sign::Positive => {}
            }
            let [cell_and_opposite @ .., e] = &points;
            check(cell_and_opposite.each_ref(), at, e);
            let positions = points.map(|p| *p.position());
            let [cell_and_opposite @ .., e] = &positions;
            check(cell_and_opposite.each_ref(), at, e);
        }
    }

    #[test]
    fn the_filters_are_sure_of_points_in_general_position() {
        let points: Vec<[f64; 3]> = [
            [0.1, 0.0, 0.2],
            [1.0, 0.1, 0.0],
            [0.2, 1.1, 0.1],
            [0.0, 0.3, 0.9],
            [1.2, 1.3, 1.1],
            [-0.9, 0.3, 0.4],
            [0.4, -1.1, 0.3],
            [0.3, 0.2, -1.0],
            [0.35, 0.4, 0.3],
        ]
        .to_vec();
        let around: [&[f64; 3]; 8] = std::array::from_fn(|i| &points[i]);
        let kinds = filters(around, 12, &points[8]).len() as u32;
        assert_eq!(check(around, 12, &points[8]), 8 * kinds);
        assert_eq!(check(around, 2, &points[8]), 4 * kinds);
        assert_eq!(check(around, 5, &points[8]), 8 * kinds);
    }

    #[test]
    fn cells_beyond_facets_and_packed_items_are_the_same_on_every_processor() {
        fn check<L: Lanes>() {
            let beyond = [[9, 2, 4, 3], [9, 1, 3, 4], [9, 4, 2, 1], [9, 3, 1, 2]];
            for (slot, expected) in (0..).zip(beyond) {
                assert_eq!(L::cell_beyond([1, 2, 3, 4], slot, 9), expected);
            }
            for bits in 0..16 {
                let items = [10u32, 11, 12, 13];
                let expected = (0..4).filter(|i| bits >> i & 1 == 1).map(|i| items[i]);
                let packed = L::packed(items, bits);
                assert!(expected.eq(packed[..bits.count_ones() as usize].iter().copied()));
            }
        }
        check::<Portable>();
        #[cfg(target_arch = "x86_64")]
        if Processor::detect() == Processor::Avx2 {
            check::<Avx2>();
        }
    }
}

//! Do the answers fit together? Symmetry, and whether the cells without conflict tile the hull.

use crate::sets::{KINDS, Random, five};
use medax::predicates::{
    Sign, delaunay_conflict, insphere, orient3d, position, power_test, regular_conflict,
};
use std::collections::BTreeSet;

type Row = [f64; 4];
type Conflict = fn(&Row, &Row, &Row, &Row, &Row) -> bool;

#[test]
fn orders_of_the_same_points_agree() {
    for (seed, kind) in KINDS.iter().enumerate() {
        let mut random = Random(100 + seed as u64);
        for _ in 0..200 {
            let rows = five(&mut random, kind);
            for (order, sign) in permutations() {
                let [a, b, c, d] = order.map(|i| &rows[i]);
                let e = &rows[4];
                let [p, q, r, s, t] = [a, b, c, d, e].map(position);
                let [p0, p1, p2, p3, _] = rows.each_ref().map(position);
                let [r0, r1, r2, r3, _] = rows.each_ref();
                assert_eq!(orient3d(p, q, r, s), sign * orient3d(p0, p1, p2, p3), "{rows:?}");
                assert_eq!(insphere(p, q, r, s, t), sign * insphere(p0, p1, p2, p3, t));
                assert_eq!(power_test(a, b, c, d, e), sign * power_test(r0, r1, r2, r3, e));
                if sign.is_positive() && orient3d(p, q, r, s).is_positive() {
                    for conflict in [delaunay_conflict, regular_conflict] {
                        assert_eq!(conflict(a, b, c, d, e), conflict(r0, r1, r2, r3, e));
                    }
                }
            }
        }
    }
}

/// The orders of four points, and whether they are even.
fn permutations() -> Vec<([usize; 4], Sign)> {
    let mut all = Vec::new();
    for code in 0..256 {
        let order = [code & 3, code >> 2 & 3, code >> 4 & 3, code >> 6];
        let pairs = || (0..4).flat_map(|i| (0..i).map(move |j| (j, i)));
        if pairs().all(|(j, i)| order[j] != order[i]) {
            let inversions = pairs().filter(|&(j, i)| order[j] > order[i]).count();
            all.push((order, if inversions % 2 == 0 { Sign::Positive } else { Sign::Negative }));
        }
    }
    assert_eq!(all.len(), 24);
    all
}

/// Six times the volume of a positively oriented cell with integer coordinates.
fn volume([a, b, c, d]: [&Row; 4]) -> i64 {
    let [x, y, z] = [b, c, d].map(|p| [0, 1, 2].map(|i| (p[i] - a[i]) as i64));
    x[0] * (y[1] * z[2] - y[2] * z[1]) - x[1] * (y[0] * z[2] - y[2] * z[0])
        + x[2] * (y[0] * z[1] - y[1] * z[0])
}

/// Checks that the cells in conflict with no other point tile a convex hull of known volume:
/// no facet has two cells on one side, a facet without a cell on the other side has no point
/// there, and the volumes add up.
fn assert_tiling(rows: &[Row], conflict: Conflict, hull: i64) -> usize {
    let mut facets = BTreeSet::new();
    let (mut total, mut cells) = (0, 0);
    for (a, b, c, d) in quadruples(rows.len()) {
        let [p, q, r, s] = [a, b, c, d].map(|i| position(&rows[i]));
        let [a, b, c, d] = match orient3d(p, q, r, s) {
            Sign::Positive => [a, b, c, d],
            Sign::Negative => [a, b, d, c],
            Sign::Zero => continue,
        };
        let corners = [a, b, c, d].map(|i| &rows[i]);
        let [p, q, r, s] = corners;
        let empty =
            (0..rows.len()).all(|e| [a, b, c, d].contains(&e) || !conflict(p, q, r, s, &rows[e]));
        if empty {
            cells += 1;
            total += volume(corners);
            for facet in [[b, d, c], [a, c, d], [a, d, b], [a, b, c]] {
                assert!(facets.insert(turned(facet)), "two cells on one side in {rows:?}");
            }
        }
    }
    assert_eq!(total, hull, "the cells do not fill the hull of {rows:?}");
    for &[a, b, c] in &facets {
        let beyond = |e: &Row| {
            orient3d(position(&rows[a]), position(&rows[b]), position(&rows[c]), position(e))
        };
        let hull = rows.iter().all(|e| !beyond(e).is_negative());
        assert!(hull || facets.contains(&turned([a, c, b])), "a gap in {rows:?}");
    }
    cells
}

/// A facet with its least vertex first, turning the same way.
fn turned([a, b, c]: [usize; 3]) -> [usize; 3] {
    [[a, b, c], [b, c, a], [c, a, b]].into_iter().min().expect("three")
}

fn quadruples(n: usize) -> impl Iterator<Item = (usize, usize, usize, usize)> {
    (0..n).flat_map(move |d| {
        (0..d).flat_map(move |c| (0..c).flat_map(move |b| (0..b).map(move |a| (a, b, c, d))))
    })
}

/// Points of the lattice {0..=side}^3, all corners and some others, in a random affine position
/// with integer coordinates; and six times the volume of their hull. Rows in random order.
fn lattice(random: &mut Random, side: usize, others: u64) -> (Vec<Row>, i64) {
    let (map, determinant) = loop {
        let map = [0; 3].map(|_| random.triple(|r| r.integer(2)));
        let [x, y, z] = map.map(|[x, y, z]| [x, y, z, 0.0]);
        let determinant = volume([&[0.0; 4], &x, &y, &z]).abs();
        if determinant != 0 {
            break (map, determinant);
        }
    };
    let origin = random.triple(|r| r.integer(9));
    let mut rows = Vec::new();
    for code in 0..(side + 1).pow(3) {
        let at = [code % (side + 1), code / (side + 1) % (side + 1), code / (side + 1).pow(2)];
        if at.iter().all(|x| x % side == 0) || random.below(27) < others {
            let [s, t, u] = at.map(|x| x as f64);
            let p: [f64; 3] =
                std::array::from_fn(|i| origin[i] + s * map[0][i] + t * map[1][i] + u * map[2][i]);
            rows.push([p[0], p[1], p[2], 0.0]);
        }
    }
    for i in (1..rows.len()).rev() {
        rows.swap(i, random.below(i as u64 + 1) as usize);
    }
    (rows, 6 * determinant * (side as i64).pow(3))
}

#[test]
fn cells_without_conflict_tile_the_hull() {
    let mut random = Random(7);
    for round in 0..200 {
        let (rows, hull) = match round {
            0 => lattice(&mut random, 2, 27),
            1..60 => lattice(&mut random, 1, 0),
            _ => lattice(&mut random, 2, 10),
        };
        assert!(assert_tiling(&rows, delaunay_conflict, hull) >= 5);
    }
}

#[test]
fn weighted_cells_without_conflict_tile_the_hull() {
    let mut random = Random(8);
    for round in 0..200 {
        let (mut rows, hull) = match round {
            0 => lattice(&mut random, 2, 27),
            1..60 => lattice(&mut random, 1, 0),
            _ => lattice(&mut random, 2, 10),
        };
        // Weights of few values: ties of power, hidden points, and ties between hiding and not.
        let range = 1 + random.below(3);
        rows.iter_mut().for_each(|row| row[3] = random.integer(range));
        assert!(assert_tiling(&rows, regular_conflict, hull) >= 5);
    }
}

#[test]
fn equal_weights_change_nothing() {
    for (seed, kind) in KINDS.iter().enumerate() {
        let mut random = Random(200 + seed as u64);
        for _ in 0..200 {
            let mut rows = five(&mut random, kind);
            let weight = rows[0][3];
            rows.iter_mut().for_each(|row| row[3] = weight);
            let [a, b, c, d, e] = rows.each_ref();
            let [p, q, r, s, t] = rows.each_ref().map(position);
            assert_eq!(power_test(a, b, c, d, e), insphere(p, q, r, s, t), "{rows:?}");
            let (delaunay, regular) =
                (delaunay_conflict(a, b, c, d, e), regular_conflict(a, b, c, d, e));
            assert_eq!(delaunay, regular, "{rows:?}");
        }
    }
}

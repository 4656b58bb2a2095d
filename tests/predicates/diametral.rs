//! Conflicts with smallest spheres, by their definition: the power of a point to the sphere orthogonal to two or three
//! weighted points, with its centre on their line or plane. Ties by weights so small that nothing but ties can notice.

use crate::rational::{Vector, dot, rational, sign, sub, vector};
use crate::sets::{KINDS, Random, five};
use medax::predicates::{Sign, collinear, edge_conflict, orient3d, position, triangle_conflict};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;

/// Minus eps^(n - rank + 1), with the rank of each point in lexicographic order, and eps = 2^-`bits`.
fn weights<const N: usize>(points: &[[f64; 3]; N], bits: usize) -> [BigRational; N] {
    points.each_ref().map(|p| {
        let larger = points.iter().filter(|q| *q > p).count();
        BigRational::new(BigInt::from(-1), BigInt::from(1) << (bits * (larger + 1)))
    })
}

/// The power of the last point to the sphere about p + u a + v b that is orthogonal to the others, p, p + a and p + b.
fn power(center: &Vector, points: &[Vector], weights: &[BigRational]) -> BigRational {
    let square = |i: usize| {
        let offset = sub(&points[i], center);
        dot(&offset, &offset) - &weights[i]
    };
    square(points.len() - 1) - square(0)
}

/// The sign of the power of r to the smallest sphere orthogonal to p and q.
fn edge(points: &[[f64; 3]; 3], weights: &[BigRational; 3]) -> Sign {
    let rows = points.map(|p| vector(&p));
    let along = sub(&rows[1], &rows[0]);
    let square = dot(&along, &along);
    let two = rational(2.0);
    let share = (&square + &weights[0] - &weights[1]) / (two * square);
    let center: Vector = std::array::from_fn(|k| &rows[0][k] + &share * &along[k]);
    sign(&power(&center, &rows, weights))
}

/// The sign of the power of s to the smallest sphere orthogonal to p, q and r.
fn triangle(points: &[[f64; 3]; 4], weights: &[BigRational; 4]) -> Sign {
    let rows = points.map(|p| vector(&p));
    let [a, b] = [1, 2].map(|i| sub(&rows[i], &rows[0]));
    let (aa, ab, bb) = (dot(&a, &a), dot(&a, &b), dot(&b, &b));
    let two = rational(2.0);
    // c = p + u a + v b with 2 (c - p) . a = aa + w_p - w_q, and likewise for b.
    let x = (&aa + &weights[0] - &weights[1]) / &two;
    let y = (&bb + &weights[0] - &weights[2]) / &two;
    let determinant = &aa * &bb - &ab * &ab;
    let u = (&x * &bb - &y * &ab) / &determinant;
    let v = (&y * &aa - &x * &ab) / &determinant;
    let center: Vector = std::array::from_fn(|k| &rows[0][k] + &u * &a[k] + &v * &b[k]);
    sign(&power(&center, &rows, weights))
}

/// Asserts both conflicts for four points, and returns whether either was a tie; `None` for points that are none of
/// theirs.
fn agree(points: [[f64; 3]; 4], bits: usize) -> Option<[bool; 2]> {
    let [p, q, r, s] = points;
    if p == q || q == r || p == r || collinear(&p, &q, &r) {
        return None;
    }
    let none = || [(); 4].map(|()| BigRational::zero());
    let three = [p, q, r];
    let [a, b, c, _] = none();
    let plain = edge(&three, &[a, b, c]);
    let expected = match plain {
        Sign::Zero => edge(&three, &weights(&three, bits)),
        sign => sign,
    };
    assert_eq!(edge_conflict(&p, &q, &r), expected.is_negative(), "{three:?}");
    assert_eq!(edge_conflict(&q, &p, &r), expected.is_negative(), "{three:?}");
    if orient3d(&p, &q, &r, &s).is_zero() {
        return None;
    }
    let solid = triangle(&points, &none());
    let expected = match solid {
        Sign::Zero => triangle(&points, &weights(&points, bits)),
        sign => sign,
    };
    for [p, q, r] in [[p, q, r], [q, r, p], [r, q, p]] {
        assert_eq!(triangle_conflict(&p, &q, &r, &s), expected.is_negative(), "{points:?}");
    }
    Some([plain.is_zero(), solid.is_zero()])
}

#[test]
fn conflicts_with_smallest_spheres_are_exact_on_every_kind_of_points() {
    for (seed, kind) in KINDS.iter().enumerate() {
        let mut random = Random(seed as u64);
        for _ in 0..100 {
            let [a, b, c, d, _] = five(&mut random, kind);
            agree([a, b, c, d].map(|row| *position(&row)), 9000);
        }
    }
}

#[test]
fn ties_go_by_infinitesimal_weights() {
    let mut random = Random(7);
    let mut ties = [0; 2];
    while ties.iter().any(|&n| n < 200) {
        let n = 1 + random.below(3);
        let points = [(); 4].map(|()| random.triple(|r| r.integer(n)));
        for (ties, is_tie) in ties.iter_mut().zip(agree(points, 60).unwrap_or_default()) {
            *ties += i32::from(is_tie);
        }
    }
}

//! The symbolic perturbation against one that is not symbolic: weights that differ by rationals
//! so small that nothing but ties can notice.

use crate::rational::{self, weights};
use crate::sets::Random;
use medax::predicates::{delaunay_conflict, orient3d, position, regular_conflict};
use num_bigint::BigInt;
use num_rational::BigRational;

/// The weights less eps^(n - rank + 1), with the rank of each point in lexicographic order and an eps
/// far below what distinguishes points with small integer coordinates.
fn perturbed(points: &[&[f64; 3]], weights: &mut [BigRational]) {
    for (i, p) in points.iter().enumerate() {
        let larger = points.iter().filter(|q| q.partial_cmp(&p).unwrap().is_gt()).count();
        let scale = BigInt::from(1) << (60 * (larger + 1));
        weights[i] -= BigRational::new(BigInt::from(1), scale);
    }
}

fn distinct(points: &[[f64; 4]]) -> bool {
    (0..points.len()).all(|i| (0..i).all(|j| position(&points[i]) != position(&points[j])))
}

#[test]
fn ties_of_five_points() {
    let mut random = Random(1);
    let (mut conflicts, mut ties) = ([0; 2], 0);
    while ties < 600 {
        let n = 1 + random.below(3);
        let w = random.below(3);
        let rows: [[f64; 4]; 5] = std::array::from_fn(|_| {
            let [x, y, z] = random.triple(|r| r.integer(n));
            [x, y, z, random.integer(w)]
        });
        let points = rows.each_ref().map(position);
        let [pa, pb, pc, pd, _] = points;
        let [a, b, c, d, e] = rows.each_ref();
        if !distinct(&rows) || !orient3d(pa, pb, pc, pd).is_positive() {
            continue;
        }
        for weighted in [false, true] {
            let weight = |p: [f64; 4]| if weighted { p[3] } else { 0.0 };
            let mut weights = weights(rows.map(weight));
            let exact = rational::excess(points, &weights).unwrap();
            ties += i32::from(rational::sign(&exact).is_zero());
            perturbed(&points, &mut weights);
            let excess = rational::excess(points, &weights).unwrap();
            let expected = rational::sign(&excess).is_negative();
            let conflict = if weighted { regular_conflict } else { delaunay_conflict };
            assert_eq!(conflict(a, b, c, d, e), expected, "weighted {weighted}: {rows:?}");
            conflicts[usize::from(expected)] += 1;
        }
    }
    assert!(conflicts.iter().all(|&n| n > 200), "both answers must occur: {conflicts:?}");
}

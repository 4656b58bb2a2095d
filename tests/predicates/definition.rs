//! Every predicate against its definition.

use crate::rational::{self, weights};
use crate::sets::{KINDS, Random, five};
use medax::predicates::{
    Sign, collinear, coplanar_orientation, delaunay_conflict, insphere, orient3d, position,
    power_test, regular_conflict,
};

/// The number of random cases of each kind.
const CASES: usize = 800;

/// Checks every kind of case, and that each sign was expected often enough to mean something.
fn cases(mut expected: impl FnMut(&str, &[[f64; 4]; 5]) -> Option<Sign>) {
    let mut seen = [0; 3];
    for (seed, kind) in KINDS.iter().enumerate() {
        let mut random = Random(seed as u64);
        for _ in 0..CASES {
            if let Some(sign) = expected(kind, &five(&mut random, kind)) {
                seen[(sign as i8 + 1) as usize] += 1;
            }
        }
    }
    assert!(seen.iter().all(|&n| n > CASES / 10), "each sign must occur: {seen:?}");
}

#[test]
fn orientation_is_the_sign_of_the_volume() {
    cases(|kind, rows| {
        let [a, b, c, d, _] = rows.each_ref().map(position);
        let expected = rational::sign(&rational::volume(a, b, c, d));
        assert_eq!(orient3d(a, b, c, d), expected, "{kind}: {rows:?}");
        Some(expected)
    });
}

#[test]
fn orientation_in_a_plane_is_the_first_of_three_that_is_not_zero() {
    cases(|kind, rows| {
        let [a, b, c, _, _] = rows.each_ref().map(position);
        let [x, y, z] = rational::normal(a, b, c);
        let signs = [rational::sign(&z), rational::sign(&x), -rational::sign(&y)];
        let expected = signs.into_iter().find(|sign| !sign.is_zero()).unwrap_or(Sign::Zero);
        assert_eq!(coplanar_orientation(a, b, c), expected, "{kind}: {rows:?}");
        assert_eq!(collinear(a, b, c), expected.is_zero());
        Some(expected)
    });
}

#[test]
fn insphere_is_the_sign_of_the_distance_to_the_sphere() {
    cases(|kind, rows| {
        let [a, b, c, d, e] = rows.each_ref().map(position);
        let excess = rational::excess([a, b, c, d, e], &weights([0.0; 5]))?;
        let expected = -rational::sign(&excess) * orient3d(a, b, c, d);
        assert_eq!(insphere(a, b, c, d, e), expected, "{kind}: {rows:?}");
        if orient3d(a, b, c, d).is_positive() && !expected.is_zero() {
            let [a, b, c, d, e] = rows.each_ref();
            assert_eq!(delaunay_conflict(a, b, c, d, e), expected.is_positive(), "{rows:?}");
        }
        Some(expected)
    });
}

#[test]
fn the_power_test_is_the_sign_of_the_power_to_the_sphere() {
    cases(|kind, rows| {
        let [a, b, c, d, e] = rows.each_ref();
        let excess = rational::excess(rows.each_ref().map(position), &weights(rows.map(|p| p[3])))?;
        let turn = orient3d(position(a), position(b), position(c), position(d));
        let expected = -rational::sign(&excess) * turn;
        assert_eq!(power_test(a, b, c, d, e), expected, "{kind}: {rows:?}");
        if turn.is_positive() && !expected.is_zero() {
            assert_eq!(regular_conflict(a, b, c, d, e), expected.is_positive(), "{rows:?}");
        }
        Some(expected)
    });
}

/// Nearly cospherical points some half steps of 2^51 apart: floats below that are as fine, those above are not, so that a test for
/// multiples of a step that adds a large number must not do so with negative ones.
#[test]
fn half_steps_are_seen_at_negative_coordinates_too() {
    let sets: [[[i32; 3]; 4]; 5] = [
        [
            [-234787, 358380, 777779],
            [74023, 48495, 0],
            [-55733, 38242, 113516],
            [-160764, 406875, 777779],
        ],
        [
            [-263947, -256958, 587823],
            [-113313, 116395, 0],
            [-1983, -51436, 59522],
            [-377260, -140563, 587823],
        ],
        [
            [-296901, 523934, 535621],
            [10341, 5860, 0],
            [64879, -124433, -124738],
            [-286560, 529794, 535621],
        ],
        [
            [-335031, -634331, -475066],
            [-203946, 107717, 0],
            [20359, -206378, -114553],
            [-538977, -526614, -475066],
        ],
        [
            [-337245, 349465, 528579],
            [4418, 4262, 1],
            [54883, -55666, -85076],
            [-332827, 353727, 528580],
        ],
    ];
    let far = (1i64 << 52) + (3 << 40);
    for set in sets {
        for origin in [0, far, -far] {
            for scale in [0.5, 0.5f64.powi(50)] {
                let at = |p: [i32; 3]| p.map(|x| (i64::from(x) + origin) as f64 * scale);
                let [a, b, c, d] = set.map(at);
                let e = at([0; 3]);
                let points = [&a, &b, &c, &d, &e];
                let excess = rational::excess(points, &weights([0.0; 5])).unwrap();
                let expected = -rational::sign(&excess) * orient3d(&a, &b, &c, &d);
                assert!(!expected.is_zero());
                assert_eq!(insphere(&a, &b, &c, &d, &e), expected, "{set:?} {origin} {scale}");
            }
        }
    }
}

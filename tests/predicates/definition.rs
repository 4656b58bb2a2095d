//! Every predicate against its definition.

use crate::rational;
use crate::sets::{KINDS, Random, five};
use medax::predicates::{insphere, orient3d, position, power_test};

/// The number of random cases of each kind.
const CASES: usize = 3000;

fn cases(mut check: impl FnMut(&str, &[[f64; 4]; 5])) {
    for (seed, kind) in KINDS.iter().enumerate() {
        let mut random = Random(seed as u64);
        for _ in 0..CASES {
            check(kind, &five(&mut random, kind));
        }
    }
}

#[test]
fn orientation_is_the_sign_of_the_volume() {
    let mut seen = [0; 3];
    cases(|kind, rows| {
        let [a, b, c, d, _] = rows.each_ref().map(position);
        let expected = rational::sign(&rational::volume(a, b, c, d));
        assert_eq!(orient3d(a, b, c, d), expected, "{kind}: {rows:?}");
        seen[(expected as i8 + 1) as usize] += 1;
    });
    assert!(seen.iter().all(|&n| n > CASES / 10), "each sign must occur: {seen:?}");
}

#[test]
fn insphere_is_the_sign_of_the_distance_to_the_sphere() {
    let mut seen = [0; 3];
    cases(|kind, rows| {
        let mut rows = *rows;
        rows.iter_mut().for_each(|row| row[3] = 0.0);
        let [a, b, c, d, e] = rows.each_ref().map(position);
        let Some(excess) = rational::excess(rows.each_ref()) else { return };
        let expected = -rational::sign(&excess) * orient3d(a, b, c, d);
        assert_eq!(insphere(a, b, c, d, e), expected, "{kind}: {rows:?}");
        seen[(expected as i8 + 1) as usize] += 1;
    });
    assert!(seen.iter().all(|&n| n > CASES / 10), "each sign must occur: {seen:?}");
}

#[test]
fn the_power_test_is_the_sign_of_the_power_to_the_sphere() {
    let mut seen = [0; 3];
    cases(|kind, rows| {
        let [a, b, c, d, e] = rows.each_ref();
        let Some(excess) = rational::excess([a, b, c, d, e]) else { return };
        let turn = orient3d(position(a), position(b), position(c), position(d));
        let expected = -rational::sign(&excess) * turn;
        assert_eq!(power_test(a, b, c, d, e), expected, "{kind}: {rows:?}");
        seen[(expected as i8 + 1) as usize] += 1;
    });
    assert!(seen.iter().all(|&n| n > CASES / 10), "each sign must occur: {seen:?}");
}

//! Every stage of the lifted determinant against the exact value: is its error within its bound?

use super::sets::{KINDS, Random, five};
use super::{CASES, lifted, rational};
use crate::predicates::lifted::{
    MAXIMUM_BOUND, PAIRS_BOUND, PERMANENT_BOUND, TINY, determinant, exact_step, on_grid, pairs,
    permanent, product, zero_step,
};
use crate::predicates::{Sign, UNIT, exact, position};
use num_traits::{Signed, Zero};

/// Runs every stage on every kind of five points, not only when the one before it fails, and
/// counts how often each of them settles the sign.
fn stages<const WEIGHTED: bool>() -> [usize; 5] {
    let mut settled = [0; 5];
    for (seed, kind) in KINDS.iter().enumerate() {
        let mut random = Random(seed as u64);
        for _ in 0..CASES {
            let rows = five(&mut random, kind);
            let points = rows.each_ref();
            let value = lifted(&rows, WEIGHTED);
            let (determinant, product) =
                (determinant::<WEIGHTED>(points), product::<WEIGHTED>(points));
            let error = (rational(determinant) - &value).abs();
            let bound = MAXIMUM_BOUND * product + TINY;
            assert!(error <= rational(bound), "floats, {kind}: {rows:?}");
            settled[0] += usize::from(determinant.abs() > bound);

            let bound = PERMANENT_BOUND * permanent::<WEIGHTED>(points) + TINY;
            assert!(error <= rational(bound), "permanent, {kind}: {rows:?}");
            settled[1] += usize::from(determinant.abs() > bound);

            if on_grid::<WEIGHTED>(points, exact_step(product)) {
                assert!(error.is_zero(), "grid, {kind}: {rows:?}");
                settled[2] += 1;
            }

            let determinant = pairs::<WEIGHTED, false>(points);
            let error = (rational(determinant) - &value).abs();
            let bound = PAIRS_BOUND * product + TINY;
            // Adding the two parts of the pair rounds once more.
            let last = rational(determinant.abs()) * rational(UNIT);
            assert!(error <= rational(bound) + last, "pairs, {kind}: {rows:?}");
            if determinant.abs() > bound {
                settled[3] += 1;
            } else if on_grid::<WEIGHTED>(points, zero_step(product)) {
                assert!(value.is_zero(), "pairs on a grid, {kind}: {rows:?}");
                settled[4] += 1;
            }

            let weights = rows.map(|row| row[3]);
            let sign = exact::lifted_space(points.map(position), WEIGHTED.then_some(&weights));
            let expected = if value.is_zero() {
                Sign::Zero
            } else if value.is_positive() {
                Sign::Positive
            } else {
                Sign::Negative
            };
            assert_eq!(sign, expected, "integers, {kind}: {rows:?}");
        }
    }
    settled
}

#[test]
fn every_stage_keeps_its_bound() {
    for settled in [stages::<false>(), stages::<true>()] {
        // A stage that settled nothing would not have been tested.
        let often = settled.iter().all(|&n| n > CASES / 10);
        assert!(often || cfg!(miri), "settled by each stage: {settled:?}");
    }
}

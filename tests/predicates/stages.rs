//! Every stage has something to do, and is counted.

use crate::sets::{KINDS, Random, five};
use medax::predicates::regular_conflict;
use medax::predicates::stages::{Stage, settled};

#[test]
fn every_stage_settles_some_tests() {
    let all = [
        Stage::Maximum,
        Stage::Grid,
        Stage::Permanent,
        Stage::Pairs,
        Stage::Exact,
        Stage::Perturbed,
    ];
    let before = all.map(settled);
    for (seed, kind) in KINDS.iter().enumerate() {
        let mut random = Random(300 + seed as u64);
        for _ in 0..200 {
            let rows = five(&mut random, kind);
            let [a, b, c, d, e] = rows.each_ref();
            regular_conflict(a, b, c, d, e);
        }
    }
    // Other tests may run at the same time, and only add to the counts.
    for (stage, before) in all.into_iter().zip(before) {
        assert!(settled(stage) > before, "{stage:?} settled nothing");
    }
}

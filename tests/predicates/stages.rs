//! Every stage has something to do, and is counted.

use crate::sets::{KINDS, Random, five};
use medax::crust::PowerCrustOptions;
use medax::predicates::regular_conflict;
use medax::predicates::stages::{Stage, settled};
use medax::{Job, Points, Poles, PowerCrust};
use std::sync::{Arc, Mutex};

const ALL: [Stage; 6] =
    [Stage::Maximum, Stage::Grid, Stage::Permanent, Stage::Pairs, Stage::Exact, Stage::Perturbed];

/// The counts are the process's: one test at a time.
static COUNTING: Mutex<()> = Mutex::new(());

#[test]
fn every_stage_settles_some_tests() {
    let _counting = COUNTING.lock().unwrap();
    let before = ALL.map(settled);
    for (seed, kind) in KINDS.iter().enumerate() {
        let mut random = Random(300 + seed as u64);
        for _ in 0..200 {
            let rows = five(&mut random, kind);
            let [a, b, c, d, e] = rows.each_ref();
            regular_conflict(a, b, c, d, e);
        }
    }
    for (stage, before) in ALL.into_iter().zip(before) {
        assert!(settled(stage) > before, "{stage:?} settled nothing");
    }
}

#[test]
fn power_tests_of_poles_seldom_need_integers() {
    let _counting = COUNTING.lock().unwrap();
    for noise in [0.0, 0.005] {
        // Samples of an ellipsoid. Each lies, but for rounding, on all its polar balls.
        let mut random = Random(7);
        let mut rows = Vec::new();
        while rows.len() < 5000 {
            let p = [(); 3].map(|()| random.unit());
            let length = p.iter().map(|x| x * x).sum::<f64>().sqrt();
            if (0.1..1.0).contains(&length) {
                let stretch = 1.0 + noise * random.unit();
                let axes = [1.0, 0.7, 0.4].map(|axis| axis * stretch / length);
                rows.push([p[0] * axes[0], p[1] * axes[1], p[2] * axes[2]]);
            }
        }
        let job = Job::default();
        let points =
            |rows: &[[f64; 3]]| Arc::new(Points::new(rows, Default::default(), &job).unwrap());
        let poles =
            Arc::new(Poles::with_far_box(&points(&rows), Default::default(), &job).unwrap());
        let counts = |round_poles| {
            let options = PowerCrustOptions { round_poles, ..Default::default() };
            let before = ALL.map(settled);
            PowerCrust::from_poles(&poles, options, &job).unwrap();
            let counts = ALL.into_iter().zip(before).map(|(stage, before)| settled(stage) - before);
            counts.collect::<Vec<_>>()
        };
        let (exact, rounded) = (counts(false), counts(true));
        let [tests, rounded_tests] =
            [&exact, &rounded].map(|counts| counts[..5].iter().sum::<u64>());
        assert!(tests.min(rounded_tests) > 40 * poles.len() as u64, "{exact:?} {rounded:?}");
        // As many are hard as there should be, and nearly all of them are settled by pairs.
        assert!(exact[3] * 20 > tests, "{exact:?}");
        assert!(exact[4] * 1000 < tests, "{exact:?}");
        // Rounding leaves few for pairs, and next to none for integers.
        assert!(rounded[3] * 3 < exact[3], "{exact:?} {rounded:?}");
        assert!(rounded[4] * 10_000 < rounded_tests, "{rounded:?}");
    }
}

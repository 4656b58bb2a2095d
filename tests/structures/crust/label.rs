//! Labels of poles, where samples are noisy and have gaps.

use super::points;
use crate::sets::Random;
use medax::crust::{CONFLICT_LIMIT, Label, LabelRule, PowerCrustOptions};
use medax::{Job, NONE, Points, PowerCrust, Status};
use std::f64::consts::TAU;
use std::sync::Arc;

fn crust(points: &Arc<Points>, label_rule: LabelRule) -> PowerCrust {
    let options = PowerCrustOptions { label_rule, ..Default::default() };
    let crust = PowerCrust::build(points, options, &Job::default()).unwrap();
    let report = crust.validate(&Job::default()).unwrap();
    assert!(report.is_valid(), "{label_rule:?}: {:?}", report.first);
    crust
}

/// Random samples of a torus with radii 2 and 0.7, each moved by up to so much along each axis: only those that turn to one of three
/// scanners, if asked for.
fn torus(noise: f64, scanned: bool, seed: u64) -> Arc<Points> {
    let mut random = Random(seed);
    let mut rows = Vec::new();
    while rows.len() < 6000 {
        let [u, v] = [(); 2].map(|()| TAU * random.unit());
        let [x, y, z] = [v.cos() * u.cos(), v.cos() * u.sin(), v.sin()];
        let is_seen = z > 0.2 || x > 0.2 || y < -0.2;
        let r = 2.0 + 0.7 * v.cos();
        // The outer half has the larger share of the area.
        if (is_seen || !scanned) && random.unit() < r / 2.7 {
            let on = [r * u.cos(), r * u.sin(), 0.7 * v.sin()];
            rows.push(on.map(|x| x + noise * (2.0 * random.unit() - 1.0)));
        }
    }
    points(&rows)
}

fn form(crust: &PowerCrust) -> (u64, Option<u64>) {
    let topology = crust.surface().topology(&Job::default()).unwrap();
    (topology.components, topology.genus)
}

#[test]
fn a_noisy_torus_keeps_its_genus_where_labels_that_spread_lose_it() {
    for (scanned, seed) in [(false, 7), (false, 8), (true, 7), (true, 8)] {
        let points = torus(0.05, scanned, seed);
        let [spread, least, auto] = [LabelRule::Spread, LabelRule::LeastConflict, LabelRule::Auto]
            .map(|rule| crust(&points, rule));
        assert!(spread.conflict() > CONFLICT_LIMIT && !spread.is_settled());
        assert_ne!(form(&spread), (1, Some(1)));
        assert!(least.conflict() < 0.7 * spread.conflict() && least.is_settled());
        assert_eq!(form(&least), (1, Some(1)), "scanned {scanned}, seed {seed}");
        assert_eq!(auto.labels(), least.labels());
    }
}

/// On a grid whole samples have hidden poles only, which others hide but for rounding: what hides them tells their labels, or they would come to light on
/// the wrong side where balls grow or go.
#[test]
fn hidden_poles_have_the_labels_of_those_that_hide_them() {
    let row = |i: usize| {
        let (u, v) = (TAU * (i / 30) as f64 / 80.0, TAU * (i % 30) as f64 / 30.0);
        let r = 2.0 + 0.7 * v.cos();
        [r * u.cos(), r * u.sin(), 0.7 * v.sin()]
    };
    let rows: Vec<_> = (0..80 * 30).map(row).collect();
    let points = points(&rows);
    let auto = crust(&points, LabelRule::Auto);
    assert!(auto.regular().hidden().len() > 1000);
    assert_eq!((auto.unreached_count(), auto.is_settled()), (0, false));
    for (pole, &label) in auto.labels().iter().enumerate() {
        let [x, y, z, _] = auto.poles().balls()[pole];
        let within = (x.hypot(y) - 2.0).hypot(z) < 0.5;
        assert_eq!(label == Label::Inner, within, "pole {pole}");
    }
    for distance in [-0.1, 0.001, 0.1] {
        let offset = auto.offset(distance, &Job::default()).unwrap();
        assert_eq!(form(&offset), (1, Some(1)), "{distance}");
        let volume = offset.surface().measure(&Job::default()).unwrap().volume;
        let exact = TAU * TAU / 2.0 * 2.0 * (0.7 + distance) * (0.7 + distance);
        assert!((volume / exact - 1.0).abs() < 0.02, "{distance}: {volume} for {exact}");
    }
    let simplified = auto.simplify(Default::default(), &Job::default()).unwrap();
    assert_eq!(form(&simplified.crust), (1, Some(1)));
    let sizes = auto.sizes_at(&rows, &Job::default()).unwrap();
    let off = |thickness: &f64| (thickness - 1.4).abs() < 0.05;
    assert!(sizes.thickness.iter().all(off), "{:?}", sizes.thickness.iter().find(|t| !off(t)));
}

#[test]
fn labels_of_dense_samples_are_those_of_the_paper() {
    let mut random = Random(5);
    let rows: Vec<[f64; 3]> = (0..3000).map(|_| random.sphere()).collect();
    for points in [points(&rows), torus(0.0, false, 1)] {
        let [spread, auto] = [LabelRule::Spread, LabelRule::Auto].map(|rule| crust(&points, rule));
        assert!(auto.conflict() < CONFLICT_LIMIT / 10.0 && !auto.is_settled());
        assert_eq!(auto.labels(), spread.labels());
    }
}

/// A depth image, taken from the origin, of a wall 3 away with a box before it; depths are rounded to the step.
fn depth_image(step: f64) -> Arc<Points> {
    let mut rows = Vec::new();
    for i in -40..40 {
        for j in -40..40 {
            let [x, y] = [i, j].map(|i| f64::from(i) / 50.0);
            let depth: f64 = if x.abs() < 0.3 && y.abs() < 0.25 { 2.4 } else { 3.0 + 0.4 * x };
            let depth = (depth / step).round() * step;
            rows.push([x * depth, y * depth, depth]);
        }
    }
    points(&rows)
}

/// Of the samples with two poles the share whose pole towards the origin is outer and the other inner.
fn seen_from_origin(crust: &PowerCrust) -> f64 {
    let coords = crust.poles().triangulation().coords();
    let (mut all, mut right) = (0, 0);
    for (sample, &pair) in coords.iter().zip(crust.poles().pole_of_sample()) {
        if pair.contains(&NONE) {
            continue;
        }
        let towards = |pole: u32| -> f64 {
            let ball = crust.poles().balls()[pole as usize];
            (0..3).map(|k| (ball[k] - sample[k]) * -sample[k]).sum()
        };
        let label = |pole: u32| crust.labels()[pole as usize];
        let [front, back] =
            if towards(pair[0]) > towards(pair[1]) { pair } else { [pair[1], pair[0]] };
        all += 1;
        right += u32::from(label(front) == Label::Outer && label(back) == Label::Inner);
    }
    f64::from(right) / f64::from(all)
}

#[test]
fn what_the_scanner_sees_is_outside() {
    let points = depth_image(0.01);
    let from = |viewpoint| {
        let options = PowerCrustOptions { viewpoint, ..Default::default() };
        let crust = PowerCrust::build(&points, options, &Job::default()).unwrap();
        let report = crust.validate(&Job::default()).unwrap();
        assert!(report.is_valid(), "{:?}", report.first);
        crust
    };
    let [blind, seeing] = [None, Some([0.0; 3])].map(from);
    assert!(seen_from_origin(&seeing) > 0.9);
    assert!(seen_from_origin(&blind) < 0.8);
    let nowhere = PowerCrustOptions { viewpoint: Some([f64::NAN; 3]), ..Default::default() };
    let error = PowerCrust::build(&points, nowhere, &Job::default()).unwrap_err();
    assert_eq!(error.status(), Status::InvalidArgument);
}

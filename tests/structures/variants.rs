//! Power crusts of other poles and other balls: poles left out, offsets, simplified shapes, holes left open.

use crate::sets::Random;
use medax::crust::{HoleOptions, Label, LabelRule, PowerCrustOptions, SimplifyOptions};
use medax::poles::{Omit, PolesOptions};
use medax::{Job, NONE, Points, Poles, PowerCrust, Status};
use std::sync::Arc;

pub fn points(rows: &[[f64; 3]]) -> Arc<Points> {
    Arc::new(Points::new(rows, Default::default(), &Job::default()).unwrap())
}

pub fn crust(rows: &[[f64; 3]], poles: PolesOptions) -> PowerCrust {
    let options = PowerCrustOptions { poles, ..Default::default() };
    PowerCrust::build(&points(rows), options, &Job::default()).unwrap()
}

fn assert_valid(crust: &PowerCrust, name: &str) {
    for report in [crust.validate(&Job::default()), crust.poles().validate(&Job::default())] {
        let report = report.unwrap();
        assert!(report.is_valid(), "{name}: {report:?}");
    }
}

/// Components and genus of the surface, which must be closed.
fn form(crust: &PowerCrust) -> (u64, Option<u64>) {
    let topology = crust.surface().topology(&Job::default()).unwrap();
    assert!(topology.closed);
    (topology.components, topology.genus)
}

fn is_empty(crust: &PowerCrust) -> bool {
    crust.surface().faces().is_empty()
}

/// The most that a vertex of the surface is off, given how far each is.
fn most(crust: &PowerCrust, off: impl Fn([f64; 3]) -> f64) -> f64 {
    crust.surface().vertices().iter().map(|&p| off(p).abs()).fold(0.0, f64::max)
}

/// A torus with radii 2 and 0.7, stirred along its surface.
pub fn torus() -> Vec<[f64; 3]> {
    let mut random = Random(3);
    let mut rows = Vec::new();
    for i in 0..120 {
        for j in 0..48 {
            let mut turn = |i: i32, n: i32| {
                std::f64::consts::TAU * (f64::from(i) + 0.3 * random.unit()) / f64::from(n)
            };
            let (u, v) = (turn(i, 120), turn(j, 48));
            let r = 2.0 + 0.7 * v.cos();
            rows.push([r * u.cos(), r * u.sin(), 0.7 * v.sin()]);
        }
    }
    rows
}

/// How far a point is outside a torus with radii 2 and `minor`.
fn outside_torus([x, y, z]: [f64; 3], minor: f64) -> f64 {
    (x.hypot(y) - 2.0).hypot(z) - minor
}

#[test]
fn offsets_of_a_torus_are_tori() {
    let whole = crust(&torus(), PolesOptions::default());
    for distance in [-0.5, -0.2, 0.2, 0.5, 1.0] {
        let offset = whole.offset(distance, &Job::default()).unwrap();
        assert_valid(&offset, "offset");
        assert_eq!(form(&offset), (1, Some(1)), "{distance}");
        // Measured: 0.012 to 0.03; samples are 0.1 apart.
        let off = most(&offset, |p| outside_torus(p, 0.7 + distance));
        assert!(off < 0.04, "{distance}: {off}");
        let labels = offset.labels().iter().zip(whole.labels()).filter(|(a, b)| a != b);
        assert_eq!(labels.count(), offset.forced_count());
    }
}

#[test]
fn a_ball_without_a_radius_vanishes_and_does_not_come_back() {
    let whole = crust(&torus(), PolesOptions::default());
    let inside = whole.offset(-0.75, &Job::default()).unwrap();
    assert!(is_empty(&inside));
    assert_valid(&inside, "nothing inside");
    assert!(is_empty(&inside.offset(0.75, &Job::default()).unwrap()));
    // Back again where nothing vanished: as before, but for rounding.
    let back = whole.offset(-0.2, &Job::default()).unwrap().offset(0.2, &Job::default()).unwrap();
    assert_eq!(form(&back), (1, Some(1)));
    assert!(most(&back, |p| outside_torus(p, 0.7)) < 0.02);
    for distance in [f64::NAN, f64::INFINITY] {
        let refused = whole.offset(distance, &Job::default()).unwrap_err();
        assert_eq!(refused.status(), Status::InvalidArgument);
    }
}

/// Samples of a box of half that size, none on its edges, a step apart or less.
pub fn brick(half: [f64; 3], step: f64) -> Vec<[f64; 3]> {
    let mut random = Random(8);
    let mut rows = Vec::new();
    for k in 0..3 {
        let [i, j] = [(k + 1) % 3, (k + 2) % 3];
        let counts = [i, j].map(|axis| (2.0 * half[axis] / step).round() as u32);
        for (a, b) in (0..counts[0]).flat_map(|a| (0..counts[1]).map(move |b| (a, b))) {
            for side in [-1.0, 1.0] {
                let mut at = |axis: usize, i: u32| {
                    -half[axis] + step * (f64::from(i) + 0.5 + 0.15 * (2.0 * random.unit() - 1.0))
                };
                let mut row = [side * half[k]; 3];
                (row[i], row[j]) = (at(i, a), at(j, b));
                rows.push(row);
            }
        }
    }
    rows
}

const HALF: [f64; 3] = [1.0, 0.5, 0.3];

/// How far a point is outside a box, where that is the largest of its distances from the planes of its sides.
fn outside_brick(p: [f64; 3], half: [f64; 3]) -> f64 {
    (0..3).map(|k| p[k].abs() - half[k]).fold(f64::MIN, f64::max)
}

#[test]
fn a_box_without_samples_on_its_edges_keeps_them() {
    for omit in [Omit::Nothing, Omit::Both] {
        let crust = crust(&brick(HALF, 0.05), PolesOptions { omit, lambda: 0.0 });
        assert_valid(&crust, "box");
        assert_eq!(form(&crust), (1, Some(0)));
        // Measured: 3e-4 and 1.5e-3, a thirtieth of the distance between samples.
        assert!(most(&crust, |p| outside_brick(p, HALF)) < 3e-3);
        // Every corner is there, and round it every edge: a rounded one would be missed by 0.01 or more.
        for corner in 0..8 {
            let sign = |k: usize| if corner >> k & 1 == 0 { -1.0 } else { 1.0 };
            let off = |p: &[f64; 3]| {
                (0..3).map(|k| (p[k] - sign(k) * HALF[k]).powi(2)).sum::<f64>().sqrt()
            };
            let nearest = crust.surface().vertices().iter().map(off).fold(f64::MAX, f64::min);
            assert!(nearest < 3e-3, "{omit:?}: corner {corner} is missed by {nearest}");
        }
        // The normals of faces are those of the box but for few, small ones: dihedral angles are 0 or 90 degrees.
        let (mut right, mut wrong) = (0.0, 0.0);
        let surface = crust.surface();
        for ring in surface.faces().iter() {
            let at = |i: usize| surface.vertices()[ring[i] as usize];
            let mut normal = [0.0; 3];
            for i in 0..ring.len() {
                let (p, q) = (at(i), at((i + 1) % ring.len()));
                let cross = |a: usize, b: usize| p[a] * q[b] - p[b] * q[a];
                normal =
                    [normal[0] + cross(1, 2), normal[1] + cross(2, 0), normal[2] + cross(0, 1)];
            }
            let area = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
            let along = normal.iter().fold(0.0f64, |most, x| most.max(x.abs()));
            *(if along > 0.9999 * area { &mut right } else { &mut wrong }) += area;
        }
        assert!(wrong < 0.01 * right, "{omit:?}: {wrong} of {right}");
        let inside = crust.offset(-0.1, &Job::default()).unwrap();
        let half = HALF.map(|x| x - 0.1);
        assert!(most(&inside, |p| outside_brick(p, half)) < 3e-3);
        // The box is thinner than twice the offset.
        assert!(is_empty(&crust.offset(-0.31, &Job::default()).unwrap()));
    }
}

/// Samples of an ellipsoid, each moved by up to so much along each axis.
pub fn ellipsoid(count: usize, noise: f64) -> Vec<[f64; 3]> {
    let mut random = Random(21);
    let axes = [1.0, 0.7, 0.4];
    let row = |_| {
        let u = random.sphere();
        [0, 1, 2].map(|k| axes[k] * u[k] + noise * (2.0 * random.unit() - 1.0))
    };
    (0..count).map(row).collect()
}

#[test]
fn poles_of_misshapen_cells_go_on_one_side_or_both() {
    let rows = ellipsoid(3000, 0.02);
    let spread = PowerCrustOptions { label_rule: LabelRule::Spread, ..Default::default() };
    let all = PowerCrust::build(&points(&rows), spread, &Job::default()).unwrap();
    let [side, both] =
        [Omit::Side, Omit::Both].map(|omit| crust(&rows, PolesOptions { omit, lambda: 0.4 }));
    assert!(form(&all) != (1, Some(0)), "the noise must do harm: {:?}", form(&all));
    assert_eq!(form(&side), (1, Some(0)));
    let missing = |crust: &PowerCrust, count: usize| {
        let pairs = crust.poles().pole_of_sample().iter();
        pairs.filter(|pair| pair.iter().filter(|&&pole| pole == NONE).count() == count).count()
    };
    for crust in [&all, &side, &both] {
        assert_valid(crust, "noise");
    }
    assert_eq!((missing(&all, 1), missing(&all, 2)), (0, 0));
    assert!(missing(&side, 1) > 300);
    // A sample that loses one pole to the one loses both to the other.
    assert_eq!(missing(&both, 1), 0);
    assert_eq!(missing(&both, 2), missing(&side, 1) + missing(&side, 2));
    assert_eq!((all.poles().lambda(), side.poles().lambda()), (0.0, 0.4));
}

#[test]
fn lambda_is_estimated_where_it_is_not_given() {
    for (noise, expected) in [(0.0, 0.4), (0.02, 0.45)] {
        let points = points(&ellipsoid(3000, noise));
        let options = PolesOptions { omit: Omit::Side, lambda: 0.0 };
        let poles = Poles::with_far_box(&points, options, &Job::default()).unwrap();
        assert_eq!(poles.lambda(), expected);
        assert!(poles.validate(&Job::default()).unwrap().is_valid());
    }
}

#[test]
fn lambda_out_of_range_and_no_pole_left_are_errors() {
    let points = points(&ellipsoid(300, 0.1));
    let build = |lambda| {
        let options = PolesOptions { omit: Omit::Both, lambda };
        Poles::with_far_box(&points, options, &Job::default()).map(drop)
    };
    for lambda in [-0.1, 0.79, f64::NAN, f64::INFINITY] {
        assert_eq!(build(lambda).unwrap_err().status(), Status::InvalidArgument, "{lambda}");
    }
    let error = build(1e-9).unwrap_err();
    assert_eq!(error.status(), Status::TooFewPoints);
    assert!(error.message().contains("600 poles"), "{}", error.message());
}

#[test]
fn simplification_keeps_what_the_shape_needs() {
    let rows = ellipsoid(3000, 0.002);
    let whole = crust(&rows, PolesOptions::default());
    let options = SimplifyOptions { epsilon: Some(0.1), delta: Some(0.02) };
    let simplified = whole.simplify(options, &Job::default()).unwrap();
    assert_valid(&simplified.crust, "simplified");
    assert_eq!(form(&simplified.crust), (1, Some(0)));
    let poles = whole.poles();
    let distance =
        |p: [f64; 3], q: [f64; 3]| (0..3).map(|k| (p[k] - q[k]).powi(2)).sum::<f64>().sqrt();
    let width = |pole: u32| {
        let samples = poles.samples_on_balls().row(pole as usize);
        let at = |s: u32| poles.triangulation().coords()[s as usize];
        let pairs = samples.iter().flat_map(|&a| samples.iter().map(move |&b| (a, b)));
        pairs.map(|(a, b)| distance(at(a), at(b))).fold(0.0, f64::max)
    };
    let is_visible = |pole: u32| simplified.crust.is_visible(pole);
    for pole in 0..poles.len() as u32 {
        let unstable = simplified.unstable.binary_search(&pole).is_ok();
        let narrow = !poles.touches_far_box()[pole as usize] && width(pole) <= 0.1;
        assert_eq!(unstable, narrow, "pole {pole}");
        assert!(!unstable || !is_visible(pole));
    }
    assert!(simplified.unstable.len() > 100 && simplified.redundant.len() > 100);
    for &[pole, keeper] in &simplified.redundant {
        let [[x, y, z, r], [u, v, w, s]] = [pole, keeper].map(|p| poles.balls()[p as usize]);
        assert!(distance([x, y, z], [u, v, w]) + r <= s + 0.02 + 1e-12 && r < s);
        let label = |p: u32| whole.labels()[p as usize];
        assert_eq!(label(pole), label(keeper));
        assert!(!is_visible(pole));
        let gone = simplified.redundant.binary_search_by_key(&keeper, |pair| pair[0]).is_ok();
        assert!(!gone, "the keeper of {pole} is gone as well");
    }
    // No ball is left that a neighbour could take.
    let neighbors = simplified.crust.inner_shape();
    assert!(neighbors.vertices().len() * 5 < whole.inner_shape().vertices().len());
    // Nothing goes where nothing may.
    let none = SimplifyOptions { epsilon: Some(0.0), delta: Some(0.0) };
    let same = whole.simplify(none, &Job::default()).unwrap();
    assert!(same.unstable.is_empty() && same.redundant.is_empty());
    assert_eq!(same.crust.surface(), whole.surface());
    let wrong = SimplifyOptions { epsilon: Some(-1.0), delta: None };
    let refused = whole.simplify(wrong, &Job::default()).unwrap_err();
    assert_eq!(refused.status(), Status::InvalidArgument);
}

#[test]
fn a_hole_stays_open_where_balls_protrude_through_it() {
    let rows: Vec<_> = ellipsoid(4000, 0.0).into_iter().filter(|row| row[2] < 0.25).collect();
    let crust = crust(&rows, PolesOptions::default());
    assert_eq!(form(&crust), (1, Some(0)));
    let open = crust.open(HoleOptions { depth: 0.1, radius: 0.1 }, &Job::default()).unwrap();
    let topology = open.surface.topology(&Job::default()).unwrap();
    assert_eq!((topology.components, topology.boundary_loops), (1, 1));
    assert_eq!(
        open.surface.faces().len() + open.left_out.faces().len(),
        crust.surface().faces().len()
    );
    // What is left out is the lid.
    assert!(open.left_out.vertices().iter().all(|p| p[2] > 0.15));
    for (depth, radius) in [(1.0, 0.0), (0.1, 10.0)] {
        let whole = crust.open(HoleOptions { depth, radius }, &Job::default()).unwrap();
        assert!(whole.left_out.faces().is_empty());
        assert_eq!(whole.surface.faces(), crust.surface().faces());
    }
    let refused = crust.open(HoleOptions { depth: 2.0, radius: 0.0 }, &Job::default());
    assert_eq!(refused.unwrap_err().status(), Status::InvalidArgument);
    assert!(crust.labels().contains(&Label::Inner));
}

//! Scale axes: what is small beside what is near goes, and nothing else.

use crate::sets::Random;
use crate::variants::{crust, points, torus};
use medax::complex::{Element, Values};
use medax::crust::{Label, PowerCrustOptions};
use medax::{Complex, Job, PowerCrust, Status};

fn axis(crust: &PowerCrust, side: Label, factor: f64) -> Complex {
    let axis = crust.scale_axis(side, factor, &Job::default()).unwrap();
    assert!(axis.validate(&Job::default()).unwrap().is_valid());
    axis
}

fn betti(axis: &Complex) -> [u64; 3] {
    axis.topology(&Job::default()).unwrap().betti
}

fn radii(axis: &Complex) -> &[f64] {
    match axis.attribute(Element::Vertex, "radius").unwrap().values() {
        Values::F64(radii) => radii,
        Values::U32(_) => panic!("radii are floats"),
    }
}

#[test]
fn the_axis_of_a_torus_is_a_circle_until_its_hole_closes() {
    let crust = crust(&torus(), Default::default());
    // At 1 the samples lie on the union's boundary, and rounding makes voids of them.
    for factor in [1.01, 1.3, 2.0] {
        let axis = axis(&crust, Label::Inner, factor);
        assert_eq!(betti(&axis), [1, 1, 0], "{factor}");
        for (p, radius) in axis.vertices().iter().zip(radii(&axis)) {
            let off = (p[0].hypot(p[1]) - 2.0).hypot(p[2]);
            assert!(off < 0.2 && (radius - 0.7).abs() < 0.2, "{factor}: {p:?}, {radius}");
        }
    }
    // The tube is 0.7 wide and 2 from the middle: grown three times it meets itself there.
    assert_eq!(betti(&axis(&crust, Label::Inner, 3.0)), [1, 0, 0]);
}

#[test]
fn a_small_ball_goes_when_the_large_one_beside_it_covers_it() {
    let mut random = Random(5);
    // Stirred: all balls of an exact sphere are one but for rounding, which then decides how they hang together.
    let mut stirred = |size: f64| {
        let radius = size * (1.0 + 0.02 * random.unit());
        random.sphere().map(|x| radius * x)
    };
    let mut rows: Vec<[f64; 3]> = (0..2000).map(|_| stirred(1.0)).collect();
    // Covered where s >= 1.5 + 0.2 s: from 1.875 on; they touch from 1.5 / 1.2 on.
    rows.extend((0..400).map(|_| stirred(0.2)).map(|[x, y, z]| [1.5 + x, y, z]));
    let crust = crust(&rows, Default::default());
    let small = |axis: &Complex| axis.vertices().iter().filter(|p| p[0] > 1.0).count();
    let apart = axis(&crust, Label::Inner, 1.01);
    assert_eq!(betti(&apart), [2, 0, 0]);
    assert!(small(&apart) > 0);
    let together = axis(&crust, Label::Inner, 1.4);
    assert_eq!(betti(&together), [1, 0, 0]);
    assert!(small(&together) > 0);
    let gone = axis(&crust, Label::Inner, 2.0);
    assert_eq!(betti(&gone), [1, 0, 0]);
    assert_eq!(small(&gone), 0);
    // What is left has the radii that it had.
    assert!(radii(&gone).iter().all(|radius| (radius - 1.0).abs() < 0.1));
}

#[test]
fn the_outer_side_has_its_own() {
    let crust = crust(&torus(), Default::default());
    let outer = axis(&crust, Label::Outer, 1.0);
    let labels = match outer.attribute(Element::Vertex, "label").unwrap().values() {
        Values::U32(labels) => labels.clone(),
        Values::F64(_) => panic!("labels are numbers"),
    };
    assert!(!labels.is_empty() && labels.iter().all(|&label| label == Label::Outer as u32));
}

#[test]
fn factors_out_of_range_and_sides_without_balls_are_errors() {
    let torus = crust(&torus(), Default::default());
    let refused = |crust: &PowerCrust, factor| {
        crust.scale_axis(Label::Inner, factor, &Job::default()).unwrap_err().status()
    };
    for factor in [f64::NAN, f64::INFINITY, 0.0, 0.999, -2.0, 1e200] {
        assert_eq!(refused(&torus, factor), Status::InvalidArgument, "{factor}");
    }
    // The corners of a cube have no inner pole.
    let corner = |i: u32| [0, 1, 2].map(|k| f64::from(i >> k & 1));
    let cube: Vec<_> = (0..8).map(corner).collect();
    let options = PowerCrustOptions::default();
    let cube = PowerCrust::build(&points(&cube), options, &Job::default()).unwrap();
    assert_eq!(refused(&cube, 1.0), Status::TooFewPoints);
    let spent = Job::default();
    spent.cancel();
    let cancelled = torus.scale_axis(Label::Inner, 1.0, &spent).unwrap_err();
    assert_eq!(cancelled.status(), Status::Cancelled);
}

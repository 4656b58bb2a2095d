//! Circles over the plane: sound and complete.

use crate::shapes::{
    Point, Random, closed, comb, distance, dot, l_shape, polygon, rectangle, rings, star, sub,
};
use medax::distance::{Cover, FieldAxis, FieldOptions, GraphOptions, MedialGraph, Piece, Sites};
use medax::{Job, JobOptions};
use std::f64::consts::PI;
use std::sync::Arc;

fn axis(sites: &Arc<Sites>, options: FieldOptions) -> FieldAxis {
    FieldAxis::new(sites, options, &Job::default()).unwrap()
}

fn figures() -> Vec<(&'static str, Arc<Sites>)> {
    let mut random = Random(17);
    let origin = [0.0; 3];
    vec![
        ("rectangle", closed(rings(&[rectangle(4.0, 2.0)]))),
        ("l", closed(rings(&[l_shape()]))),
        ("comb", closed(rings(&[comb(4)]))),
        (
            "ellipse",
            closed(rings(&[polygon(400, 1.0).iter().map(|p| [2.0 * p[0], p[1]]).collect()])),
        ),
        ("ring", closed(vec![Piece::Sphere(origin, 1.0), Piece::Sphere(origin, 2.0)])),
        ("star", closed(rings(&[star(&mut random, 15)]))),
    ]
}

/// Each point is the centre of a ball that touches the boundary twice within epsilon, that nothing enters, and passes the thresholds.
#[test]
fn every_point_is_a_medial_point() {
    for (name, sites) in figures() {
        let density = 0.05 * sites.size();
        let options = FieldOptions { density, angle: 0.3, ..FieldOptions::default() };
        let axis = axis(&sites, options);
        let epsilon = axis.options().decide.epsilon;
        let centers: Vec<Point> = axis.points().iter().map(|p| p.center).collect();
        let nearest = sites.nearest(&centers, &Job::default()).unwrap();
        let inside = sites.is_inside(&centers, &Job::default()).unwrap();
        assert!(axis.points().len() > 10, "{name}");
        for ((point, nearest), inside) in axis.points().iter().zip(nearest).zip(inside) {
            assert!(inside, "{name} {point:?}");
            assert!((nearest.distance - point.radius).abs() <= epsilon, "{name} {point:?}");
            let [a, b] = point.feet.map(|foot| sub(foot, point.center));
            assert!(a != b);
            for way in [a, b] {
                assert!(
                    (dot(way, way).sqrt() - point.radius).abs() <= 2.0 * epsilon,
                    "{name} {point:?}"
                );
            }
            let cosine = dot(a, b) / (dot(a, a) * dot(b, b)).sqrt();
            assert!(cosine.clamp(-1.0, 1.0).acos() >= 0.3 - 1e-6, "{name} {point:?}");
            assert!(point.radius >= axis.options().min_distance);
        }
    }
}

/// Every point of the exact axis beyond the stated bound has a point within the density.
#[test]
fn no_point_beyond_the_bound_is_missed() {
    for (name, sites) in figures() {
        for bound in [PI / 4.0, PI / 9.0] {
            let density = 0.06 * sites.size();
            let options = FieldOptions { density, bound, ..FieldOptions::default() };
            let axis = axis(&sites, options);
            let exact = MedialGraph::new(
                &sites,
                GraphOptions { spacing: 0.1 * density, ..GraphOptions::default() },
                &Job::default(),
            )
            .unwrap();
            check_complete(name, &axis, &exact);
        }
    }
}

/// Every point of the exact axis beyond the bound that lies in no square without a claim has a point within the density, and few squares have none.
pub fn check_complete(name: &str, axis: &FieldAxis, exact: &MedialGraph) {
    let FieldOptions { density, bound, min_distance, .. } = *axis.options();
    let (angle, unclaimed) = axis.claim();
    assert!(angle <= bound && 50 * unclaimed <= axis.covers().len(), "{name}: {angle} {unclaimed}");
    let is_unclaimed = |p: Point| {
        let holds = |c: &Cover| (0..2).all(|k| (p[k] - c.center[k]).abs() <= c.half);
        axis.covers().iter().filter(|cover| cover.missed_angle >= PI).any(holds)
    };
    let mut points: Vec<Point> = axis.points().iter().map(|p| p.center).collect();
    points.sort_by(|p, q| p.partial_cmp(q).unwrap());
    let mut checked = 0;
    for point in exact.points() {
        let center = point.center;
        if point.radius < min_distance || point.object_angle <= bound || is_unclaimed(center) {
            continue;
        }
        let begin = points.partition_point(|p| p[0] < center[0] - density);
        let near = points[begin..].iter().take_while(|p| p[0] <= center[0] + density);
        let least = near.map(|&p| distance(p, center)).fold(f64::INFINITY, f64::min);
        assert!(least <= density, "{name}: {point:?} {least}");
        checked += 1;
    }
    assert!(checked > 20, "{name} {checked}");
}

#[test]
fn a_figure_shifted_and_turned_has_the_same_axis() {
    let ring = l_shape();
    let (sine, cosine) = 0.7f64.sin_cos();
    let moved =
        |p: [f64; 2]| [10.0 + cosine * p[0] - sine * p[1], -3.0 + sine * p[0] + cosine * p[1]];
    let sites = closed(rings(std::slice::from_ref(&ring)));
    let turned = closed(rings(&[ring.into_iter().map(moved).collect()]));
    let options = FieldOptions { density: 0.1, ..FieldOptions::default() };
    let (plain, turned) = (axis(&sites, options), axis(&turned, options));
    let exact = MedialGraph::new(
        turned.sites(),
        GraphOptions { spacing: 0.01, ..Default::default() },
        &Job::default(),
    )
    .unwrap();
    for point in plain.points() {
        let at = moved([point.center[0], point.center[1]]);
        let least = exact.points().iter().map(|p| distance(p.center, [at[0], at[1], 0.0]));
        // Half of the spacing of the other one's points.
        assert!(least.fold(f64::INFINITY, f64::min) <= 0.0051, "{point:?}");
    }
}

/// Where the feet of a medial point are within the tolerance, nothing shows it: so nothing is claimed.
#[test]
fn what_the_tolerance_hides_is_not_claimed() {
    let sites = closed(rings(&[rectangle(100.0, 10.0)]));
    for tolerance in [0.0, 0.1, 1.0, 4.0, 11.0] {
        let mut options = FieldOptions { density: 1.0, ..FieldOptions::default() };
        options.decide.tolerance = tolerance;
        let axis = axis(&sites, options);
        let all: Vec<Point> = (0..=90).map(|i| [5.0 + f64::from(i), 5.0, 0.0]).collect();
        for p in all {
            let is_found = axis.points().iter().any(|q| distance(p, q.center) <= 2.0);
            // Its object angle is pi.
            let holds = |cover: &&Cover| distance(p, cover.center) <= cover.radius;
            let claims = |cover: &Cover| cover.found == 0 && cover.missed_angle < PI;
            let mut covers = axis.covers().iter().filter(holds);
            assert!(is_found || !covers.any(claims), "{tolerance} {p:?}");
        }
    }
}

/// Feet, radii and angles are rounded as coordinates are: [`FieldAxis::validate`] knows.
#[test]
fn far_from_the_origin_an_axis_is_valid() {
    let moved = |ring: Vec<[f64; 2]>| ring.iter().map(|p| [p[0] + 1e6, p[1] - 3e6]).collect();
    let mut random = Random(23);
    let sites = closed(rings(&[moved(star(&mut random, 12))]));
    let axis = axis(&sites, FieldOptions { density: 0.1, ..FieldOptions::default() });
    let report = axis.validate(&Job::default()).unwrap();
    assert!(report.is_valid() && axis.points().len() > 10, "{report:?}");
}

#[test]
fn the_bytes_are_the_same_whatever_the_threads() {
    let (_, sites) = figures().pop().unwrap();
    let found = [1, 2, 5].map(|threads| {
        let job = Job::new(JobOptions { threads, ..JobOptions::default() });
        let axis = FieldAxis::new(&sites, FieldOptions::default(), &job).unwrap();
        let graph = MedialGraph::new(&sites, GraphOptions::default(), &job).unwrap();
        (axis.complex(&job).unwrap(), graph.complex(&job).unwrap(), axis.covers().to_vec())
    });
    assert!(found[0] == found[1] && found[0] == found[2]);
}

//! Arcs and junctions.

use crate::shapes::{
    Random, closed, comb, distance, l_shape, open, polygon, rectangle, rings, star,
};
use medax::complex::Topology;
use medax::distance::{GraphOptions, MedialGraph, Piece, Sites};
use medax::medial::Side;
use medax::{Job, JobOptions, Progress, Stage, Status};
use std::sync::Arc;

fn graph(sites: &Arc<Sites>, options: GraphOptions) -> MedialGraph {
    MedialGraph::new(sites, options, &Job::default()).unwrap()
}

fn topology(graph: &MedialGraph) -> Topology {
    let complex = graph.complex(&Job::default()).unwrap();
    complex.topology(&Job::default()).unwrap()
}

/// Every point is the centre of a ball that touches the boundary twice and that nothing enters.
fn check_balls(graph: &MedialGraph) {
    let centers: Vec<_> = graph.points().iter().map(|point| point.center).collect();
    let nearest = graph.sites().nearest(&centers, &Job::default()).unwrap();
    let size = graph.sites().size();
    for (i, (point, nearest)) in graph.points().iter().zip(nearest).enumerate() {
        assert!(
            (point.radius - nearest.distance).abs() < 1e-8 * size,
            "{i}: {point:?} {nearest:?}"
        );
        if i >= graph.node_count() {
            for foot in point.feet {
                assert!(
                    (distance(foot, point.center) - point.radius).abs() < 1e-9 * size,
                    "{point:?}"
                );
            }
        }
    }
}

#[test]
fn the_axis_of_a_rectangle_has_five_arcs() {
    let sites = closed(rings(&[rectangle(4.0, 2.0)]));
    let graph = graph(&sites, GraphOptions::default());
    assert_eq!((graph.arcs().len(), graph.node_count(), graph.torn()), (5, 6, 0));
    let mut nodes: Vec<[f64; 2]> =
        graph.points()[..6].iter().map(|p| [p.center[0], p.center[1]]).collect();
    nodes.sort_by(|a, b| a.partial_cmp(b).unwrap());
    let expected = [[0.0, 0.0], [0.0, 2.0], [1.0, 1.0], [3.0, 1.0], [4.0, 0.0], [4.0, 2.0]];
    for (node, expected) in nodes.iter().zip(expected) {
        assert!((0..2).all(|k| (node[k] - expected[k]).abs() < 1e-12), "{nodes:?}");
    }
    check_balls(&graph);
}

#[test]
fn a_square_has_one_junction_of_four_arcs() {
    let sites = closed(rings(&[rectangle(2.0, 2.0)]));
    let graph = graph(&sites, GraphOptions::default());
    assert_eq!((graph.arcs().len(), graph.node_count(), graph.torn()), (4, 5, 0));
    check_balls(&graph);
}

#[test]
fn graphs_have_the_betti_numbers_of_the_region() {
    let ring = |center: [f64; 2], size: f64, turned: bool| -> Vec<[f64; 2]> {
        let mut ring: Vec<_> =
            polygon(7, size).iter().map(|p| [p[0] + center[0], p[1] + center[1]]).collect();
        if turned {
            ring.reverse();
        }
        ring
    };
    let cases = vec![
        ("l", vec![l_shape()], [1, 0]),
        ("comb", vec![comb(5)], [1, 0]),
        ("regular", vec![polygon(12, 1.0)], [1, 0]),
        ("many", vec![polygon(200, 1.0)], [1, 0]),
        (
            "frame",
            vec![rectangle(4.0, 4.0), vec![[1.0, 1.0], [1.0, 3.0], [3.0, 3.0], [3.0, 1.0]]],
            [1, 1],
        ),
        (
            "two holes",
            vec![rectangle(10.0, 4.0), ring([3.0, 2.0], 1.0, true), ring([7.0, 2.1], 1.3, true)],
            [1, 2],
        ),
        ("two parts", vec![rectangle(1.0, 1.0), ring([5.0, 0.0], 1.0, false)], [2, 0]),
    ];
    for (name, figure, betti) in cases {
        let graph = graph(&closed(rings(&figure)), GraphOptions::default());
        let found = topology(&graph).betti;
        assert_eq!((&found[..2], graph.torn()), (&betti[..], 0), "{name}");
        check_balls(&graph);
    }
}

#[test]
fn the_axis_of_a_ring_of_circles_is_a_circle() {
    let origin = [0.0; 3];
    let sites = closed(vec![Piece::Sphere(origin, 1.0), Piece::Sphere(origin, 2.0)]);
    let graph = graph(&sites, GraphOptions::default());
    assert_eq!(&topology(&graph).betti[..2], [1, 1]);
    for point in graph.points() {
        assert!((distance(point.center, origin) - 1.5).abs() < 1e-12);
        assert!((point.radius - 0.5).abs() < 1e-12);
    }
}

#[test]
fn random_stars_are_trees() {
    let mut random = Random(7);
    for count in [5, 17, 60, 300] {
        for _ in 0..20 {
            let ring = star(&mut random, count);
            let graph = graph(&closed(rings(&[ring])), GraphOptions::default());
            assert_eq!((&topology(&graph).betti[..2], graph.torn()), (&[1, 0][..], 0), "{count}");
            check_balls(&graph);
        }
    }
}

#[test]
fn the_outside_of_segments_is_their_voronoi_diagram() {
    // Two segments that face each other: a segment between, and parabolas beyond.
    let pieces = vec![
        Piece::Segment([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]),
        Piece::Segment([[0.0, 1.0, 0.0], [1.0, 1.0, 0.0]]),
        Piece::Point([3.0, 0.5, 0.0]),
    ];
    let clip = Some([[-5.0, -5.0, 0.0], [5.0, 5.0, 0.0]]);
    let options = GraphOptions { side: Side::Outer, clip, ..GraphOptions::default() };
    let graph = graph(&open(2, pieces), options);
    check_balls(&graph);
    assert_eq!((topology(&graph).components, graph.torn()), (1, 0));
    let on_middle = |p: &&medax::distance::MedialPoint| p.center[0] > 0.1 && p.center[0] < 0.9;
    assert!(graph.points().iter().filter(on_middle).count() > 10);
    assert!(graph.points().iter().filter(on_middle).all(|p| (p.center[1] - 0.5).abs() < 1e-12));
}

#[test]
fn thresholds_cut_arcs_where_they_are_passed() {
    let sites = closed(rings(&[rectangle(4.0, 2.0)]));
    let options = GraphOptions { min_distance: 0.25, ..GraphOptions::default() };
    let graph = graph(&sites, options);
    assert_eq!(&topology(&graph).betti[..2], [1, 0]);
    let least = graph.points().iter().map(|p| p.radius).fold(f64::INFINITY, f64::min);
    assert!((0.25..0.25 + 1e-9).contains(&least), "{least}");
    let options = GraphOptions { angle: 2.0, ..GraphOptions::default() };
    let middle = MedialGraph::new(&sites, options, &Job::default()).unwrap();
    assert!(middle.points().iter().all(|p| (p.center[1] - 1.0).abs() < 1e-9));
    assert_eq!(middle.arcs().len(), 1);
}

/// A host that looks at progress can stop a build, which tells it how far it is on the way.
#[test]
fn a_build_reports_progress_and_stops() {
    let mut random = Random(23);
    let points = (0..3000).map(|_| Piece::Point(random.flat(0.0, 1.0))).collect();
    let sites = open(2, points);
    let options = GraphOptions { side: Side::Outer, ..GraphOptions::default() };
    let progress: Progress = Box::new(|_, stage| stage != Stage::Field);
    let job = Job::new(JobOptions { progress: Some(progress), ..JobOptions::default() });
    let stopped = MedialGraph::new(&sites, options, &job).unwrap_err();
    assert_eq!(stopped.status(), Status::Cancelled);
    assert!(job.progress() < 1.0);
}

#[test]
fn memory_is_counted_while_arcs_are_followed() {
    let sites = closed(rings(&[rectangle(4.0, 2.0)]));
    let job = Job::default();
    let options = GraphOptions { spacing: 1e-4, ..Default::default() };
    let graph = MedialGraph::new(&sites, options, &job).unwrap();
    // The points of the lines, and those of the graph.
    let least = 2 * size_of_val(graph.points()) as u64;
    assert!(job.memory_peak() > least, "{} of {least}", job.memory_peak());
    let tight = Job::new(JobOptions { memory_ceiling: least / 2, ..Default::default() });
    let error = MedialGraph::new(&sites, options, &tight).unwrap_err();
    assert_eq!(error.status(), Status::OutOfMemory);
}

#[test]
fn a_spacing_without_end_is_refused() {
    let sites = closed(rings(&[rectangle(4.0, 2.0)]));
    let with = |spacing| GraphOptions { spacing, ..Default::default() };
    let clipped = GraphOptions { clip: Some([[0.0; 3], [1e9, 1.0, 0.0]]), ..with(1e-2) };
    for options in [with(3.8e-6), with(f64::MIN_POSITIVE), clipped] {
        let error = MedialGraph::new(&sites, options, &Job::default()).unwrap_err();
        assert_eq!(error.status(), Status::LimitExceeded);
        assert_eq!(error.to_string(), "the spacing is less than 2^-20 of the box");
    }
}

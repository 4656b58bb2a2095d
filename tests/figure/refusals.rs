//! What is no figure: the error names the ring, and says where and what.

use crate::drawing::*;
use medax::figure::{FigureOptions, FigureParts};
use medax::{ElementKind, Error, Figure, Job, JobOptions, Status};

fn refused(drawing: &Drawing, status: Status, element: Option<(ElementKind, u64)>, says: &str) {
    let error = drawing.strict().unwrap_err();
    assert_eq!((error.status(), error.element()), (status, element), "{error}");
    assert!(error.message().contains(says), "{error}");
}

fn ring(i: u64) -> Option<(ElementKind, u64)> {
    Some((ElementKind::Ring, i))
}

#[test]
fn numbers_that_are_none() {
    for (x, status) in [
        (f64::NAN, Status::NonFinite),
        (f64::NEG_INFINITY, Status::NonFinite),
        (1e61, Status::CoordinateRange),
        (1e-50, Status::CoordinateRange),
    ] {
        let good = square(0.0, 0.0, 1.0);
        let mut bad = square(5.0, 0.0, 1.0);
        bad[2][1] = x;
        let drawing = Drawing::polygons(&[&[&good], &[&bad]]);
        refused(&drawing, status, ring(1), &format!("vertex 2, (6, {x})"));
        let drawing = Drawing::polylines(&[&[[0.0, 1.0], [0.0, x]]]);
        refused(&drawing, status, Some((ElementKind::Polyline, 0)), "vertex 1");
        let drawing = Drawing { points: vec![[0.0, 1.0], [x, 0.0]], ..Drawing::default() };
        refused(&drawing, status, Some((ElementKind::Row, 1)), "vertex 0");
        for i in 0..3 {
            let mut circle = [1.0; 3];
            circle[i] = x;
            let drawing = Drawing::circles(&[[9.0, 9.0, 1.0], circle]);
            refused(&drawing, status, Some((ElementKind::Circle, 1)), "centre (");
        }
    }
    for radius in [0.0, -0.0, -1.0] {
        let drawing = Drawing::circles(&[[0.0, 0.0, radius]]);
        let element = Some((ElementKind::Circle, 0));
        refused(&drawing, Status::InvalidArgument, element, "greater than 0");
    }
}

#[test]
fn rings_that_enclose_nothing() {
    let few = Status::TooFewPoints;
    let good = square(0.0, 0.0, 1.0);
    let two = [[5.0, 7.0], [6.0, 7.0]];
    for bad in [
        &[][..],
        &[[5.0, 7.0]],
        &two,
        &[two[0], two[0], two[0]],
        &[two[0], two[1], two[0]],
        &[two[0], two[1], two[0], two[1]],
    ] {
        refused(&Drawing::polygons(&[&[&good, bad]]), few, ring(1), "three distinct vertices");
    }
    let flat = [[5.0, 7.0], [6.0, 7.5], [9.0, 9.0], [7.0, 8.0]];
    refused(&Drawing::polygons(&[&[&flat]]), Status::Degenerate, ring(0), "begins at (5, 7)");
    let line = Some((ElementKind::Polyline, 0));
    refused(&Drawing::polylines(&[&[]]), few, line, "two distinct");
    refused(&Drawing::polylines(&[&[[1.0, 2.0], [1.0, 2.0]]]), few, line, "begins at (1, 2)");
    refused(&Drawing::default(), few, None, "nothing");
}

#[test]
fn rings_that_cross_or_touch_themselves() {
    let cases: [(&[Point], &str); 6] = [
        // A proper crossing.
        (
            &[[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0]],
            "edge 0 of ring 0 from (0, 0) to (4, 4) crosses or touches \
             edge 2 of ring 0 from (4, 0) to (0, 4), at (2, 2)",
        ),
        // A vertex on a vertex.
        (&[[0.0, 0.0], [2.0, 1.0], [4.0, 0.0], [4.0, 4.0], [2.0, 1.0], [0.0, 4.0]], "at (2, 1)"),
        // A vertex on an edge.
        (&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 0.0], [0.0, 4.0]], "at (2, 0)"),
        // Edges that overlap: a spike, a folded corner, and apart.
        (&[[0.0, 0.0], [4.0, 0.0], [2.0, 0.0], [2.0, 4.0]], "edge 1 of ring 0"),
        (&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [4.0, 2.0], [0.0, 2.0]], "edge 2 of ring 0"),
        (
            &[[0.0, 0.0], [6.0, 0.0], [6.0, 3.0], [4.0, 3.0], [4.0, 0.0], [2.0, 0.0], [2.0, 3.0]],
            "edge 3 of ring 0 from (4, 3) to (4, 0), at (4, 0)",
        ),
    ];
    for (bad, says) in cases {
        refused(&Drawing::polygons(&[&[bad]]), Status::InvalidArgument, ring(0), says);
        // The numbers are those of the given rows, also where some are dropped.
        let mut given = vec![bad[0]; 3];
        given.extend(&bad[1..]);
        given.push(bad[0]);
        let error = Drawing::polygons(&[&[&given]]).strict().unwrap_err();
        assert_eq!(error.element(), ring(0), "{error}");
        let figure = Drawing::polygons(&[&[&given]]).make(ACCEPT).unwrap();
        check(&figure);
        assert!(figure.normalised().crossings > 0);
    }
    let given = [[0.0, 0.0], [0.0, 0.0], [4.0, 4.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0]];
    let error = Drawing::polygons(&[&[&given]]).strict().unwrap_err();
    assert!(error.message().contains("edge 1 of ring 0"), "{error}");
    assert!(error.message().contains("edge 4 of ring 0"), "{error}");
}

#[test]
fn curves_that_cross_or_touch_one_another() {
    let a = square(0.0, 0.0, 4.0);
    let invalid = Status::InvalidArgument;
    let others: [Vec<Point>; 4] = [
        square(2.0, 2.0, 4.0),
        square(4.0, 4.0, 1.0),
        square(4.0, 1.0, 1.0),
        vec![[6.0, 2.0], [4.0, 2.0], [6.0, 3.0]],
    ];
    for other in &others {
        refused(&Drawing::polygons(&[&[&a], &[other]]), invalid, ring(0), "of ring 1");
        let mut drawing = Drawing::polygons(&[&[&a]]);
        drawing.polylines = vec![vec![[20.0, 0.0], [21.0, 0.0]], other.clone()];
        refused(&drawing, invalid, ring(0), "of polyline 1");
    }
    // An end in the middle of another, and a polyline over itself.
    let line = Some((ElementKind::Polyline, 0));
    let tee: [&[Point]; 2] = [&[[0.0, 0.0], [4.0, 0.0]], &[[2.0, 0.0], [2.0, 3.0]]];
    refused(&Drawing::polylines(&tee), invalid, line, "at (2, 0)");
    let inner: [&[Point]; 2] = [&[[0.0, 0.0], [2.0, 0.0], [4.0, 0.0]], &[[2.0, 0.0], [2.0, 3.0]]];
    refused(&Drawing::polylines(&inner), invalid, line, "at (2, 0)");
    let twice: [&[Point]; 2] = [&[[0.0, 0.0], [4.0, 0.0]], &[[4.0, 0.0], [1.0, 0.0]]];
    refused(&Drawing::polylines(&twice), invalid, line, "of polyline 1");
    let back: [&[Point]; 1] = [&[[0.0, 0.0], [4.0, 0.0], [1.0, 0.0]]];
    refused(&Drawing::polylines(&back), invalid, line, "edge 1 of polyline 0");
}

#[test]
fn circles_that_cross_or_touch() {
    let invalid = Status::InvalidArgument;
    let mut drawing = Drawing::polygons(&[&[&square(0.0, 0.0, 4.0)]]);
    // Across a corner, touching a side from outside, round a corner.
    for circle in [[0.0, 0.0, 1.0], [6.0, 2.0, 2.0], [-3.0, -4.0, 5.0]] {
        drawing.circles = vec![[50.0, 0.0, 1.0], circle];
        refused(&drawing, invalid, ring(0), "circle 1 of radius");
        assert_eq!(drawing.make(ACCEPT).unwrap().normalised().misplaced, 0);
    }
    let circle = Some((ElementKind::Circle, 0));
    for other in [[2.0, 0.0, 1.0], [0.0, 0.0, 1.0], [0.5, 0.0, 0.5], [1.0, 0.0, 1.0]] {
        refused(&Drawing::circles(&[[0.0, 0.0, 1.0], other]), invalid, circle, "circle 1");
    }
    // By one unit in the last place.
    let near = 2f64.next_up();
    check(&Drawing::circles(&[[0.0, 0.0, 1.0], [near, 0.0, 1.0]]).strict().unwrap());
    drawing.circles = vec![[6f64.next_up(), 2.0, 2.0]];
    check(&drawing.strict().unwrap());
    refused(
        &Drawing::circles(&[[0.0, 0.0, 2.0], [0.5, 0.0, 1.0]]),
        invalid,
        Some((ElementKind::Circle, 1)),
        "lies in circle 0",
    );
}

#[test]
fn rings_in_the_wrong_place() {
    let invalid = Status::InvalidArgument;
    let (outer, inner) = (square(0.0, 0.0, 10.0), square(2.0, 2.0, 5.0));
    let (core, far) = (square(3.0, 3.0, 1.0), square(30.0, 2.0, 5.0));
    let hole_outside = Drawing::polygons(&[&[&outer, &far]]);
    refused(&hole_outside, invalid, ring(1), "first vertex at (30, 2) lies outside the polygon");
    let hole_round = Drawing::polygons(&[&[&inner, &outer]]);
    refused(&hole_round, invalid, ring(1), "lies outside the polygon");
    let hole_in_hole = Drawing::polygons(&[&[&outer, &inner, &core]]);
    refused(&hole_in_hole, invalid, ring(2), "lies in ring 1");
    let hole_elsewhere = Drawing::polygons(&[&[&outer], &[&far, &inner]]);
    refused(&hole_elsewhere, invalid, ring(2), "lies in ring 0");
    let nested = Drawing::polygons(&[&[&inner], &[&outer]]);
    refused(
        &nested,
        invalid,
        ring(0),
        "the polygon with its first vertex at (2, 2) lies in ring 1",
    );
    let in_island = Drawing::polygons(&[&[&core], &[&outer], &[&inner]]);
    refused(&in_island, invalid, ring(0), "lies in ring 2");
    let mut disc = Drawing::polygons(&[&[&outer]]);
    disc.circles = vec![[5.0, 5.0, 1.0]];
    refused(&disc, invalid, Some((ElementKind::Circle, 0)), "centre at (5, 5) lies in ring 0");
    disc.circles = vec![[5.0, 5.0, 100.0]];
    refused(&disc, invalid, ring(0), "lies in circle 0 of radius 100 round (5, 5)");
}

#[test]
fn arrays_that_do_not_fit() {
    let vertices = square(0.0, 0.0, 1.0);
    let sound = FigureParts {
        ring_vertices: &vertices,
        ring_offsets: &[0, 4],
        polygon_offsets: &[0, 1],
        ..FigureParts::default()
    };
    let make = |parts| Figure::new(parts, FigureOptions::default(), &Job::default());
    check(&make(sound).unwrap());
    let row = |i| Some((ElementKind::Row, i));
    let cases = [
        (FigureParts { ring_offsets: &[0, 3], ..sound }, Status::Mismatch, None),
        (FigureParts { ring_offsets: &[0, 5], ..sound }, Status::Mismatch, None),
        (FigureParts { ring_offsets: &[1, 4], ..sound }, Status::InvalidArgument, row(0)),
        (FigureParts { ring_offsets: &[0, 5, 4], ..sound }, Status::InvalidArgument, row(2)),
        (FigureParts { ring_offsets: &[], ..sound }, Status::Mismatch, None),
        (FigureParts { polygon_offsets: &[0, 0, 1], ..sound }, Status::InvalidArgument, row(0)),
        (FigureParts { polygon_offsets: &[0, 2], ..sound }, Status::Mismatch, None),
        (FigureParts { polygon_offsets: &[], ..sound }, Status::Mismatch, None),
        (FigureParts { polyline_offsets: &[0, 1], ..sound }, Status::Mismatch, None),
        (FigureParts { polyline_vertices: &vertices, ..sound }, Status::Mismatch, None),
    ];
    for (i, (parts, status, element)) in cases.into_iter().enumerate() {
        let error: Error = make(parts).unwrap_err();
        assert_eq!((error.status(), error.element()), (status, element), "case {i}: {error}");
    }
}

#[test]
fn a_job_stops_it_and_its_memory_is_counted() {
    let star: Vec<Point> =
        (0..100_000).map(|i| [f64::from(i), f64::from(i % 2 + 1 + i / 99_999)]).collect();
    let mut ring = star;
    ring.push([50_000.0, -1e6]);
    let drawing = Drawing::polygons(&[&[&ring]]);
    let job = Job::default();
    job.cancel();
    let error = drawing.make_with(FigureOptions::default(), &job).unwrap_err();
    assert_eq!(error.status(), Status::Cancelled);
    let job = Job::new(JobOptions { memory_ceiling: 1_000_000, ..JobOptions::default() });
    let error = drawing.make_with(FigureOptions::default(), &job).unwrap_err();
    assert_eq!(error.status(), Status::OutOfMemory);
    let figure = |threads| {
        let job = Job::new(JobOptions { threads, ..JobOptions::default() });
        drawing.make_with(FigureOptions::default(), &job).unwrap()
    };
    assert_eq!(figure(1), figure(3));
    check(&figure(1));
}

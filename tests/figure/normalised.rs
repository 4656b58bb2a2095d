//! What is changed in a figure, and counted.

use crate::drawing::*;
use medax::figure::{ChainKind, Normalised};

#[test]
fn rings_are_closed_cleaned_and_turned_and_all_is_counted() {
    let mut outer = square(0.0, 0.0, 10.0);
    outer.reverse();
    outer.push(outer[0]);
    let mut hole = square(2.0, 2.0, 3.0);
    hole.insert(1, hole[0]);
    hole.insert(1, hole[0]);
    // A vertex on a straight side stays.
    hole.push([2.0, 3.0]);
    let drawing = Drawing {
        polygons: vec![vec![outer.clone(), hole]],
        polylines: vec![vec![[20.0, 0.0], [20.0, 0.0], [21.0, -0.0]]],
        points: vec![[5.0, -0.0], [5.0, 0.0]],
        circles: vec![[-0.0, 20.0, 1.0]],
    };
    let figure = drawing.strict().unwrap();
    check(&figure);
    let counts = Normalised {
        closing_vertices: 1,
        repeated_vertices: 3,
        turned_rings: 2,
        ..Normalised::default()
    };
    assert_eq!(*figure.normalised(), counts);
    use ChainKind::*;
    assert_eq!(figure.kinds(), [Outer, Hole, Polyline, Point, Point]);
    assert_eq!(figure.parts(), [0, 0, 1, 2, 3]);
    assert_eq!((figure.part_count(), figure.part_of_circle(0)), (5, 4));
    // Turned, with the first vertex first.
    assert_eq!(chain(&figure, 0), [[0.0, 10.0], [0.0, 0.0], [10.0, 0.0], [10.0, 10.0]]);
    assert_eq!(chain(&figure, 1), [[2.0, 2.0], [2.0, 3.0], [2.0, 5.0], [5.0, 5.0], [5.0, 2.0]]);
    assert_eq!(chain(&figure, 2), [[20.0, 0.0], [21.0, 0.0]]);
    let numbers = figure.vertices().as_flattened().iter().chain(figure.circles().as_flattened());
    assert!(numbers.into_iter().all(|x| x.to_bits() != (-0.0f64).to_bits()));
    let edges: Vec<[u32; 2]> = figure.edges(1).collect();
    assert_eq!(edges, [[4, 5], [5, 6], [6, 7], [7, 8], [8, 4]]);
    assert_eq!(figure.edges(2).collect::<Vec<_>>(), [[9, 10]]);
    assert_eq!(figure.edges(3).count(), 0);
    assert_eq!(figure.chain_count(Point), 2);
    let bounds = figure.bounds();
    assert!(bounds.min[0] < -1.0 && bounds.min[0] > -1.001 && bounds.max[1] > 21.0);
    assert_eq!((bounds.max[0], bounds.min[1], bounds.max[2]), (21.0, 0.0, 0.0));
}

#[test]
fn a_ring_that_is_right_stays_as_it_is() {
    let mut hole = square(2.0, 2.0, 3.0);
    hole.reverse();
    let drawing = Drawing::polygons(&[&[&square(0.0, 0.0, 10.0), &hole]]);
    let figure = drawing.strict().unwrap();
    check(&figure);
    assert_eq!(*figure.normalised(), Normalised::default());
    assert_eq!([chain(&figure, 0), chain(&figure, 1)], [square(0.0, 0.0, 10.0), hole]);
}

#[test]
fn polylines_may_share_their_ends_and_close() {
    let drawing = Drawing::polylines(&[
        &[[0.0, 0.0], [1.0, 0.0], [2.0, 1.0]],
        &[[2.0, 1.0], [3.0, 0.0]],
        &[[4.0, 4.0], [2.0, 1.0]],
        // Closed: its ends are one place.
        &[[3.0, 0.0], [5.0, 0.0], [5.0, 2.0], [3.0, 0.0]],
    ]);
    let figure = drawing.strict().unwrap();
    check(&figure);
    assert_eq!(chain(&figure, 3).len(), 4);
    assert_eq!(*figure.normalised(), Normalised::default());
}

#[test]
fn islands_may_lie_in_holes_and_points_anywhere() {
    let (outer, hole) = (square(0.0, 0.0, 10.0), square(1.0, 1.0, 8.0));
    let (island, pond) = (square(2.0, 2.0, 6.0), square(3.0, 3.0, 4.0));
    let mut drawing = Drawing::polygons(&[&[&outer, &hole], &[&island, &pond]]);
    drawing.circles = vec![[5.0, 5.0, 1.0], [1.5, 1.5, 0.25], [20.0, 20.0, 5.0]];
    // On a vertex, on an edge, in the middle of a disc, twice.
    drawing.points = vec![[0.0, 0.0], [5.0, 0.0], [5.0, 5.0], [5.0, 5.0]];
    // Within a polygon, and within a disc.
    drawing.polylines = vec![vec![[0.25, 0.25], [0.5, 0.5]], vec![[20.0, 20.0], [21.0, 20.0]]];
    let figure = drawing.strict().unwrap();
    check(&figure);
    assert_eq!(figure.part_count(), 2 + 2 + 4 + 3);
}

#[test]
fn what_crosses_is_accepted_on_request_and_counted() {
    let bow = [[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]];
    let crossed = Drawing::polygons(&[&[&bow]]).make(ACCEPT).unwrap();
    check(&crossed);
    assert_eq!((crossed.normalised().crossings, crossed.normalised().misplaced), (1, 0));
    // Three squares one in another, a disc in the inmost, and a hole outside.
    let (a, b, c) = (square(0.0, 0.0, 10.0), square(1.0, 1.0, 8.0), square(2.0, 2.0, 6.0));
    let far = square(30.0, 0.0, 2.0);
    let mut drawing = Drawing::polygons(&[&[&a, &far], &[&b], &[&c]]);
    drawing.circles = vec![[5.0, 5.0, 1.0]];
    let nested = drawing.make(ACCEPT).unwrap();
    check(&nested);
    assert_eq!((nested.normalised().crossings, nested.normalised().misplaced), (0, 4));
    // A disc round all of them.
    drawing.circles = vec![[5.0, 5.0, 100.0]];
    let round = drawing.make(ACCEPT).unwrap();
    check(&round);
    assert_eq!((round.normalised().crossings, round.normalised().misplaced), (0, 4));
}

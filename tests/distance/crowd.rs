//! Arcs and junctions among much that is apart: the axis has the Betti numbers of the region, in general position and where much is equally far.

use crate::shapes::{Random, polygon, rectangle, rings, star};
use medax::Job;
use medax::distance::{GraphOptions, MedialGraph, Piece, Sites};
use medax::medial::Side;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// Closed curves, then what is not closed.
fn sites(closed: Vec<Piece>, open: Vec<Piece>) -> Arc<Sites> {
    let is_closed = (0..closed.len() + open.len()).map(|i| i < closed.len()).collect();
    let pieces: Vec<Piece> = closed.into_iter().chain(open).collect();
    let count = pieces.len();
    let sites = Sites::new(2, pieces, vec![0; count], &Job::default()).unwrap();
    Arc::new(sites.with_closed(is_closed).unwrap())
}

/// The first two Betti numbers, and how many sides are torn, once everything is checked.
fn found(sites: &Arc<Sites>, side: Side) -> ([u64; 2], usize) {
    let job = Job::default();
    let clip = (side == Side::Outer).then_some([[-20.0, -20.0, 0.0], [40.0, 40.0, 0.0]]);
    let options = GraphOptions { side, clip, ..GraphOptions::default() };
    let graph = MedialGraph::new(sites, options, &job).unwrap();
    let report = graph.validate(&job).unwrap();
    assert!(report.is_valid(), "{report:?}");
    let betti = graph.complex(&job).unwrap().topology(&job).unwrap().betti;
    ([betti[0], betti[1]], graph.torn())
}

fn moved(ring: &[[f64; 2]], by: [f64; 2]) -> Vec<[f64; 2]> {
    ring.iter().map(|p| [p[0] + by[0], p[1] + by[1]]).collect()
}

fn turned(mut ring: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    ring.reverse();
    ring
}

#[test]
fn points_in_a_figure_are_holes() {
    let mut random = Random(3);
    for count in [1, 2, 3, 5, 20] {
        for _ in 0..20 {
            let mut coordinate = || 0.1 + 0.8 * random.unit();
            let points = (0..count).map(|_| Piece::Point([coordinate(), coordinate(), 0.0]));
            let points: Vec<Piece> = points.collect();
            let sites = sites(rings(&[rectangle(1.0, 1.0)]), points);
            assert_eq!(found(&sites, Side::Inner), ([1, count], 0));
        }
    }
}

#[test]
fn stars_with_holes_and_a_slit_have_their_betti_numbers() {
    let mut random = Random(5);
    for _ in 0..30 {
        let outer: Vec<_> = star(&mut random, 20).iter().map(|p| p.map(|x| 10.0 * x)).collect();
        let near = outer.iter().map(|p| p[0].hypot(p[1])).fold(f64::INFINITY, f64::min);
        let hole = |at: f64| turned(moved(&polygon(7, 0.1 * near), [at * near, 0.05 * near]));
        let slit = [[-0.1, -0.3, 0.0], [0.2, -0.25, 0.0]].map(|p| p.map(|x| x * near));
        let curves = rings(&[outer, hole(0.3), hole(-0.3)]);
        let sites = sites(curves, vec![Piece::Segment(slit)]);
        assert_eq!(found(&sites, Side::Inner), ([1, 3], 0));
    }
}

/// Holes and other things on places of a lattice, so that three or more are as far from many centres.
#[test]
fn what_is_equally_far_is_told_apart() {
    let mut random = Random(11);
    for round in 0..400 {
        let mut places: Vec<[f64; 2]> =
            (0..12).map(|i| [1 + i / 3 * 3, 1 + i % 3 * 3]).map(|p| p.map(f64::from)).collect();
        let count = 1 + (random.unit() * 6.0) as usize;
        while places.len() > count {
            let i = (random.unit() * places.len() as f64) as usize;
            places.swap_remove(i);
        }
        let outer = rectangle(if random.unit() < 0.5 { 13.0 } else { 16.0 }, 12.0);
        let square = turned(rectangle(1.0, 1.0));
        let triangle = vec![[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]];
        let diamond = vec![[0.0, 1.0], [1.0, 2.0], [2.0, 1.0], [1.0, 0.0]];
        let holes = |hole: &[[f64; 2]]| -> Vec<Vec<[f64; 2]>> {
            let holes = places.iter().map(|&by| moved(hole, by));
            [outer.clone()].into_iter().chain(holes).collect()
        };
        let at = |[x, y]: [f64; 2]| [x + 1.0, y + 1.0, 0.0];
        let turn = [0.0, PI / 6.0, PI / 4.0, TAU * random.unit()][round / 6 % 4];
        let jitter = [0.0, 0.0, 1e-9, 1e-3][round / 24 % 4];
        let alone = rings(std::slice::from_ref(&outer));
        let (kind, sites) = match round % 6 {
            0 => ("squares", sites(rings(&holes(&square)), vec![])),
            1 => ("triangles", sites(rings(&holes(&triangle)), vec![])),
            2 => ("diamonds", sites(rings(&holes(&diamond)), vec![])),
            3 => ("points", sites(alone, places.iter().map(|&p| Piece::Point(at(p))).collect())),
            4 => {
                let mut circle =
                    |&p| Piece::Sphere(at(p), if random.unit() < 0.5 { 0.5 } else { 1.0 });
                let circles = places.iter().map(&mut circle);
                ("circles", sites(alone.into_iter().chain(circles).collect(), vec![]))
            }
            _ => {
                let mut slit = |&p: &[f64; 2]| {
                    let [x, y, _] = at(p);
                    Piece::Segment([
                        [x - 1.0, y - 1.0, 0.0],
                        [x + 1.0, y - 1.0 + (random.unit() * 3.0).floor(), 0.0],
                    ])
                };
                let slits = places.iter().map(&mut slit).collect();
                ("slits", sites(alone, slits))
            }
        };
        let sites = moved_pieces(&sites, |[x, y, _]| {
            let (x, y) = (x + jitter * random.unit(), y + jitter * random.unit());
            [x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos(), 0.0]
        });
        let context = || format!("{kind} {places:?} turned by {turn}, jitter {jitter}");
        assert_eq!(found(&sites, Side::Inner), ([1, count as u64], 0), "{}", context());
    }
}

/// The same pieces with their points elsewhere, ends of segments that are one again one.
fn moved_pieces(sites: &Sites, mut to: impl FnMut([f64; 3]) -> [f64; 3]) -> Arc<Sites> {
    let mut known: Vec<([f64; 3], [f64; 3])> = Vec::new();
    let mut at = |p: [f64; 3]| match known.iter().find(|(from, _)| *from == p) {
        Some((_, to)) => *to,
        None => {
            known.push((p, to(p)));
            known[known.len() - 1].1
        }
    };
    let is_closed = |piece: &Piece| !matches!(piece, Piece::Point(_));
    let pieces: Vec<Piece> = sites
        .pieces()
        .iter()
        .map(|&piece| match piece {
            Piece::Segment(ends) => Piece::Segment(ends.map(&mut at)),
            Piece::Sphere(center, radius) => Piece::Sphere(at(center), radius),
            Piece::Point(p) => Piece::Point(at(p)),
            other => other,
        })
        .collect();
    // A slit has an end of one segment alone.
    let ends = |p: [f64; 3]| {
        let has = |piece: &Piece| matches!(piece, Piece::Segment(ends) if ends.contains(&p));
        pieces.iter().filter(|piece| has(piece)).count()
    };
    let closed = pieces.iter().map(|piece| match piece {
        Piece::Segment([a, b]) => ends(*a) > 1 && ends(*b) > 1,
        piece => is_closed(piece),
    });
    let closed = closed.collect();
    let count = pieces.len();
    let sites = Sites::new(2, pieces.clone(), vec![0; count], &Job::default()).unwrap();
    Arc::new(sites.with_closed(closed).unwrap())
}

/// Vertices that are straight, or nearly, and polylines that share an end.
#[test]
fn straight_vertices_and_joints_change_no_topology() {
    let mut random = Random(17);
    for round in 0..200 {
        let jitter = [0.0, 1e-15, 1e-12, 1e-9, 1e-3][round % 5];
        let turn = TAU * random.unit();
        let mut at = |x: f64, y: f64| {
            let (x, y) = (x + jitter * random.unit(), y + jitter * random.unit());
            [x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos()]
        };
        let mut outer = Vec::new();
        for (i, x) in (0..4).flat_map(|i| (0..4).map(move |x| (i, f64::from(x) / 4.0))) {
            let (u, v) = (10.0 * x, 0.0);
            outer.push(match i {
                0 => at(u, v),
                1 => at(10.0, u),
                2 => at(10.0 - u, 10.0),
                _ => at(0.0, 10.0 - u),
            });
        }
        let slit: Vec<[f64; 2]> = (0..5).map(|i| at(2.0 + 0.5 * f64::from(i), 3.0)).collect();
        let joint = at(6.0, 6.0);
        let ends = [at(8.0, 6.0), at(5.0, 8.0), at(5.5, 4.0), at(7.0, 8.5)];
        let flat = |[x, y]: [f64; 2]| [x, y, 0.0];
        let slit = slit.windows(2).map(|ends| Piece::Segment([flat(ends[0]), flat(ends[1])]));
        let arms =
            ends[..round % 4 + 1].iter().map(|&end| Piece::Segment([flat(joint), flat(end)]));
        let sites = sites(rings(&[outer]), slit.chain(arms).collect());
        let context = || format!("jitter {jitter}, turned by {turn}, {} arms", round % 4 + 1);
        assert_eq!(found(&sites, Side::Inner), ([1, 2], 0), "{}", context());
    }
}

/// Two points next to each other, and one far off: where balls that touch both barely touch a third.
#[test]
fn points_close_together_are_told_apart() {
    let mut random = Random(19);
    for round in 0..200 {
        let apart = 10f64.powi(-1 - (round % 5));
        let mut coordinate = || 1.0 + 8.0 * random.unit();
        let (x, y) = (coordinate(), coordinate());
        let turn = coordinate();
        let pair = [[x, y, 0.0], [x + apart * turn.cos(), y + apart * turn.sin(), 0.0]];
        let outer = vec![[0.0, 0.3], [10.0, 0.0], [9.5, 10.0], [0.2, 9.0]];
        let sites = sites(rings(&[outer]), pair.map(Piece::Point).to_vec());
        assert_eq!(found(&sites, Side::Inner), ([1, 2], 0), "{pair:?}");
    }
}

#[test]
fn lattices_of_points_and_discs_have_a_lattice_between_them() {
    for count in [2, 3, 4] {
        let centers = (0..count * count)
            .map(|i| [4.0 * f64::from(i / count), 4.0 * f64::from(i % count), 0.0]);
        let points = centers.clone().map(Piece::Point).collect();
        let discs = centers.map(|center| Piece::Sphere(center, 1.0)).collect();
        let inner = ((count - 2) * (count - 2)) as u64;
        assert_eq!(found(&sites(vec![], points), Side::Outer), ([1, inner], 0), "{count} points");
        assert_eq!(found(&sites(discs, vec![]), Side::Outer), ([1, inner], 0), "{count} discs");
    }
    // What has nothing opposite on one side.
    let row = (0..3).map(|i| Piece::Sphere([4.0 * f64::from(i), 0.0, 0.0], 1.0)).collect();
    assert_eq!(found(&sites(row, vec![]), Side::Outer), ([2, 0], 0));
    let three = [[0.1, 0.2], [3.0, 1.0], [1.0, 4.0]].map(|[x, y]| Piece::Point([x, y, 0.0]));
    assert_eq!(found(&sites(vec![], three.to_vec()), Side::Outer), ([1, 0], 0));
}

#[test]
fn the_axis_of_a_disc_is_its_centre() {
    let disc = |x: f64| Piece::Sphere([x, 1.0, 0.0], 2.0);
    assert_eq!(found(&sites(vec![disc(0.0)], vec![]), Side::Inner), ([1, 0], 0));
    assert_eq!(found(&sites(vec![disc(0.0), disc(5.0)], vec![]), Side::Inner), ([2, 0], 0));
    // A point on the rim changes nothing; one inside is a hole.
    let with = |x: f64| sites(vec![disc(0.0)], vec![Piece::Point([x, 1.0, 0.0])]);
    assert_eq!(found(&with(2.0), Side::Inner), ([1, 0], 0));
    assert_eq!(found(&with(1.0), Side::Inner), ([1, 1], 0));
    assert_eq!(found(&with(0.0), Side::Inner), ([1, 1], 0));
}

/// Parcels and their like: small, and far from the origin.
#[test]
fn a_figure_far_from_the_origin_has_the_axis_that_it_has_at_the_origin() {
    let job = Job::default();
    let mut random = Random(13);
    for by in [[500123.5, 5123456.75], [1e6, 0.0], [-3e9, 7.0]] {
        let ring: Vec<[f64; 2]> = star(&mut random, 30)
            .iter()
            .map(|p| p.map(|x| (x * 1024.0).round() / 1024.0))
            .collect();
        let hole = turned(polygon(5, 1.0 / 64.0))
            .iter()
            .map(|p| p.map(|x| (x * 4096.0).round() / 4096.0))
            .collect();
        let figure: [Vec<[f64; 2]>; 2] = [ring, hole];
        let graph = |by: [f64; 2]| {
            let figure: Vec<_> = figure.iter().map(|ring| moved(ring, by)).collect();
            let options = GraphOptions { spacing: 0.01, ..GraphOptions::default() };
            MedialGraph::new(&sites(rings(&figure), vec![]), options, &job).unwrap()
        };
        let (here, there) = (graph([0.0; 2]), graph(by));
        assert_eq!((here.torn(), there.torn()), (0, 0));
        assert_eq!(here.arcs(), there.arcs());
        assert!(there.validate(&job).unwrap().is_valid());
        let ulp = by[0].abs().max(by[1].abs()) * f64::EPSILON + 1e-12;
        for (p, q) in here.points().iter().zip(there.points()) {
            let back = [q.center[0] - by[0], q.center[1] - by[1]];
            assert!((0..2).all(|k| (p.center[k] - back[k]).abs() <= ulp), "{p:?} {q:?}");
            assert!((p.radius - q.radius).abs() <= 1e-12, "{p:?} {q:?}");
        }
    }
}

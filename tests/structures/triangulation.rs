//! Triangulations against brute force, against themselves under shuffling, and against
//! `validate`, over every kind of set that breaks triangulators.

use crate::sets::{self, Set};
use medax::predicates::{Sign, delaunay_conflict, orient3d, regular_conflict};
use medax::{Job, NONE, Points, Status, Triangulation};
use std::sync::Arc;

fn points(rows: &[[f64; 3]]) -> Arc<Points> {
    Arc::new(Points::new(rows, Default::default(), &Job::default()).unwrap())
}

fn delaunay(rows: &[[f64; 3]]) -> Triangulation {
    Triangulation::delaunay(&points(rows), &Job::default()).unwrap()
}

fn regular(rows: &[[f64; 3]], weights: &[f64]) -> Triangulation {
    Triangulation::regular(&points(rows), weights, &Job::default()).unwrap()
}

fn assert_valid(t: &Triangulation, name: &str) {
    let report = t.validate(&Job::default()).unwrap();
    assert!(report.is_valid(), "{name}: {report:?}");
    assert!(report.checked > t.cells().len() as u64, "{name} was not checked");
}

/// Every positively oriented quadruple with which no other vertex is in conflict.
pub fn brute_force(t: &Triangulation, weighted: bool) -> Vec<[u32; 4]> {
    let n = t.coords().len() as u32;
    let conflict = if weighted { regular_conflict } else { delaunay_conflict };
    let at = |v: u32| &t.coords()[v as usize];
    let mut cells = Vec::new();
    for a in 0..n {
        for b in a + 1..n {
            for c in b + 1..n {
                for d in c + 1..n {
                    let cell = match orient3d(at(a), at(b), at(c), at(d)) {
                        Sign::Positive => [a, b, c, d],
                        Sign::Negative => [a, b, d, c],
                        Sign::Zero => continue,
                    };
                    let [p, q, r, s] = cell.map(|v| t.site(v));
                    let mut others = (0..n).filter(|v| !cell.contains(v));
                    if others.all(|v| !conflict(&p, &q, &r, &s, &t.site(v))) {
                        cells.push(cell);
                    }
                }
            }
        }
    }
    cells.sort_unstable();
    cells
}

#[test]
fn every_kind_of_set_is_valid() {
    for Set { name, rows } in sets::all(400) {
        assert_valid(&delaunay(&rows), name);
        for (kind, weights) in sets::weights(&rows) {
            assert_valid(&regular(&rows, &weights), &format!("{name}, {kind} weights"));
        }
    }
}

#[test]
fn small_sets_equal_brute_force() {
    for Set { name, rows } in sets::all(24) {
        let t = delaunay(&rows);
        assert_eq!(t.cells(), brute_force(&t, false), "{name}");
        for (kind, weights) in sets::weights(&rows) {
            let t = regular(&rows, &weights);
            assert_eq!(t.cells(), brute_force(&t, true), "{name}, {kind} weights");
        }
    }
}

#[test]
fn equal_weights_change_nothing() {
    for Set { name, rows } in sets::all(200) {
        let t = delaunay(&rows);
        for weight in [0.0, 0.75] {
            let r = regular(&rows, &vec![weight; rows.len()]);
            assert_eq!((t.cells(), t.neighbors()), (r.cells(), r.neighbors()), "{name}");
            assert!(r.hidden().is_empty(), "{name}");
        }
    }
}

#[test]
fn the_order_of_rows_decides_nothing_but_the_maps() {
    for Set { name, rows } in sets::all(300) {
        let weights = sets::weights(&rows).remove(0).1;
        let (t, r) = (delaunay(&rows), regular(&rows, &weights));
        for seed in 0..3 {
            let order = sets::shuffled(rows.len(), seed);
            let moved: Vec<_> = order.iter().map(|&i| rows[i]).collect();
            let moved_weights: Vec<_> = order.iter().map(|&i| weights[i]).collect();
            let (u, s) = (delaunay(&moved), regular(&moved, &moved_weights));
            assert_eq!((t.coords(), t.cells()), (u.coords(), u.cells()), "{name}");
            assert_eq!(t.neighbors(), u.neighbors(), "{name}");
            assert_eq!((r.weights(), r.cells()), (s.weights(), s.cells()), "{name}");
            assert_eq!((r.hidden(), r.neighbors()), (s.hidden(), s.neighbors()), "{name}");
        }
    }
}

#[test]
fn the_number_of_threads_decides_nothing() {
    let mut all = sets::all(3000);
    all.push(sets::all(40_000).remove(0));
    for Set { name, rows } in all {
        let points = points(&rows);
        let weights = sets::weights(&rows).remove(2).1;
        let built = |threads| {
            let job = Job::new(medax::JobOptions { threads, ..Default::default() });
            let delaunay = Triangulation::delaunay(&points, &job).unwrap();
            (delaunay, Triangulation::regular(&points, &weights, &job).unwrap())
        };
        let (t, r) = built(1);
        for threads in [2, 3, 8] {
            let (u, s) = built(threads);
            assert_eq!((t.cells(), t.neighbors()), (u.cells(), u.neighbors()), "{name}");
            assert_eq!((r.cells(), r.neighbors()), (s.cells(), s.neighbors()), "{name}");
            assert_eq!(r.hidden(), s.hidden(), "{name}");
        }
    }
}

#[test]
fn of_weighted_duplicates_the_heaviest_wins() {
    let mut rows = sets::all(30).remove(0).rows;
    rows.extend([rows[7]; 3]);
    let mut weights = vec![0.0; rows.len()];
    weights[7] = 0.01;
    weights[31] = 0.5;
    weights[32] = 0.5;
    let t = regular(&rows, &weights);
    let vertex = t.points().vertex_of_row()[7] as usize;
    assert_eq!((t.weights()[vertex], t.row_of_vertex()[vertex]), (0.5, 31));
    assert_eq!(t.points().duplicate_of()[30..], [7, 7, 7]);
    weights[7] = 0.5;
    weights[31] = 0.0;
    weights[32] = 0.0;
    assert_eq!(regular(&rows, &weights).cells(), t.cells());
}

#[test]
fn a_light_point_among_heavy_ones_is_hidden() {
    let mut rows: Vec<[f64; 3]> =
        (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from)).collect();
    rows.push([0.5, 0.5, 0.5]);
    let mut weights = vec![1.0; 8];
    // The corners' orthosphere has the squared radius 3/4 - 1 = -1/4 about the centre.
    weights.push(-1.0);
    let t = regular(&rows, &weights);
    assert_eq!(t.hidden(), [t.points().vertex_of_row()[8]]);
    assert_valid(&t, "cube with a hidden centre");
    weights[8] = 0.25 + f64::EPSILON;
    assert!(regular(&rows, &weights).hidden().is_empty());
    weights[8] = 0.25 - f64::EPSILON;
    assert_eq!(regular(&rows, &weights).hidden().len(), 1);
}

#[test]
fn flat_and_small_sets_are_errors_that_say_so() {
    let error = |rows: &[[f64; 3]]| {
        let error = Triangulation::delaunay(&points(rows), &Job::default()).unwrap_err();
        (error.status(), error.message().to_owned())
    };
    let line: Vec<_> = (0..50).map(|i| [f64::from(i), 2.0 * f64::from(i), 1.0]).collect();
    let plane: Vec<_> =
        (0..50).map(|i| [f64::from(i % 7), f64::from(i / 7), f64::from(i % 7 + i / 7)]).collect();
    assert_eq!(error(&line).0, Status::Degenerate);
    assert!(error(&line).1.contains("on a line"));
    assert_eq!(error(&plane).0, Status::Degenerate);
    assert!(error(&plane).1.contains("in a plane"));
    assert_eq!(error(&line[..3]).0, Status::TooFewPoints);
    assert_eq!(error(&[line[0]; 10]).0, Status::TooFewPoints);
}

#[test]
fn wrong_weights_are_errors_that_name_the_row() {
    let rows = sets::all(30).remove(0).rows;
    let error = |weights: &[f64]| {
        Triangulation::regular(&points(&rows), weights, &Job::default()).unwrap_err()
    };
    assert_eq!(error(&[0.0; 3]).status(), Status::Mismatch);
    for (bad, status) in [
        (f64::NAN, Status::NonFinite),
        (f64::NEG_INFINITY, Status::NonFinite),
        (1e300, Status::CoordinateRange),
        (-1e-300, Status::CoordinateRange),
    ] {
        let mut weights = vec![0.0; rows.len()];
        weights[17] = bad;
        let error = error(&weights);
        assert_eq!(error.status(), status);
        assert_eq!(error.element(), Some((medax::ElementKind::Row, 17)));
    }
}

#[test]
fn locate_finds_a_cell_that_holds_the_point() {
    for Set { name, rows } in sets::all(200) {
        let t = delaunay(&rows);
        let mut inside = 0;
        for (i, pair) in rows.windows(2).enumerate() {
            let middle = std::array::from_fn(|k| pair[0][k] / 2.0 + pair[1][k] / 2.0);
            // Midpoints of points on the hull may be rounded out of it.
            let hint = (i % t.cells().len()) as u32;
            let Some(cell) = t.locate(middle, hint).unwrap() else { continue };
            inside += 1;
            let corners = t.cells()[cell as usize].map(|v| &t.coords()[v as usize]);
            for slot in 0..4 {
                let mut corners = corners;
                corners[slot] = &middle;
                let [a, b, c, d] = corners;
                assert_ne!(orient3d(a, b, c, d), Sign::Negative, "{name}");
            }
        }
        assert!(inside > 0, "{name}");
        let b = t.points().bounds();
        let beyond = [b.max[0] + b.diagonal(), b.max[1], b.max[2]];
        assert_eq!(t.locate(beyond, NONE).unwrap(), None, "{name}");
    }
    let t = delaunay(&sets::all(30).remove(0).rows);
    assert_eq!(t.locate([f64::NAN; 3], 0).unwrap_err().status(), Status::NonFinite);
}

#[test]
fn rings_turn_round_their_edge() {
    for Set { name, rows } in sets::all(60) {
        let t = delaunay(&rows);
        let job = Job::default();
        let incidence = t.incidence(&job).unwrap();
        let edges = t.edges(&incidence, &job).unwrap();
        let mut ring = Vec::new();
        let mut in_rings = 0;
        for (&[a, b], &cell) in edges.ends.iter().zip(&edges.cells) {
            assert!(a < b);
            let closed = t.ring(cell, a, b, &mut ring);
            in_rings += ring.len();
            let mut expected: Vec<u32> = incidence.cells_of(a).to_vec();
            expected.retain(|c| incidence.cells_of(b).contains(c));
            let mut sorted = ring.clone();
            sorted.sort_unstable();
            assert_eq!(sorted, expected, "{name}: ring of {a} {b}");
            assert_eq!(cell, expected[0], "{name}");
            // The reversed edge turns the other way; both begin where the definition says.
            let forward = ring.clone();
            assert_eq!(t.ring(cell, b, a, &mut ring), closed);
            ring.reverse();
            if closed {
                ring.rotate_right(1);
                assert_eq!(forward[0], expected[0], "{name}");
            }
            assert_eq!(ring, forward, "{name}");
        }
        assert_eq!(in_rings, 6 * t.cells().len(), "{name}: every cell has six edges");
    }
}

#[test]
fn a_cancelled_job_stops_the_build() {
    let job = Job::default();
    let points = points(&sets::all(400).remove(0).rows);
    job.cancel();
    assert_eq!(Triangulation::delaunay(&points, &job).unwrap_err().status(), Status::Cancelled);
}

#[test]
fn the_memory_ceiling_is_kept() {
    let points = points(&sets::all(2000).remove(0).rows);
    let with = |memory_ceiling| {
        let job = Job::new(medax::JobOptions { memory_ceiling, ..Default::default() });
        (Triangulation::delaunay(&points, &job).map(|_| ()), job.memory_peak())
    };
    let (built, peak) = with(0);
    built.unwrap();
    assert!(peak > 2000 * 200);
    assert_eq!(with(peak).0, Ok(()));
    assert_eq!(with(peak - 1).0.unwrap_err().status(), Status::OutOfMemory);
}

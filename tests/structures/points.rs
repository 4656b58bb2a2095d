//! Points: checks, duplicates, maps, spatial order.

use crate::sets::{self, Set};
use medax::points::{COORDINATE_MAX, COORDINATE_MIN, FAR_BOX_LEN, PointsOptions};
use medax::{ElementKind, Job, NONE, Points, Result, Status};

fn points(rows: &[[f64; 3]]) -> Result<Points> {
    Points::new(rows, PointsOptions::default(), &Job::default())
}

#[test]
fn rows_that_are_not_numbers_are_named() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for axis in 0..3 {
            let mut rows = vec![[1.0, 2.0, 3.0]; 10];
            rows[6][axis] = bad;
            let error = points(&rows).unwrap_err();
            assert_eq!(error.status(), Status::NonFinite);
            assert_eq!(error.element(), Some((ElementKind::Row, 6)));
        }
    }
}

#[test]
fn rows_that_are_not_numbers_can_be_skipped() {
    let rows = [[0.0; 3], [f64::NAN; 3], [1.0; 3], [f64::INFINITY, 0.0, 0.0], [0.0; 3]];
    let options = PointsOptions { skip_non_finite: true };
    let p = Points::new(&rows, options, &Job::default()).unwrap();
    assert_eq!((p.row_count(), p.len(), p.skipped_count(), p.duplicate_count()), (5, 2, 2, 1));
    assert_eq!(p.vertex_of_row(), [0, NONE, 1, NONE, 0]);
    assert_eq!(p.row_of_vertex(), [0, 2]);
    assert_eq!(*p.duplicate_of(), [NONE, NONE, NONE, NONE, 0]);
    let none = Points::new(&[[f64::NAN; 3]], options, &Job::default());
    assert_eq!(none.unwrap_err().status(), Status::TooFewPoints);
}

#[test]
fn the_range_is_closed_and_holds_zero() {
    let ends = [COORDINATE_MIN, -COORDINATE_MIN, COORDINATE_MAX, -COORDINATE_MAX, 0.0, -0.0];
    points(&ends.map(|x| [x, 0.0, 0.0])).unwrap();
    for beyond in [COORDINATE_MIN.next_down(), COORDINATE_MAX.next_up(), 5e-324, f64::MAX] {
        for sign in [1.0, -1.0] {
            let error = points(&[[0.0; 3], [0.0, sign * beyond, 0.0]]).unwrap_err();
            assert_eq!(error.status(), Status::CoordinateRange);
            assert_eq!(error.element(), Some((ElementKind::Row, 1)));
        }
    }
}

#[test]
fn zero_has_one_sign() {
    let p = points(&[[0.0, 1.0, 0.0], [-0.0, 1.0, -0.0]]).unwrap();
    assert_eq!((p.len(), p.duplicate_count()), (1, 1));
    assert!(p.coords()[0].iter().all(|x| x.is_sign_positive()));
    let p = points(&[[-0.0, 1.0, -0.0]]).unwrap();
    assert!(p.coords()[0].iter().all(|x| x.is_sign_positive()));
}

#[test]
fn no_point_is_too_few() {
    assert_eq!(points(&[]).unwrap_err().status(), Status::TooFewPoints);
}

#[test]
fn maps_lead_there_and_back() {
    for Set { name, rows } in sets::all(300) {
        let p = points(&rows).unwrap();
        assert_eq!(p.vertex_of_row().len(), rows.len());
        for (row, &vertex) in p.vertex_of_row().iter().enumerate() {
            assert_eq!(p.coords()[vertex as usize], rows[row], "{name}");
            let first = rows.iter().position(|other| *other == rows[row]).unwrap();
            assert_eq!(p.row_of_vertex()[vertex as usize] as usize, first, "{name}");
            let expected = if first == row { NONE } else { first as u32 };
            assert_eq!(p.duplicate_of()[row], expected, "{name}");
        }
        for axis in 0..3 {
            let values = rows.iter().map(|row| row[axis]);
            assert_eq!(p.bounds().min[axis], values.clone().fold(f64::MAX, f64::min));
            assert_eq!(p.bounds().max[axis], values.fold(f64::MIN, f64::max));
        }
    }
}

#[test]
fn the_numbering_depends_on_the_set_alone() {
    for Set { name, mut rows } in sets::all(300) {
        let first = points(&rows).unwrap();
        rows.extend_from_within(..5);
        for seed in 0..4 {
            let order = sets::shuffled(rows.len(), seed);
            let moved: Vec<_> = order.iter().map(|&i| rows[i]).collect();
            assert_eq!(first.coords(), points(&moved).unwrap().coords(), "{name}");
        }
    }
}

#[test]
fn the_order_is_spatial() {
    // Neighbours in the order are near: the way through all points is much shorter than
    // through the rows as they come.
    let rows = sets::all(4000).remove(0).rows;
    let length = |rows: &[[f64; 3]]| -> f64 {
        let step = |pair: &[[f64; 3]]| {
            (0..3).map(|k| (pair[0][k] - pair[1][k]).powi(2)).sum::<f64>().sqrt()
        };
        rows.windows(2).map(step).sum()
    };
    assert!(length(points(&rows).unwrap().coords()) < 0.15 * length(&rows));
}

#[test]
fn the_far_box_surrounds_the_sample() {
    let p = points(&[[0.0, 0.0, 0.0], [2.0, 4.0, 1.0], [1.0, 1.0, 1.0]]).unwrap();
    let z = p.with_far_box(&Job::default()).unwrap();
    assert_eq!(z.coords()[..3], *p.coords());
    assert_eq!(z.len(), 3 + FAR_BOX_LEN);
    // Half the longest side, 2, times 5, about the centre (1, 2, 0.5).
    assert_eq!((z.bounds().min, z.bounds().max), ([-9.0, -8.0, -9.5], [11.0, 12.0, 10.5]));
    assert_eq!(z.row_of_vertex()[3..], [NONE; FAR_BOX_LEN]);
    assert_eq!(z.vertex_of_row(), p.vertex_of_row());
    let mut corners: Vec<_> = z.coords()[3..].to_vec();
    corners.sort_by(|a, b| a.partial_cmp(b).unwrap());
    corners.dedup();
    assert_eq!(corners.len(), 8);
    let huge = points(&[[0.0; 3], [COORDINATE_MAX; 3]]).unwrap();
    assert_eq!(huge.with_far_box(&Job::default()).unwrap_err().status(), Status::CoordinateRange);
}

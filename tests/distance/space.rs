//! Spheres round cubes: sound, and how complete.

use crate::shapes::{Point, cuboid, distance, dot, open, sub};
use medax::distance::{FieldAxis, FieldOptions, Piece, Sites};
use medax::medial::Side;
use medax::{Job, JobOptions};
use std::sync::Arc;

fn axis(sites: &Arc<Sites>, options: FieldOptions) -> FieldAxis {
    FieldAxis::new(sites, options, &Job::default()).unwrap()
}

/// Every point is as far from both of its feet, nothing is nearer, and it passes the thresholds.
fn check_sound(axis: &FieldAxis) {
    let epsilon = axis.options().decide.epsilon;
    let centers: Vec<Point> = axis.points().iter().map(|p| p.center).collect();
    let nearest = axis.sites().nearest(&centers, &Job::default()).unwrap();
    for (point, nearest) in axis.points().iter().zip(nearest) {
        assert!((nearest.distance - point.radius).abs() <= epsilon, "{point:?}");
        let ways = point.feet.map(|foot| sub(foot, point.center));
        for way in ways {
            assert!((dot(way, way).sqrt() - point.radius).abs() <= 2.0 * epsilon, "{point:?}");
        }
        let [a, b] = ways;
        let cosine = dot(a, b) / (dot(a, a) * dot(b, b)).sqrt();
        let angle = cosine.clamp(-1.0, 1.0).acos();
        assert!(angle >= axis.options().angle - 1e-6, "{point:?}");
        assert!(point.radius >= axis.options().min_distance, "{point:?}");
    }
}

/// The share of exact points that have a found one within a distance.
fn recall(axis: &FieldAxis, exact: &[Point], within: f64) -> f64 {
    let near = |p: &&Point| axis.points().iter().any(|q| distance(q.center, **p) <= within);
    exact.iter().filter(near).count() as f64 / exact.len() as f64
}

#[test]
fn the_axis_of_a_box_is_found_nearly_whole() {
    let sites = cuboid([4.0, 3.0, 2.0]);
    let density = 0.2;
    let options =
        FieldOptions { density, angle: 0.5, min_distance: 0.1, ..FieldOptions::default() };
    let axis = axis(&sites, options);
    check_sound(&axis);
    // The middle rectangle, at z = 1.
    let steps = |count: i32| (0..=count).map(move |i| f64::from(i) / f64::from(count));
    let middle: Vec<Point> =
        steps(20).flat_map(|x| steps(10).map(move |y| [1.0 + 2.0 * x, 1.0 + y, 1.0])).collect();
    // A sheet over an edge: as far from the floor as from a wall.
    let slope: Vec<Point> = steps(10)
        .flat_map(|x| steps(8).map(move |t| [1.0 + 2.0 * x, 0.15 + 0.8 * t, 0.15 + 0.8 * t]))
        .collect();
    for exact in [middle, slope] {
        assert!(recall(&axis, &exact, density * 3f64.sqrt()) == 1.0, "{}", axis.points().len());
    }
    // One point a cube.
    let cube = |p: Point| p.map(|x| (x / density).floor() as i64);
    let mut cubes: Vec<_> = axis.points().iter().map(|p| cube(p.center)).collect();
    cubes.sort_unstable();
    cubes.dedup();
    assert!(axis.points().len() < 3 * cubes.len());
}

/// The middle of a plate, wherever the lattice lies, however thin it is.
#[test]
fn what_is_thinner_than_the_cubes_is_not_skipped() {
    for thickness in [0.1, 0.03, 0.01, 0.003, 0.001, 1e-4] {
        for density in [0.1, 0.07, 0.05] {
            let sites = cuboid([1.0, 1.0, thickness]);
            let options = FieldOptions { density, angle: 2.0, ..FieldOptions::default() };
            let axis = axis(&sites, options);
            check_sound(&axis);
            let steps = move || (0..=20).map(|i| 0.1 + 0.04 * f64::from(i));
            let middle: Vec<Point> =
                steps().flat_map(|x| steps().map(move |y| [x, y, 0.5 * thickness])).collect();
            let found = recall(&axis, &middle, 1.5 * density);
            assert_eq!(found, 1.0, "{thickness} {density}");
        }
    }
}

#[test]
fn the_outside_of_points_lines_and_spheres_is_between_them() {
    let clip = Some([[-2.0; 3], [2.0; 3]]);
    let options =
        FieldOptions { side: Side::Outer, density: 0.25, clip, ..FieldOptions::default() };
    let pairs = [
        [Piece::Point([-1.0, 0.0, 0.0]), Piece::Point([1.0, 0.0, 0.0])],
        [Piece::Sphere([-1.0, 0.0, 0.0], 0.5), Piece::Sphere([1.0, 0.0, 0.0], 0.5)],
        [
            Piece::Line([0.0, 0.0, -1.0], [1.0, 0.0, 0.0]),
            Piece::Line([0.0, 0.0, 1.0], [0.0, 1.0, 0.0]),
        ],
    ];
    for (i, pair) in pairs.into_iter().enumerate() {
        let axis = axis(&open(3, pair.to_vec()), options);
        check_sound(&axis);
        let outer = |p: &Point| i != 1 || distance(*p, [p[0].signum(), 0.0, 0.0]) > 0.5;
        let points: Vec<Point> = axis.points().iter().map(|p| p.center).filter(outer).collect();
        // The plane between two points or spheres; between two lines at right angles x^2 - y^2 = 4 z.
        let off = |p: &Point| match i {
            2 => (p[0] * p[0] - p[1] * p[1] - 4.0 * p[2]).abs(),
            _ => p[0].abs(),
        };
        assert!(points.iter().all(|p| off(p) < 1e-4), "{i}");
        let grid =
            (0..=12).flat_map(|a| (0..=12).map(move |b| [a, b].map(|x| 0.3 * f64::from(x) - 1.8)));
        let exact: Vec<Point> = grid
            .map(|[a, b]| match i {
                2 => [a, b, 0.25 * (a * a - b * b)],
                _ => [0.0, a, b],
            })
            .collect();
        let share = recall(&axis, &exact, 0.25 * 3f64.sqrt());
        assert!(share > 0.99, "{i}: {share}");
    }
}

#[test]
fn the_bytes_are_the_same_whatever_the_threads() {
    let sites = cuboid([2.0, 1.5, 1.0]);
    let found = [1, 2, 5].map(|threads| {
        let job = Job::new(JobOptions { threads, ..JobOptions::default() });
        let options = FieldOptions { density: 0.1, ..FieldOptions::default() };
        FieldAxis::new(&sites, options, &job).unwrap().complex(&job).unwrap()
    });
    assert!(found[0] == found[1] && found[0] == found[2]);
}

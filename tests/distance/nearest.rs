//! Nearest points against formulas of their own.

use crate::shapes::{Point, Random, closed, distance, dot, open, rectangle, rings, star, sub};
use medax::distance::{Nearest, Piece, Sites};
use medax::{ElementKind, Job, JobOptions, Status};

/// The distance to the hull of some corners by trying all their subsets: of the nearest points of the flats through them that lie within, the nearest one (an active-set method written out).
fn to_hull(p: Point, corners: &[Point]) -> f64 {
    let mut least = f64::INFINITY;
    for subset in 1u32..1 << corners.len() {
        let chosen: Vec<Point> =
            (0..corners.len()).filter(|i| subset >> i & 1 == 1).map(|i| corners[i]).collect();
        if let Some(weights) = nearest_of_flat(p, &chosen)
            && weights.iter().all(|&w| w >= 0.0)
        {
            let mut q = [0.0; 3];
            for (corner, weight) in chosen.iter().zip(weights) {
                q = [0, 1, 2].map(|k| q[k] + weight * corner[k]);
            }
            least = least.min(distance(p, q));
        }
    }
    least
}

/// Weights, of sum 1, of the nearest point of the flat through one to three points, by the normal equations.
fn nearest_of_flat(p: Point, corners: &[Point]) -> Option<Vec<f64>> {
    let from = sub(p, corners[0]);
    match corners {
        [_] => Some(vec![1.0]),
        [a, b] => {
            let along = sub(*b, *a);
            let t = dot(from, along) / dot(along, along);
            t.is_finite().then(|| vec![1.0 - t, t])
        }
        [a, b, c] => {
            let (u, v) = (sub(*b, *a), sub(*c, *a));
            let (uu, uv, vv) = (dot(u, u), dot(u, v), dot(v, v));
            let determinant = uu * vv - uv * uv;
            let s = (vv * dot(from, u) - uv * dot(from, v)) / determinant;
            let t = (uu * dot(from, v) - uv * dot(from, u)) / determinant;
            (s.is_finite() && t.is_finite()).then(|| vec![1.0 - s - t, s, t])
        }
        _ => None,
    }
}

fn to_piece(p: Point, piece: &Piece) -> f64 {
    let to_line = |origin: Point, along: Point, is_ray: bool| {
        let from = sub(p, origin);
        let t = dot(from, along) / dot(along, along);
        let t = if is_ray { t.max(0.0) } else { t };
        distance(p, [0, 1, 2].map(|k| origin[k] + t * along[k]))
    };
    match *piece {
        Piece::Point(q) => distance(p, q),
        Piece::Segment(ends) => to_hull(p, &ends),
        Piece::Triangle(corners) => to_hull(p, &corners),
        Piece::Ray(origin, along) => to_line(origin, along, true),
        Piece::Line(origin, along) => to_line(origin, along, false),
        Piece::Sphere(center, radius) => (distance(p, center) - radius).abs(),
    }
}

fn random_piece(random: &mut Random, kind: usize) -> Piece {
    let mut point = || random.point(-1.0, 1.0);
    match kind % 6 {
        0 => Piece::Point(point()),
        1 => Piece::Segment([point(), point()]),
        2 => Piece::Ray(point(), point()),
        3 => Piece::Line(point(), point()),
        4 => {
            let a = point();
            let small = |q: Point| [0, 1, 2].map(|k| a[k] + 0.3 * q[k]);
            Piece::Triangle([a, small(point()), small(point())])
        }
        _ => Piece::Sphere(point(), 0.2),
    }
}

#[test]
fn the_nearest_of_all_kinds_is_that_of_all() {
    let mut random = Random(1);
    for count in [1, 2, 5, 30, 500] {
        let pieces: Vec<Piece> = (0..count).map(|i| random_piece(&mut random, i)).collect();
        let sites = open(3, pieces.clone());
        let points: Vec<Point> = (0..300).map(|_| random.point(-2.0, 2.0)).collect();
        let found = sites.nearest(&points, &Job::default()).unwrap();
        for (&p, found) in points.iter().zip(found) {
            let all: Vec<f64> = pieces.iter().map(|piece| to_piece(p, piece)).collect();
            let least = all.iter().copied().fold(f64::INFINITY, f64::min);
            assert!((found.distance - least).abs() < 1e-12, "{p:?} {found:?} {least}");
            assert!((all[found.piece as usize] - least).abs() < 1e-12);
            assert!((distance(p, found.point) - found.distance).abs() < 1e-15);
            let ahead = [0, 1, 2].map(|k| p[k] + found.distance * found.direction[k]);
            assert!(distance(ahead, found.point) < 1e-14);
        }
    }
}

/// Needles and triangles without area, at every scale.
#[test]
fn thin_triangles_are_as_far_as_their_sides() {
    let mut random = Random(2);
    for scale in [1e-60, 1e-9, 1.0, 1e30] {
        for thin in [0.0, 1e-17, 1e-12, 1e-6, 1e-3] {
            for _ in 0..50 {
                let (a, b) = (random.point(-1.0, 1.0), random.point(-1.0, 1.0));
                let (t, off) = (random.within(-0.2, 1.2), random.point(-1.0, 1.0));
                let c = [0, 1, 2].map(|k| a[k] + t * (b[k] - a[k]) + thin * off[k]);
                let corners = [a, b, c].map(|p| p.map(|x| x * scale));
                let sites = open(3, vec![Piece::Triangle(corners)]);
                let p = random.point(-2.0, 2.0).map(|x| x * scale);
                let found = sites.nearest(&[p], &Job::default()).unwrap()[0];
                let sides =
                    [[0, 1], [1, 2], [2, 0]].map(|[i, j]| to_hull(p, &[corners[i], corners[j]]));
                let rim = sides.into_iter().fold(f64::INFINITY, f64::min);
                // The inside of a triangle is no farther from its rim than it is thin.
                assert!(found.distance <= rim * (1.0 + 1e-14));
                assert!(
                    found.distance >= rim - 2.0 * thin * scale - 1e-14 * scale,
                    "{scale} {thin}"
                );
            }
        }
    }
}

#[test]
fn all_nearest_points_are_found_within_a_tolerance() {
    let sites = closed(rings(&[rectangle(4.0, 2.0)]));
    let points = [[1.0, 1.0, 0.0], [2.0, 1.0, 0.0], [0.5, 0.25, 0.0]];
    let all = sites.all_nearest(&points, 1e-12, &Job::default()).unwrap();
    let pieces = |row: usize| all.of(row).iter().map(|foot| foot.piece).collect::<Vec<_>>();
    assert_eq!([pieces(0), pieces(1), pieces(2)], [vec![0, 2, 3], vec![0, 2], vec![0]]);
    let wide = sites.all_nearest(&points[2..], 0.25, &Job::default()).unwrap();
    assert_eq!(wide.of(0).len(), 2);
}

#[test]
fn memory_is_counted_while_all_nearest_are_found() {
    let mut random = Random(3);
    let pieces: Vec<Piece> = (0..500).map(|i| random_piece(&mut random, i % 4)).collect();
    let sites = open(3, pieces);
    let points = vec![[0.5; 3]; 100];
    let job = Job::default();
    sites.all_nearest(&points, f64::INFINITY, &job).unwrap();
    let least = 2 * (100 * 500 * size_of::<Nearest>()) as u64;
    assert!(job.memory_peak() > least, "{} of {least}", job.memory_peak());
    let tight = Job::new(JobOptions { memory_ceiling: least / 4, ..Default::default() });
    let error = sites.all_nearest(&points, f64::INFINITY, &tight).unwrap_err();
    assert_eq!(error.status(), Status::OutOfMemory);
}

#[test]
fn a_point_is_inside_where_a_ray_crosses_an_odd_number_of_times() {
    let mut random = Random(3);
    let ring = star(&mut random, 40);
    let sites = closed(rings(std::slice::from_ref(&ring)));
    let points: Vec<Point> = (0..2000).map(|_| random.flat(-1.2, 1.2)).collect();
    let found = sites.is_inside(&points, &Job::default()).unwrap();
    let mut seen = [0; 2];
    for (p, found) in points.iter().zip(found) {
        // The angles under which the sides are seen add up to a full turn or to nothing.
        let turn: f64 = (0..ring.len())
            .map(|i| {
                let [a, b] =
                    [ring[i], ring[(i + 1) % ring.len()]].map(|q| [q[0] - p[0], q[1] - p[1]]);
                (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1])
            })
            .sum();
        assert_eq!(found, turn.abs() > 3.0, "{p:?}");
        seen[usize::from(found)] += 1;
    }
    assert!(seen.iter().all(|&count| count > 100), "{seen:?}");
    // On the height of a corner it is crossed once.
    let square = closed(rings(&[rectangle(1.0, 1.0)]));
    let points = [[-1.0, 0.0, 0.0], [-1.0, 1.0, 0.0], [0.5, 0.5, 0.0]];
    assert_eq!(square.is_inside(&points, &Job::default()).unwrap(), [false, false, true]);
}

#[test]
fn bad_input_is_an_error_that_says_where() {
    let job = Job::default();
    let good = Piece::Point([0.0; 3]);
    let refused = |dimension, piece: Piece| {
        let error = Sites::new(dimension, vec![good, piece], vec![0, 1], &job).unwrap_err();
        assert_eq!(error.element(), Some((ElementKind::Row, 1)), "{piece:?}");
        error.status()
    };
    assert_eq!(refused(3, Piece::Point([0.0, f64::NAN, 0.0])), Status::NonFinite);
    assert_eq!(refused(3, Piece::Segment([[0.0; 3], [1e70, 0.0, 0.0]])), Status::CoordinateRange);
    assert_eq!(refused(3, Piece::Line([0.0; 3], [0.0; 3])), Status::InvalidArgument);
    assert_eq!(refused(3, Piece::Sphere([0.0; 3], 0.0)), Status::InvalidArgument);
    assert_eq!(refused(2, Piece::Point([0.0, 0.0, 1.0])), Status::InvalidArgument);
    let flat = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    assert_eq!(refused(2, Piece::Triangle(flat)), Status::InvalidArgument);
    for (dimension, pieces, sites, status) in [
        (4, vec![good], vec![0], Status::InvalidArgument),
        (3, vec![], vec![], Status::InvalidArgument),
        (3, vec![good], vec![], Status::Mismatch),
    ] {
        assert_eq!(Sites::new(dimension, pieces, sites, &job).unwrap_err().status(), status);
    }
    let unnumbered = Sites::new(3, vec![good, good], vec![0, u32::MAX], &job).unwrap_err();
    assert_eq!(unnumbered.element(), Some((ElementKind::Row, 1)));
    let sites = open(3, vec![good]);
    let bad = sites.nearest(&[[0.0; 3], [f64::NAN; 3]], &job).unwrap_err();
    assert_eq!((bad.status(), bad.element()), (Status::NonFinite, Some((ElementKind::Row, 1))));
    assert!(sites.all_nearest(&[[0.0; 3]], -1.0, &job).is_err());
}

#[test]
fn the_sign_of_a_zero_leaves_no_trace() {
    let zeros = [-0.0, -0.0, -0.0];
    let pieces = vec![
        Piece::Point(zeros),
        Piece::Segment([zeros, [-0.0, 1.0, -0.0]]),
        Piece::Ray(zeros, [1.0, -0.0, -0.0]),
        Piece::Line(zeros, [-0.0, -0.0, 1.0]),
        Piece::Triangle([zeros, [1.0, -0.0, 0.0], [-0.0, 1.0, 0.0]]),
        Piece::Sphere([-0.0, 5.0, -0.0], 1.0),
    ];
    let sites = open(3, pieces);
    // -0 and 0 are equal, and look different.
    assert!(!format!("{:?}", sites.pieces()).contains("-0.0"));
    let found = sites.nearest(&[[-0.0, -1.0, 0.0]], &Job::default()).unwrap()[0];
    assert!(found.point.iter().all(|x| x.is_sign_positive()), "{found:?}");
}

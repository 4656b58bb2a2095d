//! Unions of balls against closed formulas and brute force.

use crate::shapes::{Point, Random, distance};
use medax::complex::{Attribute, CompareOptions, ComplexParts, Element, Topology, Values, compare};
use medax::distance::{Balls, BoundaryOptions, FieldAxis, FieldOptions, Sites};
use medax::io::read_complex;
use medax::{Complex, ElementKind, Job, JobOptions, Status};
use std::f64::consts::{PI, TAU};
use std::path::Path;
use std::sync::Arc;

fn balls(centers: Vec<Point>, radii: Vec<f64>) -> Balls {
    Balls::new(centers, radii, &Job::default()).unwrap()
}

fn random(count: usize, seed: u64) -> Balls {
    let mut random = Random(seed);
    let centers = (0..count).map(|_| random.point(0.0, 1.0)).collect();
    let size = (count as f64).cbrt().recip();
    balls(centers, (0..count).map(|_| size * random.within(0.3, 0.8)).collect())
}

/// A grid of equal balls, of side 1.
fn grid(side: usize, radius: f64) -> Balls {
    let at = |i: usize| [i % side, i / side % side, i / side / side].map(|x| x as f64);
    balls((0..side.pow(3)).map(at).collect(), vec![radius; side.pow(3)])
}

fn least(balls: &Balls, p: Point) -> f64 {
    let all = balls.centers().iter().zip(balls.radii());
    all.map(|(&center, radius)| distance(p, center) - radius).fold(f64::INFINITY, f64::min)
}

fn topology(boundary: &Complex) -> Topology {
    boundary.topology(&Job::default()).unwrap()
}

/// The boundary, once it is found to be closed, oriented, on the spheres, in no ball and near the union's boundary everywhere.
fn checked(balls: &Balls, spacing: f64) -> Complex {
    let boundary = balls.boundary(BoundaryOptions { spacing }, &Job::default()).unwrap();
    let bounds = balls.bounds();
    let spacing = if spacing > 0.0 { spacing } else { 0.01 * bounds.diagonal() };
    let exact = 1e-13 * bounds.diagonal();
    let Some(Values::U32(ball)) =
        boundary.attribute(Element::Vertex, "ball").map(|ball| ball.values())
    else {
        panic!("no ball")
    };
    let at_vertices = balls.distances(boundary.vertices(), &Job::default()).unwrap();
    for ((&p, &ball), least) in boundary.vertices().iter().zip(ball).zip(at_vertices) {
        let ball = ball as usize;
        let own = distance(p, balls.centers()[ball]) - balls.radii()[ball];
        assert!(own.abs() <= exact && least.abs() <= exact, "{p:?}: {own:e}, {least:e}");
    }
    // The corners of a triangle are on the boundary, and a circle no wider than the spacing goes through them.
    let corners = |t: &[u32; 3]| t.map(|v| boundary.vertices()[v as usize]);
    let middles: Vec<Point> = boundary
        .triangles()
        .iter()
        .map(|t| {
            let [a, b, c] = corners(t);
            let [x, y, z] = [distance(a, b), distance(b, c), distance(c, a)];
            let half = 0.5 * (x + y + z);
            let area = (half * (half - x) * (half - y) * (half - z)).max(0.0).sqrt();
            assert!(x * y * z <= 4.0 * area * spacing * (1.0 + 1e-6), "{x} {y} {z}");
            [0, 1, 2].map(|k| (a[k] + b[k] + c[k]) / 3.0)
        })
        .collect();
    for value in balls.distances(&middles, &Job::default()).unwrap() {
        assert!(value <= spacing, "{value}");
    }
    let mut sides: Vec<[u32; 2]> = Vec::new();
    for t in boundary.triangles() {
        sides.extend((0..3).map(|i| [t[i], t[(i + 1) % 3]]));
    }
    sides.sort_unstable();
    let mut back: Vec<[u32; 2]> = sides.iter().map(|&[a, b]| [b, a]).collect();
    back.sort_unstable();
    assert!(sides == back && !sides.is_empty());
    assert!(boundary.measure(&Job::default()).unwrap().volume > 0.0);
    boundary
}

fn assert_near(value: f64, exact: f64, relative: f64) {
    assert!((value - exact).abs() <= relative * exact, "{value} instead of {exact}");
}

fn measured(boundary: &Complex) -> [f64; 2] {
    let measure = boundary.measure(&Job::default()).unwrap();
    [measure.area, measure.volume]
}

#[test]
fn distances_are_the_least_of_all_balls() {
    let mut points = Random(3);
    for (count, seed) in [(1, 1), (5, 2), (300, 3)] {
        let balls = random(count, seed);
        let points: Vec<Point> = (0..500).map(|_| points.point(-1.0, 2.0)).collect();
        let found = balls.distances(&points, &Job::default()).unwrap();
        let expected: Vec<f64> = points.iter().map(|&p| least(&balls, p)).collect();
        assert_eq!(found, expected);
        assert!(found.iter().any(|&value| value < 0.0) && found.iter().any(|&value| value > 0.0));
    }
    // Radii of all sizes, one ball round most of the others.
    let mut random = Random(8);
    let centers: Vec<Point> = (0..200).map(|_| random.point(0.0, 1.0)).collect();
    let radii = (0..200).map(|i| 0.6 * 0.9f64.powi(i)).collect();
    let balls = balls(centers, radii);
    let points: Vec<Point> = (0..500).map(|_| random.point(-1.0, 2.0)).collect();
    let found = balls.distances(&points, &Job::default()).unwrap();
    assert_eq!(found, points.iter().map(|&p| least(&balls, p)).collect::<Vec<_>>());
}

#[test]
fn one_ball_is_a_sphere() {
    for spacing in [0.0, 0.2, 100.0] {
        let radius = 2.0;
        let boundary = checked(&balls(vec![[1.0, -2.0, 30.0]], vec![radius]), spacing);
        let topology = topology(&boundary);
        assert_eq!((topology.genus, topology.components), (Some(0), 1));
        let relative = if spacing > 1.0 { 0.2 } else { 0.01 };
        let [area, volume] = measured(&boundary);
        assert_near(area, 4.0 * PI * radius.powi(2), relative);
        assert_near(volume, 4.0 / 3.0 * PI * radius.powi(3), relative);
    }
}

#[test]
fn two_balls_are_a_lens_less_than_both() {
    let (r, s, d) = (1.0f64, 0.8f64, 1.1f64);
    let boundary = checked(&balls(vec![[0.0; 3], [0.0, d, 0.0]], vec![r, s]), 0.0);
    let lens =
        PI * (r + s - d).powi(2) * (d * d + 2.0 * d * (r + s) - 3.0 * (r - s).powi(2)) / (12.0 * d);
    let exact = 4.0 / 3.0 * PI * (r.powi(3) + s.powi(3)) - lens;
    let [area, volume] = measured(&boundary);
    assert_near(volume, exact, 2e-3);
    // What is left of each sphere is a cap.
    let height = (d * d + r * r - s * s) / (2.0 * d);
    assert_near(area, TAU * (r * (r + height) + s * (s + d - height)), 2e-3);
    let topology = topology(&boundary);
    assert!(topology.nonmanifold_edges == 0 && topology.nonmanifold_vertices == 0);
    assert_eq!((topology.genus, topology.components), (Some(0), 1));
    // The crease is met: vertices lie on both spheres.
    let on_both = |p: &&Point| {
        (distance(**p, [0.0; 3]) - r).abs().max((distance(**p, [0.0, d, 0.0]) - s).abs()) < 1e-12
    };
    assert!(boundary.vertices().iter().filter(on_both).count() > 100);
}

#[test]
fn pieces_and_rings_have_their_topology() {
    let apart = checked(&balls(vec![[0.0; 3], [3.0, 0.0, 0.0]], vec![1.0, 0.5]), 0.0);
    assert_eq!(topology(&apart).betti, [2, 0, 2]);
    let at = |i: usize| {
        let angle = TAU * i as f64 / 12.0;
        [2.0 * angle.cos(), 2.0 * angle.sin(), 0.25]
    };
    let ring = checked(&balls((0..12).map(at).collect(), vec![0.7; 12]), 0.0);
    let found = topology(&ring);
    assert_eq!((found.betti, found.genus, found.nonmanifold_edges), ([1, 2, 1], Some(1), 0));
    // A shell of balls round a void, whose boundary points into it.
    let golden = PI * (3.0 - 5f64.sqrt());
    let on_sphere = |i: usize| {
        let z = 1.0 - (2 * i + 1) as f64 / 300.0;
        let angle = golden * i as f64;
        let radius = (1.0 - z * z).sqrt();
        [radius * angle.cos(), radius * angle.sin(), z]
    };
    let shell = balls((0..300).map(on_sphere).collect(), vec![0.25; 300]);
    let boundary = checked(&shell, 0.0);
    assert_eq!(topology(&boundary).betti, [2, 0, 2]);
    let solid = 4.0 / 3.0 * PI * 1.25f64.powi(3);
    assert!(measured(&boundary)[1] < 0.95 * solid);
}

#[test]
fn grids_of_equal_balls_are_no_trouble() {
    // Apart, with windows between them, which are the cycles of the grid, closed on all sides of a void, and whole. At the limits balls only touch, or meet in one point.
    for (radius, betti) in [
        (0.45, [27, 0, 27]),
        (0.55, [1, 2 * 28, 1]),
        (0.5f64.sqrt(), [9, 0, 9]),
        (0.75, [9, 0, 9]),
        (0.75f64.sqrt(), [1, 0, 1]),
        (0.9, [1, 0, 1]),
    ] {
        let found = topology(&checked(&grid(3, radius), 0.06));
        assert_eq!((found.betti, found.nonmanifold_edges), (betti, 0), "{radius}");
    }
    checked(&grid(3, 0.5), 0.06);
}

#[test]
fn what_is_covered_leaves_no_trace() {
    let one = checked(&balls(vec![[0.0; 3]], vec![1.0]), 0.0);
    let (far, near) = ([0.1, 0.0, 0.0], [0.25, 0.0, 0.0]);
    let nested = balls(vec![[0.0; 3], far, far, near, [0.0; 3]], vec![1.0, 0.8, 0.8, 0.75, 0.2]);
    assert_eq!(topology(&checked(&nested, 0.0)).betti, [1, 0, 1]);
    let same = balls(vec![[0.0; 3]; 5], vec![1.0; 5]);
    assert_eq!(checked(&same, 0.0).vertices(), one.vertices());
    // Within another, but with a power cell of its own beyond both.
    let mut centers = vec![[0.0; 3], [0.5, 0.0, 0.0]];
    let mut radii = vec![1.0, 0.2];
    for i in 0..20 {
        centers.push([0.6 + 0.01 * f64::from(i), 0.1, 0.0]);
        radii.push(0.01);
    }
    let sphere = checked(&balls(centers, radii), 0.0);
    let is_round = |p: &Point| (distance(*p, [0.0; 3]) - 1.0).abs() < 1e-12;
    assert!(sphere.vertices().iter().all(is_round));
}

#[test]
fn balls_that_touch_or_meet_in_one_circle_are_closed() {
    for gap in [-1e-3, -1e-9, 0.0, 1e-12, 1e-4] {
        let boundary = checked(&balls(vec![[0.0; 3], [1.8 + gap, 0.0, 0.0]], vec![1.0, 0.8]), 0.05);
        assert_near(measured(&boundary)[1], 4.0 / 3.0 * PI * 1.512, 0.01);
        // One piece or two, and no bubbles in the wedge.
        let found = topology(&boundary);
        assert!(found.betti[0] <= 2 && found.betti[1] == 0 && found.nonmanifold_edges == 0);
    }
    // A pencil: all spheres go through one circle, so that only the first and the last show.
    let at = |i: i32| [0.2 * f64::from(i) - 0.5, 0.0, 0.0];
    let pencil = balls((0..6).map(at).collect(), (0..6).map(|i| 1f64.hypot(at(i)[0])).collect());
    let boundary = checked(&pencil, 0.0);
    assert_eq!(topology(&boundary).betti, [1, 0, 1]);
    // A ball on the side of a large one, finer than that is asked to be.
    let wart = balls(vec![[0.0; 3], [0.0, 0.0, 1.0]], vec![1.0, 0.05]);
    let boundary = checked(&wart, 0.5);
    let highest = boundary.vertices().iter().map(|p| p[2]).fold(0.0, f64::max);
    assert!(highest > 1.04 && topology(&boundary).betti == [1, 0, 1]);
}

/// Places on a sphere by latitude and longitude: the poles, and what lies on the seam, are there again but for rounding.
#[test]
fn balls_that_are_the_same_but_for_rounding_are_no_trouble() {
    let mut centers = Vec::new();
    for (i, j) in (0..13 * 8).map(|i| (i / 8, i % 8)) {
        let (a, b) = (TAU * f64::from(i) / 12.0, PI * f64::from(j) / 7.0);
        centers.push([a.cos() * b.sin(), a.sin() * b.sin(), b.cos()]);
    }
    let radii = vec![0.45; centers.len()];
    assert_eq!(topology(&checked(&balls(centers, radii), 0.05)).betti, [2, 0, 2]);
}

#[test]
fn random_sets_are_covered_to_the_spacing() {
    for (count, seed) in [(3, 4), (30, 5), (300, 6)] {
        let balls = random(count, seed);
        let spacing = 0.02;
        let boundary = Arc::new(checked(&balls, spacing));
        // Where a random ray from a centre leaves its ball, if that is bare, the mesh is near.
        let mut random = Random(seed + 100);
        let mut bare = Vec::new();
        while bare.len() < 300 {
            let ball = (random.unit() * count as f64) as usize;
            let way = random.point(-1.0, 1.0);
            let size = distance(way, [0.0; 3]);
            let center = balls.centers()[ball];
            let p = [0, 1, 2].map(|k| center[k] + way[k] * balls.radii()[ball] / size);
            if least(&balls, p) > -1e-12 {
                bare.push(p);
            }
        }
        let mesh = Sites::of_complex(&boundary, &Job::default()).unwrap();
        for nearest in mesh.nearest(&bare, &Job::default()).unwrap() {
            assert!(nearest.distance <= spacing, "{}", nearest.distance);
        }
        // The volume by counting.
        let bounds = balls.bounds();
        let extent = bounds.extent();
        let mut within = || {
            let p = [0, 1, 2].map(|k| bounds.min[k] + extent[k] * random.unit());
            least(&balls, p) < 0.0
        };
        let hits = (0..40_000).filter(|_| within()).count() as f64 / 40_000.0;
        assert_near(measured(&boundary)[1], hits * extent.iter().product::<f64>(), 0.03);
    }
}

#[test]
fn threads_change_no_byte() {
    let balls = random(400, 9);
    let boundary = |threads| {
        let job = Job::new(JobOptions { threads, ..JobOptions::default() });
        balls.boundary(BoundaryOptions { spacing: 0.03 }, &job).unwrap()
    };
    let one = boundary(1);
    assert!([2, 5].into_iter().all(|threads| boundary(threads) == one));
}

#[test]
fn what_is_no_ball_is_refused_by_its_number() {
    let refused = |center: Point, radius: f64| {
        let centers = vec![[0.0; 3], [1.0; 3], center];
        let error = Balls::new(centers, vec![1.0, 1.0, radius], &Job::default()).unwrap_err();
        assert_eq!(error.element(), Some((ElementKind::Row, 2)));
        error.status()
    };
    assert_eq!(refused([0.0; 3], f64::NAN), Status::NonFinite);
    assert_eq!(refused([0.0, f64::INFINITY, 0.0], 1.0), Status::NonFinite);
    assert_eq!(refused([0.0; 3], 0.0), Status::InvalidArgument);
    assert_eq!(refused([0.0; 3], -1.0), Status::InvalidArgument);
    assert_eq!(refused([0.0; 3], 1e-60), Status::CoordinateRange);
    assert_eq!(refused([1e60, 0.0, 0.0], 1.0), Status::CoordinateRange);
    let status = |centers, radii| Balls::new(centers, radii, &Job::default()).unwrap_err().status();
    assert_eq!(status(vec![[0.0; 3]], vec![]), Status::Mismatch);
    assert_eq!(status(vec![], vec![]), Status::TooFewPoints);
    let one = balls(vec![[0.0; 3]], vec![1.0]);
    for spacing in [-1.0, f64::NAN, f64::INFINITY] {
        let error = one.boundary(BoundaryOptions { spacing }, &Job::default()).unwrap_err();
        assert_eq!(error.status(), Status::InvalidArgument);
    }
    let tiny = balls(vec![[1.0; 3]], vec![1e-16]);
    let error = tiny.boundary(BoundaryOptions::default(), &Job::default()).unwrap_err();
    assert_eq!(error.status(), Status::CoordinateRange);
    let job = Job::default();
    job.cancel();
    let error = one.boundary(BoundaryOptions::default(), &job).unwrap_err();
    assert_eq!(error.status(), Status::Cancelled);
}

#[test]
fn vertices_with_a_radius_are_balls() {
    let parts = |attributes| ComplexParts {
        vertices: vec![[0.0; 3], [1.0, 0.0, 0.0]],
        attributes,
        ..ComplexParts::default()
    };
    let radius =
        Attribute::new("radius", Element::Vertex, 1, Values::F64(vec![0.5, 0.25])).unwrap();
    let complex = Complex::new(parts(vec![radius])).unwrap();
    let balls = Balls::of_complex(&complex, &Job::default()).unwrap();
    assert_eq!((balls.centers(), balls.radii()), (complex.vertices(), &[0.5, 0.25][..]));
    let bare = Complex::new(parts(vec![])).unwrap();
    let whole = Attribute::new("radius", Element::Vertex, 1, Values::U32(vec![1, 2])).unwrap();
    let of_whole = Complex::new(parts(vec![whole])).unwrap();
    let of_whole = Balls::of_complex(&of_whole, &Job::default()).unwrap();
    assert_eq!(of_whole.radii(), [1.0, 2.0]);
    assert_eq!(Balls::of_complex(&bare, &Job::default()).unwrap_err().status(), Status::Mismatch);
}

/// The union of the balls of an axis with points as dense as this, and the boundary that it came from.
fn reconstructed(mesh: &Arc<Complex>, density: f64) -> Complex {
    let sites = Arc::new(Sites::of_complex(mesh, &Job::default()).unwrap());
    let options = FieldOptions { density: density * sites.size(), ..FieldOptions::default() };
    let axis = FieldAxis::new(&sites, options, &Job::default()).unwrap();
    let axis = axis.complex(&Job::default()).unwrap();
    checked(&Balls::of_complex(&axis, &Job::default()).unwrap(), 0.0)
}

#[test]
fn a_model_comes_back_from_its_axis() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data/rocker-arm.obj");
    if !file.is_file() {
        println!("skipped: {} is not there", file.display());
        return;
    }
    let mesh = Arc::new(read_complex(file, &Job::default()).unwrap());
    let solid = measured(&mesh)[1];
    let [coarse, fine] = [0.04, 0.02].map(|density| {
        let boundary = reconstructed(&mesh, density);
        let options = CompareOptions { samples: 5000, ..CompareOptions::default() };
        let found = compare(&boundary, &mesh, &options, &Job::default()).unwrap();
        // The axis has a point for each cube, of which the density is the side.
        let diagonal = 3f64.sqrt() * density * found.diagonal;
        assert!(found.a_to_b.max.max(found.b_to_a.max) < diagonal, "{found:?}");
        // Its balls lie in the solid.
        let volume = measured(&boundary)[1];
        assert!(volume < solid, "{volume} of {solid}");
        [found.a_to_b.mean.max(found.b_to_a.mean), solid - volume]
    });
    // Twice as dense, it comes at least twice as near.
    assert!((0..2).all(|k| fine[k] < 0.5 * coarse[k]), "{fine:?} after {coarse:?}");
}

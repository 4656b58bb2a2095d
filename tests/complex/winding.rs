//! Winding numbers: shapes whose inside is known, and brute force by another formula.

use super::shapes::*;
use medax::{Complex, ElementKind, Job, JobOptions, Status};
use std::f64::consts::{PI, TAU};

type Vec3 = [f64; 3];

/// How far the numbers may be off, as their documentation says.
const ERROR: f64 = 0.002;

fn numbers(mesh: &Builder, queries: &[Vec3]) -> Vec<f64> {
    mesh.build().winding_numbers(queries, &Job::default()).unwrap()
}

fn close(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (i, (x, y)) in found.iter().zip(expected).enumerate() {
        assert!((x - y).abs() <= tolerance, "{i}: {x} is not {y}, within {tolerance}");
    }
}

fn sub(a: Vec3, b: Vec3) -> Vec3 {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn dot(a: Vec3, b: Vec3) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(a: Vec3) -> Vec3 {
    a.map(|x| x / dot(a, a).sqrt())
}

/// The winding number as the sum of all spherical triangles, each by its excess: its angles, less pi.
fn by_excess(mesh: &Complex, query: Vec3) -> f64 {
    let solid_angle = |triangle: &[u32; 3]| {
        let corners = triangle.map(|v| unit(sub(mesh.vertices()[v as usize], query)));
        let angle = |i: usize| {
            let [a, b, c] = [0, 1, 2].map(|k| corners[(i + k) % 3]);
            let (u, v) = (cross(a, b), cross(a, c));
            let sine = dot(a, cross(u, v));
            sine.abs().atan2(dot(u, v))
        };
        let [a, b, c] = corners;
        (angle(0) + angle(1) + angle(2) - PI).copysign(dot(a, cross(b, c)))
    };
    mesh.triangles().iter().map(solid_angle).sum::<f64>() / (4.0 * PI)
}

fn in_cube(random: &mut Random, side: f64) -> Vec3 {
    [0.0; 3].map(|_: f64| side * (random.unit() - 0.5))
}

/// The unit cube about the origin.
fn cube() -> Builder {
    let solid = cubes([1, 1, 1], |_| true);
    let mut cube = outer_facets(&solid);
    cube.vertices.iter_mut().flatten().for_each(|x| *x -= 0.5);
    cube
}

fn reversed(mut mesh: Builder) -> Builder {
    mesh.faces.iter_mut().for_each(|face| face.reverse());
    mesh
}

fn moved(mut mesh: Builder, by: Vec3) -> Builder {
    mesh.vertices.iter_mut().for_each(|p| *p = [0, 1, 2].map(|i| p[i] + by[i]));
    mesh
}

#[test]
fn a_cube_is_wound_round_once_inside_and_not_at_all_outside() {
    let mut random = Random(1);
    let inside: Vec<Vec3> = (0..1000).map(|_| in_cube(&mut random, 0.999)).collect();
    close(&numbers(&cube(), &inside), &[1.0; 1000], 1e-12);
    close(&numbers(&reversed(cube()), &inside), &[-1.0; 1000], 1e-12);
    let is_outside = |p: &Vec3| p.iter().any(|x| x.abs() > 0.501);
    let outside: Vec<Vec3> =
        (0..3000).map(|_| in_cube(&mut random, 6.0)).filter(is_outside).collect();
    close(&numbers(&cube(), &outside), &vec![0.0; outside.len()], ERROR);
    // From afar the series of a closed surface has no terms at all, be it ever so crooked.
    let mut crooked = sphere(1.0, 3);
    crooked.vertices.iter_mut().for_each(|p| p[0] += 0.2 * p[1] * p[1] + 0.3 * p[2] * p[2] * p[0]);
    for mesh in [cube(), crooked] {
        let far: Vec<Vec3> = outside.iter().map(|&p| unit(p).map(|x| 8.0 * x)).collect();
        close(&numbers(&mesh, &far), &vec![0.0; far.len()], 1e-15);
    }
    // The mean of both sides, or of all round an edge or a vertex.
    let touching = [[0.1, 0.2, 0.5], [0.5, 0.1, 0.1], [0.5, 0.5, 0.1], [0.5, -0.5, 0.5]];
    close(&numbers(&cube(), &touching), &[0.5, 0.5, 0.25, 0.125], 1e-15);
}

#[test]
fn shells_add_up() {
    let large = || sphere(1.0, 4);
    let inner = || sphere(0.5, 3);
    let queries = [[0.0, 0.1, 0.0], [0.7, 0.0, 0.1], [0.0, 0.0, 1.5], [40.0, 3.0, 1.0]];
    close(&numbers(&large().and(&reversed(inner())), &queries), &[0.0, 1.0, 0.0, 0.0], ERROR);
    close(&numbers(&large().and(&inner()), &queries), &[2.0, 1.0, 0.0, 0.0], ERROR);
    let beside = large().and(&moved(large(), [1.0, 0.0, 0.0]));
    let queries = [[0.5, 0.2, 0.0], [-0.5, 0.0, 0.3], [1.7, 0.1, 0.0], [0.5, 1.3, 0.0]];
    close(&numbers(&beside, &queries), &[2.0, 1.0, 1.0, 0.0], ERROR);
}

#[test]
fn a_hemisphere_fills_half_the_sky_of_its_centre() {
    for (depth, tolerance) in [(0, 1e-15), (1, 1e-15), (5, ERROR)] {
        let mut half = sphere(1.0, depth);
        let points = half.vertices.clone();
        half.faces.retain(|face| face.iter().all(|&v| points[v as usize][2] >= 0.0));
        close(&numbers(&half, &[[0.0; 3]]), &[0.5], tolerance);
        // Vertices that no face uses change nothing.
        assert_eq!(numbers(&half.clone().compact(), &[[0.0; 3]]), numbers(&half, &[[0.0; 3]]));
    }
    // A cap of half angle 60 degrees takes a quarter, in the limit; one triangle of an octahedron an eighth.
    let mut cap = sphere(1.0, 6);
    let points = cap.vertices.clone();
    cap.faces.retain(|face| face.iter().all(|&v| points[v as usize][2] >= 0.5));
    close(&numbers(&cap, &[[0.0; 3]]), &[0.25], 0.01);
    let mut eighth = sphere(1.0, 0);
    eighth.faces.truncate(1);
    close(&numbers(&eighth, &[[0.0; 3]]), &[0.125], 1e-15);
}

/// Surfaces, closed and not, and soups.
fn meshes() -> Vec<(&'static str, Builder)> {
    let mut random = Random(5);
    let mut soup = Builder::default();
    for i in 0..2000 {
        let (middle, size) = (in_cube(&mut random, 2.0), [0.02, 0.1, 0.5][i % 3]);
        for _ in 0..3 {
            let by = in_cube(&mut random, size);
            soup.vertices.push([0, 1, 2].map(|k| middle[k] + by[k]));
        }
        let n = soup.vertices.len() as u32;
        soup.faces.push(vec![n - 3, n - 2, n - 1]);
    }
    let (n, m) = (90, 40);
    let round = torus(n, m).place(|i| {
        let (u, v) = (TAU * (i / 40) as f64 / f64::from(n), TAU * (i % 40) as f64 / f64::from(m));
        [(1.0 + 0.4 * v.cos()) * u.cos(), (1.0 + 0.4 * v.cos()) * u.sin(), 0.4 * v.sin()]
    });
    let mut open = sphere(1.0, 5);
    let points = open.vertices.clone();
    open.faces.retain(|face| points[face[0] as usize][0] < 0.6);
    let mut needle = sphere(1.0, 4);
    needle.vertices.iter_mut().for_each(|p| p[1] *= 0.01);
    vec![("torus", round), ("open", open), ("soup", soup), ("flat", needle)]
}

#[test]
fn numbers_are_those_of_all_triangles() {
    let mut random = Random(9);
    for (name, mesh) in meshes() {
        let mesh = mesh.build();
        let mut queries: Vec<Vec3> = (0..600).map(|_| in_cube(&mut random, 3.0)).collect();
        queries.extend((0..100).map(|_| in_cube(&mut random, 30.0)));
        // Near the surface.
        for _ in 0..300 {
            let p = mesh.vertices()[random.below(mesh.vertices().len())];
            let by = in_cube(&mut random, 0.02);
            queries.push([0, 1, 2].map(|i| p[i] + by[i]));
        }
        let found = mesh.winding_numbers(&queries, &Job::default()).unwrap();
        let expected: Vec<f64> = queries.iter().map(|&q| by_excess(&mesh, q)).collect();
        let errors: Vec<f64> = found.iter().zip(&expected).map(|(x, y)| (x - y).abs()).collect();
        let most = errors.iter().fold(0.0f64, |m, &x| m.max(x));
        // Measured: at most 1.1e-3, in the mean 1.8e-4.
        let mean = errors.iter().sum::<f64>() / errors.len() as f64;
        assert!(most < ERROR && mean < ERROR / 4.0, "{name}: {most}, {mean} in the mean");
    }
}

#[test]
fn size_and_place_do_not_matter() {
    let mut random = Random(2);
    let queries: Vec<Vec3> = (0..100).map(|_| in_cube(&mut random, 3.0)).collect();
    let mesh = sphere(1.0, 3);
    let expected = numbers(&mesh, &queries);
    // Powers of two change no digit, far from overflow and near.
    for exponent in [-1000, -300, 300, 1000] {
        let scale = 2f64.powi(exponent);
        let mut scaled = mesh.clone();
        scaled.vertices.iter_mut().flatten().for_each(|x| *x *= scale);
        let queries: Vec<Vec3> = queries.iter().map(|q| q.map(|x| x * scale)).collect();
        assert_eq!(numbers(&scaled, &queries), expected, "2^{exponent}");
    }
    let by = [1e6, -3e5, 2e6];
    let queries: Vec<Vec3> = queries.iter().map(|q| [0, 1, 2].map(|i| q[i] + by[i])).collect();
    close(&numbers(&moved(mesh.clone(), by), &queries), &expected, ERROR);
    // As far away as can be.
    for far in [f64::MAX, f64::MIN, 1e200] {
        close(&numbers(&mesh, &[[far; 3], [0.0, far, 1.0]]), &[0.0; 2], 1e-15);
    }
    let mut small = mesh;
    small.vertices.iter_mut().flatten().for_each(|x| *x *= 1e-300);
    close(&numbers(&small, &[[f64::MAX; 3], [0.0; 3]]), &[0.0, 1.0], 0.01);
}

#[test]
fn polygons_count_as_their_triangles_and_copies_count_again() {
    let n = 30u32;
    let rim = |z: f64| {
        (0..n).map(move |i| {
            let turn = TAU * f64::from(i) / f64::from(n);
            [turn.cos(), turn.sin(), z]
        })
    };
    let mut prism = Builder { vertices: rim(0.0).chain(rim(1.0)).collect(), ..Builder::default() };
    prism.faces.push((0..n).rev().collect());
    prism.faces.push((n..2 * n).collect());
    for i in 0..n {
        let next = (i + 1) % n;
        prism.faces.push(vec![i, next, n + next, n + i]);
    }
    let queries = [[0.0, 0.0, 0.5], [0.5, -0.3, 0.9], [0.0, 0.0, 1.1], [1.1, 0.0, 0.5]];
    let once = [1.0, 1.0, 0.0, 0.0];
    close(&numbers(&prism, &queries), &once, ERROR);
    let thrice = prism.clone().and(&prism).and(&prism);
    close(&numbers(&thrice, &queries), &once.map(|x| 3.0 * x), 3.0 * ERROR);
    // A triangle without area counts nothing.
    let mut flat = prism.clone();
    flat.vertices.push([0, 1, 2].map(|i| (prism.vertices[0][i] + prism.vertices[1][i]) / 2.0));
    flat.faces.push(vec![0, 1, 2 * n]);
    close(&numbers(&flat, &queries), &numbers(&prism, &queries), ERROR);
}

#[test]
fn threads_change_no_byte() {
    let mesh = sphere(1.0, 4).build();
    let mut random = Random(7);
    let queries: Vec<Vec3> = (0..3000).map(|_| in_cube(&mut random, 3.0)).collect();
    let by = |threads| {
        let job = Job::new(JobOptions { threads, ..JobOptions::default() });
        mesh.winding_numbers(&queries, &job).unwrap()
    };
    let bits = |numbers: Vec<f64>| numbers.into_iter().map(f64::to_bits).collect::<Vec<_>>();
    let one = bits(by(1));
    for threads in [2, 3, 8] {
        assert_eq!(bits(by(threads)), one, "{threads} threads");
    }
    // Each number is that of its query, whatever the others are.
    for (i, &query) in queries.iter().enumerate().step_by(301) {
        let alone = mesh.winding_numbers(&[query], &Job::default()).unwrap();
        assert_eq!(alone[0].to_bits(), one[i]);
    }
}

#[test]
fn what_cannot_be_is_told() {
    let mesh = cube().build();
    let job = Job::default();
    assert!(mesh.winding_numbers(&[], &job).unwrap().is_empty());
    for wrong in [f64::NAN, f64::INFINITY] {
        let error = mesh.winding_numbers(&[[0.0; 3], [0.0, wrong, 0.0]], &job).unwrap_err();
        assert_eq!(error.status(), Status::NonFinite);
        assert_eq!(error.element(), Some((ElementKind::Row, 1)));
    }
    let bare = Builder::new(4).edges(&[[0, 1]]).tets(&[[0, 1, 2, 3]]).build();
    let error = bare.winding_numbers(&[[0.0; 3]], &job).unwrap_err();
    assert_eq!(error.status(), Status::InvalidArgument);
    assert!(error.message().contains("no faces"), "{}", error.message());
    let small = Job::new(JobOptions { memory_ceiling: 500, ..JobOptions::default() });
    let error = mesh.winding_numbers(&[[0.0; 3]], &small).unwrap_err();
    assert_eq!(error.status(), Status::OutOfMemory);
    job.cancel();
    let error = mesh.winding_numbers(&[[0.0; 3]], &job).unwrap_err();
    assert_eq!(error.status(), Status::Cancelled);
}

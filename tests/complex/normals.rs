//! Normals at vertices: of known surfaces, of rotated ones, of all scales.

use crate::shapes::Random;
use medax::complex::{ComplexParts, Rows};
use medax::{Complex, Job};

type Point = [f64; 3];

fn dot(a: Point, b: Point) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

fn cross(a: Point, b: Point) -> Point {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i] * b[j] - a[j] * b[i])
}

fn unit(a: Point) -> Point {
    a.map(|x| x / dot(a, a).sqrt())
}

fn minus(a: Point, b: Point) -> Point {
    [0, 1, 2].map(|k| a[k] - b[k])
}

fn distance(a: Point, b: Point) -> f64 {
    let d = minus(a, b);
    dot(d, d).sqrt()
}

fn normals(vertices: Vec<Point>, faces: &[[u32; 3]]) -> Vec<Point> {
    let mut rows = Rows::default();
    faces.iter().for_each(|face| rows.push(face).unwrap());
    let parts = ComplexParts { vertices, faces: rows, ..Default::default() };
    Complex::new(parts).unwrap().vertex_normals(&Job::default()).unwrap()
}

/// A grid of `n` x `n` vertices, each moved a little, with a height over its place.
fn grid(n: usize, jitter: f64, height: impl Fn(f64, f64) -> f64) -> (Vec<Point>, Vec<[u32; 3]>) {
    let mut random = Random(7);
    let mut place = |i: usize| (i as f64 + jitter * random.unit()) / n as f64;
    let at = (0..n * n).map(|i| [place(i / n), place(i % n)]);
    let vertices = at.map(|[x, y]| [x, y, height(x, y)]).collect();
    let mut faces = Vec::new();
    for (i, j) in (0..n - 1).flat_map(|i| (0..n - 1).map(move |j| (i, j))) {
        let [a, b, c, d] = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
        let [a, b, c, d] = [a, b, c, d].map(|[i, j]| (n * i + j) as u32);
        faces.extend([[a, b, c], [a, c, d]]);
    }
    (vertices, faces)
}

/// The surface of a box of `n` steps each way, its faces in squares cut in two.
fn cube(n: usize) -> (Vec<Point>, Vec<[u32; 3]>) {
    let (mut vertices, mut faces): (Vec<Point>, Vec<[u32; 3]>) = Default::default();
    for (axis, side) in (0..6).map(|i| (i % 3, i / 3)) {
        for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
            let mut ring = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[di, dj]| {
                let mut p = [0.0; 3];
                p[axis] = side as f64;
                p[(axis + 1) % 3] = (i + di) as f64 / n as f64;
                p[(axis + 2) % 3] = (j + dj) as f64 / n as f64;
                let known = vertices.iter().position(|&q| q == p);
                known.unwrap_or_else(|| {
                    vertices.push(p);
                    vertices.len() - 1
                }) as u32
            });
            if side == 0 {
                ring.reverse();
            }
            faces.extend([[ring[0], ring[1], ring[2]], [ring[0], ring[2], ring[3]]]);
        }
    }
    (vertices, faces)
}

/// Three axes at random, at right angles.
fn rotation(seed: u64) -> [Point; 3] {
    let mut random = Random(seed);
    let mut direction = || unit([0; 3].map(|_| random.unit() - 0.5));
    let x = direction();
    let y = unit(cross(x, direction()));
    [x, y, cross(x, y)]
}

fn rotate(axes: &[Point; 3], p: Point) -> Point {
    axes.map(|axis| dot(axis, p))
}

#[test]
fn normals_of_rotated_meshes_are_the_rotated_normals() {
    let bent = |x: f64, _| if x < 0.5 { 0.0 } else { (x - 0.5).powi(2) };
    let bowl = |x: f64, y: f64| 1e-4 * (x * x + y * y);
    let saddle = |x: f64, y: f64| (x - 0.5) * (y - 0.5);
    // Samples in rows, joined by triangles that are thin but for rounding without area.
    let (strip, mut faces) = grid(16, 0.0, |_, _| 0.25);
    faces.extend((0..14).map(|i| [i, i + 1, i + 2]));
    for (name, (vertices, faces)) in [
        ("flat", grid(24, 0.3, |_, _| 0.0)),
        ("half flat", grid(24, 0.3, bent)),
        ("nearly flat", grid(24, 0.3, bowl)),
        ("hardly curved", grid(24, 0.3, |x, y| 1e-6 * bowl(x, y))),
        ("saddle", grid(25, 0.0, saddle)),
        ("needles", (strip, faces)),
        ("cube", cube(9)),
    ] {
        for shift in [0.0, 1.0, 100.0] {
            let vertices: Vec<Point> = vertices.iter().map(|p| p.map(|x| x + shift)).collect();
            let before = normals(vertices.clone(), &faces);
            for seed in 0..4 {
                let axes = rotation(seed);
                let turned = vertices.iter().map(|&p| rotate(&axes, p)).collect();
                let after = normals(turned, &faces);
                let errors = before.iter().zip(after).map(|(&n, m)| distance(rotate(&axes, n), m));
                let worst = errors.fold(0.0, f64::max);
                assert!(worst < 2e-6, "{name}, shifted by {shift}, turned by {seed}: {worst}");
            }
        }
    }
}

#[test]
fn a_rotated_plane_has_its_own_normal() {
    let (vertices, faces) = grid(30, 0.3, |_, _| 0.0);
    for seed in 0..8 {
        let axes = rotation(seed);
        let up = rotate(&axes, [0.0, 0.0, 1.0]);
        let found = normals(vertices.iter().map(|&p| rotate(&axes, p)).collect(), &faces);
        let worst = found.into_iter().map(|n| distance(n, up)).fold(0.0, f64::max);
        assert!(worst < 1e-6, "{seed}: {worst}");
    }
}

/// Where a surface is curved its curvature decides, not the mean of its triangles.
#[test]
fn a_normal_is_that_of_the_curvature() {
    // Four uneven triangles round a peak, closed below: the sum of the cotangents' edges, edge by edge.
    let rim = [[2.0, 0.1, -0.3], [0.2, 1.0, -0.6], [-1.5, 0.3, -0.5], [0.1, -0.7, -0.4]];
    for height in [1.0, 1e-3, 1e-6] {
        let mut vertices: Vec<Point> = vec![[0.0; 3]];
        vertices.extend(rim.map(|[x, y, z]| [x, y, height * z]));
        let faces = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]];
        let mut sum = [0.0; 3];
        for [a, b, c] in faces.map(|face| face.map(|v| vertices[v as usize])) {
            for (y, other) in [(b, c), (c, b)] {
                // The edge from a to y, and the angle opposite.
                let (u, v) = (minus(a, other), minus(y, other));
                let n = cross(u, v);
                let cotangent = dot(u, v) / dot(n, n).sqrt();
                sum = [0, 1, 2].map(|k| sum[k] + cotangent * (a[k] - y[k]));
            }
        }
        let found = normals(vertices, &faces)[0];
        let error = distance(found, unit(sum));
        assert!(error < 1e-12 / height, "{height}: {found:?}, not {:?}", unit(sum));
    }
}

#[test]
fn normals_do_not_depend_on_the_scale() {
    let (vertices, faces) = cube(5);
    let middle = vertices.iter().map(|p| p.map(|x| x - 0.5)).collect::<Vec<_>>();
    let expected = normals(middle.clone(), &faces);
    assert!(expected.iter().all(|&n| (dot(n, n) - 1.0).abs() < 1e-12));
    for exponent in [-1000, -700, -265, -100, 100, 333, 700, 1020] {
        let scale = 2f64.powi(exponent);
        let scaled = middle.iter().map(|p| p.map(|x| x * scale)).collect();
        assert_eq!(normals(scaled, &faces), expected, "2^{exponent}");
    }
}

//! Distances between complexes: closed formulas, and brute force.

use super::shapes::*;
use medax::complex::{CompareOptions, Comparison, compare};
use medax::{Complex, Job, JobOptions, Status};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

fn run(a: &Builder, b: &Builder, samples: usize) -> Comparison {
    let options = CompareOptions { samples, seed: 1 };
    compare(&a.build(), &b.build(), &options, &Job::default()).unwrap()
}

fn close(x: f64, y: f64, tolerance: f64) {
    assert!((x - y).abs() <= tolerance, "{x} is not {y}, within {tolerance}");
}

/// A square [x, x + 1] x [0, 1] at height z, as an n x n grid.
fn square(n: u32, x: f64, z: f64) -> Builder {
    let mut square = Builder::new(((n + 1) * (n + 1)) as usize);
    for i in 0..n {
        for j in 0..n {
            let a = i * (n + 1) + j;
            square = square.faces(&[[a, a + n + 1, a + n + 2, a + 1]]);
        }
    }
    let side = |k: usize| k as f64 / f64::from(n);
    let m = n as usize + 1;
    square.place(|v| [x + side(v / m), side(v % m), z])
}

#[test]
fn parallel_planes() {
    let c = run(&square(5, 0.0, 0.0), &square(3, 0.0, 0.25), 1000);
    for d in [c.a_to_b, c.b_to_a] {
        for distance in [d.max, d.mean, d.rms] {
            close(distance, 0.25, 1e-15);
        }
    }
    close(c.diagonal, (2.0f64 + 0.0625).sqrt(), 1e-15);
    // Shifted by half a side: half lies on the other, the rest up to 1/2 away.
    let c = run(&square(4, 0.0, 0.0), &square(7, 0.5, 0.0), 40_000);
    for d in [c.a_to_b, c.b_to_a] {
        assert_eq!(d.max, 0.5);
        close(d.mean, 0.125, 1e-3);
        close(d.rms, (1.0f64 / 24.0).sqrt(), 1e-3);
    }
}

#[test]
fn concentric_spheres() {
    let c = run(&sphere(1.0, 5), &sphere(1.5, 5), 20_000);
    // The facets cut the corners by less than 1/1000 of the radius.
    for d in [c.a_to_b, c.b_to_a] {
        close(d.max, 0.5, 2e-3);
        close(d.mean, 0.5, 2e-3);
        close(d.rms, 0.5, 2e-3);
        assert!(d.mean <= d.rms && d.rms <= d.max);
    }
    close(c.diagonal, 27f64.sqrt(), 1e-12);
    // Not the distance between the nearest points: a far ear counts on one side only.
    let ball = sphere(1.0, 3);
    let mut ear = Builder::new(3).faces(&[[0, 1, 2]]);
    ear = ear.place(|i| [[9.0, 0.0, 0.0], [10.0, 0.0, 0.0], [10.0, 1e-9, 0.0]][i]);
    let c = run(&ball.clone().and(&ear), &ball, 1000);
    close(c.a_to_b.max, 9.0, 1e-9);
    assert!(c.b_to_a.max < 1e-15 && c.a_to_b.mean < 1e-3);
}

#[test]
fn edges_points_and_solids() {
    let segment = |y: f64| Builder::new(2).edges(&[[0, 1]]).place(|i| [i as f64, y, 0.0]);
    // From a segment on the axis to a point beyond its end: 1 to 2, uniform.
    let point = Builder::new(1).place(|_| [-1.0, 0.0, 0.0]);
    let c = run(&segment(0.0), &point, 20_000);
    assert_eq!((c.a_to_b.max, c.b_to_a.max), (2.0, 1.0));
    close(c.a_to_b.mean, 1.5, 1e-3);
    close(c.a_to_b.rms, (7.0f64 / 3.0).sqrt(), 1e-3);
    assert_eq!((c.b_to_a.mean, c.b_to_a.rms), (1.0, 1.0));
    let c = run(&segment(0.0), &segment(3.0), 100);
    assert_eq!((c.a_to_b.max, c.a_to_b.mean), (3.0, 3.0));
    // In a solid nothing is far; the skin of a solid is what is sampled.
    let block = cubes([4, 4, 4], |_| true);
    let inside = Builder::new(2).place(|i| [[2.0, 1.75, 2.5], [2.0, 2.0, 5.0]][i]);
    let c = run(&inside, &block, 100);
    assert_eq!((c.a_to_b.max, c.a_to_b.mean), (1.0, 0.5));
    let c = run(&block, &outer_facets(&block), 1000);
    // The vertex in the middle is 2 from the skin; the samples lie on it.
    assert_eq!(c.a_to_b.max, 2.0);
    assert!(c.b_to_a.max < 2e-15 && c.a_to_b.mean < 2e-15);
    // Faces without area give way to edges, and those to vertices.
    let flat = Builder::new(3).faces(&[[0, 1, 2]]).edges(&[[0, 2]]);
    let flat = flat.place(|i| [i as f64, 0.0, 0.0]);
    let c = run(&flat, &point, 20_000);
    close(c.a_to_b.mean, 2.0, 1e-3);
    let spot = Builder::new(3).faces(&[[0, 1, 2]]).edges(&[[0, 2]]);
    assert_eq!(run(&spot, &point, 100).a_to_b.mean, 1.0);
    // Vertices that nothing uses play no part.
    let stray = segment(0.0).and(&Builder::new(1).place(|_| [50.0; 3]));
    let c = run(&stray, &segment(3.0), 100);
    assert_eq!((c.a_to_b.max, c.b_to_a.max), (3.0, 3.0));
    assert_eq!(c.diagonal, 10f64.sqrt());
}

/// The distance from a point to a triangle, edge or point, by the nearest of all candidates: the
/// foot in the plane if it lies inside, feet on the lines of the sides, corners.
fn brute_distance(p: [f64; 3], corners: &[[f64; 3]]) -> f64 {
    let sub = |a: [f64; 3], b: [f64; 3]| -> [f64; 3] { std::array::from_fn(|i| a[i] - b[i]) };
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let apart = |q: [f64; 3]| dot(sub(p, q), sub(p, q)).sqrt();
    let mut best = f64::INFINITY;
    for (i, &a) in corners.iter().enumerate() {
        best = best.min(apart(a));
        for &b in &corners[i + 1..] {
            let t = dot(sub(p, a), sub(b, a)) / dot(sub(b, a), sub(b, a));
            if (0.0..=1.0).contains(&t) {
                best = best.min(apart(std::array::from_fn(|k| a[k] + t * (b[k] - a[k]))));
            }
        }
    }
    if let &[a, b, c] = corners {
        let (u, v, w) = (sub(b, a), sub(c, a), sub(p, a));
        let (uu, uv, vv) = (dot(u, u), dot(u, v), dot(v, v));
        let (s, t) = (dot(u, w) * vv - dot(v, w) * uv, dot(v, w) * uu - dot(u, w) * uv);
        let size = uu * vv - uv * uv;
        if s >= 0.0 && t >= 0.0 && s + t <= size {
            let (s, t) = (s / size, t / size);
            best = best.min(apart(std::array::from_fn(|k| a[k] + s * u[k] + t * v[k])));
        }
    }
    best
}

#[test]
fn the_nearest_point_is_found() {
    for seed in 0..20 {
        let mut random = Random(seed);
        let mut soup = |n: usize, faces: usize, edges: usize| {
            let at: Vec<[f64; 3]> =
                (0..n).map(|_| std::array::from_fn(|_| random.unit())).collect();
            let mut soup = Builder::new(n).place(|i| at[i]);
            let v = |k: usize| (k % n) as u32;
            for _ in 0..faces {
                let k = random.below(n);
                soup = soup.faces(&[[v(k), v(k + 1), v(k + 2)]]);
            }
            for _ in 0..edges {
                let k = random.below(n);
                soup = soup.edges(&[[v(k), v(k + 3)]]);
            }
            soup
        };
        // The third has more than one tree.
        let (a, b) = match seed {
            0..10 => (soup(40, 60, 10), soup(30, 25, 30)),
            10..18 => (soup(100, 0, 0), soup(60, 0, 20)),
            _ => (soup(20, 5, 0), soup(9000, 20_000, 9000)),
        };
        let c = run(&a, &b, 0);
        let used = |b: &Builder| b.clone().compact().vertices;
        let points = if a.faces.is_empty() { a.vertices.clone() } else { used(&a) };
        let distances: Vec<f64> = points
            .iter()
            .map(|&p| {
                let at = |v: u32| b.vertices[v as usize];
                let faces = b.faces.iter().map(|f| [at(f[0]), at(f[1]), at(f[2])]);
                let faces = faces.map(|t| brute_distance(p, &t));
                let edges = b.edges.iter().map(|e| brute_distance(p, &e.map(at)));
                faces.chain(edges).fold(f64::INFINITY, f64::min)
            })
            .collect();
        let n = distances.len() as f64;
        close(c.a_to_b.max, distances.iter().copied().fold(0.0, f64::max), 1e-13);
        close(c.a_to_b.mean, distances.iter().sum::<f64>() / n, 1e-13);
        close(c.a_to_b.rms, (distances.iter().map(|d| d * d).sum::<f64>() / n).sqrt(), 1e-13);
    }
}

#[test]
fn the_same_samples_every_time() {
    let (a, b) = (sphere(1.0, 2), sphere(1.1, 3));
    let first = run(&a, &b, 500);
    assert_eq!(run(&a, &b, 500), first);
    let back = run(&b, &a, 500);
    assert_eq!((back.b_to_a, back.a_to_b), (first.a_to_b, first.b_to_a));
    let other = CompareOptions { samples: 500, seed: 2 };
    let other = compare(&a.build(), &b.build(), &other, &Job::default()).unwrap();
    assert_ne!(other.a_to_b.mean, first.a_to_b.mean);
    close(other.a_to_b.mean, first.a_to_b.mean, 1e-3);
    // Scaling by a power of two scales the result, however small or large.
    for exponent in [-900, -300, 300, 1000] {
        let s = 2f64.powi(exponent);
        let scaled = |b: &Builder| {
            let mut b = b.clone();
            b.vertices.iter_mut().for_each(|p| *p = p.map(|x| x * s));
            b
        };
        let c = run(&scaled(&a), &scaled(&b), 500);
        assert_eq!(c.a_to_b.rms, first.a_to_b.rms * s);
        assert_eq!((c.b_to_a.max, c.diagonal), (first.b_to_a.max * s, first.diagonal * s));
    }
}

#[test]
fn samples_are_uniform() {
    // A square of one small and one large part: as many samples as area, in each part.
    let at = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.1, 0.0], [0.1, 1.0]];
    let parts = Builder::new(6).faces(&[[0, 4, 5, 3], [4, 1, 2, 5]]);
    let parts = parts.place(|i| [at[i][0], at[i][1], 0.0]);
    let line =
        |x: f64| Builder::new(2).edges(&[[0, 1]]).place(move |i| [x, i as f64 * 20.0 - 10.0, 0.0]);
    // The mean distance to x = 0 is the mean of x, to y = 0 that of y.
    let c = run(&parts, &line(0.0), 50_000);
    close(c.a_to_b.mean, 0.5, 1e-3);
    close(c.a_to_b.rms, (1.0f64 / 3.0).sqrt(), 1e-3);
    let c = run(&parts, &line(1.0), 50_000);
    close(c.a_to_b.mean, 0.5, 1e-3);
    let mut turned = parts.clone();
    turned.vertices.iter_mut().for_each(|p| p.swap(0, 1));
    let c = run(&turned, &line(0.0), 50_000);
    close(c.a_to_b.mean, 0.5, 1e-3);
    close(c.a_to_b.rms, (1.0f64 / 3.0).sqrt(), 1e-3);
}

#[test]
fn what_cannot_be_compared() {
    let (ball, none) = (sphere(1.0, 1).build(), Builder::new(0).build());
    let options = CompareOptions::default();
    let status =
        |a: &Complex, b: &Complex, job: &Job| compare(a, b, &options, job).unwrap_err().status();
    let job = Job::default();
    assert_eq!(status(&ball, &none, &job), Status::TooFewPoints);
    assert_eq!(status(&none, &ball, &job), Status::TooFewPoints);
    let huge = Builder::new(2).place(|i| [[-f64::MAX; 3], [f64::MAX; 3]][i]).build();
    assert_eq!(status(&ball, &huge, &job), Status::CoordinateRange);
    let tight = Job::new(JobOptions { memory_ceiling: 1000, ..JobOptions::default() });
    assert_eq!(status(&ball, &ball, &tight), Status::OutOfMemory);
    job.cancel();
    assert_eq!(status(&ball, &ball, &job), Status::Cancelled);
    // Under way: the third report of progress asks to stop.
    let calls = Arc::new(AtomicUsize::new(0));
    let counter = Arc::clone(&calls);
    let progress = move |_, _| counter.fetch_add(1, Ordering::Relaxed) < 2;
    let watched =
        Job::new(JobOptions { progress: Some(Box::new(progress)), ..JobOptions::default() });
    let large = CompareOptions { samples: 100_000_000, seed: 0 };
    let stopped = compare(&ball, &ball, &large, &watched).unwrap_err();
    assert_eq!((stopped.status(), calls.load(Ordering::Relaxed)), (Status::Cancelled, 3));
}

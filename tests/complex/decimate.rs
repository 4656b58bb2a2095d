//! Decimation: what must stay, and how far the surface comes from what it was.

use super::shapes::*;
use medax::complex::{
    Attribute, CompareOptions, Comparison, DecimateOptions, Element, Topology, Values, compare,
};
use medax::crust::PowerCrustOptions;
use medax::points::{Points, PointsOptions};
use medax::sample::{SampleOptions, Shape, sample};
use medax::{Complex, Job, JobOptions, PowerCrust, Status};
use std::f64::consts::TAU;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

fn decimated(complex: &Complex, triangles: usize, max_error: Option<f64>) -> Complex {
    let options = DecimateOptions { triangles, max_error };
    let result = complex.decimate(options, &Job::default()).unwrap();
    assert!(result.validate(&Job::default()).unwrap().is_valid());
    result
}

fn topology(complex: &Complex) -> Topology {
    complex.topology(&Job::default()).unwrap()
}

fn distances(a: &Complex, b: &Complex) -> Comparison {
    let options = CompareOptions { samples: 20_000, seed: 0 };
    compare(a, b, &options, &Job::default()).unwrap()
}

/// The larger mean and the larger maximum, as shares of the diagonal.
fn shares(a: &Complex, b: &Complex) -> [f64; 2] {
    let c = distances(a, b);
    [c.a_to_b.mean.max(c.b_to_a.mean), c.a_to_b.max.max(c.b_to_a.max)].map(|x| x / c.diagonal)
}

/// The topology of a surface that does not depend on how it is cut into faces.
fn invariants(complex: &Complex) -> (u64, Option<u64>, u64, bool, bool, [u64; 3]) {
    let t = topology(complex);
    (t.components, t.genus, t.boundary_loops, t.closed, t.oriented, t.betti)
}

fn crust(shape: Shape) -> Complex {
    let samples = sample(shape, SampleOptions::default(), &Job::default()).unwrap();
    let points = Points::new(samples.points(), PointsOptions::default(), &Job::default()).unwrap();
    let options = PowerCrustOptions::default();
    let crust = PowerCrust::build(&Arc::new(points), options, &Job::default()).unwrap();
    crust.surface().as_ref().clone()
}

/// A torus of n x m squares.
fn ring(n: u32, m: u32) -> Builder {
    torus(n, m).place(|i| {
        let (u, v) = (i as u32 / m, i as u32 % m);
        let (u, v) = (TAU * f64::from(u) / f64::from(n), TAU * f64::from(v) / f64::from(m));
        let r = 1.0 + 0.4 * v.cos();
        [r * u.cos(), r * u.sin(), 0.4 * v.sin()]
    })
}

/// The surface of a cube of n x n x n cells, two triangles a square.
fn cube(n: u32) -> Complex {
    let mut numbers = std::collections::BTreeMap::new();
    let mut faces: Vec<[u32; 3]> = Vec::new();
    for axis in 0..3 {
        for (end, i, j) in
            (0..2).flat_map(|e| (0..n).flat_map(move |i| (0..n).map(move |j| (e, i, j))))
        {
            let mut corner = |i: u32, j: u32| {
                let mut p = [0; 3];
                p[axis] = end * n;
                p[(axis + 1) % 3] = i;
                p[(axis + 2) % 3] = j;
                let next = numbers.len() as u32;
                *numbers.entry(p).or_insert(next)
            };
            let ring = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
            let [a, b, c, d] = if end == 1 { ring } else { [ring[0], ring[3], ring[2], ring[1]] };
            faces.extend([[a, b, c], [a, c, d]]);
        }
    }
    let mut at = vec![[0.0; 3]; numbers.len()];
    numbers.iter().for_each(|(p, &v)| at[v as usize] = p.map(f64::from));
    Builder::new(at.len()).faces(&faces).place(|i| at[i]).build()
}

/// Measured: means 1.6e-4 (torus of squares), 5.2e-6, 2.9e-6, 2.4e-5 (crusts); maxima 8.2e-4, 1.2e-4, 8e-5, 4e-4.
#[test]
fn a_quarter_of_the_triangles_is_the_same_surface() {
    let smooth = ring(120, 60).build();
    let cases = [
        (smooth, 1, 2e-4, 1e-3),
        (crust(Shape::Torus), 1, 1e-5, 2e-4),
        (crust(Shape::Genus3), 3, 1e-5, 2e-4),
        (crust(Shape::Ellipsoid), 0, 5e-5, 1e-3),
    ];
    for (i, (surface, genus, mean, max)) in cases.into_iter().enumerate() {
        let aim = surface.triangles().len() / 4;
        let result = decimated(&surface, aim, None);
        let [found_mean, found_max] = shares(&surface, &result);
        let (before, after) = (surface.triangles().len(), result.triangles().len());
        println!("{i}: {before} to {after}, mean {found_mean:.2e}, max {found_max:.2e}");
        assert_eq!(invariants(&result), invariants(&surface), "{i}");
        assert_eq!(topology(&result).genus, Some(genus), "{i}");
        assert!(topology(&result).closed && topology(&result).oriented);
        assert!(after <= aim && after + 2 >= aim, "{i}: {after} of {aim}");
        assert!(found_mean < mean && found_max < max, "{i}: {found_mean:e}, {found_max:e}");
        let volume = |c: &Complex| c.measure(&Job::default()).unwrap().volume;
        assert!((volume(&result) / volume(&surface) - 1.0).abs() < 0.01);
    }
}

#[test]
fn a_cube_comes_down_to_twelve() {
    for n in [2, 7, 16] {
        let cube = cube(n);
        let result = decimated(&cube, 12, None);
        assert_eq!((result.triangles().len(), result.vertices().len()), (12, 8), "{n}");
        let [_, max] = shares(&cube, &result);
        assert!(max < 1e-14, "{max:e}");
        // No distance at all is asked for, and the same is found.
        let exact = decimated(&cube, 0, Some(0.0));
        assert_eq!(exact.triangles().len(), 12, "{n}");
        assert!(shares(&cube, &exact)[1] < 1e-11);
    }
}

#[test]
fn as_few_as_can_be_is_still_the_same_topology() {
    let surface = ring(40, 20).and(&tetrahedron()).build();
    let result = decimated(&surface, 0, None);
    assert_eq!(invariants(&result), invariants(&surface));
    // No torus has fewer than 14 triangles.
    assert!((18..60).contains(&result.triangles().len()), "{}", result.triangles().len());
    for aim in [surface.triangles().len(), usize::MAX] {
        let same = decimated(&surface, aim, None);
        assert_eq!((same.vertices(), same.faces()), (surface.vertices(), surface.faces()));
    }
}

#[test]
fn open_surfaces_keep_their_loops() {
    // A square with a square hole, and a Moebius band, which has no orientation to keep.
    let n = 12u32;
    let mut sheet = Builder::new(((n + 1) * (n + 1)) as usize);
    for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
        if !((4..8).contains(&i) && (4..8).contains(&j)) {
            let a = i * (n + 1) + j;
            sheet = sheet.faces(&[[a, a + n + 1, a + n + 2, a + 1]]);
        }
    }
    let m = n as usize + 1;
    let sheet = sheet.place(|v| [(v / m) as f64, (v % m) as f64, 0.0]).compact().build();
    let result = decimated(&sheet, 0, None);
    assert_eq!(invariants(&result), invariants(&sheet));
    assert_eq!(topology(&result).boundary_loops, 2);
    let part = decimated(&sheet, 40, None);
    assert!(part.triangles().len() <= 40);
    assert!(shares(&sheet, &part)[1] < 1e-12);
    let band = band(60, true).place(|i| {
        let (a, s) = (TAU * (i / 2) as f64 / 60.0, if i % 2 == 0 { 0.3 } else { -0.3 });
        let r = 1.0 + s * (a / 2.0).cos();
        [r * a.cos(), r * a.sin(), s * (a / 2.0).sin()]
    });
    let result = decimated(&band.build(), 40, None);
    assert_eq!(invariants(&result), invariants(&band.build()));
    assert!(result.triangles().len() <= 40);
}

#[test]
fn the_greatest_error_is_kept() {
    for surface in [ring(120, 60).build(), crust(Shape::Ellipsoid)] {
        let mut last = usize::MAX;
        for limit in [0.001, 0.01, 0.05] {
            let result = decimated(&surface, 0, Some(limit));
            let found = distances(&surface, &result);
            let worst = found.a_to_b.max.max(found.b_to_a.max);
            println!("{limit}: {} triangles, {worst:.3e}", result.triangles().len());
            // Between the points that are measured it may be a little more.
            assert!(worst < 1.25 * limit, "{worst} of {limit}");
            assert!(result.triangles().len() < last);
            assert_eq!(invariants(&result), invariants(&surface));
            last = result.triangles().len();
        }
    }
    let surface = tetrahedron().build();
    for wrong in [-1.0, f64::NAN] {
        let options = DecimateOptions { triangles: 0, max_error: Some(wrong) };
        let error = surface.decimate(options, &Job::default()).unwrap_err();
        assert_eq!(error.status(), Status::InvalidArgument);
    }
}

#[test]
fn what_is_no_manifold_stays() {
    // Two grids that cross in an edge of four sides, a loose edge, a cell, a vertex of its own.
    let book = |angle: f64| {
        let (sine, cosine) = angle.sin_cos();
        move |r: f64, z: f64| [r * cosine, r * sine, z]
    };
    let n = 6u32;
    let mut pages = Builder::new(0);
    let mut at: Vec<[f64; 3]> = (0..=n).map(|z| [0.0, 0.0, f64::from(z)]).collect();
    for k in 0..3 {
        let place = book(f64::from(k));
        let start = at.len() as u32;
        for r in 1..=n {
            at.extend((0..=n).map(|z| place(f64::from(r), f64::from(z))));
        }
        let v = |r: u32, z: u32| if r == 0 { z } else { start + (r - 1) * (n + 1) + z };
        for (r, z) in (0..n).flat_map(|r| (0..n).map(move |z| (r, z))) {
            pages = pages.faces(&[[v(r, z), v(r + 1, z), v(r + 1, z + 1), v(r, z + 1)]]);
        }
    }
    let corners = at.len() as u32;
    at.extend([[9.0, 9.0, 9.0], [10.0, 9.0, 9.0], [9.0, 10.0, 9.0], [9.0, 9.0, 10.0]]);
    at.push([20.0; 3]);
    pages.vertices = at;
    let pages = pages.edges(&[[n * (n + 1), corners]]);
    let pages = pages.tets(&[[corners, corners + 1, corners + 2, corners + 3]]);
    let mut parts = pages.parts();
    let radius = Values::F64(vec![1.0; parts.vertices.len()]);
    parts.attributes = vec![
        Attribute::new("radius", Element::Vertex, 1, radius).unwrap(),
        Attribute::new("kind", Element::Cell, 1, Values::U32(vec![7])).unwrap(),
    ];
    let complex = Complex::new(parts).unwrap();
    let result = decimated(&complex, 0, None);
    assert!(result.triangles().len() < complex.triangles().len() / 2);
    let (before, after) = (topology(&complex), topology(&result));
    assert_eq!(after.nonmanifold_edges, before.nonmanifold_edges);
    assert_eq!((after.components, after.betti), (before.components, before.betti));
    assert_eq!((result.edges().len(), result.cells().len()), (1, 1));
    let names: Vec<&str> = result.attributes().iter().map(|a| a.name()).collect();
    assert_eq!(names, ["kind"]);
    assert_eq!(result.vertices().last(), Some(&[20.0; 3]));
    let empty = Builder::new(0).build();
    assert_eq!(decimated(&empty, 0, None), empty);
}

#[test]
fn size_and_threads_change_nothing() {
    let surface = ring(40, 20);
    let result = decimated(&surface.build(), 300, Some(0.1));
    for exponent in [-1000, -300, 300, 1000] {
        let s = 2f64.powi(exponent);
        let mut scaled = surface.clone();
        scaled.vertices.iter_mut().for_each(|p| *p = p.map(|x| x * s));
        let scaled = decimated(&scaled.build(), 300, Some(0.1 * s));
        assert_eq!(scaled.faces(), result.faces(), "{exponent}");
    }
    for threads in [1, 3] {
        let job = Job::new(JobOptions { threads, ..JobOptions::default() });
        let options = DecimateOptions { triangles: 300, max_error: Some(0.1) };
        assert_eq!(surface.build().decimate(options, &job).unwrap(), result);
    }
}

#[test]
fn a_job_stops_it_and_bounds_its_memory() {
    let surface = ring(600, 300).build();
    let status = |job: &Job| {
        let options = DecimateOptions { triangles: 1000, max_error: Some(1.0) };
        surface.decimate(options, job).unwrap_err().status()
    };
    let tight = Job::new(JobOptions { memory_ceiling: 1 << 20, ..JobOptions::default() });
    assert_eq!(status(&tight), Status::OutOfMemory);
    let calls = Arc::new(AtomicUsize::new(0));
    let counter = Arc::clone(&calls);
    let progress = move |_, _| counter.fetch_add(1, Ordering::Relaxed) < 2;
    let watched =
        Job::new(JobOptions { progress: Some(Box::new(progress)), ..JobOptions::default() });
    assert_eq!((status(&watched), calls.load(Ordering::Relaxed)), (Status::Cancelled, 3));
    let job = Arc::new(Job::default());
    let canceller = Arc::clone(&job);
    let cancelled = std::thread::spawn(move || {
        while canceller.progress() < 0.1 {
            std::thread::sleep(Duration::from_millis(1));
        }
        canceller.cancel();
        Instant::now()
    });
    assert_eq!(status(&job), Status::Cancelled);
    let late = cancelled.join().unwrap().elapsed();
    assert!(late < Duration::from_millis(500), "{late:?}");
}

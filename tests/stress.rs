//! What takes minutes and much memory, and so is not part of `make test`: `make stress`.

use medax::crust::PowerCrustOptions;
use medax::io::read_points;
use medax::points::PointsOptions;
use medax::{Job, JobOptions, Points, PowerCrust, Triangulation};
use std::path::Path;
use std::sync::Arc;

/// Numbers in [0, 1), always the same (Marsaglia 2003, *Xorshift RNGs*).
fn numbers() -> impl FnMut() -> f64 {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64
    }
}

fn uniform(count: usize) -> Vec<[f64; 3]> {
    let mut unit = numbers();
    (0..count).map(|_| [unit(), unit(), unit()]).collect()
}

/// Points of an ellipsoid, each moved by up to so much along each axis.
fn ellipsoid(count: usize, noise: f64) -> Vec<[f64; 3]> {
    let mut unit = numbers();
    let mut rows = Vec::new();
    while rows.len() < count {
        let u = [0; 3].map(|_| 2.0 * unit() - 1.0);
        let length = u.iter().map(|x| x * x).sum::<f64>().sqrt();
        if (0.1..1.0).contains(&length) {
            let axes = [1.0, 0.7, 0.4];
            rows.push([0, 1, 2].map(|k| axes[k] * u[k] / length + noise * (2.0 * unit() - 1.0)));
        }
    }
    rows
}

fn lattice(side: u32) -> Vec<[f64; 3]> {
    let at = |i: u32| [i % side, i / side % side, i / side / side].map(f64::from);
    // A stride that has no factor in common with the count, instead of shuffling.
    let count = u64::from(side).pow(3);
    (0..count).map(|i| at((i * 7_368_787 % count) as u32)).collect()
}

fn with_threads(threads: usize) -> Job {
    Job::new(JobOptions { threads, ..JobOptions::default() })
}

fn points(rows: &[[f64; 3]], job: &Job) -> Arc<Points> {
    Arc::new(Points::new(rows, PointsOptions::default(), job).unwrap())
}

fn assert_valid(triangulation: &Triangulation, name: &str) {
    let report = triangulation.validate(&Job::default()).unwrap();
    assert!(report.is_valid(), "{name}: {report:?}");
    println!("{name}: {} cells, valid", triangulation.cells().len());
}

#[test]
#[ignore = "takes minutes: make stress"]
fn fifty_builds_with_eight_threads_are_the_same() {
    let rows = uniform(200_000);
    let mut unit = numbers();
    let weights: Vec<f64> = rows.iter().map(|_| 1e-3 * unit()).collect();
    let build = |threads| {
        let job = with_threads(threads);
        let points = points(&rows, &job);
        let delaunay = Triangulation::delaunay(&points, &job).unwrap();
        let regular = Triangulation::regular(&points, &weights, &job).unwrap();
        [delaunay, regular]
            .map(|t| (t.cells().to_vec(), t.neighbors().to_vec(), t.hidden().to_vec()))
    };
    let one = build(1);
    for i in 0..50 {
        assert!(build(8) == one, "build {i}");
    }
}

#[test]
#[ignore = "takes minutes: make stress"]
fn a_million_points_of_each_kind_are_valid() {
    let job = Job::default();
    let sets = [
        ("uniform", uniform(1_000_000)),
        ("ellipsoid", ellipsoid(1_000_000, 0.0)),
        ("ellipsoid, noise", ellipsoid(1_000_000, 0.005)),
        ("lattice", lattice(100)),
    ];
    for (name, rows) in &sets {
        assert_valid(&Triangulation::delaunay(&points(rows, &job), &job).unwrap(), name);
    }
    let mut unit = numbers();
    let weights: Vec<f64> = (0..1_000_000).map(|_| 1e-4 * unit()).collect();
    let weighted = Triangulation::regular(&points(&sets[0].1, &job), &weights, &job).unwrap();
    assert_valid(&weighted, "uniform, weights");
    for (name, noise) in [("poles", 0.0), ("poles, noise", 0.005)] {
        for round_poles in [false, true] {
            let options = PowerCrustOptions { round_poles, ..Default::default() };
            let samples = points(&ellipsoid(500_000, noise), &job);
            let crust = PowerCrust::build(&samples, options, &job).unwrap();
            assert_valid(crust.regular(), name);
        }
    }
}

#[test]
#[ignore = "takes minutes: make stress"]
fn large_scans_are_valid_and_the_same_with_any_threads() {
    for name in ["dragon.ply", "igea.ply"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data").join(name);
        if !path.exists() {
            println!("skipped: there is no {}", path.display());
            continue;
        }
        let points =
            Arc::new(read_points(path, PointsOptions::default(), &Job::default()).unwrap());
        let one = Triangulation::delaunay(&points, &with_threads(1)).unwrap();
        assert_valid(&one, name);
        for threads in [2, 3, 8] {
            let many = Triangulation::delaunay(&points, &with_threads(threads)).unwrap();
            assert!(many.cells() == one.cells() && many.neighbors() == one.neighbors(), "{name}");
        }
    }
}

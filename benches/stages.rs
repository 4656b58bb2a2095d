//! How long each stage takes: `make bench`, or `cargo bench -- 100000` for another size.
//!
//! Each case runs several times on one machine that should be idle; the table gives the least and the
//! median time of each stage, points per second of the median, and the peak of the arrays that
//! builds charge to their job.

use medax::crust::PowerCrustOptions;
use medax::dual::{Dual, DualOptions};
use medax::points::PointsOptions;
use medax::sample::{SampleOptions, Shape, sample};
use medax::{Job, Points, PowerCrust, Triangulation};
use std::sync::Arc;

/// How often each case runs.
const RUNS: usize = 5;

/// Uniform random points of the unit cube, by a generator that is good enough for this
/// (Marsaglia 2003, *Xorshift RNGs*).
fn uniform(count: usize) -> Vec<[f64; 3]> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut unit = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    (0..count).map(|_| [unit(), unit(), unit()]).collect()
}

/// About `count` samples of a built-in shape.
fn surface(shape: Shape, count: usize) -> Vec<[f64; 3]> {
    let job = Job::default();
    let probe = sample(shape, SampleOptions::default(), &job).unwrap();
    let density = count as f64 / probe.area();
    let options = SampleOptions { density, ..Default::default() };
    sample(shape, options, &job).unwrap().points().to_vec()
}

/// Runs the build several times and prints a line for each of its stages.
fn measure(name: &str, rows: &[[f64; 3]], build: impl Fn(&Arc<Points>, &Job)) {
    let mut runs = Vec::new();
    let mut peak = 0;
    for _ in 0..RUNS {
        let job = Job::default();
        let points = Points::new(rows.iter().copied(), PointsOptions::default(), &job).unwrap();
        build(&Arc::new(points), &job);
        runs.push(job.times());
        peak = peak.max(job.memory_peak());
    }
    println!(
        "{name}, {} points, peak {:.0} bytes a point",
        rows.len(),
        peak as f64 / rows.len() as f64
    );
    for (i, stage) in runs[0].iter().enumerate() {
        let mut seconds: Vec<f64> = runs.iter().map(|times| times[i].wall_seconds).collect();
        seconds.sort_unstable_by(f64::total_cmp);
        let median = seconds[RUNS / 2];
        println!(
            "    {:<12} {:>9.4} s least {:>9.4} s median {:>12.0} points/s",
            stage.stage.name(),
            seconds[0],
            median,
            rows.len() as f64 / median
        );
    }
}

fn main() {
    // Cargo passes --bench; a number is the size.
    let size = std::env::args().filter_map(|argument| argument.parse().ok()).next();
    for count in size.map_or(vec![10_000, 100_000], |count| vec![count]) {
        measure("Delaunay and dual, uniform in a cube", &uniform(count), |points, job| {
            let triangulation = Arc::new(Triangulation::delaunay(points, job).unwrap());
            Dual::new(&triangulation, DualOptions { facets: true }, job).unwrap();
        });
        for shape in [Shape::Torus, Shape::Bracket] {
            let name = format!("power crust, {}", shape.name());
            measure(&name, &surface(shape, count), |points, job| {
                PowerCrust::build(points, PowerCrustOptions::default(), job).unwrap();
            });
        }
    }
}

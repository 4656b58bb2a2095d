//! How long each stage takes: `make bench`, or `cargo bench --bench stages -- bracket` for some.
//!
//! Each benchmark runs whole builds on one thread and counts the time of one of their stages, as the job tells it. For the
//! effect of a change: `-- --save-baseline before`, then `-- --baseline before`. The machine should be idle.

use criterion::{BenchmarkId, Criterion, Throughput};
use medax::crust::PowerCrustOptions;
use medax::dual::{Dual, DualOptions};
use medax::points::PointsOptions;
use medax::sample::{SampleOptions, Shape, sample};
use medax::{Job, JobOptions, Points, PowerCrust, Stage, Triangulation};
use std::sync::Arc;
use std::time::Duration;

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

/// A benchmark for each of the stages of a build.
fn measure(
    criterion: &mut Criterion,
    name: &str,
    rows: &[[f64; 3]],
    stages: &[Stage],
    build: impl Fn(&Arc<Points>, &Job),
) {
    let mut group = criterion.benchmark_group(name);
    group.throughput(Throughput::Elements(rows.len() as u64)).sample_size(10);
    for &stage in stages {
        let id = BenchmarkId::new(stage.name(), rows.len());
        group.bench_function(id, |bencher| {
            bencher.iter_custom(|runs| {
                let mut spent = 0.0;
                for _ in 0..runs {
                    let job = Job::new(JobOptions { threads: 1, ..JobOptions::default() });
                    let points = Points::new(rows, PointsOptions::default(), &job);
                    build(&Arc::new(points.unwrap()), &job);
                    let times = job.times();
                    let its = times.iter().filter(|time| time.stage == stage);
                    spent += its.map(|time| time.wall_seconds).sum::<f64>();
                }
                Duration::from_secs_f64(spent)
            });
        });
    }
}

fn stages(criterion: &mut Criterion) {
    let of_dual = [Stage::Order, Stage::Triangulate, Stage::Dual];
    measure(criterion, "uniform", &uniform(50_000), &of_dual, |points, job| {
        let triangulation = Arc::new(Triangulation::delaunay(points, job).unwrap());
        Dual::new(&triangulation, DualOptions { facets: true }, job).unwrap();
    });
    let of_crust = [
        Stage::Triangulate,
        Stage::Dual,
        Stage::Poles,
        Stage::Regular,
        Stage::Label,
        Stage::Extract,
    ];
    for shape in [Shape::Torus, Shape::Bracket] {
        let rows = surface(shape, 20_000);
        measure(criterion, shape.name(), &rows, &of_crust, |points, job| {
            PowerCrust::build(points, PowerCrustOptions::default(), job).unwrap();
        });
    }
}

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    stages(&mut criterion);
    criterion.final_summary();
}

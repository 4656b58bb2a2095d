//! How soon long operations answer a cancel: `cargo bench --bench cancel`, or with `-- 1000000` for another
//! size.
//!
//! Each operation is cancelled at twenty moments of its run; the table gives the longest time from the
//! cancel to the return, and what the operation was doing then. The conventions promise 50 ms.

use medax::cocone::{Cocone, CoconeOptions};
use medax::complex::{DecimateOptions, compare};
use medax::crust::{Label, PowerCrustOptions};
use medax::dual::{Dual, DualOptions};
use medax::labels::Labels;
use medax::medial::{Medial, MedialFilter, MedialOptions, MedialRule, Side};
use medax::points::PointsOptions;
use medax::sample::{SampleOptions, Shape, sample};
use medax::{Job, Points, Poles, PowerCrust, Result, Triangulation, io};
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

/// At how many moments an operation is cancelled.
const MOMENTS: u32 = 20;

/// Cancels the operation all along its run, and prints the slowest answer.
fn measure(name: &str, operation: impl Fn(&Job) -> Result<()> + Sync) {
    let begun = Instant::now();
    operation(&Job::default()).unwrap();
    let whole = begun.elapsed();
    let mut slowest = (Duration::ZERO, "");
    for moment in 0..MOMENTS {
        let job = Job::default();
        let (answered, cancelled) = thread::scope(|scope| {
            let run = scope.spawn(|| {
                let _ = operation(&job);
                Instant::now()
            });
            thread::sleep(whole * moment / MOMENTS);
            job.cancel();
            let cancelled = Instant::now();
            (run.join().unwrap(), cancelled)
        });
        let answer = answered.saturating_duration_since(cancelled);
        if answer > slowest.0 {
            slowest = (answer, job.stage().name());
        }
    }
    println!(
        "{name:<24} {:>8.3} s whole {:>9.1} ms to cancel at most, in {}",
        whole.as_secs_f64(),
        slowest.0.as_secs_f64() * 1e3,
        slowest.1
    );
}

/// Random points of an ellipsoid, by a generator that is good enough for this (Marsaglia 2003,
/// *Xorshift RNGs*).
fn ellipsoid(count: usize) -> Vec<[f64; 3]> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut unit = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut point = |_| {
        let (z, turn) = (2.0 * unit() - 1.0, std::f64::consts::TAU * unit());
        let ring = (1.0 - z * z).sqrt();
        [ring * turn.cos(), 0.7 * ring * turn.sin(), 0.4 * z]
    };
    (0..count).map(&mut point).collect()
}

fn main() {
    // Cargo passes --bench; a number is the size.
    let size = std::env::args().filter_map(|argument| argument.parse().ok()).next();
    let count: usize = size.unwrap_or(200_000);
    let free = Job::default();
    let rows = &ellipsoid(count)[..];
    let points = Arc::new(Points::new(rows, PointsOptions::default(), &free).unwrap());
    let triangulation = Arc::new(Triangulation::delaunay(&points, &free).unwrap());
    let dual = Arc::new(Dual::new(&triangulation, DualOptions { facets: true }, &free).unwrap());
    let poles = Poles::new(&dual, Default::default(), &free).unwrap();
    let crust = PowerCrust::build(&points, PowerCrustOptions::default(), &free).unwrap();
    let surface = crust.surface();
    let cocone = Cocone::new(&dual, CoconeOptions::default(), &free).unwrap();
    let labels = Arc::new(Labels::of_cocone(&cocone, &free).unwrap());
    let medial = Medial::new(&dual, Some(&labels), MedialOptions::default(), &free).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("surface.ply");
    io::write_complex(&path, surface, Default::default(), &free).unwrap();

    measure("sample", |job| sample(Shape::Genus3, SampleOptions::default(), job).map(drop));
    measure("points", |job| Points::new(rows, PointsOptions::default(), job).map(drop));
    measure("Delaunay", |job| Triangulation::delaunay(&points, job).map(drop));
    measure("its validate", |job| triangulation.validate(job).map(drop));
    measure("dual", |job| Dual::new(&triangulation, DualOptions { facets: true }, job).map(drop));
    measure("its validate", |job| dual.validate(job).map(drop));
    measure("poles", |job| Poles::new(&dual, Default::default(), job).map(drop));
    measure("its validate", |job| poles.validate(job).map(drop));
    measure("feature size", |job| poles.feature_size(rows, job).map(drop));
    measure("power crust", |job| {
        PowerCrust::build(&points, PowerCrustOptions::default(), job).map(drop)
    });
    measure("its validate", |job| crust.validate(job).map(drop));
    measure("sizes", |job| crust.with_sizes(surface, job).map(drop));
    measure("scale axis", |job| crust.scale_axis(Label::Inner, 1.5, job).map(drop));
    measure("cocone", |job| Cocone::new(&dual, CoconeOptions::default(), job).map(drop));
    measure("its validate", |job| cocone.validate(job).map(drop));
    measure("labels of a cocone", |job| Labels::of_cocone(&cocone, job).map(drop));
    measure("labels of a crust", |job| Labels::of_crust(&dual, &crust, job).map(drop));
    measure("labels of a mesh", |job| Labels::of_mesh(&dual, surface, job).map(drop));
    let scales = MedialOptions { scales: true, ..Default::default() };
    measure("medial", |job| Medial::new(&dual, Some(&labels), scales.clone(), job).map(drop));
    measure("its validate", |job| medial.validate(job).map(drop));
    measure("axis", |job| medial.axis(&MedialFilter::default(), job).map(drop));
    let (rule, side, clip) = (MedialRule::Every, Side::Both, Some([[-2.0; 3], [2.0; 3]]));
    let all = MedialFilter { rule, side, clip, ..Default::default() };
    measure("all facets in a box", |job| medial.axis(&all, job).map(drop));
    measure("vertex normals", |job| surface.vertex_normals(job).map(drop));
    measure("topology", |job| surface.topology(job).map(drop));
    measure("orientation", |job| surface.oriented(job).map(drop));
    measure("its validate", |job| surface.validate(job).map(drop));
    let fewer = DecimateOptions { triangles: surface.triangles().len() / 4, max_error: None };
    measure("decimation", |job| surface.decimate(fewer, job).map(drop));
    measure("intersections", |job| surface.self_intersections(job).map(drop));
    measure("comparison", |job| compare(surface, surface, &Default::default(), job).map(drop));
    for name in ["surface.ply", "surface.off", "surface.vtu"] {
        let path = folder.path().join(name);
        let write =
            |job: &Job| io::write_complex(&path, surface, Default::default(), job).map(drop);
        measure(&format!("writing {name}"), write);
    }
    measure("reading surface.ply", |job| io::read_complex(&path, job).map(drop));
}

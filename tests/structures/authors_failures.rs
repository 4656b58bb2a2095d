//! What the authors' program is known to fail on (the git port of Amenta, Choi, Kolluri's code, measured): repeated points, models
//! far from the origin, very small and very large ones, sets without a volume, noise, half a sphere. Rows with a NaN are in
//! `tests/program/refusals.rs`.

use crate::sets::{Random, shuffled};
use medax::complex::{CompareOptions, Complex, Element, Topology, Values, compare};
use medax::crust::{HoleOptions, PowerCrustOptions};
use medax::points::PointsOptions;
use medax::poles::{Omit, PolesOptions};
use medax::sample::{SampleOptions, Shape, sample};
use medax::{Job, Points, PowerCrust, Status};
use std::sync::Arc;

type Row = [f64; 3];

fn sampled(shape: Shape, options: SampleOptions) -> Vec<Row> {
    sample(shape, options, &Job::default()).unwrap().points().to_vec()
}

/// Each coordinate rounded to a multiple of 2^-24, so that adding 1e6 to it rounds nothing.
fn torus() -> Vec<Row> {
    let rows = sampled(Shape::Torus, SampleOptions { seed: 5, ..Default::default() });
    let grid = 2f64.powi(24);
    rows.iter().map(|row| row.map(|x| (x * grid).round() / grid)).collect()
}

fn build(rows: &[Row], omit: Omit) -> Result<PowerCrust, medax::Error> {
    let job = Job::default();
    let points = Arc::new(Points::new(rows, PointsOptions::default(), &job)?);
    let poles = PolesOptions { omit, lambda: 0.0 };
    PowerCrust::build(&points, PowerCrustOptions { poles, ..Default::default() }, &job)
}

fn crust(rows: &[Row]) -> PowerCrust {
    build(rows, Omit::Nothing).unwrap()
}

fn topology(surface: &Complex) -> Topology {
    surface.topology(&Job::default()).unwrap()
}

/// One closed piece of this genus, turned outward, in a crust that passes its own checks.
fn assert_solid(crust: &PowerCrust, genus: u64, name: &str) {
    let found = topology(crust.surface());
    assert!(found.closed && found.oriented, "{name}: {found:?}");
    assert_eq!((found.components, found.genus), (1, Some(genus)), "{name}");
    let report = crust.validate(&Job::default()).unwrap();
    assert!(report.is_valid(), "{name}: {report:?}");
    assert!(crust.surface().measure(&Job::default()).unwrap().volume > 0.0, "{name}");
}

/// The surface by rows of the input: for each face the samples on its inner ball and those on its outer one, sorted. Neither
/// numbers nor places of vertices and poles play a part.
fn faces_by_rows(crust: &PowerCrust) -> Vec<[Vec<u32>; 2]> {
    let poles = crust.poles();
    let row_of_sample = poles.triangulation().row_of_vertex();
    let rows_on = |pole: &u32| {
        let samples = poles.samples_on_balls().row(*pole as usize).iter();
        let mut rows: Vec<u32> = samples.map(|&sample| row_of_sample[sample as usize]).collect();
        rows.sort_unstable();
        rows
    };
    let poles_of_faces =
        |name| match crust.surface().attribute(Element::Face, name).unwrap().values() {
            Values::U32(poles) => poles,
            Values::F64(_) => panic!("{name} has floats"),
        };
    let pairs = poles_of_faces("inner_pole").iter().zip(poles_of_faces("outer_pole"));
    let mut faces: Vec<_> = pairs.map(|(a, b)| [rows_on(a), rows_on(b)]).collect();
    faces.sort_unstable();
    faces
}

/// The same surface but for where it is and how large: the same faces, and their vertices where they belong but for `error`.
fn assert_same_surface(old: &PowerCrust, new: &PowerCrust, back: impl Fn(Row) -> Row, error: f64) {
    assert!(faces_by_rows(old) == faces_by_rows(new));
    assert_eq!(topology(old.surface()), topology(new.surface()));
    // A face keeps its corners only by rows: numbers of vertices follow those of the poles, and these where they lie.
    let surface = new.surface();
    let vertices = surface.vertices().iter().map(|&p| back(p)).collect();
    let parts = medax::complex::ComplexParts {
        vertices,
        faces: surface.faces().clone(),
        ..Default::default()
    };
    let returned = Complex::new(parts).unwrap();
    let options = CompareOptions { samples: 20_000, seed: 0 };
    let found = compare(old.surface(), &returned, &options, &Job::default()).unwrap();
    for way in [found.a_to_b, found.b_to_a] {
        assert!(way.max < error, "{found:?}");
    }
}

#[test]
fn repeated_points_change_nothing() {
    let rows = sampled(Shape::Sphere, SampleOptions { spacing: 0.0638, ..Default::default() });
    assert!((1900..2100).contains(&rows.len()), "{} rows", rows.len());
    let order = shuffled(rows.len(), 1);
    let mut repeated = rows.clone();
    repeated.extend(order[..500].iter().map(|&row| rows[row]));
    // Some of them three times and more, and none where it was.
    repeated.extend_from_within(rows.len()..rows.len() + 40);
    let order = shuffled(repeated.len(), 2);
    let repeated: Vec<_> = order.iter().map(|&row| repeated[row]).collect();
    let (plain, repeated) = (crust(&rows), crust(&repeated));
    assert_eq!(repeated.poles().triangulation().points().duplicate_count(), 540);
    assert_solid(&plain, 0, "sphere");
    assert!(plain.poles().balls() == repeated.poles().balls());
    assert!(plain.labels() == repeated.labels());
    assert!(plain.surface() == repeated.surface());
    assert!(plain.inner_shape() == repeated.inner_shape());
    assert!(plain.outer_shape() == repeated.outer_shape());
}

#[test]
fn a_model_moved_to_a_million_keeps_every_face() {
    let rows = torus();
    let plain = crust(&rows);
    assert_solid(&plain, 1, "torus");
    for by in [[1e6; 3], [-1e6, 3e5, 77.0]] {
        let add = |sign: f64| move |p: Row| [0, 1, 2].map(|k| p[k] + sign * by[k]);
        let moved: Vec<_> = rows.iter().map(|&row| add(1.0)(row)).collect();
        assert!(moved.iter().zip(&rows).all(|(p, row)| add(-1.0)(*p) == *row), "rounded");
        let moved = crust(&moved);
        assert_solid(&moved, 1, "moved");
        // Coordinates near a million are 1.2e-10 apart.
        assert_same_surface(&plain, &moved, add(-1.0), 1e-8);
    }
    // Without the grid the samples themselves move by that much.
    let rows = sampled(Shape::Torus, SampleOptions { seed: 6, ..Default::default() });
    let moved: Vec<_> = rows.iter().map(|row| row.map(|x| x + 1e6)).collect();
    assert_solid(&crust(&moved), 1, "moved and rounded");
}

#[test]
fn a_model_scaled_by_a_billion_and_back_keeps_every_face() {
    let rows = torus();
    let plain = crust(&rows);
    for scale in [1e-9, 1e9, 2f64.powi(-30), 2f64.powi(30)] {
        let scaled = crust(&rows.iter().map(|row| row.map(|x| x * scale)).collect::<Vec<_>>());
        assert_solid(&scaled, 1, "scaled");
        assert_same_surface(&plain, &scaled, |p| p.map(|x| x / scale), 1e-12);
        if scale.log2().fract() == 0.0 {
            assert!(plain.surface().faces() == scaled.surface().faces());
            assert!(plain.inner_shape().faces() == scaled.inner_shape().faces());
            assert!(plain.outer_shape().faces() == scaled.outer_shape().faces());
            let vertices = plain.surface().vertices().iter().map(|p| p.map(|x| x * scale));
            assert!(vertices.eq(scaled.surface().vertices().iter().copied()));
        }
    }
}

#[test]
fn sets_without_a_volume_are_refused_by_name() {
    let refused = |rows: &[Row]| {
        let error = build(rows, Omit::Nothing).unwrap_err();
        assert!(!error.message().is_empty());
        error.status()
    };
    let grid = |at: &dyn Fn(f64, f64) -> Row| -> Vec<Row> {
        (0..400).map(|i| at(f64::from(i % 20), f64::from(i / 20))).collect()
    };
    // Axis-parallel, oblique, and far away.
    assert_eq!(refused(&grid(&|x, y| [x, y, 0.0])), Status::Degenerate);
    assert_eq!(refused(&grid(&|x, y| [x, y, 3.0 * x - 5.0 * y])), Status::Degenerate);
    assert_eq!(refused(&grid(&|x, y| [x + 1e6, y - 1e6, x + y])), Status::Degenerate);
    let line = |by: Row| (0..50).map(|i| by.map(|x| x * f64::from(i))).collect::<Vec<Row>>();
    assert_eq!(refused(&line([1.0, 0.0, 0.0])), Status::Degenerate);
    assert_eq!(refused(&line([1.0, -2.0, 7.0])), Status::Degenerate);
    assert_eq!(refused(&line([1.0, -2.0, 7.0])[..3]), Status::TooFewPoints);
    assert_eq!(refused(&[[1.0; 3]; 2000]), Status::TooFewPoints);
    // A plane that rounding has left has a volume. What comes out is thin, but it is sound and closed, or empty.
    let third = grid(&|x, y| [0.1 * x, 0.3 * y, 0.1 * x + 0.7 * y]);
    let crust = crust(&third);
    assert!(crust.validate(&Job::default()).unwrap().is_valid());
    assert!(crust.surface().faces().is_empty() || topology(crust.surface()).closed);
}

#[test]
fn one_per_cent_of_noise_leaves_a_sphere_a_sphere() {
    for seed in 0..3 {
        let options = SampleOptions { spacing: 0.0638, noise: 0.01, seed, ..Default::default() };
        let even = sampled(Shape::Sphere, options);
        assert!((1900..2100).contains(&even.len()), "{} rows", even.len());
        let mut random = Random(seed);
        let uneven: Vec<_> = (0..2000)
            .map(|_| (random.sphere(), 1.0 + 0.01 * (2.0 * random.unit() - 1.0)))
            .map(|(row, radius)| row.map(|x| radius * x))
            .collect();
        for (name, rows) in [("even", even), ("uneven", uneven)] {
            for omit in [Omit::Nothing, Omit::Side] {
                let crust = build(&rows, omit).unwrap();
                assert_solid(&crust, 0, name);
                for p in crust.surface().vertices() {
                    let radius = p.iter().map(|x| x * x).sum::<f64>().sqrt();
                    assert!((radius - 1.0).abs() < 0.06, "{name}, {seed}, {omit:?}: {radius}");
                }
            }
        }
    }
}

#[test]
fn half_a_sphere_is_capped_and_can_be_opened() {
    let rows = sampled(Shape::Sphere, SampleOptions { spacing: 0.0638, ..Default::default() });
    let rows: Vec<_> = rows.into_iter().filter(|row| row[2] >= 0.0).collect();
    let crust = crust(&rows);
    assert_solid(&crust, 0, "half a sphere");
    // Half a ball: the area of the dome is 2 pi, that of the cap pi, the volume 2 pi / 3.
    let measure = crust.surface().measure(&Job::default()).unwrap();
    assert!((measure.area / (3.0 * std::f64::consts::PI) - 1.0).abs() < 0.02, "{measure:?}");
    assert!((measure.volume / (std::f64::consts::TAU / 3.0) - 1.0).abs() < 0.02, "{measure:?}");
    let open = crust.open(HoleOptions::default(), &Job::default()).unwrap();
    let left = topology(&open.surface);
    assert_eq!((left.components, left.genus, left.boundary_loops), (1, Some(0), 1));
    // The cap goes but for its rim, where the balls are those of samples side by side.
    let cap = open.left_out.measure(&Job::default()).unwrap().area;
    assert!((0.85..1.0).contains(&(cap / std::f64::consts::PI)), "{cap}");
}

//! Cocones and tight cocones of shapes whose surface is known, and of sets that have none.

use crate::sets::{self, Random, Set, shuffled};
use medax::cocone::{Cocone, CoconeOptions};
use medax::complex::{Element, Topology, Values};
use medax::dual::{Dual, DualOptions};
use medax::sample::{SampleOptions, Shape, sample};
use medax::{Complex, Job, JobOptions, Points, Result, Status, Triangulation};
use std::f64::consts::TAU;
use std::sync::Arc;

fn dual(points: Points) -> Arc<Dual> {
    let job = Job::default();
    let t = Arc::new(Triangulation::delaunay(&Arc::new(points), &job).unwrap());
    Arc::new(Dual::new(&t, DualOptions::default(), &job).unwrap())
}

fn points(rows: &[[f64; 3]]) -> Points {
    Points::new(rows, Default::default(), &Job::default()).unwrap()
}

fn try_cocone(rows: &[[f64; 3]]) -> Result<Cocone> {
    Cocone::new(&dual(points(rows)), CoconeOptions::default(), &Job::default())
}

fn cocone(rows: &[[f64; 3]]) -> Cocone {
    try_cocone(rows).unwrap()
}

fn topology(surface: &Complex) -> Topology {
    surface.topology(&Job::default()).unwrap()
}

fn assert_valid(cocone: &Cocone, name: &str) {
    let report = cocone.validate(&Job::default()).unwrap();
    assert!(report.is_valid(), "{name}: {report:?}");
    let tight = topology(cocone.surface());
    assert!(tight.closed && tight.oriented, "{name}: {tight:?}");
    assert_eq!(tight.isolated_vertices, 0, "{name}");
    let open = topology(cocone.open_surface());
    assert_eq!(open.nonmanifold_edges, 0, "{name}");
    assert!(open.oriented || open.faces == 0, "{name}: {open:?}");
    assert_eq!(cocone.used(), cocone.surface().vertices().len(), "{name}");
}

/// Six times the volume that a closed surface holds.
fn volume(surface: &Complex) -> f64 {
    let at = |v: u32| surface.vertices()[v as usize];
    let det = |[a, b, c]: [[f64; 3]; 3]| {
        a[0] * (b[1] * c[2] - b[2] * c[1])
            + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0])
    };
    surface.triangles().iter().map(|triangle| det(triangle.map(at))).sum()
}

fn of_shape(shape: Shape) -> Vec<[f64; 3]> {
    sample(shape, SampleOptions::default(), &Job::default()).unwrap().points().to_vec()
}

#[test]
fn smooth_shapes_come_out_with_their_genus_by_both() {
    for shape in Shape::ALL.into_iter().filter(|shape| shape.is_smooth()) {
        let rows = of_shape(shape);
        let cocone = cocone(&rows);
        assert_valid(&cocone, shape.name());
        for surface in [cocone.surface(), cocone.open_surface()] {
            let found = topology(surface);
            let form = (found.components, found.boundary_loops, found.genus);
            assert_eq!(form, (1, 0, Some(u64::from(shape.genus()))), "{}", shape.name());
            assert!(volume(surface) > 0.0, "{} is inside out", shape.name());
        }
        assert_eq!(cocone.used(), rows.len(), "{}", shape.name());
        assert!(!cocone.is_undersampled().contains(&true), "{}", shape.name());
        assert!(!cocone.is_well_sampled().contains(&false), "{}", shape.name());
        assert_eq!(cocone.marked(), cocone.is_inner().len(), "{}", shape.name());
        // Inside is inside: cells whose centre is deep within, or far out, say so.
        for (center, &is_inner) in cocone.dual().centers().iter().zip(cocone.is_inner()) {
            let value = shape.value(*center);
            assert!(value.abs() < 0.1 || (value < 0.0) == is_inner, "{}", shape.name());
        }
    }
}

#[test]
fn two_spheres_one_within_the_other_keep_the_void() {
    let mut random = Random(5);
    let mut rows: Vec<_> = (0..3000).map(|_| random.sphere()).collect();
    rows.extend((0..1500).map(|_| random.sphere().map(|x| 0.5 * x)));
    // And a ball within the void.
    rows.extend((0..400).map(|_| random.sphere().map(|x| 0.2 * x)));
    let cocone = cocone(&rows);
    assert_valid(&cocone, "shell");
    let found = topology(cocone.surface());
    assert_eq!((found.components, found.genus), (3, Some(0)));
    for (cell, &is_inner) in cocone.triangulation().cells().iter().zip(cocone.is_inner()) {
        let at = |k: usize| {
            cell.iter().map(|&v| cocone.triangulation().coords()[v as usize][k]).sum::<f64>() / 4.0
        };
        let r = (at(0).powi(2) + at(1).powi(2) + at(2).powi(2)).sqrt();
        let expected = r < 0.19 || (0.51..0.95).contains(&r);
        let is_told = r < 0.15 || (0.25..0.4).contains(&r) || (0.55..0.9).contains(&r);
        assert!(!is_told || is_inner == expected, "a cell at {r}");
    }
}

#[test]
fn every_kind_of_set_gives_a_closed_surface_or_says_why_not() {
    for n in [12, 300, 2000] {
        for Set { name, rows } in sets::all(n) {
            let t = Triangulation::delaunay(&Arc::new(points(&rows)), &Job::default());
            if t.is_err() {
                continue;
            }
            match try_cocone(&rows) {
                Ok(cocone) => assert_valid(&cocone, &format!("{name}, {n}")),
                Err(error) => {
                    assert_eq!(error.status(), Status::Degenerate, "{name}, {n}: {error}");
                    assert!(error.message().contains("inside"), "{error}");
                    assert_eq!(name, "two lines", "{n}");
                }
            }
        }
    }
}

#[test]
fn noise_is_closed_too() {
    for noise in [0.3, 1.0, 3.0] {
        for shape in [Shape::Torus, Shape::Genus3, Shape::Bracket] {
            let options = SampleOptions { noise: noise * shape.spacing(), ..Default::default() };
            let rows = sample(shape, options, &Job::default()).unwrap();
            if let Ok(cocone) = try_cocone(rows.points()) {
                assert_valid(&cocone, shape.name());
            }
        }
    }
}

/// A spiral of points on the sphere, down to a height.
fn cap(n: usize, lowest: f64) -> Vec<[f64; 3]> {
    (0..n)
        .map(|i| {
            let z = 1.0 - (1.0 - lowest) * (i as f64 + 0.5) / n as f64;
            let (r, turn) = ((1.0 - z * z).sqrt(), 0.618_033_988_749_895 * i as f64 * TAU);
            [r * turn.cos(), r * turn.sin(), z]
        })
        .collect()
}

#[test]
fn a_hemisphere_is_open_in_one_loop_and_closed_when_tight() {
    for lowest in [0.0, 0.4, -0.4] {
        let cocone = cocone(&cap(2000, lowest));
        assert_valid(&cocone, "cap");
        let open = topology(cocone.open_surface());
        let form = (open.components, open.boundary_loops, open.genus);
        assert_eq!(form, (1, 1, Some(0)), "down to {lowest}");
        let tight = topology(cocone.surface());
        assert_eq!((tight.components, tight.genus), (1, Some(0)));
        // What is undersampled lies at the rim.
        for (p, &is_under) in cocone.triangulation().coords().iter().zip(cocone.is_undersampled()) {
            assert!(!is_under || p[2] < lowest + 0.15, "{p:?}");
        }
        assert!(cocone.is_undersampled().contains(&true));
    }
}

#[test]
fn the_edges_of_a_box_are_undersampled_and_nothing_else_is() {
    let rows = of_shape(Shape::Box);
    let cocone = cocone(&rows);
    assert_valid(&cocone, "box");
    let found = topology(cocone.surface());
    assert_eq!((found.components, found.genus), (1, Some(0)));
    let half = [1.0, 0.75, 0.5];
    let mut count = 0;
    for (p, &is_under) in cocone.triangulation().coords().iter().zip(cocone.is_undersampled()) {
        let mut off: Vec<f64> = (0..3).map(|k| half[k] - p[k].abs()).collect();
        off.sort_by(f64::total_cmp);
        let to_edge = off[0].hypot(off[1]);
        assert!(!is_under || to_edge < 2.0 * Shape::Box.spacing(), "{p:?}");
        count += usize::from(is_under);
    }
    assert!(count > 50, "{count}");
}

/// All that a cocone tells, but for maps to rows.
type Bytes = (Complex, Complex, Vec<bool>, Vec<bool>, Vec<bool>, usize);

fn bytes(cocone: &Cocone) -> Bytes {
    (
        (**cocone.surface()).clone(),
        (**cocone.open_surface()).clone(),
        cocone.is_inner().to_vec(),
        cocone.is_undersampled().to_vec(),
        cocone.is_well_sampled().to_vec(),
        cocone.marked(),
    )
}

#[test]
fn threads_and_the_order_of_rows_change_nothing() {
    let mut random = Random(8);
    let box_rows = of_shape(Shape::Bracket);
    let noisy: Vec<_> = (0..20_000).map(|_| random.sphere().map(|x| x * 1.001)).collect();
    for rows in [box_rows, noisy] {
        let expected = bytes(&cocone(&rows));
        let mixed: Vec<_> = shuffled(rows.len(), 4).into_iter().map(|i| rows[i]).collect();
        for threads in [1, 3, 8] {
            let job = Job::new(JobOptions { threads, ..JobOptions::default() });
            let found = Cocone::new(&dual(points(&mixed)), CoconeOptions::default(), &job).unwrap();
            assert!(bytes(&found) == expected, "{threads} threads");
        }
    }
}

#[test]
fn the_surface_names_its_samples_and_cells() {
    let cocone = cocone(&of_shape(Shape::Torus));
    for surface in [cocone.surface(), cocone.open_surface()] {
        let Values::U32(samples) = surface.attribute(Element::Vertex, "sample").unwrap().values()
        else {
            panic!("samples are indices")
        };
        assert!(samples.is_sorted());
        for (&sample, vertex) in samples.iter().zip(surface.vertices()) {
            assert_eq!(cocone.triangulation().coords()[sample as usize], *vertex);
        }
        let Values::U32(cells) = surface.attribute(Element::Face, "inner_cell").unwrap().values()
        else {
            panic!("cells are indices")
        };
        assert!(cells.iter().all(|&cell| cocone.is_inner()[cell as usize]));
    }
}

#[test]
fn what_cannot_be_is_an_error() {
    let rows = of_shape(Shape::Sphere);
    let job = Job::default();
    let set = Arc::new(points(&rows));
    let status = |dual: &Arc<Dual>, options| {
        Cocone::new(dual, options, &Job::default()).map(|_| ()).unwrap_err().status()
    };
    let sound = dual(points(&rows));
    let default = CoconeOptions::default();
    for options in [
        CoconeOptions { angle: 0.0, ..default },
        CoconeOptions { angle: 1.6, ..default },
        CoconeOptions { normal_angle: f64::NAN, ..default },
        CoconeOptions { ratio: -1.0, ..default },
        CoconeOptions { ratio: f64::INFINITY, ..default },
    ] {
        assert_eq!(status(&sound, options), Status::InvalidArgument, "{options:?}");
    }
    let weights = vec![0.1; rows.len()];
    let t = Arc::new(Triangulation::regular(&set, &weights, &job).unwrap());
    let power = Arc::new(Dual::new(&t, DualOptions::default(), &job).unwrap());
    assert_eq!(status(&power, default), Status::InvalidArgument);
    assert_eq!(status(&dual(set.with_far_box(&job).unwrap()), default), Status::Mismatch);
    // Between two lines there is no solid.
    let lines = sets::all(300).pop().unwrap();
    assert_eq!(lines.name, "two lines");
    assert_eq!(status(&dual(points(&lines.rows)), default), Status::Degenerate);
    let spent = Job::default();
    spent.cancel();
    assert_eq!(Cocone::new(&sound, default, &spent).unwrap_err().status(), Status::Cancelled);
    let narrow = Job::new(JobOptions { memory_ceiling: 20_000, ..JobOptions::default() });
    assert_eq!(Cocone::new(&sound, default, &narrow).unwrap_err().status(), Status::OutOfMemory);
}

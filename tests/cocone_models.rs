//! Cocones of the real models beside the project, where they are there.

use medax::cocone::{Cocone, CoconeOptions};
use medax::complex::Topology;
use medax::dual::{Dual, DualOptions};
use medax::io::read_points;
use medax::points::PointsOptions;
use medax::{Complex, Job, Points, Triangulation};
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::PathBuf;
use std::sync::Arc;

fn dual(points: Points) -> Arc<Dual> {
    let job = Job::default();
    let t = Arc::new(Triangulation::delaunay(&Arc::new(points), &job).unwrap());
    Arc::new(Dual::new(&t, DualOptions::default(), &job).unwrap())
}

fn topology(surface: &Complex) -> Topology {
    surface.topology(&Job::default()).unwrap()
}

/// Components and genus of the surfaces of `../shared/data`, where these are known and the sampling allows for them.
const MODELS: [(&str, Option<(u64, u64)>); 20] = [
    ("3holes.off", Some((1, 3))),
    ("rocker-arm.obj", Some((1, 1))),
    ("mannequin.off", Some((1, 0))),
    ("foot.off", Some((1, 0))),
    ("foot_hole.off", Some((1, 0))),
    ("kitten.xyz", Some((1, 1))),
    ("hotdogs.pts", Some((2, 0))),
    ("ant.off", Some((1, 0))),
    ("refined_elephant.off", Some((1, 3))),
    ("cavity_and_ring.off", Some((3, 1))),
    ("abc_plate_00000329.obj", Some((1, 3))),
    ("fandisk.off", Some((1, 0))),
    ("igea.ply", Some((1, 0))),
    ("knot.pts", Some((1, 1))),
    ("octopus.off", None),
    ("stanford-bunny.obj", Some((1, 0))),
    ("range_scan_rops.ply", None),
    ("street_lidar.xyz", None),
    ("kinect_office_nan.ply", None),
    ("dragon.ply", None),
];

/// The folder of the models; says so where there is none.
fn models() -> Option<PathBuf> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared/data");
    if !folder.is_dir() {
        let text = format!("skipped: cocones of models, since {} is not there\n", folder.display());
        std::io::stderr().write_all(text.as_bytes()).unwrap();
        return None;
    }
    Some(folder)
}

/// A part is turned and mirrored, exactly and by a rotation of which nothing is round, so that ties, rounding and the order of samples are others. Sharp
/// edges, where samples are not well sampled, once touched each other in some poses.
#[test]
fn the_pose_of_a_part_decides_nothing() {
    let Some(folder) = models() else { return };
    let turn = |p: [f64; 3], i: usize, j: usize, angle: f64| {
        let (sine, cosine) = angle.sin_cos();
        let mut q = p;
        (q[i], q[j]) = (cosine * p[i] - sine * p[j], sine * p[i] + cosine * p[j]);
        q
    };
    let poses: [fn([f64; 3]) -> [f64; 3]; 4] = [
        |[x, y, z]| [y, x, z],
        |[x, y, z]| [-x, y, z],
        |[x, y, z]| [z, -x, -y],
        |[x, y, z]| [-y, -z, x],
    ];
    for (name, known) in MODELS {
        if !["rocker-arm.obj", "fandisk.off", "abc_plate_00000329.obj"].contains(&name) {
            continue;
        }
        let points = read_points(folder.join(name), Default::default(), &Job::default()).unwrap();
        let rows: Vec<_> = points.coords().to_vec();
        let exact = poses.iter().map(|pose| rows.iter().map(|&p| pose(p)).collect::<Vec<_>>());
        let turned = (1..5).map(|k| {
            let angle = 0.7 * f64::from(k);
            let pose =
                |&p: &[f64; 3]| turn(turn(turn(p, 0, 1, angle), 1, 2, 2.0 * angle), 0, 2, angle);
            rows.iter().map(pose).collect()
        });
        for (pose, rows) in exact.chain(turned).enumerate() {
            let points = Points::new(&rows, PointsOptions::default(), &Job::default()).unwrap();
            let cocone = Cocone::new(&dual(points), Default::default(), &Job::default()).unwrap();
            let tight = topology(cocone.surface());
            let found = tight.genus.map(|genus| (tight.components, genus));
            assert_eq!(found, known, "{name}, pose {pose}: {tight:?}");
            assert_eq!(tight.nonmanifold_edges, 0, "{name}, pose {pose}");
            assert!(cocone.validate(&Job::default()).unwrap().is_valid(), "{name}, pose {pose}");
        }
    }
}

#[test]
fn real_models_and_scans() {
    let Some(folder) = models() else { return };
    let mut table = format!(
        "\n{:<24} {:>7} {:>7} {:>6} {:>6} | {:>5} {:>5} {:>5} | {:>5} {:>5} {:>5} {:>5}  {}\n",
        "model",
        "samples",
        "used %",
        "under",
        "good %",
        "parts",
        "genus",
        "loops",
        "parts",
        "genus",
        "edges",
        "verts",
        "betti"
    );
    let mut wrong = Vec::new();
    for (name, known) in MODELS {
        let options = PointsOptions { skip_non_finite: true };
        let points = read_points(folder.join(name), options, &Job::default()).unwrap();
        let options = CoconeOptions::default();
        let cocone = Cocone::new(&dual(points), options, &Job::default()).unwrap();
        let (open, tight) = (topology(cocone.open_surface()), topology(cocone.surface()));
        let percent = |n: usize| 100.0 * n as f64 / cocone.is_undersampled().len() as f64;
        let count = |flags: &[bool]| flags.iter().filter(|&&flag| flag).count();
        let genus = |found: &Topology| found.genus.map_or("-".into(), |genus| genus.to_string());
        let _ = writeln!(
            table,
            "{name:<24} {:>7} {:>7.2} {:>6} {:>6.2} | {:>5} {:>5} {:>5} | {:>5} {:>5} {:>5} {:>5}  {:?}",
            cocone.is_undersampled().len(),
            percent(cocone.used()),
            count(cocone.is_undersampled()),
            percent(count(cocone.is_well_sampled())),
            open.components,
            genus(&open),
            open.boundary_loops,
            tight.components,
            genus(&tight),
            tight.nonmanifold_edges,
            tight.nonmanifold_vertices,
            tight.betti,
        );
        let report = cocone.validate(&Job::default()).unwrap();
        if !report.is_valid() || !tight.closed || !tight.oriented || open.nonmanifold_edges > 0 {
            wrong.push(format!("{name}: {report:?}, {tight:?}"));
        }
        if known
            .is_some_and(|(parts, genus)| (parts, Some(genus)) != (tight.components, tight.genus))
        {
            wrong.push(format!("{name}: {tight:?}, not {known:?}"));
        }
    }
    std::io::stderr().write_all(table.as_bytes()).unwrap();
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

//! Pair-meshes of the built-in shapes, and of the real models beside the project, where they are there.

use crate::shapes::dual_of;
use medax::cocone::Cocone;
use medax::io::read_points;
use medax::sample::{Shape, sample};
use medax::{Job, Labels, PairMesh, Points};
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::PathBuf;
use std::time::Instant;

/// The genus of the surfaces of `../shared/data`.
const MODELS: [(&str, u64); 7] = [
    ("3holes.off", 3),
    ("rocker-arm.obj", 1),
    ("mannequin.off", 0),
    ("foot.off", 0),
    ("kitten.xyz", 1),
    ("refined_elephant.off", 3),
    ("igea.ply", 0),
];

/// A line of the table, and what is wrong, if anything.
fn divide(name: &str, points: Points, genus: u64) -> (String, Option<String>) {
    let job = Job::default();
    let samples = points.len();
    let dual = dual_of(points);
    let cocone = Cocone::new(&dual, Default::default(), &job).unwrap();
    let labels = Labels::of_cocone(&cocone, &job).unwrap();
    let begun = Instant::now();
    let mesh = PairMesh::voronoi(&dual, &labels, &job).unwrap();
    let seconds = begun.elapsed().as_secs_f64();
    let report = mesh.validate(&job).unwrap();
    let surface = mesh.iso_surface(0.5, &job).unwrap().topology(&job).unwrap();
    let folded = mesh.folded(&job).unwrap().len();
    let places = mesh.inner_vertices().iter().zip(mesh.voronoi_vertices());
    let moved = places.filter(|(place, voronoi)| place != voronoi).count();
    let line = format!(
        "{name:<24} {samples:>8} {:>8} {:>9} {moved:>6} {:>8} {folded:>6} {:>8} {seconds:>6.1}",
        mesh.element_count(),
        mesh.inner_vertices().len(),
        mesh.removed().len(),
        report.problems,
    );
    let volumes = mesh.volumes(&job).unwrap();
    let (sum, enclosed) = (volumes.iter().sum::<f64>(), mesh.enclosed_volume());
    let is_right = report.is_valid()
        && folded == 0
        && (sum - enclosed).abs() <= 1e-9 * enclosed
        && surface.closed
        && surface.oriented
        && (surface.components, surface.genus) == (1, Some(genus));
    (line, (!is_right).then(|| format!("{name}: {report:?}, {folded} folded, {surface:?}")))
}

/// Writes past the test runner, which would keep it.
fn show(text: &str) {
    std::io::stderr().write_all(text.as_bytes()).unwrap();
}

#[test]
fn shapes_and_models_are_divided() {
    let job = Job::default();
    let mut table = format!(
        "\n{:<24} {:>8} {:>8} {:>9} {:>6} {:>8} {:>6} {:>8} {:>6}\n",
        "sample", "samples", "elements", "inner", "moved", "removed", "folded", "problems", "s",
    );
    let mut wrong = Vec::new();
    let mut add = |name: &str, points, genus| {
        let (line, failure) = divide(name, points, genus);
        let _ = writeln!(table, "{line}");
        wrong.extend(failure);
    };
    for shape in Shape::ALL {
        let samples = sample(shape, Default::default(), &job).unwrap();
        let points = Points::new(samples.points(), Default::default(), &job).unwrap();
        add(shape.name(), points, shape.genus().into());
    }
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared/data");
    if folder.is_dir() {
        for (name, genus) in MODELS {
            let points = read_points(folder.join(name), Default::default(), &job).unwrap();
            add(name, points, genus);
        }
    } else {
        show(&format!("skipped: pair-meshes of models, since {} is not there\n", folder.display()));
    }
    show(&table);
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

/// The foot is cut off flat, with a cap of large triangles: much of what is folded there no one vertex can mend.
#[test]
fn a_foot_is_mended_in_few_places() {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared/data/foot.off");
    if !path.is_file() {
        show(&format!("skipped: the foot, since {} is not there\n", path.display()));
        return;
    }
    let job = Job::default();
    let dual = dual_of(read_points(path, Default::default(), &job).unwrap());
    let cocone = Cocone::new(&dual, Default::default(), &job).unwrap();
    let labels = Labels::of_cocone(&cocone, &job).unwrap();
    let mesh = PairMesh::voronoi(&dual, &labels, &job).unwrap();
    assert!(mesh.validate(&job).unwrap().is_valid());
    let places = mesh.inner_vertices().iter().zip(mesh.voronoi_vertices());
    let moved = places.filter(|(place, voronoi)| place != voronoi).count();
    assert!(moved < 1000, "{moved}");
}

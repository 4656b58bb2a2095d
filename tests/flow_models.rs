//! Cores of the real models beside the project, where they are there.

use medax::cocone::Cocone;
use medax::dual::{Dual, DualOptions};
use medax::flow::{CoreOptions, Flow};
use medax::io::read_points;
use medax::{Job, Labels, Triangulation};
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::PathBuf;
use std::sync::Arc;

/// Betti numbers of the solids of `../shared/data`, and whether the core alone must have them: the repaired one always must.
const MODELS: [(&str, [u64; 3], bool); 12] = [
    ("3holes.off", [1, 3, 0], true),
    ("rocker-arm.obj", [1, 1, 0], true),
    ("refined_elephant.off", [1, 3, 0], true),
    ("cavity_and_ring.off", [2, 1, 1], false),
    ("kitten.xyz", [1, 1, 0], true),
    ("hotdogs.pts", [2, 0, 0], true),
    ("mannequin.off", [1, 0, 0], false),
    ("foot.off", [1, 0, 0], true),
    ("igea.ply", [1, 0, 0], false),
    ("ant.off", [1, 0, 0], true),
    ("fandisk.off", [1, 0, 0], false),
    ("abc_plate_00000329.obj", [1, 3, 0], false),
];

#[test]
fn cores_of_real_models_have_the_homotopy_type_of_the_solid() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared/data");
    if !folder.is_dir() {
        let text = format!("skipped: cores of models, since {} is not there\n", folder.display());
        std::io::stderr().write_all(text.as_bytes()).unwrap();
        return;
    }
    let job = Job::default();
    let (mut table, mut wrong) = (String::from("\n"), Vec::new());
    for (name, betti, alone) in MODELS {
        let points = read_points(folder.join(name), Default::default(), &job).unwrap();
        let t = Arc::new(Triangulation::delaunay(&Arc::new(points), &job).unwrap());
        let dual = Arc::new(Dual::new(&t, DualOptions { facets: true }, &job).unwrap());
        let cocone = Cocone::new(&dual, Default::default(), &job).unwrap();
        let labels = Arc::new(Labels::of_cocone(&cocone, &job).unwrap());
        let flow = Flow::new(&dual, &labels, Default::default(), &job).unwrap();
        let [core, repaired] = [false, true].map(|repair| {
            let options = CoreOptions { repair, ..Default::default() };
            let core = flow.core(options, &[], &job).unwrap();
            let core = core.complex();
            (core.topology(&job).unwrap().betti, core.faces().len(), core.edges().len())
        });
        let _ = writeln!(table, "{name:<24} {betti:?}: core {core:?}, repaired {repaired:?}");
        if repaired.0 != betti || (alone && core.0 != betti) {
            wrong.push(name);
        }
    }
    std::io::stderr().write_all(table.as_bytes()).unwrap();
    assert!(wrong.is_empty(), "{wrong:?}");
}

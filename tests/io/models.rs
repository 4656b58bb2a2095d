//! Real files, with the counts that `MANIFEST.md` beside them gives.

use medax::io::{WriteOptions, read, read_complex, read_points, write_complex};
use medax::points::PointsOptions;
use medax::{ElementKind, Job, NONE, Status};
use std::path::PathBuf;

/// The folder of the models, or nothing, said plainly.
fn data() -> Option<PathBuf> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared/data");
    if folder.is_dir() {
        return Some(folder);
    }
    println!("skipped: {} is not there", folder.display());
    None
}

/// File, rows, distinct used vertices, faces, least and greatest corner as the manifest prints them.
type Model = (&'static str, usize, usize, usize, [f64; 3], [f64; 3]);

const MODELS: [Model; 20] = [
    ("3holes.off", 3596, 3596, 7200, [0.0, 0.266723, 0.478161], [1.0, 0.73302, 0.820001]),
    ("fandisk.off", 7229, 7229, 14454, [0.0, 12.6055, -2.68026], [4.8279, 17.85, 0.0]),
    (
        "rocker-arm.obj",
        10044,
        10044,
        20088,
        [-0.151733, -0.257456, -0.5],
        [0.151733, 0.257456, 0.5],
    ),
    ("mannequin.off", 11703, 11703, 23402, [-0.928476, -1.24318, -1.5], [0.928476, 1.24318, 1.5]),
    (
        "foot.off",
        10010,
        10010,
        20016,
        [-0.433628, -1.50022, -1.27031],
        [0.465838, 1.16443, -0.160049],
    ),
    (
        "foot_hole.off",
        10010,
        10010,
        19974,
        [-0.433628, -1.50022, -1.27031],
        [0.465838, 1.16443, -0.160049],
    ),
    ("ant.off", 5002, 5002, 10000, [0.0, 0.0, 0.0], [0.644431, 1.0, 0.459519]),
    ("abc_plate_00000329.obj", 4738, 4738, 9484, [0.0, 0.0, 0.0], [76.2, 15.875, 1.5875]),
    ("octopus.off", 16944, 16944, 33872, [-0.427806, -0.31208, -0.5], [0.427806, 0.31208, 0.5]),
    (
        "refined_elephant.off",
        44460,
        44460,
        88928,
        [-0.358822, -0.499404, -0.300133],
        [0.358436, 0.497472, 0.299583],
    ),
    // 1,113 vertices that no face uses.
    (
        "stanford-bunny.obj",
        35947,
        34834,
        69451,
        [-0.09469, 0.032987, -0.061874],
        [0.061009, 0.187321, 0.0588],
    ),
    (
        "igea.ply",
        134345,
        134345,
        268686,
        [-0.034556, -0.049669, -0.049538],
        [0.034556, 0.049669, 0.049538],
    ),
    (
        "dragon.ply",
        437645,
        435545,
        871414,
        [-0.108324, 0.0527295, -0.0504143],
        [0.0965662, 0.197173, 0.0412075],
    ),
    (
        "cavity_and_ring.off",
        33450,
        33450,
        66892,
        [-0.928476, -1.24318, -1.5],
        [2.80347, 1.24318, 1.5],
    ),
    ("knot.pts", 1281, 1281, 0, [-9.33656, -8.89382, -6.73709], [9.31557, 8.93709, 6.78115]),
    ("hotdogs.pts", 1748, 1748, 0, [-4.78036, -3.38529, -1.55841], [7.13779, 6.94662, 2.13322]),
    ("kitten.xyz", 5210, 5210, 0, [-0.325311, -0.499731, -0.29561], [0.325692, 0.4989, 0.294955]),
    (
        "street_lidar.xyz",
        24989,
        24989,
        0,
        [-59.5661, -59.5966, -10.719],
        [67.1525, 71.0901, 29.2967],
    ),
    (
        "range_scan_rops.ply",
        32087,
        32087,
        0,
        [-0.41984, -0.24034, -1.4022],
        [0.40617, 0.24871, -1.0098],
    ),
    (
        "kinect_office_nan.ply",
        307200,
        254456,
        0,
        [-2.64548, -2.19643, 1.833],
        [1.50436, 1.58125, 5.364],
    ),
];

#[test]
fn every_model_has_the_counts_of_the_manifest() {
    let Some(folder) = data() else { return };
    let job = Job::default();
    for (name, rows, distinct, faces, min, max) in MODELS {
        let soup = read(folder.join(name), &job).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!((soup.vertices().len(), soup.faces().len()), (rows, faces), "{name}");
        assert!(soup.edges().is_empty() && soup.warnings().is_empty(), "{name}");
        let points = soup.points(PointsOptions { skip_non_finite: true }, &job).unwrap();
        assert_eq!((points.row_count(), points.len()), (rows, distinct), "{name}");
        // The manifest prints six digits, and zero for what is below 1e-9.
        for (found, printed) in [(points.bounds().min, min), (points.bounds().max, max)] {
            for (found, printed) in found.iter().zip(printed) {
                let digits = (found - printed).abs() <= 6e-6 * printed.abs() + 1e-9;
                assert!(digits, "{name}: {found} is not {printed}");
            }
        }
    }
}

#[test]
fn unused_vertices_are_rows_without_a_vertex() {
    let Some(folder) = data() else { return };
    let (path, job) = (folder.join("stanford-bunny.obj"), Job::default());
    let points = read_points(&path, PointsOptions::default(), &job).unwrap();
    assert_eq!(points.vertex_of_row().iter().filter(|&&v| v == NONE).count(), 1113);
    let complex = read_complex(&path, &job).unwrap();
    let mut used = vec![false; complex.vertices().len()];
    complex.triangles().as_flattened().iter().for_each(|&v| used[v as usize] = true);
    for (row, (used, vertex)) in used.iter().zip(points.vertex_of_row()).enumerate() {
        assert_eq!(*used, *vertex != NONE, "row {row}");
        if *used {
            assert_eq!(points.coords()[*vertex as usize], complex.vertices()[row]);
        }
    }
}

#[test]
fn a_depth_image_with_nan_rows_is_an_error_unless_they_are_skipped() {
    let Some(folder) = data() else { return };
    let (path, job) = (folder.join("kinect_office_nan.ply"), Job::default());
    let first = read(&path, &job).unwrap().vertices().iter().position(|v| v[0].is_nan()).unwrap();
    let error = read_points(&path, PointsOptions::default(), &job).unwrap_err();
    assert_eq!(error.status(), Status::NonFinite);
    assert_eq!(error.element(), Some((ElementKind::Row, first as u64)));
    let points = read_points(&path, PointsOptions { skip_non_finite: true }, &job).unwrap();
    assert_eq!(points.skipped_count(), 52_744);
}

#[test]
fn stl_merges_the_positions_that_the_manifest_counts_as_one() {
    let Some(folder) = data() else { return };
    let job = Job::default();
    let dragon = read_complex(folder.join("dragon.ply"), &job).unwrap();
    let copy = tempfile::tempdir().unwrap();
    let path = copy.path().join("dragon.stl");
    let warnings = write_complex(&path, &dragon, WriteOptions::default(), &job).unwrap();
    assert_eq!(warnings, Vec::<String>::new());
    let soup = read(&path, &job).unwrap();
    // 2,100 vertices repeat another's position, and 108 triangles collapse.
    assert_eq!((soup.vertices().len(), soup.faces().len()), (435_545, 871_414 - 108));
    assert_eq!(soup.warnings(), ["108 facets with equal corners were left out"]);
}

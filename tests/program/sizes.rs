//! Local feature size and thickness, as the program says and writes them.

use crate::Place;
use medax::complex::{Element, Values};
use medax::points::PointsOptions;
use medax::sample::Shape;
use medax::{Complex, Job, PowerCrust, io};
use serde_json::Value;
use std::sync::Arc;

fn crust_of(place: &Place, name: &str) -> PowerCrust {
    let job = Job::default();
    let points = io::read_points(place.path(name), PointsOptions::default(), &job).unwrap();
    PowerCrust::build(&Arc::new(points), Default::default(), &job).unwrap()
}

fn read(place: &Place, name: &str) -> Complex {
    io::read_complex(place.path(name), &Job::default()).unwrap()
}

fn lengths(complex: &Complex, name: &str) -> Vec<f64> {
    match complex.attribute(Element::Vertex, name).unwrap().values() {
        Values::F64(values) => values.clone(),
        Values::U32(_) => panic!("lengths are floats"),
    }
}

/// Whether a file has the sizes that the library finds at its vertices.
fn assert_sized(crust: &PowerCrust, complex: &Complex) {
    let expected = crust.sizes_at(complex.vertices(), &Job::default()).unwrap();
    assert_eq!(lengths(complex, "feature_size"), expected.feature_size);
    assert_eq!(lengths(complex, "thickness"), expected.thickness);
}

#[test]
fn sizes_are_written_where_they_are_asked_for() {
    let place = Place::new();
    place.shape(Shape::Torus, "in.ply");
    place.write("at.xyz", "1 0 0\n0 0 0\n3 0 0.25\n1 0 0\n");
    let more = "--sizes --samples samples.ply --sizes-at at.xyz sized.ply --validate";
    let report = place.json(&format!("crust in.ply -o surface.ply {more}"));
    let crust = crust_of(&place, "in.ply");
    let surface = read(&place, "surface.ply");
    assert_eq!(surface.faces(), crust.surface().faces());
    let samples = read(&place, "samples.ply");
    assert_eq!(samples, crust.samples_to_complex(&Job::default()).unwrap());
    let sized = read(&place, "sized.ply");
    // Rows stay as they are, equal ones too.
    assert_eq!(sized.vertices(), [[1.0, 0.0, 0.0], [0.0; 3], [3.0, 0.0, 0.25], [1.0, 0.0, 0.0]]);
    for complex in [&surface, &samples, &sized] {
        assert_sized(&crust, complex);
    }
    let names: Vec<&Value> =
        report["outputs"].as_array().unwrap().iter().map(|output| &output["name"]).collect();
    assert_eq!(names, ["surface", "samples", "sizes"]);
    assert_eq!(report["parameters"]["sizes"], true);
    assert_eq!(report["parameters"]["sizes_at"], "at.xyz");
    for name in ["feature_size", "thickness"] {
        let mut values = lengths(&samples, name);
        values.sort_by(f64::total_cmp);
        let summary = &report["sizes"][name];
        assert_eq!(summary["min"], values[0], "{name}");
        assert_eq!(summary["median"], values[(values.len() - 1) / 2], "{name}");
        assert_eq!(summary["max"], values[values.len() - 1], "{name}");
    }
    // The tube has a radius of 0.4.
    assert!((report["sizes"]["thickness"]["median"].as_f64().unwrap() - 0.8).abs() < 0.01);
    let table = place.run("crust in.ply --sizes");
    let table = crate::text(&table.stdout);
    assert!(table.contains("thickness    min 0.") && table.contains("feature size min 0."));
}

#[test]
fn sizes_are_those_of_the_surface_that_is_written() {
    let place = Place::new();
    place.shape(Shape::Ellipsoid, "in.ply");
    place.json("crust in.ply -o cut.ply --sizes --triangles");
    place.json("crust in.ply -o open.ply --sizes --holes --hole-degrees 90");
    let crust = crust_of(&place, "in.ply");
    let cut = read(&place, "cut.ply");
    assert_eq!(cut.faces().len(), crust.surface().triangles().len());
    let open = read(&place, "open.ply");
    assert!(open.attribute(Element::Vertex, "sample").is_some());
    for complex in [&cut, &open] {
        assert_sized(&crust, complex);
    }
    let offset = place.json("crust in.ply -o offset.ply --sizes --offset -0.1");
    let inside = crust.offset(-0.1, &Job::default()).unwrap();
    assert_sized(&inside, &read(&place, "offset.ply"));
    let plain = place.json("crust in.ply --samples samples.ply -o plain.ply");
    let [before, after] =
        [&plain, &offset].map(|report| report["sizes"]["thickness"]["median"].as_f64().unwrap());
    assert!((before - after - 0.2).abs() < 1e-9, "{before} and {after}");
    // What is not asked for is not there.
    assert_eq!(plain["parameters"]["sizes"], false);
    assert!(read(&place, "plain.ply").attribute(Element::Vertex, "thickness").is_none());
    let none = place.json("crust in.ply");
    assert!(none.get("sizes").is_none() && none["parameters"]["sizes_at"].is_null());
}

#[test]
fn a_mesh_that_is_measured_stays_a_mesh_and_bad_points_are_told() {
    let place = Place::new();
    place.shape(Shape::Sphere, "in.ply");
    place.write("mesh.off", "OFF\n3 1 0\n0 0 1\n1 0 0\n0 1 0\n3 0 1 2\n");
    place.json("crust in.ply --sizes-at mesh.off sized.ply");
    let sized = read(&place, "sized.ply");
    assert_eq!(sized.faces().row(0), [0, 1, 2]);
    assert_sized(&crust_of(&place, "in.ply"), &sized);
    let at = "crust in.ply -o out.ply --sizes-at";
    place.write("bad.xyz", "0 0 0\n0 nan 0\n");
    let error = place.failure(&format!("{at} bad.xyz sized.ply"), 1);
    assert_eq!((&error["status"], &error["index"]), (&"NON_FINITE".into(), &1.into()));
    assert_eq!(error["path"], "bad.xyz");
    let error = place.failure(&format!("{at} absent.xyz sized.ply"), 1);
    assert_eq!((&error["status"], &error["path"]), (&"IO".into(), &"absent.xyz".into()));
    place.write("far.xyz", "0 0 0\n0 1e200 0\n");
    let error = place.failure(&format!("{at} far.xyz sized.ply"), 1);
    assert_eq!((&error["status"], &error["index"]), (&"COORDINATE_RANGE".into(), &1.into()));
    assert_eq!(error["path"], "far.xyz");
}

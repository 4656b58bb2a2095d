//! `medax union`: axes back to solids.

use crate::Place;
use crate::field::open_box;
use medax::complex::{Element, Values};
use medax::sample::Shape;
use serde_json::{Value, json};
use std::f64::consts::PI;

fn volume(place: &Place, name: &str) -> f64 {
    place.json(&format!("info {name}"))["measure"]["volume"].as_f64().unwrap()
}

#[test]
fn one_ball_is_a_sphere_and_two_are_a_lens_less() {
    let place = Place::new();
    place.write("one.ma", "1 0 0\nv 1 2 3 2\n");
    let report = place.json("union one.ma -o sphere.ply");
    assert_eq!((&report["command"], &report["input"]["points"]), (&json!("union"), &1.into()));
    let diagonal = 4.0 * 3f64.sqrt();
    let spacing = report["parameters"]["spacing"].as_f64().unwrap();
    assert!((spacing - 0.01 * diagonal).abs() < 1e-12, "{spacing}");
    let union = &report["union"];
    assert_eq!((&union["balls"], &union["least_radius"]), (&1.into(), &json!(2.0)));
    assert_eq!(union["largest_radius"], 2.0);
    assert!((union["diagonal"].as_f64().unwrap() - diagonal).abs() < 1e-12);
    let topology = &report["outputs"][0]["topology"];
    assert_eq!((&topology["genus"], &topology["closed"]), (&0.into(), &json!(true)));
    assert_eq!(
        (&topology["oriented"], &topology["euler_characteristic"]),
        (&json!(true), &2.into())
    );
    assert_eq!(report["counts"]["vertices"], place.complex("sphere.ply").vertices().len());
    for p in place.complex("sphere.ply").vertices() {
        let away = (p[0] - 1.0).hypot(p[1] - 2.0).hypot(p[2] - 3.0);
        assert!((away - 2.0).abs() < 1e-12, "{p:?}");
    }
    let exact = 4.0 / 3.0 * PI * 8.0;
    assert!((volume(&place, "sphere.ply") / exact - 1.0).abs() < 0.002);
    let coarse = place.json("union one.ma --spacing 0.5");
    assert!(coarse["counts"]["faces"].as_u64() < Some(2000), "{coarse}");
    assert!(coarse["counts"]["faces"].as_u64() < report["counts"]["faces"].as_u64());
    let table = place.run("union one.ma --spacing 0.5");
    assert!(crate::text(&table.stdout).contains("1 of radii from 2"), "{table:?}");

    place.write("two.ma", "2 1 0\nv 0 0 0 1\nv 1 0 0 1\ne 0 1\n");
    place.json("union two.ma -o two.ply");
    // Both caps of the lens are half a radius high.
    let exact = 2.0 * (4.0 / 3.0 * PI) - 2.0 * (PI * 0.25 * (3.0 - 0.5) / 3.0);
    assert!((volume(&place, "two.ply") / exact - 1.0).abs() < 0.002);
    match place.complex("two.ply").attribute(Element::Vertex, "ball").unwrap().values() {
        Values::U32(balls) => assert!(balls.contains(&0) && balls.iter().all(|&ball| ball < 2)),
        Values::F64(_) => panic!("balls are whole numbers"),
    }
}

/// Whatever medax writes of an axis comes back with its radii, and is a solid of nearly the same volume again.
#[test]
fn every_axis_that_is_written_can_be_read_back() {
    let place = Place::new();
    place.shape(Shape::Torus, "torus.ply");
    place.write("box.off", open_box(0, ""));
    place.json("crust torus.ply --shape shape.ply");
    place.json("crust torus.ply --shape shape.ma");
    place.json("medial torus.ply -o medial.ply");
    place.json("medial torus.ply -o medial.ma");
    place.json("flow torus.ply -o core.ply");
    let field = "field box.off --density 0.1 --min-distance 0.1";
    place.json(&format!("{field} -o field.ply"));
    place.json(&format!("{field} -o field.ma"));
    place.json(&format!("{field} --points -o points.ply"));
    let torus = (1, 2.0 * PI * PI * 0.4 * 0.4, 0.4);
    let cuboid = (0, 3.0, 0.5);
    let mut seen = Vec::new();
    for (name, (genus, exact, radius)) in [
        ("shape.ply", torus),
        ("shape.ma", torus),
        ("medial.ply", torus),
        ("medial.ma", torus),
        ("core.ply", torus),
        ("field.ply", cuboid),
        ("field.ma", cuboid),
        ("points.ply", cuboid),
    ] {
        let report = place.json(&format!("union {name} -o solid.ply --spacing 0.1"));
        let (axis, union) = (place.complex(name), &report["union"]);
        assert_eq!(union["balls"], axis.vertices().len(), "{name}");
        let largest = union["largest_radius"].as_f64().unwrap();
        assert!((largest - radius).abs() < 0.01, "{name}: {largest}");
        let topology = &report["outputs"][0]["topology"];
        assert_eq!((&topology["genus"], &topology["closed"]), (&genus.into(), &json!(true)));
        let volume = volume(&place, "solid.ply");
        assert!((volume / exact - 1.0).abs() < 0.1, "{name}: {volume} of {exact}");
        seen.push(union.clone());
    }
    // PLY and MA hold the same balls.
    for (ply, ma) in [(0, 1), (2, 3), (5, 6)] {
        assert_eq!(seen[ply], seen[ma]);
    }
    let written = [1, 3].map(|threads| {
        place.json(&format!("union field.ply -o solid.ply --spacing 0.1 --threads {threads}"));
        place.read("solid.ply")
    });
    assert!(written[0] == written[1]);
}

#[test]
fn what_has_no_radii_is_refused_with_what_to_do() {
    let place = Place::new();
    place.shape(Shape::Sphere, "sphere.ply");
    let square = json!([[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]]);
    let square = json!({ "type": "Polygon", "coordinates": square }).to_string();
    place.write("square.geojson", square);
    place.write("negative.ma", "2 0 0\nv 0 0 0 1\nv 1 0 0 -1\n");
    let says = |error: &Value, words: &str| {
        assert!(error["message"].as_str().unwrap().contains(words), "{error}");
    };
    let error = place.failure("union sphere.ply -o out.ply", 1);
    assert_eq!((&error["status"], &error["path"]), (&json!("MISMATCH"), &json!("sphere.ply")));
    says(&error, "give a medial axis");
    // In corners of a figure the radius is 0, unless the axis ends before.
    let graph = place.json("field square.geojson -o graph.ply");
    assert_eq!(graph["parameters"]["min_distance"], 0.0);
    for (name, index) in [("graph.ply", None), ("negative.ma", Some(1))] {
        let error = place.failure(&format!("union {name} -o out.ply"), 1);
        assert_eq!((&error["status"], &error["kind"]), (&json!("INVALID_ARGUMENT"), &json!("row")));
        assert!(index.is_none_or(|index| error["index"] == index), "{error}");
        says(&error, "--min-distance");
    }
    place.json("field square.geojson --min-distance 0.1 -o graph.ma");
    assert_eq!(place.json("union graph.ma")["outputs"][0]["topology"]["genus"], 0);
    assert_eq!(place.failure("union square.geojson", 1)["status"], "UNSUPPORTED");
    assert_eq!(place.failure("union absent.ma", 1)["status"], "IO");
    for arguments in [
        "union",
        "union negative.ma --spacing -1",
        "union negative.ma --spacing nan",
        "union negative.ma --spacing inf",
        "union negative.ma -o out.step",
    ] {
        assert_eq!(place.failure(arguments, 2)["status"], "INVALID_ARGUMENT", "{arguments}");
    }
    assert!(!place.names().contains(&"out.ply".to_string()));
}

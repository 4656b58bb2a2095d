//! `medax medial` and `medax cocone`: what they say and write.

use crate::Place;
use medax::complex::{Complex, Element, Values};
use medax::sample::Shape;
use medax::{Job, io};
use serde_json::json;

fn numbers(complex: &Complex, element: Element, name: &str) -> Vec<u32> {
    match complex.attribute(element, name).unwrap().values() {
        Values::U32(values) => values.clone(),
        Values::F64(_) => panic!("{name} has floats"),
    }
}

#[test]
fn the_axis_of_a_torus_is_a_ring_and_its_surface_is_closed() {
    let place = Place::new();
    place.shape(Shape::Torus, "torus.ply");
    let cocone = place.json("cocone torus.ply -o surface.ply --validate");
    let topology = &cocone["outputs"][0]["topology"];
    assert_eq!((&topology["genus"], &topology["closed"]), (&json!(1), &json!(true)));
    assert_eq!(
        (&cocone["cocone"]["used_share"], &cocone["cocone"]["undersampled"]),
        (&json!(1.0), &json!(0))
    );
    let open = place.json("cocone torus.ply --cocone-only");
    assert_eq!(open["outputs"][0]["topology"]["genus"], 1);

    let report = place.json("medial torus.ply -o axis.vtu --validate --compare-labels");
    assert_eq!(report["outputs"][0]["topology"]["betti"][0], 1);
    assert_eq!(report["medial"]["torn_umbrellas"], 0);
    assert_eq!(report["medial"]["selected"], report["counts"]["faces"]);
    let labels = &report["labels"];
    let cells = report["counts"]["cells"].as_u64().unwrap();
    assert_eq!(labels["inner"].as_u64().unwrap() + labels["outer"].as_u64().unwrap(), cells);
    assert!(labels["disagreement"]["crust"].as_u64().unwrap() < cells / 20);
    // Sides: the inner and the outer axis, and what crosses the surface, are all.
    let count = |options: &str| {
        let report = place.json(&format!("medial torus.ply {options}"));
        report["counts"]["faces"].as_u64().unwrap()
    };
    let inner = count("");
    assert_eq!(inner, report["counts"]["faces"]);
    assert!(count("--side outer") > 0 && inner + count("--side outer") <= count("--side both"));
    // Thresholds only take away.
    for options in [
        "--theta-degrees 60 --rho 1e9",
        "--rule ratio",
        "--rule angle",
        "--lambda 0.3",
        "--object-degrees 100",
        "--scale 2",
    ] {
        assert!(count(options) <= inner, "{options}");
    }
    assert!(count("--rule none") > inner);
    // Other labels tell nearly the same.
    for options in ["--labels crust", "--label-mesh surface.ply"] {
        let other = count(options);
        assert!(other.abs_diff(inner) < inner / 10, "{options}: {other} of {inner}");
    }
    // Normals need faces.
    let by_normals = place.json("medial surface.ply --mesh-normals");
    let by_normals = by_normals["counts"]["faces"].as_u64().unwrap();
    assert!(by_normals.abs_diff(inner) < inner / 4, "{by_normals} of {inner}");
    assert_eq!(place.failure("medial torus.ply --mesh-normals", 1)["path"], "torus.ply");
}

#[test]
fn both_sides_have_labels_where_they_are_asked_for() {
    let place = Place::new();
    place.shape(Shape::Torus, "torus.ply");
    place.json("cocone torus.ply -o surface.ply");
    let sides = |options: &str| {
        let report = place.json(&format!("medial torus.ply --side both -o axis.ply {options}"));
        let axis = io::read_complex(place.path("axis.ply"), &Job::default()).unwrap();
        let mut sides = numbers(&axis, Element::Face, "side");
        assert_eq!(report["counts"]["faces"], sides.len());
        sides.sort_unstable();
        sides.dedup();
        (report, sides)
    };
    let (without, all) = sides("");
    assert_eq!((&all[..], without.get("labels")), (&[2][..], None));
    assert_eq!(
        (&without["parameters"]["labels"], &without["parameters"]["label_mesh"]),
        (&json!(null), &json!(null))
    );
    for (options, name, mesh) in [
        ("--labels cocone", "cocone", json!(null)),
        ("--labels crust", "crust", json!(null)),
        ("--label-mesh surface.ply", "mesh", json!("surface.ply")),
        ("--compare-labels", "cocone", json!(null)),
    ] {
        // Facets that cross the surface are chosen, too, if nothing else decides.
        let (report, all) = sides(&format!("{options} --rule none"));
        assert_eq!(all, [0, 1, 2], "{options}");
        assert!(report["labels"]["inner"].as_u64().unwrap() > 0, "{options}");
        let parameters = &report["parameters"];
        assert_eq!((&parameters["labels"], &parameters["label_mesh"]), (&json!(name), &mesh));
        let is_compared = report["labels"]["disagreement"].get("crust").is_some();
        assert_eq!(is_compared, options == "--compare-labels", "{options}");
    }
    let error = place.failure("medial torus.ply --side both --label-mesh absent.off", 1);
    assert_eq!((&error["status"], &error["path"]), (&json!("IO"), &json!("absent.off")));
}

#[test]
fn a_source_that_fails_is_not_compared() {
    let place = Place::new();
    // A curve has no surface of Delaunay triangles.
    let rows = (0..30).map(|i| f64::from(i) / 5.0);
    let rows = rows.map(|x| format!("{x} {} {}\n", x * x, x * x * x)).collect::<String>();
    place.write("curve.xyz", rows);
    assert_eq!(place.failure("medial curve.xyz", 1)["status"], "DEGENERATE");
    let report = place.json("medial curve.xyz --labels crust --compare-labels");
    assert_eq!(report["labels"]["disagreement"], json!({ "cocone": null }));
    let warnings = report["warnings"].as_array().unwrap();
    let is_told =
        |warning: &serde_json::Value| warning.as_str().unwrap().contains("no labels of cocone");
    assert!(warnings.iter().any(is_told), "{warnings:?}");
}

#[test]
fn every_angle_below_90_degrees_is_a_threshold() {
    let place = Place::new();
    place.shape(Shape::Sphere, "sphere.ply");
    for angle in ["0", "89.9999", "89.99999999999999"] {
        place.json(&format!("medial sphere.ply --side both --theta-degrees {angle}"));
    }
    for (arguments, what) in [
        ("medial sphere.ply --theta-degrees 1e300", "1e300"),
        ("medial sphere.ply --object-degrees -1e300", "-1e300"),
        ("crust sphere.ply --shape a.ply --scale-axis 1e300", "1e300"),
        ("cocone sphere.ply --angle-degrees 1e300", "1e300"),
    ] {
        let error = place.failure(arguments, 2);
        let message = error["message"].as_str().unwrap();
        assert!(message.contains(what) && message.len() < 120, "{message}");
    }
}

#[test]
fn a_box_keeps_unbounded_facets_and_cuts_them() {
    let place = Place::new();
    place.shape(Shape::Torus, "torus.ply");
    let without = place.json("medial torus.ply --side outer");
    place.json("medial torus.ply --side outer --clip 0.1 -o outer.ply");
    let axis = io::read_complex(place.path("outer.ply"), &Job::default()).unwrap();
    assert!(axis.faces().len() as u64 > without["counts"]["faces"].as_u64().unwrap() / 4);
    // The diagonal of the torus' box is 2 sqrt(2 * 1.4^2 + 0.4^2).
    let margin = 0.1 * 2.0 * (2.0f64 * 1.4 * 1.4 + 0.4 * 0.4).sqrt();
    for p in axis.vertices() {
        let within =
            p[0].abs().max(p[1].abs()) < 1.4 + margin + 1e-6 && p[2].abs() < 0.4 + margin + 1e-6;
        assert!(within, "{p:?}");
    }
    assert!(numbers(&axis, Element::Vertex, "cell").contains(&u32::MAX));
    assert!(numbers(&axis, Element::Face, "side").iter().all(|&side| side == 0));
}

#[test]
fn a_box_that_is_too_large_is_refused_and_nothing_is_written() {
    let place = Place::new();
    place.shape(Shape::Torus, "torus.ply");
    let failure = place.failure("medial torus.ply --side both --clip 1e160 -o out.ply", 1);
    assert_eq!(failure["status"], "COORDINATE_RANGE", "{failure}");
    assert_eq!(place.names(), ["torus.ply"]);
    // What is written can be read, however far the box reaches.
    place.json("medial torus.ply --side both --rule none --clip 1e50 -o out.ply");
    io::read_complex(place.path("out.ply"), &Job::default()).unwrap();
}

#[test]
fn a_scale_axis_takes_the_place_of_the_shape() {
    let place = Place::new();
    place.shape(Shape::Torus, "torus.ply");
    let report = place.json("crust torus.ply --shape axis.ply --scale-axis 1.1");
    assert_eq!(report["outputs"][1]["name"], "inner scale axis");
    assert_eq!(report["outputs"][1]["topology"]["betti"], json!([1, 1, 0]));
    for (arguments, code) in [
        ("crust torus.ply --shape a.ply --scale-axis 1.1 --side both", 2),
        ("crust torus.ply --shape a.ply --scale-axis 0.5", 2),
        ("crust torus.ply --scale-axis 2", 2),
        ("medial torus.ply --theta-degrees 90", 2),
        ("medial torus.ply --rho -1", 2),
        ("medial torus.ply --clip -1", 2),
        ("cocone torus.ply --angle-degrees 0", 2),
        ("cocone torus.ply --ratio nan", 2),
    ] {
        place.failure(arguments, code);
    }
    assert_eq!(place.names(), ["axis.ply", "torus.ply"]);
}

//! What is refused, and what `medax info` says of plane figures.

use super::{feature, open_box, polygon, square};
use crate::{Place, text};
use medax::Status;
use serde_json::{Value, json};

#[test]
fn what_makes_no_sense_is_refused() {
    let place = Place::new();
    place.figure("in.geojson", &[polygon("box", &json!([square(0.0, 0.0, 1.0)]))]);
    place.write("box.off", open_box(0, ""));
    for arguments in [
        "field",
        "field in.geojson --density -1",
        "field in.geojson --density inf",
        "field in.geojson --min-distance nan",
        "field in.geojson --clip -0.1",
        "field in.geojson --object-degrees 181",
        "field in.geojson --side left",
        "field in.geojson --feature a --feature-number 1",
        "field in.geojson --feature-number one",
        "field in.geojson --epsilon 1",
        "field in.geojson --tolerance 1",
        "field in.geojson --samples 20",
        "field in.geojson --missed-degrees 20",
        "field in.geojson --points --missed-degrees 180",
        "field in.geojson --points --missed-degrees 0",
        "field in.geojson --points --samples 11",
        "field in.geojson --points --epsilon -1",
        "field in.geojson --pairs 0",
        "field in.geojson --pairs 0-1-2",
        "field in.geojson --pairs 0--1",
        "field in.geojson --pairs 0-1",
        "field in.geojson --points --pairs 0-0,0-1",
        "field box.off --pairs 0-0,1-0",
        "field box.off --missed-degrees 20",
        "field box.off --feature box",
        "field box.off --feature-number 0",
        "field box.off --crossings",
        "field box.off -o out.geojson",
        "field in.geojson -o out.step",
        "info box.off --feature box",
    ] {
        assert_eq!(place.failure(arguments, 2)["status"], "INVALID_ARGUMENT", "{arguments}");
    }
    let error = place.failure("field box.off --pairs 0-0,1-0", 2);
    assert_eq!((&error["kind"], &error["index"]), (&json!("row"), &1.into()));
    let error = place.failure("field in.geojson --epsilon 1", 2);
    assert!(error["message"].as_str().unwrap().contains("--points"), "{error}");
    for (arguments, path) in [
        ("field absent.geojson -o out.ply", "absent.geojson"),
        ("field absent.off -o out.ply", "absent.off"),
        ("field in.geojson -o nowhere/out.ply", "nowhere/out.ply"),
    ] {
        let error = place.failure(arguments, 1);
        assert_eq!((&error["status"], &error["path"]), (&json!("IO"), &json!(path)));
    }
    // An error finds the file, the feature, the ring and the place.
    let cut = json!([square(0.0, 0.0, 9.0), [[2, 2], [4, 4], [4, 2], [2, 4], [2, 2]]]);
    place.figure(
        "cut.geojson",
        &[polygon("whole", &json!([square(20.0, 0.0, 1.0)])), polygon("cut", &cut)],
    );
    let error = place.failure("field cut.geojson -o out.ply", 1);
    assert_eq!(
        (&error["status"], &error["path"]),
        (&json!("INVALID_ARGUMENT"), &json!("cut.geojson"))
    );
    assert_eq!((&error["kind"], &error["index"]), (&json!("ring"), &2.into()));
    let message = error["message"].as_str().unwrap();
    for words in ["feature 1 'cut': ", "of ring 2", "(3, 3)", "(--crossings)"] {
        assert!(message.contains(words), "{message}");
    }
    // Chosen alone, its rings count from 0.
    let error = place.failure("field cut.geojson --feature cut", 1);
    assert_eq!(error["index"], 1);
    let error = place.failure("field cut.geojson --crossings -o out.ply", 1);
    assert_eq!(error["status"], Status::Unsupported.name());
    assert!(error["message"].as_str().unwrap().contains("--points"), "{error}");
    let info = place.json("info cut.geojson");
    assert_eq!((&info["figure"]["crossings"], &info["figure"]["polygons"]), (&1.into(), &2.into()));
    place.write("broken.geojson", "{\"type\":\n\"Point\",\"coordinates\":[1,]}");
    let error = place.failure("field broken.geojson", 1);
    assert_eq!(
        (&error["status"], &error["kind"], &error["index"]),
        (&json!("FORMAT"), &json!("line"), &2.into())
    );
    place.write("nan.off", "OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n");
    let error = place.failure("field nan.off", 1);
    assert_eq!((&error["status"], &error["index"]), (&json!("NON_FINITE"), &1.into()));
    assert_eq!(
        place.names(),
        ["box.off", "broken.geojson", "cut.geojson", "in.geojson", "nan.off"]
    );
}

#[test]
fn info_tells_what_a_figure_holds() {
    let place = Place::new();
    let features = [
        polygon("a", &json!([square(0.0, 0.0, 4.0), square(1.0, 1.0, 1.0)])),
        feature(&Value::Null, "LineString", &json!([[5, 0], [5, 0], [6, 1]])),
        feature(&Value::Null, "MultiPoint", &json!([[8, 0], [20, 1]])),
        feature(&json!({ "radius": 1 }), "Point", &json!([12, 2])),
    ];
    place.figure("in.geojson", &features);
    let info = place.json("info in.geojson");
    let expected = json!({
        "polygons": 1, "holes": 1, "polylines": 1, "points": 2, "circles": 1, "closing_vertices": 2,
        "repeated_vertices": 1, "turned_rings": 1, "crossings": 0, "misplaced": 0,
    });
    assert_eq!(info["figure"], expected);
    assert_eq!(info["bounds"]["min"], json!([0.0, 0.0, 0.0]));
    assert_eq!(info["bounds"]["max"], json!([20.0, 4.0, 0.0]));
    assert_eq!((&info["topology"], &info["counts"]["vertices"]), (&Value::Null, &12.into()));
    let table = place.run("info in.geojson");
    let words = "polygons 1, holes 1, polylines 1, points 2, circles 1";
    assert!(text(&table.stdout).contains(words), "{}", text(&table.stdout));
}

//! `medax pair`: what it says and writes.

use crate::Place;
use medax::complex::Element;
use medax::sample::Shape;
use medax::{Job, io};
use serde_json::json;

#[test]
fn a_torus_is_divided_and_its_surfaces_are_written() {
    let place = Place::new();
    place.shape(Shape::Torus, "torus.ply");
    let report = place.json(
        "pair torus.ply -o solid.vtu --iso 0.1,0.75 --iso-out surface.ply --validate --labels crust",
    );
    let pair = &report["pair"];
    let count = |name: &str| pair[name].as_u64().unwrap();
    let elements = count("face_vertex") + count("edge_edge") + count("vertex_face");
    assert_eq!(report["counts"]["cells"], elements);
    assert_eq!((count("folded"), count("removed")), (0, 0));
    assert_eq!(count("face_vertex"), 2 * count("inner_faces"));
    let volume = pair["volume"].as_f64().unwrap();
    assert!(volume > 0.0);
    let outputs = report["outputs"].as_array().unwrap();
    let betti = |i: usize| &outputs[i]["topology"]["betti"];
    assert_eq!((betti(0), betti(1)), (&json!([1, 1, 0]), &json!([1, 1, 0])));
    for (i, name) in [(2, "surface-0.1.ply"), (3, "surface-0.75.ply")] {
        assert_eq!((betti(i), &outputs[i]["path"]), (&json!([1, 2, 1]), &json!(name)));
        let written = io::read_complex(place.path(name), &Job::default()).unwrap();
        assert_eq!(written.faces().len() as u64, elements);
        assert!(written.attribute(Element::Face, "kind").is_some());
    }
    // What ParaView reads: as many cells, of three types.
    let text = std::fs::read_to_string(place.path("solid.vtu")).unwrap();
    assert!(text.contains(&format!("NumberOfCells=\"{elements}\"")));

    // One surface has the name that was given; the last is the boundary.
    let one = place.json("pair torus.ply --iso 1 --iso-out last.off");
    assert_eq!(one["outputs"][2]["faces"], count("vertex_face"));
    assert_eq!(one["outputs"][2]["path"], "last.off");
}

#[test]
fn parts_of_the_inner_structure_are_asked_for() {
    let place = Place::new();
    place.shape(Shape::Torus, "torus.ply");
    let whole = place.json("pair torus.ply");
    let all = whole["pair"]["inner_faces"].as_u64().unwrap();
    assert_eq!(whole["pair"]["asked"], all);
    for (inner, least) in [
        ("medial", 1000),
        ("medial --facets angle=90 --subdivide", 100),
        ("core", 0),
        ("core --facets medial", 1000),
        ("spine", 0),
    ] {
        let command = format!("pair torus.ply --validate --inner-out inner.ply --inner {inner}");
        let report = place.json(&command);
        let pair = &report["pair"];
        let count = |name: &str| pair[name].as_u64().unwrap();
        assert_eq!(report["validation"]["problems"], 0, "{inner}");
        assert!(count("asked") >= least && count("inner_faces") < all, "{inner}: {pair}");
        assert_eq!(count("asked") + count("enclosed") + count("unseen"), count("inner_faces"));
        assert_eq!(report["outputs"][1]["topology"]["betti"], json!([1, 1, 0]), "{inner}");
        let written = io::read_complex(place.path("inner.ply"), &Job::default()).unwrap();
        assert_eq!(written.faces().len() as u64, count("inner_faces"));
    }
    let error = place.failure("pair torus.ply --inner core --exact", 1);
    assert_eq!((&error["status"], &error["kind"]), (&json!("DEGENERATE"), &json!("face")));
    for arguments in [
        "pair torus.ply --facets medial",
        "pair torus.ply --inner spine --facets medial",
        "pair torus.ply --exact",
        "pair torus.ply --subdivide",
    ] {
        assert_eq!(place.run(arguments).status.code(), Some(2), "{arguments}");
    }
}

#[test]
fn what_is_no_time_is_refused() {
    let place = Place::new();
    place.shape(Shape::Torus, "torus.ply");
    for arguments in [
        "pair torus.ply --iso 1.5 --iso-out s.ply",
        "pair torus.ply --iso 0.5",
        "pair torus.ply --iso-out s.ply",
        "pair torus.ply --iso 0.5 --iso-out s.xyz.nothing",
    ] {
        assert_eq!(place.run(arguments).status.code(), Some(2), "{arguments}");
    }
}

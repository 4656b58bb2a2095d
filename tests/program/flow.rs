//! `medax flow`: what it says and writes.

use crate::Place;
use medax::complex::{Complex, Element, Values};
use medax::sample::Shape;
use medax::{Job, io};
use serde_json::{Value, json};

fn read(place: &Place, name: &str) -> Complex {
    io::read_complex(place.path(name), &Job::default()).unwrap()
}

fn integers(complex: &Complex, element: Element, name: &str) -> Vec<u32> {
    match complex.attribute(element, name).unwrap().values() {
        Values::U32(values) => values.clone(),
        Values::F64(values) => values.iter().map(|&x| x as u32).collect(),
    }
}

fn betti(report: &Value) -> &Value {
    &report["outputs"][0]["topology"]["betti"]
}

#[test]
fn cores_of_a_torus_have_its_homotopy_type_alone_and_extended() {
    let place = Place::new();
    place.shape(Shape::Torus, "torus.ply");
    let solid = json!([1, 1, 0]);
    let core = place.json("flow torus.ply -o core.ply --validate");
    assert_eq!(betti(&core), &solid);
    assert_eq!(core["parameters"]["what"], "core");
    assert_eq!(core["flow"]["core"]["unbounded"], 0);
    let written = read(&place, "core.ply");
    assert_eq!(written.faces().len() as u64, core["counts"]["faces"].as_u64().unwrap());
    assert!(written.attribute(Element::Vertex, "radius").is_some());
    assert_eq!(betti(&place.json("flow torus.ply --plain")), &solid);

    let axis = place.json("medial torus.ply");
    let extended = place.json("flow torus.ply --extend medial -o extended.vtu");
    assert_eq!(betti(&extended), &solid);
    let taken = extended["flow"]["core"]["taken"].as_u64().unwrap();
    let excluded = &extended["flow"]["core"]["excluded"];
    let left = ["elsewhere", "leaving", "of_surface"].map(|name| excluded[name].as_u64().unwrap());
    // Those of the inner axis are taken, but for those that leave; those of the outer one are elsewhere.
    assert!(taken > 0 && left[0] > 0, "{extended}");
    assert_eq!(taken + left[1], axis["medial"]["selected"].as_u64().unwrap());
    assert!(extended["counts"]["faces"].as_u64() > core["counts"]["faces"].as_u64());
    assert_eq!(extended["parameters"]["extend"], "medial");

    // Thresholds only take away, and none of them changes the homotopy type.
    for filter in ["medial,lambda=0.3", "angle=120", "lambda=0.39", "medial,scale=1.5"] {
        let report = place.json(&format!("flow torus.ply --extend {filter}"));
        assert_eq!(betti(&report), &solid, "{filter}");
        let fewer = report["flow"]["core"]["taken"].as_u64().unwrap();
        assert!(!filter.starts_with("medial") || fewer <= taken, "{filter}");
    }
}

#[test]
fn critical_points_and_their_manifolds_and_orbits_are_written() {
    let place = Place::new();
    place.shape(Shape::Torus, "torus.ply");
    let report = place.json("flow torus.ply --critical -o critical.ply");
    let counts = &report["flow"]["critical"];
    let sum = |index: usize| {
        let of = |class: &str| counts[class][index].as_i64().unwrap();
        of("surface") + of("inner") + of("outer")
    };
    assert_eq!(sum(0) - sum(1) + sum(2) - sum(3), 1);
    let critical = read(&place, "critical.ply");
    assert_eq!(critical.vertices().len() as i64, sum(1) + sum(2) + sum(3));
    let gap = report["flow"]["gap"].as_array().unwrap();
    assert!(gap[0].as_f64().unwrap() <= 0.5 && gap[1].as_f64().unwrap() > 0.5);

    // A manifold of index 1 has faces, one of index 2 is a line, one of index 3 a point.
    let indices = integers(&critical, Element::Vertex, "index");
    let classes = integers(&critical, Element::Vertex, "class");
    for index in 1..=3 {
        let row = (0..indices.len()).find(|&i| indices[i] == index && classes[i] == 1);
        let Some(row) = row else { continue };
        let report = place.json(&format!("flow torus.ply --manifold {row}"));
        let faces = report["counts"]["faces"].as_u64().unwrap();
        let edges = report["counts"]["edges"].as_u64().unwrap();
        assert_eq!((faces > 0, edges > 0), (index == 1, index == 2 || edges > 0), "{index}");
    }

    place.write("starts.xyz", "1.1 0 0.05\n0 0 0.01\n9 9 9\n");
    let report = place.json("flow torus.ply --orbits starts.xyz -o orbits.obj");
    assert_eq!(report["flow"]["orbits"], json!({ "count": 3, "to_infinity": 2 }));
    assert_eq!(report["counts"]["faces"], 0);
    assert_eq!(betti(&report), &json!([3, 0, 0]));
    assert_eq!(report["parameters"]["orbits"], "starts.xyz");
    let orbits = read(&place, "orbits.obj");
    assert_eq!(orbits.vertices()[0], [1.1, 0.0, 0.05]);
}

#[test]
fn the_whole_complex_is_written_and_what_cannot_be_is_refused() {
    let place = Place::new();
    place.shape(Shape::Torus, "torus.ply");
    let report = place.json("flow torus.ply --complex --validate -o all.ply");
    // All but what is unbounded of a complex that fills space.
    let core = place.json("flow torus.ply");
    assert!(report["counts"]["faces"].as_u64() > core["counts"]["faces"].as_u64());
    let outer = place.json("flow torus.ply --side outer");
    assert_eq!(outer["parameters"]["side"], "outer");
    assert!(outer["counts"]["vertices"].as_u64() > Some(0));

    let before = place.names();
    for (arguments, code) in [
        ("flow torus.ply --extend thick", 2),
        ("flow torus.ply --extend angle=200", 2),
        ("flow torus.ply --extend lambda=x", 2),
        ("flow torus.ply --extend angle=10,angle=20", 2),
        ("flow torus.ply --critical --extend medial", 2),
        ("flow torus.ply --orbits torus.ply --side outer", 2),
        ("flow torus.ply --complex --plain", 2),
        ("flow torus.ply --least-slope 1", 2),
        ("flow torus.ply --core --critical", 2),
        ("flow torus.ply --manifold 100000000", 2),
        ("flow torus.ply --orbits absent.xyz -o out.ply", 1),
        ("flow absent.ply -o out.ply", 1),
    ] {
        let output = place.run(arguments);
        assert_eq!(output.status.code(), Some(code), "{arguments}");
    }
    assert_eq!(place.names(), before);
    place.write("bad.xyz", "0 0 0\n0 0 1e300\n");
    let error = place.failure("flow torus.ply --orbits bad.xyz", 1);
    assert_eq!((&error["status"], &error["index"]), (&json!("COORDINATE_RANGE"), &json!(1)));
    assert_eq!(error["path"], "bad.xyz");
    place.write("nan.xyz", "0 0 0\n0 0 nan\n");
    let error = place.failure("flow torus.ply --orbits nan.xyz", 1);
    assert_eq!((&error["status"], &error["path"]), (&json!("NON_FINITE"), &json!("nan.xyz")));
}

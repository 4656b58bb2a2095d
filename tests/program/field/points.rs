//! Points of figures and of meshes.

use super::{number, open_box, polygon, reals, rectangle};
use crate::{Place, text};
use serde_json::{Value, json};

#[test]
fn points_of_a_figure_come_with_their_claim() {
    let place = Place::new();
    place.figure("in.geojson", &[polygon("box", &json!([rectangle(0.0, 0.0, 4.0, 2.0)]))]);
    let options = "--points --density 0.1 --min-distance 0.2 --missed-degrees 15";
    let report = place.json(&format!("field in.geojson {options} -o points.ply"));
    let claim = &report["claim"];
    let missed = number(&claim["missed_degrees"]);
    assert!(missed > 0.0 && missed <= 15.0, "{claim}");
    assert_eq!(claim["circles_without_claim"].as_u64(), Some(0), "{claim}");
    assert_eq!(claim["circles"], report["field"]["covers"]);
    assert_eq!(report["field"]["points"], report["counts"]["vertices"]);
    let parameters = &report["parameters"];
    assert_eq!(
        (&parameters["what"], &parameters["missed_degrees"]),
        (&json!("points"), &json!(15.0))
    );
    assert_eq!((&parameters["density"], &parameters["min_distance"]), (&json!(0.1), &json!(0.2)));
    // As many as the bound takes: pi / sin(7.5 degrees) is 24.07.
    assert_eq!(parameters["samples"], 25);
    let epsilon = number(&parameters["epsilon"]);
    assert!((epsilon - 1e-6 * 20f64.sqrt()).abs() < 1e-15);
    let points = place.complex("points.ply");
    for (&[x, y, _], radius) in points.vertices().iter().zip(reals(&points, "radius")) {
        let mut sides = [x, 4.0 - x, y, 2.0 - y];
        sides.sort_by(f64::total_cmp);
        let off = [sides[1] - sides[0], (sides[0] - radius).abs()];
        assert!(off.iter().all(|&off| off <= 2.0 * epsilon), "({x}, {y}): {off:?}");
        assert!(radius >= 0.2);
    }
    // The claim, on what is known: the middle line has an object angle of 180 degrees, the diagonals one of 90.
    let middle = (0..=200).map(|i| [1.0 + 0.01 * f64::from(i), 1.0]);
    let diagonal = (0..=80).map(|i| [0.2 + 0.01 * f64::from(i); 2]);
    for [x, y] in middle.chain(diagonal) {
        let near = |p: &&[f64; 3]| (p[0] - x).hypot(p[1] - y) <= 0.1;
        assert!(points.vertices().iter().any(|p| near(&p)), "nothing near ({x}, {y})");
    }
    // Where what is found does not pass there is no claim.
    let report = place.json(&format!("field in.geojson {options} --object-degrees 120"));
    assert!(report["claim"]["circles_without_claim"].as_u64() > Some(0), "{report}");
    let table = place.run(&format!("field in.geojson {options} --object-degrees 120"));
    let table = text(&table.stdout);
    let line = table.lines().find(|line| line.starts_with("claim")).unwrap();
    for words in ["0.2 or more from the figure", "degrees", "within 0.1", "circles, where"] {
        assert!(line.contains(words), "{line}");
    }
    // Curves that cross have points, too.
    let bow = json!([[[0, 0], [4, 4], [4, 0], [0, 4], [0, 0]]]);
    place.figure("bow.geojson", &[polygon("bow", &bow)]);
    let report = place.json("field bow.geojson --crossings --points");
    assert!(report["counts"]["vertices"].as_u64() > Some(50), "{report}");
    assert_eq!(report["figure"]["crossings"], 1);
}

#[test]
fn points_of_a_mesh_lie_between_its_faces() {
    let place = Place::new();
    place.write("box.off", open_box(0, ""));
    let report = place.json(
        "field box.off --points --density 0.1 --object-degrees 80 --min-distance 0.1 -o axis.ply",
    );
    assert_eq!(report["warnings"], json!([]));
    assert_eq!((&report["claim"], &report["parameters"]["what"]), (&Value::Null, &json!("points")));
    assert_eq!(report["parameters"]["missed_degrees"], Value::Null);
    assert_eq!(
        (&report["parameters"]["samples"], &report["field"]["pieces"]),
        (&60.into(), &12.into())
    );
    assert_eq!((&report["input"]["points"], &report["input"]["unused"]), (&8.into(), &0.into()));
    let axis = place.complex("axis.ply");
    assert!(axis.vertices().len() > 200);
    for &[x, y, z] in axis.vertices() {
        let mut faces = [x, 2.0 - x, y, 1.5 - y, z, 1.0 - z];
        faces.sort_by(f64::total_cmp);
        assert!(faces[0] >= 0.1 - 1e-12 && faces[1] - faces[0] < 1e-4, "{x} {y} {z}");
    }
    // The rectangle in the middle is 1 wide and 0.5 deep.
    let middle = axis.vertices().iter().filter(|p| (p[2] - 0.5).abs() < 1e-5).count();
    assert!(middle > 20, "{middle}");
    let plain = place.run("field box.off --points --density 0.2");
    assert!(text(&plain.stdout).contains("in space no theorem"), "{}", text(&plain.stdout));

    // A vertex that nothing uses is nothing to measure to.
    place.write("stray.off", open_box(0, "1 0.75 0.5\n"));
    let stray = "field stray.off --points --density 0.1 --object-degrees 80 --min-distance 0.1 -o stray.ply";
    assert_eq!(place.json(stray)["input"]["unused"], 1);
    assert_eq!(place.read("stray.ply"), place.read("axis.ply"));

    // Convex from outside: there is nothing, and that is said.
    let outer = place.json("field box.off --points --density 0.2 --side outer");
    assert_eq!(outer["counts"]["vertices"], 0);
    assert!(outer["warnings"][0].as_str().unwrap().contains("empty"), "{outer}");
    // Without a lid, inside is where the faces wind round a point.
    place.write("open.off", open_box(1, ""));
    let open = place.json("field open.off --points --density 0.2 --side both");
    assert!(open["counts"]["vertices"].as_u64() > Some(20));
    assert_eq!(open["warnings"], json!([]));
    let inner = place.json("field open.off --points --density 0.2");
    assert!(inner["warnings"][0].as_str().unwrap().contains("wind"), "{inner}");
    // Points alone have their Voronoi diagram, all of it outside.
    place.write("points.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
    let points = place.json("field points.xyz --points --side outer --density 0.2");
    assert!(points["counts"]["vertices"].as_u64() > Some(20));
}

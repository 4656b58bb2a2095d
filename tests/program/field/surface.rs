//! Surfaces of meshes, and what lies between their components.

use super::{betti, number, open_box, polygon, rectangle};
use crate::Place;
use medax::complex::{Complex, Element, Values};
use serde_json::{Value, json};

/// Cubes of side 1, one after the other along x and 1 apart.
fn cubes(count: usize) -> String {
    let mut text = format!("OFF\n{} {} 0\n", 8 * count, 6 * count);
    for i in 0..8 * count {
        let x = 2 * (i / 8) + usize::from([1, 2].contains(&(i % 4)));
        text += &format!("{x} {} {}\n", i % 4 / 2, i % 8 / 4);
    }
    for first in (0..count).map(|i| 8 * i) {
        for face in
            [[0, 3, 2, 1], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [4, 5, 6, 7]]
        {
            let [a, b, c, d] = face.map(|v| first + v);
            text += &format!("4 {a} {b} {c} {d}\n");
        }
    }
    text
}

fn sites(complex: &Complex, element: Element) -> Vec<[u32; 2]> {
    match complex.attribute(element, "sites").unwrap().values() {
        Values::U32(sites) => sites.as_chunks::<2>().0.to_vec(),
        Values::F64(_) => panic!("sites are whole numbers"),
    }
}

#[test]
fn the_surface_of_a_box_is_contractible_and_has_its_middle() {
    let place = Place::new();
    place.write("box.off", open_box(0, ""));
    let report = place.json("field box.off --density 0.1 --validate -o axis.ply");
    assert_eq!(betti(&report), &json!([1, 0, 0]));
    assert_eq!(report["outputs"][0]["name"], "axis");
    let parameters = &report["parameters"];
    assert_eq!((&parameters["what"], &parameters["pairs"]), (&json!("surface"), &Value::Null));
    assert_eq!((&parameters["density"], &parameters["samples"]), (&json!(0.1), &60.into()));
    assert_eq!((&report["claim"], &report["field"]["sites"]), (&Value::Null, &1.into()));
    assert!(report["validation"]["checked"].as_u64() > Some(1000), "{report}");
    assert_eq!(report["validation"]["problems"], 0);
    let axis = place.complex("axis.ply");
    assert_eq!(report["counts"]["faces"], axis.faces().len());
    let started = report["field"]["points"].as_u64().unwrap() as usize;
    assert!(started > 500 && started <= axis.vertices().len(), "{report}");
    for &[x, y, z] in axis.vertices() {
        let mut faces = [x, 2.0 - x, y, 1.5 - y, z, 1.0 - z];
        faces.sort_by(f64::total_cmp);
        assert!(faces[1] - faces[0] < 1e-4, "{x} {y} {z}");
    }
    // In the middle a rectangle of 1 by 0.5, seen from which opposite faces are the nearest.
    let middle = place.json("field box.off --density 0.05 --object-degrees 170 -o middle.ply");
    assert_eq!(betti(&middle), &json!([1, 0, 0]));
    let area = number(&place.json("info middle.ply")["measure"]["area"]);
    assert!((area - 0.5).abs() < 0.15, "{area}");
    // Points make no faces, and start the surface.
    let points = place.json("field box.off --density 0.1 --points --validate");
    assert_eq!(
        (&points["counts"]["faces"], &points["parameters"]["what"]),
        (&0.into(), &json!("points"))
    );
    assert_eq!(points["counts"]["vertices"], started);
    assert_eq!(points["outputs"][0]["name"], "points");
}

#[test]
fn between_the_solids_of_a_mesh_are_pieces_of_planes() {
    let place = Place::new();
    place.write("cubes.off", cubes(3));
    let outer = "field cubes.off --side outer --clip 0 --density 0.1";
    let report = place.json(&format!("{outer} --between-sites -o diagram.ply"));
    assert_eq!(
        (&report["field"]["sites"], &report["parameters"]["between_sites"]),
        (&3.into(), &json!(true))
    );
    // In the box, the planes half way between cubes, each a disk.
    assert_eq!(betti(&report), &json!([2, 0, 0]));
    let diagram = place.complex("diagram.ply");
    assert!(diagram.vertices().iter().all(|p| ((p[0] - 2.5).abs() - 1.0).abs() < 1e-5));
    let of_faces = sites(&diagram, Element::Face);
    assert!(of_faces.contains(&[0, 1]) && of_faces.contains(&[1, 2]) || of_faces.contains(&[2, 1]));
    let area = number(&place.json("info diagram.ply")["measure"]["area"]);
    assert!((area - 2.0).abs() < 0.5, "{area}");
    for (pairs, x) in [("0-1", 1.5), ("2-1", 3.5)] {
        let report = place.json(&format!("{outer} --pairs {pairs} -o piece.ply"));
        assert_eq!(betti(&report), &json!([1, 0, 0]));
        let piece = place.complex("piece.ply");
        assert!(piece.vertices().iter().all(|p| (p[0] - x).abs() < 1e-5), "{pairs}");
    }
    let both = place.json(&format!("{outer} --pairs 0-1,1-2 -o both.ply"));
    assert_eq!(both["parameters"]["pairs"], json!([[0, 1], [1, 2]]));
    assert_eq!(place.read("both.ply"), place.read("diagram.ply"));
    let points = place.json(&format!("{outer} --pairs 0-1 --points -o points.ply"));
    assert!(points["counts"]["vertices"].as_u64() > Some(50));
    let points = place.complex("points.ply");
    assert!(sites(&points, Element::Vertex).iter().all(|pair| [[0, 1], [1, 0]].contains(pair)));
    // Within one cube there is nothing between sites, and its own axis is that of itself.
    let inner = place.json("field cubes.off --density 0.1 --between-sites");
    assert_eq!(inner["counts"]["vertices"], 0);
    let second = place.json("field cubes.off --density 0.1 --pairs 1-1 -o second.ply");
    assert_eq!(betti(&second), &json!([1, 0, 0]));
    assert!(place.complex("second.ply").vertices().iter().all(|p| p[0] > 2.0 && p[0] < 3.0));
    place.write("box.off", open_box(0, ""));
    let alone = place.json("field box.off --density 0.2 --between-sites");
    assert!(alone["warnings"][0].as_str().unwrap().contains("one site"), "{alone}");
}

#[test]
fn pairs_of_a_figure_have_their_arcs_and_points() {
    let place = Place::new();
    let squares = [0.0, 2.0, 4.0].map(|x| polygon("", &json!([rectangle(x, 0.0, 1.0, 1.0)])));
    place.figure("squares.geojson", &squares);
    let outer = "field squares.geojson --side outer --clip 0";
    for (pairs, length) in [("0-1", 1.0), ("0-1,2-1", 2.0)] {
        let report = place.json(&format!("{outer} --pairs {pairs} --validate"));
        assert!((number(&report["field"]["length"]) - length).abs() < 1e-6, "{report}");
        assert!(report["validation"]["checked"].as_u64() > Some(10), "{report}");
    }
    let points = format!("{outer} --points --density 0.1 --validate -o points.ply");
    for (options, pairs) in [("--between-sites", [[0, 1], [1, 2]]), ("--pairs 1-0", [[0, 1]; 2])] {
        let report = place.json(&format!("{points} {options}"));
        assert_eq!(report["validation"]["problems"], 0);
        let mut found = sites(&place.complex("points.ply"), Element::Vertex);
        found.iter_mut().for_each(|pair| pair.sort_unstable());
        assert!(pairs.iter().all(|pair| found.contains(pair)), "{found:?}");
        assert!(found.iter().all(|pair| pairs.contains(pair)), "{found:?}");
    }
}

//! Graphs of plane figures.

use super::{betti, feature, number, polygon, reals, rectangle, square};
use crate::Place;
use medax::complex::{Element, Values};
use medax::figure::ChainKind;
use serde_json::{Value, json};
use std::f64::consts::{PI, SQRT_2};

/// The length of an arc of y = (x^2 + 1) / 2 from its vertex on, which is 1/2 from focus and directrix.
fn parabola(u: f64) -> f64 {
    0.5 * (u * (1.0 + u * u).sqrt() + u.asinh())
}

#[test]
fn the_graph_of_a_rectangle_is_known() {
    let place = Place::new();
    place.figure("in.geojson", &[polygon("box", &json!([rectangle(-2.0, 1.0, 5.0, 3.0)]))]);
    let report = place.json("field in.geojson -o axis.geojson");
    assert_eq!(report["command"], "field");
    assert_eq!(betti(&report), &json!([1, 0, 0]));
    let field = &report["field"];
    assert_eq!(
        (&field["nodes"], &field["arcs"], &field["torn"]),
        (&6.into(), &5.into(), &0.into())
    );
    assert_eq!((&field["sites"], &field["pieces"]), (&1.into(), &4.into()));
    // Half the height is the share of every diagonal.
    let exact = (5.0 - 3.0) + 4.0 * 1.5 * SQRT_2;
    assert!((number(&field["length"]) - exact).abs() < 1e-9, "{field}");
    assert_eq!(report["claim"], Value::Null);
    let figure = &report["figure"];
    assert_eq!((&figure["polygons"], &figure["holes"]), (&1.into(), &0.into()));
    assert_eq!(figure["closing_vertices"], 1);
    assert_eq!(
        (&report["input"]["path"], &report["input"]["points"]),
        (&json!("in.geojson"), &4.into())
    );
    for key in ["nodes", "arcs"] {
        assert!(field[key].is_u64(), "{field}");
    }
    let parameters = &report["parameters"];
    assert_eq!((&parameters["what"], &parameters["side"]), (&json!("graph"), &json!("inner")));
    assert_eq!((&parameters["clip"], &parameters["samples"]), (&json!(0.0), &Value::Null));
    assert!((number(&parameters["density"]) - 0.01 * 34f64.sqrt()).abs() < 1e-12);
    let counts = ["cells", "hidden", "poles", "vertices", "faces", "edges"];
    let keys: Vec<&String> = report["counts"].as_object().unwrap().keys().collect();
    assert_eq!(keys, counts);
    let stages = report["stages"].as_array().unwrap();
    assert!(stages.iter().any(|stage| stage["name"] == "field"), "{stages:?}");

    // A line for each arc, and the attributes along it.
    let back = place.read_figure("axis.geojson");
    assert_eq!(back.chain_count(ChainKind::Polyline), 5);
    let written: Value = serde_json::from_slice(&place.read("axis.geojson")).unwrap();
    for line in written["features"].as_array().unwrap() {
        let count = line["geometry"]["coordinates"].as_array().unwrap().len();
        for name in ["radius", "object_angle", "feet", "is_node"] {
            assert_eq!(line["properties"][name].as_array().unwrap().len(), count, "{name}");
        }
    }
    // The same in a format for meshes, where every vertex is checked against the sides.
    place.json("field in.geojson -o axis.ply");
    let axis = place.complex("axis.ply");
    assert_eq!(axis.edges().len() as u64, report["counts"]["edges"].as_u64().unwrap());
    for (&[x, y, z], radius) in axis.vertices().iter().zip(reals(&axis, "radius")) {
        let mut sides = [x + 2.0, 3.0 - x, y - 1.0, 4.0 - y];
        sides.sort_by(f64::total_cmp);
        assert!((sides[0] - radius).abs() < 1e-9 && (sides[1] - radius).abs() < 1e-9);
        assert_eq!(z, 0.0);
    }
    for name in ["axis.obj", "axis.vtu", "axis.ma"] {
        place.json(&format!("field in.geojson -o {name}"));
    }
    assert_eq!(place.complex("axis.obj").vertices(), axis.vertices());
}

#[test]
fn lengths_of_an_l_and_of_a_ring_are_known() {
    let place = Place::new();
    let corners = json!([[[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2], [0, 0]]]);
    place.figure("l.geojson", &[polygon("L", &corners)]);
    let report = place.json("field l.geojson --density 0.01");
    // Where the parabolas round the inner corner meet the diagonal: as far from that corner as from both walls.
    let t = 2.0 - SQRT_2;
    let exact = 2.0 * SQRT_2 + 1.0 + 2.0 * parabola(1.0 - t) + t * SQRT_2;
    assert_eq!(betti(&report), &json!([1, 0, 0]));
    assert!((number(&report["field"]["length"]) - exact).abs() < 1e-5, "{report} {exact}");

    let rings = json!([square(-3.0, -3.0, 6.0), square(-1.0, -1.0, 2.0)]);
    place.figure("ring.geojson", &[polygon("ring", &rings)]);
    let report = place.json("field ring.geojson --density 0.01");
    let s = 2.0 * (SQRT_2 - 1.0);
    let exact = 8.0 + 8.0 * 2.0 * parabola(0.5 * s) + 4.0 * SQRT_2 * (2.0 - s);
    assert_eq!(betti(&report), &json!([1, 1, 0]));
    assert_eq!(report["figure"]["holes"], 1);
    assert!((number(&report["field"]["length"]) - exact).abs() < 1e-4, "{report} {exact}");
    // On the ways into the corners the object angle is 90 degrees, on the loop it is more.
    let thinned =
        place.json("field ring.geojson --density 0.01 --object-degrees 91 --min-distance 0.5");
    assert_eq!(betti(&thinned), &json!([1, 1, 0]));
    let loop_alone = 8.0 + 8.0 * 2.0 * parabola(0.5 * s);
    assert!((number(&thinned["field"]["length"]) - loop_alone).abs() < 1e-4, "{thinned}");

    // Two circles with one centre: a circle half way, without a node.
    let at = json!([1, 2]);
    let rings = [1.0, 3.0].map(|radius| feature(&json!({ "radius": radius }), "Point", &at));
    place.figure("circles.geojson", &rings);
    let report = place.json("field circles.geojson --crossings -o circle.geojson");
    assert_eq!(betti(&report), &json!([1, 1, 0]));
    assert_eq!(
        (&report["figure"]["circles"], &report["figure"]["misplaced"]),
        (&2.into(), &1.into())
    );
    assert!((number(&report["field"]["length"]) - 4.0 * PI).abs() < 0.01, "{report}");
    assert_eq!(place.read_figure("circle.geojson").chain_count(ChainKind::Polyline), 1);
}

#[test]
fn features_are_chosen_and_a_letter_keeps_its_counters() {
    let place = Place::new();
    let counters = json!([
        [[0, 0], [5, 0], [6, 1], [6, 4], [5, 5], [6, 6], [6, 9], [5, 10], [0, 10], [0, 0]],
        square(2.0, 1.5, 2.0),
        square(2.0, 6.5, 2.0)
    ]);
    let dots = json!([[square(8.0, 0.0, 1.0)], [square(8.0, 3.0, 1.0)]]);
    let features = [
        polygon("B", &counters),
        feature(&json!({ "glyph": ":" }), "MultiPolygon", &dots),
        feature(&json!({ "name": "0" }), "LineString", &json!([[20, 0], [20, 5]])),
    ];
    place.figure("letters.geojson", &features);
    for (choice, solid, pieces) in [
        ("--feature B", json!([1, 2, 0]), 17),
        ("--feature-number 0", json!([1, 2, 0]), 17),
        ("--feature :", json!([2, 0, 0]), 8),
        ("", json!([3, 2, 0]), 26),
    ] {
        let report = place.json(&format!("field letters.geojson {choice}"));
        assert_eq!(
            (betti(&report), &report["field"]["pieces"]),
            (&solid, &json!(pieces)),
            "{choice}"
        );
    }
    // A name is not a number.
    let report = place.json("field letters.geojson --feature 0 --side outer");
    assert_eq!(
        (&report["field"]["pieces"], &report["parameters"]["feature"]),
        (&1.into(), &json!("0"))
    );
    for choice in ["--feature C", "--feature-number 3"] {
        let error = place.failure(&format!("field letters.geojson {choice}"), 2);
        assert_eq!(
            (&error["status"], &error["path"]),
            (&json!("INVALID_ARGUMENT"), &json!("letters.geojson"))
        );
        assert!(error["message"].as_str().unwrap().contains("B, :, 0"), "{error}");
    }
    let info = place.json("info letters.geojson --feature B");
    assert_eq!((&info["figure"]["holes"], &info["counts"]["vertices"]), (&2.into(), &17.into()));
    let empty = place.json("field letters.geojson --feature 0");
    assert_eq!(empty["counts"]["vertices"], 0);
    assert!(empty["warnings"][0].as_str().unwrap().contains("--side outer"), "{empty}");
}

#[test]
fn outside_is_cut_by_a_box_and_lies_between_sites_on_demand() {
    let place = Place::new();
    let points = [[0, 0], [2, 0]].map(|at| feature(&Value::Null, "Point", &json!(at)));
    place.figure("two.geojson", &points);
    // The bisector, as long as the box is high: grown by shares of 2 on both sides.
    for (clip, length, shown) in [("", 2.0, 0.5), ("--clip 2", 8.0, 2.0)] {
        let report = place.json(&format!("field two.geojson --side outer {clip} -o axis.ply"));
        assert!((number(&report["field"]["length"]) - length).abs() < 1e-6, "{report}");
        assert_eq!(report["parameters"]["clip"], shown);
        assert!(place.complex("axis.ply").vertices().iter().all(|p| (p[0] - 1.0).abs() < 1e-9));
    }

    // Of an L and a point, what is between them is connected, and the way into the inner corner is no part of it.
    let corners = json!([[[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2], [0, 0]]]);
    let point = feature(&Value::Null, "Point", &json!([4, 4]));
    place.figure("apart.geojson", &[polygon("L", &corners), point]);
    let all = place.json("field apart.geojson --side outer -o all.ply");
    let between = place.json("field apart.geojson --side outer --between-sites -o between.ply");
    let sites = |name: &str| match place
        .complex(name)
        .attribute(Element::Vertex, "sites")
        .unwrap()
        .values()
    {
        Values::U32(sites) => sites.chunks(2).map(|pair| pair[0] != pair[1]).collect::<Vec<_>>(),
        Values::F64(_) => panic!("sites are whole numbers"),
    };
    assert!(sites("between.ply").iter().all(|differ| *differ));
    assert!(sites("all.ply").iter().any(|differ| !*differ));
    let [all, between] = [all, between].map(|report| number(&report["field"]["length"]));
    assert!(between > 3.0 && between < all - 1.0, "{between} of {all}");
    // Both sides are the inner and the outer one.
    let inner = number(&place.json("field apart.geojson")["field"]["length"]);
    let both = number(&place.json("field apart.geojson --side both")["field"]["length"]);
    assert!((inner + all - both).abs() < 1e-9 * both, "{inner} {all} {both}");
}

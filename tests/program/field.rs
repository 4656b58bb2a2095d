//! `medax field`, and what `medax info` says of plane figures.

use crate::{Place, text};
use medax::complex::{Complex, Element, Values};
use medax::figure::{ChainKind, Figure};
use medax::{Job, Status, io};
use serde_json::{Value, json};
use std::f64::consts::{PI, SQRT_2};

/// A feature of this geometry.
fn feature(properties: &Value, kind: &str, coordinates: &Value) -> Value {
    let geometry = json!({ "type": kind, "coordinates": coordinates });
    json!({ "type": "Feature", "properties": properties, "geometry": geometry })
}

fn polygon(name: &str, rings: &Value) -> Value {
    feature(&json!({ "name": name }), "Polygon", rings)
}

impl Place {
    fn figure(&self, name: &str, features: &[Value]) {
        let collection = json!({ "type": "FeatureCollection", "features": features });
        self.write(name, collection.to_string());
    }

    fn complex(&self, name: &str) -> Complex {
        io::read_complex(self.path(name), &Job::default()).unwrap()
    }

    /// The figure that a result in GeoJSON is when it is read back.
    fn read_figure(&self, name: &str) -> Figure {
        io::read_figure(self.path(name), &Default::default(), &Job::default()).unwrap()
    }
}

/// Corners of an axis-parallel square, counterclockwise.
fn square(x: f64, y: f64, side: f64) -> Value {
    rectangle(x, y, side, side)
}

fn rectangle(x: f64, y: f64, width: f64, height: f64) -> Value {
    let (u, v) = (x + width, y + height);
    json!([[x, y], [u, y], [u, v], [x, v], [x, y]])
}

fn betti(report: &Value) -> &Value {
    &report["outputs"][0]["topology"]["betti"]
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

fn reals(complex: &Complex, name: &str) -> Vec<f64> {
    match complex.attribute(Element::Vertex, name).unwrap().values() {
        Values::F64(values) => values.clone(),
        Values::U32(_) => panic!("{name} has whole numbers"),
    }
}

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
    // What is within 30 degrees of a corner of the outer ring goes first, the loop never.
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
    assert_eq!(claim["circles"], report["field"]["looked_at"]);
    assert_eq!(report["field"]["points"], report["counts"]["vertices"]);
    let parameters = &report["parameters"];
    assert_eq!(
        (&parameters["what"], &parameters["missed_degrees"]),
        (&json!("points"), &json!(15.0))
    );
    assert_eq!((&parameters["density"], &parameters["min_distance"]), (&json!(0.1), &json!(0.2)));
    // As many as the bound takes: pi / sin(7.5 degrees) is 24.07.
    assert_eq!(parameters["samples"], 25);
    let points = place.complex("points.ply");
    for (&[x, y, _], radius) in points.vertices().iter().zip(reals(&points, "radius")) {
        let mut sides = [x, 4.0 - x, y, 2.0 - y];
        sides.sort_by(f64::total_cmp);
        assert!((sides[1] - sides[0]).abs() < 1e-4 && (sides[0] - radius).abs() < 1e-9, "{x} {y}");
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

/// A box of sides 2, 1.5 and 1 from the origin, without its last faces.
fn open_box(left_out: usize, more: &str) -> String {
    let faces = ["0 3 2 1", "0 1 5 4", "1 2 6 5", "2 3 7 6", "3 0 4 7", "4 5 6 7"];
    let corners = [[0, 0], [1, 0], [1, 1], [0, 1]];
    let corner = |z: f64| {
        let at = |[x, y]: [i32; 2]| format!("{} {} {z}\n", 2.0 * f64::from(x), 1.5 * f64::from(y));
        corners.map(at).concat()
    };
    let faces: Vec<String> = faces[..6 - left_out].iter().map(|f| format!("4 {f}\n")).collect();
    let count = 8 + more.lines().count();
    format!(
        "OFF\n{count} {} 0\n{}{}{more}{}",
        faces.len(),
        corner(0.0),
        corner(1.0),
        faces.concat()
    )
}

#[test]
fn points_of_a_mesh_lie_between_its_faces() {
    let place = Place::new();
    place.write("box.off", open_box(0, ""));
    let report = place
        .json("field box.off --density 0.1 --object-degrees 80 --min-distance 0.1 -o axis.ply");
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
        assert!(faces[0] >= 0.1 && faces[1] - faces[0] < 1e-4, "{x} {y} {z}");
    }
    // The rectangle in the middle is 1 wide and 0.5 deep.
    let middle = axis.vertices().iter().filter(|p| (p[2] - 0.5).abs() < 1e-5).count();
    assert!(middle > 20, "{middle}");
    let plain = place.run("field box.off --density 0.2");
    assert!(text(&plain.stdout).contains("in space no theorem"), "{}", text(&plain.stdout));

    // A vertex that nothing uses is nothing to measure to.
    place.write("stray.off", open_box(0, "1 0.75 0.5\n"));
    let stray = "field stray.off --density 0.1 --object-degrees 80 --min-distance 0.1 -o stray.ply";
    assert_eq!(place.json(stray)["input"]["unused"], 1);
    assert_eq!(place.read("stray.ply"), place.read("axis.ply"));

    // Convex from outside: there is nothing, and that is said.
    let outer = place.json("field box.off --density 0.2 --side outer");
    assert_eq!(outer["counts"]["vertices"], 0);
    assert!(outer["warnings"][0].as_str().unwrap().contains("empty"), "{outer}");
    // Without a lid, inside is where the faces wind round a point.
    place.write("open.off", open_box(1, ""));
    let open = place.json("field open.off --density 0.2 --side both");
    assert!(open["counts"]["vertices"].as_u64() > Some(20));
    assert!(open["warnings"][0].as_str().unwrap().contains("wind"), "{open}");
    // Points alone have their Voronoi diagram, all of it outside.
    place.write("points.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
    let points = place.json("field points.xyz --side outer --density 0.2");
    assert!(points["counts"]["vertices"].as_u64() > Some(20));
}

#[test]
fn the_number_of_threads_changes_no_byte() {
    let place = Place::new();
    let holes: Vec<Value> = (0..6).map(|i| square(1.0 + 2.5 * f64::from(i), 1.0, 1.5)).collect();
    let rings: Vec<Value> = [rectangle(0.0, 0.0, 16.0, 4.0)].into_iter().chain(holes).collect();
    place.figure("comb.geojson", &[polygon("comb", &json!(rings))]);
    place.write("box.off", open_box(0, ""));
    for command in [
        "field comb.geojson --side both -o out.geojson",
        "field comb.geojson --points --density 0.5 -o out.ply",
        "field box.off --density 0.1 -o out.ply",
    ] {
        let name = command.rsplit(' ').next().unwrap();
        let written = [1, 3, 8].map(|threads| {
            place.json(&format!("{command} --threads {threads}"));
            place.read(name)
        });
        assert!(
            written[0].len() > 1000 && written.iter().all(|bytes| *bytes == written[0]),
            "{command}"
        );
    }
}

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
        "field in.geojson --points --between-sites",
        "field box.off --missed-degrees 20",
        "field box.off --between-sites",
        "field box.off --feature box",
        "field box.off --feature-number 0",
        "field box.off --crossings",
        "field box.off -o out.geojson",
        "field in.geojson -o out.step",
        "info box.off --feature box",
    ] {
        assert_eq!(place.failure(arguments, 2)["status"], "INVALID_ARGUMENT", "{arguments}");
    }
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
        feature(&Value::Null, "MultiPoint", &json!([[8, 0], [8, 1]])),
        feature(&json!({ "radius": 2 }), "Point", &json!([12, 2])),
    ];
    place.figure("in.geojson", &features);
    let info = place.json("info in.geojson");
    let expected = json!({
        "polygons": 1, "holes": 1, "polylines": 1, "points": 2, "circles": 1, "closing_vertices": 2,
        "repeated_vertices": 1, "turned_rings": 1, "crossings": 0, "misplaced": 0,
    });
    assert_eq!(info["figure"], expected);
    assert_eq!(info["bounds"]["min"], json!([0.0, 0.0, 0.0]));
    assert_eq!(info["bounds"]["max"], json!([14.0, 4.0, 0.0]));
    assert_eq!((&info["topology"], &info["counts"]["vertices"]), (&Value::Null, &12.into()));
    let table = place.run("info in.geojson");
    let words = "polygons 1, holes 1, polylines 1, points 2, circles 1";
    assert!(text(&table.stdout).contains(words), "{}", text(&table.stdout));
}

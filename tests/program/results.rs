//! What the commands say and write, against the library.

use crate::Place;
use medax::complex::{Element, Values};
use medax::crust::PowerCrustOptions;
use medax::points::PointsOptions;
use medax::sample::{SampleOptions, Shape, sample};
use medax::{Job, Poles, PowerCrust, Triangulation, io};
use serde_json::Value;
use std::path::Path;
use std::sync::Arc;

#[test]
fn every_command_answers_with_the_schema() {
    let place = Place::new();
    place.shape(Shape::Torus, "torus.ply");
    place.json("crust torus.ply -o crust.ply");
    let commands = [
        ("triangulate torus.ply -o cells.vtu", "triangulate"),
        ("poles torus.ply -o poles.ply --normals normals.ply", "poles"),
        ("crust torus.ply -o crust.off --shape axis.vtu --poles balls.ma", "crust"),
        ("cocone torus.ply -o cocone.ply", "cocone"),
        ("medial torus.ply -o medial.ply", "medial"),
        ("pair torus.ply -o solid.vtu", "pair"),
        ("info torus.ply", "info"),
        ("info crust.ply", "info"),
        ("compare torus.ply crust.ply --samples 100", "compare"),
        ("decimate crust.ply --ratio 0.25 -o small.ply", "decimate"),
        ("sample capsule -o capsule.xyz", "sample"),
        ("sample crust.ply", "sample"),
        ("winding crust.ply torus.ply -o winding.ply", "winding"),
    ];
    for (arguments, command) in commands {
        let report = place.json(arguments);
        assert_eq!(report["schema"], 1, "{arguments}");
        assert_eq!(report["medax"], env!("CARGO_PKG_VERSION"));
        assert_eq!(report["command"], command);
        let keys =
            |value: &Value| -> Vec<String> { value.as_object().unwrap().keys().cloned().collect() };
        let required = |value: &Value, names: &[&str]| {
            for name in names {
                assert!(keys(value).contains(&name.to_string()), "{arguments}: no {name}: {value}");
            }
        };
        required(&report["input"], &["path", "points", "duplicates", "skipped"]);
        required(&report["parameters"], &["threads", "memory_mib"]);
        let counts = ["cells", "hidden", "poles", "vertices", "faces", "edges"];
        assert_eq!(keys(&report["counts"]), counts);
        assert!(report["counts"]["vertices"].as_u64().unwrap() > 0, "{arguments}");
        for stage in report["stages"].as_array().unwrap() {
            assert!(stage["name"].is_string() && stage["wall_seconds"].as_f64().unwrap() >= 0.0);
            assert!(stage["cpu_seconds"].as_f64().unwrap() >= 0.0);
        }
        if cfg!(target_os = "linux") {
            assert!(report["peak_memory_bytes"].as_u64().unwrap() > 100_000);
        }
        assert!(report["warnings"].is_array());
        for output in report["outputs"].as_array().unwrap() {
            required(output, &["path", "topology"]);
            let names = [
                "components",
                "euler_characteristic",
                "genus",
                "boundary_loops",
                "nonmanifold_edges",
                "closed",
                "betti",
            ];
            required(&output["topology"], &names);
            assert_eq!(output["topology"]["betti"].as_array().unwrap().len(), 3);
        }
    }
    let written = ["axis.vtu", "balls.ma", "capsule.xyz", "cells.vtu", "cocone.ply", "crust.off"];
    let more = [
        "crust.ply",
        "medial.ply",
        "normals.ply",
        "poles.ply",
        "small.ply",
        "solid.vtu",
        "torus.ply",
        "winding.ply",
    ];
    assert_eq!(place.names(), [&written[..], &more].concat());
}

#[test]
fn an_empty_result_is_a_complex_and_no_points() {
    let place = Place::new();
    place.shape(Shape::Torus, "torus.ply");
    for name in ["axis.ply", "axis.obj", "axis.xyz"] {
        let report =
            place.json(&format!("medial torus.ply --theta-degrees 89.9 --rho 1e9 -o {name}"));
        assert_eq!(report["counts"]["faces"], 0);
        assert!(report["warnings"][0].as_str().unwrap().contains("the axis is empty"));
        let info = place.json(&format!("info {name}"));
        for kind in ["vertices", "faces", "edges", "cells"] {
            assert_eq!(info["counts"][kind], 0, "{name}: {kind}");
        }
        assert_eq!(info["input"]["points"], 0);
        assert_eq!((&info["bounds"], &info["topology"]["components"]), (&Value::Null, &0.into()));
        assert_eq!(info["topology"], report["outputs"][0]["topology"]);
        assert_eq!(
            (&info["self_intersecting_pairs"], &info["measure"]["area"]),
            (&0.into(), &0.0.into())
        );
        let error = place.failure(&format!("crust {name}"), 1);
        assert_eq!(error["status"], "TOO_FEW_POINTS");
        assert_eq!(error["message"], "the file holds no point");
    }
    let attributes = place.json("info axis.ply")["attributes"].clone();
    let names = attributes.as_array().unwrap().iter().map(|a| a["name"].as_str().unwrap());
    assert!(names.eq(["radius", "cell"]), "{attributes}");
}

#[test]
fn a_torus_goes_from_samples_to_a_solid() {
    let place = Place::new();
    let sampled = place.json("sample torus --seed 3 -o torus.ply");
    assert_eq!(sampled["shape"]["genus"], 1);
    assert_eq!(sampled["parameters"]["spacing"], 0.1);
    assert_eq!(sampled["parameters"]["seed"], 3);
    let points = &sampled["counts"]["vertices"];
    let options = "--shape axis.ply --side both --poles poles.ply --triangles --validate";
    let crust = place.json(&format!("crust torus.ply -o crust.ply {options}"));
    assert_eq!(&crust["input"]["points"], points);
    assert_eq!(crust["input"]["path"], "torus.ply");
    assert_eq!(crust["parameters"]["side"], "both");
    assert_eq!(crust["parameters"]["triangles"], true);
    let degrees = crust["parameters"]["deep_degrees"].as_f64().unwrap();
    assert!((degrees - 113.578_178_478_201_83).abs() < 1e-9);
    assert!(crust["validation"]["checked"].as_u64().unwrap() > 1000);
    let surface = &crust["outputs"][0];
    assert_eq!(surface["path"], "crust.ply");
    let topology = &surface["topology"];
    assert_eq!((&topology["genus"], &topology["closed"]), (&1.into(), &true.into()));
    assert_eq!(topology["betti"], serde_json::json!([1, 2, 1]));
    assert_eq!(crust["outputs"][1]["path"], "axis.ply");
    assert_eq!(crust["outputs"][2]["vertices"], crust["counts"]["poles"]);

    let info = place.json("info crust.ply");
    for key in ["components", "genus", "closed", "betti"] {
        assert_eq!(info["topology"][key], topology[key], "{key}");
    }
    assert_eq!(info["self_intersecting_pairs"], 0);
    // A polyhedron inscribed in a torus of area 15.79 and volume 3.158.
    assert!((info["measure"]["area"].as_f64().unwrap() - 15.79).abs() < 0.2);
    assert!((info["measure"]["volume"].as_f64().unwrap() - 3.158).abs() < 0.1);
    let compared = place.json("compare torus.ply crust.ply");
    let distances = &compared["distances"];
    assert!(distances["a_to_b"]["max"].as_f64().unwrap() < 1e-12);
    assert!(distances["b_to_a"]["max"].as_f64().unwrap() < 0.15);
    assert!(distances["b_to_a"]["rms"].as_f64() >= distances["b_to_a"]["mean"].as_f64());
    assert!((distances["diagonal"].as_f64().unwrap() - 4.03).abs() < 0.02);
    assert_eq!(compared["input_b"]["path"], "crust.ply");
}

#[test]
fn poles_are_rounded_where_that_is_asked_for() {
    let place = Place::new();
    place.shape(Shape::Torus, "in.ply");
    let exact = place.json("crust in.ply -o exact.ply --validate");
    let rounded = place.json("crust in.ply -o rounded.ply --round-poles --validate");
    assert_eq!(exact["parameters"]["round_poles"], false);
    assert_eq!(rounded["parameters"]["round_poles"], true);
    let topology = |report: &Value| report["outputs"][0]["topology"].clone();
    assert_eq!(topology(&exact)["genus"], 1);
    assert_eq!(topology(&rounded)["genus"], 1);
    let job = Job::default();
    let points =
        Arc::new(io::read_points(place.path("in.ply"), PointsOptions::default(), &job).unwrap());
    let options = PowerCrustOptions { round_poles: true, ..Default::default() };
    let crust = PowerCrust::build(&points, options, &job).unwrap();
    let read = |name: &str| io::read_complex(place.path(name), &job).unwrap();
    assert_eq!(read("rounded.ply").vertices(), crust.surface().vertices());
    assert_ne!(read("exact.ply").vertices(), crust.surface().vertices());
}

#[test]
fn variants_of_a_power_crust_are_told_and_written() {
    let place = Place::new();
    place.shape(Shape::Torus, "in.ply");
    let whole = place.json("crust in.ply -o whole.ply");
    assert_eq!(whole["parameters"]["lambda"], 0.0);
    let shards = place.json("crust in.ply -o shards.ply --keep-shards --validate");
    assert!(shards["counts"]["vertices"].as_u64() > whole["counts"]["vertices"].as_u64());
    let noise = place.json("crust in.ply -o noise.ply --noise --lambda 0.3 --validate");
    assert_eq!(noise["parameters"]["lambda"], 0.3);
    assert!(noise["counts"]["poles"].as_u64() < whole["counts"]["poles"].as_u64());
    let poles = place.json("poles in.ply --sharp-corners --far-box --validate");
    assert!(poles["parameters"]["lambda"].as_f64().unwrap() >= 0.4);
    let simple = place.json("crust in.ply -o simple.ply --simplify --delta 0.02 --validate");
    assert_eq!(simple["parameters"]["delta"], 0.02);
    assert!((simple["parameters"]["epsilon"].as_f64().unwrap() - 0.0403).abs() < 1e-3);
    assert!(simple["simplified"]["redundant"].as_u64().unwrap() > 100);
    let offset = place.json("crust in.ply -o offset.ply --offset -0.05 --validate");
    let area = |name: &str| {
        let info = place.json(&format!("info {name}"));
        assert_eq!(info["topology"]["closed"], true, "{name}");
        info["measure"]["area"].as_f64().unwrap()
    };
    assert_eq!(offset["parameters"]["offset"], -0.05);
    assert!(area("offset.ply") < area("whole.ply") * 0.95);
    let open = place.json("crust in.ply -o open.ply --holes --hole-degrees 90 --hole-radius 0.01");
    assert!(open["hole_faces_left_out"].is_u64() && open["parameters"]["hole_radius"] == 0.01);
}

#[test]
fn flat_tetrahedra_are_counted_and_collapsed() {
    let place = Place::new();
    place.shape(Shape::Bracket, "in.ply");
    let whole = place.json("crust in.ply --shape whole.vtu");
    assert_eq!(whole["parameters"]["flatten"], false);
    assert_eq!(whole["parameters"]["flatness"], 0.1);
    let inner = &whole["tetrahedra"]["inner"];
    assert_eq!(inner["all"], whole["outputs"][1]["cells"]);
    assert!(inner["flat"].as_u64() < inner["all"].as_u64() && inner["flat"].as_u64() > Some(100));
    assert!(whole["tetrahedra"]["outer"]["all"].as_u64() > Some(100));
    for (options, limit) in
        [("", 0.1), ("--flatness 0.01", 0.01), ("--flatness inf", f64::INFINITY)]
    {
        let flat = place.json(&format!("crust in.ply --shape flat.ply --flatten {options}"));
        assert_eq!(flat["parameters"]["flatten"], true);
        if limit.is_finite() {
            assert_eq!(flat["parameters"]["flatness"], limit);
        }
        let count = |name: &str| flat["flattened"][name].as_u64().unwrap();
        assert_eq!(count("collapsed") + count("left"), flat["tetrahedra"]["inner"]["flat"]);
        let left = inner["all"].as_u64().unwrap() - count("collapsed");
        assert_eq!(flat["outputs"][1]["cells"], left);
        assert_eq!(flat["warnings"].as_array().unwrap().len(), usize::from(left > 0));
        let betti = |report: &Value| report["outputs"][1]["topology"]["betti"].clone();
        assert_eq!(betti(&flat), betti(&whole));
    }
    let plain = place.run("crust in.ply --shape flat.ply --flatten");
    let text = crate::text(&plain.stdout);
    assert!(text.contains("tetrahedra   ") && text.contains(" flat)"), "{text}");
    assert!(text.contains("flattened    ") && text.contains(" tetrahedra collapsed"), "{text}");
}

#[test]
fn labels_come_from_a_mesh() {
    let place = Place::new();
    // A plate not much thicker than its samples are apart, from a brick of eight vertices.
    let corner = |i: u32| {
        let side = |bit: u32, half: f64| if i >> bit & 1 == 0 { -half } else { half };
        format!("{} {} {}\n", side(0, 1.0), side(1, 0.7), side(2, 0.1))
    };
    let rings = ["0 2 3 1", "4 5 7 6", "0 1 5 4", "2 6 7 3", "0 4 6 2", "1 3 7 5"];
    let off = |rings: &[String]| {
        let corners: String = (0..8).map(corner).collect();
        let faces: String = rings.iter().map(|ring| format!("4 {ring}\n")).collect();
        format!("OFF\n8 6 0\n{corners}{faces}")
    };
    place.write("plate.off", off(&rings.map(String::from)));
    let turned = rings.map(|ring| ring.split(' ').rev().collect::<Vec<_>>().join(" "));
    place.write("turned.off", off(&turned));
    place.json("sample plate.off --spacing 0.15 -o in.ply");
    let by_rule = place.json("crust in.ply -o rule.ply --labels spread");
    assert_eq!(by_rule["parameters"]["label_mesh"], Value::Null);
    let found =
        place.json("crust in.ply --label-mesh plate.off -o crust.ply --poles poles.ply --validate");
    assert_eq!(found["parameters"]["label_mesh"], "plate.off");
    assert_eq!(found["labels"]["unreached"], 0);
    let topology = &found["outputs"][0]["topology"];
    assert_eq!(topology["components"], 1);
    assert_eq!(topology["genus"], 0);
    assert_ne!(by_rule["labels"]["inner"], found["labels"]["inner"]);
    // The labels are those of the winding numbers, and an offset keeps them.
    let told = place.json("winding plate.off poles.ply -o told.ply");
    assert_eq!(told["winding"]["inside"], found["labels"]["inner"]);
    assert_eq!(told["mesh"]["path"], "plate.off");
    let offset = place.json("crust in.ply --label-mesh plate.off --offset 0.05 --validate");
    assert_eq!(offset["labels"]["inner"], found["labels"]["inner"]);
    let job = Job::default();
    let read = |name: &str| io::read_complex(place.path(name), &job).unwrap();
    let (told, mesh) = (read("told.ply"), read("plate.off"));
    let expected = mesh.winding_numbers(told.vertices(), &job).unwrap();
    let numbers = told.attribute(Element::Vertex, "winding").unwrap().values().clone();
    assert_eq!(numbers, Values::F64(expected));
    let empty = place.json("crust in.ply --label-mesh turned.off");
    assert_eq!(empty["labels"]["inner"], 0);
    let warnings = empty["warnings"].to_string();
    assert!(warnings.contains("turned inside out"), "{warnings}");
    // The input may be the mesh itself.
    place.json("crust rule.ply --label-mesh rule.ply --validate");
    let error = place.failure("crust in.ply --label-mesh in.ply", 1);
    assert_eq!(error["path"], "in.ply");
}

#[test]
fn files_hold_what_the_library_makes() {
    let place = Place::new();
    place.shape(Shape::Ellipsoid, "in.ply");
    place.json("crust in.ply -o crust.ply --shape both.ply --side both --poles poles.ply");
    place.json("crust in.ply -o cut.ply --triangles --shape outer.ply --side outer");
    let job = Job::default();
    let points =
        Arc::new(io::read_points(place.path("in.ply"), PointsOptions::default(), &job).unwrap());
    let crust = PowerCrust::build(&points, Default::default(), &job).unwrap();
    let read = |name: &str| io::read_complex(place.path(name), &job).unwrap();
    let surface = read("crust.ply");
    assert_eq!(surface.vertices(), crust.surface().vertices());
    assert_eq!(surface.faces(), crust.surface().faces());
    let cut = read("cut.ply");
    assert!(cut.faces().iter().eq(crust.surface().triangles().iter().map(|t| &t[..])));
    assert_eq!(read("outer.ply").faces(), crust.outer_shape().faces());
    let both = read("both.ply");
    let (inner, outer) = (crust.inner_shape(), crust.outer_shape());
    let split = inner.vertices().len();
    assert_eq!(&both.vertices()[..split], inner.vertices());
    assert_eq!(&both.vertices()[split..], outer.vertices());
    let half = inner.faces().len();
    assert_eq!(both.faces().len(), half + outer.faces().len());
    for (i, face) in both.faces().iter().enumerate() {
        let (from, shift) = if i < half { (inner, 0) } else { (outer, split as u32) };
        let expected = from.faces().row(if i < half { i } else { i - half });
        assert!(face.iter().zip(expected).all(|(a, b)| *a == b + shift));
    }
    let label = both.attribute(Element::Vertex, "label").unwrap();
    let expected: Vec<u32> = (0..both.vertices().len()).map(|v| u32::from(v < split)).collect();
    assert_eq!(*label.values(), medax::complex::Values::U32(expected));
    let poles = read("poles.ply");
    assert_eq!(poles.vertices().len(), crust.poles().len());
    let labels = crust.labels().iter().map(|&label| label as u32).collect();
    let label = poles.attribute(Element::Vertex, "label").unwrap();
    assert_eq!(*label.values(), medax::complex::Values::U32(labels));

    let cells = place.json("triangulate in.ply")["counts"]["cells"].clone();
    let delaunay = Triangulation::delaunay(&points, &job).unwrap();
    assert_eq!(cells, delaunay.cells().len());
    let count = place.json("poles in.ply --far-box --validate")["counts"]["poles"].clone();
    assert_eq!(count, Poles::with_far_box(&points, Default::default(), &job).unwrap().len());
}

#[test]
fn a_surface_comes_down_to_a_quarter() {
    let place = Place::new();
    place.shape(Shape::Torus, "torus.ply");
    place.json("crust torus.ply -o crust.ply");
    let report = place.json("decimate crust.ply -o small.ply --ratio 0.25");
    let before = report["triangles"]["before"].as_u64().unwrap();
    let after = report["triangles"]["after"].as_u64().unwrap();
    assert!(4 * after <= before + 3 && 4 * after + 12 > before, "{before} to {after}");
    assert_eq!(report["counts"]["faces"], after);
    let topology = &report["outputs"][0]["topology"];
    assert_eq!((&topology["genus"], &topology["closed"]), (&1.into(), &true.into()));
    let strict = place.json("decimate crust.ply --triangles 10 --max-error 0.001");
    assert!(strict["triangles"]["after"].as_u64().unwrap() > 100);
    assert_eq!(strict["warnings"].as_array().unwrap().len(), 1);
    place.failure("decimate crust.ply", 2);
    place.failure("decimate crust.ply --ratio 1.5", 2);
    place.failure("decimate crust.ply --ratio 0.5 --triangles 9", 2);
    place.failure("decimate crust.ply --ratio 0.5 --max-error -1", 2);
}

#[test]
fn weights_come_from_an_attribute() {
    let place = Place::new();
    let ply = "ply\nformat ascii 1.0\nelement vertex 7\nproperty double x\nproperty double y\n\
               property double z\nproperty double w\nend_header\n\
               0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1 1 1 0\n.1 .1 .1 0\n.4 .4 .4 -9\n";
    place.write("weighted.ply", ply);
    let hidden = |arguments: &str| place.json(arguments)["counts"]["hidden"].clone();
    assert_eq!(hidden("triangulate weighted.ply"), 0);
    assert_eq!(hidden("triangulate weighted.ply --weights w"), 1);
    // A weight above 0.36 hides the sixth point; that of a radius of 0.5 is 0.25.
    place.write("small.ply", ply.replace("-9", "0.5"));
    assert_eq!(hidden("triangulate small.ply --weights w"), 1);
    assert_eq!(hidden("triangulate small.ply --radii w"), 0);
    place.write("balls.ply", ply.replace("-9", "7"));
    let report = place.json("triangulate balls.ply --radii w --validate");
    assert_eq!(report["parameters"]["radii"], "w");
    assert_eq!(report["counts"]["hidden"], 1);
    // Whole numbers serve, too.
    place.write("whole.ply", ply.replace("-9", "7").replace("double w", "uint w"));
    let whole = place.json("triangulate whole.ply --weights w");
    assert_eq!(whole["counts"], place.json("triangulate balls.ply --weights w")["counts"]);
}

#[test]
fn left_out_rows_are_counted() {
    let place = Place::new();
    place.write("points.xyz", "0 0 0\n1 0 0\n0 1 0\nnan 2 2\n0 0 1\n1 0 0\n1 1 2\n");
    let error = place.failure("triangulate points.xyz", 1);
    assert_eq!(error["status"], "NON_FINITE");
    assert_eq!((&error["kind"], &error["index"]), (&"row".into(), &3.into()));
    assert_eq!(error["path"], "points.xyz");
    let input = place.json("triangulate points.xyz --skip-invalid")["input"].clone();
    assert_eq!((&input["points"], &input["duplicates"]), (&5.into(), &1.into()));
    assert_eq!((&input["skipped"], &input["unused"]), (&1.into(), &0.into()));
    place.write("mesh.off", "OFF\n5 1 0\n0 0 0\n1 0 0\n9 9 9\n0 1 0\n8 8 8\n3 0 1 3\n");
    let input = place.json("info mesh.off")["input"].clone();
    assert_eq!((&input["points"], &input["unused"]), (&3.into(), &2.into()));
    assert_eq!(input["skipped"], 0);
}

#[test]
fn the_order_of_rows_changes_no_byte() {
    let place = Place::new();
    let options = SampleOptions { spacing: 0.15, ..Default::default() };
    let samples = sample(Shape::Torus, options, &Job::default()).unwrap();
    let line = |p: &[f64; 3]| format!("{} {} {}\n", p[0], p[1], p[2]);
    let mut lines: Vec<String> = samples.points().iter().map(line).collect();
    place.write("a.xyz", lines.concat());
    // A few rows twice, and all of them elsewhere.
    lines.extend(lines[..20].to_vec());
    lines.reverse();
    let (one, other) = lines.split_at(lines.len() / 3);
    place.write("b.xyz", [other, one].concat().concat());
    for name in ["a", "b"] {
        let files = format!("--shape {name}.s.ply --side both --poles {name}.p.ply");
        place.json(&format!("crust {name}.xyz -o {name}.ply {files} --threads 2"));
        place.json(&format!("poles {name}.xyz -o {name}.q.ply --normals {name}.n.ply"));
    }
    for ending in ["ply", "s.ply", "p.ply", "q.ply", "n.ply"] {
        let [a, b] = ["a", "b"].map(|name| place.read(&format!("{name}.{ending}")));
        assert!(!a.is_empty() && a == b, "{ending}");
    }
}

#[test]
fn sampling_options_reach_the_library() {
    let place = Place::new();
    let report = place.json("sample genus3 --density 50 --noise 0.01 --seed 8 -o a.ply");
    let expected = sample(
        Shape::Genus3,
        SampleOptions { density: 50.0, noise: 0.01, seed: 8, ..Default::default() },
        &Job::default(),
    )
    .unwrap();
    let written = io::read_complex(place.path("a.ply"), &Job::default()).unwrap();
    assert_eq!(written.vertices(), expected.points());
    assert!(written.attribute(Element::Vertex, "normal").is_some());
    assert_eq!(report["parameters"]["spacing"], expected.spacing());
    assert_eq!(report["area"], expected.area());
    place.write("mesh.off", "OFF\n4 1 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n4 0 1 2 3\n");
    let report = place.json("sample mesh.off --spacing 0.1");
    assert!((report["area"].as_f64().unwrap() - 4.0).abs() < 0.01);
    let count = report["counts"]["vertices"].as_f64().unwrap();
    assert!((count - 0.66 * 400.0).abs() < 40.0, "{count}");
}

#[test]
fn a_spacing_that_leaves_hardly_a_sample_is_warned_of() {
    let place = Place::new();
    let warnings = |arguments: &str| place.json(arguments)["warnings"].as_array().unwrap().clone();
    let [warning] = &warnings("sample torus --spacing 1000")[..] else { panic!("no warning") };
    let warning = warning.as_str().unwrap();
    assert!(warning.contains("1 sample") && warning.contains("spacing"), "{warning}");
    assert_eq!(warnings("sample torus --density 0.1").len(), 1);
    assert!(warnings("sample torus --spacing 0.5").is_empty());
    let plain = place.run("sample torus --spacing 1000");
    assert!(crate::text(&plain.stderr).contains(warning));
}

#[test]
fn threads_and_memory_are_the_jobs() {
    let place = Place::new();
    let report = place.json("sample sphere --threads 3 --memory-mib 64");
    assert_eq!(report["parameters"]["threads"], 3);
    assert_eq!(report["parameters"]["memory_mib"], 64);
    let error = place.failure("sample torus --spacing 0.01 --memory-mib 1", 1);
    assert_eq!(error["status"], "OUT_OF_MEMORY");
}

#[test]
fn models_give_solids() {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data");
    if !data.is_dir() {
        eprintln!("skipped: {} is not there", data.display());
        return;
    }
    let place = Place::new();
    for (file, genus, components) in [("3holes.off", 3, 1), ("hotdogs.pts", 0, 2)] {
        let report = place.json(&format!("crust {}", data.join(file).display()));
        let topology = &report["outputs"][0]["topology"];
        assert_eq!(topology["closed"], true, "{file}");
        assert_eq!(topology["genus"], genus, "{file}");
        assert_eq!(topology["components"], components, "{file}");
    }
    let bunny = place.json(&format!("info {}", data.join("stanford-bunny.obj").display()));
    assert_eq!(bunny["input"]["unused"], 1113);
    assert_eq!(bunny["topology"]["boundary_edges"], 223);
    assert_eq!(bunny["topology"]["boundary_loops"], 5);
    let kinect = data.join("kinect_office_nan.ply");
    let error = place.failure(&format!("info {}", kinect.display()), 1);
    assert_eq!(error["status"], "NON_FINITE");
    let kinect = place.json(&format!("info {} --skip-invalid", kinect.display()));
    assert_eq!(kinect["input"]["skipped"], 52744);
    assert_eq!(kinect["input"]["points"], 254456);
}

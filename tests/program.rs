//! The program: its JSON, its exit codes, its files.

#![cfg(feature = "program")]

use medax::complex::Element;
use medax::points::PointsOptions;
use medax::sample::{SampleOptions, Shape, sample};
use medax::{Job, Poles, PowerCrust, Triangulation, io};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::Arc;
use tempfile::TempDir;

/// A folder of its own, in which the program runs.
struct Place(TempDir);

impl Place {
    fn new() -> Self {
        Place(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn write(&self, name: &str, bytes: impl AsRef<[u8]>) {
        fs::write(self.path(name), bytes).unwrap();
    }

    fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap()
    }

    /// The names of the files that are there now.
    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    fn command(&self, arguments: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_medax"));
        command.args(arguments.split_whitespace()).current_dir(self.0.path());
        command
    }

    fn run(&self, arguments: &str) -> Output {
        self.command(arguments).output().unwrap()
    }

    /// Runs what must succeed, silently on standard error, and reads its JSON.
    fn json(&self, arguments: &str) -> Value {
        let output = self.run(&format!("{arguments} --json"));
        assert_eq!(output.status.code(), Some(0), "{arguments}: {}", text(&output.stderr));
        assert_eq!(text(&output.stderr), "", "{arguments}");
        serde_json::from_slice(&output.stdout).unwrap()
    }

    /// Runs what must fail with this exit code, both ways, and reads the JSON's error.
    fn failure(&self, arguments: &str, code: i32) -> Value {
        let plain = self.run(arguments);
        assert_eq!(plain.status.code(), Some(code), "{arguments}: {}", text(&plain.stderr));
        assert_eq!(text(&plain.stdout), "", "{arguments}");
        let complaint = text(&plain.stderr);
        if code == 1 {
            assert_eq!(complaint.lines().count(), 1, "{complaint}");
        }
        let output = self.run(&format!("{arguments} --json"));
        assert_eq!(output.status.code(), Some(code), "{arguments}");
        assert_eq!(text(&output.stderr), "", "{arguments}");
        let object: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(object["schema"], 1);
        let error = object["error"].clone();
        for key in ["status", "message", "kind", "index", "path"] {
            assert!(error.get(key).is_some(), "{arguments}: no {key} in {error}");
        }
        // The line for people says what the object says.
        assert!(complaint.contains(error["message"].as_str().unwrap()), "{complaint} {error}");
        error
    }

    /// The built-in shape as a file.
    fn shape(&self, shape: Shape, name: &str) {
        let samples = sample(shape, SampleOptions::default(), &Job::default()).unwrap();
        let complex = samples.to_complex().unwrap();
        io::write_complex(self.path(name), &complex, Default::default(), &Job::default()).unwrap();
    }
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).unwrap()
}

#[test]
fn every_command_answers_with_the_schema() {
    let place = Place::new();
    place.shape(Shape::Torus, "torus.ply");
    place.json("crust torus.ply -o crust.ply");
    let commands = [
        ("triangulate torus.ply -o cells.vtu", "triangulate"),
        ("poles torus.ply -o poles.ply --normals normals.ply", "poles"),
        ("crust torus.ply -o crust.off --shape axis.vtu --poles balls.ma", "crust"),
        ("info torus.ply", "info"),
        ("info crust.ply", "info"),
        ("compare torus.ply crust.ply --samples 100", "compare"),
        ("sample capsule -o capsule.xyz", "sample"),
        ("sample crust.ply", "sample"),
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
    let written = ["axis.vtu", "balls.ma", "capsule.xyz", "cells.vtu", "crust.off", "crust.ply"];
    let more = ["normals.ply", "poles.ply", "torus.ply"];
    assert_eq!(place.names(), [&written[..], &more].concat());
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
    assert_eq!(count, Poles::with_far_box(&points, &job).unwrap().len());
}

#[test]
fn weights_come_from_an_attribute() {
    let place = Place::new();
    let ply = "ply\nformat ascii 1.0\nelement vertex 6\nproperty double x\nproperty double y\n\
               property double z\nproperty double w\nend_header\n\
               0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1 1 1 0\n.4 .4 .4 -9\n";
    place.write("weighted.ply", ply);
    let hidden = |arguments: &str| place.json(arguments)["counts"]["hidden"].clone();
    assert_eq!(hidden("triangulate weighted.ply"), 0);
    assert_eq!(hidden("triangulate weighted.ply --weights w"), 1);
    // As a radius its square is a weight of 81, which hides what lies round about.
    let report = place.json("triangulate weighted.ply --radii w --validate");
    assert_eq!(report["parameters"]["radii"], "w");
    assert!(report["counts"]["hidden"].as_u64() < Some(6));
    let error = place.failure("triangulate weighted.ply --weights mass", 2);
    assert!(error["message"].as_str().unwrap().contains("mass"));
}

#[test]
fn left_out_rows_are_counted() {
    let place = Place::new();
    place.write("points.xyz", "0 0 0\n1 0 0\n0 1 0\nnan 2 2\n0 0 1\n1 0 0\n1 1 2\n");
    let error = place.failure("triangulate points.xyz", 1);
    assert_eq!(error["status"], "NON_FINITE");
    assert_eq!((&error["kind"], &error["index"]), (&"row".into(), &3.into()));
    assert_eq!(error["path"], "points.xyz");
    let input = place.json("triangulate points.xyz --skip-non-finite")["input"].clone();
    assert_eq!((&input["points"], &input["duplicates"]), (&5.into(), &1.into()));
    assert_eq!((&input["skipped"], &input["unused"]), (&1.into(), &0.into()));
    place.write("mesh.off", "OFF\n5 1 0\n0 0 0\n1 0 0\n9 9 9\n0 1 0\n8 8 8\n3 0 1 3\n");
    let input = place.json("info mesh.off")["input"].clone();
    assert_eq!((&input["points"], &input["unused"]), (&3.into(), &2.into()));
    assert_eq!(input["skipped"], 0);
}

#[test]
fn bad_files_are_told_with_the_place() {
    let place = Place::new();
    place.write("word.off", "OFF\n3 1 0\n0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n");
    let error = place.failure("crust word.off -o out.ply", 1);
    assert_eq!(error["status"], "FORMAT");
    assert_eq!((&error["kind"], &error["index"]), (&"line".into(), &4.into()));
    let header = "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n\
                  property float x\nproperty float y\nproperty float z\nend_header\n";
    place.write("huge.ply", header);
    let error = place.failure("info huge.ply", 1);
    assert_eq!((&error["status"], &error["kind"]), (&"FORMAT".into(), &"byte".into()));
    place.write("empty.xyz", "");
    assert_eq!(place.failure("poles empty.xyz", 1)["status"], "FORMAT");
    assert_eq!(place.failure("info absent.ply", 1)["status"], "IO");
    let error = place.failure("crust in.ply -o nowhere/out.ply", 1);
    assert_eq!((&error["status"], &error["path"]), (&"IO".into(), &"nowhere/out.ply".into()));
    let plain = place.run("info absent.ply");
    assert_eq!(text(&plain.stderr).matches("absent.ply").count(), 1, "{}", text(&plain.stderr));
    place.write("three.xyz", "0 0 0\n1 0 0\n0 1 0\n");
    assert_eq!(place.failure("triangulate three.xyz", 1)["status"], "TOO_FEW_POINTS");
    place.write("flat.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n5 5 0\n");
    assert_eq!(place.failure("crust flat.xyz", 1)["status"], "DEGENERATE");
    place.write("huge.xyz", "0 0 0\n1e300 0 0\n");
    assert_eq!(place.failure("triangulate huge.xyz", 1)["status"], "COORDINATE_RANGE");
    place.write("sample.pdf", "what is this");
    assert_eq!(place.failure("info sample.pdf", 1)["status"], "UNSUPPORTED");
}

#[test]
fn bad_command_lines_are_refused_with_2() {
    let place = Place::new();
    place.shape(Shape::Sphere, "in.ply");
    let cases = [
        "crust",
        "solidify in.ply",
        "crust in.ply --depe 3",
        "crust in.ply --side left",
        "crust in.ply --deep-degrees 80",
        "crust in.ply --deep-degrees nan",
        "crust in.ply -o out.step",
        "crust in.ply -o out.pwn",
        "crust in.ply -o out.ply --shape out.ply",
        "triangulate in.ply --weights a --radii b",
        "sample torus --spacing 0.1 --density 5",
        "sample torus --spacing 0",
        "sample torus --density -3",
        "sample torus --noise -1",
        "sample torus --noise=-1",
        "crust in.ply --deep-degrees -100",
        "sample teapot",
        "info in.ply --threads many",
        "compare in.ply",
    ];
    for arguments in cases {
        let error = place.failure(arguments, 2);
        assert_eq!(error["status"], "INVALID_ARGUMENT", "{arguments}");
    }
    assert_eq!(place.names(), ["in.ply"]);
    for arguments in ["--help", "crust --help", "--version"] {
        let output = place.run(arguments);
        assert_eq!(output.status.code(), Some(0));
        assert!(!output.stdout.is_empty() && output.stderr.is_empty());
    }
    assert_eq!(place.run("").status.code(), Some(2));
}

#[test]
fn a_failure_leaves_old_files_as_they_are() {
    let place = Place::new();
    place.write("out.ply", "precious");
    place.write("out.stl", "precious too");
    place.write("bad.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 inf\n");
    place.failure("crust bad.xyz -o out.ply", 1);
    // The crust is built, but points have no place in an STL file.
    place.shape(Shape::Sphere, "in.ply");
    let error = place.failure("crust in.ply --poles out.stl", 1);
    assert_eq!(error["status"], "UNSUPPORTED");
    assert_eq!(place.read("out.ply"), b"precious");
    assert_eq!(place.read("out.stl"), b"precious too");
    assert_eq!(place.names(), ["bad.xyz", "in.ply", "out.ply", "out.stl"]);
    // And success replaces them.
    place.json("crust in.ply -o out.ply");
    assert!(place.read("out.ply").starts_with(b"ply\n"));
}

#[test]
fn quiet_is_quiet_and_plain_is_a_table() {
    let place = Place::new();
    // Writing XYZ loses the normals, which is worth a warning.
    let loud = place.run("sample box -o loud.xyz");
    assert_eq!(loud.status.code(), Some(0));
    let table = text(&loud.stdout);
    for word in ["box", "genus 0", "loud.xyz", "vertices", "seconds"] {
        assert!(table.contains(word), "{word} {table}");
    }
    assert!(text(&loud.stderr).starts_with("medax: warning: "), "{}", text(&loud.stderr));
    for arguments in ["sample box -o quiet.xyz --quiet", "info quiet.xyz -q"] {
        let quiet = place.run(arguments);
        assert_eq!(quiet.status.code(), Some(0));
        assert_eq!((text(&quiet.stdout), text(&quiet.stderr)), ("", ""), "{arguments}");
    }
    assert_eq!(place.read("quiet.xyz"), place.read("loud.xyz"));
    let both = place.run("info quiet.xyz --quiet --json");
    assert!(serde_json::from_slice::<Value>(&both.stdout).is_ok());
    let warned = place.json("sample box -o loud.xyz");
    assert_eq!(warned["warnings"].as_array().unwrap().len(), 1);
    let crust = place.run("crust quiet.xyz -o crust.off --shape shape.off --validate");
    let table = text(&crust.stdout);
    for word in ["closed", "genus 0", "poles", "cells", "crust.off", "shape.off", "checks hold"] {
        assert!(table.contains(word), "{word} {table}");
    }
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
fn threads_and_memory_are_the_jobs() {
    let place = Place::new();
    let report = place.json("sample sphere --threads 3 --memory-mib 64");
    assert_eq!(report["parameters"]["threads"], 3);
    assert_eq!(report["parameters"]["memory_mib"], 64);
    let error = place.failure("sample torus --spacing 0.01 --memory-mib 1", 1);
    assert_eq!(error["status"], "OUT_OF_MEMORY");
}

#[test]
fn a_reader_that_goes_away_is_no_panic() {
    let place = Place::new();
    place.shape(Shape::Sphere, "in.ply");
    for arguments in ["info in.ply", "info in.ply --json", "--help"] {
        let mut command = place.command(arguments);
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let output = command.stdout(writer).output().unwrap();
        assert_eq!(output.status.code(), Some(1), "{arguments}");
        assert_eq!(text(&output.stderr), "", "{arguments}");
    }
}

/// Signals reach the job, which stops wherever it is and leaves nothing behind.
#[cfg(unix)]
#[test]
fn a_signal_cancels_and_leaves_nothing_half_written() {
    let place = Place::new();
    place.write("out.vtu", "precious");
    let names = place.names();
    place.json("sample torus --spacing 0.01 -o torus.ply");
    let interrupt = |arguments: &str, signal: &str, is_time: &dyn Fn() -> bool| {
        let mut command = place.command(arguments);
        let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        while !is_time() {
            std::thread::yield_now();
        }
        let pid = child.id().to_string();
        assert!(Command::new("kill").args([signal, &pid]).status().unwrap().success());
        child.wait_with_output().unwrap()
    };
    // The file beside the last one is there while it is written.
    let writes = || place.names().iter().any(|name| name.ends_with(".part"));
    for (signal, json) in [("-INT", ""), ("-TERM", "--json")] {
        let output =
            interrupt(&format!("triangulate torus.ply -o out.vtu {json}"), signal, &writes);
        assert_eq!(output.status.code(), Some(1));
        if json.is_empty() {
            assert_eq!(text(&output.stderr), "medax: out.vtu: the job was cancelled\n");
        } else {
            let object: Value = serde_json::from_slice(&output.stdout).unwrap();
            assert_eq!(object["error"]["status"], "CANCELLED");
        }
        assert_eq!(place.read("out.vtu"), b"precious");
        assert_eq!(place.names(), [&names[..], &["torus.ply".to_string()]].concat());
    }
    // A pipe that nobody writes to is waited for; the second signal does not.
    let pipe = place.path("pipe.xyz");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let mut child = place.command("info pipe.xyz").stderr(Stdio::piped()).spawn().unwrap();
    let pid = child.id().to_string();
    let mut signals = 0;
    while child.try_wait().unwrap().is_none() {
        std::thread::sleep(std::time::Duration::from_millis(200));
        let _ = Command::new("kill").args(["-INT", &pid]).stderr(Stdio::null()).status();
        signals += 1;
    }
    assert!((2..20).contains(&signals), "{signals}");
    assert_eq!(child.wait().unwrap().code(), Some(130));
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
    let kinect = place.json(&format!("info {} --skip-non-finite", kinect.display()));
    assert_eq!(kinect["input"]["skipped"], 52744);
    assert_eq!(kinect["input"]["points"], 254456);
}

//! Bad files and bad command lines: what is said, the exit code, and what stays as it was.

use crate::{Place, text};
use medax::Job;
use medax::sample::{SampleOptions, Shape, sample};

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
    let error = place.failure("triangulate three.xyz", 1);
    assert_eq!((&error["status"], &error["path"]), (&"TOO_FEW_POINTS".into(), &"three.xyz".into()));
    place.write("flat.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n5 5 0\n");
    let error = place.failure("crust flat.xyz", 1);
    assert_eq!((&error["status"], &error["path"]), (&"DEGENERATE".into(), &"flat.xyz".into()));
    let report = place.json("decimate flat.xyz --ratio 0.5");
    assert_eq!(
        report["warnings"],
        serde_json::json!(["there are no faces, and nothing to decimate"])
    );
    place.write("huge.xyz", "0 0 0\n1e300 0 0\n");
    assert_eq!(place.failure("triangulate huge.xyz", 1)["status"], "COORDINATE_RANGE");
    place.write("sample.pdf", "what is this");
    assert_eq!(place.failure("info sample.pdf", 1)["status"], "UNSUPPORTED");
}

/// The authors' program makes an empty surface of a sample with one NaN and exits with 0.
#[test]
fn rows_that_are_not_finite_are_named_or_left_out_on_demand() {
    let place = Place::new();
    let samples = sample(Shape::Torus, SampleOptions::default(), &Job::default()).unwrap();
    let line = |p: &[f64; 3]| format!("{:?} {:?} {:?}\n", p[0], p[1], p[2]);
    let clean: Vec<String> = samples.points().iter().map(line).collect();
    let mut dirty = clean.clone();
    for (row, words) in [(40, "0.5 inf 0\n"), (17, "nan 2 2\n"), (900, "1 0 -inf\n")] {
        dirty.insert(row, words.to_string());
    }
    let header = format!("OFF\n{} 0 0\n", dirty.len());
    for (name, rows) in [("dirty.xyz", dirty.concat()), ("dirty.off", header + &dirty.concat())] {
        place.write(name, rows);
        let error = place.failure(&format!("crust {name} -o crust.ply"), 1);
        assert_eq!(error["status"], "NON_FINITE", "{error}");
        assert_eq!((&error["kind"], &error["index"]), (&"row".into(), &17.into()), "{error}");
        assert_eq!(error["path"], name);
        let plain = place.run(&format!("crust {name} -o crust.ply"));
        let complaint = text(&plain.stderr);
        assert!(complaint.contains(&format!("{name}: row 17: ")), "{complaint}");
    }
    assert_eq!(place.names(), ["dirty.off", "dirty.xyz"]);
    place.write("clean.xyz", clean.concat());
    let expected = place.json("crust clean.xyz -o clean.ply");
    let report = place.json("crust dirty.xyz -o crust.ply --skip-invalid");
    assert_eq!(
        (&report["input"]["skipped"], &report["input"]["duplicates"]),
        (&3.into(), &0.into())
    );
    assert_eq!(report["input"]["points"], clean.len());
    assert_eq!(report["outputs"][0]["topology"], expected["outputs"][0]["topology"]);
    assert_eq!(place.read("crust.ply"), place.read("clean.ply"));
    let table = place.run("crust dirty.off --skip-invalid");
    assert!(text(&table.stdout).contains("3 skipped rows"), "{}", text(&table.stdout));
}

#[test]
fn weights_and_radii_that_are_none_are_refused() {
    let place = Place::new();
    let ply = "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\n\
               property double z\nproperty double r\nproperty double nx\nproperty double ny\n\
               property double nz\nend_header\n\
               0 0 0 1 0 0 1\nnan 0 0 -1 0 0 1\n0 1 0 0 0 0 1\n0 0 1 -0.5 0 0 1\n1 1 1 9 0 0 1\n";
    place.write("in.ply", ply);
    let message = |arguments: &str, code| {
        let error = place.failure(arguments, code);
        assert_eq!(error["status"], "INVALID_ARGUMENT", "{error}");
        (error["message"].as_str().unwrap().to_string(), error)
    };
    let (none, _) = message("triangulate in.ply --weights mass", 2);
    assert_eq!(none, "the vertices have no numbers named 'mass'; there are: r, normal");
    let (columns, _) = message("triangulate in.ply --weights normal", 2);
    assert!(columns.contains("'normal' has 3 columns"), "{columns}");
    let (columns, _) = message("triangulate in.ply --radii normal", 2);
    assert!(columns.contains("'normal' has 3 columns"), "{columns}");
    // A row that is left out needs no radius.
    let (negative, error) = message("triangulate in.ply --radii r --skip-invalid", 1);
    assert_eq!(negative, "a radius must not be negative, and this one is -0.5");
    assert_eq!((&error["kind"], &error["index"]), (&"row".into(), &3.into()));
    assert_eq!(error["path"], "in.ply");
    place.json("triangulate in.ply --weights r --skip-invalid");
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
        "crust in.ply --lambda 0.3",
        "crust in.ply --noise --sharp-corners",
        "crust in.ply --noise --lambda 0.8",
        "poles in.ply --noise --lambda nan",
        "crust in.ply --epsilon 1",
        "crust in.ply --simplify --epsilon -1",
        "crust in.ply --offset inf",
        "crust in.ply --offset -o",
        "crust in.ply --hole-radius 1",
        "crust in.ply --holes --hole-degrees 10",
        "crust in.ply --holes --hole-radius -1",
        "crust in.ply --deep-degrees nan",
        "crust in.ply --flatten",
        "crust in.ply --shape axis.ply --flatten --flatness -1",
        "crust in.ply --flatness nan",
        "crust in.ply -o out.step",
        "crust in.ply -o out.pwn",
        "crust in.ply -o out.ply --shape out.ply",
        "crust in.ply -o out.ply --samples out.ply",
        "crust in.ply --samples out.ply --sizes-at in.ply ./out.ply",
        "crust in.ply --sizes-at in.ply",
        "crust in.ply --sizes-at in.ply out.step",
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
    let message = |arguments: &str| place.failure(arguments, 2)["message"].clone();
    let missing = "the following required arguments were not provided: <INPUT>";
    assert_eq!(message("crust"), missing);
    assert_eq!(
        message("compare --quiet"),
        "the following required arguments were not provided: <A> <B>"
    );
    assert_eq!(message("crust in.ply --sides both"), "unexpected argument '--sides' found");
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
fn one_file_under_two_names_is_refused_before_any_work() {
    let place = Place::new();
    let folder = |name: &str| std::fs::create_dir(place.path(name)).unwrap();
    folder("d");
    folder("e");
    let mut cases = vec![
        ("crust", "-o a.ply --shape ./a.ply".to_string()),
        ("crust", "-o a.ply --poles d/../a.ply".to_string()),
        ("crust", "--shape d/a.ply --poles d/../d/a.ply".to_string()),
        ("poles", format!("-o a.ply --normals {}", place.path("a.ply").display())),
    ];
    #[cfg(unix)]
    {
        let link = |to: &str, name: &str| std::os::unix::fs::symlink(to, place.path(name)).unwrap();
        place.write("there.ply", "precious");
        link("there.ply", "link.ply");
        link("../not_there.ply", "d/dangling.ply");
        link("d/dangling.ply", "twice.ply");
        link("d", "folder");
        for names in [
            "-o there.ply --shape link.ply",
            "-o link.ply --shape there.ply",
            "-o not_there.ply --shape d/dangling.ply",
            "-o d/dangling.ply --shape twice.ply",
            "-o d/a.ply --shape folder/a.ply",
        ] {
            cases.push(("crust", names.to_string()));
        }
    }
    let names = place.names();
    for (command, outputs) in cases {
        // The input is not even looked for.
        let error = place.failure(&format!("{command} absent.ply {outputs}"), 2);
        let message = error["message"].as_str().unwrap();
        assert!(message.contains("is named as two outputs"), "{outputs}: {message}");
    }
    assert_eq!(place.names(), names);
    // One name in two folders is two files.
    place.shape(Shape::Sphere, "in.ply");
    place.json("crust in.ply -o d/a.ply --shape e/a.ply");
    assert!(place.path("d/a.ply").is_file() && place.path("e/a.ply").is_file());
}

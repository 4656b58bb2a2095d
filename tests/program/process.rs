//! Streams and signals.

use crate::{Place, text};
use medax::sample::Shape;
use serde_json::Value;
use std::process::{Command, Stdio};

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
    // The values stand below each other, however long the words before them.
    place.json("crust quiet.xyz -o mesh.ply");
    for arguments in ["info mesh.ply", "info quiet.xyz", "sample box"] {
        let table = place.run(arguments);
        let table = text(&table.stdout);
        let column = |line: &str| {
            let blank = line.find(' ').unwrap();
            blank + line[blank..].find(|c| c != ' ').unwrap()
        };
        let columns: Vec<usize> = table.lines().map(column).collect();
        assert!(columns.iter().all(|&c| c == columns[0]), "{table}");
    }
    let crust = place.run("crust quiet.xyz -o crust.off --shape shape.off --validate");
    let table = text(&crust.stdout);
    for word in ["closed", "genus 0", "poles", "cells", "crust.off", "shape.off", "checks hold"] {
        assert!(table.contains(word), "{word} {table}");
    }
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

//! The program: its JSON, its exit codes, its files.

#![cfg(feature = "program")]

mod axes;
mod field;
mod flow;
mod pair;
mod process;
mod refusals;
mod results;
mod sizes;
mod union;

use medax::sample::{SampleOptions, Shape, sample};
use medax::{Complex, Job, io};
use serde_json::Value;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};
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

    fn complex(&self, name: &str) -> Complex {
        io::read_complex(self.path(name), &Job::default()).unwrap()
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
        // The lines for people say what the object says in one.
        let message = error["message"].as_str().unwrap();
        let words = complaint.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(words.contains(message) && !message.contains('\n'), "{complaint} {error}");
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

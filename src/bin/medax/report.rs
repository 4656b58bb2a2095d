//! What a command found, as one JSON object or as a table.

use crate::session::{Failure, Session};
use medax::complex::{Element, Topology};
use medax::figure::Figure;
use medax::io::Soup;
use medax::points::Points;
use medax::{Complex, NONE, StageTime, Status};
use serde_json::{Map, Value, json};
use std::fmt::Write as _;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// The version of the JSON object's layout.
const SCHEMA: u32 = 1;

/// The points that a command worked on.
#[derive(Default)]
pub struct Input {
    path: Option<PathBuf>,
    points: Option<u64>,
    duplicates: Option<u64>,
    skipped: Option<u64>,
    unused: Option<u64>,
}

impl Input {
    /// The points of a file.
    pub fn of_points(path: &Path, soup: &Soup, points: &Points) -> Self {
        let left_out = |&(row, vertex): &(&[f64; 3], &u32)| {
            *vertex == NONE && row.iter().all(|x| x.is_finite())
        };
        let unused = soup.vertices().iter().zip(points.vertex_of_row()).filter(left_out).count();
        Input {
            path: Some(path.to_path_buf()),
            points: Some(points.len() as u64),
            duplicates: Some(points.duplicate_count() as u64),
            skipped: Some((points.skipped_count() - unused) as u64),
            unused: Some(unused as u64),
        }
    }

    /// A mesh of which only the vertices that its faces and edges use are taken.
    pub fn of_mesh(path: &Path, complex: &Complex, unused: usize) -> Self {
        Input { unused: Some(unused as u64), ..Input::of_complex(path, complex) }
    }

    /// A plane figure.
    pub fn of_figure(path: &Path, figure: &Figure) -> Self {
        let points = Some(figure.vertices().len() as u64);
        Input { path: Some(path.to_path_buf()), points, ..Input::default() }
    }

    /// A file that is taken as it is.
    pub fn of_complex(path: &Path, complex: &Complex) -> Self {
        let points = Some(complex.vertices().len() as u64);
        Input { path: Some(path.to_path_buf()), points, ..Input::default() }
    }

    pub fn json(&self) -> Value {
        json!({
            "path": self.path.as_ref().map(|path| path.to_string_lossy()),
            "points": self.points,
            "duplicates": self.duplicates,
            "skipped": self.skipped,
            "unused": self.unused,
        })
    }

    fn line(&self) -> String {
        let mut line = format!("{} points", self.points.unwrap_or(0));
        let more = [
            ("duplicate rows", self.duplicates),
            ("skipped rows", self.skipped),
            ("unused rows", self.unused),
        ];
        for (name, count) in more {
            if let Some(count @ 1..) = count {
                let _ = write!(line, ", {count} {name}");
            }
        }
        line
    }
}

/// How many elements there are; `None` where the word has no meaning.
#[derive(Clone, Copy, Default)]
pub struct Counts {
    pub cells: Option<u64>,
    pub hidden: Option<u64>,
    pub poles: Option<u64>,
    pub vertices: Option<u64>,
    pub faces: Option<u64>,
    pub edges: Option<u64>,
}

impl From<&Complex> for Counts {
    fn from(complex: &Complex) -> Self {
        let count = |element| Some(complex.element_count(element) as u64);
        Counts {
            cells: count(Element::Cell),
            vertices: count(Element::Vertex),
            faces: count(Element::Face),
            edges: count(Element::Edge),
            ..Counts::default()
        }
    }
}

impl Counts {
    fn named(&self) -> [(&'static str, Option<u64>); 6] {
        [
            ("cells", self.cells),
            ("hidden", self.hidden),
            ("poles", self.poles),
            ("vertices", self.vertices),
            ("faces", self.faces),
            ("edges", self.edges),
        ]
    }

    fn line(&self) -> String {
        let known = self.named().into_iter().filter_map(|(name, count)| match count {
            Some(0) | None => None,
            Some(count) => Some(format!("{count} {name}")),
        });
        known.collect::<Vec<_>>().join(", ")
    }
}

/// A result, written or only described.
pub struct Output {
    pub name: &'static str,
    pub path: Option<PathBuf>,
    pub counts: Counts,
    pub topology: Topology,
}

impl Output {
    fn json(&self) -> Value {
        json!({
            "name": self.name,
            "path": self.path.as_ref().map(|path| path.to_string_lossy()),
            "cells": self.counts.cells,
            "vertices": self.counts.vertices,
            "faces": self.counts.faces,
            "edges": self.counts.edges,
            "topology": topology_json(&self.topology),
        })
    }

    fn line(&self) -> String {
        let mut line = self.counts.line();
        let topology = topology_line(&self.topology);
        if !topology.is_empty() {
            let _ = write!(line, "; {topology}");
        }
        if let Some(path) = &self.path {
            let _ = write!(line, " -> {}", path.display());
        }
        line
    }
}

/// The topology with the names that scripts rely on.
pub fn topology_json(topology: &Topology) -> Value {
    json!({
        "components": topology.components,
        "euler_characteristic": topology.euler_characteristic,
        "genus": topology.genus,
        "boundary_loops": topology.boundary_loops,
        "boundary_edges": topology.boundary_edges,
        "nonmanifold_edges": topology.nonmanifold_edges,
        "nonmanifold_vertices": topology.nonmanifold_vertices,
        "isolated_vertices": topology.isolated_vertices,
        "closed": topology.closed,
        "oriented": topology.oriented,
        "betti": topology.betti,
    })
}

/// The topology in a few words; nothing for what has no edges.
pub fn topology_line(topology: &Topology) -> String {
    if topology.edges == 0 {
        return String::new();
    }
    let counted = |count: u64, one: &str, many: &str| match count {
        1 => format!("1 {one}"),
        count => format!("{count} {many}"),
    };
    let mut words = vec![counted(topology.components, "component", "components")];
    if topology.closed {
        words.push("closed".into());
    }
    if let Some(genus) = topology.genus {
        words.push(format!("genus {genus}"));
    }
    if topology.boundary_edges > 0 && topology.nonmanifold_edges == 0 {
        words.push(counted(topology.boundary_loops, "boundary loop", "boundary loops"));
    }
    if topology.nonmanifold_edges > 0 {
        words.push(counted(topology.nonmanifold_edges, "non-manifold edge", "non-manifold edges"));
    }
    let [b0, b1, b2] = topology.betti;
    words.push(format!("Betti numbers {b0} {b1} {b2}"));
    words.join(", ")
}

/// All that a command has to say.
#[derive(Default)]
pub struct Report {
    pub command: &'static str,
    pub input: Input,
    /// Every option in effect, besides the common ones.
    pub parameters: Map<String, Value>,
    pub counts: Counts,
    pub outputs: Vec<Output>,
    /// Keys of this command only.
    pub more: Map<String, Value>,
    /// Lines of the table for them.
    pub lines: Vec<(&'static str, String)>,
}

impl Report {
    /// Prints the report and gives the exit code.
    pub fn print(&self, session: &Session, json: bool, quiet: bool) -> ExitCode {
        let text = match (json, quiet) {
            (true, _) => format!("{}\n", self.json(session)),
            (false, true) => return ExitCode::SUCCESS,
            (false, false) => {
                for warning in session.warnings() {
                    complain(&format!("medax: warning: {warning}"));
                }
                self.table(session)
            }
        };
        match put(&text) {
            true => ExitCode::SUCCESS,
            false => ExitCode::FAILURE,
        }
    }

    fn json(&self, session: &Session) -> Value {
        let mut parameters = session.parameters();
        parameters.extend(self.parameters.clone());
        let counts: Map<String, Value> =
            self.counts.named().into_iter().map(|(name, n)| (name.into(), json!(n))).collect();
        let stage = |time: &StageTime| {
            json!({
                "name": time.stage.name(),
                "wall_seconds": time.wall_seconds,
                "cpu_seconds": time.cpu_seconds,
            })
        };
        let mut object = json!({
            "schema": SCHEMA,
            "medax": env!("CARGO_PKG_VERSION"),
            "command": self.command,
            "input": self.input.json(),
            "parameters": parameters,
            "counts": counts,
            "stages": stages(session).iter().map(stage).collect::<Vec<_>>(),
            "peak_memory_bytes": peak_memory(),
            "outputs": self.outputs.iter().map(Output::json).collect::<Vec<_>>(),
            "warnings": session.warnings(),
        });
        if let Value::Object(object) = &mut object {
            object.extend(self.more.clone());
        }
        object
    }

    fn table(&self, session: &Session) -> String {
        let mut rows: Vec<(&str, String)> = Vec::new();
        if let Some(path) = &self.input.path {
            rows.push(("input", path.display().to_string()));
            rows.push(("", self.input.line()));
        }
        rows.push(("counts", self.counts.line()));
        rows.extend(self.lines.iter().cloned());
        rows.extend(self.outputs.iter().map(|output| (output.name, output.line())));
        let times = stages(session);
        let total: f64 = times.iter().map(|time| time.wall_seconds).sum();
        let slow = times.iter().filter(|time| time.wall_seconds >= 0.01);
        let stages: Vec<String> =
            slow.map(|time| format!("{} {:.2}", time.stage.name(), time.wall_seconds)).collect();
        let stages =
            if stages.is_empty() { String::new() } else { format!(": {}", stages.join(", ")) };
        rows.push(("seconds", format!("{total:.2}{stages}")));
        if let Some(bytes) = peak_memory() {
            rows.push(("memory", format!("{} MiB", bytes.div_ceil(1 << 20))));
        }
        let mut text = String::new();
        rows.retain(|(_, value)| !value.is_empty());
        let width = rows.iter().map(|(name, _)| name.len()).fold(12, usize::max);
        for (name, value) in rows {
            let _ = writeln!(text, "{name:<width$} {value}");
        }
        text
    }
}

impl Failure {
    /// Prints the failure and gives the exit code.
    pub fn print(&self, json: bool) -> ExitCode {
        let path = self.path.as_ref().map(|path| path.display().to_string());
        if json {
            let element = self.error.element();
            put_error(json!({
                "status": self.error.status().name(),
                "message": self.error.message(),
                "kind": element.map(|(kind, _)| kind.name()),
                "index": element.map(|(_, index)| index),
                "path": path,
            }));
        } else {
            let about = path.map_or(String::new(), |path| format!("{path}: "));
            complain(&format!("medax: {about}{}", self.error));
        }
        ExitCode::from(if self.usage { 2 } else { 1 })
    }
}

/// Answers a command line that clap refuses, or one that asks for help.
pub fn refuse(error: &clap::Error) -> ExitCode {
    let text = error.render().to_string();
    if !error.use_stderr() {
        return if put(&text) { ExitCode::SUCCESS } else { ExitCode::FAILURE };
    }
    if std::env::args_os().any(|argument| argument == "--json") {
        // The first paragraph; what it may have meant and the usage follow.
        let lines = text.lines().take_while(|line| !line.trim().is_empty()).map(str::trim);
        let paragraph = lines.collect::<Vec<_>>().join(" ");
        let message = paragraph.trim_start_matches("error: ");
        let status = Status::InvalidArgument.name();
        put_error(json!({
            "status": status,
            "message": message,
            "kind": null,
            "index": null,
            "path": null,
        }));
    } else {
        complain(text.trim_end());
    }
    ExitCode::from(2)
}

fn put_error(error: Value) {
    put(&format!("{}\n", json!({ "schema": SCHEMA, "error": error })));
}

/// The time of each stage, all its turns together, in the order of the first ones.
fn stages(session: &Session) -> Vec<StageTime> {
    let mut stages: Vec<StageTime> = Vec::new();
    for time in session.job.times() {
        match stages.iter_mut().find(|known| known.stage == time.stage) {
            Some(known) => {
                known.wall_seconds += time.wall_seconds;
                known.cpu_seconds += time.cpu_seconds;
            }
            None => stages.push(time),
        }
    }
    stages
}

/// Writes to standard output. A reader that has gone away is no reason to panic.
fn put(text: &str) -> bool {
    let mut out = std::io::stdout().lock();
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).is_ok()
}

/// Writes a line to standard error, if there is anyone to read it.
fn complain(line: &str) {
    let _ = writeln!(std::io::stderr().lock(), "{line}");
}

/// The most memory that the process has had, where the system tells.
fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kib: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kib * 1024)
}

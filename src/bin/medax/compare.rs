//! `medax compare`: how far two surfaces are apart.

use crate::report::{Counts, Input, Report};
use crate::session::{Failure, Session};
use medax::complex::{CompareOptions, Distances, compare};
use serde_json::{Map, Value, json};
use std::path::PathBuf;

/// Measure how far two meshes or point sets are apart, both ways
#[derive(clap::Args)]
pub struct Options {
    /// The first file
    a: PathBuf,
    /// The second file
    b: PathBuf,
    /// How many points of each side are measured besides its vertices
    #[arg(long, value_name = "N", default_value_t = CompareOptions::default().samples)]
    samples: usize,
    /// Which points: the same seed takes the same
    #[arg(long, value_name = "N", default_value_t = CompareOptions::default().seed)]
    seed: u64,
}

pub fn run(options: &Options, session: &mut Session) -> Result<Report, Failure> {
    let a = session.read_complex(&options.a)?;
    let b = session.read_complex(&options.b)?;
    let asked = CompareOptions { samples: options.samples, seed: options.seed };
    let found = compare(&a, &b, &asked, &session.job)?;
    let mut parameters = Map::new();
    parameters.insert("samples".into(), json!(options.samples));
    parameters.insert("seed".into(), json!(options.seed));
    let mut more = Map::new();
    more.insert("input_b".into(), Input::of_complex(&options.b, &b).json());
    more.insert(
        "distances".into(),
        json!({
            "a_to_b": distances_json(&found.a_to_b),
            "b_to_a": distances_json(&found.b_to_a),
            "diagonal": found.diagonal,
        }),
    );
    let line = |d: &Distances| {
        let share = |x: f64| 100.0 * x / found.diagonal;
        format!(
            "max {:.6e} ({:.4} % of the diagonal), mean {:.6e}, rms {:.6e}",
            d.max,
            share(d.max),
            d.mean,
            d.rms
        )
    };
    Ok(Report {
        command: "compare",
        input: Input::of_complex(&options.a, &a),
        parameters,
        counts: Counts::from(&a),
        lines: vec![
            ("second", options.b.display().to_string()),
            ("a to b", line(&found.a_to_b)),
            ("b to a", line(&found.b_to_a)),
            ("diagonal", format!("{:.6e}", found.diagonal)),
        ],
        more,
        outputs: Vec::new(),
    })
}

fn distances_json(distances: &Distances) -> Value {
    json!({ "max": distances.max, "mean": distances.mean, "rms": distances.rms })
}

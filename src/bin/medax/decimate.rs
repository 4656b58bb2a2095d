//! `medax decimate`: fewer triangles for the same surface.

use crate::report::{Counts, Input, Report};
use crate::session::{Failure, OutputOptions, Session};
use medax::complex::DecimateOptions;
use serde_json::json;
use std::path::PathBuf;

/// Reduce a surface to fewer triangles, keeping its topology
#[derive(clap::Args)]
#[command(group(clap::ArgGroup::new("aim").required(true).args(["ratio", "triangles"])))]
pub struct Options {
    /// The file of a mesh
    input: PathBuf,
    #[command(flatten)]
    output: OutputOptions,
    /// Come down to this share of the triangles, from 0 to 1
    #[arg(long, allow_hyphen_values = true, value_name = "SHARE")]
    ratio: Option<f64>,
    /// Come down to so many triangles; 0 means as few as can be
    #[arg(long, value_name = "N")]
    triangles: Option<usize>,
    /// Never come further away from the surface than this, in the units of the file
    #[arg(long, allow_hyphen_values = true, value_name = "LENGTH")]
    max_error: Option<f64>,
}

pub fn run(options: &Options, session: &mut Session) -> Result<Report, Failure> {
    options.output.check(&[])?;
    if let Some(ratio) = options.ratio.filter(|ratio| !(0.0..=1.0).contains(ratio)) {
        return Err(Failure::usage(format!("--ratio must lie between 0 and 1, not {ratio:?}")));
    }
    if let Some(limit) = options.max_error.filter(|&limit| limit.is_nan() || limit < 0.0) {
        return Err(Failure::usage(format!("--max-error must not be negative, and is {limit:?}")));
    }
    let complex = session.read_complex(&options.input)?;
    let before = complex.triangles().len();
    if before == 0 {
        session.warn("there are no faces, and nothing to decimate");
    }
    let aim = match (options.ratio, options.triangles) {
        (Some(ratio), _) => (ratio * before as f64).ceil() as usize,
        (None, triangles) => triangles.unwrap_or(0),
    };
    let asked = DecimateOptions { triangles: aim, max_error: options.max_error };
    let surface = complex.decimate(asked, &session.job)?;
    let after = surface.triangles().len();
    if after > aim && options.triangles != Some(0) {
        session.warn(&format!("{after} triangles are left, and not {aim}: no other edge may go"));
    }
    let mut report = Report {
        command: "decimate",
        input: Input::of_complex(&options.input, &complex),
        counts: Counts::from(&surface),
        lines: vec![("triangles", format!("{after} of {before}"))],
        ..Report::default()
    };
    options.output.describe(&mut report.parameters);
    for (name, value) in [
        ("ratio", json!(options.ratio)),
        ("triangles", json!(aim)),
        ("max_error", json!(options.max_error)),
    ] {
        report.parameters.insert(name.into(), value);
    }
    report.more.insert("triangles".into(), json!({ "before": before, "after": after }));
    let path = options.output.output.as_deref();
    report.outputs.push(session.deliver("surface", &surface, path, &options.output)?);
    Ok(report)
}

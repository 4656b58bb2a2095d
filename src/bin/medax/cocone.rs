//! `medax cocone`: surfaces through the samples, made of Delaunay triangles.

use crate::report::{Counts, Report};
use crate::session::{Failure, OutputOptions, ReadOptions, Session, ValidateOptions};
use medax::cocone::CoconeOptions;
use medax::dual::{Dual, DualOptions};
use medax::{Cocone, Triangulation};
use serde_json::json;
use std::f64::consts::PI;
use std::path::PathBuf;
use std::sync::Arc;

/// Build a watertight surface of Delaunay triangles through the samples (Tight Cocone)
#[derive(clap::Args)]
pub struct Options {
    /// A file of points; of a mesh the vertices that it uses
    input: PathBuf,
    #[command(flatten)]
    read: ReadOptions,
    #[command(flatten)]
    output: OutputOptions,
    /// Write the surface of Cocone alone, open where the sample is too sparse
    #[arg(long)]
    cocone_only: bool,
    /// How far from the tangent plane at a sample a Voronoi edge of the surface may pass
    #[arg(long, allow_hyphen_values = true, value_name = "DEGREES", default_value_t = 22.5)]
    angle_degrees: f64,
    /// Of a sample that is dense enough the poles are at least so many times as far as the corners of its tangent polygon
    #[arg(long, allow_hyphen_values = true, value_name = "RATIO", default_value_t = 1.2)]
    ratio: f64,
    /// The largest angle between the normals of neighbours that are dense enough
    #[arg(long, allow_hyphen_values = true, value_name = "DEGREES", default_value_t = 30.0)]
    normal_degrees: f64,
    #[command(flatten)]
    validate: ValidateOptions,
}

pub fn run(options: &Options, session: &mut Session) -> Result<Report, Failure> {
    options.output.check(&[])?;
    let degrees = |name: &str, degrees: f64| match degrees > 0.0 && degrees < 90.0 {
        true => Ok(degrees * (PI / 180.0)),
        false => {
            Err(Failure::usage(format!("--{name} must lie between 0 and 90, not {degrees:?}")))
        }
    };
    let asked = CoconeOptions {
        angle: degrees("angle-degrees", options.angle_degrees)?,
        ratio: options.ratio,
        normal_angle: degrees("normal-degrees", options.normal_degrees)?,
    };
    let soup = session.read(&options.input)?;
    let (points, input) = session.points(&options.input, &soup, &options.read)?;
    drop(soup);
    let triangulation = Arc::new(Triangulation::delaunay(&points, &session.job)?);
    let dual = Arc::new(Dual::new(&triangulation, DualOptions::default(), &session.job)?);
    let cocone = Cocone::new(&dual, asked, &session.job)?;
    let mut report = Report { command: "cocone", input, ..Report::default() };
    options.read.describe(&mut report.parameters);
    options.output.describe(&mut report.parameters);
    for (name, value) in [
        ("cocone_only", json!(options.cocone_only)),
        ("angle_degrees", json!(options.angle_degrees)),
        ("ratio", json!(options.ratio)),
        ("normal_degrees", json!(options.normal_degrees)),
    ] {
        report.parameters.insert(name.into(), value);
    }
    options.validate.report(&mut report, || cocone.validate(&session.job))?;
    let samples = cocone.is_undersampled().len();
    let undersampled = cocone.is_undersampled().iter().filter(|&&under| under).count();
    let inner = cocone.is_inner().iter().filter(|&&inner| inner).count();
    let more = json!({
        "undersampled": undersampled,
        "used": cocone.used(),
        "used_share": cocone.used_share(),
        "inner_cells": inner,
        "marked_cells": cocone.marked(),
    });
    report.more.insert("cocone".into(), more);
    let line = format!("{} of {samples}, {undersampled} of all undersampled", cocone.used());
    report.lines.push(("samples used", line));
    let (name, surface) = match options.cocone_only {
        true => ("open surface", cocone.open_surface()),
        false => ("surface", cocone.surface()),
    };
    report.counts =
        Counts { cells: Some(triangulation.cells().len() as u64), ..Counts::from(&**surface) };
    let path = options.output.output.as_deref();
    report.outputs.push(session.deliver(name, surface, path, &options.output)?);
    Ok(report)
}

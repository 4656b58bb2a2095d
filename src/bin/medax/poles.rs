//! `medax poles`: the poles of a sample, and its normals.

use crate::omit::OmitOptions;
use crate::report::{Counts, Report};
use crate::session::{Failure, OutputOptions, ReadOptions, Session, ValidateOptions};
use medax::dual::{Dual, DualOptions};
use medax::{NONE, Poles, Triangulation};
use serde_json::json;
use std::path::PathBuf;
use std::sync::Arc;

/// Find the poles of a sample: the farthest Voronoi vertices on both sides of the surface
#[derive(clap::Args)]
pub struct Options {
    /// A file of points; of a mesh the vertices that it uses
    input: PathBuf,
    #[command(flatten)]
    read: ReadOptions,
    #[command(flatten)]
    output: OutputOptions,
    /// Where to write the samples with the normals that the poles give
    #[arg(long, value_name = "FILE")]
    normals: Option<PathBuf>,
    /// Choose among the Voronoi vertices of the sample and the corners of a far box, as the power
    /// crust does; without it the pole of an unbounded cell lies at infinity
    #[arg(long)]
    far_box: bool,
    #[command(flatten)]
    omit: OmitOptions,
    #[command(flatten)]
    validate: ValidateOptions,
}

pub fn run(options: &Options, session: &mut Session) -> Result<Report, Failure> {
    options.output.check(&[&options.normals])?;
    let soup = session.read(&options.input)?;
    let (points, input) = session.points(&options.input, &soup, &options.read)?;
    drop(soup);
    let mut report = Report { command: "poles", input, ..Report::default() };
    options.read.describe(&mut report.parameters);
    options.output.describe(&mut report.parameters);
    report.parameters.insert("far_box".into(), json!(options.far_box));
    let poles = match options.far_box {
        true => Poles::with_far_box(&points, options.omit.translate()?, &session.job)?,
        false => {
            let triangulation = Arc::new(Triangulation::delaunay(&points, &session.job)?);
            report.counts.cells = Some(triangulation.cells().len() as u64);
            let dual = Dual::new(&triangulation, DualOptions::default(), &session.job)?;
            Poles::new(&dual, options.omit.translate()?, &session.job)?
        }
    };
    options.validate.report(&mut report, || poles.validate(&session.job))?;
    options.omit.report(&mut report, &poles);
    let complex = poles.to_complex()?;
    let count = |wanted: fn(&&[u32; 2]) -> bool| {
        poles.pole_of_sample().iter().filter(wanted).count() as u64
    };
    let first_missing = count(|pair| pair[0] == NONE);
    let second_missing = count(|pair| pair[1] == NONE);
    report.counts = Counts {
        poles: Some(poles.len() as u64),
        cells: report.counts.cells,
        ..Counts::from(&complex)
    };
    let missing = json!({ "first": first_missing, "second": second_missing });
    report.more.insert("samples_without_finite_pole".into(), missing);
    if first_missing + second_missing > 0 {
        let line = format!("{first_missing} first and {second_missing} second poles");
        report.lines.push(("at infinity or left out", line));
    }
    let path = options.output.output.as_deref();
    report.outputs.push(session.deliver("poles", &complex, path, &options.output)?);
    if let Some(path) = &options.normals {
        let samples = poles.samples_to_complex()?;
        report.outputs.push(session.deliver("normals", &samples, Some(path), &options.output)?);
    }
    Ok(report)
}

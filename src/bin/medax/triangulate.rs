//! `medax triangulate`: Delaunay and regular triangulations.

use crate::report::{Counts, Report};
use crate::session::{Failure, OutputOptions, ReadOptions, Session, ValidateOptions};
use medax::Triangulation;
use medax::complex::{Element, Values};
use medax::io::Soup;
use serde_json::json;
use std::path::PathBuf;

/// Build the Delaunay triangulation of points, or the regular triangulation of weighted points
#[derive(clap::Args)]
pub struct Options {
    /// A file of points; of a mesh the vertices that it uses
    input: PathBuf,
    #[command(flatten)]
    read: ReadOptions,
    #[command(flatten)]
    output: OutputOptions,
    /// The vertex attribute of the file that holds the points' weights (squared lengths)
    #[arg(long, value_name = "NAME", conflicts_with = "radii")]
    weights: Option<String>,
    /// The vertex attribute that holds radii, whose squares are the weights
    #[arg(long, value_name = "NAME")]
    radii: Option<String>,
    #[command(flatten)]
    validate: ValidateOptions,
}

pub fn run(options: &Options, session: &mut Session) -> Result<Report, Failure> {
    options.output.check(&[])?;
    let soup = session.read(&options.input)?;
    let weights = match (&options.weights, &options.radii) {
        (Some(name), _) => Some(values(&soup, name)?.to_vec()),
        (_, Some(name)) => {
            Some(values(&soup, name)?.iter().map(|radius| radius * radius).collect())
        }
        (None, None) => None,
    };
    let (points, input) = session.points(&options.input, &soup, &options.read)?;
    drop(soup);
    let triangulation = match weights {
        Some(weights) => Triangulation::regular(&points, &weights, &session.job)?,
        None => Triangulation::delaunay(&points, &session.job)?,
    };
    let mut report = Report { command: "triangulate", input, ..Report::default() };
    options.read.describe(&mut report.parameters);
    options.output.describe(&mut report.parameters);
    report.parameters.insert("weights".into(), json!(options.weights));
    report.parameters.insert("radii".into(), json!(options.radii));
    options.validate.report(&mut report, || triangulation.validate(&session.job))?;
    let complex = triangulation.to_complex()?;
    report.counts =
        Counts { hidden: Some(triangulation.hidden().len() as u64), ..Counts::from(&complex) };
    let path = options.output.output.as_deref();
    let output = session.deliver("cells", &complex, path, &options.output)?;
    report.outputs.push(output);
    Ok(report)
}

/// The one number that each row of the file has under this name.
fn values<'a>(soup: &'a Soup, name: &str) -> Result<&'a [f64], Failure> {
    let on_vertices = || soup.attributes().iter().filter(|a| a.element() == Element::Vertex);
    let found = on_vertices().find(|a| a.name() == name && a.width() == 1);
    match found.map(|attribute| attribute.values()) {
        Some(Values::F64(values)) => Ok(values),
        _ => {
            let names: Vec<&str> = on_vertices().map(|attribute| attribute.name()).collect();
            let names = if names.is_empty() { "none".into() } else { names.join(", ") };
            let message =
                format!("the vertices have no numbers named '{name}'; there are: {names}");
            Err(Failure::usage(message))
        }
    }
}

//! `medax triangulate`: Delaunay and regular triangulations.

use crate::report::{Counts, Report};
use crate::session::{Failure, OutputOptions, ReadOptions, Session, ValidateOptions};
use medax::complex::{Element, Values};
use medax::io::Soup;
use medax::points::Points;
use medax::{ElementKind, Error, NONE, Status, Triangulation};
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
    let mut weights = match options.weights.as_ref().or(options.radii.as_ref()) {
        Some(name) => Some(values(&soup, name)?),
        None => None,
    };
    let (points, input) = session.points(&options.input, &soup, &options.read)?;
    drop(soup);
    if let (Some(radii), Some(_)) = (&mut weights, &options.radii) {
        square(radii, &points).map_err(Failure::about(&options.input))?;
    }
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
fn values(soup: &Soup, name: &str) -> Result<Vec<f64>, Failure> {
    let on_vertices = || soup.attributes().iter().filter(|a| a.element() == Element::Vertex);
    let Some(found) = on_vertices().find(|attribute| attribute.name() == name) else {
        let names: Vec<&str> = on_vertices().map(|attribute| attribute.name()).collect();
        let names = if names.is_empty() { "none".into() } else { names.join(", ") };
        let message = format!("the vertices have no numbers named '{name}'; there are: {names}");
        return Err(Failure::usage(message));
    };
    if found.width() != 1 {
        let width = found.width();
        let message = format!("'{name}' has {width} columns, and one number a vertex is needed");
        return Err(Failure::usage(message));
    }
    Ok(match found.values() {
        Values::F64(values) => values.clone(),
        Values::U32(values) => values.iter().map(|&value| value.into()).collect(),
    })
}

/// Makes weights of radii. Rows that no point is made of may hold anything.
fn square(radii: &mut [f64], points: &Points) -> Result<(), Error> {
    for (row, (radius, &vertex)) in radii.iter_mut().zip(points.vertex_of_row()).enumerate() {
        if *radius < 0.0 && vertex != NONE {
            let message = format!("a radius must not be negative, and this one is {radius:?}");
            let error = Error::new(Status::InvalidArgument, message);
            return Err(error.at(ElementKind::Row, row as u64));
        }
        *radius *= *radius;
    }
    Ok(())
}

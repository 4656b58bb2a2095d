//! `medax winding`: how often a mesh winds round points.

use crate::report::{Input, Report};
use crate::session::{Failure, OutputOptions, ReadOptions, Session};
use medax::Complex;
use medax::complex::{Attribute, ComplexParts, Element, Values};
use serde_json::json;
use std::path::PathBuf;

/// Tell for every point how often the faces of a mesh wind round it: once inside, not at all outside
#[derive(clap::Args)]
pub struct Options {
    /// The mesh; its faces must point out of the solid
    mesh: PathBuf,
    /// A file of points; of a mesh the vertices that it uses
    points: PathBuf,
    #[command(flatten)]
    read: ReadOptions,
    #[command(flatten)]
    output: OutputOptions,
}

pub fn run(options: &Options, session: &mut Session) -> Result<Report, Failure> {
    options.output.check(&[])?;
    let mesh = session.read_complex(&options.mesh)?;
    let soup = session.read(&options.points)?;
    let (points, input) = session.points(&options.points, &soup, &options.read)?;
    drop(soup);
    let numbers = mesh
        .winding_numbers(points.coords(), &session.job)
        .map_err(Failure::about(&options.mesh))?;
    let mut report = Report { command: "winding", input, ..Report::default() };
    options.read.describe(&mut report.parameters);
    options.output.describe(&mut report.parameters);
    report.more.insert("mesh".into(), Input::of_complex(&options.mesh, &mesh).json());
    let inside = numbers.iter().filter(|&&number| number > 0.5).count();
    let least = numbers.iter().copied().fold(f64::INFINITY, f64::min);
    let most = numbers.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let outside = numbers.len() - inside;
    report.more.insert(
        "winding".into(),
        json!({ "inside": inside, "outside": outside, "least": least, "most": most }),
    );
    report.lines.push(("mesh", options.mesh.display().to_string()));
    let line = format!("{inside} points inside, {outside} outside; from {least:.6} to {most:.6}");
    report.lines.push(("winding", line));
    let rows = Values::U32(points.row_of_vertex().to_vec());
    let complex = Complex::new(ComplexParts {
        vertices: points.coords().to_vec(),
        attributes: vec![
            Attribute::new("row", Element::Vertex, 1, rows)?,
            Attribute::new("winding", Element::Vertex, 1, Values::F64(numbers))?,
        ],
        ..ComplexParts::default()
    })?;
    report.counts = (&complex).into();
    let path = options.output.output.as_deref();
    report.outputs.push(session.deliver("points", &complex, path, &options.output)?);
    Ok(report)
}

//! `medax union`: the boundary of a union of balls, such as those of a medial axis.

use crate::report::{Counts, Input, Report};
use crate::session::{Failure, OutputOptions, Session};
use medax::distance::{Balls, BoundaryOptions};
use medax::{Error, Status};
use serde_json::json;
use std::path::{Path, PathBuf};

/// Mesh the boundary of the union of balls: a medial axis back to a solid
#[derive(clap::Args)]
pub struct Options {
    /// A file whose vertices carry `radius`: a medial axis in PLY or .ma, whatever made it
    input: PathBuf,
    #[command(flatten)]
    output: OutputOptions,
    /// How far points of the boundary may be from a vertex, in input units; 0 means a hundredth of the diagonal of the balls' box
    #[arg(long, allow_hyphen_values = true, value_name = "LENGTH", default_value_t = 0.0)]
    spacing: f64,
}

pub fn run(options: &Options, session: &mut Session) -> Result<Report, Failure> {
    options.output.check(&[])?;
    if !(0.0..f64::INFINITY).contains(&options.spacing) {
        let spacing = options.spacing;
        let message = format!("--spacing must be 0 or more and finite, not {spacing:?}");
        return Err(Failure::usage(message));
    }
    let axis = session.read_complex(&options.input)?;
    let balls = Balls::of_complex(&axis, &session.job).map_err(hinted(&options.input))?;
    let diagonal = balls.bounds().diagonal();
    let spacing = if options.spacing > 0.0 { options.spacing } else { 0.01 * diagonal };
    let boundary = balls.boundary(BoundaryOptions { spacing }, &session.job)?;
    let mut report = Report {
        command: "union",
        input: Input::of_complex(&options.input, &axis),
        counts: Counts::from(&boundary),
        ..Report::default()
    };
    options.output.describe(&mut report.parameters);
    report.parameters.insert("spacing".into(), json!(spacing));
    let least = balls.radii().iter().copied().fold(f64::INFINITY, f64::min);
    let largest = balls.radii().iter().copied().fold(0.0, f64::max);
    let union = json!({
        "balls": balls.len(),
        "least_radius": least,
        "largest_radius": largest,
        "diagonal": diagonal,
    });
    report.more.insert("union".into(), union);
    let words = format!("{} of radii from {least:.6e} to {largest:.6e}", balls.len());
    report.lines.push(("balls", words));
    let path = options.output.output.as_deref();
    report.outputs.push(session.deliver("boundary", &boundary, path, &options.output)?);
    Ok(report)
}

/// What to do about vertices that are no balls.
fn hinted(path: &Path) -> impl Fn(Error) -> Failure {
    let about = Failure::about(path);
    move |error| {
        let hint = match error.status() {
            Status::Mismatch => {
                "; give a medial axis that medax wrote as PLY or .ma, which hold radii"
            }
            Status::TooFewPoints => "; give an axis that is not empty",
            Status::InvalidArgument => {
                "; where an axis comes to the boundary, --min-distance of medax field leaves such vertices out"
            }
            _ => "",
        };
        let said = Error::new(error.status(), format!("{}{hint}", error.message()));
        about(error.element().map_or(said.clone(), |(kind, index)| said.at(kind, index)))
    }
}

//! How thick the walls of a part are, at the vertices of its mesh:
//! `cargo run --example wall_thickness -- PART LIMIT MESH`.

use medax::complex::{Element, Values};
use medax::crust::PowerCrustOptions;
use medax::io::{WriteOptions, read_complex, write_complex};
use medax::points::PointsOptions;
use medax::poles::{Omit, PolesOptions};
use medax::sample::{SampleOptions, sample_mesh};
use medax::{Job, Points, PowerCrust};
use std::process::ExitCode;
use std::sync::Arc;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let Some([part, limit, mesh]) = understood(&arguments) else {
        eprintln!("usage: wall_thickness PART LIMIT MESH");
        return ExitCode::from(2);
    };
    match run(part, limit, mesh) {
        Ok(counts) => {
            println!("{counts}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

/// The three arguments, if they are three and the limit is a number.
pub fn understood(arguments: &[String]) -> Option<&[String; 3]> {
    let arguments: &[String; 3] = arguments.try_into().ok()?;
    arguments[1].parse::<f64>().is_ok().then_some(arguments)
}

/// Writes the part with its thickness and says how many vertices are thinner than the limit.
pub fn run(part: &str, limit: &str, mesh: &str) -> medax::Result<String> {
    let job = Job::default();
    let part = read_complex(part, &job)?;
    let samples = sample_mesh(&part, SampleOptions::default(), &job)?;
    let points = Arc::new(Points::new(samples.points(), PointsOptions::default(), &job)?);
    // The part has sharp edges; its own faces tell inside from outside.
    let options = PowerCrustOptions {
        poles: PolesOptions { omit: Omit::Both, ..PolesOptions::default() },
        ..PowerCrustOptions::default()
    };
    let crust = PowerCrust::build(&points, options, &job)?.labelled_by_mesh(&part, &job)?;
    let sized = crust.with_sizes(&part, &job)?;
    write_complex(mesh, &sized, WriteOptions::default(), &job)?;
    let mut thin = 0;
    if let Some(Values::F64(thickness)) =
        sized.attribute(Element::Vertex, "thickness").map(|attribute| attribute.values())
    {
        let least = limit.parse().unwrap_or(0.0);
        thin = thickness.iter().filter(|&&thickness| thickness < least).count();
    }
    let (samples, vertices) = (points.len(), sized.vertices().len());
    Ok(format!("{samples} samples, {vertices} vertices, {thin} thinner than {limit}"))
}

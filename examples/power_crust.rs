//! A watertight mesh of a file of points: `cargo run --example power_crust -- POINTS MESH`.

use medax::crust::PowerCrustOptions;
use medax::io::{WriteOptions, read_points, write_complex};
use medax::points::PointsOptions;
use medax::{Job, PowerCrust};
use std::process::ExitCode;
use std::sync::Arc;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [points, mesh] = arguments.as_slice() else {
        eprintln!("usage: power_crust POINTS MESH");
        return ExitCode::FAILURE;
    };
    match run(points, mesh) {
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

/// Writes the mesh and says what it is made of.
pub fn run(points: &str, mesh: &str) -> medax::Result<String> {
    let job = Job::default();
    let points = Arc::new(read_points(points, PointsOptions::default(), &job)?);
    let crust = PowerCrust::build(&points, PowerCrustOptions::default(), &job)?;
    write_complex(mesh, crust.surface(), WriteOptions::default(), &job)?;
    Ok(format!("{} samples, {} faces", points.len(), crust.surface().faces().len()))
}

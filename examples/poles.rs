//! The poles of a file of points, with the radii of their balls: `cargo run --example poles -- POINTS POLES`.

use medax::dual::DualOptions;
use medax::io::{WriteOptions, read_points, write_complex};
use medax::points::PointsOptions;
use medax::poles::PolesOptions;
use medax::{Dual, Job, Poles, Triangulation};
use std::process::ExitCode;
use std::sync::Arc;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [points, balls] = arguments.as_slice() else {
        eprintln!("usage: poles POINTS POLES");
        return ExitCode::FAILURE;
    };
    match run(points, balls) {
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

/// Writes the poles and says how many there are.
pub fn run(points: &str, balls: &str) -> medax::Result<String> {
    let job = Job::default();
    let points = Arc::new(read_points(points, PointsOptions::default(), &job)?);
    let triangulation = Arc::new(Triangulation::delaunay(&points, &job)?);
    let dual = Dual::new(&triangulation, DualOptions::default(), &job)?;
    let poles = Poles::new(&dual, PolesOptions::default(), &job)?;
    write_complex(balls, &poles.to_complex()?, WriteOptions::default(), &job)?;
    Ok(format!("{} samples, {} poles", points.len(), poles.len()))
}

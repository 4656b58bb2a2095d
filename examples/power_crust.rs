//! A watertight mesh and the inner medial axis of a file of points:
//! `cargo run --example power_crust -- POINTS MESH AXIS`.

use medax::crust::PowerCrustOptions;
use medax::io::{WriteOptions, read_points, write_complex};
use medax::points::PointsOptions;
use medax::{Job, PowerCrust};
use std::process::ExitCode;
use std::sync::Arc;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [points, mesh, axis] = arguments.as_slice() else {
        eprintln!("usage: power_crust POINTS MESH AXIS");
        return ExitCode::from(2);
    };
    match run(points, mesh, axis) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn run(points: &str, mesh: &str, axis: &str) -> medax::Result<()> {
    let job = Job::default();
    let points = Arc::new(read_points(points, PointsOptions::default(), &job)?);
    let crust = PowerCrust::build(&points, PowerCrustOptions::default(), &job)?;
    write_complex(mesh, crust.surface(), WriteOptions::default(), &job)?;
    write_complex(axis, crust.inner_shape(), WriteOptions::default(), &job)?;
    let (poles, faces) = (crust.poles().len(), crust.surface().faces().len());
    println!("{} samples, {poles} poles, {faces} faces", points.len());
    Ok(())
}

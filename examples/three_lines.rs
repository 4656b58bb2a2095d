//! The Voronoi diagram of three lines in a cube, in three meshes, one for each pair of lines: `cargo run --example three_lines -- FIRST SECOND THIRD`.

use medax::Job;
use medax::distance::{FieldAxis, FieldOptions, Piece, Sites};
use medax::io::{WriteOptions, write_complex};
use medax::medial::Side;
use std::process::ExitCode;
use std::sync::Arc;

fn main() -> ExitCode {
    let files: Vec<String> = std::env::args().skip(1).collect();
    let Ok(files) = <[String; 3]>::try_from(files) else {
        eprintln!("usage: three_lines FIRST SECOND THIRD");
        return ExitCode::from(2);
    };
    match run(&files) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn run(files: &[String; 3]) -> medax::Result<()> {
    let job = Job::default();
    // Each along another axis, none in a plane with another.
    let lines = vec![
        Piece::Line([0.0, 0.0, -1.0], [1.0, 0.0, 0.0]),
        Piece::Line([-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
        Piece::Line([0.0, -1.0, 0.0], [0.0, 0.0, 1.0]),
    ];
    let sites = Arc::new(Sites::new(3, lines, vec![0, 1, 2], &job)?);
    // Lines have no inside, and no end: a box says where to look.
    let options = FieldOptions {
        side: Side::Outer,
        density: 0.05,
        clip: Some([[-2.0; 3], [2.0; 3]]),
        ..FieldOptions::default()
    };
    for (file, pair) in files.iter().zip([[0, 1], [1, 2], [0, 2]]) {
        let piece = FieldAxis::between(&sites, &[pair], options, &job)?.surface(&job)?;
        write_complex(file, &piece, WriteOptions::default(), &job)?;
        println!("between {pair:?}: {} faces", piece.faces().len());
    }
    Ok(())
}

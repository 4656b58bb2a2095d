//! The axis in space as polygons.

use crate::shapes::{cuboid, open, polygon, prism, turned};
use medax::complex::Topology;
use medax::distance::{FieldAxis, FieldOptions, Piece, Sites};
use medax::medial::Side;
use medax::{Complex, Job};
use std::sync::Arc;

fn surface(sites: &Arc<Sites>, options: FieldOptions) -> (Complex, Topology) {
    let job = Job::default();
    let axis = FieldAxis::new(sites, options, &job).unwrap();
    let surface = axis.surface(&job).unwrap();
    println!(
        "{} points, {} vertices {} faces {} edges",
        axis.points().len(),
        surface.vertices().len(),
        surface.faces().len(),
        surface.edges().len()
    );
    let topology = surface.topology(&job).unwrap();
    (surface, topology)
}

#[test]
fn probe() {
    let circle = |n: usize, c: f64, r: f64| -> Vec<[f64; 2]> {
        polygon(n, r).iter().map(|p| [c + p[0], p[1]]).collect()
    };
    let deg = |x: f64| x.to_radians();
    for (name, sites, density, angles) in [
        (
            "ring",
            turned(&[[2.0, -0.15], [3.0, -0.15], [3.0, 0.15], [2.0, 0.15]], 64),
            0.08,
            vec![0.2, 1.0],
        ),
        ("cylinder", prism(&polygon(48, 1.0), 4.0), 0.1234, vec![deg(10.0), deg(20.0), 1.0, 1.7]),
        ("torus", turned(&circle(24, 2.0, 0.7), 48), 0.13, vec![deg(20.0), 1.0, 2.0]),
        (
            "ring",
            turned(&[[2.0, -0.15], [3.0, -0.15], [3.0, 0.15], [2.0, 0.15]], 64),
            0.08,
            vec![0.0, 0.2, 1.0, 2.5],
        ),
        (
            "square ring",
            turned(&[[2.0, -0.15], [3.0, -0.15], [3.0, 0.15], [2.0, 0.15]], 4),
            0.08,
            vec![0.0, 0.2, 1.0, 2.5],
        ),
    ] {
        for angle in angles {
            let start = std::time::Instant::now();
            let options = FieldOptions { density, angle, ..FieldOptions::default() };
            let (_, t) = surface(&sites, options);
            println!(
                "{name} {angle:.2}: betti {:?} iso {} nonmanifold {} boundary {} {:.2} s",
                t.betti,
                t.isolated_vertices,
                t.nonmanifold_edges,
                t.boundary_loops,
                start.elapsed().as_secs_f64()
            );
        }
    }
    let plates = open(
        3,
        vec![
            Piece::Triangle([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
            Piece::Triangle([[0.0, 0.0, 0.3], [1.0, 0.0, 0.3], [0.0, 1.0, 0.3]]),
        ],
    );
    let lines = open(
        3,
        vec![
            Piece::Line([0.0, 0.0, -1.0], [1.0, 0.0, 0.0]),
            Piece::Line([-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
            Piece::Line([0.0, -1.0, 0.0], [0.0, 0.0, 1.0]),
        ],
    );
    for (name, sites) in [("plates", plates), ("lines", lines)] {
        let options = FieldOptions {
            side: Side::Outer,
            density: 0.1,
            clip: Some([[-2.0; 3], [2.0; 3]]),
            ..FieldOptions::default()
        };
        let (_, t) = surface(&sites, options);
        println!(
            "{name}: betti {:?} iso {} nonmanifold {} boundary {}",
            t.betti, t.isolated_vertices, t.nonmanifold_edges, t.boundary_loops
        );
    }
}

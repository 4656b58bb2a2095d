//! Figures drawn by hand.

use medax::figure::{Crossings, FigureOptions, FigureParts};
use medax::{Error, Figure, Job};

pub type Point = [f64; 2];

/// What a figure is made of, as nested lists.
#[derive(Clone, Debug, Default)]
pub struct Drawing {
    pub polygons: Vec<Vec<Vec<Point>>>,
    pub polylines: Vec<Vec<Point>>,
    pub points: Vec<Point>,
    pub circles: Vec<[f64; 3]>,
}

pub const ACCEPT: FigureOptions = FigureOptions { crossings: Crossings::Accept };

/// Where each row ends, after 0.
fn offsets(lengths: impl Iterator<Item = usize>) -> Vec<u32> {
    let mut offsets = vec![0];
    lengths.for_each(|length| offsets.push(offsets[offsets.len() - 1] + length as u32));
    offsets
}

impl Drawing {
    pub fn polygons(polygons: &[&[&[Point]]]) -> Self {
        let rings = |rings: &&[&[Point]]| rings.iter().map(|ring| ring.to_vec()).collect();
        Drawing { polygons: polygons.iter().map(rings).collect(), ..Drawing::default() }
    }

    pub fn polylines(polylines: &[&[Point]]) -> Self {
        let polylines = polylines.iter().map(|line| line.to_vec()).collect();
        Drawing { polylines, ..Drawing::default() }
    }

    pub fn circles(circles: &[[f64; 3]]) -> Self {
        Drawing { circles: circles.to_vec(), ..Drawing::default() }
    }

    pub fn make(&self, options: FigureOptions) -> Result<Figure, Error> {
        self.make_with(options, &Job::default())
    }

    pub fn make_with(&self, options: FigureOptions, job: &Job) -> Result<Figure, Error> {
        let rings: Vec<&Vec<Point>> = self.polygons.iter().flatten().collect();
        let parts = FigureParts {
            ring_vertices: &rings.iter().flat_map(|ring| ring.iter().copied()).collect::<Vec<_>>(),
            ring_offsets: &offsets(rings.iter().map(|ring| ring.len())),
            polygon_offsets: &offsets(self.polygons.iter().map(Vec::len)),
            polyline_vertices: &self.polylines.concat(),
            polyline_offsets: &offsets(self.polylines.iter().map(Vec::len)),
            points: &self.points,
            circles: &self.circles,
        };
        Figure::new(parts, options, job)
    }

    pub fn strict(&self) -> Result<Figure, Error> {
        self.make(FigureOptions::default())
    }
}

/// The corners of a square, counterclockwise.
pub fn square(x: f64, y: f64, side: f64) -> Vec<Point> {
    vec![[x, y], [x + side, y], [x + side, y + side], [x, y + side]]
}

/// The positions of a chain.
pub fn chain(figure: &Figure, i: usize) -> Vec<Point> {
    figure.chains().row(i).iter().map(|&v| figure.vertices()[v as usize]).collect()
}

/// Checks that a figure keeps its invariants.
pub fn check(figure: &Figure) {
    let report = figure.validate(&Job::default()).unwrap();
    assert!(report.is_valid() && report.checked > 0, "{report:?}: {figure:?}");
}

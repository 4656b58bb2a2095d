//! Plane figures: polygons with holes, open polylines, points and circles.

mod build;
mod crossings;
mod meeting;
mod nesting;
mod report;
mod validate;

use crate::complex::Rows;
use crate::error::Result;
use crate::job::{Job, Run, Stage};
use crate::points::Bounds;
pub(crate) use nesting::direction as ring_direction;
use std::ops::Range;

/// A position in the plane.
type Point = [f64; 2];

/// What a chain of a [`Figure`] is. The numbers are the C ABI's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum ChainKind {
    /// The outer ring of a polygon: an edge from each vertex to the next, and from the last to the first.
    Outer = 0,
    /// A hole of a polygon, a ring like the outer one.
    Hole = 1,
    /// An open polyline: an edge from each vertex to the next.
    Polyline = 2,
    /// A single vertex.
    Point = 3,
}

impl ChainKind {
    /// Whether an edge leads from the last vertex to the first.
    pub fn is_ring(self) -> bool {
        matches!(self, ChainKind::Outer | ChainKind::Hole)
    }
}

/// What becomes of curves that cross or touch, and of polygons in the wrong place. The numbers are the C ABI's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum Crossings {
    /// They are an error.
    #[default]
    Refuse = 0,
    /// They are counted. What is inside is then where a ray crosses rings and circles an odd number of times.
    Accept = 1,
}

/// How to make a figure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FigureOptions {
    /// What becomes of curves that cross.
    pub crossings: Crossings,
}

/// The arrays from which [`Figure::new`] makes a figure. Offsets tell where each row begins and end with the number of
/// what they divide; empty offsets stand for no row.
#[derive(Clone, Copy, Debug, Default)]
pub struct FigureParts<'a> {
    /// The vertices of all rings, one ring after the other. A ring may end with its first vertex or not, and turn
    /// either way.
    pub ring_vertices: &'a [[f64; 2]],
    /// Where the vertices of each ring begin.
    pub ring_offsets: &'a [u32],
    /// Where the rings of each polygon begin: the outer ring, then the holes.
    pub polygon_offsets: &'a [u32],
    /// The vertices of all open polylines, one after the other.
    pub polyline_vertices: &'a [[f64; 2]],
    /// Where the vertices of each polyline begin.
    pub polyline_offsets: &'a [u32],
    /// Single points.
    pub points: &'a [[f64; 2]],
    /// Circles: the centre's coordinates and the radius.
    pub circles: &'a [[f64; 3]],
}

/// What [`Figure::new`] changed and accepted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Normalised {
    /// Rings whose last vertex repeated the first one, and was dropped.
    pub closing_vertices: u64,
    /// Vertices at the place of the one before, which were dropped.
    pub repeated_vertices: u64,
    /// Rings that turned the wrong way, and were turned.
    pub turned_rings: u64,
    /// Pairs of edges or circles that cross or touch. 0 unless crossings were accepted.
    pub crossings: u64,
    /// Rings and circles in a place where [`Crossings::Refuse`] does not have them. 0 unless crossings were accepted, and 0 where
    /// anything crosses.
    pub misplaced: u64,
}

/// Curves and points in the plane: what distances are measured to.
///
/// The chains are the rings, the polylines, the points, in this order and each in the order in which they were given; circles
/// stand apart. Parts are numbered alike: the polygons, the polylines, the points, the circles.
///
/// Invariants: every coordinate is finite and 0 or within [`COORDINATE_MIN`](crate::points::COORDINATE_MIN),
/// [`COORDINATE_MAX`](crate::points::COORDINATE_MAX) in absolute value, and never -0; so is every radius, which is greater
/// than 0. Each vertex belongs to one chain, and a chain's vertices follow each other. Vertices in succession differ, those of a ring round its end, too. A
/// ring has three vertices or more that are not on one line, a polyline two or more, a point one. A polygon's outer
/// ring comes first, then its holes. An outer ring turns left at its least vertex by x, then y, a hole right; crossing rings need not turn there.
///
/// Unless crossings were accepted: edges, of rings and polylines alike, and circles have no point in common but the vertex between
/// two edges of a chain and the ends that polylines share; so an outer ring runs counterclockwise, a hole clockwise. Holes lie in
/// their outer ring and in no other hole; no polygon or disc lies in another, but in its hole it may.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    vertices: Vec<[f64; 2]>,
    chains: Rows,
    kinds: Vec<ChainKind>,
    parts: Vec<u32>,
    circles: Vec<[f64; 3]>,
    bounds: Bounds,
    normalised: Normalised,
    options: FigureOptions,
}

impl Figure {
    /// Checks and normalises the given parts.
    ///
    /// Vertices that repeat the one before are dropped, and so is the last one of a ring if it is the first again; rings are turned; -0 becomes 0. Collinear vertices
    /// stay. Errors point at a ring ([`ElementKind::Ring`](crate::ElementKind), counted over all polygons), a polyline, the row of a point, or a circle, and
    /// say where: [`Status::NonFinite`](crate::Status), [`Status::CoordinateRange`](crate::Status); [`Status::TooFewPoints`](crate::Status) for a ring of fewer than three distinct vertices, a
    /// polyline of fewer than two, a figure without anything; [`Status::Degenerate`](crate::Status) for a ring on a line;
    /// [`Status::InvalidArgument`](crate::Status) for what crosses, touches or lies in the wrong place unless that is accepted, for a radius that is not
    /// greater than 0, for a polygon without a ring, and for offsets that fall; [`Status::LimitExceeded`](crate::Status)
    /// past 2^32 - 2 vertices and circles. Whether curves cross is decided exactly.
    ///
    /// Cost: O(n log n + b) with b pairs of edges whose boxes meet.
    pub fn new(parts: FigureParts<'_>, options: FigureOptions, job: &Job) -> Result<Self> {
        job.run(&[(Stage::Order, 1.0)], |run| Figure::new_in(parts, options, run))
    }

    /// [`Figure::new`] as a stage of a larger operation.
    pub(crate) fn new_in(
        parts: FigureParts<'_>,
        options: FigureOptions,
        run: &Run<'_>,
    ) -> Result<Self> {
        run.enter(Stage::Order)?;
        build::build(parts, options, run)
    }

    /// The vertices' coordinates, in input units, chain by chain.
    pub fn vertices(&self) -> &[[f64; 2]] {
        &self.vertices
    }

    /// The vertices of each chain: numbers in succession.
    pub fn chains(&self) -> &Rows {
        &self.chains
    }

    /// What each chain is.
    pub fn kinds(&self) -> &[ChainKind] {
        &self.kinds
    }

    /// The part of each chain: a polygon, a polyline or a point.
    pub fn parts(&self) -> &[u32] {
        &self.parts
    }

    /// The centre and the radius of each circle.
    pub fn circles(&self) -> &[[f64; 3]] {
        &self.circles
    }

    /// The number of parts: polygons, polylines, points and circles.
    pub fn part_count(&self) -> usize {
        self.parts.last().map_or(0, |&part| part as usize + 1) + self.circles.len()
    }

    /// The part of circle `i`: circles come after all chains.
    pub fn part_of_circle(&self, i: usize) -> u32 {
        (self.part_count() - self.circles.len() + i) as u32
    }

    /// The number of chains of a kind.
    pub fn chain_count(&self, kind: ChainKind) -> usize {
        self.kinds.iter().filter(|&&k| k == kind).count()
    }

    /// The smallest box round all vertices and discs, with z = 0; that of a disc is rounded outward.
    pub fn bounds(&self) -> &Bounds {
        &self.bounds
    }

    /// What was changed and accepted when the figure was made.
    pub fn normalised(&self) -> &Normalised {
        &self.normalised
    }

    /// How the figure was made.
    pub fn options(&self) -> FigureOptions {
        self.options
    }

    /// The ends of each edge of a chain, along the chain; none for a point.
    pub fn edges(&self, chain: usize) -> impl Iterator<Item = [u32; 2]> {
        let Range { start, end } = self.range(chain);
        let last = match self.kinds[chain].is_ring() {
            true => end,
            false => end - 1,
        };
        (start..last).map(move |v| [v, if v + 1 == end { start } else { v + 1 }])
    }

    /// The vertices of a chain.
    fn range(&self, chain: usize) -> Range<u32> {
        let offsets = self.chains.offsets();
        offsets[chain]..offsets[chain + 1]
    }

    /// The chain of a vertex.
    fn chain_of(&self, vertex: u32) -> usize {
        self.chains.offsets().partition_point(|&begin| begin <= vertex) - 1
    }

    /// The number of rings, which come before all other chains.
    fn ring_count(&self) -> usize {
        self.kinds.partition_point(|kind| kind.is_ring())
    }
}

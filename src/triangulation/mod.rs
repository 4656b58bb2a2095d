//! Exact Delaunay and regular triangulations.
//!
//! The regular triangulation of points `p` with weights `w` is the projection of the lower hull
//! of the lifted points `(p, |p|^2 - w)`: a cell is in it when no other point has a smaller power
//! distance `|x - p|^2 - w` to the cell's orthocentre `x` than its own vertices have. A point whose
//! weight is too small for any cell is *hidden*. With equal weights it is the Delaunay
//! triangulation (Aurenhammer 1987; Edelsbrunner 1987).
//!
//! Predicates are exact, and ties (cospherical points) are broken by the symbolic perturbation of
//! Devillers and Teillaud 2011 on the lexicographic order of coordinates, so that the cells are a
//! function of the set of weighted points.

mod boundary;
mod build;
mod canonical;
mod cavity;
mod cells;
mod export;
mod incidence;
mod kernel;
mod locate;
mod nearest;
mod order;
mod parallel;
mod partition;
mod power_tree;
mod star;
mod validate;
mod walk;
mod worker;

pub use cells::CELL_LIMIT;
pub(crate) use incidence::Turn;
pub use incidence::{Edges, Incidence};
pub(crate) use nearest::Descent;
pub(crate) use power_tree::PowerTree;

use crate::error::{ElementKind, Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, PART, Room, Run, Stage};
use crate::points::Points;
use crate::predicates::{WEIGHT_MAX, WEIGHT_MIN};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A Delaunay or regular triangulation: finite cells in canonical order.
///
/// Vertices are those of [`Points`]. Invariants: every cell is positively oriented, with its least
/// vertex first and its second least next; cells ascend by their vertices; `neighbors[c][i]` shares
/// with `c` the facet opposite vertex `i`, or is [`NONE`] on the convex hull; no vertex is in conflict
/// with any cell; a vertex that no cell uses is in `hidden`.
#[derive(Clone, Debug)]
pub struct Triangulation {
    points: Arc<Points>,
    weights: Vec<f64>,
    row_of_vertex: Vec<u32>,
    cells: Vec<[u32; 4]>,
    neighbors: Vec<[u32; 4]>,
    hidden: Vec<u32>,
}

impl Triangulation {
    /// The Delaunay triangulation.
    ///
    /// Errors: [`Status::TooFewPoints`] below four distinct points, [`Status::Degenerate`] when
    /// all lie in a plane, [`Status::LimitExceeded`] past [`CELL_LIMIT`] cells, and those of the
    /// job. Cost: expected O(n log n) where the triangulation has O(n) cells.
    pub fn delaunay(points: &Arc<Points>, job: &Job) -> Result<Self> {
        job.run(&[(Stage::Triangulate, 1.0)], |run| Triangulation::delaunay_in(points, run))
    }

    /// [`Triangulation::delaunay`] as a stage of a larger build.
    pub(crate) fn delaunay_in(points: &Arc<Points>, run: &Run<'_>) -> Result<Self> {
        run.enter(Stage::Triangulate)?;
        let built = build::build(points.coords(), run)?;
        let (cells, neighbors) = canonical::canonical(built, run)?;
        Ok(Triangulation {
            points: points.clone(),
            weights: Vec::new(),
            row_of_vertex: Vec::new(),
            cells,
            neighbors,
            hidden: Vec::new(),
        })
    }

    /// Whether four of the points span space.
    ///
    /// Errors: [`Status::TooFewPoints`] and [`Status::Degenerate`] if not.
    pub(crate) fn check_solid(points: &Points, run: &Run<'_>) -> Result<()> {
        let site = |v: u32| points.coords()[v as usize];
        build::first_simplex(points.len(), site, run).map(|_| ())
    }

    /// The regular triangulation with one weight per input row of the points, in squared units.
    ///
    /// Of rows with equal coordinates the largest weight wins; weights of rows left out count
    /// for nothing. Errors: as [`Triangulation::delaunay`], and [`Status::Mismatch`] for a wrong
    /// number of weights, [`Status::NonFinite`] and [`Status::CoordinateRange`] with the row.
    pub fn regular(points: &Arc<Points>, weights: &[f64], job: &Job) -> Result<Self> {
        job.run(&[(Stage::Regular, 1.0)], |run| Triangulation::regular_in(points, weights, run))
    }

    /// [`Triangulation::regular`] as a stage of a larger build.
    pub(crate) fn regular_in(points: &Arc<Points>, weights: &[f64], run: &Run<'_>) -> Result<Self> {
        run.enter(Stage::Regular)?;
        let mut room = Room::new(run);
        let row_of_vertex = heaviest_rows(points, weights, &mut room, run)?;
        let weight = |row: u32| weights[row as usize] + 0.0;
        let mut of_sites = Room::new(run);
        let mut sites = of_sites.filled(points.len(), [0.0; 4])?;
        let chunks = sites.chunks_mut(PART).zip(points.coords().chunks(PART));
        let chunks = chunks.zip(row_of_vertex.chunks(PART)).collect();
        run.in_parallel(chunks, |((sites, coords), rows)| {
            run.poll()?;
            for ((site, &[x, y, z]), &row) in sites.iter_mut().zip(coords).zip(rows) {
                *site = [x, y, z, weight(row)];
            }
            Ok(())
        })?;
        let built = build::build(&sites, run)?;
        let weights = room.collect(sites.iter().map(|site| site[3]))?;
        // Where the cells are ordered, most memory is needed.
        drop((sites, of_sites));
        let (cells, neighbors) = canonical::canonical(built, run)?;
        let hidden = hidden(points.len(), &cells, &mut room, run)?;
        Ok(Triangulation {
            points: points.clone(),
            weights,
            row_of_vertex,
            cells,
            neighbors,
            hidden,
        })
    }

    /// What the arrays take, those of the points included.
    pub(crate) fn bytes(&self) -> usize {
        self.points.bytes()
            + size_of_val(self.weights())
            + 4 * (self.row_of_vertex.len() + self.hidden.len())
            + 2 * size_of_val(self.cells())
    }

    /// The points whose distinct positions are the vertices.
    pub fn points(&self) -> &Arc<Points> {
        &self.points
    }

    /// The coordinates of each vertex.
    pub fn coords(&self) -> &[[f64; 3]] {
        self.points.coords()
    }

    /// Whether this is a regular triangulation.
    pub fn is_weighted(&self) -> bool {
        !self.weights.is_empty()
    }

    /// The weight of each vertex, in squared units; empty for Delaunay.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// The input row that each vertex stands for: the first of its duplicates, or of the
    /// heaviest ones in a regular triangulation.
    pub fn row_of_vertex(&self) -> &[u32] {
        if self.is_weighted() { &self.row_of_vertex } else { self.points.row_of_vertex() }
    }

    /// The finite cells: four vertices each, positively oriented, the least first, the second
    /// least next.
    pub fn cells(&self) -> &[[u32; 4]] {
        &self.cells
    }

    /// The neighbours of each cell: entry `i` lies opposite vertex `i`; [`NONE`] on the hull.
    pub fn neighbors(&self) -> &[[u32; 4]] {
        &self.neighbors
    }

    /// The vertices that no cell uses, because their weights are too small, ascending.
    pub fn hidden(&self) -> &[u32] {
        &self.hidden
    }

    /// Whether facet `i` of the cell lies on the convex hull.
    pub fn is_hull(&self, cell: u32, facet: usize) -> bool {
        self.neighbors[cell as usize][facet] == NONE
    }

    /// The vertices of facet `i` of the cell, the one opposite its vertex `i`. Their right-handed
    /// normal points out of the cell.
    pub fn facet(&self, cell: u32, facet: usize) -> [u32; 3] {
        cells::FACET[facet].map(|slot| self.cells[cell as usize][slot])
    }

    /// The two vertices of facet `i` of the cell that follow the one in a slot, in the facet's order.
    pub(crate) fn rim(&self, cell: u32, facet: usize, slot: usize) -> [u32; 2] {
        let [_, _, a, b] = cells::EVEN[facet][slot];
        [a, b].map(|slot| self.cells[cell as usize][slot])
    }

    /// The vertex with its weight, 0 in a Delaunay triangulation.
    pub fn site(&self, vertex: u32) -> [f64; 4] {
        let [x, y, z] = self.coords()[vertex as usize];
        [x, y, z, self.weights.get(vertex as usize).copied().unwrap_or(0.0)]
    }
}

/// The vertices that no cell has, ascending.
fn hidden(
    count: usize,
    cells: &[[u32; 4]],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<u32>> {
    let mut used = room.vec(count)?;
    used.resize_with(count, || AtomicBool::new(false));
    run.in_parallel(cells.chunks(PART).collect(), |cells| {
        run.poll()?;
        for &vertex in cells.as_flattened() {
            // What is read before it is written does not go from one processor to the other.
            let used = &used[vertex as usize];
            if !used.load(Ordering::Relaxed) {
                used.store(true, Ordering::Relaxed);
            }
        }
        Ok(())
    })?;
    let mut hidden = Vec::new();
    for vertex in run.watch((0..count).filter(|&v| !used[v].load(Ordering::Relaxed))) {
        room.push(&mut hidden, vertex? as u32)?;
    }
    Ok(hidden)
}

/// For each vertex the first of its heaviest rows, once all weights are found to be in order.
fn heaviest_rows(
    points: &Points,
    weights: &[f64],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<u32>> {
    if weights.len() != points.row_count() {
        return Err(Error::new(
            Status::Mismatch,
            format!("{} weights for {} rows of points", weights.len(), points.row_count()),
        ));
    }
    let mut heaviest = room.collect(points.row_of_vertex().iter().copied())?;
    for row in run.watch(weights.iter().zip(points.vertex_of_row()).enumerate()) {
        let (row, (&weight, &vertex)) = row?;
        if vertex == NONE {
            continue;
        }
        let error = if !weight.is_finite() {
            Error::new(Status::NonFinite, "a weight is NaN or infinite")
        } else if weight != 0.0 && !(WEIGHT_MIN..=WEIGHT_MAX).contains(&weight.abs()) {
            Error::new(
                Status::CoordinateRange,
                "a weight other than 0 is too small or too large for exact predicates; rescale",
            )
        } else {
            let best = &mut heaviest[vertex as usize];
            if weight > weights[*best as usize] {
                *best = row as u32;
            }
            continue;
        };
        return Err(error.at(ElementKind::Row, row as u64));
    }
    Ok(heaviest)
}

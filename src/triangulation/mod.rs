//! Exact Delaunay and regular triangulations.

use crate::index::NONE;
use crate::points::Points;
use std::sync::Arc;

/// A Delaunay or regular triangulation: finite cells in canonical order.
#[derive(Clone, Debug)]
pub struct Triangulation {
    points: Arc<Points>,
    weights: Vec<f64>,
    cells: Vec<[u32; 4]>,
    neighbors: Vec<[u32; 4]>,
    hidden: Vec<u32>,
}

impl Triangulation {
    /// The points whose distinct positions are the vertices.
    pub fn points(&self) -> &Arc<Points> {
        &self.points
    }

    /// The coordinates of each vertex.
    pub fn coords(&self) -> &[[f64; 3]] {
        self.points.coords()
    }

    /// The weight of each vertex (regular), or empty (Delaunay).
    pub fn weights(&self) -> &[f64] {
        &self.weights
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
}

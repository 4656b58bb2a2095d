//! Unbounded Voronoi edges: one ray for each facet of the hull.

use super::normal::normal;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::triangulation::Triangulation;

/// The unbounded Voronoi edges, in two arrays with a row per facet of the hull.
///
/// Ray `i` begins at the centre of cell `facets[i][0]` and passes through the plane of its facet
/// `facets[i][1]` at a right angle, outward. Invariants: rows ascend, and hold exactly the facets
/// without a neighbour; directions have length 1 up to rounding and are never NaN.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rays {
    pub(super) facets: Vec<[u32; 2]>,
    pub(super) directions: Vec<[f64; 3]>,
}

impl Rays {
    pub(super) fn new(t: &Triangulation, run: &Run<'_>) -> Result<Self> {
        let mut room = Room::new(run);
        let mut facets: Vec<[u32; 2]> = Vec::new();
        for cell in run.watch(t.neighbors().iter().enumerate()) {
            let (cell, neighbors) = cell?;
            for i in (0..4).filter(|&i| neighbors[i] == NONE) {
                room.push(&mut facets, [cell as u32, i as u32])?;
            }
        }
        let mut directions = room.vec(facets.len())?;
        for (i, &[cell, facet]) in facets.iter().enumerate() {
            if i % 1024 == 0 {
                run.poll()?;
            }
            let corners = t.facet(cell, facet as usize);
            directions.push(normal(corners.map(|v| t.coords()[v as usize])));
        }
        Ok(Rays { facets, directions })
    }

    /// The cell of each ray, and the number of the cell's facet that it passes, 0 to 3.
    pub fn facets(&self) -> &[[u32; 2]] {
        &self.facets
    }

    /// The unit directions, outward.
    pub fn directions(&self) -> &[[f64; 3]] {
        &self.directions
    }

    /// The number of rays.
    pub fn len(&self) -> usize {
        self.facets.len()
    }

    /// Whether there is no ray; never so.
    pub fn is_empty(&self) -> bool {
        self.facets.is_empty()
    }

    /// The ray of a facet, or [`NONE`] if it is not on the hull. Cost: O(log n).
    pub fn of_facet(&self, cell: u32, facet: u32) -> u32 {
        self.facets.binary_search(&[cell, facet]).map_or(NONE, |i| i as u32)
    }
}

//! Point location in a finished triangulation.

use super::Triangulation;
use crate::error::Result;
use crate::index::NONE;
use crate::points::check_coordinates;
use crate::predicates::{Sign, orient3d};

impl Triangulation {
    /// A cell that holds the point, or `None` outside the convex hull.
    ///
    /// The walk begins at cell `hint`, or at the first cell if there is no such cell; a hint near
    /// the point makes it short. A point on a facet, edge or vertex lies in several cells: which one
    /// is returned depends on the hint. Errors: [`crate::Status::NonFinite`] and
    /// [`crate::Status::CoordinateRange`]. Cost: the number of cells between hint and point.
    pub fn locate(&self, point: [f64; 3], hint: u32) -> Result<Option<u32>> {
        let point = check_coordinates(point)?;
        let mut cell = if (hint as usize) < self.cells.len() { hint } else { 0 };
        let mut came_from = NONE;
        // A visibility walk ends in a regular triangulation (Edelsbrunner 1990).
        'walk: loop {
            let corners = self.cells[cell as usize].map(|v| &self.coords()[v as usize]);
            for slot in 0..4 {
                let next = self.neighbors[cell as usize][slot];
                if next == came_from && next != NONE {
                    continue;
                }
                let mut corners = corners;
                corners[slot] = &point;
                let [a, b, c, d] = corners;
                if orient3d(a, b, c, d) == Sign::Negative {
                    if next == NONE {
                        return Ok(None);
                    }
                    came_from = cell;
                    cell = next;
                    continue 'walk;
                }
            }
            return Ok(Some(cell));
        }
    }
}

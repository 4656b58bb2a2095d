//! The triangles of a triangulation, each once: the duals of the Voronoi edges.

use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::triangulation::Triangulation;

/// Every triangle once.
///
/// Invariants: `sides[i]` is the lesser of the cells that have triangle i, and the slot of the vertex opposite; rows ascend. `of_cell` has the
/// triangle opposite each vertex of a cell.
#[derive(Clone, Debug)]
pub(super) struct Triangles {
    pub sides: Vec<[u32; 2]>,
    pub of_cell: Vec<[u32; 4]>,
}

impl Triangles {
    pub fn new(t: &Triangulation, room: &mut Room<'_>, run: &Run<'_>) -> Result<Self> {
        let count = t.cells().len();
        let mut of_cell = room.filled(count, [NONE; 4])?;
        let hull = t.neighbors().as_flattened().iter().filter(|&&cell| cell == NONE).count();
        let mut sides = room.vec((4 * count + hull) / 2)?;
        for cell in run.watch(0..count as u32) {
            let cell = cell?;
            for slot in 0..4 {
                let neighbor = t.neighbors()[cell as usize][slot as usize];
                if neighbor < cell {
                    continue;
                }
                let triangle = sides.len() as u32;
                of_cell[cell as usize][slot as usize] = triangle;
                if neighbor != NONE {
                    let back = t.neighbors()[neighbor as usize].iter().position(|&c| c == cell);
                    of_cell[neighbor as usize][back.unwrap_or(0)] = triangle;
                }
                sides.push([cell, slot]);
            }
        }
        Ok(Triangles { sides, of_cell })
    }

    pub fn len(&self) -> usize {
        self.sides.len()
    }

    /// The vertices of a triangle.
    pub fn corners(&self, t: &Triangulation, triangle: u32) -> [u32; 3] {
        let [cell, slot] = self.sides[triangle as usize];
        t.facet(cell, slot as usize)
    }

    /// The two cells of a triangle, the lesser first; the second is [`NONE`] on the hull.
    pub fn cells(&self, t: &Triangulation, triangle: u32) -> [u32; 2] {
        let [cell, slot] = self.sides[triangle as usize];
        [cell, t.neighbors()[cell as usize][slot as usize]]
    }
}

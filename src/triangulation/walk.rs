//! Point location in the triangulation under construction.

use super::cells::Cells;
use super::conflict::Site;
use crate::predicates::{Sign, orient3d};

/// The state of the walks: where the next one starts, and the order in which it tries facets.
pub(super) struct Walk {
    /// A cell near the next point.
    pub cell: u32,
    random: u32,
}

impl Walk {
    /// Walks that begin at the given cell.
    pub fn new(cell: u32) -> Self {
        Walk { cell, random: 0x2545_f491 }
    }

    /// The cell that holds the point, or an infinite cell whose hull facet it lies strictly beyond.
    ///
    /// A visibility walk (Devillers, Pion, Teillaud 2002): cross any facet that separates the cell
    /// from the point. It ends in Delaunay and regular triangulations, as their cells are acyclic
    /// as seen from any point; a random first facet keeps it short.
    pub fn locate(&mut self, mesh: &Cells<'_>, sites: &[Site], point: &Site) -> u32 {
        let mut cell = self.cell;
        if mesh.is_infinite(cell) {
            cell = mesh.neighbors[cell as usize][3] >> 2;
        }
        let point = point.position();
        let mut entered = u32::MAX;
        'walk: loop {
            let vertices = mesh.vertices[cell as usize];
            if vertices[3] == mesh.infinite {
                return cell;
            }
            let corners = vertices.map(|v| sites[v as usize].position());
            let first = self.next_random();
            for step in 0..4 {
                let slot = ((first + step) & 3) as usize;
                if slot as u32 == entered {
                    continue;
                }
                let mut corners = corners;
                corners[slot] = point;
                let [a, b, c, d] = corners;
                if orient3d(a, b, c, d) == Sign::Negative {
                    let across = mesh.neighbors[cell as usize][slot];
                    cell = across >> 2;
                    entered = across & 3;
                    continue 'walk;
                }
            }
            return cell;
        }
    }

    /// Two random bits (Marsaglia 2003, xorshift).
    fn next_random(&mut self) -> u32 {
        self.random ^= self.random << 13;
        self.random ^= self.random >> 17;
        self.random ^= self.random << 5;
        self.random >> 30
    }
}

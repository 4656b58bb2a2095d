//! The vertex of least power at a point.

use super::{Incidence, Triangulation};
use crate::vector::{dot, sub};

/// Goes from vertex to vertex of a triangulation, each of less power than the one before, to the vertex whose cell of the
/// power diagram, or Voronoi cell, holds a point.
pub(crate) struct Descent<'a> {
    triangulation: &'a Triangulation,
    incidence: &'a Incidence,
}

impl<'a> Descent<'a> {
    /// On a triangulation with the cells of its vertices.
    pub fn new(triangulation: &'a Triangulation, incidence: &'a Incidence) -> Self {
        Descent { triangulation, incidence }
    }

    /// The vertex of least power at a point, beginning at another one that is not hidden: where none of its neighbours has less no
    /// vertex has, since the cells of the diagram are convex. Powers are rounded. Cost: O(way).
    pub fn nearest(&self, at: [f64; 3], from: u32) -> u32 {
        let t = self.triangulation;
        let power = |vertex: u32| {
            let [x, y, z, weight] = t.site(vertex);
            let to = sub([x, y, z], at);
            dot(to, to) - weight
        };
        let (mut here, mut least) = (from, power(from));
        loop {
            let mut next = here;
            for &cell in self.incidence.cells_of(here) {
                for vertex in t.cells()[cell as usize] {
                    let power = power(vertex);
                    // Of equal ones the least vertex.
                    if power < least || (power == least && vertex < next) {
                        (next, least) = (vertex, power);
                    }
                }
            }
            if next == here {
                return here;
            }
            here = next;
        }
    }
}

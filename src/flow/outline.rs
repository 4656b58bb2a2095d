//! The outline of a Voronoi facet as the flow in it sees it.

use super::source::Source;
use crate::error::{ElementKind, Error, Result, Status};
use crate::index::NONE;
use std::ops::Range;

/// A corner of a Voronoi facet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Corner {
    /// A Voronoi vertex: a cell.
    Cell(u32),
    /// The end of a ray, at infinity.
    Ray(u32),
}

/// The sides of a Voronoi facet, counterclockwise as its ring.
///
/// The flow inside the facet runs away from the middle of the dual edge, in straight lines. It enters through the *near* sides, to whose outer
/// side the middle lies, and leaves through the others, the *far* ones. Invariants: corner `i` is where side `i` begins; a side is
/// a Voronoi edge, given as its triangle, or, of an unbounded facet, the one at infinity ([`NONE`]), which is far; the near sides come first,
/// as many as `near`, in one run, since the facet is convex; all are far where the middle lies in the facet.
#[derive(Clone, Debug, Default)]
pub(super) struct Outline {
    pub corners: Vec<Corner>,
    pub sides: Vec<u32>,
    pub near: usize,
}

impl Outline {
    /// Becomes that of a facet.
    pub fn trace(&mut self, source: &Source<'_>, facet: u32) -> Result<()> {
        let Source { dual, facets, triangles, drivers } = *source;
        let t = dual.triangulation();
        let [a, b] = facets.edges()[facet as usize];
        let ring = facets.ring(facet as usize);
        self.corners.clear();
        self.sides.clear();
        for &cell in ring {
            self.corners.push(Corner::Cell(cell));
            let ahead = t.facet_ahead(cell, a, b);
            self.sides.push(triangles.of_cell[cell as usize][ahead]);
        }
        if facets.is_unbounded(facet as usize) {
            let [back, on] = facets.rays()[facet as usize];
            let behind = t.facet_ahead(ring[0], b, a);
            self.corners.extend([Corner::Ray(on), Corner::Ray(back)]);
            self.sides.extend([NONE, triangles.of_cell[ring[0] as usize][behind]]);
        }
        let is_near = |&side: &u32| side != NONE && drivers.longest[side as usize] == facet;
        self.near = self.sides.iter().filter(|side| is_near(side)).count();
        if self.near > 0 {
            let count = self.sides.len();
            let begins = |&i: &usize| {
                is_near(&self.sides[i]) && !is_near(&self.sides[(i + count - 1) % count])
            };
            let begin = (0..count).find(begins).unwrap_or(0);
            self.sides.rotate_left(begin);
            self.corners.rotate_left(begin);
            if !self.sides[..self.near].iter().all(is_near) || self.near == count {
                let message =
                    "the flow does not cross the Voronoi facet from one side to the other";
                return Err(
                    Error::new(Status::Internal, message).at(ElementKind::Face, u64::from(facet))
                );
            }
        }
        Ok(())
    }

    /// The far sides.
    pub fn far(&self) -> Range<usize> {
        self.near..self.sides.len()
    }

    /// The corner where a side ends.
    pub fn end(&self, side: usize) -> Corner {
        self.corners[(side + 1) % self.corners.len()]
    }
}

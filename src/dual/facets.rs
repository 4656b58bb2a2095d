//! Voronoi facets: for each edge the ring of cells round it.

use super::rays::Rays;
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::triangulation::Triangulation;

/// One Voronoi facet for each edge of the triangulation.
///
/// The centres of the cells in a ring are the corners of a convex polygon in the bisector of the
/// edge `a b`, `a < b`, counterclockwise seen from `b`: its normal points from `a` to `b`.
/// Corners may coincide, where cells share their sphere.
///
/// Invariants: edges ascend lexicographically; successive cells of a ring are neighbours; the ring
/// of a bounded facet is closed and begins with its least cell; that of an unbounded one, of an edge on the
/// hull, is open, and two rays continue it: `rays[e][0]` comes in from infinity to the first cell,
/// `rays[e][1]` goes out to infinity from the last. Both are [`NONE`] for a bounded facet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Facets {
    pub(super) edges: Vec<[u32; 2]>,
    pub(super) offsets: Vec<u32>,
    pub(super) cells: Vec<u32>,
    pub(super) rays: Vec<[u32; 2]>,
}

impl Facets {
    pub(super) fn new(t: &Triangulation, rays: &Rays, run: &Run<'_>) -> Result<Self> {
        // Every cell has six edges.
        let entries = t.cells().len() * 6;
        if entries > u32::MAX as usize {
            return Err(Error::new(
                Status::LimitExceeded,
                format!("the rings of all facets would have {entries} cells, more than 2^32 - 1"),
            ));
        }
        let incidence = t.incidence_in(run)?;
        let edges = t.edges_in(&incidence, run)?;
        drop(incidence);
        let count = edges.ends.len();
        let mut room = Room::new(run);
        let mut offsets = room.vec(count + 1)?;
        let mut cells: Vec<u32> = room.vec(entries)?;
        let mut ray_pairs = room.vec(count)?;
        let mut ring = Vec::new();
        let mut reported = 0;
        offsets.push(0);
        for (&[a, b], &cell) in edges.ends.iter().zip(&edges.cells) {
            // A ring may have nearly all cells: they count, not the rings.
            if cells.len() >= reported {
                run.tick(cells.len(), entries)?;
                reported = cells.len() + 16384;
            }
            let closed = t.ring(cell, a, b, &mut ring);
            let ray = |cell: u32, from: u32, to: u32| {
                rays.of_facet(cell, t.facet_ahead(cell, from, to) as u32)
            };
            ray_pairs.push(match (closed, ring.first(), ring.last()) {
                (false, Some(&first), Some(&last)) => [ray(first, b, a), ray(last, a, b)],
                _ => [NONE; 2],
            });
            cells.extend_from_slice(&ring);
            offsets.push(cells.len() as u32);
        }
        Ok(Facets { edges: edges.ends, offsets, cells, rays: ray_pairs })
    }

    /// The edge of each facet, the lesser vertex first.
    pub fn edges(&self) -> &[[u32; 2]] {
        &self.edges
    }

    /// Where the ring of each facet begins in [`Facets::cells`]; one more entry than facets.
    pub fn offsets(&self) -> &[u32] {
        &self.offsets
    }

    /// The rings of all facets, one after the other.
    pub fn cells(&self) -> &[u32] {
        &self.cells
    }

    /// The two rays of each unbounded facet, [`NONE`] twice for a bounded one.
    pub fn rays(&self) -> &[[u32; 2]] {
        &self.rays
    }

    /// The number of facets.
    pub fn len(&self) -> usize {
        self.edges.len()
    }

    /// Whether there is no facet; never so.
    pub fn is_empty(&self) -> bool {
        self.edges.is_empty()
    }

    /// The ring of facet `i`.
    pub fn ring(&self, i: usize) -> &[u32] {
        &self.cells[self.offsets[i] as usize..self.offsets[i + 1] as usize]
    }

    /// Whether facet `i` is unbounded.
    pub fn is_unbounded(&self, i: usize) -> bool {
        self.rays[i][0] != NONE
    }
}

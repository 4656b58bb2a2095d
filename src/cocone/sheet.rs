//! Sets of facets of a triangulation, with their edges and vertices.

use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::sort::sort_by_key_in_parallel;
use crate::triangulation::Triangulation;

/// Facets of a triangulation, each once.
///
/// A facet has a front and a back: its right-handed normal points to the front. Invariants: facets ascend by the
/// cell behind them, which is the lesser one unless the facet is `turned`; edges have the numbers of `edge_of_side`, where side `k` of a facet
/// goes from its vertex `k` to the next.
pub(super) struct Sheet<'a> {
    /// The lesser cell of each facet, or the only one, and the facet's number in it.
    pub(super) facets: Vec<[u32; 2]>,
    /// The vertices: the front is opposite the lesser cell.
    pub(super) corners: Vec<[u32; 3]>,
    /// The edge of each side of each facet.
    pub(super) edge_of_side: Vec<[u32; 3]>,
    /// Where the sides of each edge begin in `sides`; one more entry than edges.
    pub(super) edges: Vec<u32>,
    /// `4 * facet + side` of every side, those of one edge together, ascending.
    pub(super) sides: Vec<u32>,
    /// Where the facets of each vertex begin in `stars`; one more entry than vertices.
    pub(super) stars_of: Vec<u32>,
    /// `4 * facet + corner` of every corner, those of one vertex together, ascending.
    pub(super) stars: Vec<u32>,
    /// What the arrays take, until they go.
    _room: Room<'a>,
}

impl<'a> Sheet<'a> {
    /// Given facets that ascend. Cost: that of sorting their sides.
    pub(super) fn new(t: &Triangulation, facets: Vec<[u32; 2]>, run: &'a Run<'a>) -> Result<Self> {
        let (mut room, mut passing) = (Room::new(run), Room::new(run));
        room.keep(size_of_val(&facets[..]))?;
        let count = facets.len();
        let corners: Vec<[u32; 3]> =
            room.collect(facets.iter().map(|&[cell, facet]| t.facet(cell, facet as usize)))?;
        let mut keyed: Vec<(u64, u32)> = passing.vec(3 * count)?;
        for corners in run.watch(corners.iter().enumerate()) {
            let (facet, corners) = corners?;
            for side in 0..3 {
                let [a, b] = [corners[side], corners[(side + 1) % 3]];
                let key = u64::from(a.min(b)) << 32 | u64::from(a.max(b));
                keyed.push((key, (4 * facet + side) as u32));
            }
        }
        sort_by_key_in_parallel(&mut keyed, |&(key, _)| key, run)?;
        let mut edge_of_side = room.filled(count, [0u32; 3])?;
        let mut edges = room.vec(3 * count + 1)?;
        let mut last = u64::MAX;
        for (place, item) in run.watch(&keyed).enumerate() {
            let &(key, side) = item?;
            if key != last {
                edges.push(place as u32);
                last = key;
            }
            edge_of_side[side as usize / 4][side as usize % 4] = edges.len() as u32 - 1;
        }
        edges.push(keyed.len() as u32);
        let sides = room.collect(keyed.iter().map(|&(_, side)| side))?;
        let mut stars_of = room.filled(t.coords().len() + 1, 0u32)?;
        for v in run.watch(corners.as_flattened()) {
            stars_of[*v? as usize + 1] += 1;
        }
        for v in 0..t.coords().len() {
            stars_of[v + 1] += stars_of[v];
        }
        let mut next = passing.collect(stars_of.iter().copied())?;
        let mut stars = room.filled(3 * count, 0u32)?;
        for corners in run.watch(corners.iter().enumerate()) {
            let (facet, corners) = corners?;
            for (corner, &v) in corners.iter().enumerate() {
                let place = &mut next[v as usize];
                stars[*place as usize] = (4 * facet + corner) as u32;
                *place += 1;
            }
        }
        Ok(Sheet { facets, corners, edge_of_side, edges, sides, stars_of, stars, _room: room })
    }

    /// The number of facets.
    pub(super) fn len(&self) -> usize {
        self.facets.len()
    }

    /// The number of edges.
    pub(super) fn edge_count(&self) -> usize {
        self.edges.len() - 1
    }

    /// The sides of an edge, as `4 * facet + side`.
    pub(super) fn sides_of_edge(&self, edge: u32) -> &[u32] {
        &self.sides[self.edges[edge as usize] as usize..self.edges[edge as usize + 1] as usize]
    }

    /// The facets of a vertex, as `4 * facet + corner`.
    pub(super) fn star(&self, vertex: u32) -> &[u32] {
        let v = vertex as usize;
        &self.stars[self.stars_of[v] as usize..self.stars_of[v + 1] as usize]
    }

    /// The facets that are kept, ascending.
    pub(super) fn kept(&self, kept: &[bool], room: &mut Room<'_>) -> Result<Vec<[u32; 2]>> {
        let mut facets = Vec::new();
        for (facet, _) in self.facets.iter().zip(kept).filter(|(_, kept)| **kept) {
            room.push(&mut facets, *facet)?;
        }
        Ok(facets)
    }

    /// The cells behind a facet and in front of it; [`NONE`] beyond the hull.
    pub(super) fn cells(&self, t: &Triangulation, facet: u32) -> [u32; 2] {
        let [cell, i] = self.facets[facet as usize];
        [cell, t.neighbors()[cell as usize][i as usize]]
    }

    /// For each cell the bits of those of its facets that are in the sheet.
    pub(super) fn walls(
        &self,
        t: &Triangulation,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Vec<u8>> {
        let mut walls = room.filled(t.cells().len(), 0u8)?;
        for facet in run.watch(&self.facets) {
            let &[cell, i] = facet?;
            walls[cell as usize] |= 1 << i;
            let neighbor = t.neighbors()[cell as usize][i as usize];
            if neighbor != NONE {
                walls[neighbor as usize] |= 1 << back(t, cell, neighbor);
            }
        }
        Ok(walls)
    }
}

/// The facet of `neighbor` through which it has `cell` for its neighbour.
pub(super) fn back(t: &Triangulation, cell: u32, neighbor: u32) -> usize {
    t.neighbors()[neighbor as usize].iter().position(|&c| c == cell).unwrap_or(0)
}

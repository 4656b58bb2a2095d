//! How the labels divide the cells of the regular triangulation: what each of them gives to the surface and the shapes.

use super::label::Label;
use crate::error::Result;
use crate::job::{PART, Room, Run, parts};
use crate::triangulation::Triangulation;

/// What one cell gives, in eight bits.
///
/// Bit i says whether vertex i is inner. Bit 4 + i says whether the cell gives facet i, the one opposite vertex i, to
/// a shape: the facet's vertices have the same label, and the cell is the lesser of the facet's two.
#[derive(Clone, Copy)]
pub(super) struct Share(u8);

impl Share {
    /// Given which vertices are inner, and whether the cell is less than each neighbour.
    fn new(inner: [bool; 4], is_less: [bool; 4]) -> Self {
        let bits = |flags: [bool; 4]| (0..4).fold(0, |bits, i| bits | u8::from(flags[i]) << i);
        let inner = bits(inner);
        let facets = match inner.count_ones() {
            0 | 4 => 15,
            1 => inner,
            3 => 15 - inner,
            _ => 0,
        };
        Share(inner | (bits(is_less) & facets) << 4)
    }

    /// Which vertices are inner, a bit each.
    pub(super) fn inner(self) -> usize {
        usize::from(self.0 % 16)
    }

    /// Whether the cell has vertices of both labels.
    pub(super) fn is_mixed(self) -> bool {
        self.inner() != 0 && self.inner() != 15
    }

    /// Whether two vertices are inner, two outer.
    pub(super) fn is_even(self) -> bool {
        self.inner().count_ones() == 2
    }

    /// Whether the cell is a tetrahedron of the side's shape.
    pub(super) fn is_cell_of(self, side: Label) -> bool {
        self.inner() == 15 * side as usize
    }

    /// The facets that the cell gives to the side's shape, a bit each.
    pub(super) fn facets_of(self, side: Label) -> u8 {
        let of_side = match side {
            Label::Outer => self.inner().count_ones() < 2,
            Label::Inner => self.inner().count_ones() > 2,
        };
        if of_side { self.0 >> 4 } else { 0 }
    }
}

/// What every cell gives.
pub(super) struct Division {
    /// Whether each vertex is inner; `false` for those that no cell has.
    pub(super) inner: Vec<bool>,
    pub(super) shares: Vec<Share>,
    /// How many cells of each of the [`parts`] have each share.
    counts: Vec<[u32; 256]>,
}

impl Division {
    /// Given a label for every pole.
    pub(super) fn new(
        regular: &Triangulation,
        labels: &[Label],
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let poles = regular.row_of_vertex().iter();
        let mut inner = room.collect(poles.map(|&pole| labels[pole as usize] == Label::Inner))?;
        for &hidden in regular.hidden() {
            inner[hidden as usize] = false;
        }
        let count = regular.cells().len();
        let mut shares = room.filled(count, Share(0))?;
        let chunks = parts(count).into_iter().zip(shares.chunks_mut(PART)).collect();
        let counts = run.in_steps(chunks, [0.0, 0.1], |(range, shares)| {
            let mut counts = [0; 256];
            let cells = regular.cells()[range.clone()].iter();
            let neighbors = &regular.neighbors()[range.clone()];
            for (((id, cell), neighbors), share) in range.zip(cells).zip(neighbors).zip(shares) {
                // What is no neighbour is greater than every cell.
                let is_less = neighbors.map(|neighbor| (id as u32) < neighbor);
                *share = Share::new(cell.map(|v| inner[v as usize]), is_less);
                counts[usize::from(share.0)] += 1;
            }
            Ok(counts)
        })?;
        Ok(Division { inner, shares, counts })
    }

    /// The edges of mixed cells for which it is told so, given the cell and the edge's slots, ascending, each with its
    /// least cell. Where not all cells of an edge agree it may be missing, or have another one of them.
    pub(super) fn edges(
        &self,
        regular: &Triangulation,
        progress: [f64; 2],
        is_asked_for: impl Fn(usize, [usize; 2]) -> bool + Sync,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Vec<Edge>> {
        let met = run.in_steps(parts(self.shares.len()), progress, |range| {
            let (mut room, mut edges) = (Room::new(run), Vec::new());
            for (cell, &share) in range.clone().zip(&self.shares[range]) {
                if !share.is_mixed() {
                    continue;
                }
                let corners = regular.cells()[cell];
                for &[i, j] in regular.edges_met(cell as u32) {
                    if is_asked_for(cell, [i, j]) {
                        let [a, b] = [corners[i], corners[j]];
                        let ends = [a.min(b), a.max(b)];
                        room.push(&mut edges, Edge { ends, cell: cell as u32 })?;
                    }
                }
            }
            Ok((edges, room))
        })?;
        // The greater vertex first, then the lesser: each sorting keeps what was in order before.
        let count = met.iter().map(|(edges, _)| edges.len()).sum();
        let met = met.iter().flat_map(|(edges, _)| edges);
        let edges = sorted(met, count, 1, regular, room, run)?;
        let mut edges = sorted(edges.iter(), count, 0, regular, room, run)?;
        // What was met several times stands together, the least cell first.
        edges.dedup_by_key(|edge| edge.ends);
        Ok(edges)
    }

    /// Given how many elements a share stands for: how many are before each of the [`parts`], and in all.
    pub(super) fn offsets(&self, elements: impl Fn(Share) -> usize) -> Vec<usize> {
        let of_part = |counts: &[u32; 256]| {
            (0..=255).map(|bits| counts[usize::from(bits)] as usize * elements(Share(bits))).sum()
        };
        let mut end = 0;
        let ends = self.counts.iter().map(|counts| {
            let count: usize = of_part(counts);
            end += count;
            end
        });
        [0].into_iter().chain(ends).collect()
    }
}

/// So many edges in the order of one of their ends, those of equal ends as they were. By counting: there are not many
/// more edges than vertices, and most come nearly in order, so that this is sooner than `sort_by_key`.
fn sorted<'a>(
    edges: impl Iterator<Item = &'a Edge> + Clone,
    count: usize,
    end: usize,
    regular: &Triangulation,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<Edge>> {
    let vertices = regular.coords().len();
    let mut next = room.filled(vertices + 1, 0usize)?;
    for edge in run.watch(edges.clone()) {
        next[edge?.ends[end] as usize + 1] += 1;
    }
    for vertex in 0..vertices {
        next[vertex + 1] += next[vertex];
    }
    let mut sorted = room.filled(count, Edge::default())?;
    for edge in run.watch(edges) {
        let edge = edge?;
        let place = &mut next[edge.ends[end] as usize];
        sorted[*place] = *edge;
        *place += 1;
    }
    Ok(sorted)
}

/// An edge that a cell has.
#[derive(Clone, Copy, Default)]
pub(super) struct Edge {
    /// The lesser vertex first.
    pub(super) ends: [u32; 2],
    pub(super) cell: u32,
}

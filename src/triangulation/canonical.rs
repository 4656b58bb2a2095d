//! From the cells under construction to the canonical order that the set alone decides.

use super::cells::{Cells, EVEN, Mark};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::sort::sort_by_key;

/// Cells of one vertex from which on the sorting must be one that a job can stop.
const MANY: usize = 1 << 12;

/// Finite cells and their neighbours.
pub(super) type CellsAndNeighbors = (Vec<[u32; 4]>, Vec<[u32; 4]>);

/// The finite cells in canonical order with plain neighbours, [`NONE`] on the hull.
///
/// In a cell the least vertex comes first, the second least next, the others as the
/// orientation asks; cells are ordered by their vertices. Cost: O(m), besides sorting the cells
/// of each vertex.
pub(super) fn canonical(mut mesh: Cells<'_>, run: &Run<'_>) -> Result<CellsAndNeighbors> {
    let slots = mesh.vertices.len();
    let mut room = Room::new(run);
    let is_finite = |mesh: &Cells<'_>, cell: usize| {
        mesh.marks[cell] == Mark::Unknown && !mesh.is_infinite(cell as u32)
    };
    // A counting sort by least vertex: first the counts, then where each vertex's cells begin.
    let mut begin = room.filled(mesh.infinite as usize + 1, 0u32)?;
    for cell in run.watch(0..slots) {
        let cell = cell?;
        if !is_finite(&mesh, cell) {
            continue;
        }
        let vertices = mesh.vertices[cell];
        let least = least_slot(&vertices, 4);
        let second = least_slot(&vertices, least);
        let order = EVEN[least][second];
        mesh.vertices[cell] = order.map(|slot| vertices[slot]);
        let neighbors = mesh.neighbors[cell];
        mesh.neighbors[cell] = order.map(|slot| neighbors[slot]);
        begin[vertices[least] as usize + 1] += 1;
    }
    for v in 1..begin.len() {
        begin[v] += begin[v - 1];
    }
    let count = begin.last().map_or(0, |&count| count as usize);
    let mut order = room.filled(count, 0u32)?;
    let mut next = room.collect(begin.iter().copied())?;
    for cell in run.watch((0..slots).filter(|&cell| is_finite(&mesh, cell))) {
        let cell = cell?;
        let slot = &mut next[mesh.vertices[cell][0] as usize];
        order[*slot as usize] = cell as u32;
        *slot += 1;
    }
    let mut keyed = Vec::new();
    for pair in run.watch(begin.windows(2)) {
        let pair = pair?;
        let cells = &mut order[pair[0] as usize..pair[1] as usize];
        sort_cells(cells, &mesh.vertices, &mut keyed, &mut room, run)?;
    }
    let mut rank = room.filled(slots, NONE)?;
    for old in run.watch(order.iter().enumerate()) {
        let (new, &old) = old?;
        rank[old as usize] = new as u32;
    }
    let vertices = room.collect(order.iter().map(|&old| mesh.vertices[old as usize]))?;
    let plain = |&old: &u32| mesh.neighbors[old as usize].map(|n| rank[(n >> 2) as usize]);
    let neighbors = room.collect(order.iter().map(plain))?;
    Ok((vertices, neighbors))
}

/// Sorts cells of one least vertex by the three others; `keyed` is room to work in.
fn sort_cells(
    cells: &mut [u32],
    vertices: &[[u32; 4]],
    keyed: &mut Vec<(u128, u32)>,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<()> {
    // The keys beside the cells: looking them up at each comparison would cost a cache miss.
    keyed.clear();
    room.grow(keyed, cells.len())?;
    keyed.extend(cells.iter().map(|&cell| {
        let [_, b, c, d] = vertices[cell as usize].map(u128::from);
        (b << 64 | c << 32 | d, cell)
    }));
    if cells.len() < MANY {
        keyed.sort_unstable_by_key(|keyed| keyed.0);
    } else {
        sort_by_key(keyed, |keyed| keyed.0 as u64, run)?;
        sort_by_key(keyed, |keyed| (keyed.0 >> 64) as u64, run)?;
    }
    for (cell, keyed) in cells.iter_mut().zip(keyed) {
        *cell = keyed.1;
    }
    Ok(())
}

/// The slot of the least vertex, one slot left aside; 4 leaves none aside.
fn least_slot(vertices: &[u32; 4], aside: usize) -> usize {
    let mut least = if aside == 0 { 1 } else { 0 };
    for slot in 1..4 {
        if slot != aside && vertices[slot] < vertices[least] {
            least = slot;
        }
    }
    least
}

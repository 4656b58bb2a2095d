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
    for pair in run.watch(begin.windows(2)) {
        let pair = pair?;
        let cells = &mut order[pair[0] as usize..pair[1] as usize];
        sort_cells(cells, &mesh.vertices, run)?;
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

/// Sorts cells of one least vertex by the three others.
fn sort_cells(cells: &mut [u32], vertices: &[[u32; 4]], run: &Run<'_>) -> Result<()> {
    if cells.len() < MANY {
        cells.sort_unstable_by_key(|&cell| vertices[cell as usize]);
        return Ok(());
    }
    let mut sorted = Room::new(run).collect(cells.iter().copied())?;
    let pair = |a: u32, b: u32| u64::from(a) << 32 | u64::from(b);
    sort_by_key(&mut sorted, |&cell| u64::from(vertices[cell as usize][3]), run)?;
    let key = |&cell: &u32| pair(vertices[cell as usize][1], vertices[cell as usize][2]);
    sort_by_key(&mut sorted, key, run)?;
    cells.copy_from_slice(&sorted);
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

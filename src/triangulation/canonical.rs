//! From the cells under construction to the canonical order that the set alone decides.

use super::cells::{Cells, EVEN, Mark};
use crate::error::Result;
use crate::index::NONE;
use crate::job::Run;

/// Finite cells and their neighbours.
pub(super) type CellsAndNeighbors = (Vec<[u32; 4]>, Vec<[u32; 4]>);

/// The finite cells in canonical order with plain neighbours, [`NONE`] on the hull.
///
/// In a cell the least vertex comes first, the second least next, the others as the
/// orientation asks; cells are ordered by their vertices. Cost: O(m), besides sorting the cells
/// of each vertex.
pub(super) fn canonical(mut mesh: Cells<'_>, run: &Run<'_>) -> Result<CellsAndNeighbors> {
    let slots = mesh.vertices.len();
    let _charge = run.charge((slots * (4 + 2 * size_of::<[u32; 4]>())) as u64)?;
    let is_finite = |mesh: &Cells<'_>, cell: usize| {
        mesh.marks[cell] == Mark::Unknown && !mesh.is_infinite(cell as u32)
    };
    // A counting sort by least vertex: first the counts, then where each vertex's cells begin.
    let mut begin: Vec<u32> = run.try_vec(mesh.infinite as usize + 1)?;
    begin.resize(mesh.infinite as usize + 1, 0);
    for cell in 0..slots {
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
    let mut order: Vec<u32> = run.try_vec(count)?;
    order.resize(count, 0);
    let mut next = begin.clone();
    for cell in (0..slots).filter(|&cell| is_finite(&mesh, cell)) {
        let slot = &mut next[mesh.vertices[cell][0] as usize];
        order[*slot as usize] = cell as u32;
        *slot += 1;
    }
    for (v, pair) in begin.windows(2).enumerate() {
        if v % 4096 == 0 {
            run.poll()?;
        }
        order[pair[0] as usize..pair[1] as usize]
            .sort_unstable_by_key(|&cell| mesh.vertices[cell as usize]);
    }
    let mut rank: Vec<u32> = run.try_vec(slots)?;
    rank.resize(slots, NONE);
    for (new, &old) in order.iter().enumerate() {
        rank[old as usize] = new as u32;
    }
    let mut vertices = run.try_vec(count)?;
    vertices.extend(order.iter().map(|&old| mesh.vertices[old as usize]));
    let mut neighbors = run.try_vec(count)?;
    neighbors.extend(
        order.iter().map(|&old| mesh.neighbors[old as usize].map(|n| rank[(n >> 2) as usize])),
    );
    Ok((vertices, neighbors))
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

//! From the cells under construction to the canonical order that the set alone decides.

use super::cells::{EVEN, Mark, Parts};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::sort::sort_by_key;

/// Cells of one vertex from which on the sorting must be one that a job can stop.
const MANY: usize = 1 << 12;

/// Finite cells and their neighbours.
pub(super) type CellsAndNeighbors = (Vec<[u32; 4]>, Vec<[u32; 4]>);

/// The slots of a block: their cells and ranks fit into the second cache.
const BLOCK: usize = if cfg!(test) { 8 } else { 1 << 13 };

/// The finite cells in canonical order with plain neighbours, [`NONE`] on the hull.
///
/// In a cell the least vertex comes first, the second least next, the others as the
/// orientation asks; cells are ordered by their vertices. Everything happens in place, with two numbers
/// a cell besides: this is where a build needs the most memory. Cost: O(m), besides sorting the cells
/// of each vertex.
pub(super) fn canonical(mut built: Parts, run: &Run<'_>) -> Result<CellsAndNeighbors> {
    let mut room = Room::new(run);
    let (order, count) = order(&mut built, &mut room, run)?;
    let rank = inverse(order, &mut room, run)?;
    let Parts { mut vertices, mut neighbors, .. } = built;
    let plain = |n: u32| match rank[(n >> 2) as usize] {
        rank if (rank as usize) < count => rank,
        _ => NONE,
    };
    for cell in run.watch(&mut neighbors) {
        let cell = cell?;
        *cell = cell.map(plain);
    }
    permute(&mut vertices, &mut neighbors, rank, run)?;
    vertices.truncate(count);
    neighbors.truncate(count);
    vertices.shrink_to_fit();
    neighbors.shrink_to_fit();
    Ok((vertices, neighbors))
}

/// Turns every finite cell as its vertices ask, and lists all slots: the finite cells in their
/// order, then the others. Returns the number of finite cells as well.
fn order(built: &mut Parts, room: &mut Room<'_>, run: &Run<'_>) -> Result<(Vec<u32>, usize)> {
    let slots = built.vertices.len();
    let is_finite = |built: &Parts, cell: usize| {
        built.marks[cell] == Mark::Unknown && !built.vertices[cell].contains(&built.infinite)
    };
    // A counting sort by least vertex: first the counts, then where each vertex's cells begin.
    let mut ends = room.filled(built.infinite as usize + 1, 0u32)?;
    for cell in run.watch(0..slots) {
        let cell = cell?;
        if !is_finite(built, cell) {
            continue;
        }
        let vertices = built.vertices[cell];
        let least = least_slot(&vertices, 4);
        let second = least_slot(&vertices, least);
        let order = EVEN[least][second];
        built.vertices[cell] = order.map(|slot| vertices[slot]);
        let neighbors = built.neighbors[cell];
        built.neighbors[cell] = order.map(|slot| neighbors[slot]);
        ends[vertices[least] as usize + 1] += 1;
    }
    for v in 1..ends.len() {
        ends[v] += ends[v - 1];
    }
    let count = ends.last().map_or(0, |&count| count as usize);
    let mut order = room.filled(slots, 0u32)?;
    let mut others = count;
    for cell in run.watch(0..slots) {
        let cell = cell?;
        if is_finite(built, cell) {
            // Where a vertex's cells begin moves on until it is where they end.
            let end = &mut ends[built.vertices[cell][0] as usize];
            order[*end as usize] = cell as u32;
            *end += 1;
        } else {
            order[others] = cell as u32;
            others += 1;
        }
    }
    let mut keyed = Vec::new();
    let mut begin = 0;
    for end in run.watch(&ends) {
        let end = *end? as usize;
        sort_cells(&mut order[begin..end], &built.vertices, &mut keyed, room, run)?;
        begin = end;
    }
    Ok((order, count))
}

/// The inverse of a permutation.
fn inverse(order: Vec<u32>, room: &mut Room<'_>, run: &Run<'_>) -> Result<Vec<u32>> {
    let mut rank = room.filled(order.len(), 0)?;
    for place in run.watch(order.iter().enumerate()) {
        let (place, &slot) = place?;
        rank[slot as usize] = place as u32;
    }
    Ok(rank)
}

/// Moves the cell in slot i to slot `rank[i]`, for all at once, in place.
///
/// First into the right block of slots, then within each block, which the cache holds: following the
/// cycles of the permutation through all of memory would wait for it at every step. (McIlroy, Bostic,
/// McIlroy 1993, *Engineering radix sort*: the "American flag".)
fn permute(
    vertices: &mut [[u32; 4]],
    neighbors: &mut [[u32; 4]],
    mut rank: Vec<u32>,
    run: &Run<'_>,
) -> Result<()> {
    let mut swap = |rank: &mut [u32], a: usize, b: usize| {
        vertices.swap(a, b);
        neighbors.swap(a, b);
        rank.swap(a, b);
    };
    let blocks = rank.len().div_ceil(BLOCK);
    // The first slot of each block whose cell may belong elsewhere.
    let mut heads = Room::new(run).collect((0..blocks).map(|block| block * BLOCK))?;
    for block in 0..blocks {
        run.poll()?;
        let end = rank.len().min((block + 1) * BLOCK);
        while heads[block] < end {
            let slot = heads[block];
            let home = rank[slot] as usize / BLOCK;
            if home != block {
                swap(&mut rank, slot, heads[home]);
            }
            heads[home] += 1;
        }
    }
    for block in 0..blocks {
        run.poll()?;
        for slot in block * BLOCK..rank.len().min((block + 1) * BLOCK) {
            // Each step brings a cell to its place, and none is moved from there.
            while rank[slot] as usize != slot {
                let place = rank[slot] as usize;
                swap(&mut rank, slot, place);
            }
        }
    }
    Ok(())
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::Job;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn cells_go_where_their_rank_says(rank in Just((0..50u32).collect::<Vec<_>>()).prop_shuffle()) {
            let before: Vec<[u32; 4]> = (0..50).map(|i| [i; 4]).collect();
            let (mut vertices, mut neighbors) = (before.clone(), before);
            let inverted = Job::default().run(&[], |run| {
                permute(&mut vertices, &mut neighbors, rank.clone(), run)?;
                inverse(rank.clone(), &mut Room::new(run), run)
            });
            let inverted = inverted.unwrap();
            for (slot, &place) in rank.iter().enumerate() {
                prop_assert_eq!(vertices[place as usize], [slot as u32; 4]);
                prop_assert_eq!(inverted[place as usize], slot as u32);
            }
            prop_assert_eq!(vertices, neighbors);
        }
    }
}

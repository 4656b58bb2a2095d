//! The places of cells, kept in the cells themselves.

use super::{PARTITION, Stretch};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use std::hint::select_unpredictable;

/// Bits of vertices up to which a cell has room for its place.
const VERTEX_BITS: u32 = if cfg!(test) { 10 } else { 24 };
/// The least number of slots in a share.
const LEAST_SHARE: usize = if cfg!(test) { 8 } else { 1 << 13 };
/// Cells whose neighbours are named in one part of the work.
const PART: usize = if cfg!(test) { 8 } else { 1 << 15 };

/// Where the place of every cell is found.
///
/// As long as vertices have 24 bits, the first vertex moves into the other bits of the other three, and the
/// place stands where it was: this costs no memory, and it comes with the cell. With more vertices the places have
/// an array of their own.
#[derive(Clone, Copy)]
pub(super) struct Places {
    are_apart: bool,
    /// The number of partitions of vertices; that of slots without a finite cell comes after them.
    pub partitions: usize,
}

impl Places {
    pub fn new(vertices: u32) -> Self {
        let partitions = (vertices as usize).div_ceil(PARTITION);
        // No partition has the vertex whose bits are all ones: it is what an unused slot seems to have.
        let are_apart = partitions > ((1 << VERTEX_BITS) - 1) / PARTITION;
        Places { are_apart, partitions }
    }

    /// Whether the places need an array of their own.
    pub fn are_apart(&self) -> bool {
        self.are_apart
    }

    /// The partition of a cell.
    #[inline(always)]
    pub fn partition(&self, cell: [u32; 4]) -> usize {
        (least(self.vertices(cell)) as usize / PARTITION).min(self.partitions)
    }

    /// The vertices of a cell that has a place.
    #[inline(always)]
    pub fn vertices(&self, cell: [u32; 4]) -> [u32; 4] {
        if self.are_apart { cell } else { without_place(cell) }
    }

    /// Gives every finite cell a place in its partition, and makes the other slots [`NONE`]. Returns where each partition
    /// begins, and where the last one ends.
    pub fn assign(
        &self,
        slots: &mut Stretch<'_>,
        infinite: u32,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Vec<u32>> {
        let len = slots.cells.len();
        let workers = run.threads().min(len.div_ceil(LEAST_SHARE)).max(1);
        let share = len.div_ceil(workers).max(1);
        let mut parts = Vec::new();
        for cells in slots.cells.chunks(share) {
            parts.push((cells, room.filled(self.partitions + 1, 0u32)?));
        }
        let mut next = run.in_parallel(parts, |(cells, mut counts)| {
            for cell in run.watch(cells) {
                counts[self.home(*cell?, infinite).1] += 1;
            }
            Ok(counts)
        })?;
        let mut begins = room.vec(self.partitions + 2)?;
        let mut begin = 0;
        for partition in 0..self.partitions {
            begins.push(begin);
            // From the counts to where each worker's cells begin.
            for next in &mut next {
                begin += std::mem::replace(&mut next[partition], begin);
            }
        }
        begins.extend([begin, len as u32]);
        let apart = slots.apart.iter_mut().flat_map(|apart| apart.chunks_mut(share));
        let apart = apart.map(Some).chain(std::iter::repeat_with(|| None));
        let parts = slots.cells.chunks_mut(share).zip(apart).zip(next).collect();
        run.in_parallel(parts, |((cells, mut apart), mut next)| {
            for cell in run.watch(cells.iter_mut().enumerate()) {
                let (i, cell) = cell?;
                let (is_finite, partition) = self.home(*cell, infinite);
                let place = select_unpredictable(is_finite, next[partition], NONE);
                next[partition] += 1;
                match &mut apart {
                    Some(places) => places[i] = place,
                    None => *cell = with_place(*cell, place),
                }
                *cell = cell.map(|word| select_unpredictable(is_finite, word, NONE));
            }
            Ok(())
        })?;
        Ok(begins)
    }

    /// Whether a cell without a place is finite, and its partition. Without branches, which would be guessed wrongly.
    #[inline(always)]
    fn home(&self, cell: [u32; 4], infinite: u32) -> (bool, usize) {
        let [a, b, c, d] = cell;
        let is_finite = a.max(b).max(c.max(d)) != infinite;
        let partition = least(cell) as usize / PARTITION;
        (is_finite, select_unpredictable(is_finite, partition, self.partitions))
    }

    /// Replaces neighbours by their places, [`NONE`] where these are not finite. `number` makes the number of the slot of what
    /// names a neighbour.
    pub fn name(
        &self,
        slots: Stretch<'_>,
        number: impl Fn(u32) -> u32 + Sync,
        run: &Run<'_>,
    ) -> Result<()> {
        let Stretch { cells, neighbors, apart } = slots;
        let (cells, apart) = (&*cells, apart.as_deref());
        run.in_parallel(neighbors.chunks_mut(PART).collect(), |neighbors| {
            run.poll()?;
            let neighbors = neighbors.as_flattened_mut().iter_mut();
            let numbers = neighbors.map(|neighbor| (number(*neighbor) as usize, neighbor));
            match apart {
                Some(apart) => numbers.for_each(|(i, neighbor)| {
                    *neighbor = apart.get(i).map_or(NONE, |&place| place)
                }),
                None => numbers.for_each(|(i, neighbor)| {
                    *neighbor = cells.get(i).map_or(NONE, |cell| cell[0])
                }),
            }
            Ok(())
        })
        .map(drop)
    }

    /// Takes the places out of the cells.
    pub fn forget(&self, cells: &mut [[u32; 4]], run: &Run<'_>) -> Result<()> {
        run.in_parallel(cells.chunks_mut(PART).collect(), |cells| {
            run.poll()?;
            cells.iter_mut().for_each(|cell| *cell = self.vertices(*cell));
            Ok(())
        })
        .map(drop)
    }
}

/// A cell with its place instead of the first vertex, which goes into the upper bits of the others.
#[inline(always)]
pub(super) fn with_place([a, b, c, d]: [u32; 4], place: u32) -> [u32; 4] {
    [place, b | a << 24, c | a >> 8 << 24, d | a >> 16 << 24]
}

/// A cell as it was before [`with_place`].
#[inline(always)]
fn without_place([_, b, c, d]: [u32; 4]) -> [u32; 4] {
    let lower = |vertex: u32| vertex & 0xff_ffff;
    [b >> 24 | c >> 24 << 8 | d >> 24 << 16, lower(b), lower(c), lower(d)]
}

/// The least of four vertices.
#[inline(always)]
pub(super) fn least([a, b, c, d]: [u32; 4]) -> u32 {
    a.min(b).min(c.min(d))
}

//! Cells in order, partition by partition.

use super::place::{Places, least, with_place};
use super::{PARTITION, Stretch};
use crate::error::Result;
use crate::job::{Room, Run};
use crate::sort::sort_by_key;
use crate::triangulation::cells::EVEN;
use std::hint::select_unpredictable;
use std::ops::Range;

/// Cells of one vertex up to which each counts those before it.
const FEW: usize = if cfg!(test) { 8 } else { 32 };
/// Cells of one vertex from which on the sorting must be one that a job can stop.
const MANY: usize = if cfg!(test) { 12 } else { 1 << 12 };
/// Groups of partitions for each thread.
const GROUPS: usize = 8;

/// Turns and sorts the cells of each partition, and gives them the places where that brings them. `begins` is where the
/// partitions begin and where the last one ends.
pub(super) fn sort(
    slots: Stretch<'_>,
    places: Places,
    begins: &[u32],
    run: &Run<'_>,
) -> Result<()> {
    let partitions = begins.len() - 1;
    let group = partitions.div_ceil(GROUPS * run.threads()).max(1);
    let mut parts = Vec::new();
    let mut rest = slots;
    for first in (0..partitions).step_by(group) {
        let begins = &begins[first..=partitions.min(first + group)];
        let (slots, others) = rest.split_at((begins[begins.len() - 1] - begins[0]) as usize);
        rest = others;
        parts.push((first, begins, slots));
    }
    run.in_parallel(parts, |(first, begins, slots)| {
        let mut sorter = Sorter::new(begins, places, run)?;
        let mut rest = slots;
        for (partition, ends) in (first..).zip(begins.windows(2)) {
            let (slots, others) = rest.split_at((ends[1] - ends[0]) as usize);
            rest = others;
            sorter.sort(partition, ends[0], slots)?;
        }
        Ok(())
    })
    .map(drop)
}

/// A cell, its neighbours, and its number in the partition by its place so far.
type Item = ([u32; 4], [u32; 4], u32);

/// What one thread needs to sort partitions.
struct Sorter<'a> {
    places: Places,
    items: Vec<Item>,
    /// The places of the cells of a partition, by their numbers.
    places_of: Vec<u32>,
    keys: [u64; FEW],
    keyed: Vec<(u64, u32)>,
    ends: Vec<u32>,
    room: Room<'a>,
    run: &'a Run<'a>,
}

impl<'a> Sorter<'a> {
    /// With room for partitions that begin and end as given.
    fn new(begins: &[u32], places: Places, run: &'a Run<'a>) -> Result<Self> {
        let mut room = Room::new(run);
        let most = begins.windows(2).map(|ends| (ends[1] - ends[0]) as usize).max().unwrap_or(0);
        Ok(Sorter {
            places,
            items: room.filled(most, Item::default())?,
            places_of: room.filled(most, 0)?,
            keys: [0; FEW],
            keyed: Vec::new(),
            ends: room.filled(PARTITION, 0)?,
            room,
            run,
        })
    }

    /// Sorts a partition, which begins at `begin`.
    fn sort(&mut self, partition: usize, begin: u32, slots: Stretch<'_>) -> Result<()> {
        self.by_least_vertex(partition * PARTITION, begin, &slots)?;
        let Stretch { cells, neighbors, apart } = slots;
        let mut sorted = 0;
        for vertex in 0..PARTITION {
            let end = self.ends[vertex] as usize;
            self.sort_bucket(sorted..end, begin, cells, neighbors)?;
            sorted = end;
        }
        match apart {
            Some(apart) => apart.copy_from_slice(&self.places_of[..cells.len()]),
            None => {
                for (cell, place) in cells.iter_mut().zip(&self.places_of) {
                    *cell = with_place(*cell, *place);
                }
            }
        }
        Ok(())
    }

    /// A counting sort into `items`. `ends` becomes where each vertex's cells end.
    fn by_least_vertex(&mut self, first: usize, begin: u32, slots: &Stretch<'_>) -> Result<()> {
        self.ends.fill(0);
        for cell in self.run.watch(&*slots.cells) {
            let vertex = least(self.places.vertices(*cell?));
            self.ends[vertex as usize - first] += 1;
        }
        let mut end = 0;
        for count in &mut self.ends {
            end += std::mem::replace(count, end);
        }
        for slot in self.run.watch(0..slots.cells.len()) {
            let slot = slot?;
            let cell = slots.cells[slot];
            let place = slots.apart.as_ref().map_or(cell[0], |apart| apart[slot]);
            let vertices = self.places.vertices(cell);
            let (least, second) = two_least(vertices);
            let order = EVEN[least][second];
            // Where a vertex's cells begin moves on until it is where they end.
            let end = &mut self.ends[vertices[least] as usize - first];
            let neighbors = slots.neighbors[slot];
            self.items[*end as usize] = (
                order.map(|slot| vertices[slot & 3]),
                order.map(|slot| neighbors[slot & 3]),
                place - begin,
            );
            *end += 1;
        }
        Ok(())
    }

    /// Sorts the cells of one least vertex.
    #[inline]
    fn sort_bucket(
        &mut self,
        bucket: Range<usize>,
        begin: u32,
        cells: &mut [[u32; 4]],
        neighbors: &mut [[u32; 4]],
    ) -> Result<()> {
        let items = &self.items[bucket.clone()];
        let mut put = |number: usize, item: &Item| {
            cells[number] = item.0;
            neighbors[number] = item.1;
            self.places_of[item.2 as usize] = begin + number as u32;
        };
        if items.len() <= FEW {
            // Filled up to whole eights: so the number of turns is mostly the same, and guessed rightly.
            let keys = &mut self.keys[..items.len().next_multiple_of(8)];
            let (last_eight, _) = keys.as_chunks_mut::<8>();
            if let Some(last) = last_eight.last_mut() {
                *last = [u64::MAX >> 1; 8];
            }
            for (to, item) in keys.iter_mut().zip(items) {
                *to = key(&item.0);
            }
            let (eights, _) = keys.as_chunks::<8>();
            for (item, key) in items.iter().zip(&*keys) {
                // The upper bit of a difference tells which is less, without a branch and in vector registers.
                let less = |keys: &[u64; 8]| {
                    keys.iter().map(|other| other.wrapping_sub(*key) >> 63).sum::<u64>()
                };
                let before = eights.iter().map(less).sum::<u64>();
                put(bucket.start + before as usize, item);
            }
            return Ok(());
        }
        self.keyed.clear();
        self.room.grow(&mut self.keyed, items.len())?;
        self.keyed.extend(items.iter().zip(0..).map(|(item, i)| (key(&item.0), i)));
        if items.len() < MANY {
            self.keyed.sort_unstable();
        } else {
            sort_by_key(&mut self.keyed, |keyed| keyed.0, self.run)?;
        }
        for (place, &(_, i)) in bucket.zip(&self.keyed) {
            put(place, &items[i as usize]);
        }
        Ok(())
    }
}

/// What orders the cells of one least vertex. No two have it in common: of the cells at a facet only one
/// lies on the side to which its vertices, in this order, turn.
#[inline(always)]
fn key(cell: &[u32; 4]) -> u64 {
    u64::from(cell[1]) << 32 | u64::from(cell[2])
}

/// The slots of the least vertex and of the second least. Without branches, which would be guessed wrongly.
#[inline(always)]
fn two_least(vertices: [u32; 4]) -> (usize, usize) {
    let less = |a: usize, b: usize| select_unpredictable(vertices[b] < vertices[a], (b, a), (a, b));
    let ((a, b), (c, d)) = (less(0, 1), less(2, 3));
    let (least, other) = less(a, c);
    let (second, _) = less(select_unpredictable(least == a, b, d), other);
    (least, second)
}

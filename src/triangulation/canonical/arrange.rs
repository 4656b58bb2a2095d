//! Cells brought to their partitions, in place.

use super::Stretch;
use super::place::Places;
use crate::error::Result;
use crate::job::{Room, Run};

/// Partitions that are filled in turns.
const LANES: usize = 8;
/// Partitions that one thread fills without dividing them first: more wait for the tables of their pages.
const MOST: usize = if cfg!(test) { 64 } else { 640 };

/// Brings the cells in a stretch to their partitions, which are `first` and those that follow. `begins` is
/// where these begin, and where the last one ends.
///
/// Slots without a cell belong to the last partition of all. Several threads first exchange cells until each
/// has those of its own partitions in its own slots.
pub(super) fn arrange(
    mut slots: Stretch<'_>,
    places: Places,
    first: usize,
    begins: &[u32],
    threads: usize,
    run: &Run<'_>,
) -> Result<()> {
    let [begin, .., end] = *begins else { return Ok(()) };
    // The first partition of the second half.
    let half = begins.partition_point(|&at| at < begin.midpoint(end));
    let is_small = threads < 2 && begins.len() <= MOST;
    if is_small || half == 0 || half + 1 >= begins.len() {
        return fill(slots, places, first, begins, run);
    }
    let middle = (begins[half] - begin) as usize;
    // As many cells belong from before the middle behind it as the other way.
    let mut before = 0;
    for after in run.watch(middle..slots.cells.len()) {
        let after = after?;
        if places.partition(slots.cells[after]) >= first + half {
            continue;
        }
        while places.partition(slots.cells[before]) < first + half {
            before += 1;
            if before.is_multiple_of(1 << 14) {
                run.poll()?;
            }
        }
        slots.swap(before, after);
    }
    let (before, after) = slots.split_at(middle);
    let halves = [
        (before, first, &begins[..=half], threads / 2),
        (after, first + half, &begins[half..], threads - threads / 2),
    ];
    let work =
        |(stretch, first, begins, threads)| arrange(stretch, places, first, begins, threads, run);
    if threads < 2 {
        return halves.into_iter().try_for_each(work);
    }
    run.in_parallel(halves.into(), work).map(drop)
}

/// [`arrange`] on one thread.
///
/// McIlroy, Bostic, McIlroy 1993, *Engineering radix sort*: the "American flag". Every step waits for memory where it finds
/// the cell for the next, so several partitions are filled in turns.
fn fill(
    mut slots: Stretch<'_>,
    places: Places,
    first: usize,
    begins: &[u32],
    run: &Run<'_>,
) -> Result<()> {
    let partitions = begins.len() - 1;
    // The first slot of each partition that may not have its own cell.
    let mut heads =
        Room::new(run).collect(begins.iter().map(|&begin| (begin - begins[0]) as usize))?;
    let end = |partition: usize| (begins[partition + 1] - begins[0]) as usize;
    let mut lanes: [usize; LANES] = std::array::from_fn(|lane| lane);
    let mut next = LANES;
    for turn in 0.. {
        if turn % (1 << 10) == 0 {
            run.poll()?;
        }
        let mut is_done = true;
        for lane in &mut lanes {
            if *lane >= partitions {
                continue;
            }
            is_done = false;
            let slot = heads[*lane];
            if slot == end(*lane) {
                (*lane, next) = (next, next + 1);
                continue;
            }
            let home = places.partition(slots.cells[slot]) - first;
            slots.swap(slot, heads[home]);
            heads[home] += 1;
        }
        if is_done {
            break;
        }
    }
    Ok(())
}

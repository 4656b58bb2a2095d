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
    let is_behind = |cell| places.partition(cell) >= first + half;
    exchange(slots.again(), middle, is_behind, threads, run)?;
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

/// Exchanges cells before the middle that belong behind it with as many that belong the other way.
fn exchange(
    mut slots: Stretch<'_>,
    middle: usize,
    is_behind: impl Fn([u32; 4]) -> bool + Sync,
    threads: usize,
    run: &Run<'_>,
) -> Result<()> {
    // Each thread exchanges between a part of the one side and a part of the other until one of them has no more.
    let (mut before, mut after) = slots.again().split_at(middle);
    let shares = [before.cells.len(), after.cells.len()].map(|len| len.div_ceil(threads.max(1)));
    let (mut pairs, mut begins) = (Vec::new(), [0, middle]);
    while !before.cells.is_empty() || !after.cells.is_empty() {
        let [its_before, its_after] =
            [before.cells.len().min(shares[0]), after.cells.len().min(shares[1])];
        let (one, rest_before) = before.split_at(its_before);
        let (other, rest_after) = after.split_at(its_after);
        pairs.push((begins, one, other));
        (before, after) = (rest_before, rest_after);
        begins = [begins[0] + its_before, begins[1] + its_after];
    }
    let left = run.in_parallel(pairs, |([begin, begin_behind], mut one, mut other)| {
        let mut at = 0;
        for at_behind in run.watch(0..other.cells.len()) {
            let at_behind = at_behind?;
            if is_behind(other.cells[at_behind]) {
                continue;
            }
            while at < one.cells.len() && !is_behind(one.cells[at]) {
                at += 1;
            }
            if at == one.cells.len() {
                let left = begin_behind + at_behind..begin_behind + other.cells.len();
                return Ok((0..0, left));
            }
            one.swap_with(at, &mut other, at_behind);
        }
        Ok((begin + at..begin + one.cells.len(), 0..0))
    })?;
    // On the whole both sides have as many left.
    let mut behind = left.iter().flat_map(|(_, behind)| behind.clone());
    for at in run.watch(left.iter().flat_map(|(before, _)| before.clone())) {
        let at = at?;
        if is_behind(slots.cells[at]) {
            let other = behind.find(|&other| !is_behind(slots.cells[other]));
            slots.swap(at, other.unwrap_or(at));
        }
    }
    Ok(())
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

//! Cells brought to their partitions, in place.

use super::Stretch;
use super::place::Places;
use crate::error::Result;
use crate::job::{Room, Run};
use std::ops::Range;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Partitions that are filled in turns.
const LANES: usize = 8;
/// Partitions that one thread fills without dividing them first: more wait for the tables of their pages.
const MOST: usize = if cfg!(test) { 64 } else { 640 };
/// Slots that a thread takes at a time.
const PIECE: usize = if cfg!(test) { 8 } else { 1 << 12 };

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
    // Each thread has a piece of either side, and takes the next where it has come to the end of one, until a side has
    // no more.
    let (before, after) = slots.again().split_at(middle);
    let sides = [(0, before), (middle, after)].map(|(begin, side)| {
        let pieces = pieces(begin, side).map(|piece| Mutex::new(Some(piece)));
        (pieces.collect::<Vec<_>>(), AtomicUsize::new(0))
    });
    // Each piece is taken once, so that nobody ever waits for its lock.
    let next = |side: usize| {
        let (pieces, taken) = &sides[side];
        let place = taken.fetch_add(1, Ordering::Relaxed);
        pieces.get(place)?.lock().ok()?.take()
    };
    let left = run.in_parallel((0..threads.max(1)).collect(), |_| {
        let mut own = [next(0), next(1)];
        loop {
            for (side, piece) in own.iter_mut().enumerate() {
                let is_wrong = |cell| is_behind(cell) == (side == 0);
                while piece.as_mut().is_some_and(|piece| !piece.find(is_wrong)) {
                    run.poll()?;
                    *piece = next(side);
                }
            }
            match &mut own {
                [Some(one), Some(other)] => one.exchange(other),
                _ => return Ok(own.map(|piece| piece.map_or(0..0, |piece| piece.rest()))),
            }
        }
    })?;
    drop(sides);
    // On the whole both sides have as many left.
    let mut behind = left.iter().flat_map(|[_, behind]| behind.clone());
    for at in run.watch(left.iter().flat_map(|[before, _]| before.clone())) {
        let at = at?;
        if is_behind(slots.cells[at]) {
            let other = behind.find(|&other| !is_behind(slots.cells[other]));
            slots.swap(at, other.unwrap_or(at));
        }
    }
    Ok(())
}

/// The pieces of a stretch of slots, which begins with the given one.
fn pieces(begin: usize, slots: Stretch<'_>) -> impl Iterator<Item = Piece<'_>> {
    let mut rest = Some((begin, slots));
    std::iter::from_fn(move || {
        let (begin, slots) = rest.take()?;
        let (slots, others) = match slots.cells.len() {
            0 => return None,
            len => slots.split_at(len.min(PIECE)),
        };
        rest = Some((begin + slots.cells.len(), others));
        Some(Piece { begin, slots, at: 0 })
    })
}

/// Slots that one thread looks through.
struct Piece<'a> {
    /// The number of the first.
    begin: usize,
    slots: Stretch<'a>,
    /// How many have been looked at.
    at: usize,
}

impl Piece<'_> {
    /// Goes on to the next cell for which it is so. Returns whether there is one.
    fn find(&mut self, is_so: impl Fn([u32; 4]) -> bool) -> bool {
        let found = self.slots.cells[self.at..].iter().position(|&cell| is_so(cell));
        self.at = found.map_or(self.slots.cells.len(), |found| self.at + found);
        found.is_some()
    }

    /// Exchanges the cells where both have come to.
    fn exchange(&mut self, other: &mut Piece<'_>) {
        self.slots.swap_with(self.at, &mut other.slots, other.at);
        self.at += 1;
        other.at += 1;
    }

    /// The slots not looked at.
    fn rest(&self) -> Range<usize> {
        self.begin + self.at..self.begin + self.slots.cells.len()
    }
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

//! Work that is divided among a job's threads.

use super::Run;
use crate::error::Result;
use std::mem;
use std::ops::Range;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;

/// The items of a part that is worth a thread's while, and is done in a few milliseconds where items are cheap.
pub(crate) const PART: usize = 1 << 14;

/// The ranges of [`PART`] items that make up `0..count`; the last may be shorter.
pub(crate) fn parts(count: usize) -> Vec<Range<usize>> {
    parts_of(PART, count)
}

/// The ranges of `size` items, 1 at least, that make up `0..count`; the last may be shorter.
pub(crate) fn parts_of(size: usize, count: usize) -> Vec<Range<usize>> {
    (0..count).step_by(size).map(|begin| begin..count.min(begin + size)).collect()
}

/// The pieces of an array, one after the other, that end before the given places, which ascend.
pub(crate) fn pieces<T>(
    mut array: &mut [T],
    ends: impl IntoIterator<Item = usize>,
) -> impl Iterator<Item = &mut [T]> {
    let mut begin = 0;
    ends.into_iter().map(move |end| {
        let (piece, rest) = mem::take(&mut array).split_at_mut(end - begin);
        (array, begin) = (rest, end);
        piece
    })
}

impl Run<'_> {
    /// [`Run::in_parallel`], reporting after each part: all of them take the stage from the first fraction of its
    /// progress to the second.
    pub(crate) fn in_steps<T: Send, R: Send>(
        &self,
        parts: Vec<T>,
        [from, to]: [f64; 2],
        work: impl Fn(T) -> Result<R> + Sync,
    ) -> Result<Vec<R>> {
        let (count, done) = (parts.len(), AtomicUsize::new(0));
        self.in_parallel(parts, |part| {
            let result = work(part)?;
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            let progress = from + (to - from) * done as f64 / count as f64;
            self.tick((1e6 * progress) as usize, 1_000_000)?;
            Ok(result)
        })
    }

    /// Does all parts of some work, as many at a time as the job has threads, and returns what they gave in
    /// the order of the parts. The calling thread works too; with one thread, or one part, no other is started.
    ///
    /// Which thread does which part is left to chance: let nothing depend on it. Errors: that of the first part
    /// in order that failed; parts that have not begun by then are left out.
    pub(crate) fn in_parallel<T: Send, R: Send>(
        &self,
        parts: Vec<T>,
        work: impl Fn(T) -> Result<R> + Sync,
    ) -> Result<Vec<R>> {
        let threads = self.threads().min(parts.len());
        let parts: Vec<_> = parts.into_iter().map(|part| Mutex::new(Some(part))).collect();
        let (next, failed) = (AtomicUsize::new(0), AtomicBool::new(false));
        // Each part is taken once, so that nobody ever waits for its lock.
        let take = |part: &Mutex<Option<T>>| part.lock().ok().and_then(|mut part| part.take());
        let labour = || {
            let mut done = Vec::new();
            while !failed.load(Ordering::Relaxed) {
                let place = next.fetch_add(1, Ordering::Relaxed);
                let Some(part) = parts.get(place).and_then(take) else { break };
                let result = work(part);
                failed.fetch_or(result.is_err(), Ordering::Relaxed);
                done.push((place, result));
            }
            done
        };
        let mut done = thread::scope(|scope| {
            let spawn = |_| thread::Builder::new().spawn_scoped(scope, labour).ok();
            // A thread that the system refuses is one that the others do without.
            let others: Vec<_> = (1..threads).map_while(spawn).collect();
            let mut done = labour();
            for other in others {
                done.extend(other.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
            }
            done
        });
        done.sort_unstable_by_key(|&(place, _)| place);
        done.into_iter().map(|(_, result)| result).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::{PART, parts, parts_of, pieces};
    use crate::error::{Error, Status};
    use crate::job::{Job, JobOptions, Stage};
    use std::collections::HashSet;
    use std::sync::{Barrier, Mutex};
    use std::thread;

    #[test]
    fn results_come_in_the_order_of_the_parts_whatever_the_threads() {
        for threads in [1, 2, 3, 8] {
            let job = Job::new(JobOptions { threads, ..JobOptions::default() });
            let seen = Mutex::new(HashSet::new());
            let squares = job.run(&[], |run| {
                run.in_parallel((0..100).collect(), |i: usize| {
                    seen.lock().unwrap().insert(thread::current().id());
                    Ok(i * i)
                })
            });
            assert_eq!(squares.unwrap(), (0..100).map(|i| i * i).collect::<Vec<_>>());
            assert!(seen.into_inner().unwrap().len() <= threads);
        }
    }

    #[test]
    fn steps_bring_the_stage_from_one_fraction_to_the_other() {
        let job = Job::new(JobOptions { threads: 2, ..JobOptions::default() });
        let ranges = job.run(&[(Stage::Dual, 1.0), (Stage::Poles, 1.0)], |run| {
            run.enter(Stage::Dual)?;
            let ranges = run.in_steps(parts(3 * PART + 1), [0.25, 0.5], |range| {
                assert!(job.progress() < 0.25);
                Ok(range)
            })?;
            assert_eq!(job.progress(), 0.25);
            Ok(ranges)
        });
        let expected = [0, PART, 2 * PART, 3 * PART].map(|i| i..(i + PART).min(3 * PART + 1));
        assert_eq!(ranges.unwrap(), expected);
    }

    #[test]
    fn pieces_end_where_the_rows_of_each_part_do() {
        // Four rows, the second empty.
        let offsets = [0, 2, 2, 3, 6];
        let mut items = *b"abcdef";
        let of_parts = |size: usize, items: &mut [u8]| {
            let parts = parts_of(size, offsets.len() - 1);
            let ends = parts.iter().map(|rows| offsets[rows.end]);
            pieces(items, ends).map(|piece| piece.to_vec()).collect::<Vec<_>>()
        };
        assert_eq!(of_parts(1, &mut items), [&b"ab"[..], b"", b"c", b"def"]);
        assert_eq!(of_parts(2, &mut items), [&b"ab"[..], b"cdef"]);
        assert_eq!(of_parts(3, &mut items), [&b"abc"[..], b"def"]);
        assert_eq!(of_parts(5, &mut items), [b"abcdef"]);
        assert!(parts_of(3, 0).is_empty());
    }

    #[test]
    fn as_many_parts_run_at_once_as_there_are_threads() {
        let job = Job::new(JobOptions { threads: 3, ..JobOptions::default() });
        // Nobody passes unless all three have come.
        let barrier = Barrier::new(3);
        let work = |_| Ok(barrier.wait().is_leader());
        let leaders = job.run(&[], |run| run.in_parallel(vec![(); 3], work)).unwrap();
        assert_eq!(leaders.into_iter().filter(|&is_leader| is_leader).count(), 1);
    }

    #[test]
    fn the_first_error_in_order_is_told_and_stops_the_rest() {
        let job = Job::new(JobOptions { threads: 2, ..JobOptions::default() });
        let error = job.run(&[], |run| {
            run.in_parallel((0..1000).collect(), |i: u64| match i {
                0..10 => Ok(()),
                _ => Err(Error::new(Status::Degenerate, i.to_string())),
            })
        });
        assert_eq!(error.unwrap_err().message(), "10");
    }
}

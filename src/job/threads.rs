//! Work that is divided among a job's threads.

use super::Run;
use crate::error::Result;
use std::ops::Range;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;

/// The items of a part that is worth a thread's while, and is done in a few milliseconds where items are cheap.
pub(crate) const PART: usize = 1 << 14;

/// The ranges of [`PART`] items that make up `0..count`; the last may be shorter.
pub(crate) fn parts(count: usize) -> Vec<Range<usize>> {
    (0..count).step_by(PART).map(|begin| begin..count.min(begin + PART)).collect()
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
    use super::{PART, parts};
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

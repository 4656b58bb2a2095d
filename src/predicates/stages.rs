//! How many conflict tests each stage settles, for tests and benchmarks.
//!
//! Without the feature `count-stages` nothing is counted, and nothing is spent on it.

/// A stage of the conflict tests, of [`insphere`](super::insphere) and of
/// [`power_test`](super::power_test).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(usize)]
pub enum Stage {
    /// Floats, with a bound from the largest differences.
    Maximum = 0,
    /// Floats, where every operation is known to be exact.
    Grid = 1,
    /// Floats, with a bound from the permanent.
    Permanent = 2,
    /// Pairs of floats.
    Pairs = 3,
    /// Integers.
    Exact = 4,
    /// The symbolic perturbation, after one of the others found zero.
    Perturbed = 5,
}

#[cfg(feature = "count-stages")]
mod counters {
    use super::Stage;
    use std::sync::atomic::{AtomicU64, Ordering};

    static COUNTS: [AtomicU64; 6] = [const { AtomicU64::new(0) }; 6];

    pub(crate) fn count(stage: Stage) {
        COUNTS[stage as usize].fetch_add(1, Ordering::Relaxed);
    }

    pub(crate) fn count_settled(tests: u32) {
        let settled = u64::from((tests & 15).count_ones());
        COUNTS[Stage::Maximum as usize].fetch_add(settled, Ordering::Relaxed);
    }

    /// The number of tests that the stage has settled since the last [`reset`], on all threads.
    pub fn settled(stage: Stage) -> u64 {
        COUNTS[stage as usize].load(Ordering::Relaxed)
    }

    /// Sets every counter to zero.
    pub fn reset() {
        COUNTS.iter().for_each(|count| count.store(0, Ordering::Relaxed));
    }
}

#[cfg(feature = "count-stages")]
pub use counters::{reset, settled};

#[cfg(feature = "count-stages")]
pub(crate) use counters::{count, count_settled};

/// Counts a test that the stage has settled.
#[cfg(not(feature = "count-stages"))]
#[inline(always)]
pub(crate) fn count(_stage: Stage) {}

/// Counts the tests that a filter has settled of four, given as bits.
#[cfg(not(feature = "count-stages"))]
#[inline(always)]
pub(crate) fn count_settled(_tests: u32) {}

//! The queue of poles that wait for their labels.

use crate::error::Result;
use crate::index::NONE;
use crate::job::Room;
use crate::sort::float_key;

/// The children of an entry: as many as fit into a cache line.
const CHILDREN: usize = 4;

/// A queue of numbers, each in it once at most, with priorities that may change: a heap (Williams 1964) that
/// knows where each number is.
///
/// Invariants: no entry is greater than its parent, entry i than entry (i - 1) / 4; `places` says where each number's
/// entry is, or [`NONE`].
pub(super) struct Queue {
    /// The priority, as [`float_key`] orders it, then the number, the least foremost.
    entries: Vec<u128>,
    places: Vec<u32>,
}

impl Queue {
    /// An empty queue for the numbers below `count`.
    pub(super) fn new(count: usize, room: &mut Room<'_>) -> Result<Self> {
        Ok(Queue { entries: room.vec(count)?, places: room.filled(count, NONE)? })
    }

    /// Puts a number into the queue with this priority, or gives it this priority if it is there.
    pub(super) fn put(&mut self, number: u32, priority: f64) {
        let entry = u128::from(float_key(priority)) << 32 | u128::from(!number);
        let place = match self.places[number as usize] {
            NONE => {
                self.entries.push(entry);
                self.entries.len() - 1
            }
            place => place as usize,
        };
        let place = self.raised(place, entry);
        self.lower(place, entry);
    }

    /// Takes out the number of the highest priority, the least of several.
    pub(super) fn pop(&mut self) -> Option<u32> {
        let &first = self.entries.first()?;
        let number = number_of(first);
        self.places[number as usize] = NONE;
        let last = self.entries.pop().filter(|_| !self.entries.is_empty());
        if let Some(last) = last {
            self.lower(0, last);
        }
        Some(number)
    }

    /// Moves parents that are less than the entry down from a place that is free, and returns the place that
    /// is free then.
    fn raised(&mut self, mut place: usize, entry: u128) -> usize {
        while place > 0 {
            let above = (place - 1) / CHILDREN;
            if self.entries[above] > entry {
                break;
            }
            self.set(place, self.entries[above]);
            place = above;
        }
        place
    }

    /// Moves children that are greater than the entry up to a place that is free, and the entry into the last.
    fn lower(&mut self, mut place: usize, entry: u128) {
        loop {
            let begin = CHILDREN * place + 1;
            let end = self.entries.len().min(begin + CHILDREN);
            let Some(most) = (begin..end).max_by_key(|&i| self.entries[i]) else { break };
            if self.entries[most] < entry {
                break;
            }
            self.set(place, self.entries[most]);
            place = most;
        }
        self.set(place, entry);
    }

    fn set(&mut self, place: usize, entry: u128) {
        self.entries[place] = entry;
        self.places[number_of(entry) as usize] = place as u32;
    }
}

/// The number of an entry.
fn number_of(entry: u128) -> u32 {
    !(entry as u32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::Job;
    use proptest::prelude::*;

    proptest! {
        /// Changes of priority, and every third time the first one out.
        #[test]
        fn numbers_come_by_priority_then_least(puts in prop::collection::vec((0..50u32, -4..5i8), 0..300)) {
            let job = Job::default();
            let queue = job.run(&[], |run| Queue::new(50, &mut Room::new(run)));
            let (mut queue, mut waiting) = (queue.unwrap(), [None; 50]);
            let first = |waiting: &mut [Option<i8>; 50], queue: &mut Queue| {
                let most = (0..50).rev().filter(|&i| waiting[i].is_some()).max_by_key(|&i| waiting[i]);
                if let Some(most) = most {
                    waiting[most] = None;
                }
                prop_assert_eq!(queue.pop(), most.map(|most| most as u32));
                Ok(most.is_some())
            };
            for (i, (number, priority)) in puts.into_iter().enumerate() {
                queue.put(number, f64::from(priority) / 4.0);
                waiting[number as usize] = Some(priority);
                if i % 3 == 0 {
                    first(&mut waiting, &mut queue)?;
                }
            }
            while first(&mut waiting, &mut queue)? {}
        }
    }
}

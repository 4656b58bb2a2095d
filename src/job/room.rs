//! Memory that a build asks for piece by piece.

use super::{Charge, Run};
use crate::error::{Error, Result, Status};
use std::collections::HashMap;
use std::hash::Hash;

/// The items between two polls.
const BATCH: usize = 1 << 14;

/// Room for the arrays of one stage: counted against the job's memory ceiling before it is
/// allocated, and an error instead of an abort where there is none left.
///
/// What was asked for stays counted until the room is dropped, at the end of the stage, also where an
/// array is dropped sooner or outlives it as a result.
pub(crate) struct Room<'a> {
    run: &'a Run<'a>,
    charges: Vec<Charge<'a>>,
}

impl<'a> Room<'a> {
    /// No room yet.
    pub fn new(run: &'a Run<'a>) -> Self {
        Room { run, charges: Vec::new() }
    }

    /// Counts what an earlier stage has made and this one still holds, given as bytes.
    pub fn keep(&mut self, bytes: usize) -> Result<()> {
        self.charges.push(self.run.charge(bytes as u64)?);
        Ok(())
    }

    /// Makes room for `extra` more elements, and no more.
    pub fn reserve<T>(&mut self, vec: &mut Vec<T>, extra: usize) -> Result<()> {
        let bytes = extra.saturating_mul(size_of::<T>());
        self.keep(bytes)?;
        vec.try_reserve_exact(extra).map_err(|_| out_of_memory(bytes))
    }

    /// Makes room for `extra` more elements; the room doubles when it is used up.
    pub fn grow<T>(&mut self, vec: &mut Vec<T>, extra: usize) -> Result<()> {
        match vec.capacity() - vec.len() >= extra {
            true => Ok(()),
            false => self.reserve(vec, vec.len().max(extra).max(64)),
        }
    }

    /// Appends an element.
    #[inline]
    pub fn push<T>(&mut self, vec: &mut Vec<T>, value: T) -> Result<()> {
        if vec.len() == vec.capacity() {
            self.grow(vec, 1)?;
        }
        vec.push(value);
        Ok(())
    }

    /// Inserts an entry; the room doubles when it is used up.
    pub fn insert<K: Eq + Hash, V>(
        &mut self,
        map: &mut HashMap<K, V>,
        key: K,
        value: V,
    ) -> Result<()> {
        if map.len() == map.capacity() {
            let extra = map.len().max(64);
            let bytes = extra.saturating_mul(size_of::<(K, V)>());
            self.keep(bytes)?;
            map.try_reserve(extra).map_err(|_| out_of_memory(bytes))?;
        }
        map.insert(key, value);
        Ok(())
    }

    /// An empty vector for so many elements.
    pub fn vec<T>(&mut self, capacity: usize) -> Result<Vec<T>> {
        let mut vec = Vec::new();
        self.reserve(&mut vec, capacity)?;
        Ok(vec)
    }

    /// A vector of equal values, as [`Run::try_filled`] makes it.
    pub fn filled<T: Clone>(&mut self, len: usize, value: T) -> Result<Vec<T>> {
        self.keep(len.saturating_mul(size_of::<T>()))?;
        self.run.try_filled(len, value)
    }

    /// The items of an iterator that knows how many there are. Polls on the way.
    pub fn collect<T>(&mut self, items: impl ExactSizeIterator<Item = T>) -> Result<Vec<T>> {
        let mut items = items;
        let mut vec = self.vec(items.len())?;
        while items.len() > 0 {
            self.run.poll()?;
            vec.extend(items.by_ref().take(BATCH));
        }
        Ok(vec)
    }
}

pub(super) fn out_of_memory(bytes: usize) -> Error {
    Error::new(Status::OutOfMemory, format!("{bytes} bytes are not to be had"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::{Job, JobOptions};

    #[test]
    fn growth_is_counted_and_refused_past_the_ceiling() {
        let job = Job::new(JobOptions { memory_ceiling: 4096, ..JobOptions::default() });
        let refused = job.run(&[], |run| {
            let mut room = Room::new(run);
            let mut vec: Vec<u64> = Vec::new();
            for i in 0..1000 {
                room.push(&mut vec, i).inspect_err(|_| assert!(vec.len() >= 256))?;
            }
            Ok(())
        });
        assert_eq!(refused.unwrap_err().status(), Status::OutOfMemory);
        // What one room asked for is given back with it.
        let collected = job.run(&[], |run| {
            drop(Room::new(run).filled(500, 0u64)?);
            Room::new(run).collect((0..500u32).map(|i| u64::from(i * i)))
        });
        assert_eq!(collected.unwrap()[499], 499 * 499);
    }

    #[test]
    fn what_no_machine_has_is_an_error() {
        let job = Job::default();
        let refused = job.run(&[], |run| Room::new(run).vec::<[u64; 1 << 20]>(1 << 43).map(drop));
        assert_eq!(refused.unwrap_err().status(), Status::OutOfMemory);
    }
}

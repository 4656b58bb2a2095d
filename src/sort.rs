//! Sorting that a job can stop.

use crate::error::Result;
use crate::job::{PART, Room, Run};

/// The bits of a digit: its counts fit into the first cache.
const DIGIT_BITS: u32 = 11;
const DIGITS: usize = 1 << DIGIT_BITS;
/// The most items that are sorted in one piece by the standard library: below a millisecond.
const PIECE: usize = 1 << 11;
/// The items between two polls.
const BATCH: usize = 1 << 16;

/// Sorts by the key, keeping items of equal keys in their order.
///
/// A radix sort, greatest digit first (Knuth, *The Art of Computer Programming* 3, 5.2.5), down to pieces for the standard
/// library; bits that are the same in all keys cost nothing. Cost: O(n) for each digit, and as much memory again.
pub(crate) fn sort_by_key<T: Copy>(
    items: &mut [T],
    key: impl Fn(&T) -> u64,
    run: &Run<'_>,
) -> Result<()> {
    if items.len() <= PIECE {
        items.sort_by_key(key);
        return Ok(());
    }
    let mut room = Room::new(run);
    let mut spare = room.filled(items.len(), items[0])?;
    sort_slice(items, &mut spare, &key, run)
}

/// [`sort_by_key`] with all threads of the job.
pub(crate) fn sort_by_key_in_parallel<T: Copy + Default + Send + Sync>(
    items: &mut Vec<T>,
    key: impl Fn(&T) -> u64 + Sync,
    run: &Run<'_>,
) -> Result<()> {
    if run.threads() == 1 || items.len() <= PART {
        return sort_by_key(items, key, run);
    }
    let mut room = Room::new(run);
    let mut sorted = room.filled(items.len(), T::default())?;
    let Some(ends) = distribute(items, &mut sorted, &key, run)? else { return Ok(()) };
    // Digits that follow each other make up a part.
    let (mut rest, mut spare) = (&mut sorted[..], &mut items[..]);
    let (mut parts, mut part, mut begin, mut last) = (Vec::new(), Vec::new(), 0, 0);
    for end in ends {
        part.push(end - last);
        last = end;
        if end - begin >= PART || end == begin + rest.len() {
            let (its, others) = rest.split_at_mut(end - begin);
            let (its_spare, other_spare) = spare.split_at_mut(end - begin);
            parts.push((std::mem::take(&mut part), its, its_spare));
            (rest, spare, begin) = (others, other_spare, end);
        }
    }
    run.in_parallel(parts, |(lengths, mut rest, mut spare)| {
        for length in lengths {
            let (its, others) = rest.split_at_mut(length);
            let (its_spare, other_spare) = spare.split_at_mut(length);
            sort_slice(its, its_spare, &key, run)?;
            (rest, spare) = (others, other_spare);
        }
        Ok(())
    })?;
    std::mem::swap(items, &mut sorted);
    Ok(())
}

/// [`sort_by_key`], given as many spare items.
fn sort_slice<T: Copy>(
    items: &mut [T],
    spare: &mut [T],
    key: &impl Fn(&T) -> u64,
    run: &Run<'_>,
) -> Result<()> {
    if items.len() <= PIECE {
        items.sort_by_key(key);
        return Ok(());
    }
    let Some(ends) = distribute(items, spare, key, run)? else { return Ok(()) };
    let mut begin = 0;
    for end in ends {
        if begin < end {
            sort_slice(&mut spare[begin..end], &mut items[begin..end], key, run)?;
        }
        begin = end;
    }
    items.copy_from_slice(spare);
    Ok(())
}

/// Copies items to where their greatest digit brings them, keeping the order of equal ones. Returns where each digit's items
/// end; `None`, and no copies, if all keys are equal.
fn distribute<T: Copy>(
    items: &[T],
    to: &mut [T],
    key: &impl Fn(&T) -> u64,
    run: &Run<'_>,
) -> Result<Option<Vec<usize>>> {
    let Some(first) = items.first().map(key) else { return Ok(None) };
    // The bits in which not all keys are equal.
    let mut varying = 0;
    for batch in items.chunks(BATCH) {
        run.poll()?;
        varying |= batch.iter().fold(0, |bits, item| bits | (key(item) ^ first));
    }
    if varying == 0 {
        return Ok(None);
    }
    let shift = (varying.ilog2() + 1).saturating_sub(DIGIT_BITS);
    let digit = |item: &T| (key(item) >> shift) as usize % DIGITS;
    let mut next = vec![0usize; DIGITS];
    for batch in items.chunks(BATCH) {
        run.poll()?;
        batch.iter().for_each(|item| next[digit(item)] += 1);
    }
    let mut begin = 0;
    for count in &mut next {
        begin += std::mem::replace(count, begin);
    }
    for batch in items.chunks(BATCH) {
        run.poll()?;
        for item in batch {
            let slot = &mut next[digit(item)];
            to[*slot] = *item;
            *slot += 1;
        }
    }
    Ok(Some(next))
}

/// A key that orders floats as numbers; NaN has no place among them, and -0 comes before 0.
pub(crate) fn float_key(x: f64) -> u64 {
    let bits = x.to_bits();
    // Negative numbers fall as their bits rise.
    bits ^ ((bits as i64 >> 63) as u64 | 1 << 63)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Status;
    use crate::job::{Job, JobOptions};
    use proptest::prelude::*;

    /// By one thread, and by three.
    fn sorted(items: Vec<(u64, usize)>) -> Vec<(u64, usize)> {
        let job = Job::new(JobOptions { threads: 3, ..JobOptions::default() });
        let (mut one, mut three) = (items.clone(), items);
        job.run(&[], |run| sort_by_key(&mut one, |item| item.0, run)).unwrap();
        job.run(&[], |run| sort_by_key_in_parallel(&mut three, |item| item.0, run)).unwrap();
        assert_eq!(one, three);
        one
    }

    #[test]
    fn the_order_is_that_of_a_stable_sort() {
        let mut state = 1u64;
        for mask in
            [0, 0xf, 0xff00, u64::MAX, 1 << 63, 0xffff_ffff_0000_0000, 0x8000_0000_0000_ffff]
        {
            let mut random = || {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                state.rotate_left(32) & mask
            };
            let items: Vec<_> = (0..3 * PART).map(|i| (random(), i)).collect();
            let mut expected = items.clone();
            expected.sort();
            assert_eq!(sorted(items), expected, "{mask:x}");
        }
        assert!(sorted(Vec::new()).is_empty());
    }

    #[test]
    fn a_cancelled_sort_stops() {
        let mut items: Vec<u64> = (0..BATCH as u64).rev().collect();
        let job = Job::default();
        let stopped = job.run(&[], |run| {
            job.cancel();
            sort_by_key(&mut items, |item| *item, run)
        });
        assert_eq!(stopped.unwrap_err().status(), Status::Cancelled);
    }

    proptest! {
        #[test]
        fn float_keys_order_as_floats(a in any::<f64>(), b in any::<f64>()) {
            prop_assume!(!a.is_nan() && !b.is_nan());
            prop_assert_eq!(float_key(a).cmp(&float_key(b)), a.total_cmp(&b));
        }
    }
}

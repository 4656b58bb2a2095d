//! Sorting that a job can stop.

use crate::error::Result;
use crate::job::{Room, Run};

/// The bits of a digit: its counts fit into the first cache.
const DIGIT_BITS: u32 = 11;
const DIGITS: usize = 1 << DIGIT_BITS;
/// The most items that are sorted in one piece by the standard library: a few milliseconds.
const PIECE: usize = 1 << 14;
/// The items between two polls.
const BATCH: usize = 1 << 16;

/// Sorts by the key, keeping items of equal keys in their order.
///
/// A radix sort, least digit first (Knuth, *The Art of Computer Programming* 3, 5.2.5); digits that are the
/// same in all keys cost nothing. Cost: O(n) for each digit that differs, and as much memory again.
pub(crate) fn sort_by_key<T: Copy>(
    items: &mut Vec<T>,
    key: impl Fn(&T) -> u64,
    run: &Run<'_>,
) -> Result<()> {
    if items.len() <= PIECE {
        items.sort_by_key(key);
        return Ok(());
    }
    let Some(&first) = items.first() else { return Ok(()) };
    // The bits in which not all keys are equal.
    let mut varying = 0;
    for batch in items.chunks(BATCH) {
        run.poll()?;
        varying |= batch.iter().fold(0, |bits, item| bits | (key(item) ^ key(&first)));
    }
    let mut room = Room::new(run);
    let mut sorted = room.filled(items.len(), first)?;
    for shift in (0..64).step_by(DIGIT_BITS as usize) {
        let digit = |item: &T| (key(item) >> shift) as usize % DIGITS;
        if ((varying >> shift) as usize).is_multiple_of(DIGITS) {
            continue;
        }
        let mut next = [0usize; DIGITS];
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
                sorted[*slot] = *item;
                *slot += 1;
            }
        }
        std::mem::swap(items, &mut sorted);
    }
    Ok(())
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
    use crate::job::Job;
    use proptest::prelude::*;

    fn sorted(mut items: Vec<(u64, usize)>) -> Vec<(u64, usize)> {
        let job = Job::default();
        job.run(&[], |run| sort_by_key(&mut items, |item| item.0, run)).unwrap();
        items
    }

    #[test]
    fn the_order_is_that_of_a_stable_sort() {
        let mut state = 1u64;
        for mask in [0, 0xf, 0xff00, u64::MAX, 1 << 63, 0xffff_ffff_0000_0000] {
            let mut random = || {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                state.rotate_left(32) & mask
            };
            let items: Vec<_> = (0..3 * PIECE).map(|i| (random(), i)).collect();
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

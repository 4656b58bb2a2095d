//! Large pages for large arrays.
//!
//! What a build touches together lies near in space, but not in hundreds of megabytes of arrays: with pages of 4 KiB
//! the processor spends much of its time finding pages, and the system handing them out.
#![allow(unsafe_code)]

/// The size of a large page on most processors, and a multiple of all small ones.
const LARGE_PAGE: usize = 2 << 20;

/// Asks the system for large pages for an array, where its memory has not been touched yet. Does nothing
/// where the system knows no such request, or does not grant it.
pub(crate) fn ask_for_large_pages<T>(array: &mut Vec<T>) {
    let bytes = array.capacity() * size_of::<T>();
    let begin = array.as_mut_ptr().cast::<u8>();
    let skipped = begin.align_offset(LARGE_PAGE);
    let whole = bytes.saturating_sub(skipped) / LARGE_PAGE * LARGE_PAGE;
    if whole > 0 {
        advise(begin.wrapping_add(skipped), whole);
    }
}

#[cfg(target_os = "linux")]
fn advise(begin: *mut u8, bytes: usize) {
    // SAFETY: these are whole pages of one allocation. The advice changes how they are mapped, never what they hold or
    // who may touch them; a refusal changes nothing.
    unsafe { libc::madvise(begin.cast(), bytes, libc::MADV_HUGEPAGE) };
}

#[cfg(not(target_os = "linux"))]
fn advise(_: *mut u8, _: usize) {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrays_of_all_sizes_keep_what_they_hold() {
        for len in [0, 1, LARGE_PAGE / 8, 3 * LARGE_PAGE / 8 + 1] {
            let mut array: Vec<u64> = Vec::with_capacity(len);
            array.extend(0..len as u64 / 2);
            ask_for_large_pages(&mut array);
            array.extend(len as u64 / 2..len as u64);
            assert!(array.iter().copied().eq(0..len as u64));
        }
        // Nothing is allocated for these.
        ask_for_large_pages(&mut vec![(); 1 << 40]);
    }
}

use super::*;

/// A struct of "version 0.2": version 0.1 ended before `later`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
struct Grown {
    struct_size: usize,
    ratio: f64,
    reserved: u32,
    mode: u32,
    later: u64,
}

const FIRST: usize = 24;

sized_struct!(Grown, first_size: FIRST, reserved: reserved, {
    ratio: f64 = 0.4,
    reserved: u32 = 0,
    mode: u32 = 2,
    later: u64 = 9,
});

/// A caller's memory: a struct of any version.
type Memory = [u64; 8];

fn read_from(memory: &Memory) -> Result<Grown> {
    // SAFETY: the memory is longer than every size that these tests write into it.
    unsafe { read(memory.as_ptr().cast::<Grown>(), "options") }
}

#[test]
fn null_is_the_defaults() {
    // SAFETY: NULL is allowed.
    let options = unsafe { read(ptr::null::<Grown>(), "options") }.unwrap();
    assert_eq!(options, Grown { struct_size: 32, ratio: 0.4, reserved: 0, mode: 2, later: 9 });
}

#[test]
fn every_size_from_the_first_is_read() {
    let older: Memory = [24, 0.5f64.to_bits(), 3 << 32, !0, !0, !0, !0, !0];
    let options = read_from(&older).unwrap();
    assert_eq!((options.ratio, options.mode, options.later), (0.5, 3, 9));
    let same: Memory = [32, 0.5f64.to_bits(), 3 << 32, 7, !0, !0, !0, !0];
    assert_eq!(read_from(&same).unwrap().later, 7);
    let newer: Memory = [48, 0.5f64.to_bits(), 3 << 32, 7, 0, 0, !0, !0];
    assert_eq!(read_from(&newer).unwrap().later, 7);
}

#[test]
fn what_no_version_has_is_refused() {
    let good: Memory = [32, 0, 0, 0, 0, 0, 0, 0];
    assert!(read_from(&good).is_ok());
    for (place, value) in [(0, 0), (0, 16), (0, 27), (0, 1 << 40), (2, 1)] {
        let mut bad = good;
        bad[place] = value;
        assert_eq!(read_from(&bad).unwrap_err().status(), Status::InvalidArgument, "{bad:?}");
    }
    let mut unknown = good;
    (unknown[0], unknown[5]) = (48, 1 << 56);
    assert_eq!(read_from(&unknown).unwrap_err().status(), Status::InvalidArgument);
}

#[test]
fn init_writes_the_callers_size_and_no_more() {
    for (size, written) in [
        (24, [24, 0.4f64.to_bits(), 2 << 32, 5, 5, 5, 5, 5]),
        (32, [32, 0.4f64.to_bits(), 2 << 32, 9, 5, 5, 5, 5]),
        (48, [48, 0.4f64.to_bits(), 2 << 32, 9, 0, 0, 5, 5]),
    ] {
        let mut memory: Memory = [5; 8];
        // SAFETY: the memory has more than `size` bytes.
        unsafe { init(memory.as_mut_ptr().cast::<Grown>(), size, "options") }.unwrap();
        assert_eq!(memory, written);
        assert!(read_from(&memory).is_ok());
    }
    let mut memory: Memory = [5; 8];
    // SAFETY: as above; NULL is allowed.
    unsafe {
        assert!(init(memory.as_mut_ptr().cast::<Grown>(), 16, "options").is_err());
        assert!(init(ptr::null_mut::<Grown>(), 32, "options").is_err());
    }
    assert_eq!(memory, [5; 8]);
}

#[test]
fn a_report_fills_what_the_caller_has() {
    let found = Grown { struct_size: 0, ratio: 0.5, reserved: 0, mode: 1, later: 4 };
    for (size, written) in [
        (24, [24, 0.5f64.to_bits(), 1 << 32, 5, 5, 5, 5, 5]),
        (48, [48, 0.5f64.to_bits(), 1 << 32, 4, 0, 0, 5, 5]),
    ] {
        let mut memory: Memory = [5; 8];
        memory[0] = size;
        // SAFETY: the memory has more than `size` bytes.
        unsafe { Report::new(memory.as_mut_ptr().cast::<Grown>(), "report") }.unwrap().fill(&found);
        assert_eq!(memory, written);
    }
    let mut memory: Memory = [5; 8];
    // SAFETY: the size is refused before anything else is read; NULL is allowed.
    unsafe {
        assert!(Report::new(memory.as_mut_ptr().cast::<Grown>(), "report").is_err());
        assert!(Report::new(ptr::null_mut::<Grown>(), "report").is_err());
    }
}

//! Files cut short and files with changed bytes: an error that says where, or all that was promised.

use crate::samples::{self, Sample};
use medax::io::{Format, Soup, parse};
use medax::{ElementKind, Error, Job, JobOptions, Status};
use proptest::prelude::*;

/// Parses under a memory ceiling of a small multiple of the file's length.
fn parse_small(bytes: &[u8], format: Format) -> Result<Soup, Error> {
    let memory_ceiling = 64 * bytes.len() as u64 + (1 << 16);
    parse(bytes, format, &Job::new(JobOptions { memory_ceiling, ..JobOptions::default() }))
}

fn counts(soup: &Soup) -> [usize; 3] {
    [soup.vertices().len(), soup.faces().len(), soup.edges().len()]
}

/// Checks that an error is a malformed file's and points into it.
fn check_place(error: &Error, bytes: &[u8]) {
    assert!(matches!(error.status(), Status::Format | Status::Unsupported), "{error}");
    let lines = bytes.iter().filter(|&&b| b == b'\n' || b == b'\r').count() as u64 + 1;
    match error.element() {
        Some((ElementKind::Line, line)) => assert!((1..=lines).contains(&line), "{error}"),
        Some((ElementKind::Byte, byte)) => assert!(byte <= bytes.len() as u64, "{error}"),
        other => panic!("{error}: {other:?}"),
    }
}

/// Checks what must hold of any soup.
fn check_sound(soup: &Soup) {
    let count = soup.vertices().len();
    assert!(soup.faces().indices().iter().all(|&v| (v as usize) < count));
    assert!(soup.faces().iter().all(|face| face.len() >= 3));
    assert!(soup.edges().as_flattened().iter().all(|&v| (v as usize) < count));
    for attribute in soup.attributes() {
        let rows = match attribute.element() {
            medax::complex::Element::Vertex => count,
            medax::complex::Element::Face => soup.faces().len(),
            _ => soup.edges().len(),
        };
        assert_eq!(attribute.rows(), rows);
    }
}

#[test]
fn the_samples_hold_what_they_should() {
    for Sample { name, format, bytes, counts: expected, .. } in samples::all() {
        let soup = parse_small(&bytes, format).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(counts(&soup), expected, "{name}");
        check_sound(&soup);
    }
}

#[test]
fn a_file_cut_short_anywhere_is_an_error_or_complete() {
    for Sample { name, format, bytes, counts: expected, is_counted } in samples::all() {
        let mut complete = 0;
        for end in 0..bytes.len() {
            match parse_small(&bytes[..end], format) {
                Err(error) => check_place(&error, &bytes[..end]),
                Ok(soup) if is_counted => {
                    assert_eq!(counts(&soup), expected, "{name} cut at byte {end}");
                    complete += 1;
                }
                Ok(soup) => check_sound(&soup),
            }
        }
        // Only the digits and the blanks at the very end may be missing.
        assert!(complete < 16, "{name}: {complete} cut files pass");
    }
}

#[test]
fn a_binary_file_cut_short_names_the_byte_where_it_ends() {
    for encoding in ["binary_little_endian", "binary_big_endian"] {
        let bytes = samples::ply(encoding);
        let header = bytes.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
        for end in header..bytes.len() {
            let error = parse_small(&bytes[..end], Format::Ply).unwrap_err();
            assert_eq!(error.element(), Some((ElementKind::Byte, end as u64)), "{error}");
        }
    }
    let bytes = samples::stl(b"", &samples::QUAD);
    for end in 84..bytes.len() {
        let error = parse_small(&bytes[..end], Format::Stl).unwrap_err();
        assert_eq!(error.element(), Some((ElementKind::Byte, end as u64)), "{error}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, ..ProptestConfig::default() })]

    #[test]
    fn changed_bytes_are_an_error_or_sound(
        which in 0usize..13,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
        end in any::<prop::sample::Index>(),
        is_cut in any::<bool>(),
    ) {
        let sample = &samples::all()[which];
        let mut bytes = sample.bytes.clone();
        for (place, byte) in changes {
            let place = place.index(bytes.len());
            bytes[place] = byte;
        }
        if is_cut {
            bytes.truncate(end.index(bytes.len()) + 1);
        }
        match parse_small(&bytes, sample.format) {
            Ok(soup) => check_sound(&soup),
            Err(error) => check_place(&error, &bytes),
        }
    }

    #[test]
    fn noise_is_an_error_or_sound(which in 0usize..13, bytes in prop::collection::vec(any::<u8>(), 1..400)) {
        let format = samples::all()[which].format;
        match parse_small(&bytes, format) {
            Ok(soup) => check_sound(&soup),
            Err(error) => check_place(&error, &bytes),
        }
    }

    #[test]
    fn noise_behind_a_header_is_an_error_or_sound(
        big in any::<bool>(),
        count in any::<u32>(),
        noise in prop::collection::vec(any::<u8>(), 0..400),
    ) {
        let order = if big { "big" } else { "little" };
        let mut bytes = format!(
            "ply\nformat binary_{order}_endian 1.0\nelement vertex {}\nproperty uchar x\nproperty char y\n\
             property uchar z\nelement face {count}\nproperty list uchar uchar vertex_indices\nend_header\n",
            count % 64
        ).into_bytes();
        bytes.extend(noise);
        match parse_small(&bytes, Format::Ply) {
            Ok(soup) => check_sound(&soup),
            Err(error) => check_place(&error, &bytes),
        }
    }
}

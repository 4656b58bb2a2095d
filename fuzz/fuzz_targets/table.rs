//! XYZ, CSV and PWN files: each input is read as all three.
#![no_main]

mod check;

use medax::io::Format;

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    for format in [Format::Xyz, Format::Csv, Format::Pwn] {
        check::read(data, format);
    }
});

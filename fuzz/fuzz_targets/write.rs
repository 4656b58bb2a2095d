//! Complexes, taken from PLY files, written in every format; PLY reads back to the same bits.
#![no_main]

use medax::Job;
use medax::io::{Format, WriteOptions, parse, read_complex, write_complex};

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    let job = Job::default();
    let Ok(soup) = parse(data, Format::Ply, &job) else { return };
    let Ok(complex) = soup.into_complex() else { return };
    let Ok(folder) = tempfile::tempdir() else { return };
    for ending in ["off", "obj", "stl", "xyz", "csv", "ma", "vtu", "geojson"] {
        let path = folder.path().join("a").with_extension(ending);
        let _ = write_complex(path, &complex, WriteOptions::default(), &job);
    }
    for text in [false, true] {
        let path = folder.path().join("a.ply");
        write_complex(&path, &complex, WriteOptions { text }, &job).expect("PLY holds every soup");
        let back = read_complex(&path, &job).expect("what is written is well formed");
        let bits = |complex: &medax::Complex| -> Vec<u64> {
            complex.vertices().as_flattened().iter().map(|x| x.to_bits()).collect()
        };
        assert_eq!(bits(&complex), bits(&back));
        assert_eq!(complex.faces(), back.faces());
        assert_eq!(complex.edges(), back.edges());
    }
});

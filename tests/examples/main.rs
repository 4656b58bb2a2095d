//! The examples in Rust say and write what those in C, C++ and Python do: `expected.txt` has a line for each, with the
//! 64-bit FNV-1a hash of the file and the line that is printed.

#![allow(dead_code, reason = "the examples' own main functions")]

#[path = "../../examples/poles.rs"]
mod poles;
#[path = "../../examples/power_crust.rs"]
mod power_crust;
#[path = "../../examples/wall_thickness.rs"]
mod wall_thickness;

use std::fs;

const SCAN: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/examples/scan.xyz");
const PART: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/examples/bracket.off");

fn check(example: &str, run: impl FnOnce(&str) -> medax::Result<String>) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("out.ply");
    let counts = run(path.to_str().unwrap()).unwrap();
    let hash = fs::read(&path).unwrap().iter().fold(0xcbf2_9ce4_8422_2325_u64, |hash, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    let line = format!("{example} {hash:016x} {counts}");
    let expected = include_str!("expected.txt");
    assert!(expected.lines().any(|known| known == line), "not in expected.txt: {line}");
}

#[test]
fn poles_are_those_of_the_other_languages() {
    check("poles", |out| poles::run(SCAN, out));
}

#[test]
fn a_power_crust_is_that_of_the_other_languages() {
    check("power_crust", |out| power_crust::run(SCAN, out));
}

#[test]
fn wall_thickness_is_that_of_the_other_languages() {
    check("wall_thickness", |out| wall_thickness::run(PART, "2.5", out));
}

#[test]
fn a_limit_that_is_no_number_is_not_understood() {
    let arguments = |limit: &str| [PART, limit, "out.ply"].map(String::from);
    for (limit, is_number) in
        [("2.5", true), ("1e-3", true), ("abc", false), ("2.5mm", false), ("", false)]
    {
        assert_eq!(wall_thickness::understood(&arguments(limit)).is_some(), is_number, "{limit}");
    }
    assert!(wall_thickness::understood(&arguments("2.5")[..2]).is_none());
}

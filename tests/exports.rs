//! What the shared library exports, what the header declares and what `tests/abi/symbols.txt`
//! promises are one set; and the chapters of the C ABI hold no unsafe code of their own.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn root(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// The functions that the header declares.
fn declared() -> BTreeSet<String> {
    let header = fs::read_to_string(root("include/medax.h")).unwrap();
    let code = header.split("extern \"C\" {").nth(1).unwrap();
    let declarations = code.split("MEDAX_API").skip(1);
    declarations
        .map(|text| {
            let before = text.split('(').next().unwrap();
            let name = |c: char| !c.is_ascii_alphanumeric() && c != '_';
            before.rsplit(name).next().unwrap().to_string()
        })
        .collect()
}

#[test]
fn the_promised_symbols_are_the_declared_ones() {
    let promised = fs::read_to_string(root("tests/abi/symbols.txt")).unwrap();
    let promised: Vec<&str> = promised.lines().collect();
    let declared = declared();
    assert!(declared.len() > 30, "the header was not understood: {declared:?}");
    assert_eq!(promised, declared.iter().collect::<Vec<_>>(), "symbols.txt against the header");
}

/// Elsewhere the shared library lies, is called and is read differently.
#[cfg(target_os = "linux")]
#[test]
fn the_library_exports_the_declared_symbols_under_its_name() {
    let test = std::env::current_exe().unwrap();
    let library = test.with_file_name("libmedax.so");
    let run = |program: &str, flag: &str| {
        let output = std::process::Command::new(program).arg(flag).arg(&library).output().unwrap();
        assert!(output.status.success(), "{program}: {}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    };
    let symbols = run("nm", "-DP");
    let exported: BTreeSet<String> = symbols
        .lines()
        .map(|line| line.split(' ').collect::<Vec<_>>())
        .filter(|fields| !matches!(fields[1], "U" | "w" | "v"))
        .map(|fields| fields[0].split('@').next().unwrap().to_string())
        .collect();
    assert_eq!(exported, declared(), "{} against the header", library.display());
    let (major, minor) = (env!("CARGO_PKG_VERSION_MAJOR"), env!("CARGO_PKG_VERSION_MINOR"));
    let abi = if major == "0" { format!("0.{minor}") } else { major.to_string() };
    let dynamic = run("readelf", "-d");
    assert!(dynamic.contains(&format!("soname: [libmedax.so.{abi}]")), "{dynamic}");
}

#[test]
fn only_four_files_hold_unsafe_code() {
    let keepers = ["boundary.rs", "handle.rs", "view.rs", "options.rs"];
    let mut chapters = 0;
    for entry in fs::read_dir(root("src/capi")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap();
        if !name.ends_with(".rs") || keepers.contains(&name) {
            continue;
        }
        chapters += 1;
        for (number, line) in fs::read_to_string(&path).unwrap().lines().enumerate() {
            // An entry is exported and trusts its caller; a helper of entries passes that on.
            let left = line
                .split("//")
                .next()
                .unwrap()
                .replace("#[unsafe(no_mangle)]", "")
                .replace("unsafe extern \"C\" fn", "")
                .replace("unsafe fn", "")
                .replace("#![allow(unsafe_code, unsafe_op_in_unsafe_fn", "");
            assert!(!left.contains("unsafe"), "{name}, line {}: {line}", number + 1);
        }
    }
    assert!(chapters > 5);
}

//! Gives the shared library the name under which programs find it: `libmedax.so.<abi>`.
//!
//! The ABI is `0.<minor>` before version 1 and `<major>` after, as cargo-c has it.

use std::env;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    let variable = |name: &str| env::var(name).unwrap_or_default();
    let (major, minor) = (variable("CARGO_PKG_VERSION_MAJOR"), variable("CARGO_PKG_VERSION_MINOR"));
    let abi = if major == "0" { format!("0.{minor}") } else { major };
    match variable("CARGO_CFG_TARGET_OS").as_str() {
        "macos" => {
            let name = format!("@rpath/libmedax.{abi}.dylib");
            println!("cargo:rustc-cdylib-link-arg=-Wl,-install_name,{name}");
        }
        // The import library carries the name there.
        "windows" => {}
        _ => println!("cargo:rustc-cdylib-link-arg=-Wl,-soname,libmedax.so.{abi}"),
    }
}

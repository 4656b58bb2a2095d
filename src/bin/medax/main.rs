//! The medax program.

fn main() {}

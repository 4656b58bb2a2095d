//! The library's structures, from points to power crusts, over sets that break such programs.

mod job;
mod points;
mod sets;
mod triangulation;

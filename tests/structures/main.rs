//! The library's structures, from points to power crusts, over sets that break such programs.

mod crust;
mod job;
mod points;
mod sets;
mod triangulation;

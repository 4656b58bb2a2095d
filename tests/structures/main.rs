//! The library's structures, from points to power crusts, over sets that break such programs.

mod crust;
mod dual;
mod generated;
mod job;
mod points;
mod poles;
mod relabel;
mod sets;
mod triangulation;
mod variants;

//! The library's structures, from points to power crusts, over sets that break such programs.

mod authors_failures;
mod cocone;
mod crust;
mod dual;
mod generated;
mod job;
mod labels;
mod points;
mod poles;
mod relabel;
mod sets;
mod sizes;
mod triangulation;
mod variants;

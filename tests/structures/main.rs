//! The library's structures, from points to power crusts, over sets that break such programs.

mod authors_failures;
mod cocone;
mod crust;
mod dual;
mod flow;
mod flow_reference;
mod flow_wedges;
mod generated;
mod job;
mod labels;
mod medial;
mod points;
mod poles;
mod relabel;
mod scale_axis;
mod sets;
mod sizes;
mod triangulation;
mod variants;

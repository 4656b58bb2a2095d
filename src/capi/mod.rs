//! The C ABI: it translates and does nothing else. Its manual is `include/medax.h`, which
//! cbindgen makes from these files, one chapter a file.
//!
//! Exporting a symbol and trusting a pointer from C are unsafe, and cannot be otherwise: every
//! entry is an `unsafe fn` whose contract is the header's text. What touches a pointer lies in
//! four files, each with its reasons: `boundary` (panics, the callback), `handle` (reference
//! counts), `view` (arrays, strings, outputs), `options` (sized structs). The chapters only call
//! them: they contain no unsafe block, and `tests/exports.rs` checks that they never will.

#![allow(unsafe_code, unsafe_op_in_unsafe_fn, clippy::missing_safety_doc)]
#![allow(non_camel_case_types, reason = "the names of the header")]

mod boundary;
mod handle;
mod options;
mod view;

mod attribute;
mod balls;
mod cocone;
mod compare;
mod complex;
mod core;
mod crust;
mod decide;
mod decimate;
mod distance;
mod dual;
mod field_axis;
mod figure;
mod file;
mod flatten;
mod flow;
mod flow_complex;
mod half_faces;
mod incidence;
mod io;
mod job;
mod labels;
mod medial;
mod medial_graph;
mod medial_points;
mod normals;
mod onto;
mod pair;
mod place;
mod points;
mod poles;
mod relabel;
mod sample;
mod sites;
mod sizes;
mod status;
mod topology;
mod triangulation;
mod validation;
mod variants;
mod winding;

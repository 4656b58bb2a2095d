//! Complexes: validity, topology, intersections, orientation, comparison, decimation, flattening.

mod compare;
mod decimate;
mod flatten;
mod intersections;
mod models;
mod orient;
mod shapes;
mod topology;

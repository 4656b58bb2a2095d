//! Complexes: validity, topology, intersections, orientation, comparison, decimation, flattening, winding numbers.

mod compare;
mod decimate;
mod flatten;
mod intersections;
mod models;
mod orient;
mod shapes;
mod topology;
mod winding;

//! Complexes: validity, topology, intersections, orientation, comparison, decimation, winding numbers.

mod compare;
mod decimate;
mod intersections;
mod models;
mod orient;
mod shapes;
mod topology;
mod winding;

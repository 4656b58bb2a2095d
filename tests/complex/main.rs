//! Complexes: validity, topology, intersections, orientation, normals, comparison, decimation, flattening, winding numbers.

mod compare;
mod decimate;
mod flatten;
mod intersections;
mod models;
mod normals;
mod orient;
mod shapes;
mod topology;
mod winding;

//! Complexes: validity, topology, intersections, orientation, comparison.

mod compare;
mod intersections;
mod models;
mod orient;
mod shapes;
mod topology;

//! Complexes: validity, topology, orientation, comparison.

mod compare;
mod models;
mod orient;
mod shapes;
mod topology;

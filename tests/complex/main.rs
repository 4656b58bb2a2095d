//! Complexes: validity, topology, orientation, comparison, decimation.

mod compare;
mod decimate;
mod models;
mod orient;
mod shapes;
mod topology;

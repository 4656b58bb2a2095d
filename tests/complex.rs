//! Complexes: validity, topology, orientation, comparison.

#[path = "complex/compare.rs"]
mod compare;
#[path = "complex/orient.rs"]
mod orient;
#[path = "complex/shapes.rs"]
mod shapes;
#[path = "complex/topology.rs"]
mod topology;

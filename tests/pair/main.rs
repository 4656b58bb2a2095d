//! Pair-meshes.

mod exact;
mod models;
mod onto;
mod partition;
mod points;
mod shapes;
mod surfaces;
mod uses;

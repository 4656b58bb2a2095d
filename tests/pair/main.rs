//! Pair-meshes.

mod exact;
mod partition;
mod points;
mod shapes;
mod surfaces;
mod uses;

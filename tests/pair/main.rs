//! Pair-meshes.

mod partition;
mod shapes;
mod surfaces;
mod uses;

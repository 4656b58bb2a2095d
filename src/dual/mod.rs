//! Voronoi and power diagrams, read off a triangulation.

mod center;
mod double_double;
mod exact;

pub use center::{Center, circumcenter, orthocenter};

/// To come.
pub struct Dual;

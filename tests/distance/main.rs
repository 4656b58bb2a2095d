//! Distances to sites, and the medial axes read off them.

mod graph;
mod nearest;
mod plane;
mod shapes;
mod theorem;

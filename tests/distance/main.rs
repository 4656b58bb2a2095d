//! Distances to sites, and the medial axes read off them.

mod balls;
mod crowd;
mod exact;
mod figures;
mod graph;
mod nearest;
mod plane;
mod shapes;
mod space;
mod surface;
mod theorem;

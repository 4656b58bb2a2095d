//! The medial axis of a boundary in the plane as a graph: arcs that meet in junctions.
//!
//! A point of the boundary has one largest ball that touches it from one side and holds no other point of the boundary. Its centre runs along the medial axis while the point runs
//! along the boundary, each arc once from either side. What the ball touches on the other side changes where it touches three features or more: in a junction. So arcs are read off
//! walks along the boundary, and nothing of the axis can be missed that does not show from either of its two sides.

mod envelope;
mod feature;
mod frame;
mod graph;
mod sides;
mod walk;

pub use graph::{GraphOptions, MedialGraph};

//! Distances to sites, and the medial axis read off their gradient (Stolpner, Whitesides, *Medial axis approximation with bounded error*). See
//! `docs/algorithms/distance.md`.

mod arcs;
mod balls;
mod bound;
mod closest;
mod crossing;
mod decide;
mod field;
mod locate;
mod nearest;
mod pairs;
mod piece;
mod plane;
mod side;
mod sites;
mod space;
mod surface;
mod tree;
mod validate;

pub use arcs::{GraphOptions, MedialGraph};
pub use balls::{Balls, BoundaryOptions};
pub use bound::largest_missed_angle;
pub use decide::{DecideOptions, DecideTest, Decision};
pub use field::{Cover, FieldAxis, FieldOptions};
pub use locate::MedialPoint;
pub use nearest::AllNearest;
pub use piece::Piece;
pub use sites::{Nearest, Sites};

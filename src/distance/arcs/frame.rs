//! A boundary in coordinates of its own.

use crate::distance::locate::MedialPoint;
use crate::distance::piece::Piece;
use crate::distance::side::Solid;
use crate::distance::sites::Sites;
use crate::error::Result;
use crate::job::{Room, Run};
use crate::points::Bounds;
use crate::vector::{Vec3, add, sub};
use std::sync::Arc;

/// A boundary that is moved to the origin, if it is farther from there than it is long. Each coordinate is then at least half, and at most twice what is taken off, so that no difference is
/// rounded; and what is calculated of the rest is as exact as if the boundary had been there from the beginning.
pub(super) struct Frame {
    pub sites: Arc<Sites>,
    origin: Vec3,
}

impl Frame {
    pub fn new(sites: &Arc<Sites>, run: &Run<'_>) -> Result<Self> {
        let origin = sites.bounds().map_or([0.0; 3], |Bounds { min, max }| {
            [0, 1, 2].map(|k| {
                let middle = 0.5 * (min[k] + max[k]);
                if middle.abs() >= max[k] - min[k] { middle } else { 0.0 }
            })
        });
        let is_bounded = sites.pieces().iter().all(|piece| piece.bounds().is_some());
        if origin == [0.0; 3] || !is_bounded {
            return Ok(Frame { sites: sites.clone(), origin: [0.0; 3] });
        }
        let mut room = Room::new(run);
        let moved = room.collect(sites.pieces().iter().map(|&piece| match piece {
            Piece::Point(p) => Piece::Point(sub(p, origin)),
            Piece::Segment(ends) => Piece::Segment(ends.map(|p| sub(p, origin))),
            Piece::Sphere(center, radius) => Piece::Sphere(sub(center, origin), radius),
            Piece::Ray(..) | Piece::Line(..) | Piece::Triangle(_) => piece,
        }))?;
        let site_of_piece = room.collect(sites.site_of_piece().iter().copied())?;
        let moved = Sites::new_in(sites.dimension(), moved, site_of_piece, run)?;
        let moved = match &sites.solid {
            Solid::Curves(is_closed) => moved.with_closed(is_closed.clone())?,
            Solid::None | Solid::Mesh(_) => moved,
        };
        Ok(Frame { sites: Arc::new(moved), origin })
    }

    /// A box in these coordinates.
    pub fn inward(&self, Bounds { min, max }: Bounds) -> Bounds {
        Bounds { min: sub(min, self.origin), max: sub(max, self.origin) }
    }

    /// A medial point in those of the boundary.
    pub fn outward(&self, point: MedialPoint) -> MedialPoint {
        let center = add(point.center, self.origin);
        MedialPoint { center, feet: point.feet.map(|foot| add(foot, self.origin)), ..point }
    }
}

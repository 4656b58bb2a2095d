//! The far box: eight points round a sample, so that every sample has a bounded Voronoi cell.

use super::{Bounds, Points, check_coordinates};
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use std::sync::OnceLock;

/// Half the far box's side, in half extents of the longest side of the sample's bounding box.
///
/// Amenta, Choi, Kolluri 2001, section 3.2, ask for a box "sufficiently large"; at five times
/// the sample's own size the outer poles near it stay clear of the surface.
pub const FAR_BOX_FACTOR: f64 = 5.0;

/// The number of points of the far box.
pub const FAR_BOX_LEN: usize = 8;

impl Points {
    /// The sample with the far box Z of the power crust: the corners of a cube round the centre of
    /// the bounding box, [`FAR_BOX_FACTOR`] times as large.
    ///
    /// The samples keep their numbers, and Z comes after them, outside the spatial order and
    /// without input rows. Errors: [`Status::CoordinateRange`] where the box would leave the
    /// range of coordinates, and those of the job.
    pub fn with_far_box(&self, job: &Job) -> Result<Points> {
        job.run(&[(Stage::Order, 1.0)], |run| self.with_far_box_in(run))
    }

    /// [`Points::with_far_box`] as a part of a larger build.
    pub(crate) fn with_far_box_in(&self, run: &Run<'_>) -> Result<Points> {
        let mut room = Room::new(run);
        let Bounds { min, max } = self.bounds;
        let half = self.bounds.extent().into_iter().fold(0.0, f64::max) / 2.0 * FAR_BOX_FACTOR;
        let mut coords = room.vec(self.len() + FAR_BOX_LEN)?;
        coords.extend_from_slice(&self.coords);
        for corner in 0..FAR_BOX_LEN {
            let xyz = std::array::from_fn(|axis| {
                let centre = min[axis] / 2.0 + max[axis] / 2.0;
                if corner >> axis & 1 == 0 { centre - half } else { centre + half }
            });
            coords.push(check_coordinates(xyz).map_err(|_| {
                Error::new(
                    Status::CoordinateRange,
                    "the far box leaves the range of coordinates; rescale the points",
                )
            })?);
        }
        let mut row_of_vertex = room.vec(self.len() + FAR_BOX_LEN)?;
        row_of_vertex.extend_from_slice(&self.row_of_vertex);
        row_of_vertex.extend([NONE; FAR_BOX_LEN]);
        Ok(Points {
            bounds: Bounds::of(coords.iter().copied()).unwrap_or(self.bounds),
            coords,
            row_of_vertex,
            vertex_of_row: room.collect(self.vertex_of_row.iter().copied())?,
            duplicate_of: OnceLock::new(),
            duplicate_count: self.duplicate_count,
            skipped_count: self.skipped_count,
        })
    }
}

//! Points of a medial axis as columns, which C sees as they lie.

use super::view::{medax_view_f64, medax_view_u32};
use crate::distance::{MedialPoint, Sites};
use crate::error::Result;
use crate::job::{Room, Run};

/// A row of each array for each point, in their order.
pub(super) struct MedialPoints {
    centers: Vec<[f64; 3]>,
    radii: Vec<f64>,
    object_angles: Vec<f64>,
    feet: Vec<[[f64; 3]; 2]>,
    pieces: Vec<[u32; 2]>,
    sites: Vec<[u32; 2]>,
}

impl MedialPoints {
    pub(super) fn new(points: &[MedialPoint], sites: &Sites, run: &Run<'_>) -> Result<Self> {
        let mut room = Room::new(run);
        let site = |piece: u32| sites.site_of_piece()[piece as usize];
        Ok(MedialPoints {
            centers: room.collect(points.iter().map(|point| point.center))?,
            radii: room.collect(points.iter().map(|point| point.radius))?,
            object_angles: room.collect(points.iter().map(|point| point.object_angle))?,
            feet: room.collect(points.iter().map(|point| point.feet))?,
            pieces: room.collect(points.iter().map(|point| point.pieces))?,
            sites: room.collect(points.iter().map(|point| point.pieces.map(site)))?,
        })
    }

    pub(super) fn centers(of: Option<&Self>) -> medax_view_f64 {
        medax_view_f64::new(of.map_or(&[][..], |points| points.centers.as_flattened()), 3)
    }

    pub(super) fn radii(of: Option<&Self>) -> medax_view_f64 {
        medax_view_f64::new(of.map_or(&[][..], |points| &points.radii), 1)
    }

    pub(super) fn object_angles(of: Option<&Self>) -> medax_view_f64 {
        medax_view_f64::new(of.map_or(&[][..], |points| &points.object_angles), 1)
    }

    pub(super) fn feet(of: Option<&Self>) -> medax_view_f64 {
        let feet = of.map_or(&[][..], |points| points.feet.as_flattened());
        medax_view_f64::new(feet.as_flattened(), 6)
    }

    pub(super) fn pieces(of: Option<&Self>) -> medax_view_u32 {
        medax_view_u32::new(of.map_or(&[][..], |points| points.pieces.as_flattened()), 2)
    }

    pub(super) fn sites(of: Option<&Self>) -> medax_view_u32 {
        medax_view_u32::new(of.map_or(&[][..], |points| points.sites.as_flattened()), 2)
    }
}

//! Filters: which Voronoi facets belong to the axis.

use super::Medial;
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::labels::Labels;
use crate::points::COORDINATE_MAX;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_8, PI};

/// Which of the two conditions of MEDIAL decide. The numbers are the C ABI's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u32)]
pub enum MedialRule {
    /// Either is enough: MEDIAL itself.
    #[default]
    AngleOrRatio = 0,
    /// The angle condition alone (section 3.1, Figure 5).
    Angle = 1,
    /// The ratio condition alone (section 3.2, Figure 7).
    Ratio = 2,
    /// Neither: all facets, those of the surface as well, for the other thresholds to choose from.
    Every = 3,
}

/// On which side of the surface. The numbers are the C ABI's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u32)]
pub enum Side {
    /// Facets of which every cell round the dual edge is outer.
    Outer = 0,
    /// Facets of which every cell round the dual edge is inner.
    #[default]
    Inner = 1,
    /// All facets, those that cross the surface as well. The only one that needs no labels.
    Both = 2,
}

impl Side {
    /// The side of a face of the Voronoi diagram: inner or outer if all cells round it are. What is outside the hull is outer, be it [`NONE`] among the cells or where the
    /// face is unbounded. Both if the face crosses the surface.
    pub(crate) fn of(labels: &Labels, cells: &[u32], is_unbounded: bool) -> Side {
        let is_inner = |&cell: &u32| cell != NONE && labels.is_inner()[cell as usize];
        match (cells.iter().all(is_inner), cells.iter().any(is_inner)) {
            (true, _) if !is_unbounded => Side::Inner,
            (_, false) => Side::Outer,
            _ => Side::Both,
        }
    }
}

/// Thresholds on the facets of a [`Medial`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MedialFilter {
    /// Which conditions decide; either is enough by default.
    pub rule: MedialRule,
    /// The threshold of the angle condition, in radians in [0, pi/2); pi/8 by default, the paper's.
    pub theta: f64,
    /// The threshold of the ratio condition, not negative; 8 by default, the paper's.
    pub rho: f64,
    /// The least object angle, in radians in [0, pi]: some point of the facet must have as much; 0 by default.
    pub object_angle: f64,
    /// The least lambda, in input units: half the length of the dual edge, the radius of the smallest ball round the nearest samples of a point
    /// within the facet (Chazal, Lieutier 2005, *The lambda-medial axis*); 0 by default.
    pub lambda: f64,
    /// The least pairwise scale ([`Medial::scales`]): the ball of some corner of the facet must have more; 0 by default, which asks for
    /// nothing.
    pub scale: f64,
    /// The inner axis by default.
    pub side: Side,
    /// The corners, least and largest, of a box to which the axis is clipped, so that it keeps its unbounded facets; no coordinate is beyond 2^200. Without it, as by
    /// default, these are left out.
    pub clip: Option<[[f64; 3]; 2]>,
}

impl Default for MedialFilter {
    fn default() -> Self {
        MedialFilter {
            rule: MedialRule::default(),
            theta: FRAC_PI_8,
            rho: 8.0,
            object_angle: 0.0,
            lambda: 0.0,
            scale: 0.0,
            side: Side::default(),
            clip: None,
        }
    }
}

impl MedialFilter {
    /// Errors: [`Status::InvalidArgument`] for what is out of range, or asks for what was not calculated; [`Status::CoordinateRange`] for a box
    /// beyond 2^200.
    pub(super) fn check(&self, medial: &Medial) -> Result<()> {
        let refuse = |message: &str| Err(Error::new(Status::InvalidArgument, message));
        if !(0.0..FRAC_PI_2).contains(&self.theta) {
            return refuse("theta is an angle in [0, pi/2), in radians");
        }
        if self.rho.is_nan() || self.rho < 0.0 {
            return refuse("rho is a ratio of lengths and not negative");
        }
        if !(0.0..=PI).contains(&self.object_angle) {
            return refuse("an object angle lies in [0, pi], in radians");
        }
        if self.lambda.is_nan() || self.lambda < 0.0 {
            return refuse("lambda is a length and not negative");
        }
        if self.scale.is_nan() || self.scale < 0.0 {
            return refuse("a scale is not negative");
        }
        if self.scale > 0.0 && medial.scales.is_empty() {
            return refuse("scales were not asked for when the facets' attributes were calculated");
        }
        if self.side != Side::Both && medial.labels.is_none() {
            return refuse("without labels inner and outer facets cannot be told apart");
        }
        let is_box = |[low, high]: &[[f64; 3]; 2]| {
            (0..3).all(|k| low[k] < high[k] && low[k].is_finite() && high[k].is_finite())
        };
        if self.clip.as_ref().is_some_and(|clip| !is_box(clip)) {
            return refuse("a box has a finite least corner and a larger finite largest one");
        }
        let is_in_range =
            |clip: &[[f64; 3]; 2]| clip.as_flattened().iter().all(|x| x.abs() <= COORDINATE_MAX);
        if self.clip.as_ref().is_some_and(|clip| !is_in_range(clip)) {
            let message = "a coordinate of the box lies beyond 2^200";
            return Err(Error::new(Status::CoordinateRange, message));
        }
        Ok(())
    }
}

/// Which conditions a facet fulfils from either end, as bits: 1 the angle condition, 2 the ratio condition.
pub(super) fn fulfilled(sines: [f64; 2], ratios: [f64; 2], sine: f64, rho: f64) -> u32 {
    let angle = sines.iter().any(|&s| s > sine);
    let ratio = ratios.iter().any(|&r| r > rho);
    u32::from(angle) | u32::from(ratio) << 1
}

impl MedialRule {
    /// Whether the conditions that a facet fulfils are enough.
    pub(super) fn admits(self, fulfilled: u32) -> bool {
        match self {
            MedialRule::AngleOrRatio => fulfilled != 0,
            MedialRule::Angle => fulfilled & 1 != 0,
            MedialRule::Ratio => fulfilled & 2 != 0,
            MedialRule::Every => true,
        }
    }
}

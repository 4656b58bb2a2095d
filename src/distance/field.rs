//! The medial axis by sampling the gradient of the distance: points as dense as they are asked for.

use super::decide::DecideOptions;
use super::locate::MedialPoint;
use super::pairs::SitePairs;
use super::sites::Sites;
use super::{plane, space};
use crate::complex::{Attribute, Complex, ComplexParts, Element, Values};
use crate::error::{Error, Result, Status};
use crate::job::{Job, Run, Stage};
use crate::medial::Side;
use crate::points::COORDINATE_MAX;
use std::f64::consts::PI;
use std::sync::Arc;

/// Which points of the medial axis, how dense, and how near to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldOptions {
    /// On which side of the boundary; inside by default. Where there is no inside, as for open curves, all is outside.
    pub side: Side,
    /// Within this distance of what of the medial axis is found there is a point, in input units. 0, the default, asks for a hundredth of the size of the boundary's box.
    pub density: f64,
    /// The least object angle of a point, in radians in [0, pi]; 0 by default.
    pub angle: f64,
    /// The least distance of a point from the boundary, in input units. 0, the default, asks for a quarter of the density in the plane, where it bounds how fine the cover gets; in space
    /// for nothing.
    pub min_distance: f64,
    /// Keep only what has its nearest points on two sites; off by default. With sites that are not convex the rest is no part of their Voronoi diagram.
    pub between_sites: bool,
    /// In the plane the largest object angle that a point may have and be missed, in radians in (0, pi); pi / 9 by default.
    pub bound: f64,
    /// The number of points at which each circle or sphere is looked at, at least 12. 0, the default, asks for as many as the bound takes in the plane, for 60 in space.
    pub samples: usize,
    /// The corners of a box that holds what is looked at. `None`, the default: the boundary's box, inside; outside the same, as much larger on each side as half its diagonal is long.
    pub clip: Option<[[f64; 3]; 2]>,
    /// How near is near.
    pub decide: DecideOptions,
}

impl Default for FieldOptions {
    fn default() -> Self {
        FieldOptions {
            side: Side::Inner,
            density: 0.0,
            angle: 0.0,
            min_distance: 0.0,
            between_sites: false,
            bound: PI / 9.0,
            samples: 0,
            clip: None,
            decide: DecideOptions::default(),
        }
    }
}

/// A circle in the plane or a sphere in space that was looked at, for the square or the cube in its middle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cover {
    /// The centre.
    pub center: [f64; 3],
    /// The radius, in input units.
    pub radius: f64,
    /// Half the side of the square or cube.
    pub half: f64,
    /// In the plane the longest arc between points that were looked at; 0 in space.
    pub gap: f64,
    /// The distance of the centre from the boundary.
    pub distance: f64,
    /// The number of points that it gave.
    pub found: u32,
    /// The largest object angle of a point of the medial axis within the square that is at least `min_distance` from the boundary and has no point of the result within
    /// the density, in radians: 0 where there is such a point, else what theorem 10 says. Pi stands for no claim: in space, and where what was found did not pass the thresholds.
    pub missed_angle: f64,
}

/// Points of the medial axis, and where they were looked for.
///
/// Invariants: `points` and `cover_of_point` have the same length; the points of a cover lie in it, one after the other, covers ascend.
#[derive(Clone, Debug)]
pub struct FieldAxis {
    pub(super) sites: Arc<Sites>,
    pub(super) options: FieldOptions,
    pub(super) pairs: SitePairs,
    pub(super) points: Vec<MedialPoint>,
    pub(super) cover_of_point: Vec<u32>,
    pub(super) covers: Vec<Cover>,
    pub(super) unconfirmed: usize,
}

impl FieldAxis {
    /// Finds points of the medial axis: the paper's APPROXMA2D in the plane, APPROXMA3D in space.
    ///
    /// Errors: [`Status::InvalidArgument`] for options out of range; [`Status::LimitExceeded`] for a density of less than 2^-20 of the box, and where the density or the least distance ask for more than 2^28 circles or spheres; those of
    /// the job. Cost: in the plane O(length / `min_distance` + area / density^2) circles; in space O(area / density^2) spheres; each some queries for each sample.
    pub fn new(sites: &Arc<Sites>, options: FieldOptions, job: &Job) -> Result<Self> {
        job.run(&[(Stage::Field, 1.0)], |run| FieldAxis::new_in(sites, options, run))
    }

    /// [`FieldAxis::new`] as a stage of a larger build.
    pub(crate) fn new_in(sites: &Arc<Sites>, options: FieldOptions, run: &Run<'_>) -> Result<Self> {
        FieldAxis::of(sites, options, SitePairs::any(options.between_sites), run)
    }

    /// The same, of which only what has its nearest points on one of some pairs of sites is looked for: pieces of the sites' Voronoi diagram. A pair of a site with itself asks for the
    /// parts of the medial axis that belong to that site alone.
    ///
    /// Errors: as [`FieldAxis::new`]; [`Status::InvalidArgument`] with the row of a pair that names no site.
    pub fn between(
        sites: &Arc<Sites>,
        pairs: &[[u32; 2]],
        options: FieldOptions,
        job: &Job,
    ) -> Result<Self> {
        job.run(&[(Stage::Field, 1.0)], |run| FieldAxis::between_in(sites, pairs, options, run))
    }

    /// [`FieldAxis::between`] as a stage of a larger build.
    pub(crate) fn between_in(
        sites: &Arc<Sites>,
        pairs: &[[u32; 2]],
        options: FieldOptions,
        run: &Run<'_>,
    ) -> Result<Self> {
        let pairs = SitePairs::of(sites, options.between_sites, pairs)?;
        FieldAxis::of(sites, options, pairs, run)
    }

    fn of(
        sites: &Arc<Sites>,
        options: FieldOptions,
        pairs: SitePairs,
        run: &Run<'_>,
    ) -> Result<Self> {
        run.enter(Stage::Field)?;
        let options = options.resolved(sites)?;
        match sites.dimension() {
            2 => plane::axis(sites, options, pairs, run),
            _ => space::axis(sites, options, pairs, run),
        }
    }

    /// What distances were measured to.
    pub fn sites(&self) -> &Arc<Sites> {
        &self.sites
    }

    /// What was asked for, with the defaults in numbers.
    pub fn options(&self) -> &FieldOptions {
        &self.options
    }

    /// The points.
    pub fn points(&self) -> &[MedialPoint] {
        &self.points
    }

    /// For each point the circle or sphere in which it was found.
    pub fn cover_of_point(&self) -> &[u32] {
        &self.cover_of_point
    }

    /// In the plane all circles that were looked at in the end; in space the spheres that gave a point.
    pub fn covers(&self) -> &[Cover] {
        &self.covers
    }

    /// How often a test fired of which no point came.
    pub fn unconfirmed(&self) -> usize {
        self.unconfirmed
    }

    /// The largest object angle that a point beyond the least distance may have and be missed, and the number of circles that make no claim, where it may be any. In space there
    /// is never a claim.
    pub fn claim(&self) -> (f64, usize) {
        let has_claim = |cover: &&Cover| cover.missed_angle < PI;
        let most = self.covers.iter().filter(has_claim).map(|cover| cover.missed_angle);
        (most.fold(0.0, f64::max), self.covers.iter().filter(|c| c.missed_angle >= PI).count())
    }

    /// The points as vertices, which carry `radius`, `object_angle`, `feet` (the two nearest points, six coordinates), `pieces`, `sites` (of these) and `missed_angle` (that of their cover).
    pub fn complex(&self, job: &Job) -> Result<Complex> {
        job.run(&[(Stage::Extract, 1.0)], |run| {
            run.enter(Stage::Extract)?;
            let attributes = self.sites.attributes_of(Element::Vertex, &self.points, run)?;
            let missed = self.cover_of_point.iter().map(|&c| self.covers[c as usize].missed_angle);
            let missed = Values::F64(missed.collect());
            let missed = Attribute::new("missed_angle", Element::Vertex, 1, missed)?;
            let parts = ComplexParts {
                dimension: self.sites.dimension(),
                vertices: self.points.iter().map(|point| point.center).collect(),
                attributes: attributes.into_iter().chain([missed]).collect(),
                ..ComplexParts::default()
            };
            Complex::new_in(parts, run)
        })
    }
}

impl Sites {
    /// What vertices carry that are medial points, or faces and edges that stand for them.
    pub(super) fn attributes_of(
        &self,
        element: Element,
        points: &[MedialPoint],
        run: &Run<'_>,
    ) -> Result<Vec<Attribute>> {
        run.poll()?;
        let of = |value: fn(&MedialPoint) -> f64| Values::F64(points.iter().map(value).collect());
        let feet = points.iter().flat_map(|point| point.feet.as_flattened().iter().copied());
        let pieces = points.iter().flat_map(|point| point.pieces);
        let sites = pieces.clone().map(|piece| self.site_of_piece()[piece as usize]);
        Ok(vec![
            Attribute::new("radius", element, 1, of(|point| point.radius))?,
            Attribute::new("object_angle", element, 1, of(|point| point.object_angle))?,
            Attribute::new("feet", element, 6, Values::F64(feet.collect()))?,
            Attribute::new("pieces", element, 2, Values::U32(pieces.collect()))?,
            Attribute::new("sites", element, 2, Values::U32(sites.collect()))?,
        ])
    }
}

impl FieldOptions {
    /// Whether a point passes the thresholds.
    pub(super) fn pass(&self, point: &MedialPoint) -> bool {
        point.object_angle >= self.angle && point.radius >= self.min_distance
    }

    /// The same with numbers for defaults.
    fn resolved(mut self, sites: &Sites) -> Result<Self> {
        let wrong = |message: String| Err(Error::new(Status::InvalidArgument, message));
        for (name, value) in [("density", self.density), ("least distance", self.min_distance)] {
            if !(0.0..=COORDINATE_MAX).contains(&value) {
                return wrong(format!("a {name} of {value} is no length"));
            }
        }
        if !(0.0..=PI).contains(&self.angle) {
            return wrong(format!("an object angle of {} is not between 0 and pi", self.angle));
        }
        if !(self.bound > 0.0 && self.bound < PI) {
            return wrong(format!("a bound of {} is not between 0 and pi", self.bound));
        }
        if self.samples != 0 && !(12..=1 << 20).contains(&self.samples) {
            return wrong(format!("{} samples are not between 12 and 2^20", self.samples));
        }
        if self.density == 0.0 {
            self.density = 0.01 * sites.size();
        }
        if self.min_distance == 0.0 && sites.dimension() == 2 {
            self.min_distance = 0.25 * self.density;
        }
        if let Some([min, max]) = self.clip {
            let is_box = (0..sites.dimension() as usize).all(|k| min[k] < max[k]);
            let in_range = min.iter().chain(&max).all(|x| x.abs() <= COORDINATE_MAX);
            if !(is_box && in_range) {
                return wrong("the corners of the box to clip to are no box".into());
            }
        } else {
            let Some(bounds) = sites.bounds() else {
                return wrong("without a box to clip to, what is unbounded has no end".into());
            };
            let margin = match self.side {
                Side::Inner => 0.0,
                Side::Outer | Side::Both => 0.5 * sites.size(),
            };
            self.clip = Some([bounds.min.map(|x| x - margin), bounds.max.map(|x| x + margin)]);
        }
        let search = sites.search(self.decide)?;
        self.decide = DecideOptions { tolerance: search.tolerance, epsilon: search.epsilon };
        Ok(self)
    }
}

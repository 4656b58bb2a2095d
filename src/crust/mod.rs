//! The power crust: a watertight surface from samples, and the power shape, an approximation of
//! the medial axis (Amenta, Choi, Kolluri 2001, *The Power Crust*).
//!
//! The Voronoi diagram of the samples gives their poles; the poles' balls, labelled inner and
//! outer, describe the solid and its complement; the facets of the balls' power diagram
//! between inner and outer cells are the surface.

mod balls;
mod conflict;
mod cut;
mod derive;
mod division;
mod export;
mod holes;
mod label;
mod links;
mod places;
mod queue;
mod relabel;
mod scale_axis;
mod shape;
mod shards;
mod simplify;
mod sizes;
mod spread;
mod surface;
mod validate;

pub use holes::{HoleOptions, OpenSurface};
pub use label::{CONFLICT_LIMIT, Label, LabelRule};
pub use simplify::{Simplified, SimplifyOptions};
pub use sizes::Sizes;

use crate::complex::Complex;
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use crate::points::Points;
use crate::poles::{Poles, PolesOptions};
use crate::triangulation::Triangulation;
use division::Division;
use label::LabelAccount;
use sizes::SizeIndex;
use std::sync::{Arc, OnceLock};
use surface::Shards;

/// What to build.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerCrustOptions {
    /// Neighbouring balls intersect deeply, and so lie on the same side, where -cos of the angle
    /// between their spheres exceeds this; in [0, 1], 0.4 by default (the paper's angle alpha is
    /// arccos(-0.4), about 114 degrees).
    pub deep: f64,
    /// Take the power diagram of balls whose centres are rounded to a grid, which is faster; off by default.
    ///
    /// The step of the grid is 2^-36 of the least power of two that the longest side of the samples' box does
    /// not exceed, but 2^-160 at least. Each ball then reaches to its own sample, the least whose pole it is: its weight
    /// is the squared distance from there to the rounded centre, rounded to 53 bits and to the square of the step.
    /// Poles that come to lie at the same place are one vertex of the triangulation, and the heaviest counts. Offsets and
    /// simplified crusts are made of the exact balls.
    pub round_poles: bool,
    /// Keep the shards of every sample, the vertices of the power diagram that are the sample itself but for the rounding of the
    /// balls; off by default: the surface then passes through the samples exactly, with one vertex for each.
    pub keep_shards: bool,
    /// How poles are labelled.
    pub label_rule: LabelRule,
    /// Where the scanner of a one-sided scan was: what it sees a sample from is outside. None by default.
    ///
    /// Labels then spread from there, and not from the far box, since what lies behind a wall that was seen from one side only is not outside. Each
    /// pole is linked with the viewpoint by the mean cosine, over its samples, of the angle between the direction to the pole and that to the viewpoint.
    pub viewpoint: Option<[f64; 3]>,
    /// Which poles are left out, where the poles have not been chosen yet.
    pub poles: PolesOptions,
}

impl Default for PowerCrustOptions {
    fn default() -> Self {
        PowerCrustOptions {
            deep: 0.4,
            round_poles: false,
            keep_shards: false,
            label_rule: LabelRule::Auto,
            viewpoint: None,
            poles: PolesOptions::default(),
        }
    }
}

/// A power crust with all that it was made from.
///
/// Invariants: every pole has a label; no inner pole has an unbounded power cell; `surface` is
/// closed, and a manifold, in its own indices: each directed side of a face occurs once, and so
/// does its reverse; its faces are exactly the power facets between inner and outer poles,
/// oriented from inner to outer. Vertices of `regular` and poles are matched by `regular`'s
/// maps: poles are its input rows.
#[derive(Clone, Debug)]
pub struct PowerCrust {
    options: PowerCrustOptions,
    poles: Arc<Poles>,
    balls: Balls,
    shards: Shards,
    regular: Arc<Triangulation>,
    labels: Vec<Label>,
    account: LabelAccount,
    surface: Arc<Complex>,
    inner_shape: Arc<Complex>,
    outer_shape: Arc<Complex>,
    /// For [`PowerCrust::sizes_at`]; made when that is first asked.
    size_index: OnceLock<SizeIndex>,
}

/// The balls of a power crust.
#[derive(Clone, Debug)]
enum Balls {
    /// Those of the poles.
    Poles,
    /// Of each pole the centre, with another weight, or none.
    Changed(Vec<Option<f64>>),
}

impl PowerCrust {
    /// The power crust of a sample.
    ///
    /// Where no pole is inner the surface is empty: the sample is too sparse for its shape. Errors:
    /// [`Status::TooFewPoints`] below four distinct points or four poles, [`Status::Degenerate`]
    /// where all points or all poles lie in a plane, [`Status::CoordinateRange`] where poles leave
    /// the range of the predicates, [`Status::InvalidArgument`] for options out of range, and those of
    /// the job. Cost: that of two triangulations, of the n samples and of their at most 2 n
    /// poles, nearly all of it in the second.
    pub fn build(points: &Arc<Points>, options: PowerCrustOptions, job: &Job) -> Result<Self> {
        let plan = [
            (Stage::Triangulate, 0.2),
            (Stage::Dual, 0.06),
            (Stage::Poles, 0.04),
            (Stage::Order, 0.05),
            (Stage::Regular, 0.45),
            (Stage::Label, 0.1),
            (Stage::Extract, 0.1),
        ];
        job.run(&plan, |run| {
            let mut room = Room::new(run);
            let poles = Arc::new(Poles::with_far_box_in(points, options.poles, run)?);
            room.keep(poles.bytes())?;
            PowerCrust::from_poles_in(poles, options, run)
        })
    }

    /// The power crust of poles that [`Poles::with_far_box`] chose, without choosing them again: which are left out was decided then.
    ///
    /// Errors: as [`PowerCrust::build`], and [`Status::Mismatch`] for poles of a sample alone.
    pub fn from_poles(poles: &Arc<Poles>, options: PowerCrustOptions, job: &Job) -> Result<Self> {
        let plan = [
            (Stage::Order, 0.1),
            (Stage::Regular, 0.6),
            (Stage::Label, 0.15),
            (Stage::Extract, 0.15),
        ];
        job.run(&plan, |run| PowerCrust::from_poles_in(poles.clone(), options, run))
    }

    fn from_poles_in(poles: Arc<Poles>, options: PowerCrustOptions, run: &Run<'_>) -> Result<Self> {
        if !(0.0..=1.0).contains(&options.deep) {
            return Err(Error::new(
                Status::InvalidArgument,
                "the depth of a deep intersection is -cos of an angle and lies in [0, 1]",
            ));
        }
        if options.viewpoint.is_some_and(|at| at.iter().any(|x| !x.is_finite())) {
            return Err(Error::new(Status::InvalidArgument, "the viewpoint must be finite"));
        }
        if !poles.has_far_box() {
            return Err(Error::new(
                Status::Mismatch,
                "a power crust needs poles chosen with the far box",
            ));
        }
        let mut room = Room::new(run);
        let regular = Arc::new(balls::triangulate(&poles, &options, run)?);
        room.keep(regular.bytes())?;
        run.enter(Stage::Label)?;
        let labelling = label::label_poles(&poles, &regular, &options, run)?;
        run.enter(Stage::Extract)?;
        let shards = if options.keep_shards { Shards::Keep } else { Shards::Merge };
        let label::Labelling { labels, account } = labelling;
        PowerCrust {
            options,
            poles,
            balls: Balls::Poles,
            shards,
            regular,
            labels,
            account,
            surface: Arc::default(),
            inner_shape: Arc::default(),
            outer_shape: Arc::default(),
            size_index: OnceLock::new(),
        }
        .extracted(run)
    }

    /// The same with the surface and the shapes of its labelled balls, which were empty.
    fn extracted(mut self, run: &Run<'_>) -> Result<Self> {
        let (poles, regular) = (&self.poles, &self.regular);
        let mut room = Room::new(run);
        let division = Division::new(regular, &self.labels, &mut room, run)?;
        let surface = surface::extract(poles, regular, &division, self.shards, run)?;
        room.keep(surface.bytes())?;
        let [outer_shape, inner_shape] = shape::extract(poles, regular, &division, run)?;
        self.surface = Arc::new(surface);
        self.inner_shape = Arc::new(inner_shape);
        self.outer_shape = Arc::new(outer_shape);
        Ok(self)
    }

    /// What was asked for.
    pub fn options(&self) -> &PowerCrustOptions {
        &self.options
    }

    /// The poles and their balls, as they were chosen: not rounded.
    pub fn poles(&self) -> &Arc<Poles> {
        &self.poles
    }

    /// The regular triangulation of the polar balls, rounded if that was asked for; its input rows are the poles.
    pub fn regular(&self) -> &Arc<Triangulation> {
        &self.regular
    }

    /// The label of each pole.
    pub fn labels(&self) -> &[Label] {
        &self.labels
    }

    /// The number of poles that no label reached, and that are outer for that reason.
    pub fn unreached_count(&self) -> usize {
        self.account.unreached
    }

    /// The number of poles made outer because their power cells are unbounded.
    pub fn forced_count(&self) -> usize {
        self.account.forced
    }

    /// How much the labels contradict each other: the sum of the squared weights of the links that do not have the labels that they ask for,
    /// divided by the number of poles. Links are samples with two poles, which ask for different labels, and balls that intersect
    /// deeply, which ask for the same. 1e-3 and less where a sample is dense; near 0.1 the solid is a guess.
    pub fn conflict(&self) -> f64 {
        self.account.conflict
    }

    /// Whether labels were changed to lessen their conflict: [`LabelRule::LeastConflict`] was asked for or needed.
    pub fn is_settled(&self) -> bool {
        self.account.settled
    }

    /// The power crust: convex polygons, oriented outward. Faces carry `inner_pole` and
    /// `outer_pole`, vertices the `cell` of the regular triangulation whose orthocentre they are.
    pub fn surface(&self) -> &Arc<Complex> {
        &self.surface
    }

    /// The inner power shape: poles inside the solid, and the faces of the regular triangulation between them.
    ///
    /// Vertices carry `radius`, `pole`, `label` (0 outer, 1 inner) and `object_angle` ([`Poles::object_angles`]), cells
    /// `flatness`: the least altitude relative to the longest edge. Centres and radii are those of the regular triangulation. Tetrahedra, most
    /// of them flat, are volume cells; [`Complex::flatten`] collapses these.
    pub fn inner_shape(&self) -> &Arc<Complex> {
        &self.inner_shape
    }

    /// The outer power shape.
    pub fn outer_shape(&self) -> &Arc<Complex> {
        &self.outer_shape
    }

    /// Whether the pole takes part in the power diagram: it is neither hidden nor a lighter
    /// duplicate of another pole's centre.
    pub fn is_visible(&self, pole: u32) -> bool {
        let vertex = self.regular.points().vertex_of_row()[pole as usize];
        vertex != NONE
            && self.regular.row_of_vertex()[vertex as usize] == pole
            && self.regular.hidden().binary_search(&vertex).is_err()
    }
}

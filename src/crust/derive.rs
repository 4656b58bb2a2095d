//! Power crusts of changed balls: other radii, or fewer balls, with the labels that the poles have.

use super::balls::{self, Ball};
use super::label::{Label, LabelAccount, force_outer};
use super::surface::Shards;
use super::{Balls, PowerCrust};
use crate::error::{Error, Result, Status};
use crate::job::{Job, Room, Run, Stage};
use crate::predicates::{WEIGHT_MAX, WEIGHT_MIN};
use std::sync::{Arc, OnceLock};

impl PowerCrust {
    /// An approximate offset surface: outside the solid for a positive distance, inside for a negative one (Amenta, Choi,
    /// Kolluri 2001, section 7.2).
    ///
    /// The radius of every inner ball grows by the distance, that of every outer ball shrinks by it; balls whose radius
    /// falls to 0 vanish, and do not come back when an offset is offset again. Labels are kept. The result is the boundary of a solid, as every power crust;
    /// its surface is empty where no inner ball is left. Its vertices are no samples, so that no shards are merged.
    ///
    /// Errors: [`Status::InvalidArgument`] for a distance that is not finite or makes radii of more than 2^200, [`Status::TooFewPoints`] and
    /// [`Status::Degenerate`] where too few balls are left, and those of the job. Cost: one regular triangulation.
    pub fn offset(&self, distance: f64, job: &Job) -> Result<Self> {
        if !distance.is_finite() {
            return Err(Error::new(Status::InvalidArgument, "the distance must be finite"));
        }
        let largest =
            (0..self.poles.len()).filter_map(|pole| self.weight(pole)).fold(0.0, f64::max);
        if largest.sqrt() + distance.abs() > WEIGHT_MAX.sqrt() {
            let message =
                format!("the distance {distance:?} is too large: radii must stay below 2^200");
            return Err(Error::new(Status::InvalidArgument, message));
        }
        job.run(&DERIVE, |run| {
            let weight = |pole: usize| {
                let radius = match self.labels[pole] {
                    Label::Inner => self.weight(pole)?.sqrt() + distance,
                    Label::Outer => self.weight(pole)?.sqrt() - distance,
                };
                (radius > 0.0 && radius * radius >= WEIGHT_MIN).then_some(radius * radius)
            };
            self.derived_in(weight, Shards::None, run)
        })
    }

    /// The power crust of the same poles with the given weights, without those that have none.
    pub(super) fn derived_in(
        &self,
        weight: impl Fn(usize) -> Option<f64> + Sync,
        shards: Shards,
        run: &Run<'_>,
    ) -> Result<Self> {
        let mut room = Room::new(run);
        let weights = room.collect((0..self.poles.len()).map(weight))?;
        let ball = |pole: usize| -> Option<Ball> {
            let [x, y, z, _] = self.poles.balls()[pole];
            weights[pole].map(|weight| ([x, y, z], weight))
        };
        let regular = Arc::new(balls::regular(&self.poles, ball, run)?);
        room.keep(regular.bytes())?;
        run.enter(Stage::Extract)?;
        let mut labels = room.collect(self.labels.iter().copied())?;
        let forced = force_outer(&regular, &mut labels, run)?;
        PowerCrust {
            options: self.options,
            poles: self.poles.clone(),
            balls: Balls::Changed(weights),
            shards,
            regular,
            labels,
            account: LabelAccount { forced, ..self.account },
            surface: Arc::default(),
            inner_shape: Arc::default(),
            outer_shape: Arc::default(),
            size_index: OnceLock::new(),
        }
        .extracted(run)
    }

    /// The weight of a pole's ball, which is its squared radius; `None` if it was left out.
    pub(super) fn weight(&self, pole: usize) -> Option<f64> {
        match &self.balls {
            Balls::Poles => Some(self.poles.radii_squared()[pole]),
            Balls::Changed(weights) => weights[pole],
        }
    }
}

/// The stages of a power crust of changed balls.
pub(super) const DERIVE: [(Stage, f64); 3] =
    [(Stage::Order, 0.1), (Stage::Regular, 0.7), (Stage::Extract, 0.2)];

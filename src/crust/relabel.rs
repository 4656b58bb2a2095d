//! Power crusts with other labels: given by the host, or by a mesh.

use super::label::{Label, LabelAccount, force_outer};
use super::links::Links;
use super::{Balls, PowerCrust, PowerCrustOptions, conflict};
use crate::complex::Complex;
use crate::error::{Error, Result, Status};
use crate::job::{Job, Room, Run, Stage};
use std::sync::{Arc, OnceLock};

/// Poles round which a mesh winds more often than this are inner.
const INNER: f64 = 0.5;

impl PowerCrust {
    /// The same poles with other labels, one for each.
    ///
    /// Poles and the regular triangulation are shared with this power crust; the surface and the shapes are made anew. An inner pole with
    /// an unbounded power cell becomes outer and is counted by [`PowerCrust::forced_count`]; [`PowerCrust::unreached_count`] is 0. Of a
    /// simplified or offset power crust the balls stay what they are, and so do the labels of offsets of the result.
    ///
    /// Errors: [`Status::Mismatch`] unless there is one label per pole, and those of the job. Cost: O(size), without a triangulation.
    pub fn with_labels(&self, labels: &[Label], job: &Job) -> Result<Self> {
        job.run(&RELABEL, |run| {
            run.enter(Stage::Label)?;
            let poles = self.poles.len();
            if labels.len() != poles {
                let count = labels.len();
                let message = format!("{poles} poles need as many labels, not {count}");
                return Err(Error::new(Status::Mismatch, message));
            }
            let mut room = Room::new(run);
            let labels = room.collect(labels.iter().copied())?;
            self.relabelled_in(labels, run)
        })
    }

    /// The same poles, labelled by a mesh: inner are those round whose centres its faces wind more than half a time, by
    /// [`Complex::winding_numbers`].
    ///
    /// Faces must point out of the solid, and those of voids into them. A pole is inner also where shells overlap, so that the solid is
    /// their union. A mesh with holes does as well: each is closed where the number passes through one half. Of a mesh that is turned inside out no pole is inner, and the surface is empty:
    /// [`Complex::oriented`] turns it. The samples need not be the mesh's vertices. The rest is as for [`PowerCrust::with_labels`].
    ///
    /// Errors: [`Status::InvalidArgument`] for a mesh without faces, and those of the job. Cost: that of the winding numbers, O(p log n) for n triangles
    /// and p poles, and then O(size).
    pub fn labelled_by_mesh(&self, mesh: &Complex, job: &Job) -> Result<Self> {
        job.run(&RELABEL, |run| {
            run.enter(Stage::Label)?;
            let mut room = Room::new(run);
            let balls = self.poles.balls();
            let center = |pole: usize| [0, 1, 2].map(|k| balls[pole][k]);
            let numbers = mesh.winding_numbers_in(balls.len(), center, run)?;
            room.keep(size_of_val(&numbers[..]))?;
            let side = |&number: &f64| if number > INNER { Label::Inner } else { Label::Outer };
            let labels = room.collect(numbers.iter().map(side))?;
            self.relabelled_in(labels, run)
        })
    }

    fn relabelled_in(&self, mut labels: Vec<Label>, run: &Run<'_>) -> Result<Self> {
        let mut room = Room::new(run);
        let forced = force_outer(&self.regular, &mut labels, run)?;
        let balls = match &self.balls {
            Balls::Poles => Balls::Poles,
            Balls::Changed(weights) => Balls::Changed(room.collect(weights.iter().copied())?),
        };
        let rule = PowerCrustOptions { viewpoint: None, ..self.options };
        let links = Links::of_poles(&self.poles, &self.regular, &rule, run)?;
        let conflict = conflict::of(&links, &labels, run)?;
        drop(links);
        run.enter(Stage::Extract)?;
        PowerCrust {
            options: self.options,
            poles: self.poles.clone(),
            balls,
            shards: self.shards,
            regular: self.regular.clone(),
            labels,
            account: LabelAccount { given: true, forced, conflict, ..LabelAccount::default() },
            surface: Arc::default(),
            inner_shape: Arc::default(),
            outer_shape: Arc::default(),
            size_index: OnceLock::new(),
        }
        .extracted(run)
    }
}

/// The stages of a power crust with other labels.
const RELABEL: [(Stage, f64); 2] = [(Stage::Label, 0.6), (Stage::Extract, 0.4)];

//! Labels from Tight Cocone.

use super::Labels;
use crate::cocone::Cocone;
use crate::error::Result;
use crate::job::{Job, Room, Run};

impl Labels {
    /// The cells that the watertight surface of Tight Cocone encloses are inner. Errors: those of the job. Cost: O(m) for m cells.
    pub fn of_cocone(cocone: &Cocone, job: &Job) -> Result<Self> {
        job.run(&[], |run| Labels::of_cocone_in(cocone, run))
    }

    /// [`Labels::of_cocone`] as a part of a larger build.
    pub(crate) fn of_cocone_in(cocone: &Cocone, run: &Run<'_>) -> Result<Self> {
        let is_inner = Room::new(run).collect(cocone.is_inner().iter().copied())?;
        Ok(Labels { triangulation: cocone.triangulation().clone(), is_inner })
    }
}

//! Batches of points: what is nearest to each.

use super::piece::Foot;
use super::sites::{Nearest, Sites};
use crate::complex::{answers, try_answers};
use crate::error::{ElementKind, Error, Result, Status};
use crate::job::{Job, Room, Run, Stage};
use std::sync::{Mutex, PoisonError};

/// All nearest points of the boundary, for each of many points.
///
/// Invariants: `feet` is parted by `offsets`, one part for each point, in their order; in a part the pieces ascend.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AllNearest {
    /// Where the part of each point begins, and where the last ends.
    pub offsets: Vec<u32>,
    /// The nearest points.
    pub feet: Vec<Nearest>,
}

impl AllNearest {
    /// Those of one point.
    pub fn of(&self, row: usize) -> &[Nearest] {
        &self.feet[self.offsets[row] as usize..self.offsets[row + 1] as usize]
    }
}

impl Sites {
    /// The nearest point of the boundary for each point.
    ///
    /// Errors: [`Status::NonFinite`] and [`Status::CoordinateRange`] with the row of a point; those of the job. Cost: about O(log n) each, divided among the job's threads.
    pub fn nearest(&self, points: &[[f64; 3]], job: &Job) -> Result<Vec<Nearest>> {
        job.run(&[(Stage::Query, 1.0)], |run| {
            run.enter(Stage::Query)?;
            let mut room = Room::new(run);
            let answer = |p| self.foot(p).seen_from(p);
            answers(points, ElementKind::Row, [0.0, 1.0], &mut room, run, answer)
        })
    }

    /// The nearest points of all pieces that are no farther than the nearest one is and `tolerance`, a distance, for each point.
    ///
    /// Errors: as [`Sites::nearest`]; [`Status::InvalidArgument`] for a tolerance that is negative or no number; [`Status::LimitExceeded`] for more than 2^32 - 1 in all.
    pub fn all_nearest(
        &self,
        points: &[[f64; 3]],
        tolerance: f64,
        job: &Job,
    ) -> Result<AllNearest> {
        job.run(&[(Stage::Query, 1.0)], |run| self.all_nearest_in(points, tolerance, run))
    }

    /// [`Sites::all_nearest`] as a stage of a larger build.
    pub(crate) fn all_nearest_in(
        &self,
        points: &[[f64; 3]],
        tolerance: f64,
        run: &Run<'_>,
    ) -> Result<AllNearest> {
        run.enter(Stage::Query)?;
        if tolerance.is_nan() || tolerance < 0.0 {
            let message = format!("a tolerance of {tolerance} is no distance");
            return Err(Error::new(Status::InvalidArgument, message));
        }
        let mut room = Room::new(run);
        let counted = Mutex::new(Room::new(run));
        let found = try_answers(points, ElementKind::Row, [0.0, 0.9], &mut room, run, |p| {
            let mut feet: Vec<Foot> = Vec::new();
            // The square of a rounded root may be less than what it is the root of.
            let distance = self.foot(p).distance_squared.sqrt().next_up() + tolerance;
            self.feet_within(p, distance, &mut feet);
            // Nothing panics while it is locked.
            let mut counted = counted.lock().unwrap_or_else(PoisonError::into_inner);
            counted.keep(feet.len() * size_of::<Nearest>())?;
            Ok(feet.iter().map(|foot| foot.seen_from(p)).collect::<Vec<_>>())
        })?;
        let mut all = AllNearest { offsets: room.vec(points.len() + 1)?, feet: Vec::new() };
        all.offsets.push(0);
        for found in run.watch(&found) {
            let found = found?;
            room.grow(&mut all.feet, found.len())?;
            all.feet.extend_from_slice(found);
            let end = u32::try_from(all.feet.len()).map_err(|_| {
                Error::new(Status::LimitExceeded, "more than 2^32 - 1 nearest points")
            })?;
            all.offsets.push(end);
        }
        Ok(all)
    }
}

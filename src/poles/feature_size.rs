//! The distance to the nearest pole: an estimate of the local feature size.

use super::Poles;
use crate::complex::{Hierarchy, Simplex, answers};
use crate::error::{ElementKind, Result};
use crate::job::{Job, Room, Run, Stage};

impl Poles {
    /// The distance from each query to the nearest finite pole, in input units: an estimate of the
    /// local feature size of the surface there (Amenta, Bern 1999). Infinite if all poles are at infinity.
    ///
    /// Errors: [`crate::Status::NonFinite`] and, beyond 2^200, [`crate::Status::CoordinateRange`] with the row of the query, and those of
    /// the job. Cost: O(log p) for each query, and O(p log p) once, on the first call.
    pub fn feature_size(&self, queries: &[[f64; 3]], job: &Job) -> Result<Vec<f64>> {
        job.run(&[(Stage::Query, 1.0)], |run| {
            run.enter(Stage::Query)?;
            let mut room = Room::new(run);
            let centers = self.centers_in(&mut room, run)?;
            distances(centers, queries, ElementKind::Row, [0.0, 1.0], &mut room, run)
        })
    }

    /// The centres of all balls, in a hierarchy that is made when it is first asked for.
    pub(crate) fn centers_in(&self, room: &mut Room<'_>, run: &Run<'_>) -> Result<&Hierarchy<1>> {
        if let Some(hierarchy) = self.hierarchy.get() {
            return Ok(hierarchy);
        }
        let center = |&[x, y, z, _]: &[f64; 4]| Simplex { corners: [[x, y, z]], tag: 0 };
        let centers = Room::new(run).collect(self.balls.iter().map(center))?;
        let hierarchy = Hierarchy::new(&centers, room, run)?;
        Ok(self.hierarchy.get_or_init(|| hierarchy))
    }
}

/// The distance from each query to the nearest of some centres.
pub(crate) fn distances(
    centers: &Hierarchy<1>,
    queries: &[[f64; 3]],
    kind: ElementKind,
    span: [f64; 2],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<f64>> {
    let distance = |query| centers.distance_2(query, f64::INFINITY).sqrt();
    answers(queries, kind, span, room, run, distance)
}

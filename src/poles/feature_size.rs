//! The distance to the nearest pole: an estimate of the local feature size.

use super::Poles;
use crate::complex::{Hierarchy, Simplex};
use crate::error::{ElementKind, Result};
use crate::job::{Job, Room, Stage};
use crate::points::check_coordinates;

impl Poles {
    /// The distance from each query to the nearest finite pole, in input units: an estimate of the
    /// local feature size of the surface there (Amenta, Bern 1999). Infinite if all poles are at infinity.
    ///
    /// Errors: [`crate::Status::NonFinite`] and [`crate::Status::CoordinateRange`] with the row of the query, and those of the job. Cost: O(log p) for each
    /// query, and O(p log p) once, on the first call.
    pub fn feature_size(&self, queries: &[[f64; 3]], job: &Job) -> Result<Vec<f64>> {
        job.run(&[(Stage::Query, 1.0)], |run| {
            run.enter(Stage::Query)?;
            let mut room = Room::new(run);
            let hierarchy = match self.hierarchy.get() {
                Some(hierarchy) => hierarchy,
                None => {
                    let center =
                        |&[x, y, z, _]: &[f64; 4]| Simplex { corners: [[x, y, z]], tag: 0 };
                    let centers = Room::new(run).collect(self.balls.iter().map(center))?;
                    let hierarchy = Hierarchy::new(&centers, &mut room, run)?;
                    self.hierarchy.get_or_init(|| hierarchy)
                }
            };
            let mut distances = room.vec(queries.len())?;
            for (row, query) in queries.iter().enumerate() {
                if row % 1024 == 0 {
                    run.tick(row, queries.len())?;
                }
                let query = check_coordinates(*query)
                    .map_err(|error| error.at(ElementKind::Row, row as u64))?;
                distances.push(hierarchy.distance_2(query, f64::INFINITY).sqrt());
            }
            Ok(distances)
        })
    }
}

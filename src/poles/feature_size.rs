//! Local feature size: the distance to the medial axis, estimated by the distance to the poles.

use super::Poles;
use crate::error::{ElementKind, Result};
use crate::job::{Job, Stage};
use crate::points::check_coordinates;
use rstar::RTree;

impl Poles {
    /// The distance from each query point to the nearest pole, in input units: an estimate of the local
    /// feature size (Amenta, Bern 1999), which is the distance to the medial axis. Infinite if
    /// there is no pole.
    ///
    /// Errors: [`crate::Status::NonFinite`] and [`crate::Status::CoordinateRange`] with the row of the
    /// query, and those of the job. Cost: O(p log p) for the search tree, then O(log p) a query.
    pub fn feature_size(&self, queries: &[[f64; 3]], job: &Job) -> Result<Vec<f64>> {
        job.run(&[(Stage::Query, 1.0)], |run| {
            run.enter(Stage::Query)?;
            let centers = self.balls.iter().map(|&[x, y, z, _]| [x, y, z]).collect();
            let tree = RTree::<[f64; 3]>::bulk_load(centers);
            let mut sizes = run.try_vec(queries.len())?;
            for (row, &query) in queries.iter().enumerate() {
                if row % 256 == 0 {
                    run.tick(row, queries.len())?;
                }
                let query = check_coordinates(query)
                    .map_err(|error| error.at(ElementKind::Row, row as u64))?;
                let squared = tree.nearest_neighbor_iter_with_distance_2(query).next();
                sizes.push(squared.map_or(f64::INFINITY, |(_, squared)| squared.sqrt()));
            }
            Ok(sizes)
        })
    }
}

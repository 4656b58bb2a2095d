//! The distance to the nearest pole: an estimate of the local feature size.

use super::Poles;
use crate::error::{ElementKind, Result};
use crate::job::{Job, Run, Stage};
use crate::points::check_coordinates;
use rstar::{PointDistance, RTree};

/// Poles in one tree: few enough to be loaded without asking whether the job is cancelled.
const TREE_SIZE: usize = 1 << 15;

/// The centres of the poles in trees, each for a stretch of the spatial order, and so compact.
#[derive(Clone, Debug)]
pub(super) struct Forest(Vec<RTree<[f64; 3]>>);

impl Forest {
    fn new(balls: &[[f64; 4]], run: &Run<'_>) -> Result<Self> {
        let mut trees = run.try_vec(balls.len().div_ceil(TREE_SIZE))?;
        for chunk in balls.chunks(TREE_SIZE) {
            run.poll()?;
            trees.push(RTree::bulk_load(chunk.iter().map(|&[x, y, z, _]| [x, y, z]).collect()));
        }
        Ok(Forest(trees))
    }

    /// The squared distance to the nearest center.
    fn distance_squared(&self, query: [f64; 3]) -> f64 {
        let bound = |tree: &RTree<[f64; 3]>| tree.root().envelope().distance_2(&query);
        let inside = |tree: &RTree<[f64; 3]>| {
            tree.nearest_neighbor(query).map_or(f64::INFINITY, |center| center.distance_2(&query))
        };
        let nearest = self.0.iter().enumerate().min_by(|a, b| bound(a.1).total_cmp(&bound(b.1)));
        let Some((start, tree)) = nearest else { return f64::INFINITY };
        let mut least = inside(tree);
        for (_, tree) in self.0.iter().enumerate().filter(|(i, _)| *i != start) {
            if bound(tree) < least {
                least = least.min(inside(tree));
            }
        }
        least
    }
}

impl Poles {
    /// The distance from each query to the nearest finite pole, in input units: an estimate of the
    /// local feature size of the surface there (Amenta, Bern 1999). Infinite if all poles are at infinity.
    ///
    /// Errors: [`crate::Status::NonFinite`] and [`crate::Status::CoordinateRange`] with the row of the query, and those of the job. Cost: O(log p) for each
    /// query, and O(p log p) once, on the first call.
    pub fn feature_size(&self, queries: &[[f64; 3]], job: &Job) -> Result<Vec<f64>> {
        job.run(&[(Stage::Query, 1.0)], |run| {
            run.enter(Stage::Query)?;
            let _charge = run.charge(queries.len() as u64 * 8 + self.len() as u64 * 64)?;
            let forest = match self.forest.get() {
                Some(forest) => forest,
                None => {
                    let forest = Forest::new(&self.balls, run)?;
                    self.forest.get_or_init(|| forest)
                }
            };
            let mut distances = run.try_vec(queries.len())?;
            for (row, query) in queries.iter().enumerate() {
                if row % 1024 == 0 {
                    run.tick(row, queries.len())?;
                }
                let query = check_coordinates(*query)
                    .map_err(|error| error.at(ElementKind::Row, row as u64))?;
                distances.push(forest.distance_squared(query).sqrt());
            }
            Ok(distances)
        })
    }
}

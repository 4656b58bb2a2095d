//! Deformations: each node keeps its vector.

use super::PairMesh;
use crate::error::{ElementKind, Error, Result, Status};
use crate::job::{Job, Room, Run, Stage};
use crate::points::check_coordinates;
use crate::vector::{Vec3, add, scale, sub};

impl PairMesh {
    /// The mesh with the inner vertices at other places, and each boundary vertex moved by the mean of what its nodes' inner vertices are moved by. See [`PairMesh::folded`] for the elements that this turns inside out.
    ///
    /// Errors: [`Status::Mismatch`] for another number of places, [`Status::NonFinite`] and [`Status::CoordinateRange`] with the vertex; those of the job. Cost: O(size).
    pub fn with_inner(&self, places: &[Vec3], job: &Job) -> Result<PairMesh> {
        job.run(&[(Stage::Pair, 1.0)], |run| {
            run.enter(Stage::Pair)?;
            let moved = check(places, self.inner.len(), run)?;
            let boundary = self.follow([&self.inner, &moved], &self.boundary, [1, 0], run)?;
            Ok(PairMesh { boundary, inner: moved, is_whole: false, ..self.clone() })
        })
    }

    /// The mesh with the vertices of the boundary at other places, and each inner vertex moved by the mean of what its nodes' boundary vertices are moved by. Errors and cost as [`PairMesh::with_inner`].
    pub fn with_boundary(&self, places: &[Vec3], job: &Job) -> Result<PairMesh> {
        job.run(&[(Stage::Pair, 1.0)], |run| {
            run.enter(Stage::Pair)?;
            let moved = check(places, self.boundary.len(), run)?;
            let inner = self.follow([&self.boundary, &moved], &self.inner, [0, 1], run)?;
            Ok(PairMesh { inner, boundary: moved, is_whole: false, ..self.clone() })
        })
    }

    /// The places of vertices on one end of the nodes that follow those on the other end.
    fn follow(
        &self,
        [before, after]: [&[Vec3]; 2],
        following: &[Vec3],
        [lead, follower]: [usize; 2],
        run: &Run<'_>,
    ) -> Result<Vec<Vec3>> {
        let mut room = Room::new(run);
        let mut sums = room.filled(following.len(), ([0.0; 3], 0u32))?;
        for item in run.watch(&self.nodes) {
            let node = item?;
            let by = sub(after[node[lead] as usize], before[node[lead] as usize]);
            let (sum, count) = &mut sums[node[follower] as usize];
            (*sum, *count) = (add(*sum, by), *count + 1);
        }
        room.collect(
            following.iter().zip(&sums).map(|(&place, &(sum, count))| {
                add(place, scale(sum, 1.0 / f64::from(count.max(1))))
            }),
        )
    }
}

/// A copy of places that are as many as they should be, and in range.
fn check(places: &[Vec3], count: usize, run: &Run<'_>) -> Result<Vec<Vec3>> {
    if places.len() != count {
        let message = format!("{} places for {count} vertices", places.len());
        return Err(Error::new(Status::Mismatch, message));
    }
    let mut checked = Room::new(run).vec(count)?;
    for item in run.watch(places.iter().enumerate()) {
        let (i, &place) = item?;
        let place =
            check_coordinates(place).map_err(|error| error.at(ElementKind::Vertex, i as u64))?;
        checked.push(place);
    }
    Ok(checked)
}

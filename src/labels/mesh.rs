//! Labels from an oriented mesh of the solid.

use super::Labels;
use crate::complex::Complex;
use crate::dual::Dual;
use crate::error::Result;
use crate::job::{Job, Room, Run, Stage};

impl Labels {
    /// A cell is inner where the faces of a mesh wind round its Voronoi vertex more than half a time
    /// ([`Complex::winding_numbers`]): they must point out of the solid, and those of voids into these. Small holes are bridged.
    ///
    /// Errors: [`Status::InvalidArgument`](crate::Status::InvalidArgument) for a mesh without faces, and those of the job. Cost: that of a winding number for each cell.
    pub fn of_mesh(dual: &Dual, mesh: &Complex, job: &Job) -> Result<Self> {
        job.run(&[(Stage::Label, 1.0)], |run| Labels::of_mesh_in(dual, mesh, run))
    }

    /// [`Labels::of_mesh`] as a stage of a larger build.
    pub(crate) fn of_mesh_in(dual: &Dual, mesh: &Complex, run: &Run<'_>) -> Result<Self> {
        run.enter(Stage::Label)?;
        let centers = dual.centers();
        let numbers = mesh.winding_numbers_in(centers.len(), |cell| centers[cell], run)?;
        let mut room = Room::new(run);
        let is_inner = room.collect(numbers.iter().map(|&number| number > 0.5))?;
        Ok(Labels { triangulation: dual.triangulation().clone(), is_inner })
    }
}

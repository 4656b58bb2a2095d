//! Labels from a power crust.

use super::Labels;
use crate::crust::{Label, PowerCrust};
use crate::dual::Dual;
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, PART, Room, Run, Stage};
use crate::poles::position;
use crate::triangulation::Descent;

impl Labels {
    /// A cell is inner where its Voronoi vertex lies in the power cell of an inner pole: in the solid that the power crust bounds.
    ///
    /// Errors: [`Status::Mismatch`] for a power crust of other samples, and those of the job. Cost: about O(m) for m cells.
    pub fn of_crust(dual: &Dual, crust: &PowerCrust, job: &Job) -> Result<Self> {
        job.run(&[(Stage::Label, 1.0)], |run| Labels::of_crust_in(dual, crust, run))
    }

    /// [`Labels::of_crust`] as a stage of a larger build.
    pub(crate) fn of_crust_in(dual: &Dual, crust: &PowerCrust, run: &Run<'_>) -> Result<Self> {
        run.enter(Stage::Label)?;
        let t = dual.triangulation();
        let poles = crust.poles();
        let samples = &poles.triangulation().coords()[..poles.sample_count()];
        if t.coords() != samples {
            return Err(Error::new(
                Status::Mismatch,
                "the power crust is not of the samples of the triangulation",
            ));
        }
        let mut room = Room::new(run);
        let regular = crust.regular();
        let incidence = regular.incidence_in(run)?;
        let descent = Descent::new(regular, &incidence);
        let vertex_of_pole = regular.points().vertex_of_row();
        let some_vertex = regular.cells()[0][0];
        let mut is_inner = room.filled(t.cells().len(), false)?;
        let chunks = is_inner.chunks_mut(PART / 8).zip(0..).collect();
        run.in_steps(chunks, [0.2, 1.0], |(is_inner, chunk): (&mut [bool], usize)| {
            let mut from = some_vertex;
            for (i, is_inner) in is_inner.iter_mut().enumerate() {
                if i % 256 == 0 {
                    run.poll()?;
                }
                let cell = chunk * (PART / 8) + i;
                // A pole of a corner is near; one that is hidden is in no cell.
                let corner = t.cells()[cell][0] as usize;
                let pole = poles.pole_of_sample()[corner].into_iter().find(|&pole| {
                    pole != NONE && !incidence.cells_of(vertex_of_pole[pole as usize]).is_empty()
                });
                if let Some(pole) = pole {
                    from = vertex_of_pole[pole as usize];
                }
                from = descent.nearest(position(dual, cell as u32), from);
                let pole = regular.row_of_vertex()[from as usize];
                *is_inner = crust.labels()[pole as usize] == Label::Inner;
            }
            Ok(())
        })?;
        Ok(Labels { triangulation: t.clone(), is_inner })
    }
}

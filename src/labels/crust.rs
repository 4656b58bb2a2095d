//! Labels from a power crust.

use super::Labels;
use crate::crust::{Label, PowerCrust};
use crate::dual::Dual;
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, PART, Room, Run, Stage};
use crate::poles::position;
use crate::triangulation::{Descent, Incidence, PowerTree};

/// The most cells of a vertex whose neighbours are looked at one by one.
const LARGE: usize = 1 << 8;

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
        let incidence = crust.regular().incidence_in(run)?;
        let solid = Solid::new(crust, &incidence, &mut room, run)?;
        let mut is_inner = room.filled(t.cells().len(), false)?;
        let chunks = is_inner.chunks_mut(PART / 8).zip(0..).collect();
        run.in_steps(chunks, [0.2, 1.0], |(is_inner, chunk): (&mut [bool], usize)| {
            for (i, is_inner) in is_inner.iter_mut().enumerate() {
                if i % 256 == 0 {
                    run.poll()?;
                }
                let cell = chunk * (PART / 8) + i;
                // The poles of a corner are near.
                let corner = t.cells()[cell][0];
                *is_inner = solid.holds(position(dual, cell as u32), solid.pole_of(corner));
            }
            Ok(())
        })?;
        Ok(Labels { triangulation: t.clone(), is_inner })
    }
}

/// The solid that a power crust bounds. Poles are vertices of the regular triangulation here.
struct Solid<'a> {
    crust: &'a PowerCrust,
    incidence: &'a Incidence,
    descent: Descent<'a>,
    /// The outer poles, and the inner ones.
    sides: [PowerTree<'a>; 2],
}

impl<'a> Solid<'a> {
    fn new(
        crust: &'a PowerCrust,
        incidence: &'a Incidence,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let regular = crust.regular();
        let mut own = Room::new(run);
        let mut sides = [Vec::new(), Vec::new()];
        for vertex in run.watch(0..regular.coords().len() as u32) {
            let vertex = vertex?;
            if !incidence.cells_of(vertex).is_empty() {
                own.push(&mut sides[usize::from(is_inner(crust, vertex))], vertex)?;
            }
        }
        let mut tree = |side: &[u32]| PowerTree::new(regular, side, room, run);
        let sides = [tree(&sides[0])?, tree(&sides[1])?];
        Ok(Solid { crust, incidence, descent: Descent::new(regular, incidence), sides })
    }

    /// A pole of a sample that is not hidden, or any.
    fn pole_of(&self, sample: u32) -> u32 {
        let regular = self.crust.regular();
        let poles = self.crust.poles().pole_of_sample()[sample as usize].into_iter();
        let vertex_of_pole = regular.points().vertex_of_row();
        let mut vertices =
            poles.filter(|&pole| pole != NONE).map(|pole| vertex_of_pole[pole as usize]);
        let shown = vertices.find(|&vertex| !self.incidence.cells_of(vertex).is_empty());
        shown.unwrap_or(regular.cells()[0][0])
    }

    /// Whether a point lies in the power cell of an inner pole. The search begins at some pole.
    fn holds(&self, at: [f64; 3], from: u32) -> bool {
        let mut here = from;
        loop {
            let is_inner = is_inner(self.crust, here);
            // A large ball in the middle of small ones has them all for neighbours. Which pole is the nearest does not matter:
            // only that none of the other side is nearer.
            let nearer = match self.incidence.cells_of(here).len() {
                ..=LARGE => self.descent.nearer(at, here),
                _ => self.sides[usize::from(!is_inner)].nearer(at, here),
            };
            match nearer {
                Some(nearer) => here = nearer,
                None => return is_inner,
            }
        }
    }
}

fn is_inner(crust: &PowerCrust, vertex: u32) -> bool {
    crust.labels()[crust.regular().row_of_vertex()[vertex as usize] as usize] == Label::Inner
}

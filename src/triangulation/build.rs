//! Incremental construction: one point after the other, in a biased randomised order.

use super::cavity::{Cavity, Found, cell_in_conflict};
use super::cells::{Cell, Cells, Parts, Patch, Slots};
use super::kernel;
use super::order::insertion_order;
use super::star::Star;
use crate::error::{Error, Result, Status};
use crate::job::{Room, Run};
use crate::predicates::around::Site;
use crate::predicates::processor::Processor;
use crate::predicates::{Sign, collinear, orient3d};
use std::ops::Range;

/// Points between two looks at the clock.
const TICK: usize = 64;

/// Triangulates distinct sites.
///
/// Errors: [`Status::TooFewPoints`] below four, [`Status::Degenerate`] for flat sets, and those
/// of the run.
pub(super) fn build<S: Site>(sites: &[S], run: &Run<'_>) -> Result<Parts> {
    let simplex = first_simplex(sites.len(), |v| *sites[v as usize].position(), run)?;
    let mut cells = Cells::new(simplex, sites.len(), run)?;
    let mut room = Room::new(run);
    let mut worker = Worker::new(0..sites.len() as u32, cells.first(), &mut room)?;
    for (done, vertex) in insertion_order(sites.len()).enumerate() {
        if done % TICK == 0 {
            run.tick(done, sites.len())?;
        }
        if simplex.contains(&vertex) {
            continue;
        }
        if worker.dig::<S, false>(&mut cells.whole(), sites, vertex, run)? == Dug::Cavity {
            worker.provide(&mut cells)?;
            worker.fill(&mut cells.whole());
        }
    }
    Ok(cells.finish([worker.slots]))
}

/// What became of a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Dug {
    /// Its cavity was found, and is to be filled.
    Cavity,
    /// It is hidden: its own cell is not in conflict with it.
    Hidden,
    /// It cannot be inserted in this patch.
    Foreign,
}

/// What one thread needs to insert points.
struct Worker {
    processor: Processor,
    cavity: Cavity,
    star: Star,
    slots: Slots,
    /// A cell near the next point.
    near: Cell,
}

impl Worker {
    /// A worker for the patch with the given vertices that begins near a cell.
    fn new(vertices: Range<u32>, near: Cell, room: &mut Room<'_>) -> Result<Self> {
        Ok(Worker {
            processor: Processor::detect(),
            cavity: Cavity::default(),
            star: Star::new(vertices, room)?,
            slots: Slots::default(),
            near,
        })
    }

    /// Finds the cells in conflict with a vertex.
    ///
    /// Errors: [`Status::Cancelled`]; the cells are of no further use then.
    fn dig<S: Site, const SHARED: bool>(
        &mut self,
        patch: &mut Patch<'_>,
        sites: &[S],
        vertex: u32,
        run: &Run<'_>,
    ) -> Result<Dug> {
        let (processor, point) = (self.processor, &sites[vertex as usize]);
        let located = kernel::locate::<S, SHARED>(processor, patch, sites, self.near, point);
        let Some(start) = located else { return Ok(Dug::Foreign) };
        self.near = start;
        // A point in a Delaunay cell is inside its sphere, and one beyond a hull facet in conflict.
        if S::WEIGHTED && !cell_in_conflict(patch, sites, start, point) {
            return Ok(Dug::Hidden);
        }
        let cavity = &mut self.cavity;
        match kernel::search::<S, SHARED>(processor, cavity, patch, sites, vertex, start, run)? {
            Found::Cavity => Ok(Dug::Cavity),
            Found::Foreign => Ok(Dug::Foreign),
        }
    }

    /// How many slots are missing to fill the cavity.
    fn missing(&self) -> usize {
        let needed = self.cavity.boundary().len().saturating_sub(self.cavity.cells().len());
        needed.saturating_sub(self.slots.len())
    }

    /// Provides slots to fill the cavity.
    ///
    /// Errors: those of [`Cells::hand_out`].
    #[inline]
    fn provide(&mut self, cells: &mut Cells<'_>) -> Result<()> {
        match self.missing() {
            0 => Ok(()),
            missing => cells.hand_out(missing.max(64 + cells.len() / 64), &mut self.slots),
        }
    }

    /// Fills the cavity; there must be slots enough.
    #[inline]
    fn fill(&mut self, patch: &mut Patch<'_>) {
        self.near = self.star.fill(&self.cavity, patch, &mut self.slots);
    }
}

/// Four sites that span space, positively oriented: the first ones in the order of insertion.
pub(super) fn first_simplex(
    count: usize,
    at: impl Fn(u32) -> [f64; 3],
    run: &Run<'_>,
) -> Result<[u32; 4]> {
    if count < 4 {
        return Err(Error::new(
            Status::TooFewPoints,
            format!("a triangulation needs 4 distinct points, not {count}"),
        ));
    }
    let mut found: Vec<u32> = Vec::with_capacity(4);
    for (done, v) in insertion_order(count).enumerate() {
        if done % 4096 == 0 {
            run.poll()?;
        }
        match found[..] {
            [a, b] if collinear(&at(a), &at(b), &at(v)) => {}
            [a, b, c] => match orient3d(&at(a), &at(b), &at(c), &at(v)) {
                Sign::Zero => {}
                Sign::Positive => return Ok([a, b, c, v]),
                Sign::Negative => return Ok([b, a, c, v]),
            },
            _ => found.push(v),
        }
    }
    let dimension = found.len() - 1;
    let place = if dimension == 1 { "on a line" } else { "in a plane" };
    Err(Error::new(Status::Degenerate, format!("all points lie {place}; a solid is needed")))
}

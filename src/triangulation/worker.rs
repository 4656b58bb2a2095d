//! What one thread needs to insert points.

use super::cavity::{Cavity, Found, cell_in_conflict};
use super::cells::{Cell, Cells, Patch, Slots};
use super::kernel;
use super::star::Star;
use crate::error::Result;
use crate::job::{Room, Run};
use crate::predicates::around::Site;
use crate::predicates::processor::Processor;

/// What became of a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Dug {
    /// Its cavity was found, and is to be filled.
    Cavity,
    /// It is hidden: its own cell is not in conflict with it.
    Hidden,
    /// It cannot be inserted in this patch.
    Foreign,
}

/// The arrays of one thread's insertions, kept from one to the next.
pub(super) struct Worker {
    processor: Processor,
    cavity: Cavity,
    star: Star,
    slots: Slots,
    /// A cell of the worker's patch, near the next point.
    near: Cell,
    /// Other such cells, or free slots: where walks begin after one has left the patch.
    anchors: [Cell; ANCHORS],
    /// The walks that succeeded, and those that did not.
    walks: [usize; 2],
    /// The walks that did not, since one did.
    stuck: usize,
}

/// How many walks in turn leave the patch before the next begins elsewhere.
const STUCK: usize = 8;
/// How many cells are remembered.
const ANCHORS: usize = 8;
/// How many walks succeed before another one is.
const ANCHOR_EVERY: usize = 256;

impl Worker {
    /// A worker for so many vertices that begins near a cell.
    pub fn new(vertices: usize, near: Cell, room: &mut Room<'_>) -> Result<Self> {
        Ok(Worker {
            processor: Processor::detect(),
            cavity: Cavity::default(),
            star: Star::new(vertices, room)?,
            slots: Slots::default(),
            near,
            anchors: [near; ANCHORS],
            walks: [0; 2],
            stuck: 0,
        })
    }

    /// Makes the next walk begin at the first of some cells, at least one, all of which the patch must own, and others at others.
    pub fn begin(&mut self, cells: &[Cell]) {
        self.near = cells[0];
        self.anchors = std::array::from_fn(|i| cells[i * cells.len() / ANCHORS]);
        self.stuck = 0;
    }

    /// A cell of the patch, as long as nobody else changes it.
    pub fn near(&self) -> Cell {
        self.near
    }

    /// The cell that holds a vertex, in a patch that owns all cells.
    pub fn locate<S: Site>(&self, patch: &Patch<'_>, sites: &[S], from: Cell, vertex: u32) -> Cell {
        let point = &sites[vertex as usize];
        let located = kernel::locate::<S, false>(self.processor, patch, sites, from, point);
        located.unwrap_or(from)
    }

    /// Finds the cells in conflict with a vertex. `SHARED` if there are other patches.
    ///
    /// Errors: [`crate::Status::Cancelled`]; the cells are of no further use then.
    #[inline]
    pub fn dig<S: Site, const SHARED: bool>(
        &mut self,
        patch: &mut Patch<'_>,
        sites: &[S],
        vertex: u32,
        run: &Run<'_>,
    ) -> Result<Dug> {
        let (processor, point) = (self.processor, &sites[vertex as usize]);
        match kernel::locate::<S, SHARED>(processor, patch, sites, self.near, point) {
            Some(cell) => (self.near, self.stuck) = (cell, 0),
            None => {
                self.stuck += 1;
                if self.stuck.is_multiple_of(STUCK) {
                    self.turn_to_anchor(patch);
                }
                return Ok(Dug::Foreign);
            }
        }
        // A point in a Delaunay cell is inside its sphere, and one beyond a hull facet in conflict.
        if S::WEIGHTED && !cell_in_conflict(patch, sites, self.near, point) {
            return Ok(Dug::Hidden);
        }
        let cavity = &mut self.cavity;
        match kernel::search::<S, SHARED>(processor, cavity, patch, sites, vertex, self.near, run)?
        {
            Found::Cavity => Ok(Dug::Cavity),
            Found::Foreign => Ok(Dug::Foreign),
        }
    }

    /// Makes the next walk begin elsewhere.
    ///
    /// Parts of a patch can be joined through foreign cells only. A walk that begins in a
    /// small one would not get out of it.
    #[cold]
    fn turn_to_anchor(&mut self, patch: &Patch<'_>) {
        self.walks[1] += 1;
        let anchor = self.anchors[self.walks[1] % ANCHORS];
        // Cells in conflict keep their mark when their slots are given back.
        if !patch.is_marked(anchor) {
            self.near = anchor;
        }
    }

    /// Inserts a vertex where there are other patches, or finds that it is hidden; `false` if neither can be done
    /// in this patch, or there are no slots left.
    ///
    /// Errors: as [`Worker::dig`].
    #[inline]
    pub fn insert<S: Site>(
        &mut self,
        patch: &mut Patch<'_>,
        sites: &[S],
        vertex: u32,
        run: &Run<'_>,
    ) -> Result<bool> {
        match self.dig::<S, true>(patch, sites, vertex, run)? {
            Dug::Hidden => Ok(true),
            Dug::Foreign => Ok(false),
            Dug::Cavity => {
                while self.missing() > 0 {
                    if !patch.take_slots(&mut self.slots) {
                        self.cavity.forget(patch);
                        return Ok(false);
                    }
                }
                self.fill(patch, vertex);
                self.walks[0] += 1;
                if self.walks[0].is_multiple_of(ANCHOR_EVERY) {
                    self.anchors[self.walks[0] / ANCHOR_EVERY % ANCHORS] = self.near;
                }
                Ok(true)
            }
        }
    }

    /// Provides slots to fill the cavity.
    ///
    /// Errors: those of [`Cells::hand_out`].
    #[inline]
    pub fn provide(&mut self, cells: &mut Cells<'_>) -> Result<()> {
        match self.missing() {
            0 => Ok(()),
            missing => cells.hand_out(missing, &mut self.slots),
        }
    }

    /// How many slots are missing to fill the cavity.
    #[inline]
    pub fn missing(&self) -> usize {
        let needed = self.cavity.boundary().len().saturating_sub(self.cavity.cells().len());
        needed.saturating_sub(self.slots.len())
    }

    /// Fills the cavity of a vertex; there must be slots enough.
    #[inline]
    pub fn fill(&mut self, patch: &mut Patch<'_>, vertex: u32) {
        let Worker { processor, star, cavity, slots, .. } = self;
        self.near = kernel::fill(*processor, star, cavity, patch, slots, vertex);
    }

    /// The slots that are left.
    pub fn into_slots(self) -> Slots {
        self.slots
    }
}

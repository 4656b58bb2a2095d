//! The star of a new vertex: the cells that fill its cavity.
//!
//! The boundary of the cavity is a closed oriented surface: each edge runs once in each direction. So every
//! new cell puts its three sides under its own directed edges and finds its neighbours under
//! the reversed ones. Small stars, nearly all of them, use a table over local vertex numbers
//! (Marot, Pellerin, Remacle 2019, section 2.4); larger ones a hash table.

use super::cavity::Cavity;
use super::cells::{Cell, Facet, Patch, Slots};
use crate::error::Result;
use crate::job::Room;
use crate::predicates::lanes::{Lanes, Portable};

/// The most vertices of a small star; their local numbers index the table.
const SMALL: usize = 64;
/// The most facets of its boundary: a triangulated sphere with v vertices has 2 v - 4.
const FACETS: usize = 2 * SMALL - 4;
/// "No local number yet".
const UNNUMBERED: u8 = u8::MAX;
/// An empty slot of the hash table: no edge runs from a vertex to itself.
const EMPTY: u64 = 0;

/// The edge tables, kept from one insertion to the next.
pub(super) struct Star {
    /// The slots of the new cells.
    cells: Vec<Cell>,
    /// The local number of each vertex in the current small star, else [`UNNUMBERED`]; last the vertex at
    /// infinity.
    local: Vec<u8>,
    /// The local numbers of the corners of each boundary facet.
    numbers: Box<[[u8; 3]; FACETS]>,
    /// `table[from * SMALL + to]`: the side of the new cell with that edge. Large enough for any numbers of eight bits.
    table: Box<[Facet; 256 * (SMALL + 1)]>,
    /// Open addressing: directed edges and their sides, for large stars.
    keys: Vec<u64>,
    sides: Vec<Facet>,
}

impl Star {
    /// Tables for stars of so many vertices and the one at infinity.
    pub fn new(vertices: usize, room: &mut Room<'_>) -> Result<Self> {
        Ok(Star {
            cells: Vec::new(),
            local: room.filled(vertices + 1, UNNUMBERED)?,
            numbers: Box::new([[0; 3]; FACETS]),
            table: Box::new([Facet::default(); 256 * (SMALL + 1)]),
            keys: Vec::new(),
            sides: Vec::new(),
        })
    }

    /// Fills the cavity of a vertex: one new cell per boundary facet, in the slots of the old cells first. Returns one
    /// of the new cells. There must be slots enough.
    #[inline(always)]
    pub fn fill<L: Lanes>(
        &mut self,
        cavity: &Cavity,
        patch: &mut Patch<'_>,
        slots: &mut Slots,
        vertex: u32,
    ) -> Cell {
        let mut patch = patch.reborrow();
        let boundary = cavity.boundary();
        let (reused, unused) = cavity.cells().split_at(boundary.len().min(cavity.cells().len()));
        self.cells.clear();
        self.cells.extend_from_slice(reused);
        slots.take(boundary.len() - reused.len(), &mut self.cells);
        slots.give_back(unused);
        if boundary.len() <= FACETS {
            self.fill_small::<L>(boundary, &mut patch, vertex);
        } else {
            self.fill_large(boundary, &mut patch, vertex);
        }
        self.cells[0]
    }

    #[inline(always)]
    fn fill_small<L: Lanes>(&mut self, boundary: &[Facet], patch: &mut Patch<'_>, vertex: u32) {
        let Star { cells, local, table, numbers, .. } = self;
        let mut count = 0;
        for ((&outer, &cell), numbers) in boundary.iter().zip(&*cells).zip(numbers.iter_mut()) {
            let vertices = put_vertices::<L>(patch, cell, outer, vertex);
            let [_, corners @ ..] = vertices;
            for (number, vertex) in numbers.iter_mut().zip(corners) {
                let local = &mut local[vertex as usize];
                let is_new = *local == UNNUMBERED;
                *number = if is_new { count } else { *local };
                *local = *number;
                count += u8::from(is_new);
            }
            let &mut [a, b, c] = numbers;
            table[edge(b, c)] = cell.facet(1);
            table[edge(c, a)] = cell.facet(2);
            table[edge(a, b)] = cell.facet(3);
        }
        for ((&outer, &cell), &[a, b, c]) in boundary.iter().zip(&*cells).zip(&**numbers) {
            let sides = [table[edge(c, b)], table[edge(a, c)], table[edge(b, a)]];
            put_neighbors(patch, cell, outer, sides);
            let [_, a, b, c] = patch.vertices(cell);
            for vertex in [a, b, c] {
                local[vertex as usize] = UNNUMBERED;
            }
        }
    }

    #[cold]
    fn fill_large(&mut self, boundary: &[Facet], patch: &mut Patch<'_>, vertex: u32) {
        let slots = (6 * boundary.len()).next_power_of_two();
        self.keys.clear();
        self.keys.resize(slots, EMPTY);
        self.sides.resize(slots, Facet::default());
        for (&outer, &cell) in boundary.iter().zip(&self.cells) {
            let [_, a, b, c] = put_vertices::<Portable>(patch, cell, outer, vertex);
            for (i, (from, to)) in [(b, c), (c, a), (a, b)].into_iter().enumerate() {
                let slot = self.slot(from, to);
                self.keys[slot] = key(from, to);
                self.sides[slot] = cell.facet(i as u32 + 1);
            }
        }
        for (&outer, &cell) in boundary.iter().zip(&self.cells) {
            let [_, a, b, c] = patch.vertices(cell);
            let sides = [(c, b), (a, c), (b, a)].map(|(from, to)| self.sides[self.slot(from, to)]);
            put_neighbors(patch, cell, outer, sides);
        }
    }

    /// The slot of a directed edge: where it is, or where it belongs.
    fn slot(&self, from: u32, to: u32) -> usize {
        let mask = self.keys.len() - 1;
        let key = key(from, to);
        let hash = key.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let mut slot = (hash >> 32) as usize & mask;
        while self.keys[slot] != EMPTY && self.keys[slot] != key {
            slot = (slot + 1) & mask;
        }
        slot
    }
}

/// Gives a new cell its vertices: the new one, and those of the facet, given as the cell outside names it.
#[inline(always)]
fn put_vertices<L: Lanes>(
    patch: &mut Patch<'_>,
    cell: Cell,
    outer: Facet,
    vertex: u32,
) -> [u32; 4] {
    let vertices = L::cell_beyond(patch.vertices(outer.cell()), outer.slot(), vertex);
    patch.put_vertices(cell, vertices);
    vertices
}

/// Gives a new cell its neighbours: outside, and across its sides.
#[inline(always)]
fn put_neighbors(patch: &mut Patch<'_>, cell: Cell, outer: Facet, [a, b, c]: [Facet; 3]) {
    patch.put_neighbors(cell, [outer, a, b, c]);
    patch.set_neighbor(outer, cell.facet(0));
    patch.set_mark(cell, false);
}

/// The place of a directed edge in the table of a small star.
#[inline(always)]
fn edge(from: u8, to: u8) -> usize {
    usize::from(from) * SMALL + usize::from(to)
}

/// A directed edge in one number; never [`EMPTY`], as its ends differ.
#[inline]
fn key(from: u32, to: u32) -> u64 {
    u64::from(from) << 32 | u64::from(to)
}

//! The star of a new vertex: the cells that fill its cavity.
//!
//! The boundary of the cavity is a closed oriented surface: each edge runs once in each direction. So every
//! new cell puts its three sides under its own directed edges and finds its neighbours under
//! the reversed ones. Small stars, nearly all of them, use a table over local vertex numbers
//! (Marot, Pellerin, Remacle 2019, section 2.4); larger ones a hash table.

use super::cavity::{BoundaryFacet, Cavity};
use super::cells::{Cell, Facet, Patch, Slots};
use crate::error::Result;
use crate::job::Room;

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
    /// The vertices that have a local number.
    numbered: Box<[u32; 2 * SMALL]>,
    /// `table[from * SMALL + to]`: the side of the new cell with that edge.
    table: Box<[Facet; SMALL * SMALL]>,
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
            numbered: Box::new([0; 2 * SMALL]),
            table: Box::new([Facet::default(); SMALL * SMALL]),
            keys: Vec::new(),
            sides: Vec::new(),
        })
    }

    /// Fills the cavity: one new cell per boundary facet, in the slots of the old cells first. Returns one
    /// of the new cells. There must be slots enough.
    pub fn fill(&mut self, cavity: &Cavity, patch: &mut Patch<'_>, slots: &mut Slots) -> Cell {
        let boundary = cavity.boundary();
        let (reused, unused) = cavity.cells().split_at(boundary.len().min(cavity.cells().len()));
        self.cells.clear();
        self.cells.extend_from_slice(reused);
        slots.take(boundary.len() - reused.len(), &mut self.cells);
        slots.give_back(unused);
        if boundary.len() <= FACETS {
            self.fill_small(boundary, patch);
        } else {
            self.fill_large(boundary, patch);
        }
        self.cells[0]
    }

    fn fill_small(&mut self, boundary: &[BoundaryFacet], patch: &mut Patch<'_>) {
        let Star { cells, local, table, numbers, numbered, .. } = self;
        let mut count = 0;
        for ((facet, &cell), numbers) in boundary.iter().zip(&*cells).zip(numbers.iter_mut()) {
            let [_, corners @ ..] = facet.vertices;
            for (number, vertex) in numbers.iter_mut().zip(corners) {
                let local = &mut local[vertex as usize];
                let is_new = *local == UNNUMBERED;
                *number = if is_new { count as u8 } else { *local };
                *local = *number;
                // Written before it is known to be new: there is room for more than there can be.
                numbered[count % (2 * SMALL)] = vertex;
                count += usize::from(is_new);
            }
            let &mut [a, b, c] = numbers;
            table[edge(b, c)] = cell.facet(1);
            table[edge(c, a)] = cell.facet(2);
            table[edge(a, b)] = cell.facet(3);
        }
        for ((facet, &cell), &[a, b, c]) in boundary.iter().zip(&*cells).zip(&**numbers) {
            let sides = [table[edge(c, b)], table[edge(a, c)], table[edge(b, a)]];
            put(patch, facet, cell, sides);
        }
        for &vertex in &numbered[..count] {
            local[vertex as usize] = UNNUMBERED;
        }
    }

    #[cold]
    fn fill_large(&mut self, boundary: &[BoundaryFacet], patch: &mut Patch<'_>) {
        let slots = (6 * boundary.len()).next_power_of_two();
        self.keys.clear();
        self.keys.resize(slots, EMPTY);
        self.sides.resize(slots, Facet::default());
        for (facet, &cell) in boundary.iter().zip(&self.cells) {
            let [_, a, b, c] = facet.vertices;
            for (i, (from, to)) in [(b, c), (c, a), (a, b)].into_iter().enumerate() {
                let slot = self.slot(from, to);
                self.keys[slot] = key(from, to);
                self.sides[slot] = cell.facet(i as u32 + 1);
            }
        }
        for (facet, &cell) in boundary.iter().zip(&self.cells) {
            let [_, a, b, c] = facet.vertices;
            let sides = [(c, b), (a, c), (b, a)].map(|(from, to)| self.sides[self.slot(from, to)]);
            put(patch, facet, cell, sides);
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

/// Puts the new cell on a boundary facet, given its neighbours across its sides.
#[inline(always)]
fn put(patch: &mut Patch<'_>, facet: &BoundaryFacet, cell: Cell, [a, b, c]: [Facet; 3]) {
    patch.put(cell, facet.vertices, [facet.outer, a, b, c]);
    patch.set_neighbor(facet.outer, cell.facet(0));
}

/// The place of a directed edge in the table of a small star.
#[inline(always)]
fn edge(from: u8, to: u8) -> usize {
    (usize::from(from) * SMALL + usize::from(to)) % (SMALL * SMALL)
}

/// A directed edge in one number; never [`EMPTY`], as its ends differ.
#[inline]
fn key(from: u32, to: u32) -> u64 {
    u64::from(from) << 32 | u64::from(to)
}

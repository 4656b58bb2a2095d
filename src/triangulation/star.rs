//! Adjacency in the star of a new vertex: which two new cells share each edge of the cavity's
//! boundary.
//!
//! The boundary is a closed oriented surface: each edge runs once in each direction. So every
//! new cell puts its three sides under its own directed edges and finds its neighbours under
//! the reversed ones. Small stars, nearly all of them, use a table over local vertex numbers
//! (Marot, Pellerin, Remacle 2019, section 2.4); larger ones a hash table.

use crate::error::Result;
use crate::job::Run;

/// The most vertices of a small star; their local numbers index the table.
const SMALL: usize = 64;
/// "No local number yet".
const UNNUMBERED: u8 = u8::MAX;
/// An empty slot of the hash table: no edge runs from a vertex to itself.
const EMPTY: u64 = 0;

/// The edge tables, kept from one insertion to the next.
pub(super) struct Star {
    /// The local number of each vertex of the current small star, else [`UNNUMBERED`].
    local: Vec<u8>,
    /// The vertices that have a local number.
    numbered: Vec<u32>,
    /// `table[from * SMALL + to]`: the side of the new cell with that edge.
    table: Box<[u32]>,
    /// Per boundary facet of a small star its corners' local numbers.
    corners: Vec<[u8; 3]>,
    /// Open addressing: directed edges and their sides; empty for small stars.
    keys: Vec<u64>,
    sides: Vec<u32>,
    small: bool,
}

impl Star {
    /// Tables for stars among `vertex_count` vertices and the one at infinity.
    pub fn new(vertex_count: usize, run: &Run<'_>) -> Result<Self> {
        let mut local = run.try_vec(vertex_count + 1)?;
        local.resize(vertex_count + 1, UNNUMBERED);
        Ok(Star {
            local,
            numbered: Vec::new(),
            table: vec![0; SMALL * SMALL].into_boxed_slice(),
            corners: Vec::new(),
            keys: Vec::new(),
            sides: Vec::new(),
            small: true,
        })
    }

    /// Prepares for a star over these facets, whose corners `corners_of` tells.
    pub fn begin<F>(&mut self, facets: &[F], corners_of: impl Fn(&F) -> [u32; 3]) {
        // A triangulated sphere with v vertices has 2 v - 4 facets; a cavity's boundary is one.
        self.small = facets.len() <= 2 * SMALL - 4;
        if self.small {
            self.corners.clear();
            for facet in facets {
                let numbers = corners_of(facet).map(|v| self.number(v));
                self.corners.push(numbers);
            }
        } else {
            let slots = (6 * facets.len()).next_power_of_two();
            self.keys.clear();
            self.keys.resize(slots, EMPTY);
            self.sides.resize(slots, 0);
        }
    }

    /// Enters the side of a new cell under the edge opposite corner `k` of facet `i`.
    #[inline]
    pub fn put(&mut self, i: usize, from: u32, to: u32, k: usize, side: u32) {
        if self.small {
            let corners = &self.corners[i];
            let (from, to) = (corners[(k + 1) % 3], corners[(k + 2) % 3]);
            self.table[usize::from(from) * SMALL + usize::from(to)] = side;
        } else {
            let slot = self.slot(from, to);
            self.keys[slot] = key(from, to);
            self.sides[slot] = side;
        }
    }

    /// The side that was put under the edge from `from` to `to`, the reverse of the edge opposite
    /// corner `k` of facet `i`.
    #[inline]
    pub fn get(&self, i: usize, from: u32, to: u32, k: usize) -> u32 {
        if self.small {
            let corners = &self.corners[i];
            let (to, from) = (corners[(k + 1) % 3], corners[(k + 2) % 3]);
            self.table[usize::from(from) * SMALL + usize::from(to)]
        } else {
            self.sides[self.slot(from, to)]
        }
    }

    /// Forgets the local numbers.
    pub fn end(&mut self) {
        for vertex in self.numbered.drain(..) {
            self.local[vertex as usize] = UNNUMBERED;
        }
    }

    #[inline]
    fn number(&mut self, vertex: u32) -> u8 {
        let local = &mut self.local[vertex as usize];
        if *local == UNNUMBERED {
            *local = self.numbered.len() as u8;
            self.numbered.push(vertex);
        }
        *local
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

/// A directed edge in one number; never [`EMPTY`], as its ends differ.
#[inline]
fn key(from: u32, to: u32) -> u64 {
    u64::from(from) << 32 | u64::from(to)
}

//! Storage of the cells under construction: topology only, no coordinates.

use crate::error::{Error, Result, Status};
use crate::job::{Charge, Run};

/// The most cells: a packed neighbour, `4 * cell + facet`, must fit into 32 bits.
pub const CELL_LIMIT: usize = 1 << 30;

/// What one cell takes: vertices, packed neighbours, mark.
const CELL_BYTES: usize = size_of::<[u32; 4]>() * 2 + 1;

/// Facet `i` of a cell as three slots, such that `(i, FACET[i])` is an even permutation: seen from
/// vertex `i` the facet turns counterclockwise in a positively oriented cell.
pub(super) const FACET: [[usize; 3]; 4] = [[1, 2, 3], [0, 3, 2], [3, 0, 1], [2, 1, 0]];

/// The even permutation of the slots that brings `i` to the front and `j` next: `EVEN[i][j]`.
pub(super) const EVEN: [[[usize; 4]; 4]; 4] = {
    let mut table = [[[0; 4]; 4]; 4];
    let mut i = 0;
    while i < 4 {
        let mut j = 0;
        while j < 4 {
            if i != j {
                let (mut k, mut l) = (0, 0);
                while k == i || k == j {
                    k += 1;
                }
                while l == i || l == j || l == k {
                    l += 1;
                }
                // Count the inversions of (i, j, k, l); k < l.
                let odd = (i > j) ^ (i > k) ^ (i > l) ^ (j > k) ^ (j > l);
                table[i][j] = if odd { [i, j, l, k] } else { [i, j, k, l] };
            }
            j += 1;
        }
        i += 1;
    }
    table
};

/// What the current insertion knows of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(super) enum Mark {
    /// Not tested.
    Unknown,
    /// In conflict with the new point: part of the cavity.
    Conflict,
    /// Tested, and outside the cavity.
    Outside,
}

/// Cells in flat arrays, with a list of free slots.
///
/// The vertex at infinity is vertex `infinite`; it stands in slot 3 of every cell that has it,
/// and a cell `(a, b, c, infinite)` is oriented so that a point beyond the hull facet `abc` makes
/// `(a, b, c, point)` positive. Invariants between insertions: every cell that is not free has
/// four neighbours, given as `4 * cell + facet`, and is named by each of them; all marks are
/// [`Mark::Unknown`].
pub(super) struct Cells<'a> {
    pub vertices: Vec<[u32; 4]>,
    pub neighbors: Vec<[u32; 4]>,
    pub marks: Vec<Mark>,
    pub free: Vec<u32>,
    pub infinite: u32,
    run: &'a Run<'a>,
    charges: Vec<Charge<'a>>,
}

impl<'a> Cells<'a> {
    /// The four infinite cells and the one finite cell of a first positively oriented simplex.
    pub fn new(simplex: [u32; 4], vertex_count: usize, run: &'a Run<'a>) -> Result<Self> {
        let mut cells = Cells {
            vertices: Vec::new(),
            neighbors: Vec::new(),
            marks: Vec::new(),
            free: Vec::new(),
            infinite: vertex_count as u32,
            run,
            charges: Vec::new(),
        };
        // A surface in general position has a little more than four cells a point, a volume
        // nearly seven: the first guess serves surfaces, and volumes grow from it.
        cells.reserve(vertex_count.saturating_mul(9) / 2 + 64)?;
        cells.push(simplex);
        for facet in FACET {
            let [a, b, c] = facet.map(|slot| simplex[slot]);
            cells.push([a, b, c, cells.infinite]);
        }
        for i in 0..4u32 {
            cells.link(i, 4 * (i + 1) + 3);
            for j in 0..i {
                // Cells i + 1 and j + 1 share the edge of the simplex without vertices i and j.
                let (x, y) = (simplex[i as usize], simplex[j as usize]);
                let slot_of = |cell: u32, v: u32| {
                    let found = cells.vertices[cell as usize].iter().position(|&w| w == v);
                    found.unwrap_or(0) as u32
                };
                let (s, t) = (slot_of(i + 1, y), slot_of(j + 1, x));
                cells.link(4 * (i + 1) + s, 4 * (j + 1) + t);
            }
        }
        Ok(cells)
    }

    /// Makes two packed facets each other's neighbour.
    #[inline]
    pub fn link(&mut self, a: u32, b: u32) {
        self.neighbors[(a >> 2) as usize][(a & 3) as usize] = b;
        self.neighbors[(b >> 2) as usize][(b & 3) as usize] = a;
    }

    /// Appends a cell without neighbours; room for it was reserved.
    #[inline]
    pub fn push(&mut self, vertices: [u32; 4]) -> u32 {
        self.vertices.push(vertices);
        self.neighbors.push([0; 4]);
        self.marks.push(Mark::Unknown);
        self.vertices.len() as u32 - 1
    }

    /// Whether the cell has the vertex at infinity.
    #[inline]
    pub fn is_infinite(&self, cell: u32) -> bool {
        self.vertices[cell as usize][3] == self.infinite
    }

    /// Makes room for `extra` more cells.
    ///
    /// Errors: [`Status::LimitExceeded`] past [`CELL_LIMIT`], [`Status::OutOfMemory`].
    #[inline]
    pub fn reserve(&mut self, extra: usize) -> Result<()> {
        let needed = self.vertices.len() + extra;
        if needed <= self.vertices.capacity() { Ok(()) } else { self.grow(needed) }
    }

    #[cold]
    fn grow(&mut self, needed: usize) -> Result<()> {
        if needed > CELL_LIMIT {
            return Err(Error::new(
                Status::LimitExceeded,
                format!("the triangulation has more than {CELL_LIMIT} cells"),
            ));
        }
        let len = self.vertices.len();
        let capacity = needed.max(len + len / 8).min(CELL_LIMIT);
        let added = capacity - self.vertices.capacity();
        self.charges.push(self.run.charge((added * CELL_BYTES) as u64)?);
        let refused = self.vertices.try_reserve_exact(capacity - len).is_err()
            || self.neighbors.try_reserve_exact(capacity - len).is_err()
            || self.marks.try_reserve_exact(capacity - len).is_err();
        if refused {
            let bytes = capacity * CELL_BYTES;
            return Err(Error::new(
                Status::OutOfMemory,
                format!("{bytes} bytes for cells are not to be had"),
            ));
        }
        Ok(())
    }
}

//! Storage of the cells under construction: topology only, no coordinates.
//!
//! # Why the unsafe code here is sound
//!
//! **In bounds.** A [`Cell`] and a [`Facet`] are made in this file only, from slots that were handed
//! out or taken. So what is read from the arrays names slots within them, and needs no check. The arrays
//! move only in [`Cells::prepare`], which borrows them as a whole, and never shrink; patches take slots within their capacity. (All
//! cells belong to one [`Cells`]: a build has no other.)
//!
//! **Initialised.** Slots are filled with zeros when they are handed out or taken.
//!
//! **No data race.** Several threads insert at once, each through a [`Patch`] of its own. Every vertex but the one at infinity
//! has one owner among the patches, and *a patch owns the cells of which it owns three vertices or more*; so a cell has one owner, or none.
//! Each thread keeps to these rules:
//!
//! 1. It writes the vertices of a cell, and all its neighbours, only in slots that it took itself, or of cells that it owns.
//! 2. Of a cell that it does not own it reads the vertices, and writes a neighbour, only where that neighbour is, or was in
//!    the same place, a cell that it owns.
//! 3. Marks are atomic.
//!
//! Let Y be a cell that the patch owns, and X a neighbour of Y that it does not. X has at least two vertices
//! of the patch: Y has three, and one facet lacks only one of them. (i) No other patch owns X, since only two vertices
//! are left. So nobody writes the vertices of X. (ii) Of the neighbours of X, a thread writes only those that it owns or
//! replaces by its own cells, and these are different places in the array for different threads. So no two threads
//! touch the same element of an array, if one of them writes. A new cell consists of the new vertex and a facet of a cell that the
//! patch owns: it has three vertices of the patch at least, so that the patch owns it.
//!
//! Threads begin after the patches were made, and end before these are given up: what one of them wrote is seen by all afterwards.
//! The rules are kept by `cavity.rs`, `star.rs` and `walk.rs`, and checked in debug builds where cells are written. `make tsan` watches
//! them too, and tests that compare the cells of one thread and of several.
#![allow(unsafe_code)]

use crate::error::{Error, Result, Status};
use crate::job::{Charge, Run};
use std::marker::PhantomData;
use std::ops::Range;
use std::sync::atomic::{AtomicU8, AtomicUsize, Ordering};

/// The most cells: a packed neighbour, `4 * cell + facet`, must fit into 32 bits.
pub const CELL_LIMIT: usize = 1 << 30;

/// Slots that a thread takes at a time.
pub(super) const PIECE: usize = if cfg!(test) { 64 } else { 1 << 12 };

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

/// A cell: a slot that was handed out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(transparent)]
pub(super) struct Cell(u32);

impl Cell {
    /// The facet opposite the vertex in a slot.
    #[inline(always)]
    pub fn facet(self, slot: u32) -> Facet {
        Facet(4 * self.0 + (slot & 3))
    }

    /// The place of the cell in the arrays.
    #[inline(always)]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A facet of a cell: `4 * cell + slot` of the vertex opposite it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(transparent)]
pub(super) struct Facet(u32);

impl Facet {
    #[inline(always)]
    pub fn cell(self) -> Cell {
        Cell(self.0 >> 2)
    }

    #[inline(always)]
    pub fn slot(self) -> u32 {
        self.0 & 3
    }
}

/// Cells in flat arrays.
///
/// The vertex at infinity is vertex `infinite`; a cell with it is oriented so that a point beyond its
/// hull facet in its place makes the cell positive. Invariants between insertions: every cell that is
/// not free has four neighbours, given as packed facets, and is named by each of them; all marks are 0.
pub(super) struct Cells<'a> {
    vertices: Vec<[u32; 4]>,
    neighbors: Vec<[u32; 4]>,
    /// 1 for cells in conflict with a point that is being inserted.
    marks: Vec<u8>,
    infinite: u32,
    /// How many slots there are with those that patches have taken.
    taken: AtomicUsize,
    run: &'a Run<'a>,
    charges: Vec<Charge<'a>>,
}

/// The arrays of finished cells, see [`Cells`].
pub(super) struct Parts {
    pub vertices: Vec<[u32; 4]>,
    pub neighbors: Vec<[u32; 4]>,
    pub infinite: u32,
}

impl<'a> Cells<'a> {
    /// The one finite cell of a first positively oriented simplex, and the four infinite ones.
    pub fn new(simplex: [u32; 4], vertex_count: usize, run: &'a Run<'a>) -> Result<Self> {
        let mut cells = Cells {
            vertices: Vec::new(),
            neighbors: Vec::new(),
            marks: Vec::new(),
            infinite: vertex_count as u32,
            taken: AtomicUsize::new(0),
            run,
            charges: Vec::new(),
        };
        // A volume in general position has nearly seven cells a point, a surface a little more than four. What is
        // not used is address space only; where even that is scarce, the arrays grow as they are filled.
        let _ = cells.reserve(vertex_count.saturating_mul(15) / 2 + 64);
        cells.charge(5)?;
        cells.prepare(5)?;
        cells.vertices.push(simplex);
        for facet in FACET {
            // The facet turned round: the vertex at infinity lies on its other side.
            let [a, b, c] = facet.map(|slot| simplex[slot]);
            cells.vertices.push([cells.infinite, a, c, b]);
        }
        for (i, cell) in cells.vertices.iter().enumerate() {
            let neighbor = |v: u32| {
                // Every two of the five cells are neighbours: the one without v, across from it.
                let across = cells.vertices.iter().position(|other| !other.contains(&v));
                let other = across.unwrap_or(i);
                let slot = cells.vertices[other].iter().position(|w| !cell.contains(w));
                (4 * other + slot.unwrap_or(0)) as u32
            };
            cells.neighbors.push(cell.map(neighbor));
        }
        cells.marks.resize(5, 0);
        Ok(cells)
    }

    /// The first cell.
    pub fn first(&self) -> Cell {
        Cell(0)
    }

    /// The number of slots that were handed out.
    pub fn len(&self) -> usize {
        self.vertices.len()
    }

    /// A patch that owns every cell; there is no other as long as it lives.
    pub fn whole(&mut self) -> Patch<'_> {
        Patch {
            vertices: self.vertices.as_mut_ptr(),
            neighbors: self.neighbors.as_mut_ptr(),
            marks: self.marks.as_mut_ptr(),
            infinite: self.infinite,
            owners: None,
            supply: None,
            lifetime: PhantomData,
        }
    }

    /// So many patches; `owners` tells for each vertex, the one at infinity excepted, which of them owns it.
    ///
    /// They take new slots while they last; [`Cells::add_taken`] must follow.
    pub fn patches<'p>(&'p mut self, owners: &'p [u8], count: u8) -> Vec<Patch<'p>> {
        *self.taken.get_mut() = self.len();
        let capacity = self.capacity();
        let (vertices, neighbors) = (self.vertices.as_mut_ptr(), self.neighbors.as_mut_ptr());
        let (marks, infinite) = (self.marks.as_mut_ptr(), self.infinite);
        let supply = Some((&self.taken, capacity));
        let patch = |id| Patch {
            vertices,
            neighbors,
            marks,
            infinite,
            owners: Some((owners, id)),
            supply,
            lifetime: PhantomData,
        };
        (0..count).map(patch).collect()
    }

    /// Hands out more slots, as many at a time as a patch would take, or `least` if these are more.
    ///
    /// Errors: those of [`Cells::prepare`].
    pub fn hand_out(&mut self, least: usize, to: &mut Slots) -> Result<()> {
        let (begin, count) = (self.len(), least.max(PIECE));
        self.charge(count)?;
        self.prepare(count)?;
        self.vertices.resize(begin + count, [0; 4]);
        self.neighbors.resize(begin + count, [0; 4]);
        self.marks.resize(begin + count, 0);
        to.add(begin..begin + count);
        Ok(())
    }

    /// Adds the slots that patches have taken, now that these are given up.
    ///
    /// Errors: [`Status::OutOfMemory`] where they are more than the job's ceiling allows.
    pub fn add_taken(&mut self) -> Result<()> {
        let (begin, end) = (self.len(), *self.taken.get_mut());
        if begin < end {
            // SAFETY: pieces up to here were taken, from where the arrays end on; each was within the capacity, which
            // has not changed since, and filled with zeros.
            unsafe {
                self.vertices.set_len(end);
                self.neighbors.set_len(end);
                self.marks.set_len(end);
            }
            self.charge(end - begin)?;
        }
        Ok(())
    }

    /// Counts so many more cells against the job's ceiling.
    fn charge(&mut self, count: usize) -> Result<()> {
        self.charges.push(self.run.charge((count * CELL_BYTES) as u64)?);
        Ok(())
    }

    /// Makes room for `extra` more cells, and for an eighth of all besides if there is none.
    ///
    /// Errors: [`Status::LimitExceeded`] past [`CELL_LIMIT`], [`Status::OutOfMemory`].
    pub fn prepare(&mut self, extra: usize) -> Result<()> {
        let len = self.len();
        let needed = len + extra;
        if needed > CELL_LIMIT {
            return Err(Error::new(
                Status::LimitExceeded,
                format!("the triangulation has more than {CELL_LIMIT} cells"),
            ));
        }
        if needed <= self.capacity() {
            return Ok(());
        }
        self.reserve(needed.max(len + len / 8))
    }

    /// How many slots there can be before the arrays move.
    fn capacity(&self) -> usize {
        let least = self.vertices.capacity().min(self.neighbors.capacity());
        least.min(self.marks.capacity()).min(CELL_LIMIT)
    }

    /// Makes room for `capacity` cells in all.
    fn reserve(&mut self, capacity: usize) -> Result<()> {
        let (capacity, len) = (capacity.min(CELL_LIMIT), self.len());
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

    /// The arrays. Unused slots have only the vertex at infinity.
    pub fn finish(self, slots: impl IntoIterator<Item = Slots>) -> Parts {
        let Cells { mut vertices, neighbors, infinite, .. } = self;
        for Slots { free, fresh } in slots {
            for cell in free.into_iter().chain(fresh.map(Cell)) {
                vertices[cell.index()] = [infinite; 4];
            }
        }
        Parts { vertices, neighbors, infinite }
    }
}

/// The slots that one thread may use: free ones, and some that never held a cell.
#[derive(Default)]
pub(super) struct Slots {
    free: Vec<Cell>,
    fresh: Range<u32>,
}

impl Slots {
    /// How many slots there are.
    #[inline]
    pub fn len(&self) -> usize {
        self.free.len() + self.fresh.len()
    }

    /// Adds slots that never held a cell.
    fn add(&mut self, slots: Range<usize>) {
        self.free.extend(self.fresh.by_ref().map(Cell));
        self.fresh = slots.start as u32..slots.end as u32;
    }

    /// Appends `count` slots to the list; there must be so many.
    #[inline]
    pub fn take(&mut self, count: usize, to: &mut Vec<Cell>) {
        let reused = count.min(self.free.len());
        to.extend(self.free.drain(self.free.len() - reused..));
        to.extend(self.fresh.by_ref().take(count - reused).map(Cell));
    }

    /// Takes slots back whose cells are gone.
    #[inline]
    pub fn give_back(&mut self, cells: &[Cell]) {
        self.free.extend_from_slice(cells);
    }
}

/// A view of cells through which one thread changes those that it owns, see above.
pub(super) struct Patch<'a> {
    vertices: *mut [u32; 4],
    neighbors: *mut [u32; 4],
    marks: *mut u8,
    infinite: u32,
    /// The owner of each vertex, and the number of this patch; `None` if it owns all.
    owners: Option<(&'a [u8], u8)>,
    /// How many slots there are with those that patches have taken, and how many there can be; `None` if it cannot take any.
    supply: Option<(&'a AtomicUsize, usize)>,
    lifetime: PhantomData<&'a mut u8>,
}

// SAFETY: the patch stands for a mutable borrow of plain numbers; what keeps several of them apart
// is written above.
unsafe impl Send for Patch<'_> {}

impl Patch<'_> {
    /// The same patch, for a while: a copy of the pointers that the compiler can keep in registers.
    #[inline(always)]
    pub fn reborrow(&mut self) -> Patch<'_> {
        Patch { ..*self }
    }

    /// Takes some more slots; `false` if there are none.
    #[cold]
    pub fn take_slots(&mut self, to: &mut Slots) -> bool {
        let Some((taken, capacity)) = self.supply else { return false };
        let end = |begin: usize| (begin + PIECE <= capacity).then_some(begin + PIECE);
        let begin = taken.fetch_update(Ordering::Relaxed, Ordering::Relaxed, end);
        let Ok(begin) = begin else { return false };
        // SAFETY: these slots are within the capacity and nobody else's: each piece is taken once, and the arrays ended
        // before them when the patches were made.
        unsafe {
            self.vertices.add(begin).write_bytes(0, PIECE);
            self.neighbors.add(begin).write_bytes(0, PIECE);
            self.marks.add(begin).write_bytes(0, PIECE);
        }
        to.add(begin..begin + PIECE);
        true
    }

    /// The vertex at infinity.
    #[inline(always)]
    pub fn infinite(&self) -> u32 {
        self.infinite
    }

    #[inline(always)]
    pub fn vertices(&self, cell: Cell) -> [u32; 4] {
        // SAFETY: a cell is within bounds and initialised; nobody else writes its vertices, see (i).
        unsafe { self.vertices.add(cell.index()).read() }
    }

    #[inline(always)]
    pub fn neighbors(&self, cell: Cell) -> [Facet; 4] {
        // SAFETY: as for the vertices: this is a cell that the patch owns.
        let [a, b, c, d] = unsafe { self.neighbors.add(cell.index()).read() };
        [Facet(a), Facet(b), Facet(c), Facet(d)]
    }

    /// Fetches a cell's neighbours into the cache.
    #[inline(always)]
    pub fn fetch_neighbors(&self, cell: Cell) {
        fetch(self.neighbors.wrapping_add(cell.index()));
    }

    /// Fetches the vertices of a cell's neighbours into the cache.
    #[inline(always)]
    pub fn fetch_around(&self, cell: Cell) {
        for facet in self.neighbors(cell) {
            fetch(self.vertices.wrapping_add(facet.cell().index()));
        }
    }

    /// The vertex opposite the facet, in the facet's own cell.
    #[inline(always)]
    pub fn opposite(&self, facet: Facet) -> u32 {
        // SAFETY: as for the vertices; the facet's number is the place of the vertex.
        unsafe { self.vertices.cast::<u32>().add(facet.0 as usize).read() }
    }

    /// The neighbour across a facet.
    #[inline(always)]
    pub fn neighbor(&self, facet: Facet) -> Facet {
        // SAFETY: a facet is within bounds; nobody else writes this neighbour, by rule 2.
        Facet(unsafe { self.neighbors.cast::<u32>().add(facet.0 as usize).read() })
    }

    /// Whether a cell is in conflict with the new point, as far as is known; free slots are marked too.
    #[inline(always)]
    pub fn is_marked(&self, cell: Cell) -> bool {
        self.atomic_mark(cell).load(Ordering::Relaxed) != 0
    }

    /// Marks a cell, or not. One that the patch does not own is, and stays, unmarked.
    #[inline(always)]
    pub fn set_mark(&mut self, cell: Cell, in_conflict: bool) {
        self.atomic_mark(cell).store(u8::from(in_conflict), Ordering::Relaxed);
    }

    #[inline(always)]
    fn atomic_mark(&self, cell: Cell) -> &AtomicU8 {
        // SAFETY: a cell is within bounds; while there are patches, marks are only accessed here.
        unsafe { AtomicU8::from_ptr(self.marks.add(cell.index())) }
    }

    /// Gives a slot the vertices of a cell that the patch owns.
    #[inline(always)]
    pub fn put_vertices(&mut self, cell: Cell, vertices: [u32; 4]) {
        debug_assert!(self.owns(vertices), "{vertices:?}");
        // SAFETY: a cell is within bounds; nobody else touches it, by rule 1.
        unsafe { self.vertices.add(cell.index()).write(vertices) }
    }

    /// Gives a cell that the patch owns its neighbours.
    #[inline(always)]
    pub fn put_neighbors(&mut self, cell: Cell, [a, b, c, d]: [Facet; 4]) {
        // SAFETY: as for its vertices.
        unsafe { self.neighbors.add(cell.index()).write([a.0, b.0, c.0, d.0]) }
    }

    /// Changes the neighbour across a facet, where a cell that the patch owns was and is.
    #[inline(always)]
    pub fn set_neighbor(&mut self, facet: Facet, neighbor: Facet) {
        // SAFETY: a facet is within bounds; nobody else touches this neighbour, by rule 2.
        unsafe { self.neighbors.cast::<u32>().add(facet.0 as usize).write(neighbor.0) }
    }

    /// Whether the patch owns a cell with these vertices.
    #[inline(always)]
    pub fn owns(&self, [a, b, c, d]: [u32; 4]) -> bool {
        let own = |v| u32::from(self.owns_vertex(v));
        self.owners.is_none() || own(a) + own(b) + own(c) + own(d) >= 3
    }

    /// Whether the patch owns a vertex; nobody owns the one at infinity.
    #[inline(always)]
    pub fn owns_vertex(&self, vertex: u32) -> bool {
        self.owners.is_some_and(|(owners, id)| owners.get(vertex as usize) == Some(&id))
    }

    /// The slot of the vertex at infinity.
    #[inline(always)]
    pub fn infinite_slot(&self, vertices: [u32; 4]) -> Option<usize> {
        (0..4).find(|&i| vertices[i] == self.infinite)
    }
}

/// Asks the processor to have memory at hand that is needed soon.
#[inline(always)]
fn fetch<T>(at: *const T) {
    #[cfg(target_arch = "x86_64")]
    // SAFETY: every processor of the target has the instruction; a hint, which reads nothing.
    unsafe {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        _mm_prefetch::<_MM_HINT_T0>(at.cast());
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = at;
}

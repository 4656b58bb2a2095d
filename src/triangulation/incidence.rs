//! Derived incidences: the cells of a vertex, the edges, the ring of cells round an edge.

use super::Triangulation;
use super::cells::EVEN;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use crate::sort::sort_by_key;

/// The cells of every vertex, in rows.
///
/// Invariant: row `v` holds, ascending, exactly the cells that have vertex `v`; the row of a
/// hidden vertex is empty.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Incidence {
    offsets: Vec<u32>,
    cells: Vec<u32>,
}

impl Incidence {
    /// The cells of one vertex, ascending.
    pub fn cells_of(&self, vertex: u32) -> &[u32] {
        let v = vertex as usize;
        &self.cells[self.offsets[v] as usize..self.offsets[v + 1] as usize]
    }

    /// Where the row of each vertex begins; one more entry than vertices.
    pub fn offsets(&self) -> &[u32] {
        &self.offsets
    }

    /// All rows, one after the other.
    pub fn cells(&self) -> &[u32] {
        &self.cells
    }
}

/// Every edge once.
///
/// Invariants: in each edge the lesser vertex comes first; edges ascend lexicographically;
/// `cells[e]` is the least cell that has edge `e`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Edges {
    /// The two vertices of each edge.
    pub ends: Vec<[u32; 2]>,
    /// One cell of each edge.
    pub cells: Vec<u32>,
}

impl Edges {
    /// What the arrays take.
    pub(crate) fn bytes(&self) -> usize {
        size_of_val(&self.ends[..]) + size_of_val(&self.cells[..])
    }
}

impl Triangulation {
    /// The cells of every vertex. Errors: those of the job. Cost: O(n + m).
    pub fn incidence(&self, job: &Job) -> Result<Incidence> {
        job.run(&[(Stage::Extract, 1.0)], |run| {
            run.enter(Stage::Extract)?;
            self.incidence_in(run)
        })
    }

    /// [`Triangulation::incidence`] as a part of a larger build.
    pub(crate) fn incidence_in(&self, run: &Run<'_>) -> Result<Incidence> {
        let vertices = self.coords().len();
        let mut room = Room::new(run);
        let mut offsets = room.filled(vertices + 1, 0u32)?;
        for vertex in run.watch(self.cells.as_flattened()) {
            offsets[*vertex? as usize + 1] += 1;
        }
        for v in 0..vertices {
            offsets[v + 1] += offsets[v];
        }
        let mut cells = room.filled(4 * self.cells.len(), 0u32)?;
        let mut next = room.collect(offsets.iter().copied())?;
        for vertices in run.watch(self.cells.iter().enumerate()) {
            let (cell, vertices) = vertices?;
            for &vertex in vertices {
                let slot = &mut next[vertex as usize];
                cells[*slot as usize] = cell as u32;
                *slot += 1;
            }
        }
        Ok(Incidence { offsets, cells })
    }

    /// Every edge with one of its cells. Errors: those of the job. Cost: O(n + m), besides
    /// sorting the edges of each vertex.
    pub fn edges(&self, incidence: &Incidence, job: &Job) -> Result<Edges> {
        job.run(&[(Stage::Extract, 1.0)], |run| {
            run.enter(Stage::Extract)?;
            self.edges_in(incidence, run)
        })
    }

    /// [`Triangulation::edges`] as a part of a larger build.
    pub(crate) fn edges_in(&self, incidence: &Incidence, run: &Run<'_>) -> Result<Edges> {
        let mut room = Room::new(run);
        let mut edges = Edges::default();
        let mut found: Vec<(u32, u32)> = Vec::new();
        let mut seen = 0;
        for vertex in 0..self.coords().len() as u32 {
            // A vertex may have nearly all cells: they count, not the vertices.
            seen += incidence.cells_of(vertex).len();
            if seen >= 4096 {
                seen = 0;
                run.poll()?;
            }
            found.clear();
            room.grow(&mut found, 3 * incidence.cells_of(vertex).len())?;
            for &cell in incidence.cells_of(vertex) {
                let others = self.cells[cell as usize].into_iter().filter(|&v| v > vertex);
                found.extend(others.map(|other| (other, cell)));
            }
            sort_by_key(&mut found, |(other, _)| u64::from(*other), run)?;
            found.dedup_by_key(|(other, _)| *other);
            room.grow(&mut edges.ends, found.len())?;
            room.grow(&mut edges.cells, found.len())?;
            edges.ends.extend(found.iter().map(|&(other, _)| [vertex, other]));
            edges.cells.extend(found.iter().map(|&(_, cell)| cell));
        }
        Ok(edges)
    }

    /// The ring of cells round the edge from `a` to `b`, given one of them, into `ring`;
    /// returns whether it is closed.
    ///
    /// The cells turn counterclockwise seen from `b` to `a` (the right hand's fingers, thumb
    /// from `a` to `b`), so that their centres are the dual facet's polygon with its normal along the
    /// edge. A closed ring begins with its least cell; an open one, of an edge on the hull,
    /// with the cell that has the hull behind it. `cell` must have both vertices. Cost: O(ring).
    pub fn ring(&self, cell: u32, a: u32, b: u32, ring: &mut Vec<u32>) -> bool {
        ring.clear();
        let mut current = cell;
        loop {
            ring.push(current);
            match self.turn(current, a, b) {
                NONE => break,
                next if next == cell => {
                    let least = (0..ring.len()).min_by_key(|&i| ring[i]).unwrap_or(0);
                    ring.rotate_left(least);
                    return true;
                }
                next => current = next,
            }
        }
        // The hull cuts the ring: its first part lies clockwise of the given cell.
        let ahead = ring.len();
        current = self.turn(cell, b, a);
        while current != NONE {
            ring.push(current);
            current = self.turn(current, b, a);
        }
        ring[ahead..].reverse();
        ring.rotate_left(ahead);
        false
    }

    /// The next cell counterclockwise round the edge from `a` to `b`, or [`NONE`].
    fn turn(&self, cell: u32, a: u32, b: u32) -> u32 {
        self.neighbors[cell as usize][self.facet_ahead(cell, a, b)]
    }

    /// The facet of the cell through which a counterclockwise turn round the edge from `a` to `b`
    /// leaves it. The cell must have both vertices.
    pub(crate) fn facet_ahead(&self, cell: u32, a: u32, b: u32) -> usize {
        let vertices = &self.cells[cell as usize];
        let slot_of = |v: u32| vertices.iter().position(|&w| w == v).unwrap_or(0);
        // With (a, b, k, l) positive, the turn goes from k to l: it leaves through facet a b l.
        let [_, _, k, _] = EVEN[slot_of(a)][slot_of(b)];
        k
    }
}

//! Derived incidences: the cells of a vertex, the edges, the ring of cells round an edge.

use super::Triangulation;
use super::cells::EVEN;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Job, PART, Room, Run, Stage};
use crate::sort::sort_by_key;
use std::ops::Range;

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
        let vertices = self.coords().len();
        // Few parts: each needs as much memory as there are vertices.
        let size = match run.threads() {
            1 => vertices,
            threads => vertices.div_ceil(2 * threads).max(PART),
        };
        let ranges = (0..vertices).step_by(size.max(1));
        let ranges = ranges.map(|begin| begin..vertices.min(begin + size)).collect();
        let mut pieces = run.in_parallel(ranges, |range| {
            let mut room = Room::new(run);
            Ok((self.edges_of(incidence, range, &mut room, run)?, room))
        })?;
        if pieces.len() == 1 {
            return Ok(pieces.swap_remove(0).0);
        }
        let mut room = Room::new(run);
        let count = pieces.iter().map(|(edges, _)| edges.ends.len()).sum();
        let mut all = Edges { ends: room.vec(count)?, cells: room.vec(count)? };
        for (edges, _) in pieces {
            run.poll()?;
            all.ends.extend(edges.ends);
            all.cells.extend(edges.cells);
        }
        Ok(all)
    }

    /// The edges whose lesser vertex is one of the given.
    fn edges_of(
        &self,
        incidence: &Incidence,
        vertices: Range<usize>,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Edges> {
        let mut edges = Edges::default();
        let mut found: Vec<(u32, u32)> = Vec::new();
        // The vertex that has found each other one last.
        let mut finder = room.filled(self.coords().len(), NONE)?;
        let mut seen = 0;
        for vertex in vertices.start as u32..vertices.end as u32 {
            // A vertex may have nearly all cells: they count, not the vertices.
            let cells = incidence.cells_of(vertex);
            seen += cells.len();
            if seen >= 4096 {
                seen = 0;
                run.poll()?;
            }
            found.clear();
            room.grow(&mut found, 4 * cells.len())?;
            found.resize(4 * cells.len(), (0, 0));
            // Each is written where the next one goes, and kept if it is new: no branches, which nobody could
            // predict.
            let mut count = 0;
            for &cell in cells {
                for other in self.cells[cell as usize] {
                    let is_new = other > vertex && finder[other as usize] != vertex;
                    finder[other as usize] = vertex;
                    found[count] = (other, cell);
                    count += usize::from(is_new);
                }
            }
            found.truncate(count);
            sort_by_key(&mut found, |(other, _)| u64::from(*other), run)?;
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

    /// Whether any cell round the edge from `a` to `b` is what is looked for, given one of the cells; looks no
    /// further then. Cost: as [`Triangulation::ring`], or less.
    pub(crate) fn any_round(
        &self,
        cell: u32,
        a: u32,
        b: u32,
        is_it: impl Fn(&[u32; 4]) -> bool,
    ) -> bool {
        for [a, b] in [[a, b], [b, a]] {
            let mut current = cell;
            while current != NONE {
                if is_it(&self.cells[current as usize]) {
                    return true;
                }
                current = self.turn(current, a, b);
                if current == cell {
                    return false;
                }
            }
            // The hull cuts the ring: the rest lies the other way.
        }
        false
    }

    /// The next cell counterclockwise round the edge from `a` to `b`, or [`NONE`].
    fn turn(&self, cell: u32, a: u32, b: u32) -> u32 {
        self.neighbors[cell as usize][self.facet_ahead(cell, a, b)]
    }

    /// The facet of the cell through which a counterclockwise turn round the edge from `a` to `b`
    /// leaves it. The cell must have both vertices.
    pub(crate) fn facet_ahead(&self, cell: u32, a: u32, b: u32) -> usize {
        let [_, p, q, r] = self.cells[cell as usize];
        // Without branches, which nobody could predict.
        let slot_of =
            |v: u32| usize::from(p == v) + 2 * usize::from(q == v) + 3 * usize::from(r == v);
        // With (a, b, k, l) positive, the turn goes from k to l: it leaves through facet a b l.
        let [_, _, k, _] = EVEN[slot_of(a)][slot_of(b)];
        k
    }
}

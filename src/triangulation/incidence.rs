//! Derived incidences: the cells of a vertex, the edges, the ring of cells round an edge.

use super::Triangulation;
use super::cells::EVEN;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Job, PART, Room, Run, Stage, parts_of};
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
        let mut pieces = run.in_parallel(parts_of(size.max(1), vertices), |range| {
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
        ring.push(cell);
        let mut turn = Turn::new(self, cell, a, b);
        loop {
            match turn.step() {
                NONE => break,
                next if next == cell => {
                    let least = (0..ring.len()).min_by_key(|&i| ring[i]).unwrap_or(0);
                    ring.rotate_left(least);
                    return true;
                }
                next => ring.push(next),
            }
        }
        // The hull cuts the ring: its first part lies clockwise of the given cell.
        let ahead = ring.len();
        let mut turn = Turn::new(self, cell, b, a);
        loop {
            match turn.step() {
                NONE => break,
                next => ring.push(next),
            }
        }
        ring[ahead..].reverse();
        ring.rotate_left(ahead);
        false
    }

    /// The edges of a cell, as pairs of slots, that it is the first to have, as far as its neighbours tell: no lesser
    /// cell is next to it round the edge. So every edge is found in its least cell, and now and then in others.
    #[inline]
    pub(crate) fn edges_met(&self, cell: u32) -> &'static [[usize; 2]] {
        const TABLE: [([[usize; 2]; 6], usize); 16] = edges_by_lesser_neighbors();
        let neighbors = self.neighbors[cell as usize];
        let lesser = (0..4).fold(0, |bits, i| bits | usize::from(neighbors[i] < cell) << i);
        let (edges, count) = &TABLE[lesser];
        &edges[..*count]
    }

    /// The facet of the cell through which a counterclockwise turn round the edge from `a` to `b`
    /// leaves it. The cell must have both vertices.
    pub(crate) fn facet_ahead(&self, cell: u32, a: u32, b: u32) -> usize {
        let corners = &self.cells[cell as usize];
        let [_, _, k, _] = EVEN[slot_of(corners, a)][slot_of(corners, b)];
        k
    }
}

/// The slot of a vertex that the cell has. Without branches, which nobody could predict.
#[inline]
fn slot_of([_, p, q, r]: &[u32; 4], v: u32) -> usize {
    usize::from(*p == v) + 2 * usize::from(*q == v) + 3 * usize::from(*r == v)
}

/// For each set of facets, a bit each, the edges round which no turn passes any of them.
const fn edges_by_lesser_neighbors() -> [([[usize; 2]; 6], usize); 16] {
    let mut table = [([[0; 2]; 6], 0); 16];
    let mut facets = 0;
    while facets < 16 {
        let (edges, count) = &mut table[facets];
        let mut pair = 0;
        while pair < 16 {
            let [i, j] = [pair / 4, pair % 4];
            // Round edge i j turns pass the facets opposite the other two.
            if i < j && facets & !(1 << i | 1 << j) == 0 {
                edges[*count] = [i, j];
                *count += 1;
            }
            pair += 1;
        }
        facets += 1;
    }
    table
}

/// A turn round an edge, counterclockwise seen from its second end to its first, cell by cell.
pub(crate) struct Turn<'a> {
    t: &'a Triangulation,
    cell: u32,
    /// The exclusive or of the two ends.
    ends: u32,
    /// The vertices of the cell that are not ends: the turn goes from the first to the second, and so leaves the
    /// cell opposite the first.
    behind: u32,
    ahead: u32,
}

impl<'a> Turn<'a> {
    /// A turn round the edge from `a` to `b`, both of them vertices of the cell in which it begins.
    pub(crate) fn new(t: &'a Triangulation, cell: u32, a: u32, b: u32) -> Self {
        let corners = &t.cells[cell as usize];
        // With (a, b, k, l) positive, the turn goes from k to l: it leaves through facet a b l.
        let [_, _, k, l] = EVEN[slot_of(corners, a)][slot_of(corners, b)];
        Turn { t, cell, ends: a ^ b, behind: corners[k], ahead: corners[l] }
    }

    /// The cell that the turn has come to.
    #[inline]
    pub(crate) fn cell(&self) -> u32 {
        self.cell
    }

    /// The next cell; at the hull [`NONE`].
    #[inline]
    pub(crate) fn next(&self) -> u32 {
        let facet = slot_of(&self.t.cells[self.cell as usize], self.behind);
        self.t.neighbors[self.cell as usize][facet]
    }

    /// Goes on to the next cell, given it.
    #[inline]
    pub(crate) fn enter(&mut self, next: u32) {
        // Of its vertices three are known: the exclusive or of these and of all four is the last.
        let [p, q, r, s] = self.t.cells[next as usize];
        let beyond = p ^ q ^ r ^ s ^ self.ends ^ self.ahead;
        (self.behind, self.ahead) = (self.ahead, beyond);
        self.cell = next;
    }

    /// Goes on to the next cell, if there is one, and returns it.
    pub(crate) fn step(&mut self) -> u32 {
        let next = self.next();
        if next != NONE {
            self.enter(next);
        }
        next
    }
}

#[cfg(test)]
mod tests {
    use crate::job::Job;
    use crate::{Points, Triangulation};
    use std::sync::Arc;

    #[test]
    fn every_edge_is_met_in_its_least_cell() {
        let row = |i: usize| [i % 6, i / 6 % 6, i / 36].map(|x| x as f64);
        let points = Points::by_row(216, row, Default::default(), &Job::default()).unwrap();
        let t = Triangulation::delaunay(&Arc::new(points), &Job::default()).unwrap();
        let edges = t.edges(&t.incidence(&Job::default()).unwrap(), &Job::default()).unwrap();
        let mut met = Vec::new();
        for (cell, corners) in t.cells().iter().enumerate() {
            for &[i, j] in t.edges_met(cell as u32) {
                let [a, b] = [corners[i], corners[j]];
                met.push(([a.min(b), a.max(b)], cell as u32));
            }
        }
        // Now and then another cell meets it too.
        assert!(met.len() > edges.ends.len() && met.len() < 2 * edges.ends.len());
        met.sort();
        met.dedup_by_key(|(ends, _)| *ends);
        let expected: Vec<_> = edges.ends.into_iter().zip(edges.cells).collect();
        assert_eq!(met, expected);
    }
}

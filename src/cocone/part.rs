//! Parting: where the boundary of the inner cells touches itself, cells change sides until it does not.

use crate::error::Result;
use crate::index::NONE;
use crate::job::{PART, Room, Run};
use crate::triangulation::{Incidence, Triangulation};

/// How many cells may change sides at once.
const MOST: usize = 32;

/// Where the surface touches itself, changes the label of cells so that it does so less often, and returns which, ascending.
///
/// Round an edge with four triangles or more inner and outer cells take turns; round a pinched vertex those of one side do not hang together through
/// triangles. Each such *sector* may change sides. Those that the votes of well sampled vertices hold least in their place come first, and
/// one does if round all edges and vertices of its cells the surface then touches itself less often. That is repeated as long as it helps. The papers
/// have no such step: where samples are dense enough the surface does not touch itself.
pub(super) fn part(
    t: &Triangulation,
    incidence: &Incidence,
    votes: &[i8],
    is_inner: &mut [bool],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<u32>> {
    let stars = Stars { t, incidence };
    let vertices = 0..t.coords().len() as u32;
    let labels = &*is_inner;
    let chunks = vertices.step_by(PART / 16).collect();
    let touching = run.in_parallel(chunks, |begin: u32| {
        run.poll()?;
        let mut room = Room::new(run);
        let mut found: Vec<u32> = Vec::new();
        for vertex in begin..(begin + (PART / 16) as u32).min(t.coords().len() as u32) {
            if stars.touches(labels, vertex) > 0 {
                room.push(&mut found, vertex)?;
            }
        }
        Ok((found, room))
    })?;
    let mut waiting = Vec::new();
    for (found, _) in touching {
        room.grow(&mut waiting, found.len())?;
        waiting.extend(found);
    }
    let mut changed: Vec<u32> = Vec::new();
    while !waiting.is_empty() {
        let mut next = Vec::new();
        for vertex in waiting {
            run.poll()?;
            let mut sectors = stars.sectors(is_inner, vertex);
            sectors.retain(|sector| sector.len() <= MOST);
            let hold = |sector: &[u32]| -> i32 {
                let hold = |&cell: &u32| {
                    let vote = i32::from(votes[cell as usize]);
                    (if is_inner[cell as usize] { vote } else { -vote }).max(0)
                };
                sector.iter().map(hold).sum()
            };
            sectors.sort_by_cached_key(|sector| (hold(sector), sector.len(), sector.clone()));
            for sector in sectors {
                let mut vertices: Vec<u32> =
                    sector.iter().flat_map(|&cell| t.cells()[cell as usize]).collect();
                vertices.sort_unstable();
                vertices.dedup();
                let count = |is_inner: &[bool]| -> usize {
                    vertices.iter().map(|&vertex| stars.touches(is_inner, vertex)).sum()
                };
                let before = count(is_inner);
                sector.iter().for_each(|&cell| is_inner[cell as usize] ^= true);
                if count(is_inner) < before {
                    room.grow(&mut changed, sector.len())?;
                    changed.extend(sector);
                    room.grow(&mut next, vertices.len())?;
                    next.extend(vertices);
                    break;
                }
                sector.iter().for_each(|&cell| is_inner[cell as usize] ^= true);
            }
        }
        next.sort_unstable();
        next.dedup();
        next.retain(|&vertex| stars.touches(is_inner, vertex) > 0);
        waiting = next;
    }
    // What has changed twice is what it was.
    changed.sort_unstable();
    Ok(changed.chunk_by(|a, b| a == b).filter(|same| same.len() % 2 == 1).map(|s| s[0]).collect())
}

/// The cells round vertices and edges.
struct Stars<'a> {
    t: &'a Triangulation,
    incidence: &'a Incidence,
}

impl Stars<'_> {
    /// How often the surface touches itself at a vertex and at its edges: how many more sectors than two there are.
    fn touches(&self, is_inner: &[bool], vertex: u32) -> usize {
        let cells = self.incidence.cells_of(vertex);
        let Some(&first) = cells.first() else { return 0 };
        let is_hull = |&cell: &u32| self.hull_facets(cell, vertex).next().is_some();
        let is_one = cells.iter().all(|&cell| is_inner[cell as usize] == is_inner[first as usize]);
        if is_one && !(is_inner[first as usize] && cells.iter().any(is_hull)) {
            return 0;
        }
        let (groups, beyond) = self.groups(is_inner, vertex);
        let mut roots: Vec<(bool, u32)> = cells
            .iter()
            .zip(&groups)
            .map(|(&cell, &group)| (is_inner[cell as usize], group))
            .chain(beyond.map(|group| (false, group)))
            .collect();
        roots.sort_unstable();
        roots.dedup();
        let inner = roots.iter().filter(|&&(inner, _)| inner).count();
        let outer = roots.len() - inner;
        let mut touches = inner.saturating_sub(1) + outer.saturating_sub(1);
        self.for_each_edge(is_inner, vertex, |ring, closed| {
            touches += (Self::changes(is_inner, ring, closed) / 2).saturating_sub(1);
        });
        touches
    }

    /// The sectors at a vertex and at its edges where the surface touches itself there, but for those with what lies beyond the hull.
    fn sectors(&self, is_inner: &[bool], vertex: u32) -> Vec<Vec<u32>> {
        let cells = self.incidence.cells_of(vertex);
        let (groups, beyond) = self.groups(is_inner, vertex);
        let mut members: Vec<(u32, u32)> = groups.into_iter().zip(cells.iter().copied()).collect();
        members.sort_unstable();
        let mut sectors: Vec<Vec<u32>> = members
            .chunk_by(|a, b| a.0 == b.0)
            .filter(|group| beyond != Some(group[0].0))
            .map(|group| group.iter().map(|&(_, cell)| cell).collect())
            .collect();
        self.for_each_edge(is_inner, vertex, |ring, closed| {
            if Self::changes(is_inner, ring, closed) < 4 {
                return;
            }
            let mut ring = ring.to_vec();
            if closed {
                // A sector to begin with.
                let label = |i: usize| is_inner[ring[i] as usize];
                let begin = (1..ring.len()).find(|&i| label(i) != label(i - 1)).unwrap_or(0);
                ring.rotate_left(begin);
            }
            let runs: Vec<&[u32]> =
                ring.chunk_by(|&a, &b| is_inner[a as usize] == is_inner[b as usize]).collect();
            for (i, run) in runs.iter().enumerate() {
                let at_hull = !closed && (i == 0 || i + 1 == runs.len());
                if is_inner[run[0] as usize] || !at_hull {
                    let mut sector = run.to_vec();
                    sector.sort_unstable();
                    sectors.push(sector);
                }
            }
        });
        sectors
    }

    /// For each cell of a vertex a number that those share that hang together through triangles at it, and that of what lies beyond the
    /// hull.
    fn groups(&self, is_inner: &[bool], vertex: u32) -> (Vec<u32>, Option<u32>) {
        let cells = self.incidence.cells_of(vertex);
        let beyond = cells.len() as u32;
        let mut parent: Vec<u32> = (0..=beyond).collect();
        let mut at_hull = false;
        for (i, &cell) in cells.iter().enumerate() {
            let corners = &self.t.cells()[cell as usize];
            for (slot, &next) in self.t.neighbors()[cell as usize].iter().enumerate() {
                if corners[slot] == vertex {
                    continue;
                }
                let other = match next {
                    NONE if is_inner[cell as usize] => {
                        at_hull = true;
                        continue;
                    }
                    NONE => {
                        at_hull = true;
                        beyond
                    }
                    next if is_inner[next as usize] != is_inner[cell as usize] => continue,
                    next => cells.binary_search(&next).map_or(i as u32, |other| other as u32),
                };
                let [a, b] = [i as u32, other].map(|mut x| {
                    while parent[x as usize] != x {
                        x = parent[x as usize];
                    }
                    x
                });
                parent[a.max(b) as usize] = a.min(b);
            }
        }
        // A parent is less than its child.
        for i in 0..parent.len() {
            parent[i] = parent[parent[i] as usize];
        }
        let last = parent.pop();
        (parent, last.filter(|_| at_hull))
    }

    /// Calls a function for the ring of cells round each edge at a vertex that has cells of both labels, and whether it is closed.
    fn for_each_edge(&self, is_inner: &[bool], vertex: u32, mut call: impl FnMut(&[u32], bool)) {
        let mut ends: Vec<(u32, u32)> = Vec::new();
        for &cell in self.incidence.cells_of(vertex) {
            let corners = self.t.cells()[cell as usize];
            ends.extend(corners.into_iter().filter(|&v| v != vertex).map(|v| (v, cell)));
        }
        ends.sort_unstable();
        let mut ring = Vec::new();
        for cells in ends.chunk_by(|a, b| a.0 == b.0) {
            let (end, first) = cells[0];
            // Four sectors take four cells, or three and what lies beyond the hull.
            let inner = cells.iter().filter(|&&(_, cell)| is_inner[cell as usize]).count();
            if inner > 0 && cells.len() > 2 {
                let closed = self.t.ring(first, vertex, end, &mut ring);
                call(&ring, closed);
            }
        }
    }

    /// How often labels change round an edge.
    fn changes(is_inner: &[bool], ring: &[u32], closed: bool) -> usize {
        let label = |&cell: &u32| is_inner[cell as usize];
        let inside = ring.windows(2).filter(|pair| label(&pair[0]) != label(&pair[1])).count();
        match (closed, ring) {
            (true, [first, .., last]) => inside + usize::from(label(first) != label(last)),
            (false, [first, .., last]) => {
                inside + usize::from(label(first)) + usize::from(label(last))
            }
            _ => inside,
        }
    }

    /// The facets of a cell on the hull that have a vertex of it.
    fn hull_facets(&self, cell: u32, vertex: u32) -> impl Iterator<Item = usize> {
        let (corners, neighbors) =
            (self.t.cells()[cell as usize], self.t.neighbors()[cell as usize]);
        (0..4).filter(move |&slot| neighbors[slot] == NONE && corners[slot] != vertex)
    }
}

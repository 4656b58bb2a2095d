//! A complex as a cell complex of indices: each edge, face and cell once, with its incidences.

use super::{CellType, Complex};
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::Run;

/// The number of steps between two ticks.
const BATCH: usize = 1 << 14;

/// Items grouped by a key: those of key `k` are `items[offsets[k]..offsets[k + 1]]`, ascending.
pub(super) struct Groups {
    offsets: Vec<u32>,
    items: Vec<u32>,
}

impl Groups {
    /// Groups the items `0..len` by `key`, which is below `keys`, or [`NONE`] to leave one out.
    pub(super) fn new(
        keys: usize,
        len: usize,
        key: impl Fn(usize) -> u32,
        run: &Run<'_>,
    ) -> Result<Self> {
        let mut offsets = filled(keys + 1, 0u32, run)?;
        for batch in (0..len).step_by(BATCH) {
            run.poll()?;
            for i in batch..len.min(batch + BATCH) {
                match key(i) {
                    NONE => {}
                    k => offsets[k as usize] += 1,
                }
            }
        }
        // First each group's end; filling from the back then leaves its begin.
        let mut end = 0;
        for offset in &mut offsets {
            end += *offset;
            *offset = end;
        }
        let mut items = filled(end as usize, 0u32, run)?;
        for batch in (0..len).step_by(BATCH).rev() {
            run.poll()?;
            for i in (batch..len.min(batch + BATCH)).rev() {
                match key(i) {
                    NONE => {}
                    k => {
                        offsets[k as usize] -= 1;
                        items[offsets[k as usize] as usize] = i as u32;
                    }
                }
            }
        }
        Ok(Groups { offsets, items })
    }

    /// The items of key `k`, ascending.
    pub(super) fn get(&self, k: usize) -> &[u32] {
        &self.items[self.offsets[k] as usize..self.offsets[k + 1] as usize]
    }

    /// Replaces every item by what it stands for.
    pub(super) fn replace(&mut self, of: impl Fn(u32) -> u32) {
        self.items.iter_mut().for_each(|item| *item = of(*item));
    }

    fn get_mut(&mut self, k: usize) -> &mut [u32] {
        &mut self.items[self.offsets[k] as usize..self.offsets[k + 1] as usize]
    }
}

/// A vector of `len` equal values, or an error where memory does not suffice.
pub(super) fn filled<T: Clone>(len: usize, value: T, run: &Run<'_>) -> Result<Vec<T>> {
    let mut vec = run.try_vec(len)?;
    vec.resize(len, value);
    Ok(vec)
}

/// Rings of vertices, one after the other; ring `r` is `vertices[offsets[r]..offsets[r + 1]]`.
struct Rings {
    offsets: Vec<u32>,
    vertices: Vec<u32>,
}

impl Rings {
    fn with_capacity(rings: usize, vertices: usize, run: &Run<'_>) -> Result<Self> {
        let mut offsets = run.try_vec(rings + 1)?;
        offsets.push(0);
        Ok(Rings { offsets, vertices: run.try_vec(vertices)? })
    }

    fn push(&mut self, ring: impl Iterator<Item = u32>) {
        self.vertices.extend(ring);
        self.offsets.push(self.vertices.len() as u32);
    }

    fn len(&self) -> usize {
        self.offsets.len() - 1
    }

    fn get(&self, r: usize) -> &[u32] {
        &self.vertices[self.offsets[r] as usize..self.offsets[r + 1] as usize]
    }
}

/// The cell complex of a [`Complex`].
///
/// Faces that are the same ring, up to where it begins and which way it runs, are one face: a
/// listed face and a facet of a cell, the facets of two cells, a face listed twice. Cells with
/// the same facets are one cell, edges with the same ends one edge. The faces listed come first,
/// in the order of the list, each with the ring that it has there; sides are numbered through all
/// rings, and side `s` runs from `tail(s)` to the next vertex of its ring.
pub(super) struct Skeleton {
    pub(super) vertex_count: usize,
    /// The ends of each edge, the lesser first; ascending.
    pub(super) edges: Vec<[u32; 2]>,
    /// The number of faces that are listed as such; the others are facets of cells only.
    pub(super) listed: usize,
    /// The face of each row of the list.
    pub(super) face_of_row: Vec<u32>,
    /// The cell of each row of the list.
    pub(super) cell_of_row: Vec<u32>,
    rings: Rings,
    /// For each side its face and its edge.
    pub(super) face_of_side: Vec<u32>,
    pub(super) edge_of_side: Vec<u32>,
    sides_of_edge: Groups,
    facets_of_cell: Rings,
    cells_of_face: Groups,
}

impl Skeleton {
    /// The cell complex of a complex.
    ///
    /// Errors: [`Status::LimitExceeded`] past 2^31 - 1 sides of faces and facets. Cost: linear, but
    /// for the sorting of short lists.
    pub(super) fn new(complex: &Complex, run: &Run<'_>) -> Result<Self> {
        let (rings, facets_of_cell) = list_rings(complex, run)?;
        let canonical = canonical_rings(&rings, run)?;
        let first = first_equal(&canonical, complex.vertices.len(), run)?;
        drop(canonical);
        run.tick(1, 4)?;

        let mut face_of_ring: Vec<u32> = run.try_vec(rings.len())?;
        let mut faces = Rings::with_capacity(rings.len(), rings.vertices.len(), run)?;
        let mut listed = 0;
        for batch in (0..rings.len()).step_by(BATCH) {
            run.poll()?;
            for r in batch..rings.len().min(batch + BATCH) {
                if first[r] as usize == r {
                    face_of_ring.push(faces.len() as u32);
                    faces.push(rings.get(r).iter().copied());
                    listed += usize::from(r < complex.faces.len());
                } else {
                    face_of_ring.push(face_of_ring[first[r] as usize]);
                }
            }
        }
        let (facets_of_cell, cells_of_face, cell_of_row) =
            distinct_cells(&facets_of_cell, &face_of_ring, faces.len(), run)?;
        drop((rings, first));
        run.tick(2, 4)?;

        let mut face_of_side = run.try_vec(faces.vertices.len())?;
        for f in run.watch(0..faces.len()) {
            let f = f?;
            face_of_side.extend(std::iter::repeat_n(f as u32, faces.get(f).len()));
        }
        let (edges, edge_of_side) = number_edges(complex, &faces, run)?;
        let sides = edge_of_side.len();
        let sides_of_edge = Groups::new(edges.len(), sides, |s| edge_of_side[s], run)?;
        run.tick(3, 4)?;
        face_of_ring.truncate(complex.faces.len());
        Ok(Skeleton {
            vertex_count: complex.vertices.len(),
            edges,
            listed,
            face_of_row: face_of_ring,
            cell_of_row,
            rings: faces,
            face_of_side,
            edge_of_side,
            sides_of_edge,
            facets_of_cell,
            cells_of_face,
        })
    }

    pub(super) fn face_count(&self) -> usize {
        self.rings.len()
    }

    pub(super) fn cell_count(&self) -> usize {
        self.facets_of_cell.len()
    }

    /// The vertices of a face in the order of its ring.
    pub(super) fn ring(&self, face: usize) -> &[u32] {
        self.rings.get(face)
    }

    /// The sides of a face: side `i` of the range leaves vertex `i` of its ring.
    pub(super) fn sides(&self, face: usize) -> std::ops::Range<usize> {
        self.rings.offsets[face] as usize..self.rings.offsets[face + 1] as usize
    }

    /// The vertex that a side leaves.
    pub(super) fn tail(&self, side: u32) -> u32 {
        self.rings.vertices[side as usize]
    }

    /// Whether the side runs along its edge from the lesser end to the greater.
    pub(super) fn is_forward(&self, side: u32) -> bool {
        self.tail(side) == self.edges[self.edge_of_side[side as usize] as usize][0]
    }

    /// Every side that lies on the edge, ascending; those of listed faces come first.
    pub(super) fn sides_of_edge(&self, edge: usize) -> &[u32] {
        self.sides_of_edge.get(edge)
    }

    /// The sides of listed faces that lie on the edge.
    pub(super) fn listed_sides_of_edge(&self, edge: usize) -> &[u32] {
        let sides = self.sides_of_edge.get(edge);
        let end = self.rings.offsets[self.listed];
        &sides[..sides.partition_point(|&s| s < end)]
    }

    /// The facets of a cell, ascending.
    pub(super) fn facets(&self, cell: usize) -> &[u32] {
        self.facets_of_cell.get(cell)
    }

    /// The cells that a face bounds.
    pub(super) fn cells_of_face(&self, face: usize) -> &[u32] {
        self.cells_of_face.get(face)
    }
}

/// The listed faces, then the facets of each cell, as rings; and for each cell its rings' numbers.
fn list_rings(complex: &Complex, run: &Run<'_>) -> Result<(Rings, Rings)> {
    let listed = complex.faces.len();
    let kinds = || complex.cells.iter().zip(&complex.cell_types);
    let (mut count, mut size) = (listed, complex.faces.indices().len());
    for (cell, kind) in kinds() {
        let base = cell.len() - 1;
        count += base + 1;
        size += 3 * base + if *kind == CellType::Tetrahedron { 3 } else { base };
    }
    if size + complex.edges.len() >= 1 << 31 {
        return Err(Error::new(
            Status::LimitExceeded,
            "the complex has more than 2^31 - 1 sides of faces and facets; ask for parts of it",
        ));
    }
    let mut rings = Rings::with_capacity(count, size, run)?;
    let mut facets = Rings::with_capacity(complex.cells.len(), count - listed, run)?;
    for (i, face) in complex.faces.iter().enumerate() {
        if i % BATCH == 0 {
            run.poll()?;
        }
        rings.push(face.iter().copied());
    }
    for (i, (cell, kind)) in kinds().enumerate() {
        if i % BATCH == 0 {
            run.poll()?;
        }
        let begin = rings.len() as u32;
        // Every cell is a pyramid: a base, and an apex that comes last.
        let (&apex, base) = cell.split_last().unwrap_or((&0, &[]));
        debug_assert!(*kind != CellType::Tetrahedron || base.len() == 3);
        rings.push(base.iter().copied());
        for k in 0..base.len() {
            rings.push([base[k], base[(k + 1) % base.len()], apex].into_iter());
        }
        facets.push(begin..rings.len() as u32);
    }
    Ok((rings, facets))
}

/// The rings, each read so that equal ones become equal lists.
fn canonical_rings(rings: &Rings, run: &Run<'_>) -> Result<Rings> {
    let mut canonical = Rings::with_capacity(rings.len(), rings.vertices.len(), run)?;
    for r in 0..rings.len() {
        if r % BATCH == 0 {
            run.poll()?;
        }
        canonical.push(canonical_ring(rings.get(r)));
    }
    Ok(canonical)
}

/// For each list the first one equal to it. Lists are not empty and start below `keys`.
fn first_equal(lists: &Rings, keys: usize, run: &Run<'_>) -> Result<Vec<u32>> {
    let mut buckets = Groups::new(keys, lists.len(), |r| lists.get(r)[0], run)?;
    let mut first = filled(lists.len(), 0u32, run)?;
    for key in 0..keys {
        if key % BATCH == 0 {
            run.poll()?;
        }
        let bucket = buckets.get_mut(key);
        bucket.sort_unstable_by(|&r, &q| {
            lists.get(r as usize).cmp(lists.get(q as usize)).then(r.cmp(&q))
        });
        let mut equal = 0;
        for (i, &r) in bucket.iter().enumerate() {
            if lists.get(r as usize) != lists.get(bucket[equal] as usize) {
                equal = i;
            }
            first[r as usize] = bucket[equal];
        }
    }
    Ok(first)
}

/// The least of the sequences that a ring reads as, from any of its vertices, either way round.
fn canonical_ring(ring: &[u32]) -> impl Iterator<Item = u32> {
    let n = ring.len();
    let read = move |start: usize, back: bool| {
        (0..n).map(move |k| ring[if back { (start + n - k) % n } else { (start + k) % n }])
    };
    let least = ring.iter().min().copied().unwrap_or(NONE);
    // A polygon may pass its least vertex more than once; any other ring has two candidates.
    let best = (0..n)
        .filter(|&i| ring[i] == least)
        .flat_map(|i| [(i, false), (i, true)])
        .min_by(|a, b| read(a.0, a.1).cmp(read(b.0, b.1)))
        .unwrap_or((0, false));
    read(best.0, best.1)
}

/// The facets of each distinct cell, ascending, the cells of each face, and the cell of each row.
fn distinct_cells(
    rings_of_cell: &Rings,
    face_of_ring: &[u32],
    faces: usize,
    run: &Run<'_>,
) -> Result<(Rings, Groups, Vec<u32>)> {
    let mut all = Rings::with_capacity(rings_of_cell.len(), rings_of_cell.vertices.len(), run)?;
    let mut facets: Vec<u32> = Vec::new();
    for c in 0..rings_of_cell.len() {
        if c % BATCH == 0 {
            run.poll()?;
        }
        facets.clear();
        facets.extend(rings_of_cell.get(c).iter().map(|&r| face_of_ring[r as usize]));
        facets.sort_unstable();
        all.push(facets.iter().copied());
    }
    let first = first_equal(&all, faces, run)?;
    let mut cells = Rings::with_capacity(all.len(), all.vertices.len(), run)?;
    let mut owner: Vec<u32> = run.try_vec(all.vertices.len())?;
    let mut cell_of_row: Vec<u32> = run.try_vec(all.len())?;
    for c in run.watch(0..all.len()) {
        let c = c?;
        if (first[c] as usize) < c {
            cell_of_row.push(cell_of_row[first[c] as usize]);
            continue;
        }
        cell_of_row.push(cells.len() as u32);
        owner.extend(std::iter::repeat_n(cells.len() as u32, all.get(c).len()));
        cells.push(all.get(c).iter().copied());
    }
    let mut groups = Groups::new(faces, cells.vertices.len(), |i| cells.vertices[i], run)?;
    groups.replace(|i| owner[i as usize]);
    Ok((cells, groups, cell_of_row))
}

/// The distinct edges, ascending, and the edge of each side.
fn number_edges(
    complex: &Complex,
    faces: &Rings,
    run: &Run<'_>,
) -> Result<(Vec<[u32; 2]>, Vec<u32>)> {
    // Pairs of ends: those of the sides, then those of the loose edges.
    let sides = faces.vertices.len();
    let mut pairs: Vec<[u32; 2]> = run.try_vec(sides + complex.edges.len())?;
    for f in run.watch(0..faces.len()) {
        let ring = faces.get(f?);
        pairs.extend((0..ring.len()).map(|k| sorted(ring[k], ring[(k + 1) % ring.len()])));
    }
    pairs.extend(complex.edges.iter().map(|edge| sorted(edge[0], edge[1])));
    run.poll()?;
    let vertices = complex.vertices.len();
    let mut buckets = Groups::new(vertices, pairs.len(), |i| pairs[i][0], run)?;
    let mut edges: Vec<[u32; 2]> = run.try_vec(pairs.len())?;
    let mut edge_of_pair = filled(pairs.len(), 0u32, run)?;
    for v in 0..vertices {
        if v % BATCH == 0 {
            run.poll()?;
        }
        let bucket = buckets.get_mut(v);
        bucket.sort_unstable_by_key(|&i| (pairs[i as usize][1], i));
        for &i in bucket.iter() {
            let pair = pairs[i as usize];
            if edges.last() != Some(&pair) {
                edges.push(pair);
            }
            edge_of_pair[i as usize] = edges.len() as u32 - 1;
        }
    }
    edge_of_pair.truncate(sides);
    Ok((edges, edge_of_pair))
}

fn sorted(a: u32, b: u32) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

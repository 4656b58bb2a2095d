//! The power crust: the facets of the power diagram between inner and outer cells.

use super::division::{Division, Edge};
use super::places::Places;
use super::shards;
use crate::complex::{Attribute, Complex, ComplexParts, Element, Rows, Values};
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{PART, Room, Run, parts, pieces};
use crate::poles::Poles;
use crate::triangulation::{Triangulation, Turn};

/// What becomes of the shards of samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Shards {
    /// There are none: the balls do not touch the samples.
    None,
    /// They stay as they are.
    Keep,
    /// Those of each sample are merged.
    Merge,
}

/// The oriented boundary between the inner and the outer cells of the power diagram.
///
/// Each face is the convex polygon dual to an edge between an inner and an outer pole, turning
/// counterclockwise as seen from the outer one. It is closed by construction: an edge of the
/// polygon is dual to a facet of the regular triangulation, and of that facet's three
/// poles none or exactly two pairs have different labels. Its vertices are cells of the
/// triangulation, those with poles of both labels, so that the same argument on a tetrahedron's four poles, of which one or
/// two are inner, makes every vertex's faces one disk: the surface is a manifold.
///
/// If that is asked for, the shards of each sample are merged then, see `shards.rs`; faces left with two vertices or one
/// are gone. Shards that stay apart have no sample.
///
/// Faces are in the order of their dual edges, the lesser vertex of each first, and begin with their least cells.
/// Vertices carry `cell`, the least, and `sample`, faces `inner_pole` and `outer_pole`.
pub(super) fn extract(
    poles: &Poles,
    regular: &Triangulation,
    division: &Division,
    treatment: Shards,
    run: &Run<'_>,
) -> Result<Complex> {
    let mut room = Room::new(run);
    let (cells, vertex_of_cell) = mixed_cells(regular, division, &mut room, run)?;
    let samples = match treatment {
        Shards::None => room.filled(cells.len(), NONE)?,
        _ => shards::samples_of_cells(poles, regular, &cells, [0.15, 0.2], &mut room, run)?,
    };
    let separates = |cell: usize, [i, j]: [usize; 2]| {
        let inner = division.shares[cell].inner();
        (inner >> i ^ inner >> j) & 1 == 1
    };
    let edges = division.edges(regular, [0.2, 0.25], separates, &mut room, run)?;
    let pieces = run.in_steps(edges.chunks(PART / 8).collect(), [0.25, 0.4], |edges| {
        let mut room = Room::new(run);
        Ok((Faces::new(regular, division, edges, &vertex_of_cell, &mut room)?, room))
    })?;
    drop((vertex_of_cell, edges));
    let mut surface = Surface::joined(pieces, cells, samples, &mut room, run)?;
    let vertices = match treatment {
        Shards::Merge => surface.merge_shards(poles, regular, &mut room, run)?,
        _ => {
            let mut places = Places::new(poles, regular, &surface.cells, &mut room)?;
            places.settle(&room.filled(surface.cells.len(), NONE)?, [0.4, 0.5], run)?;
            places.into_positions()
        }
    };
    let attribute =
        |name: &str, element, values| Attribute::new(name, element, 1, Values::U32(values));
    let parts = ComplexParts {
        vertices,
        faces: surface.faces,
        attributes: vec![
            attribute("cell", Element::Vertex, surface.cells)?,
            attribute("sample", Element::Vertex, surface.samples)?,
            attribute("inner_pole", Element::Face, surface.inner_pole)?,
            attribute("outer_pole", Element::Face, surface.outer_pole)?,
        ],
        ..Default::default()
    };
    Complex::sound_in(parts, run)
}

/// The cells with poles of both labels, which are the vertices of the surface, and the vertex of each of them. Nobody asks for that
/// of another cell.
fn mixed_cells(
    regular: &Triangulation,
    division: &Division,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<(Vec<u32>, Vec<u32>)> {
    let offsets = division.offsets(|share| usize::from(share.is_mixed()));
    let mut cells = room.filled(offsets[offsets.len() - 1], 0u32)?;
    let mut vertex_of_cell = room.filled(regular.cells().len(), 0u32)?;
    let ranges = parts(regular.cells().len()).into_iter().zip(&offsets);
    let cells_of_parts = pieces(&mut cells, offsets[1..].iter().copied());
    let results = vertex_of_cell.chunks_mut(PART).zip(cells_of_parts);
    run.in_steps(ranges.zip(results).collect(), [0.1, 0.15], |((range, &first), results)| {
        let (vertex_of_cell, cells) = results;
        let shares = division.shares[range.clone()].iter().enumerate();
        let mixed = shares.filter(|(_, share)| share.is_mixed());
        for (i, ((place, _), cell)) in mixed.zip(cells).enumerate() {
            *cell = (range.start + place) as u32;
            vertex_of_cell[place] = (first + i) as u32;
        }
        Ok(())
    })?;
    Ok((cells, vertex_of_cell))
}

/// A surface without the positions of its vertices.
struct Surface {
    /// For each vertex its least cell, and its sample or [`NONE`].
    cells: Vec<u32>,
    samples: Vec<u32>,
    faces: Rows,
    inner_pole: Vec<u32>,
    outer_pole: Vec<u32>,
}

impl Surface {
    /// All faces of all pieces.
    fn joined(
        pieces: Vec<(Faces, Room<'_>)>,
        cells: Vec<u32>,
        samples: Vec<u32>,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let count = pieces.iter().map(|(piece, _)| piece.ends.len()).sum();
        let corners = pieces.iter().map(|(piece, _)| piece.rings.len()).sum();
        if corners > u32::MAX as usize {
            return Err(Error::new(Status::LimitExceeded, "more than 2^32 - 1 indices"));
        }
        let (mut offsets, mut indices) = (room.vec(count + 1)?, room.vec(corners)?);
        let (mut inner_pole, mut outer_pole) = (room.vec(count)?, room.vec(count)?);
        offsets.push(0);
        for (piece, _) in pieces {
            run.poll()?;
            let begin = indices.len();
            offsets.extend(piece.ends.iter().map(|&end| (begin + end as usize) as u32));
            indices.extend(piece.rings);
            inner_pole.extend(piece.inner_pole);
            outer_pole.extend(piece.outer_pole);
        }
        let faces = Rows::new(offsets, indices)?;
        Ok(Surface { cells, samples, faces, inner_pole, outer_pole })
    }

    /// Merges the shards of each sample, and gives the positions of the vertices left.
    fn merge_shards(
        &mut self,
        poles: &Poles,
        regular: &Triangulation,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Vec<[f64; 3]>> {
        let mut places = Places::new(poles, regular, &self.cells, room)?;
        let mut progress = [0.4, 0.5];
        let turned = |samples: &[u32], roots: &[u32]| {
            places.settle(samples, progress, run)?;
            // What stays apart is little.
            progress = [0.5; 2];
            let poles_of = |face: usize| [self.inner_pole[face], self.outer_pole[face]];
            places.turned(&self.faces, roots, poles_of, run)
        };
        let roots = shards::merged(&mut self.samples, &self.faces, turned, run)?;
        let mut vertices = places.into_positions();
        // A root is the least vertex, and has the least cell.
        let mut number = room.filled(roots.len(), NONE)?;
        let mut count = 0;
        for root in run.watch(roots.iter().zip(0..)) {
            let (&root, vertex) = root?;
            if root == vertex {
                number[vertex as usize] = count as u32;
                self.cells[count] = self.cells[vertex as usize];
                self.samples[count] = self.samples[vertex as usize];
                vertices[count] = vertices[vertex as usize];
                count += 1;
            }
        }
        self.cells.truncate(count);
        self.samples.truncate(count);
        vertices.truncate(count);
        let (mut offsets, mut indices) = (vec![0], Vec::new());
        let (mut ring, mut kept) = (Vec::new(), 0);
        for face in run.watch(self.faces.iter().enumerate()) {
            let (face, row) = face?;
            shards::contract(row, &roots, &mut ring);
            if ring.len() > 2 {
                room.grow(&mut indices, ring.len())?;
                indices.extend(ring.iter().map(|&root| number[root as usize]));
                room.push(&mut offsets, indices.len() as u32)?;
                self.inner_pole[kept] = self.inner_pole[face];
                self.outer_pole[kept] = self.outer_pole[face];
                kept += 1;
            }
        }
        self.inner_pole.truncate(kept);
        self.outer_pole.truncate(kept);
        self.faces = Rows::new(offsets, indices)?;
        Ok(vertices)
    }
}

/// Walks round edges at a time: each waits for memory at every step, and the others go on meanwhile.
const WALKS: usize = 8;

/// The faces dual to some of the edges.
#[derive(Default)]
struct Faces {
    rings: Vec<u32>,
    /// Where the ring of each face ends.
    ends: Vec<u32>,
    inner_pole: Vec<u32>,
    outer_pole: Vec<u32>,
}

impl Faces {
    fn new(
        regular: &Triangulation,
        division: &Division,
        edges: &[Edge],
        vertex_of_cell: &[u32],
        room: &mut Room<'_>,
    ) -> Result<Self> {
        let mut faces = Faces::default();
        let mut rings: [Vec<u32>; WALKS] = Default::default();
        let mut walks = Vec::with_capacity(WALKS);
        for edges in edges.chunks(WALKS) {
            for (place, edge) in edges.iter().enumerate() {
                let [a, b] = edge.ends;
                let [inner, outer] = if division.inner[a as usize] { [a, b] } else { [b, a] };
                room.push(&mut faces.inner_pole, regular.row_of_vertex()[inner as usize])?;
                room.push(&mut faces.outer_pole, regular.row_of_vertex()[outer as usize])?;
                walks.push((place, Turn::new(regular, edge.cell, inner, outer), NONE));
            }
            while !walks.is_empty() {
                // What has to be fetched is asked for by all of them before any is looked at: a branch that was
                // guessed wrongly waits for nothing then.
                for (place, turn, next) in &mut walks {
                    room.push(&mut rings[*place], vertex_of_cell[turn.cell() as usize])?;
                    *next = turn.next();
                }
                for (_, turn, next) in &mut walks {
                    if *next == NONE {
                        return Err(Error::new(
                            Status::Internal,
                            "a facet between an inner and an outer pole is unbounded",
                        ));
                    }
                    turn.enter(*next);
                }
                walks.retain(|&(place, _, next)| next != edges[place].cell);
            }
            for ring in &mut rings[..edges.len()] {
                room.grow(&mut faces.rings, ring.len())?;
                faces.rings.append(ring);
                room.push(&mut faces.ends, faces.rings.len() as u32)?;
            }
        }
        Ok(faces)
    }
}

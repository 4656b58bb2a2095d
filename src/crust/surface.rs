//! The power crust: the facets of the power diagram between inner and outer cells.

use super::division::{Division, Edge, pieces};
use crate::complex::{Attribute, Complex, ComplexParts, Element, Rows, Values};
use crate::dual::orthocenter_positions;
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{PART, Room, Run, parts};
use crate::triangulation::{Triangulation, Turn};

/// The oriented boundary between the inner and the outer cells of the power diagram.
///
/// Each face is the convex polygon dual to an edge between an inner and an outer pole, turning
/// counterclockwise as seen from the outer one. It is closed by construction: an edge of the
/// polygon is dual to a facet of the regular triangulation, and of that facet's three
/// poles none or exactly two pairs have different labels. Its vertices are cells of the
/// triangulation, those with poles of both labels, so that the same argument on a tetrahedron's four poles, of which one or
/// two are inner, makes every vertex's faces one disk: the surface is a manifold.
///
/// Faces are in the order of their dual edges, the lesser vertex of each first, and begin with their least cells.
/// Vertices carry `cell`, faces `inner_pole` and `outer_pole`.
pub(super) fn extract(
    regular: &Triangulation,
    division: &Division,
    run: &Run<'_>,
) -> Result<Complex> {
    let mut room = Room::new(run);
    let offsets = division.offsets(|share| usize::from(share.is_mixed()));
    let mut cells = room.filled(offsets[offsets.len() - 1], 0u32)?;
    // Nobody asks for that of another cell.
    let mut vertex_of_cell = room.filled(regular.cells().len(), 0u32)?;
    let ranges = parts(regular.cells().len()).into_iter().zip(&offsets);
    let results = vertex_of_cell.chunks_mut(PART).zip(pieces(&mut cells, &offsets));
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
    let mut vertices = room.filled(cells.len(), [0.0; 3])?;
    let chunks = cells.chunks(PART).zip(vertices.chunks_mut(PART)).collect();
    run.in_steps(chunks, [0.15, 0.3], |(cells, positions): (&[u32], &mut [_])| {
        orthocenter_positions(regular, cells, positions, run)
    })?;
    let separates = |cell: usize, [i, j]: [usize; 2]| {
        let inner = division.shares[cell].inner();
        (inner >> i ^ inner >> j) & 1 == 1
    };
    let edges = division.edges(regular, [0.3, 0.35], separates, &mut room, run)?;
    let pieces = run.in_steps(edges.chunks(PART / 8).collect(), [0.35, 0.5], |edges| {
        let mut room = Room::new(run);
        Ok((Faces::new(regular, division, edges, &vertex_of_cell, &mut room)?, room))
    })?;
    drop((vertex_of_cell, edges));
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
    let pole = |name: &str, poles| Attribute::new(name, Element::Face, 1, Values::U32(poles));
    let parts = ComplexParts {
        vertices,
        faces: Rows::new(offsets, indices)?,
        attributes: vec![
            Attribute::new("cell", Element::Vertex, 1, Values::U32(cells))?,
            pole("inner_pole", inner_pole)?,
            pole("outer_pole", outer_pole)?,
        ],
        ..Default::default()
    };
    Complex::sound_in(parts, run)
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

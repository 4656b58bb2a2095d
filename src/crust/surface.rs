//! The power crust: the facets of the power diagram between inner and outer cells.

use super::label::Label;
use crate::complex::{Attribute, Complex, ComplexParts, Element, Rows, Values};
use crate::dual::orthocenter_positions;
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{PART, Room, Run, parts};
use crate::triangulation::{Edges, Triangulation};
use std::ops::Range;

/// The oriented boundary between the inner and the outer cells of the power diagram.
///
/// Each face is the convex polygon dual to an edge between an inner and an outer pole, turning
/// counterclockwise as seen from the outer one. It is closed by construction: an edge of the
/// polygon is dual to a facet of the regular triangulation, and of that facet's three
/// poles none or exactly two pairs have different labels. Its vertices are cells of the
/// triangulation, those with poles of both labels, so that the same argument on a tetrahedron's four poles, of which one or
/// two are inner, makes every vertex's faces one disk: the surface is a manifold.
///
/// Vertices carry `cell`, faces `inner_pole` and `outer_pole`.
pub(super) fn extract(
    regular: &Triangulation,
    sides: &[Option<Label>],
    edges: &Edges,
    run: &Run<'_>,
) -> Result<Complex> {
    let mut room = Room::new(run);
    let mut vertex_of_cell = room.filled(regular.cells().len(), NONE)?;
    let mut cells: Vec<u32> = Vec::new();
    for cell in run.watch(regular.cells().iter().enumerate()) {
        let (cell, corners) = cell?;
        let [first, others @ ..] = corners.map(|v| sides[v as usize]);
        if others != [first; 3] {
            vertex_of_cell[cell] = cells.len() as u32;
            room.push(&mut cells, cell as u32)?;
        }
    }
    let mut vertices = room.filled(cells.len(), [0.0; 3])?;
    let chunks = cells.chunks(PART).zip(vertices.chunks_mut(PART)).collect();
    run.in_steps(chunks, [0.1, 0.25], |(cells, positions): (&[u32], &mut [_])| {
        orthocenter_positions(regular, cells, positions, run)
    })?;
    let pieces = run.in_steps(parts(edges.ends.len()), [0.25, 0.5], |range| {
        let mut room = Room::new(run);
        let piece = Piece::new(regular, sides, edges, &vertex_of_cell, range, &mut room)?;
        Ok((piece, room))
    })?;
    let faces = pieces.iter().map(|(piece, _)| piece.inner.len()).sum();
    let corners = pieces.iter().map(|(piece, _)| piece.rings.len()).sum();
    if corners > u32::MAX as usize {
        return Err(Error::new(Status::LimitExceeded, "more than 2^32 - 1 indices"));
    }
    let (mut offsets, mut indices) = (room.vec(faces + 1)?, room.vec(corners)?);
    let (mut inner_pole, mut outer_pole) = (room.vec(faces)?, room.vec(faces)?);
    offsets.push(0);
    for (piece, _) in pieces {
        run.poll()?;
        let begin = indices.len();
        offsets.extend(piece.ends.iter().map(|&end| (begin + end as usize) as u32));
        indices.extend(piece.rings);
        inner_pole.extend(piece.inner);
        outer_pole.extend(piece.outer);
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

/// The faces of some of the edges.
#[derive(Default)]
struct Piece {
    rings: Vec<u32>,
    /// Where the ring of each face ends.
    ends: Vec<u32>,
    inner: Vec<u32>,
    outer: Vec<u32>,
}

impl Piece {
    fn new(
        regular: &Triangulation,
        sides: &[Option<Label>],
        edges: &Edges,
        vertex_of_cell: &[u32],
        range: Range<usize>,
        room: &mut Room<'_>,
    ) -> Result<Self> {
        let pole_of_vertex = regular.row_of_vertex();
        let mut piece = Piece::default();
        let mut ring = Vec::new();
        for (&[a, b], &cell) in edges.ends[range.clone()].iter().zip(&edges.cells[range]) {
            let (inner, outer) = match (sides[a as usize], sides[b as usize]) {
                (Some(Label::Inner), Some(Label::Outer)) => (a, b),
                (Some(Label::Outer), Some(Label::Inner)) => (b, a),
                _ => continue,
            };
            if !regular.ring(cell, inner, outer, &mut ring) {
                return Err(Error::new(
                    Status::Internal,
                    "a facet between an inner and an outer pole is unbounded",
                ));
            }
            room.grow(&mut piece.rings, ring.len())?;
            piece.rings.extend(ring.iter().map(|&cell| vertex_of_cell[cell as usize]));
            room.push(&mut piece.ends, piece.rings.len() as u32)?;
            room.push(&mut piece.inner, pole_of_vertex[inner as usize])?;
            room.push(&mut piece.outer, pole_of_vertex[outer as usize])?;
        }
        Ok(piece)
    }
}

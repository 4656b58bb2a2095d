//! The power shape: the faces of the regular triangulation that connect poles of one side, an
//! approximation of the medial axis (Amenta, Choi, Kolluri 2001, section 3.4).

use super::label::Label;
use crate::complex::{Attribute, CellType, Complex, ComplexParts, Element, Rows, Values};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run, parts};
use crate::triangulation::{Edges, Triangulation};
use std::ops::Range;

/// The power shapes of both sides, in the order of their labels.
///
/// The vertices of each are that side's poles, but for those hidden in the regular triangulation;
/// faces are all triangles between them, edges those that no such triangle has, cells the
/// tetrahedra. Vertices carry `radius`, the root of their weight, and `pole`.
pub(super) fn extract(
    regular: &Triangulation,
    sides: &[Option<Label>],
    edges: &Edges,
    run: &Run<'_>,
) -> Result<[Complex; 2]> {
    let mut room = Room::new(run);
    // Each vertex is in one shape at most.
    let mut number = room.filled(sides.len(), NONE)?;
    let mut vertices: [Vec<u32>; 2] = Default::default();
    for vertex in run.watch(sides.iter().enumerate()) {
        if let (vertex, Some(side)) = vertex? {
            let of_side = &mut vertices[*side as usize];
            number[vertex] = of_side.len() as u32;
            room.push(of_side, vertex as u32)?;
        }
    }
    let shapes = Shapes { regular, sides, edges, number: &number };
    let pieces = run.in_steps(parts(regular.cells().len()), [0.5, 0.75], |range| {
        let mut room = Room::new(run);
        Ok((shapes.facets(range, &mut room)?, room))
    })?;
    let loose = run.in_steps(parts(edges.ends.len()), [0.75, 1.0], |range| {
        let mut room = Room::new(run);
        Ok((shapes.loose_edges(range, &mut room)?, room))
    })?;
    let shape = |side: usize| {
        let mut room = Room::new(run);
        let pole_of_vertex = regular.row_of_vertex();
        let of_side = &vertices[side];
        let poles_of = room.collect(of_side.iter().map(|&v| pole_of_vertex[v as usize]))?;
        let radii = room.collect(of_side.iter().map(|&v| regular.weights()[v as usize].sqrt()))?;
        let facets = || pieces.iter().map(|(piece, _)| &piece[side]);
        let cells = joined(facets().map(|piece| &piece.cells[..]), &mut room, run)?;
        let faces = joined(facets().map(|piece| &piece.faces[..]), &mut room, run)?;
        let parts = ComplexParts {
            vertices: room.collect(of_side.iter().map(|&v| regular.coords()[v as usize]))?,
            edges: joined(loose.iter().map(|(edges, _)| &edges[side][..]), &mut room, run)?,
            cell_types: room.filled(cells.len(), CellType::Tetrahedron)?,
            cells: Rows::uniform_in(cells, &mut room)?,
            faces: Rows::uniform_in(faces, &mut room)?,
            attributes: vec![
                Attribute::new("radius", Element::Vertex, 1, Values::F64(radii))?,
                Attribute::new("pole", Element::Vertex, 1, Values::U32(poles_of))?,
            ],
            ..Default::default()
        };
        Complex::sound_in(parts, run)
    };
    let [outer, inner] = [Label::Outer, Label::Inner].map(|side| shape(side as usize));
    Ok([outer?, inner?])
}

/// All rows of all pieces.
fn joined<'a, T: Copy + 'a>(
    pieces: impl Iterator<Item = &'a [T]> + Clone,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<T>> {
    let mut rows = room.vec(pieces.clone().map(<[T]>::len).sum())?;
    for piece in pieces {
        run.poll()?;
        rows.extend_from_slice(piece);
    }
    Ok(rows)
}

/// The triangles and tetrahedra of one shape.
#[derive(Default)]
struct Facets {
    faces: Vec<[u32; 3]>,
    cells: Vec<[u32; 4]>,
}

/// What both shapes are read off.
struct Shapes<'a> {
    regular: &'a Triangulation,
    sides: &'a [Option<Label>],
    edges: &'a Edges,
    /// The number of each vertex in its shape.
    number: &'a [u32],
}

impl Shapes<'_> {
    /// The facets of some of the cells, each facet once: by the lesser of its cells.
    fn facets(&self, range: Range<usize>, room: &mut Room<'_>) -> Result<[Facets; 2]> {
        let mut facets: [Facets; 2] = Default::default();
        for id in range {
            let (cell, neighbors) = (self.regular.cells()[id], self.regular.neighbors()[id]);
            let numbers = cell.map(|v| self.number[v as usize]);
            let sides = cell.map(|v| self.sides[v as usize]);
            for (side, label) in [Label::Outer, Label::Inner].into_iter().enumerate() {
                let inside = sides.map(|side| side == Some(label));
                if inside.iter().filter(|&&inside| inside).count() < 3 {
                    continue;
                }
                if inside == [true; 4] {
                    room.push(&mut facets[side].cells, numbers)?;
                }
                for (slot, &neighbor) in neighbors.iter().enumerate() {
                    let first = neighbor == NONE || id < neighbor as usize;
                    if first && (0..4).all(|i| i == slot || inside[i]) {
                        let corners = [0, 1, 2].map(|i| numbers[i + usize::from(i >= slot)]);
                        room.push(&mut facets[side].faces, corners)?;
                    }
                }
            }
        }
        Ok(facets)
    }

    /// The edges of the shapes, among some of the triangulation's, that no triangle of the shape has.
    fn loose_edges(&self, range: Range<usize>, room: &mut Room<'_>) -> Result<[Vec<[u32; 2]>; 2]> {
        let mut loose: [Vec<[u32; 2]>; 2] = Default::default();
        let ends = &self.edges.ends[range.clone()];
        for (&[a, b], &cell) in ends.iter().zip(&self.edges.cells[range]) {
            let Some(side) = self.sides[a as usize] else { continue };
            if self.sides[b as usize] != Some(side) {
                continue;
            }
            let has_triangle = |corners: &[u32; 4]| {
                corners.iter().any(|&v| v != a && v != b && self.sides[v as usize] == Some(side))
            };
            // Nearly always one of the first cells tells.
            if !self.regular.any_round(cell, a, b, has_triangle) {
                let ends = [a, b].map(|v| self.number[v as usize]);
                room.push(&mut loose[side as usize], ends)?;
            }
        }
        Ok(loose)
    }
}

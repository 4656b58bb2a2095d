//! The power crust: the facets of the power diagram between inner and outer cells.

use super::label::Label;
use crate::complex::{Attribute, Complex, ComplexParts, Element, Rows, Values};
use crate::dual::orthocenter_position;
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::triangulation::{Edges, Triangulation};

/// The oriented boundary between the inner and the outer cells of the power diagram.
///
/// Each face is the convex polygon dual to an edge between an inner and an outer pole, turning
/// counterclockwise as seen from the outer one. It is closed by construction: an edge of the
/// polygon is dual to a facet of the regular triangulation, and of that facet's three
/// poles none or exactly two pairs have different labels. Its vertices are cells of the
/// triangulation, so that the same argument on a tetrahedron's four poles, of which one or
/// two are inner, makes every vertex's faces one disk: the surface is a manifold.
///
/// Vertices carry `cell`, faces `inner_pole` and `outer_pole`.
pub(super) fn extract(
    regular: &Triangulation,
    labels: &[Label],
    edges: &Edges,
    run: &Run<'_>,
) -> Result<Complex> {
    let pole_of_vertex = regular.row_of_vertex();
    let label_of = |vertex: u32| labels[pole_of_vertex[vertex as usize] as usize];
    let mut room = Room::new(run);
    let mut faces = Rows::default();
    let (mut inner_pole, mut outer_pole) = (Vec::new(), Vec::new());
    let mut used = room.filled(regular.cells().len(), false)?;
    let mut ring = Vec::new();
    for (i, (&[a, b], &cell)) in edges.ends.iter().zip(&edges.cells).enumerate() {
        if i % 4096 == 0 {
            run.tick(i, 2 * edges.ends.len())?;
        }
        let (inner, outer) = match (label_of(a), label_of(b)) {
            (Label::Inner, Label::Outer) => (a, b),
            (Label::Outer, Label::Inner) => (b, a),
            _ => continue,
        };
        if !regular.ring(cell, inner, outer, &mut ring) {
            return Err(Error::new(
                Status::Internal,
                "a facet between an inner and an outer pole is unbounded",
            ));
        }
        ring.iter().for_each(|&cell| used[cell as usize] = true);
        faces.push_in(&ring, &mut room)?;
        room.push(&mut inner_pole, pole_of_vertex[inner as usize])?;
        room.push(&mut outer_pole, pole_of_vertex[outer as usize])?;
    }
    let mut vertex_of_cell = room.filled(used.len(), NONE)?;
    let mut cells: Vec<u32> = Vec::new();
    let mut vertices = Vec::new();
    for cell in 0..used.len() {
        if cell % 1024 == 0 {
            run.tick(used.len() + cell, 2 * used.len())?;
        }
        if !used[cell] {
            continue;
        }
        vertex_of_cell[cell] = cells.len() as u32;
        room.push(&mut cells, cell as u32)?;
        let corners = regular.cells()[cell].map(|v| regular.site(v));
        let points = corners.map(|[x, y, z, _]| [x, y, z]);
        let position = orthocenter_position(points, corners.map(|site| site[3]))
            .ok_or_else(|| Error::new(Status::Internal, "a cell of a triangulation is flat"))?;
        room.push(&mut vertices, position)?;
    }
    let indices =
        room.collect(faces.indices().iter().map(|&cell| vertex_of_cell[cell as usize]))?;
    let offsets = room.collect(faces.offsets().iter().copied())?;
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
    Complex::new_in(parts, run)
}

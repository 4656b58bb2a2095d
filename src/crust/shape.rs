//! The power shape: the faces of the regular triangulation that connect poles of one side, an
//! approximation of the medial axis (Amenta, Choi, Kolluri 2001, section 3.4).

use super::label::Label;
use crate::complex::{Attribute, CellType, Complex, ComplexParts, Element, Values};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::poles::Poles;
use crate::triangulation::{Edges, Triangulation};

/// The power shape of one side.
///
/// Its vertices are that side's poles, but for those hidden in the regular triangulation;
/// faces are all triangles between them, edges those that no such triangle has, cells the
/// tetrahedra. Vertices carry `radius` and `pole`.
pub(super) fn extract(
    poles: &Poles,
    regular: &Triangulation,
    labels: &[Label],
    edges: &Edges,
    side: Label,
    run: &Run<'_>,
) -> Result<Complex> {
    let pole_of_vertex = regular.row_of_vertex();
    let mut room = Room::new(run);
    let mut on_side =
        room.collect(pole_of_vertex.iter().map(|&pole| labels[pole as usize] == side))?;
    for &hidden in regular.hidden() {
        on_side[hidden as usize] = false;
    }
    let mut number = room.filled(on_side.len(), NONE)?;
    let mut parts = ComplexParts::default();
    let (mut radii, mut pole_of) = (Vec::new(), Vec::new());
    for vertex in run.watch((0..on_side.len()).filter(|&v| on_side[v])) {
        let vertex = vertex?;
        number[vertex] = pole_of.len() as u32;
        let pole = pole_of_vertex[vertex];
        room.push(&mut pole_of, pole)?;
        room.push(&mut radii, poles.balls()[pole as usize][3])?;
        room.push(&mut parts.vertices, regular.coords()[vertex])?;
    }
    for (id, (cell, neighbors)) in regular.cells().iter().zip(regular.neighbors()).enumerate() {
        if id % 4096 == 0 {
            run.tick(id, 2 * regular.cells().len())?;
        }
        let inside = cell.map(|v| on_side[v as usize]);
        let numbers = cell.map(|v| number[v as usize]);
        if inside == [true; 4] {
            parts.cells.push_in(&numbers, &mut room)?;
            room.push(&mut parts.cell_types, CellType::Tetrahedron)?;
        }
        for (slot, &neighbor) in neighbors.iter().enumerate() {
            // Each facet once: by the lesser of its cells.
            let first = neighbor == NONE || id < neighbor as usize;
            if first && (0..4).all(|i| i == slot || inside[i]) {
                let corners = [0, 1, 2].map(|i| numbers[i + usize::from(i >= slot)]);
                parts.faces.push_in(&corners, &mut room)?;
            }
        }
    }
    let mut ring = Vec::new();
    for (i, (&[a, b], &cell)) in edges.ends.iter().zip(&edges.cells).enumerate() {
        if i % 4096 == 0 {
            run.tick(edges.ends.len() + i, 2 * edges.ends.len())?;
        }
        if !on_side[a as usize] || !on_side[b as usize] {
            continue;
        }
        regular.ring(cell, a, b, &mut ring);
        let is_loose = ring.iter().all(|&cell| {
            regular.cells()[cell as usize].iter().all(|&v| v == a || v == b || !on_side[v as usize])
        });
        if is_loose {
            room.push(&mut parts.edges, [number[a as usize], number[b as usize]])?;
        }
    }
    parts.attributes = vec![
        Attribute::new("radius", Element::Vertex, 1, Values::F64(radii))?,
        Attribute::new("pole", Element::Vertex, 1, Values::U32(pole_of))?,
    ];
    Complex::new_in(parts, run)
}

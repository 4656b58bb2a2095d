//! Facets of a triangulation as a complex.

use crate::complex::{Attribute, Complex, ComplexParts, Element, Rows, Values};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{PART, Room, Run};
use crate::triangulation::Triangulation;

/// The given facets as triangles, oriented out of their cells, or into them where they are `turned`.
///
/// Vertices are the samples used, ascending, with `sample`; faces carry `inner_cell` and `outer_cell`, the cells behind
/// and in front of them, the latter [`NONE`] beyond the hull.
pub(super) fn complex(
    t: &Triangulation,
    facets: &[[u32; 2]],
    turned: &[bool],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Complex> {
    let mut number = room.filled(t.coords().len(), NONE)?;
    let mut triangles: Vec<[u32; 3]> = room.vec(facets.len())?;
    let (mut behind, mut before) = (room.vec(facets.len())?, room.vec(facets.len())?);
    for facet in run.watch(facets.iter().zip(turned)) {
        let (&[cell, i], &turned) = facet?;
        let mut corners = t.facet(cell, i as usize);
        let mut cells = [cell, t.neighbors()[cell as usize][i as usize]];
        if turned {
            corners.swap(1, 2);
            cells.swap(0, 1);
        }
        for v in corners {
            number[v as usize] = 0;
        }
        triangles.push(corners);
        behind.push(cells[0]);
        before.push(cells[1]);
    }
    let mut samples = Vec::new();
    for (v, number) in number.iter_mut().enumerate().filter(|(_, number)| **number == 0) {
        *number = samples.len() as u32;
        room.push(&mut samples, v as u32)?;
    }
    for part in triangles.chunks_mut(PART) {
        run.poll()?;
        for v in part.as_flattened_mut() {
            *v = number[*v as usize];
        }
    }
    let vertices = room.collect(samples.iter().map(|&v| t.coords()[v as usize]))?;
    let attribute =
        |name: &str, element, values| Attribute::new(name, element, 1, Values::U32(values));
    let parts = ComplexParts {
        vertices,
        faces: Rows::uniform_in(triangles, room)?,
        attributes: vec![
            attribute("sample", Element::Vertex, samples)?,
            attribute("inner_cell", Element::Face, behind)?,
            attribute("outer_cell", Element::Face, before)?,
        ],
        ..ComplexParts::default()
    };
    Complex::sound_in(parts, run)
}

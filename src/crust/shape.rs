//! The power shape: the faces of the regular triangulation that connect poles of one side, an
//! approximation of the medial axis (Amenta, Choi, Kolluri 2001, section 3.4).

use super::division::{Division, Edge};
use super::label::Label;
use crate::complex::{Attribute, CellType, Complex, ComplexParts, Element, Rows, Values, flatness};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{PART, Room, Run, parts, pieces};
use crate::poles::Poles;
use crate::triangulation::{Triangulation, Turn};
use std::ops::Range;

/// The power shapes of both sides, in the order of their labels.
///
/// The vertices of each are that side's poles, but for those hidden in the regular triangulation;
/// faces are all triangles between them, edges those that no such triangle has, cells the
/// tetrahedra. Vertices carry `radius`, the root of their weight, `pole`, `label` and the pole's `object_angle`, cells
/// their `flatness`.
pub(super) fn extract(
    poles: &Poles,
    regular: &Triangulation,
    division: &Division,
    run: &Run<'_>,
) -> Result<[Complex; 2]> {
    let mut room = Room::new(run);
    // Each vertex is in one shape at most.
    let mut number = room.filled(regular.coords().len(), NONE)?;
    let mut vertices: [Vec<u32>; 2] = Default::default();
    let mut hidden = regular.hidden();
    for vertex in run.watch(division.inner.iter().enumerate()) {
        let (vertex, &inner) = vertex?;
        let vertex = vertex as u32;
        match hidden.split_first() {
            Some((&first, rest)) if first == vertex => hidden = rest,
            _ => {
                let of_side = &mut vertices[usize::from(inner)];
                number[vertex as usize] = of_side.len() as u32;
                room.push(of_side, vertex)?;
            }
        }
    }
    // Round a loose edge all cells have two vertices of either label: of most others a neighbour tells at once.
    let is_even = |cell: u32| cell == NONE || division.shares[cell as usize].is_even();
    let may_be_loose = |cell: usize, [i, j]: [usize; 2]| {
        let inner = division.shares[cell].inner();
        let neighbors = regular.neighbors()[cell];
        division.shares[cell].is_even()
            && (inner >> i ^ inner >> j) & 1 == 0
            && (0..4).all(|slot| slot == i || slot == j || is_even(neighbors[slot]))
    };
    let edges = division.edges(regular, [0.6, 0.65], may_be_loose, &mut room, run)?;
    let loose = run.in_steps(edges.chunks(PART).collect(), [0.65, 0.7], |edges| {
        let mut room = Room::new(run);
        Ok((loose_edges(regular, division, edges, &number, &mut room)?, room))
    })?;
    drop(edges);
    let shape = |side: Label| {
        let mut room = Room::new(run);
        let pole_of_vertex = regular.row_of_vertex();
        let of_side = &vertices[side as usize];
        let poles_of = room.collect(of_side.iter().map(|&v| pole_of_vertex[v as usize]))?;
        let radii = room.collect(of_side.iter().map(|&v| regular.weights()[v as usize].sqrt()))?;
        let angles = room.collect(poles_of.iter().map(|&p| poles.object_angles()[p as usize]))?;
        let labels = room.filled(of_side.len(), side as u32)?;
        let Facets { faces, cells } = facets(regular, division, side, &number, &mut room, run)?;
        let at = room.collect(of_side.iter().map(|&v| regular.coords()[v as usize]))?;
        let flat = flatness_of(&cells, &at, &mut room, run)?;
        let loose = loose.iter().map(|(edges, _)| &edges[side as usize][..]);
        let parts = ComplexParts {
            vertices: at,
            edges: joined(loose, &mut room, run)?,
            cell_types: room.filled(cells.len(), CellType::Tetrahedron)?,
            cells: Rows::uniform_in(cells, &mut room)?,
            faces: Rows::uniform_in(faces, &mut room)?,
            attributes: vec![
                Attribute::new("radius", Element::Vertex, 1, Values::F64(radii))?,
                Attribute::new("pole", Element::Vertex, 1, Values::U32(poles_of))?,
                Attribute::new("label", Element::Vertex, 1, Values::U32(labels))?,
                Attribute::new("object_angle", Element::Vertex, 1, Values::F64(angles))?,
                Attribute::new("flatness", Element::Cell, 1, Values::F64(flat))?,
            ],
            ..Default::default()
        };
        Complex::sound_in(parts, run)
    };
    let [outer, inner] = [Label::Outer, Label::Inner].map(shape);
    Ok([outer?, inner?])
}

/// The triangles and the tetrahedra of one shape.
struct Facets {
    faces: Vec<[u32; 3]>,
    cells: Vec<[u32; 4]>,
}

/// The triangles and the tetrahedra of a side, given the number of each vertex in its shape: each triangle once, by
/// the lesser of its cells.
fn facets(
    regular: &Triangulation,
    division: &Division,
    side: Label,
    number: &[u32],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Facets> {
    let face_offsets = division.offsets(|share| share.facets_of(side).count_ones() as usize);
    let cell_offsets = division.offsets(|share| usize::from(share.is_cell_of(side)));
    let mut faces = room.filled(face_offsets[face_offsets.len() - 1], [0u32; 3])?;
    let mut cells = room.filled(cell_offsets[cell_offsets.len() - 1], [0u32; 4])?;
    let results = pieces(&mut faces, face_offsets[1..].iter().copied())
        .zip(pieces(&mut cells, cell_offsets[1..].iter().copied()));
    let chunks = parts(regular.cells().len()).into_iter().zip(results).collect();
    let from = 0.7 + 0.15 * f64::from(side as u32);
    run.in_steps(chunks, [from, from + 0.15], |(range, (faces, cells)): (Range<_>, _)| {
        let (mut faces, mut cells) = (faces.iter_mut(), cells.iter_mut());
        for (corners, share) in regular.cells()[range.clone()].iter().zip(&division.shares[range]) {
            let facets = share.facets_of(side);
            if facets == 0 && !share.is_cell_of(side) {
                continue;
            }
            let numbers = corners.map(|v| number[v as usize]);
            if share.is_cell_of(side)
                && let Some(cell) = cells.next()
            {
                *cell = numbers;
            }
            for slot in (0..4).filter(|slot| facets >> slot & 1 == 1) {
                if let Some(face) = faces.next() {
                    *face = [0, 1, 2].map(|i| numbers[i + usize::from(i >= slot)]);
                }
            }
        }
        Ok(())
    })?;
    Ok(Facets { faces, cells })
}

/// How flat each tetrahedron is.
fn flatness_of(
    cells: &[[u32; 4]],
    vertices: &[[f64; 3]],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<f64>> {
    let mut flat = room.filled(cells.len(), 0.0)?;
    let chunks = flat.chunks_mut(PART).zip(cells.chunks(PART)).collect();
    run.in_parallel(chunks, |(flat, cells)| {
        run.poll()?;
        for (flat, corners) in flat.iter_mut().zip(cells) {
            *flat = flatness(corners.map(|v| vertices[v as usize]));
        }
        Ok(())
    })?;
    Ok(flat)
}

/// Those of the edges round which all cells have two vertices of either label, by the label of their ends, as numbers of
/// the shape.
fn loose_edges(
    regular: &Triangulation,
    division: &Division,
    edges: &[Edge],
    number: &[u32],
    room: &mut Room<'_>,
) -> Result<[Vec<[u32; 2]>; 2]> {
    let mut loose: [Vec<[u32; 2]>; 2] = Default::default();
    for edge in edges {
        if is_loose(regular, edge, |cell| division.shares[cell as usize].is_even()) {
            let side = usize::from(division.inner[edge.ends[0] as usize]);
            room.push(&mut loose[side], edge.ends.map(|v| number[v as usize]))?;
        }
    }
    Ok(loose)
}

/// Whether all cells round an edge are as they should be. Nearly always one of the first is not.
fn is_loose(regular: &Triangulation, edge: &Edge, goes_on: impl Fn(u32) -> bool) -> bool {
    let [a, b] = edge.ends;
    for [a, b] in [[a, b], [b, a]] {
        let mut turn = Turn::new(regular, edge.cell, a, b);
        loop {
            match turn.step() {
                NONE => break,
                next if next == edge.cell => return true,
                next if !goes_on(next) => return false,
                _ => {}
            }
        }
        // The hull cuts the ring: the rest lies the other way.
    }
    true
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

#[cfg(test)]
mod tests {
    use crate::crust::{Label, LabelRule, PowerCrust, PowerCrustOptions};
    use crate::{Job, Points};
    use std::collections::{BTreeMap, BTreeSet};
    use std::sync::Arc;

    /// Points without a surface, so that labels are mixed everywhere.
    fn crust() -> PowerCrust {
        let mut state = 1u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 40) as f64
        };
        let rows: Vec<[f64; 3]> = (0..2000).map(|_| [random(), random(), random()]).collect();
        let points = Points::new(&rows, Default::default(), &Job::default()).unwrap();
        let options = PowerCrustOptions { label_rule: LabelRule::Spread, ..Default::default() };
        PowerCrust::build(&Arc::new(points), options, &Job::default()).unwrap()
    }

    #[test]
    fn shapes_have_the_faces_of_their_side_and_the_edges_that_no_triangle_has() {
        let crust = crust();
        let t = crust.regular();
        let label = |v: u32| crust.labels()[t.row_of_vertex()[v as usize] as usize];
        let pairs = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];
        for (side, shape) in
            [(Label::Inner, crust.inner_shape()), (Label::Outer, crust.outer_shape())]
        {
            // The number of a vertex is its rank among those of its side.
            let seen =
                (0..t.coords().len() as u32).filter(|v| t.hidden().binary_search(v).is_err());
            let number: BTreeMap<u32, u32> = seen.filter(|&v| label(v) == side).zip(0..).collect();
            let (mut cells, mut faces) = (Vec::new(), Vec::new());
            let (mut edges, mut of_triangles) = (BTreeSet::new(), BTreeSet::new());
            for (id, (cell, neighbors)) in t.cells().iter().zip(t.neighbors()).enumerate() {
                let numbers = cell.map(|v| number.get(&v).copied());
                if let [Some(a), Some(b), Some(c), Some(d)] = numbers {
                    cells.push([a, b, c, d]);
                }
                for (slot, &neighbor) in neighbors.iter().enumerate() {
                    let mut corners = numbers.to_vec();
                    corners.remove(slot);
                    if let [Some(a), Some(b), Some(c)] = corners[..] {
                        if (id as u32) < neighbor {
                            faces.push([a, b, c]);
                        }
                        for [a, b] in [[a, b], [b, c], [a, c]] {
                            of_triangles.insert([a.min(b), a.max(b)]);
                        }
                    }
                }
                for [i, j] in pairs {
                    if let (Some(a), Some(b)) = (numbers[i], numbers[j]) {
                        edges.insert([a.min(b), a.max(b)]);
                    }
                }
            }
            let loose: Vec<_> = edges.difference(&of_triangles).copied().collect();
            assert_eq!(shape.cells().indices(), cells.as_flattened());
            assert_eq!(shape.faces().indices(), faces.as_flattened());
            assert_eq!(shape.edges(), loose);
            assert!(loose.len() > 10, "{side:?} has {} loose edges", loose.len());
        }
    }
}

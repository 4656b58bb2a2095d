//! The parts of the Voronoi diagram inside a solid, and those of its surface: what elements are made of.

use super::solid::Solid;
use crate::complex::{DisjointSets, Rows};
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::predicates::{Sign, insphere};
use crate::triangulation::Triangulation;

/// The inner cells, and what is dual to the edges and facets among them. Inner cells have numbers of their own, ascending with the cells.
pub(super) struct Parts {
    /// The number that each cell of the triangulation has among the inner cells, or [`NONE`]; and the other way round.
    pub number: Vec<u32>,
    pub cells: Vec<u32>,
    /// For each inner cell the least one of those that share its sphere and can be reached through such ones.
    pub sphere: Vec<u32>,
    /// The two samples whose bisector each inner Voronoi facet lies in.
    pub facets: Vec<[u32; 2]>,
    /// The inner cells round it, counterclockwise round the direction from the first sample to the second.
    pub rings: Rows,
    /// The edges of the surface, once for each fan of inner cells at it.
    pub edges: Vec<[u32; 2]>,
    /// These cells, turning the same way; the surface's triangles lie before the first and behind the last.
    pub fans: Rows,
    /// The triangles of the surface, turning counterclockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// The inner cell behind each.
    pub behind: Vec<u32>,
    /// For each inner cell the facets and fans that have it, a fan counted after the facets.
    pub of_cell: Rows,
}

impl Parts {
    pub fn new(solid: &Solid, room: &mut Room<'_>, run: &Run<'_>) -> Result<Self> {
        let t = solid.dual.triangulation();
        let dual = solid.dual.facets().ok_or_else(|| {
            Error::new(Status::InvalidArgument, "the dual was made without its facets")
        })?;
        let mut number = room.filled(solid.is_inner.len(), NONE)?;
        let mut cells = Vec::new();
        for cell in run.watch(0..number.len()) {
            let cell = cell?;
            if solid.is_inner[cell] {
                number[cell] = cells.len() as u32;
                room.push(&mut cells, cell as u32)?;
            }
        }
        let (mut facets, mut rings) = (Vec::new(), Rows::default());
        let (mut edges, mut fans) = (Vec::new(), Rows::default());
        let mut ring = Vec::new();
        for (i, &ends) in dual.edges().iter().enumerate() {
            run.poll()?;
            ring.clear();
            ring.extend(dual.ring(i).iter().map(|&cell| number[cell as usize]));
            let is_inner = ring.iter().all(|&cell| cell != NONE);
            if is_inner && !dual.is_unbounded(i) {
                room.push(&mut facets, ends)?;
                room.keep(4 * (ring.len() + 1))?;
                rings.push(&ring)?;
                continue;
            }
            if !dual.is_unbounded(i) {
                // So that no fan goes on from the last cell to the first.
                let outer = ring.iter().position(|&cell| cell == NONE).unwrap_or(0);
                ring.rotate_left(outer);
            }
            for fan in ring.split(|&cell| cell == NONE).filter(|fan| !fan.is_empty()) {
                room.push(&mut edges, ends)?;
                room.keep(4 * (fan.len() + 1))?;
                fans.push(fan)?;
            }
        }
        let surface = t.boundary_of(&solid.is_inner, room, run)?;
        let triangles = room.collect(surface.iter().map(|&[cell, i]| t.facet(cell, i as usize)))?;
        let behind = room.collect(surface.iter().map(|&[cell, _]| number[cell as usize]))?;
        let sphere = spheres(t, &cells, &number, room, run)?;
        let of_cell = of_cells(cells.len(), &rings, &fans, room, run)?;
        Ok(Parts { number, cells, sphere, facets, rings, edges, fans, triangles, behind, of_cell })
    }
}

/// For each inner cell the least one with the same sphere among those that it is joined to by such ones.
fn spheres(
    t: &Triangulation,
    cells: &[u32],
    number: &[u32],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<u32>> {
    let mut sets = DisjointSets::new(cells.len(), run)?;
    for (i, &cell) in cells.iter().enumerate() {
        run.poll()?;
        let [a, b, c, d] = t.cells()[cell as usize];
        let at = |v: u32| &t.coords()[v as usize];
        for &next in
            t.neighbors()[cell as usize].iter().filter(|&&next| next != NONE && next < cell)
        {
            let beyond = t.cells()[next as usize].iter().find(|&&v| ![a, b, c, d].contains(&v));
            if let (Some(&e), true) = (beyond, number[next as usize] != NONE)
                && insphere(at(a), at(b), at(c), at(d), at(e)) == Sign::Zero
            {
                sets.join(i as u32, number[next as usize]);
            }
        }
    }
    let mut spheres = room.vec(cells.len())?;
    spheres.extend((0..cells.len() as u32).map(|i| sets.root(i)));
    Ok(spheres)
}

/// For each inner cell the rows that have it, those of the second after those of the first.
fn of_cells(
    count: usize,
    rings: &Rows,
    fans: &Rows,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Rows> {
    let rows = || rings.iter().chain(fans.iter());
    let mut offsets = room.filled(count + 1, 0u32)?;
    for row in run.watch(rows()) {
        row?.iter().for_each(|&cell| offsets[cell as usize + 1] += 1);
    }
    for i in 0..count {
        offsets[i + 1] += offsets[i];
    }
    let mut next = room.collect(offsets.iter().copied())?;
    let mut indices = room.filled(offsets[count] as usize, 0)?;
    for item in run.watch(rows().zip(0u32..)) {
        let (row, number) = item?;
        for &cell in row {
            indices[next[cell as usize] as usize] = number;
            next[cell as usize] += 1;
        }
    }
    Rows::new(offsets, indices)
}

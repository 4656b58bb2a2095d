//! Insertion of one point: the cells in conflict with it are dug out, and the hole is filled
//! with the star of the point (Bowyer 1981, Watson 1981).

use super::cells::{Cells, FACET, Mark};
use super::conflict::{Conflict, Site};
use super::star::Star;
use crate::error::Result;
use crate::job::Run;
use crate::predicates::{Sign, orient3d};
use std::marker::PhantomData;

/// A facet between a cell in conflict and one that is not.
#[derive(Clone, Copy)]
struct BoundaryFacet {
    /// The vertices of the cell in conflict.
    vertices: [u32; 4],
    /// Its slot opposite the facet, which the new point will take.
    slot: u32,
    /// The facet as its outer cell names it: `4 * cell + facet`.
    outer: u32,
}

/// The arrays of one insertion, kept from one to the next: nothing is allocated per point.
pub(super) struct Cavity<C> {
    /// The cells in conflict: first the queue of the search, then the slots to fill.
    cells: Vec<u32>,
    boundary: Vec<BoundaryFacet>,
    star: Star,
    conflict: PhantomData<C>,
}

impl<C: Conflict> Cavity<C> {
    /// Arrays for triangulations of `vertex_count` points.
    pub fn new(vertex_count: usize, run: &Run<'_>) -> Result<Self> {
        Ok(Cavity {
            cells: Vec::new(),
            boundary: Vec::new(),
            star: Star::new(vertex_count, run)?,
            conflict: PhantomData,
        })
    }

    /// Inserts a vertex, given the cell that holds it, and returns one of its new cells; `None`
    /// if the vertex is hidden, because its own cell is not in conflict with it.
    ///
    /// Errors: [`crate::Status::Cancelled`] and what [`Cells::reserve`] returns; the cells are
    /// of no further use then.
    pub fn insert(
        &mut self,
        mesh: &mut Cells<'_>,
        sites: &[Site],
        vertex: u32,
        start: u32,
        run: &Run<'_>,
    ) -> Result<Option<u32>> {
        let site = &sites[vertex as usize];
        if !Self::in_conflict(mesh, sites, start, site) {
            return Ok(None);
        }
        self.dig(mesh, sites, site, start, run)?;
        mesh.reserve(self.boundary.len())?;
        Ok(Some(self.fill(mesh, vertex)))
    }

    /// Collects the cells in conflict, breadth first from one of them, and their boundary.
    fn dig(
        &mut self,
        mesh: &mut Cells<'_>,
        sites: &[Site],
        site: &Site,
        start: u32,
        run: &Run<'_>,
    ) -> Result<()> {
        self.cells.clear();
        self.boundary.clear();
        self.cells.push(start);
        mesh.marks[start as usize] = Mark::Conflict;
        let mut next = 0;
        while let Some(&cell) = self.cells.get(next) {
            next += 1;
            if next % 1024 == 0 {
                run.poll()?;
            }
            for slot in 0..4 {
                let outer = mesh.neighbors[cell as usize][slot];
                let neighbor = outer >> 2;
                let inside = match mesh.marks[neighbor as usize] {
                    Mark::Conflict => continue,
                    Mark::Outside => false,
                    Mark::Unknown => Self::in_conflict(mesh, sites, neighbor, site),
                };
                if inside {
                    mesh.marks[neighbor as usize] = Mark::Conflict;
                    self.cells.push(neighbor);
                } else {
                    mesh.marks[neighbor as usize] = Mark::Outside;
                    let vertices = mesh.vertices[cell as usize];
                    self.boundary.push(BoundaryFacet { vertices, slot: slot as u32, outer });
                }
            }
        }
        Ok(())
    }

    /// Fills the cavity: one new cell per boundary facet, in the slots of the old cells first.
    fn fill(&mut self, mesh: &mut Cells<'_>, vertex: u32) -> u32 {
        for &cell in &self.cells {
            mesh.marks[cell as usize] = Mark::Unknown;
        }
        self.star.begin(&self.boundary, |facet| {
            FACET[facet.slot as usize].map(|slot| facet.vertices[slot])
        });
        let mut cell = 0;
        for (i, facet) in self.boundary.iter_mut().enumerate() {
            let slot = facet.slot as usize;
            // All four at once: a store of one, and a load of four right after it, would wait for
            // each other.
            let vertices = [0, 1, 2, 3].map(|k| match k == slot {
                true => vertex,
                false => facet.vertices[k],
            });
            cell = match self.cells.get(i).copied().or_else(|| mesh.free.pop()) {
                Some(cell) => {
                    mesh.vertices[cell as usize] = vertices;
                    cell
                }
                None => mesh.push(vertices),
            };
            mesh.marks[(facet.outer >> 2) as usize] = Mark::Unknown;
            mesh.link(4 * cell + facet.slot, facet.outer);
            // The slot's facet turns counterclockwise seen from the new point; its edge opposite
            // vertex `corners[k]` runs from `corners[k + 1]` to `corners[k + 2]`.
            let corners = FACET[slot];
            for k in 0..3 {
                let (from, to) = (corners[(k + 1) % 3], corners[(k + 2) % 3]);
                let side = 4 * cell + corners[k] as u32;
                self.star.put(i, facet.vertices[from], facet.vertices[to], k, side);
            }
            facet.outer = cell;
        }
        for (i, facet) in self.boundary.iter().enumerate() {
            let corners = FACET[facet.slot as usize];
            for k in 0..3 {
                let (from, to) = (corners[(k + 1) % 3], corners[(k + 2) % 3]);
                let across = self.star.get(i, facet.vertices[to], facet.vertices[from], k);
                mesh.neighbors[facet.outer as usize][corners[k]] = across;
            }
        }
        self.star.end();
        if let Some(unused) = self.cells.get(self.boundary.len()..) {
            mesh.free.extend_from_slice(unused);
        }
        cell
    }

    /// Whether a cell, finite or infinite, is in conflict with the point.
    fn in_conflict(mesh: &Cells<'_>, sites: &[Site], cell: u32, point: &Site) -> bool {
        let [a, b, c, d] = mesh.vertices[cell as usize];
        let site = |v: u32| &sites[v as usize];
        if d != mesh.infinite {
            return C::in_conflict(site(a), site(b), site(c), site(d), point);
        }
        match orient3d(site(a).position(), site(b).position(), site(c).position(), point.position())
        {
            Sign::Positive => true,
            Sign::Negative => false,
            // In the plane of the hull facet the circle decides, and it is where the plane
            // cuts the sphere of the finite cell behind the facet. The perturbation agrees: lifting
            // that cell's fourth vertex moves nothing in the plane.
            Sign::Zero => {
                let behind = mesh.neighbors[cell as usize][3] >> 2;
                match mesh.marks[behind as usize] {
                    Mark::Conflict => true,
                    Mark::Outside => false,
                    Mark::Unknown => {
                        let [a, b, c, d] = mesh.vertices[behind as usize];
                        C::in_conflict(site(a), site(b), site(c), site(d), point)
                    }
                }
            }
        }
    }
}

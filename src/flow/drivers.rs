//! Drivers: whither the distance to the samples grows.

use super::simplex::Simplex;
use super::triangles::Triangles;
use crate::dual::{Dual, Facets};
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{PART, Room, Run};
use crate::predicates::{edge_conflict, triangle_conflict};

/// What decides about every driver.
///
/// The driver of the points inside a face of the Voronoi diagram is the point of the dual Delaunay simplex that is nearest to them, and with that the centre of a
/// simplex that holds its own centre (Giesen, Ramos, Sadri, section 2): that simplex is given for it.
///
/// Invariants: `longest[i]` is the Voronoi facet of the longest edge of an obtuse triangle, or [`NONE`] for an acute one, with ties broken
/// by the perturbation of the triangulation: no triangle has a right angle. Bit `s` of `beyond[c]` says whether the centre of the
/// cell lies beyond the triangle opposite its vertex `s`.
#[derive(Clone, Debug)]
pub(super) struct Drivers {
    pub longest: Vec<u32>,
    pub beyond: Vec<u8>,
}

impl Drivers {
    pub fn new(
        dual: &Dual,
        facets: &Facets,
        triangles: &Triangles,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let t = dual.triangulation();
        let at = |v: u32| &t.coords()[v as usize];
        // Where the edges of each lesser vertex begin.
        let mut first = room.filled(t.coords().len() + 1, 0u32)?;
        for edge in run.watch(facets.edges()) {
            first[edge?[0] as usize + 1] += 1;
        }
        for v in 0..t.coords().len() {
            first[v + 1] += first[v];
        }
        let facet_of = |a: u32, b: u32| -> Result<u32> {
            let (a, b) = (a.min(b), a.max(b));
            let begin = first[a as usize];
            let row = &facets.edges()[begin as usize..first[a as usize + 1] as usize];
            match row.binary_search(&[a, b]) {
                Ok(i) => Ok(begin + i as u32),
                Err(_) => Err(Error::new(Status::Internal, "a triangle has no facet for an edge")),
            }
        };
        let mut longest = room.filled(triangles.len(), NONE)?;
        let chunks = longest.chunks_mut(PART / 4).enumerate().collect();
        run.in_steps(chunks, [0.05, 0.15], |(chunk, longest): (usize, &mut [u32])| {
            run.poll()?;
            for (i, longest) in longest.iter_mut().enumerate() {
                let [a, b, c] = triangles.corners(t, (chunk * (PART / 4) + i) as u32);
                for [p, q, r] in [[a, b, c], [b, c, a], [c, a, b]] {
                    if edge_conflict(at(p), at(q), at(r)) {
                        *longest = facet_of(p, q)?;
                        break;
                    }
                }
            }
            Ok(())
        })?;
        let mut beyond = room.filled(t.cells().len(), 0u8)?;
        let chunks = beyond.chunks_mut(PART / 4).zip(t.cells().chunks(PART / 4)).collect();
        run.in_steps(chunks, [0.15, 0.3], |(beyond, cells): (&mut [u8], &[[u32; 4]])| {
            run.poll()?;
            for (bits, &[a, b, c, d]) in beyond.iter_mut().zip(cells) {
                let apart = [[b, c, d, a], [c, d, a, b], [d, a, b, c], [a, b, c, d]];
                for (slot, [p, q, r, s]) in apart.into_iter().enumerate() {
                    *bits |= u8::from(triangle_conflict(at(p), at(q), at(r), at(s))) << slot;
                }
            }
            Ok(())
        })?;
        Ok(Drivers { longest, beyond })
    }

    /// That of a Voronoi edge.
    pub fn of_triangle(&self, triangle: u32) -> Simplex {
        match self.longest[triangle as usize] {
            NONE => Simplex::Triangle(triangle),
            facet => Simplex::Edge(facet),
        }
    }

    /// That of a Voronoi vertex.
    ///
    /// The centre of a cell lies beyond an acute triangle: then the nearest point of the cell is that triangle's centre. Or it lies
    /// beyond two obtuse ones with the same longest edge: that edge's middle.
    pub fn of_cell(&self, triangles: &Triangles, cell: u32) -> Simplex {
        let beyond = self.beyond[cell as usize];
        let sides = triangles.of_cell[cell as usize];
        let mut seen = [NONE; 4];
        for slot in (0..4).filter(|slot| beyond >> slot & 1 == 1) {
            if self.longest[sides[slot] as usize] == NONE {
                return Simplex::Triangle(sides[slot]);
            }
        }
        for (slot, &side) in sides.iter().enumerate() {
            let longest = self.longest[side as usize];
            if longest != NONE && seen[..slot].contains(&longest) {
                return Simplex::Edge(longest);
            }
            seen[slot] = longest;
        }
        Simplex::Cell(cell)
    }
}

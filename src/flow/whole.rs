//! Sets of whole Voronoi faces that the flow does not leave.
//!
//! Nothing need be cut to find them. The flow's pairs of elements outside such a set, which has all critical points, take off all that is outside: so it has the
//! homotopy type of what it is in.

use super::collapse::{Flags, collapse};
use super::outline::Outline;
use super::simplex::{Simplex, VoronoiSet};
use super::source::Source;
use super::subdivision::FlowElement;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use std::mem;

impl VoronoiSet {
    /// The least set of whole faces that holds some of them, with every face its sides, and all whole faces of another set into which something flows.
    pub fn closed(
        source: &Source<'_>,
        seeds: impl IntoIterator<Item = Simplex>,
        within: &VoronoiSet,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let mut set = VoronoiSet::filled(source, false, room)?;
        let (mut waiting, mut outline) = (Vec::new(), Outline::default());
        let t = source.dual.triangulation();
        let mut seen = 0;
        for seed in run.watch(seeds) {
            room.push(&mut waiting, seed?)?;
            while let Some(face) = waiting.pop() {
                seen += 1;
                if seen % 1024 == 0 {
                    run.poll()?;
                }
                if !set.insert(face) {
                    continue;
                }
                let driver = match face {
                    Simplex::Sample(_) => continue,
                    Simplex::Edge(facet) => {
                        outline.trace(source, facet)?;
                        room.grow(&mut waiting, outline.sides.len())?;
                        let sides = outline.sides.iter().filter(|&&side| side != NONE);
                        waiting.extend(sides.map(|&side| Simplex::Triangle(side)));
                        continue;
                    }
                    Simplex::Triangle(triangle) => {
                        let cells = source.triangles.cells(t, triangle);
                        room.grow(&mut waiting, 2)?;
                        let ends = cells.into_iter().filter(|&cell| cell != NONE);
                        waiting.extend(ends.map(Simplex::Cell));
                        source.drivers.of_triangle(triangle)
                    }
                    Simplex::Cell(cell) => source.drivers.of_cell(source.triangles, cell),
                };
                if within.has(driver) {
                    room.push(&mut waiting, driver)?;
                }
            }
        }
        Ok(set)
    }

    /// Adds a face alone; `false` if the set had it. Voronoi cells are never added.
    pub fn insert(&mut self, face: Simplex) -> bool {
        let flag = match face {
            Simplex::Sample(_) => return false,
            Simplex::Edge(facet) => &mut self.facets[facet as usize],
            Simplex::Triangle(triangle) => &mut self.edges[triangle as usize],
            Simplex::Cell(cell) => &mut self.vertices[cell as usize],
        };
        !mem::replace(flag, true)
    }

    /// Collapses a closed set of bounded faces as far as there are free sides outside of another one, which is kept.
    pub fn collapse(
        &mut self,
        source: &Source<'_>,
        kept: &VoronoiSet,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<()> {
        let mut spare = Room::new(run);
        let (mut offsets, mut sides) = (spare.vec(self.facets.len() + 1)?, Vec::new());
        let mut outline = Outline::default();
        offsets.push(0);
        for (facet, is_in) in (0..).zip(run.watch(&self.facets)) {
            if *is_in? {
                outline.trace(source, facet)?;
                spare.grow(&mut sides, outline.sides.len())?;
                sides.extend(outline.sides.iter().filter(|&&side| side != NONE));
            }
            offsets.push(sides.len());
        }
        let rim_of = |facet: u32| &sides[offsets[facet as usize]..offsets[facet as usize + 1]];
        let ends_of = |triangle| source.triangles.cells(source.dual.triangulation(), triangle);
        let is_kept = |element: FlowElement| {
            kept.has(match element {
                FlowElement::Vertex(cell) => Simplex::Cell(cell),
                FlowElement::Edge(triangle) => Simplex::Triangle(triangle),
                FlowElement::Face(facet) => Simplex::Edge(facet),
            })
        };
        let VoronoiSet { facets, edges, vertices, .. } = self;
        collapse(Flags { vertices, edges, faces: facets }, is_kept, rim_of, ends_of, room, run)
    }

    /// The faces of the set, ascending by the dimension of their simplices.
    pub fn faces(&self) -> impl Iterator<Item = Simplex> + '_ {
        let of = |flags: &'_ [bool]| {
            let numbers = (0..).zip(flags).filter(|(_, is_in)| **is_in).map(|(i, _)| i);
            numbers.collect::<Vec<u32>>()
        };
        let facets = of(&self.facets).into_iter().map(Simplex::Edge);
        let edges = of(&self.edges).into_iter().map(Simplex::Triangle);
        facets.chain(edges).chain(of(&self.vertices).into_iter().map(Simplex::Cell))
    }
}

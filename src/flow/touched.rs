//! The Voronoi faces that the flow from some of them can come to.

use super::outline::{Corner, Outline};
use super::side::View;
use super::simplex::{Simplex, VoronoiSet};
use super::source::Source;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use std::mem;

/// A face, and one into which something of it flows at once.
pub(super) type Step = (Simplex, Simplex);

impl VoronoiSet {
    /// A set that holds what the flow from some faces runs through, and a little more: what only a part of a Voronoi edge flows to is
    /// found as if all of the edge did. Of the facets it holds all edges, but of those into which something flows not their vertices on the near sides. Within another set
    /// the flow ends where it leaves that.
    ///
    /// Facets among the given faces stay whole: all that flows through them stays in what flows from them.
    pub fn touched(
        source: &Source<'_>,
        seeds: impl Iterator<Item = Simplex> + Clone,
        within: Option<&VoronoiSet>,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let mut walk = Walk::new(source, within, room)?;
        for seed in run.watch(seeds.clone()) {
            if let Simplex::Edge(facet) = seed? {
                walk.touched.whole[facet as usize] = true;
            }
        }
        walk.visit_all(seeds, room, run)?;
        Ok(walk.touched)
    }

    /// The same, but that nothing stays whole; and each step of the flow from face to face.
    pub fn touched_by_steps(
        source: &Source<'_>,
        seeds: impl Iterator<Item = Simplex> + Clone,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<(Self, Vec<Step>)> {
        let mut walk = Walk::new(source, None, room)?;
        // From a facet to its edges, of which three facets share each; from an edge to its ends and on; from a vertex on: for three edges about seven steps.
        let sides = seeds.clone().map(|seed| match seed {
            Simplex::Edge(facet) => source.facets.ring(facet as usize).len(),
            _ => 0,
        });
        walk.steps = Some(room.vec(7 * sides.sum::<usize>() / 3)?);
        walk.visit_all(seeds, room, run)?;
        Ok((walk.touched, walk.steps.unwrap_or_default()))
    }
}

struct Walk<'a> {
    source: &'a Source<'a>,
    within: Option<&'a VoronoiSet>,
    touched: VoronoiSet,
    /// The facets of which everything flows, and the edges.
    is_seed: Vec<bool>,
    flows: Vec<bool>,
    waiting: Vec<Simplex>,
    /// Where somebody asks for them.
    steps: Option<Vec<Step>>,
    outline: Outline,
}

impl<'a> Walk<'a> {
    fn new(
        source: &'a Source<'a>,
        within: Option<&'a VoronoiSet>,
        room: &mut Room<'_>,
    ) -> Result<Self> {
        Ok(Walk {
            source,
            within,
            touched: VoronoiSet::filled(source, false, room)?,
            is_seed: room.filled(source.facets.len(), false)?,
            flows: room.filled(source.triangles.len(), false)?,
            waiting: Vec::new(),
            steps: None,
            outline: Outline::default(),
        })
    }

    fn visit_all(
        &mut self,
        seeds: impl Iterator<Item = Simplex>,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<()> {
        let mut seen = 0;
        for seed in run.watch(seeds) {
            room.push(&mut self.waiting, seed?)?;
            while let Some(face) = self.waiting.pop() {
                seen += 1;
                if seen % 1024 == 0 {
                    run.poll()?;
                }
                let before = self.waiting.len();
                self.visit(face, room)?;
                if let Some(steps) = &mut self.steps {
                    room.grow(steps, self.waiting.len() - before)?;
                    steps.extend(self.waiting[before..].iter().map(|&next| (face, next)));
                }
            }
        }
        Ok(())
    }

    /// Whether the flow may run through a face.
    fn admits(&self, face: Simplex) -> bool {
        self.within.is_none_or(|within| within.has(face))
    }

    /// Whether a facet has to be looked at for what flows through it.
    fn is_crossed(&self, facet: u32) -> bool {
        !self.touched.whole[facet as usize] && self.admits(Simplex::Edge(facet))
    }

    /// Waits for what flows out of a face, unless it has been here.
    fn visit(&mut self, face: Simplex, room: &mut Room<'_>) -> Result<()> {
        match face {
            Simplex::Sample(_) => Ok(()),
            Simplex::Edge(facet) => {
                if mem::replace(&mut self.is_seed[facet as usize], true) {
                    return Ok(());
                }
                self.enter(facet)?;
                room.grow(&mut self.waiting, self.outline.sides.len())?;
                let sides = self.outline.sides.iter().filter(|&&side| side != NONE);
                self.waiting.extend(sides.map(|&side| Simplex::Triangle(side)));
                Ok(())
            }
            Simplex::Triangle(triangle) => self.flow_from_edge(triangle, room),
            Simplex::Cell(cell) => self.flow_from_vertex(cell, room),
        }
    }

    /// Touches a facet, with its edges.
    fn enter(&mut self, facet: u32) -> Result<()> {
        self.outline.trace(self.source, facet)?;
        if !mem::replace(&mut self.touched.facets[facet as usize], true) {
            for &side in self.outline.sides.iter().filter(|&&side| side != NONE) {
                self.touched.edges[side as usize] = true;
            }
        }
        Ok(())
    }

    fn flow_from_edge(&mut self, triangle: u32, room: &mut Room<'_>) -> Result<()> {
        if mem::replace(&mut self.flows[triangle as usize], true) {
            return Ok(());
        }
        self.touched.edges[triangle as usize] = true;
        let cells = self.source.triangles.cells(self.source.dual.triangulation(), triangle);
        room.grow(&mut self.waiting, 2)?;
        self.waiting.extend(cells.into_iter().filter(|&c| c != NONE).map(Simplex::Cell));
        let facet = self.source.drivers.longest[triangle as usize];
        if facet == NONE || !self.is_crossed(facet) {
            return Ok(());
        }
        self.enter(facet)?;
        let Some(side) = self.outline.sides.iter().position(|&side| side == triangle) else {
            return Ok(());
        };
        // Where the rays through its ends leave the facet; the far sides follow the near ones.
        let count = self.outline.sides.len();
        let last = match self.outline.corners[side] {
            Corner::Cell(cell) if side > 0 => self.exit(facet, cell),
            _ => count - 1,
        };
        let first = match self.outline.end(side) {
            Corner::Cell(cell) if side + 1 < self.outline.near => self.exit(facet, cell),
            _ => self.outline.near,
        };
        room.grow(&mut self.waiting, last + 1 - first)?;
        let sides = self.outline.sides[first..=last].iter().filter(|&&side| side != NONE);
        self.waiting.extend(sides.map(|&side| Simplex::Triangle(side)));
        Ok(())
    }

    fn flow_from_vertex(&mut self, cell: u32, room: &mut Room<'_>) -> Result<()> {
        if mem::replace(&mut self.touched.vertices[cell as usize], true) {
            return Ok(());
        }
        let driver = self.source.drivers.of_cell(self.source.triangles, cell);
        if !self.admits(driver) {
            return Ok(());
        }
        match driver {
            Simplex::Triangle(_) => room.push(&mut self.waiting, driver),
            Simplex::Edge(facet) if self.touched.whole[facet as usize] => Ok(()),
            Simplex::Edge(facet) => {
                self.enter(facet)?;
                match self.outline.sides[self.exit(facet, cell)] {
                    NONE => Ok(()),
                    side => room.push(&mut self.waiting, Simplex::Triangle(side)),
                }
            }
            _ => Ok(()),
        }
    }

    /// The far side of the facet by which the ray through a Voronoi vertex leaves.
    fn exit(&self, facet: u32, cell: u32) -> usize {
        let view = View::new(self.source.dual, self.source.facets.edges()[facet as usize]);
        view.exit(&self.outline, cell, self.outline.sides.len()) - 1
    }
}

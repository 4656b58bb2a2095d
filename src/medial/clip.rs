//! Voronoi facets cut off at a box.

use crate::dual::{Dual, Facets};
use crate::vector::{Vec3, add, cross, dot, length, scale, sub, unit};

/// What a corner of a clipped facet is. Facets that share it have the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Corner {
    /// The Voronoi vertex of a cell, the least of those that share it.
    Vertex(u32),
    /// Where a Voronoi edge passes through a plane of the box.
    Crossing(Line, u8),
    /// Where a facet meets an edge of the box, the line of two planes.
    OnEdge(u32, u8, u8),
    /// Somewhere outside of the box.
    Outside,
}

/// What a side of a facet lies on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Line {
    /// The Voronoi edge between the vertices of two cells.
    Edge(u32, u32),
    /// An unbounded one.
    Ray(u32),
    /// A plane of the box.
    Plane(u8),
    /// Beyond the box.
    Outside,
}

/// A corner, where it is, and what the side that begins there lies on.
pub(super) type Side = (Corner, Vec3, Line);

/// Cuts Voronoi facets off at a box.
pub(super) struct Clip<'a> {
    dual: &'a Dual,
    facets: &'a Facets,
    least_cell: &'a [u32],
    low: Vec3,
    high: Vec3,
    ring: Vec<Side>,
    next: Vec<Side>,
}

impl<'a> Clip<'a> {
    /// With the least and the largest corner of the box.
    pub fn new(
        dual: &'a Dual,
        facets: &'a Facets,
        least_cell: &'a [u32],
        [low, high]: [Vec3; 2],
    ) -> Self {
        Clip { dual, facets, least_cell, low, high, ring: Vec::new(), next: Vec::new() }
    }

    /// What of a facet lies in the box, counterclockwise; fewer than three corners if nothing does (Sutherland, Hodgman 1974, *Reentrant
    /// polygon clipping*).
    pub fn cut(&mut self, facet: usize) -> &[Side] {
        self.fill(facet);
        for plane in 0..6u8 {
            let axis = usize::from(plane / 2);
            // Positive within.
            let (low, high) = (self.low[axis], self.high[axis]);
            let depth = |at: Vec3| if plane % 2 == 0 { at[axis] - low } else { high - at[axis] };
            self.next.clear();
            for i in 0..self.ring.len() {
                let (corner, at, line) = self.ring[i];
                let (_, to, _) = self.ring[(i + 1) % self.ring.len()];
                let (here, there) = (depth(at), depth(to));
                if here >= 0.0 {
                    self.next.push((corner, at, line));
                }
                if (here >= 0.0) == (there >= 0.0) {
                    continue;
                }
                // From within to without, whichever way the facet turns: its neighbours find the same place.
                let crossing = match here >= 0.0 {
                    true => between(at, to, here / (here - there)),
                    false => between(to, at, there / (there - here)),
                };
                let corner = match line {
                    Line::Plane(other) => Corner::OnEdge(facet as u32, other, plane),
                    Line::Outside => Corner::Outside,
                    line => Corner::Crossing(line, plane),
                };
                // On the way out the plane comes next, on the way in the rest of the side.
                let on = if here >= 0.0 { Line::Plane(plane) } else { line };
                self.next.push((corner, crossing, on));
            }
            std::mem::swap(&mut self.ring, &mut self.next);
        }
        &self.ring
    }

    /// The facet's corners; where it is unbounded three of them stand for what is far away.
    fn fill(&mut self, facet: usize) {
        self.ring.clear();
        let cells = self.facets.ring(facet);
        let least = |cell: u32| self.least_cell[cell as usize];
        for (i, &cell) in cells.iter().enumerate() {
            let here = least(cell);
            let there = least(cells[(i + 1) % cells.len()]);
            // Cells that share their Voronoi vertex are one corner.
            if here != there || cells.len() == 1 {
                let at = self.dual.centers()[here as usize];
                let line = Line::Edge(here.min(there), here.max(there));
                self.ring.push((Corner::Vertex(here), at, line));
            }
        }
        if !self.facets.is_unbounded(facet) {
            return;
        }
        // The ring may have lost its last corner, if that is its first.
        let (first, last) = (least(cells[0]), least(cells[cells.len() - 1]));
        if self.ring.last().map(|side| side.0) != Some(Corner::Vertex(last)) {
            self.ring.push((
                Corner::Vertex(last),
                self.dual.centers()[last as usize],
                Line::Outside,
            ));
        }
        let [come, go] = self.facets.rays()[facet];
        let direction = |ray: u32| self.dual.rays().directions()[ray as usize];
        let middle = between(self.low, self.high, 0.5);
        let ends = [first, last].map(|cell| self.dual.centers()[cell as usize]);
        let size = length(sub(self.high, self.low));
        let far = ends.map(|end| length(sub(end, middle))).into_iter().fold(size, f64::max);
        let at = |end: Vec3, along: Vec3| add(end, scale(along, 8.0 * far));
        let coords = self.dual.triangulation().coords();
        let [p, q] = self.facets.edges()[facet].map(|v| coords[v as usize]);
        // Half way round from the ray that goes to the one that comes, so that no chord comes near the box.
        let half = match dot(direction(go), direction(come)) < 0.0 {
            true => unit(cross(sub(q, p), direction(go))),
            false => unit(add(direction(go), direction(come))),
        };
        if let Some(side) = self.ring.last_mut() {
            side.2 = Line::Ray(go);
        }
        self.ring.push((Corner::Outside, at(ends[1], direction(go)), Line::Outside));
        self.ring.push((Corner::Outside, at(between(ends[0], ends[1], 0.5), half), Line::Outside));
        self.ring.push((Corner::Outside, at(ends[0], direction(come)), Line::Ray(come)));
    }
}

/// The point a share of the way from one to another.
fn between(from: Vec3, to: Vec3, share: f64) -> Vec3 {
    add(scale(from, 1.0 - share), scale(to, share))
}

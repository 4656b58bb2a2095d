//! Voronoi facets cut off at a box.

use super::axis::corners;
use crate::dual::{Dual, Facets};
use crate::error::Result;
use crate::job::{Room, Run};
use crate::poles::least_rays;
use crate::vector::{Vec3, add, cross, dot, scale, sub, unit};
use std::collections::HashMap;

/// What a corner of a clipped facet is. Facets that share it have the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Corner {
    /// The Voronoi vertex of a cell, the least of those that share it.
    Vertex(u32),
    /// Where a Voronoi edge passes through a plane of the box.
    Crossing(Line, u8),
    /// One that no other facet has: where this one meets an edge of the box.
    Own,
}

/// A Voronoi edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Line {
    /// Between the vertices of two cells, the least of those that share them, in their order.
    Edge(u32, u32),
    /// An unbounded one, the least of those that are the same.
    Ray(u32),
}

/// What is farther away than this, 2^400, is kept in homogeneous coordinates: nothing overflows, and a direction is a place as any other.
const FAR: f64 = f64::from_bits((1023 + 400) << 52);

/// The place `x / w`. Either `w` is 1 and no coordinate above [`FAR`], or `w` is less than `1 / FAR` and the largest coordinate about 1: far away, and infinitely far for 0.
#[derive(Clone, Copy, Debug)]
struct Place {
    x: Vec3,
    w: f64,
}

impl Place {
    fn new(x: Vec3, w: f64) -> Self {
        let largest = x.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        if w > 0.0 && largest <= FAR * w {
            return Place { x: x.map(|x| x / w), w: 1.0 };
        }
        // A power of two, so that nothing is rounded.
        let exponent = (largest.to_bits() >> 52).clamp(1, 2045);
        let factor = f64::from_bits((2046 - exponent) << 52);
        Place { x: scale(x, factor), w: w * factor }
    }

    /// Where the side from here to there passes through a plane, given how deep both lie below and above it, one less than 0.
    ///
    /// What is the same at both ends is the same there, and what floats can tell exactly is exact.
    fn between(self, to: Place, [here, there]: [f64; 2]) -> Place {
        // The end that is not far away is the one to start from.
        if self.w < 1.0 && to.w == 1.0 {
            return to.between(self, [there, here]);
        }
        let (here, there) = (here.abs(), there.abs());
        if self.w < 1.0 {
            let x = add(scale(self.x, there), scale(to.x, here));
            return Place::new(x, self.w * there + to.w * here);
        }
        let w = there + to.w * here;
        let offset = scale(sub(to.x, scale(self.x, to.w)), here);
        if offset.iter().all(|x| x.abs() <= FAR * w) {
            return Place::new(add(self.x, offset.map(|x| x / w)), 1.0);
        }
        Place::new(add(scale(self.x, w), offset), w)
    }
}

/// A corner, where it is, and the Voronoi edge on which the side lies that begins there; `None` for one in a plane of the box, or
/// infinitely far away.
type Side = (Corner, Place, Option<Line>);

/// Cuts Voronoi facets off at a box.
pub(super) struct Clip<'a> {
    dual: &'a Dual,
    facets: &'a Facets,
    least_cell: &'a [u32],
    /// For each ray the least that is the same.
    least_ray: Vec<u32>,
    low: Vec3,
    high: Vec3,
    vertices: Vec<u32>,
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
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let least_ray = least_rays(dual, facets, least_cell, room, run)?;
        let (vertices, ring, next) = (Vec::new(), Vec::new(), Vec::new());
        Ok(Clip { dual, facets, least_cell, least_ray, low, high, vertices, ring, next })
    }

    /// What of a facet lies in the box, counterclockwise, no corner twice; fewer than three corners if nothing does, or nothing with an area
    /// (Sutherland, Hodgman 1974, *Reentrant polygon clipping*).
    ///
    /// What becomes of a Voronoi edge depends on nothing else, so all its facets get the same corners there.
    pub fn cut(
        &mut self,
        facet: usize,
        run: &Run<'_>,
    ) -> Result<impl ExactSizeIterator<Item = (Corner, Vec3)>> {
        self.fill(facet);
        for plane in 0..6u8 {
            run.poll()?;
            let axis = usize::from(plane / 2);
            let bound = if plane % 2 == 0 { self.low[axis] } else { self.high[axis] };
            // Positive within, and 0 in the plane.
            let depth = |at: Place| {
                let above = at.x[axis] - bound * at.w;
                if plane % 2 == 0 { above } else { -above }
            };
            self.next.clear();
            let (mut is_within, mut is_without) = (false, false);
            for i in 0..self.ring.len() {
                let (corner, at, line) = self.ring[i];
                let (_, to, _) = self.ring[(i + 1) % self.ring.len()];
                let (here, there) = (depth(at), depth(to));
                is_within |= here > 0.0;
                is_without |= here < 0.0;
                if here >= 0.0 {
                    // From a corner in the plane the polygon goes on in the plane if the side leads out.
                    self.next.push((corner, at, line.filter(|_| here > 0.0 || there >= 0.0)));
                }
                // A side that ends in the plane has a corner there already.
                if here > 0.0 && there < 0.0 || here < 0.0 && there > 0.0 {
                    // From within to without, whichever way the facet turns: its neighbours find the same place.
                    let mut crossing = match here > 0.0 {
                        true => at.between(to, [here, there]),
                        false => to.between(at, [there, here]),
                    };
                    crossing.x[axis] = bound * crossing.w;
                    let corner = line.map_or(Corner::Own, |line| Corner::Crossing(line, plane));
                    // On the way out the plane comes next, on the way in the rest of the side.
                    self.next.push((corner, crossing, line.filter(|_| here < 0.0)));
                }
            }
            // A polygon that only touches the plane has no area this side of it.
            if is_without && !is_within {
                self.next.clear();
            }
            std::mem::swap(&mut self.ring, &mut self.next);
        }
        // Nothing far away lies in the box, but for what rounding has left of two opposite directions: nothing.
        self.ring.retain(|(_, at, _)| at.w == 1.0);
        let (low, high) = (self.low, self.high);
        // A place between two in the box may be rounded out of it.
        let within = move |at: Vec3| [0, 1, 2].map(|k| at[k].clamp(low[k], high[k]));
        Ok(self.ring.iter().map(move |&(corner, at, _)| (corner, within(at.x))))
    }

    /// The facet's corners, and where it is unbounded directions as well; none if it has no area.
    fn fill(&mut self, facet: usize) {
        self.ring.clear();
        corners(self.least_cell, self.facets.ring(facet), &mut self.vertices);
        let count = self.vertices.len();
        let is_unbounded = self.facets.is_unbounded(facet);
        if !is_unbounded && count < 3 {
            return;
        }
        for (i, &here) in self.vertices.iter().enumerate() {
            let there = self.vertices[(i + 1) % count];
            let at = Place::new(self.dual.centers()[here as usize], 1.0);
            let line = Line::Edge(here.min(there), here.max(there));
            self.ring.push((Corner::Vertex(here), at, Some(line)));
        }
        if !is_unbounded {
            return;
        }
        let [come, go] = self.facets.rays()[facet].map(|ray| self.least_ray[ray as usize]);
        if come == go {
            self.ring.clear();
            return;
        }
        if let Some(side) = self.ring.last_mut() {
            side.2 = Some(Line::Ray(go));
        }
        let direction = |ray: u32| self.dual.rays().directions()[ray as usize];
        let coords = self.dual.triangulation().coords();
        let [p, q] = self.facets.edges()[facet].map(|v| coords[v as usize]);
        let mut push = |x: Vec3, line| self.ring.push((Corner::Own, Place::new(x, 0.0), line));
        push(direction(go), None);
        // Nearly opposite directions tell nothing of those between them.
        if dot(direction(go), direction(come)) < 0.0 {
            push(unit(cross(sub(q, p), direction(go))), None);
        }
        push(direction(come), Some(Line::Ray(come)));
    }
}

/// The numbers of the crossings that facets share.
///
/// Many small tables: none takes long to grow, and the job is asked in between whether to go on.
pub(super) struct Crossings {
    tables: Vec<HashMap<(Line, u8), u32>>,
}

/// The number of tables.
const TABLES: usize = 256;

impl Default for Crossings {
    fn default() -> Self {
        Crossings { tables: (0..TABLES).map(|_| HashMap::new()).collect() }
    }
}

impl Crossings {
    /// The number of a crossing, which is `next` if it is new.
    pub fn number(&mut self, line: Line, plane: u8, next: u32, room: &mut Room<'_>) -> Result<u32> {
        let table = match line {
            Line::Edge(from, to) => from ^ to,
            Line::Ray(ray) => ray,
        };
        let table = &mut self.tables[table as usize % TABLES];
        match table.get(&(line, plane)) {
            Some(&number) => Ok(number),
            None => room.insert(table, (line, plane), next).map(|()| next),
        }
    }
}

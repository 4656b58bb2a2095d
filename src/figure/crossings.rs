//! Edges and circles that cross or touch.

use super::meeting::{self, Relation, edges_meet, folds};
use super::{ChainKind, Figure, Point};
use crate::complex::{Hierarchy, Simplex};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run, parts};

/// The edges and circles of a figure. An edge has the number of its first vertex; circles come after all vertices.
pub(super) struct Curves<'a> {
    pub figure: &'a Figure,
    /// The end of the edge of each vertex, or [`NONE`] where no edge begins.
    next: Vec<u32>,
}

/// What was found of curves.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Found {
    /// The number of pairs that cross or touch, and the first of them.
    pub crossings: u64,
    pub first: Option<[u32; 2]>,
    /// Edges of rings and circles in a disc, each with the circle, in no order. Of a ring's edges not all need be there.
    pub inside: Vec<[u32; 2]>,
}

impl<'a> Curves<'a> {
    pub fn new(figure: &'a Figure, room: &mut Room<'_>, run: &Run<'_>) -> Result<Self> {
        let mut next = room.filled(figure.vertices.len(), NONE)?;
        for chain in run.watch(0..figure.chains.len()) {
            for edge in run.watch(figure.edges(chain?)) {
                let [a, b] = edge?;
                next[a as usize] = b;
            }
        }
        Ok(Curves { figure, next })
    }

    /// The numbers of the ends of an edge; `None` for a circle, and for a vertex where no edge begins.
    pub fn ends(&self, curve: u32) -> Option<[u32; 2]> {
        let next = self.next.get(curve as usize).filter(|&&next| next != NONE);
        next.map(|&next| [curve, next])
    }

    /// The number of a circle.
    pub fn circle_of(&self, curve: u32) -> Option<usize> {
        (curve as usize).checked_sub(self.figure.vertices.len())
    }

    pub fn position(&self, vertex: u32) -> &'a Point {
        &self.figure.vertices[vertex as usize]
    }

    /// The numbers of all curves, ascending.
    pub fn numbers(&self) -> impl Iterator<Item = u32> {
        let circles = self.next.len()..self.next.len() + self.figure.circles.len();
        let edges = (0..self.next.len()).filter(|&v| self.next[v] != NONE);
        edges.chain(circles).map(|number| number as u32)
    }

    /// Two opposite corners of the box of a curve, that of a circle rounded outward.
    pub fn corners(&self, curve: u32) -> [[f64; 3]; 2] {
        match self.circle_of(curve) {
            Some(circle) => circle_box(&self.figure.circles[circle]),
            None => {
                let [a, b] = self.ends(curve).unwrap_or([curve; 2]);
                [a, b].map(|v| {
                    let [x, y] = *self.position(v);
                    [x, y, 0.0]
                })
            }
        }
    }

    /// What a curve has to do with another. Edges of one vertex, and polylines with a common end, meet only if they fold.
    pub fn relation(&self, s: u32, t: u32) -> Relation {
        match (self.ends(s), self.ends(t)) {
            (Some(s), Some(t)) => match self.edges_cross(s, t) {
                true => Relation::Meets,
                false => Relation::Apart,
            },
            (Some(s), None) => self.edge_and_circle(s, t),
            (None, Some(t)) => match self.edge_and_circle(t, s) {
                Relation::Within => Relation::Around,
                other => other,
            },
            (None, None) => {
                let circle = |curve| self.circle_of(curve).map(|i| &self.figure.circles[i]);
                match (circle(s), circle(t)) {
                    (Some(s), Some(t)) => meeting::circles(s, t),
                    _ => Relation::Apart,
                }
            }
        }
    }

    fn edge_and_circle(&self, ends: [u32; 2], circle: u32) -> Relation {
        match self.circle_of(circle) {
            Some(i) => {
                let ends = ends.map(|v| self.position(v));
                meeting::edge_and_circle(ends, &self.figure.circles[i])
            }
            None => Relation::Apart,
        }
    }

    fn edges_cross(&self, s: [u32; 2], t: [u32; 2]) -> bool {
        let at = |v: u32| self.position(v);
        let ([a, b], [c, d]) = (s, t);
        if b == c {
            return folds(at(a), at(b), at(d));
        }
        if a == d {
            return folds(at(b), at(a), at(c));
        }
        // Each end of the one at the same place as an end of the other: they may be ends of polylines.
        for ([p, q], [r, u]) in
            [([a, b], [c, d]), ([a, b], [d, c]), ([b, a], [c, d]), ([b, a], [d, c])]
        {
            if at(p) == at(r) && self.is_end(p) && self.is_end(r) {
                return folds(at(q), at(p), at(u));
            }
        }
        edges_meet([at(a), at(b)], [at(c), at(d)])
    }

    /// Whether a vertex is an end of a polyline.
    fn is_end(&self, vertex: u32) -> bool {
        let chain = self.figure.chain_of(vertex);
        let range = self.figure.range(chain);
        self.figure.kinds[chain] == ChainKind::Polyline
            && (vertex == range.start || vertex + 1 == range.end)
    }

    /// Looks at all pairs of curves whose boxes meet.
    ///
    /// Cost: O(n log n + b) with b such pairs.
    pub fn find(&self, room: &mut Room<'_>, run: &Run<'_>) -> Result<Found> {
        let mut simplices = Vec::new();
        for curve in run.watch(self.numbers()) {
            let tag = curve?;
            room.push(&mut simplices, Simplex { corners: self.corners(tag), tag })?;
        }
        let hierarchy = Hierarchy::new(&simplices, room, run)?;
        let found = run.in_steps(parts(hierarchy.node_count()), [0.3, 0.9], |nodes| {
            // The room goes along, so that what is inside stays counted.
            let (mut found, mut room) = (Found::default(), Room::new(run));
            hierarchy.pairs(nodes, run, |s, t| self.look(s.tag, t.tag, &mut found, &mut room))?;
            Ok((found, room))
        })?;
        let mut all = Found::default();
        for (part, _) in &found {
            all.crossings += part.crossings;
            all.first = all.first.into_iter().chain(part.first).min();
            for &pair in &part.inside {
                room.push(&mut all.inside, pair)?;
            }
        }
        Ok(all)
    }

    /// Looks at a pair of curves.
    pub fn look(&self, s: u32, t: u32, found: &mut Found, room: &mut Room<'_>) -> Result<()> {
        let inside = match self.relation(s, t) {
            Relation::Apart => return Ok(()),
            Relation::Meets => {
                found.crossings += 1;
                found.first = found.first.into_iter().chain([[s.min(t), s.max(t)]]).min();
                return Ok(());
            }
            Relation::Within => [s, t],
            Relation::Around => [t, s],
        };
        // Polylines may lie anywhere, and of a ring's edges one in a row is enough.
        let ring = |curve: u32| match self.circle_of(curve) {
            Some(_) => None,
            None => Some(self.figure.chain_of(curve)),
        };
        let is_polyline = |chain: usize| !self.figure.kinds[chain].is_ring();
        let chain = ring(inside[0]);
        let is_known = |last: &[u32; 2]| last[1] == inside[1] && ring(last[0]) == chain;
        if chain.is_some_and(is_polyline)
            || chain.is_some() && found.inside.last().is_some_and(is_known)
        {
            return Ok(());
        }
        room.push(&mut found.inside, inside)
    }
}

/// Two opposite corners of a box round a disc.
pub(super) fn circle_box(&[x, y, radius]: &[f64; 3]) -> [[f64; 3]; 2] {
    let least = |c: f64| (c - radius).next_down();
    let greatest = |c: f64| (c + radius).next_up();
    [[least(x), least(y), 0.0], [greatest(x), greatest(y), 0.0]]
}

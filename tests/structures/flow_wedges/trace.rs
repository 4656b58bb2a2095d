//! Wedges, from facet to facet.

use super::Reached;
use super::diagram::{Corner, Diagram, Onward, Point, length};
use crate::flow::sub;
use medax::flow::Simplex;
use std::collections::{BTreeMap, BTreeSet};

/// Disjoint intervals, ascending.
#[derive(Clone, Debug, Default)]
struct Intervals(Vec<[f64; 2]>);

impl Intervals {
    /// Adds an interval, and gives those parts of it that are new.
    fn add(&mut self, [low, high]: [f64; 2]) -> Vec<[f64; 2]> {
        let (mut fresh, mut at) = (Vec::new(), low);
        let (mut merged, mut others) = ([low, high], Vec::new());
        for &[begin, end] in &self.0 {
            if end < low || begin > high {
                others.push([begin, end]);
                continue;
            }
            if begin > at {
                fresh.push([at, begin]);
            }
            at = at.max(end);
            merged = [merged[0].min(begin), merged[1].max(end)];
        }
        if at < high {
            fresh.push([at, high]);
        }
        others.push(merged);
        others.sort_by(|a, b| a[0].total_cmp(&b[0]));
        self.0 = others;
        fresh
    }

    fn contains(&self, share: f64) -> bool {
        self.0.iter().any(|&[low, high]| low <= share && share <= high)
    }
}

/// Where an orbit comes into a facet.
#[derive(Clone, Copy)]
enum Entry {
    Vertex(u32),
    Hit(u32, f64),
}

/// A tracing under way.
struct Trace<'a> {
    diagram: &'a Diagram,
    /// By Voronoi edges: all, and what is on the rims of parts of facets.
    covered: BTreeMap<u32, Intervals>,
    rims: BTreeMap<u32, Intervals>,
    areas: BTreeMap<u32, f64>,
    whole: BTreeSet<u32>,
    /// Facets, where orbits come in, and how far they run.
    hairs: Vec<(u32, Entry, f64)>,
    vertices: BTreeSet<u32>,
    waiting: Vec<(u32, [f64; 2])>,
}

impl<'a> Trace<'a> {
    fn new(diagram: &'a Diagram) -> Self {
        Trace {
            diagram,
            covered: BTreeMap::new(),
            rims: BTreeMap::new(),
            areas: BTreeMap::new(),
            whole: BTreeSet::new(),
            hairs: Vec::new(),
            vertices: BTreeSet::new(),
            waiting: Vec::new(),
        }
    }

    fn whole_facet(&mut self, facet: u32) {
        self.whole.insert(facet);
        let its = &self.diagram.facets[facet as usize];
        self.areas.insert(facet, self.diagram.area(facet, &its.corners));
        for &(edge, _) in its.sides.iter().flatten() {
            self.push(edge, [0.0, self.diagram.edges[edge as usize].last], true);
        }
    }

    /// Adds a part of a Voronoi edge; what of it is new has yet to flow.
    fn push(&mut self, edge: u32, part: [f64; 2], is_rim: bool) {
        if is_rim {
            self.rims.entry(edge).or_default().add(part);
        }
        let fresh = self.covered.entry(edge).or_default().add(part);
        self.waiting.extend(fresh.into_iter().map(|part| (edge, part)));
    }

    fn run(&mut self) {
        while let Some((edge, [low, high])) = self.waiting.pop() {
            let its = &self.diagram.edges[edge as usize];
            if low == 0.0 {
                self.vertex(its.ends[0]);
            }
            if high == 1.0 && its.last == 1.0 {
                self.vertex(its.ends[1]);
            }
            match its.crossed_into {
                Some(facet) if self.whole.contains(&facet) => {}
                Some(facet) => self.wedge(facet, edge, [low, high]),
                None => {
                    // Away from the middle of the triangle.
                    if low < its.middle {
                        self.push(edge, [0.0, low], false);
                    }
                    if high > its.middle {
                        self.push(edge, [high, its.last], false);
                    }
                }
            }
        }
    }

    /// Crosses a facet from a part of one of its near sides.
    fn wedge(&mut self, facet: u32, edge: u32, [low, high]: [f64; 2]) {
        let its = &self.diagram.facets[facet as usize];
        let count = its.sides.len();
        let runs_on = its.sides.contains(&Some((edge, true)));
        let place = |edge: u32, share: f64| {
            let of = &self.diagram.edges[edge as usize];
            match share {
                f64::INFINITY => {
                    Corner::Infinite(its.plane(of.from), its.direction(sub(of.to, of.from)))
                }
                _ => Corner::Finite(its.plane(of.at(share))),
            }
        };
        let entries = (if runs_on { [low, high] } else { [high, low] }).map(|s| place(edge, s));
        // Side, share of its edge, place.
        let [(last, last_share, end), (first, first_share, begin)] = entries.map(|entry| {
            let at_infinity = || its.sides.iter().position(Option::is_none).unwrap();
            let (side, share) = match entry {
                Corner::Finite(x) => self.diagram.exit(facet, x),
                Corner::Infinite(..) => (at_infinity(), f64::INFINITY),
            };
            match (its.sides[side], entry) {
                (Some(of), _) => {
                    let share = self.diagram.share_of_edge(of, share);
                    (side, share, place(of.0, share))
                }
                (None, Corner::Finite(x)) => (side, share, Corner::Infinite(x, x)),
                (None, entry) => (side, share, entry),
            }
        });
        let mut polygon = vec![entries[0], entries[1], begin];
        let mut exits = Vec::new();
        for side in first..first + count {
            let is_last = side % count == last;
            if let Some((edge, runs_on)) = its.sides[side % count] {
                let far_end = self.diagram.edges[edge as usize].last;
                let [from, to] = if runs_on { [0.0, far_end] } else { [far_end, 0.0] };
                let from = if side == first { first_share } else { from };
                let to = if is_last { last_share } else { to };
                exits.push((edge, [from.min(to), from.max(to)]));
            }
            if is_last {
                break;
            }
            polygon.push(its.corners[(side + 1) % count]);
        }
        polygon.push(end);
        *self.areas.entry(facet).or_default() += self.diagram.area(facet, &polygon);
        for (edge, part) in exits {
            self.push(edge, part, true);
        }
    }

    fn vertex(&mut self, cell: u32) {
        if !self.vertices.insert(cell) {
            return;
        }
        match self.diagram.onward[cell as usize] {
            Onward::End => {}
            Onward::Along(edge) => {
                self.push(edge, [0.0, self.diagram.edges[edge as usize].last], false)
            }
            Onward::Into(facet) => {
                self.orbit(facet, Entry::Vertex(cell), self.diagram.centers[cell as usize])
            }
        }
    }

    /// Follows the orbit of a Voronoi vertex from where it comes into a facet.
    fn orbit(&mut self, facet: u32, entry: Entry, at: Point) {
        let its = &self.diagram.facets[facet as usize];
        let (side, share) = self.diagram.exit(facet, its.plane(at));
        let Some(of) = its.sides[side] else {
            self.hairs.push((facet, entry, f64::INFINITY));
            return;
        };
        let share = self.diagram.share_of_edge(of, share);
        let edge = &self.diagram.edges[of.0 as usize];
        let hit = edge.at(share);
        self.hairs.push((facet, entry, length(sub(hit, at))));
        match edge.crossed_into {
            Some(facet) => self.orbit(facet, Entry::Hit(of.0, share), hit),
            None if share > edge.middle => self.push(of.0, [share, edge.last], false),
            None => self.push(of.0, [0.0, share], false),
        }
    }

    /// Whether what flows into a facet there does so from parts of Voronoi edges.
    fn is_covered(&self, facet: u32, entry: Entry) -> bool {
        let covers = |edge, share| self.covered.get(&edge).is_some_and(|its| its.contains(share));
        let diagram = self.diagram;
        match entry {
            _ if self.whole.contains(&facet) => true,
            Entry::Hit(edge, share) => covers(edge, share),
            Entry::Vertex(cell) => {
                let its = &diagram.facets[facet as usize];
                let near = (0..its.sides.len()).filter(|&side| diagram.is_near(facet, side));
                let edges = near.filter_map(|side| its.sides[side]).map(|(edge, _)| edge);
                edges.into_iter().any(|edge| match diagram.edges[edge as usize].ends {
                    [begin, _] if begin == cell => covers(edge, 0.0),
                    [_, end] if end == cell => covers(edge, 1.0),
                    _ => false,
                })
            }
        }
    }

    fn reached(self) -> Reached {
        let mut reached = Reached::default();
        for (&edge, parts) in &self.covered {
            let sum = |parts: &Intervals| -> f64 {
                let its = &self.diagram.edges[edge as usize];
                parts.0.iter().map(|&part| its.length(part)).sum()
            };
            let rims = self.rims.get(&edge).map_or(0.0, sum);
            reached.edges.insert(edge, sum(parts));
            reached.loose.insert(edge, sum(parts) - rims);
        }
        for &(facet, entry, length) in &self.hairs {
            if !self.is_covered(facet, entry) {
                reached.add_hair(facet, length);
            }
        }
        (reached.areas, reached.vertices) = (self.areas, self.vertices);
        reached
    }
}

/// Traces what is reached from some Voronoi faces.
pub fn trace(diagram: &Diagram, seeds: &[Simplex]) -> Reached {
    let mut trace = Trace::new(diagram);
    for &seed in seeds {
        match seed {
            Simplex::Edge(facet) => trace.whole_facet(facet),
            Simplex::Triangle(edge) => {
                // What is crossed is on the rim of what it flows into.
                let its = &diagram.edges[edge as usize];
                trace.push(edge, [0.0, its.last], its.crossed_into.is_some());
            }
            Simplex::Cell(cell) => trace.vertex(cell),
            Simplex::Sample(_) => {}
        }
        trace.run();
    }
    trace.reached()
}

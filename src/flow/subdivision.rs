//! The Voronoi diagram cut along the flow.

use super::cuts::{Cuts, Entry};
use super::simplex::{Simplex, VoronoiSet};
use super::source::Source;
use super::strips::{Rims, Strips};
use crate::complex::Rows;
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{PART, Room, Run};
use crate::vector::Vec3;
use std::ops::Range;

/// The vertices, edges and facets of a part of the Voronoi diagram, or of all of it, cut where the flow of one part runs into a part of another.
///
/// Vertices are first the Voronoi vertices, one for each cell; then the ends of cuts; then the critical points of index 2, each of which
/// divides its Voronoi edge. Edges are first the parts of Voronoi edges, then the cuts. Faces are the parts of Voronoi facets. Where samples are cospherical
/// vertices lie in one place, and edges and faces may have no extent: they are told apart by the triangulation, not by where they lie.
///
/// Every face flows into whole faces (Giesen, Ramos, Sadri, section 5): a vertex into the edge `edge_of_vertex`, and so to that edge's other end; the part of
/// a Voronoi edge of an obtuse triangle into the face `face_of_edge`; every other edge along itself, and every face to its rim. So what is flowed
/// into is a closed set: with an element its sides, and what these flow into. Of a part of the diagram that holds for what the faces flow into from which the part
/// was found ([`VoronoiSet::touched`]); vertices whose cuts would cross a facet that stays whole flow into no edge, but lie on the rim of that facet, which is flowed into with all its rim. The subdivision is finer than the paper's: it is cut along the orbits of all
/// Voronoi vertices, also where both sides of a cut are in the unstable manifolds of the same critical points.
///
/// Invariants: row i of `rim_vertices` has the vertices of face i counterclockwise, as its facet, and row i of `rim_edges` the edge that begins at each; [`NONE`] stands for
/// the point at infinity, in edges too.
#[derive(Clone, Debug, Default)]
pub(super) struct Subdivision {
    /// Of the ends of cuts, and of the critical points of index 2.
    pub points: Vec<Vec3>,
    /// The triangle of each such point.
    pub triangle_of_point: Vec<u32>,
    /// The number of ends of cuts.
    pub hits: u32,
    pub edges: Vec<[u32; 2]>,
    /// The triangle of each edge that is a part of a Voronoi edge.
    pub triangle_of_edge: Vec<u32>,
    /// The facet that each cut crosses.
    pub facet_of_cut: Vec<u32>,
    /// For each triangle where its edges begin.
    pub edges_of_triangle: Vec<u32>,
    pub edge_of_vertex: Vec<u32>,
    pub face_of_edge: Vec<u32>,
    pub rim_vertices: Rows,
    pub rim_edges: Vec<u32>,
    /// For each facet where its faces begin.
    pub faces_of_facet: Vec<u32>,
}

/// An element of a flow complex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum FlowElement {
    /// A vertex.
    Vertex(u32),
    /// An edge.
    Edge(u32),
    /// A face.
    Face(u32),
}

/// What a subdivision is made of.
pub(super) struct Made<'a> {
    pub source: &'a Source<'a>,
    pub set: &'a VoronoiSet,
    pub cuts: &'a Cuts,
}

impl Subdivision {
    /// Cuts a set of Voronoi faces.
    pub fn new(
        source: &Source<'_>,
        set: &VoronoiSet,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        // What is only needed to make it gives its room back.
        let mut spare = Room::new(run);
        let cuts = Cuts::new(source, set, &mut spare, run)?;
        let mut its = Subdivision { hits: cuts.hits.len() as u32, ..Subdivision::default() };
        let mut saddles: Vec<u32> = Vec::new();
        for triangle in run.watch(0..source.triangles.len() as u32) {
            let triangle = triangle?;
            if set.edges[triangle as usize] && source.is_saddle(triangle) {
                spare.push(&mut saddles, triangle)?;
            }
        }
        let cells = source.dual.triangulation().cells().len();
        let points = cuts.hits.len() + saddles.len();
        its.points = room.vec(points)?;
        its.points.extend(cuts.hits.iter().map(|hit| hit.at));
        let center = |&triangle: &u32| source.center_of(Simplex::Triangle(triangle));
        its.points.extend(saddles.iter().map(center));
        its.triangle_of_point = room.vec(points)?;
        its.triangle_of_point.extend(cuts.hits.iter().map(|hit| hit.triangle));
        its.triangle_of_point.extend(saddles.iter());
        its.edge_of_vertex = room.filled(cells + points, NONE)?;
        let made = Made { source, set, cuts: &cuts };
        its.divide_edges(&made, &saddles, room, run)?;
        its.add_cuts(&made, room)?;
        its.face_of_edge = room.filled(its.edges.len(), NONE)?;
        its.add_faces(&made, room, run)?;
        Ok(its)
    }

    /// The numbers of the faces of a Voronoi facet.
    pub fn faces_of(&self, facet: u32) -> Range<u32> {
        self.faces_of_facet[facet as usize]..self.faces_of_facet[facet as usize + 1]
    }

    /// The numbers of the edges that a triangle's Voronoi edge is divided into.
    pub fn edges_of(&self, triangle: u32) -> Range<u32> {
        self.edges_of_triangle[triangle as usize]..self.edges_of_triangle[triangle as usize + 1]
    }

    /// The Voronoi facet of a face.
    pub fn facet_of(&self, face: u32) -> u32 {
        self.faces_of_facet.partition_point(|&begin| begin <= face) as u32 - 1
    }

    /// The Voronoi face that an edge is a part of: a Voronoi edge, or for a cut a facet.
    pub fn simplex_of(&self, edge: u32) -> Simplex {
        match self.triangle_of_edge.get(edge as usize) {
            Some(&triangle) => Simplex::Triangle(triangle),
            None => {
                let cut = edge as usize - self.triangle_of_edge.len();
                Simplex::Edge(self.facet_of_cut[cut])
            }
        }
    }

    /// The elements of a Voronoi facet, edge or vertex.
    pub fn elements_of(&self, face: Simplex) -> impl Iterator<Item = FlowElement> + use<> {
        let (range, element): (_, fn(u32) -> FlowElement) = match face {
            Simplex::Sample(_) => (0..0, FlowElement::Vertex),
            Simplex::Edge(facet) => (self.faces_of(facet), FlowElement::Face),
            Simplex::Triangle(triangle) => (self.edges_of(triangle), FlowElement::Edge),
            Simplex::Cell(cell) => (cell..cell + 1, FlowElement::Vertex),
        };
        range.map(element)
    }

    /// The elements that hold a critical point, but for a sample.
    pub fn elements_at(&self, critical: Simplex) -> impl Iterator<Item = FlowElement> + '_ {
        let points = (self.edge_of_vertex.len() - self.points.len()) as u32 + self.hits;
        let saddle = match critical {
            Simplex::Triangle(triangle) => self.edges_of(triangle),
            _ => 0..0,
        };
        // Both parts of its Voronoi edge end there.
        let saddle = saddle.map(|edge| self.edges[edge as usize][1]);
        let saddle = saddle.filter(move |&v| v != NONE && v >= points).map(FlowElement::Vertex);
        let others = match critical {
            Simplex::Triangle(_) => None,
            _ => Some(self.elements_of(critical)),
        };
        saddle.chain(others.into_iter().flatten())
    }

    /// The edges of a face.
    pub fn rim_of(&self, face: u32) -> &[u32] {
        let offsets = self.rim_vertices.offsets();
        &self.rim_edges[offsets[face as usize] as usize..offsets[face as usize + 1] as usize]
    }

    /// The vertex of an entry.
    pub fn vertex_of(&self, source: &Source<'_>, entry: Entry) -> u32 {
        match entry {
            Entry::Cell(cell) => cell,
            Entry::Hit(hit) => source.dual.triangulation().cells().len() as u32 + hit,
        }
    }

    /// Divides the Voronoi edges, and lets Voronoi vertices and points flow along them.
    fn divide_edges(
        &mut self,
        Made { source, set, cuts }: &Made<'_>,
        saddles: &[u32],
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<()> {
        let t = source.dual.triangulation();
        let cells = t.cells().len() as u32;
        let count = set.edges.iter().filter(|&&is_in| is_in).count() + self.points.len();
        self.edges = room.vec(count + cuts.cuts.len())?;
        self.triangle_of_edge = room.vec(count)?;
        self.edges_of_triangle = room.vec(source.triangles.len() + 1)?;
        let (mut list, mut next_saddle) = (Vec::new(), 0);
        for triangle in run.watch(0..source.triangles.len() as u32) {
            let triangle = triangle?;
            let first = self.edges.len() as u32;
            self.edges_of_triangle.push(first);
            if !set.edges[triangle as usize] {
                continue;
            }
            cuts.hits_on(triangle, &mut list);
            let ends = source.triangles.cells(t, triangle);
            // The points that flow back to the first end, then the critical point, then those that flow on to the second.
            let mut back = 0;
            list.iter_mut().for_each(|hit| *hit += cells);
            if saddles.get(next_saddle) == Some(&triangle) {
                let saddle = self.hits + next_saddle as u32;
                let share = source.share(triangle, self.points[saddle as usize]);
                let is_before =
                    |&v: &u32| cuts.hits[(v - cells) as usize].share.order(&share).is_lt();
                back = list.partition_point(is_before);
                list.insert(back, cells + saddle);
                next_saddle += 1;
            } else if source.drivers.longest[triangle as usize] == NONE {
                let [cell, slot] = source.triangles.sides[triangle as usize];
                match source.drivers.beyond[cell as usize] >> slot & 1 {
                    1 => self.edge_of_vertex[ends[0] as usize] = first,
                    _ => {
                        self.edge_of_vertex[ends[1] as usize] = first + list.len() as u32;
                        back = list.len();
                    }
                }
            }
            if source.drivers.longest[triangle as usize] == NONE {
                for (i, &vertex) in list.iter().enumerate() {
                    if vertex < cells + self.hits {
                        let edge = if i < back { i } else { i + 1 };
                        self.edge_of_vertex[vertex as usize] = first + edge as u32;
                    }
                }
            }
            let mut begin = ends[0];
            for &vertex in list.iter().chain([&ends[1]]) {
                self.edges.push([begin, vertex]);
                self.triangle_of_edge.push(triangle);
                begin = vertex;
            }
        }
        self.edges_of_triangle.push(self.edges.len() as u32);
        Ok(())
    }

    fn add_cuts(&mut self, made: &Made<'_>, room: &mut Room<'_>) -> Result<()> {
        let Made { source, cuts, .. } = made;
        let cells = source.dual.triangulation().cells().len() as u32;
        room.grow(&mut self.edges, cuts.cuts.len())?;
        for cut in &cuts.cuts {
            let from = self.vertex_of(source, cut.from);
            let to = if cut.to == NONE { NONE } else { cells + cut.to };
            self.edge_of_vertex[from as usize] = self.edges.len() as u32;
            self.edges.push([from, to]);
        }
        self.facet_of_cut = room.filled(cuts.cuts.len(), NONE)?;
        for (facet, &[begin, end]) in (0..).zip(&cuts.of_facet) {
            self.facet_of_cut[begin as usize..end as usize].fill(facet);
        }
        Ok(())
    }

    fn add_faces(&mut self, made: &Made<'_>, room: &mut Room<'_>, run: &Run<'_>) -> Result<()> {
        let count = made.source.facets.len();
        self.faces_of_facet = room.vec(count + 1)?;
        self.faces_of_facet.push(0);
        let mut last = 0;
        for (&[begin, end], &is_in) in made.cuts.of_facet.iter().zip(&made.set.facets) {
            last += end - begin + u32::from(is_in);
            self.faces_of_facet.push(last);
        }
        let parts = (0..count).step_by(PART / 8).map(|i| i..count.min(i + PART / 8)).collect();
        let shared = &*self;
        let pieces = run.in_steps(parts, [0.75, 0.95], |facets| {
            run.poll()?;
            let mut room = Room::new(run);
            let (mut strips, mut rims) = (Strips::default(), Rims::default());
            for facet in facets.filter(|&facet| made.set.facets[facet]) {
                strips.trace(shared, made, facet as u32, &mut rims, &mut room)?;
            }
            Ok((rims, room))
        })?;
        let faces: usize = pieces.iter().map(|(rims, _)| rims.ends.len()).sum();
        let entries: usize = pieces.iter().map(|(rims, _)| rims.vertices.len()).sum();
        if u32::try_from(entries).is_err() {
            let message = "a flow complex with more than 2^32 - 1 sides of faces";
            return Err(Error::new(Status::LimitExceeded, message));
        }
        let mut offsets = room.vec(faces + 1)?;
        let mut vertices: Vec<u32> = room.vec(entries)?;
        self.rim_edges = room.vec(entries)?;
        offsets.push(0);
        for (rims, _) in pieces {
            run.poll()?;
            let begin = vertices.len() as u32;
            for (edge, face) in rims.entered {
                self.face_of_edge[edge as usize] = face;
            }
            offsets.extend(rims.ends.iter().map(|&end| begin + end));
            vertices.extend(rims.vertices);
            self.rim_edges.extend(rims.edges);
        }
        self.rim_vertices = Rows::new(offsets, vertices)?;
        Ok(())
    }
}

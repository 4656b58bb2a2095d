//! The unstable flow complex as cells.

use super::cuts::{Cuts, Entry};
use super::drivers::Drivers;
use super::outline::{Corner, Outline};
use super::triangles::Triangles;
use crate::complex::Rows;
use crate::dual::{Dual, Facets};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{PART, Room, Run};
use crate::vector::{Vec3, add, cross, dot, scale, sub};
use std::ops::Range;

/// The Voronoi diagram's vertices, edges and facets, cut where the flow of one part runs into a part of another.
///
/// Vertices are first the Voronoi vertices, one for each cell; then the ends of cuts; then the critical points of index 2, each of which
/// divides its Voronoi edge. Edges are first the parts of Voronoi edges, then the cuts. Faces are the parts of Voronoi facets. Where samples are cospherical
/// vertices lie in one place, and edges and faces may have no extent: they are told apart by the triangulation, not by where they lie.
///
/// Every face flows into whole faces (Giesen, Ramos, Sadri, section 5): a vertex into the edge `edge_of_vertex`, and so to that edge's other end; the part of
/// a Voronoi edge of an obtuse triangle into the face `face_of_edge`; every other edge along itself, and every face to its rim. So what is flowed
/// into is a closed set: with an element its sides, and what these flow into. The complex is finer than the paper's: it is cut along the orbits of all
/// Voronoi vertices, also where both sides of a cut are in the unstable manifolds of the same critical points.
///
/// Invariants: row i of `rim_vertices` has the vertices of face i counterclockwise, as its facet, and row i of `rim_edges` the edge that begins at each; [`NONE`] stands for
/// the point at infinity, in edges too.
#[derive(Clone, Debug, Default)]
pub(super) struct FlowComplex {
    /// Of the ends of cuts, and of the critical points of index 2.
    pub points: Vec<Vec3>,
    /// The triangle of each such point.
    pub triangle_of_point: Vec<u32>,
    /// The number of ends of cuts.
    pub hits: u32,
    pub edges: Vec<[u32; 2]>,
    /// The triangle of each edge that is a part of a Voronoi edge.
    pub triangle_of_edge: Vec<u32>,
    /// For each triangle where its edges begin.
    pub edges_of_triangle: Vec<u32>,
    pub edge_of_vertex: Vec<u32>,
    pub face_of_edge: Vec<u32>,
    pub rim_vertices: Rows,
    pub rim_edges: Vec<u32>,
    /// For each facet where its faces begin.
    pub faces_of_facet: Vec<u32>,
}

/// What a flow complex is made of.
pub(super) struct Source<'a> {
    pub dual: &'a Dual,
    pub facets: &'a Facets,
    pub triangles: &'a Triangles,
    pub drivers: &'a Drivers,
    pub cuts: &'a Cuts,
}

impl FlowComplex {
    /// Given the triangles of the critical points of index 2, ascending.
    pub fn new(
        source: &Source<'_>,
        saddles: &[u32],
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let cells = source.dual.triangulation().cells().len();
        let hits = source.cuts.hits.len();
        let mut complex = FlowComplex { hits: hits as u32, ..FlowComplex::default() };
        let points = hits + saddles.len();
        complex.points = room.vec(points)?;
        complex.triangle_of_point = room.vec(points)?;
        for hit in run.watch(&source.cuts.hits) {
            let hit = hit?;
            complex.points.push(hit.at);
            complex.triangle_of_point.push(hit.triangle);
        }
        for &triangle in saddles {
            complex.points.push(source.center_of_triangle(triangle));
            complex.triangle_of_point.push(triangle);
        }
        complex.edge_of_vertex = room.filled(cells + points, NONE)?;
        complex.divide_edges(source, saddles, room, run)?;
        complex.add_cuts(source, room)?;
        complex.face_of_edge = room.filled(complex.edges.len(), NONE)?;
        complex.add_faces(source, room, run)?;
        Ok(complex)
    }

    /// The edges of a face.
    pub fn rim_of(&self, face: u32) -> &[u32] {
        let offsets = self.rim_vertices.offsets();
        &self.rim_edges[offsets[face as usize] as usize..offsets[face as usize + 1] as usize]
    }

    /// The vertex of an entry.
    fn vertex_of(&self, source: &Source<'_>, entry: Entry) -> u32 {
        match entry {
            Entry::Cell(cell) => cell,
            Entry::Hit(hit) => source.dual.triangulation().cells().len() as u32 + hit,
        }
    }

    /// Divides the Voronoi edges, and lets Voronoi vertices and points flow along them.
    fn divide_edges(
        &mut self,
        source: &Source<'_>,
        saddles: &[u32],
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<()> {
        let t = source.dual.triangulation();
        let cells = t.cells().len() as u32;
        let count = source.triangles.len() + self.points.len() + source.cuts.cuts.len();
        self.edges = room.vec(count)?;
        self.triangle_of_edge = room.vec(source.triangles.len() + self.points.len())?;
        self.edges_of_triangle = room.vec(source.triangles.len() + 1)?;
        let (mut list, mut next_saddle) = (Vec::new(), 0);
        for triangle in run.watch(0..source.triangles.len() as u32) {
            let triangle = triangle?;
            source.cuts.hits_on(triangle, &mut list);
            let first = self.edges.len() as u32;
            self.edges_of_triangle.push(first);
            let ends = source.triangles.cells(t, triangle);
            // The points that flow back to the first end, then the critical point, then those that flow on to the second.
            let mut back = 0;
            list.iter_mut().for_each(|hit| *hit += cells);
            if saddles.get(next_saddle) == Some(&triangle) {
                let saddle = self.hits + next_saddle as u32;
                let share = source.share(triangle, self.points[saddle as usize]);
                let is_before = |&v: &u32| source.cuts.hits[(v - cells) as usize].share < share;
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

    fn add_cuts(&mut self, source: &Source<'_>, room: &mut Room<'_>) -> Result<()> {
        let cells = source.dual.triangulation().cells().len() as u32;
        room.grow(&mut self.edges, source.cuts.cuts.len())?;
        for cut in &source.cuts.cuts {
            let from = self.vertex_of(source, cut.from);
            let to = if cut.to == NONE { NONE } else { cells + cut.to };
            self.edge_of_vertex[from as usize] = self.edges.len() as u32;
            self.edges.push([from, to]);
        }
        Ok(())
    }

    fn add_faces(&mut self, source: &Source<'_>, room: &mut Room<'_>, run: &Run<'_>) -> Result<()> {
        let count = source.facets.len();
        self.faces_of_facet = room.vec(count + 1)?;
        self.faces_of_facet.push(0);
        for &[begin, end] in &source.cuts.of_facet {
            let last = self.faces_of_facet[self.faces_of_facet.len() - 1];
            self.faces_of_facet.push(last + (end - begin) + 1);
        }
        let parts = (0..count).step_by(PART / 8).map(|i| i..count.min(i + PART / 8)).collect();
        let shared = &*self;
        let pieces = run.in_steps(parts, [0.75, 0.95], |facets| {
            run.poll()?;
            let mut room = Room::new(run);
            let (mut strips, mut rims) = (Strips::default(), Rims::default());
            for facet in facets {
                strips.trace(shared, source, facet as u32, &mut rims, &mut room)?;
            }
            Ok((rims, room))
        })?;
        let faces: usize = pieces.iter().map(|(rims, _)| rims.ends.len()).sum();
        let entries: usize = pieces.iter().map(|(rims, _)| rims.vertices.len()).sum();
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

impl Source<'_> {
    /// The triangles whose Voronoi edges hold their centres: the critical points of index 2.
    pub fn saddles(&self, room: &mut Room<'_>, run: &Run<'_>) -> Result<Vec<u32>> {
        let mut saddles = Vec::new();
        for triangle in run.watch(0..self.triangles.len() as u32) {
            let triangle = triangle?;
            if self.is_saddle(triangle) {
                room.push(&mut saddles, triangle)?;
            }
        }
        Ok(saddles)
    }

    fn is_saddle(&self, triangle: u32) -> bool {
        if self.drivers.longest[triangle as usize] != NONE {
            return false;
        }
        let t = self.dual.triangulation();
        let is_beyond = |cell: u32| {
            cell != NONE && {
                let sides = self.triangles.of_cell[cell as usize];
                let slot = sides.iter().position(|&side| side == triangle);
                slot.is_some_and(|slot| self.drivers.beyond[cell as usize] >> slot & 1 == 1)
            }
        };
        !self.triangles.cells(t, triangle).into_iter().any(is_beyond)
    }

    /// The centre of a triangle's smallest sphere, in its plane.
    pub fn center_of_triangle(&self, triangle: u32) -> Vec3 {
        let t = self.dual.triangulation();
        let [p, q, r] = self.triangles.corners(t, triangle).map(|v| t.coords()[v as usize]);
        circumcenter(p, q, r)
    }

    /// How far along a triangle's Voronoi edge a point lies, as [`Hit::share`](super::cuts::Hit).
    fn share(&self, triangle: u32, at: Vec3) -> f64 {
        let t = self.dual.triangulation();
        let [cell, other] = self.triangles.cells(t, triangle);
        let begin = self.dual.centers()[cell as usize];
        let along = match other {
            NONE => {
                let ray =
                    self.dual.rays().of_facet(cell, self.triangles.sides[triangle as usize][1]);
                return dot(sub(at, begin), self.dual.rays().directions()[ray as usize]);
            }
            other => sub(self.dual.centers()[other as usize], begin),
        };
        dot(sub(at, begin), along) / dot(along, along)
    }
}

/// The centre of the smallest sphere through three points, from the corner with the largest angle.
fn circumcenter(p: Vec3, q: Vec3, r: Vec3) -> Vec3 {
    let opposite = [[p, q, r], [q, r, p], [r, p, q]];
    let length = |[_, b, c]: &[Vec3; 3]| dot(sub(*c, *b), sub(*c, *b));
    let widest = opposite.iter().max_by(|x, y| length(x).total_cmp(&length(y)));
    let [p, q, r] = *widest.unwrap_or(&opposite[0]);
    let (a, b) = (sub(q, p), sub(r, p));
    let normal = cross(a, b);
    let sum = add(scale(cross(b, normal), dot(a, a)), scale(cross(normal, a), dot(b, b)));
    add(p, scale(sum, 0.5 / dot(normal, normal)))
}

/// The rims of some faces.
#[derive(Default)]
struct Rims {
    ends: Vec<u32>,
    vertices: Vec<u32>,
    edges: Vec<u32>,
    /// Edges and the faces that they flow into.
    entered: Vec<(u32, u32)>,
}

/// A path of vertices and the edges between them.
#[derive(Default)]
struct Path {
    vertices: Vec<u32>,
    edges: Vec<u32>,
}

/// The faces of one facet: strips between its cuts.
#[derive(Default)]
struct Strips {
    outline: Outline,
    near: Path,
    far: Path,
}

impl Strips {
    fn trace(
        &mut self,
        complex: &FlowComplex,
        source: &Source<'_>,
        facet: u32,
        rims: &mut Rims,
        room: &mut Room<'_>,
    ) -> Result<()> {
        self.outline.trace(source.dual, source.facets, source.triangles, source.drivers, facet)?;
        let near = self.outline.near;
        let sides = self.outline.sides.len();
        self.near.walk(complex, source, &self.outline, 0..near, room)?;
        self.far.walk(complex, source, &self.outline, near..sides, room)?;
        let first_face = complex.faces_of_facet[facet as usize];
        if near == 0 {
            // The walk has come back to where it began.
            rims.add(&self.far.vertices[..self.far.edges.len()], &self.far.edges, room)?;
            return rims.end(room);
        }
        let [first_cut, _] = source.cuts.of_facet[facet as usize];
        let cuts = source.cuts.of(facet);
        let cells = source.dual.triangulation().cells().len() as u32;
        let cut_edge = |i: usize| complex.triangle_of_edge.len() as u32 + first_cut + i as u32;
        // From the last cut to the first: the far side is walked counterclockwise.
        let mut far_begin = 0;
        let mut ranges = room.vec(cuts.len() + 1)?;
        for cut in cuts.iter().rev() {
            let exit = if cut.to == NONE { NONE } else { cells + cut.to };
            let steps = self.far.vertices[far_begin..].iter().position(|&v| v == exit);
            let far_end = far_begin + steps.unwrap_or(0);
            ranges.push((far_begin, far_end));
            far_begin = far_end;
        }
        ranges.push((far_begin, self.far.edges.len()));
        ranges.reverse();
        for (strip, (begin, end)) in ranges.into_iter().enumerate() {
            room.grow(&mut rims.entered, 1)?;
            rims.entered.push((self.near.edges[strip], first_face + strip as u32));
            rims.add(&self.near.vertices[strip..=strip], &self.near.edges[strip..=strip], room)?;
            if strip < cuts.len() {
                rims.add(&self.near.vertices[strip + 1..strip + 2], &[cut_edge(strip)], room)?;
            }
            rims.add(&self.far.vertices[begin..end], &self.far.edges[begin..end], room)?;
            if strip > 0 {
                rims.add(&self.far.vertices[end..=end], &[cut_edge(strip - 1)], room)?;
            }
            rims.end(room)?;
        }
        Ok(())
    }
}

impl Rims {
    fn add(&mut self, vertices: &[u32], edges: &[u32], room: &mut Room<'_>) -> Result<()> {
        room.grow(&mut self.vertices, vertices.len())?;
        room.grow(&mut self.edges, edges.len())?;
        self.vertices.extend_from_slice(vertices);
        self.edges.extend_from_slice(edges);
        Ok(())
    }

    fn end(&mut self, room: &mut Room<'_>) -> Result<()> {
        room.push(&mut self.ends, self.vertices.len() as u32)
    }
}

impl Path {
    /// Becomes the walk along some sides of an outline.
    fn walk(
        &mut self,
        complex: &FlowComplex,
        source: &Source<'_>,
        outline: &Outline,
        sides: Range<usize>,
        room: &mut Room<'_>,
    ) -> Result<()> {
        self.vertices.clear();
        self.edges.clear();
        let vertex = |corner| match corner {
            Corner::Cell(cell) => cell,
            Corner::Ray(_) => NONE,
        };
        self.vertices.push(vertex(outline.corners[sides.start % outline.corners.len()]));
        for side in sides {
            let triangle = outline.sides[side];
            if triangle == NONE {
                // The point at infinity, where the walk is already.
                continue;
            }
            let [lesser, _] = source.triangles.sides[triangle as usize];
            let [begin, end] = [0, 1].map(|i| complex.edges_of_triangle[triangle as usize + i]);
            room.grow(&mut self.vertices, (end - begin) as usize)?;
            room.grow(&mut self.edges, (end - begin) as usize)?;
            let runs_on = outline.corners[side] == Corner::Cell(lesser);
            if runs_on {
                for edge in begin..end {
                    self.edges.push(edge);
                    self.vertices.push(complex.edges[edge as usize][1]);
                }
            } else {
                for edge in (begin..end).rev() {
                    self.edges.push(edge);
                    self.vertices.push(complex.edges[edge as usize][0]);
                }
            }
        }
        Ok(())
    }
}

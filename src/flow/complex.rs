//! The unstable flow complex and its flow DAG.

use super::Flow;
use super::closure::Subset;
use super::simplex::{Simplex, VoronoiSet};
use super::subdivision::{FlowElement, Subdivision};
use super::upstream::Upstream;
use crate::complex::{Complex, Rows};
use crate::error::{ElementKind, Error, Result, Status};
#[cfg(doc)]
use crate::index::NONE;
use crate::job::{Job, Room, Stage};
use std::sync::Arc;

/// The unstable flow complex of a sample (Giesen, Ramos, Sadri, section 5): the Voronoi diagram, cut where the flow of one part runs into a part of another.
///
/// Its cells are those of the Voronoi diagram, one for each sample. Vertices are first the Voronoi vertices, one for each cell of the triangulation; then points on Voronoi edges: where orbits of Voronoi vertices hit them, and
/// the critical points of index 2. Edges are first the parts of Voronoi edges, then what orbits of Voronoi vertices cut through Voronoi facets. Faces are the parts of Voronoi facets. Where samples are cospherical
/// vertices lie in one place, and edges and faces may have no extent: they are told apart by the triangulation, not by where they lie.
///
/// Every element flows into whole elements: a vertex into one edge, the part of a Voronoi edge that the flow crosses into one face, every other edge to its ends and every face to its rim.
/// These steps and those from an element to its sides are the flow DAG: what can be reached by them from some elements is their flow closure. The paper's complex is coarser:
/// here two faces may be in the unstable manifolds of the same critical points.
#[derive(Clone, Debug)]
pub struct FlowComplex {
    flow: Arc<Flow>,
    pub(super) its: Subdivision,
}

impl FlowComplex {
    /// Makes all of the flow complex.
    ///
    /// Errors: [`Status::LimitExceeded`] for one with more than 2^32 - 1 sides of faces; those of the job. Cost: O(size) besides sorting the points on each Voronoi edge. On scans it has 40 to 120
    /// faces for each sample, and takes 4 to 13 kB; for a core, a manifold or a closure alone ask the [`Flow`].
    pub fn new(flow: &Arc<Flow>, job: &Job) -> Result<Self> {
        job.run(&[(Stage::Flow, 1.0)], |run| {
            run.enter(Stage::Flow)?;
            let source = flow.source()?;
            let mut room = Room::new(run);
            let set = VoronoiSet::filled(&source, true, &mut room)?;
            let its = Subdivision::new(&source, &set, &mut room, run)?;
            Ok(FlowComplex { flow: flow.clone(), its })
        })
    }

    /// The flow.
    pub fn flow(&self) -> &Arc<Flow> {
        &self.flow
    }

    /// The number of vertices.
    pub fn vertex_count(&self) -> usize {
        self.its.edge_of_vertex.len()
    }

    /// The points on Voronoi edges: the vertices that come after the Voronoi vertices.
    pub fn points(&self) -> &[[f64; 3]] {
        &self.its.points
    }

    /// The triangle on whose Voronoi edge each of these points lies.
    pub fn triangle_of_point(&self) -> &[u32] {
        &self.its.triangle_of_point
    }

    /// The two ends of each edge; [`NONE`] at infinity. Orbits run from the first to the second end of a cut.
    pub fn edges(&self) -> &[[u32; 2]] {
        &self.its.edges
    }

    /// The triangle whose Voronoi edge each edge is a part of; the edges beyond these are cuts.
    pub fn triangle_of_edge(&self) -> &[u32] {
        &self.its.triangle_of_edge
    }

    /// The vertices of each face, counterclockwise seen from the second end of its facet's dual edge; [`NONE`] at infinity.
    pub fn faces(&self) -> &Rows {
        &self.its.rim_vertices
    }

    /// The edges of each face, in rows as [`FlowComplex::faces`]: at the place of a vertex the edge that begins there.
    pub fn face_edges(&self) -> &[u32] {
        &self.its.rim_edges
    }

    /// Where the faces of each Voronoi facet begin; one entry more than facets.
    pub fn faces_of_facet(&self) -> &[u32] {
        &self.its.faces_of_facet
    }

    /// The edge into which each vertex flows; [`NONE`] for critical points.
    pub fn edge_of_vertex(&self) -> &[u32] {
        &self.its.edge_of_vertex
    }

    /// The face into which each edge flows; [`NONE`] for those that flow along themselves.
    pub fn face_of_edge(&self) -> &[u32] {
        &self.its.face_of_edge
    }

    /// The elements that can be reached from some, these included, ascending: their flow closure.
    ///
    /// Errors: [`Status::InvalidArgument`] for an element that is not there; those of the job. Cost: O(size of the complex).
    pub fn closure(&self, elements: &[FlowElement], job: &Job) -> Result<Vec<FlowElement>> {
        job.run(&[(Stage::Query, 1.0)], |run| {
            run.enter(Stage::Query)?;
            self.check(elements)?;
            let mut room = Room::new(run);
            let mut closure = Subset::new(&self.its, &mut room)?;
            closure.add(&self.its, elements.iter().copied(), None, &mut room, run)?;
            closure.list(&mut room, run)
        })
    }

    /// The elements from which some can be reached, these included, ascending.
    ///
    /// Errors and cost: as [`FlowComplex::closure`].
    pub fn upstream(&self, elements: &[FlowElement], job: &Job) -> Result<Vec<FlowElement>> {
        job.run(&[(Stage::Query, 1.0)], |run| {
            run.enter(Stage::Query)?;
            self.check(elements)?;
            let mut room = Room::new(run);
            let upstream = Upstream::new(&self.its, &mut room, run)?;
            let mut set = Subset::new(&self.its, &mut room)?;
            upstream.add_to(&mut set, elements.iter().copied(), &mut room, run)?;
            set.list(&mut room, run)
        })
    }

    /// The critical points in whose unstable manifolds each of some elements lies, as rows of [`CriticalPoints`](super::CriticalPoints), ascending.
    ///
    /// Errors: as [`FlowComplex::closure`]. Cost: O(size of the complex), and for each element O(size) of what is upstream of it.
    pub fn critical_sets(&self, elements: &[FlowElement], job: &Job) -> Result<Rows> {
        job.run(&[(Stage::Query, 1.0)], |run| {
            run.enter(Stage::Query)?;
            self.check(elements)?;
            let mut room = Room::new(run);
            let upstream = Upstream::new(&self.its, &mut room, run)?;
            let mut seen = Subset::new(&self.its, &mut room)?;
            let (mut waiting, mut reached) = (Vec::new(), Vec::new());
            let mut sets = Rows::default();
            for element in run.watch(elements) {
                let &element = element?;
                room.push(&mut waiting, element)?;
                let mut steps = 0;
                while let Some(element) = waiting.pop() {
                    steps += 1;
                    if steps % 4096 == 0 {
                        run.poll()?;
                    }
                    if seen.insert(element) {
                        room.push(&mut reached, element)?;
                        upstream.before(element, &mut waiting, &mut room)?;
                    }
                }
                let mut set = Vec::new();
                for &element in &reached {
                    seen.remove(element);
                    self.add_critical(element, &mut set, &mut room)?;
                }
                reached.clear();
                set.sort_unstable();
                set.dedup();
                sets.push(&set)?;
            }
            Ok(sets)
        })
    }

    /// Adds to a list the critical points whose Voronoi faces an element is a part of.
    fn add_critical(
        &self,
        element: FlowElement,
        list: &mut Vec<u32>,
        room: &mut Room<'_>,
    ) -> Result<()> {
        let its = &self.its;
        let face = match element {
            FlowElement::Vertex(v)
                if (v as usize) < its.edge_of_vertex.len() - its.points.len() =>
            {
                Simplex::Cell(v)
            }
            FlowElement::Edge(e) if (e as usize) < its.triangle_of_edge.len() => {
                Simplex::Triangle(its.triangle_of_edge[e as usize])
            }
            FlowElement::Face(f) => Simplex::Edge(its.facet_of(f)),
            _ => return Ok(()),
        };
        if let Simplex::Edge(_) = face {
            let corners = self.flow.source()?.corners(face);
            room.grow(list, 2)?;
            list.extend_from_slice(&corners[..2]);
        }
        if let Some(row) = self.flow.critical.row_of(face) {
            room.push(list, row)?;
        }
        Ok(())
    }

    /// All of it as a complex, with the attributes of [`Core::complex`](super::Core::complex), but for what is unbounded.
    ///
    /// Errors: those of the job. Cost: O(size).
    pub fn complex(&self, job: &Job) -> Result<Complex> {
        job.run(&[(Stage::Extract, 1.0)], |run| {
            run.enter(Stage::Extract)?;
            let mut room = Room::new(run);
            let all = Subset::filled(&self.its, true, &mut room)?;
            Ok(self.flow.complex_of(&self.its, &all, run)?.0)
        })
    }

    /// The elements of a Voronoi facet, edge or vertex.
    ///
    /// Errors: [`Status::InvalidArgument`] for one that is not there, and for a Voronoi cell.
    pub fn elements_of(&self, face: Simplex) -> Result<Vec<FlowElement>> {
        self.flow.check_face(face)?;
        if let Simplex::Sample(_) = face {
            let message = "a Voronoi cell is made of no elements of the flow complex";
            return Err(Error::new(Status::InvalidArgument, message));
        }
        Ok(self.its.elements_of(face).collect())
    }

    fn check(&self, elements: &[FlowElement]) -> Result<()> {
        let its = &self.its;
        let is_there = |element: &FlowElement| match *element {
            FlowElement::Vertex(v) => (v as usize) < its.edge_of_vertex.len(),
            FlowElement::Edge(e) => (e as usize) < its.edges.len(),
            FlowElement::Face(f) => (f as usize) < its.rim_vertices.len(),
        };
        match elements.iter().position(|element| !is_there(element)) {
            None => Ok(()),
            Some(row) => {
                let message = "the flow complex has no such element";
                Err(Error::new(Status::InvalidArgument, message).at(ElementKind::Row, row as u64))
            }
        }
    }
}

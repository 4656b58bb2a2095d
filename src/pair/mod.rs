//! Pair-meshes: solids between an inner structure and their boundary (Shaham, Shamir, Cohen-Or, *Medial axis based solid representation*). See `docs/algorithms/pair.md`.

mod assemble;
mod collapse;
mod contract;
mod deform;
mod export;
mod half_faces;
mod iso;
mod measure;
mod mend;
mod onto;
mod parts;
mod place;
mod reroute;
mod shell;
mod solid;
mod subdivide;
mod surgery;
mod target;
mod validate;

pub use half_faces::HalfFaces;
pub use onto::PairOntoOptions;
pub use place::PairPlace;

use crate::complex::Rows;
use crate::dual::Dual;
use crate::error::{Error, Result, Status};
use crate::job::{Job, Room, Run, Stage};
use crate::labels::Labels;
use crate::vector::Vec3;
use mend::Mended;
use parts::Parts;
use solid::Solid;
use std::sync::Arc;

/// The kinds of elements (Shaham, Shamir, Cohen-Or, figure 1). The numbers are the C ABI's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum PairElement {
    /// A pyramid with a vertex of the boundary over a face of the inner structure.
    FaceVertex = 1,
    /// A tetrahedron between an edge of the inner structure and one of the boundary.
    EdgeEdge = 2,
    /// A tetrahedron with a vertex of the inner structure over a triangle of the boundary.
    VertexFace = 3,
}

/// Why a face or a loose edge of the inner structure is there. The numbers are the C ABI's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum PairReason {
    /// It was asked for.
    Asked = 0,
    /// None of its edges, or ends, is free: it closes a hole of what was asked for, joins parts of it, or lies behind what stays.
    Enclosed = 1,
    /// Something of it is free, but without it an element would be folded: some of the boundary would see nothing.
    Unseen = 2,
}

/// A solid in pyramids and tetrahedra, each with some vertices on its boundary and some on an inner structure.
///
/// A *node* pairs a vertex of the boundary with an inner one; an element is a ring of nodes. Of a pyramid these are its apex with each vertex of its base; of an element between two edges, the ends of
/// one with those of the other; of an element over a triangle, its corners with one inner vertex. The nodes and rings are a closed surface, oriented outward, whatever t
/// in (0, 1) puts each node between its inner vertex (t = 0) and its boundary vertex (t = 1).
///
/// Invariants: elements stand by kind, pyramids first; those over both sides of inner face `f` are `2 * f` and `2 * f + 1`, and begin at the same vertex of it. Every two nodes next to each other in a ring are next to each
/// other, the other way round, in one other. Rings of [`PairElement::EdgeEdge`] begin with the two ends of the boundary's edge. No inner vertex is on its own.
#[derive(Clone, Debug)]
pub struct PairMesh {
    boundary: Vec<Vec3>,
    sample_of_boundary: Vec<u32>,
    inner: Vec<Vec3>,
    cell_of_inner: Vec<u32>,
    voronoi: Vec<Vec3>,
    faces: Rows,
    nodes: Vec<[u32; 2]>,
    rings: Rows,
    /// The number of pyramids, and of these and the elements between edges.
    ends: [usize; 2],
    removed: Vec<u32>,
    /// For each inner face why it is there, unless all were asked for; and the loose edges that were not, with reasons.
    reasons: Vec<PairReason>,
    unasked: Vec<([u32; 2], PairReason)>,
    /// How many of the facets and edges asked for it does not have.
    missing: usize,
    /// Whether it is that of all of the inner diagram, as it was built.
    is_whole: bool,
}

impl PairMesh {
    fn empty() -> Self {
        PairMesh {
            boundary: Vec::new(),
            sample_of_boundary: Vec::new(),
            inner: Vec::new(),
            cell_of_inner: Vec::new(),
            voronoi: Vec::new(),
            faces: Rows::default(),
            nodes: Vec::new(),
            rings: Rows::default(),
            ends: [0; 2],
            removed: Vec::new(),
            reasons: Vec::new(),
            unasked: Vec::new(),
            missing: 0,
            is_whole: false,
        }
    }

    /// The pair-mesh between the inner part of the Voronoi diagram and the surface between inner and outer cells (Shaham, Shamir, Cohen-Or, section 3). The dual must have its facets.
    ///
    /// It always succeeds, whatever the labels. Samples of which all cells are inner are removed, and the rest is triangulated anew. Voronoi vertices of cells that share a sphere are one. Where an element would be
    /// folded, inner vertices are moved ([`PairMesh::voronoi_vertices`] tells whence), and facets with such a vertex are divided into triangles round one in their middle. The surface stays as it is.
    ///
    /// Errors: [`Status::Degenerate`] where no cell is inner; [`Status::InvalidArgument`] for a power diagram, or a dual without facets; [`Status::Mismatch`] for labels of another triangulation;
    /// [`Status::LimitExceeded`] past 2^32 - 1 corners; those of the job. Cost: O(size of the dual), besides what is mended.
    pub fn voronoi(dual: &Arc<Dual>, labels: &Labels, job: &Job) -> Result<Self> {
        job.run(&[(Stage::Pair, 1.0)], |run| PairMesh::voronoi_in(dual, labels, run))
    }

    /// [`PairMesh::voronoi`] as a stage of a larger build.
    pub(crate) fn voronoi_in(dual: &Arc<Dual>, labels: &Labels, run: &Run<'_>) -> Result<Self> {
        run.enter(Stage::Pair)?;
        if dual.triangulation().is_weighted() {
            return Err(Error::new(
                Status::InvalidArgument,
                "a pair-mesh needs the dual of a Delaunay triangulation, not of a regular one",
            ));
        }
        if dual.facets().is_none() {
            let message = "the dual was made without its facets";
            return Err(Error::new(Status::InvalidArgument, message));
        }
        labels.check_triangulation(dual.triangulation())?;
        let mut room = Room::new(run);
        let solid = Solid::new(dual, labels, &mut room, run)?;
        let mut parts = Parts::new(&solid, &mut room, run)?;
        loop {
            let mended = Mended::new(&solid.dual, &parts, &mut room, run)?;
            let (mesh, mut apart) = assemble::assemble(&solid, &parts, &mended, &mut room, run)?;
            if apart.is_empty() {
                return Ok(PairMesh { removed: solid.removed, is_whole: true, ..mesh });
            }
            drop(mended);
            // Where a sphere's vertex would be met twice, its cells keep vertices of their own.
            apart.sort_unstable();
            for sphere in 0..parts.sphere.len() {
                if apart.binary_search(&parts.sphere[sphere]).is_ok() {
                    parts.sphere[sphere] = sphere as u32;
                }
            }
        }
    }

    /// The number of elements.
    pub fn element_count(&self) -> usize {
        self.rings.len()
    }

    /// How many elements there are of each kind, in the order of the kinds.
    pub fn counts(&self) -> [usize; 3] {
        let [pyramids, tetrahedra] = self.ends;
        [pyramids, tetrahedra - pyramids, self.rings.len() - tetrahedra]
    }

    /// The kind of an element.
    pub fn kind(&self, element: u32) -> PairElement {
        match element as usize {
            element if element < self.ends[0] => PairElement::FaceVertex,
            element if element < self.ends[1] => PairElement::EdgeEdge,
            _ => PairElement::VertexFace,
        }
    }

    /// The nodes of an element, counterclockwise seen from the boundary.
    pub fn ring(&self, element: u32) -> &[u32] {
        self.rings.row(element as usize)
    }

    /// The nodes of every element.
    pub fn rings(&self) -> &Rows {
        &self.rings
    }

    /// The boundary vertex and the inner vertex of each node.
    pub fn nodes(&self) -> &[[u32; 2]] {
        &self.nodes
    }

    /// The vertices of the boundary, in input units.
    pub fn boundary_vertices(&self) -> &[Vec3] {
        &self.boundary
    }

    /// The sample that each vertex of the boundary is, as a vertex of the triangulation; [`NONE`](crate::NONE) for one by which triangles were divided ([`PairOntoOptions::subdivide`]).
    pub fn sample_of_boundary(&self) -> &[u32] {
        &self.sample_of_boundary
    }

    /// The inner vertices, in input units.
    pub fn inner_vertices(&self) -> &[Vec3] {
        &self.inner
    }

    /// The cell of which each inner vertex is the Voronoi vertex, of several the least; [`NONE`](crate::NONE) for one in the middle of a facet, and throughout where samples were removed.
    pub fn cell_of_inner(&self) -> &[u32] {
        &self.cell_of_inner
    }

    /// Where each inner vertex would be, had nothing been folded: the Voronoi vertices.
    pub fn voronoi_vertices(&self) -> &[Vec3] {
        &self.voronoi
    }

    /// The faces of the inner structure: rings of inner vertices, counterclockwise seen from the apex of the second of their two pyramids.
    pub fn inner_faces(&self) -> &Rows {
        &self.faces
    }

    /// The samples inside the solid, which were removed before it was divided, as vertices of the triangulation, ascending.
    pub fn removed(&self) -> &[u32] {
        &self.removed
    }

    /// Why each face of the inner structure is there; empty where all were asked for, as in [`PairMesh::voronoi`].
    pub fn reasons(&self) -> &[PairReason] {
        &self.reasons
    }

    /// The loose edges of the inner structure that were not asked for, by their ends, ascending, and why they are there.
    pub fn unasked_edges(&self) -> &[([u32; 2], PairReason)] {
        &self.unasked
    }

    /// The number of Voronoi facets and edges asked for that the inner structure does not have: they are of another diagram, outside, or of samples that were removed.
    pub fn missing(&self) -> usize {
        self.missing
    }

    /// The sample at the boundary end of a node.
    fn sample_of(&self, node: u32) -> u32 {
        self.sample_of_boundary[self.nodes[node as usize][0] as usize]
    }

    /// The two ends of a node as vertices: those of the boundary, then the inner ones.
    fn corners(&self, node: u32) -> [u32; 2] {
        let [b, v] = self.nodes[node as usize];
        [b, self.boundary.len() as u32 + v]
    }
}

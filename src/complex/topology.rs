//! What a complex looks like to a topologist.

use super::Complex;
use super::disjoint::DisjointSets;
use super::homology::upper_betti;
use super::skeleton::{Skeleton, filled};
use super::surface::Surface;
use crate::error::Result;
use crate::job::{Job, Run, Stage};

/// The topology of a [`Complex`], told from its indices alone: vertices that merely lie at the same
/// place are different vertices.
///
/// The complex counts as a cell complex, each cell of it once. An edge is a pair of vertices: a
/// side of a face, of a facet of a volume cell, or a loose edge. A face is a ring of vertices, up
/// to where it begins and which way it runs: listed as a face, or a facet of a volume cell, or
/// both. What is listed twice counts once. A vertex that nothing uses is part of the complex too,
/// and a component of its own.
///
/// The fields from `boundary_edges` to `oriented` tell about the *surface*: the listed
/// faces, their sides and corners, without facets that belong to volume cells only.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Topology {
    /// The number of vertices, isolated ones included.
    pub vertices: u64,
    /// The number of vertices that no face, edge or cell uses.
    pub isolated_vertices: u64,
    /// The number of distinct edges.
    pub edges: u64,
    /// The number of distinct faces, facets of volume cells included.
    pub faces: u64,
    /// The number of distinct volume cells.
    pub cells: u64,
    /// The number of connected components, isolated vertices included.
    pub components: u64,
    /// `vertices - edges + faces - cells`.
    pub euler_characteristic: i64,
    /// The number of edges on exactly one side of a face.
    pub boundary_edges: u64,
    /// The number of curves that the boundary edges form. Two boundary edges at a vertex follow each
    /// other where they end the same fan of faces, so that a pinched vertex lies on several curves.
    /// On a surface without non-manifold edges each curve is a closed loop.
    pub boundary_loops: u64,
    /// The number of edges on more than two sides of faces.
    pub nonmanifold_edges: u64,
    /// The number of vertices at which the faces are more than one fan, or one with a
    /// non-manifold edge: neither a disk nor a half disk.
    pub nonmanifold_vertices: u64,
    /// Whether there is a face, and every edge lies on an even number of sides. So a solid's
    /// surface is closed also where parts of it touch along an edge.
    pub closed: bool,
    /// Whether there is a face, and every edge is run by its faces equally often both ways;
    /// boundary edges are free.
    pub oriented: bool,
    /// The genus, summed over the components: (2 components - Euler characteristic - boundary
    /// loops) / 2 of the surface. `None` unless the complex is an orientable manifold surface,
    /// with or without boundary: there must be a face, and no volume cell, no loose edge, no
    /// non-manifold edge or vertex. Isolated vertices do not matter.
    pub genus: Option<u64>,
    /// The Betti numbers b0, b1, b2 over Z/2 of all of the complex, cells included. (b3, which is
    /// 0 for whatever lies in space, is b0 - b1 + b2 minus the Euler characteristic.)
    pub betti: [u64; 3],
}

impl Complex {
    /// The topology of the complex.
    ///
    /// Errors: those of the job, and [`Status::LimitExceeded`](crate::Status::LimitExceeded) past
    /// 2^31 - 1 sides of faces and facets. Cost: close to linear, as long as collapses and
    /// joining faces into sheets leave few sheets that meet along seams; cubic in the number of
    /// those at worst.
    pub fn topology(&self, job: &Job) -> Result<Topology> {
        job.run(&[(Stage::Topology, 1.0)], |run| self.topology_in(run))
    }

    /// What a skeleton takes while it is made and used.
    pub(super) fn skeleton_bytes(&self) -> u64 {
        // Per side of a face or facet: rings twice over, numbering, incidences, sets. Measured.
        let facets: usize = self.cells.iter().map(|cell| 4 * cell.len()).sum();
        let sides = self.faces.indices().len() + facets + self.edges.len();
        48 * sides as u64 + 16 * self.vertices.len() as u64
    }

    /// [`Complex::topology`] as a stage of a larger operation.
    pub(crate) fn topology_in(&self, run: &Run<'_>) -> Result<Topology> {
        run.enter(Stage::Topology)?;
        let _charge = run.charge(self.skeleton_bytes())?;
        let skeleton = Skeleton::new(self, run)?;
        let surface = Surface::new(&skeleton, run)?;
        let (components, isolated) = components(&skeleton, run)?;

        let counts = [
            skeleton.vertex_count as u64,
            skeleton.edges.len() as u64,
            skeleton.face_count() as u64,
            skeleton.cell_count() as u64,
        ];
        let [vertices, edges, faces, cells] = counts;
        let euler = |v: u64, e: u64, f: u64, c: u64| v as i64 - e as i64 + f as i64 - c as i64;
        let euler_characteristic = euler(vertices, edges, faces, cells);
        let [b2, b3] = upper_betti(&skeleton, run)?;
        // The alternating sums of Betti numbers and of counts agree (Euler-Poincaré).
        let b1 = components as i64 + b2 as i64 - b3 as i64 - euler_characteristic;
        debug_assert!(b1 >= 0);

        let loose = (0..skeleton.edges.len()).any(|e| skeleton.sides_of_edge(e).is_empty());
        let is_surface = skeleton.listed > 0 && cells == 0 && !loose;
        let is_manifold = surface.nonmanifold_edges == 0 && surface.nonmanifold_vertices == 0;
        let genus = (is_surface && is_manifold && surface.orientable).then(|| {
            let handles = 2 * (components - isolated) as i64
                - euler(vertices - isolated, edges, faces, 0)
                - surface.boundary_loops as i64;
            (handles / 2) as u64
        });
        Ok(Topology {
            vertices,
            isolated_vertices: isolated,
            edges,
            faces,
            cells,
            components,
            euler_characteristic,
            boundary_edges: surface.boundary_edges,
            boundary_loops: surface.boundary_loops,
            nonmanifold_edges: surface.nonmanifold_edges,
            nonmanifold_vertices: surface.nonmanifold_vertices,
            closed: skeleton.listed > 0 && surface.even,
            oriented: skeleton.listed > 0 && surface.oriented,
            genus,
            betti: [components, b1 as u64, b2],
        })
    }
}

/// The number of components, and how many of them are a vertex that nothing uses.
fn components(skeleton: &Skeleton, run: &Run<'_>) -> Result<(u64, u64)> {
    let mut pieces = DisjointSets::new(skeleton.vertex_count, run)?;
    let mut used = filled(skeleton.vertex_count, false, run)?;
    let mut components = skeleton.vertex_count as u64;
    for (e, &[v, w]) in skeleton.edges.iter().enumerate() {
        if e % (1 << 14) == 0 {
            run.poll()?;
        }
        components -= u64::from(pieces.join(v, w));
        used[v as usize] = true;
        used[w as usize] = true;
    }
    Ok((components, used.iter().filter(|&&used| !used).count() as u64))
}

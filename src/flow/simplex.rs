//! Delaunay simplices and, their duals, Voronoi faces.

use super::source::Source;
use crate::error::Result;
use crate::index::NONE;
use crate::job::Room;
use crate::labels::Labels;
use crate::medial::Side;

/// A Delaunay simplex, or its dual, a face of the Voronoi diagram. In memory it is its dimension, then its number, which the C ABI shows as they lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u32)]
pub enum Simplex {
    /// A sample, by its vertex; a Voronoi cell.
    Sample(u32),
    /// An edge, by the facet of the dual; a Voronoi facet.
    Edge(u32),
    /// A triangle, by its row in [`Flow::triangles`](super::Flow::triangles); a Voronoi edge.
    Triangle(u32),
    /// A cell of the triangulation; a Voronoi vertex.
    Cell(u32),
}

impl Simplex {
    /// The number of the simplex among those of its dimension.
    pub fn number(self) -> u32 {
        let (Simplex::Sample(i) | Simplex::Edge(i) | Simplex::Triangle(i) | Simplex::Cell(i)) =
            self;
        i
    }

    /// The dimension of the simplex; of a critical point the index.
    pub fn dimension(self) -> usize {
        match self {
            Simplex::Sample(_) => 0,
            Simplex::Edge(_) => 1,
            Simplex::Triangle(_) => 2,
            Simplex::Cell(_) => 3,
        }
    }
}

impl Source<'_> {
    /// The samples of a simplex, then [`NONE`].
    pub fn corners(&self, simplex: Simplex) -> [u32; 4] {
        let t = self.dual.triangulation();
        match simplex {
            Simplex::Sample(v) => [v, NONE, NONE, NONE],
            Simplex::Edge(facet) => {
                let [p, q] = self.facets.edges()[facet as usize];
                [p, q, NONE, NONE]
            }
            Simplex::Triangle(triangle) => {
                let [p, q, r] = self.triangles.corners(t, triangle);
                [p, q, r, NONE]
            }
            Simplex::Cell(cell) => t.cells()[cell as usize],
        }
    }
}

impl Source<'_> {
    /// Inner or outer if all cells round a Voronoi face are; what is outside the hull is outer. Both for a face that crosses the surface, as Voronoi cells do.
    pub fn side_of(&self, labels: &Labels, face: Simplex) -> Side {
        let of = |cells: &[u32], is_unbounded| Side::of(labels, cells, is_unbounded);
        match face {
            Simplex::Sample(_) => Side::Both,
            Simplex::Edge(facet) => {
                of(self.facets.ring(facet as usize), self.facets.is_unbounded(facet as usize))
            }
            Simplex::Triangle(triangle) => {
                of(&self.triangles.cells(self.dual.triangulation(), triangle), false)
            }
            Simplex::Cell(cell) => of(&[cell], false),
        }
    }
}

/// A set of Voronoi facets, edges and vertices.
///
/// Invariants: one row for each facet of the dual, each triangle, each cell.
#[derive(Clone, Debug)]
pub(super) struct VoronoiSet {
    pub facets: Vec<bool>,
    pub edges: Vec<bool>,
    pub vertices: Vec<bool>,
    /// Facets that stay in one piece: whatever flows into them is taken to flow to all of them.
    pub whole: Vec<bool>,
}

impl VoronoiSet {
    /// All of them, or none.
    pub fn filled(source: &Source<'_>, value: bool, room: &mut Room<'_>) -> Result<Self> {
        Ok(VoronoiSet {
            facets: room.filled(source.facets.len(), value)?,
            edges: room.filled(source.triangles.len(), value)?,
            vertices: room.filled(source.dual.triangulation().cells().len(), value)?,
            whole: room.filled(source.facets.len(), false)?,
        })
    }

    /// Whether a face is in the set; Voronoi cells never are.
    pub fn has(&self, face: Simplex) -> bool {
        match face {
            Simplex::Sample(_) => false,
            Simplex::Edge(facet) => self.facets[facet as usize],
            Simplex::Triangle(triangle) => self.edges[triangle as usize],
            Simplex::Cell(cell) => self.vertices[cell as usize],
        }
    }

    /// Adds what another set has.
    pub fn unite(&mut self, other: &VoronoiSet) {
        self.combine(other, |its, other| its | other);
        self.whole.iter_mut().zip(&other.whole).for_each(|(its, other)| *its |= other);
    }

    /// Takes off what another set has.
    pub fn subtract(&mut self, other: &VoronoiSet) {
        self.combine(other, |its, other| its & !other);
    }

    fn combine(&mut self, other: &VoronoiSet, with: impl Fn(bool, bool) -> bool) {
        for (its, others) in [
            (&mut self.facets, &other.facets),
            (&mut self.edges, &other.edges),
            (&mut self.vertices, &other.vertices),
        ] {
            its.iter_mut().zip(others).for_each(|(its, &other)| *its = with(*its, other));
        }
    }
}

//! The listed faces of a complex as a surface: its edges, fans, patches and boundary.

use super::disjoint::DisjointSets;
use super::skeleton::{Skeleton, filled};
use crate::error::Result;
use crate::job::Run;

/// The number of steps between two ticks.
const BATCH: usize = 1 << 14;

/// What the listed faces look like as a surface.
pub(super) struct Surface {
    pub(super) boundary_edges: u64,
    pub(super) boundary_loops: u64,
    pub(super) nonmanifold_edges: u64,
    pub(super) nonmanifold_vertices: u64,
    /// Every edge of a listed face lies on an even number of their sides.
    pub(super) even: bool,
    /// Every edge is run equally often both ways, but for the boundary edges.
    pub(super) oriented: bool,
    /// Every patch can be oriented.
    pub(super) orientable: bool,
}

impl Surface {
    /// Looks at every edge and every corner of the listed faces. Cost: linear, nearly.
    pub(super) fn new(skeleton: &Skeleton, run: &Run<'_>) -> Result<Self> {
        let mut patches = Patches::new(skeleton, run)?;
        let mut surface = Surface {
            boundary_edges: 0,
            boundary_loops: 0,
            nonmanifold_edges: 0,
            nonmanifold_vertices: 0,
            even: true,
            oriented: true,
            orientable: true,
        };
        for f in run.watch(0..skeleton.listed as u32) {
            surface.orientable &= patches.orientable(f?);
        }
        let mut fans = Fans::new(skeleton, run)?;
        let mut broken = filled(skeleton.vertex_count, false, run)?;
        for (e, &[v, w]) in skeleton.edges.iter().enumerate() {
            if e % BATCH == 0 {
                run.poll()?;
            }
            let sides = skeleton.listed_sides_of_edge(e);
            let forward = sides.iter().filter(|&&s| skeleton.is_forward(s)).count();
            surface.boundary_edges += u64::from(sides.len() == 1);
            surface.even &= sides.len().is_multiple_of(2);
            surface.oriented &= sides.len() == 1 || 2 * forward == sides.len();
            if sides.len() > 2 {
                surface.nonmanifold_edges += 1;
                broken[v as usize] = true;
                broken[w as usize] = true;
            }
        }
        fans.mark_pinched(skeleton, &mut broken, run)?;
        surface.nonmanifold_vertices = broken.iter().filter(|&&b| b).count() as u64;
        surface.boundary_loops = fans.count_loops(skeleton, run)?;
        Ok(surface)
    }
}

/// Faces joined across the edges that exactly two sides share, with the way each must turn.
///
/// Node `2f` stands for listed face `f` as it is, `2f + 1` for the face turned round: joined nodes
/// agree across every edge that joins them.
pub(super) struct Patches {
    nodes: DisjointSets,
}

impl Patches {
    pub(super) fn new(skeleton: &Skeleton, run: &Run<'_>) -> Result<Self> {
        let mut nodes = DisjointSets::new(2 * skeleton.listed, run)?;
        for e in 0..skeleton.edges.len() {
            if e % BATCH == 0 {
                run.poll()?;
            }
            let &[s, t] = skeleton.listed_sides_of_edge(e) else { continue };
            let (f, g) = (skeleton.face_of_side[s as usize], skeleton.face_of_side[t as usize]);
            // Neighbours agree where they run their common edge in opposite directions.
            let turned = u32::from(skeleton.is_forward(s) == skeleton.is_forward(t));
            nodes.join(2 * f, 2 * g + turned);
            nodes.join(2 * f + 1, 2 * g + 1 - turned);
        }
        Ok(Patches { nodes })
    }

    /// The patch of a face, by its least face, and whether the face must turn to agree with that one.
    pub(super) fn of(&mut self, face: u32) -> (u32, bool) {
        let root = self.nodes.root(2 * face);
        (root / 2, root % 2 == 1)
    }

    /// Whether a face is not joined to itself turned round.
    pub(super) fn orientable(&mut self, face: u32) -> bool {
        self.nodes.root(2 * face) != self.nodes.root(2 * face + 1)
    }
}

/// The fans of faces round each vertex, as sets of edge ends.
///
/// End `2e` is the end of edge `e` at its lesser vertex, `2e + 1` the other. The corner of a face
/// joins the ends of its two edges there.
struct Fans {
    ends: DisjointSets,
}

impl Fans {
    fn new(skeleton: &Skeleton, run: &Run<'_>) -> Result<Self> {
        let mut ends = DisjointSets::new(2 * skeleton.edges.len(), run)?;
        for f in 0..skeleton.listed {
            if f % BATCH == 0 {
                run.poll()?;
            }
            let sides = skeleton.sides(f);
            for out in sides.clone() {
                let into = if out == sides.start { sides.end - 1 } else { out - 1 };
                let (out, into) = (out as u32, into as u32);
                let end = |s: u32, forward: bool| {
                    2 * skeleton.edge_of_side[s as usize] + u32::from(!forward)
                };
                ends.join(
                    end(out, skeleton.is_forward(out)),
                    end(into, !skeleton.is_forward(into)),
                );
            }
        }
        Ok(Fans { ends })
    }

    /// Marks the vertices that are in more than one fan.
    fn mark_pinched(
        &mut self,
        skeleton: &Skeleton,
        broken: &mut [bool],
        run: &Run<'_>,
    ) -> Result<()> {
        let mut seen = filled(skeleton.vertex_count, false, run)?;
        for e in run.watch(0..skeleton.edges.len()) {
            let e = e?;
            if skeleton.listed_sides_of_edge(e).is_empty() {
                continue;
            }
            for (i, &v) in skeleton.edges[e].iter().enumerate() {
                let end = (2 * e + i) as u32;
                if self.ends.root(end) == end {
                    broken[v as usize] |= seen[v as usize];
                    seen[v as usize] = true;
                }
            }
        }
        Ok(())
    }

    /// The number of boundary curves: boundary edges are joined where one fan has both.
    fn count_loops(&mut self, skeleton: &Skeleton, run: &Run<'_>) -> Result<u64> {
        let mut curves = DisjointSets::new(skeleton.edges.len(), run)?;
        // For each fan, under its root, a boundary edge that begins or ends it.
        let mut edge_of_fan = filled(2 * skeleton.edges.len(), u32::MAX, run)?;
        let mut loops = 0;
        for e in run.watch(0..skeleton.edges.len() as u32) {
            let e = e?;
            if skeleton.listed_sides_of_edge(e as usize).len() != 1 {
                continue;
            }
            loops += 1;
            for end in [2 * e, 2 * e + 1] {
                let other = &mut edge_of_fan[self.ends.root(end) as usize];
                if *other == u32::MAX {
                    *other = e;
                } else {
                    loops -= u64::from(curves.join(e, *other));
                }
            }
        }
        Ok(loops)
    }
}

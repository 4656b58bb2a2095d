//! The pair-mesh of a filtered inner structure: a medial axis, a core (Shaham, Shamir, Cohen-Or, section 4).

use super::collapse::Collapse;
use super::shell::{Kind, Shell};
use super::target::Target;
use super::{PairMesh, PairReason};
use crate::complex::Complex;
use crate::error::{ElementKind, Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use std::collections::BTreeMap;

/// How a pair-mesh is brought onto a part of its inner structure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PairOntoOptions {
    /// Divide triangles of the boundary round their centroids, at the middles of their edges, where no more goes without (section 4). The boundary stays where it is, but has more vertices. Where it touches itself in an edge, the sheets there may be divided at different vertices. Off by default.
    pub subdivide: bool,
    /// Fail where anything stays that was not asked for, or what was is not there. Off by default.
    pub exact: bool,
}

impl PairMesh {
    /// The pair-mesh of a part of the inner structure: that in which a complex of Voronoi faces lies, such as the axis of a [`Medial`](crate::Medial), or a core, extended or not
    /// ([`Core::complex`](crate::flow::Core::complex)), of the same samples. Of its faces and loose edges only the attribute `samples` counts.
    ///
    /// What is not asked for is collapsed, bit by bit, as long as no element gets folded. So it always succeeds: where no more can go, the rest stays, and [`PairMesh::reasons`] tells what stood in the
    /// way. The search is local, so that another order might leave less. Faces that stay unasked are triangles, and their corners may have moved into others. What was asked for and is not there counts in
    /// [`PairMesh::missing`].
    ///
    /// Errors: [`Status::InvalidArgument`] for faces or loose edges without `samples`, or if this is a part already, or deformed; [`Status::Degenerate`] if it is to be `exact` and something is missing, or stays unasked: then with the first such face; [`Status::LimitExceeded`] past
    /// 2^32 - 2 sides; those of the job. Cost: O(size log size) where few changes are refused.
    pub fn onto(&self, part: &Complex, options: PairOntoOptions, job: &Job) -> Result<PairMesh> {
        job.run(&[(Stage::Pair, 1.0)], |run| self.onto_in(part, options, run))
    }

    /// [`PairMesh::onto`] as a stage of a larger build.
    pub(crate) fn onto_in(
        &self,
        part: &Complex,
        options: PairOntoOptions,
        run: &Run<'_>,
    ) -> Result<PairMesh> {
        run.enter(Stage::Pair)?;
        if !self.is_whole {
            let message = "only the pair-mesh of all of the inner Voronoi diagram, as it was built, can be brought onto a part of it";
            return Err(Error::new(Status::InvalidArgument, message));
        }
        let mut room = Room::new(run);
        let target = Target::new(self, part, &mut room, run)?;
        let shell = Shell::new(self, &|face| target.is_asked(face), &mut room, run)?;
        let shell = Collapse::run(shell, &target, options.subdivide, run)?;
        let mesh = self.assembled(&shell, &target, &mut room, run)?;
        match options.exact {
            true => mesh.check_exact(),
            false => Ok(mesh),
        }
    }

    /// This mesh, unless something in it was not asked for.
    fn check_exact(self) -> Result<PairMesh> {
        if self.missing > 0 {
            let message = format!(
                "{} of the Voronoi facets and edges asked for are not in the inner structure",
                self.missing
            );
            return Err(Error::new(Status::Degenerate, message));
        }
        let faces = self.reasons.iter().filter(|&&reason| reason != PairReason::Asked).count();
        let edges = self.unasked.len();
        let why = |reason: &PairReason| match reason {
            PairReason::Unseen => "without it an element would be folded",
            _ => "none of its edges or ends is free",
        };
        let counts = format!("{faces} faces and {edges} loose edges stay that were not asked for");
        if let Some(face) = self.reasons.iter().position(|&reason| reason != PairReason::Asked) {
            let [a, b] = [2 * face, 2 * face + 1]
                .map(|element| self.sample_of(self.ring(element as u32)[0]));
            let why = why(&self.reasons[face]);
            let message = format!(
                "{counts}; the first is of the Voronoi facet between samples {a} and {b}: {why}"
            );
            return Err(Error::new(Status::Degenerate, message).at(ElementKind::Face, face as u64));
        }
        if let Some(([v, w], reason)) = self.unasked.first() {
            let [v, w] = [v, w].map(|&v| self.inner[v as usize]);
            let message = format!("{counts}; the first is from {v:?} to {w:?}: {}", why(reason));
            return Err(Error::new(Status::Degenerate, message).at(ElementKind::Edge, 0));
        }
        Ok(self)
    }

    /// What is left of this pair-mesh.
    fn assembled(
        &self,
        shell: &Shell<'_>,
        target: &Target,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<PairMesh> {
        let mut mesh = PairMesh { missing: target.missing, ..PairMesh::empty() };
        mesh.boundary = room.collect(self.boundary.iter().copied())?;
        mesh.sample_of_boundary = room.collect(self.sample_of_boundary.iter().copied())?;
        mesh.removed = room.collect(self.removed.iter().copied())?;
        for &place in shell.added() {
            room.push(&mut mesh.boundary, place)?;
            room.push(&mut mesh.sample_of_boundary, NONE)?;
        }
        let mut its = Assembly {
            from: self,
            shell,
            mesh,
            node: room.filled(shell.node_count(), NONE)?,
            vertex: room.filled(self.inner.len(), NONE)?,
        };
        let mut loose = BTreeMap::new();
        for kind in [Kind::Pyramid, Kind::Between, Kind::Over] {
            for element in 0..shell.element_count() {
                run.poll()?;
                if shell.kind(element) != kind {
                    continue;
                }
                match kind {
                    Kind::Pyramid => its.add_face(element, target, room)?,
                    _ => _ = its.add(its.first(element), room)?,
                }
                if kind == Kind::Between {
                    its.note_loose(element, target, &mut loose, room)?;
                }
            }
            match kind {
                Kind::Pyramid => its.mesh.ends[0] = its.mesh.rings.len(),
                Kind::Between => its.mesh.ends[1] = its.mesh.rings.len(),
                _ => {}
            }
        }
        its.mesh.unasked = room.collect(loose.into_iter())?;
        Ok(its.mesh)
    }
}

struct Assembly<'a> {
    from: &'a PairMesh,
    shell: &'a Shell<'a>,
    mesh: PairMesh,
    /// The new numbers of nodes and inner vertices.
    node: Vec<u32>,
    vertex: Vec<u32>,
}

impl Assembly<'_> {
    /// The side with which the ring of an element begins.
    fn first(&self, element: u32) -> u32 {
        let first = self.shell.first(element);
        let is_along_inner =
            self.shell.kind(element) == Kind::Between && self.shell.is_along_inner(first);
        if is_along_inner { self.shell.side(first).next } else { first }
    }

    /// Notes the inner edge of an element between edges, if no face has it, and nobody asked for it.
    fn note_loose(
        &self,
        element: u32,
        target: &Target,
        loose: &mut BTreeMap<[u32; 2], PairReason>,
        room: &mut Room<'_>,
    ) -> Result<()> {
        let Some(edge) = self.shell.loose_edge(element) else { return Ok(()) };
        let mut ends = edge.map(|v| self.vertex[v as usize]);
        ends.sort_unstable();
        if target.is_edge_asked(edge) || loose.contains_key(&ends) {
            return Ok(());
        }
        let side = self.first(element);
        let is_free = [side, self.shell.opposite(side)].iter().any(|&at| self.shell.is_end(at));
        room.keep(2 * size_of::<([u32; 2], PairReason)>())?;
        loose.insert(ends, if is_free { PairReason::Unseen } else { PairReason::Enclosed });
        Ok(())
    }

    /// Adds an element by its ring, which is returned.
    fn add(&mut self, first: u32, room: &mut Room<'_>) -> Result<Vec<u32>> {
        let mut ring = Vec::new();
        for side in self.shell.ring_from(first) {
            let node = self.shell.side(side).node as usize;
            if self.node[node] == NONE {
                let [b, v] = self.shell.node(node as u32);
                let v = v as usize;
                if self.vertex[v] == NONE {
                    self.vertex[v] = self.mesh.inner.len() as u32;
                    room.push(&mut self.mesh.inner, self.from.inner[v])?;
                    room.push(&mut self.mesh.voronoi, self.from.voronoi[v])?;
                    room.push(&mut self.mesh.cell_of_inner, self.from.cell_of_inner[v])?;
                }
                self.node[node] = self.mesh.nodes.len() as u32;
                room.push(&mut self.mesh.nodes, [b, self.vertex[v]])?;
            }
            ring.push(self.node[node]);
        }
        room.keep(size_of::<u32>() * (ring.len() + 1))?;
        self.mesh.rings.push(&ring)?;
        Ok(ring)
    }

    /// Adds both pyramids of a face, for the lesser of the two.
    fn add_face(&mut self, element: u32, target: &Target, room: &mut Room<'_>) -> Result<()> {
        let first = self.shell.first(element);
        // Both rings begin at the same corner.
        let other = self.shell.side(self.shell.side(first).partner).next;
        if self.shell.side(other).element < element {
            return Ok(());
        }
        self.add(first, room)?;
        let ring = self.add(other, room)?;
        let face: Vec<u32> = ring.iter().map(|&node| self.mesh.nodes[node as usize][1]).collect();
        room.keep(size_of::<u32>() * (face.len() + 1))?;
        self.mesh.faces.push(&face)?;
        let is_free = |side: &u32| self.shell.strip(*side).is_some();
        let reason = match target.is_asked(self.shell.face(element)) {
            true => PairReason::Asked,
            false if self.shell.sides_of(element).iter().any(is_free) => PairReason::Unseen,
            false => PairReason::Enclosed,
        };
        room.push(&mut self.mesh.reasons, reason)
    }
}

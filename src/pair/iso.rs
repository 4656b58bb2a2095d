//! The surfaces between the inner structure and the boundary, and the sides that elements share.

use super::PairMesh;
use crate::complex::{Attribute, Complex, ComplexParts, DisjointSets, Element, Values};
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};

impl PairMesh {
    /// The surface on which each node is so far on the way from its inner vertex to its boundary vertex: t in [0, 1].
    ///
    /// For t below 1 its vertices are the nodes and its faces the elements' rings, the same for every t; for t = 0 it is the wrapping of the inner structure, whose two sides coincide. For t = 1 it is the boundary itself, vertex for
    /// vertex. Faces are planar (but for rounding) and convex: parallel to the base of a pyramid, or to a triangle of the boundary; or parallelograms. Vertices carry `sample`
    /// and `inner_vertex` ([`NONE`] where there is none); faces `element` and `kind`.
    ///
    /// Errors: [`Status::InvalidArgument`] for another t; those of the job. Cost: O(size).
    pub fn iso_surface(&self, t: f64, job: &Job) -> Result<Complex> {
        job.run(&[(Stage::Extract, 1.0)], |run| {
            run.enter(Stage::Extract)?;
            self.iso_surface_in(t, run)
        })
    }

    pub(crate) fn iso_surface_in(&self, t: f64, run: &Run<'_>) -> Result<Complex> {
        if !(0.0..=1.0).contains(&t) {
            return Err(Error::new(
                Status::InvalidArgument,
                format!("t = {t} is not between 0 and 1"),
            ));
        }
        if t == 1.0 {
            return self.boundary_in(run);
        }
        let mut room = Room::new(run);
        let place = |&[b, v]: &[u32; 2]| {
            let (from, to) = (self.inner[v as usize], self.boundary[b as usize]);
            std::array::from_fn(|k| from[k] * (1.0 - t) + to[k] * t)
        };
        let of_nodes = |room: &mut Room<'_>, of: &dyn Fn([u32; 2]) -> u32| -> Result<Values> {
            Ok(Values::U32(room.collect(self.nodes.iter().map(|&node| of(node)))?))
        };
        let samples = of_nodes(&mut room, &|[b, _]| self.sample_of_boundary[b as usize])?;
        let inner = of_nodes(&mut room, &|[_, v]| v)?;
        let elements = room.collect(0..self.element_count() as u32)?;
        let kinds = room.collect((0..self.element_count() as u32).map(|e| self.kind(e) as u32))?;
        room.keep(4 * (self.rings.indices().len() + self.rings.len() + 1))?;
        let parts = ComplexParts {
            vertices: room.collect(self.nodes.iter().map(place))?,
            faces: self.rings.clone(),
            attributes: vec![
                Attribute::new("sample", Element::Vertex, 1, samples)?,
                Attribute::new("inner_vertex", Element::Vertex, 1, inner)?,
                Attribute::new("element", Element::Face, 1, Values::U32(elements))?,
                Attribute::new("kind", Element::Face, 1, Values::U32(kinds))?,
            ],
            ..ComplexParts::default()
        };
        Complex::sound_in(parts, run)
    }

    /// For each side of each ring, from a node to the next, the element on the other side, and the number of the side there; [`NONE`] twice where there is none.
    pub(super) fn sides(&self, room: &mut Room<'_>, run: &Run<'_>) -> Result<Vec<[u32; 2]>> {
        let count = self.rings.indices().len();
        // The sides that begin at each node.
        let mut offsets = room.filled(self.nodes.len() + 1, 0u32)?;
        for item in run.watch(self.rings.indices()) {
            let &node = item?;
            offsets[node as usize + 1] += 1;
        }
        for i in 0..self.nodes.len() {
            offsets[i + 1] += offsets[i];
        }
        let mut next = room.collect(offsets.iter().copied())?;
        let mut leaving = room.filled(count, [NONE; 3])?;
        for item in run.watch((0u32..).zip(self.rings.iter())) {
            let (element, ring) = item?;
            let ends = ring.iter().zip(ring.iter().cycle().skip(1));
            for (side, (&from, &to)) in (0u32..).zip(ends) {
                leaving[next[from as usize] as usize] = [to, element, side];
                next[from as usize] += 1;
            }
        }
        let mut sides = room.vec(count)?;
        for item in run.watch(self.rings.iter()) {
            let ring = item?;
            for (&from, &to) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                let of_end = offsets[to as usize] as usize..offsets[to as usize + 1] as usize;
                let across = leaving[of_end].iter().find(|&&[end, ..]| end == from);
                sides.push(across.map_or([NONE; 2], |&[_, element, side]| [element, side]));
            }
        }
        Ok(sides)
    }

    /// For each element the number of its shell: of the closed surface that it is a face of for every t. Errors: those of the job. Cost: O(size).
    pub fn shells(&self, job: &Job) -> Result<Vec<u32>> {
        job.run(&[(Stage::Extract, 1.0)], |run| {
            run.enter(Stage::Extract)?;
            let mut room = Room::new(run);
            let mut of_nodes = DisjointSets::new(self.nodes.len(), run)?;
            for item in run.watch(self.rings.iter()) {
                let ring = item?;
                ring.iter().for_each(|&node| _ = of_nodes.join(ring[0], node));
            }
            let mut number = room.filled(self.nodes.len(), NONE)?;
            let (mut shells, mut count) = (room.vec(self.element_count())?, 0);
            for item in run.watch(self.rings.iter()) {
                let ring = item?;
                let shell = &mut number[of_nodes.root(ring[0]) as usize];
                if *shell == NONE {
                    *shell = count;
                    count += 1;
                }
                shells.push(*shell);
            }
            Ok(shells)
        })
    }
}

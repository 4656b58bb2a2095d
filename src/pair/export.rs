//! Complexes from a pair-mesh: the solid, its boundary, the inner structure.

use super::target::samples_of_edges;
use super::{PairElement, PairMesh, PairReason};
use crate::complex::{Attribute, CellType, Complex, ComplexParts, Element, Rows, Values};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use crate::vector::{length, sub};
use std::collections::HashSet;

impl PairMesh {
    /// The solid as cells: tetrahedra, and pyramids over faces of more than three corners.
    ///
    /// Vertices are those of the boundary, then the inner ones, with `t` (1 on the boundary, 0 inside: a host that cuts cells where t has a value gets the surface of that t) and `sample`; cells are the elements, with `kind` and `volume`. Errors: those of the job. Cost: O(size).
    pub fn solid(&self, job: &Job) -> Result<Complex> {
        job.run(&[(Stage::Extract, 1.0)], |run| {
            run.enter(Stage::Extract)?;
            self.solid_in(run)
        })
    }

    pub(crate) fn solid_in(&self, run: &Run<'_>) -> Result<Complex> {
        let mut room = Room::new(run);
        let (outer, all) = (self.boundary.len(), self.boundary.len() + self.inner.len());
        let vertices = room.collect((0..all as u32).map(|v| self.place_of(v)))?;
        let on_boundary = room.collect((0..all).map(|v| f64::from(v < outer)))?;
        let of_vertex = |v: usize| self.sample_of_boundary.get(v).copied().unwrap_or(NONE);
        let samples = room.collect((0..all).map(of_vertex))?;
        let mut cells = Rows::default();
        let mut cell_types = room.vec(self.element_count())?;
        let (mut kinds, mut volumes) =
            (room.vec(self.element_count())?, room.vec(self.element_count())?);
        room.keep(4 * (2 * self.rings.indices().len() + self.element_count()))?;
        for element in run.watch(0..self.element_count() as u32) {
            let element = element?;
            let ring = self.ring(element);
            if self.kind(element) == PairElement::FaceVertex && ring.len() > 3 {
                let apex = self.nodes[ring[0] as usize][0];
                let base = ring.iter().map(|&node| self.corners(node)[1]);
                cells.push(&base.chain([apex]).collect::<Vec<_>>())?;
                cell_types.push(match ring.len() {
                    4 => CellType::Pyramid,
                    _ => CellType::PolygonalPyramid,
                });
            } else {
                cells.push(&self.piece(element, 0))?;
                cell_types.push(CellType::Tetrahedron);
            }
            kinds.push(self.kind(element) as u32);
            volumes.push(self.volume_and_moment(element).0);
        }
        let parts = ComplexParts {
            vertices,
            cells,
            cell_types,
            attributes: vec![
                Attribute::new("t", Element::Vertex, 1, Values::F64(on_boundary))?,
                Attribute::new("sample", Element::Vertex, 1, Values::U32(samples))?,
                Attribute::new("kind", Element::Cell, 1, Values::U32(kinds))?,
                Attribute::new("volume", Element::Cell, 1, Values::F64(volumes))?,
            ],
            ..ComplexParts::default()
        };
        Complex::sound_in(parts, run)
    }

    /// The boundary: triangles that point out of the solid. Vertices carry `sample`, faces `element`. Errors: those of the job. Cost: O(size).
    pub fn boundary(&self, job: &Job) -> Result<Complex> {
        job.run(&[(Stage::Extract, 1.0)], |run| {
            run.enter(Stage::Extract)?;
            self.boundary_in(run)
        })
    }

    pub(super) fn boundary_in(&self, run: &Run<'_>) -> Result<Complex> {
        let mut room = Room::new(run);
        let elements = self.ends[1] as u32..self.element_count() as u32;
        let triangle = |element: u32| {
            let [_, p, q, r] = self.piece(element, 0);
            [p, q, r]
        };
        let triangles = room.collect(elements.clone().map(triangle))?;
        let samples = room.collect(self.sample_of_boundary.iter().copied())?;
        let parts = ComplexParts {
            vertices: room.collect(self.boundary.iter().copied())?,
            faces: Rows::uniform_in(triangles, &mut room)?,
            attributes: vec![
                Attribute::new("sample", Element::Vertex, 1, Values::U32(samples))?,
                Attribute::new("element", Element::Face, 1, Values::U32(room.collect(elements)?))?,
            ],
            ..ComplexParts::default()
        };
        Complex::sound_in(parts, run)
    }

    /// The inner structure: its faces, and the edges that belong to none. Vertices carry `cell` (of which they are the Voronoi vertex, the least of several; or [`NONE`]) and
    /// `moved` (how far from there they are, in input units); faces `samples` (those of their two pyramids); loose edges `samples` (the least three of those round them); faces and edges `reason` ([`PairReason`]). Errors: those of the job. Cost: O(size).
    pub fn inner(&self, job: &Job) -> Result<Complex> {
        job.run(&[(Stage::Extract, 1.0)], |run| {
            run.enter(Stage::Extract)?;
            self.inner_in(run)
        })
    }

    pub(crate) fn inner_in(&self, run: &Run<'_>) -> Result<Complex> {
        let mut room = Room::new(run);
        let mut edges = HashSet::new();
        for item in run.watch(self.rings.iter()) {
            let ring = item?;
            for (&m, &n) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                let [v, w] = [m, n].map(|node| self.nodes[node as usize][1]);
                if v < w {
                    edges.insert([v, w]);
                }
            }
        }
        for item in run.watch(self.faces.iter()) {
            let face = item?;
            for (&v, &w) in face.iter().zip(face.iter().cycle().skip(1)) {
                edges.remove(&[v.min(w), v.max(w)]);
            }
        }
        let mut edges = room.collect(edges.into_iter())?;
        edges.sort_unstable();
        let cells = room.collect(self.cell_of_inner.iter().copied())?;
        let moved = self.inner.iter().zip(&self.voronoi).map(|(&p, &q)| length(sub(p, q)));
        let moved = room.collect(moved)?;
        let asked = [PairReason::Asked].into_iter().cycle().take(self.faces.len());
        let of_faces = self.reasons.iter().copied().chain(asked).take(self.faces.len());
        let mut face_reasons = room.vec(self.faces.len())?;
        face_reasons.extend(of_faces.map(|reason| reason as u32));
        let reason_of = |edge: &[u32; 2]| {
            let found = self.unasked.binary_search_by_key(edge, |&(edge, _)| edge);
            found.map_or(PairReason::Asked, |i| self.unasked[i].1) as u32
        };
        let edge_reasons = room.collect(edges.iter().map(reason_of))?;
        let round = samples_of_edges(self, &mut room, run)?;
        let mut samples_of_loose = room.vec(3 * edges.len())?;
        for edge in &edges {
            let its = round.get(edge).into_iter().flatten().copied();
            samples_of_loose.extend(its.chain([NONE; 3]).take(3));
        }
        let apexes = (0..self.ends[0] as u32).map(|element| self.sample_of(self.ring(element)[0]));
        let samples = room.collect(apexes)?;
        room.keep(4 * (self.faces.indices().len() + self.faces.len() + 1))?;
        let parts = ComplexParts {
            vertices: room.collect(self.inner.iter().copied())?,
            faces: self.faces.clone(),
            edges,
            attributes: vec![
                Attribute::new("cell", Element::Vertex, 1, Values::U32(cells))?,
                Attribute::new("moved", Element::Vertex, 1, Values::F64(moved))?,
                Attribute::new("samples", Element::Face, 2, Values::U32(samples))?,
                Attribute::new("samples", Element::Edge, 3, Values::U32(samples_of_loose))?,
                Attribute::new("reason", Element::Face, 1, Values::U32(face_reasons))?,
                Attribute::new("reason", Element::Edge, 1, Values::U32(edge_reasons))?,
            ],
            ..ComplexParts::default()
        };
        Complex::sound_in(parts, run)
    }
}

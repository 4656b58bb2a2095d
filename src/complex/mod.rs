//! The one output type: vertices, polygons, loose edges, volume cells, named attributes.

mod answers;
mod attribute;
mod closest;
mod compare;
mod decimate;
mod disjoint;
mod flatten;
mod hierarchy;
mod homology;
mod intersections;
mod measure;
mod normals;
mod orient;
mod rows;
mod skeleton;
mod surface;
mod topology;
mod triangulated;
mod validate;
mod winding;

pub(crate) use answers::{answers, try_answers};
pub use attribute::{Attribute, Element, Values};
pub use compare::{CompareOptions, Comparison, Distances, compare};
pub use decimate::DecimateOptions;
pub(crate) use disjoint::DisjointSets;
pub(crate) use flatten::flatness;
pub use flatten::{FlattenOptions, Flattened};
pub(crate) use hierarchy::{Hierarchy, Simplex};
pub use measure::Measure;
pub use rows::Rows;
pub use topology::Topology;

use crate::error::{ElementKind, Error, Result, Status};
use crate::job::{Job, Room, Run};
use validate::{cell_problem, edge_problem, face_problem, vertex_problem};

/// A position in space.
type Point = [f64; 3];

/// The shape of a volume cell. The numbers are the C ABI's; the order of the vertices is VTK's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum CellType {
    /// Four vertices.
    Tetrahedron = 1,
    /// A quadrilateral base, then the apex: five vertices.
    Pyramid = 2,
    /// A polygonal base of any size, then the apex.
    PolygonalPyramid = 3,
}

/// Vertices, faces, loose edges and volume cells, with named attributes on each.
///
/// Invariants: every coordinate is finite, every index below the number of vertices; a face has at
/// least three vertices, and no vertex twice in succession; a cell has as many vertices as its type
/// asks for, all different; an attribute has one row per element; `triangles` covers each face with a fan from its first vertex, and
/// `face_of_triangle` says which. Faces of a solid's surface are oriented outward, those of
/// voids included. Elements are told apart by their indices, never by where they lie.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Complex {
    dimension: u32,
    vertices: Vec<[f64; 3]>,
    faces: Rows,
    edges: Vec<[u32; 2]>,
    cells: Rows,
    cell_types: Vec<CellType>,
    triangles: Vec<[u32; 3]>,
    face_of_triangle: Vec<u32>,
    attributes: Vec<Attribute>,
}

/// The parts from which [`Complex::new`] makes a complex.
#[derive(Clone, Debug, Default)]
pub struct ComplexParts {
    /// 2 for plane results (every z is 0), else 3; 0 stands for 3.
    pub dimension: u32,
    /// The vertices' coordinates.
    pub vertices: Vec<[f64; 3]>,
    /// Polygons, each a ring of vertices.
    pub faces: Rows,
    /// Edges that are not a side of a face.
    pub edges: Vec<[u32; 2]>,
    /// Volume cells, each a list of vertices.
    pub cells: Rows,
    /// One type per cell.
    pub cell_types: Vec<CellType>,
    /// Named attributes.
    pub attributes: Vec<Attribute>,
}

impl Complex {
    /// Checks the parts and derives the triangles.
    ///
    /// Errors: [`Status::NonFinite`] with the vertex, [`Status::InvalidArgument`] with the offending
    /// vertex, face, edge or cell, [`Status::Mismatch`] where arrays differ in length,
    /// [`Status::LimitExceeded`] past 2^32 - 2 elements.
    pub fn new(parts: ComplexParts) -> Result<Self> {
        Job::default().run(&[], |run| Complex::new_in(parts, run))
    }

    /// [`Complex::new`] as a part of a larger operation.
    pub(crate) fn new_in(parts: ComplexParts, run: &Run<'_>) -> Result<Self> {
        let ComplexParts { dimension, vertices, faces, edges, cells, cell_types, .. } = &parts;
        if cells.len() != cell_types.len() {
            return Err(Error::new(Status::Mismatch, "cells and cell types differ in number"));
        }
        let dimension = if *dimension == 2 { 2 } else { 3 };
        let refuse = |kind, i: usize, problem: Option<&'static str>| match problem {
            Some(problem) => {
                let finite =
                    kind != ElementKind::Vertex || vertices[i].iter().all(|x| x.is_finite());
                let status = if finite { Status::InvalidArgument } else { Status::NonFinite };
                Err(Error::new(status, problem).at(kind, i as u64))
            }
            None => Ok(()),
        };
        let count = vertices.len();
        for vertex in run.watch(vertices.iter().enumerate()) {
            let (i, p) = vertex?;
            refuse(ElementKind::Vertex, i, vertex_problem(p, dimension))?;
        }
        for face in run.watch(faces.iter().enumerate()) {
            let (i, face) = face?;
            refuse(ElementKind::Face, i, face_problem(face, count))?;
        }
        for edge in run.watch(edges.iter().enumerate()) {
            let (i, &edge) = edge?;
            refuse(ElementKind::Edge, i, edge_problem(edge, count))?;
        }
        for cell in run.watch(cells.iter().zip(cell_types).enumerate()) {
            let (i, (cell, &kind)) = cell?;
            refuse(ElementKind::Cell, i, cell_problem(cell, kind, count))?;
        }
        Complex::sound_in(parts, run)
    }

    /// [`Complex::new_in`] for parts that are sound by construction: elements are not looked at, but for their number.
    pub(crate) fn sound_in(parts: ComplexParts, run: &Run<'_>) -> Result<Self> {
        let ComplexParts { dimension, vertices, faces, edges, cells, cell_types, attributes } =
            parts;
        let limit = u32::MAX as usize;
        if [vertices.len(), faces.len(), edges.len(), cells.len()].iter().any(|&n| n >= limit) {
            return Err(Error::new(Status::LimitExceeded, "more than 2^32 - 2 elements"));
        }
        let dimension = if dimension == 2 { 2 } else { 3 };
        let mut complex = Complex {
            dimension,
            vertices,
            faces,
            edges,
            cells,
            cell_types,
            triangles: Vec::new(),
            face_of_triangle: Vec::new(),
            attributes: Vec::new(),
        };
        for attribute in &attributes {
            let rows = complex.element_count(attribute.element());
            if attribute.rows() != rows {
                let name = attribute.name();
                return Err(Error::new(
                    Status::Mismatch,
                    format!("attribute '{name}' has {} rows for {rows} elements", attribute.rows()),
                ));
            }
        }
        complex.attributes = attributes;
        (complex.triangles, complex.face_of_triangle) = fans(&complex.faces, run)?;
        Ok(complex)
    }

    /// What the arrays of vertices, faces and triangles take.
    pub(crate) fn bytes(&self) -> usize {
        size_of_val(self.vertices())
            + 4 * (self.faces.indices().len() + self.faces.offsets().len())
            + size_of_val(self.triangles())
            + size_of_val(self.face_of_triangle())
    }

    /// 2 for plane results, whose z is 0 throughout, else 3.
    pub fn dimension(&self) -> u32 {
        self.dimension
    }

    /// The vertices' coordinates, in input units.
    pub fn vertices(&self) -> &[[f64; 3]] {
        &self.vertices
    }

    /// The polygons, each a ring of vertices.
    pub fn faces(&self) -> &Rows {
        &self.faces
    }

    /// The edges that are not a side of a face.
    pub fn edges(&self) -> &[[u32; 2]] {
        &self.edges
    }

    /// The volume cells, each a list of vertices.
    pub fn cells(&self) -> &Rows {
        &self.cells
    }

    /// One type per cell.
    pub fn cell_types(&self) -> &[CellType] {
        &self.cell_types
    }

    /// The faces cut into triangles: a fan from each face's first vertex, with its orientation.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The face that each triangle comes from.
    pub fn face_of_triangle(&self) -> &[u32] {
        &self.face_of_triangle
    }

    /// Every attribute.
    pub fn attributes(&self) -> &[Attribute] {
        &self.attributes
    }

    /// The attribute of this name on this kind of element.
    pub fn attribute(&self, element: Element, name: &str) -> Option<&Attribute> {
        self.attributes.iter().find(|a| a.element() == element && a.name() == name)
    }

    /// The number of elements of a kind.
    pub fn element_count(&self, element: Element) -> usize {
        match element {
            Element::Vertex => self.vertices.len(),
            Element::Edge => self.edges.len(),
            Element::Face => self.faces.len(),
            Element::Cell => self.cells.len(),
        }
    }
}

/// The triangles of every face, and the face of each.
fn fans(faces: &Rows, run: &Run<'_>) -> Result<(Vec<[u32; 3]>, Vec<u32>)> {
    let count = faces.indices().len() - 2 * faces.len();
    let mut room = Room::new(run);
    if count == faces.len() {
        // Nothing but triangles.
        let triangles = room.collect(faces.indices().as_chunks().0.iter().copied())?;
        return Ok((triangles, room.collect(0..count as u32)?));
    }
    let (mut triangles, mut face_of) = (room.vec(count)?, room.vec(count)?);
    for face in run.watch(faces.iter().enumerate()) {
        let (i, face) = face?;
        triangles.extend(fan(face));
        face_of.extend(std::iter::repeat_n(i as u32, face.len() - 2));
    }
    Ok((triangles, face_of))
}

/// The triangles of a fan from the first vertex of a face.
fn fan(face: &[u32]) -> impl Iterator<Item = [u32; 3]> {
    (2..face.len()).map(|k| [face[0], face[k - 1], face[k]])
}

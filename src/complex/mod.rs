//! The one output type: vertices, polygons, loose edges, volume cells, named attributes.

mod attribute;

pub use attribute::{Attribute, Element, Values};

use crate::error::{ElementKind, Error, Result, Status};

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

/// Rows of varying length in two flat arrays: row `i` is `indices[offsets[i]..offsets[i + 1]]`.
///
/// Invariant: `offsets` starts with 0, never falls, and ends with `indices.len()`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rows {
    offsets: Vec<u32>,
    indices: Vec<u32>,
}

impl Default for Rows {
    fn default() -> Self {
        Rows { offsets: vec![0], indices: Vec::new() }
    }
}

impl Rows {
    /// The given arrays, if they keep the invariant.
    pub fn new(offsets: Vec<u32>, indices: Vec<u32>) -> Result<Self> {
        let sound = offsets.first() == Some(&0)
            && offsets.windows(2).all(|pair| pair[0] <= pair[1])
            && offsets.last().map(|&last| last as usize) == Some(indices.len());
        if !sound {
            return Err(Error::new(
                Status::InvalidArgument,
                "row offsets must start at 0, never fall, and end at the number of indices",
            ));
        }
        Ok(Rows { offsets, indices })
    }

    /// Appends one row. Errors: [`Status::LimitExceeded`] past 2^32 - 1 indices.
    pub fn push(&mut self, row: &[u32]) -> Result<()> {
        let end = u32::try_from(self.indices.len() + row.len())
            .map_err(|_| Error::new(Status::LimitExceeded, "more than 2^32 - 1 indices"))?;
        self.indices.extend_from_slice(row);
        self.offsets.push(end);
        Ok(())
    }

    /// The number of rows.
    pub fn len(&self) -> usize {
        self.offsets.len() - 1
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Row `i`.
    pub fn row(&self, i: usize) -> &[u32] {
        &self.indices[self.offsets[i] as usize..self.offsets[i + 1] as usize]
    }

    /// Every row in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        (0..self.len()).map(|i| self.row(i))
    }

    /// Where each row begins; one more entry than rows.
    pub fn offsets(&self) -> &[u32] {
        &self.offsets
    }

    /// All rows, one after the other.
    pub fn indices(&self) -> &[u32] {
        &self.indices
    }
}

/// Vertices, faces, loose edges and volume cells, with named attributes on each.
///
/// Invariants: every index is below the number of vertices; a face has at least three vertices,
/// and no vertex twice in succession; a cell has as many vertices as its type asks for; an
/// attribute has one row per element; `triangles` covers each face with a fan from its first vertex, and
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
    /// Errors: [`Status::InvalidArgument`] or [`Status::Mismatch`] with the offending face, edge or
    /// cell; [`Status::LimitExceeded`] past 2^32 - 1 elements.
    pub fn new(parts: ComplexParts) -> Result<Self> {
        let ComplexParts { dimension, vertices, faces, edges, cells, cell_types, attributes } =
            parts;
        let limit = u32::MAX as usize;
        if [vertices.len(), faces.len(), edges.len(), cells.len()].iter().any(|&n| n >= limit) {
            return Err(Error::new(Status::LimitExceeded, "more than 2^32 - 2 elements"));
        }
        let count = vertices.len();
        let known = |row: &[u32]| row.iter().all(|&v| (v as usize) < count);
        for (i, face) in faces.iter().enumerate() {
            let repeats = (0..face.len()).any(|k| face[k] == face[(k + 1) % face.len()]);
            if face.len() < 3 || repeats || !known(face) {
                return Err(Error::new(
                    Status::InvalidArgument,
                    "a face needs three known vertices or more, none twice in succession",
                )
                .at(ElementKind::Face, i as u64));
            }
        }
        if let Some(i) = edges.iter().position(|edge| edge[0] == edge[1] || !known(edge)) {
            return Err(Error::new(Status::InvalidArgument, "an edge needs two known vertices")
                .at(ElementKind::Edge, i as u64));
        }
        if cells.len() != cell_types.len() {
            return Err(Error::new(Status::Mismatch, "cells and cell types differ in number"));
        }
        for (i, (cell, kind)) in cells.iter().zip(&cell_types).enumerate() {
            let fits = match kind {
                CellType::Tetrahedron => cell.len() == 4,
                CellType::Pyramid => cell.len() == 5,
                CellType::PolygonalPyramid => cell.len() >= 4,
            };
            if !fits || !known(cell) {
                return Err(Error::new(
                    Status::InvalidArgument,
                    "a cell needs as many known vertices as its type asks for",
                )
                .at(ElementKind::Cell, i as u64));
            }
        }
        let mut complex = Complex {
            dimension: if dimension == 2 { 2 } else { 3 },
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
        for (i, face) in complex.faces.iter().enumerate() {
            for k in 1..face.len() - 1 {
                complex.triangles.push([face[0], face[k], face[k + 1]]);
                complex.face_of_triangle.push(i as u32);
            }
        }
        Ok(complex)
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

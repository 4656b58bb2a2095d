//! Named values on the elements of a complex.

use super::{Complex, ComplexParts, Rows};
use crate::error::{Error, Result, Status};
use crate::job::{Room, Run};

/// The kinds of elements of a [`Complex`](super::Complex). The numbers are the C ABI's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum Element {
    /// A vertex.
    Vertex = 0,
    /// A loose edge.
    Edge = 1,
    /// A face.
    Face = 2,
    /// A volume cell.
    Cell = 3,
}

/// The values of an attribute, row-major.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// Lengths, angles, coordinates.
    F64(Vec<f64>),
    /// Indices and labels.
    U32(Vec<u32>),
}

/// Values with a name on one kind of element.
///
/// Invariant: the number of values is a multiple of `width`, which is at least 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Attribute {
    name: String,
    element: Element,
    width: usize,
    values: Values,
}

impl Attribute {
    /// An attribute of `width` values a row.
    pub fn new(
        name: impl Into<String>,
        element: Element,
        width: usize,
        values: Values,
    ) -> Result<Self> {
        let attribute = Attribute { name: name.into(), element, width, values };
        if width == 0 || !attribute.value_count().is_multiple_of(width) {
            return Err(Error::new(
                Status::Mismatch,
                format!("attribute '{}' does not fill its rows", attribute.name),
            ));
        }
        Ok(attribute)
    }

    /// The name, such as `radius`.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The kind of element that carries it.
    pub fn element(&self) -> Element {
        self.element
    }

    /// The number of values per element.
    pub fn width(&self) -> usize {
        self.width
    }

    /// The number of rows, one per element.
    pub fn rows(&self) -> usize {
        self.value_count() / self.width
    }

    /// The values, row-major.
    pub fn values(&self) -> &Values {
        &self.values
    }

    /// What the values take.
    fn bytes(&self) -> usize {
        match &self.values {
            Values::F64(values) => size_of_val(&values[..]),
            Values::U32(values) => size_of_val(&values[..]),
        }
    }

    fn value_count(&self) -> usize {
        match &self.values {
            Values::F64(values) => values.len(),
            Values::U32(values) => values.len(),
        }
    }
}

impl Complex {
    /// The same complex with more attributes, in place of any that have their names on the same kind of element.
    pub(crate) fn with_attributes_in(
        &self,
        mut attributes: Vec<Attribute>,
        run: &Run<'_>,
    ) -> Result<Complex> {
        let mut room = Room::new(run);
        let mut copy = |rows: &Rows| {
            let offsets = room.collect(rows.offsets().iter().copied())?;
            Rows::new(offsets, room.collect(rows.indices().iter().copied())?)
        };
        let (faces, cells) = (copy(&self.faces)?, copy(&self.cells)?);
        let mut kept = Vec::new();
        for old in &self.attributes {
            let same = |new: &Attribute| new.element == old.element && new.name == old.name;
            if !attributes.iter().any(same) {
                run.poll()?;
                room.keep(old.bytes())?;
                kept.push(old.clone());
            }
        }
        kept.append(&mut attributes);
        let parts = ComplexParts {
            dimension: self.dimension,
            vertices: room.collect(self.vertices.iter().copied())?,
            faces,
            edges: room.collect(self.edges.iter().copied())?,
            cells,
            cell_types: room.collect(self.cell_types.iter().copied())?,
            attributes: kept,
        };
        Complex::sound_in(parts, run)
    }
}

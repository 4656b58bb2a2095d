//! Named values on the elements of a complex.

use crate::error::{Error, Result, Status};

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

    fn value_count(&self) -> usize {
        match &self.values {
            Values::F64(values) => values.len(),
            Values::U32(values) => values.len(),
        }
    }
}

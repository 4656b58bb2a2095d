//! The labelled poles, and the power shapes of both sides, as complexes, for writing.

use super::PowerCrust;
use crate::complex::{Attribute, Complex, ComplexParts, Element, Rows, Values};
use crate::error::{Error, Result, Status};

impl PowerCrust {
    /// The poles as vertices with `radius`, `object_angle` and `label` (0 outer, 1 inner), in the poles' order.
    pub fn poles_to_complex(&self) -> Result<Complex> {
        let poles = self.poles().to_complex()?;
        let labels = self.labels().iter().map(|&label| label as u32).collect();
        let mut attributes = poles.attributes().to_vec();
        attributes.push(Attribute::new("label", Element::Vertex, 1, Values::U32(labels))?);
        let vertices = poles.vertices().to_vec();
        Complex::new(ComplexParts { vertices, attributes, ..ComplexParts::default() })
    }

    /// The power shapes of both sides in one complex, the inner one first, with their attributes. They share nothing, as
    /// no pole is on both sides.
    ///
    /// Errors: [`Status::LimitExceeded`] past 2^32 - 2 elements.
    pub fn both_shapes(&self) -> Result<Complex> {
        let (inner, outer) = (self.inner_shape(), self.outer_shape());
        let mut parts = ComplexParts::default();
        for shape in [inner, outer] {
            let first = u32::try_from(parts.vertices.len())
                .map_err(|_| Error::new(Status::LimitExceeded, "more than 2^32 - 1 vertices"))?;
            let shift = |row: &[u32]| row.iter().map(|v| v + first).collect::<Vec<u32>>();
            let append =
                |from: &Rows, to: &mut Rows| from.iter().try_for_each(|row| to.push(&shift(row)));
            parts.vertices.extend_from_slice(shape.vertices());
            append(shape.faces(), &mut parts.faces)?;
            append(shape.cells(), &mut parts.cells)?;
            parts.cell_types.extend_from_slice(shape.cell_types());
            parts.edges.extend(shape.edges().iter().map(|edge| edge.map(|v| v + first)));
        }
        for attribute in inner.attributes() {
            let (name, element) = (attribute.name(), attribute.element());
            let other = outer.attribute(element, name).map(Attribute::values);
            let values = match (attribute.values(), other) {
                (Values::F64(a), Some(Values::F64(b))) => Values::F64([&a[..], b].concat()),
                (Values::U32(a), Some(Values::U32(b))) => Values::U32([&a[..], b].concat()),
                _ => {
                    let message = format!("the outer shape has another attribute '{name}'");
                    return Err(Error::new(Status::Internal, message));
                }
            };
            parts.attributes.push(Attribute::new(name, element, attribute.width(), values)?);
        }
        Complex::new(parts)
    }
}

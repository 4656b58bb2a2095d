//! The labelled poles, and the power shapes of both sides, as complexes, for writing.

use super::{Label, PowerCrust};
use crate::complex::{Attribute, Complex, ComplexParts, Element, Rows, Values};
use crate::error::{Error, Result, Status};

impl PowerCrust {
    /// The poles as vertices with `radius` and `label` (0 outer, 1 inner), in the poles' order.
    pub fn poles_to_complex(&self) -> Result<Complex> {
        let poles = self.poles().to_complex()?;
        let labels = self.labels().iter().map(|&label| label as u32).collect();
        let mut attributes = poles.attributes().to_vec();
        attributes.push(Attribute::new("label", Element::Vertex, 1, Values::U32(labels))?);
        let vertices = poles.vertices().to_vec();
        Complex::new(ComplexParts { vertices, attributes, ..ComplexParts::default() })
    }

    /// The power shapes of both sides in one complex, the inner one first: vertices carry
    /// `radius`, `pole` and `label`. They share nothing, as no pole is on both sides.
    ///
    /// Errors: [`Status::LimitExceeded`] past 2^32 - 2 elements.
    pub fn both_shapes(&self) -> Result<Complex> {
        let mut parts = ComplexParts::default();
        let (mut radii, mut poles, mut labels) = (Vec::new(), Vec::new(), Vec::new());
        for (shape, label) in
            [(self.inner_shape(), Label::Inner), (self.outer_shape(), Label::Outer)]
        {
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
            labels.resize(parts.vertices.len(), label as u32);
            for attribute in shape.attributes() {
                match attribute.values() {
                    Values::F64(values) => radii.extend_from_slice(values),
                    Values::U32(values) => poles.extend_from_slice(values),
                }
            }
        }
        let vertex = |name, values| Attribute::new(name, Element::Vertex, 1, values);
        parts.attributes = vec![
            vertex("radius", Values::F64(radii))?,
            vertex("pole", Values::U32(poles))?,
            vertex("label", Values::U32(labels))?,
        ];
        Complex::new(parts)
    }
}

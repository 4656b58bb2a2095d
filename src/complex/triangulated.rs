//! A complex with its faces cut into triangles.

use super::{Attribute, Complex, ComplexParts, Element, Rows, Values};
use crate::error::Result;

impl Complex {
    /// The same complex with a face for each of its triangles. Face attributes are repeated
    /// for each triangle of the face, and `face`, in place of any of that name, says which face
    /// that was.
    ///
    /// Errors: [`Status::LimitExceeded`](crate::Status::LimitExceeded) past 2^32 - 2 triangles.
    pub fn triangulated(&self) -> Result<Complex> {
        let mut faces = Rows::default();
        for triangle in self.triangles() {
            faces.push(triangle)?;
        }
        let spread = |attribute: &Attribute| {
            let values = match attribute.values() {
                Values::F64(values) => Values::F64(self.per_triangle(values, attribute.width())),
                Values::U32(values) => Values::U32(self.per_triangle(values, attribute.width())),
            };
            Attribute::new(attribute.name(), Element::Face, attribute.width(), values)
        };
        let mut attributes = Vec::new();
        let known = |attribute: &&Attribute| {
            attribute.element() != Element::Face || attribute.name() != "face"
        };
        for attribute in self.attributes().iter().filter(known) {
            attributes.push(match attribute.element() {
                Element::Face => spread(attribute)?,
                _ => attribute.clone(),
            });
        }
        let face = Values::U32(self.face_of_triangle().to_vec());
        attributes.push(Attribute::new("face", Element::Face, 1, face)?);
        Complex::new(ComplexParts {
            dimension: self.dimension(),
            vertices: self.vertices().to_vec(),
            faces,
            edges: self.edges().to_vec(),
            cells: self.cells().clone(),
            cell_types: self.cell_types().to_vec(),
            attributes,
        })
    }

    /// The rows of a face attribute, one for each triangle.
    fn per_triangle<T: Copy>(&self, values: &[T], width: usize) -> Vec<T> {
        let row = |&face: &u32| &values[face as usize * width..][..width];
        self.face_of_triangle().iter().flat_map(row).copied().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_keep_orientation_and_attributes() {
        let mut parts = ComplexParts {
            vertices: (0..7).map(|i| [f64::from(i), 0.5 * f64::from(i * i), 0.0]).collect(),
            edges: vec![[5, 6]],
            attributes: vec![
                Attribute::new("pair", Element::Face, 2, Values::U32(vec![1, 2, 3, 4])).unwrap(),
                Attribute::new("r", Element::Vertex, 1, Values::F64(vec![0.5; 7])).unwrap(),
            ],
            ..ComplexParts::default()
        };
        parts.faces.push(&[0, 1, 2]).unwrap();
        parts.faces.push(&[2, 3, 4, 5, 6]).unwrap();
        let complex = Complex::new(parts).unwrap();
        let cut = complex.triangulated().unwrap();
        let faces: Vec<&[u32]> = cut.faces().iter().collect();
        assert_eq!(faces, [[0, 1, 2], [2, 3, 4], [2, 4, 5], [2, 5, 6]]);
        assert_eq!((cut.vertices(), cut.edges()), (complex.vertices(), complex.edges()));
        let values = |element, name| cut.attribute(element, name).unwrap().values().clone();
        assert_eq!(values(Element::Face, "pair"), Values::U32(vec![1, 2, 3, 4, 3, 4, 3, 4]));
        assert_eq!(values(Element::Face, "face"), Values::U32(vec![0, 1, 1, 1]));
        assert_eq!(values(Element::Vertex, "r"), Values::F64(vec![0.5; 7]));
        let again = cut.triangulated().unwrap();
        assert_eq!((again.faces(), again.attributes().len()), (cut.faces(), 3));
        let face = again.attribute(Element::Face, "face").unwrap();
        assert_eq!(*face.values(), Values::U32(vec![0, 1, 2, 3]));
    }
}

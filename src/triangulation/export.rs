//! A triangulation as a complex, for writing.

use super::Triangulation;
use crate::complex::{Attribute, CellType, Complex, ComplexParts, Element, Rows, Values};
use crate::error::Result;

impl Triangulation {
    /// The vertices, hidden ones included, and the cells as tetrahedra. Vertices carry `row`,
    /// the input row that they come from, and `weight` where there are weights.
    ///
    /// Errors: [`Status::LimitExceeded`](crate::Status::LimitExceeded) past 2^32 - 1 corners.
    pub fn to_complex(&self) -> Result<Complex> {
        let mut cells = Rows::default();
        for cell in self.cells() {
            cells.push(cell)?;
        }
        let rows = Values::U32(self.row_of_vertex().to_vec());
        let mut attributes = vec![Attribute::new("row", Element::Vertex, 1, rows)?];
        if self.is_weighted() {
            let weights = Values::F64(self.weights().to_vec());
            attributes.push(Attribute::new("weight", Element::Vertex, 1, weights)?);
        }
        Complex::new(ComplexParts {
            vertices: self.coords().to_vec(),
            cell_types: vec![CellType::Tetrahedron; self.cells().len()],
            cells,
            attributes,
            ..ComplexParts::default()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::Job;
    use crate::points::Points;
    use std::sync::Arc;

    #[test]
    fn cells_rows_and_weights_are_all_there() {
        // Five points, one of them twice with two weights, and one that its weight hides.
        let rows = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 1.0],
            [1.0, 1.0, 1.0],
            [0.3, 0.3, 0.3],
            [1.0, 0.0, 0.0],
        ];
        let weights = [0.0, 0.0, 0.0, 0.0, 0.0, -9.0, 0.5];
        let points = Points::new(&rows, Default::default(), &Job::default()).unwrap();
        let regular = Triangulation::regular(&Arc::new(points), &weights, &Job::default()).unwrap();
        let complex = regular.to_complex().unwrap();
        assert_eq!(regular.hidden().len(), 1);
        assert_eq!(complex.vertices(), regular.coords());
        assert_eq!(complex.cells().len(), 2);
        assert!(complex.cells().iter().zip(regular.cells()).all(|(a, b)| a == b));
        let values = |name| complex.attribute(Element::Vertex, name).unwrap().values().clone();
        let (Values::U32(row), Values::F64(weight)) = (values("row"), values("weight")) else {
            panic!("rows are indices and weights are numbers");
        };
        for (v, &row) in row.iter().enumerate() {
            assert_eq!(complex.vertices()[v], rows[row as usize]);
            assert_eq!(weight[v], weights[row as usize]);
        }
        assert!(row.contains(&6) && !row.contains(&1), "the larger weight wins");
    }
}

//! Poles and samples as complexes, for writing.

use super::Poles;
use crate::complex::{Attribute, Complex, ComplexParts, Element, Values};
use crate::error::Result;

impl Poles {
    /// The poles as vertices with `radius` and `object_angle`, in the poles' order.
    pub fn to_complex(&self) -> Result<Complex> {
        let radii = self.balls().iter().map(|ball| ball[3]).collect();
        let angles = self.object_angles().to_vec();
        Complex::new(ComplexParts {
            vertices: self.balls().iter().map(|&[x, y, z, _]| [x, y, z]).collect(),
            attributes: vec![
                Attribute::new("radius", Element::Vertex, 1, Values::F64(radii))?,
                Attribute::new("object_angle", Element::Vertex, 1, Values::F64(angles))?,
            ],
            ..ComplexParts::default()
        })
    }

    /// The samples as vertices with `normal`: the unit vector towards the first pole.
    pub fn samples_to_complex(&self) -> Result<Complex> {
        let normals = Values::F64(self.normals().as_flattened().to_vec());
        Complex::new(ComplexParts {
            vertices: self.triangulation().coords()[..self.sample_count()].to_vec(),
            attributes: vec![Attribute::new("normal", Element::Vertex, 3, normals)?],
            ..ComplexParts::default()
        })
    }
}

//! Uniform points of a mesh: a triangle by its area, then a point of it.

use super::random::Random;
use super::{Sample, Source};
use crate::complex::Complex;
use crate::error::{Error, Result, Status};
use crate::vector::{Vec3, add, cross, length, scale, sub, unit};

/// The triangles of a mesh, each with the area of all up to and with it.
pub(super) struct Triangles<'a> {
    mesh: &'a Complex,
    area_up_to: Vec<f64>,
}

impl<'a> Triangles<'a> {
    /// Errors: [`Status::CoordinateRange`] if the areas overflow, [`Status::Degenerate`] if they
    /// vanish.
    pub(super) fn new(mesh: &'a Complex) -> Result<Self> {
        let mut triangles = Triangles { mesh, area_up_to: Vec::new() };
        let mut total = 0.0;
        for triangle in 0..mesh.triangles().len() {
            let [_, u, v] = triangles.corner(triangle);
            total += 0.5 * length(cross(u, v));
            triangles.area_up_to.push(total);
        }
        if !total.is_finite() {
            return Err(too_large());
        }
        if total == 0.0 {
            let message = "the mesh has no triangle with an area, so it has no points to sample";
            return Err(Error::new(Status::Degenerate, message));
        }
        Ok(triangles)
    }

    /// The first vertex of a triangle, and its sides from there.
    fn corner(&self, triangle: usize) -> [Vec3; 3] {
        let [a, b, c] = self.mesh.triangles()[triangle].map(|v| self.mesh.vertices()[v as usize]);
        [a, sub(b, a), sub(c, a)]
    }

    fn area(&self) -> f64 {
        self.area_up_to.last().copied().unwrap_or(0.0)
    }
}

/// The error for lengths or areas that overflow.
pub(super) fn too_large() -> Error {
    Error::new(Status::CoordinateRange, "the mesh is too large; rescale it")
}

impl Source for Triangles<'_> {
    fn throws(&self, density: f64) -> f64 {
        density * self.area()
    }

    fn throw(&self, random: &mut Random, into: &mut Vec<Sample>) {
        let pick = random.uniform() * self.area();
        let triangle = self.area_up_to.partition_point(|&up_to| up_to <= pick);
        let [a, u, v] = self.corner(triangle);
        let (mut s, mut t) = (random.uniform(), random.uniform());
        if s + t > 1.0 {
            // The other half of the parallelogram, turned onto the triangle.
            (s, t) = (1.0 - s, 1.0 - t);
        }
        let point = add(a, add(scale(u, s), scale(v, t)));
        into.push(Sample { point, normal: unit(cross(u, v)) });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::complex::{ComplexParts, Rows};

    #[test]
    fn candidates_fall_on_triangles_by_area_and_evenly_on_each() {
        // Twenty right triangles side by side whose areas are as 1 to 20, and one without area.
        let mut parts = ComplexParts::default();
        for i in 0..21u32 {
            let (x, height) = (f64::from(i), f64::from(i));
            parts.vertices.extend([[x, 0.0, 0.0], [x + 1.0, 0.0, 0.0], [x, 0.0, height]]);
            parts.faces.push(&[3 * i, 3 * i + 1, 3 * i + 2]).unwrap();
        }
        let mesh = Complex::new(parts).unwrap();
        let triangles = Triangles::new(&mesh).unwrap();
        assert_eq!(triangles.throws(2.0), 210.0);
        let mut random = Random::new(3);
        let mut candidates = Vec::new();
        let count = 200_000;
        (0..count).for_each(|_| triangles.throw(&mut random, &mut candidates));
        // Each triangle cut into four by the middles of its sides.
        let mut hits = [[0u32; 4]; 21];
        for Sample { point: [x, y, z], normal } in candidates {
            assert_eq!((y, normal), (0.0, [0.0, -1.0, 0.0]));
            let i = x.floor() as usize;
            let (s, t) = (x - x.floor(), z / i as f64);
            assert!(s + t <= 1.0 + 1e-12);
            let quarter = match (s > 0.5, t > 0.5, s + t < 0.5) {
                (true, ..) => 0,
                (_, true, _) => 1,
                (_, _, true) => 2,
                _ => 3,
            };
            hits[i][quarter] += 1;
        }
        assert_eq!(hits[0], [0; 4]);
        let chi_square: f64 = (1..21usize)
            .flat_map(|i| hits[i].map(|hit| (i as f64, f64::from(hit))))
            .map(|(i, hit)| {
                let expected = f64::from(count) * i / 210.0 / 4.0;
                (hit - expected) * (hit - expected) / expected
            })
            .sum();
        // 79 degrees of freedom: exceeded with a chance of 1e-6 only.
        assert!(chi_square < 152.0, "{chi_square}");
    }

    #[test]
    fn bad_meshes_are_refused() {
        let mesh = |vertices: [[f64; 3]; 3]| {
            let mut faces = Rows::default();
            faces.push(&[0, 1, 2]).unwrap();
            let vertices = vertices.to_vec();
            Complex::new(ComplexParts { vertices, faces, ..ComplexParts::default() }).unwrap()
        };
        let refusal = |vertices| Triangles::new(&mesh(vertices)).err().unwrap();
        let line = refusal([[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]);
        assert_eq!(line.status(), Status::Degenerate);
        let huge = refusal([[0.0; 3], [1e200, 0.0, 0.0], [0.0, 1e200, 0.0]]);
        assert_eq!(huge.status(), Status::CoordinateRange);
    }
}

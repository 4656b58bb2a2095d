//! The invariants of a complex: refused when it is made, and checked again on request.

use super::{CellType, Complex, Element, Point, fan};
use crate::error::{ElementKind, Result};
use crate::job::{Job, Run, Stage};
use crate::validation::Validation;

/// What is wrong with a vertex.
pub(super) fn vertex_problem(p: &Point, dimension: u32) -> Option<&'static str> {
    if !p.iter().all(|x| x.is_finite()) {
        return Some("a coordinate is NaN or infinite");
    }
    (dimension == 2 && p[2] != 0.0).then_some("a vertex of a plane complex has a z other than 0")
}

/// What is wrong with a face of a complex of so many vertices.
pub(super) fn face_problem(face: &[u32], vertices: usize) -> Option<&'static str> {
    let known = face.iter().all(|&v| (v as usize) < vertices);
    let repeats = (0..face.len()).any(|k| face[k] == face[(k + 1) % face.len()]);
    (face.len() < 3 || repeats || !known)
        .then_some("a face needs three known vertices or more, none twice in succession")
}

/// What is wrong with a loose edge.
pub(super) fn edge_problem(edge: [u32; 2], vertices: usize) -> Option<&'static str> {
    let known = edge.iter().all(|&v| (v as usize) < vertices);
    (edge[0] == edge[1] || !known).then_some("an edge needs two known vertices")
}

/// What is wrong with a cell.
pub(super) fn cell_problem(cell: &[u32], kind: CellType, vertices: usize) -> Option<&'static str> {
    let fits = match kind {
        CellType::Tetrahedron => cell.len() == 4,
        CellType::Pyramid => cell.len() == 5,
        CellType::PolygonalPyramid => cell.len() >= 4,
    };
    if !fits || !cell.iter().all(|&v| (v as usize) < vertices) {
        return Some("a cell needs as many known vertices as its type asks for");
    }
    let repeats = match cell.len() {
        0..=8 => (1..cell.len()).any(|k| cell[..k].contains(&cell[k])),
        _ => {
            let mut sorted = cell.to_vec();
            sorted.sort_unstable();
            sorted.windows(2).any(|pair| pair[0] == pair[1])
        }
    };
    repeats.then_some("a cell has a vertex twice")
}

impl Complex {
    /// Checks every invariant of the complex: indices, rings, finite coordinates, triangles,
    /// attributes. Complexes are made valid, so a problem is a defect of medax.
    ///
    /// Errors: those of the job. Cost: linear.
    pub fn validate(&self, job: &Job) -> Result<Validation> {
        job.run(&[(Stage::Validate, 1.0)], |run| self.validate_in(run))
    }

    /// [`Complex::validate`] as a stage of a larger operation.
    pub(crate) fn validate_in(&self, run: &Run<'_>) -> Result<Validation> {
        run.enter(Stage::Validate)?;
        let mut report = Validation::new();
        let mut check = |kind, i: usize, problem: Option<&str>| -> Result<()> {
            let message = || problem.unwrap_or_default().to_string();
            report.check(problem.is_none(), kind, i as u64, message);
            if i.is_multiple_of(1 << 14) { run.poll() } else { Ok(()) }
        };
        let count = self.vertices.len();
        for (i, p) in self.vertices.iter().enumerate() {
            check(ElementKind::Vertex, i, vertex_problem(p, self.dimension))?;
        }
        for (i, face) in self.faces.iter().enumerate() {
            check(ElementKind::Face, i, face_problem(face, count))?;
        }
        for (i, &edge) in self.edges.iter().enumerate() {
            check(ElementKind::Edge, i, edge_problem(edge, count))?;
        }
        for (i, cell) in self.cells.iter().enumerate() {
            let kind = self.cell_types.get(i).copied();
            let problem = kind.map_or(Some("a cell has no type"), |k| cell_problem(cell, k, count));
            check(ElementKind::Cell, i, problem)?;
        }
        for (i, face) in self.faces.iter().enumerate() {
            let offset = (self.faces.offsets()[i] as usize).saturating_sub(2 * i);
            let range = offset..offset + face.len().saturating_sub(2);
            let triangles = self.triangles.get(range.clone()).unwrap_or_default();
            let owners = self.face_of_triangle.get(range).unwrap_or_default();
            let right = triangles.iter().copied().eq(fan(face))
                && owners.len() == triangles.len()
                && owners.iter().all(|&f| f as usize == i);
            let message = "the triangles of a face are not the fan from its first vertex";
            check(ElementKind::Face, i, (!right).then_some(message))?;
        }
        let fans = self.faces.indices().len().saturating_sub(2 * self.faces.len());
        let extra = self.triangles.len() != fans || self.face_of_triangle.len() != fans;
        check(
            ElementKind::Face,
            self.faces.len(),
            extra.then_some("there are triangles of no face"),
        )?;
        for attribute in &self.attributes {
            let (rows, elements) = (attribute.rows(), self.element_count(attribute.element()));
            let kind = match attribute.element() {
                Element::Vertex => ElementKind::Vertex,
                Element::Edge => ElementKind::Edge,
                Element::Face => ElementKind::Face,
                Element::Cell => ElementKind::Cell,
            };
            let problem = (rows != elements).then_some("an attribute ends before or after this");
            check(kind, rows.min(elements), problem)?;
        }
        Ok(report)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::complex::{Attribute, ComplexParts, Rows, Values};
    use crate::error::Status;

    fn parts() -> ComplexParts {
        let rows = |list: &[u32]| Rows::new(vec![0, list.len() as u32], list.to_vec()).unwrap();
        let radius = Values::F64(vec![1.0; 5]);
        ComplexParts {
            dimension: 3,
            vertices: (0..5).map(|i| [f64::from(i), 0.0, 0.0]).collect(),
            faces: rows(&[0, 1, 2, 3]),
            edges: vec![[3, 4]],
            cells: rows(&[0, 1, 2, 3, 4]),
            cell_types: vec![CellType::PolygonalPyramid],
            attributes: vec![Attribute::new("radius", Element::Vertex, 1, radius).unwrap()],
        }
    }

    #[test]
    fn what_is_broken_by_hand_is_noticed() {
        let sound = Complex::new(parts()).unwrap();
        let report = sound.validate(&Job::default()).unwrap();
        assert!(report.is_valid() && report.checked > 8);
        type Break = (ElementKind, u64, fn(&mut Complex));
        let breaks: [Break; 12] = [
            (ElementKind::Vertex, 3, |c| c.vertices[3][1] = f64::NAN),
            (ElementKind::Vertex, 2, |c| {
                c.dimension = 2;
                c.vertices[2][2] = 1.0;
            }),
            (ElementKind::Face, 0, |c| c.faces = Rows::new(vec![0, 4], vec![0, 1, 2, 5]).unwrap()),
            (ElementKind::Face, 0, |c| c.faces = Rows::new(vec![0, 4], vec![0, 1, 2, 0]).unwrap()),
            (ElementKind::Face, 0, |c| c.faces = Rows::new(vec![0, 2], vec![0, 1]).unwrap()),
            (ElementKind::Edge, 0, |c| c.edges[0] = [2, 2]),
            (ElementKind::Edge, 0, |c| c.edges[0] = [2, 9]),
            (ElementKind::Cell, 0, |c| c.cell_types[0] = CellType::Tetrahedron),
            (ElementKind::Cell, 0, |c| c.cell_types.clear()),
            (ElementKind::Face, 0, |c| c.triangles[1].swap(0, 1)),
            (ElementKind::Face, 1, |c| c.triangles.push([0, 1, 2])),
            (ElementKind::Vertex, 5, |c| c.vertices.push([0.0; 3])),
        ];
        for (i, (kind, index, break_it)) in breaks.into_iter().enumerate() {
            let mut complex = sound.clone();
            break_it(&mut complex);
            let report = complex.validate(&Job::default()).unwrap();
            let (found, at, _) = report.first.unwrap();
            assert_eq!((found, at), (kind, index), "break {i}");
        }
    }

    #[test]
    fn broken_parts_are_refused() {
        type Break = (Status, Option<(ElementKind, u64)>, fn(&mut ComplexParts));
        let breaks: [Break; 7] = [
            (Status::NonFinite, Some((ElementKind::Vertex, 4)), |p| {
                p.vertices[4][2] = f64::INFINITY;
            }),
            (Status::InvalidArgument, Some((ElementKind::Vertex, 1)), |p| {
                p.dimension = 2;
                p.vertices[1][2] = 1.0;
            }),
            (Status::InvalidArgument, Some((ElementKind::Face, 1)), |p| {
                p.faces.push(&[0, 1, 1]).unwrap();
            }),
            (Status::InvalidArgument, Some((ElementKind::Edge, 1)), |p| p.edges.push([0, 5])),
            (Status::InvalidArgument, Some((ElementKind::Cell, 1)), |p| {
                p.cells.push(&[0, 1, 2, 2]).unwrap();
                p.cell_types.push(CellType::Tetrahedron);
            }),
            (Status::Mismatch, None, |p| p.cell_types.clear()),
            (Status::Mismatch, None, |p| p.vertices.push([0.0; 3])),
        ];
        for (i, (status, element, break_it)) in breaks.into_iter().enumerate() {
            let mut parts = parts();
            break_it(&mut parts);
            let error = Complex::new(parts).unwrap_err();
            assert_eq!((error.status(), error.element()), (status, element), "break {i}");
        }
        // A ring of any length is searched for vertices that come twice.
        let ring: Vec<u32> = (0..20).collect();
        assert_eq!(cell_problem(&ring, CellType::PolygonalPyramid, 20), None);
        let mut twice = ring;
        twice[17] = 3;
        assert!(cell_problem(&twice, CellType::PolygonalPyramid, 20).is_some());
    }
}

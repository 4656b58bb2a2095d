//! What a file holds, before anything is made of it.

use crate::complex::{Attribute, Complex, ComplexParts, Element, Rows, Values};
use crate::error::{ElementKind, Error, Result, Status};
use crate::job::{Job, Room, Run, Stage};
use crate::points::{Points, PointsOptions};

/// The contents of a file, in the file's order: rows of vertices, faces, edges, attributes.
///
/// Invariants: every index is below the number of vertices; a face has at least three vertices;
/// an attribute has one row per element of its kind. Nothing else is checked: coordinates may be
/// NaN or infinite, and faces and edges may repeat a vertex.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Soup {
    pub(super) vertices: Vec<[f64; 3]>,
    pub(super) faces: Rows,
    pub(super) edges: Vec<[u32; 2]>,
    pub(super) attributes: Vec<Attribute>,
    pub(super) warnings: Vec<String>,
    /// Where a file without vertices says that it has none.
    pub(super) nothing_at: Option<(ElementKind, u64)>,
}

impl Soup {
    /// The rows of the vertex table.
    pub fn vertices(&self) -> &[[f64; 3]] {
        &self.vertices
    }

    /// The faces, each a ring of vertices.
    pub fn faces(&self) -> &Rows {
        &self.faces
    }

    /// The edges that the file lists, sides of faces among them.
    pub fn edges(&self) -> &[[u32; 2]] {
        &self.edges
    }

    /// The named values that the file holds on vertices, edges and faces.
    pub fn attributes(&self) -> &[Attribute] {
        &self.attributes
    }

    /// Sentences about what was left out in reading.
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// Whether there is a face or an edge. A file without either is a set of points.
    pub fn is_mesh(&self) -> bool {
        !self.faces.is_empty() || !self.edges.is_empty()
    }

    /// The points: the vertices that a face or an edge uses, or all where there is neither.
    ///
    /// Rows are those of the file; an unused one maps to [`NONE`](crate::NONE).
    /// Errors: as [`Points::new`]; [`Status::TooFewPoints`] names the line or byte where the file says
    /// that it holds no point.
    pub fn points(&self, options: PointsOptions, job: &Job) -> Result<Points> {
        job.run(&[(Stage::Order, 1.0)], |run| self.points_in(options, run))
    }

    /// [`Soup::points`] as a stage of a larger build.
    pub(crate) fn points_in(&self, options: PointsOptions, run: &Run<'_>) -> Result<Points> {
        if let Some((kind, place)) = self.nothing_at {
            return Err(Error::new(Status::TooFewPoints, "the file holds no point").at(kind, place));
        }
        if !self.is_mesh() {
            let row = |i: usize| Some(self.vertices[i]);
            return Points::by_row_in(self.vertices.len(), row, options, run);
        }
        let mut used: Vec<bool> = run.try_vec(self.vertices.len())?;
        used.resize(self.vertices.len(), false);
        for &v in self.faces.indices().iter().chain(self.edges.as_flattened()) {
            used[v as usize] = true;
        }
        let row = |i: usize| used[i].then_some(self.vertices[i]);
        Points::by_row_in(self.vertices.len(), row, options, run)
    }

    /// The complex of all vertices, faces, and the edges that are not a side of a face.
    ///
    /// Errors: [`Status::NonFinite`] with the row of the vertex; [`Status::Format`] with the face
    /// or edge that repeats a vertex in succession. Cost: linear, times the logarithm of the number
    /// of edges.
    pub fn into_complex(mut self) -> Result<Complex> {
        if let Some(row) = self.vertices.iter().position(|v| !v.iter().all(|x| x.is_finite())) {
            return Err(Error::new(Status::NonFinite, "a coordinate is NaN or infinite")
                .at(ElementKind::Row, row as u64));
        }
        if let Some(i) = self.edges.iter().position(|[a, b]| a == b) {
            return Err(Error::new(Status::Format, "the edge has both ends at one vertex")
                .at(ElementKind::Edge, i as u64));
        }
        self.drop_sides()?;
        let parts = ComplexParts {
            dimension: 3,
            vertices: self.vertices,
            faces: self.faces,
            edges: self.edges,
            attributes: self.attributes,
            ..ComplexParts::default()
        };
        Complex::new(parts).map_err(|error| match error.element() {
            Some((kind @ ElementKind::Face, index)) => {
                Error::new(Status::Format, "the face names a vertex twice in succession")
                    .at(kind, index)
            }
            _ => error,
        })
    }

    /// Removes the edges that are sides of a face, with their attributes.
    fn drop_sides(&mut self) -> Result<()> {
        if self.edges.is_empty() || self.faces.is_empty() {
            return Ok(());
        }
        let sorted = |a: u32, b: u32| (a.min(b), a.max(b));
        let mut order: Vec<((u32, u32), usize)> =
            self.edges.iter().enumerate().map(|(i, edge)| (sorted(edge[0], edge[1]), i)).collect();
        order.sort_unstable();
        let mut loose = vec![true; self.edges.len()];
        for face in self.faces.iter() {
            for (k, &corner) in face.iter().enumerate() {
                let side = sorted(corner, face[(k + 1) % face.len()]);
                let first = order.partition_point(|(edge, _)| *edge < side);
                // An edge may be listed more than once.
                let same = order[first..].iter().take_while(|(edge, _)| *edge == side);
                same.for_each(|&(_, i)| loose[i] = false);
            }
        }
        let mut keep = loose.iter();
        self.edges.retain(|_| keep.next() == Some(&true));
        for attribute in &mut self.attributes {
            if attribute.element() == Element::Edge {
                let values = match attribute.values() {
                    Values::F64(v) => Values::F64(kept_rows(v, attribute.width(), &loose)),
                    Values::U32(v) => Values::U32(kept_rows(v, attribute.width(), &loose)),
                };
                let (name, width) = (attribute.name().to_string(), attribute.width());
                *attribute = Attribute::new(name, Element::Edge, width, values)?;
            }
        }
        Ok(())
    }
}

/// The rows that `keep` marks.
fn kept_rows<T: Copy>(values: &[T], width: usize, keep: &[bool]) -> Vec<T> {
    let rows = values.chunks_exact(width).zip(keep);
    rows.filter(|(_, keep)| **keep).flat_map(|(row, _)| row).copied().collect()
}

/// A [`Soup`] in the making.
pub(super) struct Builder<'a> {
    pub room: Room<'a>,
    pub vertices: Vec<[f64; 3]>,
    pub edges: Vec<[u32; 2]>,
    pub attributes: Vec<Attribute>,
    pub warnings: Vec<String>,
    face_offsets: Vec<u32>,
    face_indices: Vec<u32>,
}

impl<'a> Builder<'a> {
    pub fn new(run: &'a Run<'a>) -> Self {
        Builder {
            room: Room::new(run),
            vertices: Vec::new(),
            edges: Vec::new(),
            attributes: Vec::new(),
            warnings: Vec::new(),
            face_offsets: vec![0],
            face_indices: Vec::new(),
        }
    }

    pub fn vertex(&mut self, xyz: [f64; 3]) -> Result<()> {
        self.room.push(&mut self.vertices, xyz)
    }

    pub fn edge(&mut self, edge: [u32; 2]) -> Result<()> {
        self.room.push(&mut self.edges, edge)
    }

    /// Appends a corner to the face that is not closed yet.
    pub fn corner(&mut self, vertex: u32) -> Result<()> {
        self.room.push(&mut self.face_indices, vertex)
    }

    /// Closes the face and returns the number of its corners.
    pub fn close_face(&mut self) -> Result<usize> {
        let end = u32::try_from(self.face_indices.len())
            .map_err(|_| Error::new(Status::LimitExceeded, "more than 2^32 - 1 face corners"))?;
        let begin = self.face_offsets.last().copied().unwrap_or(0);
        self.room.push(&mut self.face_offsets, end)?;
        Ok((end - begin) as usize)
    }

    pub fn face(&mut self, corners: [u32; 3]) -> Result<()> {
        for vertex in corners {
            self.corner(vertex)?;
        }
        self.close_face().map(|_| ())
    }

    /// Makes room for as many faces of three corners.
    pub fn reserve_faces(&mut self, count: usize) -> Result<()> {
        self.room.reserve(&mut self.face_offsets, count)?;
        self.room.reserve(&mut self.face_indices, count.saturating_mul(3))
    }

    /// Ends the reading. The number of vertices stands at `counted`, or is known there.
    pub fn finish(self, counted: (ElementKind, u64)) -> Result<Soup> {
        let limit = u32::MAX as usize;
        if [self.vertices.len(), self.edges.len()].iter().any(|&n| n >= limit) {
            return Err(Error::new(Status::LimitExceeded, "more than 2^32 - 2 rows"));
        }
        Ok(Soup {
            nothing_at: self.vertices.is_empty().then_some(counted),
            vertices: self.vertices,
            faces: Rows::new(self.face_offsets, self.face_indices)?,
            edges: self.edges,
            attributes: self.attributes,
            warnings: self.warnings,
        })
    }
}

//! Parts of flow complexes as complexes.

use super::Flow;
use super::closure::Subset;
use super::simplex::{Simplex, VoronoiSet};
use super::source::Source;
use super::subdivision::Subdivision;
use crate::complex::{Attribute, Complex, ComplexParts, Element, Rows, Values};
use crate::error::{ElementKind, Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use crate::vector::{length, scale, sub};

impl Flow {
    /// The flow closure of some Voronoi facets, edges and vertices: these, and whatever can be reached from them. Of the faces of a critical point that is its unstable manifold (Giesen,
    /// Ramos, Sadri, section 5, figures 10 and 12), hairs included; of a Voronoi cell all its facets. What is unbounded is left out. Attributes are those of
    /// [`Core::complex`](super::Core::complex).
    ///
    /// Errors: [`Status::InvalidArgument`] with the row of a face that is not there; those of the job. Cost: O(n), and O(size) of what is reached.
    pub fn closure(&self, faces: &[Simplex], job: &Job) -> Result<Complex> {
        job.run(&[(Stage::Flow, 0.8), (Stage::Extract, 0.2)], |run| {
            run.enter(Stage::Flow)?;
            let source = self.source()?;
            let mut room = Room::new(run);
            let mut seeds = Vec::new();
            for row in run.watch(faces.iter().enumerate()) {
                let (row, &face) = row?;
                let is_there = self.check_face(face);
                is_there.map_err(|error| error.at(ElementKind::Row, row as u64))?;
                match face {
                    Simplex::Sample(v) => {
                        for facet in run.watch(0..source.facets.len() as u32) {
                            let facet = facet?;
                            if source.facets.edges()[facet as usize].contains(&v) {
                                room.push(&mut seeds, Simplex::Edge(facet))?;
                            }
                        }
                    }
                    _ => room.push(&mut seeds, face)?,
                }
            }
            let seeds = || seeds.iter().copied();
            let set = VoronoiSet::touched(&source, seeds(), None, &mut room, run)?;
            let its = Subdivision::new(&source, &set, &mut room, run)?;
            let mut closure = Subset::new(&its, &mut room)?;
            let elements = seeds().flat_map(|face| its.elements_of(face));
            closure.add(&its, elements, None, &mut room, run)?;
            run.enter(Stage::Extract)?;
            Ok(self.complex_of(&its, &closure, run)?.0)
        })
    }

    /// The critical points as vertices, with the attributes `index`, `class` (0 the surface's, 1 inner, 2 outer), `radius` (their distance from the samples, in input units), `slope`, `share` and `samples`
    /// (the nearest ones, then [`NONE`]). Samples, which are those of index 0, are left out.
    ///
    /// Errors: those of the job. Cost: O(critical points).
    pub fn critical_complex(&self, job: &Job) -> Result<Complex> {
        job.run(&[(Stage::Extract, 1.0)], |run| {
            run.enter(Stage::Extract)?;
            let mut room = Room::new(run);
            let critical = &self.critical;
            let first = self.dual.triangulation().coords().len();
            let rows = first..critical.len();
            let vertices = room.collect(rows.clone().map(|i| critical.points()[i]))?;
            let indices = rows.clone().map(|i| critical.simplices()[i].dimension() as u32);
            let indices = room.collect(indices)?;
            let classes = room.collect(rows.clone().map(|i| critical.classes()[i] as u32))?;
            let mut samples = room.vec(4 * rows.len())?;
            rows.clone().for_each(|i| samples.extend_from_slice(&critical.corners()[i]));
            let of = |values: &[f64], room: &mut Room<'_>| {
                Ok::<_, Error>(Values::F64(room.collect(values[first..].iter().copied())?))
            };
            let radii = of(critical.distances(), &mut room)?;
            let slopes = of(critical.slopes(), &mut room)?;
            let shares = of(critical.shares(), &mut room)?;
            let attributes = vec![
                Attribute::new("index", Element::Vertex, 1, Values::U32(indices))?,
                Attribute::new("class", Element::Vertex, 1, Values::U32(classes))?,
                Attribute::new("radius", Element::Vertex, 1, radii)?,
                Attribute::new("slope", Element::Vertex, 1, slopes)?,
                Attribute::new("share", Element::Vertex, 1, shares)?,
                Attribute::new("samples", Element::Vertex, 4, Values::U32(samples))?,
            ];
            let parts = ComplexParts { vertices, attributes, ..ComplexParts::default() };
            Complex::sound_in(parts, run)
        })
    }

    /// Errors: [`Status::InvalidArgument`] for a face that the Voronoi diagram does not have.
    pub(super) fn check_face(&self, face: Simplex) -> Result<()> {
        let t = self.dual.triangulation();
        let count = match face {
            Simplex::Sample(_) => t.coords().len(),
            Simplex::Edge(_) => self.source()?.facets.len(),
            Simplex::Triangle(_) => self.triangles.len(),
            Simplex::Cell(_) => t.cells().len(),
        };
        if (face.number() as usize) < count {
            return Ok(());
        }
        let message = format!("there are only {count} simplices of dimension {}", face.dimension());
        let error = Error::new(Status::InvalidArgument, message);
        Err(error.at(ElementKind::Face, u64::from(face.number())))
    }

    /// The position of a vertex of the flow complex.
    pub(super) fn place(&self, its: &Subdivision, vertex: u32) -> [f64; 3] {
        let centers = self.dual.centers();
        match centers.get(vertex as usize) {
            Some(center) => *center,
            None => its.points[vertex as usize - centers.len()],
        }
    }

    /// A closed set as a complex, but for what is unbounded: the number of faces and loose edges left out.
    pub(super) fn complex_of(
        &self,
        its: &Subdivision,
        set: &Subset,
        run: &Run<'_>,
    ) -> Result<(Complex, usize)> {
        let mut room = Room::new(run);
        let source = self.source()?;
        let mut number = room.filled(set.has_vertex.len(), NONE)?;
        let (mut vertices, mut its_vertices) = (Vec::new(), Vec::new());
        for vertex in run.watch(0..number.len()) {
            let vertex = vertex?;
            if set.has_vertex[vertex] {
                number[vertex] = vertices.len() as u32;
                room.push(&mut vertices, self.place(its, vertex as u32))?;
                room.push(&mut its_vertices, vertex as u32)?;
            }
        }
        let mut unbounded = 0;
        let mut is_side = room.filled(set.has_edge.len(), false)?;
        let mut faces = Rows::default();
        let (mut row, mut facets): (Vec<u32>, Vec<u32>) = (Vec::new(), Vec::new());
        for face in run.watch(0..set.has_face.len()) {
            let face = face?;
            if !set.has_face[face] {
                continue;
            }
            for &edge in its.rim_of(face as u32) {
                is_side[edge as usize] = true;
            }
            let rim = its.rim_vertices.row(face);
            if rim.contains(&NONE) {
                unbounded += 1;
                continue;
            }
            row.clear();
            row.extend(rim.iter().map(|&v| number[v as usize]));
            faces.push(&row)?;
            room.push(&mut facets, its.facet_of(face as u32))?;
        }
        let mut edges = Vec::new();
        let mut samples_of_edges: Vec<u32> = Vec::new();
        for edge in run.watch(0..is_side.len()) {
            let edge = edge?;
            if !set.has_edge[edge] || is_side[edge] {
                continue;
            }
            let ends = its.edges[edge];
            if ends.contains(&NONE) {
                unbounded += 1;
                continue;
            }
            room.push(&mut edges, ends.map(|v| number[v as usize]))?;
            room.grow(&mut samples_of_edges, 3)?;
            samples_of_edges.extend_from_slice(&source.corners(its.simplex_of(edge as u32))[..3]);
        }
        let mut attributes = self.vertex_attributes(its, &source, &its_vertices, &mut room)?;
        attributes.extend(face_attributes(&source, facets, &mut room)?);
        let samples = Values::U32(samples_of_edges);
        attributes.push(Attribute::new("samples", Element::Edge, 3, samples)?);
        let parts = ComplexParts { vertices, faces, edges, attributes, ..ComplexParts::default() };
        Ok((Complex::sound_in(parts, run)?, unbounded))
    }

    /// Of vertices: distances, cells, critical points.
    fn vertex_attributes(
        &self,
        its: &Subdivision,
        source: &Source<'_>,
        vertices: &[u32],
        room: &mut Room<'_>,
    ) -> Result<Vec<Attribute>> {
        let t = self.dual.triangulation();
        let count = self.dual.centers().len();
        let simplex_of = |v: u32| match (v as usize).checked_sub(count) {
            None => Simplex::Cell(v),
            Some(point) => Simplex::Triangle(its.triangle_of_point[point]),
        };
        let radii = room.collect(vertices.iter().map(|&v| match simplex_of(v) {
            Simplex::Cell(cell) => self.dual.radii_squared()[cell as usize].sqrt(),
            simplex => {
                let sample = t.coords()[source.corners(simplex)[0] as usize];
                length(sub(self.place(its, v), sample))
            }
        }))?;
        let is_cell = |v: u32| (v as usize) < count;
        let cells = vertices.iter().map(|&v| if is_cell(v) { v } else { NONE });
        let cells = room.collect(cells)?;
        let critical = room.collect(vertices.iter().map(|&v| {
            let is_hit = !is_cell(v) && (v as usize) < count + its.hits as usize;
            match is_hit {
                true => NONE,
                false => self.critical.row_of(simplex_of(v)).unwrap_or(NONE),
            }
        }))?;
        Ok(vec![
            Attribute::new("radius", Element::Vertex, 1, Values::F64(radii))?,
            Attribute::new("cell", Element::Vertex, 1, Values::U32(cells))?,
            Attribute::new("critical", Element::Vertex, 1, Values::U32(critical))?,
        ])
    }
}

/// Of faces: facets, their samples, half the distance of these.
fn face_attributes(
    source: &Source<'_>,
    facets: Vec<u32>,
    room: &mut Room<'_>,
) -> Result<[Attribute; 3]> {
    let coords = source.dual.triangulation().coords();
    let mut samples = room.vec(2 * facets.len())?;
    let mut lambdas = room.vec(facets.len())?;
    for &facet in &facets {
        let [p, q] = source.facets.edges()[facet as usize];
        samples.extend([p, q]);
        lambdas.push(length(scale(sub(coords[q as usize], coords[p as usize]), 0.5)));
    }
    Ok([
        Attribute::new("facet", Element::Face, 1, Values::U32(facets))?,
        Attribute::new("samples", Element::Face, 2, Values::U32(samples))?,
        Attribute::new("lambda", Element::Face, 1, Values::F64(lambdas))?,
    ])
}

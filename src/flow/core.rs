//! The core: the flow closure of the critical points of the medial axis.

use super::Flow;
use super::closure::{FlowElement, Subset};
use super::critical::CriticalClass;
use super::drivers::Driver;
use crate::complex::{Complex, ComplexParts, DisjointSets, Rows};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};

impl Flow {
    /// The core of one class of critical points: the union of their unstable manifolds, which has the homotopy type of the solid if
    /// the sample is dense enough (Giesen, Ramos, Sadri, theorem 3.16).
    pub fn core(&self, class: CriticalClass, job: &Job) -> Result<Complex> {
        job.run(&[(Stage::Extract, 1.0)], |run| {
            run.enter(Stage::Extract)?;
            let mut room = Room::new(run);
            let mut core = Subset::new(&self.complex, &mut room)?;
            core.add(&self.complex, self.elements_of_class(class), None, &mut room, run)?;
            self.complex_of(&core, run)
        })
    }

    /// The inner core, with as much of the flow of other critical points as it takes to have the homotopy type of the labelled solid.
    pub fn repaired_core(&self, job: &Job) -> Result<Complex> {
        job.run(&[(Stage::Extract, 1.0)], |run| {
            run.enter(Stage::Extract)?;
            let mut room = Room::new(run);
            let inner = self.inner(&mut room, run)?;
            let mut least = Subset::new(&self.complex, &mut room)?;
            let elements = self.elements_of_class(CriticalClass::Inner);
            least.add(&self.complex, elements, Some(&inner), &mut room, run)?;
            let mut all = Subset::new(&self.complex, &mut room)?;
            let elements =
                (0..self.critical.len()).flat_map(|i| self.elements_of(self.critical.drivers()[i]));
            let elements = elements.filter(|&element| inner.has(element));
            all.add(&self.complex, elements, Some(&inner), &mut room, run)?;
            all.add(&self.complex, self.leaks(&inner), Some(&inner), &mut room, run)?;
            all.collapse(&self.complex, &least, &mut room, run)?;
            self.complex_of(&all, run)
        })
    }

    /// The elements of a set that flow out of it.
    fn leaks<'a>(&'a self, set: &'a Subset) -> impl Iterator<Item = FlowElement> + 'a {
        let complex = &self.complex;
        let vertices = (0..).zip(&complex.edge_of_vertex).filter(|&(v, &edge)| {
            set.has_vertex[v as usize] && edge != NONE && !set.has_edge[edge as usize]
        });
        let edges = (0..).zip(&complex.face_of_edge).filter(|&(e, &face)| {
            set.has_edge[e as usize] && face != NONE && !set.has_face[face as usize]
        });
        let vertices = vertices.map(|(v, _): (u32, _)| FlowElement::Vertex(v));
        vertices.chain(edges.map(|(e, _): (u32, _)| FlowElement::Edge(e)))
    }

    /// The parts of Voronoi faces that have inner cells all round them: dual to the simplices inside the labelled solid, and so of its homotopy type.
    fn inner(&self, room: &mut Room<'_>, run: &Run<'_>) -> Result<Subset> {
        let complex = &self.complex;
        let t = self.dual.triangulation();
        let mut inner = Subset::new(complex, room)?;
        let is_inner = |cell: u32| cell != NONE && self.labels.is_inner()[cell as usize];
        for cell in run.watch(0..t.cells().len()) {
            let cell = cell?;
            inner.has_vertex[cell] = is_inner(cell as u32);
        }
        for triangle in run.watch(0..self.triangles.len() as u32) {
            let triangle = triangle?;
            if self.triangles.cells(t, triangle).into_iter().all(is_inner) {
                let edges = &complex.edges_of_triangle;
                for edge in edges[triangle as usize]..edges[triangle as usize + 1] {
                    inner.has_edge[edge as usize] = true;
                    for v in complex.edges[edge as usize] {
                        inner.has_vertex[v as usize] = true;
                    }
                }
            }
        }
        let facets = self.facets()?;
        for facet in run.watch(0..facets.len()) {
            let facet = facet?;
            let ring = facets.ring(facet);
            if !facets.is_unbounded(facet) && ring.iter().all(|&cell| is_inner(cell)) {
                for face in complex.faces_of_facet[facet]..complex.faces_of_facet[facet + 1] {
                    inner.has_face[face as usize] = true;
                    for &edge in complex.rim_of(face) {
                        inner.has_edge[edge as usize] = true;
                    }
                }
            }
        }
        for facet in self.openings(room, run)? {
            inner.has_face[complex.faces_of_facet[facet as usize] as usize] = false;
        }
        Ok(inner)
    }

    /// Critical facets through which the Voronoi cells of samples inside the solid, which no surface has, open into each other and to those of the surface's
    /// samples: a shortest forest. Without them each such cell were a void.
    fn openings(&self, room: &mut Room<'_>, run: &Run<'_>) -> Result<Vec<u32>> {
        let t = self.dual.triangulation();
        let samples = t.coords().len() as u32;
        // All others are one.
        let mut set = room.collect(0..samples)?;
        for cell in run.watch(0..t.cells().len()) {
            let cell = cell?;
            for (slot, &v) in t.cells()[cell].iter().enumerate() {
                let at_hull = (0..4).any(|i| i != slot && t.neighbors()[cell][i] == NONE);
                if at_hull || !self.labels.is_inner()[cell] {
                    set[v as usize] = samples;
                }
            }
        }
        let facets = self.facets()?;
        let mut openings: Vec<(f64, u32)> = Vec::new();
        for (driver, &distance) in self.critical.drivers().iter().zip(self.critical.distances()) {
            if let Driver::Edge(facet) = *driver {
                let [p, q] = facets.edges()[facet as usize].map(|v| set[v as usize]);
                if p != q {
                    room.push(&mut openings, (distance, facet))?;
                }
            }
        }
        openings.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut sets = DisjointSets::new(samples as usize + 1, run)?;
        openings.retain(|&(_, facet)| {
            let [p, q] = facets.edges()[facet as usize].map(|v| set[v as usize]);
            sets.join(p, q)
        });
        room.collect(openings.into_iter().map(|(_, facet)| facet))
    }

    fn elements_of_class(&self, class: CriticalClass) -> impl Iterator<Item = FlowElement> + '_ {
        let critical = self.critical.drivers().iter().zip(self.critical.classes());
        critical
            .filter(move |(_, its)| **its == class)
            .flat_map(|(&driver, _)| self.elements_of(driver))
    }

    /// The elements from which the unstable manifold of a critical point is reached: those of its Voronoi face.
    pub(super) fn elements_of(&self, driver: Driver) -> Vec<FlowElement> {
        match driver {
            Driver::Sample(_) => Vec::new(),
            Driver::Edge(facet) => {
                let faces = &self.complex.faces_of_facet;
                (faces[facet as usize]..faces[facet as usize + 1]).map(FlowElement::Face).collect()
            }
            Driver::Triangle(triangle) => {
                let edges = &self.complex.edges_of_triangle;
                let edges = edges[triangle as usize]..edges[triangle as usize + 1];
                edges.map(FlowElement::Edge).collect()
            }
            Driver::Cell(cell) => vec![FlowElement::Vertex(cell)],
        }
    }

    /// The position of a vertex of the flow complex.
    fn place(&self, vertex: u32) -> [f64; 3] {
        let centers = self.dual.centers();
        match centers.get(vertex as usize) {
            Some(center) => *center,
            None => self.complex.points[vertex as usize - centers.len()],
        }
    }

    /// A closed set as a complex, but for what is unbounded.
    fn complex_of(&self, set: &Subset, run: &Run<'_>) -> Result<Complex> {
        let mut room = Room::new(run);
        let complex = &self.complex;
        let mut number = room.filled(set.has_vertex.len(), NONE)?;
        let mut vertices = Vec::new();
        for vertex in run.watch(0..number.len()) {
            let vertex = vertex?;
            if set.has_vertex[vertex] {
                number[vertex] = vertices.len() as u32;
                room.push(&mut vertices, self.place(vertex as u32))?;
            }
        }
        let mut is_side = room.filled(set.has_edge.len(), false)?;
        let mut faces = Rows::default();
        let mut row: Vec<u32> = Vec::new();
        for face in run.watch(0..set.has_face.len()) {
            let face = face?;
            let rim = complex.rim_vertices.row(face);
            if !set.has_face[face] || rim.contains(&NONE) {
                continue;
            }
            let begin = complex.rim_vertices.offsets()[face] as usize;
            for &edge in &complex.rim_edges[begin..begin + rim.len()] {
                is_side[edge as usize] = true;
            }
            row.clear();
            row.extend(rim.iter().map(|&v| number[v as usize]));
            faces.push(&row)?;
        }
        let mut edges = Vec::new();
        for edge in run.watch(0..is_side.len()) {
            let edge = edge?;
            let ends = complex.edges[edge];
            if set.has_edge[edge] && !is_side[edge] && !ends.contains(&NONE) {
                room.push(&mut edges, ends.map(|v| number[v as usize]))?;
            }
        }
        let parts = ComplexParts { vertices, faces, edges, ..ComplexParts::default() };
        Complex::sound_in(parts, run)
    }
}

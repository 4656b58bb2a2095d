//! The checks of the flow and of its complex.

use super::complex::FlowComplex;
use super::simplex::Simplex;
use super::source::Source;
use super::{CriticalPoints, Flow};
use crate::error::{ElementKind, Result};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use crate::validation::Validation;
use crate::vector::{Vec3, cross, dot, length, sub};

/// How far beside the lengths that are compared rounded numbers may be off: centres are rounded once, but those of thin triangles are not.
const SLACK: f64 = 1e-7;

impl Flow {
    /// Checks drivers and critical points from the other side than they were made: the driver of a Voronoi edge or vertex is the nearest point of its simplex if all corners of that lie on the other side of the
    /// plane there; the balls of drivers do not shrink along the flow; critical points are as far from all their samples, and no sample is nearer; they are as many as they can be.
    /// Errors: those of the job. Cost: O(n).
    pub fn validate(&self, job: &Job) -> Result<Validation> {
        job.run(&[(Stage::Validate, 1.0)], |run| {
            run.enter(Stage::Validate)?;
            let source = self.source()?;
            let mut report = Validation::new();
            self.check_triangles(&source, &mut report, run)?;
            self.check_cells(&source, &mut report, run)?;
            check_critical(&source, &self.critical, &mut report, run)?;
            Ok(report)
        })
    }

    fn check_triangles(
        &self,
        source: &Source<'_>,
        report: &mut Validation,
        run: &Run<'_>,
    ) -> Result<()> {
        for triangle in run.watch(0..self.triangles.len() as u32) {
            let triangle = triangle?;
            let own = Simplex::Triangle(triangle);
            let driver = self.driver_of_triangle(triangle);
            let x = source.center_of(own);
            let index = u64::from(triangle);
            report.check(source.is_nearest(x, own, driver), ElementKind::Face, index, || {
                format!("the triangle's driver is not that of {driver:?}")
            });
            let is_side = source.is_side(driver, own);
            report.check(is_side, ElementKind::Face, index, || {
                format!("the triangle's driver is that of {driver:?}, which is none of its sides")
            });
        }
        Ok(())
    }

    fn check_cells(
        &self,
        source: &Source<'_>,
        report: &mut Validation,
        run: &Run<'_>,
    ) -> Result<()> {
        for cell in run.watch(0..self.dual.centers().len() as u32) {
            let cell = cell?;
            let own = Simplex::Cell(cell);
            let driver = self.driver_of_cell(cell);
            let x = self.dual.centers()[cell as usize];
            let right = source.is_side(driver, own) && source.is_nearest(x, own, driver);
            report.check(right, ElementKind::Cell, u64::from(cell), || {
                format!("the cell's driver is not that of {driver:?}")
            });
            for triangle in self.triangles.of_cell[cell as usize] {
                let before = source.radius(self.driver_of_triangle(triangle));
                let grows = source.radius(driver) >= before * (1.0 - SLACK);
                report.check(grows, ElementKind::Cell, u64::from(cell), || {
                    format!("its driver's ball is smaller than that of triangle {triangle}")
                });
            }
        }
        Ok(())
    }
}

impl Source<'_> {
    /// Whether a simplex is another one, or a side of it.
    fn is_side(&self, side: Simplex, of: Simplex) -> bool {
        let corners = self.corners(of);
        self.corners(side).iter().all(|v| *v == NONE || corners.contains(v))
    }

    /// How far rounding moves a centre that lies there, beside samples of the same size.
    fn blur(&self, simplex: Simplex) -> f64 {
        let at = |v: u32| self.dual.triangulation().coords()[v as usize];
        let corner = at(self.corners(simplex)[0]);
        let sizes = corner.into_iter().chain(self.center_of(simplex)).map(f64::abs);
        8.0 * f64::EPSILON * sizes.fold(0.0, f64::max)
    }

    /// Whether a simplex holds its centre, as far as rounded places tell.
    fn holds_center(&self, simplex: Simplex) -> bool {
        if self.blur(simplex) > SLACK * self.radius(simplex) {
            return true;
        }
        let center = self.center_of(simplex);
        let corners = self.corners(simplex);
        let at = |v: u32| sub(self.dual.triangulation().coords()[v as usize], center);
        let count = simplex.dimension() + 1;
        // The centre lies on the same side of each side as the corner opposite.
        (0..count).filter(|_| count > 2).all(|i| {
            let other = |k: usize| at(corners[(i + k) % count]);
            let [p, q] = [other(1), other(2)];
            let along = sub(q, p);
            let normal = match count {
                3 => cross(cross(along, sub(other(0), p)), along),
                _ => cross(along, sub(other(3), p)),
            };
            let (corner, center) = (dot(sub(other(0), p), normal), -dot(p, normal));
            let least = -SLACK * length(p) * length(normal);
            if corner < 0.0 { -center >= least } else { center >= least }
        })
    }

    /// Whether the centre of a side, which it holds, is the point of a simplex nearest to x: seen from x, no corner lies before the plane there.
    fn is_nearest(&self, x: Vec3, of: Simplex, side: Simplex) -> bool {
        if !self.holds_center(side) {
            return false;
        }
        let driver = self.center_of(side);
        let to = sub(x, driver);
        let corners = self.corners(of);
        corners.iter().filter(|&&v| v != NONE).all(|&v| {
            let corner = sub(self.dual.triangulation().coords()[v as usize], driver);
            let reach = length(to) + length(corner);
            let blur = (self.blur(of) + self.blur(side)) * reach;
            // Where a centre is so far that its place is lost, so is the side of the plane.
            dot(to, corner) <= SLACK * reach * length(corner) + blur || !reach.is_finite()
        })
    }
}

fn check_critical(
    source: &Source<'_>,
    critical: &CriticalPoints,
    report: &mut Validation,
    run: &Run<'_>,
) -> Result<()> {
    let t = source.dual.triangulation();
    let incidence = t.incidence_in(run)?;
    let mut sum = 0i64;
    let simplices = critical.simplices();
    for row in run.watch(0..simplices.len()) {
        let row = row?;
        let (at, radius) = (critical.points()[row], critical.distances()[row]);
        sum += [1, -1, 1, -1][simplices[row].dimension()];
        let corners = source.corners(simplices[row]);
        let far = |v: u32| length(sub(t.coords()[v as usize], at));
        let slack = SLACK * radius + source.blur(simplices[row]);
        let even =
            (corners.iter().filter(|&&v| v != NONE)).all(|&v| (far(v) - radius).abs() <= slack);
        let around = incidence.cells_of(corners[0]);
        let mut near = around.iter().flat_map(|&cell| t.cells()[cell as usize]);
        let empty = near.all(|v| far(v) >= radius - slack);
        report.check(even && empty, ElementKind::Row, row as u64, || {
            format!("{:?} is no critical point: its ball is not empty", simplices[row])
        });
    }
    report.check(sum == 1, ElementKind::Row, 0, || {
        format!("c0 - c1 + c2 - c3 of the critical points is {sum}, not 1")
    });
    Ok(())
}

impl FlowComplex {
    /// Checks that the complex is whole, and the flow in it: rims are closed; a part of a Voronoi edge is a side of three faces, a cut of two; with the Voronoi cells and the point at
    /// infinity the complex has the Euler characteristic of the three-sphere; everything flows into what it is a side of, never in a circle, and away from the samples. Errors: those of the job.
    /// Cost: O(size).
    pub fn validate(&self, job: &Job) -> Result<Validation> {
        job.run(&[(Stage::Validate, 1.0)], |run| {
            run.enter(Stage::Validate)?;
            let mut report = Validation::new();
            self.check_rims(&mut report, run)?;
            self.check_vertices(&mut report, run)?;
            self.check_edges(&mut report, run)?;
            Ok(report)
        })
    }

    fn check_rims(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let mut room = Room::new(run);
        let mut sides = room.filled(self.edges().len(), 0u8)?;
        for (face, rim) in run.watch(self.faces().iter().enumerate()).flatten() {
            let begin = self.faces().offsets()[face] as usize;
            let edges = &self.face_edges()[begin..begin + rim.len()];
            let closed = edges.iter().enumerate().all(|(i, &edge)| {
                let step = [rim[i], rim[(i + 1) % rim.len()]];
                let ends = self.edges()[edge as usize];
                ends == step || [ends[1], ends[0]] == step
            });
            report.check(closed, ElementKind::Face, face as u64, || {
                "an edge of its rim does not join the vertices there".into()
            });
            for &edge in edges {
                sides[edge as usize] = sides[edge as usize].saturating_add(1);
            }
        }
        run.poll()?;
        let parts = self.triangle_of_edge().len();
        for (edge, count) in run.watch(sides.into_iter().enumerate()).flatten() {
            let expected = if edge < parts { 3 } else { 2 };
            report.check(count == expected, ElementKind::Edge, edge as u64, || {
                format!("it is a side of {count} faces, not {expected}")
            });
        }
        run.poll()?;
        let samples = self.flow().dual().triangulation().coords().len();
        let sum = self.vertex_count() as i64 + 1 - self.edges().len() as i64
            + self.faces().len() as i64
            - samples as i64;
        report.check(sum == 0, ElementKind::Row, 0, || {
            format!("the Euler characteristic of all is {sum}, not 0")
        });
        Ok(())
    }

    /// The way from vertex to vertex comes to no vertex twice, and leads away from the samples.
    fn check_vertices(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let mut room = Room::new(run);
        let next = |v: u32| match self.edge_of_vertex()[v as usize] {
            NONE => NONE,
            edge => {
                let [from, to] = self.edges()[edge as usize];
                if from == v { to } else { from }
            }
        };
        let sizes = self.flow().dual().triangulation().coords().as_flattened().iter();
        let blur = 8.0 * f64::EPSILON * sizes.fold(0.0, |size: f64, x| size.max(x.abs()));
        // 0 before, 1 on the way, 2 when all beyond is known.
        let mut state = room.filled(self.vertex_count(), 0u8)?;
        let mut way = Vec::new();
        for vertex in run.watch(0..self.vertex_count() as u32) {
            let vertex = vertex?;
            let mut v = vertex;
            while v != NONE && state[v as usize] == 0 {
                state[v as usize] = 1;
                room.push(&mut way, v)?;
                let edge = self.edge_of_vertex()[v as usize];
                let joined = edge == NONE || self.edges()[edge as usize].contains(&v);
                report.check(joined, ElementKind::Vertex, u64::from(v), || {
                    format!("it flows into edge {edge}, which does not end there")
                });
                let (here, there) = (self.distance(v)?, self.distance(next(v))?);
                let grows = there >= here * (1.0 - SLACK) - blur;
                report.check(grows, ElementKind::Vertex, u64::from(v), || {
                    format!("it flows nearer to the samples, from {here} to {there}")
                });
                v = next(v);
            }
            let comes_back = v != NONE && state[v as usize] == 1;
            report.check(!comes_back, ElementKind::Vertex, u64::from(vertex), || {
                "it flows in a circle".into()
            });
            way.drain(..).for_each(|v| state[v as usize] = 2);
        }
        Ok(())
    }

    /// Edges that flow into faces are sides of these, and the way through faces comes to no edge twice.
    fn check_edges(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let mut room = Room::new(run);
        // Each face waits for all edges that flow into it, each edge for all faces whose rim it is on but the one that it flows into.
        let mut awaited = room.filled(self.faces().len(), 0u32)?;
        for (edge, face) in run.watch((0..).zip(self.face_of_edge())).flatten() {
            if *face != NONE {
                awaited[*face as usize] += 1;
                let is_side = self.its.rim_of(*face).contains(&edge);
                report.check(is_side, ElementKind::Edge, u64::from(edge), || {
                    format!("it flows into face {face}, of which it is no side")
                });
            }
        }
        run.poll()?;
        let mut faces_before = room.filled(self.edges().len(), 0u32)?;
        for edge in run.watch(self.face_edges()) {
            faces_before[*edge? as usize] += 1;
        }
        let mut free = room.vec(self.faces().len())?;
        for face in 0..awaited.len() as u32 {
            if awaited[face as usize] == 0 {
                free.push(face);
            }
        }
        let mut done = 0;
        while let Some(face) = free.pop() {
            done += 1;
            if done % 4096 == 0 {
                run.poll()?;
            }
            for &edge in self.its.rim_of(face) {
                let into = self.face_of_edge()[edge as usize];
                if into != NONE && into != face {
                    // The face that it flows into is not before it.
                    faces_before[edge as usize] -= 1;
                    if faces_before[edge as usize] == 1 {
                        awaited[into as usize] -= 1;
                        if awaited[into as usize] == 0 {
                            free.push(into);
                        }
                    }
                }
            }
        }
        report.check(done == self.faces().len(), ElementKind::Row, 0, || {
            format!("{} faces are on or behind a circle of the flow", self.faces().len() - done)
        });
        Ok(())
    }

    /// The distance of a vertex from the samples.
    fn distance(&self, vertex: u32) -> Result<f64> {
        if vertex == NONE {
            return Ok(f64::INFINITY);
        }
        let dual = self.flow().dual();
        if let Some(square) = dual.radii_squared().get(vertex as usize) {
            return Ok(square.sqrt());
        }
        let point = vertex as usize - dual.centers().len();
        let source = self.flow().source()?;
        let corners = source.corners(Simplex::Triangle(self.triangle_of_point()[point]));
        let sample = dual.triangulation().coords()[corners[0] as usize];
        Ok(length(sub(self.points()[point], sample)))
    }
}

//! The scale axis transform: the medial axis without what is small beside what is near.

use super::balls::{self, Ball};
use super::derive::DERIVE;
use super::{Label, PowerCrust};
use crate::complex::{Attribute, CellType, Complex, ComplexParts, Element, Rows, Values};
use crate::dual::{Dual, DualOptions};
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use crate::predicates::WEIGHT_MAX;
use crate::triangulation::{Edges, Triangulation};
use crate::vector::{add, cross, dot, scale, sub};
use std::sync::Arc;

impl PowerCrust {
    /// The scale axis of one side, for a factor of at least 1: the balls of that side grow by the factor, the axis is that of their union, and they
    /// shrink back (Giesen, Miklos, Pauly, Wormser 2009, *The scale axis transform*). What grown balls cover is gone: features that are small beside
    /// what is near, at any scale. With 1 it is the axis of the union of the balls as they are:
    /// samples lie on its boundary then, and rounding makes voids without a size there; a little more than 1 has none.
    ///
    /// The axis of a union of balls is its dual complex (Edelsbrunner 1995, *The union of balls and its dual shape*), with the homotopy type of the
    /// union: the simplices of the balls' regular triangulation whose faces of the power diagram meet the union. Vertices carry `radius` (shrunk back), `pole`,
    /// `label` and `object_angle`, as those of the power shape. Signs of powers at power vertices are exact; those on edges and facets are
    /// rounded.
    ///
    /// Errors: [`Status::InvalidArgument`] for a factor below 1 or one that makes radii of more than 2^200, [`Status::TooFewPoints`] and [`Status::Degenerate`]
    /// where there are too few balls of that side, and those of the job. Cost: one regular triangulation of that side's balls.
    pub fn scale_axis(&self, side: Label, factor: f64, job: &Job) -> Result<Complex> {
        let largest =
            (0..self.poles.len()).filter_map(|pole| self.weight(pole)).fold(0.0, f64::max);
        if !(1.0..f64::INFINITY).contains(&factor) || largest.sqrt() * factor > WEIGHT_MAX.sqrt() {
            let message =
                format!("a scale of {factor:?} is below 1, or makes radii of more than 2^200");
            return Err(Error::new(Status::InvalidArgument, message));
        }
        job.run(&DERIVE, |run| self.scale_axis_in(side, factor, run))
    }

    fn scale_axis_in(&self, side: Label, factor: f64, run: &Run<'_>) -> Result<Complex> {
        let mut room = Room::new(run);
        let ball = |pole: usize| -> Option<Ball> {
            let [x, y, z, _] = self.poles.balls()[pole];
            let weight = self.weight(pole).filter(|_| self.labels[pole] == side)?;
            Some(([x, y, z], weight * factor * factor))
        };
        let regular = Arc::new(balls::regular(&self.poles, ball, run)?);
        room.keep(regular.bytes())?;
        run.enter(Stage::Extract)?;
        let shape = DualComplex::new(&regular, &mut room, run)?;
        self.scaled(side, factor, &regular, shape, run)
    }

    /// The dual complex with the attributes of its poles.
    fn scaled(
        &self,
        side: Label,
        factor: f64,
        regular: &Triangulation,
        mut shape: DualComplex,
        run: &Run<'_>,
    ) -> Result<Complex> {
        let mut room = Room::new(run);
        let kept: Vec<u32> =
            (0..regular.coords().len() as u32).filter(|&v| shape.has_vertex[v as usize]).collect();
        let mut number = room.filled(regular.coords().len(), NONE)?;
        for (i, &vertex) in kept.iter().enumerate() {
            number[vertex as usize] = i as u32;
        }
        let renumber = |rows: &mut [u32]| rows.iter_mut().for_each(|v| *v = number[*v as usize]);
        renumber(shape.edges.as_flattened_mut());
        renumber(shape.triangles.as_flattened_mut());
        renumber(shape.cells.as_flattened_mut());
        let of_kept = kept.iter().map(|&v| v as usize);
        let radius = |v: usize| regular.weights()[v].sqrt() / factor;
        let poles = room.collect(of_kept.clone().map(|v| regular.row_of_vertex()[v]))?;
        let angles =
            room.collect(poles.iter().map(|&pole| self.poles.object_angles()[pole as usize]))?;
        let cell_types = room.filled(shape.cells.len(), CellType::Tetrahedron)?;
        let parts = ComplexParts {
            vertices: room.collect(of_kept.clone().map(|v| regular.coords()[v]))?,
            edges: shape.edges,
            faces: Rows::uniform_in(shape.triangles, &mut room)?,
            cells: Rows::uniform_in(shape.cells, &mut room)?,
            cell_types,
            attributes: vec![
                Attribute::new(
                    "radius",
                    Element::Vertex,
                    1,
                    Values::F64(room.collect(of_kept.map(radius))?),
                )?,
                Attribute::new(
                    "label",
                    Element::Vertex,
                    1,
                    Values::U32(room.filled(poles.len(), side as u32)?),
                )?,
                Attribute::new("pole", Element::Vertex, 1, Values::U32(poles))?,
                Attribute::new("object_angle", Element::Vertex, 1, Values::F64(angles))?,
            ],
            ..Default::default()
        };
        Complex::sound_in(parts, run)
    }
}

/// The dual complex of a union of balls: the edges that no triangle of it has, the triangles, the tetrahedra.
struct DualComplex {
    has_vertex: Vec<bool>,
    edges: Vec<[u32; 2]>,
    triangles: Vec<[u32; 3]>,
    cells: Vec<[u32; 4]>,
}

impl DualComplex {
    /// A simplex belongs to it if one with it as a side does, or if the point of least power on its power face, the foot, is in the inside of that face, and in
    /// the union: no other ball has less power there.
    fn new(t: &Arc<Triangulation>, room: &mut Room<'_>, run: &Run<'_>) -> Result<Self> {
        let dual = Dual::new_in(t, DualOptions::default(), run)?;
        run.enter(Stage::Extract)?;
        let is_cell_in = |cell: u32| dual.radii_squared()[cell as usize] <= 0.0;
        let mut shape = DualComplex {
            has_vertex: room.filled(t.coords().len(), false)?,
            edges: Vec::new(),
            triangles: Vec::new(),
            cells: Vec::new(),
        };
        // Of each cell a bit for every facet that is in.
        let mut facets_in = room.filled(t.cells().len(), 0u8)?;
        for cell in run.watch(0..t.cells().len() as u32) {
            let cell = cell?;
            let corners = t.cells()[cell as usize];
            if is_cell_in(cell) {
                room.push(&mut shape.cells, corners)?;
            }
            for (facet, opposite) in corners.into_iter().enumerate() {
                let neighbor = t.neighbors()[cell as usize][facet];
                if neighbor < cell {
                    continue;
                }
                let triangle = t.facet(cell, facet);
                let apex = |cell: u32| {
                    t.cells()[cell as usize].into_iter().find(|v| !triangle.contains(v))
                };
                let beyond = if neighbor == NONE { None } else { apex(neighbor) };
                let others = [Some(opposite), beyond].into_iter().flatten();
                let is_in = is_cell_in(cell)
                    || (neighbor != NONE && is_cell_in(neighbor))
                    || is_free(t, foot_of_triangle(t, triangle), triangle[0], others);
                if !is_in {
                    continue;
                }
                room.push(&mut shape.triangles, triangle)?;
                triangle.iter().for_each(|&v| shape.has_vertex[v as usize] = true);
                facets_in[cell as usize] |= 1 << facet;
                if neighbor != NONE {
                    let back = t.neighbors()[neighbor as usize].iter().position(|&c| c == cell);
                    facets_in[neighbor as usize] |= back.map_or(0, |slot| 1 << slot);
                }
            }
        }
        let incidence = t.incidence_in(run)?;
        let edges = t.edges_in(&incidence, run)?;
        shape.add_edges(t, &edges, &facets_in, room, run)?;
        for vertex in run.watch(0..t.coords().len() as u32) {
            let vertex = vertex?;
            let cells = incidence.cells_of(vertex);
            let others = cells.iter().flat_map(|&cell| t.cells()[cell as usize]);
            let is_in =
                !cells.is_empty() && is_free(t, t.coords()[vertex as usize], vertex, others);
            shape.has_vertex[vertex as usize] |= is_in;
        }
        Ok(shape)
    }

    fn add_edges(
        &mut self,
        t: &Triangulation,
        edges: &Edges,
        facets_in: &[u8],
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<()> {
        let mut ring = Vec::new();
        for edge in run.watch(edges.ends.iter().zip(&edges.cells)) {
            let (&[a, b], &cell) = edge?;
            t.ring(cell, a, b, &mut ring);
            let has_triangle = ring.iter().any(|&cell| {
                let corners = t.cells()[cell as usize];
                (0..4).any(|facet| {
                    facets_in[cell as usize] >> facet & 1 == 1
                        && corners[facet] != a
                        && corners[facet] != b
                })
            });
            let link = ring.iter().flat_map(|&cell| t.cells()[cell as usize]);
            if !has_triangle && is_free(t, foot_of_edge(t, [a, b]), a, link) {
                room.push(&mut self.edges, [a, b])?;
                self.has_vertex[a as usize] = true;
                self.has_vertex[b as usize] = true;
            }
        }
        Ok(())
    }
}

/// The power of a point to a ball.
fn power(t: &Triangulation, at: [f64; 3], vertex: u32) -> f64 {
    let to = sub(at, t.coords()[vertex as usize]);
    dot(to, to) - t.weights()[vertex as usize]
}

/// Whether a foot is in a ball, and none of the others has less power there.
fn is_free(
    t: &Triangulation,
    foot: [f64; 3],
    vertex: u32,
    mut others: impl Iterator<Item = u32>,
) -> bool {
    let own = power(t, foot, vertex);
    own <= 0.0 && others.all(|other| power(t, foot, other) >= own - 1e-12 * own.abs())
}

/// The point of an edge's line that has the same power to both ends.
fn foot_of_edge(t: &Triangulation, [a, b]: [u32; 2]) -> [f64; 3] {
    let [p, q] = [a, b].map(|v| t.coords()[v as usize]);
    let along = sub(q, p);
    let square = dot(along, along);
    let share = (square + t.weights()[a as usize] - t.weights()[b as usize]) / (2.0 * square);
    add(p, scale(along, share))
}

/// The point of a triangle's plane that has the same power to all its corners.
fn foot_of_triangle(t: &Triangulation, corners: [u32; 3]) -> [f64; 3] {
    let [p, q, r] = corners.map(|v| t.coords()[v as usize]);
    let [wp, wq, wr] = corners.map(|v| t.weights()[v as usize]);
    let (u, v) = (sub(q, p), sub(r, p));
    let normal = cross(u, v);
    let (of_u, of_v) = (dot(u, u) + wp - wq, dot(v, v) + wp - wr);
    let sum = add(scale(cross(v, normal), of_u), scale(cross(normal, u), of_v));
    add(p, scale(sum, 1.0 / (2.0 * dot(normal, normal))))
}

//! The axis as a complex: the facets that a filter lets pass, and their closure.

use super::clip::{Clip, Corner, Crossings};
use super::filter::fulfilled;
use super::{Medial, MedialFilter, Side};
use crate::complex::{Attribute, Complex, ComplexParts, Element, Rows, Values};
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage, parts};
use crate::labels::Labels;
use crate::vector::{length, sub};
use std::sync::Arc;

impl Medial {
    /// The facets that a filter lets pass, ascending.
    ///
    /// Errors: [`Status::InvalidArgument`] for thresholds out of range, and for an inner or an outer side without
    /// labels; [`Status::CoordinateRange`] for a box beyond 2^200; those of the job. Cost: O(facets), a look at each.
    pub fn selected(&self, filter: &MedialFilter, job: &Job) -> Result<Vec<u32>> {
        job.run(&[(Stage::Extract, 1.0)], |run| {
            run.enter(Stage::Extract)?;
            filter.check(self)?;
            self.selected_in(filter, &mut Room::new(run), run)
        })
    }

    fn selected_in(
        &self,
        filter: &MedialFilter,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Vec<u32>> {
        let facets = self.facets()?;
        let coords = self.dual.triangulation().coords();
        let sine = libm::sin(filter.theta);
        // An object angle of a: half the edge by the distance from its middle is the tangent of a / 2.
        let half = libm::tan(filter.object_angle / 2.0);
        let passes = |facet: usize| {
            let fulfilled = fulfilled(
                self.conditions.sines[facet],
                self.conditions.ratios[facet],
                sine,
                filter.rho,
            );
            if !filter.rule.admits(fulfilled) {
                return false;
            }
            if filter.object_angle > 0.0 || filter.lambda > 0.0 {
                let [p, q] = facets.edges()[facet].map(|v| coords[v as usize]);
                let lambda = length(sub(q, p)) / 2.0;
                if lambda < filter.lambda || lambda < half * self.reaches[facet][0] {
                    return false;
                }
            }
            if filter.scale > 0.0 {
                let mut scales = facets.ring(facet).iter().map(|&cell| self.scales[cell as usize]);
                if !scales.any(|scale| scale > filter.scale) {
                    return false;
                }
            }
            filter.side == Side::Both || self.side_of(facets.ring(facet), facet) == filter.side
        };
        let pieces = run.in_steps(parts(facets.len()), [0.0, 0.4], |range| {
            run.poll()?;
            let mut room = Room::new(run);
            let mut selected = Vec::new();
            for facet in range.filter(|&facet| passes(facet)) {
                room.push(&mut selected, facet as u32)?;
            }
            Ok((selected, room))
        })?;
        let mut selected = room.vec(pieces.iter().map(|(piece, _)| piece.len()).sum())?;
        pieces.into_iter().for_each(|(piece, _)| selected.extend(piece));
        Ok(selected)
    }

    /// The side of a facet; both where there are no labels.
    fn side_of(&self, ring: &[u32], facet: usize) -> Side {
        let is_unbounded = self.dual.facets().is_some_and(|facets| facets.is_unbounded(facet));
        let of = |labels: &Arc<Labels>| Side::of(labels, ring, is_unbounded);
        self.labels.as_ref().map_or(Side::Both, of)
    }

    /// The axis: the Voronoi facets that a filter lets pass, with their edges and vertices, as convex polygons.
    ///
    /// Vertices are Voronoi vertices, one for all cells that share a sphere, and carry `cell`, the least of these, or [`NONE`] where a box has cut, `radius`, that of the ball round
    /// them through their samples, and `scale` if scales were calculated. Faces are in the order of the facets and turn counterclockwise as seen from the second sample; they carry
    /// `facet`, `samples` (the two ends of the dual edge), `condition` (1 the angle condition, 2 the ratio condition, 3 both, 0 neither), `object_angle` (the least and
    /// the largest on the face, in radians, in [0, pi]), `lambda` (half the length of the dual edge) and `side` (0 outer, 1 inner, 2 for one that
    /// crosses the surface or where there are no labels). Facets that have no area, since their cells share spheres, are no faces. Of a facet that only touches the box
    /// nothing is left.
    ///
    /// Errors: as [`Medial::selected`]. Cost: O(facets), and O(size) of what passes.
    pub fn axis(&self, filter: &MedialFilter, job: &Job) -> Result<Complex> {
        job.run(&[(Stage::Extract, 1.0)], |run| {
            run.enter(Stage::Extract)?;
            self.axis_in(filter, run)
        })
    }

    /// [`Medial::axis`] as a stage of a larger build.
    pub(crate) fn axis_in(&self, filter: &MedialFilter, run: &Run<'_>) -> Result<Complex> {
        filter.check(self)?;
        let mut room = Room::new(run);
        let selected = self.selected_in(filter, &mut room, run)?;
        let mut faces = Faces::default();
        match filter.clip {
            None => self.bounded_faces(&selected, &mut faces, &mut room, run)?,
            Some(clip) => self.clipped_faces(&selected, clip, &mut faces, &mut room, run)?,
        }
        drop(selected);
        self.complex(faces, filter, run)
    }

    /// The facets that are bounded and have an area.
    fn bounded_faces(
        &self,
        selected: &[u32],
        faces: &mut Faces,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<()> {
        let facets = self.facets()?;
        let mut number = room.filled(self.least_cell.len(), NONE)?;
        let mut ring = Vec::new();
        for facet in run.watch(selected) {
            let &facet = facet?;
            if facets.is_unbounded(facet as usize) {
                continue;
            }
            corners(&self.least_cell, facets.ring(facet as usize), &mut ring);
            if ring.len() < 3 {
                continue;
            }
            let sample = facets.edges()[facet as usize][0];
            for cell in &mut ring {
                let at = self.dual.centers()[*cell as usize];
                *cell = faces.vertex(*cell, at, sample, &mut number, room)?;
            }
            faces.push(facet, &ring, room)?;
        }
        Ok(())
    }

    /// What of the facets lies in a box and has an area.
    fn clipped_faces(
        &self,
        selected: &[u32],
        clip: [[f64; 3]; 2],
        faces: &mut Faces,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<()> {
        let facets = self.facets()?;
        let mut number = room.filled(self.least_cell.len(), NONE)?;
        let mut clip = Clip::new(&self.dual, facets, &self.least_cell, clip, room, run)?;
        let mut crossings = Crossings::default();
        let mut ring = Vec::new();
        for &facet in selected {
            let corners = clip.cut(facet as usize, run)?;
            if corners.len() < 3 {
                continue;
            }
            ring.clear();
            let sample = facets.edges()[facet as usize][0];
            for (corner, at) in corners {
                let next = faces.cells.len() as u32;
                let vertex = match corner {
                    Corner::Vertex(cell) => faces.vertex(cell, at, sample, &mut number, room)?,
                    Corner::Crossing(line, plane) => crossings.number(line, plane, next, room)?,
                    Corner::Own => next,
                };
                // New, and no Voronoi vertex.
                if vertex as usize == faces.cells.len() {
                    faces.add_corner(NONE, at, sample, room)?;
                }
                ring.push(vertex);
            }
            faces.push(facet, &ring, room)?;
        }
        Ok(())
    }

    /// The faces with their attributes.
    fn complex(&self, faces: Faces, filter: &MedialFilter, run: &Run<'_>) -> Result<Complex> {
        let mut room = Room::new(run);
        let dual = &self.dual;
        let facets = self.facets()?;
        let coords = dual.triangulation().coords();
        let Faces { cells, positions: vertices, samples: touched, .. } = faces;
        let of_vertices = cells.iter().zip(&vertices).zip(&touched);
        let radii = room.collect(of_vertices.map(|((&cell, &at), &sample)| match cell {
            NONE => length(sub(at, coords[sample as usize])),
            cell => dual.radii_squared()[cell as usize].sqrt(),
        }))?;
        let mut attributes =
            vec![Attribute::new("radius", Element::Vertex, 1, Values::F64(radii))?];
        if !self.scales.is_empty() {
            let scale = |&cell: &u32| self.scales.get(cell as usize).copied().unwrap_or(f64::NAN);
            let scales = room.collect(cells.iter().map(scale))?;
            attributes.push(Attribute::new("scale", Element::Vertex, 1, Values::F64(scales))?);
        }
        let sine = libm::sin(filter.theta);
        let count = faces.facets.len();
        let mut samples = room.vec(2 * count)?;
        let (mut angles, mut lambdas) = (room.vec(2 * count)?, room.vec(count)?);
        let (mut conditions, mut sides) = (room.vec(count)?, room.vec(count)?);
        for facet in run.watch(faces.facets.iter().map(|&facet| facet as usize)) {
            let facet = facet?;
            let ends = facets.edges()[facet];
            let [p, q] = ends.map(|v| coords[v as usize]);
            let lambda = length(sub(q, p)) / 2.0;
            samples.extend(ends);
            lambdas.push(lambda);
            let [near, far] = self.reaches[facet];
            angles.extend([far, near].map(|reach| 2.0 * libm::atan2(lambda, reach)));
            let of_facet = (self.conditions.sines[facet], self.conditions.ratios[facet]);
            conditions.push(fulfilled(of_facet.0, of_facet.1, sine, filter.rho));
            sides.push(self.side_of(facets.ring(facet), facet) as u32);
        }
        let mut add = |name: &str, element, width, values| -> Result<()> {
            attributes.push(Attribute::new(name, element, width, values)?);
            Ok(())
        };
        add("cell", Element::Vertex, 1, Values::U32(cells))?;
        add("facet", Element::Face, 1, Values::U32(faces.facets))?;
        add("samples", Element::Face, 2, Values::U32(samples))?;
        add("condition", Element::Face, 1, Values::U32(conditions))?;
        add("object_angle", Element::Face, 2, Values::F64(angles))?;
        add("lambda", Element::Face, 1, Values::F64(lambdas))?;
        add("side", Element::Face, 1, Values::U32(sides))?;
        let faces = Rows::new(faces.offsets, faces.indices)?;
        Complex::sound_in(ComplexParts { vertices, faces, attributes, ..Default::default() }, run)
    }
}

/// The distinct Voronoi vertices of a ring of cells, each by its least cell.
pub(super) fn corners(least_cell: &[u32], ring: &[u32], corners: &mut Vec<u32>) {
    corners.clear();
    corners.extend(ring.iter().map(|&cell| least_cell[cell as usize]));
    corners.dedup();
    while corners.len() > 1 && corners.first() == corners.last() {
        corners.pop();
    }
}

/// Polygons, and the Voronoi facet of each; corners, each with its cell, or [`NONE`] where a box has cut, its place, and a sample on
/// the ball round it.
struct Faces {
    facets: Vec<u32>,
    offsets: Vec<u32>,
    indices: Vec<u32>,
    cells: Vec<u32>,
    positions: Vec<[f64; 3]>,
    samples: Vec<u32>,
}

impl Default for Faces {
    fn default() -> Self {
        Faces {
            facets: Vec::new(),
            offsets: vec![0],
            indices: Vec::new(),
            cells: Vec::new(),
            positions: Vec::new(),
            samples: Vec::new(),
        }
    }
}

impl Faces {
    /// The number of a Voronoi vertex, by its least cell.
    fn vertex(
        &mut self,
        cell: u32,
        at: [f64; 3],
        sample: u32,
        numbers: &mut [u32],
        room: &mut Room<'_>,
    ) -> Result<u32> {
        let number = &mut numbers[cell as usize];
        if *number == NONE {
            *number = self.cells.len() as u32;
            self.add_corner(cell, at, sample, room)?;
        }
        Ok(*number)
    }

    fn add_corner(
        &mut self,
        cell: u32,
        at: [f64; 3],
        sample: u32,
        room: &mut Room<'_>,
    ) -> Result<()> {
        room.push(&mut self.cells, cell)?;
        room.push(&mut self.positions, at)?;
        room.push(&mut self.samples, sample)
    }

    fn push(&mut self, facet: u32, ring: &[u32], room: &mut Room<'_>) -> Result<()> {
        room.push(&mut self.facets, facet)?;
        room.grow(&mut self.indices, ring.len())?;
        self.indices.extend_from_slice(ring);
        let end = u32::try_from(self.indices.len())
            .map_err(|_| Error::new(Status::LimitExceeded, "more than 2^32 - 1 indices"))?;
        room.push(&mut self.offsets, end)
    }
}

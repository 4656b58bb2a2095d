//! Places in a pair-mesh: from points to elements and back.

use super::PairMesh;
use crate::complex::{Hierarchy, Simplex};
use crate::error::{ElementKind, Result};
use crate::index::NONE;
use crate::job::{Job, PART, Room, Run, Stage};
use crate::points::{Bounds, check_coordinates};
use crate::predicates::orient3d;
use crate::vector::{Vec3, add, cross, dot, scale, sub};

/// A point of the solid: a tetrahedron of an element, and how much each of its corners weighs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairPlace {
    /// The element, or [`NONE`] for a point outside the solid.
    pub element: u32,
    /// The number of its tetrahedron, as [`PairMesh::piece`] takes it.
    pub piece: u32,
    /// Barycentric coordinates; their sum is 1.
    pub weights: [f64; 4],
    /// How far the point is on the way from the inner structure (0) to the boundary (1).
    pub t: f64,
}

impl Default for PairPlace {
    fn default() -> Self {
        PairPlace { element: NONE, piece: 0, weights: [f64::NAN; 4], t: f64::NAN }
    }
}

impl PairMesh {
    /// The place of each point; of several elements that share it the least. Which tetrahedron holds a point is decided exactly.
    ///
    /// Errors: [`Status::NonFinite`](crate::Status::NonFinite) and [`Status::CoordinateRange`](crate::Status::CoordinateRange) with the row of a point; those of the job. Cost: O(size log size) for a hierarchy of boxes, then about O(log size) for each point: ask for many at once.
    pub fn locate(&self, points: &[Vec3], job: &Job) -> Result<Vec<PairPlace>> {
        job.run(&[(Stage::Query, 1.0)], |run| {
            run.enter(Stage::Query)?;
            self.locate_in(points, run)
        })
    }

    pub(crate) fn locate_in(&self, points: &[Vec3], run: &Run<'_>) -> Result<Vec<PairPlace>> {
        let mut room = Room::new(run);
        for (row, &point) in (0..).zip(points) {
            check_coordinates(point).map_err(|error| error.at(ElementKind::Row, row))?;
        }
        let (hierarchy, pieces) = self.hierarchy(&mut room, run)?;
        let mut places = room.filled(points.len(), PairPlace::default())?;
        let chunks = places.chunks_mut(PART / 64).zip(points.chunks(PART / 64)).collect();
        run.in_steps(chunks, [0.3, 1.0], |(places, points)| {
            for (place, &point) in places.iter_mut().zip(points) {
                run.poll()?;
                let mut least = NONE;
                hierarchy.meeting(&Bounds { min: point, max: point }, |simplex| {
                    if simplex.tag < least && holds(&simplex.corners, point) {
                        least = simplex.tag;
                    }
                });
                if least != NONE {
                    let [element, piece] = pieces[least as usize];
                    *place = self.place_in(element, piece, point);
                }
            }
            Ok(())
        })?;
        Ok(places)
    }

    /// The point at a place.
    pub fn position(&self, place: &PairPlace) -> Vec3 {
        let corners = self.piece(place.element, place.piece).map(|v| self.place_of(v));
        let weighted = corners.into_iter().zip(place.weights);
        weighted.fold([0.0; 3], |sum, (corner, weight)| add(sum, scale(corner, weight)))
    }

    /// Every tetrahedron in a hierarchy of boxes, with its element and its number there.
    fn hierarchy(
        &self,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<(Hierarchy<4>, Vec<[u32; 2]>)> {
        let (mut simplices, mut pieces) = (Vec::new(), Vec::new());
        for element in run.watch(0..self.element_count() as u32) {
            let element = element?;
            for piece in 0..self.piece_count(element) {
                let corners = self.piece(element, piece).map(|v| self.place_of(v));
                room.push(&mut simplices, Simplex { corners, tag: pieces.len() as u32 })?;
                room.push(&mut pieces, [element, piece])?;
            }
        }
        Ok((Hierarchy::new(&simplices, room, run)?, pieces))
    }

    fn place_in(&self, element: u32, piece: u32, point: Vec3) -> PairPlace {
        let vertices = self.piece(element, piece);
        let corners = vertices.map(|v| self.place_of(v));
        let weights = weights(&corners, point);
        let on_boundary = vertices.iter().zip(weights);
        let t = on_boundary.filter(|(v, _)| (**v as usize) < self.boundary.len());
        PairPlace { element, piece, weights, t: t.map(|(_, weight)| weight).sum() }
    }
}

/// Whether a tetrahedron, positively oriented, holds a point.
fn holds([a, b, c, d]: &[Vec3; 4], p: Vec3) -> bool {
    let faces = [[&p, b, c, d], [a, &p, c, d], [a, b, &p, d], [a, b, c, &p]];
    faces.into_iter().all(|[a, b, c, d]| !orient3d(a, b, c, d).is_negative())
        && orient3d(a, b, c, d).is_positive()
}

/// The barycentric coordinates of a point in a tetrahedron that holds it.
fn weights(corners: &[Vec3; 4], p: Vec3) -> [f64; 4] {
    let [a, b, c, d] = corners.map(|corner| sub(corner, p));
    let volume = |x: Vec3, y: Vec3, z: Vec3| dot(cross(x, y), z).max(0.0);
    let parts = [volume(b, c, d), volume(a, d, c), volume(a, b, d), volume(a, c, b)];
    let sum: f64 = parts.iter().sum();
    if sum > 0.0 { parts.map(|part| part / sum) } else { [0.25; 4] }
}

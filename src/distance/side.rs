//! Inside and outside.

use super::piece::Piece;
use super::sites::Sites;
use crate::complex::{Complex, answers};
use crate::error::{ElementKind, Error, Result, Status};
use crate::job::{Job, Room, Run, Stage};
use crate::medial::Side;
use crate::predicates::coplanar_orientation;
use crate::vector::Vec3;
use std::sync::Arc;

/// What tells the inside from the outside.
#[derive(Clone, Debug, Default)]
pub(super) enum Solid {
    /// Nothing: all is outside.
    #[default]
    None,
    /// In the plane: pieces marked as parts of closed curves. A point is inside if a ray from it crosses an odd number of times.
    Curves(Vec<bool>),
    /// In space: faces that point out of the solid. A point is inside if they wind round it more than half a time.
    Mesh(Arc<Complex>),
}

impl Sites {
    /// Whether each point lies inside: in the plane where a ray from there crosses closed curves an odd number of times, decided exactly; in space where the faces wind round it more than
    /// half a time ([`Complex::winding_numbers`]), so that they must point out of the solid. Nothing lies inside of open curves, lines, points, polygon soup without such faces.
    ///
    /// Errors: [`Status::NonFinite`] and [`Status::CoordinateRange`] with the row of a point; those of the job.
    pub fn is_inside(&self, points: &[[f64; 3]], job: &Job) -> Result<Vec<bool>> {
        job.run(&[(Stage::Query, 1.0)], |run| {
            run.enter(Stage::Query)?;
            for (row, point) in (0..).zip(run.watch(points)) {
                if !point?.iter().all(|x| x.is_finite()) {
                    let error = Error::new(Status::NonFinite, "a coordinate is NaN or infinite");
                    return Err(error.at(ElementKind::Row, row));
                }
            }
            self.is_inside_in(points, run)
        })
    }

    /// [`Sites::is_inside`] for points that are finite.
    pub(super) fn is_inside_in(&self, points: &[Vec3], run: &Run<'_>) -> Result<Vec<bool>> {
        let mut room = Room::new(run);
        match &self.solid {
            Solid::None => room.filled(points.len(), false),
            Solid::Curves(is_closed) => {
                let inside = |p| self.is_within(is_closed, p);
                answers(points, ElementKind::Row, [0.0, 1.0], &mut room, run, inside)
            }
            Solid::Mesh(mesh) => {
                let numbers = mesh.winding_numbers_in(points.len(), |row| points[row], run)?;
                room.collect(numbers.iter().map(|&number| number > 0.5))
            }
        }
    }

    /// Whether points that are finite lie on a side.
    pub(super) fn are_on(&self, side: Side, points: &[Vec3], run: &Run<'_>) -> Result<Vec<bool>> {
        if side == Side::Both {
            return Room::new(run).filled(points.len(), true);
        }
        let mut is_inside = self.is_inside_in(points, run)?;
        is_inside.iter_mut().for_each(|inside| *inside = *inside == (side == Side::Inner));
        Ok(is_inside)
    }

    /// Whether one point of the plane lies inside of closed curves.
    fn is_within(&self, is_closed: &[bool], p: Vec3) -> bool {
        let mut crossed = 0;
        self.tree().to_the_right(p, |piece| {
            if is_closed[piece as usize] {
                crossed += usize::from(match self.pieces()[piece as usize] {
                    Piece::Segment([a, b]) => crosses(p, a, b),
                    Piece::Sphere(center, radius) => {
                        libm::hypot(p[0] - center[0], p[1] - center[1]) < radius
                    }
                    _ => false,
                });
            }
        });
        crossed % 2 == 1
    }
}

/// Whether the ray from a point to the right crosses a segment, which has its lower end and not its upper one.
fn crosses(p: Vec3, a: Vec3, b: Vec3) -> bool {
    let (low, high) = if a[1] <= b[1] { (a, b) } else { (b, a) };
    low[1] <= p[1] && p[1] < high[1] && coplanar_orientation(&low, &high, &p).is_positive()
}

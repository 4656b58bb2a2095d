//! What can be nearest: points, segments, rays, lines, triangles, spheres.

use crate::error::{Error, Result, Status};
use crate::points::{Bounds, COORDINATE_MAX};
use crate::vector::Vec3;

/// A piece of a boundary. In the plane every z is 0, and a sphere is a circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Piece {
    /// A point.
    Point(Vec3),
    /// The points between two ends; one point if these are equal.
    Segment([Vec3; 2]),
    /// An origin, and the way into which all else lies, of any length but 0.
    Ray(Vec3, Vec3),
    /// A point of it, and its direction, of any length but 0.
    Line(Vec3, Vec3),
    /// Three corners. One without area is its longest side.
    Triangle([Vec3; 3]),
    /// The centre, and the radius, which is positive: the surface alone, not the ball.
    Sphere(Vec3, f64),
}

/// The nearest point of a piece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foot {
    /// Where it lies.
    pub point: Vec3,
    /// Its distance, squared.
    pub distance_squared: f64,
    /// Of which piece it is.
    pub piece: u32,
}

impl Piece {
    /// The smallest box round it; `None` for what is unbounded.
    pub fn bounds(&self) -> Option<Bounds> {
        match *self {
            Piece::Point(p) => Some(Bounds { min: p, max: p }),
            Piece::Segment(ends) => Bounds::of(ends.into_iter()),
            Piece::Triangle(corners) => Bounds::of(corners.into_iter()),
            Piece::Sphere(center, r) => {
                Some(Bounds { min: center.map(|x| x - r), max: center.map(|x| x + r) })
            }
            Piece::Ray(..) | Piece::Line(..) => None,
        }
    }

    /// The same with 0 for every -0.
    pub(super) fn normalized(self) -> Self {
        let plain = |p: Vec3| p.map(|x| x + 0.0);
        match self {
            Piece::Point(p) => Piece::Point(plain(p)),
            Piece::Segment(ends) => Piece::Segment(ends.map(plain)),
            Piece::Ray(origin, along) => Piece::Ray(plain(origin), plain(along)),
            Piece::Line(origin, along) => Piece::Line(plain(origin), plain(along)),
            Piece::Triangle(corners) => Piece::Triangle(corners.map(plain)),
            Piece::Sphere(center, radius) => Piece::Sphere(plain(center), radius),
        }
    }

    /// Errors: [`Status::NonFinite`], [`Status::CoordinateRange`] beyond 2^200, [`Status::InvalidArgument`] for a direction or a radius without meaning, and for what does not lie in the plane.
    pub(super) fn check(&self, dimension: u32) -> Result<()> {
        let (vectors, radius) = match *self {
            Piece::Point(p) => ([p; 3], None),
            Piece::Segment([p, q]) | Piece::Ray(p, q) | Piece::Line(p, q) => ([p, q, q], None),
            Piece::Triangle(corners) => (corners, None),
            Piece::Sphere(center, radius) => ([center; 3], Some(radius)),
        };
        let numbers = || vectors.iter().flatten().copied().chain(radius);
        if numbers().any(|x| !x.is_finite()) {
            return Err(Error::new(Status::NonFinite, "a coordinate is NaN or infinite"));
        }
        if numbers().any(|x| x.abs() > COORDINATE_MAX) {
            return Err(Error::new(Status::CoordinateRange, "a coordinate lies beyond 2^200"));
        }
        let is_triangle = matches!(self, Piece::Triangle(_));
        let is_still = matches!(self, Piece::Ray(..) | Piece::Line(..)) && vectors[1] == [0.0; 3];
        let problem = match dimension {
            _ if is_still => "a direction has no length",
            _ if radius.is_some_and(|radius| radius <= 0.0) => "a radius is not positive",
            2 if is_triangle => "a triangle is no boundary in the plane",
            2 if vectors.iter().any(|v| v[2] != 0.0) => "a piece of a plane figure has a z",
            _ => return Ok(()),
        };
        Err(Error::new(Status::InvalidArgument, problem))
    }
}

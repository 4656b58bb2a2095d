//! The features of a boundary in the plane: sides of segments, fans round corners and points, sides of circles.

use crate::distance::closest::on_segment;
use crate::vector::{Vec3, add, cross, dot, length, scale, sub};
use std::f64::consts::TAU;

/// More than angles err: so little beside a tangent, a point is as far from its end as from the rest, but for rounding.
const ROUNDING: f64 = 1e-7;

/// A part of a boundary as seen from the region on its left, with a place on it for each number from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Feature {
    /// The left of a segment, from its first end to the second.
    Side { ends: [Vec3; 2] },
    /// A point, seen from the directions of a sector: its first direction as an angle, and how far it turns, clockwise.
    Fan { at: Vec3, first: f64, turn: f64 },
    /// A circle, seen from within, counterclockwise, or from without, clockwise.
    Circle { center: Vec3, radius: f64, is_inside: bool },
}

/// A place on a feature: a point of the boundary, and the way from there into the region, at right angles to the boundary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    pub at: Vec3,
    pub way: Vec3,
}

impl Feature {
    pub fn place(&self, u: f64) -> Place {
        match *self {
            Feature::Side { ends: [a, b] } => {
                let along = sub(b, a);
                let at =
                    if u < 0.5 { add(a, scale(along, u)) } else { sub(b, scale(along, 1.0 - u)) };
                Place { at, way: left(along) }
            }
            Feature::Fan { at, first, turn } => Place { at, way: direction(first - u * turn) },
            Feature::Circle { center, radius, is_inside } => {
                let out = direction(if is_inside { u * TAU } else { -u * TAU });
                let at = add(center, scale(out, radius));
                Place { at, way: if is_inside { scale(out, -1.0) } else { out } }
            }
        }
    }

    /// The place from which a point of the region is seen, as a number from 0 to 1; what lies beyond the ends is moved to them.
    pub fn number(&self, p: Vec3) -> f64 {
        match *self {
            Feature::Side { ends: [a, b] } => {
                let along = sub(b, a);
                (dot(sub(p, a), along) / dot(along, along)).clamp(0.0, 1.0)
            }
            Feature::Fan { at, first, turn } => {
                let back = (first - angle(sub(p, at))).rem_euclid(TAU);
                // What lies outside is nearer to the one end or to the other.
                match back > turn {
                    true if back - turn < TAU - back => 1.0,
                    true => 0.0,
                    false => back / turn,
                }
            }
            Feature::Circle { center, is_inside, .. } => {
                let turned = angle(sub(p, center)) / TAU;
                (if is_inside { turned } else { -turned }).rem_euclid(1.0)
            }
        }
    }

    /// Whether a point lies in the sector of a fan, or next to it but for rounding.
    pub fn is_seen_from(&self, p: Vec3) -> bool {
        match *self {
            Feature::Fan { at, first, turn } => {
                let back = (first - angle(sub(p, at))).rem_euclid(TAU);
                back <= turn + ROUNDING || back >= TAU - ROUNDING
            }
            Feature::Side { .. } | Feature::Circle { .. } => true,
        }
    }

    /// How far away a point is.
    pub fn distance(&self, p: Vec3) -> f64 {
        match *self {
            Feature::Side { ends: [a, b] } => length(sub(p, on_segment(p, a, b))),
            Feature::Fan { at, .. } => length(sub(p, at)),
            Feature::Circle { center, radius, .. } => (length(sub(p, center)) - radius).abs(),
        }
    }

    /// The radius of the ball that touches a place from the region, and this feature, or the line or the point that bears it; infinity if there is none.
    pub fn radius_from(&self, place: &Place) -> f64 {
        let radius = match *self {
            Feature::Side { ends: [a, b] } => {
                let normal = left(sub(b, a));
                let denominator = 1.0 - dot(normal, place.way);
                dot(normal, sub(place.at, a)) / denominator
            }
            Feature::Fan { at, .. } => {
                let to = sub(at, place.at);
                dot(to, to) / (2.0 * dot(place.way, to))
            }
            Feature::Circle { center, radius, is_inside } => {
                let from = sub(place.at, center);
                let sign = if is_inside { -1.0 } else { 1.0 };
                let power = dot(from, from) - radius * radius;
                power / (2.0 * (sign * radius - dot(place.way, from)))
            }
        };
        if radius >= 0.0 { radius } else { f64::INFINITY }
    }
}

/// The unit vector at the left of a direction.
fn left(along: Vec3) -> Vec3 {
    let size = length(along);
    [-along[1] / size, along[0] / size, 0.0]
}

/// The unit vector at an angle.
fn direction(angle: f64) -> Vec3 {
    [libm::cos(angle), libm::sin(angle), 0.0]
}

/// The angle of a vector.
pub(super) fn angle(v: Vec3) -> f64 {
    libm::atan2(v[1], v[0])
}

/// How far one vector is turned clockwise from another, in (0, 2 pi], exact where the two have one direction.
pub(super) fn clockwise(from: Vec3, to: Vec3) -> f64 {
    let (turned, ahead) = (-cross(from, to)[2], dot(from, to));
    let turn = libm::atan2(turned, ahead);
    if turn > 0.0 { turn } else { turn + TAU }
}

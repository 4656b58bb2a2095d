//! Finding points of the medial axis along segments whose ends have different nearest points.

use super::closest::Shape;
use super::piece::Foot;
use super::sites::Sites;
use crate::vector::{Vec3, add, cross, dot, length, scale, sub};

/// The steps of a search, which halve what is left or do better.
const STEPS: usize = 200;
/// The first steps, which nearly always are enough without halving.
const EAGER: usize = 10;

/// A point that is as far from two points of the boundary, and no nearer to any other.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MedialPoint {
    /// Where it lies.
    pub center: [f64; 3],
    /// Its distance from the boundary: the radius of the medial ball.
    pub radius: f64,
    /// Two of its nearest points of the boundary.
    pub feet: [[f64; 3]; 2],
    /// The pieces that have them.
    pub pieces: [u32; 2],
    /// The angle between the ways to the two, in radians.
    pub object_angle: f64,
}

/// How near is near.
#[derive(Clone, Copy, Debug)]
pub(super) struct Search<'a> {
    pub sites: &'a Sites,
    /// Two nearest points no farther apart than this are the same.
    pub tolerance: f64,
    /// How far a point may be from the medial axis.
    pub epsilon: f64,
    /// Two points of the boundary that a ball of radius 1 touches, and that are no farther apart than this, are the same.
    pub blur: f64,
}

impl Search<'_> {
    /// Whether two nearest points are the same, and so are the gradients there, seen from one line through them.
    pub fn is_same(&self, a: Vec3, b: Vec3) -> bool {
        let way = sub(a, b);
        dot(way, way) <= self.tolerance * self.tolerance
    }

    /// Whether a ball of this radius, as far as can be told, touches two points.
    fn are_two(&self, a: &Foot, b: &Foot, radius: f64) -> bool {
        let (way, blur) = (sub(a.point, b.point), self.blur * radius);
        dot(way, way) > blur * blur && !self.is_same(a.point, b.point)
    }

    /// The first point of the medial axis on a ray from a point of the boundary, between two distances from it; at the first one this point must be the nearest one. `None` if it still
    /// is at the second.
    ///
    /// Until there it is the nearest point of everything on the ray (lemma 1), and beyond never. The ball through it that touches the point nearest to the far end is smaller than the
    /// one that was tried, and holds the one that is looked for: so balls shrink, as Newton's method does, and where they do so slowly what is left is halved (binary search, section VI).
    pub fn along(&self, a: &Foot, way: Vec3, [near, far]: [f64; 2]) -> Option<MedialPoint> {
        let at = |t: f64| add(a.point, scale(way, t));
        let (mut low, mut high) = (near, far);
        let mut other: Option<Foot> = None;
        for step in 0..STEPS {
            let center = at(high);
            let nearest = self.sites.foot_within(center, high);
            let Some(b) = nearest.filter(|b| self.are_two(a, b, high)) else {
                // Nothing but the point itself is as near: the ball that touches the other one is the one.
                return other.map(|b| self.touching(a, &b, center, high));
            };
            other = Some(b);
            let to_b = sub(b.point, a.point);
            let size_2 = dot(to_b, to_b);
            // Of the ball through both points, whose centre lies on the ray.
            let next = size_2 / (2.0 * dot(way, to_b));
            // One less the cosine of the object angle: how fast the two distances part.
            let rate = size_2 / (2.0 * high * high);
            let lead = high - b.distance_squared.sqrt();
            let shrinks = next < high;
            if lead <= 0.25 * self.epsilon * rate.min(1.0) || !shrinks {
                return Some(self.touching(a, &b, center, high));
            }
            let shrunk = high - next;
            high = next.max(low);
            if step > EAGER && shrunk < 0.25 * (high - low) {
                let middle = 0.5 * (low + high);
                let nearest = self.sites.foot_within(at(middle), middle);
                match nearest.filter(|b| self.are_two(a, b, middle)) {
                    Some(b) => {
                        other = Some(b);
                        high = middle;
                    }
                    None => low = middle,
                }
            }
            if high - low <= 0.25 * self.epsilon {
                break;
            }
        }
        other.map(|b| self.touching(a, &b, at(high), high))
    }

    /// A point on a segment between points of which the nearest boundary points lie on different sides of the line through them, as seen from a direction that all have right angles
    /// with (corollary 7).
    pub fn between(&self, u: Vec3, v: Vec3, normal: Vec3) -> Option<MedialPoint> {
        let across = cross(normal, sub(v, u));
        let side = |p: Vec3, foot: &Foot| dot(sub(foot.point, p), across);
        let (mut low, mut high) = ((u, self.sites.foot(u)), (v, self.sites.foot(v)));
        let begins = side(low.0, &low.1) > 0.0;
        for _ in 0..STEPS {
            let apart = length(sub(high.0, low.0));
            let middle = scale(add(low.0, high.0), 0.5);
            if apart <= 0.125 * self.epsilon || middle == low.0 || middle == high.0 {
                break;
            }
            let foot = self.sites.foot(middle);
            let way = side(middle, &foot);
            if way == 0.0 {
                return self.aligned(middle, &foot, [low.0, high.0]);
            }
            match (way > 0.0) == begins {
                true => low = (middle, foot),
                false => high = (middle, foot),
            }
        }
        let ((p, a), (_, b)) = (low, high);
        if self.is_same(a.point, b.point) {
            return self.aligned(p, &a, [u, v]);
        }
        // The medial axis passes between the two, and may be met exactly on the way on from the first.
        let distance = a.distance_squared.sqrt();
        if distance > 0.0 {
            let way = scale(sub(p, a.point), 1.0 / distance);
            let found = self.along(&a, way, [distance, distance + self.epsilon]);
            if found.is_some() {
                return found;
            }
        }
        Some(self.touching(&a, &b, p, distance))
    }

    /// A point on the line of a segment on which the nearest point lies: at the end that is farther from it another one is nearest.
    fn aligned(&self, p: Vec3, a: &Foot, ends: [Vec3; 2]) -> Option<MedialPoint> {
        let distance = a.distance_squared.sqrt();
        let way = scale(sub(p, a.point), 1.0 / distance);
        let far = ends.map(|end| dot(sub(end, a.point), way)).into_iter().fold(0.0, f64::max);
        self.along(a, way, [distance, far])
    }

    /// The medial point with these two nearest points, the second of which is that of its piece anew.
    pub fn touching(&self, a: &Foot, b: &Foot, center: Vec3, radius: f64) -> MedialPoint {
        let shape = Shape::from(&self.sites.pieces()[b.piece as usize]);
        let anew = shape.closest(center);
        // A sphere has its nearest point wherever one looks from, but from its centre.
        let touched = if self.is_same(anew, a.point) { b.point } else { anew };
        let (to_a, to_b) = (sub(a.point, center), sub(touched, center));
        let object_angle = libm::atan2(length(cross(to_a, to_b)), dot(to_a, to_b));
        MedialPoint {
            center,
            radius,
            feet: [a.point, touched],
            pieces: [a.piece, b.piece],
            object_angle,
        }
    }
}

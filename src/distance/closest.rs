//! The nearest point of each kind of piece, degenerate ones included.

use super::piece::Piece;
use crate::vector::{Vec3, add, dot, length, scale, sub};

/// A piece made ready for queries.
#[derive(Clone, Copy, Debug)]
pub(super) enum Shape {
    Point(Vec3),
    Segment([Vec3; 2]),
    Ray(Vec3, Vec3),
    Line(Vec3, Vec3),
    Triangle(Triangle),
    Sphere(Vec3, f64),
}

impl From<&Piece> for Shape {
    fn from(piece: &Piece) -> Self {
        match *piece {
            Piece::Point(p) => Shape::Point(p),
            Piece::Segment(ends) => Shape::Segment(ends),
            Piece::Ray(origin, along) => Shape::Ray(origin, unit(along)),
            Piece::Line(origin, along) => Shape::Line(origin, unit(along)),
            Piece::Triangle(corners) => match Triangle::new(corners) {
                Ok(triangle) => Shape::Triangle(triangle),
                Err(longest) => Shape::Segment(longest),
            },
            Piece::Sphere(center, radius) => Shape::Sphere(center, radius),
        }
    }
}

impl Shape {
    /// The nearest point of the piece. Each is a point of it but for rounding in its last place, and corners and ends are hit exactly: so what pieces share is one point for all of
    /// them.
    pub fn closest(&self, p: Vec3) -> Vec3 {
        match self {
            Shape::Point(q) => *q,
            Shape::Segment([a, b]) => on_segment(p, *a, *b),
            Shape::Ray(origin, along) => {
                add(*origin, scale(*along, dot(sub(p, *origin), *along).max(0.0)))
            }
            Shape::Line(origin, along) => add(*origin, scale(*along, dot(sub(p, *origin), *along))),
            Shape::Triangle(triangle) => triangle.closest(p),
            Shape::Sphere(center, radius) => {
                let out = sub(p, *center);
                let size = length(out);
                // All points are as near to the centre: one is as good as another.
                let out = if size > 0.0 { scale(out, 1.0 / size) } else { [1.0, 0.0, 0.0] };
                add(*center, scale(out, *radius))
            }
        }
    }
}

/// A direction of length 1, however long or short it was.
fn unit(along: Vec3) -> Vec3 {
    let largest = along.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let along = along.map(|x| x / largest);
    scale(along, 1.0 / length(along))
}

/// The nearest point of a segment.
pub(super) fn on_segment(p: Vec3, a: Vec3, b: Vec3) -> Vec3 {
    let along = sub(b, a);
    let length_2 = dot(along, along);
    let from_a = dot(sub(p, a), along);
    // A segment that is a point has neither.
    if from_a <= 0.0 || length_2 == 0.0 {
        return a;
    }
    let from_b = dot(sub(b, p), along);
    if from_b <= 0.0 {
        return b;
    }
    // From the nearer end, where rounding does less harm.
    match from_a <= from_b {
        true => add(a, scale(along, from_a / length_2)),
        false => sub(b, scale(along, from_b / length_2)),
    }
}

/// A triangle with its longest side as the base: then the angles at both ends of the base are acute, and the foot of the height lies between them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Triangle {
    corners: [Vec3; 3],
    base: Vec3,
    height: Vec3,
    /// One by the squared lengths of base and height.
    inverse: [f64; 2],
    /// Where the height stands, as a share of the base.
    top: f64,
}

impl Triangle {
    /// Prepares a triangle, or gives its longest side if it has no area.
    fn new([p, q, r]: [Vec3; 3]) -> Result<Self, [Vec3; 2]> {
        let side = |[a, b, _]: &[Vec3; 3]| dot(sub(*b, *a), sub(*b, *a));
        let turned = [[p, q, r], [q, r, p], [r, p, q]];
        let longest = turned.iter().max_by(|s, t| side(s).total_cmp(&side(t)));
        let corners @ [a, b, c] = *longest.unwrap_or(&turned[0]);
        let (base, slope) = (sub(b, a), sub(c, a));
        let base_2 = dot(base, base);
        let top = dot(slope, base) / base_2;
        let height = sub(slope, scale(base, top));
        let height_2 = dot(height, height);
        // Rounding alone makes a height of a few units in the last place of the slope.
        let has_area = height_2 > 1e-28 * base_2;
        match has_area {
            false => Err([a, b]),
            true => {
                Ok(Triangle { corners, base, height, inverse: [1.0 / base_2, 1.0 / height_2], top })
            }
        }
    }

    fn closest(&self, p: Vec3) -> Vec3 {
        let [a, b, c] = self.corners;
        let from = sub(p, a);
        let s = dot(from, self.base) * self.inverse[0];
        let t = dot(from, self.height) * self.inverse[1];
        if t <= 0.0 {
            return on_segment(p, a, b);
        }
        let is_left = s < t * self.top;
        let is_right = 1.0 - s < t * (1.0 - self.top);
        match (is_left, is_right) {
            (false, false) if t < 1.0 => add(a, add(scale(self.base, s), scale(self.height, t))),
            (true, false) => on_segment(p, a, c),
            (false, true) => on_segment(p, c, b),
            _ => {
                let (left, right) = (on_segment(p, a, c), on_segment(p, c, b));
                let distance = |q: Vec3| dot(sub(p, q), sub(p, q));
                if distance(right) < distance(left) { right } else { left }
            }
        }
    }
}

//! On which side of a ray the corners of a Voronoi facet lie.

use super::outline::{Corner, Outline};
use super::share::Share;
use crate::dual::{Dual, Way, triple_sign};
use crate::poles::seen_from;
use crate::predicates::{Sign, UNIT};
use crate::vector::{Vec3, add, cross, dot, scale, sub};

/// The farthest that an orbit is followed along a ray, 2^400.
const FARTHEST: f64 = f64::from_bits((1023 + 400) << 52);

/// A Voronoi facet seen from the middle of its dual edge p q: rays from there through points of the facet, and on which side of them
/// others lie. That is the sign of (x - p) x (z - p) . (q - p): positive if z lies counterclockwise of x seen from q.
pub(super) struct View<'a> {
    dual: &'a Dual,
    ends: [u32; 2],
    origin: Vec3,
    along: Vec3,
}

impl<'a> View<'a> {
    pub fn new(dual: &'a Dual, ends: [u32; 2]) -> Self {
        let [p, q] = ends.map(|v| dual.triangulation().coords()[v as usize]);
        View { dual, ends, origin: p, along: sub(q, p) }
    }

    /// The place of a corner less that of p, or its direction.
    pub fn vector(&self, corner: Corner) -> Vec3 {
        match corner {
            Corner::Cell(cell) => sub(self.dual.centers()[cell as usize], self.origin),
            Corner::Ray(ray) => self.dual.rays().directions()[ray as usize],
        }
    }

    /// A point less p.
    pub fn to(&self, point: Vec3) -> Vec3 {
        sub(point, self.origin)
    }

    /// How far z lies counterclockwise of x, both as vectors from p: rounded.
    pub fn turn(&self, x: Vec3, z: Vec3) -> f64 {
        dot(cross(x, z), self.along)
    }

    /// Whether a corner lies strictly counterclockwise of the ray through the centre of a cell of the edge: exact.
    pub fn is_beyond(&self, cell: u32, corner: Corner) -> bool {
        self.is_ahead(self.dual.center_from(cell, self.origin), corner, || self.center(cell))
    }

    /// Whether a corner lies strictly counterclockwise of the ray through a given point: exact.
    pub fn is_beyond_point(&self, point: Vec3, corner: Corner) -> bool {
        let x = self.to(point);
        self.is_ahead((x, x.map(|x| UNIT * x.abs())), corner, || Way::Point(point))
    }

    /// By a rounded vector from p along the ray, and the most that each coordinate is off, where these are enough.
    fn is_ahead(
        &self,
        (x, x_error): (Vec3, Vec3),
        corner: Corner,
        exact: impl Fn() -> Way,
    ) -> bool {
        if let Corner::Cell(other) = corner {
            let (z, z_error) = self.dual.center_from(other, self.origin);
            let size = |v: Vec3| v.map(f64::abs);
            let [xs, zs, es] = [x, z, self.along].map(size);
            let most = [0, 1, 2].map(|k| zs[k] + z_error[k]);
            let error = permanent(x_error, most, es)
                + permanent(xs, z_error, es)
                + 16.0 * UNIT * permanent(xs, zs, es)
                + f64::MIN_POSITIVE;
            let turn = self.turn(x, z);
            // A comparison with NaN is false.
            if turn.abs() > error * (1.0 + 32.0 * UNIT) {
                return turn > 0.0;
            }
        }
        self.sign(exact(), corner).is_positive()
    }

    /// One more than the far side by which the ray through the centre of a cell of the edge leaves, given that it is none of the sides from `last` on:
    /// exact.
    pub fn exit(&self, outline: &Outline, cell: u32, last: usize) -> usize {
        let mut far = last;
        while far > outline.near + 1 && self.is_beyond(cell, outline.corners[far - 1]) {
            far -= 1;
        }
        far
    }

    /// Where the ray through a point of the facet hits a side. Not before the hit before, if there is
    /// one, as the sides are walked; and where rounding leaves nothing of the crossing, as where the facet has no width there, not nearer to the driver than the point.
    pub fn share(&self, outline: &Outline, side: usize, x: Vec3, last: Option<Share>) -> Share {
        let (begin, end) = (outline.corners[side], outline.end(side));
        let turn = |corner| self.turn(x, self.vector(corner));
        let (from, to) = ((-turn(begin)).max(0.0), turn(end).max(0.0));
        let (share, parted) = match (begin, end) {
            (Corner::Cell(_), Corner::Cell(_)) => (Share::of(from, to), from + to),
            (_, Corner::Ray(_)) => (Share::on_ray(from / to), to),
            (Corner::Ray(_), _) => (Share::on_ray(to / from), from),
        };
        let at = self.to(self.place(outline, side, share));
        let noise = self.noise(x, begin).max(self.noise(x, end));
        let share = match parted > noise && dot(at, at) >= dot(x, x) {
            true => share,
            false => self.foot(outline, side, x),
        };
        match (begin, end) {
            (Corner::Cell(_), Corner::Cell(_)) => {
                share.max(Share::BEGIN).min(last.unwrap_or(Share::END))
            }
            (_, Corner::Ray(_)) => {
                share.max(Share::on_ray(0.0)).min(last.unwrap_or(Share::on_ray(FARTHEST)))
            }
            (Corner::Ray(_), _) => {
                share.max(last.unwrap_or(Share::on_ray(0.0))).min(Share::on_ray(FARTHEST))
            }
        }
    }

    /// What rounding alone makes of a turn from a vector to a corner that lies in its direction.
    fn noise(&self, x: Vec3, corner: Corner) -> f64 {
        let size = |v: Vec3| v.map(f64::abs);
        let (from, along) = (size(self.origin), size(self.along));
        let of_corner = match corner {
            Corner::Cell(_) => add(size(self.vector(corner)), from),
            Corner::Ray(_) => size(self.vector(corner)),
        };
        32.0 * UNIT * permanent(add(size(x), from), of_corner, along)
    }

    /// Where on a side the point nearest to another one lies, on its line.
    fn foot(&self, outline: &Outline, side: usize, x: Vec3) -> Share {
        let part = |from: Vec3, to: Vec3, along: Vec3| {
            let part = dot(sub(to, from), along) / dot(along, along);
            // Of a side without length any point is it.
            if part.is_nan() { 0.0 } else { part }
        };
        match (outline.corners[side], outline.end(side)) {
            (Corner::Ray(ray), cell) | (cell, Corner::Ray(ray)) => {
                Share::on_ray(part(self.vector(cell), x, self.vector(Corner::Ray(ray))))
            }
            (begin, end) => {
                let [begin, end] = [begin, end].map(|corner| self.vector(corner));
                let along = sub(end, begin);
                Share { before: part(begin, x, along), behind: part(x, end, along) }
            }
        }
    }

    /// The point of a side.
    pub fn place(&self, outline: &Outline, side: usize, share: Share) -> Vec3 {
        let center = |cell: u32| self.dual.centers()[cell as usize];
        let direction = |ray: u32| self.dual.rays().directions()[ray as usize];
        match (outline.corners[side], outline.end(side)) {
            (Corner::Cell(begin), Corner::Cell(end)) => {
                let [begin, end] = [begin, end].map(center);
                match share.is_near_begin() {
                    true => add(begin, scale(sub(end, begin), share.before)),
                    false => add(end, scale(sub(begin, end), share.behind)),
                }
            }
            (Corner::Cell(cell), Corner::Ray(ray)) | (Corner::Ray(ray), Corner::Cell(cell)) => {
                add(center(cell), scale(direction(ray), share.before))
            }
            (Corner::Ray(ray), Corner::Ray(_)) => direction(ray),
        }
    }

    fn sign(&self, x: Way, corner: Corner) -> Sign {
        let t = self.dual.triangulation();
        let at = |v: u32| t.coords()[v as usize];
        let z = match corner {
            Corner::Cell(cell) => self.center(cell),
            Corner::Ray(ray) => {
                let [cell, facet] = self.dual.rays().facets()[ray as usize];
                Way::Normal(t.facet(cell, facet as usize).map(at))
            }
        };
        triple_sign(x, z, self.ends.map(at))
    }

    fn center(&self, cell: u32) -> Way {
        Way::Center(seen_from(self.dual.triangulation(), self.ends[0], cell))
    }
}

/// The permanent of three rows.
fn permanent(a: Vec3, b: Vec3, c: Vec3) -> f64 {
    let minor = |i: usize, j: usize| a[i] * b[j] + a[j] * b[i];
    minor(1, 2) * c[0] + minor(2, 0) * c[1] + minor(0, 1) * c[2]
}

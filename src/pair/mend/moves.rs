//! Moves of one inner vertex that leave less of what is turned.

use super::{Corner, Mended, Part, tidy};
use crate::vector::{Vec3, cross, dot, length, scale, sub};

/// How often a place is moved to the other side of a plane.
const MOVES: usize = 40;
/// How vertices are moved.
#[derive(Clone, Copy)]
pub(super) struct Way {
    /// The largest share of what is turned that a move may leave.
    pub leave: f64,
    /// How far beyond a plane a place is moved, as a share of how far it was on the wrong side: so it comes to where it may be in finitely many moves (Motzkin, Schoenberg 1954, *The relaxation method
    /// for linear inequalities*).
    pub beyond: f64,
}

/// A plane that a corner of a tetrahedron must lie behind: its normal out of it, of length 1, how far it is from the origin along that, and twice the area of the other three corners.
struct Plane {
    normal: Vec3,
    distance: f64,
    size: f64,
}

impl Plane {
    /// How far before it a place is.
    fn before(&self, p: Vec3) -> f64 {
        dot(self.normal, p) - self.distance
    }
}

impl Mended<'_> {
    /// Moves a vertex to where nothing that has it is turned, or, if no such place is found, at most a share of what was. Whether it was moved.
    pub(super) fn improve(&mut self, vertex: u32, way: Way) -> bool {
        if self.planes_left == 0 {
            return false;
        }
        let v = vertex as usize;
        let (place, was_moved) = (self.places[v], self.is_moved[v]);
        let at = self.parts_at(vertex);
        let most = way.leave * self.turned_volume(&at, vertex);
        self.is_moved[v] = true;
        let planes = self.planes(&at, vertex);
        self.is_moved[v] = was_moved;
        self.planes_left = self.planes_left.saturating_sub(planes.len());
        match better(place, &planes, most, way).map(tidy) {
            Some(found) if found != place => {
                self.put(vertex, found);
                true
            }
            _ => false,
        }
    }

    /// Six times the volume of all that is turned and has a vertex.
    fn turned_volume(&self, at: &[Part], vertex: u32) -> f64 {
        let mut sum = 0.0;
        for &part in at {
            self.tetrahedra(part, &mut |corners| {
                if corners.contains(&Corner::Inner(vertex)) {
                    let [a, b, c, d] = corners.map(|corner| self.at(corner));
                    sum += (-dot(cross(sub(b, a), sub(c, a)), sub(d, a))).max(0.0);
                }
            });
        }
        sum
    }

    /// The planes that a vertex must lie behind.
    fn planes(&self, at: &[Part], vertex: u32) -> Vec<Plane> {
        let mut planes = Vec::new();
        for &part in at {
            self.tetrahedra(part, &mut |corners| {
                let own = corners.iter().position(|&corner| corner == Corner::Inner(vertex));
                planes.extend(own.and_then(|own| self.plane(corners, own)));
            });
        }
        planes
    }

    /// The plane that a corner of a tetrahedron must lie behind, if the others make one.
    fn plane(&self, corners: [Corner; 4], own: usize) -> Option<Plane> {
        // The others, so that they turn counterclockwise seen from the side where the corner is not.
        let [p, q, r] =
            [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]][own].map(|i| self.at(corners[i]));
        let normal = cross(sub(q, p), sub(r, p));
        let size = length(normal);
        (size > 0.0).then(|| {
            let normal = scale(normal, 1.0 / size);
            Plane { normal, distance: dot(normal, p), size }
        })
    }
}

/// A place behind all planes, near to a given one, or else the best that is found on the way there: what is turned has less volume, six times, than given.
fn better(mut p: Vec3, planes: &[Plane], mut most: f64, way: Way) -> Option<Vec3> {
    let mut best = None;
    for _ in 0..MOVES {
        let (mut worst, mut beyond, mut sum) = (None, 0.0, 0.0);
        for plane in planes {
            let before = plane.before(p);
            if before >= 0.0 {
                sum += before * plane.size;
            }
            if before >= beyond {
                (worst, beyond) = (Some(plane), before);
            }
        }
        let Some(worst) = worst else { return Some(p) };
        if sum < most {
            (best, most) = (Some(p), sum);
        }
        // Not on the plane, whatever rounding does.
        let size = p.iter().fold(worst.distance.abs(), |size, x| size.max(x.abs()));
        p = sub(p, scale(worst.normal, beyond * (1.0 + way.beyond) + 1e-14 * size));
    }
    best
}

//! What a flow is read from.

use super::drivers::Drivers;
use super::share::Share;
use super::triangles::Triangles;
use crate::dual::{Dual, Facets};
use crate::index::NONE;
use crate::vector::{Vec3, add, cross, dot, scale, sub};

/// The Voronoi diagram and its drivers.
#[derive(Clone, Copy)]
pub(super) struct Source<'a> {
    pub dual: &'a Dual,
    pub facets: &'a Facets,
    pub triangles: &'a Triangles,
    pub drivers: &'a Drivers,
}

impl Source<'_> {
    /// Whether the Voronoi edge of a triangle holds its centre: a critical point of index 2.
    pub fn is_saddle(&self, triangle: u32) -> bool {
        if self.drivers.longest[triangle as usize] != NONE {
            return false;
        }
        let t = self.dual.triangulation();
        let is_beyond = |cell: u32| {
            cell != NONE && {
                let sides = self.triangles.of_cell[cell as usize];
                let slot = sides.iter().position(|&side| side == triangle);
                slot.is_some_and(|slot| self.drivers.beyond[cell as usize] >> slot & 1 == 1)
            }
        };
        !self.triangles.cells(t, triangle).into_iter().any(is_beyond)
    }

    /// The centre of a triangle's smallest sphere, in its plane: a corner, and the way from there, which is exact to some units of rounding where the triangle is acute.
    pub fn center_of_triangle(&self, triangle: u32) -> [Vec3; 2] {
        let t = self.dual.triangulation();
        let [p, q, r] = self.triangles.corners(t, triangle).map(|v| t.coords()[v as usize]);
        circumcenter(p, q, r)
    }

    /// Where on the line of a triangle's Voronoi edge a point lies, as [`Hit::share`](super::cuts::Hit).
    pub fn share(&self, triangle: u32, at: Vec3) -> Share {
        let t = self.dual.triangulation();
        let [cell, other] = self.triangles.cells(t, triangle);
        let begin = self.dual.centers()[cell as usize];
        if other == NONE {
            let ray = self.dual.rays().of_facet(cell, self.triangles.sides[triangle as usize][1]);
            return Share::on_ray(dot(sub(at, begin), self.dual.rays().directions()[ray as usize]));
        }
        let end = self.dual.centers()[other as usize];
        let along = sub(end, begin);
        Share::of(dot(sub(at, begin), along), dot(sub(end, at), along))
    }
}

/// The corner with the largest angle, and the way from there to the centre of the smallest sphere through three points.
fn circumcenter(p: Vec3, q: Vec3, r: Vec3) -> [Vec3; 2] {
    let opposite = [[p, q, r], [q, r, p], [r, p, q]];
    let length = |[_, b, c]: &[Vec3; 3]| dot(sub(*c, *b), sub(*c, *b));
    let widest = opposite.iter().max_by(|x, y| length(x).total_cmp(&length(y)));
    let [p, q, r] = *widest.unwrap_or(&opposite[0]);
    let (a, b) = (sub(q, p), sub(r, p));
    let normal = cross(a, b);
    let sum = add(scale(cross(b, normal), dot(a, a)), scale(cross(normal, a), dot(b, b)));
    [p, scale(sum, 0.5 / dot(normal, normal))]
}

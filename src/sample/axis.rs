//! The inner medial axes that are known in closed form.

use super::{Shape, solids, trefoil};
use crate::vector::{Vec3, length, sub};

impl Shape {
    /// The distance from a point to the inner medial axis, where that is known: the core circle
    /// of the torus, the segment of the capsule, the knot of the trefoil tube, the centre of the
    /// sphere, the thirteen facets of the box, the elliptical disc of the ellipsoid.
    /// `None` for the genus 3 surface and the bracket.
    pub fn inner_axis_distance(self, point: [f64; 3]) -> Option<f64> {
        match self {
            Shape::Torus => Some(solids::torus(point, 1.0, 0.0).0),
            Shape::Capsule => Some(solids::capsule(point, 1.0, 0.0).0),
            Shape::Sphere => Some(length(point)),
            Shape::Trefoil => Some(trefoil::distance_to_knot(point)),
            Shape::Box => Some(box_axis(point.map(f64::abs), solids::BOX)),
            Shape::Ellipsoid => Some(ellipsoid_axis(point.map(f64::abs), solids::ELLIPSOID)),
            Shape::Genus3 | Shape::Bracket => None,
        }
    }
}

/// The distance from a point of the first octant to the axis of a box whose least half side is the last.
///
/// The axis is a rectangle in the plane z = 0, and from each edge of the box a facet that halves the
/// angle. It is symmetric in each coordinate, so that its part in the first octant is nearest.
fn box_axis(p: Vec3, [a, b, c]: Vec3) -> f64 {
    let rectangle = length(sub(p, [p[0].min(a - c), p[1].min(b - c), 0.0]));
    // The facet of an edge is the set of points at the depth s in [0, c] under both its sides and at most
    // the edge's half length less s from the middle.
    let facet = |[along, half]: [f64; 2], [v, v_half]: [f64; 2], [w, w_half]: [f64; 2]| {
        let depths = [half - along, v_half - v, w_half - w];
        let between = (depths[1] + depths[2]) / 2.0;
        // Beyond the facet's slanted end the third coordinate pulls too.
        let free = along <= half - between;
        let s = if free { between } else { depths.iter().sum::<f64>() / 3.0 }.clamp(0.0, c);
        length([(s - depths[0]).max(0.0), depths[1] - s, depths[2] - s])
    };
    let [x, y, z] = [[p[0], a], [p[1], b], [p[2], c]];
    rectangle.min(facet(x, y, z)).min(facet(y, x, z)).min(facet(z, x, y))
}

/// The distance from a point of the first octant to the axis of an ellipsoid with half axes a >= b > c.
///
/// The normal at a surface point (x, y, z) meets the plane z = 0 at (x (1 - c^2 / a^2),
/// y (1 - c^2 / b^2), 0), so the axis is the disc with half axes a - c^2 / a and b - c^2 / b.
fn ellipsoid_axis(p: Vec3, [a, b, c]: Vec3) -> f64 {
    let half = [a - c * c / a, b - c * c / b];
    let size =
        |q: [f64; 2]| (q[0] / half[0]) * (q[0] / half[0]) + (q[1] / half[1]) * (q[1] / half[1]);
    if size([p[0], p[1]]) <= 1.0 {
        return p[2];
    }
    // Outside, the nearest point of the ellipse is (p h^2 / (h^2 + t)) for the t > 0 that puts it
    // on the ellipse (Eberly 2013, *Distance from a point to an ellipse*); bisection finds it.
    let foot = |t: f64| -> [f64; 2] {
        std::array::from_fn(|i| p[i] * half[i] * half[i] / (half[i] * half[i] + t))
    };
    let (mut low, mut high) = (0.0, half[0] * length([p[0], p[1], 0.0]));
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if size(foot(middle)) > 1.0 { low = middle } else { high = middle }
    }
    let [x, y] = foot(high);
    length(sub(p, [x, y, 0.0]))
}

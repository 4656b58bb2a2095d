//! Implicit functions of primitives, and the two shapes that are composed of them.
//!
//! Each function returns a value and its gradient. The value is negative inside, 0 on the surface and
//! positive outside, and no two values differ by more than the distance of their points. Unions
//! and differences keep that: minima, maxima and smooth minima of such functions are such
//! functions.

use crate::vector::{Vec3, length, scale, sub};

/// Half the sides of the box.
pub(super) const BOX: Vec3 = [1.0, 0.75, 0.5];
/// The half axes of the ellipsoid, the least last.
pub(super) const ELLIPSOID: Vec3 = [1.4, 1.0, 0.7];

/// `a / b`, or 0 where `b` is 0: a gradient has no direction at the centre of symmetry.
fn ratio(a: f64, b: f64) -> f64 {
    if b > 0.0 { a / b } else { 0.0 }
}

/// The signed distance to a torus about the z axis.
pub(super) fn torus(p: Vec3, major: f64, minor: f64) -> (f64, Vec3) {
    let [x, y, z] = p;
    let from_axis = (x * x + y * y).sqrt();
    let across = from_axis - major;
    let from_circle = (across * across + z * z).sqrt();
    let outward = ratio(across, from_circle);
    let gradient =
        [ratio(x, from_axis) * outward, ratio(y, from_axis) * outward, ratio(z, from_circle)];
    (from_circle - minor, gradient)
}

/// The signed distance to a box about the origin.
pub(super) fn cuboid(p: Vec3, half: Vec3) -> (f64, Vec3) {
    let beyond: Vec3 = std::array::from_fn(|i| p[i].abs() - half[i]);
    let outside = beyond.map(|x| x.max(0.0));
    let distance = length(outside);
    if distance > 0.0 {
        return (distance, std::array::from_fn(|i| outside[i] / distance * p[i].signum()));
    }
    let nearest = (1..3).fold(0, |best, i| if beyond[i] > beyond[best] { i } else { best });
    let mut gradient = [0.0; 3];
    gradient[nearest] = p[nearest].signum();
    (beyond[nearest], gradient)
}

/// The signed distance to the points within `radius` of the segment of the x axis from `-half` to `half`.
pub(super) fn capsule(p: Vec3, half: f64, radius: f64) -> (f64, Vec3) {
    let from_segment = sub(p, [p[0].clamp(-half, half), 0.0, 0.0]);
    let distance = length(from_segment);
    (distance - radius, from_segment.map(|x| ratio(x, distance)))
}

/// The ellipsoid whose least half axis is the last, as the unit sphere stretched: the value is
/// below the distance where the stretch is larger.
pub(super) fn ellipsoid(p: Vec3, axes: Vec3) -> (f64, Vec3) {
    let least = axes[2];
    let q: Vec3 = std::array::from_fn(|i| p[i] / axes[i]);
    let size = length(q);
    (least * (size - 1.0), std::array::from_fn(|i| ratio(least * q[i], size * axes[i])))
}

/// The infinite cylinder about the line through `center` along the axis of number `axis`.
fn cylinder(p: Vec3, axis: usize, center: Vec3, radius: f64) -> (f64, Vec3) {
    let mut across = sub(p, center);
    across[axis] = 0.0;
    let distance = length(across);
    (distance - radius, across.map(|x| ratio(x, distance)))
}

/// Three tori in a row that touch, joined by a smooth minimum.
///
/// The sharpest bend of the joined surface has a radius of curvature of 0.343, found numerically,
/// a little less than that of the tubes. The outer tori count as one by symmetry: where they are equally near, the
/// middle one is nearer by more than the blend reaches.
pub(super) fn three_tori(p: Vec3) -> (f64, Vec3) {
    let middle = torus(p, 1.0, 0.4);
    let (value, mut gradient) = torus([p[0].abs() - 2.0, p[1], p[2]], 1.0, 0.4);
    gradient[0] *= p[0].signum();
    smooth_minimum(middle, (value, gradient), 0.68)
}

/// The minimum of two values, lowered with two continuous derivatives where they differ by less
/// than `reach` (Quilez 2013, *Smooth minimum*, the cubic one).
fn smooth_minimum(a: (f64, Vec3), b: (f64, Vec3), reach: f64) -> (f64, Vec3) {
    let (near, far) = if a.0 < b.0 { (a, b) } else { (b, a) };
    let blend = (1.0 - (far.0 - near.0) / reach).max(0.0);
    let share = 0.5 * blend * blend;
    let gradient = std::array::from_fn(|i| (1.0 - share) * near.1[i] + share * far.1[i]);
    (near.0 - blend * blend * blend * reach / 6.0, gradient)
}

/// A plate on the ground and one upright, joined; two holes in the first and one in the second.
pub(super) fn bracket(p: Vec3) -> (f64, Vec3) {
    let plate = |min: Vec3, max: Vec3| {
        let center = std::array::from_fn(|i| (min[i] + max[i]) / 2.0);
        cuboid(sub(p, center), scale(sub(max, min), 0.5))
    };
    let ground = plate([0.0, 0.0, 0.0], [4.0, 2.4, 0.5]);
    let upright = plate([0.0, 0.0, 0.0], [0.5, 2.4, 3.0]);
    let holes = [
        cylinder(p, 2, [1.6, 1.2, 0.0], 0.4),
        cylinder(p, 2, [3.1, 1.2, 0.0], 0.4),
        cylinder(p, 0, [0.0, 1.2, 1.8], 0.6),
    ];
    let mut solid = if ground.0 < upright.0 { ground } else { upright };
    for hole in holes {
        if -hole.0 > solid.0 {
            solid = (-hole.0, scale(hole.1, -1.0));
        }
    }
    solid
}

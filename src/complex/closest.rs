//! Distances from a point to points, segments, triangles and tetrahedra, degenerate ones included.

use super::Point;
use crate::predicates::orient3d;

pub(super) fn sub(a: Point, b: Point) -> Point {
    std::array::from_fn(|i| a[i] - b[i])
}

pub(super) fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The squared distance from a point to the hull of one to four corners.
///
/// Each branch measures the distance to a point of the hull, up to rounding, and the hull's own
/// hull of fewer corners is always among the branches: so a flat or thin simplex costs no more
/// accuracy than the simplex it nearly is. Coordinates must be as
/// [`Frame::scaled`](super::measure::Frame::scaled) makes them.
pub(super) fn distance_2(p: Point, corners: &[Point]) -> f64 {
    match *corners {
        [a] => squared_length(sub(p, a)),
        [a, b] => to_segment(p, a, b),
        [a, b, c] => to_triangle(p, a, b, c),
        [a, b, c, d] => to_tetrahedron(p, [a, b, c, d]),
        _ => f64::INFINITY,
    }
}

fn squared_length(a: Point) -> f64 {
    dot(a, a)
}

fn to_segment(p: Point, a: Point, b: Point) -> f64 {
    let (along, from) = (sub(b, a), sub(p, a));
    let length_2 = squared_length(along);
    let t = dot(from, along) / length_2;
    if t > 0.0 && t < 1.0 {
        // From the nearer end, where rounding does less harm.
        let (base, s) = if t <= 0.5 { (from, t) } else { (sub(p, b), t - 1.0) };
        squared_length(std::array::from_fn(|i| base[i] - s * along[i]))
    } else if t >= 1.0 {
        squared_length(sub(p, b))
    } else {
        // Here belongs also a segment that is a point, whose t is NaN.
        squared_length(from)
    }
}

fn to_triangle(p: Point, a: Point, b: Point, c: Point) -> f64 {
    let rim = to_segment(p, a, b).min(to_segment(p, b, c)).min(to_segment(p, c, a));
    // Base and height, the longest side the base: then a thin triangle has a small height, and the
    // foot of the perpendicular errs by no more than the rounding of the coordinates.
    let length_2 = |a, b| squared_length(sub(b, a));
    let (ab, bc, ca) = (length_2(a, b), length_2(b, c), length_2(c, a));
    let (a, b, c) = if ab >= bc && ab >= ca {
        (a, b, c)
    } else if bc >= ca {
        (b, c, a)
    } else {
        (c, a, b)
    };
    let (base, top, from) = (sub(b, a), sub(c, a), sub(p, a));
    let along = |v: Point| dot(v, base) / squared_length(base);
    let across = |v: Point| -> Point {
        let s = along(v);
        std::array::from_fn(|i| v[i] - s * base[i])
    };
    let (height, rise) = (across(top), across(from));
    let (s, top) = (along(from), along(top));
    let t = dot(rise, height) / squared_length(height);
    // The width of the triangle at that height; nothing lies in it where a division failed.
    if t > 0.0 && t < 1.0 && s > t * top && s < 1.0 + t * (top - 1.0) {
        rim.min(squared_length(std::array::from_fn(|i| rise[i] - t * height[i])))
    } else {
        rim
    }
}

fn to_tetrahedron(p: Point, [a, b, c, d]: [Point; 4]) -> f64 {
    let volume = orient3d(&a, &b, &c, &d);
    let parts = [
        orient3d(&p, &b, &c, &d),
        orient3d(&a, &p, &c, &d),
        orient3d(&a, &b, &p, &d),
        orient3d(&a, &b, &c, &p),
    ];
    if !volume.is_zero() && parts.iter().all(|&part| part != -volume) {
        return 0.0;
    }
    to_triangle(p, a, b, c)
        .min(to_triangle(p, a, b, d))
        .min(to_triangle(p, a, c, d))
        .min(to_triangle(p, b, c, d))
}

#[cfg(test)]
mod tests;

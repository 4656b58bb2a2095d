//! What a far part of a surface looks like: its area vector, and how it lies about a point.

use super::super::Point;
use super::super::closest::{cross, dot, sub};
use crate::points::Bounds;

/// The pairs and triples of axes to which the coefficients of quadratic and cubic forms belong.
const PAIRS: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [0, 2], [1, 2]];
const TRIPLES: [[usize; 3]; 10] = [
    [0, 0, 0],
    [1, 1, 1],
    [2, 2, 2],
    [0, 0, 1],
    [0, 0, 2],
    [0, 1, 1],
    [1, 1, 2],
    [0, 2, 2],
    [1, 2, 2],
    [0, 1, 2],
];

/// Homogeneous polynomials of a vector u, of degree 1, 2 and 3, by their coefficients.
type Linear = [f64; 3];
type Quadratic = [f64; 6];
type Cubic = [f64; 10];

/// Triangles as they are seen from afar.
///
/// With n the unit normal and y the way from the centre, integrated over the triangles: `area` is that of n, `first` that of
/// (n u)(y u), `second` that of (n u)(y u)^2, as forms in u. Two sets with the same forms cannot be told apart but for terms
/// that fall with the fifth power of the distance.
#[derive(Clone, Copy, Default)]
pub(super) struct Moments {
    center: Point,
    area: Linear,
    first: Quadratic,
    second: Cubic,
}

impl Moments {
    /// Of no triangle, about the middle of a box.
    pub(super) fn about(bounds: &Bounds) -> Self {
        let Bounds { min, max } = bounds;
        let center = std::array::from_fn(|i| min[i] + (max[i] - min[i]) / 2.0);
        Moments { center, ..Moments::default() }
    }

    /// Adds a triangle.
    pub(super) fn add(&mut self, corners: &[Point; 3]) {
        let [a, b, c] = corners.map(|corner| sub(corner, self.center));
        let area = cross(sub(b, a), sub(c, a)).map(|x| x / 2.0);
        let sum: Linear = std::array::from_fn(|i| a[i] + b[i] + c[i]);
        let first = product(&area, &sum.map(|x| x / 3.0));
        // The mean of (y u)^2 over a triangle, by its corners and their sum.
        let mut square = product(&sum, &sum);
        for corner in [a, b, c] {
            plus(&mut square, &product(&corner, &corner));
        }
        let second = cubic(&square.map(|x| x / 12.0), &area);
        plus(&mut self.area, &area);
        plus(&mut self.first, &first);
        plus(&mut self.second, &second);
    }

    /// Adds all that others stand for.
    pub(super) fn merge(&mut self, other: &Moments) {
        let way = sub(other.center, self.center);
        let shifted = product(&other.area, &way);
        let mut second = cubic(&other.first, &way).map(|x| 2.0 * x);
        plus(&mut second, &cubic(&shifted, &way));
        plus(&mut second, &other.second);
        plus(&mut self.area, &other.area);
        plus(&mut self.first, &other.first);
        plus(&mut self.first, &shifted);
        plus(&mut self.second, &second);
    }

    /// As a field to be evaluated at points that are farther from the centre than `reach`.
    pub(super) fn field(&self, reach: f64) -> Field {
        // Of (n u)(y u) and (n u)(y u)^2 the Taylor series has what is left without a trace.
        let [xx, yy, zz, ..] = self.first;
        let mut quadratic = self.first.map(|x| -3.0 * x);
        quadratic[..3].iter_mut().for_each(|x| *x += xx + yy + zz);
        let mut cube = self.second.map(|x| 7.5 * x);
        let s = &self.second;
        // The trace of a symmetric form of degree 3, by the coefficients of u_i^3 and u_i u_k^2.
        let trace =
            [s[0] + (s[5] + s[7]) / 3.0, s[1] + (s[3] + s[8]) / 3.0, s[2] + (s[4] + s[6]) / 3.0];
        let sphere = [1.0, 1.0, 1.0, 0.0, 0.0, 0.0];
        plus(&mut cube, &cubic(&sphere, &trace.map(|x| -4.5 * x)));
        let Moments { center, area, .. } = *self;
        Field { center, reach_2: reach * reach, area, quadratic, cube }
    }
}

/// The solid angle under which triangles are seen, where they are far away: the Taylor series of the integral of n y / |y|^3,
/// y being the way from where it is evaluated, up to second derivatives.
#[derive(Clone, Copy)]
pub(super) struct Field {
    center: Point,
    reach_2: f64,
    area: Linear,
    quadratic: Quadratic,
    cube: Cubic,
}

impl Field {
    /// The solid angle seen from a point; `None` if it is not far enough away.
    pub(super) fn at(&self, point: Point) -> Option<f64> {
        let way = sub(self.center, point);
        let distance_2 = dot(way, way);
        if distance_2 <= self.reach_2 {
            return None;
        }
        let distance = distance_2.sqrt();
        let u = way.map(|x| x / distance);
        // Each term falls with one more power of the distance; none of them is raised to a power that could underflow.
        let terms = [dot(self.area, u), at_2(&self.quadratic, u), at_3(&self.cube, u)];
        Some((terms[0] + (terms[1] + terms[2] / distance) / distance) / distance_2)
    }
}

fn plus<const N: usize>(to: &mut [f64; N], more: &[f64; N]) {
    to.iter_mut().zip(more).for_each(|(x, y)| *x += y);
}

/// The product of two linear forms.
fn product(a: &Linear, b: &Linear) -> Quadratic {
    PAIRS.map(|[i, j]| if i == j { a[i] * b[i] } else { a[i] * b[j] + a[j] * b[i] })
}

/// The product of a quadratic and a linear form.
fn cubic(q: &Quadratic, a: &Linear) -> Cubic {
    let [xx, yy, zz, xy, xz, yz] = *q;
    let [x, y, z] = *a;
    [
        xx * x,
        yy * y,
        zz * z,
        xx * y + xy * x,
        xx * z + xz * x,
        yy * x + xy * y,
        yy * z + yz * y,
        zz * x + xz * z,
        zz * y + yz * z,
        xy * z + xz * y + yz * x,
    ]
}

fn at_2(form: &Quadratic, u: Point) -> f64 {
    form.iter().zip(PAIRS).fold(0.0, |sum, (x, [i, j])| sum + x * u[i] * u[j])
}

fn at_3(form: &Cubic, u: Point) -> f64 {
    form.iter().zip(TRIPLES).fold(0.0, |sum, (x, [i, j, k])| sum + x * u[i] * u[j] * u[k])
}

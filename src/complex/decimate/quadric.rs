//! Quadrics: weighted sums of squared distances to planes and lines.

use crate::vector::{Vec3, add, cross, dot, length, scale, sub, unit};

/// Eigenvalues below this share of the largest count as zero: in these directions the quadric tells next to
/// nothing, and dividing by them would throw the vertex far away (Lindstrom 2000 takes the same share).
const FLAT: f64 = 1e-3;
/// What a squared length of an edge adds to the cost, next to squared distances: where all is flat, short edges go first.
const LENGTH: f64 = 1e-8;
/// The middle of an edge is as good as its ends where it costs no more than this share of the squared length more.
const EVEN: f64 = 1e-12;

/// The function `x A x + 2 b x + c` of positions relative to a vertex, and the area that it stands for.
///
/// Relative to a vertex, because about a common origin rounding would drown the distances within fine parts.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Quadric {
    /// Row by row, the upper half: xx, xy, xz, yy, yz, zz.
    a: [f64; 6],
    b: Vec3,
    c: f64,
    area: f64,
}

impl Quadric {
    /// A third of the squared distance to the plane of a triangle, weighted by its area, about its first corner.
    /// A triangle without area adds nothing.
    pub(super) fn of_triangle([p, q, r]: [Vec3; 3]) -> Self {
        let normal = cross(sub(q, p), sub(r, p));
        let area = length(normal) / 6.0;
        let n = unit(normal);
        Quadric { a: outer(n).map(|x| area * x), area, ..Quadric::default() }
    }

    /// The squared distance to the line of a boundary edge, weighted by its squared length, about its first end.
    pub(super) fn of_boundary(p: Vec3, q: Vec3) -> Self {
        let along = sub(q, p);
        let d = outer(unit(along));
        let weight = dot(along, along);
        let identity = [1.0, 0.0, 0.0, 1.0, 0.0, 1.0];
        let a = std::array::from_fn(|i| weight * (identity[i] - d[i]));
        Quadric { a, ..Quadric::default() }
    }

    /// The same function of positions relative to another origin, `by` away from the old one.
    pub(super) fn moved(&self, by: Vec3) -> Self {
        let turned = self.times(by);
        let c = self.c + dot(by, add(scale(self.b, 2.0), turned));
        Quadric { b: add(self.b, turned), c, ..*self }
    }

    pub(super) fn plus(&self, other: &Quadric) -> Self {
        Quadric {
            a: std::array::from_fn(|i| self.a[i] + other.a[i]),
            b: add(self.b, other.b),
            c: self.c + other.c,
            area: self.area + other.area,
        }
    }

    fn times(&self, x: Vec3) -> Vec3 {
        let [xx, xy, xz, yy, yz, zz] = self.a;
        [dot([xx, xy, xz], x), dot([xy, yy, yz], x), dot([xz, yz, zz], x)]
    }

    fn at(&self, x: Vec3) -> f64 {
        dot(x, add(self.times(x), scale(self.b, 2.0))) + self.c
    }

    /// Where to contract the edge from the origin to `end`, and what that costs: never less than 0.
    ///
    /// The better of both ends and the middle; from there to the minimum in the directions in which the quadric
    /// tells anything, unless that is further away than twice the edge.
    pub(super) fn target(&self, end: Vec3) -> (f64, Vec3) {
        let length_2 = dot(end, end);
        let ends = [[0.0; 3], end].map(|x| (self.at(x), x));
        let best = if ends[1].0 < ends[0].0 { ends[1] } else { ends[0] };
        let middle = scale(end, 0.5);
        let even = self.at(middle) <= best.0 + EVEN * self.area * length_2;
        let base = if even { middle } else { best.1 };
        let gradient = add(self.times(base), self.b);
        let (values, vectors) = eigen(self.a);
        let largest = values[0].max(values[1]).max(values[2]);
        let mut step = [0.0; 3];
        for (&value, &vector) in values.iter().zip(&vectors) {
            if value > FLAT * largest {
                step = sub(step, scale(vector, dot(vector, gradient) / value));
            }
        }
        let moved = add(base, step);
        let better = dot(step, step) <= 4.0 * length_2 && self.at(moved) <= self.at(base);
        let x = if better { moved } else { base };
        let cost = self.at(x).max(0.0) + LENGTH * self.area * length_2;
        (if cost.is_nan() { f64::INFINITY } else { cost + 0.0 }, x)
    }
}

/// The upper half of the product of a vector with itself.
fn outer([x, y, z]: Vec3) -> [f64; 6] {
    [x * x, x * y, x * z, y * y, y * z, z * z]
}

/// The eigenvalues and eigenvectors of a symmetric matrix, by Jacobi's rotations.
fn eigen([xx, xy, xz, yy, yz, zz]: [f64; 6]) -> (Vec3, [Vec3; 3]) {
    let mut m = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let mut vectors = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    // Convergence is quadratic: after six sweeps nothing is left beside the diagonal.
    for _ in 0..6 {
        let mut rotated = false;
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            let (off, size) = (m[i][j], m[i][i].abs() + m[j][j].abs());
            if off.abs() <= 1e-17 * size {
                continue;
            }
            rotated = true;
            let theta = (m[j][j] - m[i][i]) / (2.0 * off);
            let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
            let cosine = 1.0 / (t * t + 1.0).sqrt();
            let sine = t * cosine;
            for row in &mut m {
                (row[i], row[j]) =
                    (cosine * row[i] - sine * row[j], sine * row[i] + cosine * row[j]);
            }
            let turn = |p: Vec3, q: Vec3| {
                (sub(scale(p, cosine), scale(q, sine)), add(scale(p, sine), scale(q, cosine)))
            };
            (m[i], m[j]) = turn(m[i], m[j]);
            (vectors[i], vectors[j]) = turn(vectors[i], vectors[j]);
        }
        if !rotated {
            break;
        }
    }
    ([m[0][0], m[1][1], m[2][2]], vectors)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: Vec3, b: Vec3) {
        assert!(length(sub(a, b)) < 1e-12, "{a:?} is not {b:?}");
    }

    #[test]
    fn eigenvectors_make_the_matrix_diagonal() {
        let matrix = Quadric { a: [2.0, -1.0, 0.5, 3.0, 0.25, 1.0], ..Quadric::default() };
        let (values, vectors) = eigen(matrix.a);
        for (&value, &vector) in values.iter().zip(&vectors) {
            near(matrix.times(vector), scale(vector, value));
            assert!((length(vector) - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn three_planes_meet_in_the_target() {
        let corner = [1.0, 2.0, 3.0];
        let mut sum = Quadric::default();
        for axis in 0..3 {
            let at = |k: usize, far: f64| -> Vec3 {
                std::array::from_fn(|i| corner[i] + if i == (axis + k) % 3 { far } else { 0.0 })
            };
            // A triangle in the plane through the corner, about its own first vertex.
            let triangle = [at(1, 1.0), at(2, 1.0), at(1, 2.0)];
            sum =
                sum.plus(&Quadric::of_triangle(triangle).moved(sub([0.9, 1.9, 2.9], triangle[0])));
        }
        let (cost, x) = sum.target([0.0, 0.0, 0.5]);
        near(add(x, [0.9, 1.9, 2.9]), corner);
        assert!(cost < 1e-7);
    }

    #[test]
    fn flat_and_empty_quadrics_take_the_middle() {
        let flat = Quadric::of_triangle([[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        for quadric in [flat, Quadric::default()] {
            assert_eq!(quadric.target([0.5, 0.25, 0.0]).1, [0.25, 0.125, 0.0]);
        }
    }
}

//! The predicates by their definitions, in exact rationals: centres, radii and distances, not
//! the determinants that the library uses.

use medax::predicates::Sign;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

pub type Vector = [BigRational; 3];

pub fn rational(x: f64) -> BigRational {
    BigRational::from_float(x).expect("finite")
}

pub fn vector(p: &[f64]) -> Vector {
    [rational(p[0]), rational(p[1]), rational(p[2])]
}

pub fn sub(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|i| &a[i] - &b[i])
}

pub fn dot(a: &Vector, b: &Vector) -> BigRational {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

pub fn cross(a: &Vector, b: &Vector) -> Vector {
    let part = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
    [part(1, 2), part(2, 0), part(0, 1)]
}

/// A normal of the plane through a, b, c: the three projected areas of twice the triangle.
pub fn normal(a: &[f64], b: &[f64], c: &[f64]) -> Vector {
    let [a, b, c] = [a, b, c].map(vector);
    cross(&sub(&b, &a), &sub(&c, &a))
}

pub fn weights<const N: usize>(weights: [f64; N]) -> [BigRational; N] {
    weights.map(rational)
}

pub fn sign(x: &BigRational) -> Sign {
    if x.is_positive() {
        Sign::Positive
    } else if x.is_negative() {
        Sign::Negative
    } else {
        Sign::Zero
    }
}

/// Six times the signed volume of abcd.
pub fn volume(a: &[f64], b: &[f64], c: &[f64], d: &[f64]) -> BigRational {
    let [a, b, c, d] = [a, b, c, d].map(vector);
    dot(&cross(&sub(&b, &a), &sub(&c, &a)), &sub(&d, &a))
}

/// The difference of e's power and a's to the sphere orthogonal to a, b, c, d.
///
/// The centre solves 2 (p - a) . (x - a) = |p - a|^2 - (w_p - w_a) for p = b, c, d. Negative
/// when e is in conflict with the cell. `None` if a, b, c, d are coplanar.
pub fn excess(points: [&[f64; 3]; 5], weights: &[BigRational]) -> Option<BigRational> {
    let origin = vector(points[0]);
    let [_, b, c, d, e] = points.map(|p| sub(&vector(p), &origin));
    let weight = |i: usize| &weights[i] - &weights[0];
    let two = BigRational::from_integer(BigInt::from(2));
    let right = [1, 2, 3].map(|i| {
        let row = [&b, &c, &d][i - 1];
        (dot(row, row) - weight(i)) / &two
    });
    let determinant = dot(&cross(&b, &c), &d);
    if determinant.is_zero() {
        return None;
    }
    let terms = [cross(&c, &d), cross(&d, &b), cross(&b, &c)];
    let centre: Vector = std::array::from_fn(|i| {
        (&terms[0][i] * &right[0] + &terms[1][i] * &right[1] + &terms[2][i] * &right[2])
            / &determinant
    });
    // |x - e|^2 - w_e - |x|^2 + w_a = |e|^2 - 2 x . e - (w_e - w_a)
    Some(dot(&e, &e) - two * dot(&centre, &e) - weight(4))
}

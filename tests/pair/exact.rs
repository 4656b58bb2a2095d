//! Orientations by their definition: in f64 where rounding cannot matter, else in rationals.

use num_rational::BigRational;
use num_traits::Zero;
use std::cmp::Ordering::{self, Equal, Greater, Less};

/// The sign of a determinant, from what rounding leaves of it and the sum of the sizes of its products.
fn sign(value: f64, size: f64, exact: impl Fn() -> BigRational) -> Ordering {
    // Some twenty roundings of 1.1e-16 each are far less.
    if value.abs() > 1e-14 * size {
        return if value > 0.0 { Greater } else { Less };
    }
    exact().cmp(&BigRational::zero())
}

fn rational(x: f64) -> BigRational {
    BigRational::from_float(x).unwrap()
}

/// The sign of the determinant of b - a, c - a, d - a.
pub fn in_space([a, b, c, d]: [[f64; 3]; 4]) -> Ordering {
    let [u, v, w] = [b, c, d].map(|p| [0, 1, 2].map(|k| p[k] - a[k]));
    let (mut value, mut size) = (0.0, 0.0);
    for [i, j, k] in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
        let (plus, minus) = (v[j] * w[k], v[k] * w[j]);
        value += u[i] * (plus - minus);
        size += u[i].abs() * (plus.abs() + minus.abs());
    }
    sign(value, size, || {
        let [a, b, c, d] = [a, b, c, d].map(|p| p.map(rational));
        let [u, v, w] = [b, c, d].map(|p| [0, 1, 2].map(|k| &p[k] - &a[k]));
        let part = |[i, j, k]: [usize; 3]| &u[i] * (&v[j] * &w[k] - &v[k] * &w[j]);
        part([0, 1, 2]) + part([1, 2, 0]) + part([2, 0, 1])
    })
}

/// The sign of the determinant of b - a, c - a, along x and y.
pub fn in_plane([a, b, c]: [[f64; 3]; 3]) -> Ordering {
    let [u, v] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1]]);
    let (plus, minus) = (u[0] * v[1], u[1] * v[0]);
    sign(plus - minus, plus.abs() + minus.abs(), || {
        let [a, b, c] = [a, b, c].map(|p| p.map(rational));
        let [u, v] = [b, c].map(|p| [&p[0] - &a[0], &p[1] - &a[1]]);
        &u[0] * &v[1] - &u[1] * &v[0]
    })
}

/// How often triangles turn round a point, counted along a line upward from it, which must meet none of their edges.
pub fn turns(p: [f64; 3], triangles: impl Iterator<Item = [[f64; 3]; 3]>) -> i32 {
    let mut turns = 0;
    for [a, b, c] in triangles {
        let sides = [[a, b, p], [b, c, p], [c, a, p]].map(in_plane);
        let turn = match sides {
            [Greater, Greater, Greater] => 1,
            [Less, Less, Less] => -1,
            _ => {
                let touches =
                    sides.contains(&Equal) && !(sides.contains(&Less) && sides.contains(&Greater));
                assert!(!touches, "{p:?} lies below an edge");
                continue;
            }
        };
        // Below a triangle that points up, the point is on the side from which it runs clockwise.
        match in_space([a, b, c, p]) {
            Less if turn > 0 => turns += 1,
            Greater if turn < 0 => turns -= 1,
            Equal => panic!("{p:?} lies on a triangle"),
            _ => {}
        }
    }
    turns
}

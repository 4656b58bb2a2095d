//! Directions: the normals of facets, and unit vectors.

use super::center::power_of_two;
use super::exact;
use crate::predicates::double_double::Pairs;

/// The error of a normal's coordinate, relative to itself, past which integers decide.
const NORMAL_ERROR: f64 = power_of_two(-60);

/// The right-handed unit normal of a triangle that is not degenerate, each coordinate right to a few
/// 2^-53 of itself, however thin the triangle: so its products with the triangle's edges cancel as far
/// as rounding lets them.
pub(super) fn normal([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let (u, v) = (Pairs::difference(b, a), Pairs::difference(c, a));
    let (forward, backward) = ([1, 2, 0], [2, 0, 1]);
    let cross = u.pick(forward).mul(&v.pick(backward)).sub(&u.pick(backward).mul(&v.pick(forward)));
    // The error is 15u² of the size, the same formula on absolute values.
    let accurate = (0..3).all(|k| {
        let [i, j] = [forward[k], backward[k]];
        let size = (u.hi[i] * v.hi[j]).abs() + (u.hi[j] * v.hi[i]).abs();
        size * 16.0 * power_of_two(-106) <= NORMAL_ERROR * cross.hi[k].abs()
    });
    match accurate {
        true => unit(cross.normalized().hi),
        false => unit(exact::cross([a, b, c])),
    }
}

/// The vector divided by its length, which must not be 0 or infinite.
pub(crate) fn unit(vector: [f64; 3]) -> [f64; 3] {
    let largest = vector.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    // A power of two near the length: the squares neither overflow nor all underflow.
    let exponent = ((largest.to_bits() >> 52) as i32 - 1023).clamp(-1000, 1000);
    let scaled = vector.map(|x| x * power_of_two(-exponent));
    let length = scaled.iter().map(|x| x * x).sum::<f64>().sqrt();
    // Adding 0 turns -0 into 0.
    scaled.map(|x| x / length + 0.0)
}

//! The vertex of least power at a point.

use super::{Incidence, Triangulation};
use crate::predicates::UNIT;
use crate::vector::{dot, sub};
use num_bigint::BigInt;
use std::cmp::Ordering;

/// Goes from vertex to vertex of a triangulation, each of less power than the one before, to the vertex whose cell of the
/// power diagram, or Voronoi cell, holds a point.
pub(crate) struct Descent<'a> {
    triangulation: &'a Triangulation,
    incidence: &'a Incidence,
}

impl<'a> Descent<'a> {
    /// On a triangulation with the cells of its vertices.
    pub fn new(triangulation: &'a Triangulation, incidence: &'a Incidence) -> Self {
        Descent { triangulation, incidence }
    }

    /// The vertex of least power at a point, of several the least, beginning at another one that is not hidden: where none of its
    /// neighbours has less no vertex has, since the cells of the diagram are convex. Powers are compared exactly. Cost: O(way).
    pub fn nearest(&self, at: [f64; 3], from: u32) -> u32 {
        let mut here = from;
        while let Some(next) = self.nearer(at, here) {
            here = next;
        }
        here
    }

    /// Of the neighbours of a vertex the one of least power at a point, if that is less than the vertex's own, or as much and it
    /// comes before it. If there is none, no vertex of the triangulation is nearer. Cost: that of looking at all of them.
    pub fn nearer(&self, at: [f64; 3], than: u32) -> Option<u32> {
        let t = self.triangulation;
        let mut next = than;
        for &cell in self.incidence.cells_of(than) {
            for vertex in t.cells()[cell as usize] {
                if vertex == next {
                    continue;
                }
                match power_order(at, t.site(vertex), t.site(next)) {
                    Ordering::Less => next = vertex,
                    Ordering::Equal => next = next.min(vertex),
                    Ordering::Greater => {}
                }
            }
        }
        (next != than).then_some(next)
    }

    /// Whether one vertex has no more power at a point than another: exact.
    pub fn is_as_near(&self, at: [f64; 3], vertex: u32, than: u32) -> bool {
        let t = self.triangulation;
        power_order(at, t.site(vertex), t.site(than)) != Ordering::Greater
    }
}

/// The order of the powers of a point to two balls, given as centres and weights.
pub(super) fn power_order(at: [f64; 3], p: [f64; 4], q: [f64; 4]) -> Ordering {
    let power = |[x, y, z, weight]: [f64; 4]| {
        let to = sub([x, y, z], at);
        let square = dot(to, to);
        // Seven roundings at most, each of what is no larger than the sum.
        (square - weight, 8.0 * UNIT * (square + weight.abs()))
    };
    let ((a, a_error), (b, b_error)) = (power(p), power(q));
    // What overflows is decided exactly, as what is too close.
    if (a - b).abs() > 1.01 * (a_error + b_error) + f64::MIN_POSITIVE {
        return a.total_cmp(&b);
    }
    exact_power_order(at, p, q)
}

#[cold]
fn exact_power_order(at: [f64; 3], p: [f64; 4], q: [f64; 4]) -> Ordering {
    let coordinates = at.iter().chain(&p[..3]).chain(&q[..3]).map(|&x| decode(x).1);
    let weights = [p[3], q[3]].map(|w| decode(w).1.div_euclid(2));
    let unit = coordinates.chain(weights).min().unwrap_or(0).min(0);
    let integer = |x: f64, unit: i32| {
        let (mantissa, exponent) = decode(x);
        BigInt::from(mantissa) << (exponent - unit).max(0) as usize
    };
    let power = |ball: [f64; 4]| {
        let to = |k: usize| integer(ball[k], unit) - integer(at[k], unit);
        (0..3).map(|k| to(k) * to(k)).sum::<BigInt>() - integer(ball[3], 2 * unit)
    };
    power(p).cmp(&power(q))
}

/// The mantissa and the exponent of a finite float; an exponent of 0 for 0.
fn decode(x: f64) -> (i64, i32) {
    let biased = (x.to_bits() >> 52 & 0x7ff) as i32;
    let fraction = (x.to_bits() & ((1 << 52) - 1)) as i64;
    let mantissa = if biased == 0 { fraction } else { fraction | 1 << 52 };
    let sign = if x < 0.0 { -1 } else { 1 };
    if mantissa == 0 { (0, 0) } else { (sign * mantissa, biased.max(1) - 1075) }
}

#[cfg(test)]
mod tests {
    use super::{Ordering, power_order};

    #[test]
    fn powers_that_rounding_makes_equal_are_told_apart() {
        let far = 1e8;
        let ball = |x: f64, weight: f64| [x, 0.0, 0.0, weight];
        let order = |p, q| power_order([0.0; 3], p, q);
        assert_eq!(order(ball(far, 0.0), ball(far, 0.5)), Ordering::Greater);
        assert_eq!(order(ball(far, 0.5), ball(far, 0.0)), Ordering::Less);
        assert_eq!(order(ball(far, 0.5), ball(-far, 0.5)), Ordering::Equal);
        // (1 + u)^2 - 2u is more than 1 by u^2, which no float of that size shows.
        let u = f64::EPSILON;
        assert_eq!(order(ball(1.0 + u, 2.0 * u), ball(1.0, 0.0)), Ordering::Greater);
        assert_eq!(order(ball(3.0, 5.0), ball(1.0, 0.0)), Ordering::Greater);
    }
}

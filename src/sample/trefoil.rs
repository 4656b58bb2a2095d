//! The tube about a trefoil knot: nearest point of the knot, and uniform points of the tube.

use super::random::Random;
use super::{Sample, Source};
use crate::vector::{Vec3, add, dot, length, scale, sub, unit};
use std::f64::consts::TAU;

/// The tube's radius. The knot's own reach, found numerically, is 0.607: the tube is about as far
/// from its inner axis as from its outer one.
const RADIUS: f64 = 0.3;
/// The largest speed of the parameterisation, 5.83096, and the largest curvature, 1 / 1.28730.
const SPEED_BOUND: f64 = 5.831;
const CURVATURE_BOUND: f64 = 0.777;
/// How many points of the knot start the search for the nearest one.
const STARTS: usize = 96;

/// The knot at `t`: position, first and second derivative.
fn knot(t: f64) -> [Vec3; 3] {
    let (s, c) = libm::sincos(t);
    let (s2, c2) = (2.0 * s * c, c * c - s * s);
    let (s3, c3) = (s2 * c + c2 * s, c2 * c - s2 * s);
    [
        [s + 2.0 * s2, c - 2.0 * c2, -s3],
        [c + 4.0 * c2, 4.0 * s2 - s, -3.0 * c3],
        [-s - 8.0 * s2, 8.0 * c2 - c, 9.0 * s3],
    ]
}

/// The knot's point nearest to `p`.
///
/// Every start that is no farther than its neighbours along the knot is refined, by golden
/// section and then by Newton's method, whose error is that of the arithmetic.
fn nearest(p: Vec3) -> Vec3 {
    let step = TAU / STARTS as f64;
    let square = |t: f64| {
        let d = sub(knot(t)[0], p);
        dot(d, d)
    };
    let starts: [f64; STARTS] = std::array::from_fn(|i| square(i as f64 * step));
    let mut best = (f64::INFINITY, [0.0; 3]);
    for i in 0..STARTS {
        let (before, after) = (starts[(i + STARTS - 1) % STARTS], starts[(i + 1) % STARTS]);
        if starts[i] > before || starts[i] > after {
            continue;
        }
        let middle = i as f64 * step;
        let mut t = golden_section(square, middle - step, middle + step);
        for _ in 0..3 {
            let [c, c1, c2] = knot(t);
            let d = sub(c, p);
            let bend = dot(c1, c1) + dot(d, c2);
            if bend > 0.0 {
                t -= dot(d, c1) / bend;
            }
        }
        let found = square(t);
        if found < best.0 {
            best = (found, knot(t)[0]);
        }
    }
    best.1
}

/// A local minimum of `f` in [low, high], to about the root of the machine precision.
fn golden_section(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let ratio = (5f64.sqrt() - 1.0) / 2.0;
    let (mut a, mut b) = (high - ratio * (high - low), low + ratio * (high - low));
    let (mut at_a, mut at_b) = (f(a), f(b));
    while high - low > 1e-7 {
        if at_a < at_b {
            (high, b, at_b) = (b, a, at_a);
            a = high - ratio * (high - low);
            at_a = f(a);
        } else {
            (low, a, at_a) = (a, b, at_b);
            b = low + ratio * (high - low);
            at_b = f(b);
        }
    }
    (low + high) / 2.0
}

/// The distance to the knot.
pub(super) fn distance_to_knot(p: Vec3) -> f64 {
    length(sub(p, nearest(p)))
}

/// The signed distance to the tube, and its gradient.
pub(super) fn tube(p: Vec3) -> (f64, Vec3) {
    let from_knot = sub(p, nearest(p));
    (length(from_knot) - RADIUS, unit(from_knot))
}

/// Uniform points of the tube, by its parameters and rejection: at the point of the knot with
/// speed v and second derivative c'', the area element towards the unit normal e is
/// r (v - r c''.e / v).
pub(super) struct Tube;

impl Source for Tube {
    fn throws(&self, density: f64) -> f64 {
        density * Tube::bound() * TAU * TAU
    }

    fn throw(&self, random: &mut Random, into: &mut Vec<Sample>) {
        let [c, c1, c2] = knot(TAU * random.uniform());
        let speed = length(c1);
        let tangent = scale(c1, 1.0 / speed);
        // A uniform direction of space projects to a uniform one of the normal plane.
        let direction = random.direction();
        let normal = unit(sub(direction, scale(tangent, dot(direction, tangent))));
        let element = RADIUS * (speed - RADIUS * dot(c2, normal) / speed);
        if random.uniform() * Tube::bound() < element {
            into.push(Sample { point: add(c, scale(normal, RADIUS)), normal });
        }
    }
}

impl Tube {
    /// The largest area element.
    fn bound() -> f64 {
        RADIUS * SPEED_BOUND * (1.0 + RADIUS * CURVATURE_BOUND)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_hold_all_round_the_knot() {
        let (mut speed, mut curvature): (f64, f64) = (0.0, 0.0);
        for i in 0..10_000 {
            let [_, c1, c2] = knot(TAU * f64::from(i) / 10_000.0);
            let v = length(c1);
            let tangent = scale(c1, 1.0 / v);
            speed = speed.max(v);
            let bend = sub(c2, scale(tangent, dot(c2, tangent)));
            curvature = curvature.max(length(bend) / (v * v));
        }
        assert!(speed <= SPEED_BOUND && speed > 0.9999 * SPEED_BOUND, "{speed}");
        assert!(curvature <= CURVATURE_BOUND && curvature > 0.999 * CURVATURE_BOUND, "{curvature}");
    }

    #[test]
    fn derivatives_are_those_of_the_curve() {
        let h = 1e-5;
        for i in 0..100 {
            let t = f64::from(i) * 0.0631;
            let ([back, back1, _], [ahead, ahead1, _]) = (knot(t - h), knot(t + h));
            let [_, c1, c2] = knot(t);
            assert!(length(sub(scale(sub(ahead, back), 0.5 / h), c1)) < 1e-8);
            assert!(length(sub(scale(sub(ahead1, back1), 0.5 / h), c2)) < 1e-8);
        }
    }

    #[test]
    fn no_point_of_the_knot_is_nearer_than_the_nearest() {
        let mut random = Random::new(7);
        for _ in 0..200 {
            let p = [4.0 * random.signed(), 4.0 * random.signed(), 2.0 * random.signed()];
            let found = distance_to_knot(p);
            let brute = (0..20_000)
                .map(|i| length(sub(knot(TAU * f64::from(i) / 20_000.0)[0], p)))
                .fold(f64::INFINITY, f64::min);
            assert!(found <= brute && brute - found < 1e-5, "{found} {brute}");
        }
    }
}

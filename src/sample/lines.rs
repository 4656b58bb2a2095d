//! Uniform points of an implicit surface: where random lines cross it.
//!
//! Lines drawn from the one distribution that no rigid motion changes cross every piece of a
//! surface in proportion to its area (Cauchy, Crofton; Santalo 1976, *Integral Geometry and
//! Geometric Probability*, III.14). Those that meet a ball are the chords between two independent
//! uniform points of its sphere (Rovira and others 2005, *Point sampling with uniformly
//! distributed lines*).

use super::random::Random;
use super::{Sample, Shape, Source};
use crate::vector::{Vec3, add, length, scale, sub, unit};
use std::f64::consts::TAU;

/// The lines that meet the ball about a shape.
pub(super) struct Lines {
    shape: Shape,
    center: Vec3,
    radius: f64,
    /// The least step along a line. Two crossings nearer to each other may be missed; of the lines
    /// that meet a ball of radius r, one in (2 r / step)^2 crosses it so.
    step: f64,
}

impl Lines {
    pub(super) fn new(shape: Shape) -> Self {
        let bounds = shape.bounds();
        let center = scale(add(bounds.min, bounds.max), 0.5);
        let radius = 0.5 * bounds.diagonal() * 1.001;
        Lines { shape, center, radius, step: 1e-3 * radius }
    }
}

impl Source for Lines {
    fn throws(&self, density: f64) -> f64 {
        // A surface of area A is crossed A / (2 pi R^2) times by a line on average.
        density * TAU * self.radius * self.radius
    }

    fn throw(&self, random: &mut Random, into: &mut Vec<Sample>) {
        let end = |direction: Vec3| add(self.center, scale(direction, self.radius));
        let (from, to) = (end(random.direction()), end(random.direction()));
        let direction = unit(sub(to, from));
        let reach = length(sub(to, from));
        let at = |t: f64| add(from, scale(direction, t));
        let value = |t: f64| self.shape.value(at(t));
        let mut here = (0.0, value(0.0));
        while here.0 < reach {
            // The value bounds the distance to the surface: a step of that length crosses
            // nothing, and a step that is a little longer crosses when the surface is near.
            let t = here.0 + here.1.abs().max(self.step);
            let next = (t, value(t));
            if (here.1 < 0.0) != (next.1 < 0.0) {
                let point = at(root(value, here, next));
                into.push(Sample { point, normal: unit(self.shape.gradient(point)) });
            }
            here = next;
        }
    }
}

/// The root of `f` between two arguments where it differs in sign, to the precision of the
/// arithmetic: regula falsi with the Illinois correction (Dowell, Jarratt 1971), then bisection.
fn root(f: impl Fn(f64) -> f64, mut a: (f64, f64), mut b: (f64, f64)) -> f64 {
    let mut weight = (a.1, b.1);
    for round in 0..100 {
        let middle = if round < 12 {
            (a.0 * weight.1 - b.0 * weight.0) / (weight.1 - weight.0)
        } else {
            0.5 * (a.0 + b.0)
        };
        if middle <= a.0 || middle >= b.0 || a.1 == 0.0 || b.1 == 0.0 {
            break;
        }
        let found = (middle, f(middle));
        if (found.1 < 0.0) == (a.1 < 0.0) {
            a = found;
            weight = (a.1, 0.5 * weight.1);
        } else {
            b = found;
            weight = (0.5 * weight.0, b.1);
        }
    }
    if a.1.abs() < b.1.abs() { a.0 } else { b.0 }
}

#[cfg(test)]
mod tests {
    use super::super::trefoil::Tube;
    use super::*;
    use crate::vector::dot;

    fn candidates(source: &impl Source, throws: usize) -> Vec<Sample> {
        let (mut random, mut found) = (Random::new(11), Vec::new());
        (0..throws).for_each(|_| source.throw(&mut random, &mut found));
        found
    }

    /// The share of the candidates that pass, and five standard errors of it. Candidates on one
    /// line depend on each other: their number counts as that of the lines.
    fn share(found: &[Sample], pass: impl Fn(&Sample) -> bool, throws: usize) -> (f64, f64) {
        let share = found.iter().filter(|sample| pass(sample)).count() as f64 / found.len() as f64;
        (share, 5.0 * (share * (1.0 - share) / throws.min(found.len()) as f64).sqrt())
    }

    #[test]
    fn crossings_are_uniform_by_area() {
        let throws = 60_000;
        // The box's sides have areas 1.5, 2 and 3, twice each.
        let found = candidates(&Lines::new(Shape::Box), throws);
        for (axis, area) in [(0, 1.5), (1, 2.0), (2, 3.0)] {
            for sign in [1.0, -1.0] {
                let (share, error) = share(&found, |s| s.normal[axis] == sign, throws);
                assert!((share - area / 13.0).abs() < error, "{axis} {sign} {share} {error}");
            }
        }
        // Of a torus the half that faces away from the axis has the share 1/2 + r / (pi R).
        let found = candidates(&Lines::new(Shape::Torus), throws);
        let faces_away = |s: &Sample| s.normal[0] * s.point[0] + s.normal[1] * s.point[1] > 0.0;
        let (share, error) = share(&found, faces_away, throws);
        assert!((share - (0.5 + 0.4 / std::f64::consts::PI)).abs() < error, "{share} {error}");
    }

    #[test]
    fn lines_and_parameters_agree_on_the_trefoil() {
        let (lines, tube) = (Lines::new(Shape::Trefoil), Tube);
        let (by_lines, by_tube) = (candidates(&lines, 6_000), candidates(&tube, 60_000));
        let area = |source: &dyn Source, found: &[Sample], throws: f64| {
            found.len() as f64 * source.throws(1.0) / throws
        };
        let areas = [area(&lines, &by_lines, 6e3), area(&tube, &by_tube, 6e4)];
        assert!((areas[0] / areas[1] - 1.0).abs() < 0.05, "{areas:?}");
        for direction in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.6, 0.0, 0.8]] {
            for least in [0.5, 1.5] {
                let beyond = |s: &Sample| dot(s.point, direction) > least;
                let (a, a_error) = share(&by_lines, beyond, 6_000);
                let (b, b_error) = share(&by_tube, beyond, 60_000);
                assert!((a - b).abs() <= a_error + b_error, "{direction:?} {least} {a} {b}");
                let up = |s: &Sample| dot(s.normal, direction) > 0.5 * least;
                let (a, a_error) = share(&by_lines, up, 6_000);
                let (b, b_error) = share(&by_tube, up, 60_000);
                assert!((a - b).abs() <= a_error + b_error, "{direction:?} {least} {a} {b}");
            }
        }
    }

    #[test]
    fn roots_are_found_to_the_last_bits() {
        let cubic = |x: f64| x * x * x - 2.0;
        let found = root(cubic, (0.0, -2.0), (40.0, cubic(40.0)));
        assert!((found - libm::cbrt(2.0)).abs() <= 4e-16);
        let step = |x: f64| if x < 0.7 { -1.0 } else { 1.0 };
        assert!((root(step, (0.0, -1.0), (1.0, 1.0)) - 0.7).abs() < 1e-15);
    }
}

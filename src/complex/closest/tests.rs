//! Distances against exact rationals.

use super::*;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

type Exact = [BigRational; 3];

fn exact_sub(a: &Exact, b: &Exact) -> Exact {
    std::array::from_fn(|i| &a[i] - &b[i])
}

fn exact_dot(a: &Exact, b: &Exact) -> BigRational {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// The squared distance to the hull of the corners: to the foot in their affine hull, where that
/// lies inside, else to the nearest of the facets.
fn exact_distance_2(p: &Exact, corners: &[Exact]) -> BigRational {
    let from = exact_sub(p, &corners[0]);
    let sides: Vec<Exact> = corners[1..].iter().map(|c| exact_sub(c, &corners[0])).collect();
    let n = sides.len();
    let mut rows: Vec<Vec<BigRational>> = sides
        .iter()
        .map(|u| {
            let mut row: Vec<_> = sides.iter().map(|v| exact_dot(u, v)).collect();
            row.push(exact_dot(u, &from));
            row
        })
        .collect();
    let mut regular = true;
    for k in 0..n {
        let Some(pivot) = (k..n).find(|&r| !rows[r][k].is_zero()) else {
            regular = false;
            break;
        };
        rows.swap(k, pivot);
        let pivot = rows[k].clone();
        for r in (0..n).filter(|&r| r != k) {
            let factor = &rows[r][k] / &pivot[k];
            rows[r].iter_mut().zip(&pivot).for_each(|(x, y)| *x -= &factor * y);
        }
    }
    if regular {
        let weights: Vec<BigRational> = (0..n).map(|k| &rows[k][n] / &rows[k][k]).collect();
        let sum: BigRational = weights.iter().sum();
        if weights.iter().all(|w| !w.is_negative()) && sum <= BigRational::from_integer(1.into()) {
            let mut foot = from;
            for (w, u) in weights.iter().zip(&sides) {
                foot = std::array::from_fn(|i| &foot[i] - w * &u[i]);
            }
            return exact_dot(&foot, &foot);
        }
    }
    // A flat simplex is the union of its facets.
    (0..corners.len())
        .map(|k| {
            let facet: Vec<Exact> =
                (0..corners.len()).filter(|&i| i != k).map(|i| corners[i].clone()).collect();
            exact_distance_2(p, &facet)
        })
        .min()
        .unwrap()
}

fn exact(p: &Point) -> Exact {
    p.map(|x| BigRational::from_float(x).unwrap())
}

/// Compares with exact arithmetic; errors count in units of the largest distance in sight.
fn check(p: Point, corners: &[Point]) {
    let all: Vec<Exact> = corners.iter().map(exact).collect();
    let expected = exact_distance_2(&exact(&p), &all).to_f64().unwrap().sqrt();
    let found = distance_2(p, corners).sqrt();
    let extent = corners.iter().map(|&c| squared_length(sub(p, c)).sqrt()).fold(0.0, f64::max);
    assert!(
        (found - expected).abs() <= 16.0 * f64::EPSILON * extent,
        "{found} is not {expected}: {p:?} and {corners:?}"
    );
}

/// A linear congruential generator (Knuth's MMIX); the high bits serve.
struct Random(u64);

impl Random {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) % n
    }

    fn point(&mut self) -> Point {
        std::array::from_fn(|_| self.below(1 << 30) as f64 / (1 << 29) as f64 - 1.0)
    }
}

#[test]
fn distances_are_exact_up_to_rounding() {
    let mut random = Random(1);
    for round in 0..1200 {
        let count = 1 + round % 4;
        let mut corners: Vec<Point> = (0..count).map(|_| random.point()).collect();
        let p = random.point();
        check(p, &corners);
        // One corner all but on the hull of two others: thinner and thinner, at last flat.
        if count > 2 {
            let (t, u) = (random.point()[0].abs(), random.point());
            let thin = [1e-3, 1e-6, 1e-8, 1e-11, 1e-14, 1e-16, 0.0][random.below(7) as usize];
            let [a, b] = [corners[0], corners[1]];
            corners[2] = std::array::from_fn(|i| (1.0 - t) * a[i] + t * b[i] + thin * u[i]);
            check(p, &corners);
            // And a point all but on that.
            let near = [0.0, 1e-16, 1e-12, 1e-8][random.below(4) as usize];
            let (v, w) = (random.point(), random.point()[0].abs() / 2.0);
            let c = corners[2];
            check(
                std::array::from_fn(|i| a[i] + w * (b[i] - a[i]) + w * (c[i] - a[i]) + near * v[i]),
                &corners,
            );
        }
        // Two corners at the same place.
        if count > 1 {
            corners[1] = corners[0];
            check(p, &corners);
            check(corners[0], &corners);
        }
    }
}

#[test]
fn lattice_points_fall_on_every_feature() {
    let mut random = Random(2);
    for round in 0..6000 {
        let mut point = || -> Point { std::array::from_fn(|_| random.below(4) as f64) };
        let p = point();
        let corners: Vec<Point> = (0..1 + round % 4).map(|_| point()).collect();
        check(p, &corners);
        // The corners, and the middle, belong to the hull.
        for &c in &corners {
            assert_eq!(distance_2(c, &corners), 0.0);
        }
    }
}

#[test]
fn inside_a_tetrahedron_is_no_distance() {
    let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]];
    assert_eq!(distance_2([1.0, 1.0, 1.0], &corners), 0.0);
    let [a, b, c, d] = corners;
    assert_eq!(distance_2([1.0, 1.0, 1.0], &[b, a, c, d]), 0.0);
    assert_eq!(distance_2([1.0, 1.0, -2.0], &corners), 4.0);
}

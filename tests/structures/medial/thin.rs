//! MEDIAL where umbrellas have triangles that are nearly collinear: rotated boxes and plates, of which the samples lie in rows.

use super::{BOTH, assert_valid, cross, dot, length, medial, minus, selected};
use crate::poles::{Exact, exact, exact_cross, exact_dot, exact_minus};
use crate::sets::Random;
use medax::Medial;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::ToPrimitive;
use std::collections::BTreeSet;

/// The lattice points on the surface of a box with so many steps.
fn boxed(steps: [usize; 3]) -> Vec<[f64; 3]> {
    let of = |n: usize| 0..=n;
    let all = of(steps[0])
        .flat_map(|i| of(steps[1]).flat_map(move |j| of(steps[2]).map(move |k| [i, j, k])));
    let is_outside = |p: &[usize; 3]| (0..3).any(|k| p[k] == 0 || p[k] == steps[k]);
    all.filter(is_outside).map(|p| [0, 1, 2].map(|k| p[k] as f64 / steps[0] as f64)).collect()
}

/// The points turned at random about the origin, each coordinate rounded by a function.
fn turned(rows: &[[f64; 3]], seed: u64, round: fn(f64) -> f64) -> Vec<[f64; 3]> {
    let mut random = Random(seed);
    let unit = |a: [f64; 3]| a.map(|x| x / length(a));
    let x = unit(random.sphere());
    let y = unit(cross(x, random.sphere()));
    let z = cross(x, y);
    rows.iter().map(|&p| [x, y, z].map(|axis| round(dot(axis, p)))).collect()
}

/// The umbrella of a sample in rationals: the normals of its triangles, and its largest squared circumradius.
struct Umbrella {
    normals: Vec<Exact>,
    radius_squared: BigRational,
}

impl Umbrella {
    fn new(medial: &Medial, v: u32) -> Self {
        let at = |v: u32| exact(medial.dual().triangulation().coords()[v as usize]);
        let p = at(v);
        let mut normals = Vec::new();
        let mut radius_squared = BigRational::from(BigInt::ZERO);
        for &[a, b] in medial.umbrellas().rims_of(v) {
            let [a, b] = [a, b].map(|v| exact_minus(&at(v), &p));
            let c = exact_minus(&a, &b);
            let n = exact_cross(&a, &b);
            let square = |x: &Exact| exact_dot(x, x);
            let four = BigRational::from(BigInt::from(4));
            let its = square(&a) * square(&b) * square(&c) / (four * square(&n));
            radius_squared = radius_squared.max(its);
            normals.push(n);
        }
        Umbrella { normals, radius_squared }
    }

    /// The sine and the ratio of an edge.
    fn conditions(&self, edge: &Exact) -> (f64, f64) {
        let size = exact_dot(edge, edge);
        let sine = |n: &Exact| {
            let along = exact_dot(n, edge);
            &along * &along / (exact_dot(n, n) * &size)
        };
        let least = self.normals.iter().map(sine).min().unwrap();
        let ratio = &size / &self.radius_squared;
        (least.to_f64().unwrap().sqrt(), ratio.to_f64().unwrap().sqrt())
    }
}

/// Compares sines, ratios and what is chosen with rationals, at all samples with a thin umbrella triangle. Returns how many ends of edges were compared.
fn equals_rationals(rows: &[[f64; 3]], name: &str) -> usize {
    let medial = medial(rows);
    assert_valid(&medial, name);
    let coords = medial.dual().triangulation().coords();
    let umbrellas: Vec<Option<Umbrella>> = (0..coords.len() as u32)
        .map(|v| {
            let is_thin = |&[a, b]: &[u32; 2]| {
                let [p, a, b] = [v, a, b].map(|v| coords[v as usize]);
                let sides = [minus(a, p), minus(b, a), minus(p, b)];
                let longest = sides.map(length).into_iter().fold(0.0, f64::max);
                length(cross(sides[0], sides[1])) < 1e-6 * longest * longest
            };
            let thin = medial.umbrellas().rims_of(v).iter().any(is_thin);
            thin.then(|| Umbrella::new(&medial, v))
        })
        .collect();
    let chosen: BTreeSet<u32> = selected(&medial, &BOTH).into_iter().collect();
    let mut compared = 0;
    for (facet, ends) in medial.dual().facets().unwrap().edges().iter().enumerate() {
        let mut passes = [false; 2];
        let mut is_near = false;
        for i in 0..2 {
            let is = (medial.sines()[facet][i], medial.ratios()[facet][i]);
            let right = match &umbrellas[ends[i] as usize] {
                Some(umbrella) if is.0 >= 0.0 => {
                    let [p, q] = [i, 1 - i].map(|i| exact(coords[ends[i] as usize]));
                    compared += 1;
                    umbrella.conditions(&exact_minus(&q, &p))
                }
                _ => is,
            };
            let agree = (is.0 == right.0 || (is.0 - right.0).abs() < 1e-12)
                && (is.1 == right.1 || (is.1 - right.1).abs() < 1e-12 * right.1);
            assert!(agree, "{name}: {ends:?} has {is:?}, not {right:?}");
            passes[i] = right.0 > BOTH.theta.sin() || right.1 > BOTH.rho;
            is_near |= (right.0 - BOTH.theta.sin()).abs() < 1e-9;
            is_near |= (right.1 - BOTH.rho).abs() < 1e-9;
        }
        let is_chosen = chosen.contains(&(facet as u32));
        assert!(is_near || is_chosen == passes.contains(&true), "{name}: {ends:?}");
    }
    compared
}

#[test]
fn sines_and_ratios_of_rotated_boxes_and_plates_equal_rationals() {
    let single: fn(f64) -> f64 = |x| f64::from(x as f32);
    let mut compared = 0;
    for steps in [[14; 3], [40, 20, 1], [24, 9, 3]] {
        for seed in 0..4 {
            for (round, digits) in [((|x| x) as fn(f64) -> f64, "f64"), (single, "f32")] {
                let rows = turned(&boxed(steps), seed, round);
                compared +=
                    equals_rationals(&rows, &format!("{steps:?} turned by {seed}, {digits}"));
            }
        }
    }
    println!("{compared} ends of edges");
    assert!(compared > 3000);
}

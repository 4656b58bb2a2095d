//! How near and how far facets come to the middles of their edges, against rationals, where spheres are the same or nearly so.

use super::{BOTH, assert_valid, length, medial, minus, selected};
use crate::poles::{Exact, exact, exact_center, exact_cross, exact_dot, exact_minus};
use crate::sets::{self, Random};
use medax::Medial;
use medax::medial::{MedialFilter, MedialRule};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};
use std::f64::consts::PI;

/// Integer points of one sphere, so that every Voronoi vertex within the hull is its centre.
pub fn on_a_sphere(square: i32) -> Vec<[f64; 3]> {
    let root = f64::from(square).sqrt() as i32;
    let range = -root..=root;
    let xy = range.clone().flat_map(|x| range.clone().map(move |y| (x, y)));
    let all = xy.flat_map(|(x, y)| range.clone().map(move |z| [x, y, z]));
    all.filter(|p| p.iter().map(|x| x * x).sum::<i32>() == square)
        .map(|p| p.map(f64::from))
        .collect()
}

/// Points of a unit sphere that only rounding keeps from having one Voronoi vertex within the hull.
pub fn nearly_on_a_sphere(count: usize) -> Vec<[f64; 3]> {
    let mut random = Random(count as u64);
    let on = |p: [f64; 3]| p.map(|x| x / length(p));
    (0..count).map(|_| on(random.sphere())).collect()
}

/// The exact squared distance of a point from a convex polygon in a plane through it, whose normal is given.
fn to_polygon(point: &Exact, corners: &[Exact], normal: &Exact) -> BigRational {
    let mut nearest = exact_dot(&exact_minus(&corners[0], point), &exact_minus(&corners[0], point));
    let (mut is_left, mut is_flat) = (true, true);
    for (i, a) in corners.iter().enumerate() {
        let b = &corners[(i + 1) % corners.len()];
        let (side, from) = (exact_minus(b, a), exact_minus(point, a));
        let square = exact_dot(&side, &side);
        if square.is_zero() {
            continue;
        }
        let turn = exact_dot(&exact_cross(&side, &from), normal);
        is_left &= !turn.is_negative();
        is_flat &= turn.is_zero();
        let share = exact_dot(&from, &side) / square;
        let share = share.max(BigRational::zero()).min(BigRational::from(BigInt::from(1)));
        let gap: Exact = std::array::from_fn(|k| &from[k] - &side[k] * &share);
        nearest = nearest.min(exact_dot(&gap, &gap));
    }
    if is_left && !is_flat { BigRational::zero() } else { nearest }
}

fn assert_exact(medial: &Medial, name: &str) {
    let (dual, facets) = (medial.dual(), medial.dual().facets().unwrap());
    let t = dual.triangulation();
    let of_cell = |corners: &[u32; 4]| exact_center(corners.map(|v| t.coords()[v as usize]));
    let centers: Vec<Exact> = t.cells().iter().map(of_cell).collect();
    let mut checked = 0;
    for (facet, ends) in facets.edges().iter().enumerate() {
        if facets.is_unbounded(facet) {
            continue;
        }
        let [p, q] = ends.map(|v| exact(t.coords()[v as usize]));
        let two = BigRational::from(BigInt::from(2));
        let middle: Exact = std::array::from_fn(|k| (&p[k] + &q[k]) / &two);
        let corners: Vec<_> =
            facets.ring(facet).iter().map(|&cell| centers[cell as usize].clone()).collect();
        let right = to_polygon(&middle, &corners, &exact_minus(&q, &p)).to_f64().unwrap().sqrt();
        let [reach, farthest] = medial.reaches()[facet];
        // Rounded corners are an ulp of the coordinates off.
        let size = farthest + t.coords()[ends[0] as usize].iter().fold(0.0, |m, x| x.abs().max(m));
        assert!((reach - right).abs() <= 1e-12 * size, "{name}, {facet}: {reach}, not {right}");
        checked += 1;
    }
    assert!(checked > 20, "{name}: {checked}");
}

#[test]
fn reaches_of_cospherical_samples_are_exact() {
    for (name, rows) in [
        ("integer sphere", on_a_sphere(50)),
        ("nearly a sphere", nearly_on_a_sphere(120)),
        ("lattice", sets::all(64).swap_remove(3).rows),
        ("random", sets::all(80).swap_remove(0).rows),
    ] {
        let medial = medial(&rows);
        assert_valid(&medial, name);
        assert_exact(&medial, name);
    }
}

#[test]
fn facets_at_the_centre_of_a_sphere_have_the_angle_seen_from_there() {
    let rows = on_a_sphere(50);
    let medial = medial(&rows);
    let facets = medial.dual().facets().unwrap();
    let coords = medial.dual().triangulation().coords();
    let is_point = |facet: usize| {
        let least = |&cell: &u32| medial.least_cell()[cell as usize];
        let ring = facets.ring(facet);
        !facets.is_unbounded(facet) && ring.iter().all(|cell| least(cell) == least(&ring[0]))
    };
    let points: Vec<usize> = (0..facets.len()).filter(|&facet| is_point(facet)).collect();
    let mut flat = 0;
    for &facet in &points {
        let [p, q] = facets.edges()[facet].map(|v| coords[v as usize]);
        // Half the sum, as seen from the centre.
        let distance = length(minus(p, q.map(|x| -x))) / 2.0;
        assert!((medial.reaches()[facet][0] - distance).abs() < 1e-12 * 50.0);
        flat += usize::from(distance == 0.0);
    }
    assert!(points.len() > 200 && flat < 10, "{} {flat}", points.len());
    let straight = MedialFilter { rule: MedialRule::Every, object_angle: 0.999 * PI, ..BOTH };
    let found = selected(&medial, &straight);
    assert_eq!(points.iter().filter(|&&f| found.contains(&(f as u32))).count(), flat);
}

#[test]
fn rounding_of_the_reaches_of_a_turned_cylinder_is_valid() {
    let mut rows = Vec::new();
    for i in 0..60 {
        let (sin, cos) = (f64::from(i) * 0.1).sin_cos();
        for k in 0..20 {
            // A turned frame, so that no two coordinates are the same.
            let [x, y, z] = [cos, sin, f64::from(k) * 0.11 - 1.0];
            rows.push([
                0.36 * x + 0.48 * y - 0.8 * z,
                -0.8 * x + 0.6 * y,
                0.48 * x + 0.64 * y + 0.6 * z,
            ]);
        }
    }
    let medial = medial(&rows);
    assert_valid(&medial, "cylinder");
}

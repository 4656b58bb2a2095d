//! Poles: against exact rationals, on shapes whose medial axis is known, and against `validate`.

use crate::sets::{self, Random, Set};
use medax::complex::{Element, Values};
use medax::dual::DualOptions;
use medax::points::FAR_BOX_LEN;
use medax::{Dual, Job, NONE, Points, Poles, Status, Triangulation};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;
use std::sync::Arc;

fn points(rows: &[[f64; 3]]) -> Points {
    Points::new(rows, Default::default(), &Job::default()).unwrap()
}

fn dual_of(points: Points) -> Dual {
    let t = Triangulation::delaunay(&Arc::new(points), &Job::default()).unwrap();
    Dual::new(&Arc::new(t), DualOptions::default(), &Job::default()).unwrap()
}

/// The poles of the sample alone.
fn alone(rows: &[[f64; 3]]) -> Poles {
    Poles::new(&dual_of(points(rows)), Default::default(), &Job::default()).unwrap()
}

/// The poles of the sample with the far box.
fn boxed(rows: &[[f64; 3]]) -> Poles {
    Poles::new(
        &dual_of(points(rows).with_far_box(&Job::default()).unwrap()),
        Default::default(),
        &Job::default(),
    )
    .unwrap()
}

fn assert_valid(poles: &Poles, name: &str) {
    let report = poles.validate(&Job::default()).unwrap();
    assert!(report.is_valid(), "{name}: {report:?}");
    assert!(report.checked as usize > 3 * poles.sample_count(), "{name} was not checked");
}

fn sample(poles: &Poles, i: usize) -> [f64; 3] {
    poles.triangulation().coords()[i]
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    [0, 1, 2].map(|k| (a[k] - b[k]) * (a[k] - b[k])).iter().sum::<f64>().sqrt()
}

fn center([x, y, z, _]: [f64; 4]) -> [f64; 3] {
    [x, y, z]
}

#[test]
fn every_kind_of_set_is_valid() {
    for Set { name, rows } in sets::all(400) {
        assert_valid(&alone(&rows), name);
        assert_valid(&boxed(&rows), &format!("{name}, far box"));
    }
}

pub type Exact = [BigRational; 3];

pub fn exact(p: [f64; 3]) -> Exact {
    p.map(|x| BigRational::from_float(x).unwrap())
}

pub fn exact_dot(a: &Exact, b: &Exact) -> BigRational {
    (0..3).map(|k| &a[k] * &b[k]).sum()
}

pub fn exact_minus(a: &Exact, b: &Exact) -> Exact {
    std::array::from_fn(|k| &a[k] - &b[k])
}

pub fn exact_cross(a: &Exact, b: &Exact) -> Exact {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}

/// The circumcenter, by Cramer's rule.
pub fn exact_center(points: [[f64; 3]; 4]) -> Exact {
    let [a, b, c, d] = points.map(exact);
    let [b, c, d] = [b, c, d].map(|p| exact_minus(&p, &a));
    let [bc, cd, db] = [exact_cross(&b, &c), exact_cross(&c, &d), exact_cross(&d, &b)];
    let twice = exact_dot(&b, &cd) * BigRational::from(BigInt::from(2));
    std::array::from_fn(|k| {
        let sum =
            exact_dot(&b, &b) * &cd[k] + exact_dot(&c, &c) * &db[k] + exact_dot(&d, &d) * &bc[k];
        &a[k] + sum / &twice
    })
}

/// The longest vector, the least of equal ones.
fn farthest<'a>(vectors: impl Iterator<Item = &'a Exact>) -> Option<&'a Exact> {
    vectors.fold(None, |best, x| match best {
        Some(b) if exact_dot(b, b) > exact_dot(x, x) => best,
        Some(b) if exact_dot(b, b) == exact_dot(x, x) && b <= x => best,
        _ => Some(x),
    })
}

/// The poles of each sample by the definition, as exact points: of all centers the farthest, then
/// the least; `None` at infinity, or where there is none.
fn reference(poles: &Poles) -> Vec<[Option<Exact>; 2]> {
    let t = poles.triangulation();
    let centers: Vec<Exact> =
        t.cells().iter().map(|c| exact_center(c.map(|v| t.coords()[v as usize]))).collect();
    (0..poles.sample_count())
        .map(|i| {
            let s = exact(sample(poles, i));
            let offsets: Vec<(Exact, bool)> = t
                .cells()
                .iter()
                .zip(t.neighbors())
                .zip(&centers)
                .filter(|((cell, _), _)| cell.contains(&(i as u32)))
                .map(|((cell, neighbors), center)| {
                    let open = (0..4).any(|k| neighbors[k] == NONE && cell[k] != i as u32);
                    (exact_minus(center, &s), open)
                })
                .collect();
            let unbounded = offsets.iter().any(|(_, open)| *open);
            let first = match unbounded {
                true => None,
                false => farthest(offsets.iter().map(|(x, _)| x)),
            };
            let axis = first.cloned().unwrap_or_else(|| exact(poles.normals()[i]));
            let second = farthest(
                offsets
                    .iter()
                    .map(|(x, _)| x)
                    .filter(|x| exact_dot(x, &axis) < BigRational::zero()),
            );
            [first, second].map(|x| x.map(|x| std::array::from_fn(|k| &x[k] + &s[k])))
        })
        .collect()
}

/// The poles of every sample are those of the definition.
fn equals_reference(poles: &Poles, name: &str) {
    let t = poles.triangulation();
    let at = |pole: u32| match pole {
        NONE => None,
        pole => {
            let cell = t.cells()[poles.cell_of_pole()[pole as usize] as usize];
            Some(exact_center(cell.map(|v| t.coords()[v as usize])))
        }
    };
    for (i, expected) in reference(poles).into_iter().enumerate() {
        let found = poles.pole_of_sample()[i].map(at);
        assert!(found == expected, "{name}: sample {i}");
    }
}

#[test]
fn small_sets_equal_the_definition_in_rationals() {
    for n in [12, 40] {
        for Set { name, rows } in sets::all(n) {
            for (kind, poles) in [("alone", alone(&rows)), ("far box", boxed(&rows))] {
                equals_reference(&poles, &format!("{name}, {kind}"));
            }
        }
    }
}

/// The centres of a sphere's cells are all at the same distance, but for the rounding of the samples.
#[test]
fn near_ties_are_decided_exactly() {
    let mut random = Random(77);
    for _ in 0..10 {
        let rows: Vec<_> = (0..25).map(|_| random.sphere()).collect();
        for (kind, poles) in [("alone", alone(&rows)), ("far box", boxed(&rows))] {
            assert_valid(&poles, kind);
            equals_reference(&poles, kind);
        }
    }
}

/// Coordinates so small that the centres of balls are rounded to 0 where exact ones are not.
#[test]
fn the_least_coordinates_have_sound_poles() {
    let mut random = Random(78);
    for _ in 0..50 {
        let steps = |x: f64| (5.0 * x).floor() * 2f64.powi(-160);
        let rows: Vec<_> = (0..12).map(|_| random.cube().map(steps)).collect();
        assert_valid(&alone(&rows), "tiny");
        assert_valid(&boxed(&rows), "tiny, far box");
    }
}

#[test]
fn the_inner_poles_of_a_sphere_are_its_center() {
    let mut random = Random(5);
    let rows: Vec<_> = (0..2000).map(|_| random.sphere().map(|x| 3.0 * x + 1.0)).collect();
    let poles = boxed(&rows);
    for i in 0..poles.sample_count() {
        let [first, second] = poles.pole_of_sample()[i];
        let balls = [first, second].map(|pole| poles.balls()[pole as usize]);
        let inner: Vec<_> =
            balls.iter().filter(|ball| distance(center(**ball), [1.0; 3]) < 1e-6).collect();
        assert_eq!(inner.len(), 1, "{balls:?}");
        assert!((inner[0][3] - 3.0).abs() < 1e-6);
        // The normal is that of the sphere, inward or outward.
        let radial = [0, 1, 2].map(|k| (sample(&poles, i)[k] - 1.0) / 3.0);
        let cosine: f64 = (0..3).map(|k| radial[k] * poles.normals()[i][k]).sum();
        assert!(cosine.abs() > 0.9, "{cosine}");
    }
    // Alone the outer poles are at infinity, outward.
    let poles = alone(&rows);
    for i in 0..poles.sample_count() {
        assert_eq!(poles.pole_of_sample()[i][0], NONE);
        let radial = [0, 1, 2].map(|k| (sample(&poles, i)[k] - 1.0) / 3.0);
        let cosine: f64 = (0..3).map(|k| radial[k] * poles.normals()[i][k]).sum();
        assert!(cosine > 0.99, "{cosine}");
        let ball = poles.balls()[poles.pole_of_sample()[i][1] as usize];
        assert!(distance(center(ball), [1.0; 3]) < 1e-6);
    }
}

/// A torus about the z axis, sampled on a jittered grid of its two angles.
fn torus(major: f64, minor: f64, steps: [usize; 2]) -> Vec<[f64; 3]> {
    let mut random = Random(11);
    let angle =
        |i: usize, n: usize, r: f64| (i as f64 + 0.2 * r) / n as f64 * std::f64::consts::TAU;
    (0..steps[0] * steps[1])
        .map(|i| {
            let u = angle(i / steps[1], steps[0], random.unit());
            let v = angle(i % steps[1], steps[1], random.unit());
            let r = major + minor * v.cos();
            [r * u.cos(), r * u.sin(), minor * v.sin()]
        })
        .collect()
}

#[test]
fn the_inner_poles_of_a_torus_lie_on_its_circle() {
    let (major, minor) = (3.0, 1.0);
    let poles = boxed(&torus(major, minor, [240, 80]));
    for i in 0..poles.sample_count() {
        let near = poles.pole_of_sample()[i].iter().filter(|&&pole| {
            let [x, y, z, radius] = poles.balls()[pole as usize];
            let from_circle = ((x * x + y * y).sqrt() - major).hypot(z);
            from_circle < 0.15 && (radius - minor).abs() < 0.02
        });
        assert_eq!(near.count(), 1, "sample {i}");
    }
}

#[test]
fn the_inner_poles_of_a_slab_lie_in_its_middle() {
    // Two planes at z = 0 and z = 1, far wider than the slab is thick. In the middle of the slab the
    // inner pole is half way up.
    let mut random = Random(3);
    let side = 60;
    let rows: Vec<_> = (0..2 * side * side)
        .map(|i| {
            let [u, v] = [i % side, i / side % side].map(|x| x as f64 * 0.1);
            [u + 0.05 * random.unit(), v + 0.05 * random.unit(), (i / side / side) as f64]
        })
        .collect();
    let poles = boxed(&rows);
    let mut middle = 0;
    for i in 0..poles.sample_count() {
        let [x, y, z] = sample(&poles, i);
        if (x - 3.0).abs() > 1.5 || (y - 3.0).abs() > 1.5 {
            continue;
        }
        middle += 1;
        let [first, second] = poles.pole_of_sample()[i].map(|pole| poles.balls()[pole as usize]);
        assert!((second[2] - 0.5).abs() < 0.02, "{second:?}");
        // The first one is outside, above or below.
        assert!((first[2] - z) * (0.5 - z) < 0.0, "{first:?}");
        assert!(poles.normals()[i][2].abs() > 0.99);
    }
    assert!(middle > 1000);
}

#[test]
fn the_poles_of_a_lattice_are_cube_centers_and_ties_go_to_the_least() {
    let rows: Vec<_> = (0..125).map(|i| [i % 5, i / 5 % 5, i / 25].map(f64::from)).collect();
    let poles = alone(&rows);
    assert_valid(&poles, "lattice");
    let inner = |x: &f64| *x >= 1.0 && *x <= 3.0;
    for i in (0..125).filter(|&i| sample(&poles, i).iter().all(inner)) {
        let p = sample(&poles, i);
        let [first, second] = poles.pole_of_sample()[i].map(|pole| poles.balls()[pole as usize]);
        assert_eq!(center(first), p.map(|x| x - 0.5));
        // Opposite are the centers that differ in two coordinates or three; the least of them.
        assert_eq!(center(second), [p[0] - 0.5, p[1] + 0.5, p[2] + 0.5]);
        assert_eq!((first[3], second[3]), (0.75f64.sqrt(), 0.75f64.sqrt()));
    }
    // Every cube is one Voronoi vertex, though it is cut into five cells or six.
    let mut centers: Vec<_> =
        poles.balls().iter().map(|ball| format!("{:?}", center(*ball))).collect();
    centers.sort();
    let count = centers.len();
    centers.dedup();
    assert_eq!((centers.len(), count <= 64), (count, true));
}

#[test]
fn samples_of_one_sphere_share_one_pole() {
    // Eighteen integer points on one sphere, and more: all cells have the same sphere.
    let rows = &sets::all(40).into_iter().find(|set| set.name == "cospherical").unwrap().rows;
    let poles = alone(rows);
    assert_eq!(poles.len(), 1);
    assert_eq!(poles.balls(), &[[0.0, 0.0, 0.0, 3.0]]);
    assert_eq!(poles.cell_of_pole(), &[0]);
    assert!(poles.pole_of_sample().iter().all(|pair| *pair == [NONE, 0]));
    let boxed = boxed(rows);
    let central = boxed.balls().iter().position(|ball| center(*ball) == [0.0; 3]).unwrap();
    assert!(!boxed.touches_far_box()[central]);
    assert!(boxed.touches_far_box().iter().filter(|far| **far).count() >= 6);
    assert!(boxed.pole_of_sample().iter().all(|pair| pair.contains(&(central as u32))));
}

#[test]
fn the_far_box_bounds_everything_and_is_in_no_count() {
    for Set { name, rows } in sets::all(200) {
        let poles = boxed(&rows);
        let vertices = poles.triangulation().coords().len();
        assert_eq!(poles.sample_count() + FAR_BOX_LEN, vertices, "{name}");
        assert!(poles.pole_of_sample().iter().all(|pair| pair[0] != NONE), "{name}");
        assert!(poles.touches_far_box().contains(&true), "{name}");
        assert!(!alone(&rows).touches_far_box().contains(&true), "{name}");
    }
}

#[derive(PartialEq)]
struct Bytes(Vec<u64>, Vec<u32>, Vec<bool>);

fn bytes(poles: &Poles) -> Bytes {
    let floats =
        [poles.balls().as_flattened(), poles.radii_squared(), poles.normals().as_flattened()];
    let indices = [poles.pole_of_sample().as_flattened(), poles.cell_of_pole()];
    Bytes(
        floats.concat().iter().map(|x| x.to_bits()).collect(),
        indices.concat(),
        poles.touches_far_box().to_vec(),
    )
}

#[test]
fn rows_in_another_order_give_the_same_bytes() {
    for Set { name, rows } in sets::all(250) {
        let order = sets::shuffled(rows.len(), 3);
        let shuffled: Vec<_> = order.iter().map(|&i| rows[i]).collect();
        assert!(bytes(&alone(&rows)) == bytes(&alone(&shuffled)), "{name}");
        assert!(bytes(&boxed(&rows)) == bytes(&boxed(&shuffled)), "{name}, far box");
    }
}

#[test]
fn scaling_by_a_power_of_two_scales_the_poles() {
    for Set { name, rows } in sets::all(150) {
        let scale = 2f64.powi(90);
        let large: Vec<_> = rows.iter().map(|p| p.map(|x| x * scale)).collect();
        for (one, two) in [(alone(&rows), alone(&large)), (boxed(&rows), boxed(&large))] {
            assert_eq!(one.pole_of_sample(), two.pole_of_sample(), "{name}");
            assert_eq!(one.normals(), two.normals(), "{name}");
            let scaled: Vec<_> = one.balls().iter().map(|ball| ball.map(|x| x * scale)).collect();
            assert_eq!(scaled, two.balls(), "{name}");
        }
    }
}

#[test]
fn feature_size_is_the_distance_to_the_nearest_pole() {
    // Enough queries for several parts, and poles for many levels.
    let mut random = Random(9);
    let rows: Vec<_> = (0..25_000).map(|_| random.cube()).collect();
    let poles = boxed(&rows);
    assert!(poles.len() > 1 << 15);
    let queries: Vec<_> = (0..1100).map(|_| random.cube().map(|x| 3.0 * x - 1.0)).collect();
    for _ in 0..2 {
        let found = poles.feature_size(&queries, &Job::default()).unwrap();
        for (query, found) in queries.iter().zip(found) {
            let nearest = poles.balls().iter().map(|ball| distance(center(*ball), *query));
            assert_eq!(found, nearest.fold(f64::MAX, f64::min));
        }
    }
}

#[test]
fn feature_size_of_a_torus_is_its_minor_radius() {
    // The medial axis inside is the circle; outside, the axis of rotation is two away.
    let rows = torus(3.0, 1.0, [240, 80]);
    let sizes = boxed(&rows).feature_size(&rows, &Job::default()).unwrap();
    assert!(sizes.iter().all(|size| (size - 1.0).abs() < 0.1));
}

#[test]
fn bad_input_is_an_error_that_says_where() {
    let rows: Vec<_> = sets::all(30).swap_remove(0).rows;
    let poles = boxed(&rows);
    let status = |queries: &[[f64; 3]]| {
        let error = poles.feature_size(queries, &Job::default()).unwrap_err();
        (error.status(), error.element().map(|(_, index)| index))
    };
    assert_eq!(status(&[[0.0; 3], [0.0, f64::NAN, 0.0]]), (Status::NonFinite, Some(1)));
    assert_eq!(status(&[[1e300, 0.0, 0.0]]), (Status::CoordinateRange, Some(0)));
    // Distances to the smallest numbers are as good as those to 0.
    let tiny = poles.feature_size(&[[1e-300, 0.0, 0.0], [0.0; 3]], &Job::default()).unwrap();
    assert_eq!(tiny[0], tiny[1]);
    let t =
        Triangulation::regular(&Arc::new(points(&rows)), &vec![0.0; rows.len()], &Job::default());
    let dual = Dual::new(&Arc::new(t.unwrap()), DualOptions::default(), &Job::default()).unwrap();
    let error = Poles::new(&dual, Default::default(), &Job::default()).unwrap_err();
    assert_eq!(error.status(), Status::InvalidArgument);
    let spent = Job::default();
    spent.cancel();
    assert_eq!(poles.feature_size(&rows, &spent).unwrap_err().status(), Status::Cancelled);
}

#[test]
fn a_tetrahedron_with_an_obtuse_center_may_have_no_second_pole() {
    // The center lies beyond the base, behind the hull as the flat apex sees it.
    let rows = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [1.0, 1.0, 0.25]];
    let poles = alone(&rows);
    assert_valid(&poles, "flat tetrahedron");
    assert!(poles.pole_of_sample().iter().all(|pair| pair[0] == NONE));
    let seconds: Vec<_> = poles.pole_of_sample().iter().map(|pair| pair[1]).collect();
    assert!(seconds.contains(&0), "{seconds:?}");
    let apex = poles.triangulation().coords().iter().position(|p| p[2] > 0.0).unwrap();
    assert_eq!(poles.pole_of_sample()[apex][1], 0);
}

#[test]
fn object_angles_are_the_largest_between_samples() {
    // The ball round the centre of a cube touches opposite faces.
    let range = || (-2..=2).map(f64::from);
    let grid = range().flat_map(|x| range().flat_map(move |y| range().map(move |z| [x, y, z])));
    let cube: Vec<[f64; 3]> = grid.filter(|p| p.iter().any(|x| x.abs() == 2.0)).collect();
    let poles = boxed(&cube);
    let centre = poles.balls().iter().position(|ball| ball[..3] == [0.0; 3]).unwrap();
    assert_eq!(poles.object_angles()[centre], std::f64::consts::PI);
    // The angle at the centre by its cosine, where that has digits enough.
    for Set { name, rows } in sets::all(300) {
        let poles = boxed(&rows);
        let mut compared = 0;
        for (pole, ball) in poles.balls().iter().enumerate() {
            let samples = poles.samples_on_balls().row(pole);
            let seen = |s: u32| {
                let at = poles.triangulation().coords()[s as usize];
                [0, 1, 2].map(|k| (at[k] - ball[k]) / ball[3])
            };
            let cosine = |a: u32, b: u32| -> f64 { (0..3).map(|k| seen(a)[k] * seen(b)[k]).sum() };
            let pairs = samples.iter().flat_map(|&a| samples.iter().map(move |&b| (a, b)));
            let least = pairs.map(|(a, b)| cosine(a, b)).fold(1.0, f64::min);
            let largest = ball.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            let angle = poles.object_angles()[pole];
            assert!((0.0..=std::f64::consts::PI).contains(&angle), "{name}: {angle}");
            assert!(samples.len() > 1 || angle == 0.0, "{name}: {angle}");
            if largest < 1e3 * ball[3] {
                assert!((angle.cos() - least).abs() < 1e-9, "{name}: {angle}, {least}");
                compared += 1;
            }
        }
        assert!(compared > 20 || name.contains("far") || name == "clustered", "{name}: {compared}");
        let complex = poles.to_complex().unwrap();
        let carried = complex.attribute(Element::Vertex, "object_angle").unwrap();
        assert_eq!(*carried.values(), Values::F64(poles.object_angles().to_vec()));
    }
}

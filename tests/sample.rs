//! The built-in shapes and the sampling of shapes and meshes, against closed formulas and brute
//! force.

use medax::complex::{ComplexParts, Element, Rows};
use medax::sample::{SampleOptions, Samples, Shape, sample, sample_mesh};
use medax::{Complex, Job, JobOptions, Stage, Status};
use std::collections::{HashMap, HashSet};
use std::f64::consts::{PI, TAU};
use std::sync::LazyLock;

type Vec3 = [f64; 3];

fn sub(a: Vec3, b: Vec3) -> Vec3 {
    std::array::from_fn(|i| a[i] - b[i])
}

fn dot(a: Vec3, b: Vec3) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

fn distance(a: Vec3, b: Vec3) -> f64 {
    dot(sub(a, b), sub(a, b)).sqrt()
}

/// The point `t` along `direction` from `a`.
fn along(a: Vec3, direction: Vec3, t: f64) -> Vec3 {
    std::array::from_fn(|i| a[i] + t * direction[i])
}

fn take(shape: Shape, options: SampleOptions) -> Samples {
    sample(shape, options, &Job::default()).unwrap()
}

/// The samples with default options, taken once for all tests.
fn default_samples(shape: Shape) -> &'static Samples {
    static SAMPLES: LazyLock<Vec<Samples>> = LazyLock::new(|| {
        Shape::ALL.map(|shape| take(shape, SampleOptions::default())).into_iter().collect()
    });
    &SAMPLES[shape as usize]
}

/// A grid of samples, to answer "how far is the nearest one" within a radius.
struct Nearby<'a> {
    points: &'a [Vec3],
    side: f64,
    cells: HashMap<[i64; 3], Vec<usize>>,
}

impl<'a> Nearby<'a> {
    fn new(points: &'a [Vec3], side: f64) -> Self {
        let mut cells: HashMap<_, Vec<_>> = HashMap::new();
        for (i, p) in points.iter().enumerate() {
            cells.entry(p.map(|x| (x / side).floor() as i64)).or_default().push(i);
        }
        Nearby { points, side, cells }
    }

    /// The distance to the nearest point other than `but`, if it is below the side.
    fn nearest(&self, p: Vec3, but: Option<usize>) -> f64 {
        let [x, y, z] = p.map(|x| (x / self.side).floor() as i64);
        let mut nearest = f64::INFINITY;
        for (dx, dy, dz) in (0..27).map(|i| (i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)) {
            for &i in self.cells.get(&[x + dx, y + dy, z + dz]).into_iter().flatten() {
                if Some(i) != but {
                    nearest = nearest.min(distance(p, self.points[i]));
                }
            }
        }
        nearest
    }
}

/// Evenly strewn points of a shape's bounds, made wider by `margin` on each side.
fn strewn(shape: Shape, margin: f64, count: usize) -> Vec<Vec3> {
    let bounds = shape.bounds();
    // The additive recurrence of the three-dimensional golden ratio.
    let steps = [0.819_172_513_396_164_4, 0.671_043_606_703_789_3, 0.549_700_477_901_970_3];
    let coordinate = |k: usize, i: usize| {
        let t = (0.5137 + k as f64 * steps[i]).fract();
        bounds.min[i] - margin + t * (bounds.extent()[i] + 2.0 * margin)
    };
    (0..count).map(|k| std::array::from_fn(|i| coordinate(k, i))).collect()
}

#[test]
fn samples_lie_on_the_surface_and_inside_the_bounds() {
    for shape in Shape::ALL {
        let samples = default_samples(shape);
        let bounds = shape.bounds();
        assert!(samples.points().len() > 100);
        for &p in samples.points() {
            assert!(shape.value(p).abs() < 1e-13, "{shape:?} {p:?} {}", shape.value(p));
            for i in 0..3 {
                let inside = bounds.min[i] - 1e-12 <= p[i] && p[i] <= bounds.max[i] + 1e-12;
                assert!(inside, "{shape:?} {p:?}");
            }
        }
    }
}

#[test]
fn bounds_are_tight() {
    for shape in Shape::ALL {
        let (bounds, samples) = (shape.bounds(), default_samples(shape));
        for i in 0..3 {
            let values = || samples.points().iter().map(|p| p[i]);
            let (min, max) = (values().fold(f64::MAX, f64::min), values().fold(f64::MIN, f64::max));
            let slack = [min - bounds.min[i], bounds.max[i] - max];
            assert!(slack.iter().all(|&x| x < 0.08), "{shape:?} {i} {slack:?}");
        }
    }
}

#[test]
fn the_value_never_exceeds_the_distance() {
    for shape in Shape::ALL {
        let points = strewn(shape, 0.5, 2000);
        let values: Vec<f64> = points.iter().map(|&p| shape.value(p)).collect();
        for i in 0..points.len() {
            for j in [(i + 1) % points.len(), (i + 7) % points.len(), (i * i) % points.len()] {
                let change = (values[i] - values[j]).abs();
                let step = distance(points[i], points[j]);
                assert!(change <= step * (1.0 + 1e-12) + 1e-14, "{shape:?} {change} {step}");
            }
        }
        // Where it is the distance, the point so far along the gradient is on the surface.
        if !matches!(shape, Shape::Ellipsoid | Shape::Genus3 | Shape::Bracket) {
            for (&p, &value) in points.iter().zip(&values) {
                let foot = along(p, shape.gradient(p), -value);
                assert!(shape.value(foot).abs() < 1e-9, "{shape:?} {p:?}");
            }
        }
    }
}

#[test]
fn gradients_are_those_of_the_value() {
    let h = 1e-6;
    for shape in Shape::ALL {
        let mut agree = 0;
        for p in strewn(shape, 0.3, 1000) {
            let difference: Vec3 = std::array::from_fn(|i| {
                let (mut low, mut high) = (p, p);
                low[i] -= h;
                high[i] += h;
                (shape.value(high) - shape.value(low)) / (2.0 * h)
            });
            agree += usize::from(distance(shape.gradient(p), difference) < 1e-6);
        }
        // The rest lie within h of a ridge.
        assert!(agree >= 998, "{shape:?} {agree}");
    }
}

#[test]
fn normals_are_outward_unit_normals() {
    for shape in Shape::ALL {
        let samples = default_samples(shape);
        assert_eq!(samples.normals().len(), samples.points().len());
        let h = 1e-5;
        for (&p, &n) in samples.points().iter().zip(samples.normals()) {
            assert!((dot(n, n) - 1.0).abs() < 1e-12);
            assert!(shape.value(along(p, n, h)) > 0.0 && shape.value(along(p, n, -h)) < 0.0);
            let closed = match shape {
                Shape::Sphere => p,
                Shape::Ellipsoid => {
                    let g: Vec3 = [p[0] / 1.96, p[1], p[2] / 0.49];
                    g.map(|x| x / dot(g, g).sqrt())
                }
                Shape::Torus => {
                    let q = (p[0] * p[0] + p[1] * p[1]).sqrt();
                    [p[0] / q * (q - 1.0) / 0.4, p[1] / q * (q - 1.0) / 0.4, p[2] / 0.4]
                }
                _ => continue,
            };
            assert!(distance(n, closed) < 1e-12, "{shape:?} {n:?} {closed:?}");
        }
    }
}

#[test]
fn no_two_samples_are_nearer_than_the_spacing() {
    for shape in Shape::ALL {
        let samples = default_samples(shape);
        assert_eq!(samples.spacing(), shape.spacing());
        let nearby = Nearby::new(samples.points(), 1.5 * samples.spacing());
        for (i, &p) in samples.points().iter().enumerate() {
            let nearest = nearby.nearest(p, Some(i));
            // The library compares rounded squares.
            assert!(nearest >= samples.spacing() * (1.0 - 1e-15), "{shape:?} {nearest}");
        }
    }
}

/// A grid of points by two parameters in (0, 1).
fn grid(side: usize, point: impl Fn(f64, f64) -> Vec3) -> Vec<Vec3> {
    let at = |i: usize| (i as f64 + 0.5) / side as f64;
    (0..side * side).map(|i| point(at(i % side), at(i / side))).collect()
}

#[test]
fn every_point_of_the_surface_has_a_sample_near() {
    for shape in Shape::ALL {
        let samples = default_samples(shape);
        let probes = match shape {
            // Probes that the library had no hand in.
            Shape::Torus => grid(200, |u, v| {
                let (a, b) = (TAU * u, TAU * v);
                let q = 1.0 + 0.4 * b.cos();
                [q * a.cos(), q * a.sin(), 0.4 * b.sin()]
            }),
            Shape::Ellipsoid | Shape::Sphere => grid(200, |u, v| {
                let (a, z) = (TAU * u, 2.0 * v - 1.0);
                let q = (1.0 - z * z).sqrt();
                let axes = if shape == Shape::Sphere { [1.0; 3] } else { [1.4, 1.0, 0.7] };
                [axes[0] * q * a.cos(), axes[1] * q * a.sin(), axes[2] * z]
            }),
            Shape::Box => grid(100, |u, v| [2.0 * u - 1.0, 1.5 * v - 0.75, 0.5]),
            _ => {
                let spacing = shape.spacing() / 1.5;
                let finer = SampleOptions { spacing, seed: 99, ..Default::default() };
                take(shape, finer).points().to_vec()
            }
        };
        let nearby = Nearby::new(samples.points(), 1.5 * samples.spacing());
        let gap = probes.iter().map(|&p| nearby.nearest(p, None)).fold(0.0, f64::max);
        assert!(gap < 1.3 * samples.spacing(), "{shape:?} {}", gap / samples.spacing());
    }
}

/// The mean of `f` over [0, 1] by the midpoint rule.
fn mean(f: impl Fn(f64) -> f64) -> f64 {
    let n = 2000;
    (0..n).map(|i| f((f64::from(i) + 0.5) / f64::from(n))).sum::<f64>() / f64::from(n)
}

#[test]
fn areas_and_counts_are_those_of_the_formulas() {
    // The sphere's area element, stretched: |(b c x, a c y, a b z)|.
    let [a, b, c] = [1.4, 1.0, 0.7];
    let stretch = |u: f64, v: f64| {
        let z = 2.0 * v - 1.0;
        let q = (1.0 - z * z).sqrt();
        let (x, y) = (q * (TAU * u).cos(), q * (TAU * u).sin());
        ((b * c * x).powi(2) + (a * c * y).powi(2) + (a * b * z).powi(2)).sqrt()
    };
    let ellipsoid = 4.0 * PI * mean(|v| mean(|u| stretch(u, v)));
    let knot = TAU
        * mean(|u| {
            let t = TAU * u;
            let (x, y) = (t.cos() + 4.0 * (2.0 * t).cos(), 4.0 * (2.0 * t).sin() - t.sin());
            (x * x + y * y + (3.0 * (3.0 * t).cos()).powi(2)).sqrt()
        });
    let outline = 4.0 * 0.5 + 0.5 * 2.5;
    let girth = 4.0 + 0.5 + 3.5 + 2.5 + 0.5 + 3.0;
    let holes = [0.4, 0.4, 0.6].map(|r: f64| TAU * r * 0.5 - TAU * r * r);
    let known = [
        (Shape::Sphere, 4.0 * PI),
        (Shape::Torus, 4.0 * PI * PI * 0.4),
        (Shape::Box, 13.0),
        (Shape::Capsule, TAU * 0.5 * 2.0 + 4.0 * PI * 0.25),
        (Shape::Ellipsoid, ellipsoid),
        (Shape::Trefoil, TAU * 0.3 * knot),
        (Shape::Bracket, 2.0 * outline + 2.4 * girth + holes.iter().sum::<f64>()),
    ];
    for (shape, area) in known {
        let samples = take(shape, SampleOptions { spacing: 0.1, ..Default::default() });
        assert!((samples.area() / area - 1.0).abs() < 0.01, "{shape:?} {} {area}", samples.area());
        let dense = take(shape, SampleOptions { spacing: 0.05, ..Default::default() });
        let growth = dense.points().len() as f64 / samples.points().len() as f64;
        assert!((growth - 4.0).abs() < 0.12, "{shape:?} {growth}");
        let asked = take(shape, SampleOptions { density: 150.0, ..Default::default() });
        let density = asked.points().len() as f64 / area;
        assert!((density / 150.0 - 1.0).abs() < 0.04, "{shape:?} {density}");
    }
}

/// Components and Euler characteristic of the solid, from the closed cubes of a grid whose
/// centres are inside.
fn voxel_topology(shape: Shape, side: f64) -> (usize, i64) {
    let bounds = shape.bounds();
    let size = bounds.extent().map(|x| (x / side).ceil() as usize + 2);
    // Every cell of the cubical complex by its doubled coordinates.
    let mut cells = HashSet::new();
    for i in 0..size[0] * size[1] * size[2] {
        let cube = [i % size[0], i / size[0] % size[1], i / size[0] / size[1]];
        let center = std::array::from_fn(|i| bounds.min[i] + (cube[i] as f64 - 0.487) * side);
        if shape.value(center) < 0.0 {
            for d in 0..27 {
                cells.insert([2 * cube[0] + d % 3, 2 * cube[1] + d / 3 % 3, 2 * cube[2] + d / 9]);
            }
        }
    }
    let dimension = |cell: &[usize; 3]| cell.iter().map(|x| x % 2).sum::<usize>();
    let euler = cells.iter().map(|cell| if dimension(cell) % 2 == 0 { 1 } else { -1 }).sum();
    let mut components = 0;
    while let Some(first) = cells.iter().next().copied() {
        components += 1;
        cells.remove(&first);
        let mut stack = vec![first];
        while let Some(cell) = stack.pop() {
            for (i, step) in (0..6).map(|k| (k / 2, [-1isize, 1][k % 2])) {
                let mut next = cell;
                next[i] = next[i].wrapping_add_signed(step);
                if cells.remove(&next) {
                    stack.push(next);
                }
            }
        }
    }
    (components, euler)
}

#[test]
fn genus_and_components_are_those_of_the_voxels() {
    for shape in Shape::ALL {
        let (components, euler) = voxel_topology(shape, 0.07);
        assert_eq!(components, shape.components() as usize, "{shape:?}");
        assert_eq!(euler, i64::from(shape.components()) - i64::from(shape.genus()), "{shape:?}");
    }
}

#[test]
fn only_sharp_shapes_have_normals_that_jump() {
    for shape in Shape::ALL {
        let samples = default_samples(shape);
        let (points, normals) = (samples.points(), samples.normals());
        let jumps = (0..points.len()).any(|i| {
            (0..points.len()).any(|j| {
                let near = distance(points[i], points[j]) < 1.3 * samples.spacing();
                near && dot(normals[i], normals[j]) < 0.5
            })
        });
        assert_eq!(jumps, !shape.is_smooth(), "{shape:?}");
    }
}

#[test]
fn noise_has_the_asked_deviation_along_the_normal() {
    for shape in Shape::ALL {
        let clean = default_samples(shape);
        let noisy = take(shape, SampleOptions { noise: 0.01, ..Default::default() });
        assert_eq!(clean.normals(), noisy.normals());
        let mut shifts = Vec::new();
        for i in 0..clean.points().len() {
            let (p, q, n) = (clean.points()[i], noisy.points()[i], clean.normals()[i]);
            let shift = dot(sub(q, p), n);
            assert!(distance(q, along(p, n, shift)) < 1e-14);
            shifts.push(shift / 0.01);
        }
        let count = shifts.len() as f64;
        let mean = shifts.iter().sum::<f64>() / count;
        let square = shifts.iter().map(|x| x * x).sum::<f64>() / count;
        let beyond_two = shifts.iter().filter(|x| x.abs() > 2.0).count() as f64 / count;
        assert!(mean.abs() < 5.0 / count.sqrt(), "{shape:?} {mean}");
        assert!((square - 1.0).abs() < 5.0 * (2.0 / count).sqrt(), "{shape:?} {square}");
        assert!((beyond_two - 0.0455).abs() < 5.0 * (0.0455 / count).sqrt(), "{beyond_two}");
    }
}

#[test]
fn the_seed_decides_everything() {
    for shape in Shape::ALL {
        let options = SampleOptions { noise: 0.01, seed: 5, ..Default::default() };
        let once = take(shape, options);
        assert_eq!(once, take(shape, options));
        let other = take(shape, SampleOptions { seed: 6, ..options });
        assert!(once.points().iter().all(|p| !other.points().contains(p)), "{shape:?}");
    }
}

/// The bits are the same on every machine: these were taken once.
#[test]
fn the_points_are_the_same_everywhere() {
    let hash = |shape| {
        let samples = take(shape, SampleOptions { noise: 0.01, seed: 1, ..Default::default() });
        let bits = samples.points().as_flattened().iter().map(|x| x.to_bits());
        bits.fold(0xcbf2_9ce4_8422_2325u64, |hash, bits| {
            (hash ^ bits).wrapping_mul(0x0100_0000_01b3)
        })
    };
    let known = [
        6377452440242264468,
        1568885089789293576,
        14944531727583980267,
        1090312598922156961,
        14799386143729212246,
        176400823911127764,
        12818437688773497482,
        6747257745570634053,
    ];
    assert_eq!(Shape::ALL.map(hash), known);
}

/// Centres of the largest inner balls that touch the surface at the samples.
fn ball_centers(shape: Shape) -> Vec<Vec3> {
    let samples = default_samples(shape);
    let center = |(&p, &n): (&Vec3, &Vec3)| {
        if shape == Shape::Ellipsoid {
            // By symmetry the ball touches at the mirror image too.
            return along(p, n, -p[2].abs() / n[2].abs());
        }
        // Bisection on the signed distance.
        let (mut low, mut high) = (0.0, 5.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let empty = shape.value(along(p, n, -middle)) <= -middle + 1e-12;
            if empty { low = middle } else { high = middle }
        }
        along(p, n, -low)
    };
    samples.points().iter().zip(samples.normals()).map(center).collect()
}

#[test]
fn known_axes_are_the_centres_of_maximal_balls() {
    for shape in Shape::ALL {
        if shape.inner_axis_distance([0.0; 3]).is_none() {
            assert!(matches!(shape, Shape::Genus3 | Shape::Bracket));
            continue;
        }
        let from_axis = |p| shape.inner_axis_distance(p).unwrap();
        let centers = ball_centers(shape);
        for &center in &centers {
            assert!(from_axis(center) < 2e-5, "{shape:?} {center:?} {}", from_axis(center));
        }
        // And the axis has nothing that those centres lack, up to the gaps between them.
        for p in strewn(shape, 0.3, 2000) {
            let by_formula = from_axis(p);
            let by_centers = centers.iter().map(|&c| distance(p, c)).fold(f64::MAX, f64::min);
            assert!(by_formula < by_centers + 2e-5, "{shape:?} {p:?} {by_formula} {by_centers}");
            let gap = by_centers - by_formula;
            assert!(gap < 1.5 * shape.spacing(), "{shape:?} {p:?} {gap}");
        }
    }
}

/// A triangle, a triangle and a rectangle in three planes, of areas 0.5, 2 and 6.
fn small_mesh() -> Complex {
    let mut faces = Rows::default();
    for face in [&[0u32, 1, 2][..], &[3, 4, 5], &[6, 7, 8, 9]] {
        faces.push(face).unwrap();
    }
    let vertices = vec![
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [5.0, 0.0, 0.0],
        [5.0, 2.0, 0.0],
        [5.0, 0.0, 2.0],
        [0.0, 5.0, 0.0],
        [0.0, 5.0, 2.0],
        [3.0, 5.0, 2.0],
        [3.0, 5.0, 0.0],
    ];
    Complex::new(ComplexParts { vertices, faces, ..Default::default() }).unwrap()
}

#[test]
fn meshes_are_sampled_by_area() {
    let mesh = small_mesh();
    let options = SampleOptions { spacing: 0.02, ..Default::default() };
    let samples = sample_mesh(&mesh, options, &Job::default()).unwrap();
    assert!((samples.area() - 8.5).abs() < 1e-3);
    let mut counts = [0.0; 3];
    for (p, n) in samples.points().iter().zip(samples.normals()) {
        let normals = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let face = normals.iter().position(|normal| normal == n).unwrap();
        assert_eq!([p[2], p[0] - 5.0, p[1] - 5.0][face], 0.0);
        counts[face] += 1.0;
    }
    for (count, area) in counts.iter().zip([0.5, 2.0, 6.0]) {
        let share: f64 = count * 0.02 * 0.02 / area;
        assert!((share - 0.66).abs() < 0.03, "{area} {share}");
    }
    let nearby = Nearby::new(samples.points(), 0.03);
    for (i, &p) in samples.points().iter().enumerate() {
        assert!(nearby.nearest(p, Some(i)) >= 0.02 * (1.0 - 1e-15));
    }
    let default = sample_mesh(&mesh, SampleOptions::default(), &Job::default()).unwrap();
    assert!((default.spacing() - 54f64.sqrt() / 100.0).abs() < 1e-12);
}

#[test]
fn samples_become_vertices_with_normals() {
    let samples = default_samples(Shape::Sphere);
    let complex = samples.to_complex().unwrap();
    assert_eq!(complex.vertices(), samples.points());
    let normal = complex.attribute(Element::Vertex, "normal").unwrap();
    assert_eq!((normal.width(), normal.rows()), (3, samples.points().len()));
}

#[test]
fn a_spacing_beyond_the_shape_still_gives_a_sample() {
    let samples = take(Shape::Torus, SampleOptions { spacing: 1e6, ..Default::default() });
    assert_eq!(samples.points().len(), 1);
}

#[test]
fn bad_options_are_refused() {
    let refusal = |options| sample(Shape::Box, options, &Job::default()).unwrap_err();
    let bad = [
        SampleOptions { spacing: -1.0, ..Default::default() },
        SampleOptions { spacing: f64::NAN, ..Default::default() },
        SampleOptions { density: f64::INFINITY, ..Default::default() },
        SampleOptions { noise: -0.1, ..Default::default() },
        SampleOptions { noise: f64::NAN, ..Default::default() },
        SampleOptions { spacing: 0.1, density: 10.0, ..Default::default() },
    ];
    for options in bad {
        assert_eq!(refusal(options).status(), Status::InvalidArgument, "{options:?}");
    }
    for spacing in [1e-6, 1e-200, f64::MIN_POSITIVE] {
        let error = refusal(SampleOptions { spacing, ..Default::default() });
        assert_eq!(error.status(), Status::LimitExceeded);
    }
    let flat = vec![[0.0; 3], [1.0; 3], [2.0; 3]];
    let mut parts = ComplexParts { vertices: flat, ..Default::default() };
    parts.faces.push(&[0, 1, 2]).unwrap();
    let mesh = Complex::new(parts).unwrap();
    let error = sample_mesh(&mesh, SampleOptions::default(), &Job::default()).unwrap_err();
    assert_eq!(error.status(), Status::Degenerate);
}

#[test]
fn noise_that_drowns_the_shape_is_refused() {
    let noisy = |noise| SampleOptions { noise, ..Default::default() };
    let diagonal = 7.25f64.sqrt();
    let mut faces = Rows::default();
    faces.push(&[0, 1, 2]).unwrap();
    let vertices = vec![[0.0; 3], [1e60, 0.0, 0.0], [0.0, 1e60, 0.0]];
    let mesh = Complex::new(ComplexParts { vertices, faces, ..Default::default() }).unwrap();
    let job = Job::default();
    let of_shape = |noise| sample(Shape::Box, noisy(noise), &job);
    let of_mesh = |noise| sample_mesh(&mesh, noisy(noise), &job);
    for refused in [1.001e6 * diagonal, 1e100, f64::MAX] {
        for taken in [of_shape(refused), of_mesh(refused * 1e60)] {
            let error = taken.map(|_| "samples").unwrap_err();
            assert_eq!(error.status(), Status::InvalidArgument, "{error}");
            assert!(error.message().starts_with("the noise must "), "{error}");
        }
    }
    for samples in [of_shape(0.999e6 * diagonal).unwrap(), of_mesh(1.4e66).unwrap()] {
        assert!(samples.points().as_flattened().iter().all(|x| x.is_finite()));
    }
    // A diagonal that overflows bounds nothing, though the area is sound: the long triangle has none.
    let vertices = [mesh.vertices(), &[[1e300, 0.0, 0.0], [2e300, 0.0, 0.0]]].concat();
    let mut faces = mesh.faces().clone();
    faces.push(&[0, 3, 4]).unwrap();
    let mesh = Complex::new(ComplexParts { vertices, faces, ..Default::default() }).unwrap();
    let error = sample_mesh(&mesh, noisy(1e305), &job).map(|_| "samples").unwrap_err();
    assert_eq!(error.status(), Status::CoordinateRange);
}

#[test]
fn a_job_can_stop_it_and_cap_it() {
    let job = Job::new(JobOptions {
        progress: Some(Box::new(|progress, stage| {
            assert!(stage == Stage::Sample && (0.0..=1.0).contains(&progress));
            progress < 0.001
        })),
        ..Default::default()
    });
    let options = SampleOptions { spacing: 0.004, ..Default::default() };
    let error = sample(Shape::Genus3, options, &job).unwrap_err();
    assert_eq!(error.status(), Status::Cancelled);
    assert!(job.is_cancelled() && job.progress() < 0.5);
    let capped = Job::new(JobOptions { memory_ceiling: 100_000, ..Default::default() });
    let error =
        sample(Shape::Torus, SampleOptions { spacing: 0.01, ..Default::default() }, &capped);
    assert_eq!(error.unwrap_err().status(), Status::OutOfMemory);
    sample(Shape::Sphere, SampleOptions::default(), &capped).unwrap();
}

#[test]
fn names_and_numbers_lead_back() {
    for (number, shape) in Shape::ALL.into_iter().enumerate() {
        assert_eq!(shape as usize, number);
        assert_eq!(Shape::from_name(shape.name()), Some(shape));
    }
    assert_eq!(Shape::from_name("cube"), None);
}

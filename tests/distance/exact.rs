//! Axes that are known in closed form: every point that is returned is one of them, by brute force over the pieces, and few of them or none are missed.

use crate::shapes::{
    Point, Random, closed, comb, cuboid, distance, dot, l_shape, open, polygon, prism, rectangle,
    rings, sub, turned,
};
use medax::Job;
use medax::distance::{FieldAxis, FieldOptions, Piece, Sites};
use medax::medial::Side;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::Arc;

/// A point of an exact axis: where, its distance from the boundary, and its object angle.
type Exact = (Point, f64, f64);

/// The nearest point of a piece: of a hull the nearest of those of its sides, or the foot of the height if it lies within.
pub fn nearest_of(p: Point, piece: &Piece) -> Point {
    let along = |a: Point, way: Point, low: f64, high: f64| {
        let t = (dot(sub(p, a), way) / dot(way, way)).clamp(low, high);
        [0, 1, 2].map(|k| a[k] + t * way[k])
    };
    match *piece {
        Piece::Point(q) => q,
        Piece::Segment([a, b]) => along(a, sub(b, a), 0.0, 1.0),
        Piece::Ray(a, way) => along(a, way, 0.0, f64::INFINITY),
        Piece::Line(a, way) => along(a, way, f64::NEG_INFINITY, f64::INFINITY),
        Piece::Sphere(center, radius) => {
            let way = sub(p, center);
            let size = dot(way, way).sqrt();
            let way = if size > 0.0 { way.map(|x| x / size) } else { [1.0, 0.0, 0.0] };
            [0, 1, 2].map(|k| center[k] + radius * way[k])
        }
        Piece::Triangle([a, b, c]) => {
            let cross = |u: Point, v: Point| {
                [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
            };
            let normal = cross(sub(b, a), sub(c, a));
            let height = dot(sub(p, a), normal) / dot(normal, normal);
            let foot = [0, 1, 2].map(|k| p[k] - height * normal[k]);
            let sides = [[a, b], [b, c], [c, a]];
            let within =
                sides.iter().all(|[u, v]| dot(cross(sub(*v, *u), sub(foot, *u)), normal) >= 0.0);
            let rim = sides.map(|[u, v]| along(u, sub(v, u), 0.0, 1.0));
            let away = |q: &Point| distance(*q, p);
            match within {
                true => foot,
                false => rim.into_iter().min_by(|q, r| away(q).total_cmp(&away(r))).unwrap(),
            }
        }
    }
}

/// Holds every point against all pieces: a point of the axis within epsilon has two nearest points that are no farther from here than two epsilons more than the nearest, and are seen from here
/// under nearly the angle that they are seen under from there.
pub fn check_sound(name: &str, sites: &Sites, points: &[Point], angle: f64, epsilon: f64) {
    assert!(points.len() > 20, "{name}");
    for &p in points {
        let mut feet: Vec<Point> =
            sites.pieces().iter().map(|piece| nearest_of(p, piece)).collect();
        // All of a sphere is as near to its centre: its farthest point then, too.
        feet.extend(sites.pieces().iter().zip(feet.clone()).filter_map(
            |(piece, foot)| match piece {
                Piece::Sphere(center, _) => Some([0, 1, 2].map(|k| 2.0 * center[k] - foot[k])),
                _ => None,
            },
        ));
        let least = feet.iter().map(|&q| distance(p, q)).fold(f64::INFINITY, f64::min);
        let near = feet.iter().filter(|q| distance(p, **q) <= least + 2.0 * epsilon);
        let ways: Vec<Point> = near.map(|&q| sub(q, p)).collect();
        let angle_of = |a: Point, b: Point| {
            (dot(a, b) / (dot(a, a) * dot(b, b)).sqrt()).clamp(-1.0, 1.0).acos()
        };
        let seen = ways.iter().flat_map(|&a| ways.iter().map(move |&b| angle_of(a, b)));
        let widest = seen.fold(0.0, f64::max);
        // Moving by epsilon turns either way by no more than this; acos has half of the digits near pi.
        let turns = 2.0 * epsilon / least + 1e-7;
        assert!(widest >= angle - turns, "{name}: {p:?} {widest}");
    }
}

/// The share of the exact points that have one of some points within a distance.
fn recall(points: &[Point], exact: &[Exact], within: f64) -> f64 {
    let mut points = points.to_vec();
    points.sort_by(|p, q| p.partial_cmp(q).unwrap());
    let has_near = |&&(at, ..): &&Exact| {
        let begin = points.partition_point(|p| p[0] < at[0] - within);
        let near = points[begin..].iter().take_while(|p| p[0] <= at[0] + within);
        near.into_iter().any(|p| distance(*p, at) <= within)
    };
    exact.iter().filter(has_near).count() as f64 / exact.len() as f64
}

/// Evenly spread numbers between two others.
fn steps(low: f64, high: f64) -> impl Iterator<Item = f64> + Clone {
    (0..=200).map(move |i| low + (high - low) * f64::from(i) / 200.0)
}

/// Part of an axis: the centre, the distance and the angle along it.
fn arc(low: f64, high: f64, at: impl Fn(f64) -> Exact) -> Vec<Exact> {
    steps(low, high).map(at).collect()
}

/// From a convex right corner inward, along a diagonal.
fn diagonal(corner: [f64; 2], way: [f64; 2], end: f64) -> Vec<Exact> {
    arc(0.0, end, |t| ([corner[0] + t * way[0], corner[1] + t * way[1], 0.0], t, FRAC_PI_2))
}

fn exact_rectangle() -> Vec<Exact> {
    let mut exact = arc(1.0, 3.0, |x| ([x, 1.0, 0.0], 1.0, PI));
    for (corner, way) in [
        ([0.0, 0.0], [1.0, 1.0]),
        ([4.0, 0.0], [-1.0, 1.0]),
        ([0.0, 2.0], [1.0, -1.0]),
        ([4.0, 2.0], [-1.0, -1.0]),
    ] {
        exact.extend(diagonal(corner, way, 1.0));
    }
    exact
}

/// As far from the corner at the origin, which juts out, as from a side below at a depth: a parabola over the side.
fn parabola(depth: f64, x: f64) -> (f64, f64, f64) {
    let y = (x * x - depth * depth) / (2.0 * depth);
    let angle = (-y / x.hypot(y)).acos();
    (y, y + depth, angle)
}

fn exact_l() -> Vec<Exact> {
    let mut exact = arc(1.0, 2.5, |x| ([x, 0.5, 0.0], 0.5, PI));
    exact.extend(arc(1.0, 1.5, |y| ([0.5, y, 0.0], 0.5, PI)));
    for (corner, way) in [
        ([3.0, 0.0], [-1.0, 1.0]),
        ([3.0, 1.0], [-1.0, -1.0]),
        ([0.0, 2.0], [1.0, -1.0]),
        ([1.0, 2.0], [-1.0, -1.0]),
    ] {
        exact.extend(diagonal(corner, way, 0.5));
    }
    // Up to where the corner that juts out is as near.
    let end = 2f64.sqrt() / (1.0 + 2f64.sqrt());
    exact.extend(diagonal([0.0, 0.0], [1.0, 1.0], end));
    let below = arc(end - 1.0, 0.0, |x| {
        let (y, radius, angle) = parabola(1.0, x);
        ([1.0 + x, 1.0 + y, 0.0], radius, angle)
    });
    exact.extend(below.iter().map(|&([x, y, _], radius, angle)| ([y, x, 0.0], radius, angle)));
    exact.extend(below);
    exact
}

/// Of a comb of which the teeth and the bar are as wide as the slots: 1.
fn exact_comb(slots: usize) -> Vec<Exact> {
    let mut exact = Vec::new();
    for slot in 0..slots {
        let left = 2.0 * slot as f64 + 1.0;
        exact.extend(arc(left, left + 1.0, |x| ([x, 0.5, 0.0], 0.5, PI)));
    }
    for tooth in 0..=slots {
        let left = 2.0 * tooth as f64;
        exact.extend(arc(1.0, 3.5, |y| ([left + 0.5, y, 0.0], 0.5, PI)));
        exact.extend(diagonal([left, 4.0], [1.0, -1.0], 0.5));
        exact.extend(diagonal([left + 1.0, 4.0], [-1.0, -1.0], 0.5));
        if tooth == 0 || tooth == slots {
            continue;
        }
        // Below a tooth between two slots: from its foot down to where the bar's side is as near, and to both sides.
        exact.extend(arc(0.625, 1.0, |y| {
            let radius = 0.5f64.hypot(1.0 - y);
            ([left + 0.5, y, 0.0], radius, 2.0 * (0.5 / radius).asin())
        }));
        for sign in [-1.0, 1.0] {
            let corner = if sign < 0.0 { left + 1.0 } else { left };
            exact.extend(arc(0.0, 0.5, |x| {
                let (y, radius, angle) = parabola(1.0, x);
                ([corner + sign * x, 1.0 + y, 0.0], radius, angle)
            }));
        }
    }
    exact
}

/// Of an ellipse: a part of its long axis.
fn exact_ellipse(a: f64, b: f64) -> Vec<Exact> {
    let square = a * a - b * b;
    arc(-square / a, square / a, |x| {
        let foot = [x * a * a / square, b * (1.0 - (x * a / square).powi(2)).max(0.0).sqrt()];
        let radius = (foot[0] - x).hypot(foot[1]);
        ([x, 0.0, 0.0], radius, 2.0 * foot[1].atan2((foot[0] - x).abs()))
    })
}

#[test]
fn exact_axes_in_the_plane_are_found_beyond_the_bound() {
    let origin = [0.0; 3];
    let ellipse = polygon(2000, 1.0).iter().map(|p| [2.0 * p[0], p[1]]).collect();
    let cases: Vec<(&str, Arc<Sites>, Vec<Exact>)> = vec![
        ("rectangle", closed(rings(&[rectangle(4.0, 2.0)])), exact_rectangle()),
        ("l", closed(rings(&[l_shape()])), exact_l()),
        ("comb", closed(rings(&[comb(3)])), exact_comb(3)),
        ("ellipse", closed(rings(&[ellipse])), exact_ellipse(2.0, 1.0)),
        (
            "ring",
            closed(vec![Piece::Sphere(origin, 1.0), Piece::Sphere(origin, 2.0)]),
            arc(0.0, TAU, |t| ([1.5 * t.cos(), 1.5 * t.sin(), 0.0], 0.5, PI)),
        ),
    ];
    for (name, sites, exact) in cases {
        // The exact axis is one, by brute force.
        let at: Vec<Point> =
            exact.iter().filter(|e| e.1 > 0.01 && e.2 > 0.4).map(|e| e.0).collect();
        let slack = if name == "ellipse" { 1e-5 } else { 1e-12 };
        check_sound(name, &sites, &at, 0.3, slack);
        for (bound, share) in [(PI / 9.0, 0.03), (PI / 4.0, 0.05)] {
            let density = share * sites.size();
            let options = FieldOptions { density, bound, angle: 0.2, ..FieldOptions::default() };
            let axis = FieldAxis::new(&sites, options, &Job::default()).unwrap();
            assert!(axis.validate(&Job::default()).unwrap().is_valid(), "{name}");
            let points: Vec<Point> = axis.points().iter().map(|p| p.center).collect();
            check_sound(name, &sites, &points, 0.2, axis.options().decide.epsilon);
            let least = axis.options().min_distance;
            let beyond = |e: &&Exact| e.1 > 1.001 * least && e.2 > 1.001 * bound;
            let beyond: Vec<Exact> = exact.iter().filter(beyond).copied().collect();
            assert!(beyond.len() > 100, "{name}");
            assert_eq!(recall(&points, &beyond, density), 1.0, "{name} {bound}");
        }
    }
}

/// Points spread over the sheets between the planes of a box.
fn exact_box(size: Point, random: &mut Random) -> Vec<Exact> {
    // How far from each plane, as a sign, an axis and an offset.
    let planes: Vec<(usize, f64, f64)> =
        (0..3).flat_map(|k| [(k, 1.0, 0.0), (k, -1.0, size[k])]).collect();
    let away = |p: Point, &(k, sign, offset): &(usize, f64, f64)| sign * p[k] + offset;
    let mut exact = Vec::new();
    while exact.len() < 4000 {
        let mut p = [0, 1, 2].map(|k| random.within(0.0, size[k]));
        let [i, j] = [0; 2].map(|_| (random.unit() * 6.0) as usize);
        if i == j {
            continue;
        }
        // Moves the point along the axis of the second plane to where both are as far.
        let (k, sign, offset) = planes[j];
        p[k] = if planes[i].0 == k { 0.5 * size[k] } else { sign * (away(p, &planes[i]) - offset) };
        let radius = away(p, &planes[i]);
        if planes.iter().all(|plane| away(p, plane) >= radius - 1e-12) {
            let angle = if planes[i].0 == k { PI } else { FRAC_PI_2 };
            exact.push((p, radius, angle));
        }
    }
    exact
}

/// One exact axis in space, or a part of one.
struct Case {
    name: &'static str,
    sites: Arc<Sites>,
    options: FieldOptions,
    exact: Vec<Exact>,
    /// The least recall of points within the density, and of the vertices of the surface within a cube's diagonal.
    recall: [f64; 2],
}

fn in_space() -> Vec<Case> {
    let mut random = Random(23);
    let inner = FieldOptions { angle: 0.3, min_distance: 0.05, ..FieldOptions::default() };
    let clip = Some([[-2.0; 3], [2.0; 3]]);
    let outer = FieldOptions { side: Side::Outer, density: 0.15, clip, ..inner };
    let tube: Vec<[f64; 2]> = polygon(24, 0.7).iter().map(|p| [2.0 + p[0], p[1]]).collect();
    let turn = |t: f64, r: f64| [r * t.cos(), r * t.sin()];
    // Between the caps and the side of a cylinder: cones.
    let cones: Vec<Exact> = (0..2000)
        .map(|i| {
            let (radius, [x, y]) = (random.unit(), turn(random.within(0.0, TAU), 1.0));
            let z = if i % 2 == 0 { radius } else { 4.0 - radius };
            ([(1.0 - radius) * x, (1.0 - radius) * y, z], radius, FRAC_PI_2)
        })
        .collect();
    let cylinder = || prism(&polygon(48, 1.0), 4.0);
    let circle = arc(0.0, TAU, |t| ([2.0 * t.cos(), 2.0 * t.sin(), 0.0], 0.7, PI));
    let middle = arc(1.0, 3.0, |z| ([0.0, 0.0, z], 1.0, PI));
    let (small, large) = ([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    let spheres = [Piece::Sphere(small, 0.4), Piece::Sphere(large, 0.8)];
    vec![
        Case {
            name: "box",
            sites: cuboid([4.0, 3.0, 2.0]),
            options: FieldOptions { density: 0.15, ..inner },
            exact: exact_box([4.0, 3.0, 2.0], &mut random),
            recall: [0.99, 1.0],
        },
        Case {
            name: "cylinder's cones",
            sites: cylinder(),
            options: FieldOptions { density: 0.12, ..inner },
            exact: cones,
            recall: [0.99, 1.0],
        },
        Case {
            name: "cylinder's middle",
            sites: cylinder(),
            options: FieldOptions { density: 0.12, ..inner },
            exact: middle,
            recall: [0.0, 1.0],
        },
        Case {
            name: "torus",
            sites: turned(&tube, 48),
            options: FieldOptions { density: 0.13, ..inner },
            exact: circle,
            recall: [0.95, 1.0],
        },
        Case {
            name: "two spheres",
            sites: open(3, spheres.to_vec()),
            options: outer,
            exact: between_spheres(&mut random),
            recall: [0.99, 1.0],
        },
        Case {
            name: "three lines",
            sites: open(3, three_lines()),
            options: outer,
            exact: between_lines(&mut random),
            recall: [0.99, 1.0],
        },
    ]
}

/// As far from the smaller sphere's surface as from the larger's: a sheet of a hyperboloid.
fn between_spheres(random: &mut Random) -> Vec<Exact> {
    let mut exact = Vec::new();
    while exact.len() < 2000 {
        // The distances from the centres differ by 0.4: half of that and 1 are the half axes.
        let rho = random.within(0.0, 2.8);
        let (a, b) = (0.2, 0.96f64.sqrt());
        let x = -a * 1f64.hypot(rho / b);
        let t = random.within(0.0, TAU);
        let p = [x, rho * t.cos(), rho * t.sin()];
        let ways = [-1.0, 1.0].map(|c| sub([c, 0.0, 0.0], p));
        let radius = dot(ways[0], ways[0]).sqrt() - 0.4;
        let angle = dot(ways[0], ways[1]) / (dot(ways[0], ways[0]) * dot(ways[1], ways[1])).sqrt();
        if p.iter().all(|x| x.abs() < 2.0) && angle.acos() > 0.35 {
            exact.push((p, radius, angle.acos()));
        }
    }
    exact
}

/// Each along another axis, none in a plane with another.
pub fn three_lines() -> Vec<Piece> {
    vec![
        Piece::Line([0.0, 0.0, -1.0], [1.0, 0.0, 0.0]),
        Piece::Line([-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
        Piece::Line([0.0, -1.0, 0.0], [0.0, 0.0, 1.0]),
    ]
}

/// The squared distances from the three lines.
pub fn to_lines([x, y, z]: Point) -> Point {
    [y * y + (z + 1.0).powi(2), (x + 1.0).powi(2) + z * z, x * x + (y + 1.0).powi(2)]
}

/// The hyperbolic paraboloid between two lines, where the third is farther: 2 z = x^2 + 2 x - y^2, and so on round the axes.
fn between_lines(random: &mut Random) -> Vec<Exact> {
    let mut exact = Vec::new();
    while exact.len() < 4000 {
        let ([a, b], first) =
            ([0; 2].map(|_| random.within(-2.0, 2.0)), (random.unit() * 3.0) as usize);
        let c = 0.5 * (a * a + 2.0 * a - b * b);
        // The lines follow each other as the axes do, the other way round.
        let p: Point = match first {
            0 => [a, b, c],
            1 => [b, c, a],
            _ => [c, a, b],
        };
        let away = to_lines(p);
        let pair = match first {
            0 => [0, 1],
            1 => [2, 0],
            _ => [1, 2],
        };
        assert!((away[pair[0]] - away[pair[1]]).abs() < 1e-12);
        let radius = away[pair[0]].sqrt();
        if c.abs() > 2.0 || away.iter().any(|d| d.sqrt() < radius - 1e-12) || radius < 0.06 {
            continue;
        }
        let lines = three_lines();
        let ways = pair.map(|line| sub(nearest_of(p, &lines[line]), p));
        let angle = (dot(ways[0], ways[1]) / away[pair[0]]).clamp(-1.0, 1.0).acos();
        if angle > 0.35 {
            exact.push((p, radius, angle));
        }
    }
    exact
}

/// Recall is measured here, and nothing bounds it: what is held is that it does not get worse.
#[test]
fn exact_axes_in_space_are_found_nearly_whole() {
    for Case { name, sites, options, exact, recall: least } in in_space() {
        let job = Job::default();
        let axis = FieldAxis::new(&sites, options, &job).unwrap();
        let report = axis.validate(&job).unwrap();
        assert!(report.is_valid(), "{name} {report:?}");
        let points: Vec<Point> = axis.points().iter().map(|p| p.center).collect();
        let surface = axis.surface(&job).unwrap();
        let epsilon = axis.options().decide.epsilon;
        check_sound(name, &sites, surface.vertices(), options.angle, epsilon);
        let density = options.density;
        let beyond = exact.iter().filter(|e| e.1 > 1.1 * options.min_distance);
        let beyond: Vec<Exact> = beyond.copied().collect();
        let of = |points: &[Point], within: f64| recall(points, &beyond, within * density);
        let diagonal = 3f64.sqrt();
        let [near, wide] = [1.0, diagonal].map(|within| of(&points, within));
        let [surface_near, surface_wide] =
            [1.0, diagonal].map(|within| of(surface.vertices(), within));
        println!(
            "{name}: {} points, recall {near:.4} within the density, {wide:.4} within a cube's diagonal; surface {surface_near:.4} {surface_wide:.4}",
            points.len()
        );
        assert!(near >= least[0] && surface_wide >= least[1], "{name}");
    }
}

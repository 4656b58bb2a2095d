//! How the inner medial axis of MEDIAL nears the exact one where samples grow dense, and how little it asks for even density: `make convergence`.
//!
//! Prints a table, fields parted by tabs, which `benches/convergence.py` makes the page and the plot of. With a folder of models as its argument it takes
//! 3holes.off too.

mod flow;
mod surfaces;

use medax::complex::{CompareOptions, Comparison, ComplexParts, Element, Rows, Values, compare};
use medax::dual::DualOptions;
use medax::io::read_complex;
use medax::medial::MedialFilter;
use medax::points::PointsOptions;
use medax::sample::{SampleOptions, Shape, sample, sample_mesh};
use medax::{Complex, Dual, Job, Labels, Medial, Points, Triangulation};
use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;
use surfaces::{Point, Surface, TORUS_TUBE, distance, length};

/// The sampling densities of the table.
const EPSILONS: [f64; 4] = [0.4, 0.2, 0.1, 0.05];

/// Random numbers (SplitMix64).
struct Random(u64);

impl Random {
    /// Uniform in [0, 1).
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn shuffle<T>(&mut self, rows: &mut [T]) {
        for i in (1..rows.len()).rev() {
            rows.swap(i, (self.uniform() * (i + 1) as f64) as usize);
        }
    }
}

/// Points in the cells of a grid.
struct Grid {
    size: f64,
    cells: HashMap<[i32; 3], Vec<Point>>,
    points: Vec<Point>,
}

impl Grid {
    fn new(size: f64) -> Self {
        Grid { size, cells: HashMap::new(), points: Vec::new() }
    }

    fn cell(&self, p: Point) -> [i32; 3] {
        p.map(|x| (x / self.size).floor() as i32)
    }

    fn add(&mut self, p: Point) {
        self.cells.entry(self.cell(p)).or_default().push(p);
        self.points.push(p);
    }

    /// The distance of the nearest point, if it is at most the size of a cell; infinity if not.
    fn nearest(&self, p: Point) -> f64 {
        let [x, y, z] = self.cell(p);
        let mut least = f64::INFINITY;
        for i in 0..27 {
            let cell = [x + i % 3 - 1, y + i / 3 % 3 - 1, z + i / 9 - 1];
            for &q in self.cells.get(&cell).into_iter().flatten() {
                least = least.min(distance(p, q));
            }
        }
        if least <= self.size { least } else { f64::INFINITY }
    }
}

/// A part of a surface: the middle of its parameters, and half their extents.
#[derive(Clone, Copy)]
struct Patch {
    middle: [f64; 2],
    half: [f64; 2],
}

impl Patch {
    /// The point at the middle, and how far any point of the patch may be from it.
    fn ball(&self, surface: Surface) -> (Point, f64, [f64; 2]) {
        let [u, v] = self.middle;
        let speeds = surface.speeds(u, self.half[0]);
        let reaches = [0, 1].map(|k| speeds[k] * self.half[k]);
        (surface.at(u, v), reaches[0] + reaches[1], reaches)
    }

    /// Halves, across the longer side.
    fn halves(&self, reaches: [f64; 2]) -> [Patch; 2] {
        let k = usize::from(reaches[1] > reaches[0]);
        [-0.5, 0.5].map(|side| {
            let mut half = *self;
            half.half[k] *= 0.5;
            half.middle[k] += side * self.half[k];
            half
        })
    }

    /// All of a surface, in patches small beside the features.
    fn all(surface: Surface, size: f64) -> Vec<Patch> {
        let mut waiting = vec![Patch { middle: [0.5; 2], half: [0.5; 2] }];
        let mut small = Vec::new();
        while let Some(patch) = waiting.pop() {
            let (_, radius, reaches) = patch.ball(surface);
            if radius <= size {
                small.push(patch);
            } else {
                waiting.extend(patch.halves(reaches));
            }
        }
        small
    }
}

/// How much denser than epsilon asks, smoothly from place to place: between 1 and 0.6.
fn density(p: Point) -> f64 {
    0.8 + 0.2 * (3.0 * p[0] + 1.0).sin() * (2.0 * p[1] - 1.0).cos()
}

/// Random samples, no two of them much nearer than need be, in random order: patches of the surface are cut until a sample covers them, and those that
/// none covers when they are small get a random one.
fn samples(surface: Surface, epsilon: f64) -> Vec<Point> {
    let mut random = Random(1);
    let mut grid =
        Grid::new(epsilon * if matches!(surface, Surface::Ellipsoid) { 0.7 } else { 0.4 });
    let mut patches = Patch::all(surface, 0.1 * epsilon);
    random.shuffle(&mut patches);
    for patch in patches {
        let mut waiting = vec![patch];
        while let Some(patch) = waiting.pop() {
            let (at, radius, reaches) = patch.ball(surface);
            let allowed = epsilon * density(at) * (surface.feature_size(at) - radius);
            if grid.nearest(at) + radius <= allowed {
                continue;
            }
            if radius > 0.15 * allowed {
                let mut halves = patch.halves(reaches);
                random.shuffle(&mut halves);
                waiting.extend(halves);
            } else {
                let [u, v] = [0, 1]
                    .map(|k| patch.middle[k] + patch.half[k] * (2.0 * random.uniform() - 1.0));
                grid.add(surface.at(u, v));
            }
        }
    }
    grid.points
}

/// The epsilon of which the samples certainly are an epsilon-sample, at most the one that is given, and the largest that was seen at a point; nothing if
/// they are not.
///
/// A patch whose points are all within r of its middle x is covered if (d(x) + r) / (f(x) - r) is at most epsilon, where d is the distance
/// of the nearest sample: both d and the local feature size f change by at most the distance between two points. If not it is cut in two.
fn certified(surface: Surface, samples: &[Point], epsilon: f64) -> Option<[f64; 2]> {
    let mut grid =
        Grid::new(epsilon * if matches!(surface, Surface::Ellipsoid) { 0.7 } else { 0.4 });
    samples.iter().for_each(|&p| grid.add(p));
    let mut waiting = Patch::all(surface, 0.1 * epsilon);
    let mut found: [f64; 2] = [0.0; 2];
    while let Some(patch) = waiting.pop() {
        let (at, radius, reaches) = patch.ball(surface);
        let (nearest, feature) = (grid.nearest(at), surface.feature_size(at));
        found[1] = found[1].max(nearest / feature);
        let bound = (nearest + radius) / (feature - radius);
        if feature > radius && bound <= epsilon {
            found[0] = found[0].max(bound);
        } else if nearest / feature > epsilon || radius < 1e-6 {
            return None;
        } else {
            waiting.extend(patch.halves(reaches));
        }
    }
    Some(found)
}

/// The inner axis with the default thresholds, and all that was calculated. A facet is inner if all its corners, the Voronoi vertices,
/// are: flat cells that span the outside of a bend have their barycentres inside, and their Voronoi vertices far outside.
fn inner_axis(rows: &[Point], is_inside: &dyn Fn(&[Point]) -> Vec<bool>) -> (Complex, Medial) {
    let job = Job::default();
    let points = Arc::new(Points::new(rows, PointsOptions::default(), &job).unwrap());
    let t = Arc::new(Triangulation::delaunay(&points, &job).unwrap());
    let dual = Arc::new(Dual::new(&t, DualOptions { facets: true }, &job).unwrap());
    let labels = Arc::new(Labels::new(&t, is_inside(dual.centers())).unwrap());
    let medial = Medial::new(&dual, Some(&labels), Default::default(), &job).unwrap();
    (medial.axis(&MedialFilter::default(), &job).unwrap(), medial)
}

/// Whether points lie inside, by a function that is negative there.
fn by_value(value: impl Fn(Point) -> f64) -> impl Fn(&[Point]) -> Vec<bool> {
    move |points| points.iter().map(|&p| value(p) < 0.0).collect()
}

fn distances(a: &Complex, b: &Complex) -> Comparison {
    let options = CompareOptions { samples: 200_000, ..Default::default() };
    compare(a, b, &options, &Job::default()).unwrap()
}

fn print(fields: &[String]) {
    println!("{}", fields.join("\t"));
}

/// The part of the axis of which the paper proves that it converges (definition 4): what the angle condition chooses, and of the rest facets whose edge
/// p q is at least epsilon^(1/4) times as long as the inner ball's radius at p, where the medial angle is more than epsilon^(1/3).
fn proved(surface: Surface, epsilon: f64, axis: &Complex, medial: &Medial) -> Complex {
    let numbers = |name| match axis.attribute(Element::Face, name).unwrap().values() {
        Values::U32(values) => values,
        Values::F64(_) => unreachable!(),
    };
    let (conditions, facets) = (numbers("condition"), numbers("facet"));
    let dual = medial.dual();
    let is_proved = |face: usize| {
        if conditions[face] & 1 == 1 {
            return true;
        }
        let facet = facets[face] as usize;
        let ends = dual.facets().unwrap().edges()[facet];
        let [p, q] = ends.map(|v| dual.triangulation().coords()[v as usize]);
        [p, q].into_iter().zip(medial.ratios()[facet]).any(|(end, ratio)| {
            let [radius, angle] = surface.inner_ball(end);
            let is_long = distance(p, q) >= epsilon.powf(0.25) * radius;
            ratio > MedialFilter::default().rho && is_long && angle > epsilon.cbrt()
        })
    };
    let mut faces = Rows::default();
    for (_, ring) in axis.faces().iter().enumerate().filter(|&(face, _)| is_proved(face)) {
        faces.push(ring).unwrap();
    }
    let vertices = axis.vertices().to_vec();
    Complex::new(ComplexParts { vertices, faces, ..Default::default() }).unwrap()
}

fn convergence(epsilons: &[f64]) {
    for surface in Surface::ALL {
        let exact = surface.axis();
        let diagonal = surface.shape().bounds().diagonal();
        for &epsilon in epsilons {
            let rows = samples(surface, epsilon);
            let [bound, seen] = certified(surface, &rows, epsilon).expect("an epsilon-sample");
            let is_inside = by_value(|p| surface.shape().value(p));
            let (axis, medial) = inner_axis(&rows, &is_inside);
            let part = proved(surface, epsilon, &axis, &medial);
            let torn = medial.umbrellas().torn_count();
            drop(medial);
            let mut fields = vec!["smooth".into(), surface.shape().name().into()];
            let counts = [rows.len(), axis.faces().len(), part.faces().len(), torn];
            fields.extend(counts.map(|n| n.to_string()));
            fields.extend([epsilon, bound, seen].map(|x| format!("{x:.9e}")));
            for axis in [axis, part] {
                let found = distances(&axis, &exact);
                for part in [found.a_to_b, found.b_to_a] {
                    fields.extend([part.max, part.mean].map(|x| format!("{:.6e}", x / diagonal)));
                }
            }
            print(&fields);
        }
    }
}

/// What the threshold of the ratio condition leaves of the error, with the densest samples of a tube.
fn ratios(epsilon: f64) {
    let surface = Surface::Torus;
    let rows = samples(surface, epsilon);
    let (_, medial) = inner_axis(&rows, &by_value(|p| surface.shape().value(p)));
    for rho in [4.0, 8.0, 16.0, 32.0] {
        let filter = MedialFilter { rho, ..Default::default() };
        let axis = medial.axis(&filter, &Job::default()).unwrap();
        let found = distances(&axis, &surface.axis());
        let mut fields = vec![
            "ratio".into(),
            format!("{epsilon}"),
            format!("{rho}"),
            axis.faces().len().to_string(),
        ];
        fields.extend(
            [found.a_to_b.max, found.a_to_b.mean].map(|x| format!("{:.6e}", x / TORUS_TUBE)),
        );
        print(&fields);
    }
}

/// A name, samples, the diagonal of the shape's box, its exact axis, and what is negative inside.
type Case<'a> = (&'a str, Vec<Point>, f64, &'a Complex, fn(Point) -> f64);

/// The signed distance to a box with rounded edges, of half sides `BRICK` plus `ROUND`.
const BRICK: Point = [0.8, 0.55, 0.3];
const ROUND: f64 = 0.2;

fn brick(p: Point) -> f64 {
    let beyond = [0, 1, 2].map(|k| p[k].abs() - BRICK[k]);
    let inside = beyond.into_iter().fold(f64::NEG_INFINITY, f64::max).min(0.0);
    length(beyond.map(|x| x.max(0.0))) + inside - ROUND
}

/// The axis of the rounded box is that of the box within it: a ball that touches two of that box's sides from within, grown by the rounding, touches the
/// rounded box in two places; and along the box's edges the ball of the rounding's radius touches all of the rounded edge. It is a rectangle and for each edge a
/// facet that halves the angle.
fn brick_axis() -> Complex {
    let [a, b, c] = BRICK;
    let signs = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];
    let (x, y) = (a - c, b - c);
    let mut rings = vec![vec![[x, y, 0.0], [-x, y, 0.0], [-x, -y, 0.0], [x, -y, 0.0]]];
    for [s, t] in signs {
        rings.push(vec![[-a, s * b, t * c], [a, s * b, t * c], [x, s * y, 0.0], [-x, s * y, 0.0]]);
        rings.push(vec![[s * a, -b, t * c], [s * a, b, t * c], [s * x, y, 0.0], [s * x, -y, 0.0]]);
        rings.push(vec![[s * a, t * b, -c], [s * a, t * b, c], [s * x, t * y, 0.0]]);
    }
    let (mut vertices, mut faces) = (Vec::new(), Rows::default());
    for ring in rings {
        let first = vertices.len() as u32;
        faces.push(&(first..first + ring.len() as u32).collect::<Vec<_>>()).unwrap();
        vertices.extend(ring);
    }
    Complex::new(ComplexParts { vertices, faces, ..Default::default() }).unwrap()
}

/// Random points of the rounded box, thinned to a spacing: of a larger box's points the nearest ones.
fn brick_samples(spacing: f64) -> Vec<Point> {
    let mut random = Random(2);
    let mut grid = Grid::new(spacing);
    let outer = BRICK.map(|half| half + 2.0 * ROUND);
    for _ in 0..(2000.0 / spacing / spacing) as usize {
        let mut p = [0, 1, 2].map(|k| outer[k] * (2.0 * random.uniform() - 1.0));
        let k = (3.0 * random.uniform()) as usize;
        p[k] = outer[k] * p[k].signum();
        let within = [0, 1, 2].map(|k| p[k].clamp(-BRICK[k], BRICK[k]));
        let away = distance(p, within);
        let p = [0, 1, 2].map(|k| within[k] + (p[k] - within[k]) * (ROUND / away));
        if grid.nearest(p) > spacing {
            grid.add(p);
        }
    }
    grid.points
}

/// Shapes whose samples are cospherical, or whose medial axis is a point or a curve: where every Voronoi vertex inside is a sliver's.
fn degenerate() {
    let point = ComplexParts { vertices: vec![[0.0; 3]], ..Default::default() };
    let segment = ComplexParts {
        vertices: vec![[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]],
        edges: vec![[0, 1]],
        ..Default::default()
    };
    let [point, segment] = [point, segment].map(|parts| Complex::new(parts).unwrap());
    let of_shape = |shape: Shape, spacing: f64| {
        let options = SampleOptions { spacing, ..Default::default() };
        sample(shape, options, &Job::default()).unwrap().points().to_vec()
    };
    for spacing in [0.2, 0.1, 0.05, 0.025] {
        let cases: [Case; 3] = [
            ("sphere", of_shape(Shape::Sphere, spacing), 12f64.sqrt(), &point, |p| {
                Shape::Sphere.value(p)
            }),
            (
                "capsule",
                of_shape(Shape::Capsule, spacing),
                Shape::Capsule.bounds().diagonal(),
                &segment,
                |p| Shape::Capsule.value(p),
            ),
            (
                "rounded box",
                brick_samples(spacing),
                length(BRICK.map(|x| 2.0 * (x + ROUND))),
                &brick_axis(),
                brick,
            ),
        ];
        for (name, rows, diagonal, exact, value) in cases {
            let (axis, medial) = inner_axis(&rows, &by_value(value));
            let torn = medial.umbrellas().torn_count();
            let mut fields = vec!["degenerate".into(), name.to_string()];
            fields.extend([rows.len(), axis.faces().len(), torn].map(|n| n.to_string()));
            fields.push(format!("{spacing}"));
            if axis.faces().is_empty() {
                fields.extend(["-"; 4].map(String::from));
            } else {
                let found = distances(&axis, exact);
                let parts =
                    [found.a_to_b.max, found.a_to_b.mean, found.b_to_a.max, found.b_to_a.mean];
                fields.extend(parts.map(|x| format!("{:.6e}", x / diagonal)));
            }
            print(&fields);
        }
    }
}

/// The samples, those on one side of the middle thinned to about a tenth of their density.
fn thinned(rows: &[Point], spacing: f64) -> Vec<Point> {
    let (low, high) =
        rows.iter().fold((f64::MAX, f64::MIN), |(a, b), p| (a.min(p[0]), b.max(p[0])));
    // Thinning to a spacing leaves one in its square; what is already thinned is a little denser than random points.
    let mut grid = Grid::new(spacing * 10f64.sqrt() * 0.96);
    let mut kept: Vec<Point> = rows.iter().copied().filter(|p| p[0] < (low + high) / 2.0).collect();
    let mut rest: Vec<Point> =
        rows.iter().copied().filter(|p| p[0] >= (low + high) / 2.0).collect();
    Random(3).shuffle(&mut rest);
    for p in rest {
        if grid.nearest(p) > grid.size {
            grid.add(p);
        }
    }
    kept.extend(grid.points);
    kept
}

fn densities(models: Option<&str>) {
    let job = Job::default();
    let even = |name: &str,
                rows: &[Point],
                spacing: f64,
                labels: &dyn Fn(&[Point]) -> Vec<bool>,
                diagonal: f64| {
        let uneven = thinned(rows, spacing);
        let [(a, _), (b, _)] = [rows, &uneven].map(|rows| inner_axis(rows, labels));
        let found = distances(&a, &b);
        let mut fields = vec!["density".into(), name.to_string()];
        for (rows, axis) in [(rows, &a), (&uneven, &b)] {
            let topology = axis.topology(&job).unwrap();
            fields.extend([rows.len(), axis.faces().len()].map(|n| n.to_string()));
            fields.push(topology.betti.map(|b| b.to_string()).join(", "));
        }
        let parts = [found.a_to_b.max, found.a_to_b.mean, found.b_to_a.max, found.b_to_a.mean];
        fields.extend(parts.map(|x| format!("{:.6e}", x / diagonal)));
        print(&fields);
    };
    for spacing in [0.04, 0.02] {
        let options = SampleOptions { spacing, ..Default::default() };
        let rows = sample(Shape::Torus, options, &job).unwrap().points().to_vec();
        let labels = by_value(|p| Shape::Torus.value(p));
        even(
            &format!("torus, spacing {spacing}"),
            &rows,
            spacing,
            &labels,
            Shape::Torus.bounds().diagonal(),
        );
    }
    let Some(path) =
        models.map(|folder| Path::new(folder).join("3holes.off")).filter(|path| path.is_file())
    else {
        eprintln!("3holes.off is not there");
        return;
    };
    let mesh = read_complex(&path, &job).unwrap();
    let (low, high) =
        mesh.vertices().iter().fold(([f64::MAX; 3], [f64::MIN; 3]), |(low, high), p| {
            ([0, 1, 2].map(|k| p[k].min(low[k])), [0, 1, 2].map(|k| p[k].max(high[k])))
        });
    let diagonal = distance(low, high);
    for share in [200.0, 400.0] {
        let spacing = diagonal / share;
        let options = SampleOptions { spacing, ..Default::default() };
        let rows = sample_mesh(&mesh, options, &job).unwrap().points().to_vec();
        let labels = |points: &[Point]| {
            let numbers = mesh.winding_numbers(points, &job).unwrap();
            numbers.into_iter().map(|number| number > 0.5).collect()
        };
        even(
            &format!("3holes, spacing 1/{share} of the diagonal"),
            &rows,
            spacing,
            &labels,
            diagonal,
        );
    }
}

fn main() {
    let words: Vec<String> =
        std::env::args().skip(1).filter(|word| !word.starts_with("--")).collect();
    let quick = std::env::args().any(|word| word == "--quick");
    let epsilons = if quick { &EPSILONS[..2] } else { &EPSILONS };
    ratios(epsilons[epsilons.len() - 1]);
    convergence(epsilons);
    flow::convergence(epsilons);
    degenerate();
    densities(words.first().map(String::as_str));
}

//! MEDIAL against the paper, by brute force.

use super::{BOTH, assert_valid, cross, dot, edge, length, medial, minus, samples, selected};
use crate::poles::{Exact, exact, exact_center, exact_cross, exact_dot, exact_minus};
use crate::sets::{self, Random, Set};
use medax::medial::{MedialFilter, MedialRule};
use medax::predicates::orient3d;
use medax::sample::Shape;
use medax::{Dual, Job, NONE, Points, Poles, Triangulation};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};
use std::cell::OnceCell;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_8};
use std::sync::Arc;

/// A Voronoi diagram whose signs are decided in rationals where f64 leaves a doubt.
struct Brute<'a> {
    t: &'a Triangulation,
    dual: &'a Dual,
    centers: Vec<OnceCell<Exact>>,
    cells_of: Vec<Vec<u32>>,
}

/// The pole of a sample: the cell of the farthest Voronoi vertex, or the direction of one at infinity.
#[derive(Clone, Copy)]
enum Pole {
    At(u32),
    Towards([f64; 3]),
}

/// The conditions at one end of an edge: the least sine and the least ratio over the umbrella.
type AtEnd = Option<(f64, f64)>;

impl<'a> Brute<'a> {
    fn new(dual: &'a Dual) -> Self {
        let t = &**dual.triangulation();
        let mut cells_of = vec![Vec::new(); t.coords().len()];
        for (cell, corners) in t.cells().iter().enumerate() {
            corners.iter().for_each(|&v| cells_of[v as usize].push(cell as u32));
        }
        let centers = vec![OnceCell::new(); t.cells().len()];
        Brute { t, dual, centers, cells_of }
    }

    fn center(&self, cell: u32) -> &Exact {
        self.centers[cell as usize].get_or_init(|| {
            exact_center(self.t.cells()[cell as usize].map(|v| self.t.coords()[v as usize]))
        })
    }

    /// Whether the first cell's centre is farther from the sample, or as far and lexicographically less.
    fn is_farther(&self, sample: [f64; 3], a: u32, b: u32) -> bool {
        let [ra, rb] = [a, b].map(|cell| self.dual.radii_squared()[cell as usize]);
        if (ra - rb).abs() > 1e-12 * ra.max(rb) {
            return ra > rb;
        }
        let [ca, cb] = [a, b].map(|cell| self.center(cell));
        let s = exact(sample);
        let [x, y] = [ca, cb].map(|c| exact_minus(c, &s)).map(|x| exact_dot(&x, &x));
        x > y || (x == y && ca < cb)
    }

    /// Definition 1. The direction at infinity is the crate's, checked here against the mean of the hull's normals.
    fn pole(&self, sample: u32, crates: [f64; 3]) -> Pole {
        let mut mean = [0.0; 3];
        let (mut hull, mut thin) = (0, false);
        for &cell in &self.cells_of[sample as usize] {
            let corners = self.t.cells()[cell as usize];
            for facet in 0..4 {
                let open = self.t.neighbors()[cell as usize][facet] == NONE;
                if !open || corners[facet] == sample {
                    continue;
                }
                hull += 1;
                let [a, b, c, d] = [1, 2, 3, 0].map(|k| {
                    let v = corners[(facet + k) % 4];
                    self.t.coords()[v as usize]
                });
                let (x, y) = (minus(b, a), minus(c, a));
                let n = cross(x, y);
                thin |= length(n) < 1e-3 * length(x) * length(y);
                let inward = orient3d(&a, &b, &c, &d).is_positive();
                let outward = if inward { -1.0 } else { 1.0 };
                let size = length(n) * outward;
                mean = [0, 1, 2].map(|k| mean[k] + n[k] / size);
            }
        }
        if hull > 0 {
            // Needles have no normal in f64.
            let cosine = dot(mean, crates) / length(mean) / length(crates);
            assert!(thin || cosine > 1.0 - 1e-9, "{cosine}");
            return Pole::Towards(crates);
        }
        let at = self.t.coords()[sample as usize];
        let cells = self.cells_of[sample as usize].iter().copied();
        Pole::At(cells.reduce(|a, b| if self.is_farther(at, b, a) { b } else { a }).unwrap())
    }

    /// Whether the Voronoi vertex of a cell lies beyond the tangent plane of a sample, seen from its pole.
    fn is_below(&self, sample: u32, pole: Pole, cell: u32) -> bool {
        let at = self.t.coords()[sample as usize];
        let far = |p: [f64; 3]| p.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let center = |cell: u32| self.dual.centers()[cell as usize];
        let x = minus(center(cell), at);
        let (y, y_far) = match pole {
            Pole::At(other) => (minus(center(other), at), far(center(other))),
            Pole::Towards(direction) => (direction, 1.0),
        };
        let found = dot(x, y);
        if found.abs() > 1e-12 * (length(x) + far(center(cell))) * (length(y) + y_far) {
            return found < 0.0;
        }
        let s = exact(at);
        let x = exact_minus(self.center(cell), &s);
        let y = match pole {
            Pole::At(other) => exact_minus(self.center(other), &s),
            Pole::Towards(direction) => exact(direction),
        };
        exact_dot(&x, &y) < BigRational::zero()
    }

    /// Definitions 2 and 3: the other vertices of the triangles at a sample whose dual edge the tangent plane cuts, as ascending pairs.
    fn umbrella(&self, sample: u32, pole: Pole) -> BTreeSet<[u32; 2]> {
        let mut around: BTreeMap<[u32; 2], Vec<bool>> = BTreeMap::new();
        for &cell in &self.cells_of[sample as usize] {
            let corners = self.t.cells()[cell as usize];
            for (facet, _) in corners.iter().enumerate().filter(|&(_, &v)| v != sample) {
                let mut rim: Vec<u32> =
                    (0..4).filter(|&k| k != facet).map(|k| corners[k]).collect();
                rim.retain(|&v| v != sample);
                rim.sort_unstable();
                let sides = around.entry([rim[0], rim[1]]).or_default();
                sides.push(self.is_below(sample, pole, cell));
                if self.t.neighbors()[cell as usize][facet] == NONE {
                    let ray = self.dual.rays().of_facet(cell, facet as u32);
                    let direction = self.dual.rays().directions()[ray as usize];
                    // The pole is at infinity then.
                    let Pole::Towards(pole) = pole else { unreachable!() };
                    sides.push(dot(direction, pole) < 0.0);
                }
            }
        }
        assert!(around.values().all(|sides| sides.len() == 2));
        around.into_iter().filter(|(_, sides)| sides[0] != sides[1]).map(|(rim, _)| rim).collect()
    }

    /// The sine of the angle between the edge p q and the triangle p u v, and the edge's length by the triangle's circumradius.
    fn measure(&self, [p, q, u, v]: [u32; 4]) -> (f64, f64) {
        let at = [p, q, u, v].map(|x| self.t.coords()[x as usize]);
        let [e, a, b] = [1, 2, 3].map(|k| minus(at[k], at[0]));
        let n = cross(a, b);
        if length(n) > 1e-3 * length(a) * length(b) && length(n) > 1e-200 {
            let sine = dot(n, e) / length(n) / length(e);
            let radius = length(a) * length(b) * length(minus(a, b)) / 2.0 / length(n);
            return (sine.abs(), length(e) / radius);
        }
        let [p, q, u, v] = at.map(exact);
        let [e, a, b] = [q, u, v].map(|x| exact_minus(&x, &p));
        let n = exact_cross(&a, &b);
        let square = |x: &Exact| exact_dot(x, x);
        let along = exact_dot(&n, &e);
        let sine = &along * &along / (square(&n) * square(&e));
        let sides = square(&a) * square(&b) * square(&exact_minus(&a, &b));
        let ratio = square(&e) * square(&n) * BigRational::from(BigInt::from(4)) / sides;
        (sine.to_f64().unwrap().sqrt(), ratio.to_f64().unwrap().sqrt())
    }

    /// What each Delaunay edge, the lesser vertex first, has from either end; nothing where the end's umbrella has the edge.
    fn conditions(&self, umbrellas: &[BTreeSet<[u32; 2]>]) -> BTreeMap<[u32; 2], [AtEnd; 2]> {
        let mut edges = BTreeMap::new();
        for corners in self.t.cells() {
            let mut sorted = *corners;
            sorted.sort_unstable();
            for (i, j) in [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)] {
                let ends = [sorted[i], sorted[j]];
                edges.entry(ends).or_insert_with(|| {
                    [ends, [ends[1], ends[0]]].map(|[p, q]| {
                        let umbrella = &umbrellas[p as usize];
                        if umbrella.is_empty() || umbrella.iter().any(|rim| rim.contains(&q)) {
                            return None;
                        }
                        let all = umbrella.iter().map(|&[u, v]| self.measure([p, q, u, v]));
                        all.reduce(|(a, b), (c, d)| (a.min(c), b.min(d)))
                    })
                });
            }
        }
        edges
    }
}

/// Whether conditions are fulfilled from either end, as the paper has them; nothing within 1e-9 of a threshold.
fn decided(ends: &[AtEnd; 2], filter: &MedialFilter) -> Option<bool> {
    let mut passes = false;
    for &(sine, ratio) in ends.iter().flatten() {
        // The largest angle to a normal.
        let angle = FRAC_PI_2 - sine.min(1.0).asin();
        let bound = FRAC_PI_2 - filter.theta;
        if (angle - bound).abs() < 1e-9 || (ratio - filter.rho).abs() < 1e-9 * filter.rho.max(1.0) {
            return None;
        }
        passes |= match filter.rule {
            MedialRule::AngleOrRatio => angle < bound || ratio > filter.rho,
            MedialRule::Angle => angle < bound,
            MedialRule::Ratio => ratio > filter.rho,
            MedialRule::Every => true,
        };
    }
    Some(passes || filter.rule == MedialRule::Every)
}

/// Compares everything with the paper. Returns how many edges were compared, selected by default, and left aside.
fn equals_the_paper(rows: &[[f64; 3]], name: &str) -> [usize; 3] {
    let job = Job::default();
    let medial = medial(rows);
    assert_valid(&medial, name);
    let dual = medial.dual();
    let brute = Brute::new(dual);
    let poles = Poles::new(dual, Default::default(), &job).unwrap();
    let vertices = dual.triangulation().coords().len() as u32;
    let umbrellas: Vec<_> = (0..vertices)
        .map(|v| brute.umbrella(v, brute.pole(v, poles.normals()[v as usize])))
        .collect();
    for v in 0..vertices {
        let rims = medial.umbrellas().rims_of(v).iter();
        let found: BTreeSet<_> = rims.map(|&[a, b]| [a.min(b), a.max(b)]).collect();
        assert_eq!(found, umbrellas[v as usize], "{name}: umbrella of {v}");
    }
    let conditions = brute.conditions(&umbrellas);
    assert!(conditions.keys().eq(dual.facets().unwrap().edges()), "{name}");
    for (facet, (edge, ends)) in conditions.iter().enumerate() {
        for (i, end) in ends.iter().enumerate() {
            let found = (medial.sines()[facet][i], medial.ratios()[facet][i]);
            let (sine, ratio) = end.unwrap_or((f64::NEG_INFINITY, f64::NEG_INFINITY));
            let near = |a: f64, b: f64| a == b || (a - b).abs() < 1e-9 * b.abs().max(1e-3);
            let right = near(found.0, sine.min(1.0)) && near(found.1, ratio);
            assert!(right, "{name}: {edge:?}: {found:?}, not {:?}", (sine, ratio));
        }
    }
    let mut counts = [conditions.len(), 0, 0];
    for rule in [MedialRule::AngleOrRatio, MedialRule::Angle, MedialRule::Ratio, MedialRule::Every]
    {
        for (theta, rho) in [(FRAC_PI_8, 8.0), (0.1, 3.0), (1.0, 0.5), (0.0, 0.0)] {
            let filter = MedialFilter { rule, theta, rho, ..BOTH };
            let found: BTreeSet<_> =
                selected(&medial, &filter).into_iter().map(|facet| edge(&medial, facet)).collect();
            let is_default = filter == BOTH;
            counts[1] += usize::from(is_default) * found.len();
            for (edge, ends) in &conditions {
                match decided(ends, &filter) {
                    Some(passes) => assert_eq!(found.contains(edge), passes, "{name}: {edge:?}"),
                    None => counts[2] += usize::from(is_default),
                }
            }
        }
    }
    counts
}

#[test]
fn every_kind_of_set_equals_the_paper() {
    for n in [12, 40, 200] {
        for Set { name, rows } in sets::all(n) {
            let [edges, selected, aside] = equals_the_paper(&rows, &format!("{name}, {n}"));
            println!("{name}, {n}: {edges} edges, {selected} selected, {aside} left aside");
            // On lattices and on lines many angles are those of thresholds.
            assert!(aside * 50 <= edges || n < 100, "{name}: {aside} of {edges}");
        }
    }
}

#[test]
fn small_random_sets_equal_the_paper() {
    let mut random = Random(21);
    for i in 0..60 {
        let n = 5 + i % 20;
        // Rounded to eighths and sixteenths: ties of every kind.
        let step = [8.0, 16.0, 1e6][i % 3];
        let rows: Vec<_> =
            (0..n).map(|_| random.cube().map(|x| (x * step).round() / step)).collect();
        let points = Arc::new(Points::new(&rows, Default::default(), &Job::default()).unwrap());
        if Triangulation::delaunay(&points, &Job::default()).is_ok() {
            equals_the_paper(&rows, &format!("set {i}"));
        }
    }
}

#[test]
fn sampled_shapes_equal_the_paper() {
    for shape in Shape::ALL {
        let rows = samples(shape, 2.0 * shape.spacing());
        let [edges, selected, aside] = equals_the_paper(&rows, shape.name());
        println!("{}: {edges} edges, {selected} selected, {aside} left aside", shape.name());
        let few = if shape == Shape::Sphere { 5 } else { 50 };
        assert!(selected > few && 2 * selected < edges && aside < 3, "{}", shape.name());
    }
}

//! MEDIAL: against the paper, a hand-built case, thresholds, threads, normals, errors.

mod clip;
mod paper;
mod reach;
mod thin;

use crate::sets::{self, Random, Set};
use medax::complex::{ComplexParts, Element, Rows, Values};
use medax::dual::DualOptions;
use medax::medial::{MedialFilter, MedialOptions, MedialRule, Side};
use medax::sample::{SampleOptions, Shape, sample};
use medax::{Complex, Dual, Job, JobOptions, Labels, Medial, Points, Status};
use medax::{ElementKind, Triangulation};
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_8, PI, TAU};
use std::sync::Arc;

const BOTH: MedialFilter = MedialFilter {
    rule: MedialRule::AngleOrRatio,
    theta: FRAC_PI_8,
    rho: 8.0,
    object_angle: 0.0,
    lambda: 0.0,
    scale: 0.0,
    side: Side::Both,
    clip: None,
};

pub fn dual_of(rows: &[[f64; 3]], job: &Job) -> Arc<Dual> {
    let points = Arc::new(Points::new(rows, Default::default(), job).unwrap());
    let t = Arc::new(Triangulation::delaunay(&points, job).unwrap());
    Arc::new(Dual::new(&t, DualOptions { facets: true }, job).unwrap())
}

fn medial(rows: &[[f64; 3]]) -> Medial {
    let job = Job::default();
    Medial::new(&dual_of(rows, &job), None, Default::default(), &job).unwrap()
}

pub fn samples(shape: Shape, spacing: f64) -> Vec<[f64; 3]> {
    let options = SampleOptions { spacing, ..Default::default() };
    sample(shape, options, &Job::default()).unwrap().points().to_vec()
}

/// Labels by the shape itself: a cell is inner if its Voronoi vertex is. Flat cells that span the outside of a bend have their barycentre inside.
pub fn labels_of(shape: Shape, dual: &Dual) -> Arc<Labels> {
    let is_inner = dual.centers().iter().map(|&center| shape.value(center) < 0.0);
    Arc::new(Labels::new(dual.triangulation(), is_inner.collect()).unwrap())
}

fn with_labels(shape: Shape, spacing: f64, options: MedialOptions) -> Medial {
    let job = Job::default();
    let dual = dual_of(&samples(shape, spacing), &job);
    let labels = labels_of(shape, &dual);
    Medial::new(&dual, Some(&labels), options, &job).unwrap()
}

fn selected(medial: &Medial, filter: &MedialFilter) -> Vec<u32> {
    medial.selected(filter, &Job::default()).unwrap()
}

fn edge(medial: &Medial, facet: u32) -> [u32; 2] {
    medial.dual().facets().unwrap().edges()[facet as usize]
}

fn assert_valid(medial: &Medial, name: &str) {
    let report = medial.validate(&Job::default()).unwrap();
    assert!(report.is_valid(), "{name}: {report:?}");
    let facets = medial.sines().len() as u64;
    assert!(report.checked > 2 * facets, "{name} was not checked");
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| a[k] - b[k])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i] * b[j] - a[j] * b[i])
}

fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

// MEDIAL as the paper has it, over the cells of the triangulation.

/// A wall x = 0, coarse, above a floor z = 0, fine, and a box far round both. Of the floor only the sample at the origin is left within `gap`. The edge from the lowest sample of the wall down to the floor lies in the
/// wall's plane: it is tangent as seen from the wall, and at a right angle as seen from the floor.
fn wall_and_floor(shift: f64, gap: f64) -> (Medial, [u32; 2]) {
    let mut rows = vec![[0.0, shift, 1.0], [0.0; 3]];
    let floor = (-16..=16).flat_map(|i| (-16..=16).map(move |j| [i, j].map(f64::from)));
    rows.extend(floor.map(|[x, y]| [x / 4.0, y / 4.0, 0.0]).filter(|p| length(*p) > gap));
    let wall = (-4..=4).flat_map(|j| (2..=5).map(move |k| [j, k].map(f64::from)));
    rows.extend(wall.map(|[y, z]| [0.0, y + 0.5 * (z % 2.0), 1.0 + 0.9 * (z - 1.0)]));
    rows.extend([-4.0, -3.0, -2.0, -1.0, 1.0, 2.0, 3.0, 4.0].map(|y| [0.0, y, 1.0]));
    rows.extend((0..8).map(|i| [1, 2, 4].map(|bit| if i & bit > 0 { 40.0 } else { -40.0 })));
    let medial = medial(&rows);
    let vertices = medial.dual().triangulation().points().vertex_of_row();
    let ends = [vertices[0], vertices[1]];
    (medial, ends)
}

#[test]
fn an_edge_that_passes_from_one_end_only_is_chosen() {
    let mut in_umbrella = [0; 2];
    for (shift, gap) in [(0.0, 0.0), (0.25, 0.0), (-0.2, 0.0), (0.0, 0.6), (0.1, 0.8)] {
        let (medial, [p, q]) = wall_and_floor(shift, gap);
        assert_valid(&medial, "wall and floor");
        let edges = medial.dual().facets().unwrap().edges();
        let facet = edges.binary_search(&[p.min(q), p.max(q)]).expect("an edge");
        let end = |v: u32| edges[facet].iter().position(|&x| x == v).unwrap();
        let at = |v: u32| (medial.sines()[facet][end(v)], medial.ratios()[facet][end(v)]);
        let ((p_sine, p_ratio), (q_sine, _)) = (at(p), at(q));
        let has = |v: u32, w: u32| medial.umbrellas().rims_of(v).as_flattened().contains(&w);
        println!("{shift}: from p {p_sine} {p_ratio}, from q {q_sine}, in U_p: {}", has(p, q));
        in_umbrella[usize::from(has(p, q))] += 1;
        assert_eq!(has(p, q), p_sine == f64::NEG_INFINITY);
        assert!(!has(q, p) && p_sine < 0.38 && p_ratio < 8.0 && q_sine > 0.9);
        assert!(selected(&medial, &BOTH).contains(&(facet as u32)));
    }
    // Both kinds: an edge of p's umbrella, and one that fails both conditions there.
    assert!(in_umbrella.iter().all(|&count| count > 0), "{in_umbrella:?}");
}

#[test]
fn thresholds_only_ever_take_away() {
    let medial = with_labels(Shape::Bracket, 0.16, Default::default());
    for rule in [MedialRule::Angle, MedialRule::Ratio, MedialRule::AngleOrRatio] {
        let mut before: Option<(BTreeSet<u32>, BTreeSet<u32>)> = None;
        for step in 0..12 {
            let set = |filter: &MedialFilter| -> BTreeSet<u32> {
                selected(&medial, filter).into_iter().collect()
            };
            let by_theta = set(&MedialFilter { rule, theta: 0.13 * f64::from(step), ..BOTH });
            let by_rho = set(&MedialFilter { rule, rho: 1.5 * f64::from(step), ..BOTH });
            if let Some((theta, rho)) = &before {
                assert!(by_theta.is_subset(theta) && by_rho.is_subset(rho), "{rule:?} {step}");
                // What a rule does not ask changes nothing.
                assert_eq!(by_theta.len() == theta.len(), rule == MedialRule::Ratio, "{rule:?}");
                assert_eq!(by_rho.len() == rho.len(), rule == MedialRule::Angle, "{rule:?}");
            }
            before = Some((by_theta, by_rho));
        }
    }
    let of = |rule| -> BTreeSet<u32> {
        selected(&medial, &MedialFilter { rule, ..BOTH }).into_iter().collect()
    };
    let [either, angle, ratio, every] =
        [MedialRule::AngleOrRatio, MedialRule::Angle, MedialRule::Ratio, MedialRule::Every].map(of);
    assert_eq!(either, &angle | &ratio);
    assert!(!angle.is_subset(&ratio) && !ratio.is_subset(&angle));
    assert_eq!(every.len(), medial.sines().len());
    // An infinite rho is allowed and selects by the angle alone.
    let none = MedialFilter { rho: f64::INFINITY, ..BOTH };
    assert_eq!(selected(&medial, &none).into_iter().collect::<BTreeSet<_>>(), angle);
}

/// Filters of every kind.
fn filters() -> Vec<MedialFilter> {
    let base = MedialFilter::default();
    vec![
        base,
        BOTH,
        MedialFilter { side: Side::Outer, ..base },
        MedialFilter { theta: 0.9, rho: 20.0, ..base },
        MedialFilter { rule: MedialRule::Ratio, ..base },
        MedialFilter { rule: MedialRule::Every, object_angle: 1.5, ..base },
        MedialFilter { rule: MedialRule::Every, lambda: 0.15, side: Side::Both, ..base },
        MedialFilter { scale: 1.1, ..base },
    ]
}

/// Two complexes are the same to the bit.
fn same_bytes(a: &Complex, b: &Complex) -> bool {
    let bits = |values: &[f64]| values.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    let attributes = |c: &Complex| -> Vec<_> {
        let row = |attribute: &medax::complex::Attribute| match attribute.values() {
            Values::F64(values) => (attribute.name().to_string(), bits(values), vec![]),
            Values::U32(values) => (attribute.name().to_string(), vec![], values.clone()),
        };
        c.attributes().iter().map(row).collect()
    };
    bits(a.vertices().as_flattened()) == bits(b.vertices().as_flattened())
        && a.faces() == b.faces()
        && attributes(a) == attributes(b)
}

#[test]
fn a_slider_gives_what_a_fresh_build_gives() {
    let job = Job::default();
    let options = MedialOptions { scales: true, ..Default::default() };
    let medial = with_labels(Shape::Torus, 0.1, options.clone());
    let mut sizes = BTreeSet::new();
    for filter in filters() {
        let moved = medial.axis(&filter, &job).unwrap();
        let dual = dual_of(&samples(Shape::Torus, 0.1), &job);
        let labels = labels_of(Shape::Torus, &dual);
        let fresh = Medial::new(&dual, Some(&labels), options.clone(), &job).unwrap();
        assert!(same_bytes(&moved, &fresh.axis(&filter, &job).unwrap()), "{filter:?}");
        assert!(same_bytes(&moved, &medial.axis(&filter, &job).unwrap()), "{filter:?}");
        assert!(moved.faces().len() > 10, "{filter:?}");
        sizes.insert(moved.faces().len());
    }
    assert!(sizes.len() > 5, "{sizes:?}");
}

fn same(a: &Medial, b: &Medial) -> bool {
    let bits = |rows: &[[f64; 2]]| -> Vec<u64> {
        rows.as_flattened().iter().map(|x| x.to_bits()).collect()
    };
    let scales = |m: &Medial| m.scales().iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    bits(a.sines()) == bits(b.sines())
        && bits(a.ratios()) == bits(b.ratios())
        && bits(a.reaches()) == bits(b.reaches())
        && scales(a) == scales(b)
        && a.least_cell() == b.least_cell()
        && a.umbrellas() == b.umbrellas()
}

#[test]
fn threads_and_the_order_of_rows_change_nothing() {
    let mut all = sets::all(250);
    // More than several parts of the work.
    all.push(Set { name: "torus", rows: samples(Shape::Torus, 0.03) });
    for Set { name, rows } in all {
        let order = sets::shuffled(rows.len(), 4);
        let shuffled: Vec<_> = order.iter().map(|&i| rows[i]).collect();
        let build = |rows: &[[f64; 3]], threads: usize| {
            let job = Job::new(JobOptions { threads, ..Default::default() });
            // Scales of so many balls of both sides take long.
            let options = MedialOptions { scales: rows.len() < 1000, ..Default::default() };
            let medial = Medial::new(&dual_of(rows, &job), None, options, &job).unwrap();
            let axis = medial.axis(&BOTH, &job).unwrap();
            (medial, axis)
        };
        let (one, one_axis) = build(&rows, 1);
        for (rows, threads) in [(&rows, 3), (&rows, 8), (&shuffled, 1), (&shuffled, 3)] {
            let (other, axis) = build(rows, threads);
            assert!(same(&one, &other), "{name}, {threads} threads");
            assert!(same_bytes(&one_axis, &axis), "{name}, {threads} threads");
        }
    }
}

#[test]
fn every_kind_of_set_is_valid() {
    for Set { name, rows } in sets::all(400) {
        assert_valid(&medial(&rows), name);
    }
    for shape in Shape::ALL {
        assert_valid(&medial(&samples(shape, shape.spacing())), shape.name());
    }
}

#[test]
fn umbrellas_of_dense_samples_of_smooth_shapes_are_disks() {
    for shape in Shape::ALL.into_iter().filter(|shape| shape.is_smooth()) {
        let rows = samples(shape, 0.8 * shape.spacing());
        let medial = medial(&rows);
        let count = rows.len();
        assert_eq!(medial.umbrellas().torn_count(), 0, "{}: of {count}", shape.name());
        for v in 0..count as u32 {
            let rims = medial.umbrellas().rims_of(v);
            // The triangles turn one way round the sample, seen along the pole.
            for (i, rim) in rims.iter().enumerate() {
                assert_eq!(rim[1], rims[(i + 1) % rims.len()][0]);
                assert!(!rim.contains(&v));
            }
        }
    }
}

#[test]
fn the_axis_is_the_closure_of_the_facets() {
    let job = Job::default();
    let options = MedialOptions { scales: true, ..Default::default() };
    for shape in [Shape::Torus, Shape::Box] {
        let medial = with_labels(shape, 1.5 * shape.spacing(), options.clone());
        let facets = medial.dual().facets().unwrap();
        let coords = medial.dual().triangulation().coords();
        for filter in filters() {
            let axis = medial.axis(&filter, &job).unwrap();
            let chosen = selected(&medial, &filter);
            let of = |name| match axis.attribute(Element::Face, name).unwrap().values() {
                Values::U32(values) => values.clone(),
                Values::F64(_) => unreachable!(),
            };
            let numbers = |element, name| match axis.attribute(element, name).unwrap().values() {
                Values::F64(values) => values.clone(),
                Values::U32(_) => unreachable!(),
            };
            let radii = numbers(Element::Vertex, "radius");
            let (angles, lambdas) =
                (numbers(Element::Face, "object_angle"), numbers(Element::Face, "lambda"));
            let (numbers_of_faces, ends_of_faces) = (of("facet"), of("samples"));
            let chosen: BTreeSet<_> = chosen.into_iter().collect();
            let shown: BTreeSet<_> = numbers_of_faces.iter().copied().collect();
            assert!(shown.is_subset(&chosen));
            // Those that are no faces are unbounded, or have fewer than three corners.
            let missing = chosen.difference(&shown);
            for &facet in missing.filter(|&&facet| !facets.is_unbounded(facet as usize)) {
                let ring = facets.ring(facet as usize).iter();
                let corners: BTreeSet<_> =
                    ring.map(|&cell| medial.least_cell()[cell as usize]).collect();
                assert!(corners.len() < 3);
            }
            for (face, ring) in axis.faces().iter().enumerate() {
                let facet = numbers_of_faces[face] as usize;
                let ends = [0, 1].map(|i| ends_of_faces[2 * face + i]);
                assert_eq!(ends, facets.edges()[facet]);
                let [p, q] = ends.map(|v| coords[v as usize]);
                assert_eq!(lambdas[face], length(minus(q, p)) / 2.0);
                let angle = |at: [f64; 3]| {
                    let [x, y] = [minus(p, at), minus(q, at)];
                    length(cross(x, y)).atan2(dot(x, y))
                };
                let corners: Vec<_> = ring.iter().map(|&v| axis.vertices()[v as usize]).collect();
                // Every corner is as far from both as its radius says, and none sees them at a smaller angle than the least.
                for (&v, &at) in ring.iter().zip(&corners) {
                    for end in [p, q] {
                        let radius = radii[v as usize];
                        assert!((length(minus(at, end)) - radius).abs() < 1e-6 * (1.0 + radius));
                    }
                    assert!(angle(at) > angles[2 * face] - 1e-6);
                    assert!(angle(at) < angles[2 * face + 1] + 1e-6);
                }
                let least = corners.iter().map(|&at| angle(at)).fold(PI, f64::min);
                assert!((least - angles[2 * face]).abs() < 1e-6, "{least} {:?}", &angles[2 * face]);
                if corners.as_flattened().iter().any(|x| x.abs() > FAR) {
                    continue;
                }
                // The largest is at the point of the polygon that is nearest to the middle of the edge.
                let middle = [0, 1, 2].map(|k| (p[k] + q[k]) / 2.0);
                let fan = (1..corners.len() - 1).map(|i| [corners[0], corners[i], corners[i + 1]]);
                let nearest = fan.map(|triangle| to_triangle(middle, triangle, minus(q, p)));
                let nearest = nearest.fold(f64::INFINITY, f64::min);
                let largest = 2.0 * (lambdas[face] / nearest).atan();
                assert!((largest - angles[2 * face + 1]).abs() < 1e-6, "{largest}");
                let reach = medial.reaches()[facet][0];
                assert!(
                    (reach - nearest).abs() < 1e-6,
                    "{reach} {nearest} {corners:?} {p:?} {q:?}"
                );
                // The polygon turns counterclockwise as seen from the second sample.
                let n = (0..corners.len()).fold([0.0; 3], |sum, i| {
                    let c = cross(corners[i], corners[(i + 1) % corners.len()]);
                    [0, 1, 2].map(|k| sum[k] + c[k])
                });
                assert!(dot(n, minus(q, p)) > -1e-12);
            }
        }
    }
}

/// Facets with corners that are farther away are not measured: there is nothing left of their nearest points in f64.
const FAR: f64 = 1e4;

/// The distance of a point from a triangle that lies in a plane through it, whose normal is given: 0 within, that of a side elsewhere.
fn to_triangle(p: [f64; 3], [a, b, c]: [[f64; 3]; 3], normal: [f64; 3]) -> f64 {
    let along = |a: [f64; 3], b: [f64; 3]| {
        let d = minus(b, a);
        let t = (dot(minus(p, a), d) / dot(d, d)).clamp(0.0, 1.0);
        let t = if t.is_nan() { 0.0 } else { t };
        length(minus(p, [0, 1, 2].map(|k| a[k] + t * d[k])))
    };
    let rim = along(a, b).min(along(b, c)).min(along(c, a));
    let is_left = |(x, y)| {
        let (d, e) = (minus(y, x), minus(p, x));
        dot(cross(d, e), normal) > 1e-12 * length(normal) * length(d) * length(e)
    };
    if [(a, b), (b, c), (c, a)].into_iter().all(is_left) { 0.0 } else { rim }
}

#[test]
fn filters_of_facets_equal_brute_force() {
    let job = Job::default();
    let options = MedialOptions { scales: true, ..Default::default() };
    for (shape, is_labelled) in [(Shape::Genus3, true), (Shape::Box, true), (Shape::Torus, false)] {
        let dual = dual_of(&samples(shape, 2.0 * shape.spacing()), &job);
        let t = dual.triangulation();
        let labels = is_labelled.then(|| labels_of(shape, &dual));
        let medial = Medial::new(&dual, labels.as_ref(), options.clone(), &job).unwrap();
        let is_inner = |cell: u32| match &labels {
            Some(labels) => labels.is_inner()[cell as usize],
            None => true,
        };
        // Every pair of balls; a Voronoi vertex has the label of its least cell.
        let least: BTreeSet<u32> = medial.least_cell().iter().copied().collect();
        let radius = |cell: u32| dual.radii_squared()[cell as usize].sqrt();
        let mut scales = BTreeMap::new();
        for &cell in &least {
            let mut scale = f64::INFINITY;
            for &other in &least {
                if is_inner(other) == is_inner(cell) && radius(other) > radius(cell) {
                    let [a, b] = [cell, other].map(|cell| dual.centers()[cell as usize]);
                    scale = scale.min(length(minus(a, b)) / (radius(other) - radius(cell)));
                }
            }
            scales.insert(cell, scale);
        }
        for (cell, least) in medial.least_cell().iter().enumerate() {
            assert_eq!(medial.scales()[cell], scales[least], "{} {cell}", shape.name());
        }
        assert_eq!(
            scales.values().filter(|s| s.is_infinite()).count(),
            1 + usize::from(is_labelled)
        );
        let facets = dual.facets().unwrap();
        let every = MedialFilter { rule: MedialRule::Every, ..BOTH };
        for step in 1..6 {
            let share = f64::from(step) / 6.0;
            let lambda = MedialFilter { lambda: 0.5 * share, ..every };
            let angle = MedialFilter { object_angle: PI * share, ..every };
            let scale = MedialFilter { scale: 1.0 + share, ..every };
            let [lambdas, angles, scaled] = [lambda, angle, scale]
                .map(|filter| selected(&medial, &filter).into_iter().collect::<BTreeSet<_>>());
            assert!(!lambdas.is_empty() && !angles.is_empty() && !scaled.is_empty());
            for (facet, ends) in facets.edges().iter().enumerate() {
                let [p, q] = ends.map(|v| t.coords()[v as usize]);
                let half = length(minus(q, p)) / 2.0;
                assert_eq!(lambdas.contains(&(facet as u32)), half >= lambda.lambda);
                let ring = facets.ring(facet);
                let above =
                    ring.iter().any(|&c| scales[&medial.least_cell()[c as usize]] > scale.scale);
                assert_eq!(scaled.contains(&(facet as u32)), above);
                let at = |i: usize| dual.centers()[ring[i] as usize];
                let is_near = |i: usize| at(i).iter().all(|x| x.abs() < FAR);
                if facets.is_unbounded(facet) || !(0..ring.len()).all(is_near) {
                    continue;
                }
                let middle = [0, 1, 2].map(|k| (p[k] + q[k]) / 2.0);
                let fan = (1..ring.len() - 1).map(|i| [at(0), at(i), at(i + 1)]);
                let nearest = fan.map(|triangle| to_triangle(middle, triangle, minus(q, p)));
                let largest = 2.0 * half.atan2(nearest.fold(f64::INFINITY, f64::min));
                let distance = largest - angle.object_angle;
                if distance.abs() > 1e-6 {
                    let reach = medial.reaches()[facet];
                    let name = format!("{} {facet} {largest} {reach:?} {half}", shape.name());
                    let corners: Vec<_> = (0..ring.len()).map(at).collect();
                    let found = angles.contains(&(facet as u32));
                    assert_eq!(found, distance > 0.0, "{name} {corners:?} {p:?} {q:?}");
                }
            }
        }
    }
}

#[test]
fn sides_are_those_of_all_cells_of_a_facet() {
    let medial = with_labels(Shape::Torus, 0.1, Default::default());
    let facets = medial.dual().facets().unwrap();
    let of = |side, rule| selected(&medial, &MedialFilter { side, rule, ..BOTH });
    for rule in [MedialRule::Every, MedialRule::AngleOrRatio] {
        let [outer, inner, both] =
            [Side::Outer, Side::Inner, Side::Both].map(|side| of(side, rule));
        let [inner, outer] = [inner, outer].map(|set| set.into_iter().collect::<BTreeSet<_>>());
        for &facet in &both {
            let ring = facets.ring(facet as usize);
            let is_inner = |&cell: &u32| medial.labels().unwrap().is_inner()[cell as usize];
            let open = facets.is_unbounded(facet as usize);
            assert_eq!(inner.contains(&facet), ring.iter().all(is_inner) && !open);
            assert_eq!(outer.contains(&facet), !ring.iter().any(is_inner));
        }
        assert!(inner.len() > 100 && outer.len() > 100);
    }
    // The inner axis lies round the core circle, the outer one does not.
    let job = Job::default();
    let inner = medial.axis(&MedialFilter::default(), &job).unwrap();
    let core = |p: &[f64; 3]| Shape::Torus.inner_axis_distance(*p).unwrap();
    assert!(inner.vertices().iter().all(|p| core(p) < 0.15));
    let outer = medial.axis(&MedialFilter { side: Side::Outer, ..BOTH }, &job).unwrap();
    assert!(outer.vertices().iter().all(|p| core(p) > 0.4));
}

/// A torus as a mesh of a stirred grid.
pub fn torus_mesh([rows, columns]: [usize; 2]) -> Complex {
    let mut random = Random(13);
    let mut vertices = Vec::new();
    for i in 0..rows * columns {
        let mut angle = |k: usize, n: usize| (k as f64 + 0.3 * random.unit()) / n as f64 * TAU;
        let (u, v) = (angle(i / columns, rows), angle(i % columns, columns));
        let r = 1.0 + 0.4 * v.cos();
        vertices.push([r * u.cos(), r * u.sin(), 0.4 * v.sin()]);
    }
    let at = |i: usize, j: usize| (i % rows * columns + j % columns) as u32;
    let mut faces = Rows::default();
    for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
        faces.push(&[at(i, j), at(i + 1, j), at(i + 1, j + 1)]).unwrap();
        faces.push(&[at(i, j), at(i + 1, j + 1), at(i, j + 1)]).unwrap();
    }
    Complex::new(ComplexParts { vertices, faces, ..Default::default() }).unwrap()
}

#[test]
fn normals_of_a_mesh_give_nearly_the_same_axis() {
    let job = Job::default();
    let mesh = torus_mesh([120, 48]);
    let dual = dual_of(mesh.vertices(), &job);
    let of_rows = mesh.vertex_normals(&job).unwrap();
    let rows = dual.triangulation().row_of_vertex();
    let normals: Vec<_> = rows.iter().map(|&row| of_rows[row as usize]).collect();
    let by_poles = Medial::new(&dual, None, Default::default(), &job).unwrap();
    let set = |medial: &Medial| selected(medial, &BOTH).into_iter().collect::<BTreeSet<_>>();
    let poles = set(&by_poles);
    let by = |normals: Vec<[f64; 3]>| {
        let options = MedialOptions { normals: Some(normals), ..Default::default() };
        let medial = Medial::new(&dual, None, options, &job).unwrap();
        assert_valid(&medial, "normals");
        medial
    };
    let medial = by(normals.clone());
    let found = set(&medial);
    let differ = found.symmetric_difference(&poles).count();
    println!("{differ} of {} edges differ", poles.len());
    assert!(100 * differ < 2 * poles.len() && poles.len() > 1000);
    // Neither their lengths nor which way they point count.
    let turn = |(i, n): (usize, &[f64; 3])| n.map(|x| if i % 2 == 0 { -x } else { 3.0 * x });
    let turned = by(normals.iter().enumerate().map(turn).collect());
    assert!(turned.sines() == medial.sines() && turned.ratios() == medial.ratios());
    // Without a normal there is no umbrella, and nothing is chosen from there.
    let mut without = normals;
    without[7] = [0.0; 3];
    let without = by(without);
    assert!(without.umbrellas().rims_of(7).is_empty() && !without.umbrellas().is_disk()[7]);
    for (ends, sines) in dual.facets().unwrap().edges().iter().zip(without.sines()) {
        assert!((0..2).all(|i| ends[i] != 7 || sines[i] == f64::NEG_INFINITY));
    }
}

#[test]
fn bad_input_is_an_error_that_says_what() {
    let job = Job::default();
    let rows = sets::all(60).swap_remove(0).rows;
    let dual = dual_of(&rows, &job);
    let t = dual.triangulation();
    let fails = |dual: &Arc<Dual>, labels: Option<&Arc<Labels>>, options: MedialOptions| {
        let error = Medial::new(dual, labels, options, &Job::default()).unwrap_err();
        (error.status(), error.element())
    };
    let bare = Arc::new(Dual::new(t, DualOptions::default(), &job).unwrap());
    assert_eq!(fails(&bare, None, Default::default()), (Status::InvalidArgument, None));
    let regular = Triangulation::regular(t.points(), &vec![0.0; rows.len()], &job).unwrap();
    let power = Dual::new(&Arc::new(regular), DualOptions { facets: true }, &job).unwrap();
    assert_eq!(fails(&Arc::new(power), None, Default::default()), (Status::InvalidArgument, None));
    let other = dual_of(&samples(Shape::Torus, 0.2), &job);
    let foreign = labels_of(Shape::Torus, &other);
    assert_eq!(fails(&dual, Some(&foreign), Default::default()), (Status::Mismatch, None));
    // Labels of an equal triangulation will do.
    let equal = dual_of(&rows, &job);
    let labels = labels_of(Shape::Torus, &equal);
    Medial::new(&dual, Some(&labels), Default::default(), &job).unwrap();
    let with = |normals| MedialOptions { normals: Some(normals), ..Default::default() };
    let count = t.coords().len();
    assert_eq!(fails(&dual, None, with(vec![[1.0; 3]; count - 1])), (Status::Mismatch, None));
    let mut wrong = vec![[1.0; 3]; count];
    wrong[5][1] = f64::NAN;
    let at = Some((ElementKind::Vertex, 5));
    assert_eq!(fails(&dual, None, with(wrong)), (Status::InvalidArgument, at));
    let medial = Medial::new(&dual, None, Default::default(), &job).unwrap();
    let refused = [
        MedialFilter { side: Side::Inner, ..BOTH },
        MedialFilter { side: Side::Outer, ..BOTH },
        MedialFilter { theta: -0.1, ..BOTH },
        MedialFilter { theta: FRAC_PI_2, ..BOTH },
        MedialFilter { theta: f64::NAN, ..BOTH },
        MedialFilter { rho: -1.0, ..BOTH },
        MedialFilter { rho: f64::NAN, ..BOTH },
        MedialFilter { object_angle: -0.1, ..BOTH },
        MedialFilter { object_angle: 3.2, ..BOTH },
        MedialFilter { object_angle: f64::NAN, ..BOTH },
        MedialFilter { lambda: -1.0, ..BOTH },
        MedialFilter { lambda: f64::NAN, ..BOTH },
        MedialFilter { scale: -1.0, ..BOTH },
        MedialFilter { scale: f64::NAN, ..BOTH },
        // Scales were not asked for.
        MedialFilter { scale: 1.5, ..BOTH },
        MedialFilter { clip: Some([[0.0; 3], [1.0, 0.0, 1.0]]), ..BOTH },
        MedialFilter { clip: Some([[0.0; 3], [1.0, f64::INFINITY, 1.0]]), ..BOTH },
    ];
    for filter in refused {
        let status = |error: medax::Error| error.status();
        let selected = medial.selected(&filter, &job).map_err(status);
        assert_eq!(selected, Err(Status::InvalidArgument), "{filter:?}");
        let axis = medial.axis(&filter, &job).map(|_| ()).map_err(status);
        assert_eq!(axis, Err(Status::InvalidArgument), "{filter:?}");
    }
    let spent = Job::default();
    spent.cancel();
    let error = Medial::new(&dual, None, Default::default(), &spent).unwrap_err();
    assert_eq!(error.status(), Status::Cancelled);
}

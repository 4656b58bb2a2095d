//! Axes clipped to boxes: sound, without doubles, with all of what lies in the box.

use super::reach::{nearly_on_a_sphere, on_a_sphere};
use super::{BOTH, cross, dual_of, length, medial, minus};
use crate::sets::{self, Set};
use medax::complex::{Element, Values};
use medax::medial::{MedialFilter, MedialOptions, MedialRule};
use medax::{Complex, Job, Medial, NONE, Status};
use std::collections::{BTreeMap, BTreeSet};

const EVERY: MedialFilter = MedialFilter { rule: MedialRule::Every, ..BOTH };
const RULES: [MedialRule; 4] =
    [MedialRule::AngleOrRatio, MedialRule::Angle, MedialRule::Ratio, MedialRule::Every];

type Box = [[f64; 3]; 2];

fn lattice(side: usize) -> Vec<[f64; 3]> {
    let at = |i: usize| [i % side, i / side % side, i / side / side].map(|x| x as f64);
    (0..side * side * side).map(at).collect()
}

/// A lattice with the centres of its cubes.
fn body_centred(side: usize) -> Vec<[f64; 3]> {
    let mut rows = lattice(side);
    rows.extend(lattice(side - 1).into_iter().map(|p| p.map(|x| x + 0.5)));
    rows
}

fn cube(low: f64, high: f64) -> Box {
    [[low; 3], [high; 3]]
}

fn axis(medial: &Medial, filter: &MedialFilter) -> Complex {
    medial.axis(filter, &Job::default()).unwrap()
}

fn corners(axis: &Complex, face: &[u32]) -> Vec<[f64; 3]> {
    face.iter().map(|&v| axis.vertices()[v as usize]).collect()
}

fn area(ring: &[[f64; 3]]) -> f64 {
    let fan =
        (1..ring.len() - 1).map(|i| cross(minus(ring[i], ring[0]), minus(ring[i + 1], ring[0])));
    length(fan.fold([0.0; 3], |sum, n| [0, 1, 2].map(|k| sum[k] + n[k]))) / 2.0
}

fn numbers(axis: &Complex, element: Element, name: &str) -> Vec<f64> {
    match axis.attribute(element, name).unwrap().values() {
        Values::F64(values) => values.clone(),
        Values::U32(values) => values.iter().map(|&x| f64::from(x)).collect(),
    }
}

/// That the complex keeps what every complex promises, and what axes do besides.
fn assert_sound(axis: &Complex, clip: Option<Box>, name: &str) {
    let report = axis.validate(&Job::default()).unwrap();
    assert!(report.is_valid(), "{name}: {report:?}");
    let used: BTreeSet<u32> = axis.faces().iter().flatten().copied().collect();
    assert_eq!(used.len(), axis.vertices().len(), "{name}");
    for face in axis.faces().iter() {
        let distinct: BTreeSet<_> = face.iter().collect();
        assert!(distinct.len() == face.len(), "{name}: {face:?}");
    }
    for attribute in axis.attributes() {
        if let Values::F64(values) = attribute.values() {
            assert!(values.iter().all(|x| x.is_finite()), "{name}: {}", attribute.name());
        }
    }
    if let Some([low, high]) = clip {
        let is_in = |p: &[f64; 3]| (0..3).all(|k| low[k] <= p[k] && p[k] <= high[k]);
        assert!(axis.vertices().iter().all(is_in), "{name}");
    }
}

/// That a box cuts no hole: a side of a face that does not lie in the box's surface has three faces or more.
fn assert_closed(axis: &Complex, [low, high]: Box, name: &str) {
    let mut sides: BTreeMap<[u32; 2], usize> = BTreeMap::new();
    for face in axis.faces().iter() {
        for (i, &a) in face.iter().enumerate() {
            let b = face[(i + 1) % face.len()];
            *sides.entry([a.min(b), a.max(b)]).or_default() += 1;
        }
    }
    let in_surface = |[a, b]: [[f64; 3]; 2]| {
        (0..3).any(|k| [low[k], high[k]].iter().any(|&x| a[k] == x && b[k] == x))
    };
    for (&side, &count) in &sides {
        let ends = side.map(|v| axis.vertices()[v as usize]);
        assert!(count >= 3 || in_surface(ends), "{name}: {count} faces at {ends:?}");
    }
}

fn boxes(rows: &[[f64; 3]]) -> Vec<Box> {
    let extreme = |pick: fn(f64, f64) -> f64| {
        [0, 1, 2].map(|k| rows.iter().map(|p| p[k]).reduce(pick).unwrap())
    };
    let (low, high) = (extreme(f64::min), extreme(f64::max));
    let at = |share: f64| [0, 1, 2].map(|k| low[k] + share * (high[k] - low[k]));
    vec![
        [low, high],
        [at(-0.1), at(1.1)],
        [at(-1e6), at(1e6)],
        [at(0.25), at(0.5)],
        [at(0.125), at(0.625)],
        [at(0.3), at(0.9)],
        [at(1.5), at(4.0)],
        [low, at(0.5)],
    ]
}

#[test]
fn axes_of_degenerate_sets_are_sound() {
    let mut all = sets::all(180);
    let mut add = |name, rows| all.push(Set { name, rows });
    add("lattice", lattice(5));
    add("body-centred lattice", body_centred(4));
    add("integer sphere", on_a_sphere(50));
    add("nearly a sphere", nearly_on_a_sphere(150));
    add("cube", lattice(2));
    let axes = [0, 1, 2].map(|k| [0, 1, 2].map(|i| f64::from(u8::from(i == k))));
    add("octahedron", axes.iter().flat_map(|&p| [p, p.map(|x| -x)]).collect());
    add("tetrahedron", [[0.0; 3]].into_iter().chain(axes).collect());
    for Set { name, rows } in all {
        let medial = medial(&rows);
        for rule in RULES {
            let filter = MedialFilter { rule, ..BOTH };
            assert_sound(&axis(&medial, &filter), None, name);
            for clip in boxes(&rows) {
                let clipped = axis(&medial, &MedialFilter { clip: Some(clip), ..filter });
                assert_sound(&clipped, Some(clip), &format!("{name} in {clip:?}"));
            }
        }
    }
}

#[test]
fn what_a_box_leaves_of_a_lattice_has_an_area_and_no_double() {
    let flush = [[0.5, 0.5, 0.0], [2.5, 2.0, 2.0]];
    for clip in [cube(0.0, 2.0), cube(0.5, 2.5), flush, cube(-0.7, 4.7), cube(-90.0, 90.0)] {
        let name = format!("{clip:?}");
        for side in [4, 5] {
            let clipped =
                axis(&medial(&lattice(side)), &MedialFilter { clip: Some(clip), ..EVERY });
            assert_sound(&clipped, Some(clip), &name);
            assert_closed(&clipped, clip, &name);
            let places: BTreeSet<_> =
                clipped.vertices().iter().map(|p| p.map(|x| (x + 0.0).to_bits())).collect();
            assert_eq!(places.len(), clipped.vertices().len(), "{name}");
            let areas = clipped.faces().iter().map(|face| area(&corners(&clipped, face)));
            let areas: Vec<f64> = areas.inspect(|&area| assert!(area > 0.2, "{name}")).collect();
            // The planes half way between the samples, as far as they lie in the box.
            let [low, high] = clip;
            let mut right = 0.0;
            for k in 0..3 {
                let section: f64 = (0..3).filter(|&i| i != k).map(|i| high[i] - low[i]).product();
                let planes = (1..side).map(|i| i as f64 - 0.5);
                right += section * planes.filter(|&x| low[k] <= x && x <= high[k]).count() as f64;
            }
            let total: f64 = areas.iter().sum();
            assert!((total - right).abs() < 1e-12 * right, "{name}: {total}, not {right}");
        }
    }
}

#[test]
fn rays_of_one_face_of_the_hull_are_one() {
    // Each square of the hull has two triangles: with a vertex and a ray for both there would be a face without area, and doubles.
    let rows = lattice(2);
    let medial = medial(&rows);
    let clipped = axis(&medial, &MedialFilter { clip: Some(cube(-1.0, 2.0)), ..EVERY });
    // The centre, six rays, and twelve edges of the box.
    assert_eq!(clipped.faces().len(), 12);
    assert_eq!(clipped.vertices().len(), 1 + 6 + 12);
    // The cells of triangles in one plane, but of different circles, keep theirs.
    let mut long = rows.clone();
    long.extend(rows.iter().map(|p| [3.0 + p[0], p[1], p[2]]));
    let clipped =
        axis(&super::medial(&long), &MedialFilter { clip: Some(cube(-9.0, 9.0)), ..EVERY });
    assert_sound(&clipped, Some(cube(-9.0, 9.0)), "two cubes");
    // The planes x = 0.5, 2 and 3.5, y = 0.5, z = 0.5.
    let total: f64 = clipped.faces().iter().map(|face| area(&corners(&clipped, face))).sum();
    assert!((total - 5.0 * 18.0 * 18.0).abs() < 1e-9 * total, "{total}");
}

#[test]
fn a_plane_through_voronoi_vertices_makes_no_double() {
    let medial = medial(&body_centred(5));
    for clip in [cube(0.0, 4.0), cube(0.0, 2.0), cube(0.25, 2.5), cube(0.75, 2.25)] {
        let clipped = axis(&medial, &MedialFilter { clip: Some(clip), ..EVERY });
        assert_sound(&clipped, Some(clip), "body-centred lattice");
        assert_closed(&clipped, clip, "body-centred lattice");
        let places: BTreeSet<_> =
            clipped.vertices().iter().map(|p| p.map(|x| (x + 0.0).to_bits())).collect();
        assert_eq!(places.len(), clipped.vertices().len(), "{clip:?}");
        assert!(clipped.faces().iter().all(|face| area(&corners(&clipped, face)) > 1e-3));
    }
}

#[test]
fn boxes_cut_no_holes() {
    for (name, rows) in [
        ("random", sets::all(200).swap_remove(0).rows),
        ("ellipsoid", sets::all(200).swap_remove(2).rows),
        ("body-centred lattice", body_centred(4)),
        ("integer sphere", on_a_sphere(50)),
    ] {
        let medial = medial(&rows);
        let coords = medial.dual().triangulation().coords();
        for clip in boxes(&rows) {
            let clipped = axis(&medial, &MedialFilter { clip: Some(clip), ..EVERY });
            assert_closed(&clipped, clip, name);
            // Balls round corners have their samples on them, and none within.
            let radii = numbers(&clipped, Element::Vertex, "radius");
            for (&at, radius) in clipped.vertices().iter().zip(radii) {
                let nearest = coords.iter().map(|&p| length(minus(p, at)));
                let nearest = nearest.fold(f64::INFINITY, f64::min);
                assert!((nearest - radius).abs() <= 1e-9 * radius, "{name} {at:?} {radius}");
            }
        }
    }
}

#[test]
fn a_box_that_holds_all_bounded_facets_leaves_them_as_they_are() {
    let rows = sets::all(300).swap_remove(0).rows;
    let medial = medial(&rows);
    let clip = cube(-1e9, 1e9);
    let [whole, clipped] =
        [None, Some(clip)].map(|clip| axis(&medial, &MedialFilter { clip, ..EVERY }));
    let facets = medial.dual().facets().unwrap();
    let of = |axis: &Complex| -> BTreeMap<u64, Vec<[f64; 3]>> {
        let numbers = numbers(axis, Element::Face, "facet");
        let bounded = numbers.iter().zip(axis.faces().iter());
        let bounded = bounded.filter(|(facet, _)| !facets.is_unbounded(**facet as usize));
        bounded.map(|(&facet, face)| (facet as u64, corners(axis, face))).collect()
    };
    assert_eq!(of(&whole), of(&clipped));
    assert!(clipped.faces().len() > whole.faces().len());
}

#[test]
fn the_largest_boxes_and_farthest_centres_give_finite_vertices() {
    let largest = 2f64.powi(200);
    let mut far: Vec<[f64; 3]> = lattice(3);
    // Cells so flat that their centres lie beyond every number, and near ones.
    for (i, tiny) in [2f64.powi(-150), 2f64.powi(-100), 2f64.powi(-52)].into_iter().enumerate() {
        far.push([0.2 + i as f64 * 0.3, 0.1, tiny]);
        far.push([largest * tiny, 0.3, 2.0 - 0.1 * i as f64]);
    }
    far.extend([[largest, 0.0, 0.0], [0.0, -largest, 1.0], [0.25, 0.5, largest / 3.0]]);
    let hollow = [[0.0; 3], [largest, 0.0, 0.0], [0.0, largest, 0.0], [1.0, 1.0, 2f64.powi(-160)]];
    let random = sets::all(200).swap_remove(0).rows;
    let flat: Vec<_> = random.iter().map(|&[x, y, z]| [x, y, z * 2f64.powi(-100)]).collect();
    for (name, rows) in
        [("random", random), ("far", far), ("flat", flat), ("hollow", hollow.to_vec())]
    {
        let job = Job::default();
        let medial =
            Medial::new(&dual_of(&rows, &job), None, MedialOptions::default(), &job).unwrap();
        assert!(medial.reaches().as_flattened().iter().all(|x| !x.is_nan()), "{name}");
        assert_sound(&axis(&medial, &EVERY), None, name);
        for size in [1e-60, 0.3, 1.0, 1e30, largest] {
            for clip in
                [cube(-size, size), [[-size, 0.0, 0.0], [0.5 * size, size, 2.0 * size.min(0.5)]]]
            {
                let clipped = axis(&medial, &MedialFilter { clip: Some(clip), ..EVERY });
                assert_sound(&clipped, Some(clip), &format!("{name} in {clip:?}"));
            }
        }
    }
}

#[test]
fn edges_between_centres_beyond_all_squares_are_cut_where_they_pass() {
    let unit = 2f64.powi(197);
    // Nearly in a plane: near it the diagram is that of the plane, and Voronoi vertices are far above and below.
    let areas = |height: f64| {
        let rows = [
            [0.0, 0.0, 0.0],
            [4.0, 0.0, 0.0],
            [0.0, 4.0, 0.0],
            [5.0, 5.0, 1.0],
            [-3.0, -2.0, -1.0],
        ];
        let medial = medial(&rows.map(|[x, y, z]| [x * unit, y * unit, z * height]));
        let centers = medial.dual().centers().iter();
        let farthest = centers.fold(0.0, |most: f64, center| most.max(center[2].abs()));
        let clip = [[-3.0, -3.0, -1.0], [4.0, 4.0, 2.0]].map(|p| p.map(|x| x * unit));
        let clipped = axis(&medial, &MedialFilter { clip: Some(clip), ..EVERY });
        assert_sound(&clipped, Some(clip), "flat");
        assert_closed(&clipped, clip, "flat");
        let rows = medial.dual().triangulation().row_of_vertex().to_vec();
        let samples = numbers(&clipped, Element::Face, "samples");
        let pairs = samples.chunks(2).map(|pair| {
            let [a, b] = [0, 1].map(|i| rows[pair[i] as usize]);
            [a.min(b), a.max(b)]
        });
        let scaled = |face: &[u32]| {
            area(&corners(&clipped, face).iter().map(|p| p.map(|x| x / unit)).collect::<Vec<_>>())
        };
        let areas: BTreeMap<_, _> = pairs.zip(clipped.faces().iter().map(scaled)).collect();
        (areas, farthest)
    };
    let (near, _) = areas(unit * 2f64.powi(-40));
    let (far, farthest) = areas(2f64.powi(-160));
    assert!(farthest > 2f64.powi(540) && near.len() > 5, "{farthest} {near:?}");
    assert!(near.keys().eq(far.keys()), "{near:?} {far:?}");
    for (pair, area) in &near {
        assert!((far[pair] - area).abs() < 1e-9 * area, "{pair:?}: {area} {}", far[pair]);
    }
}

#[test]
fn facets_between_samples_nearly_on_a_line_fill_the_box() {
    let (unit, height) = (2f64.powi(197), 2f64.powi(-160));
    let offsets =
        [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [-2.0, 1.0], [0.0, -3.0], [1.0, -1.0]];
    let at = |(i, [y, z]): (usize, [f64; 2])| [unit * i as f64, y * height, z * height];
    let rows: Vec<_> = offsets.into_iter().enumerate().map(at).collect();
    let medial = medial(&rows);
    // Voronoi vertices are so far away in two directions that products of their coordinates overflow.
    let is_far = |center: &&[f64; 3]| center[1].abs().min(center[2].abs()) > 2f64.powi(530);
    assert!(medial.dual().centers().iter().filter(is_far).count() > 2);
    let clip = [[-1.0, -4.0, -2.0], [7.0, 4.0, 1.0]].map(|p| p.map(|x| x * unit));
    let clipped = axis(&medial, &MedialFilter { clip: Some(clip), ..EVERY });
    assert_sound(&clipped, Some(clip), "line");
    assert_eq!(clipped.faces().len(), offsets.len() - 1);
    for face in clipped.faces().iter() {
        let ring: Vec<_> = corners(&clipped, face).iter().map(|p| p.map(|x| x / unit)).collect();
        assert!((area(&ring) - 24.0).abs() < 1e-9, "{ring:?}");
    }
}

#[test]
fn a_box_out_of_range_is_refused() {
    let medial = medial(&lattice(3));
    for far in [2f64.powi(200).next_up(), 1e160, f64::MAX] {
        for clip in [cube(-far, 1.0), cube(-1.0, far)] {
            let filter = MedialFilter { clip: Some(clip), ..BOTH };
            let error = medial.axis(&filter, &Job::default()).unwrap_err();
            assert_eq!(error.status(), Status::CoordinateRange);
            assert!(error.to_string().contains("beyond 2^200"), "{error}");
            let error = medial.selected(&filter, &Job::default()).unwrap_err();
            assert_eq!(error.status(), Status::CoordinateRange);
        }
    }
}

#[test]
fn corners_in_a_plane_of_the_box_are_voronoi_vertices() {
    let medial = medial(&lattice(5));
    let clipped = axis(&medial, &MedialFilter { clip: Some(cube(0.5, 2.5)), ..EVERY });
    // The Voronoi vertices are the multiples of a half: every corner is one.
    let cells = numbers(&clipped, Element::Vertex, "cell");
    assert!(cells.iter().all(|&cell| cell != f64::from(NONE)));
    assert_eq!((clipped.vertices().len(), clipped.faces().len()), (27, 36));
}

//! Flattening: each step replayed by brute force, and what must stay.

use super::shapes::*;
use medax::complex::{
    Attribute, CellType, ComplexParts, Element, FlattenOptions, Flattened, Values,
};
use medax::points::Points;
use medax::sample::{SampleOptions, Shape, sample};
use medax::{Complex, Job, JobOptions, NONE, PowerCrust, Status};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

fn flattened(complex: &Complex, flatness: f64) -> Flattened {
    let result = complex.flatten(FlattenOptions { flatness }, &Job::default()).unwrap();
    assert!(result.complex.validate(&Job::default()).unwrap().is_valid());
    result
}

fn betti(complex: &Complex) -> [u64; 3] {
    complex.topology(&Job::default()).unwrap().betti
}

fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| a[k] - b[k])
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    sub(a, b).iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// The distance of a point from the plane of a triangle, by Gram and Schmidt.
fn height(d: [f64; 3], [a, b, c]: [[f64; 3]; 3]) -> f64 {
    let dot = |u: [f64; 3], v: [f64; 3]| u.iter().zip(v).map(|(x, y)| x * y).sum::<f64>();
    let without = |u: [f64; 3], e: [f64; 3]| {
        let share = dot(u, e) / dot(e, e);
        [0, 1, 2].map(|k| u[k] - share * e[k])
    };
    let e = sub(b, a);
    let f = without(sub(c, a), e);
    distance(without(without(sub(d, a), e), f), [0.0; 3])
}

/// The altitude over the triangle opposite each corner, and the least relative to the longest edge.
fn altitudes(complex: &Complex, cell: &[u32]) -> ([f64; 4], f64) {
    let at = |i: usize| complex.vertices()[cell[i] as usize];
    let altitudes = std::array::from_fn(|i| {
        let mut others = (0..4).filter(|&k| k != i).map(at);
        height(at(i), std::array::from_fn(|_| others.next().unwrap()))
    });
    let edges = (0..4).flat_map(|i| (0..i).map(move |j| distance(at(i), at(j))));
    (altitudes, altitudes.into_iter().fold(f64::MAX, f64::min) / edges.fold(0.0, f64::max))
}

fn sorted<const N: usize>(row: &[u32]) -> [u32; N] {
    let mut row: [u32; N] = row.try_into().unwrap();
    row.sort_unstable();
    row
}

/// The triangles of a complex, listed or not, with the tetrahedra at each.
fn triangles(complex: &Complex) -> BTreeMap<[u32; 3], BTreeSet<[u32; 4]>> {
    let mut triangles = BTreeMap::new();
    for face in complex.faces().iter() {
        triangles.insert(sorted(face), BTreeSet::new());
    }
    for cell in complex.cells().iter() {
        for i in 0..4 {
            let mut facet = cell.to_vec();
            facet.remove(i);
            let at: &mut BTreeSet<_> = triangles.entry(sorted(&facet)).or_default();
            at.insert(sorted(cell));
        }
    }
    triangles
}

/// Replays the collapses of a complex of triangles and tetrahedra, and checks that each is elementary, of a flat tetrahedron, and in order;
/// that no flat tetrahedron is left that has a free triangle; and that the result is what the replay leaves.
fn replay(complex: &Complex, limit: f64) -> Flattened {
    let result = flattened(complex, limit);
    let mut left = triangles(complex);
    let flat: BTreeMap<[u32; 4], Vec<u32>> = (complex.cells().iter())
        .filter(|cell| altitudes(complex, cell).1 <= limit)
        .map(|cell| (sorted(cell), cell.to_vec()))
        .collect();
    let free = |left: &BTreeMap<[u32; 3], BTreeSet<[u32; 4]>>| -> Vec<f64> {
        let lone = left.iter().filter(|(_, at)| at.len() == 1);
        let of = |(triangle, at): (&[u32; 3], &BTreeSet<[u32; 4]>)| {
            let cell = flat.get(at.first().unwrap())?;
            let opposite = cell.iter().position(|v| !triangle.contains(v)).unwrap();
            Some(altitudes(complex, cell).0[opposite])
        };
        lone.filter_map(of).collect()
    };
    for (step, &[row, corner]) in result.collapses.iter().enumerate() {
        let cell = complex.cells().row(row as usize);
        let corners = sorted::<4>(cell);
        assert!(flat.contains_key(&corners), "step {step}: the tetrahedron is not flat");
        let opposite = cell.iter().position(|&v| v == corner).unwrap();
        if step % result.collapses.len().div_ceil(20) == 0 {
            let altitude = altitudes(complex, cell).0[opposite];
            let least = free(&left).into_iter().fold(f64::MAX, f64::min);
            assert!(altitude <= least * (1.0 + 1e-6) + 1e-9, "step {step}: {altitude}, {least}");
        }
        let others: Vec<u32> = cell.iter().copied().filter(|&v| v != corner).collect();
        let at = left.remove(&sorted(&others)).expect("the triangle went before");
        assert!(at.len() == 1 && at.contains(&corners), "step {step} is not elementary");
        for i in 0..4 {
            let mut facet = cell.to_vec();
            facet.remove(i);
            if let Some(at) = left.get_mut(&sorted(&facet)) {
                assert!(at.remove(&corners));
            }
        }
    }
    assert!(free(&left).is_empty());
    assert_eq!(triangles(&result.complex), left);
    let cells = complex.cells().iter().map(sorted);
    let cells: BTreeSet<[u32; 4]> = left.values().flatten().copied().chain(cells).collect();
    let gone: BTreeSet<[u32; 4]> = result
        .collapses
        .iter()
        .map(|&[row, _]| sorted(complex.cells().row(row as usize)))
        .collect();
    assert_eq!(gone.len(), result.collapses.len());
    assert_eq!(result.left, flat.len() - gone.len());
    let kept: BTreeSet<[u32; 4]> = result.complex.cells().iter().map(sorted).collect();
    assert_eq!(kept, cells.difference(&gone).copied().collect());
    assert_eq!(result.complex.vertices(), complex.vertices());
    assert_eq!(result.complex.edges(), complex.edges());
    assert_eq!(betti(&result.complex), betti(complex));
    result
}

/// A box of tetrahedra whose corners are stirred, without some of its cubes; all triangles listed.
fn stirred(n: [u32; 3], seed: u64, keep: impl Fn([u32; 3]) -> bool) -> Complex {
    let mut random = Random(seed);
    let mut solid = cubes(n, keep);
    for p in &mut solid.vertices {
        // Flat along one axis.
        *p = [p[0], p[1], 0.1 * p[2]].map(|x| x + 0.05 * random.unit());
    }
    let listed = triangles(&solid.build()).into_keys().map(|t| t.to_vec());
    solid.faces.extend(listed);
    solid.build()
}

#[test]
fn a_tetrahedron_loses_its_largest_triangle() {
    // The last corner is over the middle of the others.
    let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [1.0, 1.0, 0.1]];
    for listed in [true, false] {
        let mut one = Builder::new(4).tets(&[[0, 1, 2, 3]]).place(|i| corners[i]);
        if listed {
            one = one.faces(&TETRAHEDRON);
        }
        let result = replay(&one.build(), 0.05);
        assert_eq!((&result.collapses[..], result.left), (&[[0, 3]][..], 0));
        let faces: BTreeSet<[u32; 3]> = result.complex.faces().iter().map(sorted).collect();
        assert_eq!(faces, BTreeSet::from([[0, 1, 3], [0, 2, 3], [1, 2, 3]]));
        assert!(result.complex.cells().is_empty() && result.complex.cell_types().is_empty());
        // The altitude is 0.1, the longest edge the square root of 32.
        let limit = 0.1 / 32f64.sqrt();
        assert_eq!(replay(&one.build(), 1.001 * limit).collapses.len(), 1);
        assert_eq!(replay(&one.build(), 0.999 * limit).collapses.len(), 0);
        assert!(flattened(&one.build(), 0.999 * limit).complex == one.build());
    }
}

#[test]
fn tetrahedra_with_a_common_triangle_both_go() {
    let corners =
        [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [1.0, 1.0, 0.1], [1.0, 1.0, -0.2]];
    let two = Builder::new(5).tets(&[[0, 1, 2, 3], [0, 2, 1, 4]]).place(|i| corners[i]).build();
    let result = replay(&two, f64::INFINITY);
    // The triangle between them is not free at first: the flatter one loses another, and then the other one that.
    assert_eq!((result.collapses.len(), result.complex.faces().len()), (2, 5));
    assert_eq!((result.collapses[0][0], result.collapses[1]), (0, [1, 4]));
    // The flatter one alone: the triangle between them bounds the other one, and is not listed.
    let result = replay(&two, 0.02);
    assert_eq!((result.collapses.len(), result.complex.cells().len()), (1, 1));
    assert_eq!(result.complex.faces().len(), 2);
}

#[test]
fn a_flat_tetrahedron_between_others_is_left() {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.01], [0.0, 1.0, 0.0]];
    let mut all = corners.to_vec();
    all.extend([[0.3, 0.2, 2.0], [0.7, 0.6, 2.1], [0.2, 0.3, -2.0], [0.6, 0.7, -2.2]]);
    let cells = [[0, 1, 2, 3], [0, 1, 2, 4], [0, 2, 3, 5], [0, 1, 3, 6], [1, 2, 3, 7]];
    let fan = Builder::new(8).tets(&cells).place(|i| all[i]).build();
    let result = replay(&fan, 0.02);
    assert_eq!((result.collapses.len(), result.left), (0, 1));
    assert!(result.complex == fan);
    assert_eq!(replay(&fan, 1.0).collapses.len(), 5);
}

#[test]
fn what_closes_up_on_itself_stays() {
    // The boundary of a simplex of dimension four.
    let cells = [[1, 2, 3, 4], [0, 2, 3, 4], [0, 1, 3, 4], [0, 1, 2, 4], [0, 1, 2, 3]];
    let place = |i: usize| [i as f64, (i * i) as f64, (i * i * i) as f64];
    let sphere = Builder::new(5).tets(&cells).place(place).build();
    let result = flattened(&sphere, f64::INFINITY);
    assert_eq!((result.collapses.len(), result.left), (0, 5));
    assert!(result.complex == sphere);
}

/// An octahedron round another one, the space between them cut into prisms, and these into tetrahedra.
fn shell() -> Builder {
    let axes = |i: usize| (0..3).map(move |k| if i % 3 == k { 1.0 } else { 0.0 });
    let place = |i: usize| {
        let size = if i % 6 < 3 { 1.0 } else { -1.0 } * if i < 6 { 1.0 } else { 1.1 };
        let mut p = axes(i).map(|x| size * x);
        std::array::from_fn(|_| p.next().unwrap())
    };
    let mut cells = Vec::new();
    for signs in 0..8u32 {
        // Ascending, so that neighbouring prisms are cut alike.
        let mut ring = [0, 1, 2].map(|k| k + 3 * (signs >> k & 1));
        ring.sort_unstable();
        let [a, b, c] = ring;
        let [d, e, f] = ring.map(|v| v + 6);
        cells.extend([[a, b, c, f], [a, b, e, f], [a, d, e, f]]);
    }
    Builder::new(12).tets(&cells).place(place)
}

#[test]
fn a_void_stays_a_void() {
    let shell = shell().build();
    assert_eq!(betti(&shell), [1, 0, 1]);
    for limit in [0.02, 0.05, 0.1, f64::INFINITY] {
        let result = replay(&shell, limit);
        assert_eq!(betti(&result.complex), [1, 0, 1], "{limit}");
    }
    let result = flattened(&shell, f64::INFINITY);
    assert_eq!((result.collapses.len(), result.complex.cells().len()), (24, 0));
}

#[test]
fn stirred_boxes_keep_their_holes() {
    let middle = |p: [u32; 3]| p != [1, 1, 1];
    let pierced = |p: [u32; 3]| p[1] != 1 || p[2] != 1;
    for seed in 0..4 {
        let cases = [
            (stirred([3, 3, 3], seed, |_| true), [1, 0, 0]),
            (stirred([3, 3, 3], seed, middle), [1, 0, 1]),
            (stirred([2, 3, 3], seed, pierced), [1, 1, 0]),
        ];
        for (solid, expected) in cases {
            assert_eq!(betti(&solid), expected);
            let mut gone = Vec::new();
            for limit in [0.0, 0.03, 0.06, 0.1, 1.0] {
                gone.push(replay(&solid, limit).collapses.len());
            }
            assert!(gone.is_sorted() && gone[0] == 0, "{gone:?}");
            assert!(gone[1] < gone[3] && gone[4] == solid.cells().len(), "{gone:?}");
        }
    }
}

#[test]
fn attributes_follow_their_elements() {
    let mut parts = tetrahedron().tets(&[[0, 1, 2, 3]]).parts();
    parts.vertices.push([2.0, 2.0, 2.0]);
    let far = [[1, 2, 3, 4], [4, 3, 2, 1]];
    far.iter().for_each(|cell| parts.cells.push(cell).unwrap());
    parts.cell_types.extend([CellType::Tetrahedron; 2]);
    parts.edges = vec![[0, 4]];
    let attribute = |name, element, values| Attribute::new(name, element, 1, values).unwrap();
    parts.attributes = vec![
        attribute("number", Element::Vertex, Values::U32((0..5).collect())),
        attribute("loose", Element::Edge, Values::U32(vec![7])),
        attribute("face", Element::Face, Values::U32((0..4).collect())),
        attribute("share", Element::Face, Values::F64(vec![0.0, 0.125, 0.25, 0.375])),
        attribute("cell", Element::Cell, Values::U32((0..3).collect())),
    ];
    let complex = Complex::new(parts).unwrap();
    let values = |complex: &Complex, element, name| {
        complex.attribute(element, name).unwrap().values().clone()
    };
    // The cell that is listed twice goes with both rows; those of its triangles that were no faces have no values.
    let result = flattened(&complex, f64::INFINITY);
    assert_eq!(result.collapses.len(), 2);
    assert_eq!((result.complex.cells().len(), result.left), (0, 0));
    assert_eq!(values(&result.complex, Element::Cell, "cell"), Values::U32(vec![]));
    let (Values::U32(faces), Values::F64(shares)) = (
        values(&result.complex, Element::Face, "face"),
        values(&result.complex, Element::Face, "share"),
    ) else {
        panic!("other types");
    };
    assert_eq!(faces.len(), result.complex.faces().len());
    for (row, (&face, &share)) in faces.iter().zip(&shares).enumerate() {
        let ring = result.complex.faces().row(row);
        match face {
            NONE => assert!(share.is_nan() && ring.contains(&4)),
            face => {
                assert_eq!(ring, complex.faces().row(face as usize));
                assert_eq!(share, f64::from(face) / 8.0);
            }
        }
    }
    assert!(faces.contains(&NONE) && faces.iter().any(|&face| face != NONE));
    for (element, name) in [(Element::Vertex, "number"), (Element::Edge, "loose")] {
        assert_eq!(values(&result.complex, element, name), values(&complex, element, name));
    }
    // A triangle that another kind of cell has is not free.
    let pyramid = Builder {
        vertices: vec![[0.0; 3]; 6],
        cells: vec![
            (CellType::Pyramid, vec![0, 1, 2, 3, 4]),
            (CellType::Tetrahedron, vec![0, 1, 4, 5]),
        ],
        ..Builder::default()
    };
    let pyramid = pyramid.place(|i| [i as f64, (i * i % 5) as f64, (i * i * i % 7) as f64]).build();
    let result = flattened(&pyramid, f64::INFINITY);
    assert_eq!(result.complex.cell_types(), [CellType::Pyramid]);
    assert!(result.collapses[0][0] == 1 && result.collapses[0][1] != 5);
}

#[test]
fn scale_decides_nothing() {
    let solid = stirred([3, 3, 3], 5, |p| p != [1, 1, 1]);
    let expected = flattened(&solid, 0.06).collapses;
    assert!(expected.len() > 10);
    for exponent in [-900, -300, 300, 1000] {
        let parts = ComplexParts {
            vertices: solid.vertices().iter().map(|p| p.map(|x| x * 2f64.powi(exponent))).collect(),
            faces: solid.faces().clone(),
            cells: solid.cells().clone(),
            cell_types: solid.cell_types().to_vec(),
            ..ComplexParts::default()
        };
        assert_eq!(flattened(&Complex::new(parts).unwrap(), 0.06).collapses, expected);
    }
    // Where corners coincide all is flat.
    let point = Builder::new(4).tets(&[[0, 1, 2, 3]]).build();
    assert_eq!(flattened(&point, 0.0).collapses.len(), 1);
}

fn crust(rows: &[[f64; 3]]) -> PowerCrust {
    let points = Points::new(rows, Default::default(), &Job::default()).unwrap();
    PowerCrust::build(&Arc::new(points), Default::default(), &Job::default()).unwrap()
}

#[test]
fn power_shapes_keep_their_homotopy_type() {
    let mut random = Random(8);
    // Points without a surface, so that labels are mixed everywhere.
    let noise: Vec<_> = (0..1500).map(|_| std::array::from_fn(|_| random.unit())).collect();
    let samples =
        |shape| sample(shape, SampleOptions::default(), &Job::default()).unwrap().points().to_vec();
    for (name, rows) in [
        ("noise", noise),
        ("torus", samples(Shape::Torus)),
        ("bracket", samples(Shape::Bracket)),
        ("genus 3", samples(Shape::Genus3)),
    ] {
        let crust = crust(&rows);
        for shape in
            [crust.inner_shape(), crust.outer_shape(), &Arc::new(crust.both_shapes().unwrap())]
        {
            let Values::F64(flatness) =
                shape.attribute(Element::Cell, "flatness").unwrap().values().clone()
            else {
                panic!("another type")
            };
            for (row, flatness) in flatness.iter().enumerate() {
                let expected = altitudes(shape, shape.cells().row(row)).1;
                assert!((flatness - expected).abs() < 1e-7, "{name}: {flatness}, {expected}");
            }
            for limit in [0.1, 1.0] {
                let result = replay(shape, limit);
                assert!(result.collapses.len() > 50, "{name}");
                let threads = JobOptions { threads: 3, ..JobOptions::default() };
                let again = shape.flatten(FlattenOptions { flatness: limit }, &Job::new(threads));
                let again = again.unwrap();
                assert!(again.complex == result.complex && again.collapses == result.collapses);
            }
        }
    }
}

#[test]
fn nonsense_and_cancels_are_refused() {
    let solid = stirred([3, 3, 3], 5, |_| true);
    for flatness in [-0.1, f64::NAN] {
        let refused = solid.flatten(FlattenOptions { flatness }, &Job::default());
        assert_eq!(refused.unwrap_err().status(), Status::InvalidArgument);
    }
    let job = Job::default();
    job.cancel();
    let cancelled = solid.flatten(FlattenOptions::default(), &job);
    assert_eq!(cancelled.unwrap_err().status(), Status::Cancelled);
    let job = Job::new(JobOptions { memory_ceiling: 20_000, ..JobOptions::default() });
    let refused = solid.flatten(FlattenOptions::default(), &job);
    assert_eq!(refused.unwrap_err().status(), Status::OutOfMemory);
    let empty = Builder::new(0).build();
    let nothing = empty.flatten(FlattenOptions::default(), &Job::default()).unwrap();
    assert!(nothing.complex == empty && nothing.collapses.is_empty());
}

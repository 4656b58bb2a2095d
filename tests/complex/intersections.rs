//! Triangles that intersect: known complexes, and random ones against clipping in rationals.

use super::shapes::*;
use medax::complex::ComplexParts;
use medax::{Complex, ElementKind, Job, JobOptions, Status};
use num_rational::Ratio;

type Number = Ratio<i128>;
type Vector = [Number; 3];

fn pairs(complex: &Complex) -> Vec<[u32; 2]> {
    complex.self_intersections(&Job::default()).unwrap()
}

fn sub(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn dot(a: Vector, b: Vector) -> Number {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
}

fn is_zero(a: Vector) -> bool {
    dot(a, a) == Number::from(0)
}

/// The corners of the part of a convex polygon where `normal` times the way from `origin` is not negative.
fn clipped(polygon: &[Vector], normal: Vector, origin: Vector) -> Vec<Vector> {
    let zero = Number::from(0);
    let mut kept = Vec::new();
    for (i, &p) in polygon.iter().enumerate() {
        let q = polygon[(i + 1) % polygon.len()];
        let [at_p, at_q] = [p, q].map(|x| dot(normal, sub(x, origin)));
        if at_p >= zero {
            kept.push(p);
        }
        if at_p * at_q < zero {
            let part = at_p / (at_p - at_q);
            kept.push([0, 1, 2].map(|k| p[k] + part * (q[k] - p[k])));
        }
    }
    kept.dedup();
    kept
}

/// The half spaces, normal and origin, whose intersection is a triangle, a segment or a point.
fn half_spaces([a, b, c]: [Vector; 3]) -> Vec<[Vector; 2]> {
    let axes = [0, 1, 2].map(|k| [0, 1, 2].map(|i| Number::from(i128::from(i == k))));
    let normal = cross(sub(b, a), sub(c, a));
    let mut found = Vec::new();
    let mut both = |n: Vector, at| found.extend([[n, at], [n.map(|x| -x), at]]);
    if !is_zero(normal) {
        both(normal, a);
        found.extend([[a, b], [b, c], [c, a]].map(|[p, q]| [cross(normal, sub(q, p)), p]));
        return found;
    }
    // The two corners that are farthest apart are its ends.
    let length = |&[p, q]: &[Vector; 2]| dot(sub(q, p), sub(q, p));
    let [p, q] = [[a, b], [b, c], [c, a]].into_iter().max_by_key(length).unwrap();
    let along = sub(q, p);
    match is_zero(along) {
        true => axes.into_iter().for_each(|axis| both(axis, p)),
        false => {
            axes.into_iter().for_each(|axis| both(cross(along, axis), p));
            found.extend([[along, p], [along.map(|x| -x), q]]);
        }
    }
    found
}

/// Whether two triangles intersect, from all that they have in common.
fn expected(vertices: &[[i8; 3]], s: [u32; 3], t: [u32; 3]) -> bool {
    let at = |v: u32| vertices[v as usize].map(|x| Number::from(i128::from(x)));
    let mut common = s.map(at).to_vec();
    for [normal, origin] in half_spaces(t.map(at)) {
        common = clipped(&common, normal, origin);
    }
    let mut shared: Vec<u32> = s.into_iter().filter(|v| t.contains(v)).collect();
    shared.sort_unstable();
    shared.dedup();
    let shared: Vec<Vector> = shared.into_iter().map(at).collect();
    let zero = Number::from(0);
    let is_allowed = |&p: &Vector| match shared[..] {
        [] => false,
        [a] => a == p,
        // On the segment: in line with its ends, and between them.
        [a, b] => is_zero(cross(sub(p, a), sub(p, b))) && dot(sub(p, a), sub(p, b)) <= zero,
        [a, b, c] => is_zero(cross(sub(b, a), sub(c, a))),
        _ => unreachable!(),
    };
    !common.iter().all(is_allowed)
}

/// Vertices on a small grid, several at a place, and triangles of them; some have a vertex twice, as a face may.
fn random_mesh(random: &mut Random) -> (Vec<[i8; 3]>, Vec<[u32; 3]>) {
    let size = 2 + random.below(4);
    let depth = 1 + random.below(size);
    let count = 4 + random.below(8);
    let vertices: Vec<[i8; 3]> = (0..count)
        .map(|_| [random.below(size), random.below(size), random.below(depth)].map(|x| x as i8))
        .collect();
    let mut triangles = Vec::new();
    for _ in 0..2 + random.below(20) {
        let mut corner = || random.below(count) as u32;
        let [a, b, c] = [corner(), corner(), corner()];
        // The fan of a ring a b a c has triangles with a vertex twice.
        match a == b || b == c {
            true => continue,
            false if a == c => triangles.push([a, b, a]),
            false => triangles.push([a, b, c]),
        }
    }
    (vertices, triangles)
}

/// A face cannot be a ring of two vertices twice over: what ends as it begins is made of a quadrilateral.
fn mesh(vertices: &[[i8; 3]], triangles: &[[u32; 3]], scale: [f64; 3]) -> (Complex, Vec<[u32; 3]>) {
    let mut parts = ComplexParts::default();
    let place = |p: &[i8; 3]| [0, 1, 2].map(|i| f64::from(p[i]) * scale[i]);
    parts.vertices = vertices.iter().map(place).collect();
    for &[a, b, c] in triangles {
        match a == c {
            true => parts.faces.push(&[a, b, a, (b + 1) % vertices.len() as u32]),
            false => parts.faces.push(&[a, b, c]),
        }
        .unwrap();
    }
    let complex = Complex::new(parts);
    // A quadrilateral may have a vertex twice in succession after all.
    let Ok(complex) = complex else { return (Complex::default(), Vec::new()) };
    let triangles = complex.triangles().to_vec();
    (complex, triangles)
}

#[test]
fn random_triangles_are_as_clipping_says() {
    let mut random = Random(5);
    let (mut touching, mut compared) = (0, 0);
    for round in 0..3000 {
        let (vertices, triangles) = random_mesh(&mut random);
        // A power of two for each axis changes no answer, up to the ends of the range.
        let scales = [[1.0; 3], [0.25, 2f64.powi(190), 2f64.powi(-150)]];
        let (complex, triangles) = mesh(&vertices, &triangles, scales[round % 2]);
        let mut wanted = Vec::new();
        for t in 0..triangles.len() {
            for s in 0..t {
                compared += 1;
                if expected(&vertices, triangles[s], triangles[t]) {
                    wanted.push([s as u32, t as u32]);
                }
            }
        }
        wanted.sort_unstable();
        touching += wanted.len();
        assert_eq!(pairs(&complex), wanted, "round {round}: {vertices:?} {triangles:?}");
    }
    assert!(touching > 10_000 && touching < compared - 10_000, "{touching} of {compared}");
}

/// A cube of side 2 about a point, its squares cut into two triangles.
fn cube(middle: [f64; 3]) -> Builder {
    let quads =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let corner = |i: usize| [0, 1, 2].map(|k| middle[k] + [-1.0, 1.0][i >> k & 1]);
    Builder::new(8).faces(&quads).place(corner)
}

#[test]
fn surfaces_that_touch_nothing_but_their_neighbours_have_none() {
    assert!(pairs(&tetrahedron().build()).is_empty());
    assert!(pairs(&cube([0.0; 3]).build()).is_empty());
    assert!(pairs(&cube([0.0; 3]).and(&cube([3.0, 0.0, 0.0])).build()).is_empty());
    // One within the other.
    assert!(pairs(&cube([0.0; 3]).and(&tetrahedron()).build()).len() > 2);
    let inner =
        tetrahedron().place(|i| [[0.0; 3], [0.5, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, 0.5]][i]);
    assert!(pairs(&cube([0.0; 3]).and(&inner).build()).is_empty());
    assert!(pairs(&Builder::new(3).build()).is_empty());
}

#[test]
fn a_spike_through_a_cube_meets_what_it_passes() {
    // A thin triangle through the bottom and the top, off the diagonals: one triangle of either.
    let spike = Builder::new(3).faces(&[[0, 1, 2]]);
    let spike = spike.place(|i| [[0.5, 0.25, -3.0], [0.5, 0.25, 3.0], [0.5, 0.3, 3.0]][i]);
    assert_eq!(pairs(&cube([0.0; 3]).and(&spike).build()).len(), 2);
    // On the diagonal of the bottom: both of its triangles, one of the top.
    let spike = spike.place(|i| [[0.5, 0.5, -3.0], [0.5, 0.5, 0.0], [0.5, 0.6, 0.0]][i]);
    let found = pairs(&cube([0.0; 3]).and(&spike).build());
    assert_eq!(found, [[0, 12], [1, 12]]);
}

#[test]
fn a_grid_of_sheets_meets_another_in_a_formula() {
    // n upright rectangles x = i + 1/2 and m rectangles z = j + 1/2 that all cross, each of two triangles. The line in which
    // two of them meet runs along y. It crosses both triangles of either, and in parts that overlap or touch, but for one pair.
    let sheet =
        |corners: [[f64; 3]; 4]| Builder::new(4).faces(&[[0, 1, 2, 3]]).place(|i| corners[i]);
    let (n, m) = (3, 4);
    let mut sheets = Builder::new(0);
    for i in 0..n {
        let x = f64::from(i) + 0.5;
        sheets = sheets.and(&sheet([[x, 0.0, 0.0], [x, 9.0, 0.0], [x, 9.0, 9.0], [x, 0.0, 9.0]]));
    }
    for j in 0..m {
        let z = f64::from(j) + 0.75;
        sheets = sheets.and(&sheet([[0.0, 0.0, z], [9.0, 0.0, z], [9.0, 9.0, z], [0.0, 9.0, z]]));
    }
    assert_eq!(pairs(&sheets.build()).len(), 3 * (n * m) as usize);
}

#[test]
fn a_strip_that_is_folded_intersects_itself_flat_only() {
    // Two squares on a common edge, the second at a right angle, on the first, or beside it.
    let strip = |x: f64, z: f64| {
        let place = [
            [0.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [x, 0.0, z],
            [x, 1.0, z],
        ];
        let strip = Builder::new(6).faces(&[[0, 2, 3], [0, 3, 1], [2, 4, 5], [2, 5, 3]]);
        pairs(&strip.place(|i| place[i]).build())
    };
    assert!(strip(1.0, 1.0).is_empty() && strip(2.0, 0.0).is_empty());
    assert!(strip(0.5, 1e-30).is_empty());
    // Triangles 0 and 2 have the vertex 2 in common and the triangle between the diagonals and the side below.
    assert_eq!(strip(0.5, 0.0), [[0, 2], [0, 3], [1, 2], [1, 3]]);
}

#[test]
fn duplicates_and_equal_places() {
    // The same triangle twice; another with the same corners, but vertices of its own.
    let twice = Builder::new(6).faces(&[[0, 1, 2], [2, 1, 0], [3, 4, 5]]);
    let twice = twice.place(|i| [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]][i % 3]);
    assert_eq!(pairs(&twice.build()), [[0, 1], [0, 2], [1, 2]]);
    // Without area they have nothing but their sides in common, which the first two share.
    let flat = twice.place(|i| [(i % 3) as f64, 0.0, 0.0]);
    assert_eq!(pairs(&flat.build()), [[0, 2], [1, 2]]);
    let points = flat.place(|_| [7.0; 3]);
    assert_eq!(pairs(&points.build()), [[0, 2], [1, 2]]);
    // A soup: neighbours touch along edges that they do not share.
    let soup = Builder::new(6).faces(&[[0, 1, 2], [3, 4, 5]]);
    let place = [
        [0.0; 3],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
    ];
    assert_eq!(pairs(&soup.place(|i| place[i]).build()), [[0, 1]]);
}

#[test]
fn the_triangles_of_a_face_are_compared() {
    // A dart: the fan from its tip is flat, that from a wing folds back.
    let dart = |ring: [u32; 4]| {
        let place = [[0.0, 0.0, 0.0], [4.0, -2.0, 0.0], [1.0, 0.0, 0.0], [4.0, 2.0, 0.0]];
        pairs(&Builder::new(4).faces(&[ring]).place(|i| place[i]).build())
    };
    assert!(dart([0, 1, 2, 3]).is_empty());
    assert_eq!(dart([1, 2, 3, 0]), [[0, 1]]);
}

#[test]
fn coordinates_out_of_range_are_refused() {
    for bad in [2f64.powi(-200), -2f64.powi(201)] {
        let mut triangle = Builder::new(4).faces(&[[0, 1, 2]]).place(|i| [i as f64, 1.0, 0.0]);
        triangle.vertices[3][1] = bad;
        assert!(pairs(&triangle.build()).is_empty());
        triangle.vertices[2][1] = bad;
        let error = triangle.build().self_intersections(&Job::default()).unwrap_err();
        assert_eq!(error.status(), Status::CoordinateRange);
        assert_eq!(error.element(), Some((ElementKind::Vertex, 2)));
    }
}

/// `n` triangles through one point, none with a vertex of another: all pairs intersect.
fn star(n: u32) -> Complex {
    let faces: Vec<[u32; 3]> = (0..n).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let mut random = Random(9);
    let mut star = Builder::new(3 * n as usize).faces(&faces);
    for i in 0..n as usize {
        let [p, q] = [0, 1].map(|_| [random.unit(), random.unit(), random.unit()].map(|x| x - 0.5));
        star.vertices[3 * i] = p;
        star.vertices[3 * i + 1] = q;
        star.vertices[3 * i + 2] = [0, 1, 2].map(|k| -2.0 * (p[k] + q[k]));
    }
    star.build()
}

#[test]
fn threads_change_nothing_and_the_ceiling_and_a_cancel_stop_it() {
    let n = 300;
    let complex = star(n);
    let mut all = Vec::new();
    for i in 0..n {
        all.extend((i + 1..n).map(|j| [i, j]));
    }
    for threads in [1, 2, 3] {
        let job = Job::new(JobOptions { threads, ..JobOptions::default() });
        assert_eq!(complex.self_intersections(&job).unwrap(), all);
    }
    let job = Job::new(JobOptions { memory_ceiling: 1 << 18, ..JobOptions::default() });
    assert_eq!(complex.self_intersections(&job).unwrap_err().status(), Status::OutOfMemory);
    let job = Job::default();
    job.cancel();
    assert_eq!(complex.self_intersections(&job).unwrap_err().status(), Status::Cancelled);
}

//! Topology: known complexes, and random ones against elimination over Z/2.

use super::shapes::*;
use medax::complex::{CellType, ComplexParts, Topology};
use medax::{Complex, Job, JobOptions, Status};
use std::collections::{BTreeMap, BTreeSet};

fn topology(builder: &Builder) -> Topology {
    builder.build().topology(&Job::default()).unwrap()
}

/// What the tests of known shapes ask.
#[derive(Debug, PartialEq)]
struct Known {
    betti: [u64; 3],
    euler: i64,
    loops: u64,
    genus: Option<u64>,
    closed: bool,
}

fn known(t: &Topology) -> Known {
    Known {
        betti: t.betti,
        euler: t.euler_characteristic,
        loops: t.boundary_loops,
        genus: t.genus,
        closed: t.closed,
    }
}

fn closed(betti: [u64; 3], euler: i64, genus: Option<u64>) -> Known {
    Known { betti, euler, loops: 0, genus, closed: true }
}

fn open(betti: [u64; 3], euler: i64, loops: u64, genus: Option<u64>) -> Known {
    Known { betti, euler, loops, genus, closed: false }
}

#[test]
fn closed_surfaces() {
    for quads in [false, true] {
        let torus = topology(&wrapped_grid(4, 5, false, quads));
        assert_eq!(known(&torus), closed([1, 2, 1], 0, Some(1)));
        assert!(torus.oriented);
        let klein = topology(&wrapped_grid(4, 5, true, quads));
        assert_eq!(known(&klein), closed([1, 2, 1], 0, None));
        assert!(!klein.oriented);
    }
    let sphere = topology(&tetrahedron());
    assert_eq!(known(&sphere), closed([1, 0, 1], 2, Some(0)));
    assert_eq!([sphere.vertices, sphere.edges, sphere.faces, sphere.cells], [4, 6, 4, 0]);
    assert!(sphere.oriented);
    assert_eq!(known(&topology(&projective_plane())), closed([1, 1, 1], 1, None));
    // Three squares on four vertices: half a cube's boundary, another projective plane. Two of
    // them have the same vertices, yet are different faces.
    let hemicube = Builder::new(4).faces(&[[0, 1, 2, 3], [0, 2, 3, 1], [0, 2, 1, 3]]);
    assert_eq!(known(&topology(&hemicube)), closed([1, 1, 1], 1, None));
    let mut two = wrapped_grid(3, 3, false, false).and(&tetrahedron());
    assert_eq!(known(&topology(&two)), closed([2, 2, 2], 2, Some(1)));
    // One face turned round spoils the orientation and nothing else.
    two.faces[7].reverse();
    let turned = topology(&two);
    assert_eq!(known(&turned), closed([2, 2, 2], 2, Some(1)));
    assert!(!turned.oriented);
}

#[test]
fn surfaces_with_boundary() {
    let disk = Builder::new(4).faces(&[[0, 1, 2], [0, 2, 3]]);
    let t = topology(&disk);
    assert_eq!(known(&t), open([1, 0, 0], 1, 1, Some(0)));
    assert_eq!((t.boundary_edges, t.oriented), (4, true));
    let annulus = topology(&band(5, false));
    assert_eq!(known(&annulus), open([1, 1, 0], 0, 2, Some(0)));
    let moebius = topology(&band(5, true));
    assert_eq!(known(&moebius), open([1, 1, 0], 0, 1, None));
    // A torus without two far triangles keeps its genus.
    let mut holes = torus(6, 6);
    holes.faces.remove(40);
    holes.faces.remove(0);
    assert_eq!(known(&topology(&holes)), open([1, 3, 0], -2, 2, Some(1)));
    // One square glued to itself along two sides: a band out of a single face.
    let bridge = Builder::new(6).faces(&[[0, 1, 2, 0, 3, 4, 5, 3]]);
    let t = topology(&bridge);
    assert_eq!(known(&t), open([1, 1, 0], 0, 2, Some(0)));
    assert_eq!((t.boundary_edges, t.edges, t.nonmanifold_vertices), (6, 7, 0));
}

#[test]
fn singular_surfaces() {
    let spheres = tetrahedron().and(&tetrahedron());
    let at_vertex = topology(&spheres.clone().glue(&[(4, 0)]));
    assert_eq!(known(&at_vertex), closed([2, 0, 2], 4, None));
    assert_eq!((at_vertex.nonmanifold_vertices, at_vertex.nonmanifold_edges), (1, 0));
    assert_eq!(at_vertex.isolated_vertices, 1);
    let at_edge = topology(&spheres.clone().glue(&[(4, 0), (5, 1)]));
    assert_eq!(known(&at_edge), closed([3, 0, 2], 5, None));
    assert_eq!((at_edge.nonmanifold_vertices, at_edge.nonmanifold_edges), (2, 1));
    assert!(at_edge.oriented);
    // Sharing a face, which is listed twice and counts once: a sphere with a wall.
    let at_face = topology(&spheres.glue(&[(4, 0), (5, 1), (6, 2)]));
    assert_eq!(known(&at_face), open([4, 0, 2], 6, 0, None));
    assert_eq!((at_face.faces, at_face.nonmanifold_edges), (7, 3));
    // Two triangles that touch in a vertex: the curves part there.
    let tie = topology(&Builder::new(5).faces(&[[0, 1, 2], [0, 3, 4]]));
    assert_eq!(known(&tie), open([1, 0, 0], 1, 2, None));
    assert_eq!(tie.nonmanifold_vertices, 1);
    // Three pages: one curve of boundary, but no surface.
    let book = topology(&Builder::new(5).faces(&[[0, 1, 2], [0, 1, 3], [0, 1, 4]]));
    assert_eq!(known(&book), open([1, 0, 0], 1, 1, None));
    assert_eq!((book.boundary_edges, book.nonmanifold_edges), (6, 1));
    assert_eq!((book.nonmanifold_vertices, book.oriented), (2, false));
    // A sphere with a disk across: three sheets on a common rim, two chambers.
    let chambers = Builder::new(5).faces(&[
        [0, 1, 2],
        [0, 1, 3],
        [1, 2, 3],
        [2, 0, 3],
        [0, 1, 4],
        [1, 2, 4],
        [2, 0, 4],
    ]);
    assert_eq!(topology(&chambers).betti, [1, 0, 2]);
    let dangling = topology(&Builder::new(4).faces(&[[0, 1, 2]]).edges(&[[2, 3]]));
    assert_eq!(known(&dangling), open([1, 0, 0], 1, 1, None));
    let ring = topology(&Builder::new(4).faces(&[[0, 1, 2]]).edges(&[[2, 3], [3, 0], [0, 1]]));
    assert_eq!(known(&ring), open([1, 1, 0], 0, 1, None));
    assert_eq!(ring.edges, 5);
}

#[test]
fn points_and_edges() {
    let none = topology(&Builder::new(0));
    assert_eq!(known(&none), open([0, 0, 0], 0, 0, None));
    assert!(!none.oriented);
    let points = topology(&Builder::new(3));
    assert_eq!(known(&points), open([3, 0, 0], 3, 0, None));
    assert_eq!(points.isolated_vertices, 3);
    let triangle = topology(&Builder::new(4).edges(&[[0, 1], [1, 2], [2, 0], [0, 2]]));
    assert_eq!(known(&triangle), open([2, 1, 0], 1, 0, None));
    assert_eq!((triangle.edges, triangle.components), (3, 2));
    // Isolated vertices count as components and leave the genus alone.
    let torus = topology(&torus(3, 4).and(&Builder::new(2)));
    assert_eq!(known(&torus), closed([3, 2, 1], 2, Some(1)));
}

#[test]
fn solids() {
    let tet = Builder::new(4).tets(&[[0, 1, 2, 3]]);
    let t = topology(&tet);
    assert_eq!(known(&t), open([1, 0, 0], 1, 0, None));
    assert_eq!([t.vertices, t.edges, t.faces, t.cells], [4, 6, 4, 1]);
    // With its facets listed the surface is seen, and the solid stays filled.
    let t = topology(&tet.clone().faces(&TETRAHEDRON));
    assert_eq!(known(&t), closed([1, 0, 0], 1, None));
    assert_eq!([t.faces, t.cells], [4, 1]);
    // The same cell twice is one cell.
    assert_eq!(topology(&tet.clone().tets(&[[3, 1, 0, 2]])).cells, 1);
    let ball = cubes([3, 3, 3], |_| true);
    assert_eq!(topology(&ball).betti, [1, 0, 0]);
    let ring = cubes([3, 3, 1], |p| p != [1, 1, 0]);
    assert_eq!(topology(&ring).betti, [1, 1, 0]);
    let shell = cubes([3, 3, 3], |p| p != [1, 1, 1]);
    assert_eq!(topology(&shell).betti, [1, 0, 1]);
    let skin = topology(&outer_facets(&shell));
    assert_eq!(known(&skin), closed([2, 0, 2], 4, Some(0)));
    assert!(skin.oriented);
    // Two cubes that touch along an edge: a closed surface all the same.
    let apart = cubes([2, 2, 1], |p| p[0] == p[1]);
    assert_eq!(topology(&apart).betti, [1, 0, 0]);
    let skin = topology(&outer_facets(&apart));
    assert!(skin.closed && skin.oriented && skin.nonmanifold_edges == 1 && skin.genus.is_none());
}

#[test]
fn pyramids() {
    let mut house = Builder::new(9);
    house.cells.push((CellType::Pyramid, vec![0, 1, 2, 3, 4]));
    house.cells.push((CellType::PolygonalPyramid, vec![3, 2, 1, 0, 5]));
    let t = topology(&house);
    // They share their base, whichever way round.
    assert_eq!([t.vertices, t.edges, t.faces, t.cells], [9, 12, 9, 2]);
    assert_eq!(t.betti, [4, 0, 0]);
    house.cells.push((CellType::PolygonalPyramid, vec![0, 1, 4, 6]));
    let t = topology(&house);
    assert_eq!([t.edges, t.faces, t.cells], [15, 12, 3]);
    house.cells.push((CellType::Tetrahedron, vec![1, 4, 6, 0]));
    assert_eq!(topology(&house), t);
    house.faces.push(vec![2, 3, 0, 1]);
    assert_eq!(topology(&house).faces, 12);
}

#[test]
fn closed_solids_that_fit_into_no_space() {
    // The boundary of the simplex in dimension 4: b3 = 1, from b0 - b1 + b2 - chi.
    let simplex = [[1, 2, 3, 4], [0, 2, 3, 4], [0, 1, 3, 4], [0, 1, 2, 4], [0, 1, 2, 3]];
    let t = topology(&Builder::new(5).tets(&simplex));
    assert_eq!((t.betti, t.euler_characteristic), ([1, 0, 0], 0));
    // Opposite sides of a box glued: the three-dimensional torus.
    let n = 3;
    let mut space = cubes([n, n, n], |_| true);
    let size = n + 1;
    let wrapped: Vec<(u32, u32)> = (0..size * size * size)
        .map(|i| [i / (size * size), i / size % size, i % size].map(|k| k % n))
        .enumerate()
        .map(|(i, p)| (i as u32, (p[0] * size + p[1]) * size + p[2]))
        .collect();
    space = space.glue(&wrapped);
    let t = topology(&space.compact());
    assert_eq!((t.betti, t.euler_characteristic), ([1, 3, 3], 0));
}

#[test]
fn disks_wrapped_round_a_circle() {
    // Attached with degree d: over Z/2 only its parity counts.
    let hat = topology(&wrapped_disk(&[1, 1, -1]));
    assert_eq!(known(&hat), open([1, 0, 0], 1, 0, None));
    // Contractible, but not one face is free.
    assert_eq!((hat.boundary_edges, hat.nonmanifold_edges), (0, 3));
    assert_eq!(topology(&wrapped_disk(&[1, 1])).betti, [1, 1, 1]);
    assert_eq!(topology(&wrapped_disk(&[1, 1, 1])).betti, [1, 0, 0]);
    assert_eq!(topology(&wrapped_disk(&[1, 1, 1, 1])).betti, [1, 1, 1]);
    assert_eq!(topology(&wrapped_disk(&[1, 1, -1, -1, 1])).betti, [1, 0, 0]);
    // As a single polygon that runs along its edges thrice.
    let polygon = Builder::new(3).faces(&[[0, 1, 2, 0, 1, 2, 0, 2, 1]]);
    assert_eq!(topology(&polygon).betti, [1, 0, 0]);
}

/// All cells of a dimension, each as a canonical list of vertices, with their facets: told apart
/// without any of the library's code.
fn rows_of(b: &Builder, dimension: usize) -> BTreeMap<Vec<u32>, Vec<Vec<u32>>> {
    let ring_key = |ring: &[u32]| {
        let n = ring.len();
        let turned = |k: usize, back: bool| -> Vec<u32> {
            (0..n).map(|i| ring[if back { (k + n - i) % n } else { (k + i) % n }]).collect()
        };
        (0..n).flat_map(|k| [turned(k, false), turned(k, true)]).min().unwrap()
    };
    let facets = |cell: &[u32]| -> Vec<Vec<u32>> {
        let (apex, base) = cell.split_last().unwrap();
        let n = base.len();
        let mut rings = vec![base.to_vec()];
        rings.extend((0..n).map(|k| vec![base[k], base[(k + 1) % n], *apex]));
        rings.iter().map(|r| ring_key(r)).collect()
    };
    let cells: BTreeMap<Vec<u32>, Vec<Vec<u32>>> = (b.cells.iter())
        .map(|(_, c)| {
            let mut facets = facets(c);
            facets.sort();
            (facets.concat(), facets)
        })
        .collect();
    let mut faces: BTreeSet<Vec<u32>> = b.faces.iter().map(|f| ring_key(f)).collect();
    faces.extend(cells.values().flatten().cloned());
    let sides = |ring: &[u32]| -> Vec<Vec<u32>> {
        let n = ring.len();
        let pair = |i: usize| [ring[i], ring[(i + 1) % n]];
        (0..n).map(|i| vec![pair(i)[0].min(pair(i)[1]), pair(i)[0].max(pair(i)[1])]).collect()
    };
    let mut edges: BTreeSet<Vec<u32>> = faces.iter().flat_map(|f| sides(f)).collect();
    edges.extend(b.edges.iter().map(|e| vec![e[0].min(e[1]), e[0].max(e[1])]));
    match dimension {
        0 => (0..b.vertices.len() as u32).map(|v| (vec![v], Vec::new())).collect(),
        1 => edges.iter().map(|e| (e.clone(), vec![vec![e[0]], vec![e[1]]])).collect(),
        2 => faces.iter().map(|f| (f.clone(), sides(f))).collect(),
        _ => cells,
    }
}

/// The four Betti numbers by plain elimination over Z/2.
fn brute_betti(b: &Builder) -> [u64; 4] {
    let cells: Vec<_> = (0..4).map(|d| rows_of(b, d)).collect();
    let rank = |d: usize| -> u64 {
        let number: BTreeMap<&Vec<u32>, usize> =
            cells[d - 1].keys().enumerate().map(|(i, k)| (k, i)).collect();
        let mut rows: Vec<Vec<bool>> = Vec::new();
        for facets in cells[d].values() {
            let mut row = vec![false; number.len()];
            facets.iter().for_each(|f| row[number[f]] ^= true);
            rows.push(row);
        }
        let mut rank = 0;
        for column in 0..number.len() {
            let Some(pivot) = (rank..rows.len()).find(|&r| rows[r][column]) else { continue };
            rows.swap(rank, pivot);
            let (done, rest) = rows.split_at_mut(rank + 1);
            for row in rest.iter_mut().filter(|row| row[column]) {
                row.iter_mut().zip(&done[rank]).for_each(|(x, y)| *x ^= y);
            }
            rank += 1;
        }
        rank as u64
    };
    let ranks = [0, rank(1), rank(2), rank(3), 0];
    std::array::from_fn(|d| cells[d].len() as u64 - ranks[d] - ranks[d + 1])
}

/// The parts of a random complex on a few vertices: everything may meet everything.
fn random_complex(random: &mut Random) -> Builder {
    let n = 4 + random.below(8);
    let mut b = Builder::new(n);
    let distinct = |random: &mut Random, k: usize| -> Vec<u32> {
        let mut list: Vec<u32> = (0..n as u32).collect();
        for i in 0..k {
            let j = i + random.below(n - i);
            list.swap(i, j);
        }
        list.truncate(k);
        list
    };
    let most = [30, 14, 8, 20];
    let mut count = most.map(|m| random.below(m + 1));
    // Some kinds often stay away altogether.
    count.iter_mut().for_each(|c| *c *= usize::from(random.below(3) > 0));
    for _ in 0..count[0] {
        b.faces.push(distinct(random, 3));
    }
    for _ in 0..count[1] {
        let k = 3 + random.below((n - 2).min(4));
        let mut ring = distinct(random, k);
        if random.below(3) == 0 && ring.len() > 3 {
            // Passes a vertex twice.
            let again = ring[0];
            ring.insert(2, again);
        }
        b.faces.push(ring);
    }
    for _ in 0..count[2] {
        let e = distinct(random, 2);
        b.edges.push([e[0], e[1]]);
    }
    for _ in 0..count[3] {
        let kind = random.below(6);
        b.cells.push(match kind {
            0 if n > 4 => (CellType::Pyramid, distinct(random, 5)),
            1 => {
                let k = 4 + random.below((n - 3).min(4));
                (CellType::PolygonalPyramid, distinct(random, k))
            }
            _ => (CellType::Tetrahedron, distinct(random, 4)),
        });
    }
    b
}

#[test]
fn random_complexes_agree_with_elimination() {
    let mut seen_b2 = 0;
    let mut seen_b3 = 0;
    for seed in 0..3000 {
        let b = random_complex(&mut Random(seed));
        let t = topology(&b);
        let counts = [0, 1, 2, 3].map(|d| rows_of(&b, d).len() as u64);
        assert_eq!([t.vertices, t.edges, t.faces, t.cells], counts, "seed {seed}");
        let betti = brute_betti(&b);
        assert_eq!(t.betti, betti[..3], "seed {seed}");
        let b3 = (betti[0] + betti[2]) as i64 - betti[1] as i64 - t.euler_characteristic;
        assert_eq!(b3, betti[3] as i64, "seed {seed}");
        assert_eq!(t.components, betti[0]);
        seen_b2 += usize::from(betti[2] > 0);
        seen_b3 += usize::from(betti[3] > 0);
    }
    assert!(seen_b2 > 300 && seen_b3 > 30, "{seen_b2} and {seen_b3} of 3000 tell something");
}

/// The surface counts from their definitions, vertex by vertex.
fn brute_surface(b: &Builder) -> [u64; 3] {
    let canonical: BTreeSet<Vec<u32>> =
        rows_of(&Builder { cells: Vec::new(), ..b.clone() }, 2).into_keys().collect();
    let mut sides: BTreeMap<[u32; 2], usize> = BTreeMap::new();
    // For each vertex the links of its corners: pairs of neighbours.
    let mut links: BTreeMap<u32, Vec<[u32; 2]>> = BTreeMap::new();
    for ring in &canonical {
        let n = ring.len();
        for i in 0..n {
            let (a, v, c) = (ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]);
            *sides.entry([v.min(c), v.max(c)]).or_default() += 1;
            links.entry(v).or_default().push([a, c]);
        }
    }
    let boundary = sides.values().filter(|&&n| n == 1).count() as u64;
    let nonmanifold = sides.values().filter(|&&n| n > 2).count() as u64;
    let disk = |link: &Vec<[u32; 2]>| {
        let mut degree: BTreeMap<u32, usize> = BTreeMap::new();
        link.iter().flatten().for_each(|&v| *degree.entry(v).or_default() += 1);
        let mut reached = BTreeSet::from([link[0][0]]);
        for _ in 0..link.len() {
            for [a, c] in link {
                if reached.contains(a) || reached.contains(c) {
                    reached.extend([*a, *c]);
                }
            }
        }
        degree.values().all(|&d| d <= 2) && reached.len() == degree.len()
    };
    let singular = links.values().filter(|link| !disk(link)).count() as u64;
    [boundary, nonmanifold, singular]
}

#[test]
fn random_surfaces_agree_with_the_definitions() {
    let mut random = Random(99);
    for round in 0..2000 {
        let mut b = random_complex(&mut random);
        // Sparse ones have fans worth a look.
        b.faces.truncate(1 + random.below(8));
        let t = topology(&b);
        let counts = [t.boundary_edges, t.nonmanifold_edges, t.nonmanifold_vertices];
        assert_eq!(counts, brute_surface(&b), "round {round}: {:?}", b.faces);
    }
}

#[test]
fn the_numbering_does_not_matter() {
    let mut random = Random(5);
    let shapes =
        [torus(7, 5), wrapped_grid(3, 4, true, true), cubes([3, 3, 2], |p| p != [1, 1, 1])];
    for shape in shapes {
        let expected = topology(&shape);
        for _ in 0..5 {
            let n = shape.vertices.len();
            let mut order: Vec<u32> = (0..n as u32).collect();
            (1..n).for_each(|i| order.swap(i, random.below(i + 1)));
            let pairs: Vec<(u32, u32)> = (0..n as u32).zip(order.iter().copied()).collect();
            let mut shuffled = shape.clone().glue(&pairs);
            (1..shuffled.faces.len()).for_each(|i| shuffled.faces.swap(i, random.below(i + 1)));
            (1..shuffled.cells.len()).for_each(|i| shuffled.cells.swap(i, random.below(i + 1)));
            shuffled.faces.iter_mut().for_each(|f| f.rotate_left(1));
            assert_eq!(topology(&shuffled), expected);
        }
    }
}

#[test]
fn large_surfaces_and_solids() {
    let n = 300;
    let mut torus = torus(n, n);
    assert_eq!(known(&topology(&torus)), closed([1, 2, 1], 0, Some(1)));
    torus.faces.truncate(100_000);
    assert!(!topology(&torus).closed);
    // A block with two tunnels and a void.
    let block = cubes([16, 16, 16], |p| {
        let tunnel = (p[0] == 3 || p[0] == 12) && p[1] == 4;
        let void = p.iter().all(|k| (8..11).contains(k));
        !tunnel && !void
    });
    assert_eq!(topology(&block).betti, [1, 2, 1]);
}

#[test]
fn jobs_are_honoured() {
    let torus = torus(20, 20).build();
    let spent = Job::default();
    spent.cancel();
    assert_eq!(torus.topology(&spent).unwrap_err().status(), Status::Cancelled);
    let tight = Job::new(JobOptions { memory_ceiling: 1000, ..JobOptions::default() });
    assert_eq!(torus.topology(&tight).unwrap_err().status(), Status::OutOfMemory);
    let job = Job::default();
    torus.topology(&job).unwrap();
    assert_eq!(job.progress(), 1.0);
    assert!(Complex::new(ComplexParts::default()).unwrap().topology(&job).is_ok());
}

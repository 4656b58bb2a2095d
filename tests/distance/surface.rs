//! The axis in space as polygons.

use crate::exact::{nearest_of, three_lines, to_lines};
use crate::shapes::{Point, cuboid, distance, dot, open, polygon, prism, sub, turned};
use medax::complex::{ComplexParts, Element, Rows, Topology, Values};
use medax::distance::{FieldAxis, FieldOptions, GraphOptions, MedialGraph, Piece, Sites};
use medax::medial::Side;
use medax::{Complex, ElementKind, Job, JobOptions, Status};
use std::sync::Arc;

fn surface(sites: &Arc<Sites>, options: FieldOptions) -> (Complex, Topology) {
    let job = Job::default();
    let surface = FieldAxis::new(sites, options, &job).unwrap().surface(&job).unwrap();
    let topology = surface.topology(&job).unwrap();
    (surface, topology)
}

fn inner(density: f64, angle: f64) -> FieldOptions {
    FieldOptions { density, angle, ..FieldOptions::default() }
}

/// What is outside, in a cube.
fn outer(density: f64) -> FieldOptions {
    let clip = Some([[-2.0; 3], [2.0; 3]]);
    FieldOptions { side: Side::Outer, density, clip, ..FieldOptions::default() }
}

/// What turns a rectangle round the z axis, in so many steps.
fn ring(steps: u32) -> Arc<Sites> {
    turned(&[[2.0, -0.15], [3.0, -0.15], [3.0, 0.15], [2.0, 0.15]], steps)
}

#[test]
fn the_axis_of_a_box_is_contractible_and_its_middle_a_disk() {
    for density in [0.2, 0.13] {
        for size in [[4.0, 3.0, 2.0], [4.0, 3.0, 0.5]] {
            let sites = cuboid(size);
            let (_, whole) = surface(&sites, inner(density, 0.5));
            assert_eq!((whole.betti, whole.isolated_vertices), ([1, 0, 0], 0), "{density}");
            assert!(whole.nonmanifold_edges > 0);
            // Sheets over edges have half of the angle.
            let (middle, disk) = surface(&sites, inner(density, 2.0));
            assert_eq!((disk.betti, disk.boundary_loops, disk.genus), ([1, 0, 0], 1, Some(0)));
            assert!(middle.vertices().iter().all(|p| (p[2] - 0.5 * size[2]).abs() < 1e-5));
        }
    }
}

#[test]
fn two_plates_have_a_disk_between_them() {
    let plate = |z: f64| Piece::Triangle([[0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z]]);
    let sites = open(3, vec![plate(0.0), plate(0.3)]);
    let (sheet, disk) = surface(&sites, outer(0.2));
    assert_eq!((disk.betti, disk.boundary_loops, disk.genus), ([1, 0, 0], 1, Some(0)));
    assert!(sheet.vertices().iter().all(|p| (p[2] - 0.15).abs() < 1e-5));
    // It comes within a cube of the box's rim.
    let reach = |k: usize| sheet.vertices().iter().map(|p| p[k].abs()).fold(0.0, f64::max);
    assert!(reach(0) > 1.8 && reach(1) > 1.8);
}

#[test]
fn the_axis_of_a_ring_goes_round_it() {
    for steps in [4, 24] {
        let (_, whole) = surface(&ring(steps), inner(0.11, 0.4));
        assert_eq!((whole.betti, whole.isolated_vertices), ([1, 1, 0], 0), "{steps}");
        let (_, annulus) = surface(&ring(steps), inner(0.11, 2.5));
        assert_eq!((annulus.betti, annulus.boundary_loops), ([1, 1, 0], 2), "{steps}");
    }
}

/// What has no surface for an axis but a curve becomes loose edges.
#[test]
fn the_axis_of_a_torus_is_a_loop_of_edges() {
    let tube: Vec<[f64; 2]> = polygon(24, 0.7).iter().map(|p| [2.0 + p[0], p[1]]).collect();
    let (circle, topology) = surface(&turned(&tube, 48), inner(0.2, 1.0));
    assert_eq!((topology.betti, circle.faces().len()), ([1, 1, 0], 0));
    assert!(circle.edges().len() >= circle.vertices().len());
    let off = |p: &Point| (p[0].hypot(p[1]) - 2.0).hypot(p[2]);
    // The mesh is no torus: its axis is off by what the mesh is.
    assert!(circle.vertices().iter().all(|p| off(p) < 0.02));
}

#[test]
fn the_axis_of_a_cylinder_is_two_cones_and_a_line() {
    let (axis, topology) = surface(&prism(&polygon(48, 1.0), 4.0), inner(0.17, 1.0));
    assert_eq!(topology.betti, [1, 0, 0]);
    assert!(axis.edges().len() >= 8);
    let off = |&[x, y, z]: &Point| {
        let rho = x.hypot(y);
        let end = (1.0 - rho) - z.min(4.0 - z);
        if z > 1.0 && z < 3.0 { rho } else { end.abs() }
    };
    // The mesh is 0.0022 thinner than the cylinder.
    assert!(axis.vertices().iter().all(|p| off(p) < 0.01));
}

fn numbers(complex: &Complex, element: Element, name: &str) -> Vec<[u32; 2]> {
    match complex.attribute(element, name).unwrap().values() {
        Values::U32(values) => values.as_chunks().0.to_vec(),
        values => panic!("{values:?}"),
    }
}

#[test]
fn three_lines_have_hyperbolic_paraboloids_between_them() {
    let sites = open(3, three_lines());
    let (diagram, topology) = surface(&sites, outer(0.2));
    assert_eq!((topology.betti, topology.isolated_vertices), ([1, 0, 0], 0));
    for (&p, [a, b]) in diagram.vertices().iter().zip(numbers(&diagram, Element::Vertex, "sites")) {
        let away = to_lines(p).map(f64::sqrt);
        assert!((away[a as usize] - away[b as usize]).abs() < 2e-5, "{p:?} {away:?}");
        assert!(away.iter().all(|d| *d > away[a as usize] - 2e-5));
    }
    // A face is crossed from the lesser of its sites to the larger.
    let lines = three_lines();
    let mut turned = 0;
    for (face, [a, b]) in diagram.faces().iter().zip(numbers(&diagram, Element::Face, "sites")) {
        let corners: Vec<Point> = face.iter().map(|&v| diagram.vertices()[v as usize]).collect();
        let [u, v] = [sub(corners[2], corners[0]), sub(corners[3], corners[1])];
        let normal =
            [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        let middle = [0, 1, 2].map(|k| 0.25 * corners.iter().map(|p| p[k]).sum::<f64>());
        let [low, high] =
            [a.min(b), a.max(b)].map(|site| nearest_of(middle, &lines[site as usize]));
        turned += usize::from(dot(sub(high, low), normal) <= 0.0);
    }
    // Where three sheets meet, a vertex of another sheet may turn a face over.
    assert!(50 * turned < diagram.faces().len(), "{turned}");
}

#[test]
fn chosen_pairs_of_sites_have_their_pieces_alone() {
    let job = Job::default();
    let sites = open(3, three_lines());
    let options = outer(0.2);
    let pairs = [[0, 1], [2, 0], [1, 2]];
    let mut sum = 0;
    for pair in pairs {
        let axis = FieldAxis::between(&sites, &[pair], options, &job).unwrap();
        assert!(axis.validate(&job).unwrap().is_valid());
        let piece = axis.surface(&job).unwrap();
        for element in [Element::Vertex, Element::Face] {
            let of = numbers(&piece, element, "sites");
            assert!(of.iter().all(|&[a, b]| [a, b] == pair || [b, a] == pair));
        }
        assert_eq!(piece.topology(&job).unwrap().betti[1..], [0, 0]);
        sum += piece.faces().len();
    }
    let all = FieldAxis::between(&sites, &pairs, options, &job).unwrap().surface(&job).unwrap();
    assert!(all == surface(&sites, options).0);
    // An edge of the lattice may cross two of the sheets.
    assert!(sum >= all.faces().len() && sum < all.faces().len() + all.faces().len() / 20);
    let none = FieldAxis::between(&sites, &[[0, 0]], options, &job).unwrap();
    assert!(none.points().is_empty() && none.surface(&job).unwrap().vertices().is_empty());
    let error = FieldAxis::between(&sites, &[[0, 1], [1, 3]], options, &job).unwrap_err();
    assert_eq!(error.status(), Status::InvalidArgument);
    assert_eq!(error.element(), Some((ElementKind::Row, 1)));
}

/// Two hooks, and a point: the axis within each hook is no part of their Voronoi diagram.
fn hooks(dimension: u32) -> Arc<Sites> {
    let bent = |x: f64, way: f64| {
        [
            Piece::Segment([[x, -1.0, 0.0], [x, 1.0, 0.0]]),
            Piece::Segment([[x, 1.0, 0.0], [x + way, 1.0, 0.0]]),
        ]
    };
    let mut pieces = [bent(-0.3, -1.0), bent(0.3, 1.0)].concat();
    pieces.push(Piece::Point([0.0, -1.8, 0.0]));
    Arc::new(Sites::new(dimension, pieces, vec![0, 0, 1, 1, 2], &Job::default()).unwrap())
}

#[test]
fn what_lies_on_one_site_is_pruned() {
    let job = Job::default();
    for dimension in [2, 3] {
        let sites = hooks(dimension);
        let points = |options: FieldOptions| -> Vec<Point> {
            let axis = FieldAxis::new(&sites, options, &job).unwrap();
            assert!(axis.validate(&job).unwrap().is_valid());
            axis.points().iter().map(|p| p.center).collect()
        };
        let options = outer(0.2);
        let within = |p: &&Point| {
            (p[0].abs() - 0.3) > 0.05 && (p[0].abs() - 0.3 - (1.0 - p[1])).abs() < 1e-3
        };
        let whole = points(options);
        assert!(whole.iter().filter(within).count() > 5, "{dimension}");
        let pruned = points(FieldOptions { between_sites: true, ..options });
        assert_eq!(pruned.iter().filter(within).count(), 0, "{dimension}");
        // Nothing else is gone.
        let kept = whole.iter().filter(|p| p[0].abs() < 0.1 && p[1] > -0.8);
        for p in kept {
            assert!(pruned.iter().any(|q| distance(*p, *q) < 0.36), "{dimension} {p:?}");
        }
    }
    let sites = hooks(2);
    let clip = Some([[-2.0, -2.0, 0.0], [2.0, 2.0, 0.0]]);
    let options = GraphOptions { side: Side::Outer, clip, ..GraphOptions::default() };
    let graph = |pairs: &[[u32; 2]]| {
        let graph = MedialGraph::between(&sites, pairs, options, &job).unwrap();
        assert!(graph.validate(&job).unwrap().is_valid());
        graph
    };
    let between = graph(&[[1, 0]]);
    let middle: Vec<_> = between.points()[between.node_count()..].iter().collect();
    assert!(middle.len() > 20 && middle.iter().all(|p| p.center[0].abs() < 1e-9));
    let within = graph(&[[0, 0]]);
    assert!(within.points().iter().all(|p| p.center[0] < -0.29));
    let error = MedialGraph::between(&sites, &[[0, 3]], options, &job).unwrap_err();
    assert_eq!(error.element(), Some((ElementKind::Row, 0)));
}

#[test]
fn surfaces_are_the_same_whatever_the_threads() {
    let sites = cuboid([2.0, 1.5, 1.0]);
    let found = [1, 2, 5].map(|threads| {
        let job = Job::new(JobOptions { threads, ..JobOptions::default() });
        FieldAxis::new(&sites, inner(0.1, 0.2), &job).unwrap().surface(&job).unwrap()
    });
    assert!(found[0] == found[1] && found[0] == found[2]);
}

#[test]
fn in_the_plane_there_is_no_surface() {
    let job = Job::default();
    let axis = FieldAxis::new(&hooks(2), outer(0.3), &job).unwrap();
    assert_eq!(axis.surface(&job).unwrap_err().status(), Status::InvalidArgument);
}

/// Two cubes, of which one has a loose edge, beside a vertex on its own and a square whose corner lies on one of the cubes without being it.
#[test]
fn components_are_sites_and_planes_lie_between_them() {
    let cube = |x: f64| {
        (0..8).map(move |i: usize| {
            [0, 1, 2]
                .map(|k| if i >> k & 1 == 1 { 1.0 } else { 0.0 } + if k == 0 { x } else { 0.0 })
        })
    };
    let faces: [[u32; 4]; 6] =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let alone = [[10.0, 0.0, 0.0], [11.0, 0.0, 0.0]];
    let square = [[1.0, 1.0, 1.0], [1.0, 2.0, 1.0], [0.0, 2.0, 1.0], [0.0, 1.0, 1.0]];
    let mut rows = Rows::default();
    // The second cube first: numbers come from vertices, not from faces.
    faces.iter().for_each(|face| rows.push(&face.map(|v| v + 8)).unwrap());
    faces.iter().for_each(|face| rows.push(face).unwrap());
    rows.push(&[18, 19, 20, 21]).unwrap();
    let parts = ComplexParts {
        vertices: cube(0.0).chain(cube(2.0)).chain(alone).chain(square).collect(),
        faces: rows,
        edges: vec![[16, 8]],
        ..ComplexParts::default()
    };
    let complex = Arc::new(Complex::new(parts).unwrap());
    let sites = Sites::of_components(&complex, &Job::default()).unwrap();
    let counts = [(1, 12), (0, 12), (3, 2), (1, 1), (2, 1)];
    let expected: Vec<u32> =
        counts.into_iter().flat_map(|(site, count)| vec![site; count]).collect();
    assert_eq!(sites.site_of_piece(), expected);
    let components = complex.topology(&Job::default()).unwrap().components;
    assert_eq!(u64::from(sites.site_count()), components);
    let one = Sites::of_complex(&complex, &Job::default()).unwrap();
    assert_eq!((one.pieces(), one.site_count()), (sites.pieces(), 1));
    // The inside is that of the whole mesh.
    let inside = sites.is_inside(&[[0.5; 3], [2.5, 0.5, 0.5], [1.5, 0.5, 0.5]], &Job::default());
    assert_eq!(inside.unwrap(), [true, true, false]);

    // Between the cubes a square half way, and nothing of what each has for itself.
    let sites = Arc::new(sites);
    let clip = Some([[1.0, 0.1, 0.1], [2.0, 0.9, 0.9]]);
    let options = FieldOptions { side: Side::Outer, density: 0.1, clip, ..FieldOptions::default() };
    let options = FieldOptions { between_sites: true, ..options };
    let (diagram, topology) = surface(&sites, options);
    assert_eq!(topology.betti, [1, 0, 0]);
    assert!(diagram.vertices().iter().all(|p| (p[0] - 1.5).abs() < 1e-5));
    assert!(numbers(&diagram, Element::Face, "sites").iter().all(|&pair| pair == [0, 1]));
}

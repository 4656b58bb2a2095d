//! Coordinates, deformations, half-faces, cells.

use crate::shapes::{Random, is_in_torus, mesh, sphere, torus};
use medax::complex::CellType;
use medax::pair::{PairElement, PairPlace};
use medax::{Job, NONE, Status};

#[test]
fn points_come_back_from_their_places() {
    let mut random = Random(1);
    let mesh = mesh(&torus(1200, &mut random), is_in_torus);
    let points: Vec<[f64; 3]> =
        (0..100_000).map(|_| random.point().map(|x| 3.0 * x - 1.5)).collect();
    let places = mesh.locate(&points, &Job::default()).unwrap();
    let mut found = 0;
    for (p, place) in points.iter().zip(&places).filter(|(_, place)| place.element != NONE) {
        let q = mesh.position(place);
        assert!((0..3).all(|k| (p[k] - q[k]).abs() <= 1e-9 * 3.0), "{p:?} {q:?}");
        assert!((-1e-12..=1.0 + 1e-12).contains(&place.t));
        found += 1;
    }
    assert!(found > 5000);
    // The other way round, through elements that are not slivers.
    let volumes = mesh.volumes(&Job::default()).unwrap();
    let large = 1e-9 * mesh.enclosed_volume();
    let there: Vec<PairPlace> = (0..mesh.element_count() as u32)
        .filter(|&element| volumes[element as usize] > large && mesh.piece_count(element) == 1)
        .map(|element| PairPlace { element, piece: 0, weights: [0.1, 0.2, 0.3, 0.4], t: 0.0 })
        .collect();
    let points: Vec<[f64; 3]> = there.iter().map(|place| mesh.position(place)).collect();
    let back = mesh.locate(&points, &Job::default()).unwrap();
    for (place, back) in there.iter().zip(&back) {
        assert_eq!(place.element, back.element);
        assert!((0..4).all(|k| (place.weights[k] - back.weights[k]).abs() < 1e-6), "{back:?}");
        let t = match mesh.kind(place.element) {
            PairElement::FaceVertex => 0.1,
            PairElement::EdgeEdge => 0.3,
            PairElement::VertexFace => 0.9,
        };
        assert!((back.t - t).abs() < 1e-6, "{back:?}");
    }
}

#[test]
fn what_moves_the_inner_structure_moves_the_boundary_along() {
    let job = Job::default();
    let mut random = Random(2);
    let mesh = mesh(&torus(1000, &mut random), is_in_torus);
    let by = |p: &[f64; 3]| [p[0] + 1.0, p[1] - 2.0, p[2] + 0.5];
    let moved: Vec<[f64; 3]> = mesh.inner_vertices().iter().map(by).collect();
    let there = mesh.with_inner(&moved, &job).unwrap();
    for (p, q) in mesh.boundary_vertices().iter().map(by).zip(there.boundary_vertices()) {
        assert!((0..3).all(|k| (p[k] - q[k]).abs() < 1e-12));
    }
    assert!(there.validate(&job).unwrap().is_valid());
    // And back, by the boundary.
    let back = there.with_boundary(mesh.boundary_vertices(), &job).unwrap();
    for (p, q) in mesh.inner_vertices().iter().zip(back.inner_vertices()) {
        assert!((0..3).all(|k| (p[k] - q[k]).abs() < 1e-12));
    }
    // A gentle bend folds nothing; what is turned inside out is reported, and only that.
    let bent = |p: &[f64; 3]| [p[0], p[1], p[2] + 0.05 * p[0] * p[0]];
    let bent: Vec<[f64; 3]> = mesh.inner_vertices().iter().map(bent).collect();
    let bent = mesh.with_inner(&bent, &job).unwrap();
    assert!(bent.folded(&job).unwrap().len() * 20 < mesh.element_count());
    let mirrored: Vec<[f64; 3]> =
        mesh.boundary_vertices().iter().map(|p| [-p[0], p[1], p[2]]).collect();
    let folded = mesh.with_boundary(&mirrored, &job).unwrap().folded(&job).unwrap();
    assert!(folded.len() * 2 > mesh.element_count());
    let status = |made: medax::Result<_>| made.map(|_: medax::PairMesh| ()).unwrap_err();
    assert_eq!(status(mesh.with_inner(&moved[1..], &job)).status(), Status::Mismatch);
    let mut bad = moved;
    bad[7][1] = f64::NAN;
    let error = status(mesh.with_inner(&bad, &job));
    assert_eq!((error.status(), error.element().map(|(_, i)| i)), (Status::NonFinite, Some(7)));
}

#[test]
fn half_faces_lead_round_edges_and_through_the_solid() {
    let job = Job::default();
    let mut random = Random(3);
    let mesh = mesh(&torus(1500, &mut random), is_in_torus);
    let its = mesh.half_faces(&job).unwrap();
    let count = its.dual.len() as u32;
    assert_eq!(its.of_element.last(), Some(&count));
    let corners = |face: u32| -> Vec<u32> {
        let [begin, end] = [face, face + 1].map(|i| its.offsets[i as usize] as usize);
        its.origin[begin..end].to_vec()
    };
    let mut on_boundary = 0;
    for face in 0..count {
        let dual = its.dual[face as usize];
        if dual == NONE {
            on_boundary += 1;
            assert_eq!(mesh.kind(its.element(face)), PairElement::VertexFace);
            continue;
        }
        assert_eq!(its.dual[dual as usize], face);
        assert_ne!(its.element(dual), its.element(face));
        let (own, mut other) = (corners(face), corners(dual));
        other.reverse();
        // The same ring, wherever it begins.
        let first = other.iter().position(|&v| v == own[0]).unwrap();
        other.rotate_left(first);
        assert_eq!(own, other);
    }
    assert_eq!(on_boundary, mesh.counts()[2]);
    let mut steps_round = 0;
    for half_edge in 0..its.origin.len() as u32 {
        let [from, to] = its.ends(half_edge);
        let opposite = its.opposite[half_edge as usize];
        assert_eq!(its.ends(opposite), [to, from]);
        assert_eq!(its.opposite[opposite as usize], half_edge);
        assert_eq!(its.element(its.half_face(opposite)), its.element(its.half_face(half_edge)));
        assert_ne!(its.half_face(opposite), its.half_face(half_edge));
        let partner = its.partner[half_edge as usize];
        assert_eq!(partner == NONE, its.dual[its.half_face(half_edge) as usize] == NONE);
        if partner != NONE {
            assert_eq!(its.ends(partner), [to, from]);
            assert_eq!(its.partner[partner as usize], half_edge);
        }
        // Round the edge, back to the beginning or to the boundary.
        if half_edge % 97 == 0 {
            let mut at = half_edge;
            loop {
                at = its.partner[its.opposite[at as usize] as usize];
                steps_round += 1;
                if at == NONE || at == half_edge {
                    break;
                }
                assert!(steps_round < 10_000_000);
            }
        }
    }
    // Each element is a closed surface, a sphere.
    for element in 0..mesh.element_count() {
        let [begin, end] = [element, element + 1].map(|i| its.of_element[i]);
        let [first, last] = [begin, end].map(|face| its.offsets[face as usize] as usize);
        let mut vertices = its.origin[first..last].to_vec();
        vertices.sort_unstable();
        vertices.dedup();
        assert_eq!(vertices.len() + (end - begin) as usize, (last - first) / 2 + 2);
    }
}

#[test]
fn the_cells_of_the_solid_are_its_elements() {
    let job = Job::default();
    let mut random = Random(4);
    let mesh = mesh(&sphere(500, &mut random), |_| true);
    let solid = mesh.solid(&job).unwrap();
    assert_eq!(solid.cells().len(), mesh.element_count());
    for (element, (cell, kind)) in solid.cells().iter().zip(solid.cell_types()).enumerate() {
        let ring = mesh.ring(element as u32).len();
        let (corners, expected) = match mesh.kind(element as u32) {
            PairElement::FaceVertex if ring == 4 => (5, CellType::Pyramid),
            PairElement::FaceVertex if ring > 4 => (ring + 1, CellType::PolygonalPyramid),
            _ => (4, CellType::Tetrahedron),
        };
        assert_eq!((cell.len(), *kind), (corners, expected));
    }
    // The centroids of convex elements are in them.
    let centroids = mesh.centroids(&job).unwrap();
    let places = mesh.locate(&centroids, &job).unwrap();
    let volumes = mesh.volumes(&job).unwrap();
    for (element, place) in places.iter().enumerate() {
        if volumes[element] > 1e-9 * mesh.enclosed_volume() {
            assert_eq!(place.element, element as u32);
        }
    }
}

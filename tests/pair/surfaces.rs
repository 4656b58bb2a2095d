//! The surfaces between the inner structure and the boundary.

use crate::shapes::{Random, dual, is_in_torus, labels, mesh, sphere, torus};
use medax::complex::{Element, Values};
use medax::{Job, NONE, PairMesh, Status};

/// The values of the paper's figures, and of the project's own.
const TIMES: [f64; 8] = [0.001, 0.01, 0.05, 0.1, 0.3, 0.5, 0.75, 0.9];

#[test]
fn every_surface_is_closed_oriented_and_of_the_genus_of_the_boundary() {
    let job = Job::default();
    let mut random = Random(1);
    // Not a sphere, where all Voronoi vertices are one but for rounding.
    let ellipsoid: Vec<[f64; 3]> =
        sphere(400, &mut random).iter().map(|p| [p[0], 0.8 * p[1], 0.6 * p[2]]).collect();
    for (mesh, genus) in
        [(mesh(&ellipsoid, |_| true), 0), (mesh(&torus(1200, &mut random), is_in_torus), 1)]
    {
        let volumes = mesh.volumes(&job).unwrap();
        for t in TIMES {
            let surface = mesh.iso_surface(t, &job).unwrap();
            let found = surface.topology(&job).unwrap();
            assert!(found.closed && found.oriented, "{found:?}");
            assert_eq!((found.genus, found.components), (Some(genus), 1));
            // Where elements are as small as rounding, so is what is between their faces.
            let is_large = |&triangle: &u32| {
                let element = surface.face_of_triangle()[triangle as usize];
                volumes[element as usize] > 1e-12 * mesh.enclosed_volume()
            };
            let mut crossing = surface.self_intersections(&job).unwrap();
            let face = |triangle: u32| surface.face_of_triangle()[triangle as usize];
            // A face that is straight but for rounding is cut into triangles that may overlap.
            let is_one = |pair: &[u32; 2]| face(pair[0]) == face(pair[1]);
            crossing.retain(|pair| pair.iter().all(is_large) && !is_one(pair));
            assert!(crossing.is_empty(), "{t} {crossing:?}");
        }
    }
}

#[test]
fn faces_are_planar_and_convex() {
    let mut random = Random(2);
    let mesh = mesh(&torus(1200, &mut random), is_in_torus);
    for t in TIMES {
        let surface = mesh.iso_surface(t, &Job::default()).unwrap();
        for (i, face) in surface.faces().iter().enumerate() {
            let at: Vec<[f64; 3]> = face.iter().map(|&v| surface.vertices()[v as usize]).collect();
            let sub = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
            let cross = |u: [f64; 3], v: [f64; 3]| {
                [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
            };
            let dot = |u: [f64; 3], v: [f64; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
            let normal = (1..at.len() - 1)
                .map(|k| cross(sub(at[k], at[0]), sub(at[k + 1], at[0])))
                .fold([0.0; 3], |sum, n| [sum[0] + n[0], sum[1] + n[1], sum[2] + n[2]]);
            let size = dot(normal, normal).sqrt();
            for k in 0..at.len() {
                // Lengths are around 1: rounding moves corners by some 1e-16.
                let off = dot(sub(at[k], at[0]), normal).abs();
                assert!(off <= 1e-13 * size.max(1e-4), "{t} {i}: {off:e} of {size:e}");
                let turn = cross(
                    sub(at[(k + 1) % at.len()], at[k]),
                    sub(at[(k + 2) % at.len()], at[(k + 1) % at.len()]),
                );
                assert!(dot(turn, normal) >= -1e-13 * size, "{t} {i}");
            }
        }
    }
}

#[test]
fn the_last_surface_is_the_boundary_and_the_first_the_inner_structure() {
    let job = Job::default();
    let mut random = Random(3);
    let rows = torus(2000, &mut random);
    let dual = dual(&rows);
    let labels = labels(&dual, is_in_torus);
    let mesh = PairMesh::voronoi(&dual, &labels, &job).unwrap();
    let last = mesh.iso_surface(1.0, &job).unwrap();
    assert_eq!(last, mesh.boundary(&job).unwrap());
    // The facets between inner cells and others.
    let t = dual.triangulation();
    let mut expected = Vec::new();
    for cell in (0..t.cells().len()).filter(|&cell| labels.is_inner()[cell]) {
        for i in 0..4 {
            let next = t.neighbors()[cell][i];
            if next == NONE || !labels.is_inner()[next as usize] {
                expected.push(t.facet(cell as u32, i));
            }
        }
    }
    let Some(Values::U32(samples)) =
        last.attribute(Element::Vertex, "sample").map(|samples| samples.values())
    else {
        panic!("no samples")
    };
    let found: Vec<[u32; 3]> =
        last.triangles().iter().map(|corners| corners.map(|v| samples[v as usize])).collect();
    assert_eq!(found, expected);
    for (&p, &sample) in last.vertices().iter().zip(samples) {
        assert_eq!(p, t.coords()[sample as usize]);
    }
    let first = mesh.iso_surface(0.0, &job).unwrap();
    for (p, node) in first.vertices().iter().zip(mesh.nodes()) {
        assert_eq!(*p, mesh.inner_vertices()[node[1] as usize]);
    }
    for t in [-0.1, 1.1, f64::NAN] {
        assert_eq!(mesh.iso_surface(t, &job).unwrap_err().status(), Status::InvalidArgument);
    }
}

#[test]
fn shells_wrap_what_is_connected() {
    let job = Job::default();
    let mut random = Random(4);
    // A ball with a void, and another one beside it.
    let mut rows = sphere(1500, &mut random);
    rows.extend(sphere(400, &mut random).iter().map(|p| p.map(|x| 0.4 * x)));
    rows.extend(sphere(300, &mut random).iter().map(|p| [p[0] + 5.0, p[1], p[2]]));
    let mesh = mesh(&rows, |[x, y, z]| {
        let r = (x * x + y * y + z * z).sqrt();
        let s = ((x - 5.0).powi(2) + y * y + z * z).sqrt();
        (r > 0.4 && r < 1.0) || s < 1.0
    });
    assert!(mesh.validate(&job).unwrap().is_valid());
    let shells = mesh.shells(&job).unwrap();
    assert_eq!(shells.iter().max(), Some(&2));
    let boundary = mesh.boundary(&job).unwrap().topology(&job).unwrap();
    assert_eq!((boundary.components, boundary.genus), (3, Some(0)));
    // The inner structure has the homotopy type of the solid: a void, two parts.
    assert_eq!(mesh.inner(&job).unwrap().topology(&job).unwrap().betti, [2, 0, 1]);
}

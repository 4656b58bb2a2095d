//! A pair-mesh is a partition of its solid, whatever the solid.

use crate::shapes::{Random, dual, grid, is_in_torus, labels, mesh, sphere, torus};
use medax::dual::Dual;
use medax::pair::PairElement;
use medax::{Job, JobOptions, Labels, NONE, PairMesh, Status};
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

fn check(mesh: &PairMesh) {
    let job = Job::default();
    let report = mesh.validate(&job).unwrap();
    assert!(report.is_valid(), "{report:?}");
    let volumes = mesh.volumes(&job).unwrap();
    let (sum, enclosed) = (volumes.iter().sum::<f64>(), mesh.enclosed_volume());
    assert!((sum - enclosed).abs() <= 1e-9 * enclosed, "{sum} {enclosed}");
    assert!(volumes.iter().all(|&volume| volume >= -1e-12 * enclosed));
    assert_eq!(mesh.counts()[0], 2 * mesh.inner_faces().len());
}

/// The volume of the inner cells.
fn volume(dual: &Dual, labels: &Labels) -> f64 {
    let t = dual.triangulation();
    let cells = t.cells().iter().zip(labels.is_inner()).filter(|(_, is_inner)| **is_inner);
    let of = |cell: &[u32; 4]| {
        let [a, b, c, d] = cell.map(|v| t.coords()[v as usize]);
        let [u, v, w] = [b, c, d].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
        let cross =
            [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        (cross[0] * w[0] + cross[1] * w[1] + cross[2] * w[2]) / 6.0
    };
    cells.map(|(cell, _)| of(cell)).sum()
}

#[test]
fn balls_and_tori_are_divided() {
    let mut random = Random(1);
    for count in [20, 60, 200] {
        let ball = mesh(&sphere(count, &mut random), |_| true);
        check(&ball);
        assert!(ball.removed().is_empty());
        check(&mesh(&torus(10 * count, &mut random), is_in_torus));
    }
}

/// Samples that are not spread evenly: many Voronoi vertices are outside the box, and much is folded.
#[test]
fn samples_at_random_are_mended_where_they_must_be() {
    let mut random = Random(9);
    let mesh = mesh(&torus(4000, &mut random), is_in_torus);
    check(&mesh);
    assert!(mesh.folded(&Job::default()).unwrap().is_empty());
    let places = mesh.inner_vertices().iter().zip(mesh.voronoi_vertices());
    let moved = places.filter(|(place, voronoi)| place != voronoi).count();
    assert!((1..5000).contains(&moved), "{moved}");
}

/// The proof asks nothing of the solid: cells may be inner at random, so that the surface touches itself in edges and vertices.
#[test]
fn any_labels_will_do() {
    let mut random = Random(2);
    for count in [5, 8, 20, 60, 200] {
        for share in [0.2, 0.5, 0.8, 1.0] {
            for _ in 0..5 {
                let rows: Vec<[f64; 3]> = (0..count).map(|_| random.point()).collect();
                let dual = dual(&rows);
                let cells = dual.triangulation().cells().len();
                let mut is_inner: Vec<bool> = (0..cells).map(|_| random.unit() < share).collect();
                is_inner[0] = true;
                let labels = Labels::new(dual.triangulation(), is_inner).unwrap();
                let mesh = PairMesh::voronoi(&dual, &labels, &Job::default()).unwrap();
                check(&mesh);
                let all = volume(&dual, &labels);
                assert!((mesh.enclosed_volume() - all).abs() <= 1e-9 * all);
            }
        }
    }
}

#[test]
fn any_labels_of_cospherical_points_will_do() {
    let mut random = Random(3);
    for sides in [[2, 2, 2], [3, 3, 3], [4, 3, 2], [5, 5, 5]] {
        for share in [0.3, 0.7, 1.0] {
            for _ in 0..5 {
                let dual = dual(&grid(sides));
                let cells = dual.triangulation().cells().len();
                let mut is_inner: Vec<bool> = (0..cells).map(|_| random.unit() < share).collect();
                is_inner[0] = true;
                let labels = Labels::new(dual.triangulation(), is_inner).unwrap();
                check(&PairMesh::voronoi(&dual, &labels, &Job::default()).unwrap());
            }
        }
    }
}

#[test]
fn a_cube_has_one_inner_vertex_for_its_eight_corners() {
    let cube = mesh(&grid([2, 2, 2]), |_| true);
    check(&cube);
    assert_eq!((cube.inner_vertices(), cube.counts()), (&[[0.5; 3]][..], [0, 0, 12]));
    // Two cubes have an edge between their vertices, and each of its samples a share.
    let two = mesh(&grid([3, 2, 2]), |_| true);
    check(&two);
    assert_eq!((two.inner_vertices().len(), two.inner_faces().len()), (2, 0));
    // A slab of four has a face.
    let slab = mesh(&grid([3, 3, 2]), |_| true);
    check(&slab);
    assert_eq!((slab.inner_vertices().len(), slab.inner_faces().len()), (4, 1));
    assert_eq!(slab.inner_faces().row(0).len(), 4);
}

#[test]
fn samples_inside_are_removed_and_named() {
    let mut rows = grid([3, 3, 3]);
    let dual_of_all = dual(&rows);
    let whole = mesh(&rows, |_| true);
    check(&whole);
    let points = dual_of_all.triangulation().points();
    let inside = points.vertex_of_row()[13];
    assert_eq!((rows[13], whole.removed()), ([1.0; 3], &[inside][..]));
    assert!(whole.cell_of_inner().iter().all(|&cell| cell == NONE));
    // What is left has the numbers that it had.
    for (&p, &sample) in whole.boundary_vertices().iter().zip(whole.sample_of_boundary()) {
        assert_eq!(p, dual_of_all.triangulation().coords()[sample as usize]);
    }
    // It is as if they had never been there.
    rows.remove(13);
    let without = mesh(&rows, |_| true);
    assert_eq!(without.boundary_vertices(), whole.boundary_vertices());
    assert_eq!((without.nodes(), without.rings()), (whole.nodes(), whole.rings()));
}

/// The counts of section 3, read off the triangulation.
#[test]
fn elements_are_as_many_as_the_paper_says() {
    let mut random = Random(4);
    let rows = torus(1500, &mut random);
    let dual = dual(&rows);
    let labels = labels(&dual, is_in_torus);
    let mesh = PairMesh::voronoi(&dual, &labels, &Job::default()).unwrap();
    check(&mesh);
    let t = dual.triangulation();
    // For each edge of the surface its fans: an inner cell more than elements, for each two triangles.
    let (mut triangles, mut cells_at, mut ends) =
        (0, HashMap::<[u32; 2], HashSet<usize>>::new(), HashMap::<[u32; 2], usize>::new());
    for (cell, corners) in t.cells().iter().enumerate().filter(|(i, _)| labels.is_inner()[*i]) {
        for i in 0..4 {
            for j in i + 1..4 {
                let edge = [corners[i].min(corners[j]), corners[i].max(corners[j])];
                cells_at.entry(edge).or_default().insert(cell);
            }
            let next = t.neighbors()[cell][i];
            if next == NONE || !labels.is_inner()[next as usize] {
                triangles += 1;
                let facet = t.facet(cell as u32, i);
                for k in 0..3 {
                    let [a, b] = [facet[k], facet[(k + 1) % 3]];
                    *ends.entry([a.min(b), a.max(b)]).or_default() += 1;
                }
            }
        }
    }
    let between: usize = ends.iter().map(|(edge, ends)| cells_at[edge].len() - ends / 2).sum();
    let inner = cells_at.keys().filter(|edge| !ends.contains_key(*edge)).count();
    let [pyramids, edges, over] = mesh.counts();
    assert_eq!((edges, over), (between, triangles));
    // A facet whose vertices were moved is as many triangles as it has sides.
    let divided = mesh.cell_of_inner().iter().filter(|&&cell| cell == NONE).count();
    let of_faces = |face: &[u32]| face.iter().any(|&v| mesh.cell_of_inner()[v as usize] == NONE);
    let pieces = mesh.inner_faces().iter().filter(|face| of_faces(face)).count();
    assert_eq!(pyramids, 2 * (inner - divided + pieces));
}

#[test]
fn the_bytes_are_the_same_whatever_the_threads_and_the_order() {
    let mut random = Random(6);
    let mut rows = torus(1000, &mut random);
    let made = |rows: &[[f64; 3]], threads| {
        let job = Job::new(JobOptions { threads, ..JobOptions::default() });
        let dual = dual(rows);
        PairMesh::voronoi(&dual, &labels(&dual, is_in_torus), &job).unwrap()
    };
    let one = made(&rows, 1);
    rows.reverse();
    let three = made(&rows, 3);
    assert_eq!(
        (one.nodes(), one.rings(), one.inner_vertices()),
        (three.nodes(), three.rings(), three.inner_vertices())
    );
}

#[test]
fn what_is_no_solid_is_refused() {
    let mut random = Random(7);
    let rows = sphere(50, &mut random);
    let job = Job::default();
    let its = dual(&rows);
    let none = labels(&its, |_| false);
    let status = |made: medax::Result<PairMesh>| made.unwrap_err().status();
    assert_eq!(status(PairMesh::voronoi(&its, &none, &job)), Status::Degenerate);
    let other = dual(&sphere(60, &mut random));
    let labels = labels(&other, |_| true);
    assert_eq!(status(PairMesh::voronoi(&its, &labels, &job)), Status::Mismatch);
    let bare = Dual::new(its.triangulation(), Default::default(), &job).unwrap();
    let all = crate::shapes::labels(&its, |_| true);
    assert_eq!(status(PairMesh::voronoi(&Arc::new(bare), &all, &job)), Status::InvalidArgument);
    let small = Job::new(JobOptions { memory_ceiling: 1000, ..JobOptions::default() });
    assert_eq!(status(PairMesh::voronoi(&its, &all, &small)), Status::OutOfMemory);
    let spent = Job::default();
    spent.cancel();
    assert_eq!(status(PairMesh::voronoi(&its, &all, &spent)), Status::Cancelled);
}

#[test]
fn each_element_is_of_its_kind() {
    let mut random = Random(8);
    let mesh = mesh(&sphere(300, &mut random), |_| true);
    let kinds: Vec<PairElement> = (0..mesh.element_count() as u32).map(|e| mesh.kind(e)).collect();
    assert!(kinds.is_sorted_by_key(|&kind| kind as u32));
    let count = |kind| kinds.iter().filter(|&&of| of == kind).count();
    let each = [PairElement::FaceVertex, PairElement::EdgeEdge, PairElement::VertexFace];
    assert_eq!(mesh.counts(), each.map(count));
}

//! Random points, and the elements in which they lie: by a grid of boxes and exact orientations, not by the library's own search.

use crate::exact::{in_space, turns};
use crate::shapes::{Random, dual, is_in_torus, mesh, torus};
use medax::{Job, Labels, NONE, PairMesh};
use std::cmp::Ordering::Greater;

/// How many boxes of a grid there are along each axis.
const SIDE: usize = 48;

/// What may hold a point of each box of a grid.
struct Grid {
    min: [f64; 3],
    step: [f64; 3],
    lists: Vec<Vec<u32>>,
}

impl Grid {
    /// Of things by their corners. The boxes of the first `axes` axes count; along the others all things share one.
    fn new<const N: usize>(things: &[[[f64; 3]; N]], axes: usize) -> Grid {
        let (mut min, mut max) = ([f64::MAX; 3], [f64::MIN; 3]);
        for p in things.iter().flatten() {
            for k in 0..3 {
                (min[k], max[k]) = (min[k].min(p[k]), max[k].max(p[k]));
            }
        }
        let step = [0, 1, 2].map(|k| match k < axes {
            true => (max[k] - min[k]) / SIDE as f64,
            false => f64::INFINITY,
        });
        let mut grid = Grid { min, step, lists: vec![Vec::new(); SIDE * SIDE * SIDE] };
        for (thing, corners) in (0..).zip(things) {
            let boxes = corners.map(|p| grid.at(p));
            let of = |k: usize| {
                let along = boxes.map(|at| at[k]);
                along.into_iter().min().unwrap()..=along.into_iter().max().unwrap()
            };
            for x in of(0) {
                for y in of(1) {
                    of(2).for_each(|z| grid.lists[(x * SIDE + y) * SIDE + z].push(thing));
                }
            }
        }
        grid
    }

    /// The box of a point; beside the grid the nearest. Rising coordinates never come to a lesser box.
    fn at(&self, p: [f64; 3]) -> [usize; 3] {
        let along = |k: usize| ((p[k] - self.min[k]) / self.step[k]) as usize;
        [0, 1, 2].map(|k| along(k).min(SIDE - 1))
    }

    fn list(&self, p: [f64; 3]) -> &[u32] {
        let [x, y, z] = self.at(p);
        &self.lists[(x * SIDE + y) * SIDE + z]
    }
}

/// Whether a point lies strictly inside a tetrahedron that is positively oriented.
fn holds([a, b, c, d]: [[f64; 3]; 4], p: [f64; 3]) -> bool {
    let parts = [[p, b, c, d], [a, p, c, d], [a, b, p, d], [a, b, c, p]];
    parts.into_iter().all(|part| in_space(part) == Greater)
}

/// Holds each point against every element; the number of those inside the solid.
fn check(mesh: &PairMesh, points: &[[f64; 3]]) -> usize {
    let job = Job::default();
    let (mut elements, mut tetrahedra) = (Vec::new(), Vec::new());
    for element in 0..mesh.element_count() as u32 {
        for piece in 0..mesh.piece_count(element) {
            elements.push(element);
            tetrahedra.push(mesh.piece(element, piece).map(|v| mesh.place_of(v)));
        }
    }
    let boundary = mesh.boundary(&job).unwrap();
    let of_vertices = |corners: &[u32; 3]| corners.map(|v| boundary.vertices()[v as usize]);
    let triangles: Vec<[[f64; 3]; 3]> = boundary.triangles().iter().map(of_vertices).collect();
    let (in_space, in_plane) = (Grid::new(&tetrahedra, 3), Grid::new(&triangles, 2));
    let places = mesh.locate(points, &job).unwrap();
    let mut inside = 0;
    for (&p, place) in points.iter().zip(&places) {
        let near = in_space.list(p).iter().map(|&i| i as usize);
        let holders: Vec<u32> =
            near.filter(|&i| holds(tetrahedra[i], p)).map(|i| elements[i]).collect();
        assert!(holders.len() <= 1, "{p:?} {holders:?}");
        let turns = turns(p, in_plane.list(p).iter().map(|&i| triangles[i as usize]));
        assert_eq!(holders.len() as i32, turns, "{p:?}");
        assert_eq!(holders.first().copied().unwrap_or(NONE), place.element, "{p:?}");
        inside += holders.len();
    }
    inside
}

#[test]
fn every_point_of_a_torus_is_in_one_element() {
    let mut random = Random(5);
    let mesh = mesh(&torus(1000, &mut random), is_in_torus);
    let points: Vec<[f64; 3]> = (0..100_000)
        .map(|_| random.point().map(|x| 3.0 * x - 1.5))
        .map(|[x, y, z]| [x, y, 0.3 * z])
        .collect();
    assert!(check(&mesh, &points) > 30_000);
}

/// A solid that touches itself in edges and vertices, of which many inner vertices are moved.
#[test]
fn every_point_of_random_cells_is_in_one_element() {
    let mut random = Random(6);
    let rows: Vec<[f64; 3]> = (0..200).map(|_| random.point()).collect();
    let dual = dual(&rows);
    let cells = dual.triangulation().cells().len();
    let is_inner = (0..cells).map(|_| random.unit() < 0.5).collect();
    let labels = Labels::new(dual.triangulation(), is_inner).unwrap();
    let mesh = PairMesh::voronoi(&dual, &labels, &Job::default()).unwrap();
    assert_ne!(mesh.inner_vertices(), mesh.voronoi_vertices());
    let points: Vec<[f64; 3]> = (0..100_000).map(|_| random.point()).collect();
    assert!(check(&mesh, &points) > 30_000);
}

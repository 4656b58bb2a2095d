//! Samples with labels.

use medax::dual::{Dual, DualOptions};
use medax::{Job, Labels, PairMesh, Points, Triangulation};
use std::f64::consts::TAU;
use std::sync::Arc;

/// A generator of Marsaglia's (2003, *Xorshift RNGs*).
pub struct Random(pub u64);

impl Random {
    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn point(&mut self) -> [f64; 3] {
        [0; 3].map(|_| self.unit())
    }
}

pub fn dual(rows: &[[f64; 3]]) -> Arc<Dual> {
    dual_of(Points::new(rows, Default::default(), &Job::default()).unwrap())
}

pub fn dual_of(points: Points) -> Arc<Dual> {
    let job = Job::default();
    let triangulation = Arc::new(Triangulation::delaunay(&Arc::new(points), &job).unwrap());
    Arc::new(Dual::new(&triangulation, DualOptions { facets: true }, &job).unwrap())
}

/// Labels of the cells by where their barycentres lie.
pub fn labels(dual: &Arc<Dual>, is_inner: impl Fn([f64; 3]) -> bool) -> Labels {
    let t = dual.triangulation();
    let middle = |cell: &[u32; 4]| {
        let corners = cell.map(|v| t.coords()[v as usize]);
        [0, 1, 2].map(|k| corners.iter().map(|p| p[k]).sum::<f64>() / 4.0)
    };
    let labels = t.cells().iter().map(|cell| is_inner(middle(cell))).collect();
    Labels::new(t, labels).unwrap()
}

pub fn mesh(rows: &[[f64; 3]], is_inner: impl Fn([f64; 3]) -> bool) -> PairMesh {
    let dual = dual(rows);
    PairMesh::voronoi(&dual, &labels(&dual, is_inner), &Job::default()).unwrap()
}

/// Points on a sphere of radius 1.
pub fn sphere(count: usize, random: &mut Random) -> Vec<[f64; 3]> {
    let mut points = Vec::new();
    while points.len() < count {
        let p = random.point().map(|x| 2.0 * x - 1.0);
        let size = p.iter().map(|x| x * x).sum::<f64>().sqrt();
        if size > 0.1 && size < 1.0 {
            points.push(p.map(|x| x / size));
        }
    }
    points
}

/// Points on a torus of radii 1 and 0.4, and whether a point lies in it.
pub fn torus(count: usize, random: &mut Random) -> Vec<[f64; 3]> {
    let at = |u: f64, v: f64| {
        let r = 1.0 + 0.4 * v.cos();
        [r * u.cos(), r * u.sin(), 0.4 * v.sin()]
    };
    (0..count).map(|_| at(TAU * random.unit(), TAU * random.unit())).collect()
}

pub fn is_in_torus([x, y, z]: [f64; 3]) -> bool {
    let r = (x * x + y * y).sqrt() - 1.0;
    r * r + z * z < 0.16
}

/// A grid of points, so that most are cospherical.
pub fn grid(sides: [usize; 3]) -> Vec<[f64; 3]> {
    let mut points = Vec::new();
    for x in 0..sides[0] {
        for y in 0..sides[1] {
            points.extend((0..sides[2]).map(|z| [x, y, z].map(|x| x as f64)));
        }
    }
    points
}

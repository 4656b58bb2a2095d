//! Boundaries, and random numbers.

use medax::complex::{ComplexParts, Rows};
use medax::distance::{Piece, Sites};
use medax::{Complex, Job};
use std::f64::consts::TAU;
use std::sync::Arc;

pub type Point = [f64; 3];

/// A generator of Marsaglia's (2003, *Xorshift RNGs*).
pub struct Random(pub u64);

impl Random {
    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    pub fn point(&mut self, low: f64, high: f64) -> Point {
        [0; 3].map(|_| self.within(low, high))
    }

    pub fn flat(&mut self, low: f64, high: f64) -> Point {
        [self.within(low, high), self.within(low, high), 0.0]
    }
}

pub fn sub(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn distance(a: Point, b: Point) -> f64 {
    dot(sub(a, b), sub(a, b)).sqrt()
}

/// The segments of rings.
pub fn rings(rings: &[Vec<[f64; 2]>]) -> Vec<Piece> {
    let flat = |p: [f64; 2]| [p[0], p[1], 0.0];
    let of = |ring: &Vec<[f64; 2]>| {
        let next = ring.iter().cycle().skip(1);
        ring.iter().zip(next).map(|(&a, &b)| Piece::Segment([flat(a), flat(b)])).collect::<Vec<_>>()
    };
    rings.iter().flat_map(of).collect()
}

/// Closed curves in the plane, one site.
pub fn closed(pieces: Vec<Piece>) -> Arc<Sites> {
    let count = pieces.len();
    let sites = Sites::new(2, pieces, vec![0; count], &Job::default()).unwrap();
    Arc::new(sites.with_closed(vec![true; count]).unwrap())
}

/// Open ones, each a site.
pub fn open(dimension: u32, pieces: Vec<Piece>) -> Arc<Sites> {
    let numbers = (0..pieces.len() as u32).collect();
    Arc::new(Sites::new(dimension, pieces, numbers, &Job::default()).unwrap())
}

pub fn rectangle(width: f64, height: f64) -> Vec<[f64; 2]> {
    vec![[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]]
}

pub fn l_shape() -> Vec<[f64; 2]> {
    vec![[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]]
}

/// A comb: slots cut into a bar from above.
pub fn comb(slots: usize) -> Vec<[f64; 2]> {
    let width = 2.0 * slots as f64 + 1.0;
    let mut ring = vec![[0.0, 0.0], [width, 0.0]];
    for slot in (0..slots).rev() {
        let left = 2.0 * slot as f64 + 1.0;
        ring.extend([[left + 2.0, 4.0], [left + 1.0, 4.0], [left + 1.0, 1.0], [left, 1.0]]);
    }
    ring.extend([[1.0, 4.0], [0.0, 4.0]]);
    ring
}

pub fn polygon(count: usize, radius: f64) -> Vec<[f64; 2]> {
    let angle = |i: usize| TAU * i as f64 / count as f64;
    (0..count).map(|i| [radius * angle(i).cos(), radius * angle(i).sin()]).collect()
}

/// A star-shaped polygon with random radii.
pub fn star(random: &mut Random, count: usize) -> Vec<[f64; 2]> {
    (0..count)
        .map(|i| {
            let angle = TAU * i as f64 / count as f64;
            let radius = random.within(0.3, 1.0);
            [radius * angle.cos(), radius * angle.sin()]
        })
        .collect()
}

/// A mesh, whose faces point out.
pub fn solid(vertices: Vec<Point>, faces: &[Vec<u32>]) -> Arc<Sites> {
    let mut rows = Rows::default();
    faces.iter().for_each(|face| rows.push(face).unwrap());
    let parts = ComplexParts { vertices, faces: rows, ..ComplexParts::default() };
    let complex = Arc::new(Complex::new(parts).unwrap());
    let topology = complex.topology(&Job::default()).unwrap();
    assert!(topology.closed && topology.oriented);
    Arc::new(Sites::of_complex(&complex, &Job::default()).unwrap())
}

pub fn cuboid(size: Point) -> Arc<Sites> {
    let corner = |i: usize| [0, 1, 2].map(|k| if i >> k & 1 == 1 { size[k] } else { 0.0 });
    let faces: [[u32; 4]; 6] =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    solid((0..8).map(corner).collect(), &faces.map(Vec::from))
}

/// What a convex ring in the plane sweeps over from z = 0 to a height.
pub fn prism(ring: &[[f64; 2]], height: f64) -> Arc<Sites> {
    let count = ring.len() as u32;
    let vertices = [0.0, height].map(|z| ring.iter().map(move |p| [p[0], p[1], z]));
    let side = |i: u32| vec![i, (i + 1) % count, count + (i + 1) % count, count + i];
    let mut faces: Vec<Vec<u32>> = (0..count).map(side).collect();
    faces.extend([(0..count).rev().collect(), (count..2 * count).collect()]);
    solid(vertices.into_iter().flatten().collect(), &faces)
}

/// A closed tube round the z axis: a section in the half plane of the distance from the axis and of z, counterclockwise, turned round in some steps.
pub fn turned(section: &[[f64; 2]], steps: u32) -> Arc<Sites> {
    let count = section.len() as u32;
    let at = |step: u32| {
        let angle = TAU * f64::from(step) / f64::from(steps);
        section.iter().map(move |p| [p[0] * angle.cos(), p[0] * angle.sin(), p[1]])
    };
    let side = |step: u32, i: u32| {
        let [here, next] = [step, (step + 1) % steps].map(|step| step * count);
        let j = (i + 1) % count;
        vec![here + i, next + i, next + j, here + j]
    };
    let faces: Vec<_> =
        (0..steps).flat_map(|step| (0..count).map(move |i| side(step, i))).collect();
    solid((0..steps).flat_map(at).collect(), &faces)
}

//! Boundaries, and random numbers.

use medax::Job;
use medax::distance::{Piece, Sites};
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

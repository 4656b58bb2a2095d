//! Smooth surfaces whose inner medial axes and local feature sizes are known.

use medax::Complex;
use medax::complex::{ComplexParts, Rows};
use medax::sample::Shape;
use std::f64::consts::TAU;

pub type Point = [f64; 3];

/// Segments of the polygons that stand for exact curves, which are off by less than 3e-8; and for the rim of the ellipsoid's disc, off by less than 6e-6.
pub const SEGMENTS: usize = 1 << 16;
pub const RIM: usize = 1 << 10;
/// The half axes of the ellipsoid and the tubes' radii, those of `medax::sample`.
pub const HALF_AXES: Point = [1.4, 1.0, 0.7];
pub const TORUS_TUBE: f64 = 0.4;
pub const TREFOIL_TUBE: f64 = 0.3;

pub fn distance(a: Point, b: Point) -> f64 {
    (0..3).map(|k| (a[k] - b[k]) * (a[k] - b[k])).sum::<f64>().sqrt()
}

pub fn length(a: Point) -> f64 {
    distance(a, [0.0; 3])
}

pub fn cross(a: Point, b: Point) -> Point {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i] * b[j] - a[j] * b[i])
}

/// A surface with two parameters in [0, 1], whose local feature size is known.
#[derive(Clone, Copy)]
pub enum Surface {
    Torus,
    Ellipsoid,
    Trefoil,
}

/// The trefoil (sin t + 2 sin 2t, cos t - 2 cos 2t, -sin 3t) and its derivative.
pub fn knot(t: f64) -> [Point; 2] {
    let ([s, s2, s3], [c, c2, c3]) =
        ([1.0, 2.0, 3.0].map(|k| (k * t).sin()), [1.0, 2.0, 3.0].map(|k| (k * t).cos()));
    [[s + 2.0 * s2, c - 2.0 * c2, -s3], [c + 4.0 * c2, 4.0 * s2 - s, -3.0 * c3]]
}

impl Surface {
    pub const ALL: [Surface; 3] = [Surface::Torus, Surface::Ellipsoid, Surface::Trefoil];

    pub fn shape(self) -> Shape {
        match self {
            Surface::Torus => Shape::Torus,
            Surface::Ellipsoid => Shape::Ellipsoid,
            Surface::Trefoil => Shape::Trefoil,
        }
    }

    pub fn at(self, u: f64, v: f64) -> Point {
        let (s, c) = (TAU * v).sin_cos();
        match self {
            Surface::Torus => {
                let r = 1.0 + TORUS_TUBE * c;
                [r * (TAU * u).cos(), r * (TAU * u).sin(), TORUS_TUBE * s]
            }
            // The sphere by longitude and latitude, stretched.
            Surface::Ellipsoid => {
                let (up, across) = (0.5 * TAU * (u - 0.5)).sin_cos();
                [HALF_AXES[0] * across * c, HALF_AXES[1] * across * s, HALF_AXES[2] * up]
            }
            // The knot never runs upward: its derivative is at least 3 long seen from above. So there is a horizontal normal everywhere.
            Surface::Trefoil => {
                let [at, along] = knot(TAU * u);
                let flat = cross([0.0, 0.0, 1.0], along);
                let flat = flat.map(|x| x / length(flat));
                let other = cross(along, flat).map(|x| x / length(along));
                [0, 1, 2].map(|k| at[k] + TREFOIL_TUBE * (c * flat[k] + s * other[k]))
            }
        }
    }

    /// More than the length of the derivatives by both parameters, within `half` of the parameter `u`.
    pub fn speeds(self, u: f64, half: f64) -> [f64; 2] {
        match self {
            Surface::Torus => [TAU * (1.0 + TORUS_TUBE), TAU * TORUS_TUBE],
            Surface::Ellipsoid => {
                // Half a turn from pole to pole, a turn round the axis; the latter shrinks towards the poles.
                let across = (0.5 * TAU * (u - 0.5)).cos() + 0.5 * TAU * half;
                [0.5 * TAU * HALF_AXES[0], TAU * HALF_AXES[0] * across.min(1.0)]
            }
            // Seen from above the derivative is h = exp(-it) + 4 exp(2it), which turns by at most |h'| / |h| <= 9 / 3; its direction in
            // space by at most the largest curvature by the largest speed, 0.777 * 5.831. The frame turns by no more than both together. The second
            // derivative is at most (9^2 + 9^2)^(1/2) long.
            Surface::Trefoil => {
                let speed = length(knot(TAU * u)[1]) + 12.8 * TAU * half;
                [TAU * (speed + TREFOIL_TUBE * (3.0 + 0.777 * 5.831)), TAU * TREFOIL_TUBE]
            }
        }
    }

    /// The local feature size, the distance to the whole medial axis, inner and outer. It changes by at most the distance between two points.
    ///
    /// Torus: the inner axis is the core circle, 0.4 away; the outer one the z axis (a point outside that is not on it has one nearest
    /// point), which is 0.6 away or more. Ellipsoid: it is convex and has no outer axis; the inner one is the elliptic disc below. Trefoil
    /// tube: the knot's reach is 0.607, found numerically (see `medax::sample`); an outer point whose nearest point on the tube is not unique has none that is
    /// unique on the knot either, so that it is 0.607 from the knot or more, and 0.307 from the tube. So the knot is nearer, 0.3 away.
    pub fn feature_size(self, at: Point) -> f64 {
        match self {
            Surface::Torus => TORUS_TUBE,
            Surface::Ellipsoid => Shape::Ellipsoid.inner_axis_distance(at).unwrap(),
            Surface::Trefoil => TREFOIL_TUBE,
        }
    }

    /// The radius of the inner medial ball at a point of the surface, and its medial angle: that between the tangent plane and the farthest
    /// point at which the ball touches.
    pub fn inner_ball(self, [x, y, z]: Point) -> [f64; 2] {
        match self {
            Surface::Torus => [TORUS_TUBE, TAU / 4.0],
            Surface::Trefoil => [TREFOIL_TUBE, TAU / 4.0],
            // It touches at (x, y, -z), 2 |z| away: see below.
            Surface::Ellipsoid => {
                let [a, b, c] = HALF_AXES.map(|half| half * half);
                let radius = length([x * c / a, y * c / b, z]);
                [radius, (z.abs() / radius).min(1.0).asin()]
            }
        }
    }

    /// The exact inner axis.
    pub fn axis(self) -> Complex {
        match self {
            // The ball of radius 0.4 about a point of the core circle touches a whole circle of the torus.
            Surface::Torus => curve(|t| [t.cos(), t.sin(), 0.0]),
            // The normal at the surface point (x, y, z), along (x / a^2, y / b^2, z / c^2), meets the plane z = 0 at (x (1 - c^2 / a^2), y (1 - c^2 /
            // b^2), 0). The point (x, y, -z) has the same foot, and its ball is within the ellipsoid, as c is the least half axis. The feet of all points
            // fill the disc with half axes (a^2 - c^2) / a and (b^2 - c^2) / b.
            Surface::Ellipsoid => {
                let [a, b, c] = HALF_AXES;
                disc([a - c * c / a, b - c * c / b])
            }
            // As for the torus, while the tube is thinner than the knot's reach.
            Surface::Trefoil => curve(|t| knot(t)[0]),
        }
    }
}

pub fn curve(at: impl Fn(f64) -> Point) -> Complex {
    let vertices = (0..SEGMENTS).map(|i| at(TAU * i as f64 / SEGMENTS as f64)).collect();
    let edges = (0..SEGMENTS as u32).map(|i| [i, (i + 1) % SEGMENTS as u32]).collect();
    Complex::new(ComplexParts { vertices, edges, ..Default::default() }).unwrap()
}

/// Triangles of an elliptic disc about the origin, in the plane z = 0.
pub fn disc(half: [f64; 2]) -> Complex {
    const RINGS: usize = 40;
    let segments = RIM;
    let mut vertices = vec![[0.0; 3]];
    for ring in 1..=RINGS {
        let share = ring as f64 / RINGS as f64;
        vertices.extend((0..segments).map(|i| {
            let (s, c) = (TAU * i as f64 / segments as f64).sin_cos();
            [share * half[0] * c, share * half[1] * s, 0.0]
        }));
    }
    let at = |ring: usize, i: usize| (1 + (ring - 1) * segments + i % segments) as u32;
    let mut faces = Rows::default();
    for i in 0..segments {
        faces.push(&[0, at(1, i), at(1, i + 1)]).unwrap();
        for ring in 1..RINGS {
            faces
                .push(&[at(ring, i), at(ring + 1, i), at(ring + 1, i + 1), at(ring, i + 1)])
                .unwrap();
        }
    }
    Complex::new(ComplexParts { vertices, faces, ..Default::default() }).unwrap()
}

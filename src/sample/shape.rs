//! The built-in shapes: what is known of each, and its implicit function.

use super::{solids, trefoil};
use crate::points::Bounds;
use crate::vector::Vec3;

/// A solid of known form. The numbers are the C ABI's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum Shape {
    /// A torus about the z axis: core circle of radius 1, tube of radius 0.4.
    Torus = 0,
    /// A box of sides 2, 1.5 and 1 about the origin.
    Box = 1,
    /// All points within 0.5 of the segment from (-1, 0, 0) to (1, 0, 0).
    Capsule = 2,
    /// An ellipsoid with half axes 1.4, 1 and 0.7 along x, y and z.
    Ellipsoid = 3,
    /// A tube of radius 0.3 about the trefoil knot
    /// (sin t + 2 sin 2t, cos t - 2 cos 2t, -sin 3t).
    Trefoil = 4,
    /// Three tori in a row along x, core circles of radius 1 and tubes of radius 0.4, blended into
    /// one smooth surface.
    Genus3 = 5,
    /// A bracket: two plates at a right angle, two holes through one, one through the other.
    Bracket = 6,
    /// The unit ball.
    Sphere = 7,
}

impl Shape {
    /// Every shape, by number.
    pub const ALL: [Shape; 8] = [
        Shape::Torus,
        Shape::Box,
        Shape::Capsule,
        Shape::Ellipsoid,
        Shape::Trefoil,
        Shape::Genus3,
        Shape::Bracket,
        Shape::Sphere,
    ];

    /// The name that the program uses, such as `torus`.
    pub fn name(self) -> &'static str {
        match self {
            Shape::Torus => "torus",
            Shape::Box => "box",
            Shape::Capsule => "capsule",
            Shape::Ellipsoid => "ellipsoid",
            Shape::Trefoil => "trefoil",
            Shape::Genus3 => "genus3",
            Shape::Bracket => "bracket",
            Shape::Sphere => "sphere",
        }
    }

    /// The shape of this name, if there is one.
    pub fn from_name(name: &str) -> Option<Self> {
        Shape::ALL.into_iter().find(|shape| shape.name() == name)
    }

    /// The genus of the surface.
    pub fn genus(self) -> u32 {
        match self {
            Shape::Box | Shape::Capsule | Shape::Ellipsoid | Shape::Sphere => 0,
            Shape::Torus | Shape::Trefoil => 1,
            Shape::Genus3 | Shape::Bracket => 3,
        }
    }

    /// The number of pieces of the surface.
    pub fn components(self) -> u32 {
        1
    }

    /// Whether the surface has a tangent plane everywhere. A shape with sharp edges has no local
    /// feature size on them, so no sample of it is dense enough there.
    pub fn is_smooth(self) -> bool {
        !matches!(self, Shape::Box | Shape::Bracket)
    }

    /// A box that holds the shape.
    pub fn bounds(self) -> Bounds {
        let (min, max) = match self {
            Shape::Torus => ([-1.4, -1.4, -0.4], [1.4, 1.4, 0.4]),
            Shape::Box => (solids::BOX.map(|h| -h), solids::BOX),
            Shape::Capsule => ([-1.5, -0.5, -0.5], [1.5, 0.5, 0.5]),
            Shape::Ellipsoid => (solids::ELLIPSOID.map(|h| -h), solids::ELLIPSOID),
            Shape::Trefoil => ([-3.04, -3.3, -1.3], [3.04, 2.37, 1.3]),
            Shape::Genus3 => ([-3.4, -1.4, -0.515], [3.4, 1.4, 0.515]),
            Shape::Bracket => ([0.0, 0.0, 0.0], [4.0, 2.4, 3.0]),
            Shape::Sphere => ([-1.0; 3], [1.0; 3]),
        };
        Bounds { min, max }
    }

    /// The spacing that [`sample`](super::sample) takes by default: a quarter of the least local
    /// feature size of a smooth shape, about a sixth of the thinnest part of a sharp one.
    pub fn spacing(self) -> f64 {
        match self {
            Shape::Torus => 0.1,
            Shape::Box => 0.1,
            Shape::Capsule => 0.125,
            Shape::Ellipsoid => 0.0875,
            Shape::Trefoil => 0.075,
            Shape::Genus3 => 0.085,
            Shape::Bracket => 0.08,
            Shape::Sphere => 0.25,
        }
    }

    /// An implicit function: negative inside, 0 on the surface, positive outside.
    ///
    /// It changes by at most the distance between two points, so its absolute value never
    /// exceeds the distance to the surface. It *is* the signed distance for the torus, box,
    /// capsule, trefoil and sphere.
    pub fn value(self, point: [f64; 3]) -> f64 {
        self.evaluate(point).0
    }

    /// The gradient of [`Shape::value`]: on the surface it points along the outward normal.
    /// On an edge it is that of one of the sides.
    pub fn gradient(self, point: [f64; 3]) -> [f64; 3] {
        self.evaluate(point).1
    }

    fn evaluate(self, p: Vec3) -> (f64, Vec3) {
        match self {
            Shape::Torus => solids::torus(p, 1.0, 0.4),
            Shape::Box => solids::cuboid(p, solids::BOX),
            Shape::Capsule => solids::capsule(p, 1.0, 0.5),
            Shape::Ellipsoid => solids::ellipsoid(p, solids::ELLIPSOID),
            Shape::Trefoil => trefoil::tube(p),
            Shape::Genus3 => solids::three_tori(p),
            Shape::Bracket => solids::bracket(p),
            Shape::Sphere => solids::capsule(p, 0.0, 1.0),
        }
    }
}

//! Voronoi diagrams with their drivers, by floats.

use crate::flow::{dot, sub};
use crate::flow_reference::held_center;
use medax::NONE;
use medax::flow::Flow;
use std::collections::HashMap;

pub type Point = [f64; 3];
pub type Plane = [f64; 2];

/// How far from the middle of the samples areas and rays are measured, in diagonals; and where what is infinite is cut off first.
const REACH: f64 = 4.0;
const FAR: f64 = 1e3;

pub fn length(v: Point) -> f64 {
    dot(v, v).sqrt()
}

fn cross(a: Plane, b: Plane) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// A Voronoi edge.
pub struct Edge {
    pub corners: [u32; 3],
    /// The cells of its ends; the second may be [`NONE`].
    pub ends: [u32; 2],
    /// Shares go from 0 at `from` to 1 at `to`, or along a ray to infinity.
    pub from: Point,
    pub to: Point,
    pub last: f64,
    /// The facet of the longest edge of an obtuse triangle.
    pub crossed_into: Option<u32>,
    /// The share of the triangle's centre.
    pub middle: f64,
}

impl Edge {
    pub fn at(&self, share: f64) -> Point {
        match share {
            // Without rounding.
            1.0 => self.to,
            _ => std::array::from_fn(|k| self.from[k] + share * (self.to[k] - self.from[k])),
        }
    }

    /// The length of a part, within reach.
    pub fn length(&self, [low, high]: [f64; 2]) -> f64 {
        (high.min(REACH) - low.min(REACH)) * length(sub(self.to, self.from))
    }
}

/// A corner of a polygon: a point, or one at infinity as a point and a direction from there.
#[derive(Clone, Copy)]
pub enum Corner {
    Finite(Plane),
    Infinite(Plane, Plane),
}

impl Corner {
    /// What its place is among directions from the origin.
    fn vector(self) -> Plane {
        match self {
            Corner::Finite(at) => at,
            Corner::Infinite(_, direction) => direction,
        }
    }
}

/// A Voronoi facet in coordinates of its plane, from the middle of its edge, counterclockwise.
pub struct Facet {
    pub middle: Point,
    pub axes: [Point; 2],
    pub corners: Vec<Corner>,
    /// The edge of each side, and whether it runs on; none at infinity.
    pub sides: Vec<Option<(u32, bool)>>,
}

impl Facet {
    pub fn plane(&self, x: Point) -> Plane {
        self.direction(sub(x, self.middle))
    }

    pub fn direction(&self, v: Point) -> Plane {
        self.axes.map(|axis| dot(v, axis))
    }
}

/// Where a Voronoi vertex flows.
#[derive(Clone, Copy)]
pub enum Onward {
    End,
    Along(u32),
    Into(u32),
}

/// A Voronoi diagram with its drivers, by floats.
pub struct Diagram {
    pub edges: Vec<Edge>,
    pub facets: Vec<Facet>,
    pub onward: Vec<Onward>,
    pub edge_of: HashMap<[u32; 3], u32>,
    pub facet_of: HashMap<[u32; 2], u32>,
    pub centers: Vec<Point>,
    pub middle: Point,
    pub diagonal: f64,
}

pub fn sorted<const N: usize>(mut corners: [u32; N]) -> [u32; N] {
    corners.sort_unstable();
    corners
}

impl Diagram {
    pub fn new(flow: &Flow) -> Self {
        let dual = flow.dual();
        let t = dual.triangulation();
        let (coords, centers) = (t.coords(), dual.centers());
        let facets = dual.facets().unwrap();
        let at = |v: u32| coords[v as usize];
        let extreme = |pick: fn(f64, f64) -> f64| -> Point {
            std::array::from_fn(|k| coords.iter().map(|p| p[k]).fold(coords[0][k], pick))
        };
        let (low, high) = (extreme(f64::min), extreme(f64::max));
        let diagonal = length(sub(high, low));
        let facet_of: HashMap<[u32; 2], u32> =
            facets.edges().iter().map(|&edge| sorted(edge)).zip(0..).collect();
        let mut edges = Vec::new();
        for &[cell, slot] in flow.triangles() {
            let corners = sorted(t.facet(cell, slot as usize));
            let other = t.neighbors()[cell as usize][slot as usize];
            let from = centers[cell as usize];
            let to = match other {
                NONE => {
                    let ray = dual.rays().of_facet(cell, slot) as usize;
                    let direction = dual.rays().directions()[ray];
                    std::array::from_fn(|k| from[k] + diagonal * direction[k])
                }
                other => centers[other as usize],
            };
            let [p, q, r] = corners;
            let obtuse = [[p, q, r], [q, r, p], [r, p, q]].into_iter().find(|apart| {
                let [p, q, r] = apart.map(at);
                dot(sub(p, r), sub(q, r)) < 0.0
            });
            let crossed_into = obtuse.map(|[p, q, _]| facet_of[&sorted([p, q])]);
            let middle = held_center(&corners.map(at)).map_or(f64::NAN, |center| {
                let along = sub(to, from);
                dot(sub(center, from), along) / dot(along, along)
            });
            assert_eq!(middle.is_nan(), crossed_into.is_some(), "a triangle has a right angle");
            let last = if other == NONE { f64::INFINITY } else { 1.0 };
            edges.push(Edge { corners, ends: [cell, other], from, to, last, crossed_into, middle });
        }
        let edge_of: HashMap<[u32; 3], u32> =
            edges.iter().map(|edge| edge.corners).zip(0..).collect();
        let mut diagram = Diagram {
            edges,
            facets: Vec::new(),
            onward: Vec::new(),
            edge_of,
            facet_of,
            centers: centers.to_vec(),
            middle: std::array::from_fn(|k| (low[k] + high[k]) / 2.0),
            diagonal,
        };
        diagram.facets = (0..facets.len()).map(|facet| diagram.facet(flow, facet)).collect();
        diagram.onward = t.cells().iter().map(|&cell| diagram.onward(cell, coords)).collect();
        diagram
    }

    fn facet(&self, flow: &Flow, facet: usize) -> Facet {
        let dual = flow.dual();
        let t = dual.triangulation();
        let facets = dual.facets().unwrap();
        let [p, q] = facets.edges()[facet].map(|v| t.coords()[v as usize]);
        let normal = sub(q, p);
        let least = (0..3).min_by(|&i, &j| normal[i].abs().total_cmp(&normal[j].abs())).unwrap();
        let mut axis = [0.0; 3];
        axis[least] = 1.0;
        let product = |a: Point, b: Point| -> Point {
            std::array::from_fn(|k| {
                a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]
            })
        };
        let unit = |v: Point| v.map(|x| x / length(v));
        let first = unit(product(normal, axis));
        let mut its = Facet {
            middle: std::array::from_fn(|k| (p[k] + q[k]) / 2.0),
            axes: [first, unit(product(normal, first))],
            corners: Vec::new(),
            sides: Vec::new(),
        };
        let ring = facets.ring(facet);
        let [back, on] = facets.rays()[facet];
        let center = |cell: u32| its.plane(dual.centers()[cell as usize]);
        let ray = |ray: u32| {
            let [cell, slot] = dual.rays().facets()[ray as usize];
            let direction = dual.rays().directions()[ray as usize];
            let corner = Corner::Infinite(center(cell), its.direction(direction));
            (corner, self.edge_of[&sorted(t.facet(cell, slot as usize))])
        };
        let mut corners: Vec<Corner> = ring.iter().map(|&c| Corner::Finite(center(c))).collect();
        let mut sides = Vec::new();
        for (i, &cell) in ring.iter().enumerate() {
            let next = ring[(i + 1) % ring.len()];
            let next_corners = t.cells()[next as usize];
            let slot = t.cells()[cell as usize].iter().position(|v| !next_corners.contains(v));
            if i + 1 < ring.len() || on == NONE {
                let edge = self.edge_of[&sorted(t.facet(cell, slot.unwrap()))];
                sides.push(Some((edge, self.edges[edge as usize].ends[0] == cell)));
            }
        }
        if on != NONE {
            let [(on, on_edge), (back, back_edge)] = [ray(on), ray(back)];
            corners.extend([on, back]);
            sides.extend([Some((on_edge, true)), None, Some((back_edge, false))]);
        }
        (its.corners, its.sides) = (corners, sides);
        its
    }

    /// The nearest point of a cell to its centre is the centre of one of its sides, of those that hold theirs that of the largest sphere.
    fn onward(&self, cell: [u32; 4], coords: &[Point]) -> Onward {
        let mut best = (0.0, Onward::End);
        for bits in 1..16u32 {
            let side: Vec<u32> = (0..4).filter(|i| bits >> i & 1 == 1).map(|i| cell[i]).collect();
            let corners: Vec<Point> = side.iter().map(|&v| coords[v as usize]).collect();
            let Some(center) = held_center(&corners) else { continue };
            let radius = length(sub(center, corners[0]));
            if radius > best.0 {
                best = match side[..] {
                    [p, q] => (radius, Onward::Into(self.facet_of[&sorted([p, q])])),
                    [p, q, r] => (radius, Onward::Along(self.edge_of[&sorted([p, q, r])])),
                    _ => (radius, Onward::End),
                };
            }
        }
        best.1
    }

    /// Whether the flow comes into a facet through one of its sides.
    pub fn is_near(&self, facet: u32, side: usize) -> bool {
        self.facets[facet as usize].sides[side]
            .is_some_and(|(edge, _)| self.edges[edge as usize].crossed_into == Some(facet))
    }

    /// The side by which the ray from the middle through a point leaves a facet into which the flow comes, and the share there.
    pub fn exit(&self, facet: u32, x: Plane) -> (usize, f64) {
        let its = &self.facets[facet as usize];
        let count = its.sides.len();
        let first = (0..count)
            .find(|&i| !self.is_near(facet, i) && self.is_near(facet, (i + count - 1) % count))
            .expect("the flow comes in through some side, not through all");
        let turn = |corner: usize| cross(x, its.corners[corner % count].vector());
        // Far sides turn counterclockwise about the middle: the last one that begins clockwise of the ray.
        let far = (first..first + count).take_while(|&i| !self.is_near(facet, i % count));
        let side = far.skip(1).take_while(|&i| turn(i) <= 0.0).last().unwrap_or(first);
        let share = match (its.corners[side % count], its.corners[(side + 1) % count]) {
            (Corner::Finite(_), Corner::Finite(_)) => {
                (turn(side) / (turn(side) - turn(side + 1))).clamp(0.0, 1.0)
            }
            (Corner::Finite(_), _) => -turn(side) / (turn(side + 1) * self.diagonal),
            (_, Corner::Finite(_)) => -turn(side + 1) / (turn(side) * self.diagonal),
            _ => f64::INFINITY,
        };
        (side % count, share.max(0.0))
    }

    /// A share of a side as one of its edge.
    pub fn share_of_edge(&self, (edge, runs_on): (u32, bool), share: f64) -> f64 {
        let is_bounded = self.edges[edge as usize].last == 1.0;
        if runs_on || !is_bounded { share } else { 1.0 - share }
    }

    /// The area of a part of a facet, within reach.
    pub fn area(&self, facet: u32, polygon: &[Corner]) -> f64 {
        let far = |base: Plane, direction: Plane| {
            let scale = FAR * self.diagonal / direction[0].hypot(direction[1]);
            [0, 1].map(|k| base[k] + scale * direction[k])
        };
        let mut points: Vec<Plane> = Vec::new();
        for (i, &corner) in polygon.iter().enumerate() {
            match (corner, polygon[(i + 1) % polygon.len()]) {
                (Corner::Finite(at), _) => points.push(at),
                (Corner::Infinite(base, a), Corner::Infinite(_, b)) => {
                    // The middle direction, lest the chord come near.
                    let [x, y] = [a, b].map(|v| v.map(|x| x / v[0].hypot(v[1])));
                    points.push(far(base, a));
                    points.push(far(base, [x[0] + y[0], x[1] + y[1]]));
                }
                (Corner::Infinite(base, direction), _) => points.push(far(base, direction)),
            }
        }
        let origin = self.facets[facet as usize].plane(self.middle);
        for point in &mut points {
            *point = [0, 1].map(|k| point[k] - origin[k]);
        }
        for axis in 0..2 {
            for sign in [1.0, -1.0] {
                let inside = |p: Plane| REACH * self.diagonal - sign * p[axis];
                let mut clipped = Vec::new();
                for (i, &p) in points.iter().enumerate() {
                    let q = points[(i + 1) % points.len()];
                    let (here, there) = (inside(p), inside(q));
                    if here >= 0.0 {
                        clipped.push(p);
                    }
                    if (here >= 0.0) != (there >= 0.0) {
                        let share = here / (here - there);
                        clipped.push([0, 1].map(|k| p[k] + share * (q[k] - p[k])));
                    }
                }
                points = clipped;
            }
        }
        let sides = (0..points.len()).map(|i| cross(points[i], points[(i + 1) % points.len()]));
        sides.sum::<f64>() / 2.0
    }
}

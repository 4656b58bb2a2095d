//! Whether any of some vertices has less power at a point than another vertex.

use super::Triangulation;
use super::nearest::power_order;
use crate::boxes::{Boxes, Four, Item, Node};
use crate::error::Result;
use crate::job::{Room, Run};
use crate::points::Bounds;
use crate::predicates::UNIT;
use crate::vector::{Vec3, dot, sub};

/// More than the roundings of a bound add up to, as a part of the absolute values in it.
const ERROR: f64 = 16.0 * UNIT;

/// What is known of the vertices in a box: the largest weight, and no more than the least height.
type Known = (f64, f64);

/// Some vertices of a triangulation in a hierarchy of boxes.
///
/// All powers are taken less |q|², with q from an origin to the point. That is h - 2 q·v, with v from the origin to a vertex, and
/// its *height* h = |v|² - w, w its weight. Of a point that is far away this tells vertices apart where all powers are |q|² but
/// for rounding; of a near one the power itself bounds a box more closely.
///
/// Invariant: `vertices` are in the order of the leaves.
pub(crate) struct PowerTree<'a> {
    triangulation: &'a Triangulation,
    boxes: Boxes<Known>,
    vertices: Vec<u32>,
    /// A vertex in the middle of the spatial order: near most others.
    origin: Vec3,
}

impl<'a> PowerTree<'a> {
    /// Of vertices that are not hidden, in ascending order. Cost: O(n log n).
    pub fn new(
        triangulation: &'a Triangulation,
        vertices: &[u32],
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let coords = triangulation.coords();
        let origin = vertices.get(vertices.len() / 2).map_or([0.0; 3], |&v| coords[v as usize]);
        let item = |&number: &u32| Item { middle: coords[number as usize], number };
        let mut own = Room::new(run);
        let mut items = own.collect(vertices.iter().map(item))?;
        let known = |items: &[Item]| {
            let mut known = (f64::NEG_INFINITY, f64::INFINITY);
            for item in items {
                let site = triangulation.site(item.number);
                let (height, error) = height(site, origin);
                known = (site[3].max(known.0), known.1.min(height - error));
            }
            (Bounds::of(items.iter().map(|item| item.middle)), known)
        };
        let boxes = Boxes::new(&mut items, known, room, run)?;
        let vertices = room.collect(items.iter().map(|item| item.number))?;
        Ok(PowerTree { triangulation, boxes, vertices, origin })
    }

    /// Some vertex that has less power at a point than a vertex of the triangulation has, or as much and comes before it. Powers
    /// are compared exactly. Cost: O(log n) where no power is near that one.
    pub fn nearer(&self, at: Vec3, than: u32) -> Option<u32> {
        let site = |vertex| self.triangulation.site(vertex);
        let limit = self.upper(site(than), at);
        let mut best = than;
        self.boxes.least_first(
            |node| self.lower(node, at),
            limit,
            |places| {
                for &vertex in &self.vertices[places] {
                    let order = power_order(at, site(vertex), site(best));
                    if order.then(vertex.cmp(&best)).is_lt() {
                        best = vertex;
                    }
                }
                // One is enough.
                if best == than { limit } else { f64::NEG_INFINITY }
            },
        );
        (best != than).then_some(best)
    }

    /// No more than the least power of a vertex under each child, less |q|².
    fn lower(&self, node: &Node<Known>, at: Vec3) -> Four {
        let q = sub(at, self.origin);
        let square = dot(q, q);
        let mut along = [0.0; 4];
        let mut sizes = [0.0; 4];
        for (k, q) in q.into_iter().enumerate() {
            for (slot, (along, size)) in along.iter_mut().zip(&mut sizes).enumerate() {
                let [a, b] =
                    [node.min[k][slot], node.max[k][slot]].map(|x| 2.0 * q * (x - self.origin[k]));
                *along += a.max(b);
                *size += a.abs().max(b.abs());
            }
        }
        let squares = node.distances_squared(at);
        std::array::from_fn(|slot| {
            let (weight, height) = node.more[slot];
            let by_distance =
                squares[slot] - weight - square - ERROR * (squares[slot] + weight.abs() + square);
            let by_height = height - along[slot] - ERROR * (height.abs() + sizes[slot]);
            by_distance.max(by_height)
        })
    }

    /// No less than the power of a site, less |q|².
    fn upper(&self, site: [f64; 4], at: Vec3) -> f64 {
        let [x, y, z, weight] = site;
        let q = sub(at, self.origin);
        let (square, to) = (dot(q, q), sub([x, y, z], at));
        let by_distance =
            dot(to, to) - weight - square + ERROR * (dot(to, to) + weight.abs() + square);
        let v = sub([x, y, z], self.origin);
        let along = 2.0 * dot(q, v);
        let size: f64 = (0..3).map(|k| 2.0 * (q[k] * v[k]).abs()).sum();
        let (height, error) = height(site, self.origin);
        let by_height = height - along + error + ERROR * (height.abs() + size);
        by_distance.min(by_height)
    }
}

/// The height of a site, and more than its error.
fn height(site: [f64; 4], origin: Vec3) -> (f64, f64) {
    let [x, y, z, weight] = site;
    let v = sub([x, y, z], origin);
    let square = dot(v, v);
    (square - weight, ERROR * (square + weight.abs()))
}

#[cfg(test)]
mod tests {
    use super::PowerTree;
    use super::power_order;
    use crate::job::{Job, Room};
    use crate::points::Points;
    use crate::triangulation::Triangulation;
    use std::cmp::Ordering;
    use std::sync::Arc;

    /// Floats from 0 to 1.
    fn random(mut state: u64) -> impl FnMut() -> f64 {
        move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 11) as f64 / (1u64 << 53) as f64
        }
    }

    fn check(rows: &[[f64; 3]], weights: &[f64], queries: impl Iterator<Item = [f64; 3]>) {
        let points = Arc::new(Points::new(rows, Default::default(), &Job::default()).unwrap());
        let t = Triangulation::regular(&points, weights, &Job::default()).unwrap();
        let all: Vec<u32> = (0..points.len() as u32).filter(|v| !t.hidden().contains(v)).collect();
        let halves: Vec<Vec<u32>> =
            (0..2).map(|half| all.iter().copied().filter(|v| v % 2 == half).collect()).collect();
        let job = Job::default();
        job.run(&[], |run| {
            let mut room = Room::new(run);
            let mut tree = |vertices: &[u32]| PowerTree::new(&t, vertices, &mut room, run);
            let trees = [tree(&halves[0])?, tree(&halves[1])?];
            for at in queries {
                let order = |a: u32, b: u32| power_order(at, t.site(a), t.site(b)).then(a.cmp(&b));
                let least = |of: &[u32]| of.iter().copied().min_by(|&a, &b| order(a, b)).unwrap();
                for (tree, half) in trees.iter().zip(&halves) {
                    let nearest = least(half);
                    assert_eq!(tree.nearer(at, nearest), None, "{at:?}");
                    for &than in all.iter().step_by(7) {
                        let nearer = tree.nearer(at, than);
                        let is_found = order(nearest, than) == Ordering::Less;
                        assert_eq!(nearer.is_some(), is_found, "{at:?} {than}");
                        if let Some(nearer) = nearer {
                            assert_eq!(order(nearer, than), Ordering::Less);
                            assert!(half.contains(&nearer));
                        }
                    }
                }
            }
            Ok(())
        })
        .unwrap();
    }

    #[test]
    fn what_is_nearer_is_found_near_and_far() {
        let mut random = random(1);
        let mut point = |size: f64| [0; 3].map(|_| size * (random() - 0.5));
        let rows: Vec<_> = (0..300).map(|_| point(1.0)).collect();
        let mut weights: Vec<_> = rows.iter().map(|row| 0.01 * row[0].abs()).collect();
        // A ball that touches most others.
        weights[0] = 0.2;
        let sizes = [1.0, 3.0, 1e3, 1e8, 1e12, 1e15, 1e17, 1e30, 1e60];
        let queries: Vec<_> = sizes.iter().flat_map(|&size| [size; 20]).map(&mut point).collect();
        check(&rows, &weights, queries.into_iter());
    }

    #[test]
    fn ties_go_to_the_first_vertex() {
        let grid = |n: i32| (0..n * n * n).map(move |i| [i % n, i / n % n, i / n / n]);
        let rows: Vec<_> = grid(6).map(|row| row.map(f64::from)).collect();
        let queries = grid(11).map(|row| row.map(|x| 0.5 * f64::from(x)));
        check(&rows, &vec![0.0; rows.len()], queries.clone());
        // On the planes of symmetry, and so far away that rounded distances are all the same.
        check(&rows, &vec![0.25; rows.len()], queries.map(|row| row.map(|x| 1e16 * (x - 2.5))));
    }
}

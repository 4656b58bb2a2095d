//! Balls in a hierarchy of boxes round their centres, four to a node.

use crate::distance::tree::{DEPTH, Item, LEAF, WIDE, halved};
use crate::error::Result;
use crate::job::{Room, Run};
use crate::points::Bounds;
use crate::vector::{Vec3, dot, sub};

/// The boxes of four children, coordinate by coordinate, so that they are compared at once.
#[derive(Clone, Copy, Debug)]
struct Node {
    min: [[f64; WIDE]; 3],
    max: [[f64; WIDE]; 3],
    /// The largest radius under each child.
    radius: [f64; WIDE],
    /// The number of a node, or [`LEAF`] and that of the first ball of a leaf.
    child: [u32; WIDE],
    /// How many balls a leaf has; 0 for a node.
    count: [u32; WIDE],
}

/// Balls, halved again and again along the longest side of their centres' box.
///
/// Invariants: children come after their parent, and a child's box holds the centres under it, whose radii are at most the child's; a child that is not there has a box that is
/// infinitely far away. `balls` are centres and radii in the order of the leaves.
#[derive(Clone, Debug)]
pub(super) struct Hierarchy {
    nodes: Vec<Node>,
    balls: Vec<(Vec3, f64)>,
}

impl Hierarchy {
    /// Cost: O(n log n).
    pub fn new(
        centers: &[Vec3],
        radii: &[f64],
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let mut own = Room::new(run);
        let numbered = centers.iter().zip(0..centers.len() as u32);
        let mut items = own.collect(numbered.map(|(&middle, number)| Item { middle, number }))?;
        let mut nodes = Vec::new();
        // What is still to be divided, and where it goes.
        let mut waiting = vec![(0, items.len(), None)];
        while let Some((begin, end, place)) = waiting.pop() {
            run.poll()?;
            let number = nodes.len() as u32;
            if let Some((parent, slot)) = place {
                let parent: &mut Node = &mut nodes[parent as usize];
                parent.child[slot] = number;
            }
            let parts = halved(&mut items, begin, end);
            let mut node = Node {
                min: [[f64::INFINITY; WIDE]; 3],
                max: [[f64::INFINITY; WIDE]; 3],
                radius: [0.0; WIDE],
                child: [LEAF; WIDE],
                count: [0; WIDE],
            };
            for (slot, &(begin, end)) in parts.iter().enumerate().filter(|(_, (b, e))| b < e) {
                let part = &items[begin..end];
                if let Some(bounds) = Bounds::of(part.iter().map(|item| item.middle)) {
                    for k in 0..3 {
                        node.min[k][slot] = bounds.min[k];
                        node.max[k][slot] = bounds.max[k];
                    }
                }
                let radii = part.iter().map(|item| radii[item.number as usize]);
                node.radius[slot] = radii.fold(0.0, f64::max);
                match end - begin > WIDE {
                    true => waiting.push((begin, end, Some((number, slot)))),
                    false => {
                        node.child[slot] = LEAF | begin as u32;
                        node.count[slot] = (end - begin) as u32;
                    }
                }
            }
            room.push(&mut nodes, node)?;
        }
        let ball = |item: &Item| (item.middle, radii[item.number as usize]);
        Ok(Hierarchy { nodes, balls: room.collect(items.iter().map(ball))? })
    }

    /// The least |p - c| - r of all balls.
    pub fn least(&self, p: Vec3) -> f64 {
        self.search(p, f64::INFINITY, false)
    }

    /// Whether the point is within a ball, and not on its sphere.
    pub fn holds(&self, p: Vec3) -> bool {
        self.search(p, 0.0, true) < 0.0
    }

    /// The least of the given number and of all |p - c| - r, or the first that is less.
    fn search(&self, p: Vec3, mut best: f64, any: bool) -> f64 {
        let mut waiting = [(f64::NEG_INFINITY, 0, 0); DEPTH];
        let mut count = 1;
        while count > 0 {
            count -= 1;
            let (lower, child, size): (f64, u32, u32) = waiting[count];
            if lower > best {
                continue;
            }
            if child & LEAF != 0 {
                let begin = (child & !LEAF) as usize;
                for &(center, radius) in &self.balls[begin..begin + size as usize] {
                    let value = signed_distance(p, center, radius);
                    if value < best {
                        best = value;
                        if any {
                            return best;
                        }
                    }
                }
                continue;
            }
            let node = &self.nodes[child as usize];
            let lower = node.lower(p);
            let begin = count;
            for (slot, &lower) in lower.iter().enumerate() {
                if lower <= best {
                    // The nearest comes last, to be looked at first.
                    let mut place = count;
                    while place > begin && waiting[place - 1].0 < lower {
                        waiting[place] = waiting[place - 1];
                        place -= 1;
                    }
                    waiting[place] = (lower, node.child[slot], node.count[slot]);
                    count += 1;
                }
            }
        }
        best
    }
}

/// How far a point is outside a ball; negative within it.
pub(super) fn signed_distance(p: Vec3, center: Vec3, radius: f64) -> f64 {
    let way = sub(p, center);
    dot(way, way).sqrt() - radius
}

impl Node {
    /// The least that a ball under each child can give, and a little less: so rounding hides nothing.
    #[inline]
    fn lower(&self, p: Vec3) -> [f64; WIDE] {
        let mut sum = [0.0; WIDE];
        for ((min, max), x) in self.min.iter().zip(&self.max).zip(p) {
            for ((sum, min), max) in sum.iter_mut().zip(min).zip(max) {
                let out = (min - x).max(x - max).max(0.0);
                *sum += out * out;
            }
        }
        std::array::from_fn(|slot| {
            let distance = sum[slot].sqrt();
            distance * (1.0 - 1e-14) - self.radius[slot] * (1.0 + 1e-14)
        })
    }
}

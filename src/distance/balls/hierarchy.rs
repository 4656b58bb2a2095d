//! Balls in a hierarchy of boxes round their centres.

use crate::boxes::{Boxes, Four, Item, Node};
use crate::error::Result;
use crate::job::{Room, Run};
use crate::points::Bounds;
use crate::vector::{Vec3, dot, sub};

/// Balls in the boxes of their centres, with the largest radius under each.
///
/// Invariants: `balls` are centres and radii in the order of the leaves.
#[derive(Clone, Debug)]
pub(super) struct Hierarchy {
    boxes: Boxes<f64>,
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
        let of = |items: &[Item]| {
            let largest = items.iter().map(|item| radii[item.number as usize]).fold(0.0, f64::max);
            (Bounds::of(items.iter().map(|item| item.middle)), largest)
        };
        let boxes = Boxes::new(&mut items, of, room, run)?;
        let ball = |item: &Item| (item.middle, radii[item.number as usize]);
        Ok(Hierarchy { boxes, balls: room.collect(items.iter().map(ball))? })
    }

    /// The least |p - c| - r of all balls.
    pub fn least(&self, p: Vec3) -> f64 {
        let mut best = f64::INFINITY;
        self.boxes.least_first(
            |node| lower(node, p),
            best,
            |places| {
                let values = self.balls[places].iter().map(|&(c, r)| signed_distance(p, c, r));
                best = values.fold(best, f64::min);
                best
            },
        );
        best
    }

    /// Whether the point is deeper than so in a ball; than 0, not on its sphere.
    pub fn holds(&self, p: Vec3, depth: f64) -> bool {
        let mut is_held = false;
        self.boxes.least_first(
            |node| lower(node, p),
            -depth,
            |places| {
                let mut balls = self.balls[places].iter();
                is_held = balls.any(|&(c, r)| signed_distance(p, c, r) < -depth);
                // One is enough.
                if is_held { f64::NEG_INFINITY } else { -depth }
            },
        );
        is_held
    }
}

/// How far a point is outside a ball; negative within it.
pub(super) fn signed_distance(p: Vec3, center: Vec3, radius: f64) -> f64 {
    let way = sub(p, center);
    dot(way, way).sqrt() - radius
}

/// The least that a ball under each child can give, and a little less: so rounding hides nothing.
#[inline]
fn lower(node: &Node<f64>, p: Vec3) -> Four {
    let squares = node.distances_squared(p);
    std::array::from_fn(|slot| {
        squares[slot].sqrt() * (1.0 - 1e-14) - node.more[slot] * (1.0 + 1e-14)
    })
}

//! Pieces in a hierarchy of boxes.

use super::closest::Shape;
use super::piece::{Foot, Piece};
use crate::boxes::{Boxes, Item};
use crate::error::Result;
use crate::job::{Room, Run};
use crate::points::Bounds;
use crate::vector::{Vec3, dot, sub};

/// Bounded pieces in their boxes, and unbounded ones, which are looked at one by one.
///
/// Invariants: `shapes` and `numbers` have the pieces in the order of the leaves, then the unbounded ones.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    boxes: Boxes<()>,
    shapes: Vec<Shape>,
    numbers: Vec<u32>,
    bounded: usize,
}

impl Tree {
    /// Cost: O(n log n).
    pub fn new(pieces: &[Piece], room: &mut Room<'_>, run: &Run<'_>) -> Result<Self> {
        let mut own = Room::new(run);
        let (mut items, mut unbounded) = (Vec::new(), Vec::new());
        for (number, piece) in (0..).zip(run.watch(pieces)) {
            match piece?.bounds() {
                Some(Bounds { min, max }) => {
                    let middle = [0, 1, 2].map(|k| 0.5 * min[k] + 0.5 * max[k]);
                    own.push(&mut items, Item { middle, number })?;
                }
                None => own.push(&mut unbounded, number)?,
            }
        }
        let bounds_of = |items: &[Item]| {
            let boxes = items.iter().filter_map(|item| pieces[item.number as usize].bounds());
            (Bounds::of(boxes.flat_map(|bounds| [bounds.min, bounds.max])), ())
        };
        let boxes = Boxes::new(&mut items, bounds_of, room, run)?;
        let order = items.iter().map(|item| item.number).chain(unbounded);
        let mut numbers = room.vec(pieces.len())?;
        numbers.extend(order);
        let shapes = room.collect(numbers.iter().map(|&i| Shape::from(&pieces[i as usize])))?;
        Ok(Tree { boxes, shapes, numbers, bounded: items.len() })
    }

    /// The nearest point of all pieces, of several as near that of the least piece. `limit` is a squared distance beyond which
    /// nothing is looked for. `None` if there is nothing.
    ///
    /// Distances are compared by their rounded squares. Rounding makes no box farther than a point in it by more than some units in the last place, and as much more is looked at.
    pub fn nearest(&self, p: Vec3, limit: f64) -> Option<Foot> {
        let mut best = Foot { point: p, distance_squared: limit, piece: u32::MAX };
        for place in self.bounded..self.shapes.len() {
            self.look(place, p, &mut best);
        }
        let limit = best.distance_squared;
        self.boxes.least_first(
            |node| lower(node.distances_squared(p)),
            limit,
            |places| {
                places.for_each(|place| self.look(place, p, &mut best));
                best.distance_squared
            },
        );
        (best.piece != u32::MAX).then_some(best)
    }

    /// Visits the nearest point of every piece that is no farther than the root of `limit`.
    pub fn within(&self, p: Vec3, limit: f64, mut visit: impl FnMut(Foot)) {
        let mut look = |place: usize| {
            let foot = self.foot(place, p);
            if foot.distance_squared <= limit {
                visit(foot);
            }
        };
        (self.bounded..self.shapes.len()).for_each(&mut look);
        self.boxes.met(|node| lower(node.distances_squared(p)).map(|lower| lower <= limit), look);
    }

    /// Visits every bounded piece whose box a ray to the right, along x in the plane, comes to.
    pub fn to_the_right(&self, p: Vec3, mut visit: impl FnMut(u32)) {
        self.boxes.met(
            |node| {
                std::array::from_fn(|slot| {
                    let [min_y, max_y] = [node.min[1][slot], node.max[1][slot]];
                    min_y <= p[1] && p[1] <= max_y && p[0] <= node.max[0][slot]
                })
            },
            |place| visit(self.numbers[place]),
        );
    }

    /// The nearest point of one piece.
    fn foot(&self, place: usize, p: Vec3) -> Foot {
        let point = self.shapes[place].closest(p);
        let way = sub(p, point);
        Foot { point, distance_squared: dot(way, way), piece: self.numbers[place] }
    }

    #[inline]
    fn look(&self, place: usize, p: Vec3, best: &mut Foot) {
        let foot = self.foot(place, p);
        let key = |foot: &Foot| (foot.distance_squared, foot.piece);
        if key(&foot) < key(best) {
            *best = foot;
        }
    }
}

/// Squared distances, a little less than they are: so rounding hides nothing.
#[inline]
fn lower<const N: usize>(squares: [f64; N]) -> [f64; N] {
    squares.map(|square| square * (1.0 - 1e-14))
}

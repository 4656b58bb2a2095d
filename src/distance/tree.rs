//! Pieces in a hierarchy of boxes, four to a node.

use super::closest::Shape;
use super::piece::{Foot, Piece};
use crate::error::Result;
use crate::job::{Room, Run};
use crate::points::Bounds;
use crate::vector::{Vec3, dot, sub};

/// The children of a node, and the most pieces in a leaf.
pub(super) const WIDE: usize = 4;
/// What may wait: three siblings a level, and levels enough for 2^32 pieces.
pub(super) const DEPTH: usize = 3 * 20 + 4;
/// A child that is a leaf: its pieces begin at the number's other bits.
pub(super) const LEAF: u32 = 1 << 31;

/// The boxes of four children, coordinate by coordinate, so that they are compared at once.
#[derive(Clone, Copy, Debug)]
struct Node {
    min: [[f64; WIDE]; 3],
    max: [[f64; WIDE]; 3],
    /// The number of a node, or [`LEAF`] and that of the first piece of a leaf.
    child: [u32; WIDE],
    /// How many pieces a leaf has; 0 for a node.
    count: [u32; WIDE],
}

/// Bounded pieces, halved again and again along the longest side of their middles' box, and unbounded ones, which are looked at one by one.
///
/// Invariants: children come after their parent, and a child's box holds the pieces under it; a child that is not there has a box that is infinitely far away. `shapes`
/// and `numbers` have the pieces in the order of the leaves, then the unbounded ones.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    nodes: Vec<Node>,
    shapes: Vec<Shape>,
    numbers: Vec<u32>,
    bounded: usize,
}

/// A piece in the making of a tree.
pub(super) struct Item {
    pub middle: Vec3,
    pub number: u32,
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
            let halves = halved(&mut items, begin, end);
            let mut node = Node {
                min: [[f64::INFINITY; WIDE]; 3],
                max: [[f64::INFINITY; WIDE]; 3],
                child: [LEAF; WIDE],
                count: [0; WIDE],
            };
            for (slot, &(begin, end)) in halves.iter().enumerate().filter(|(_, (b, e))| b < e) {
                let boxes =
                    items[begin..end].iter().filter_map(|i| pieces[i.number as usize].bounds());
                let corners = boxes.flat_map(|bounds| [bounds.min, bounds.max]);
                if let Some(bounds) = Bounds::of(corners) {
                    for k in 0..3 {
                        node.min[k][slot] = bounds.min[k];
                        node.max[k][slot] = bounds.max[k];
                    }
                }
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
        let order = items.iter().map(|item| item.number).chain(unbounded);
        let mut numbers = room.vec(pieces.len())?;
        numbers.extend(order);
        let shapes = room.collect(numbers.iter().map(|&i| Shape::from(&pieces[i as usize])))?;
        Ok(Tree { nodes, shapes, numbers, bounded: items.len() })
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
        let mut waiting = [(0.0, 0, 0); DEPTH];
        let mut count = 1;
        while count > 0 {
            count -= 1;
            let (lower, child, size): (f64, u32, u32) = waiting[count];
            if lower > best.distance_squared {
                continue;
            }
            if child & LEAF != 0 {
                let begin = (child & !LEAF) as usize;
                (begin..begin + size as usize).for_each(|place| self.look(place, p, &mut best));
                continue;
            }
            let node = &self.nodes[child as usize];
            let lower = node.distances_squared(p);
            let begin = count;
            for (slot, &lower) in lower.iter().enumerate() {
                if lower <= best.distance_squared {
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
        self.leaves(|node| node.distances_squared(p).map(|lower| lower <= limit), look);
    }

    /// Visits every bounded piece whose box a ray to the right, along x in the plane, comes to.
    pub fn to_the_right(&self, p: Vec3, mut visit: impl FnMut(u32)) {
        let is_met = |node: &Node| {
            std::array::from_fn(|slot| {
                let [min_y, max_y] = [node.min[1][slot], node.max[1][slot]];
                min_y <= p[1] && p[1] <= max_y && p[0] <= node.max[0][slot]
            })
        };
        self.leaves(is_met, |place| visit(self.numbers[place]));
    }

    /// Visits the places of all pieces in leaves of which this box and those above are met.
    fn leaves(&self, is_met: impl Fn(&Node) -> [bool; WIDE], mut visit: impl FnMut(usize)) {
        let mut waiting = [0; DEPTH];
        let mut count = 1;
        while count > 0 {
            count -= 1;
            let node = &self.nodes[waiting[count] as usize];
            let met = is_met(node);
            for slot in (0..WIDE).filter(|&slot| met[slot]) {
                match node.child[slot] & LEAF {
                    0 => {
                        waiting[count] = node.child[slot];
                        count += 1;
                    }
                    _ => {
                        let begin = (node.child[slot] & !LEAF) as usize;
                        (begin..begin + node.count[slot] as usize).for_each(&mut visit);
                    }
                }
            }
        }
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

impl Node {
    /// The squared distances to the boxes, a little less than they are: so rounding hides nothing.
    #[inline]
    fn distances_squared(&self, p: Vec3) -> [f64; WIDE] {
        let mut sum = [0.0; WIDE];
        for ((min, max), x) in self.min.iter().zip(&self.max).zip(p) {
            for ((sum, min), max) in sum.iter_mut().zip(min).zip(max) {
                let out = (min - x).max(x - max).max(0.0);
                *sum += out * out;
            }
        }
        sum.map(|sum| sum * (1.0 - 1e-14))
    }
}

/// A range of items in up to four parts, halved twice.
pub(super) fn halved(items: &mut [Item], begin: usize, end: usize) -> [(usize, usize); WIDE] {
    let mut half = |begin: usize, end: usize| {
        if end - begin <= WIDE {
            return end;
        }
        let part = &mut items[begin..end];
        let Some(bounds) = Bounds::of(part.iter().map(|item| item.middle)) else { return end };
        let extent = bounds.extent();
        let axis = (0..3).max_by(|&i, &j| extent[i].total_cmp(&extent[j])).unwrap_or(0);
        let middle = part.len() / 2;
        part.select_nth_unstable_by(middle, |a, b| {
            a.middle[axis].total_cmp(&b.middle[axis]).then(a.number.cmp(&b.number))
        });
        begin + middle
    };
    let middle = half(begin, end);
    let (first, third) = (half(begin, middle), half(middle, end));
    [(begin, first), (first, middle), (middle, third), (third, end)]
}

//! A hierarchy of boxes, four to a node.

use crate::error::Result;
use crate::job::{Room, Run};
use crate::points::Bounds;
use crate::vector::Vec3;
use std::ops::Range;

/// The children of a node, and the most items in a leaf.
const WIDE: usize = 4;
/// What may wait: three siblings a level, and levels enough for 2^32 items.
const DEPTH: usize = 3 * 20 + 4;
/// A child that is a leaf: its items begin at the number's other bits.
const LEAF: u32 = 1 << 31;

/// A number for each child of a node.
pub(crate) type Four = [f64; WIDE];

/// The boxes of four children, coordinate by coordinate, so that they are compared at once.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Node<T> {
    pub min: [Four; 3],
    pub max: [Four; 3],
    /// What else is known of each child.
    pub more: [T; WIDE],
    /// The number of a node, or [`LEAF`] and that of the first item of a leaf.
    child: [u32; WIDE],
    /// How many items a leaf has; 0 for a node.
    count: [u32; WIDE],
}

/// An item in the making of a hierarchy.
pub(crate) struct Item {
    pub middle: Vec3,
    pub number: u32,
}

/// Items, halved again and again along the longest side of their middles' box.
///
/// Invariants: children come after their parent, and a child's box holds the boxes under it; a child that is not there has a box that is infinitely far away.
#[derive(Clone, Debug)]
pub(crate) struct Boxes<T> {
    nodes: Vec<Node<T>>,
}

impl<T: Copy + Default> Boxes<T> {
    /// Puts items in the order of the leaves. Given the box of some of them, and what else is known of these.
    ///
    /// Cost: O(n log n).
    pub fn new(
        items: &mut [Item],
        of: impl Fn(&[Item]) -> (Option<Bounds>, T),
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let mut nodes = Vec::new();
        // What is still to be divided, and where it goes.
        let mut waiting = vec![(0, items.len(), None)];
        while let Some((begin, end, place)) = waiting.pop() {
            run.poll()?;
            let number = nodes.len() as u32;
            if let Some((parent, slot)) = place {
                let parent: &mut Node<T> = &mut nodes[parent as usize];
                parent.child[slot] = number;
            }
            let parts = halved(items, begin, end);
            let mut node = Node {
                min: [[f64::INFINITY; WIDE]; 3],
                max: [[f64::INFINITY; WIDE]; 3],
                more: [T::default(); WIDE],
                child: [LEAF; WIDE],
                count: [0; WIDE],
            };
            for (slot, &(begin, end)) in parts.iter().enumerate().filter(|(_, (b, e))| b < e) {
                let (bounds, more) = of(&items[begin..end]);
                node.more[slot] = more;
                if let Some(bounds) = bounds {
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
        Ok(Boxes { nodes })
    }

    /// Visits leaves, given for a node the least that is to be found under each child: of siblings the one that promises the least first, and none that promises more than the limit.
    /// A visit tells the limit from then on.
    #[inline]
    pub fn least_first(
        &self,
        lower: impl Fn(&Node<T>) -> Four,
        mut limit: f64,
        mut visit: impl FnMut(Range<usize>) -> f64,
    ) {
        let mut waiting = [(f64::NEG_INFINITY, 0, 0); DEPTH];
        let mut count = 1;
        while count > 0 {
            count -= 1;
            let (least, child, size): (f64, u32, u32) = waiting[count];
            if least > limit {
                continue;
            }
            if child & LEAF != 0 {
                let begin = (child & !LEAF) as usize;
                limit = visit(begin..begin + size as usize);
                continue;
            }
            let node = &self.nodes[child as usize];
            let begin = count;
            for (slot, &least) in lower(node).iter().enumerate() {
                if least <= limit {
                    // The least comes last, to be looked at first.
                    let mut place = count;
                    while place > begin && waiting[place - 1].0 < least {
                        waiting[place] = waiting[place - 1];
                        place -= 1;
                    }
                    waiting[place] = (least, node.child[slot], node.count[slot]);
                    count += 1;
                }
            }
        }
    }

    /// Visits the items of all leaves of which this box and those above are met.
    pub fn met(&self, is_met: impl Fn(&Node<T>) -> [bool; WIDE], mut visit: impl FnMut(usize)) {
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
}

impl<T> Node<T> {
    /// The squared distances to the boxes, rounded.
    #[inline]
    pub fn distances_squared(&self, p: Vec3) -> Four {
        let mut sum = [0.0; WIDE];
        for ((min, max), x) in self.min.iter().zip(&self.max).zip(p) {
            for ((sum, min), max) in sum.iter_mut().zip(min).zip(max) {
                let out = (min - x).max(x - max).max(0.0);
                *sum += out * out;
            }
        }
        sum
    }
}

/// A range of items in up to four parts, halved twice.
fn halved(items: &mut [Item], begin: usize, end: usize) -> [(usize, usize); WIDE] {
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

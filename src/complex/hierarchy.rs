//! Simplices in a hierarchy of boxes, for the nearest of them, for those in a box, for those whose boxes meet, and for sums over
//! all of them in which what is far away counts as one.

use super::Point;
use super::closest::distance_2;
use crate::error::Result;
use crate::job::{Room, Run};
use crate::points::Bounds;
use std::ops::Range;

/// The most simplices in a leaf.
const LEAF: usize = 4;
/// More than the depth of any hierarchy: each level halves fewer than 2^32 simplices.
pub(crate) const DEPTH: usize = 40;

/// Corners and a number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Simplex<const N: usize> {
    pub(crate) corners: [Point; N],
    pub(crate) tag: u32,
}

impl<const N: usize> Simplex<N> {
    /// The smallest box round it.
    pub(crate) fn bounds(&self) -> Bounds {
        let extreme = |pick: fn(f64, f64) -> f64| {
            std::array::from_fn(|axis| {
                self.corners[1..].iter().fold(self.corners[0][axis], |x, c| pick(x, c[axis]))
            })
        };
        Bounds { min: extreme(f64::min), max: extreme(f64::max) }
    }
}

/// A box, and the simplices in it: `simplices[begin..end]`.
#[derive(Clone, Debug)]
struct Node {
    bounds: Bounds,
    begin: u32,
    end: u32,
    /// The second of its two halves, the first being the next node; 0 for a leaf.
    second: u32,
}

/// Simplices halved again and again along the longest side of their middles' box.
///
/// Invariants: nodes stand in depth-first order, so that children come after their parent; each
/// node's box holds those of its children or simplices. All is in two flat arrays: it is freed at once.
#[derive(Clone, Debug)]
pub(crate) struct Hierarchy<const N: usize> {
    simplices: Vec<Simplex<N>>,
    nodes: Vec<Node>,
}

impl<const N: usize> Hierarchy<N> {
    /// Cost: O(n log n).
    pub(crate) fn new(
        simplices: &[Simplex<N>],
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let middle = |(i, s): (usize, &Simplex<N>)| {
            let sum = |axis: usize| s.corners.iter().map(|c| c[axis]).sum::<f64>();
            ([sum(0), sum(1), sum(2)], i as u32)
        };
        let mut order = Room::new(run).collect(simplices.iter().enumerate().map(middle))?;
        let mut nodes: Vec<Node> = Vec::new();
        let none = Bounds { min: [f64::INFINITY; 3], max: [f64::NEG_INFINITY; 3] };
        // What is still to be divided, and the node whose second half it is.
        let mut waiting = vec![(0, order.len(), None)];
        while let Some((begin, end, parent)) = waiting.pop() {
            if begin == end {
                continue;
            }
            run.poll()?;
            let number = nodes.len();
            if let Some(parent) = parent {
                let parent: &mut Node = &mut nodes[parent];
                parent.second = number as u32;
            }
            let node = Node { bounds: none, begin: begin as u32, end: end as u32, second: 0 };
            room.push(&mut nodes, node)?;
            if end - begin > LEAF {
                let part = &mut order[begin..end];
                let Some(Bounds { min, max }) = Bounds::of(part.iter().map(|(p, _)| *p)) else {
                    continue;
                };
                let longest =
                    |&i: &usize, &j: &usize| (max[i] - min[i]).total_cmp(&(max[j] - min[j]));
                let axis = (0..3).max_by(longest).unwrap_or(0);
                let half = part.len() / 2;
                part.select_nth_unstable_by(half, |a, b| {
                    a.0[axis].total_cmp(&b.0[axis]).then(a.1.cmp(&b.1))
                });
                waiting.push((begin + half, end, Some(number)));
                waiting.push((begin, begin + half, None));
            }
        }
        let simplices = room.collect(order.iter().map(|&(_, i)| simplices[i as usize]))?;
        for number in run.watch((0..nodes.len()).rev()) {
            let number = number?;
            let Node { begin, end, second, .. } = nodes[number];
            nodes[number].bounds = match second {
                0 => simplices[begin as usize..end as usize]
                    .iter()
                    .fold(none, |bounds, s| merged(&bounds, &s.bounds())),
                second => merged(&nodes[number + 1].bounds, &nodes[second as usize].bounds),
            };
        }
        Ok(Hierarchy { simplices, nodes })
    }

    /// The squared distance to the nearest simplex, if it is less than `bound`, else `bound`.
    pub(crate) fn distance_2(&self, point: Point, bound: f64) -> f64 {
        self.approach(point, bound, |simplex, least| least.min(distance_2(point, &simplex.corners)))
    }

    /// Visits simplices, nearer boxes first, whose boxes are nearer to a point than a limit, a squared distance. `visit` gets the limit and
    /// returns the next one, which is no greater. Returns the last.
    fn approach(
        &self,
        point: Point,
        limit: f64,
        mut visit: impl FnMut(&Simplex<N>, f64) -> f64,
    ) -> f64 {
        let to_box = |node: u32| {
            let Bounds { min, max } = self.nodes[node as usize].bounds;
            let out = |axis: usize| (min[axis] - point[axis]).max(point[axis] - max[axis]).max(0.0);
            let [x, y, z] = [out(0), out(1), out(2)];
            (x * x + y * y + z * z, node)
        };
        let mut limit = limit;
        let mut waiting = [(0.0, 0); DEPTH];
        let mut count = usize::from(!self.nodes.is_empty());
        while count > 0 {
            count -= 1;
            let (lower, number) = waiting[count];
            if lower >= limit {
                continue;
            }
            let node = &self.nodes[number as usize];
            if node.second == 0 {
                let simplices = &self.simplices[node.begin as usize..node.end as usize];
                limit = simplices.iter().fold(limit, |limit, simplex| visit(simplex, limit));
            } else {
                let (a, b) = (to_box(number + 1), to_box(node.second));
                // The nearer one is looked at first: it may rule out the other.
                let (near, far) = if a.0 <= b.0 { (a, b) } else { (b, a) };
                waiting[count] = far;
                waiting[count + 1] = near;
                count += 2;
            }
        }
        limit
    }

    /// Visits every simplex whose box meets the given box.
    pub(crate) fn meeting(&self, bounds: &Bounds, mut visit: impl FnMut(&Simplex<N>)) {
        let mut number = 0;
        // The end of the part of the nodes that a missed box rules out is where its sibling begins.
        let mut siblings = [0; DEPTH];
        let mut depth = 0;
        while let Some(node) = self.nodes.get(number) {
            let met = meets(&node.bounds, bounds);
            if met && node.second != 0 {
                siblings[depth] = node.second as usize;
                depth += 1;
                number += 1;
                continue;
            }
            if met {
                let simplices = &self.simplices[node.begin as usize..node.end as usize];
                simplices.iter().filter(|s| meets(&s.bounds(), bounds)).for_each(&mut visit);
            }
            if depth == 0 {
                return;
            }
            depth -= 1;
            number = siblings[depth];
        }
    }

    /// The number of nodes, to be divided among calls of [`Hierarchy::pairs`].
    pub(crate) fn node_count(&self) -> usize {
        self.nodes.len()
    }

    /// The box of a node.
    pub(crate) fn bounds(&self, node: usize) -> &Bounds {
        &self.nodes[node].bounds
    }

    /// The two halves of a node, which have greater numbers; `None` for a leaf.
    pub(crate) fn halves(&self, node: usize) -> Option<[usize; 2]> {
        match self.nodes[node].second {
            0 => None,
            second => Some([node + 1, second as usize]),
        }
    }

    /// The simplices of a node.
    pub(crate) fn simplices(&self, node: usize) -> &[Simplex<N>] {
        let Node { begin, end, .. } = self.nodes[node];
        &self.simplices[begin as usize..end as usize]
    }

    /// Visits every two simplices whose boxes meet, once, where the first is in a leaf among these nodes.
    pub(crate) fn pairs(
        &self,
        nodes: Range<usize>,
        run: &Run<'_>,
        mut visit: impl FnMut(&Simplex<N>, &Simplex<N>) -> Result<()>,
    ) -> Result<()> {
        let mut waiting = [0; DEPTH];
        for number in nodes {
            let leaf = &self.nodes[number];
            if leaf.second != 0 {
                continue;
            }
            run.poll()?;
            let mut count = 1;
            waiting[0] = 0;
            while count > 0 {
                count -= 1;
                let number = waiting[count];
                let node = &self.nodes[number as usize];
                // What is in earlier leaves has met this one before.
                if node.end <= leaf.begin || !meets(&node.bounds, &leaf.bounds) {
                    continue;
                }
                if node.second != 0 {
                    waiting[count] = node.second;
                    waiting[count + 1] = number + 1;
                    count += 2;
                    continue;
                }
                // A large leaf may meet all others.
                run.poll()?;
                for i in leaf.begin..leaf.end {
                    let first = &self.simplices[i as usize];
                    let bounds = first.bounds();
                    for j in node.begin.max(i + 1)..node.end {
                        let second = &self.simplices[j as usize];
                        if meets(&bounds, &second.bounds()) {
                            visit(first, second)?;
                        }
                    }
                }
            }
        }
        Ok(())
    }
}

impl Hierarchy<1> {
    /// The tag of the nearest point, of several as near the least; `None` if there is no point.
    ///
    /// Distances are compared by their rounded squares. Rounding makes no box farther than a point in it, so that those are all
    /// looked at that the rounded square of the least distance has.
    pub(crate) fn nearest(&self, point: Point) -> Option<u32> {
        let mut nearest: Option<(f64, u32)> = None;
        self.approach(point, f64::INFINITY, |simplex, limit| {
            let found = (distance_2(point, &simplex.corners), simplex.tag);
            if nearest.is_none_or(|best| found < best) {
                nearest = Some(found);
            }
            // What is as near may still come.
            nearest.map_or(limit, |(distance_2, _)| distance_2.next_up())
        });
        nearest.map(|(_, tag)| tag)
    }
}

fn merged(a: &Bounds, b: &Bounds) -> Bounds {
    Bounds {
        min: std::array::from_fn(|i| a.min[i].min(b.min[i])),
        max: std::array::from_fn(|i| a.max[i].max(b.max[i])),
    }
}

/// Whether two closed boxes have a point in common.
pub(crate) fn meets(a: &Bounds, b: &Bounds) -> bool {
    (0..3).all(|i| a.min[i] <= b.max[i] && b.min[i] <= a.max[i])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::Job;
    use proptest::prelude::*;

    fn hierarchy(simplices: &[Simplex<2>]) -> Hierarchy<2> {
        Job::default().run(&[], |run| Hierarchy::new(simplices, &mut Room::new(run), run)).unwrap()
    }

    /// Segments between small integers: many share their box, or have an empty one.
    fn segments() -> impl Strategy<Value = Vec<Simplex<2>>> {
        let end = || prop::array::uniform3(0..6i32).prop_map(|p| p.map(f64::from));
        let segments = prop::collection::vec([end(), end()], 0..60);
        segments.prop_map(|ends| {
            let number = |(i, corners)| Simplex { corners, tag: i as u32 };
            ends.into_iter().enumerate().map(number).collect()
        })
    }

    proptest! {
        #[test]
        fn the_nearest_is_that_of_all(
            segments in segments(),
            point in prop::array::uniform3(-3.0..9.0f64),
            bound in prop_oneof![Just(f64::INFINITY), 0.0..9.0f64],
        ) {
            let all = segments.iter().map(|s| distance_2(point, &s.corners));
            let expected = all.fold(bound, f64::min);
            prop_assert_eq!(hierarchy(&segments).distance_2(point, bound), expected);
        }

        #[test]
        fn of_points_as_near_the_least_is_found(
            points in prop::collection::vec(prop::array::uniform3(0..4i32), 0..60),
            twice in prop::array::uniform3(-3..10i32),
        ) {
            let number = |(i, p): (usize, &[i32; 3])| {
                Simplex { corners: [p.map(f64::from)], tag: 1000 - i as u32 }
            };
            let points: Vec<Simplex<1>> = points.iter().enumerate().map(number).collect();
            let made = |run: &Run<'_>| Hierarchy::new(&points, &mut Room::new(run), run);
            let hierarchy = Job::default().run(&[], made).unwrap();
            let query = twice.map(|x| 0.5 * f64::from(x));
            let all = points.iter().map(|p| (distance_2(query, &p.corners), p.tag));
            let least = all.min_by(|a, b| a.partial_cmp(b).unwrap());
            prop_assert_eq!(hierarchy.nearest(query), least.map(|(_, tag)| tag));
        }

        #[test]
        fn those_that_meet_a_box_are_visited_once(
            segments in segments(),
            min in prop::array::uniform3(-1..7i32),
            size in prop::array::uniform3(0..3i32),
        ) {
            let min = min.map(f64::from);
            let bounds = Bounds { min, max: [0, 1, 2].map(|i| min[i] + f64::from(size[i])) };
            let mut found = Vec::new();
            hierarchy(&segments).meeting(&bounds, |s| found.push(s.tag));
            found.sort_unstable();
            let expected: Vec<u32> =
                segments.iter().filter(|s| meets(&s.bounds(), &bounds)).map(|s| s.tag).collect();
            prop_assert_eq!(found, expected);
        }

        #[test]
        fn those_whose_boxes_meet_are_paired_once(segments in segments(), cut in 0..40usize) {
            let hierarchy = hierarchy(&segments);
            let count = hierarchy.node_count();
            let mut found = Vec::new();
            for nodes in [0..cut.min(count), cut.min(count)..count] {
                let pair = |s: &Simplex<2>, t: &Simplex<2>| {
                    found.push([s.tag.min(t.tag), s.tag.max(t.tag)]);
                    Ok(())
                };
                Job::default().run(&[], |run| hierarchy.pairs(nodes, run, pair)).unwrap();
            }
            found.sort_unstable();
            let mut expected = Vec::new();
            for s in &segments {
                let later = segments[s.tag as usize + 1..].iter();
                let met = later.filter(|t| meets(&s.bounds(), &t.bounds()));
                expected.extend(met.map(|t| [s.tag, t.tag]));
            }
            prop_assert_eq!(found, expected);
        }
    }
}

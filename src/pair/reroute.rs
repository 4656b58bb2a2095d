//! Other paths for the strip over a free edge, where along its own path elements would be folded (Shaham, Shamir, Cohen-Or, section 4).

use super::shell::{Kind, Refusal, Shell};
use super::surgery::Strip;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap, HashMap, HashSet};

/// The triangles on both sides of a strip that one of the ends of its inner edge sees.
pub(super) struct Region {
    /// The elements, and at which end of the edge they are.
    pub of: BTreeMap<u32, bool>,
    /// For nodes at the second end of the edge, over the strip, those at the first end.
    across: HashMap<u32, u32>,
}

impl Shell<'_> {
    /// Moves the strip over a pyramid's side to the shortest path of the boundary along which the strips over the face's other edges have no folded elements. Nothing is said where there is none.
    pub fn reroute(&mut self, side: u32, strip: &Strip, reach: usize) -> Option<()> {
        let region = self.region(strip, reach);
        let path = self.shortest(side, strip, &region)?;
        let own: HashSet<[u32; 2]> = strip
            .at_first
            .iter()
            .map(|&at| [self.side(at).node, self.side(self.side(at).next).node])
            .collect();
        let new: HashSet<[u32; 2]> = path.windows(2).map(|pair| [pair[0], pair[1]]).collect();
        // What lies between the two paths goes over to the other end.
        let node_of = |node: u32| region.across.get(&node).copied().unwrap_or(node);
        let is_crossed = |at: u32| {
            let ends = [self.side(at).node, self.side(self.side(at).next).node].map(node_of);
            let back = [ends[1], ends[0]];
            [ends, back].iter().any(|ends| own.contains(ends) || new.contains(ends))
        };
        let mut stays = HashSet::new();
        let mut waiting: Vec<u32> = Vec::new();
        for &element in region.of.keys() {
            let is_outer = self.ring(element).any(|at| {
                !is_crossed(at) && !region.of.contains_key(&self.side(self.side(at).twin).element)
            });
            if is_outer && stays.insert(element) {
                waiting.push(element);
            }
        }
        while let Some(element) = waiting.pop() {
            for at in self.ring(element) {
                let next = self.side(self.side(at).twin).element;
                if !is_crossed(at) && region.of.contains_key(&next) && stays.insert(next) {
                    waiting.push(next);
                }
            }
        }
        let goes: HashSet<u32> =
            region.of.keys().copied().filter(|element| !stays.contains(element)).collect();
        self.flip_all(side, goes)
    }

    pub fn region(&self, strip: &Strip, reach: usize) -> Region {
        let mut region = Region { of: BTreeMap::new(), across: HashMap::new() };
        for (sides, is_second) in [(&strip.at_first, false), (&strip.at_second, true)] {
            let mut waiting: std::collections::VecDeque<u32> =
                sides.iter().map(|&at| self.side(self.side(at).twin).element).collect();
            let mut count = 0;
            while let Some(element) = waiting.pop_front() {
                if self.kind(element) != Kind::Over
                    || region.of.contains_key(&element)
                    || count == reach
                {
                    continue;
                }
                region.of.insert(element, is_second);
                count += 1;
                waiting.extend(self.ring(element).map(|at| self.side(self.side(at).twin).element));
            }
        }
        for (&first, &second) in strip.at_first.iter().zip(&strip.at_second) {
            let [start, end] = [first, self.side(first).next].map(|at| self.side(at).node);
            let [back, begin] = [second, self.side(second).next].map(|at| self.side(at).node);
            region.across.insert(begin, start);
            region.across.insert(back, end);
        }
        region
    }

    /// The nodes of the shortest path.
    fn shortest(&self, side: u32, strip: &Strip, region: &Region) -> Option<Vec<u32>> {
        let mut edges: Vec<[u32; 2]> = Vec::new();
        let mut exempt: HashSet<([u32; 2], [u32; 2])> = HashSet::new();
        let mut at = self.side(side).next;
        while at != side {
            let edge = [self.ends(self.side(at).next)[1], self.ends(at)[1]];
            edges.push(edge);
            // What runs back on the next element cancels it.
            for beside in [self.side(at).twin, self.side(self.side(at).partner).twin] {
                if self.kind(self.side(beside).element) == Kind::Between {
                    let own = self.ends(beside)[0];
                    let far = self.ends(self.opposite(beside))[0];
                    exempt.insert((edge, [own, far]));
                    exempt.insert((edge, [far, own]));
                }
            }
            at = self.side(at).next;
        }
        let node_of = |node: u32| region.across.get(&node).copied().unwrap_or(node);
        let mut next: BTreeMap<u32, BTreeMap<u32, f64>> = BTreeMap::new();
        let mut add = |from: u32, to: u32| {
            for [from, to] in [[from, to], [to, from]] {
                let ends = [from, to].map(|node| self.node(node)[0]);
                let is_valid = |&edge: &[u32; 2]| {
                    exempt.contains(&(edge, ends)) || self.is_between(ends, edge)
                };
                if edges.iter().all(is_valid) {
                    let length =
                        Self::squared(self.boundary(ends[0]), self.boundary(ends[1])).sqrt();
                    next.entry(from).or_default().insert(to, length);
                }
            }
        };
        for &element in region.of.keys() {
            for at in self.ring(element) {
                add(node_of(self.side(at).node), node_of(self.side(self.side(at).next).node));
            }
        }
        for &at in &strip.at_first {
            add(self.side(at).node, self.side(self.side(at).next).node);
        }
        let start = self.side(strip.at_first[0]).node;
        let last = *strip.at_first.last()?;
        let end = self.side(self.side(last).next).node;
        let mut best: BTreeMap<u32, (f64, u32)> = BTreeMap::from([(start, (0.0, start))]);
        let mut waiting = BinaryHeap::from([Reverse((0u64, start))]);
        while let Some(Reverse((bits, node))) = waiting.pop() {
            let far = f64::from_bits(bits);
            if far > best[&node].0 {
                continue;
            }
            if node == end {
                break;
            }
            for (&to, &length) in next.get(&node).into_iter().flatten() {
                let total = far + length;
                if best.get(&to).is_none_or(|&(old, _)| total < old) {
                    best.insert(to, (total, node));
                    waiting.push(Reverse((total.to_bits(), to)));
                }
            }
        }
        let mut path = vec![end];
        while *path.last()? != start {
            path.push(best.get(path.last()?)?.1);
        }
        path.reverse();
        Some(path)
    }

    /// Moves the strip over some triangles, one after the other.
    fn flip_all(&mut self, side: u32, mut goes: HashSet<u32>) -> Option<()> {
        while !goes.is_empty() {
            let strip = self.strip(side)?;
            let sides = strip.at_first.iter().chain(&strip.at_second);
            let next =
                sides.copied().find(|&at| goes.contains(&self.side(self.side(at).twin).element))?;
            goes.remove(&self.side(self.side(next).twin).element);
            self.flip(next).ok()?;
        }
        Some(())
    }

    /// Lets the triangle beside an element between edges be seen by the other end of the inner edge.
    fn flip(&mut self, along: u32) -> Result<(), Refusal> {
        let between = self.side(along);
        let at = between.twin;
        let [one, two] = [self.side(at).next, self.side(at).previous];
        let corner = self.side(two).node;
        let other = self.opposite(along);
        let to = self.ends(other)[1];
        let new = self.add_node([self.node(corner)[0], to]);
        // The nodes at both ends of the element's boundary edge, here and across.
        let [x, y] = [between.node, self.side(between.next).node];
        let [back_y, back_x] = [self.side(other).node, self.side(self.side(other).next).node];
        let [beyond_one, beyond_two] = [one, two].map(|side| self.side(side).twin);
        let beyond_other = self.side(other).twin;
        let [at_y, at_x] = [between.next, between.previous].map(|side| self.side(side).twin);
        self.remove(self.side(at).element);
        self.remove(between.element);
        let triangle = self.add(Kind::Over, &[back_y, back_x, new]);
        let first = self.add(Kind::Between, &[x, corner, new, back_x]);
        let second = self.add(Kind::Between, &[corner, y, back_y, new]);
        self.glue(triangle, beyond_other);
        self.glue(triangle + 1, first + 2);
        self.glue(triangle + 2, second + 2);
        self.glue(first, beyond_one);
        self.glue(second, beyond_two);
        self.glue(first + 1, second + 3);
        self.glue(first + 3, at_x);
        self.glue(second + 1, at_y);
        self.zip_all(at_x)?;
        self.zip_all(at_y)
    }
}

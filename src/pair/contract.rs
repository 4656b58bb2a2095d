//! The change by which one end of an inner edge moves into the other.

use super::shell::{Kind, Refusal, Shell};
use std::collections::{BTreeMap, BTreeSet, HashSet};

/// The elements at an inner vertex.
pub(super) struct Star {
    /// The vertex.
    pub of: u32,
    /// All sides that begin at its nodes.
    sides: Vec<u32>,
    /// The inner vertices at the other ends of its edges.
    pub ends: BTreeSet<u32>,
    /// The elements, each once.
    pub elements: Vec<u32>,
}

impl Shell<'_> {
    /// The elements at the inner vertex where a side begins; none if there are more than some.
    pub fn star(&self, side: u32, most: usize) -> Option<Star> {
        let of = self.ends(side)[1];
        let mut star = Star { of, sides: Vec::new(), ends: BTreeSet::new(), elements: Vec::new() };
        let (mut seen, mut elements) = (HashSet::from([side]), HashSet::new());
        let mut waiting = vec![side];
        while let Some(at) = waiting.pop() {
            star.sides.push(at);
            if star.sides.len() > most {
                return None;
            }
            let its = self.side(at);
            if elements.insert(its.element) {
                star.elements.push(its.element);
            }
            let end = self.ends(its.next)[1];
            if end != of {
                star.ends.insert(end);
            }
            // The next side round the node; along the vertex to another node; and the other pyramid of the face.
            let round = Some(self.side(its.previous).twin);
            let along = (end == of).then_some(its.next);
            let is_pyramid = self.kind(its.element) == Kind::Pyramid;
            let through = is_pyramid.then(|| self.side(its.previous).partner);
            let next = [round, along, through].into_iter().flatten();
            waiting.extend(next.filter(|&next| seen.insert(next)));
        }
        Some(star)
    }

    /// Moves the vertex of a star into the other end of one of its edges. What lies over that edge vanishes, and what lay on both sides of it meets. No face that has the vertex may have more than
    /// three corners. Returns the sides that meet.
    pub fn contract(&mut self, star: &Star, to: u32) -> Result<Vec<u32>, Refusal> {
        let (mut gone, mut merged) = (Vec::new(), Vec::new());
        for &at in &star.sides {
            let its = self.side(at);
            let runs_out = self.ends(its.next)[1] == to;
            if runs_out {
                merged.push([its.node, self.side(its.next).node]);
            }
            if runs_out || self.ends(its.previous)[1] == to {
                gone.push(its.element);
            }
        }
        gone.sort_unstable();
        gone.dedup();
        if !is_forest(&merged) {
            return Err(Refusal);
        }
        let mut meeting: Vec<[u32; 2]> = Vec::new();
        for &element in &gone {
            let runs_along = |side: u32| {
                let ends = [self.ends(side)[1], self.ends(self.side(side).next)[1]];
                ends == [star.of, to] || ends == [to, star.of]
            };
            let sides: Vec<u32> = self.ring(element).filter(|&side| !runs_along(side)).collect();
            let &[a, b] = &sides[..] else { return Err(Refusal) };
            let twins = [a, b].map(|side| self.side(side).twin);
            if twins.iter().any(|&twin| gone.binary_search(&self.side(twin).element).is_ok()) {
                return Err(Refusal);
            }
            meeting.push(twins);
        }
        let staying: HashSet<u32> = merged.iter().map(|&[_, node]| node).collect();
        for &at in &star.sides {
            let its = self.side(at);
            self.touch(its.element);
            if self.node(its.node)[1] != to {
                self.set_inner(its.node, to);
            }
        }
        for &element in &gone {
            self.remove(element);
        }
        for &[a, b] in &meeting {
            self.glue(a, b);
        }
        for &[a, b] in &meeting {
            for side in [a, b, self.side(a).next, self.side(b).next] {
                if staying.contains(&self.side(side).node) {
                    self.unite_round(side);
                }
            }
        }
        Ok(meeting.into_flattened())
    }
}

/// Whether pairs are the edges of a graph without cycles.
fn is_forest(pairs: &[[u32; 2]]) -> bool {
    let mut next: BTreeMap<u32, u32> = BTreeMap::new();
    let find = |next: &BTreeMap<u32, u32>, mut at: u32| {
        while let Some(&further) = next.get(&at) {
            at = further;
        }
        at
    };
    pairs.iter().all(|pair| {
        let [a, b] = pair.map(|node| find(&next, node));
        next.insert(a, b);
        a != b
    })
}

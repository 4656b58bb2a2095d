//! Minimum cuts: where a network gives way between supply and demand.

use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use std::collections::VecDeque;

/// The parent of a node that has supply left.
const ROOT: u32 = NONE - 1;
/// The parent of a node that has lost its own, until it finds another.
const ORPHAN: u32 = NONE - 2;

/// A network of nodes with supply or demand, joined by arcs of limited room.
///
/// Arc i leads from the node in whose row of `offsets` it is to `heads[i]`; `twins[i]` leads back. Invariant: what one of the
/// two gains in `rest` the other loses.
pub(super) struct Network<'a> {
    pub offsets: &'a [u32],
    pub heads: &'a [u32],
    pub twins: &'a [u32],
    /// How much more an arc can carry.
    pub rest: Vec<i32>,
    /// What a node can give, or take if negative.
    pub supply: Vec<i64>,
}

/// Paths from the supply along arcs with room: a forest (Boykov, Kolmogorov 2004, *An experimental comparison of min-cut/max-flow
/// algorithms*, section 3), but from one side only, since the nodes that supply reaches are all that is asked for.
///
/// Invariants between steps: `parent` of a node is an arc to its parent, whose twin has room; ROOT for those with supply;
/// NONE for nodes that are not reached. A node whose arcs might reach another has a place in `active`.
struct Forest<'n, 'a> {
    network: &'n mut Network<'a>,
    parent: Vec<u32>,
    /// The number of arcs to the root, as of the step `seen`.
    depth: Vec<u32>,
    seen: Vec<u32>,
    step: u32,
    active: VecDeque<u32>,
    waits: Vec<bool>,
    orphans: Vec<u32>,
    /// The number of arcs looked at.
    looks: usize,
}

impl Network<'_> {
    /// Sends as much as possible from supply to demand; then tells the nodes that supply still reaches, the smallest side of
    /// any minimum cut. Which they are depends on no order. Cost: a few passes over the arcs where little is in the way,
    /// without a useful bound otherwise: `None` if it is more than `passes` of them.
    pub fn reached(
        &mut self,
        passes: usize,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Option<Vec<bool>>> {
        let most = passes * self.heads.len();
        let count = self.supply.len();
        let mut forest = Forest {
            parent: room.filled(count, NONE)?,
            depth: room.filled(count, 0)?,
            seen: room.filled(count, 0)?,
            step: 0,
            active: VecDeque::new(),
            waits: room.filled(count, false)?,
            orphans: Vec::new(),
            looks: 0,
            network: self,
        };
        // Each node waits at most once.
        room.keep(count * size_of::<u32>())?;
        for node in run.watch(0..count as u32) {
            let node = node?;
            if forest.network.supply[node as usize] > 0 {
                forest.parent[node as usize] = ROOT;
                forest.wake(node);
            }
        }
        let mut polled = 0u32;
        while let Some(node) = forest.active.pop_front() {
            forest.waits[node as usize] = false;
            polled = polled.wrapping_add(1);
            if polled.is_multiple_of(256) {
                run.poll()?;
            }
            forest.grow(node, run)?;
            if forest.looks > most {
                return Ok(None);
            }
        }
        let parent = forest.parent;
        room.collect(parent.iter().map(|&parent| parent != NONE)).map(Some)
    }
}

impl Forest<'_, '_> {
    fn wake(&mut self, node: u32) {
        if !std::mem::replace(&mut self.waits[node as usize], true) {
            self.active.push_back(node);
        }
    }

    fn arcs(&self, node: u32) -> std::ops::Range<u32> {
        self.network.offsets[node as usize]..self.network.offsets[node as usize + 1]
    }

    /// Where an arc leads.
    fn head(&self, arc: u32) -> u32 {
        self.network.heads[arc as usize]
    }

    fn has_room(&self, arc: u32) -> bool {
        self.network.rest[arc as usize] > 0
    }

    /// Reaches on from a node, and serves the demand that it meets.
    fn grow(&mut self, node: u32, run: &Run<'_>) -> Result<()> {
        for arc in self.arcs(node) {
            self.looks += 1;
            let other = self.head(arc);
            let twin = self.network.twins[arc as usize];
            while self.network.supply[other as usize] < 0
                && self.has_room(arc)
                && self.parent[node as usize] != NONE
            {
                run.poll()?;
                self.send(node, arc);
            }
            if self.parent[node as usize] == NONE {
                // Whoever can reach it again has been woken.
                return Ok(());
            }
            if !self.has_room(arc) {
                continue;
            }
            let (at, to) = (node as usize, other as usize);
            if self.parent[to] == NONE {
                self.parent[to] = twin;
                self.depth[to] = self.depth[at] + 1;
                self.seen[to] = self.seen[at];
                self.wake(other);
            } else if self.parent[to] != ROOT
                && self.seen[to] <= self.seen[at]
                && self.depth[to] > self.depth[at] + 1
            {
                // A shorter way to the root.
                self.parent[to] = twin;
                self.depth[to] = self.depth[at] + 1;
                self.seen[to] = self.seen[at];
            }
        }
        Ok(())
    }

    /// Sends what it can from the root of a node along the path to it, and on by an arc to a node that demands.
    fn send(&mut self, node: u32, last: u32) {
        let demanding = self.head(last) as usize;
        let mut amount =
            i64::from(self.network.rest[last as usize]).min(-self.network.supply[demanding]);
        let mut at = node;
        while self.parent[at as usize] != ROOT {
            self.looks += 1;
            let up = self.parent[at as usize];
            let down = self.network.twins[up as usize];
            amount = amount.min(i64::from(self.network.rest[down as usize]));
            at = self.head(up);
        }
        amount = amount.min(self.network.supply[at as usize]);
        // No arc has more room than an i32 holds.
        let moved = amount as i32;
        let network = &mut *self.network;
        network.supply[demanding] += amount;
        network.supply[at as usize] -= amount;
        network.rest[last as usize] -= moved;
        network.rest[network.twins[last as usize] as usize] += moved;
        if network.supply[at as usize] == 0 {
            self.cut_off(at);
        }
        let root = at;
        let mut at = node;
        while at != root {
            // An orphan's arc is still needed to go on.
            let up = self.parent[at as usize];
            let down = self.network.twins[up as usize];
            let next = self.head(up);
            self.network.rest[down as usize] -= moved;
            self.network.rest[up as usize] += moved;
            if self.network.rest[down as usize] == 0 {
                self.cut_off(at);
            }
            at = next;
        }
        self.step += 1;
        while let Some(orphan) = self.orphans.pop() {
            self.adopt(orphan);
        }
    }

    fn cut_off(&mut self, node: u32) {
        self.parent[node as usize] = ORPHAN;
        self.orphans.push(node);
    }

    /// Finds the parent nearest to a root for an orphan; without any it is not reached, and its children are orphans.
    fn adopt(&mut self, orphan: u32) {
        let mut best: Option<(u32, u32)> = None;
        self.looks += self.arcs(orphan).len();
        for arc in self.arcs(orphan) {
            if !self.has_room(self.network.twins[arc as usize]) {
                continue;
            }
            if let Some(depth) = self.depth_of(self.head(arc))
                && best.is_none_or(|(least, _)| depth < least)
            {
                best = Some((depth, arc));
            }
        }
        if let Some((depth, arc)) = best {
            self.parent[orphan as usize] = arc;
            self.depth[orphan as usize] = depth + 1;
            self.seen[orphan as usize] = self.step;
            return;
        }
        self.parent[orphan as usize] = NONE;
        for arc in self.arcs(orphan) {
            let other = self.head(arc);
            let up = self.parent[other as usize];
            if up == NONE {
                continue;
            }
            if self.has_room(self.network.twins[arc as usize]) {
                self.wake(other);
            }
            if up < ORPHAN && self.head(up) == orphan {
                self.cut_off(other);
            }
        }
    }

    /// How far a node is from its root; `None` if its path ends at an orphan, or it is not reached.
    fn depth_of(&mut self, node: u32) -> Option<u32> {
        let mut above = 0;
        let mut at = node;
        let depth = loop {
            let up = self.parent[at as usize];
            if up == ROOT {
                self.depth[at as usize] = 0;
                break above;
            }
            if up >= ORPHAN {
                return None;
            }
            if self.seen[at as usize] == self.step {
                break above + self.depth[at as usize];
            }
            above += 1;
            self.looks += 1;
            at = self.head(up);
        };
        // What was walked over knows its depth for the rest of this step.
        let (mut at, mut left) = (node, depth);
        while self.parent[at as usize] != ROOT && self.seen[at as usize] != self.step {
            self.seen[at as usize] = self.step;
            self.depth[at as usize] = left;
            left -= 1;
            at = self.head(self.parent[at as usize]);
        }
        Some(depth)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::Job;
    use proptest::prelude::*;

    proptest! {
        /// Against all sides: what a cut costs is the room that leads out of it, what it leaves unsent of the supply and what it must take.
        #[test]
        fn reached_is_the_smallest_side_of_a_least_cut(
            supply in prop::collection::vec(-9..10i64, 2..8),
            pairs in prop::collection::vec((0..8usize, 0..8usize, 0..9i32, 0..9i32), 0..20),
        ) {
            let count = supply.len();
            let pairs: Vec<_> = pairs.into_iter().filter(|&(a, b, ..)| a < count && b < count && a != b).collect();
            let mut rows = vec![Vec::new(); count];
            for (k, &(a, b, there, back)) in pairs.iter().enumerate() {
                rows[a].push((b, there, 2 * k));
                rows[b].push((a, back, 2 * k + 1));
            }
            let mut offsets = vec![0u32];
            let (mut heads, mut rest, mut place) = (Vec::new(), Vec::new(), vec![0; 2 * pairs.len()]);
            for row in &rows {
                for &(to, room, k) in row {
                    place[k] = heads.len();
                    heads.push(to as u32);
                    rest.push(room);
                }
                offsets.push(heads.len() as u32);
            }
            let mut twins = vec![0u32; heads.len()];
            for k in 0..place.len() {
                twins[place[k]] = place[k ^ 1] as u32;
            }
            let cost = |side: u32| -> i64 {
                let within = |node: usize| side >> node & 1 == 1;
                let terminals = supply.iter().enumerate().map(|(node, &supply)| match within(node) {
                    true => (-supply).max(0),
                    false => supply.max(0),
                });
                let arcs = pairs.iter().map(|&(a, b, there, back)| match (within(a), within(b)) {
                    (true, false) => i64::from(there),
                    (false, true) => i64::from(back),
                    _ => 0,
                });
                terminals.chain(arcs).sum()
            };
            let least = (0..1u32 << count).map(cost).min().unwrap();
            let sides = (0..1u32 << count).filter(|&side| cost(side) == least);
            let smallest = sides.fold(u32::MAX, |a, b| a & b);
            let mut network = Network { offsets: &offsets, heads: &heads, twins: &twins, rest, supply: supply.clone() };
            let reached = Job::default().run(&[], |run| network.reached(1000, &mut Room::new(run), run));
            let reached = reached.unwrap().unwrap();
            let reached = (0..count).fold(0, |bits, node| bits | u32::from(reached[node]) << node);
            prop_assert_eq!(reached, smallest);
        }
    }

    #[test]
    fn gives_up_where_it_takes_too_long() {
        let mut network = Network {
            offsets: &[0, 1, 2],
            heads: &[1, 0],
            twins: &[1, 0],
            rest: vec![1, 0],
            supply: vec![1, -1],
        };
        let reached = Job::default().run(&[], |run| network.reached(0, &mut Room::new(run), run));
        assert_eq!(reached.unwrap(), None);
    }
}

//! The two sides of each arc of the medial axis: parts of walks between the places where what is opposite changes.

use super::envelope::{Break, Envelope, Touch};
use crate::complex::DisjointSets;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::vector::{Vec3, dot, sub};

/// How often breaks are sought again where the two sides of arcs do not agree.
const ROUNDS: usize = 12;
/// How far apart both sides of an arc may see its ends, as a share of the size: where a ball barely touches, rounding moves it along the arc.
const NEAR: f64 = 1e-5;

/// Where arcs meet or end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    pub center: Vec3,
    pub radius: f64,
}

/// A place on a walk: the number of a feature, and how far on it is.
pub(super) type Position = f64;

/// A part of a walk which sees an arc, from one node to another, or all of a walk if it has no node.
#[derive(Clone, Copy, Debug)]
pub(super) struct ArcSide {
    /// Where it begins and ends: as features are numbered, but beyond the last one of the walk where it goes round its end.
    pub span: [Position; 2],
    /// The nodes, or [`NONE`] of a loop.
    pub nodes: [u32; 2],
    /// The side of the same arc that is opposite.
    pub partner: u32,
    /// Whether that has this one opposite.
    pub agrees: bool,
}

/// All sides of arcs, and the nodes.
///
/// Invariants: sides of a walk follow one another; the partner of a side's partner is the side, unless rounding has got the better of it, or the rim cuts the arc.
#[derive(Clone, Debug, Default)]
pub(super) struct ArcSides {
    pub nodes: Vec<Node>,
    pub sides: Vec<ArcSide>,
}

/// A node of a walk.
#[derive(Clone, Copy)]
struct Contact {
    at: Position,
    node: u32,
}

impl Envelope<'_> {
    /// Finds the breaks and joins what lies between them, until both sides of every arc agree.
    pub fn arc_sides(&self, tolerance: f64, room: &mut Room<'_>) -> Result<ArcSides> {
        let run = self.run;
        let count = self.walks.features.len();
        let mut hints: Vec<Vec<f64>> = vec![Vec::new(); count];
        let mut breaks: Vec<Vec<Break>> = room.collect((0..count).map(|_| Vec::new()))?;
        let mut changed: Vec<usize> = (0..count).collect();
        let mut round = 0;
        loop {
            self.find_breaks(&changed, &hints, &mut breaks)?;
            let mut found = self.between(&breaks, tolerance, room, run)?;
            let new = self.pair(&mut found, run)?;
            round += 1;
            // Features without a new place have the breaks that they had. Where the rim cuts an arc its sides never agree, and ask for the same places again.
            changed.clear();
            for (feature, u) in new {
                let hints = &mut hints[feature as usize];
                if !hints.contains(&u) {
                    hints.push(u);
                    changed.push(feature as usize);
                }
            }
            if changed.is_empty() || round == ROUNDS {
                unite(&mut found, room, run)?;
                return Ok(found);
            }
            changed.sort_unstable();
            changed.dedup();
        }
    }

    /// The parts of the walks between breaks and corners.
    fn between(
        &self,
        breaks: &[Vec<Break>],
        tolerance: f64,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<ArcSides> {
        let mut spots: Vec<Node> = Vec::new();
        let mut contacts: Vec<Vec<Contact>> = vec![Vec::new(); self.walks.walks.len()];
        for (walk, contacts) in self.walks.walks.iter().zip(&mut contacts) {
            run.poll()?;
            for feature in walk.clone() {
                for &Break { u, center, radius, .. } in &breaks[feature] {
                    let node = spots.len() as u32;
                    // The end of a walk is its begin; its number is the next walk's.
                    let is_end = feature as f64 + u >= walk.end as f64;
                    let at = if is_end { walk.start as f64 } else { feature as f64 + u };
                    contacts.push(Contact { at, node });
                    room.push(&mut spots, Node { center, radius })?;
                }
                if self.walks.is_corner[feature] {
                    let center = self.walks.features[feature].place(1.0).at;
                    let at = self.walks.after(feature) as f64;
                    contacts.push(Contact { at, node: spots.len() as u32 });
                    room.push(&mut spots, Node { center, radius: 0.0 })?;
                }
            }
        }
        let (nodes, node_of) = clustered(&spots, tolerance, room, run)?;
        let mut found = ArcSides { nodes, ..ArcSides::default() };
        for (number, contacts) in contacts.iter_mut().enumerate() {
            let walk = &self.walks.walks[number];
            contacts.iter_mut().for_each(|contact| contact.node = node_of[contact.node as usize]);
            contacts.sort_by(|a, b| a.at.total_cmp(&b.at));
            let length = walk.len() as f64;
            if contacts.is_empty() {
                let begin = walk.start as f64;
                let side = ArcSide {
                    span: [begin, begin + length],
                    nodes: [NONE; 2],
                    partner: NONE,
                    agrees: false,
                };
                room.push(&mut found.sides, side)?;
                continue;
            }
            for (i, from) in contacts.iter().enumerate() {
                let to = contacts[(i + 1) % contacts.len()];
                let end = if i + 1 < contacts.len() { to.at } else { to.at + length };
                let side = ArcSide {
                    span: [from.at, end],
                    nodes: [from.node, to.node],
                    partner: NONE,
                    agrees: false,
                };
                // What two breaks at one node leave between them is nothing, or beyond the rim.
                let is_nothing = from.node == to.node
                    && self.touch_of(number, 0.5 * (from.at + end)).is_none_or(|touch| {
                        let node = found.nodes[from.node as usize];
                        let way = sub(touch.point.center, node.center);
                        dot(way, way) <= 4.0 * tolerance * tolerance
                    });
                if !is_nothing {
                    room.push(&mut found.sides, side)?;
                }
            }
        }
        Ok(found)
    }

    /// The feature and the place on it of a position, which may lie beyond the end of its walk.
    fn unwound(&self, walk: usize, at: Position) -> (usize, f64) {
        let walk = &self.walks.walks[walk];
        let (begin, length) = (walk.start as f64, walk.len() as f64);
        let at = if at >= begin + length { at - length } else { at };
        let feature = (at.floor() as usize).clamp(walk.start, walk.end - 1);
        (feature, (at - feature as f64).clamp(0.0, 1.0))
    }

    /// The medial ball that touches a position, which may lie beyond the end of its walk.
    pub fn touch_of(&self, walk: usize, at: Position) -> Option<Touch> {
        let (feature, u) = self.unwound(walk, at);
        self.touch(feature, u)
    }

    fn walk_at(&self, at: Position) -> usize {
        let feature = (at.floor() as usize).min(self.walks.features.len() - 1);
        self.walks.walk_of[feature] as usize
    }

    /// Finds the partner of each side; where the two do not agree, gives the places that would have shown it.
    fn pair(&self, found: &mut ArcSides, run: &Run<'_>) -> Result<Vec<(u32, f64)>> {
        let parts = found.sides.chunks(64).collect::<Vec<_>>();
        let middles = run.in_steps(parts, [0.4, 0.5], |sides| {
            run.poll()?;
            let middle = |side: &ArcSide| {
                let walk = self.walk_of(side);
                self.touch_of(walk, 0.5 * (side.span[0] + side.span[1]))
            };
            Ok(sides.iter().map(middle).collect::<Vec<_>>())
        })?;
        let middles: Vec<Option<Touch>> = middles.into_iter().flatten().collect();
        // Beyond the rim there is no arc.
        let mut is_arc = middles.iter().map(Option::is_some);
        found.sides.retain(|_| is_arc.next() == Some(true));
        let middles: Vec<Touch> = middles.into_iter().flatten().collect();
        let partners: Vec<u32> = middles
            .iter()
            .map(|touch| self.side_at(&found.sides, touch.opposite).unwrap_or(NONE))
            .collect();
        let mut new = Vec::new();
        for (i, touch) in middles.iter().enumerate() {
            let partner = partners[i];
            let agrees = partner != NONE
                && partners[partner as usize] == i as u32
                && self.has_ends_of(found, [i, partner as usize]);
            (found.sides[i].partner, found.sides[i].agrees) = (partner, agrees);
            if !agrees {
                new.push(touch.opposite);
                // What is opposite in the middle of the partner may part what comes before it and behind it, and is the same.
                let sides = [Some(&found.sides[i]), found.sides.get(partner as usize)];
                new.extend(sides.into_iter().flatten().map(|side| {
                    let middle = 0.5 * (side.span[0] + side.span[1]);
                    let (feature, u) = self.unwound(self.walk_of(side), middle);
                    (feature as u32, u)
                }));
                // What is opposite may see the ends of the arc, and something else between them.
                let opposite = touch.opposite.0;
                let ends = found.sides[i].nodes.into_iter().filter(|&node| node != NONE);
                let feature = &self.walks.features[opposite as usize];
                let ends: Vec<f64> =
                    ends.map(|n| feature.number(found.nodes[n as usize].center)).collect();
                let middle = 0.5 * ends.iter().sum::<f64>();
                let between = [middle, (middle + 0.5).rem_euclid(1.0)];
                new.extend(ends.into_iter().chain(between).map(|u| (opposite, u)));
            }
        }
        Ok(new)
    }

    /// Whether a side ends where another one begins, and begins where that ends: so both see all of one arc.
    fn has_ends_of(&self, found: &ArcSides, [i, j]: [usize; 2]) -> bool {
        let ([a, b], [d, c]) = (found.sides[i].nodes, found.sides[j].nodes);
        let near = NEAR * self.search.sites.size();
        [[a, c], [b, d]].iter().all(|&[p, q]| match p == NONE || q == NONE {
            true => p == q,
            false => {
                let [p, q] = [p, q].map(|node| found.nodes[node as usize].center);
                let way = sub(p, q);
                dot(way, way) <= near * near
            }
        })
    }

    /// The walk of a side.
    pub fn walk_of(&self, side: &ArcSide) -> usize {
        self.walk_at(side.span[0])
    }

    /// The side that holds a place of a feature.
    fn side_at(&self, sides: &[ArcSide], (feature, u): (u32, f64)) -> Option<u32> {
        let walk = &self.walks.walks[self.walks.walk_of[feature as usize] as usize];
        let at = f64::from(feature) + u;
        let holds = |i: usize, at: f64| {
            let [begin, end] = sides[i].span;
            // Beyond the end of a walk are the numbers of the next one.
            let is_of_walk = walk.start as f64 <= begin && begin < walk.end as f64;
            is_of_walk && begin <= at && at <= end
        };
        let after = sides.partition_point(|side| side.span[0] <= at);
        let last = sides.partition_point(|side| side.span[0] < walk.end as f64);
        // The last side of a walk may go on beyond its end.
        let candidates = [
            after.checked_sub(1).map(|i| (i, at)),
            last.checked_sub(1).map(|i| (i, at)),
            last.checked_sub(1).map(|i| (i, at + walk.len() as f64)),
        ];
        candidates.into_iter().flatten().find(|&(i, at)| holds(i, at)).map(|(i, _)| i as u32)
    }
}

/// Makes one node of those at which both sides of an arc end.
fn unite(found: &mut ArcSides, room: &mut Room<'_>, run: &Run<'_>) -> Result<()> {
    let mut sets = DisjointSets::new(found.nodes.len(), run)?;
    for side in run.watch(found.sides.iter().filter(|side| side.agrees)) {
        let side = side?;
        let other = found.sides[side.partner as usize].nodes;
        if side.nodes[0] != NONE {
            sets.join(side.nodes[0], other[1]);
            sets.join(side.nodes[1], other[0]);
        }
    }
    let mut node_of = room.vec(found.nodes.len())?;
    node_of.extend((0..found.nodes.len() as u32).map(|node| sets.root(node)));
    for node in found.sides.iter_mut().flat_map(|side| &mut side.nodes) {
        if *node != NONE {
            *node = node_of[*node as usize];
        }
    }
    Ok(())
}

/// Spots that are no farther apart than a tolerance become one node, that of the first; gives for each its node.
fn clustered(
    spots: &[Node],
    tolerance: f64,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<(Vec<Node>, Vec<u32>)> {
    let mut order: Vec<u32> = room.collect(0..spots.len() as u32)?;
    let at = |i: u32| spots[i as usize].center;
    order.sort_by(|&i, &j| at(i)[0].total_cmp(&at(j)[0]).then(i.cmp(&j)));
    let mut sets = DisjointSets::new(spots.len(), run)?;
    for place in run.watch(0..order.len()) {
        let place = place?;
        let p = at(order[place]);
        for &other in order[place + 1..].iter().take_while(|&&j| at(j)[0] - p[0] <= tolerance) {
            let way = sub(at(other), p);
            // Corners of several sectors at one point are apart: the boundary is between them.
            let are_corners = [order[place], other].map(|i| spots[i as usize].radius) == [0.0; 2];
            if dot(way, way) <= tolerance * tolerance && !are_corners {
                sets.join(order[place], other);
            }
        }
    }
    let (mut nodes, mut node_of) = (Vec::new(), room.filled(spots.len(), NONE)?);
    let mut of_root = room.filled(spots.len(), NONE)?;
    for spot in 0..spots.len() as u32 {
        let root = sets.root(spot) as usize;
        if of_root[root] == NONE {
            of_root[root] = nodes.len() as u32;
            room.push(&mut nodes, spots[spot as usize])?;
        }
        node_of[spot as usize] = of_root[root];
    }
    Ok((nodes, node_of))
}

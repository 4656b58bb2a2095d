//! Labels that contradict each other as little as can be found.
//!
//! The queue of Figure 8 never takes a label back. Where a sample is noisy or seen from one side only, a wrong label
//! spreads to a whole region, and on its border links ask for what they do not get. Kolluri, Shewchuk and O'Brien 2004 (*Spectral surface reconstruction
//! from noisy point clouds*) cut the same graph of poles by an eigenvector; here the weight of the links that are cut wrongly is
//! lowered itself, by minimum cuts.
//!
//! All is in integers, and depends on neither threads nor the order of rows.

use super::cut::Network;
use super::label::Label;
use super::links::Links;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};

/// The cost of a link of weight 1.
const UNIT: f64 = 65536.0;
/// More than all links together cost.
const FIRM: i64 = 1 << 50;
/// How often regions are tried at most: the first few rounds gain nearly all.
const ROUNDS: u32 = 8;
/// How many passes over all links a cut may take. Where the labels are a guess anyway a cut can take thousands; where it tells much it takes
/// ten.
const PASSES: usize = 60;

/// The cost of a link whose labels are not what it asks for: the square of its weight. Compared with the weight itself, the many links that are hardly deep
/// count little, which has labelled more poles rightly on samples whose labels are known.
fn cost(weight: f64) -> i32 {
    (weight * weight * UNIT) as i32
}

/// How much labels contradict each other, for each pole in the mean.
pub(super) fn of(links: &Links, labels: &[Label], run: &Run<'_>) -> Result<f64> {
    let mut sum = 0u64;
    let mut broken = Vec::new();
    for pole in run.watch(0..links.count() as u32) {
        let pole = pole?;
        let own = labels[pole as usize];
        let later = links.of(pole).iter().filter(|link| link.other > pole);
        broken.clear();
        broken.extend(later.filter(|link| !link.agrees(own, labels[link.other as usize])).copied());
        broken.sort_unstable_by(|a, b| a.other.cmp(&b.other).then(a.weight.total_cmp(&b.weight)));
        broken.dedup_by(|a, b| a.is_same_deep(b));
        sum += broken.iter().map(|link| cost(link.weight) as u64).sum::<u64>();
    }
    Ok(sum as f64 / UNIT / links.count().max(1) as f64)
}

/// The links as a graph: each once in either pole's row, ascending by the other pole.
///
/// Invariant: `twins[i]` is where link i stands in the other's row.
struct Graph {
    offsets: Vec<u32>,
    others: Vec<u32>,
    twins: Vec<u32>,
    /// Negative for links that ask for different labels.
    costs: Vec<i32>,
}

impl Graph {
    fn new(links: &Links, room: &mut Room<'_>, run: &Run<'_>) -> Result<Self> {
        let count = links.count();
        let most = (0..count as u32).map(|pole| links.of(pole).len()).sum();
        let mut graph = Graph {
            offsets: room.vec(count + 1)?,
            others: room.vec(most)?,
            twins: Vec::new(),
            costs: room.vec(most)?,
        };
        graph.offsets.push(0);
        let mut row = Vec::new();
        for pole in run.watch(0..count as u32) {
            row.clear();
            row.extend_from_slice(links.of(pole?));
            row.sort_unstable_by(|a, b| a.other.cmp(&b.other).then(a.weight.total_cmp(&b.weight)));
            row.dedup_by(|a, b| a.is_same_deep(b));
            for link in &row {
                graph.others.push(link.other);
                graph.costs.push(if link.weight < 0.0 {
                    -cost(link.weight)
                } else {
                    cost(link.weight)
                });
            }
            graph.offsets.push(graph.others.len() as u32);
        }
        // Links to lesser poles come first in each row, in the order in which those are visited.
        graph.twins = room.filled(graph.others.len(), NONE)?;
        let mut next = room.collect(graph.offsets[..count].iter().copied())?;
        for pole in run.watch(0..count) {
            let pole = pole?;
            for i in graph.offsets[pole]..graph.offsets[pole + 1] {
                let other = graph.others[i as usize] as usize;
                if other > pole {
                    let twin = next[other];
                    next[other] += 1;
                    graph.twins[i as usize] = twin;
                    graph.twins[twin as usize] = i;
                }
            }
        }
        Ok(graph)
    }

    fn row(&self, pole: usize) -> std::ops::Range<usize> {
        self.offsets[pole] as usize..self.offsets[pole + 1] as usize
    }

    fn count(&self) -> usize {
        self.offsets.len() - 1
    }

    /// What the labels cost.
    fn cost(&self, labels: &[Label]) -> i64 {
        let row = |pole: usize| self.row(pole).filter(move |&i| !self.agrees(pole, i, labels));
        (0..self.count()).flat_map(row).map(|i| i64::from(self.costs[i].abs())).sum::<i64>() / 2
    }

    fn agrees(&self, pole: usize, link: usize, labels: &[Label]) -> bool {
        (self.costs[link] < 0) == (labels[pole] != labels[self.others[link] as usize])
    }
}

/// Changes labels until they contradict each other as little as can be found. Those of `outer` poles become and stay outer. The conflict never
/// grows, but for these.
pub(super) fn settle(
    links: &Links,
    outer: &[bool],
    labels: &mut [Label],
    run: &Run<'_>,
) -> Result<()> {
    let mut room = Room::new(run);
    let graph = Graph::new(links, &mut room, run)?;
    for (label, _) in labels.iter_mut().zip(outer).filter(|&(_, &outer)| outer) {
        *label = Label::Outer;
    }
    settle_where_certain(&graph, outer, labels, run)?;
    settle_regions(&graph, outer, labels, run)
}

/// Gives each pole the label that it has in every labelling of least conflict, as far as roof duality tells (Hammer, Hansen, Simeone 1984;
/// Boros, Hammer, Sun 1991; Kolmogorov, Rother 2007, *Minimizing nonsubmodular functions with graph cuts*).
///
/// Each pole has two nodes, one that is reached if it is outer and one that is not. A link that asks for the same label joins the two of one
/// kind, one that asks for different labels each with that of the other kind: where the links of a region can
/// all have what they ask for, there is no path from the first node of a pole to its second.
fn settle_where_certain(
    graph: &Graph,
    outer: &[bool],
    labels: &mut [Label],
    run: &Run<'_>,
) -> Result<()> {
    let mut room = Room::new(run);
    let (count, arcs) = (graph.count(), graph.others.len());
    let mut offsets = room.vec(2 * count + 1)?;
    let (mut heads, mut twins) = (room.vec(2 * arcs)?, room.vec(2 * arcs)?);
    let mut rest = room.vec(2 * arcs)?;
    for copy in 0..2 {
        let first = copy * arcs;
        offsets.extend(graph.offsets[..count].iter().map(|offset| offset + first as u32));
        for i in run.watch(0..arcs) {
            let i = i?;
            // A link that asks for different labels leads to the other copy.
            let to = if graph.costs[i] < 0 { 1 - copy } else { copy };
            heads.push(graph.others[i] + (to * count) as u32);
            twins.push(graph.twins[i] + (to * arcs) as u32);
            rest.push(graph.costs[i].abs());
        }
    }
    offsets.push(2 * arcs as u32);
    let mut supply = room.filled(2 * count, 0i64)?;
    for pole in (0..count).filter(|&pole| outer[pole]) {
        supply[pole] = FIRM;
        supply[count + pole] = -FIRM;
    }
    let mut network = Network { offsets: &offsets, heads: &heads, twins: &twins, rest, supply };
    let Some(reached) = network.reached(PASSES, &mut room, run)? else { return Ok(()) };
    for (pole, label) in labels.iter_mut().enumerate() {
        match (reached[pole], reached[count + pole]) {
            (true, false) => *label = Label::Outer,
            (false, true) => *label = Label::Inner,
            _ => {}
        }
    }
    Ok(())
}

/// Changes the labels of whole regions at once while that lowers the conflict.
///
/// Changing a set of poles costs the links that agree now and leave the set, and gains those that do not. A gain from a link between two poles cannot be
/// cut; it is underestimated by granting it to one of the two, and charging it if the other changes. So a minimum cut never raises
/// the conflict, and changes the region that gains most by that estimate. To which of the two is decided anew each round.
fn settle_regions(
    graph: &Graph,
    outer: &[bool],
    labels: &mut [Label],
    run: &Run<'_>,
) -> Result<()> {
    let mut best = graph.cost(labels);
    let mut idle = 0;
    for round in 0..ROUNDS {
        run.tick(round as usize, ROUNDS as usize)?;
        let mut room = Room::new(run);
        let mut rest = room.vec(graph.others.len())?;
        let mut supply = room.filled(graph.count(), 0i64)?;
        for pole in run.watch(0..graph.count()) {
            let pole = pole?;
            if outer[pole] {
                supply[pole] -= FIRM;
            }
            for i in graph.row(pole) {
                let cost = graph.costs[i].abs();
                if graph.agrees(pole, i, labels) {
                    rest.push(cost);
                    continue;
                }
                rest.push(0);
                let other = graph.others[i] as usize;
                let grant = rank(pole, round) > rank(other, round);
                supply[pole] += if grant { i64::from(cost) } else { -i64::from(cost) };
            }
        }
        let mut network = Network {
            offsets: &graph.offsets,
            heads: &graph.others,
            twins: &graph.twins,
            rest,
            supply,
        };
        let Some(changed) = network.reached(PASSES, &mut room, run)? else { break };
        for (label, _) in labels.iter_mut().zip(&changed).filter(|&(_, &changed)| changed) {
            *label = label.opposite();
        }
        let cost = graph.cost(labels);
        idle = if cost < best { 0 } else { idle + 1 };
        best = cost;
        if best == 0 || idle == 3 {
            break;
        }
    }
    Ok(())
}

/// Where a pole stands in a round: links grant their gain to the pole that stands behind. The first rounds go by number, up and down, the
/// others by chance.
fn rank(pole: usize, round: u32) -> u64 {
    match round {
        0 => !(pole as u64),
        1 => pole as u64,
        _ => {
            // The finalizer of SplitMix64 (Steele, Lea, Flood 2014), which gives no two poles the same.
            let mut x =
                (pole as u64).wrapping_add(u64::from(round).wrapping_mul(0x9e37_79b9_7f4a_7c15));
            x = (x ^ x >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            x = (x ^ x >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
            x ^ x >> 31
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::Job;
    use proptest::prelude::*;

    /// A few poles, and links between them: both ends and a weight.
    fn links() -> impl Strategy<Value = (usize, Vec<(u32, u32, f64)>)> {
        (2..9usize).prop_flat_map(|count| {
            let pole = 0..count as u32;
            let weight = prop_oneof![(41..100i32), (-100..0i32)].prop_map(|w| f64::from(w) / 100.0);
            let link = (pole.clone(), pole, weight).prop_filter("a loop", |(p, q, _)| p != q);
            (Just(count), prop::collection::vec(link, 0..25))
        })
    }

    fn labels(bits: u32, count: usize) -> Vec<Label> {
        (0..count).map(|p| if bits >> p & 1 == 1 { Label::Inner } else { Label::Outer }).collect()
    }

    /// The labellings in which pole 0 is outer, with what they cost.
    fn all(graph: &Graph) -> Vec<(i64, Vec<Label>)> {
        let labellings =
            (0..1u32 << (graph.count() - 1)).map(|bits| labels(bits << 1, graph.count()));
        labellings.map(|labels| (graph.cost(&labels), labels)).collect()
    }

    proptest! {
        /// Roof duality tells what all best labellings have in common, if not all of it; regions never cost more.
        #[test]
        fn what_is_certain_is_in_every_best_labelling((count, found) in links(), start in any::<u32>()) {
            let run = |run: &Run<'_>| {
                let mut room = Room::new(run);
                let links = Links::new(count, std::slice::from_ref(&found), &mut room, run)?;
                let graph = Graph::new(&links, &mut room, run)?;
                for (i, &twin) in graph.twins.iter().enumerate() {
                    assert_eq!(graph.twins[twin as usize] as usize, i);
                    assert_eq!(graph.costs[twin as usize], graph.costs[i]);
                }
                let mut outer = vec![false; count];
                outer[0] = true;
                let labellings = all(&graph);
                let least = labellings.iter().map(|(cost, _)| *cost).min().unwrap();
                let best: Vec<_> = labellings.iter().filter(|(cost, _)| *cost == least).collect();
                // What is certain overrides both starts.
                let [mut one, mut other] = [0, u32::MAX].map(|bits| labels(bits << 1, count));
                settle_where_certain(&graph, &outer, &mut one, run)?;
                settle_where_certain(&graph, &outer, &mut other, run)?;
                for pole in (0..count).filter(|&pole| one[pole] == other[pole]) {
                    assert!(best.iter().all(|(_, labels)| labels[pole] == one[pole]));
                }
                let mut settled = labels(start & !1, count);
                let before = graph.cost(&settled);
                settle_regions(&graph, &outer, &mut settled, run)?;
                assert!(graph.cost(&settled) <= before && settled[0] == Label::Outer);
                let conflict = of(&links, &settled, run)?;
                assert_eq!((conflict * count as f64 * UNIT).round() as i64, graph.cost(&settled));
                Ok(())
            };
            Job::default().run(&[], run).unwrap();
        }

        /// Where all links can have what they ask for they get it.
        #[test]
        fn links_without_contradiction_are_settled((count, found) in links(), truth in any::<u32>(), start in any::<u32>()) {
            let truth = labels(truth & !1, count);
            let agree = |&(p, q, weight): &(u32, u32, f64)| {
                let same = truth[p as usize] == truth[q as usize];
                (p, q, if same { weight.abs().max(0.5) } else { -weight.abs() })
            };
            let found: Vec<_> = found.iter().map(agree).collect();
            let conflict = Job::default().run(&[], |run| {
                let links = Links::new(count, std::slice::from_ref(&found), &mut Room::new(run), run)?;
                let mut labels = labels(start, count);
                let mut outer = vec![false; count];
                outer[0] = true;
                settle(&links, &outer, &mut labels, run)?;
                of(&links, &labels, run)
            });
            // What hangs on no link from pole 0 has no certain label, but regions are flipped as a whole.
            prop_assert_eq!(conflict.unwrap(), 0.0);
        }
    }
}

//! Inner or outer: the priority-queue labelling of poles (Amenta, Choi, Kolluri 2001, section
//! 5.2 and Figure 8).

use super::PowerCrustOptions;
use crate::complex::Rows;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run, Stage};
use crate::poles::Poles;
use crate::triangulation::{Edges, Triangulation};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// The side of the surface on which a pole lies. The numbers are the C ABI's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum Label {
    /// Outside the solid.
    Outer = 0,
    /// Inside the solid.
    Inner = 1,
}

impl Label {
    fn opposite(self) -> Self {
        match self {
            Label::Outer => Label::Inner,
            Label::Inner => Label::Outer,
        }
    }
}

/// The labels, and how they came about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Labelling {
    /// One label per pole.
    pub labels: Vec<Label>,
    /// Poles that no other pole's label reached; they are outer.
    pub unreached: usize,
    /// Poles that came out inner but whose power cell is unbounded; they are outer.
    pub forced: usize,
}

/// Weighted links from each pole to others.
#[derive(Default)]
struct Links {
    rows: Rows,
    weights: Vec<f64>,
}

impl Links {
    /// The links of every pole, given each link once with its two ends.
    fn new(
        count: usize,
        links: &[(u32, u32, f64)],
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let mut offsets = room.filled(count + 1, 0u32)?;
        for link in run.watch(links) {
            let &(p, q, _) = link?;
            offsets[p as usize + 1] += 1;
            offsets[q as usize + 1] += 1;
        }
        for p in 0..count {
            offsets[p + 1] += offsets[p];
        }
        let mut next = room.collect(offsets.iter().copied())?;
        let mut others = room.filled(2 * links.len(), 0)?;
        let mut weights = room.filled(2 * links.len(), 0.0)?;
        for link in run.watch(links) {
            let &(p, q, weight) = link?;
            for (from, to) in [(p, q), (q, p)] {
                let slot = &mut next[from as usize];
                others[*slot as usize] = to;
                weights[*slot as usize] = weight;
                *slot += 1;
            }
        }
        Ok(Links { rows: Rows::new(offsets, others)?, weights })
    }

    fn of(&self, pole: u32) -> impl Iterator<Item = (u32, f64)> {
        let begin = self.rows.offsets()[pole as usize] as usize;
        let row = self.rows.row(pole as usize);
        row.iter().copied().zip(self.weights[begin..].iter().copied())
    }
}

/// What the labels given so far say of a pole: two beliefs in [0, 1].
#[derive(Clone, Copy, Default, PartialEq)]
struct Belief {
    inner: f64,
    outer: f64,
}

impl Belief {
    /// Figure 8, Update_Priority: a confused pole waits.
    fn priority(self) -> f64 {
        if self.inner > 0.0 && self.outer > 0.0 {
            (self.inner - self.outer).abs() - 1.0
        } else {
            self.inner.max(self.outer)
        }
    }

    fn side(&mut self, label: Label) -> &mut f64 {
        match label {
            Label::Outer => &mut self.outer,
            Label::Inner => &mut self.inner,
        }
    }
}

/// A pole in the queue. The greatest comes first: the highest priority, then the least pole.
#[derive(Clone, Copy, PartialEq)]
struct Waiting {
    priority: f64,
    pole: u32,
}

impl Eq for Waiting {}

impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> Ordering {
        self.priority.total_cmp(&other.priority).then(other.pole.cmp(&self.pole))
    }
}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// Labels every pole.
///
/// A pole enters the queue when a label first reaches it, as in the authors' program: Figure 8
/// read literally would label unreached poles, with priority 0, before the confused ones that might
/// still reach them. Cost: O((p + links) log p).
pub(super) fn label_poles(
    poles: &Poles,
    regular: &Triangulation,
    edges: &Edges,
    options: &PowerCrustOptions,
    run: &Run<'_>,
) -> Result<Labelling> {
    run.enter(Stage::Label)?;
    let count = poles.len();
    let mut room = Room::new(run);
    let links = sample_links(poles, &mut room, run)?;
    let opposite = Links::new(count, &links, &mut room, run)?;
    run.tick(1, 8)?;
    let links = deep_links(poles, regular, edges, options.deep, &mut room, run)?;
    let same = Links::new(count, &links, &mut room, run)?;
    drop(links);
    run.tick(2, 8)?;
    let mut beliefs = room.filled(count, Belief::default())?;
    let mut labels: Vec<Option<Label>> = room.filled(count, None)?;
    let mut waiting = Vec::new();
    for pole in run.watch(0..count as u32) {
        let pole = pole?;
        if poles.touches_far_box()[pole as usize] {
            beliefs[pole as usize].outer = 1.0;
            room.push(&mut waiting, Waiting { priority: 1.0, pole })?;
        }
    }
    let mut queue = BinaryHeap::from(waiting);
    let mut done = 0;
    while let Some(Waiting { priority, pole }) = queue.pop() {
        let p = pole as usize;
        if labels[p].is_some() || beliefs[p].priority() != priority {
            // A newer entry stands for this pole, or stood.
            continue;
        }
        if done % 1024 == 0 {
            run.tick(count / 4 + done * 3 / 4, count)?;
        }
        done += 1;
        // Each link pushes once at most.
        let links = opposite.rows.row(p).len() + same.rows.row(p).len();
        if queue.capacity() - queue.len() < links {
            let mut waiting = queue.into_vec();
            room.grow(&mut waiting, links)?;
            queue = BinaryHeap::from(waiting);
        }
        let label = if beliefs[p].inner > beliefs[p].outer { Label::Inner } else { Label::Outer };
        let strength = *beliefs[p].side(label);
        labels[p] = Some(label);
        let mut propagate = |other: u32, label: Label, weight: f64| {
            let q = other as usize;
            let before = beliefs[q].priority();
            let belief = beliefs[q].side(label);
            *belief = belief.max(strength * weight);
            let priority = beliefs[q].priority();
            if labels[q].is_none() && priority != before {
                queue.push(Waiting { priority, pole: other });
            }
        };
        opposite.of(pole).for_each(|(q, weight)| propagate(q, label.opposite(), weight));
        same.of(pole).for_each(|(q, weight)| propagate(q, label, weight));
    }
    let unreached = labels.iter().filter(|label| label.is_none()).count();
    let labelled = labels.into_iter().map(|label| label.unwrap_or(Label::Outer));
    let mut labels: Vec<Label> = room.collect(labelled)?;
    let mut forced = 0;
    for pole in unbounded_poles(regular, &mut room, run)? {
        if labels[pole as usize] == Label::Inner {
            labels[pole as usize] = Label::Outer;
            forced += 1;
        }
    }
    Ok(Labelling { labels, unreached, forced })
}

/// The two poles of each sample, with the weight -cos of the angle between them at the sample.
fn sample_links(poles: &Poles, room: &mut Room<'_>, run: &Run<'_>) -> Result<Vec<(u32, u32, f64)>> {
    let coords = poles.triangulation().coords();
    let mut links = room.vec(poles.sample_count())?;
    for pair in run.watch(poles.pole_of_sample().iter().zip(coords)) {
        let (&[p, q], sample) = pair?;
        if p == NONE || q == NONE || p == q {
            continue;
        }
        let to = |pole: u32| -> [f64; 3] {
            std::array::from_fn(|k| poles.balls()[pole as usize][k] - sample[k])
        };
        let (u, v) = (to(p), to(q));
        let cosine = dot(u, v) / (dot(u, u) * dot(v, v)).sqrt();
        // The poles of a sample lie on different sides: the cosine is negative but for rounding.
        if cosine < 0.0 {
            links.push((p, q, (-cosine).min(1.0)));
        }
    }
    Ok(links)
}

/// The neighbours in the power diagram whose balls intersect deeply.
///
/// The weight is -cos of the angle at which the balls' spheres intersect, from the law of
/// cosines: (r_p^2 + r_q^2 - d^2) / (2 r_p r_q), within [-1, 1].
fn deep_links(
    poles: &Poles,
    regular: &Triangulation,
    edges: &Edges,
    deep: f64,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<(u32, u32, f64)>> {
    let pole_of_vertex = regular.row_of_vertex();
    let mut links = Vec::new();
    for ends in run.watch(&edges.ends) {
        let [p, q] = ends?.map(|v| pole_of_vertex[v as usize]);
        let weight = same_side_weight(&poles.balls()[p as usize], &poles.balls()[q as usize]);
        if weight > deep {
            room.push(&mut links, (p, q, weight))?;
        }
    }
    Ok(links)
}

/// How deeply two balls intersect: -cos of the angle between them, 1 where one holds the other.
pub(super) fn same_side_weight(p: &[f64; 4], q: &[f64; 4]) -> f64 {
    let d: [f64; 3] = std::array::from_fn(|k| p[k] - q[k]);
    let cosine = (p[3] * p[3] + q[3] * q[3] - dot(d, d)) / (2.0 * p[3] * q[3]);
    cosine.clamp(-1.0, 1.0)
}

/// The poles whose power cells are unbounded: those on the hull of the regular triangulation,
/// each once, ascending by vertex.
pub(super) fn unbounded_poles(
    regular: &Triangulation,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<u32>> {
    let mut on_hull = room.filled(regular.coords().len(), false)?;
    for cell in run.watch(regular.cells().iter().zip(regular.neighbors())) {
        let (cell, neighbors) = cell?;
        for slot in (0..4).filter(|&slot| neighbors[slot] == NONE) {
            for other in (0..4).filter(|&other| other != slot) {
                on_hull[cell[other] as usize] = true;
            }
        }
    }
    let mut poles = Vec::new();
    for vertex in (0..on_hull.len()).filter(|&v| on_hull[v]) {
        room.push(&mut poles, regular.row_of_vertex()[vertex])?;
    }
    Ok(poles)
}

fn dot(u: [f64; 3], v: [f64; 3]) -> f64 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}

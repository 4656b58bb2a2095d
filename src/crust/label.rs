//! Inner or outer: the priority-queue labelling of poles (Amenta, Choi, Kolluri 2001, section
//! 5.2 and Figure 8).

use super::PowerCrustOptions;
use super::queue::Queue;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{self, Room, Run};
use crate::poles::Poles;
use crate::triangulation::Triangulation;
use std::ops::Range;

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

/// A link from a pole to another: the weight with which the same label passes on, or less than 0 if it is
/// the opposite label that does.
#[derive(Clone, Copy, Default)]
struct Link {
    other: u32,
    weight: f64,
}

/// The links of each pole, in rows.
struct Links {
    offsets: Vec<u32>,
    links: Vec<Link>,
}

impl Links {
    /// The links of every pole, given each link with its two ends.
    fn new(
        count: usize,
        parts: &[Vec<(u32, u32, f64)>],
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        // Row p begins at offsets[p + 1] while it is filled, which moves that to its end.
        let mut offsets = room.filled(count + 2, 0u32)?;
        for link in run.watch(parts.iter().flatten()) {
            let &(p, q, _) = link?;
            offsets[p as usize + 2] += 1;
            offsets[q as usize + 2] += 1;
        }
        for p in 2..count + 2 {
            offsets[p] += offsets[p - 1];
        }
        let mut links = room.filled(offsets[count + 1] as usize, Link::default())?;
        for link in run.watch(parts.iter().flatten()) {
            let &(p, q, weight) = link?;
            for (from, other) in [(p, q), (q, p)] {
                let slot = &mut offsets[from as usize + 1];
                links[*slot as usize] = Link { other, weight };
                *slot += 1;
            }
        }
        Ok(Links { offsets, links })
    }

    fn of(&self, pole: u32) -> &[Link] {
        let p = pole as usize;
        &self.links[self.offsets[p] as usize..self.offsets[p + 1] as usize]
    }
}

/// What the labels given so far say of a pole: a belief in [0, 1] for either label, by its number.
type Belief = [f64; 2];

/// Figure 8, Update_Priority: a confused pole waits.
fn priority([outer, inner]: Belief) -> f64 {
    if inner > 0.0 && outer > 0.0 { (inner - outer).abs() - 1.0 } else { inner.max(outer) }
}

/// Labels every pole.
///
/// A pole enters the queue when a label first reaches it, as in the authors' program: Figure 8
/// read literally would label unreached poles, with priority 0, before the confused ones that might
/// still reach them. Cost: O((p + links) log p).
pub(super) fn label_poles(
    poles: &Poles,
    regular: &Triangulation,
    options: &PowerCrustOptions,
    run: &Run<'_>,
) -> Result<Labelling> {
    let count = poles.len();
    let mut room = Room::new(run);
    let mut parts = vec![sample_links(poles, &mut room, run)?];
    let cells = job::parts(regular.cells().len());
    let deep = run.in_steps(cells, [0.0, 0.3], |cells| {
        let mut room = Room::new(run);
        Ok((deep_links(poles, regular, cells, options.deep, &mut room)?, room))
    })?;
    let (deep, rooms): (Vec<_>, Vec<_>) = deep.into_iter().unzip();
    parts.extend(deep);
    let links = Links::new(count, &parts, &mut room, run)?;
    drop((parts, rooms));
    run.tick(1, 2)?;
    let mut beliefs = room.filled(count, Belief::default())?;
    let mut labels: Vec<Option<Label>> = room.filled(count, None)?;
    let mut queue = Queue::new(count, &mut room)?;
    for pole in run.watch(0..count as u32) {
        let pole = pole?;
        if poles.touches_far_box()[pole as usize] {
            beliefs[pole as usize][Label::Outer as usize] = 1.0;
            queue.put(pole, 1.0);
        }
    }
    let mut done = 0;
    while let Some(pole) = queue.pop() {
        let p = pole as usize;
        let [outer, inner] = beliefs[p];
        if done % 1024 == 0 {
            run.tick(count + done, 2 * count)?;
        }
        done += 1;
        let label = if inner > outer { Label::Inner } else { Label::Outer };
        let strength = inner.max(outer);
        labels[p] = Some(label);
        // Nothing raises that any more.
        beliefs[p] = [f64::INFINITY; 2];
        spread(links.of(pole), label, strength, &mut beliefs, &mut queue);
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

/// Passes a label on.
fn spread(links: &[Link], label: Label, strength: f64, beliefs: &mut [Belief], queue: &mut Queue) {
    let raised = |link: &Link| {
        let to = if link.weight < 0.0 { label.opposite() } else { label };
        (to as usize, strength * link.weight.abs())
    };
    for link in links {
        let (to, raised) = raised(link);
        let belief = &mut beliefs[link.other as usize];
        if raised <= belief[to] {
            continue;
        }
        let before = priority(*belief);
        belief[to] = raised;
        let priority = priority(*belief);
        if priority != before {
            queue.put(link.other, priority);
        }
    }
}

/// The two poles of each sample, with minus the weight -cos of the angle between them at the sample.
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
            links.push((p, q, cosine.max(-1.0)));
        }
    }
    Ok(links)
}

/// The neighbours in the power diagram whose balls intersect deeply, as far as they are met in the given cells.
/// Some are found in several cells: a link more changes nothing.
///
/// The weight is -cos of the angle at which the balls' spheres intersect, from the law of
/// cosines: (r_p^2 + r_q^2 - d^2) / (2 r_p r_q), within [-1, 1].
fn deep_links(
    poles: &Poles,
    regular: &Triangulation,
    cells: Range<usize>,
    deep: f64,
    room: &mut Room<'_>,
) -> Result<Vec<(u32, u32, f64)>> {
    let pole_of_vertex = regular.row_of_vertex();
    let mut links = Vec::new();
    for cell in cells {
        for &[i, j] in regular.edges_met(cell as u32) {
            let corners = &regular.cells()[cell];
            let [p, q] = [i, j].map(|slot| pole_of_vertex[corners[slot] as usize]);
            let weight = same_side_weight(&poles.balls()[p as usize], &poles.balls()[q as usize]);
            if weight > deep {
                room.push(&mut links, (p, q, weight))?;
            }
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

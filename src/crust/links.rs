//! What ties the labels of two poles: a sample that has both, or balls that intersect deeply; and a pole with the place that sees its samples (Amenta, Choi, Kolluri 2001,
//! section 5.2).

use super::PowerCrustOptions;
use super::label::Label;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{self, Room, Run};
use crate::poles::Poles;
use crate::triangulation::{Descent, Triangulation};
use std::ops::Range;

/// A link from a pole to another: the weight with which the same label passes on, or less than 0 if it is
/// the opposite label that does.
#[derive(Clone, Copy, Default)]
pub(super) struct Link {
    pub other: u32,
    pub weight: f64,
}

impl Link {
    /// Whether two labels are what the link asks for.
    pub fn agrees(&self, one: Label, other: Label) -> bool {
        (self.weight < 0.0) == (one != other)
    }

    /// Whether both are the same deep intersection, met in two cells.
    pub fn is_same_deep(&self, other: &Link) -> bool {
        self.other == other.other && self.weight > 0.0 && self.weight == other.weight
    }
}

/// The links of each pole, in rows. A deep link may be in a row twice: labels spread all the same.
pub(super) struct Links {
    offsets: Vec<u32>,
    links: Vec<Link>,
}

impl Links {
    /// All links of labelled poles. The viewpoint, if there is one, counts as a pole after all others.
    pub fn of_poles(
        poles: &Poles,
        regular: &Triangulation,
        options: &PowerCrustOptions,
        run: &Run<'_>,
    ) -> Result<Self> {
        let mut room = Room::new(run);
        let mut parts = vec![sample_links(poles, &mut room, run)?];
        let cells = job::parts(regular.cells().len());
        let deep = run.in_steps(cells, [0.0, 0.3], |cells| {
            let mut room = Room::new(run);
            Ok((deep_links(poles, regular, cells, options.deep, &mut room)?, room))
        })?;
        let (deep, rooms): (Vec<_>, Vec<_>) = deep.into_iter().unzip();
        parts.extend(deep);
        parts.push(hidden_links(poles, regular, options.deep, &mut room, run)?);
        let mut count = poles.len();
        if let Some(viewpoint) = options.viewpoint {
            parts.push(sight_links(poles, viewpoint, &mut room, run)?);
            count += 1;
        }
        let links = Links::new(count, &parts, &mut room, run)?;
        drop(rooms);
        Ok(links)
    }

    /// What the arrays take.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.offsets[..]) + size_of_val(&self.links[..])
    }

    /// The number of poles, and one more for the viewpoint if there is one.
    pub fn count(&self) -> usize {
        self.offsets.len() - 2
    }

    /// The links of every pole, given each link with its two ends.
    pub fn new(
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

    /// The links of a pole.
    pub fn of(&self, pole: u32) -> &[Link] {
        let p = pole as usize;
        &self.links[self.offsets[p] as usize..self.offsets[p + 1] as usize]
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

/// Each pole with the viewpoint, by the mean cosine over its samples of the angle between the directions to either: a pole on this side
/// of the surface has the viewpoint's label, one behind it the other.
fn sight_links(
    poles: &Poles,
    viewpoint: [f64; 3],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<(u32, u32, f64)>> {
    let coords = poles.triangulation().coords();
    let mut sums = room.filled(poles.len(), (0.0, 0.0))?;
    for pair in run.watch(poles.pole_of_sample().iter().zip(coords)) {
        let (&pair, sample) = pair?;
        let sight: [f64; 3] = std::array::from_fn(|k| viewpoint[k] - sample[k]);
        for pole in pair.into_iter().filter(|&pole| pole != NONE) {
            let ball = &poles.balls()[pole as usize];
            let to: [f64; 3] = std::array::from_fn(|k| ball[k] - sample[k]);
            let cosine = dot(to, sight) / (dot(to, to).sqrt() * dot(sight, sight).sqrt());
            // A sample where the viewpoint is tells nothing.
            if cosine.is_finite() {
                let (sum, count) = &mut sums[pole as usize];
                *sum += cosine;
                *count += 1.0;
            }
        }
    }
    let mut links = room.vec(poles.len())?;
    for (pole, &(sum, count)) in sums.iter().enumerate().filter(|(_, (sum, _))| *sum != 0.0) {
        let weight = f64::clamp(sum / count, -1.0, 1.0);
        links.push((pole as u32, poles.len() as u32, weight));
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

/// Poles that are hidden in the regular triangulation, or share their place with a heavier one, each with the pole whose power cell its centre is in, where
/// their balls intersect deeply. No cell has such a pole, so that nothing else would tell its label but its samples; often both poles of these are hidden,
/// as those of a torus that was sampled on a grid are by their neighbours, which differ by rounding.
fn hidden_links(
    poles: &Poles,
    regular: &Triangulation,
    deep: f64,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<(u32, u32, f64)>> {
    let [pole_of_vertex, vertex_of_pole] =
        [regular.row_of_vertex(), regular.points().vertex_of_row()];
    let mut links = Vec::new();
    let mut link = |p: u32, q: u32| {
        let weight = same_side_weight(&poles.balls()[p as usize], &poles.balls()[q as usize]);
        if weight > deep { room.push(&mut links, (p, q, weight)) } else { Ok(()) }
    };
    for pole in run.watch(0..poles.len() as u32) {
        let pole = pole?;
        let vertex = vertex_of_pole[pole as usize];
        if vertex != NONE && pole_of_vertex[vertex as usize] != pole {
            link(pole, pole_of_vertex[vertex as usize])?;
        }
    }
    if !regular.hidden().is_empty() {
        let incidence = regular.incidence_in(run)?;
        let descent = Descent::new(regular, &incidence);
        let mut from = regular.cells()[0][0];
        for vertex in run.watch(regular.hidden()) {
            let &vertex = vertex?;
            // Vertices stand in spatial order: the last one found is near.
            from = descent.nearest(regular.coords()[vertex as usize], from);
            link(pole_of_vertex[vertex as usize], pole_of_vertex[from as usize])?;
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

fn dot(u: [f64; 3], v: [f64; 3]) -> f64 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}

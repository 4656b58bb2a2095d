//! Which samples are dense enough (Dey, Giesen 2001, *Detecting undersampling in surface reconstruction*).

use super::cone::Cones;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{PART, Room, Run};
use crate::triangulation::Incidence;

/// For each sample whether it is *flat*: well sampled all round.
///
/// The *ratio condition* asks that the second pole be at least `ratio` times as far as the farthest corner of the tangent polygon: the
/// Voronoi cell is long and thin. The *normal condition* asks that the pole vectors of all samples of which this one is a cocone neighbour make at
/// most the angle of this cosine with its own. A sample with the ratio is flat, too, if it is a cocone neighbour of a flat one to which its
/// pole vector is as parallel, and so on (section 4). The result does not depend on the order, since flat samples only ever become more.
pub(super) fn flat_samples(
    cones: &Cones<'_>,
    incidence: &Incidence,
    [ratio, cosine]: [f64; 2],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<bool>> {
    let samples = cones.poles.first.len();
    let in_ratio = by_samples(samples, [0.0, 0.3], room, run, |sample| {
        let second = cones.poles.second[sample as usize];
        second != NONE && {
            let height = cones.dual.radii_squared()[second as usize];
            let width = cones.width_squared(sample, incidence.cells_of(sample));
            ratio * ratio * width <= height
        }
    })?;
    let mut flat = by_samples(samples, [0.3, 0.6], room, run, |sample| {
        in_ratio[sample as usize]
            && neighbors(cones, incidence, sample).all(|(other, meets)| {
                // The other one's cocone counts: this one is its neighbour.
                !meets[1] || cones.is_parallel(sample, other, cosine)
            })
    })?;
    let mut stack = Vec::new();
    for sample in (0..samples as u32).filter(|&sample| flat[sample as usize]) {
        room.push(&mut stack, sample)?;
    }
    let mut done = 0;
    while let Some(sample) = stack.pop() {
        done += 1;
        if done % 256 == 0 {
            run.poll()?;
        }
        for (other, meets) in neighbors(cones, incidence, sample) {
            if meets[0]
                && in_ratio[other as usize]
                && !flat[other as usize]
                && cones.is_parallel(sample, other, cosine)
            {
                flat[other as usize] = true;
                room.push(&mut stack, other)?;
            }
        }
    }
    Ok(flat)
}

/// What holds of each sample.
fn by_samples(
    samples: usize,
    progress: [f64; 2],
    room: &mut Room<'_>,
    run: &Run<'_>,
    holds: impl Fn(u32) -> bool + Sync,
) -> Result<Vec<bool>> {
    let mut results = room.filled(samples, false)?;
    // Stars are much longer to look at than other items.
    let chunks = results.chunks_mut(PART / 8).enumerate().collect();
    run.in_steps(chunks, progress, |(chunk, results)| {
        for (i, result) in results.iter_mut().enumerate() {
            if i % 64 == 0 {
                run.poll()?;
            }
            *result = holds((chunk * (PART / 8) + i) as u32);
        }
        Ok(())
    })?;
    Ok(results)
}

/// The samples that share a Voronoi edge with the given one, some more than once, each with whether that edge meets the given one's cocone, and the other's.
fn neighbors<'a>(
    cones: &'a Cones<'_>,
    incidence: &'a Incidence,
    sample: u32,
) -> impl Iterator<Item = (u32, [bool; 2])> + 'a {
    let t = cones.dual.triangulation();
    incidence.cells_of(sample).iter().flat_map(move |&cell| {
        let corners = t.cells()[cell as usize];
        let neighbors = t.neighbors()[cell as usize];
        let facets = (0..4).filter(move |&i| {
            corners[i] != sample && (neighbors[i] == NONE || neighbors[i] > cell)
        });
        facets.flat_map(move |facet| {
            let own = cones.meets(cell, facet, sample);
            let others = (0..4).filter(move |&i| i != facet && corners[i] != sample);
            others.map(move |i| (corners[i], [own, cones.meets(cell, facet, corners[i])]))
        })
    })
}

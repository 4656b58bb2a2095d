//! Marking: which cells are inside and which outside, as far as the umbrellas of well sampled points tell.

use super::sheet::Sheet;
use super::umbrella::Umbrellas;
use crate::dual::Dual;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::sort::sort_by_key;
use crate::triangulation::Triangulation;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// For each sample with an umbrella which of its sides is outside.
pub(super) struct Marks {
    /// The side that is outside, 1 or 2; 0 where there is no umbrella.
    pub(super) outer_side: Vec<u8>,
    /// How many more well sampled vertices of each cell say that it is inner than that it is outer: a cell is marked unless it is 0.
    pub(super) votes: Vec<i8>,
}

/// Marks the cells round well sampled points (Dey, Goswami 2003, MARK).
///
/// Umbrellas that share a triangle agree on their sides, and so do all of a *patch*, which hangs together through these. A cell, or what is beyond a
/// facet of the hull, that has vertices of two patches asks that its sides of both be the same; so patches tell each other's sides, as those of the paper's walk from the hull do. Where cells contradict
/// each other the majority counts: patches are decided one after the other, always the one about which most
/// cells, those that contradict taken off, agree, beginning with what lies beyond the hull. The paper leaves that to the order of the walk.
pub(super) fn mark(
    dual: &Dual,
    sheet: &Sheet<'_>,
    umbrellas: &Umbrellas,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Marks> {
    let t = dual.triangulation();
    let Patches { patch, turned, count } = Patches::new(dual, sheet, umbrellas, room, run)?;
    // The side of a patch on which a cell is, by the umbrella of one vertex.
    let side_of = |vertex: u32, side: u8| match side {
        0 => None,
        side => Some((patch[vertex as usize], side ^ if turned[vertex as usize] { 3 } else { 0 })),
    };
    // Each relation of two patches: 1 if a cell is on the same side of both, else -1. The last patch is what lies beyond the hull, on side 1 of itself.
    let mut relations: Vec<(u64, i32)> = Vec::new();
    let mut relate = |sides: &mut [(u32, u8)], room: &mut Room<'_>| -> Result<()> {
        sides.sort_unstable();
        for (i, &(p, of_p)) in sides.iter().enumerate() {
            for &(q, of_q) in sides[i + 1..].iter().filter(|&&(q, _)| q != p) {
                let agree = if of_p == of_q { 1 } else { -1 };
                room.push(&mut relations, (u64::from(p) << 32 | u64::from(q), agree))?;
            }
        }
        Ok(())
    };
    let mut sides = Vec::new();
    for cell in run.watch(t.cells().iter().zip(&umbrellas.sides).enumerate()) {
        let (cell, (corners, of_corners)) = cell?;
        sides.clear();
        sides.extend(corners.iter().zip(of_corners).filter_map(|(&v, &side)| side_of(v, side)));
        relate(&mut sides, room)?;
        for i in (0..4).filter(|&i| t.is_hull(cell as u32, i)) {
            let corners = t.facet(cell as u32, i);
            sides.clear();
            sides.push((count, 1));
            let beyond = |v: u32| side_of(v, umbrellas.beyond[v as usize]);
            sides.extend(corners.into_iter().filter_map(beyond));
            relate(&mut sides, room)?;
        }
    }
    let outer_of_patch = decide(dual, umbrellas, side_of, relations, count, room, run)?;
    let outer_side = room.collect((0..t.coords().len()).map(|v| match umbrellas.is_good[v] {
        false => 0,
        true => outer_of_patch[patch[v] as usize] ^ if turned[v] { 3 } else { 0 },
    }))?;
    let votes = votes(t, umbrellas, &outer_side, room, run)?;
    Ok(Marks { outer_side, votes })
}

/// The votes of each cell.
fn votes(
    t: &Triangulation,
    umbrellas: &Umbrellas,
    outer_side: &[u8],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<i8>> {
    let mut votes = room.vec(t.cells().len())?;
    for cell in run.watch(t.cells().iter().zip(&umbrellas.sides)) {
        let (corners, sides) = cell?;
        let mut inner = 0i8;
        for (&v, &side) in corners.iter().zip(sides).filter(|&(_, &side)| side != 0) {
            inner += if side == outer_side[v as usize] { -1 } else { 1 };
        }
        votes.push(inner);
    }
    Ok(votes)
}

/// Well sampled points that hang together through triangles.
struct Patches {
    /// The patch of each sample, numbered by their least ones; [`NONE`] without an umbrella.
    patch: Vec<u32>,
    /// Whether the first side of the sample's umbrella is the second of its patch.
    turned: Vec<bool>,
    count: u32,
}

impl Patches {
    fn new(
        dual: &Dual,
        sheet: &Sheet<'_>,
        umbrellas: &Umbrellas,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let t = dual.triangulation();
        let mut patch = room.filled(t.coords().len(), NONE)?;
        let mut turned = room.filled(t.coords().len(), false)?;
        let mut queue = Vec::new();
        let mut count = 0;
        for first in run.watch(0..t.coords().len() as u32) {
            let first = first?;
            if !umbrellas.is_good[first as usize] || patch[first as usize] != NONE {
                continue;
            }
            patch[first as usize] = count;
            queue.clear();
            room.push(&mut queue, first)?;
            let mut next = 0;
            while let Some(&v) = queue.get(next) {
                next += 1;
                if next % 1024 == 0 {
                    run.poll()?;
                }
                for &corner in sheet.star(v) {
                    let [_, front] = sheet.cells(t, corner / 4);
                    let side = umbrellas.side(t, front, v);
                    for &q in &sheet.corners[corner as usize / 4] {
                        if umbrellas.is_good[q as usize] && patch[q as usize] == NONE {
                            let agree = umbrellas.side(t, front, q) == side;
                            patch[q as usize] = count;
                            turned[q as usize] = turned[v as usize] == agree;
                            room.push(&mut queue, q)?;
                        }
                    }
                }
            }
            count += 1;
        }
        Ok(Patches { patch, turned, count })
    }
}

/// Which side of each patch is outside.
fn decide(
    dual: &Dual,
    umbrellas: &Umbrellas,
    side_of: impl Fn(u32, u8) -> Option<(u32, u8)>,
    mut relations: Vec<(u64, i32)>,
    count: u32,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<u8>> {
    sort_by_key(&mut relations, |&(pair, _)| pair, run)?;
    // Both ways, those of one pair added up.
    let mut links: Vec<(u64, i32)> = Vec::new();
    for relations in run.watch(relations.chunk_by(|a, b| a.0 == b.0)) {
        let relations = relations?;
        let weight = relations.iter().map(|&(_, agree)| agree).sum();
        let pair = relations[0].0;
        room.push(&mut links, (pair, weight))?;
        room.push(&mut links, (pair.rotate_right(32), weight))?;
    }
    sort_by_key(&mut links, |&(pair, _)| pair, run)?;
    let largest = largest_cells(dual, umbrellas, side_of, count, room, run)?;
    let mut outer = room.filled(count as usize + 1, 0u8)?;
    let mut scores = room.filled(count as usize + 1, 0i64)?;
    let mut heap = BinaryHeap::new();
    room.keep(16 * links.len())?;
    // A patch about which nothing is known yet comes last, with the side that has the largest ball outside.
    let mut rest = 0;
    let mut next = count;
    let mut done = 0;
    loop {
        if outer[next as usize] == 0 {
            done += 1;
            if done % 1024 == 0 {
                run.poll()?;
            }
            outer[next as usize] = match scores[next as usize] {
                _ if next == count => 1,
                0 => largest[next as usize].1,
                1.. => 1,
                _ => 2,
            };
            let begin = links.partition_point(|&(pair, _)| pair >> 32 < u64::from(next));
            let of_next =
                links[begin..].iter().take_while(|(pair, _)| pair >> 32 == u64::from(next));
            for &(pair, weight) in of_next {
                let other = pair as u32;
                let sign = if outer[next as usize] == 1 { 1 } else { -1 };
                let score = &mut scores[other as usize];
                *score += sign * i64::from(weight);
                if outer[other as usize] == 0 && *score != 0 {
                    heap.push((score.unsigned_abs(), Reverse(other)));
                }
            }
        }
        // Scores have changed since some entries were made.
        next = match heap.pop() {
            Some((score, Reverse(patch))) if scores[patch as usize].unsigned_abs() != score => {
                continue;
            }
            Some((_, Reverse(patch))) => patch,
            None => {
                while rest < count && outer[rest as usize] != 0 {
                    rest += 1;
                }
                if rest == count {
                    return Ok(outer);
                }
                rest
            }
        };
    }
}

/// For each patch the largest squared radius of the cells round it, and the side on which that cell is.
fn largest_cells(
    dual: &Dual,
    umbrellas: &Umbrellas,
    side_of: impl Fn(u32, u8) -> Option<(u32, u8)>,
    count: u32,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<(f64, u8)>> {
    let mut largest = room.filled(count as usize + 1, (-1.0, 1))?;
    let cells = dual.triangulation().cells().iter().zip(&umbrellas.sides);
    for cell in run.watch(cells.zip(dual.radii_squared())) {
        let ((corners, sides), &radius) = cell?;
        for (patch, side) in corners.iter().zip(sides).filter_map(|(&v, &side)| side_of(v, side)) {
            let largest = &mut largest[patch as usize];
            if radius > largest.0 {
                *largest = (radius, side);
            }
        }
    }
    Ok(largest)
}

//! Manifold extraction: one layer of the candidate triangles, by walking on their outside.

use super::sheet::Sheet;
use crate::complex::DisjointSets;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::predicates::{Sign, orient3d};
use crate::triangulation::Triangulation;
use crate::vector::{dot, sub};
use std::collections::VecDeque;

/// What the walk has seen of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// Nothing.
    Unseen,
    /// Its front: the outside is there.
    Front,
    /// Its back.
    Back,
}

/// The triangles that are met by walking on the outside of each component, with the side that was walked on.
///
/// Across an edge the walk goes on to the next triangle on its side, and it ends at an edge with one triangle (Amenta, Choi, Dey, Leekha 2002, section 4; Dey, Giesen 2001). A
/// component is what hangs together through edges. The walk begins with the least triangle and side that
/// has before it the most cells, among regions of space that the triangles divide; triangles of which no vertex was reached begin another one.
///
/// The papers walk on surfaces without boundary. To stay on one side of others, the walk turns round no edge by more than 3 pi / 2, takes triangles breadth
/// first, those with flat vertices only before all others, and if `strict` takes none that would be the third at an edge, or disagree there on which side is
/// outside: so what it takes is oriented, and no edge has more than two triangles.
pub(super) fn walk(
    t: &Triangulation,
    sheet: &Sheet<'_>,
    is_flat: &[bool],
    strict: bool,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<Side>> {
    let mut seen = room.filled(sheet.len(), Side::Unseen)?;
    let mut touched = room.filled(t.coords().len(), false)?;
    // A bit for each way in which a triangle runs the edge.
    let mut runs = room.filled(sheet.edge_count(), 0u8)?;
    let orders = Orders::new(t, sheet, room, run)?;
    let starts = starts(t, sheet, room, run)?;
    room.keep(32 * sheet.len())?;
    let mut queues: [VecDeque<(u32, Side)>; 2] = Default::default();
    let mut done = 0;
    // First where most cells are, then what is left.
    for &(facet, side) in &starts {
        let corners = sheet.corners[facet as usize];
        if seen[facet as usize] != Side::Unseen || corners.iter().any(|&v| touched[v as usize]) {
            continue;
        }
        queues[0].push_back((facet, side));
        loop {
            let [first, second] = &mut queues;
            let Some((facet, own)) = first.pop_front().or_else(|| second.pop_front()) else {
                break;
            };
            done += 1;
            if done % 4096 == 0 {
                run.poll()?;
            }
            let ways = [0, 1, 2].map(|side| way(sheet, facet, side, own));
            let edges = sheet.edge_of_side[facet as usize].map(|edge| edge as usize);
            let is_taken = edges.iter().zip(ways).any(|(&edge, way)| runs[edge] & way != 0);
            if seen[facet as usize] != Side::Unseen || (strict && is_taken) {
                continue;
            }
            seen[facet as usize] = own;
            for (&edge, way) in edges.iter().zip(ways) {
                runs[edge] |= way;
            }
            for &corner in &sheet.corners[facet as usize] {
                touched[corner as usize] = true;
            }
            for side in 0..3 {
                let (next, side_of_next) = orders.next(sheet, facet, side, own);
                if next != facet
                    && seen[next as usize] == Side::Unseen
                    && !is_fold(t, sheet, facet, side, own, next)
                {
                    let is_flat = sheet.corners[next as usize].iter().all(|&v| is_flat[v as usize]);
                    queues[usize::from(!is_flat)].push_back((next, side_of_next));
                }
            }
        }
    }
    Ok(seen)
}

/// The bit of the way in which a triangle runs its side, oriented towards the side of it that was seen.
fn way(sheet: &Sheet<'_>, facet: u32, side: u32, seen: Side) -> u8 {
    1 << u8::from(runs_up(sheet, 4 * facet + side) == (seen == Side::Front))
}

/// Whether the walk would turn by more than 3 pi / 2 round a side of a triangle to come to the next one: from one layer to
/// the back of another.
fn is_fold(
    t: &Triangulation,
    sheet: &Sheet<'_>,
    facet: u32,
    side: usize,
    seen: Side,
    next: u32,
) -> bool {
    let corners = sheet.corners[facet as usize];
    let [a, b, c] = [0, 1, 2].map(|k| corners[(side + k) % 3]);
    let apex = sheet.corners[next as usize].into_iter().find(|v| ![a, b].contains(v));
    let at = |v: u32| &t.coords()[v as usize];
    let [along, own, other] = [b, c, apex.unwrap_or(c)].map(|v| sub(*at(v), *at(a)));
    let cosine = dot(own, other) * dot(along, along) - dot(own, along) * dot(other, along);
    // In front of a triangle the determinant is positive; two triangles that lie in one plane do not overlap.
    let before = orient3d(at(a), at(b), at(c), at(apex.unwrap_or(c)));
    cosine > 0.0 && before == if seen == Side::Front { Sign::Negative } else { Sign::Positive }
}

/// Every triangle with the side that the larger region is on; first, of each component, that with the largest region before it.
fn starts(
    t: &Triangulation,
    sheet: &Sheet<'_>,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<(u32, Side)>> {
    let walls = sheet.walls(t, room, run)?;
    let cells = t.cells().len() as u32;
    room.keep(4 * cells as usize + 4 * sheet.len())?;
    // All that is beyond the hull is one more cell.
    let mut regions = DisjointSets::new(cells as usize + 1, run)?;
    for neighbors in run.watch(t.neighbors().iter().enumerate()) {
        let (cell, neighbors) = neighbors?;
        for (i, &neighbor) in neighbors.iter().enumerate() {
            if neighbor > cell as u32 && walls[cell] >> i & 1 == 0 {
                regions.join(cell as u32, neighbor.min(cells));
            }
        }
    }
    let mut sizes = room.filled(cells as usize + 1, 0u32)?;
    for cell in run.watch(0..cells + 1) {
        sizes[regions.root(cell?) as usize] += 1;
    }
    // What is beyond the hull is larger than all else.
    sizes[regions.root(cells) as usize] = u32::MAX;
    let mut components = DisjointSets::new(sheet.len(), run)?;
    for edge in run.watch(0..sheet.edge_count() as u32) {
        let sides = sheet.sides_of_edge(edge?);
        for pair in sides.windows(2) {
            components.join(pair[0] / 4, pair[1] / 4);
        }
    }
    let mut best: Vec<(u32, u32)> = room.filled(sheet.len(), (0, NONE))?;
    let mut starts = room.vec(sheet.len())?;
    for facet in run.watch(0..sheet.len() as u32) {
        let facet = facet?;
        let [behind, before] =
            sheet.cells(t, facet).map(|cell| sizes[regions.root(cell.min(cells)) as usize]);
        let side = if before >= behind { Side::Front } else { Side::Back };
        starts.push((facet, side));
        let best = &mut best[components.root(facet) as usize];
        if best.1 == NONE || before.max(behind) > best.0 {
            *best = (before.max(behind), facet);
        }
    }
    let is_first = |&(facet, _): &(u32, Side), components: &mut DisjointSets| {
        best[components.root(facet) as usize].1 == facet
    };
    let mut ordered = room.vec(2 * sheet.len())?;
    ordered.extend(starts.iter().filter(|start| is_first(start, &mut components)));
    ordered.extend(starts);
    Ok(ordered)
}

/// The order of the triangles round each edge.
struct Orders {
    /// The sides of each edge as the sheet has them, but counterclockwise round the edge from its lesser vertex to the greater.
    sides: Vec<u32>,
}

impl Orders {
    fn new(
        t: &Triangulation,
        sheet: &Sheet<'_>,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let mut sides = room.collect(sheet.sides.iter().copied())?;
        let mut ring = Vec::new();
        let mut order: Vec<(usize, u32)> = Vec::new();
        for edge in run.watch(0..sheet.edge_count() as u32) {
            let of_edge = sheet.sides_of_edge(edge?);
            // Two follow each other either way.
            if of_edge.len() < 3 {
                continue;
            }
            run.poll()?;
            let [a, b] = ends(sheet, of_edge[0]);
            let closed =
                t.ring(sheet.facets[of_edge[0] as usize / 4][0], a.min(b), a.max(b), &mut ring);
            order.clear();
            for &side in of_edge {
                // A facet comes after the cell that is clockwise of it.
                let [behind, before] = sheet.cells(t, side / 4);
                let cell = if runs_up(sheet, side) { behind } else { before };
                let place = ring.iter().position(|&c| c == cell);
                // The cell beyond the hull comes before all others.
                order.push((place.map_or(0, |place| place + 1), side));
            }
            debug_assert!(!closed || order.iter().all(|(place, _)| *place > 0));
            order.sort_unstable();
            let begin = sheet.edges[edge_of(sheet, of_edge[0]) as usize] as usize;
            for (place, &(_, side)) in order.iter().enumerate() {
                sides[begin + place] = side;
            }
        }
        Ok(Orders { sides })
    }

    /// The triangle that is next to a side of a triangle on the side that was seen of it, and what is seen of that.
    fn next(&self, sheet: &Sheet<'_>, facet: u32, side: usize, seen: Side) -> (u32, Side) {
        let own = 4 * facet + side as u32;
        let edge = sheet.edge_of_side[facet as usize][side] as usize;
        let sides = &self.sides[sheet.edges[edge] as usize..sheet.edges[edge + 1] as usize];
        let place = sides.iter().position(|&side| side == own).unwrap_or(0);
        // The front of a triangle that runs up is counterclockwise of it.
        let ahead = (seen == Side::Front) == runs_up(sheet, own);
        let step = if ahead { 1 } else { sides.len() - 1 };
        let next = sides[(place + step) % sides.len()];
        // It is reached from its clockwise side if that was the way.
        let front = runs_up(sheet, next) != ahead;
        (next / 4, if front { Side::Front } else { Side::Back })
    }
}

fn edge_of(sheet: &Sheet<'_>, side: u32) -> u32 {
    sheet.edge_of_side[side as usize / 4][side as usize % 4]
}

/// The two ends of a side, in the triangle's order.
fn ends(sheet: &Sheet<'_>, side: u32) -> [u32; 2] {
    let corners = sheet.corners[side as usize / 4];
    [corners[side as usize % 4], corners[(side as usize % 4 + 1) % 3]]
}

/// Whether the triangle runs its side from the lesser vertex to the greater.
fn runs_up(sheet: &Sheet<'_>, side: u32) -> bool {
    let [a, b] = ends(sheet, side);
    a < b
}

//! Umbrellas: the Delaunay triangles at a sample that lie along the surface.

use crate::dual::Dual;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{PART, Room, Run, parts};
use crate::poles::{FirstPoles, is_opposite};
use crate::triangulation::Incidence;
use crate::vector::dot;

/// For each sample p the triangles of its umbrella U_p: those at p whose dual Voronoi edge is cut by the tangent polygon, the
/// plane through p across the pole vector (Dey, Zhao 2004, definitions 2 and 3).
///
/// Which edges are cut is decided exactly, for the exact Voronoi vertices. A vertex in the plane counts as beyond it, on the side of the
/// pole; so the plane is moved by nothing, and every cut is one of edges. At infinity the direction of an unbounded edge decides.
///
/// Invariants: row p of `rims` has the two other vertices of each triangle, so that the triangle turns counterclockwise seen
/// from the pole; where the umbrella is a disk the second of one is the first of the next, and the least comes first. Otherwise
/// they ascend.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Umbrellas {
    pub(super) offsets: Vec<u32>,
    pub(super) rims: Vec<[u32; 2]>,
    pub(super) is_disk: Vec<bool>,
}

impl Umbrellas {
    pub(super) fn new(
        dual: &Dual,
        incidence: &Incidence,
        poles: &FirstPoles,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let t = dual.triangulation();
        let is_below = below(dual, poles, room, run)?;
        let chunks = parts(t.coords().len()).into_iter().flat_map(|range| {
            // A sample's umbrella costs more than a step of most loops.
            let end = range.end;
            range.step_by(PART / 8).map(move |begin| begin..end.min(begin + PART / 8))
        });
        let pieces = run.in_steps(chunks.collect(), [0.4, 0.6], |range| {
            let mut room = Room::new(run);
            let (mut ends, mut rims) = (room.vec(range.len())?, Vec::new());
            let (mut is_disk, mut found) = (room.vec(range.len())?, Vec::new());
            let mut seen = 0;
            for sample in range {
                let cells = incidence.cells_of(sample as u32);
                seen += cells.len();
                if seen >= 4096 {
                    seen = 0;
                    run.poll()?;
                }
                found.clear();
                for &cell in cells {
                    rims_in(dual, poles, &is_below, cell, sample as u32, &mut found);
                }
                is_disk.push(chain(&mut found));
                room.grow(&mut rims, found.len())?;
                rims.extend_from_slice(&found);
                ends.push(rims.len() as u32);
            }
            run.poll()?;
            Ok((ends, rims, is_disk, room))
        })?;
        let count = pieces.iter().map(|(_, rims, ..)| rims.len()).sum();
        let mut umbrellas = Umbrellas {
            offsets: room.vec(t.coords().len() + 1)?,
            rims: room.vec(count)?,
            is_disk: room.vec(t.coords().len())?,
        };
        umbrellas.offsets.push(0);
        for (ends, rims, is_disk, _) in pieces {
            run.poll()?;
            let begin = umbrellas.rims.len() as u32;
            umbrellas.offsets.extend(ends.iter().map(|&end| begin + end));
            umbrellas.rims.extend(rims);
            umbrellas.is_disk.extend(is_disk);
        }
        Ok(umbrellas)
    }

    /// The two other vertices of each triangle of one sample's umbrella.
    pub fn rims_of(&self, sample: u32) -> &[[u32; 2]] {
        let s = sample as usize;
        &self.rims[self.offsets[s] as usize..self.offsets[s + 1] as usize]
    }

    /// Where the triangles of each sample begin; one more entry than samples.
    pub fn offsets(&self) -> &[u32] {
        &self.offsets
    }

    /// The triangles of all samples, one after the other.
    pub fn rims(&self) -> &[[u32; 2]] {
        &self.rims
    }

    /// Whether each sample's umbrella is a topological disk: its triangles make one ring round the sample. Where the sample is on the hull, or
    /// has no Voronoi cell of its own, it may not be.
    pub fn is_disk(&self) -> &[bool] {
        &self.is_disk
    }

    /// The samples whose umbrella is no disk.
    pub fn torn_count(&self) -> usize {
        self.is_disk.iter().filter(|&&is_disk| !is_disk).count()
    }
}

/// For each cell the corners, a bit for each slot, whose tangent plane has the cell's centre below it, on the side away from
/// the pole.
fn below(dual: &Dual, poles: &FirstPoles, room: &mut Room<'_>, run: &Run<'_>) -> Result<Vec<u8>> {
    let t = dual.triangulation();
    let mut is_below = room.filled(t.cells().len(), 0u8)?;
    let chunks = is_below.chunks_mut(PART / 4).zip(t.cells().chunks(PART / 4)).zip(0..).collect();
    run.in_steps(
        chunks,
        [0.2, 0.4],
        |((is_below, cells), chunk): ((&mut [u8], &[[u32; 4]]), usize)| {
            run.poll()?;
            for (i, (bits, corners)) in is_below.iter_mut().zip(cells).enumerate() {
                let cell = (chunk * (PART / 4) + i) as u32;
                for (slot, &v) in corners.iter().enumerate() {
                    let v = v as usize;
                    let is_below = is_opposite(dual, v, cell, poles.cells[v], poles.normals[v]);
                    *bits |= u8::from(is_below) << slot;
                }
            }
            Ok(())
        },
    )?;
    Ok(is_below)
}

/// The rims of the umbrella of a vertex that the facets of one of its cells give. A facet between two cells is the business of the lower
/// one, which lies below the vertex' tangent plane.
fn rims_in(
    dual: &Dual,
    poles: &FirstPoles,
    is_below: &[u8],
    cell: u32,
    vertex: u32,
    rims: &mut Vec<[u32; 2]>,
) {
    let t = dual.triangulation();
    let corners = t.cells()[cell as usize];
    let Some(slot) = corners.iter().position(|&v| v == vertex) else { return };
    let is_low = is_below[cell as usize] >> slot & 1 == 1;
    for facet in (0..4).filter(|&facet| facet != slot) {
        let neighbor = t.neighbors()[cell as usize][facet];
        let is_cut = match neighbor {
            NONE => is_low != is_low_at_infinity(dual, poles, cell, facet, vertex),
            _ if !is_low => false,
            neighbor => {
                let place = t.cells()[neighbor as usize].iter().position(|&v| v == vertex);
                place.is_some_and(|place| is_below[neighbor as usize] >> place & 1 == 0)
            }
        };
        if is_cut {
            // The facet turns counterclockwise seen from outside the cell.
            let mut ring = t.facet(cell, facet);
            while ring[0] != vertex {
                ring.rotate_left(1);
            }
            // Outside is above, but where an unbounded edge comes down from above.
            let rim = [ring[1], ring[2]];
            rims.push(if is_low { rim } else { [rim[1], rim[0]] });
        }
    }
}

/// Whether the unbounded Voronoi edge of a facet on the hull ends below the tangent plane of the vertex.
#[cold]
fn is_low_at_infinity(
    dual: &Dual,
    poles: &FirstPoles,
    cell: u32,
    facet: usize,
    vertex: u32,
) -> bool {
    let ray = dual.rays().of_facet(cell, facet as u32);
    dot(dual.rays().directions()[ray as usize], poles.normals[vertex as usize]) < 0.0
}

/// Puts rims into a ring if they make one: each begins where the one before ends, the least first. Whether they do; if not they
/// ascend.
fn chain(rims: &mut [[u32; 2]]) -> bool {
    rims.sort_unstable();
    if rims.len() < 3 || rims.windows(2).any(|pair| pair[0][0] == pair[1][0]) {
        return false;
    }
    let sorted: Vec<[u32; 2]> = rims.to_vec();
    let mut at = 0;
    for (i, rim) in rims.iter_mut().enumerate() {
        *rim = sorted[at];
        let next = sorted.binary_search_by_key(&rim[1], |rim| rim[0]);
        let is_last = i + 1 == sorted.len();
        match next {
            // Back at the first at the end, and not before: there is one ring.
            Ok(next) if (next == 0) == is_last => at = next,
            _ => {
                rims.copy_from_slice(&sorted);
                return false;
            }
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::chain;

    #[test]
    fn rims_that_make_one_ring_are_put_in_its_order() {
        let mut ring = [[4, 9], [7, 2], [9, 7], [2, 4]];
        assert!(chain(&mut ring));
        assert_eq!(ring, [[2, 4], [4, 9], [9, 7], [7, 2]]);
    }

    #[test]
    fn anything_else_is_no_disk() {
        for rims in [
            vec![],
            vec![[1, 2], [2, 1]],
            // Open, two rings, a vertex that is passed twice.
            vec![[1, 2], [2, 3], [3, 4]],
            vec![[1, 2], [2, 3], [3, 1], [4, 5], [5, 6], [6, 4]],
            vec![[1, 2], [2, 3], [3, 1], [1, 5], [5, 6], [6, 1]],
        ] {
            let mut found = rims.clone();
            assert!(!chain(&mut found), "{rims:?}");
            let mut sorted = rims.clone();
            sorted.sort_unstable();
            assert_eq!(found, sorted);
        }
    }
}

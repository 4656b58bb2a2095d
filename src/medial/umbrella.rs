//! Umbrellas: the Delaunay triangles at a sample that lie along the surface.

use crate::dual::Dual;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{PART, Room, Run, parts, parts_of, pieces};
use crate::poles::{FirstPoles, TangentPlane};
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
        poles: &FirstPoles,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let count = dual.triangulation().coords().len();
        let is_below = below(dual, poles, room, run)?;
        let found = triangles(dual, poles, &is_below, run)?;
        let mut offsets = room.filled(count + 1, 0u32)?;
        for triangle in run.watch(found.iter().flat_map(|(triangles, _)| triangles)) {
            offsets[triangle?.vertex as usize + 1] += 1;
        }
        for vertex in 0..count {
            offsets[vertex + 1] += offsets[vertex];
        }
        let mut rims = room.filled(offsets[count] as usize, [0; 2])?;
        let mut next = room.collect(offsets.iter().copied())?;
        for triangle in run.watch(found.iter().flat_map(|(triangles, _)| triangles)) {
            let Triangle { vertex, rim } = *triangle?;
            let place = &mut next[vertex as usize];
            rims[*place as usize] = rim;
            *place += 1;
        }
        drop(found);
        let mut is_disk = room.filled(count, false)?;
        let samples = parts_of(PART / 4, count);
        let ends = samples.iter().map(|samples| offsets[samples.end] as usize);
        let results = is_disk.chunks_mut(PART / 4).zip(pieces(&mut rims, ends));
        let chunks = results.zip(&samples).collect();
        run.in_steps(chunks, [0.5, 0.6], |((is_disk, rims), samples)| {
            run.poll()?;
            let mut sorted = Vec::new();
            let offsets = &offsets[samples.start..=samples.end];
            for (is_disk, range) in is_disk.iter_mut().zip(offsets.windows(2)) {
                let [begin, end] = [0, 1].map(|i| (range[i] - offsets[0]) as usize);
                *is_disk = chain(&mut rims[begin..end], &mut sorted);
            }
            Ok(())
        })?;
        Ok(Umbrellas { offsets, rims, is_disk })
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
    let mut planes = room.filled(t.coords().len(), TangentPlane::default())?;
    let rows =
        planes.chunks_mut(PART).zip(poles.cells.chunks(PART).zip(poles.normals.chunks(PART)));
    run.in_steps(rows.zip(0..).collect(), [0.2, 0.25], |((planes, (cells, normals)), chunk)| {
        run.poll()?;
        for (i, (plane, (&first, &normal))) in
            planes.iter_mut().zip(cells.iter().zip(normals)).enumerate()
        {
            *plane = TangentPlane::new(dual, chunk * PART + i, first, normal);
        }
        Ok(())
    })?;
    let mut is_below = room.filled(t.cells().len(), 0u8)?;
    let chunks = is_below.chunks_mut(PART / 4).zip(t.cells().chunks(PART / 4)).zip(0..).collect();
    run.in_steps(
        chunks,
        [0.25, 0.35],
        |((is_below, cells), chunk): ((&mut [u8], &[[u32; 4]]), usize)| {
            run.poll()?;
            for (i, (bits, corners)) in is_below.iter_mut().zip(cells).enumerate() {
                let cell = (chunk * (PART / 4) + i) as u32;
                *bits = (0..4).fold(0, |bits, slot| {
                    let v = corners[slot];
                    bits | u8::from(planes[v as usize].is_below(dual, v, cell)) << slot
                });
            }
            Ok(())
        },
    )?;
    Ok(is_below)
}

/// A triangle of the umbrella of a vertex: with its two other vertices it turns counterclockwise seen from the pole.
struct Triangle {
    vertex: u32,
    rim: [u32; 2],
}

/// The triangles of all umbrellas, in pieces with the room that they take. A facet between two cells is the business of the
/// lower one, which lies below the vertex' tangent plane.
fn triangles<'a>(
    dual: &Dual,
    poles: &FirstPoles,
    is_below: &[u8],
    run: &'a Run<'a>,
) -> Result<Vec<(Vec<Triangle>, Room<'a>)>> {
    let t = dual.triangulation();
    run.in_steps(parts(t.cells().len()), [0.35, 0.45], |cells| {
        let mut room = Room::new(run);
        // An umbrella has about six triangles, a vertex some six or seven cells to itself.
        let mut triangles = room.vec(cells.len())?;
        for cell in cells {
            if cell % 1024 == 0 {
                run.poll()?;
            }
            let (corners, low) = (t.cells()[cell], is_below[cell]);
            for (facet, &neighbor) in t.neighbors()[cell].iter().enumerate() {
                let cut = match neighbor {
                    NONE => low ^ below_at_infinity(dual, poles, cell as u32, facet),
                    _ => {
                        let neighbor = neighbor as usize;
                        low & !carried(is_below[neighbor], t.cells()[neighbor], corners)
                    }
                };
                let mut cut = cut & !(1 << facet);
                while cut != 0 {
                    let slot = cut.trailing_zeros() as usize;
                    cut &= cut - 1;
                    // The facet turns counterclockwise seen from outside the cell, and outside is above, but where an unbounded
                    // edge comes down from above.
                    let mut rim = t.rim(cell as u32, facet, slot);
                    if low >> slot & 1 == 0 {
                        rim.reverse();
                    }
                    room.push(&mut triangles, Triangle { vertex: corners[slot], rim })?;
                }
            }
        }
        Ok((triangles, room))
    })
}

/// Bits by the slots of one cell as bits by the slots of another, for the vertices that both have.
#[inline]
fn carried(bits: u8, from: [u32; 4], to: [u32; 4]) -> u8 {
    // Whole registers, as the compiler sees at once.
    let mut found = [0u32; 4];
    for (slot, v) in from.into_iter().enumerate() {
        let bit = u32::from(bits >> slot & 1);
        for (found, w) in found.iter_mut().zip(to) {
            *found |= if v == w { bit } else { 0 };
        }
    }
    let [a, b, c, d] = found;
    (a | b << 1 | c << 2 | d << 3) as u8
}

/// The corners of a facet on the hull, a bit for each slot of its cell, whose tangent plane has the far end of the unbounded Voronoi edge
/// below it.
#[cold]
fn below_at_infinity(dual: &Dual, poles: &FirstPoles, cell: u32, facet: usize) -> u8 {
    let ray = dual.rays().of_facet(cell, facet as u32);
    let direction = dual.rays().directions()[ray as usize];
    let corners = dual.triangulation().cells()[cell as usize];
    (0..4).fold(0, |bits, slot| {
        let normal = poles.normals[corners[slot] as usize];
        bits | u8::from(dot(direction, normal) < 0.0) << slot
    })
}

/// Puts rims into a ring if they make one: each begins where the one before ends, the least first. Whether they do; if not they
/// ascend.
fn chain(rims: &mut [[u32; 2]], sorted: &mut Vec<[u32; 2]>) -> bool {
    rims.sort_unstable();
    if rims.len() < 3 || rims.windows(2).any(|pair| pair[0][0] == pair[1][0]) {
        return false;
    }
    sorted.clear();
    sorted.extend_from_slice(rims);
    let mut at = 0;
    for (i, rim) in rims.iter_mut().enumerate() {
        *rim = sorted[at];
        let next = sorted.binary_search_by_key(&rim[1], |rim| rim[0]);
        let is_last = i + 1 == sorted.len();
        match next {
            // Back at the first at the end, and not before: there is one ring.
            Ok(next) if (next == 0) == is_last => at = next,
            _ => {
                rims.copy_from_slice(sorted);
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
        assert!(chain(&mut ring, &mut Vec::new()));
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
            assert!(!chain(&mut found, &mut Vec::new()), "{rims:?}");
            let mut sorted = rims.clone();
            sorted.sort_unstable();
            assert_eq!(found, sorted);
        }
    }
}

//! Shards: the vertices of the power diagram that are one sample, but for the rounding of the balls.
//!
//! A sample has power zero to every pole whose ball it lies on, and these are seven or eight, not four: the power diagram has a
//! vertex there that more than four poles share. Rounded, it breaks into several: the shards. Which they are
//! is told by the poles alone, never by distance: a vertex whose four poles' balls all touch the sample is the sample.

use crate::complex::{DisjointSets, Rows};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{PART, Room, Run};
use crate::poles::Poles;
use crate::sort::sort_by_key;
use crate::triangulation::Triangulation;

/// The sample that each of the given cells' orthocentres is, or [`NONE`]: the one on the balls of all four poles. Where
/// there are several, as in cells that are flat but for rounding, the least.
pub(super) fn samples_of_cells(
    poles: &Poles,
    regular: &Triangulation,
    cells: &[u32],
    progress: [f64; 2],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<u32>> {
    let touching = |vertex: u32| {
        let pole = regular.row_of_vertex()[vertex as usize];
        poles.samples_on_balls().row(pole as usize)
    };
    let sample_of = |cell: u32| {
        let rows = regular.cells()[cell as usize].map(touching);
        // A ball may touch all samples of a sphere: the others have few.
        let fewest =
            (1..4).fold(0, |best, i| if rows[i].len() < rows[best].len() { i } else { best });
        let touches_all =
            |sample: &&u32| (0..4).all(|i| i == fewest || rows[i].binary_search(sample).is_ok());
        rows[fewest].iter().find(touches_all).copied().unwrap_or(NONE)
    };
    let mut samples = room.filled(cells.len(), 0u32)?;
    let chunks = samples.chunks_mut(PART).zip(cells.chunks(PART)).collect();
    run.in_steps(chunks, progress, |(samples, cells): (&mut [u32], &[u32])| {
        run.poll()?;
        for (sample, &cell) in samples.iter_mut().zip(cells) {
            *sample = sample_of(cell);
        }
        Ok(())
    })?;
    Ok(samples)
}

/// The vertex that stands for each vertex of a closed surface once the shards of each sample are merged: the least of
/// those that hang together.
///
/// Merging shards that make up a disk changes no topology. Where they make up something else, where the faces left, or their triangles, could not be told
/// from each other by their vertices, or where `turned` names the vertex that would stand for them, they stay apart: each is itself, and no sample any more.
/// `turned` sees the samples and what would be merged.
pub(super) fn merged(
    samples: &mut [u32],
    faces: &Rows,
    mut turned: impl FnMut(&[u32], &[u32]) -> Result<Vec<u32>>,
    run: &Run<'_>,
) -> Result<Vec<u32>> {
    let mut room = Room::new(run);
    loop {
        let roots = joined(samples, faces, &mut room, run)?;
        let mut is_wrong = wrong(&roots, faces, &mut room, run)?;
        for root in turned(samples, &roots)? {
            is_wrong[root as usize] = true;
        }
        let mut any = false;
        for (sample, &root) in samples.iter_mut().zip(&roots) {
            if *sample != NONE && is_wrong[root as usize] {
                *sample = NONE;
                any = true;
            }
        }
        if !any {
            return Ok(roots);
        }
    }
}

/// The least vertex of all that sides of faces connect to each one, where both ends are shards of one sample.
fn joined(samples: &[u32], faces: &Rows, room: &mut Room<'_>, run: &Run<'_>) -> Result<Vec<u32>> {
    let mut sets = DisjointSets::new(samples.len(), run)?;
    for ring in run.watch(faces.iter()) {
        for [a, b] in sides(ring?) {
            let sample = samples[a as usize];
            // The other side comes from the other face.
            if a < b && sample != NONE && sample == samples[b as usize] {
                sets.join(a, b);
            }
        }
    }
    room.collect((0..samples.len() as u32).map(|v| sets.root(v)))
}

/// Which merged vertices, by their roots, would not leave the surface what it is.
fn wrong(roots: &[u32], faces: &Rows, room: &mut Room<'_>, run: &Run<'_>) -> Result<Vec<bool>> {
    // Of the part of the surface that becomes one vertex: the Euler characteristic, which is 1 if and only if it is a disk
    // (or a tree, or between the two), since it hangs together and is not all of a surface.
    let mut euler = room.filled(roots.len(), 0i32)?;
    let mut last_face = room.filled(roots.len(), NONE)?;
    let mut is_wrong = room.filled(roots.len(), false)?;
    let mut left: Vec<u64> = Vec::new();
    let mut ring = Vec::new();
    for &root in roots {
        euler[root as usize] += 1;
    }
    for face in run.watch(faces.iter().zip(0..)) {
        let (face, id) = face?;
        for [a, b] in sides(face) {
            let root = roots[a as usize];
            if a < b && root == roots[b as usize] {
                euler[root as usize] -= 1;
            }
        }
        contract(face, roots, &mut ring);
        match ring[..] {
            [root] => euler[root as usize] += 1,
            [_, _] => {}
            _ => {
                for [a, b] in sides(&ring) {
                    // The face comes back to a vertex.
                    is_wrong[a as usize] |= std::mem::replace(&mut last_face[a as usize], id) == id;
                    room.push(&mut left, u64::from(a) << 32 | u64::from(b))?;
                }
                // The sides of its triangles count as well, which are a fan from its first vertex.
                for &b in &ring[2..ring.len() - 1] {
                    for [a, b] in [[ring[0], b], [b, ring[0]]] {
                        room.push(&mut left, u64::from(a) << 32 | u64::from(b))?;
                    }
                }
            }
        }
    }
    sort_by_key(&mut left, |&side| side, run)?;
    for pair in run.watch(left.windows(2)) {
        let pair = pair?;
        // Two faces, or two of their triangles, have the same side.
        if pair[0] == pair[1] {
            is_wrong[(pair[0] >> 32) as usize] = true;
            is_wrong[pair[0] as u32 as usize] = true;
        }
    }
    for (v, &root) in roots.iter().enumerate() {
        // What no face has left is a component that would vanish.
        is_wrong[v] |= root as usize == v && (euler[v] != 1 || last_face[v] == NONE);
    }
    Ok(is_wrong)
}

/// The ring of a face after vertices were merged: none follows itself. At least one vertex.
pub(super) fn contract(face: &[u32], roots: &[u32], ring: &mut Vec<u32>) {
    ring.clear();
    ring.extend(face.iter().map(|&v| roots[v as usize]));
    ring.dedup();
    while ring.len() > 1 && ring.first() == ring.last() {
        ring.pop();
    }
}

/// The sides of a face, each from its tail to its head.
fn sides(ring: &[u32]) -> impl Iterator<Item = [u32; 2]> {
    let heads = ring.iter().cycle().skip(1);
    ring.iter().zip(heads).map(|(&a, &b)| [a, b])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::Job;

    /// The faces of a closed surface, and what stands for each vertex, given the vertices that are shards of sample 7.
    fn roots(faces: &[&[u32]], vertices: usize, shards: &[u32]) -> Vec<u32> {
        let mut rows = Rows::default();
        faces.iter().for_each(|face| rows.push(face).unwrap());
        let sample = |v: u32| if shards.contains(&v) { 7 } else { NONE };
        let mut samples: Vec<u32> = (0..vertices as u32).map(sample).collect();
        Job::default().run(&[], |run| merged(&mut samples, &rows, |_, _| Ok(vec![]), run)).unwrap()
    }

    const CUBE: [&[u32]; 6] =
        [&[0, 2, 3, 1], &[4, 5, 7, 6], &[0, 1, 5, 4], &[2, 6, 7, 3], &[0, 4, 6, 2], &[1, 3, 7, 5]];

    #[test]
    fn shards_that_are_a_disk_become_the_least_of_them() {
        assert_eq!(roots(&CUBE, 8, &[1, 3]), [0, 1, 2, 1, 4, 5, 6, 7]);
        // A face, and more than half of all.
        assert_eq!(roots(&CUBE, 8, &[4, 5, 6, 7]), [0, 1, 2, 3, 4, 4, 4, 4]);
        // Two that no side connects are two.
        assert_eq!(roots(&CUBE, 8, &[0, 7]), [0, 1, 2, 3, 4, 5, 6, 7]);
    }

    #[test]
    fn shards_that_are_no_disk_stay_apart() {
        // Four sides round four triangles, none of which is all shards.
        let mut faces: Vec<&[u32]> = vec![&[0, 2, 8], &[2, 3, 8], &[3, 1, 8], &[1, 0, 8]];
        faces.extend(&CUBE[1..]);
        let all: Vec<u32> = (0..9).collect();
        assert_eq!(roots(&faces, 9, &[0, 1, 2, 3]), all);
        assert_eq!(roots(&faces, 9, &[0, 1, 2, 3, 8]), [0, 0, 0, 0, 4, 5, 6, 7, 0]);
        // All of a component: it would vanish.
        assert_eq!(roots(&CUBE, 8, &all[..8]), all[..8]);
    }

    #[test]
    fn shards_stay_apart_where_faces_could_not_be_told_by_their_vertices() {
        // A face would come back to a vertex.
        let faces: [&[u32]; 3] = [&[0, 1, 2, 3, 4, 5], &[0, 3, 2, 1], &[0, 5, 4, 3]];
        assert_eq!(roots(&faces, 6, &[0, 3]), [0, 1, 2, 3, 4, 5]);
        // Two faces would have the same side, from 0 to 1.
        let faces: [&[u32]; 6] =
            [&[0, 1, 3], &[1, 2, 3], &[2, 0, 3], &[1, 0, 4], &[2, 1, 4], &[0, 2, 4]];
        assert_eq!(roots(&faces, 5, &[1, 2]), [0, 1, 2, 3, 4]);
        // Two triangles would, from 0 to 2: the first two faces lie on either side of vertex 1 then.
        let faces: [&[u32]; 4] = [&[0, 1, 2, 3], &[0, 4, 5, 1], &[2, 1, 5], &[3, 2, 5, 4, 0]];
        assert_eq!(roots(&faces, 6, &[2, 5]), [0, 1, 2, 3, 4, 5]);
    }

    #[test]
    fn shards_stay_apart_all_of_them_where_a_triangle_would_turn() {
        let mut rows = Rows::default();
        CUBE.iter().for_each(|face| rows.push(face).unwrap());
        let mut samples = [NONE, 7, NONE, 7, 8, 8, NONE, NONE];
        let turned = |samples: &[u32], roots: &[u32]| {
            assert_eq!(samples[1] == 7, roots == [0, 1, 2, 1, 4, 4, 6, 7]);
            Ok(if samples[1] == 7 { vec![1, 2] } else { vec![] })
        };
        let roots =
            Job::default().run(&[], |run| merged(&mut samples, &rows, turned, run)).unwrap();
        assert_eq!(roots, [0, 1, 2, 3, 4, 4, 6, 7]);
        assert_eq!(samples, [NONE, NONE, NONE, NONE, 8, 8, NONE, NONE]);
    }
}

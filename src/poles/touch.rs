//! The samples on each polar ball.

use crate::complex::Rows;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::triangulation::Triangulation;

/// For each pole the samples on its ball, ascending: the vertices of all cells whose Voronoi vertex it is. No other
/// sample lies on the ball, or in it.
///
/// Given the least cell that shares its sphere for each cell, and the pole of each of these. Cost: O(m).
pub(super) fn samples_on_balls(
    t: &Triangulation,
    samples: usize,
    poles: usize,
    pole_of_cell: impl Fn(usize) -> u32,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Rows> {
    let is_sample = |&&v: &&u32| (v as usize) < samples;
    // Row p begins at ends[p + 1] while it is filled, which moves that to its end.
    let mut ends = room.filled(poles + 2, 0u32)?;
    for cell in run.watch(t.cells().iter().enumerate()) {
        let (id, cell) = cell?;
        if let Some(end) = ends.get_mut((pole_of_cell(id) as usize).saturating_add(2)) {
            *end += cell.iter().filter(is_sample).count() as u32;
        }
    }
    for pole in 2..poles + 2 {
        ends[pole] += ends[pole - 1];
    }
    let mut touching = room.filled(ends[poles + 1] as usize, 0u32)?;
    for cell in run.watch(t.cells().iter().enumerate()) {
        let (id, cell) = cell?;
        let pole = pole_of_cell(id);
        if pole != NONE {
            let end = &mut ends[pole as usize + 1];
            for &sample in cell.iter().filter(is_sample) {
                touching[*end as usize] = sample;
                *end += 1;
            }
        }
    }
    // Cells that share their sphere share samples: each once.
    let (mut begin, mut kept) = (0, 0);
    for end in run.watch(ends[1..=poles].iter_mut()) {
        let end = end?;
        touching[begin..*end as usize].sort_unstable();
        let first = kept;
        for i in begin..*end as usize {
            if kept == first || touching[kept - 1] != touching[i] {
                touching[kept] = touching[i];
                kept += 1;
            }
        }
        begin = *end as usize;
        *end = kept as u32;
    }
    touching.truncate(kept);
    ends.truncate(poles + 1);
    Rows::new(ends, touching)
}

//! Peeling: cells that are not marked, taken off from outside.

use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::triangulation::Triangulation;

/// For each cell whether it is inner (Dey, Goswami 2003, PEEL).
///
/// Cells that are marked are what they are marked as. Of the others those go that are reached from what is beyond the hull, or from cells that are marked outer,
/// through cells that go; but not through triangles of the surface, of which `walls` has a bit for each facet. What is left is inner. The paper
/// keeps all that the walk from beyond the hull does not reach; here a void that is marked outer is kept as a void.
pub(super) fn peel(
    t: &Triangulation,
    walls: &[u8],
    votes: &[i8],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<bool>> {
    let mut is_inner = room.collect(votes.iter().map(|&vote| vote >= 0))?;
    let mut stack = Vec::new();
    for cell in run.watch(0..votes.len()) {
        let cell = cell?;
        let is_open = |i: usize| t.is_hull(cell as u32, i) && walls[cell] >> i & 1 == 0;
        let goes = votes[cell] == 0 && (0..4).any(is_open);
        if votes[cell] < 0 || goes {
            is_inner[cell] = false;
            room.push(&mut stack, cell as u32)?;
        }
    }
    let mut done = 0;
    while let Some(cell) = stack.pop() {
        done += 1;
        if done % 4096 == 0 {
            run.poll()?;
        }
        for (i, &next) in t.neighbors()[cell as usize].iter().enumerate() {
            if next != NONE
                && walls[cell as usize] >> i & 1 == 0
                && is_inner[next as usize]
                && votes[next as usize] == 0
            {
                is_inner[next as usize] = false;
                room.push(&mut stack, next)?;
            }
        }
    }
    Ok(is_inner)
}

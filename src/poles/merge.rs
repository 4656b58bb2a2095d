//! Cells that share their Voronoi vertex.

use crate::dual::Dual;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run, parts};
use crate::predicates::insphere;

/// For each cell the least cell with the same circumscribed sphere, in exact arithmetic.
///
/// Such cells make up one polytope, so they hang together through facets. Cost: O(m), since equal
/// spheres have equal rounded centres, and the predicate looks at those only.
pub(crate) fn least_cells<'a>(
    dual: &Dual,
    room: &mut Room<'a>,
    run: &'a Run<'a>,
) -> Result<Vec<u32>> {
    let t = dual.triangulation();
    let count = t.cells().len();
    let mut parent = room.collect(0..count as u32)?;
    let pairs = run.in_steps(parts(count), [0.0, 0.25], |range| {
        let mut room = Room::new(run);
        let mut pairs: Vec<[u32; 2]> = Vec::new();
        for cell in range {
            for neighbor in t.neighbors()[cell] {
                if neighbor != NONE
                    && neighbor as usize > cell
                    && same_sphere(dual, cell, neighbor as usize)
                {
                    room.push(&mut pairs, [cell as u32, neighbor])?;
                }
            }
        }
        run.poll()?;
        Ok((pairs, room))
    })?;
    for pair in run.watch(pairs.iter().flat_map(|(pairs, _)| pairs)) {
        let [a, b] = pair?.map(|cell| root(&mut parent, cell));
        parent[a.max(b) as usize] = a.min(b);
    }
    // A parent is less than its child: by the time a cell is reached, its parent points at the root.
    for cell in run.watch(0..count) {
        let cell = cell?;
        parent[cell] = parent[parent[cell] as usize];
    }
    Ok(parent)
}

/// Whether two neighbouring cells have the same circumscribed sphere.
fn same_sphere(dual: &Dual, cell: usize, neighbor: usize) -> bool {
    let t = dual.triangulation();
    let at = |v: u32| &t.coords()[v as usize];
    let [a, b, c, d] = t.cells()[cell];
    let apex = || t.cells()[neighbor].into_iter().find(|v| ![a, b, c, d].contains(v));
    // Radii are sooner looked at than centres.
    dual.radii_squared()[cell] == dual.radii_squared()[neighbor]
        && dual.centers()[cell] == dual.centers()[neighbor]
        && apex().is_some_and(|e| insphere(at(a), at(b), at(c), at(d), at(e)).is_zero())
}

fn root(parent: &mut [u32], mut cell: u32) -> u32 {
    while parent[cell as usize] != cell {
        let above = parent[parent[cell as usize] as usize];
        parent[cell as usize] = above;
        cell = above;
    }
    cell
}

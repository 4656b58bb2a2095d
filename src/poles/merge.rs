//! Cells that share their Voronoi vertex, and rays that are one unbounded Voronoi edge.

use crate::dual::{Dual, Facets};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run, parts};
use crate::predicates::{insphere, orient3d};

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
        unite(&mut parent, *pair?);
    }
    flatten(&mut parent, run)?;
    Ok(parent)
}

/// For each ray of the dual the least that is the same: one whose hull triangle lies in the same plane, in exact arithmetic, and
/// whose cell has the same Voronoi vertex.
///
/// Such triangles share their circumscribed circle and make up one polygon of the hull, so they hang together through edges. Cost: O(facets).
pub(crate) fn least_rays(
    dual: &Dual,
    facets: &Facets,
    least_cell: &[u32],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<u32>> {
    let t = dual.triangulation();
    let mut parent = room.collect(0..dual.rays().len() as u32)?;
    for item in run.watch(facets.rays().iter().zip(facets.edges())) {
        let (&rays, ends) = item?;
        if rays[0] == NONE {
            continue;
        }
        let [(come, a), (go, b)] = rays.map(|ray| {
            let [cell, facet] = dual.rays().facets()[ray as usize];
            let third = t.facet(cell, facet as usize).into_iter().find(|v| !ends.contains(v));
            (least_cell[cell as usize], third)
        });
        let at = |v: u32| &t.coords()[v as usize];
        let [p, q] = ends.map(at);
        if let (Some(a), Some(b)) = (a, b)
            && come == go
            && orient3d(p, q, at(a), at(b)).is_zero()
        {
            unite(&mut parent, rays);
        }
    }
    flatten(&mut parent, run)?;
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

fn unite(parent: &mut [u32], pair: [u32; 2]) {
    let [a, b] = pair.map(|item| root(parent, item));
    parent[a.max(b) as usize] = a.min(b);
}

/// Points every item at its root. A parent is less than its child: by the time an item is reached, its parent points there.
fn flatten(parent: &mut [u32], run: &Run<'_>) -> Result<()> {
    for item in run.watch(0..parent.len()) {
        let item = item?;
        parent[item] = parent[parent[item] as usize];
    }
    Ok(())
}

fn root(parent: &mut [u32], mut cell: u32) -> u32 {
    while parent[cell as usize] != cell {
        let above = parent[parent[cell as usize] as usize];
        parent[cell as usize] = above;
        cell = above;
    }
    cell
}

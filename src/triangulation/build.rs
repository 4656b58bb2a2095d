//! Incremental construction: one point after the other, in a biased randomised order.

use super::cavity::Cavity;
use super::cells::{Cells, Mark};
use super::conflict::{Conflict, Site};
use super::order::insertion_order;
use super::walk::Walk;
use crate::error::{Error, Result, Status};
use crate::job::Run;
use crate::predicates::{Sign, collinear, orient3d};

/// Points between two looks at the clock.
const TICK: usize = 64;

/// Triangulates distinct sites; the free slots are marked [`Mark::Conflict`].
///
/// Errors: [`Status::TooFewPoints`] below four, [`Status::Degenerate`] for flat sets, and those
/// of the run.
pub(super) fn build<'a, C: Conflict>(sites: &[Site], run: &'a Run<'a>) -> Result<Cells<'a>> {
    let simplex = first_simplex(sites.len(), |v| *sites[v as usize].position(), run)?;
    let mut mesh = Cells::new(simplex, sites.len(), run)?;
    let mut cavity = Cavity::<C>::new(sites.len(), run)?;
    let mut walk = Walk::new(0);
    for (done, vertex) in insertion_order(sites.len()).enumerate() {
        if done % TICK == 0 {
            run.tick(done, sites.len())?;
        }
        if simplex.contains(&vertex) {
            continue;
        }
        let cell = walk.locate(&mesh, sites, &sites[vertex as usize]);
        walk.cell = cavity.insert(&mut mesh, sites, vertex, cell, run)?.unwrap_or(cell);
    }
    for &cell in &mesh.free {
        mesh.marks[cell as usize] = Mark::Conflict;
    }
    Ok(mesh)
}

/// Four sites that span space, positively oriented: the first ones in the order of insertion.
pub(super) fn first_simplex(
    count: usize,
    at: impl Fn(u32) -> [f64; 3],
    run: &Run<'_>,
) -> Result<[u32; 4]> {
    if count < 4 {
        return Err(Error::new(
            Status::TooFewPoints,
            format!("a triangulation needs 4 distinct points, not {count}"),
        ));
    }
    let mut found: Vec<u32> = Vec::with_capacity(4);
    for (done, v) in insertion_order(count).enumerate() {
        if done % 4096 == 0 {
            run.poll()?;
        }
        match found[..] {
            [a, b] if collinear(&at(a), &at(b), &at(v)) => {}
            [a, b, c] => match orient3d(&at(a), &at(b), &at(c), &at(v)) {
                Sign::Zero => {}
                Sign::Positive => return Ok([a, b, c, v]),
                Sign::Negative => return Ok([b, a, c, v]),
            },
            _ => found.push(v),
        }
    }
    let dimension = found.len() - 1;
    let place = if dimension == 1 { "on a line" } else { "in a plane" };
    Err(Error::new(Status::Degenerate, format!("all points lie {place}; a solid is needed")))
}

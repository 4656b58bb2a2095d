//! Incremental construction: one point after the other, in a biased randomised order, or several at
//! once in different places.

use super::cells::{Cells, Parts};
use super::order::{Rounds, insertion_order};
use super::parallel::{self, Crew};
use crate::error::{Error, Result, Status};
use crate::job::Run;
use crate::predicates::around::Site;
use crate::predicates::{Sign, collinear, orient3d};

/// Triangulates distinct sites.
///
/// Errors: [`Status::TooFewPoints`] below four, [`Status::Degenerate`] for flat sets, and those
/// of the run.
pub(super) fn build<S: Site>(sites: &[S], run: &Run<'_>) -> Result<Parts> {
    let simplex = first_simplex(sites.len(), |v| *sites[v as usize].position(), run)?;
    let mut cells = Cells::new(simplex, sites.len(), run)?;
    let mut crew = Crew::new(&cells, sites, run)?;
    let rounds = Rounds::new(sites.len());
    for round in rounds.all() {
        let vertices = || rounds.vertices(round).filter(|v| !simplex.contains(v));
        let expected = rounds.expected_len(round);
        match parallel::threads(expected, run) {
            1 => crew.insert_in_turn(&mut cells, vertices())?,
            threads => crew.insert_at_once(&mut cells, vertices, expected, threads)?,
        }
    }
    Ok(cells.finish(crew.into_slots()))
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

//! Batches of queries: many points, each answered by itself.

use super::Point;
use crate::error::{ElementKind, Error, Result, Status};
use crate::job::{PART, Room, Run};
use crate::points::COORDINATE_MAX;

/// The queries of a part: some take as long as looking at all there is.
const QUERIES: usize = PART / 16;
/// The queries between two polls.
const BATCH: usize = 16;

/// The answer to each query, in their order, found by several threads.
///
/// Errors: [`Status::NonFinite`] and, beyond 2^200, [`Status::CoordinateRange`] with the least query that is so, an element of the
/// given kind; those of the job.
pub(crate) fn answers<T: Clone + Default + Send>(
    queries: &[Point],
    kind: ElementKind,
    span: [f64; 2],
    room: &mut Room<'_>,
    run: &Run<'_>,
    answer: impl Fn(Point) -> T + Sync,
) -> Result<Vec<T>> {
    try_answers(queries, kind, span, room, run, |query| Ok(answer(query)))
}

/// [`answers`] where a query may have none for an error.
pub(crate) fn try_answers<T: Clone + Default + Send>(
    queries: &[Point],
    kind: ElementKind,
    span: [f64; 2],
    room: &mut Room<'_>,
    run: &Run<'_>,
    answer: impl Fn(Point) -> Result<T> + Sync,
) -> Result<Vec<T>> {
    let mut found = room.filled(queries.len(), T::default())?;
    let parts = queries.chunks(QUERIES).zip(found.chunks_mut(QUERIES)).enumerate().collect();
    run.in_steps(parts, span, |(part, (queries, found))| {
        for (place, (&query, found)) in queries.iter().zip(found).enumerate() {
            if place % BATCH == 0 {
                run.poll()?;
            }
            let at = |error: Error| error.at(kind, (QUERIES * part + place) as u64);
            check(query).map_err(at)?;
            *found = answer(query)?;
        }
        Ok(())
    })?;
    Ok(found)
}

/// Squared distances to what is in range are numbers. However small a coordinate is, it does no harm.
fn check(query: Point) -> Result<()> {
    if query.iter().any(|x| !x.is_finite()) {
        return Err(Error::new(Status::NonFinite, "a coordinate is NaN or infinite"));
    }
    if query.iter().any(|x| x.abs() > COORDINATE_MAX) {
        return Err(Error::new(Status::CoordinateRange, "a coordinate lies beyond 2^200"));
    }
    Ok(())
}

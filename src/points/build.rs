//! From rows to distinct points in spatial order.

use super::order::{Ranked, order, split_between_ranks};
use super::{Bounds, COORDINATE_MAX, COORDINATE_MIN, POINT_LIMIT, Points, PointsOptions};
use crate::error::{ElementKind, Error, Result, Status};
use crate::index::NONE;
use crate::job::{Room, Run, Stage, parts, pieces};
use std::sync::OnceLock;

/// [`Points::by_row`], where a row that is `None` is left out unseen.
pub(super) fn build(
    total: usize,
    row: impl Fn(usize) -> Option<[f64; 3]> + Sync,
    options: PointsOptions,
    run: &Run<'_>,
) -> Result<Points> {
    run.enter(Stage::Order)?;
    if total > POINT_LIMIT {
        return Err(Error::new(
            Status::LimitExceeded,
            format!("{total} points are more than the limit of {POINT_LIMIT}"),
        ));
    }
    let mut room = Room::new(run);
    let (bounds, kept) = check(total, &row, options, &mut room, run)?;
    let kept = Kept { row: |i| without_negative_zero(row(i).unwrap_or_default()), numbers: kept };
    let count = kept.numbers.as_ref().map_or(total, Vec::len);
    let ranked = order(count, |i| kept.at(i as u32), &bounds, run)?;
    let Distinct { coords, row_of_vertex, repeated } = distinct(&kept, ranked, &mut room, run)?;
    let mut vertex_of_row = room.filled(total, NONE)?;
    for numbered in run.watch(row_of_vertex.iter().zip(0..)) {
        let (&row, vertex) = numbered?;
        vertex_of_row[row as usize] = vertex;
    }
    let mut duplicate_count = 0;
    for rows in run.watch(repeated.into_iter().flatten()) {
        let (row, first) = rows?;
        vertex_of_row[row as usize] = vertex_of_row[first as usize];
        duplicate_count += 1;
    }
    Ok(Points {
        coords,
        vertex_of_row,
        row_of_vertex,
        duplicate_of: OnceLock::new(),
        duplicate_count,
        skipped_count: total - count,
        bounds,
    })
}

/// The box of the rows that are not left out, and their numbers if any row is.
fn check(
    total: usize,
    row: &(impl Fn(usize) -> Option<[f64; 3]> + Sync),
    options: PointsOptions,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<(Bounds, Option<Vec<u32>>)> {
    let found = run.in_steps(parts(total), [0.0, 0.2], |range| {
        let (mut bounds, mut left_out) = (None, false);
        for i in range {
            match row(i).map(check_coordinates) {
                Some(Ok(xyz)) => bounds = Some(Bounds::with(bounds, xyz)),
                Some(Err(error))
                    if error.status() != Status::NonFinite || !options.skip_non_finite =>
                {
                    let advice = match error.status() {
                        Status::NonFinite => "remove the row, or ask to skip such rows",
                        _ => "rescale the points",
                    };
                    let message = format!("{}; {advice}", error.message());
                    let error = Error::new(error.status(), message);
                    return Err(error.at(ElementKind::Row, i as u64));
                }
                _ => left_out = true,
            }
        }
        Ok((bounds, left_out))
    })?;
    let corners = found.iter().filter_map(|(bounds, _)| *bounds);
    let bounds = Bounds::of(corners.flat_map(|bounds| [bounds.min, bounds.max]))
        .ok_or_else(|| Error::new(Status::TooFewPoints, "there is no point"))?;
    if found.iter().all(|(_, left_out)| !left_out) {
        return Ok((bounds, None));
    }
    let mut kept = Vec::new();
    for i in run.watch(0..total) {
        let i = i?;
        if row(i).is_some_and(|xyz| check_coordinates(xyz).is_ok()) {
            room.push(&mut kept, i as u32)?;
        }
    }
    Ok((bounds, Some(kept)))
}

/// The rows that are not left out.
struct Kept<F> {
    /// Given its number. In range, and without -0.
    row: F,
    /// The number of each, if any is left out.
    numbers: Option<Vec<u32>>,
}

impl<F: Fn(usize) -> [f64; 3]> Kept<F> {
    fn number(&self, point: u32) -> u32 {
        self.numbers.as_ref().map_or(point, |numbers| numbers[point as usize])
    }

    fn at(&self, point: u32) -> [f64; 3] {
        (self.row)(self.number(point) as usize)
    }

    /// Whether a point of a piece in order is not equal to the one before. Equal points stand together.
    fn is_new(&self, piece: &[Ranked], i: usize) -> bool {
        i == 0 || piece[i - 1].0 != piece[i].0 || self.at(piece[i - 1].1) != self.at(piece[i].1)
    }
}

/// Points in order, equal ones once.
struct Distinct {
    coords: Vec<[f64; 3]>,
    row_of_vertex: Vec<u32>,
    /// The rows that repeat an earlier one, with that one.
    repeated: Vec<Vec<(u32, u32)>>,
}

fn distinct<F: Fn(usize) -> [f64; 3] + Sync>(
    kept: &Kept<F>,
    mut ranked: Vec<Ranked>,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Distinct> {
    let ranked = split_between_ranks(&mut ranked);
    let counts = run.in_parallel(ranked.iter().collect(), |piece| {
        let mut count = 0;
        for i in run.watch(0..piece.len()) {
            count += usize::from(kept.is_new(piece, i?));
        }
        Ok(count)
    })?;
    let count = counts.iter().sum();
    let mut coords = room.filled(count, [0.0; 3])?;
    let mut row_of_vertex = room.filled(count, 0)?;
    let ends = counts.iter().scan(0, |end, count| {
        *end += count;
        Some(*end)
    });
    let results = pieces(&mut coords, ends.clone()).zip(pieces(&mut row_of_vertex, ends));
    let parts = ranked.into_iter().zip(results).collect();
    let repeated = run.in_parallel(parts, |(piece, (coords, rows))| {
        let (mut room, mut repeated) = (Room::new(run), Vec::new());
        let mut next = 0;
        for point in run.watch(piece.iter().enumerate()) {
            let (i, &(_, point)) = point?;
            if kept.is_new(piece, i) {
                (coords[next], rows[next]) = (kept.at(point), kept.number(point));
                next += 1;
            } else {
                room.push(&mut repeated, (kept.number(point), rows[next - 1]))?;
            }
        }
        Ok(repeated)
    })?;
    Ok(Distinct { coords, row_of_vertex, repeated })
}

/// The row with -0 made 0, if every coordinate is finite and in range.
pub(crate) fn check_coordinates(xyz: [f64; 3]) -> Result<[f64; 3]> {
    if !xyz.iter().all(|x| x.is_finite()) {
        return Err(Error::new(Status::NonFinite, "a coordinate is NaN or infinite"));
    }
    let in_range = |x: f64| x == 0.0 || (COORDINATE_MIN..=COORDINATE_MAX).contains(&x.abs());
    if !xyz.iter().all(|&x| in_range(x)) {
        return Err(Error::new(
            Status::CoordinateRange,
            "a coordinate other than 0 lies outside [2^-160, 2^200]",
        ));
    }
    Ok(without_negative_zero(xyz))
}

/// The same with -0 made 0: equal points must be equal in every bit.
fn without_negative_zero(xyz: [f64; 3]) -> [f64; 3] {
    xyz.map(|x| x + 0.0)
}

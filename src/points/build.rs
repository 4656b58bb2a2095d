//! From rows to distinct points in spatial order.

use super::order::{Ranked, order, split_between_ranks};
use super::{Bounds, COORDINATE_MAX, COORDINATE_MIN, POINT_LIMIT, Points, PointsOptions};
use crate::error::{ElementKind, Error, Result, Status};
use crate::index::NONE;
use crate::job::{Room, Run, Stage};
use std::sync::OnceLock;

/// [`Points::new`], where a row that is `None` is left out unseen.
pub(super) fn build(
    rows: impl ExactSizeIterator<Item = Option<[f64; 3]>>,
    options: PointsOptions,
    run: &Run<'_>,
) -> Result<Points> {
    run.enter(Stage::Order)?;
    let total = rows.len();
    if total > POINT_LIMIT {
        return Err(Error::new(
            Status::LimitExceeded,
            format!("{total} points are more than the limit of {POINT_LIMIT}"),
        ));
    }
    let mut room = Room::new(run);
    let kept = Kept::new(rows, options, &mut room, run)?;
    let Some(bounds) = Bounds::of(kept.coords.iter().copied()) else {
        return Err(Error::new(Status::TooFewPoints, "there is no point"));
    };
    let skipped_count = total - kept.coords.len();
    let ranked = order(kept.coords.len(), |i| kept.coords[i], &bounds, run)?;
    let Distinct { coords, row_of_vertex, repeated } = distinct(kept, ranked, &mut room, run)?;
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
        skipped_count,
        bounds,
    })
}

/// The rows that are not left out.
struct Kept {
    coords: Vec<[f64; 3]>,
    /// The number of each row, if any was left out.
    rows: Option<Vec<u32>>,
}

impl Kept {
    fn new(
        rows: impl ExactSizeIterator<Item = Option<[f64; 3]>>,
        options: PointsOptions,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let total = rows.len();
        let mut kept = Kept { coords: room.vec(total)?, rows: None };
        for (row, xyz) in rows.enumerate() {
            if row % 65536 == 0 {
                run.tick(row / 4, total)?;
            }
            match xyz.map(check_coordinates) {
                Some(Ok(xyz)) => {
                    kept.coords.push(xyz);
                    if let Some(rows) = &mut kept.rows {
                        rows.push(row as u32);
                    }
                    continue;
                }
                Some(Err(error))
                    if error.status() != Status::NonFinite || !options.skip_non_finite =>
                {
                    let advice = match error.status() {
                        Status::NonFinite => "remove the row, or ask to skip such rows",
                        _ => "rescale the points",
                    };
                    let message = format!("{}; {advice}", error.message());
                    let error = Error::new(error.status(), message);
                    return Err(error.at(ElementKind::Row, row as u64));
                }
                _ => {}
            }
            if kept.rows.is_none() {
                let mut rows = room.vec(total)?;
                rows.extend(0..row as u32);
                kept.rows = Some(rows);
            }
        }
        run.tick(1, 4)?;
        Ok(kept)
    }

    fn row(&self, point: u32) -> u32 {
        self.rows.as_ref().map_or(point, |rows| rows[point as usize])
    }

    /// Whether a point of a piece in order is not equal to the one before. Equal points stand together.
    fn is_new(&self, piece: &[Ranked], i: usize) -> bool {
        let at = |i: usize| self.coords[piece[i].1 as usize];
        i == 0 || piece[i - 1].0 != piece[i].0 || at(i - 1) != at(i)
    }
}

/// Points in order, equal ones once.
struct Distinct {
    coords: Vec<[f64; 3]>,
    row_of_vertex: Vec<u32>,
    /// The rows that repeat an earlier one, with that one.
    repeated: Vec<Vec<(u32, u32)>>,
}

fn distinct(
    kept: Kept,
    mut ranked: Vec<Ranked>,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Distinct> {
    let pieces = split_between_ranks(&mut ranked);
    let counts = run.in_parallel(pieces.iter().collect(), |piece| {
        let mut count = 0;
        for i in run.watch(0..piece.len()) {
            count += usize::from(kept.is_new(piece, i?));
        }
        Ok(count)
    })?;
    let count = counts.iter().sum();
    let mut coords = room.filled(count, [0.0; 3])?;
    let mut row_of_vertex = room.filled(count, 0)?;
    let (mut coords_left, mut rows_left) = (&mut coords[..], &mut row_of_vertex[..]);
    let mut parts = Vec::new();
    for (piece, count) in pieces.into_iter().zip(counts) {
        let (its_coords, others) = coords_left.split_at_mut(count);
        let (its_rows, other_rows) = rows_left.split_at_mut(count);
        parts.push((piece, its_coords, its_rows));
        (coords_left, rows_left) = (others, other_rows);
    }
    let repeated = run.in_parallel(parts, |(piece, coords, rows)| {
        let (mut room, mut repeated) = (Room::new(run), Vec::new());
        let mut next = 0;
        for point in run.watch(piece.iter().enumerate()) {
            let (i, &(_, point)) = point?;
            if kept.is_new(piece, i) {
                (coords[next], rows[next]) = (kept.coords[point as usize], kept.row(point));
                next += 1;
            } else {
                room.push(&mut repeated, (kept.row(point), rows[next - 1]))?;
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
    // -0 + 0 is 0: equal points must be equal in every bit.
    Ok(xyz.map(|x| x + 0.0))
}

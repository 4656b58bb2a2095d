//! Spatial order: the rank of a point along a Hilbert curve through the bounding box.

use super::Bounds;
use super::hilbert::{BITS, hilbert};
use crate::error::Result;
use crate::job::{PART, Room, Run, parts};
use crate::sort::{float_key, sort_by_key, sort_by_key_in_parallel};

/// Points of one grid cell from which on the sorting must be one that a job can stop.
const MANY: usize = 1 << 12;

/// A position and its row, or what stands for it.
pub(crate) type Row = ([f64; 3], u32);

/// A Hilbert rank, and the number of the point that has it.
pub(super) type Ranked = (u64, u32);

/// Sorts the points by Hilbert rank, ties by coordinates.
///
/// Ties beyond the coordinates stay in the order given. Only the coordinates' bits and the box decide, so that the order depends on the
/// set alone; equal points come to stand together, the first row first. Cost: O(n log n), divided among the job's threads.
pub(crate) fn sort(points: &mut Vec<Row>, bounds: &Bounds, run: &Run<'_>) -> Result<()> {
    let ranked = order(points.len(), |i| points[i].0, bounds, run)?;
    *points = Room::new(run).collect(ranked.iter().map(|&(_, i)| points[i as usize]))?;
    Ok(())
}

/// The numbers of so many points as [`sort`] would order them, with their ranks.
pub(super) fn order(
    count: usize,
    at: impl Fn(usize) -> [f64; 3] + Sync,
    bounds: &Bounds,
    run: &Run<'_>,
) -> Result<Vec<Ranked>> {
    let grid = Grid::new(bounds);
    let mut ranked: Vec<Ranked> = Room::new(run).filled(count, (0, 0))?;
    let parts = ranked.chunks_mut(PART).zip(parts(count)).collect();
    run.in_steps(parts, [0.25, 0.4], |(ranked, range)| {
        for (ranked, i) in ranked.iter_mut().zip(range) {
            *ranked = (grid.rank(at(i)), i as u32);
        }
        Ok(())
    })?;
    sort_by_key_in_parallel(&mut ranked, |ranked| ranked.0, run)?;
    run.in_steps(split_between_ranks(&mut ranked), [0.6, 0.75], |ranked| {
        for tied in run.watch(ranked.chunk_by_mut(|a, b| a.0 == b.0)) {
            sort_tied(tied?, &at, run)?;
        }
        Ok(())
    })?;
    Ok(ranked)
}

/// Sorts points of the same rank.
fn sort_tied(tied: &mut [Ranked], at: impl Fn(usize) -> [f64; 3], run: &Run<'_>) -> Result<()> {
    if tied.len() > MANY {
        let mut room = Room::new(run);
        let mut rows = room.collect(tied.iter().copied())?;
        for axis in [2, 1, 0] {
            sort_by_key(&mut rows, |row| float_key(at(row.1 as usize)[axis]), run)?;
        }
        tied.copy_from_slice(&rows);
    } else if tied.len() > 1 {
        tied.sort_by(|a, b| lexicographic(&at(a.1 as usize), &at(b.1 as usize)));
    }
    Ok(())
}

/// Pieces of about [`PART`] points; those of one rank are in one piece.
pub(super) fn split_between_ranks(ranked: &mut [Ranked]) -> Vec<&mut [Ranked]> {
    let mut pieces = Vec::new();
    let mut rest = ranked;
    while !rest.is_empty() {
        let least = PART.min(rest.len());
        let rank = rest[least - 1].0;
        let tied = rest[least..].iter().take_while(|ranked| ranked.0 == rank).count();
        let (piece, others) = rest.split_at_mut(least + tied);
        pieces.push(piece);
        rest = others;
    }
    pieces
}

/// The lexicographic order of coordinates, which must not be NaN.
fn lexicographic(a: &[f64; 3], b: &[f64; 3]) -> std::cmp::Ordering {
    a.iter().zip(b).map(|(x, y)| x.total_cmp(y)).fold(std::cmp::Ordering::Equal, |o, n| o.then(n))
}

/// The cubic grid of 2^[`BITS`] cells a side over a bounding box.
struct Grid {
    min: [f64; 3],
    scale: f64,
}

impl Grid {
    fn new(bounds: &Bounds) -> Self {
        let side = bounds.extent().into_iter().fold(0.0, f64::max);
        let cells = f64::from(1u32 << BITS);
        // A single point has no side: every rank is 0 then. The scale stays finite.
        let scale = if side > 0.0 { (cells / side).min(f64::MAX) } else { 0.0 };
        Grid { min: bounds.min, scale }
    }

    fn rank(&self, p: [f64; 3]) -> u64 {
        let most = f64::from((1u32 << BITS) - 1);
        let cell = |i: usize| ((p[i] - self.min[i]) * self.scale).min(most) as u32;
        hilbert([cell(0), cell(1), cell(2)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::Job;

    #[test]
    fn ties_in_one_grid_cell_go_by_coordinates_then_rows() {
        let bounds = Bounds { min: [0.0; 3], max: [1e12; 3] };
        let mut random = 1u64;
        for count in [10, 3 * MANY] {
            let mut points: Vec<Row> = (0..count as u32)
                .map(|row| {
                    random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                    ([0, 8, 16].map(|shift| f64::from((random >> (40 + shift)) as u8 % 8)), row)
                })
                .collect();
            let mut expected = points.clone();
            expected.sort_by(|a, b| lexicographic(&a.0, &b.0).then(a.1.cmp(&b.1)));
            Job::default().run(&[], |run| sort(&mut points, &bounds, run)).unwrap();
            assert_eq!(points, expected);
        }
    }
}

//! From the cells under construction to the canonical order that the set alone decides.
//!
//! This is where a build needs the most memory, and where time is waiting for memory. Everything happens in place: cells
//! move to the *partition* of their least vertex, a range of vertices whose cells the second
//! cache holds, and are sorted there. Neighbours, which are slots at first, become the places that
//! their cells have been given, and then those where sorting has brought them.

mod arrange;
mod place;
mod sort;

use super::cells::Parts;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use arrange::arrange;
use place::Places;
use sort::sort;

/// The vertices of a partition: its cells fit into the second cache.
const PARTITION: usize = if cfg!(test) { 8 } else { 1 << 11 };

/// Finite cells and their neighbours.
pub(super) type CellsAndNeighbors = (Vec<[u32; 4]>, Vec<[u32; 4]>);

/// The finite cells in canonical order with plain neighbours, [`NONE`] on the hull.
///
/// In a cell the least vertex comes first, the second least next, the others as the
/// orientation asks; cells are ordered by their vertices. Cost: O(m), besides sorting the cells of each vertex.
pub(super) fn canonical(built: Parts, run: &Run<'_>) -> Result<CellsAndNeighbors> {
    let Parts { vertices: mut cells, mut neighbors, infinite } = built;
    let mut room = Room::new(run);
    room.keep(2 * size_of_val(&cells[..]))?;
    let places = Places::new(infinite);
    let mut apart = match places.are_apart() {
        true => Some(room.filled(cells.len(), NONE)?),
        false => None,
    };
    let mut slots =
        Stretch { cells: &mut cells, neighbors: &mut neighbors, apart: apart.as_deref_mut() };
    let begins = places.assign(&mut slots, infinite, &mut room, run)?;
    places.name(slots.again(), |facet| facet >> 2, run)?;
    arrange(slots.again(), places, 0, &begins, run.threads(), run)?;
    // The middle of the stage's last quarter: see `parallel.rs`.
    run.tick(7, 8)?;
    let finite = begins[places.partitions] as usize;
    sort(slots.split_at(finite).0, places, &begins[..=places.partitions], run)?;
    cells.truncate(finite);
    neighbors.truncate(finite);
    let mut slots =
        Stretch { cells: &mut cells, neighbors: &mut neighbors, apart: apart.as_deref_mut() };
    places.name(slots.again(), |place| place, run)?;
    places.forget(&mut cells, run)?;
    cells.shrink_to_fit();
    neighbors.shrink_to_fit();
    Ok((cells, neighbors))
}

/// A stretch of slots: cells, neighbours, and the places of the cells where these are kept apart.
struct Stretch<'a> {
    cells: &'a mut [[u32; 4]],
    neighbors: &'a mut [[u32; 4]],
    apart: Option<&'a mut [u32]>,
}

impl<'a> Stretch<'a> {
    /// The same slots, to be given away for a while.
    fn again(&mut self) -> Stretch<'_> {
        Stretch { cells: self.cells, neighbors: self.neighbors, apart: self.apart.as_deref_mut() }
    }

    /// The first so many slots, and the others.
    fn split_at(self, first: usize) -> (Self, Self) {
        let (cells, other_cells) = self.cells.split_at_mut(first);
        let (neighbors, other_neighbors) = self.neighbors.split_at_mut(first);
        let (apart, other_apart) = self.apart.map(|apart| apart.split_at_mut(first)).unzip();
        let others = Stretch { cells: other_cells, neighbors: other_neighbors, apart: other_apart };
        (Stretch { cells, neighbors, apart }, others)
    }

    /// Exchanges a slot with one of another stretch.
    #[inline(always)]
    fn swap_with(&mut self, slot: usize, other: &mut Stretch<'_>, other_slot: usize) {
        std::mem::swap(&mut self.cells[slot], &mut other.cells[other_slot]);
        std::mem::swap(&mut self.neighbors[slot], &mut other.neighbors[other_slot]);
        if let (Some(apart), Some(others)) = (&mut self.apart, &mut other.apart) {
            std::mem::swap(&mut apart[slot], &mut others[other_slot]);
        }
    }

    #[inline(always)]
    fn swap(&mut self, a: usize, b: usize) {
        self.cells.swap(a, b);
        self.neighbors.swap(a, b);
        if let Some(apart) = &mut self.apart {
            apart.swap(a, b);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::job::{Job, JobOptions};
    use crate::points::Points;
    use crate::triangulation::Triangulation;
    use std::sync::Arc;

    /// Points of which many have few cells that are theirs as the least vertex, and some have many.
    fn points(count: usize) -> Arc<Points> {
        let mut state = count as u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 11) as f64
        };
        let rows: Vec<_> = (0..count)
            .map(|i| if i % 3 == 0 { [0.0, 0.0, random()] } else { [random(), random(), random()] })
            .collect();
        Arc::new(Points::new(&rows, Default::default(), &Job::default()).unwrap())
    }

    #[test]
    fn order_and_neighbours_are_right_whatever_the_threads_and_where_places_are_kept() {
        // With so many vertices places are kept in the cells, and with so many apart.
        for count in [4, 5, 40, 1000, 3000] {
            let points = points(count);
            let built = |threads| {
                let job = Job::new(JobOptions { threads, ..JobOptions::default() });
                Triangulation::delaunay(&points, &job).unwrap()
            };
            let one = built(1);
            assert!(one.validate(&Job::default()).unwrap().is_valid(), "{count}");
            for threads in [2, 3, 8] {
                let several = built(threads);
                assert_eq!(several.cells(), one.cells(), "{count} points, {threads} threads");
                assert_eq!(
                    several.neighbors(),
                    one.neighbors(),
                    "{count} points, {threads} threads"
                );
            }
        }
    }
}

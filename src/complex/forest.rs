//! Simplices in R-trees, for the nearest of them and for those in a box.

use super::Point;
use super::closest::distance_2;
use crate::error::Result;
use crate::job::Run;
use rstar::{AABB, Envelope, PointDistance, RTree, RTreeObject};

/// The most simplices in one tree: loading one takes a few milliseconds, and cannot be cancelled.
const TREE_SIZE: usize = 1 << 13;

/// A box.
pub(super) type Box3 = AABB<Point>;

/// Corners and a number.
#[derive(Clone, Copy)]
pub(super) struct Simplex<const N: usize> {
    pub(super) corners: [Point; N],
    pub(super) tag: u32,
}

impl<const N: usize> RTreeObject for Simplex<N> {
    type Envelope = Box3;

    fn envelope(&self) -> Box3 {
        AABB::from_points(&self.corners)
    }
}

impl<const N: usize> PointDistance for Simplex<N> {
    fn distance_2(&self, point: &Point) -> f64 {
        distance_2(*point, &self.corners)
    }
}

/// Simplices in boxes that hardly overlap, an R-tree in each.
pub(super) struct Forest<const N: usize> {
    trees: Vec<(Box3, RTree<Simplex<N>>)>,
}

impl<const N: usize> Forest<N> {
    /// Cost: O(n log n).
    pub(super) fn new(mut simplices: Vec<Simplex<N>>, run: &Run<'_>) -> Result<Self> {
        let mut trees = Vec::new();
        let mut waiting = vec![simplices.as_mut_slice()];
        while let Some(part) = waiting.pop() {
            run.poll()?;
            let bounds = part.iter().fold(AABB::new_empty(), |b: Box3, s| b.merged(&s.envelope()));
            if part.len() > TREE_SIZE {
                let extent = |i: usize| bounds.upper()[i] - bounds.lower()[i];
                let axis = (0..3).max_by(|&i, &j| extent(i).total_cmp(&extent(j))).unwrap_or(0);
                let key = |s: &Simplex<N>| s.corners.iter().map(|c| c[axis]).sum::<f64>();
                let middle = part.len() / 2;
                part.select_nth_unstable_by(middle, |s, t| key(s).total_cmp(&key(t)));
                let (low, high) = part.split_at_mut(middle);
                waiting.push(high);
                waiting.push(low);
            } else if !part.is_empty() {
                trees.push((bounds, RTree::bulk_load(part.to_vec())));
            }
        }
        Ok(Forest { trees })
    }

    /// The squared distance to the nearest simplex, if it is less than `bound`, else `bound`.
    pub(super) fn distance_2(&self, point: Point, bound: f64) -> f64 {
        let lower = |tree: &(Box3, _)| tree.0.distance_2(&point);
        let search = |tree: &(_, RTree<Simplex<N>>), least: f64| {
            let mut found = tree.1.nearest_neighbor_iter_with_distance_2(point);
            found.next().map_or(least, |(_, distance)| least.min(distance))
        };
        // The nearest box first: it rules out nearly all the others.
        let first = (0..self.trees.len())
            .min_by(|&i, &j| lower(&self.trees[i]).total_cmp(&lower(&self.trees[j])));
        let mut least = bound;
        for i in first.into_iter().chain((0..self.trees.len()).filter(|&i| Some(i) != first)) {
            if lower(&self.trees[i]) < least {
                least = search(&self.trees[i], least);
            }
        }
        least
    }

    /// Every simplex whose box meets the given box.
    pub(super) fn meeting(&self, bounds: Box3) -> impl Iterator<Item = &Simplex<N>> {
        let trees = self.trees.iter().filter(move |tree| tree.0.intersects(&bounds));
        trees.flat_map(move |tree| tree.1.locate_in_envelope_intersecting(bounds))
    }
}

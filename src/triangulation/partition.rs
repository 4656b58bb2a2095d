//! The division of space into boxes, one for each thread.

use crate::points::Bounds;
use std::ops::Range;

/// A box, or boxes on both sides of a plane.
pub(super) enum Partition {
    Box(u8),
    /// Points with a coordinate below `place` on the one side, all others on the other.
    Cut {
        axis: usize,
        place: f64,
        below: Box<Partition>,
        above: Box<Partition>,
    },
}

impl Partition {
    /// Divides space into boxes with about equally many of the given points, first across an axis, then each part
    /// across its longest. What lies below the first cut has `shares[0]` of the points that would be fair, and below the
    /// others `shares[1]`. Cost: O(n log n log b) for n points and b boxes.
    pub fn new(points: &mut [[f64; 3]], boxes: Range<u8>, axis: usize, shares: [f64; 2]) -> Self {
        let count = usize::from(boxes.end - boxes.start);
        if count <= 1 || points.is_empty() {
            return Partition::Box(boxes.start);
        }
        points.sort_unstable_by(|p, q| p[axis].total_cmp(&q[axis]));
        let fair = (points.len() * (count / 2)) as f64 / count as f64;
        let (below, above) = points.split_at_mut((shares[0] * fair) as usize);
        let place = above[0][axis];
        let middle = boxes.start + (count / 2) as u8;
        let part = |points: &mut [[f64; 3]], boxes| {
            let axis = axes_by_length(points.iter().copied())[0];
            Box::new(Partition::new(points, boxes, axis, [shares[1]; 2]))
        };
        let (below, above) = (part(below, boxes.start..middle), part(above, middle..boxes.end));
        Partition::Cut { axis, place, below, above }
    }

    /// The box that a point lies in.
    pub fn of(&self, point: &[f64; 3]) -> u8 {
        let mut part = self;
        loop {
            part = match part {
                Partition::Box(number) => return *number,
                Partition::Cut { axis, place, below, above } => {
                    if point[*axis] < *place {
                        below
                    } else {
                        above
                    }
                }
            }
        }
    }
}

/// The axes by the extent of the points along them, the longest first.
pub(super) fn axes_by_length(points: impl Iterator<Item = [f64; 3]>) -> [usize; 3] {
    let mut axes = [0, 1, 2];
    if let Some(bounds) = Bounds::of(points) {
        let extent = bounds.extent();
        axes.sort_by(|&a, &b| extent[b].total_cmp(&extent[a]));
    }
    axes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_have_equally_many_points() {
        let points: Vec<[f64; 3]> = (0..4096u32)
            .map(|i| [f64::from(i % 64), f64::from(i / 64 % 16), f64::from(i / 1024)])
            .collect();
        for boxes in [1, 2, 3, 8, 200] {
            let partition = Partition::new(&mut points.clone(), 0..boxes, 1, [1.0; 2]);
            let mut counts = vec![0; usize::from(boxes)];
            points.iter().for_each(|p| counts[usize::from(partition.of(p))] += 1);
            let fair = points.len() / usize::from(boxes);
            // On a lattice cuts come between layers.
            assert!(counts.iter().all(|&count| count <= 2 * fair + 64), "{boxes}: {counts:?}");
            let Partition::Cut { axis, .. } = partition else { continue };
            assert_eq!(axis, 1);
        }
    }
}

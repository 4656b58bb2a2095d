//! Pairwise scales: how much balls must grow until another one covers them.

use crate::complex::{Hierarchy, Simplex};
use crate::dual::Dual;
use crate::error::Result;
use crate::job::{PART, Room, Run};
use crate::labels::Labels;
use crate::points::Bounds;
use crate::vector::{length, sub};

/// For each cell the pairwise scale of its ball: the least |c - c'| / (r' - r) over the balls of the same label that are larger; infinity if
/// none is. Cells that share a sphere have one ball, and the label of the least of them.
pub(super) fn scales(
    dual: &Dual,
    least_cell: &[u32],
    labels: Option<&Labels>,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<f64>> {
    let mut scales = room.filled(least_cell.len(), f64::INFINITY)?;
    for side in [true, false] {
        let is_here = |cell: usize| {
            let of_side = labels.map_or(side, |labels| labels.is_inner()[cell] == side);
            // A ball that is too large for numbers covers nothing, and nothing covers it.
            least_cell[cell] as usize == cell && of_side && dual.radii_squared()[cell] < f64::MAX
        };
        let mut balls = Vec::new();
        for cell in run.watch(0..least_cell.len()) {
            let cell = cell?;
            if is_here(cell) {
                let corners = [dual.centers()[cell]];
                room.push(&mut balls, Simplex { corners, tag: cell as u32 })?;
            }
        }
        let index = Index::new(dual, &balls, room, run)?;
        let found = run.in_parallel(balls.chunks(PART / 64).collect(), |balls| {
            let scale = |ball: &Simplex<1>| {
                run.poll()?;
                Ok((ball.tag, index.scale(ball.tag)))
            };
            balls.iter().map(scale).collect::<Result<Vec<_>>>()
        })?;
        for found in run.watch(found.iter().flatten()) {
            let &(cell, scale) = found?;
            scales[cell as usize] = scale;
        }
    }
    for cell in run.watch(0..least_cell.len()) {
        let cell = cell?;
        scales[cell] = scales[least_cell[cell] as usize];
    }
    Ok(scales)
}

/// Balls in a hierarchy of their centres, with the largest radius under each node.
struct Index<'a> {
    dual: &'a Dual,
    hierarchy: Hierarchy<1>,
    largest: Vec<f64>,
}

impl<'a> Index<'a> {
    fn new(
        dual: &'a Dual,
        balls: &[Simplex<1>],
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let hierarchy = Hierarchy::new(balls, room, run)?;
        let mut largest = room.filled(hierarchy.node_count(), 0.0)?;
        // Children come after their parent.
        for node in run.watch((0..hierarchy.node_count()).rev()) {
            let node = node?;
            largest[node] = match hierarchy.halves(node) {
                Some([first, second]) => f64::max(largest[first], largest[second]),
                None => hierarchy
                    .simplices(node)
                    .iter()
                    .map(|ball| dual.radii_squared()[ball.tag as usize].sqrt())
                    .fold(0.0, f64::max),
            };
        }
        Ok(Index { dual, hierarchy, largest })
    }

    /// The least scale at which another ball covers that of a cell.
    fn scale(&self, cell: u32) -> f64 {
        let center = self.dual.centers()[cell as usize];
        let radius = self.dual.radii_squared()[cell as usize].sqrt();
        let scale = |distance: f64, other: f64| match other > radius {
            true => distance / (other - radius),
            false => f64::INFINITY,
        };
        let bound =
            |node: usize| scale(to_box(self.hierarchy.bounds(node), center), self.largest[node]);
        let mut least = f64::INFINITY;
        let mut waiting = Vec::new();
        if self.hierarchy.node_count() > 0 {
            waiting.push((bound(0), 0));
        }
        while let Some((lower, node)) = waiting.pop() {
            if lower >= least {
                continue;
            }
            match self.hierarchy.halves(node) {
                Some(halves) => {
                    let [mut near, mut far] = halves.map(|half| (bound(half), half));
                    if far.0 < near.0 {
                        (near, far) = (far, near);
                    }
                    waiting.extend([far, near]);
                }
                None => {
                    for ball in self.hierarchy.simplices(node) {
                        let other = self.dual.radii_squared()[ball.tag as usize].sqrt();
                        least = least.min(scale(length(sub(center, ball.corners[0])), other));
                    }
                }
            }
        }
        least
    }
}

/// The distance of a point from a box.
fn to_box(bounds: &Bounds, point: [f64; 3]) -> f64 {
    length([0, 1, 2].map(|k| (bounds.min[k] - point[k]).max(point[k] - bounds.max[k]).max(0.0)))
}

//! How far the surface has come from what it was, measured at points.

use super::super::closest::distance_2;
use super::super::hierarchy::{Hierarchy, Simplex};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::vector::{Vec3, add, scale};

/// The surface as it was, and points of it that each stay with the triangle near them.
///
/// Invariant: every point is in the list of one triangle that is not gone, and no further from it than the limit.
pub(super) struct Deviation {
    limit_2: f64,
    before: Hierarchy<3>,
    points: Vec<Vec3>,
    head: Vec<u32>,
    next: Vec<u32>,
    /// The points of the star under examination, and the triangle that each one goes to.
    moved: Vec<(u32, u32)>,
}

impl Deviation {
    /// Takes the vertices and the centres of the triangles as points. Cost: O(n log n).
    pub(super) fn new(
        triangles: &[[u32; 3]],
        at: &[Vec3],
        limit: f64,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let corners = |t: &[u32; 3]| t.map(|v| at[v as usize]);
        let simplex = |t: &[u32; 3]| Simplex { corners: corners(t), tag: 0 };
        let simplices = Room::new(run).collect(triangles.iter().map(simplex))?;
        let mut found = Deviation {
            limit_2: limit * limit,
            before: Hierarchy::new(&simplices, room, run)?,
            points: Vec::new(),
            head: room.filled(triangles.len(), NONE)?,
            next: Vec::new(),
            moved: Vec::new(),
        };
        let mut seen = Room::new(run).filled(at.len(), false)?;
        for triangle in run.watch(triangles.iter().zip(0..)) {
            let (triangle, t) = triangle?;
            found.put(centre(corners(triangle)), t, room)?;
            for &v in triangle {
                if !std::mem::replace(&mut seen[v as usize], true) {
                    found.put(at[v as usize], t, room)?;
                }
            }
        }
        Ok(found)
    }

    fn put(&mut self, p: Vec3, t: u32, room: &mut Room<'_>) -> Result<()> {
        let number = self.points.len() as u32;
        room.push(&mut self.points, p)?;
        room.push(&mut self.next, self.head[t as usize])?;
        self.head[t as usize] = number;
        Ok(())
    }

    /// Whether the triangles `after` may come in place of the triangles `old`: each point stays near one of them,
    /// and their common corner `to`, their centres and the middles of the sides that end there are near the surface as
    /// it was. If so, points move.
    pub(super) fn allows(
        &mut self,
        old: impl Iterator<Item = u32> + Clone,
        after: &[(u32, [Vec3; 3])],
        to: Vec3,
        run: &Run<'_>,
    ) -> Result<bool> {
        // Nothing beyond the limit need be looked at; what has not moved was looked at before.
        let beyond = 1.01 * self.limit_2;
        let near = |p: Vec3| self.before.distance_2(p, beyond) <= self.limit_2;
        if !near(to) {
            return Ok(false);
        }
        for (_, corners) in after {
            let sides = corners.iter().filter(|&&q| q != to).map(|&q| scale(add(q, to), 0.5));
            if !near(centre(*corners)) || !sides.into_iter().all(near) {
                return Ok(false);
            }
        }
        self.moved.clear();
        for t in old.clone() {
            let mut point = self.head[t as usize];
            while point != NONE {
                if self.moved.len().is_multiple_of(1 << 10) {
                    run.poll()?;
                }
                let p = self.points[point as usize];
                let mut nearest = (f64::INFINITY, NONE);
                for (t, corners) in after {
                    let distance = distance_2(p, corners);
                    if distance < nearest.0 {
                        nearest = (distance, *t);
                    }
                }
                if nearest.0 > self.limit_2 || nearest.1 == NONE {
                    return Ok(false);
                }
                self.moved.push((point, nearest.1));
                point = self.next[point as usize];
            }
        }
        for t in old {
            self.head[t as usize] = NONE;
        }
        for &(point, t) in &self.moved {
            self.next[point as usize] = self.head[t as usize];
            self.head[t as usize] = point;
        }
        Ok(true)
    }
}

fn centre([a, b, c]: [Vec3; 3]) -> Vec3 {
    scale(add(add(a, b), c), 1.0 / 3.0)
}

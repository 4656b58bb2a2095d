//! Moves of one inner vertex, or of several to one place, that leave less of what is turned.

use super::{Corner, Mended, Part, tidy};
use crate::error::Result;
use crate::job::{Room, Run};
use crate::vector::{Vec3, add, cross, dot, length, scale, sub};

/// How often a place is moved to the other side of a plane.
const MOVES: usize = 40;
/// How many vertices are gathered at most.
const GATHERED: usize = 30;
/// Inner vertices nearer to each other than this share of the box's diagonal may be turned by how their coordinates are rounded.
const NEAR: f64 = 1e-12;

/// How vertices are moved.
#[derive(Clone, Copy)]
pub(super) struct Way {
    /// The largest share of what is turned that a move may leave.
    pub leave: f64,
    /// How far beyond a plane a place is moved, as a share of how far it was on the wrong side: so it comes to where it may be in finitely many moves (Motzkin, Schoenberg 1954, *The relaxation method
    /// for linear inequalities*).
    pub beyond: f64,
}

/// A plane that a corner of a tetrahedron must lie behind: its normal out of it, of length 1, how far it is from the origin along that, and twice the area of the other three corners.
struct Plane {
    normal: Vec3,
    distance: f64,
    size: f64,
}

impl Plane {
    /// How far before it a place is.
    fn before(&self, p: Vec3) -> f64 {
        dot(self.normal, p) - self.distance
    }
}

impl Mended<'_> {
    /// Moves a vertex to where nothing that has it is turned, or, if no such place is found, at most a share of what was. Whether it was moved.
    pub(super) fn improve(&mut self, vertex: u32, way: Way) -> bool {
        if self.planes_left == 0 {
            return false;
        }
        let v = vertex as usize;
        let (place, was_moved) = (self.places[v], self.is_moved[v]);
        let at = self.parts_at(vertex);
        let most = way.leave * self.turned_volume(&at, &[vertex]);
        self.is_moved[v] = true;
        let (planes, _) = self.planes(&at, &[vertex]);
        self.is_moved[v] = was_moved;
        self.planes_left = self.planes_left.saturating_sub(planes.len());
        match better(place, &planes, most, way).map(tidy) {
            Some(found) if found != place => {
                self.put(vertex, found);
                true
            }
            _ => false,
        }
    }

    /// Moves some vertices to one place, with the middles between them, where less is turned, and so many others as that takes. Tetrahedra with two corners there have no volume. Returns what was moved.
    pub(super) fn gather(&mut self, mut group: Vec<u32>, way: Way) -> Vec<u32> {
        while group.len() <= GATHERED && self.planes_left > 0 {
            let mut at: Vec<Part> = group.iter().flat_map(|&v| self.parts_at(v)).collect();
            at.sort_unstable();
            for pair in at.windows(2).filter(|pair| pair[0] == pair[1]) {
                if let Part::Facet(facet) = pair[0] {
                    group.push(self.middle_of(facet));
                }
            }
            at.dedup();
            group.sort_unstable();
            group.dedup();
            let most = way.leave * self.turned_volume(&at, &group);
            let was: Vec<bool> = group.iter().map(|&v| self.is_moved[v as usize]).collect();
            group.iter().for_each(|&v| self.is_moved[v as usize] = true);
            let (planes, corners) = self.planes(&at, &group);
            group.iter().zip(was).for_each(|(&v, was)| self.is_moved[v as usize] = was);
            self.planes_left = self.planes_left.saturating_sub(planes.len());
            let cells = group.partition_point(|&v| (v as usize) < self.parts.cells.len());
            let sum = group[..cells].iter().fold([0.0; 3], |sum, &v| add(sum, self.place(v)));
            if cells == 0 {
                break;
            }
            let start = scale(sum, 1.0 / cells as f64);
            if let Some(place) = better(start, &planes, most, way).map(tidy) {
                group.iter().for_each(|&v| self.put(v, place));
                self.gathered.extend(&group);
                return group;
            }
            let wrong = planes.iter().zip(corners).filter(|(plane, _)| plane.before(start) >= 0.0);
            let mut more: Vec<u32> = wrong.flat_map(|(_, corners)| inner(corners)).collect();
            more.retain(|v| !group.contains(v));
            if more.is_empty() {
                break;
            }
            group.extend(more);
            group.sort_unstable();
            group.dedup();
        }
        Vec::new()
    }

    /// Puts inner vertices together that lie so near to each other that rounding has turned something.
    pub(super) fn join_near(
        &mut self,
        folded: &[Part],
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<()> {
        let bounds = self.dual.triangulation().points().bounds();
        let near = NEAR * length(sub(bounds.max, bounds.min));
        let mut is_joined = room.filled(self.parts.cells.len(), false)?;
        for &part in folded {
            run.poll()?;
            let mut seeds = Vec::new();
            self.tetrahedra(part, &mut |corners| {
                if let [_, _, Corner::Inner(c), Corner::Inner(d)] = corners
                    && length(sub(self.place(c), self.place(d))) <= near
                    && self.is_turned(corners)
                {
                    seeds.push(c);
                }
            });
            for seed in seeds {
                let place = self.place(seed);
                let mut waiting = vec![seed];
                while let Some(cell) = waiting.pop() {
                    self.put(cell, place);
                    for part in self.parts_at(cell) {
                        for next in self.cells_of(part) {
                            let is_near = length(sub(self.place(next), place)) <= near;
                            if is_near && !is_joined[next as usize] {
                                is_joined[next as usize] = true;
                                waiting.push(next);
                            }
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// Six times the volume of all that is turned and has one of some vertices.
    fn turned_volume(&self, at: &[Part], vertices: &[u32]) -> f64 {
        let mut sum = 0.0;
        for &part in at {
            self.tetrahedra(part, &mut |corners| {
                if inner(corners).any(|v| vertices.contains(&v)) {
                    let [a, b, c, d] = corners.map(|corner| self.at(corner));
                    sum += (-dot(cross(sub(b, a), sub(c, a)), sub(d, a))).max(0.0);
                }
            });
        }
        sum
    }

    /// The planes that one place for some vertices must lie behind, and whose they are.
    fn planes(&self, at: &[Part], vertices: &[u32]) -> (Vec<Plane>, Vec<[Corner; 4]>) {
        let (mut planes, mut whose) = (Vec::new(), Vec::new());
        for &part in at {
            self.tetrahedra(part, &mut |corners| {
                let is_one = |corner| matches!(corner, Corner::Inner(v) if vertices.contains(&v));
                let mut own = (0..4).filter(|&i| is_one(corners[i]));
                if let (Some(own), None) = (own.next(), own.next())
                    && let Some(plane) = self.plane(corners, own)
                {
                    planes.push(plane);
                    whose.push(corners);
                }
            });
        }
        (planes, whose)
    }

    /// The plane that a corner of a tetrahedron must lie behind, if the others make one.
    fn plane(&self, corners: [Corner; 4], own: usize) -> Option<Plane> {
        // The others, so that they turn counterclockwise seen from the side where the corner is not.
        let [p, q, r] =
            [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]][own].map(|i| self.at(corners[i]));
        let normal = cross(sub(q, p), sub(r, p));
        let size = length(normal);
        (size > 0.0).then(|| {
            let normal = scale(normal, 1.0 / size);
            Plane { normal, distance: dot(normal, p), size }
        })
    }
}

fn inner(corners: [Corner; 4]) -> impl Iterator<Item = u32> {
    corners.into_iter().filter_map(|corner| match corner {
        Corner::Inner(v) => Some(v),
        Corner::Sample(_) => None,
    })
}

/// A place behind all planes, near to a given one, or else the best that is found on the way there: what is turned has less volume, six times, than given.
fn better(mut p: Vec3, planes: &[Plane], mut most: f64, way: Way) -> Option<Vec3> {
    let mut best = None;
    for _ in 0..MOVES {
        let (mut worst, mut beyond, mut sum) = (None, 0.0, 0.0);
        for plane in planes {
            let before = plane.before(p);
            if before >= 0.0 {
                sum += before * plane.size;
            }
            if before >= beyond {
                (worst, beyond) = (Some(plane), before);
            }
        }
        let Some(worst) = worst else { return Some(p) };
        if sum < most {
            (best, most) = (Some(p), sum);
        }
        // Not on the plane, whatever rounding does.
        let size = p.iter().fold(worst.distance.abs(), |size, x| size.max(x.abs()));
        p = sub(p, scale(worst.normal, beyond * (1.0 + way.beyond) + 1e-14 * size));
    }
    best
}

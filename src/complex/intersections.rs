//! Pairs of triangles that have more in common than the vertices and edges that they share.

use super::hierarchy::{Hierarchy, Simplex};
use super::{Complex, Point};
use crate::error::{ElementKind, Result};
use crate::job::{Job, Room, Run, Stage, parts};
use crate::points::check_coordinates;
use crate::predicates::{Sign, collinear, coplanar_orientation, orient3d};
use crate::sort::sort_by_key;

impl Complex {
    /// The pairs of triangles that intersect: numbers of [`Complex::triangles`], the less one first, ascending.
    ///
    /// Two triangles intersect if they have a point in common that is on no vertex and no edge that they share, and
    /// they share what has the same vertex numbers. So triangles with a common edge intersect where they are folded
    /// onto each other; those with a common vertex where they meet anywhere else; others where they touch at all, be
    /// it in vertices that lie at the same place. A triangle that is listed twice intersects itself.
    ///
    /// A triangle without area is the segment or the point that its corners span, and what holds for triangles
    /// holds for it. The triangles of one face are compared as well: those of a face that is not convex, or not
    /// flat, may intersect.
    ///
    /// The answer is exact. Errors: [`Status::CoordinateRange`](crate::Status::CoordinateRange) with the vertex
    /// where a corner's coordinate is beyond the range of the predicates,
    /// [`Status::OutOfMemory`](crate::Status::OutOfMemory) where the pairs are too many, those of the job.
    /// Cost: O(n log n + b) with b pairs of triangles whose boxes meet.
    pub fn self_intersections(&self, job: &Job) -> Result<Vec<[u32; 2]>> {
        job.run(&[(Stage::Query, 1.0)], |run| self.self_intersections_in(run))
    }

    /// [`Complex::self_intersections`] as a stage of a larger operation.
    pub(crate) fn self_intersections_in(&self, run: &Run<'_>) -> Result<Vec<[u32; 2]>> {
        run.enter(Stage::Query)?;
        let mut room = Room::new(run);
        let hierarchy = self.boxes(&mut room, run)?;
        let found = run.in_steps(parts(hierarchy.node_count()), [0.3, 0.95], |nodes| {
            // The room goes along, so that the pairs stay counted.
            let (mut pairs, mut room) = (Vec::new(), Room::new(run));
            hierarchy.pairs(nodes, run, |s, t| {
                let ids = [s, t].map(|simplex| self.triangles[simplex.tag as usize]);
                match intersect(ids, [&s.corners, &t.corners]) {
                    true => room.push(&mut pairs, [s.tag.min(t.tag), s.tag.max(t.tag)]),
                    false => Ok(()),
                }
            })?;
            Ok((pairs, room))
        })?;
        let mut all = room.vec(found.iter().map(|(pairs, _)| pairs.len()).sum())?;
        for (pairs, _) in &found {
            run.poll()?;
            all.extend_from_slice(pairs);
        }
        drop(found);
        sort_by_key(&mut all, |&[s, t]| u64::from(s) << 32 | u64::from(t), run)?;
        Ok(all)
    }

    /// The triangles, tagged with their numbers, in a hierarchy of boxes.
    fn boxes(&self, room: &mut Room<'_>, run: &Run<'_>) -> Result<Hierarchy<3>> {
        let mut simplices = Vec::new();
        let mut own = Room::new(run);
        own.reserve(&mut simplices, self.triangles.len())?;
        for triangle in run.watch(self.triangles.iter().enumerate()) {
            let (tag, triangle) = triangle?;
            for &v in triangle {
                let checked = check_coordinates(self.vertices[v as usize]);
                checked.map_err(|error| error.at(ElementKind::Vertex, u64::from(v)))?;
            }
            let corners = triangle.map(|v| self.vertices[v as usize]);
            simplices.push(Simplex { corners, tag: tag as u32 });
        }
        run.tick(10, 100)?;
        Hierarchy::new(&simplices, room, run)
    }
}

/// Whether two triangles have a point in common that is on no vertex and no edge that they share, given
/// their vertices and where these lie.
fn intersect(ids: [[u32; 3]; 2], [s, t]: [&[Point; 3]; 2]) -> bool {
    // Where each shared vertex stands in the one and in the other. A vertex that a triangle has twice counts once.
    let mut places = [[0; 2]; 3];
    let mut count = 0;
    for i in 0..3 {
        let place = ids[1].iter().position(|&v| v == ids[0][i]);
        if let (Some(j), false) = (place, ids[0][..i].contains(&ids[0][i])) {
            places[count] = [i, j];
            count += 1;
        }
    }
    match places[..count] {
        [] => touch(s, t),
        [[i, j]] => leaves_through(s, i, t) || leaves_through(t, j, s),
        [[i, j], [k, l]] => folded([&s[i], &s[k]], [&s[3 - i - k], &t[3 - j - l]]),
        // The same triangle: its inside is on no edge.
        _ => !collinear(&s[0], &s[1], &s[2]),
    }
}

/// The sides of a triangle.
fn sides([a, b, c]: &[Point; 3]) -> [[&Point; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// On which side of a triangle's plane a point is; zero for any point where the triangle has no area.
fn side_of([a, b, c]: &[Point; 3], p: &Point) -> Sign {
    orient3d(a, b, c, p)
}

/// Whether two triangles have any point in common.
///
/// If so, then a side of one meets the other: the sides that bound a common segment or polygon do, and a triangle without
/// area is made of its sides.
fn touch(s: &[Point; 3], t: &[Point; 3]) -> bool {
    let apart = |s: &[Point; 3], t: &[Point; 3]| {
        let side = side_of(s, &t[0]);
        !side.is_zero() && t[1..].iter().all(|p| side_of(s, p) == side)
    };
    if apart(s, t) || apart(t, s) {
        return false;
    }
    sides(s).iter().any(|&side| meets(side, t)) || sides(t).iter().any(|&side| meets(side, s))
}

/// Whether what bounds a triangle, seen from its corner `i`, meets another triangle that has this corner.
///
/// What two triangles have in common is convex. If it is more than their common corner, follow a ray from there through another
/// common point: the last one is where the ray leaves one of the triangles. That is on the side opposite
/// the corner, or, where the triangle has no area, at one of its other ends.
fn leaves_through(s: &[Point; 3], i: usize, t: &[Point; 3]) -> bool {
    let [v, p, q] = [&s[i], &s[(i + 1) % 3], &s[(i + 2) % 3]];
    let side = side_of(t, p);
    if !side.is_zero() && side == side_of(t, q) {
        return false;
    }
    match collinear(v, p, q) {
        true => [p, q].into_iter().any(|end| end != v && meets([end, end], t)),
        false => meets([p, q], t),
    }
}

/// Whether the triangles `a b c` and `a b d` have more in common than the segment `a b`.
fn folded([a, b]: [&Point; 2], [c, d]: [&Point; 2]) -> bool {
    if !orient3d(a, b, c, d).is_zero() {
        return false;
    }
    let turns = [c, d].map(|p| coplanar_orientation(a, b, p));
    if turns != [Sign::Zero; 2] {
        // Two triangles in a plane, on one side of the edge or on both; or one of them is on the edge's line.
        return turns[0] == turns[1];
    }
    // Segments with a common part `a b`, which may be a point.
    let is_on = |p, ends| segments_meet([p, p], ends);
    let beyond = |p, q| is_on(p, [a, q]) || is_on(p, [b, q]);
    !is_on(c, [a, b]) && !is_on(d, [a, b]) && (beyond(c, d) || beyond(d, c))
}

/// Whether a segment, which may be a point, meets a triangle, which may have no area.
fn meets([p, q]: [&Point; 2], t: &[Point; 3]) -> bool {
    let ends = [p, q].map(|end| side_of(t, end));
    if ends != [Sign::Zero; 2] {
        // One point of the segment is in the plane, unless both ends are on one side. It is in the triangle where the
        // segment's line passes no side on the left while it passes another on the right.
        if ends[0] == ends[1] {
            return false;
        }
        let passes = sides(t).map(|[a, b]| orient3d(p, q, a, b));
        return !(passes.contains(&Sign::Positive) && passes.contains(&Sign::Negative));
    }
    if sides(t).iter().any(|&side| segments_meet([p, q], side)) {
        return true;
    }
    // All is in one plane, or the triangle is but its sides.
    let turn = coplanar_orientation(&t[0], &t[1], &t[2]);
    !turn.is_zero() && sides(t).iter().all(|[a, b]| coplanar_orientation(a, b, p) == turn)
}

/// Whether two segments, each of which may be a point, have a point in common.
fn segments_meet([p, q]: [&Point; 2], [r, s]: [&Point; 2]) -> bool {
    if !orient3d(p, q, r, s).is_zero() {
        return false;
    }
    let turn = coplanar_orientation;
    let turns = [turn(p, q, r), turn(p, q, s), turn(r, s, p), turn(r, s, q)];
    if turns == [Sign::Zero; 4] {
        // On a line: then the segments are where their boxes are.
        return (0..3)
            .all(|i| p[i].min(q[i]) <= r[i].max(s[i]) && r[i].min(s[i]) <= p[i].max(q[i]));
    }
    !(turns[0] * turns[1]).is_positive() && !(turns[2] * turns[3]).is_positive()
}

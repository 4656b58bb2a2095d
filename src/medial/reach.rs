//! How near and how far a Voronoi facet comes to the middle of its dual edge.

use crate::dual::{Dual, Facets, unit};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{PART, Room, Run};
use crate::predicates::edge_conflict;
use crate::vector::{Vec3, add, dot, length, scale, sub};

/// For each Voronoi facet the least and the largest distance of its points from the middle of its dual edge; infinite where it is
/// unbounded. The object angle at a point of the facet, the angle between the directions to the edge's ends, falls with that
/// distance: it is twice the arc tangent of half the edge's length by the distance.
pub(super) fn reaches(
    dual: &Dual,
    facets: &Facets,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<[f64; 2]>> {
    let mut reaches = room.filled(facets.len(), [0.0; 2])?;
    let chunks = reaches.chunks_mut(PART / 4).zip(0..).collect();
    run.in_steps(chunks, [0.0, 0.5], |(reaches, chunk): (&mut [[f64; 2]], usize)| {
        run.poll()?;
        let mut seen = 0;
        for (i, reach) in reaches.iter_mut().enumerate() {
            let facet = chunk * (PART / 4) + i;
            seen += facets.ring(facet).len();
            if seen > 1 << 14 {
                seen = 0;
                run.poll()?;
            }
            *reach = of_facet(dual, facets, facet);
        }
        Ok(())
    })?;
    Ok(reaches)
}

fn of_facet(dual: &Dual, facets: &Facets, facet: usize) -> [f64; 2] {
    let coords = dual.triangulation().coords();
    let [p, q] = facets.edges()[facet].map(|v| coords[v as usize]);
    let middle = scale(add(p, q), 0.5);
    let ring = facets.ring(facet);
    let at = |cell: u32| sub(dual.centers()[cell as usize], middle);
    let is_unbounded = facets.is_unbounded(facet);
    let farthest = match is_unbounded {
        true => f64::INFINITY,
        false => ring.iter().fold(0.0, |most: f64, &cell| most.max(norm(at(cell)))),
    };
    if has_middle(dual, facets, facet) {
        return [0.0, farthest];
    }
    // The nearest point is on a side.
    let mut nearest = f64::INFINITY;
    let sides = if is_unbounded { ring.len() - 1 } else { ring.len() };
    for i in 0..sides {
        nearest = nearest.min(to_side([ring[i], ring[(i + 1) % ring.len()]].map(at)));
    }
    if is_unbounded {
        let ends = [ring[0], ring[ring.len() - 1]].map(at);
        for (end, ray) in ends.into_iter().zip(facets.rays()[facet]) {
            nearest =
                nearest.min(to_points(end, dual.rays().directions()[ray as usize], f64::INFINITY));
        }
    }
    [nearest, farthest]
}

/// Whether a facet has the middle of its dual edge, in exact arithmetic: no sample that shares a triangle with the edge lies inside the smallest
/// sphere through its ends. Where such spheres are the same, centres tell nothing; ties are broken as those of the triangulation are.
fn has_middle(dual: &Dual, facets: &Facets, facet: usize) -> bool {
    let t = dual.triangulation();
    let at = |v: u32| &t.coords()[v as usize];
    let ends = facets.edges()[facet];
    let [p, q] = ends.map(at);
    // Successive cells share a triangle.
    let mut before = [NONE; 4];
    for &cell in facets.ring(facet) {
        let corners = t.cells()[cell as usize];
        let new = corners.iter().filter(|v| !ends.contains(v) && !before.contains(v));
        if new.copied().any(|v| edge_conflict(p, q, at(v))) {
            return false;
        }
        before = corners;
    }
    true
}

/// The distance of the origin from a side, given its ends.
fn to_side([a, b]: [Vec3; 2]) -> f64 {
    // From the nearer end on: the other one may be so far away that nothing is left of what is near.
    let (near, far) = if norm(a) <= norm(b) { (a, b) } else { (b, a) };
    // Half of it does not overflow.
    let along = sub(scale(far, 0.5), scale(near, 0.5));
    // A side may be a point.
    if along == [0.0; 3] { norm(near) } else { to_points(near, unit(along), 2.0 * norm(along)) }
}

/// The distance of the origin from the points `from + t along`, for t from 0 to `most` and a unit vector.
fn to_points(from: Vec3, along: Vec3, most: f64) -> f64 {
    let t = (-dot(from, along)).min(most);
    let end = norm(from);
    if t > 0.0 { end.min(norm(add(from, scale(along, t)))) } else { end }
}

/// The length of a vector whose squares may overflow.
pub(super) fn norm(a: Vec3) -> f64 {
    let largest = a.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    match largest < OVERFLOWS {
        true => length(a),
        false => (largest * length(a.map(|x| x / largest))).min(f64::MAX),
    }
}

/// 2^500: squares of less do not overflow.
const OVERFLOWS: f64 = f64::from_bits((1023 + 500) << 52);

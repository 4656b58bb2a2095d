//! How near and how far a Voronoi facet comes to the middle of its dual edge.

use crate::dual::{Dual, Facets};
use crate::error::Result;
use crate::job::{PART, Room, Run};
use crate::vector::{add, cross, dot, length, scale, sub};

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
    let normal = sub(q, p);
    let ring = facets.ring(facet);
    let at = |cell: u32| sub(dual.centers()[cell as usize], middle);
    let corners = ring.iter().map(|&cell| at(cell));
    let farthest = corners.fold(0.0, |most: f64, x| most.max(length(x)));
    // The middle is in the facet unless it lies to the right of a side; the nearest point of all is on a side then.
    let (mut nearest, mut is_within) = (f64::INFINITY, true);
    let mut see = |(distance, is_left): (f64, bool)| {
        nearest = nearest.min(distance);
        is_within &= is_left;
    };
    let is_unbounded = facets.is_unbounded(facet);
    let sides = if is_unbounded { ring.len() - 1 } else { ring.len() };
    for i in 0..sides {
        let [from, to] = [ring[i], ring[(i + 1) % ring.len()]].map(at);
        see(side(from, sub(to, from), 1.0, normal));
    }
    if is_unbounded {
        let [first, last] = [ring[0], ring[ring.len() - 1]].map(at);
        let [back, on] = facets.rays()[facet].map(|ray| dual.rays().directions()[ray as usize]);
        see(side(last, on, f64::INFINITY, normal));
        // The first side comes in from infinity: seen from its end it runs the other way.
        see(side(first, back, f64::INFINITY, scale(normal, -1.0)));
    }
    let farthest = if is_unbounded { f64::INFINITY } else { farthest };
    [if is_within { 0.0 } else { nearest }, farthest]
}

/// The distance from the origin of the points `from + t along`, for t from 0 to `most`, and whether the origin lies to the left
/// of them, seen against the normal.
fn side(from: [f64; 3], along: [f64; 3], most: f64, normal: [f64; 3]) -> (f64, bool) {
    let square = dot(along, along);
    // A side may be a point.
    let share = if square > 0.0 { (-dot(from, along) / square).clamp(0.0, most) } else { 0.0 };
    let distance = length(add(from, scale(along, share)));
    (distance, dot(cross(from, along), normal) >= 0.0)
}

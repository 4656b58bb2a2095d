//! The angle condition and the ratio condition, at both ends of every Delaunay edge.

use super::umbrella::Umbrellas;
use crate::dual::Facets;
use crate::error::Result;
use crate::job::{PART, Room, Run, parts};
use crate::triangulation::Triangulation;
use crate::vector::{Vec3, cross, dot, length, scale, sub};

/// What the conditions ask of each Voronoi facet, by the two ends of its dual edge.
///
/// Invariant: an end whose umbrella has the edge, or has no triangle, is no candidate (Dey, Zhao 2004, step 5 of MEDIAL); it has
/// minus infinity for both.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Conditions {
    /// The sine of the least angle between the edge and the planes of the end's umbrella triangles: the angle condition asks
    /// that it exceed that of theta (section 3.1, where angles to the normals are at most pi/2 - theta).
    pub sines: Vec<[f64; 2]>,
    /// The length of the edge by the largest circumradius of the end's umbrella triangles: the ratio condition asks that it
    /// exceed rho (section 3.2).
    pub ratios: Vec<[f64; 2]>,
}

impl Conditions {
    pub fn new(
        t: &Triangulation,
        facets: &Facets,
        umbrellas: &Umbrellas,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let (normals, radii) = planes(t, umbrellas, room, run)?;
        let none = [f64::NEG_INFINITY; 2];
        let mut sines = room.filled(facets.len(), none)?;
        let mut ratios = room.filled(facets.len(), none)?;
        let results = sines.chunks_mut(PART).zip(ratios.chunks_mut(PART));
        let chunks = results.zip(facets.edges().chunks(PART)).collect();
        run.in_steps(chunks, [0.7, 1.0], |((sines, ratios), edges)| {
            run.poll()?;
            let mut seen = 0;
            for ((sine, ratio), ends) in sines.iter_mut().zip(ratios).zip(edges) {
                let [p, q] = ends.map(|v| t.coords()[v as usize]);
                let edge = sub(q, p);
                let size = length(edge);
                for (i, &end) in ends.iter().enumerate() {
                    let rims = umbrellas.rims_of(end);
                    seen += rims.len();
                    let other = ends[1 - i];
                    let has = |has, rim: &[u32; 2]| has | (rim[0] == other) | (rim[1] == other);
                    if rims.is_empty() || rims.iter().fold(false, has) {
                        continue;
                    }
                    let first = umbrellas.offsets()[end as usize] as usize;
                    let least = normals[first..first + rims.len()]
                        .iter()
                        .map(|&normal| dot(normal, edge).abs())
                        .fold(f64::INFINITY, f64::min);
                    sine[i] = (least / size).min(1.0);
                    ratio[i] = size / radii[end as usize];
                }
                // An umbrella may have nearly all triangles: they count, not the edges.
                if seen > 1 << 16 {
                    seen = 0;
                    run.poll()?;
                }
            }
            Ok(())
        })?;
        Ok(Conditions { sines, ratios })
    }
}

/// The unit normal of each umbrella triangle, and for each sample the largest of their circumradii.
fn planes(
    t: &Triangulation,
    umbrellas: &Umbrellas,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<(Vec<[f64; 3]>, Vec<f64>)> {
    let count = t.coords().len();
    let pieces = run.in_steps(parts(count), [0.6, 0.7], |samples| {
        let mut room = Room::new(run);
        let offsets = umbrellas.offsets();
        let triangles = offsets[samples.end] - offsets[samples.start];
        let (mut normals, mut radii) = (room.vec(triangles as usize)?, room.vec(samples.len())?);
        for sample in samples {
            let p = t.coords()[sample];
            let mut largest: f64 = 0.0;
            for (i, rim) in umbrellas.rims_of(sample as u32).iter().enumerate() {
                if i % 4096 == 0 {
                    run.poll()?;
                }
                let [u, v] = rim.map(|v| t.coords()[v as usize]);
                let (normal, square) = plane(p, u, v);
                largest = largest.max(square);
                normals.push(normal);
            }
            radii.push(largest.sqrt());
        }
        Ok((normals, radii, room))
    })?;
    let total = umbrellas.rims().len();
    let (mut normals, mut radii) = (room.vec(total)?, room.vec(count)?);
    for (piece, piece_radii, _) in pieces {
        run.poll()?;
        normals.extend(piece);
        radii.extend(piece_radii);
    }
    Ok((normals, radii))
}

/// The unit normal of a triangle, and its squared circumradius. From its two shortest sides: those of a needle are two long ones, which differ by less
/// than they are rounded, and a short one.
fn plane(a: Vec3, b: Vec3, c: Vec3) -> (Vec3, f64) {
    let sides = [sub(b, a), sub(c, b), sub(a, c)];
    let squares = sides.map(|side| dot(side, side));
    let [ab, bc, ca] = squares;
    let (u, v) = match (ab >= bc && ab >= ca, bc >= ca) {
        (true, _) => (sides[1], sides[2]),
        (false, true) => (sides[2], sides[0]),
        (false, false) => (sides[0], sides[1]),
    };
    let normal = cross(u, v);
    // Of twice the area.
    let square = dot(normal, normal);
    // The product of the sides by four times the area.
    (scale(normal, 1.0 / square.sqrt()), 0.25 * ab * (bc * ca / square))
}

//! The angle condition and the ratio condition, at both ends of every Delaunay edge.

use super::umbrella::Umbrellas;
use crate::dual::{self, Facets};
use crate::error::Result;
use crate::job::{PART, Room, Run, parts_of, pieces};
use crate::triangulation::Triangulation;
use crate::vector::{Vec3, cross, dot, length, sub};
use std::array;

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
        let planes = Planes::new(t, umbrellas, room, run)?;
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
                    let blocks = planes.of(end);
                    seen += blocks.len();
                    let (mut least, mut is_spoke) = ([f64::INFINITY; LANES], blocks.is_empty());
                    for block in blocks {
                        is_spoke |= block.has(ends[1 - i]);
                        block.lessen(&mut least, edge);
                    }
                    if !is_spoke {
                        let least = least.into_iter().fold(f64::INFINITY, f64::min);
                        sine[i] = (least / size).min(1.0);
                        ratio[i] = size / planes.radii[end as usize];
                    }
                }
                // An umbrella may have nearly all triangles: they count, not the edges.
                if seen > 1 << 14 {
                    seen = 0;
                    run.poll()?;
                }
            }
            Ok(())
        })?;
        Ok(Conditions { sines, ratios })
    }
}

/// Triangles of an umbrella that are looked at together.
const LANES: usize = 4;

/// The sine of a triangle's largest angle below which its normal is not calculated in floats.
const THIN: f64 = 1.0 / 128.0;

/// The unit normal and the circumradius of a triangle that is thin, but not without area.
#[cold]
fn thin(corners: [Vec3; 3]) -> (Vec3, f64) {
    let [a, b, c] = corners;
    let normal = dual::cross(corners);
    let [ab, bc, ca] = [sub(b, a), sub(c, b), sub(a, c)].map(length);
    let size = length(normal);
    (normal.map(|x| x / size), 0.5 * ab * (bc * ca / size))
}

/// A few triangles of one umbrella, coordinate by coordinate; the last stands for those that are missing.
#[derive(Clone, Copy, Default)]
struct Block {
    /// The unit normals.
    normals: [[f64; LANES]; 3],
    /// The two other vertices.
    rims: [[u32; LANES]; 2],
}

impl Block {
    /// Fills in triangles of a sample's umbrella and returns their circumradii. From their two shortest sides: those of a
    /// needle are two long ones, which differ by less than they are rounded, and a short one.
    ///
    /// The normal in floats has an error of 5u of the product of these sides (u = 2^-53: each coordinate is a difference of two products of
    /// sides, and each of the products wrong by 3u of itself), which is much beside its length where they are nearly parallel. Triangles
    /// of which the normal is less than [`THIN`] of that product are measured again; so all normals are right to 10^-13 of their length.
    #[inline]
    fn fill(&mut self, t: &Triangulation, sample: usize, rims: [[u32; 2]; LANES]) -> [f64; LANES] {
        let a = t.coords()[sample];
        self.rims = [0, 1].map(|i| rims.map(|rim| rim[i]));
        let corners = rims.map(|rim| rim.map(|v| t.coords()[v as usize]));
        let mut radii = [0.0; LANES];
        let mut is_thin = [false; LANES];
        for (lane, [b, c]) in corners.into_iter().enumerate() {
            let sides = [sub(b, a), sub(c, b), sub(a, c)];
            let [ab, bc, ca] = sides.map(|side| dot(side, side));
            let (ab_is_longest, bc_is_longer) = (ab >= bc && ab >= ca, bc >= ca);
            let choose = |[a, b, c]: [Vec3; 3]| -> Vec3 {
                array::from_fn(|k| match (ab_is_longest, bc_is_longer) {
                    (true, _) => b[k],
                    (false, true) => c[k],
                    (false, false) => a[k],
                })
            };
            let normal = cross(choose(sides), choose([sides[1], sides[2], sides[0]]));
            // Of twice the area.
            let square = dot(normal, normal);
            let by_length = 1.0 / square.sqrt();
            for (row, x) in self.normals.iter_mut().zip(normal) {
                row[lane] = x * by_length;
            }
            // The product of the sides by four times the area: half the longest by the sine between the others.
            let radius_squared = 0.25 * ab * (bc * ca / square);
            radii[lane] = radius_squared.sqrt();
            let longest = ab.max(bc).max(ca);
            is_thin[lane] = radius_squared * (4.0 * THIN * THIN) > longest;
        }
        if is_thin.contains(&true) {
            for (lane, [b, c]) in corners.into_iter().enumerate().filter(|&(lane, _)| is_thin[lane])
            {
                let (normal, radius) = thin([a, b, c]);
                radii[lane] = radius;
                for (row, x) in self.normals.iter_mut().zip(normal) {
                    row[lane] = x;
                }
            }
        }
        radii
    }

    /// Whether one of the triangles has the vertex.
    #[inline]
    fn has(&self, vertex: u32) -> bool {
        self.rims.as_flattened().iter().fold(false, |has, &v| has | (v == vertex))
    }

    /// Lessens numbers to the distances of a vector's end from the planes of the triangles.
    #[inline]
    fn lessen(&self, least: &mut [f64; LANES], vector: Vec3) {
        for (lane, least) in least.iter_mut().enumerate() {
            let distance = dot(self.normals.map(|row| row[lane]), vector).abs();
            *least = if distance < *least { distance } else { *least };
        }
    }
}

/// The planes of all umbrella triangles.
struct Planes {
    offsets: Vec<u32>,
    blocks: Vec<Block>,
    /// For each sample the largest circumradius of its umbrella's triangles.
    radii: Vec<f64>,
}

impl Planes {
    fn new(
        t: &Triangulation,
        umbrellas: &Umbrellas,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let count = t.coords().len();
        let blocks_of = |sample: usize| umbrellas.rims_of(sample as u32).chunks(LANES);
        let mut offsets = room.vec(count + 1)?;
        offsets.push(0);
        for sample in run.watch(0..count) {
            let sample = sample?;
            offsets.push(offsets[sample] + blocks_of(sample).len() as u32);
        }
        let mut blocks = room.filled(offsets[count] as usize, Block::default())?;
        let mut radii = room.filled(count, 0.0f64)?;
        let samples = parts_of(PART / 4, count);
        let ends = samples.iter().map(|samples| offsets[samples.end] as usize);
        let results = radii.chunks_mut(PART / 4).zip(pieces(&mut blocks, ends));
        let chunks = results.zip(&samples).collect();
        run.in_steps(chunks, [0.6, 0.7], |((radii, blocks), samples)| {
            let mut blocks = blocks.iter_mut();
            for (radius, sample) in radii.iter_mut().zip(samples.clone()) {
                let mut largest = [0.0; LANES];
                let rows = blocks_of(sample);
                if sample % 1024 == 0 || rows.len() > 1024 {
                    run.poll()?;
                }
                for (rims, block) in rows.zip(&mut blocks) {
                    let last = rims.len() - 1;
                    // The lesser vertex first, so that which way the pole points decides no digit.
                    let rims = array::from_fn(|lane| {
                        let [u, v] = rims[lane.min(last)];
                        [u.min(v), u.max(v)]
                    });
                    let radii = block.fill(t, sample, rims);
                    largest = array::from_fn(|lane| f64::max(largest[lane], radii[lane]));
                }
                *radius = largest.into_iter().fold(0.0, f64::max);
            }
            Ok(())
        })?;
        Ok(Planes { offsets, blocks, radii })
    }

    #[inline]
    fn of(&self, sample: u32) -> &[Block] {
        let s = sample as usize;
        &self.blocks[self.offsets[s] as usize..self.offsets[s + 1] as usize]
    }
}

//! The choice of the two poles of every sample.

use super::position;
use super::tangent::TangentPlane;
use crate::dual::{Dual, radius_order, unit};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{PART, Room, Run};
use crate::predicates::double_double::Pairs;
use crate::triangulation::{Incidence, Triangulation};
use std::cmp::Ordering;

/// The cells whose centres are the poles.
pub(crate) struct Selection {
    /// The cell of each sample's first pole; [`NONE`] where it is at infinity.
    pub(crate) first: Vec<u32>,
    /// The cell of each sample's second pole, or [`NONE`].
    pub(crate) second: Vec<u32>,
    /// The unit direction of each first pole at infinity; 0 for other samples, until [`select_in`](super::select_in) has filled it in.
    pub(crate) normals: Vec<[f64; 3]>,
}

/// The first poles of all samples, without numbers and second ones.
#[derive(Clone, Debug)]
pub(crate) struct FirstPoles {
    /// The cell of each; [`NONE`] where it is at infinity.
    pub cells: Vec<u32>,
    /// The unit direction of each at infinity; 0 for other samples.
    pub normals: Vec<[f64; 3]>,
}

impl FirstPoles {
    /// Of the first so many vertices of a Delaunay triangulation, whose cells round each are given. The cells of each are looked at in ascending
    /// order, so that the least of equal ones is kept.
    pub fn new(
        dual: &Dual,
        samples: usize,
        incidence: &Incidence,
        progress: [f64; 2],
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let normals = directions_to_infinity(dual, samples, room, run)?;
        let mut cells = room.filled(samples, NONE)?;
        let chunks = cells.chunks_mut(PART / 8).zip(normals.chunks(PART / 8)).enumerate().collect();
        run.in_steps(chunks, progress, |(chunk, (first, normals))| {
            for (i, (first, normal)) in first.iter_mut().zip(normals).enumerate() {
                let sample = chunk * (PART / 8) + i;
                let cells = incidence.cells_of(sample as u32);
                if i % 64 == 0 || cells.len() > 1024 {
                    run.poll()?;
                }
                if *normal == [0.0; 3] {
                    for &cell in cells {
                        if is_farther(dual, sample, cell, *first) {
                            *first = cell;
                        }
                    }
                }
            }
            Ok(())
        })?;
        Ok(FirstPoles { cells, normals })
    }
}

impl Selection {
    /// The cells of each sample are looked at in ascending order, so that the least of equal ones is kept.
    pub(super) fn new(
        dual: &Dual,
        samples: usize,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let incidence = dual.triangulation().incidence_in(run)?;
        let FirstPoles { cells: first, normals } =
            FirstPoles::new(dual, samples, &incidence, [0.3, 0.45], room, run)?;
        let mut second = room.filled(samples, NONE)?;
        let poles = first.chunks(PART / 8).zip(normals.chunks(PART / 8));
        let chunks = second.chunks_mut(PART / 8).zip(poles).enumerate().collect();
        run.in_steps(chunks, [0.45, 0.6], |(chunk, (second, (first, normals)))| {
            for (i, second) in second.iter_mut().enumerate() {
                let sample = chunk * (PART / 8) + i;
                let cells = incidence.cells_of(sample as u32);
                if i % 64 == 0 || cells.len() > 1024 {
                    run.poll()?;
                }
                let plane = TangentPlane::new(dual, sample, first[i], normals[i]);
                for &cell in cells {
                    if is_farther(dual, sample, cell, *second)
                        && plane.is_below(dual, sample as u32, cell)
                    {
                        *second = cell;
                    }
                }
            }
            Ok(())
        })?;
        Ok(Selection { first, second, normals })
    }
}

/// For each sample on the hull the mean of the unit directions of its Voronoi cell's unbounded edges, made
/// a unit vector; 0 for all others.
fn directions_to_infinity(
    dual: &Dual,
    samples: usize,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<[f64; 3]>> {
    let mut sums = room.filled(samples, [0.0; 3])?;
    let rays = dual.rays();
    for ray in run.watch(rays.facets().iter().zip(rays.directions())) {
        let (&[cell, facet], direction) = ray?;
        let corners = dual.triangulation().facet(cell, facet as usize);
        for sample in corners.map(|v| v as usize).into_iter().filter(|&v| v < samples) {
            let sum = [0, 1, 2].map(|k| sums[sample][k] + direction[k]);
            // All directions lie strictly on one side of a plane, so no sum is 0 but by rounding.
            sums[sample] = if sum == [0.0; 3] { *direction } else { sum };
        }
    }
    for sum in run.watch(sums.iter_mut().filter(|sum| **sum != [0.0; 3])) {
        let sum = sum?;
        *sum = unit(*sum);
    }
    Ok(sums)
}

/// Whether the cell's centre is farther from their common vertex, the sample, than that of another,
/// lesser cell, or as far and lexicographically less. Distances are compared exactly.
pub(super) fn is_farther(dual: &Dual, sample: usize, cell: u32, other: u32) -> bool {
    if other == NONE {
        return true;
    }
    let radius = |cell: u32| dual.radii_squared()[cell as usize];
    if radius(cell) != radius(other) {
        return radius(cell) > radius(other);
    }
    let is_less = position(dual, cell) < position(dual, other);
    if is_exact(dual, cell) && is_exact(dual, other) {
        return is_less;
    }
    let cells = [cell, other].map(|cell| seen_from(dual.triangulation(), sample as u32, cell));
    match radius_order(cells) {
        Ordering::Equal => is_less,
        order => order == Ordering::Greater,
    }
}

/// Whether the centre and the squared radius of a cell are right without rounding, as they are on most
/// lattices; `false` where that is not seen at once.
fn is_exact(dual: &Dual, cell: u32) -> bool {
    let t = dual.triangulation();
    let (center, square) = (dual.centers()[cell as usize], dual.radii_squared()[cell as usize]);
    t.cells()[cell as usize].iter().all(|&v| {
        // A pair without a second part has lost nothing.
        let offset = Pairs::difference(t.coords()[v as usize], center);
        let squares = offset.mul(&offset);
        let [x, y, z] = [0, 1, 2].map(|k| squares.pick([k]));
        let (xy, xyz) = (x.add(&y), x.add(&y).add(&z));
        let lost = [offset.lo, squares.lo, [xy.lo[0], xyz.lo[0], 0.0]];
        lost.as_flattened().iter().all(|&part| part == 0.0) && xyz.hi[0] == square
    })
}

/// The points of a cell, the given vertex of it first.
pub(crate) fn seen_from(t: &Triangulation, vertex: u32, cell: u32) -> [[f64; 3]; 4] {
    let mut corners = t.cells()[cell as usize];
    let slot = corners.iter().position(|&v| v == vertex).unwrap_or(0);
    corners.swap(0, slot);
    corners.map(|v| t.coords()[v as usize])
}

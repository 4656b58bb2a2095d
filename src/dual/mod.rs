//! Voronoi and power diagrams, read off a triangulation.
//!
//! Each part of the diagram is dual to one of the triangulation: a Voronoi vertex to a cell, an edge to
//! a facet, a polygonal facet to an edge, a Voronoi cell to a vertex. Of a regular triangulation it is the
//! power diagram (Aurenhammer 1987); what is said of Voronoi diagrams here holds for both.

mod center;
mod exact;
mod facets;
mod fixed;
mod normal;
mod processor;
mod rays;
mod validate;

pub use center::{Center, circumcenter, orthocenter};
pub(crate) use center::{offsets, radius_order};
pub(crate) use exact::{Way, direction_sign, dot_sign, triple_sign};
pub use facets::Facets;
pub(crate) use normal::{cross, unit};
pub use rays::Rays;

use crate::error::{ElementKind, Error, Result, Status};
use crate::job::{Job, PART, Room, Run, Stage, parts};
use crate::predicates::UNIT;
use crate::triangulation::Triangulation;
use crate::vector::{Vec3, sub};
use std::sync::Arc;

/// What a [`Dual`] holds besides centres, radii and rays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DualOptions {
    /// The Voronoi facets: a ring of cells for each edge.
    pub facets: bool,
}

/// The Voronoi diagram of a Delaunay triangulation, or the power diagram of a regular one.
///
/// Invariants: one centre and squared radius per finite cell, each number the f64 nearest to the exact
/// one (see [`circumcenter`]); one ray per facet on the hull; facets as [`Facets`] says.
#[derive(Clone, Debug)]
pub struct Dual {
    triangulation: Arc<Triangulation>,
    centers: Vec<[f64; 3]>,
    radii_squared: Vec<f64>,
    rays: Rays,
    facets: Option<Facets>,
}

impl Dual {
    /// Reads the diagram off a triangulation, which it keeps.
    ///
    /// Errors: [`Status::LimitExceeded`] where the rings of the facets have more than 2^32 - 1
    /// entries together, and those of the job. Cost: O(m) for m cells.
    pub fn new(
        triangulation: &Arc<Triangulation>,
        options: DualOptions,
        job: &Job,
    ) -> Result<Self> {
        job.run(&[(Stage::Dual, 1.0)], |run| Dual::new_in(triangulation, options, run))
    }

    /// [`Dual::new`] as a stage of a larger build.
    pub(crate) fn new_in(
        triangulation: &Arc<Triangulation>,
        options: DualOptions,
        run: &Run<'_>,
    ) -> Result<Self> {
        run.enter(Stage::Dual)?;
        let mut room = Room::new(run);
        let (centers, radii_squared) = centers(triangulation, &mut room, run)?;
        let rays = Rays::new(triangulation, run)?;
        let facets = match options.facets {
            true => Some(Facets::new(triangulation, &rays, run)?),
            false => None,
        };
        Ok(Dual { triangulation: triangulation.clone(), centers, radii_squared, rays, facets })
    }

    /// What the centres, radii and rays take.
    pub(crate) fn bytes(&self) -> usize {
        (size_of_val(self.centers()) + size_of_val(self.radii_squared()))
            + (size_of_val(self.rays.facets()) + size_of_val(self.rays.directions()))
    }

    /// The triangulation.
    pub fn triangulation(&self) -> &Arc<Triangulation> {
        &self.triangulation
    }

    /// The Voronoi vertex of each cell: its circumcentre, or its orthocentre in a power diagram. In
    /// input units, correctly rounded.
    pub fn centers(&self) -> &[[f64; 3]] {
        &self.centers
    }

    /// The squared radius of each cell's sphere, in squared units, correctly rounded; negative
    /// where weights are large.
    pub fn radii_squared(&self) -> &[f64] {
        &self.radii_squared
    }

    /// The rounded centre of a cell less a point, and the most that each coordinate of the difference is off the exact one.
    #[inline]
    pub(crate) fn center_from(&self, cell: u32, point: Vec3) -> (Vec3, Vec3) {
        let center = self.centers[cell as usize];
        let x = sub(center, point);
        let error = [0, 1, 2].map(|k| match center[k].abs() {
            // The centre may be farther still: nothing is known.
            f64::MAX => f64::INFINITY,
            size => UNIT * (size + x[k].abs()) + f64::from_bits(1),
        });
        (x, error)
    }

    /// The unbounded Voronoi edges.
    pub fn rays(&self) -> &Rays {
        &self.rays
    }

    /// The Voronoi facets, if [`DualOptions::facets`] asked for them.
    pub fn facets(&self) -> Option<&Facets> {
        self.facets.as_ref()
    }
}

/// The orthocentres of the given cells of a regular triangulation, correctly rounded, without their radii: much
/// cheaper where the squared radius is nearly 0, as it is where many balls pass through one point, and so hard to
/// round.
pub(crate) fn orthocenter_positions(
    t: &Triangulation,
    cells: &[u32],
    positions: &mut [[f64; 3]],
    run: &Run<'_>,
) -> Result<()> {
    for (cells, positions) in cells.chunks(LANES * 256).zip(positions.chunks_mut(LANES * 256)) {
        run.poll()?;
        for (cells, positions) in cells.chunks(LANES).zip(positions.chunks_mut(LANES)) {
            // The last cell stands for those that are missing.
            let lanes: [u32; LANES] = std::array::from_fn(|l| cells[l.min(cells.len() - 1)]);
            let corners = lanes.map(|cell| t.cells()[cell as usize]);
            let points = corners.map(|corners| corners.map(|v| t.coords()[v as usize]));
            let weights = corners.map(|corners| corners.map(|v| t.weights()[v as usize]));
            let bases = points.map(|points| points[0]);
            let found = center::centers::<LANES, false>(&points, Some(&weights), &bases);
            for ((position, found), &cell) in positions.iter_mut().zip(found).zip(cells) {
                *position = found.ok_or_else(|| is_flat(cell))?.position;
            }
        }
    }
    Ok(())
}

/// The error of a cell without a centre.
fn is_flat(cell: u32) -> Error {
    Error::new(Status::Internal, "the cell is flat").at(ElementKind::Cell, u64::from(cell))
}

/// Cells whose centres are calculated together: as many as floats in a vector register of most processors.
pub(crate) const LANES: usize = 4;

/// The centre and the squared radius of every cell.
fn centers(
    t: &Triangulation,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<(Vec<[f64; 3]>, Vec<f64>)> {
    let count = t.cells().len();
    let mut centers = room.filled(count, [0.0; 3])?;
    let mut radii_squared = room.filled(count, 0.0)?;
    let results = centers.chunks_mut(PART).zip(radii_squared.chunks_mut(PART));
    let chunks = parts(count).into_iter().zip(results).collect();
    run.in_steps(chunks, [0.0, 0.8], |(range, (centers, radii_squared))| {
        for begin in range.clone().step_by(LANES) {
            // The last cell stands for those that are missing.
            let lanes: [usize; LANES] = std::array::from_fn(|l| (begin + l).min(range.end - 1));
            let corners = lanes.map(|cell| t.cells()[cell]);
            let points = corners.map(|corners| corners.map(|v| t.coords()[v as usize]));
            let bases = points.map(|points| points[0]);
            let weights =
                t.is_weighted().then(|| corners.map(|c| c.map(|v| t.weights()[v as usize])));
            let found = center::centers::<LANES, true>(&points, weights.as_ref(), &bases);
            for (cell, center) in (begin..range.end).zip(found) {
                if cell % 1024 == 0 {
                    run.poll()?;
                }
                let center = center.ok_or_else(|| is_flat(cell as u32))?;
                centers[cell - range.start] = center.position;
                radii_squared[cell - range.start] = center.radius_squared;
            }
        }
        Ok(())
    })?;
    Ok((centers, radii_squared))
}

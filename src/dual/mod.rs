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
mod rays;
mod validate;

pub use center::{Center, circumcenter, orthocenter};
pub(crate) use center::{offset, orthocenter_position, radius_order};
pub(crate) use exact::{direction_sign, dot_sign};
pub use facets::Facets;
pub(crate) use normal::unit;
pub use rays::Rays;

use crate::error::{ElementKind, Error, Result, Status};
use crate::job::{Job, Run, Stage};
use crate::triangulation::Triangulation;
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
        let _charge = run.charge(triangulation.cells().len() as u64 * CELL_BYTES)?;
        let (centers, radii_squared) = centers(triangulation, run)?;
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

    /// The unbounded Voronoi edges.
    pub fn rays(&self) -> &Rays {
        &self.rays
    }

    /// The Voronoi facets, if [`DualOptions::facets`] asked for them.
    pub fn facets(&self) -> Option<&Facets> {
        self.facets.as_ref()
    }
}

/// What a centre and a squared radius take.
const CELL_BYTES: u64 = size_of::<[f64; 4]>() as u64;
/// Cells whose centres are calculated together: as many as floats in the vector registers that every
/// processor has.
const LANES: usize = 2;
/// Lanes between two reports of progress.
const BATCH: usize = 4096;

/// The centre and the squared radius of every cell.
fn centers(t: &Triangulation, run: &Run<'_>) -> Result<(Vec<[f64; 3]>, Vec<f64>)> {
    let count = t.cells().len();
    let (mut centers, mut radii_squared) = (run.try_vec(count)?, run.try_vec(count)?);
    for (batch, cells) in t.cells().chunks(LANES * BATCH).enumerate() {
        run.tick(batch * LANES * BATCH, count)?;
        for chunk in cells.chunks(LANES) {
            // The last cell stands for those that are missing.
            let lanes: [[u32; 4]; LANES] = std::array::from_fn(|l| chunk[l.min(chunk.len() - 1)]);
            let points = lanes.map(|cell| cell.map(|v| t.coords()[v as usize]));
            let weights =
                t.is_weighted().then(|| lanes.map(|cell| cell.map(|v| t.weights()[v as usize])));
            for center in center::centers(points, weights).into_iter().take(chunk.len()) {
                let center = center.ok_or_else(|| {
                    Error::new(Status::Internal, "the cell is flat")
                        .at(ElementKind::Cell, centers.len() as u64)
                })?;
                centers.push(center.position);
                radii_squared.push(center.radius_squared);
            }
        }
    }
    Ok((centers, radii_squared))
}

//! MEDIAL: the medial axis straight from the Voronoi diagram (Dey, Zhao 2004, *Approximating the medial axis from the
//! Voronoi diagram with a convergence guarantee*).
//!
//! A Voronoi facet belongs to the axis if its dual Delaunay edge makes a large angle with the surface at one of its ends, or is long beside
//! the triangles of the surface there. See `docs/algorithms/medial.md`.

mod axis;
mod clip;
mod conditions;
mod filter;
mod reach;
mod scale;
mod umbrella;
mod validate;

pub use filter::{MedialFilter, MedialRule, Side};
pub use umbrella::Umbrellas;

use crate::dual::{Dual, Facets};
use crate::error::{ElementKind, Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use crate::labels::Labels;
use crate::poles::{FirstPoles, least_cells};
use conditions::Conditions;
use std::sync::Arc;

/// What to calculate.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MedialOptions {
    /// The normals of the surface at the samples, one for each vertex of the points, to be used in place of their pole vectors: where the input is a
    /// mesh, for example those of discrete curvature. Their lengths do not count, nor which way they point; a
    /// vertex whose normal is 0 has no umbrella.
    pub normals: Option<Vec<[f64; 3]>>,
    /// Calculate the pairwise scales too, for filters by scale; off by default. Costs a search among all balls for each, far
    /// more than all the rest: 12 seconds for 44,000 samples with two threads.
    pub scales: bool,
}

/// Every Voronoi facet of a sample with what decides whether it belongs to the axis. A filter is a threshold on that: to move it
/// builds nothing again.
///
/// Invariants: arrays by facet have one row for each facet of the dual, arrays by cell one for each cell; see
/// [`Umbrellas`] for these.
#[derive(Clone, Debug)]
pub struct Medial {
    dual: Arc<Dual>,
    labels: Option<Arc<Labels>>,
    options: MedialOptions,
    poles: FirstPoles,
    umbrellas: Umbrellas,
    conditions: Conditions,
    reaches: Vec<[f64; 2]>,
    /// For each cell the least that has its Voronoi vertex.
    least_cell: Vec<u32>,
    /// For each cell, or empty.
    scales: Vec<f64>,
}

impl Medial {
    /// Calculates umbrellas, conditions and attributes from the Voronoi diagram of a sample, which must have its facets
    /// ([`DualOptions::facets`](crate::dual::DualOptions)). With labels the inner and the outer axis can be told apart.
    ///
    /// Errors: [`Status::InvalidArgument`] for a power diagram, a dual without facets, or normals that are not finite;
    /// [`Status::Mismatch`] for labels of another triangulation and for normals that are more or fewer than the vertices; those of the job. Cost:
    /// O(size of the dual), and for each Delaunay edge a look at every umbrella triangle of its ends: linear where umbrellas or degrees are bounded, as on
    /// surfaces that are sampled evenly, quadratic at a sample of which most others are neighbours.
    pub fn new(
        dual: &Arc<Dual>,
        labels: Option<&Arc<Labels>>,
        options: MedialOptions,
        job: &Job,
    ) -> Result<Self> {
        let plan = [(Stage::Medial, 0.6), (Stage::Extract, 0.4)];
        job.run(&plan, |run| Medial::new_in(dual, labels, options, run))
    }

    /// [`Medial::new`] as a stage of a larger build.
    pub(crate) fn new_in(
        dual: &Arc<Dual>,
        labels: Option<&Arc<Labels>>,
        options: MedialOptions,
        run: &Run<'_>,
    ) -> Result<Self> {
        run.enter(Stage::Medial)?;
        let t = dual.triangulation();
        if t.is_weighted() {
            return Err(Error::new(
                Status::InvalidArgument,
                "a medial axis needs the dual of a Delaunay triangulation, not of a regular one",
            ));
        }
        let facets = dual.facets().ok_or_else(|| {
            Error::new(Status::InvalidArgument, "the dual was made without its facets")
        })?;
        if let Some(labels) = labels {
            labels.check_triangulation(t)?;
        }
        let mut room = Room::new(run);
        let poles = match &options.normals {
            Some(normals) => given(normals, t.coords().len(), &mut room)?,
            None => {
                let incidence = t.incidence_in(run)?;
                FirstPoles::new(dual, t.coords().len(), &incidence, [0.0, 0.2], &mut room, run)?
            }
        };
        let umbrellas = Umbrellas::new(dual, &poles, &mut room, run)?;
        let conditions = Conditions::new(t, facets, &umbrellas, &mut room, run)?;
        // What follows decides nothing of MEDIAL.
        run.enter(Stage::Extract)?;
        let reaches = reach::reaches(dual, facets, &mut room, run)?;
        let least_cell = least_cells(dual, &mut room, run)?;
        let scales = match options.scales {
            true => scale::scales(dual, &least_cell, labels.map(|l| &**l), &mut room, run)?,
            false => Vec::new(),
        };
        let labels = labels.cloned();
        let dual = dual.clone();
        Ok(Medial {
            dual,
            labels,
            options,
            poles,
            umbrellas,
            conditions,
            reaches,
            least_cell,
            scales,
        })
    }

    /// The Voronoi diagram.
    pub fn dual(&self) -> &Arc<Dual> {
        &self.dual
    }

    /// The labels that tell the inner from the outer axis, if any.
    pub fn labels(&self) -> Option<&Arc<Labels>> {
        self.labels.as_ref()
    }

    /// What was asked for.
    pub fn options(&self) -> &MedialOptions {
        &self.options
    }

    /// The umbrella of each sample.
    pub fn umbrellas(&self) -> &Umbrellas {
        &self.umbrellas
    }

    /// For each Voronoi facet, by the two ends of its dual edge, the sine of the least angle between the edge and the planes of the
    /// end's umbrella triangles, in [0, 1]; minus infinity where the umbrella has the edge, or has no triangle. Right to 10^-12, however thin
    /// the triangles are.
    pub fn sines(&self) -> &[[f64; 2]] {
        &self.conditions.sines
    }

    /// For each Voronoi facet, by the two ends of its dual edge, the length of the edge by the largest circumradius of the
    /// end's umbrella triangles; minus infinity where the umbrella has the edge, or has no triangle. Right to 10^-12 of itself, however thin the
    /// triangles are.
    pub fn ratios(&self) -> &[[f64; 2]] {
        &self.conditions.ratios
    }

    /// For each Voronoi facet the least and the largest distance of its points from the middle of its dual edge, in input units;
    /// infinity where it is unbounded.
    pub fn reaches(&self) -> &[[f64; 2]] {
        &self.reaches
    }

    /// For each cell the least with the same circumscribed sphere: the same Voronoi vertex.
    pub fn least_cell(&self) -> &[u32] {
        &self.least_cell
    }

    /// The pairwise scale s* of each cell's ball (of its Voronoi vertex, through its samples): the least factor s at which another ball
    /// of the same label, its radius grown by s, covers this one, grown as well; infinity for the largest. Empty unless asked for.
    ///
    /// That is |c - c'| / (r' - r), the least over all balls with a larger radius r'. It stands for the scale axis transform (Giesen,
    /// Miklos, Pauly, Wormser 2009), where grown balls are covered by many together: a ball that this one keeps may be one that the
    /// transform drops.
    pub fn scales(&self) -> &[f64] {
        &self.scales
    }

    /// The facets of the dual, which a [`Medial`] always has.
    fn facets(&self) -> Result<&Facets> {
        self.dual
            .facets()
            .ok_or_else(|| Error::new(Status::Internal, "the dual has lost its facets"))
    }
}

/// Normals in place of poles.
fn given(normals: &[[f64; 3]], vertices: usize, room: &mut Room<'_>) -> Result<FirstPoles> {
    if normals.len() != vertices {
        let message = format!("{} normals for {vertices} vertices", normals.len());
        return Err(Error::new(Status::Mismatch, message));
    }
    if let Some(row) = normals.iter().position(|normal| !normal.iter().all(|x| x.is_finite())) {
        let error = Error::new(Status::InvalidArgument, "a normal is not finite");
        return Err(error.at(ElementKind::Vertex, row as u64));
    }
    Ok(FirstPoles {
        cells: room.filled(vertices, NONE)?,
        normals: room.collect(normals.iter().copied())?,
    })
}

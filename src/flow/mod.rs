//! The flow of the distance to the samples, its critical points, and the unstable flow complex (Giesen, Ramos, Sadri, *Medial axis approximation and unstable
//! flow complex*). See `docs/algorithms/flow.md`.

mod closure;
mod collapse;
mod complex;
mod core;
mod critical;
mod cuts;
mod drivers;
mod extract;
mod inner;
mod leaving;
mod orbit;
mod outline;
mod place;
mod share;
mod side;
mod simplex;
mod source;
mod strips;
mod subdivision;
mod touched;
mod triangles;
mod upstream;
mod validate;
mod whole;

pub use complex::FlowComplex;
pub use core::{Core, CoreOptions, Excluded};
pub use critical::{CriticalClass, CriticalPoints};
pub use orbit::Orbits;
pub use place::FlowAt;
pub use simplex::Simplex;
pub use subdivision::FlowElement;

use crate::dual::Dual;
use crate::error::{Error, Result, Status};
use crate::job::{Job, Room, Run, Stage};
use crate::labels::Labels;
use drivers::Drivers;
use source::Source;
use std::sync::Arc;
use triangles::Triangles;

/// What to calculate.
#[derive(Clone, Debug, PartialEq)]
pub struct FlowOptions {
    /// The slope above which a critical point belongs to the medial axis and not to the surface ([`CriticalPoints::slopes`]), in (0, 1); 0.5 by default.
    pub least_slope: f64,
}

impl Default for FlowOptions {
    fn default() -> Self {
        FlowOptions { least_slope: 0.5 }
    }
}

/// The flow of the distance to the samples: where it goes, and where it ends.
///
/// From each point the flow runs away from the nearest point of the Delaunay simplex of its nearest samples, the *driver*: in the direction in
/// which the distance to the samples grows most.
#[derive(Clone, Debug)]
pub struct Flow {
    dual: Arc<Dual>,
    labels: Arc<Labels>,
    options: FlowOptions,
    triangles: Triangles,
    drivers: Drivers,
    critical: CriticalPoints,
}

impl Flow {
    /// Calculates the flow of a sample from its Voronoi diagram, which must have its facets. The labels tell the inner from the outer medial axis.
    ///
    /// Errors: [`Status::InvalidArgument`] for a power diagram, a dual without facets, or an option out of range; [`Status::Mismatch`] for labels of another
    /// triangulation; those of the job.
    pub fn new(
        dual: &Arc<Dual>,
        labels: &Arc<Labels>,
        options: FlowOptions,
        job: &Job,
    ) -> Result<Self> {
        job.run(&[(Stage::Flow, 1.0)], |run| Flow::new_in(dual, labels, options, run))
    }

    /// [`Flow::new`] as a stage of a larger build.
    pub(crate) fn new_in(
        dual: &Arc<Dual>,
        labels: &Arc<Labels>,
        options: FlowOptions,
        run: &Run<'_>,
    ) -> Result<Self> {
        run.enter(Stage::Flow)?;
        if !(options.least_slope > 0.0 && options.least_slope < 1.0) {
            let message = format!("a slope of {} is not between 0 and 1", options.least_slope);
            return Err(Error::new(Status::InvalidArgument, message));
        }
        let t = dual.triangulation();
        if t.is_weighted() {
            return Err(Error::new(
                Status::InvalidArgument,
                "a flow needs the dual of a Delaunay triangulation, not of a regular one",
            ));
        }
        let facets = dual.facets().ok_or_else(|| {
            Error::new(Status::InvalidArgument, "the dual was made without its facets")
        })?;
        labels.check_triangulation(t)?;
        let mut room = Room::new(run);
        let triangles = Triangles::new(t, &mut room, run)?;
        let drivers = Drivers::new(dual, facets, &triangles, &mut room, run)?;
        let source = Source { dual, facets, triangles: &triangles, drivers: &drivers };
        let mut critical = CriticalPoints::new(&source, &mut room, run)?;
        critical.separate(&source, labels, options.least_slope, &mut room, run)?;
        let (dual, labels) = (dual.clone(), labels.clone());
        Ok(Flow { dual, labels, options, triangles, drivers, critical })
    }

    /// The Voronoi diagram.
    pub fn dual(&self) -> &Arc<Dual> {
        &self.dual
    }

    /// The labels that tell the inner from the outer medial axis.
    pub fn labels(&self) -> &Arc<Labels> {
        &self.labels
    }

    /// What was asked for.
    pub fn options(&self) -> &FlowOptions {
        &self.options
    }

    /// The critical points of the distance to the samples.
    pub fn critical(&self) -> &CriticalPoints {
        &self.critical
    }

    /// The triangles of the triangulation, each once: the lesser of its cells, and the slot of the vertex opposite. [`Simplex::Triangle`] counts them.
    pub fn triangles(&self) -> &[[u32; 2]] {
        &self.triangles.sides
    }

    /// The driver of the points inside the Voronoi edge of a triangle: the centre of the triangle, or if that is obtuse the middle of its longest edge. That of a Voronoi
    /// facet is always the middle of its edge.
    pub fn driver_of_triangle(&self, triangle: u32) -> Simplex {
        self.drivers.of_triangle(triangle)
    }

    /// The driver of the Voronoi vertex of a cell.
    pub fn driver_of_cell(&self, cell: u32) -> Simplex {
        self.drivers.of_cell(&self.triangles, cell)
    }

    /// What the flow is read from.
    fn source(&self) -> Result<Source<'_>> {
        let facets = self
            .dual
            .facets()
            .ok_or_else(|| Error::new(Status::Internal, "the dual has lost its facets"))?;
        let Flow { dual, triangles, drivers, .. } = self;
        Ok(Source { dual, facets, triangles, drivers })
    }
}

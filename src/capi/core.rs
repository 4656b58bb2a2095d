//! Core
//!
//! What flows from the critical points of the medial axis on one side of the surface: an axis, of faces and loose edges, with the homotopy type
//! of the solid where the sample is dense enough. Repaired, the inner core has that of the labelled solid, however sparse the sample is. A core can be
//! extended by Voronoi facets, such as those that a filter of a #medax_medial lets pass, which alone need not have it.
//! (Giesen, Ramos, Sadri 2010, Medial axis approximation and unstable flow complex.)

use super::boundary;
use super::complex;
use super::handle::{self, medax_complex, medax_flow, medax_job};
use super::medial::{self, medax_side};
use super::options::{self, Report, SizedStruct, flag, sized_struct};
use super::status::medax_status;
use super::view::{self, Out};
use crate::error::Result;
use crate::flow::{Core, CoreOptions};
use std::sync::Arc;

/// Which core.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_core_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// A #medax_side: of the critical points of which axis; `MEDAX_SIDE_INNER` by default.
    pub side: u32,
    /// 1, the default, to add as much of the flow of other critical points to the inner core as it takes for it to have the homotopy type
    /// of the labelled solid, however sparse the sample is; 0 not to. Other cores are not repaired.
    pub repair: u32,
}

sized_struct!(medax_core_options, first_size: size_of::<medax_core_options>(), reserved: none,
    { side: u32 = medax_side::Inner as u32, repair: u32 = 1 });

impl medax_core_options {
    fn translate(&self) -> Result<CoreOptions> {
        Ok(CoreOptions { side: medial::side(self.side)?, repair: flag(self.repair, "repair")? })
    }
}

/// Sets core options to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_core_options_init(
    options: *mut medax_core_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// What became of the facets by which a core was to be extended, each counted once. The caller sets `struct_size`, the library the rest.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_core_report {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// The number of those that extend it.
    pub taken: u64,
    /// The number of those that cross the surface, and so are left out: the dual edge is one of its edges.
    pub of_surface: u64,
    /// The number of those on the other side of the surface, which are left out.
    pub elsewhere: u64,
    /// The number of those whose flow comes to a critical point of the surface, or of the other side, and of those that stay open for a sample within the solid when the core is repaired; they are left out.
    pub leaving: u64,
    /// The number of faces and loose edges of the core itself that are left out, since they are unbounded.
    pub unbounded: u64,
}

sized_struct!(medax_core_report, first_size: size_of::<medax_core_report>(), reserved: none,
    { taken: u64 = 0, of_surface: u64 = 0, elsewhere: u64 = 0, leaving: u64 = 0, unbounded: u64 = 0 });

impl From<&Core> for medax_core_report {
    fn from(core: &Core) -> Self {
        let excluded = core.excluded();
        medax_core_report {
            taken: core.taken() as u64,
            of_surface: excluded.of_surface as u64,
            elsewhere: excluded.elsewhere as u64,
            leaving: excluded.leaving as u64,
            unbounded: core.unbounded() as u64,
            ..Self::DEFAULT
        }
    }
}

/// The core of one side: what flows from the critical points of its medial axis, which has the homotopy type of the solid if the sample is
/// dense enough (theorem 3.16); extended by what flows from some Voronoi facets, but for those that cannot extend it (theorem 3.17).
///
/// Vertices carry `radius` (their distance from the samples), `cell` (of which they are the Voronoi vertex, or `MEDAX_NONE`) and `critical`
/// (the row of the critical point that they are, or `MEDAX_NONE`). Faces carry `facet` (of which they are a part), `samples` (the two ends of
/// its dual edge) and `lambda` (half the length of that); edges, those of no face, `samples` (the corners of the triangle of whose Voronoi edge they
/// are a part; or the two samples of the facet through which they follow an orbit, then `MEDAX_NONE`).
///
/// \param flow The flow.
/// \param facets `facet_count` rows of #medax_dual_facets, as #medax_medial_selected has them; NULL only if `facet_count` is 0.
/// \param facet_count The number of facets by which the core is to be extended.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_report Filled, its `struct_size` being set; or NULL.
/// \param out_core Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` with a facet that is not there, for an option out of range, and for a report of no
///         version; `NULL_ARGUMENT`, `LIMIT_EXCEEDED`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size of the dual), and O(size) of the part of the flow complex that is reached. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_core(
    flow: *const medax_flow,
    facets: *const u32,
    facet_count: usize,
    options: *const medax_core_options,
    job: *const medax_job,
    out_report: *mut medax_core_report,
    out_core: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let flow = &handle::get(flow, "flow")?.flow;
        let options = options::read(options, "options")?.translate()?;
        let facets = view::slice(facets, facet_count, "facets")?;
        let report = Report::maybe(out_report, "out_report")?;
        let out = Out::new(out_core, "out_core")?;
        let mut own = None;
        let core = flow.core(options, facets, handle::job(job, &mut own))?;
        if let Some(report) = report {
            report.fill(&medax_core_report::from(&core));
        }
        out.put(complex::give(Arc::new(core.into_complex())));
        Ok(())
    })
}

//! Incidence
//!
//! What a triangulation tells only indirectly: the cells of each vertex, and the edges.

use super::boundary;
use super::handle::{self, medax_incidence, medax_job, medax_triangulation};
use super::status::medax_status;
use super::view::{Out, medax_view_rows, medax_view_u32};
use crate::job::Stage;
use std::ptr;

/// Builds the incidences of a triangulation.
///
/// \param triangulation The triangulation.
/// \param job NULL for a default job.
/// \param out_incidence Receives the incidences, which the caller frees with
///        #medax_incidence_free.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(m log m). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_incidence_build(
    triangulation: *const medax_triangulation,
    job: *const medax_job,
    out_incidence: *mut *const medax_incidence,
) -> medax_status {
    boundary::status(|| {
        let triangulation = &handle::get(triangulation, "triangulation")?.triangulation;
        let out = Out::new(out_incidence, "out_incidence")?;
        let mut own = None;
        let built = handle::job(job, &mut own).run(&[(Stage::Extract, 1.0)], |run| {
            run.enter(Stage::Extract)?;
            let cells = triangulation.incidence_in(run)?;
            let edges = triangulation.edges_in(&cells, run)?;
            Ok(medax_incidence { cells, edges })
        })?;
        out.put(handle::new(built));
        Ok(())
    })
}

/// The cells of each vertex.
///
/// \param incidence The incidences, or NULL.
/// \return One row a vertex: the cells that have it, ascending; a hidden vertex has none. Borrowed
///         from `incidence`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_incidence_cells_of_vertex(
    incidence: *const medax_incidence,
) -> medax_view_rows {
    boundary::value(medax_view_rows::EMPTY, || {
        handle::maybe(incidence).map_or(medax_view_rows::EMPTY, |i| {
            medax_view_rows::new(i.cells.offsets(), i.cells.cells())
        })
    })
}

/// The edges.
///
/// \param incidence The incidences, or NULL.
/// \return e x 2 vertices, the lesser one first; edges ascend. Borrowed from `incidence`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_incidence_edges(
    incidence: *const medax_incidence,
) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], 2), || {
        let edges = handle::maybe(incidence).map_or(&[][..], |i| &i.edges.ends);
        medax_view_u32::new(edges.as_flattened(), 2)
    })
}

/// A cell of each edge, from which #medax_triangulation_ring finds the others.
///
/// \param incidence The incidences, or NULL.
/// \return e x 1: the least cell that has the edge. Borrowed from `incidence`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_incidence_cell_of_edge(
    incidence: *const medax_incidence,
) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], 1), || {
        medax_view_u32::new(handle::maybe(incidence).map_or(&[][..], |i| &i.edges.cells), 1)
    })
}

/// One more reference to incidences.
///
/// \param incidence The incidences, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_incidence_clone(
    incidence: *const medax_incidence,
) -> *const medax_incidence {
    boundary::value(ptr::null(), || handle::clone(incidence))
}

/// Gives one reference to incidences back; the last one frees them.
///
/// \param incidence The incidences; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_incidence_free(incidence: *const medax_incidence) {
    boundary::value((), || handle::free(incidence));
}

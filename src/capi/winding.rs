//! Winding numbers
//!
//! How often the faces of a complex wind round a point: 1 inside a closed surface whose faces point out, 0 outside of it.
//! (Jacobson, Kavan, Sorkine-Hornung 2013, Robust inside-outside segmentation using generalized winding numbers.)

use super::boundary;
use super::handle::{self, medax_complex, medax_job};
use super::status::medax_status;
use super::view::{self, Buffer};

/// The generalised winding number of the faces round points: the solid angle of #medax_complex_triangles seen from there, by 4 pi.
///
/// Inside a closed surface it is 1, outside 0; -1 inside one that is turned inside out, 0 in a void whose faces point into it, 2 where two shells
/// overlap. Near a hole or a seam it lies in between, and on a face it is the mean of both sides. Triangles that are far away count together: on
/// the meshes that were measured that is off by 0.002 at most.
///
/// \param complex The complex.
/// \param query_xyz `query_count` x 3 coordinates; NULL only if `query_count` is 0.
/// \param query_count The number of points.
/// \param job NULL for a default job.
/// \param out_numbers Receives `query_count` winding numbers; the caller's buffer, NULL only if `query_count` is 0.
/// \return `MEDAX_STATUS_OK`; `NON_FINITE` with the row of a query; `INVALID_ARGUMENT` for a complex without faces;
///         `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(n log n) for n triangles, and then about O(log n) a query. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_winding_numbers(
    complex: *const medax_complex,
    query_xyz: *const f64,
    query_count: usize,
    job: *const medax_job,
    out_numbers: *mut f64,
) -> medax_status {
    boundary::status(|| {
        let complex = &handle::get(complex, "complex")?.complex;
        let queries = view::rows(query_xyz, query_count, "query_xyz")?;
        let out = Buffer::new(out_numbers, query_count, "out_numbers")?;
        let mut own = None;
        out.fill(&complex.winding_numbers(queries, handle::job(job, &mut own))?);
        Ok(())
    })
}

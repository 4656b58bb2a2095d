//! Normals
//!
//! The normals of a surface at its vertices.

use super::boundary;
use super::handle::{self, medax_complex, medax_job};
use super::status::medax_status;
use super::view::Buffer;
use crate::error::{Error, Status};

/// The normals of the surface at the vertices of a complex, those of its discrete mean curvature, turned as the faces turn: outward
/// if the faces point out. (Meyer, Desbrun, Schroeder, Barr 2003, Discrete differential-geometry operators for triangulated
/// 2-manifolds.)
///
/// Where the surface is flat, so that it has no curvature, or the two differ by more than 60 degrees, the mean of the triangles'
/// normals weighted by their angles. What only the rounding of coordinates makes counts for next to nothing: a mesh that is rotated
/// about the origin has the rotated normals, but for about 10^-6.
///
/// \param complex The complex.
/// \param job NULL for a default job.
/// \param vertex_count The number of vertices of the complex, for which `out_normals` has room.
/// \param out_normals Receives `vertex_count` x 3 coordinates: vectors of length 1, and of length 0 for a vertex without a face
///        that has an area; the caller's buffer, NULL only if `vertex_count` is 0.
/// \return `MEDAX_STATUS_OK`; `MISMATCH` unless `vertex_count` is the number of vertices; `NULL_ARGUMENT`, `INVALID_ARGUMENT`,
///         `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_vertex_normals(
    complex: *const medax_complex,
    job: *const medax_job,
    vertex_count: usize,
    out_normals: *mut f64,
) -> medax_status {
    boundary::status(|| {
        let complex = &handle::get(complex, "complex")?.complex;
        let out = Buffer::new(out_normals.cast::<[f64; 3]>(), vertex_count, "out_normals")?;
        let vertices = complex.vertices().len();
        if vertex_count != vertices {
            let message = format!("room for {vertex_count} normals of {vertices} vertices");
            return Err(Error::new(Status::Mismatch, message));
        }
        let mut own = None;
        out.fill(&complex.vertex_normals(handle::job(job, &mut own))?);
        Ok(())
    })
}

//! Decimation
//!
//! Fewer triangles for the same surface.

use super::boundary;
use super::complex;
use super::handle::{self, medax_complex, medax_job};
use super::options::{self, sized_struct};
use super::status::medax_status;
use super::view::Out;
use crate::complex::DecimateOptions;
use std::sync::Arc;

/// The settings of a decimation.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_decimate_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// The number of triangles to come down to; 0, the default: as few as can be.
    pub triangles: u64,
    /// The greatest distance, in input units, that the surface may come away from what it was; infinity, the
    /// default: any. With it the aim may be missed.
    pub max_error: f64,
}

sized_struct!(medax_decimate_options, first_size: size_of::<medax_decimate_options>(),
    reserved: none, { triangles: u64 = 0, max_error: f64 = f64::INFINITY });

/// Sets decimate options to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_decimate_options_init(
    options: *mut medax_decimate_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// The same surface with fewer triangles: edges are contracted, the one of the least quadric error first.
///
/// Components, genus, boundary loops and orientation stay. Vertices on loose edges, on cells, on edges of
/// more than two triangles, or of several fans stay as they are. Loose edges, cells and their attributes
/// stay; attributes of vertices and faces are left out.
///
/// \param complex The complex; its faces become triangles first.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_decimated Receives the new complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`, also where the aim was missed; `INVALID_ARGUMENT` for a `max_error` that is
///         negative or NaN; `NULL_ARGUMENT`, `LIMIT_EXCEEDED`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(n log n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_decimate(
    complex: *const medax_complex,
    options: *const medax_decimate_options,
    job: *const medax_job,
    out_decimated: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let complex = &handle::get(complex, "complex")?.complex;
        let out = Out::new(out_decimated, "out_decimated")?;
        let given = options::read(options, "options")?;
        let options = DecimateOptions {
            triangles: usize::try_from(given.triangles).unwrap_or(usize::MAX),
            max_error: (given.max_error != f64::INFINITY).then_some(given.max_error),
        };
        let mut own = None;
        let decimated = complex.decimate(options, handle::job(job, &mut own))?;
        out.put(complex::give(Arc::new(decimated)));
        Ok(())
    })
}

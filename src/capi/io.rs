//! Reading and writing
//!
//! Written are PLY, OFF, OBJ, STL, XYZ, PTS, TXT, CSV, MA, VTU, and GeoJSON for plane complexes, by the ending of the path, to a
//! file beside the given name, which is moved into place when it is complete: after an error, a file
//! that was there before is as it was.

use super::boundary;
use super::complex;
use super::handle::{self, medax_complex, medax_job, medax_points, medax_warnings};
use super::options::{self, flag, sized_struct};
use super::points::medax_points_options;
use super::status::{c_text, medax_status};
use super::view::{self, Out};
use crate::Job;
use crate::error::Result;
use crate::io::{self, WriteOptions};
use std::ffi::c_char;
use std::ptr;
use std::sync::Arc;

/// Reads points: #medax_file_read and #medax_file_points in one.
///
/// \param path_utf8 The path.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_points Receives the points, which the caller frees with #medax_points_free.
/// \return As #medax_file_read and #medax_points_create_f64.
///
/// O(n log n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_points_read(
    path_utf8: *const c_char,
    options: *const medax_points_options,
    job: *const medax_job,
    out_points: *mut *const medax_points,
) -> medax_status {
    boundary::status(|| {
        let path = view::text(path_utf8, "path_utf8")?;
        let options = options::read(options, "options")?.translate()?;
        let out = Out::new(out_points, "out_points")?;
        let mut own = None;
        let points = io::read_points(path, options, handle::job(job, &mut own))?;
        out.put(handle::new(medax_points { points: Arc::new(points) }));
        Ok(())
    })
}

/// Reads a complex: #medax_file_read and #medax_file_complex in one.
///
/// \param path_utf8 The path.
/// \param job NULL for a default job.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return As #medax_file_read and #medax_file_complex.
///
/// O(n log n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_read(
    path_utf8: *const c_char,
    job: *const medax_job,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let path = view::text(path_utf8, "path_utf8")?;
        let out = Out::new(out_complex, "out_complex")?;
        let mut own = None;
        let complex = io::read_complex(path, handle::job(job, &mut own))?;
        out.put(complex::give(Arc::new(complex)));
        Ok(())
    })
}

/// How to write a file.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_write_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// 1 writes PLY as text; 0, the default: binary, little endian.
    pub text: u32,
    /// Must be 0.
    pub reserved: u32,
}

sized_struct!(medax_write_options, first_size: size_of::<medax_write_options>(),
    reserved: reserved, { text: u32 = 0, reserved: u32 = 0 });

/// Sets write options to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_write_options_init(
    options: *mut medax_write_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// Writes a complex. Numbers are written so that they read back to the same bits, save for STL, which
/// has single precision.
///
/// \param complex The complex.
/// \param path_utf8 The path.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_warnings Receives a sentence for each thing that the format cannot hold, which the
///        caller frees with #medax_warnings_free; or NULL.
/// \return `MEDAX_STATUS_OK`; `UNSUPPORTED` for an unknown ending, a format that is not written, or
///         one that can hold nothing of the complex; `COORDINATE_RANGE` with the vertex where single
///         precision is too small; `IO`; `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`,
///         `OUT_OF_MEMORY`.
///
/// O(n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_write(
    complex: *const medax_complex,
    path_utf8: *const c_char,
    options: *const medax_write_options,
    job: *const medax_job,
    out_warnings: *mut *const medax_warnings,
) -> medax_status {
    write(path_utf8, options, job, out_warnings, |path, options, job| {
        io::write_complex(path, &handle::get(complex, "complex")?.complex, options, job)
    })
}

/// Writes the distinct points in the order of their vertices.
///
/// \param points The points.
/// \param path_utf8 The path.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_warnings As for #medax_complex_write.
/// \return As #medax_complex_write.
///
/// O(n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_points_write(
    points: *const medax_points,
    path_utf8: *const c_char,
    options: *const medax_write_options,
    job: *const medax_job,
    out_warnings: *mut *const medax_warnings,
) -> medax_status {
    write(path_utf8, options, job, out_warnings, |path, options, job| {
        io::write_points(path, &handle::get(points, "points")?.points, options, job)
    })
}

unsafe fn write(
    path_utf8: *const c_char,
    options: *const medax_write_options,
    job: *const medax_job,
    out_warnings: *mut *const medax_warnings,
    write: impl FnOnce(&str, WriteOptions, &Job) -> Result<Vec<String>>,
) -> medax_status {
    boundary::status(|| {
        let path = view::text(path_utf8, "path_utf8")?;
        let options = options::read(options, "options")?;
        let options = WriteOptions { text: flag(options.text, "text")? };
        let mut own = None;
        let found = write(path, options, handle::job(job, &mut own))?;
        Out::maybe_with(out_warnings, || warnings(&found));
        Ok(())
    })
}

/// A handle on the sentences.
pub(super) fn warnings(texts: &[String]) -> *const medax_warnings {
    handle::new(medax_warnings { texts: texts.iter().map(|text| c_text(text)).collect() })
}

/// The number of warnings.
///
/// \param warnings The warnings; NULL has none.
/// \return The number of sentences.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_warnings_count(warnings: *const medax_warnings) -> usize {
    boundary::value(0, || handle::maybe(warnings).map_or(0, |w| w.texts.len()))
}

/// A warning.
///
/// \param warnings The warnings, or NULL.
/// \param index Which one, below #medax_warnings_count.
/// \return A sentence in UTF-8, borrowed from `warnings`; empty past the last one; never NULL.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_warnings_text(
    warnings: *const medax_warnings,
    index: usize,
) -> *const c_char {
    boundary::value(c"".as_ptr(), || {
        let text = handle::maybe(warnings).and_then(|w| w.texts.get(index));
        text.map_or(c"".as_ptr(), |text| text.as_ptr())
    })
}

/// One more reference to warnings.
///
/// \param warnings The warnings, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_warnings_clone(
    warnings: *const medax_warnings,
) -> *const medax_warnings {
    boundary::value(ptr::null(), || handle::clone(warnings))
}

/// Gives one reference to warnings back; the last one frees them.
///
/// \param warnings The warnings; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_warnings_free(warnings: *const medax_warnings) {
    boundary::value((), || handle::free(warnings));
}

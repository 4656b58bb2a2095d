//! Files
//!
//! The ending of a path names the format. Read: PLY (text, binary), OFF, OBJ, STL (text, binary),
//! XYZ, PTS, TXT and CSV (a row a line), PWN, MA (medial meshes). Written: PLY, OFF, OBJ, STL, XYZ,
//! PTS, TXT, CSV, MA, VTU. Paths are UTF-8.
//!
//! Reading trusts nothing, and an error names the line of a text or the byte of a binary file.
//! Writing goes to a file beside the given name, which is moved into place when it is complete:
//! after an error, a file that was there before is as it was.

use super::boundary;
use super::complex;
use super::handle::{self, medax_complex, medax_file, medax_job, medax_points, medax_warnings};
use super::options::{self, flag, sized_struct};
use super::points::medax_points_options;
use super::status::{c_text, medax_status};
use super::view::{self, Out, medax_view_f64, medax_view_rows, medax_view_u32};
use crate::error::Result;
use crate::io::{self, WriteOptions};
use crate::job::{Job, Stage};
use std::ffi::c_char;
use std::ptr;
use std::sync::Arc;

/// Reads the contents of a file, of which points or a complex can then be made.
///
/// \param path_utf8 The path.
/// \param job NULL for a default job.
/// \param out_file Receives the contents, which the caller frees with #medax_file_free.
/// \return `MEDAX_STATUS_OK`; `FORMAT` with the line or byte where the file is malformed or ends too
///         early; `UNSUPPORTED` for a kind of file that is not read; `IO`; `LIMIT_EXCEEDED` past
///         2^32 - 2 rows; `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`,
///         `OUT_OF_MEMORY`.
///
/// O(size of the file). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_file_read(
    path_utf8: *const c_char,
    job: *const medax_job,
    out_file: *mut *const medax_file,
) -> medax_status {
    boundary::status(|| {
        let path = view::text(path_utf8, "path_utf8")?;
        let out = Out::new(out_file, "out_file")?;
        let mut own = None;
        let soup = io::read(path, handle::job(job, &mut own))?;
        out.put(handle::new(medax_file { soup }));
        Ok(())
    })
}

/// Whether a file has a face or an edge; one without either is a set of points.
///
/// \param file The contents; NULL has none.
/// \return True for a mesh.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_file_is_mesh(file: *const medax_file) -> bool {
    boundary::value(false, || handle::maybe(file).is_some_and(|f| f.soup.is_mesh()))
}

/// The rows of a file's vertex table, as they are: they may be NaN.
///
/// \param file The contents, or NULL.
/// \return v x 3 coordinates. Borrowed from `file`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_file_vertices(file: *const medax_file) -> medax_view_f64 {
    boundary::value(medax_view_f64::new(&[], 3), || {
        let vertices = handle::maybe(file).map_or(&[][..], |f| f.soup.vertices());
        medax_view_f64::new(vertices.as_flattened(), 3)
    })
}

/// The faces of a file.
///
/// \param file The contents, or NULL.
/// \return One row a face: a ring of three vertices or more. Borrowed from `file`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_file_faces(file: *const medax_file) -> medax_view_rows {
    boundary::value(medax_view_rows::EMPTY, || {
        handle::maybe(file).map_or(medax_view_rows::EMPTY, |f| {
            medax_view_rows::new(f.soup.faces().offsets(), f.soup.faces().indices())
        })
    })
}

/// The edges that a file lists, sides of faces among them.
///
/// \param file The contents, or NULL.
/// \return e x 2 vertices. Borrowed from `file`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_file_edges(file: *const medax_file) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], 2), || {
        let edges = handle::maybe(file).map_or(&[][..], |f| f.soup.edges());
        medax_view_u32::new(edges.as_flattened(), 2)
    })
}

/// What was left out in reading a file.
///
/// \param file The contents.
/// \param out_warnings Receives the warnings, which the caller frees with #medax_warnings_free.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// O(warnings). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_file_warnings(
    file: *const medax_file,
    out_warnings: *mut *const medax_warnings,
) -> medax_status {
    boundary::status(|| {
        let file = handle::get(file, "file")?;
        let out = Out::new(out_warnings, "out_warnings")?;
        out.put(warnings(file.soup.warnings()));
        Ok(())
    })
}

/// Makes points of a file: of a mesh the vertices that a face or an edge uses, else all. Rows are
/// those of the file; an unused vertex maps to `MEDAX_NONE`.
///
/// \param file The contents.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_points Receives the points, which the caller frees with #medax_points_free.
/// \return As #medax_points_create_f64.
///
/// O(n log n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_file_points(
    file: *const medax_file,
    options: *const medax_points_options,
    job: *const medax_job,
    out_points: *mut *const medax_points,
) -> medax_status {
    boundary::status(|| {
        let file = handle::get(file, "file")?;
        let options = options::read(options, "options")?.translate()?;
        let out = Out::new(out_points, "out_points")?;
        let mut own = None;
        let points = file.soup.points(options, handle::job(job, &mut own))?;
        out.put(handle::new(medax_points { points: Arc::new(points) }));
        Ok(())
    })
}

/// Makes a complex of a file: all vertices, the faces, the edges that are no side of a face, the
/// attributes.
///
/// \param file The contents.
/// \param job NULL for a default job.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`; `NON_FINITE` with the row of a vertex; `FORMAT` with the face or edge
///         that repeats a vertex in succession; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`,
///         `OUT_OF_MEMORY`.
///
/// O(n log n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_file_complex(
    file: *const medax_file,
    job: *const medax_job,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let file = handle::get(file, "file")?;
        let out = Out::new(out_complex, "out_complex")?;
        let mut own = None;
        let complex = handle::job(job, &mut own).run(&[(Stage::Read, 1.0)], |run| {
            run.enter(Stage::Read)?;
            file.soup.clone().into_complex()
        })?;
        out.put(complex::give(Arc::new(complex)));
        Ok(())
    })
}

/// One more reference to a file's contents.
///
/// \param file The contents, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_file_clone(file: *const medax_file) -> *const medax_file {
    boundary::value(ptr::null(), || handle::clone(file))
}

/// Gives one reference to a file's contents back; the last one frees them.
///
/// \param file The contents; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_file_free(file: *const medax_file) {
    boundary::value((), || handle::free(file));
}

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

fn warnings(texts: &[String]) -> *const medax_warnings {
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

//! File contents
//!
//! What a file holds, before points or a complex are made of it. Reading trusts nothing, and an error
//! names the line of a text or the byte of a binary file. The ending of a path names the format:
//! PLY (text, binary), OFF, OBJ, STL (text, binary), XYZ, PTS, TXT and CSV (a row a line), PWN, MA
//! (medial meshes). Plane figures are read by #medax_figure_read. Paths are UTF-8.

use super::attribute::{self, medax_attribute};
use super::boundary;
use super::complex;
use super::handle::{self, medax_complex, medax_file, medax_job, medax_points, medax_warnings};
use super::io::warnings;
use super::options;
use super::points::medax_points_options;
use super::status::medax_status;
use super::view::{self, Out, medax_view_f64, medax_view_rows, medax_view_u32};
use crate::io;
use crate::job::Stage;
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
        let names = attribute::names(soup.attributes());
        out.put(handle::new(medax_file { soup, names }));
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

/// The number of attributes of a file.
///
/// \param file The contents; NULL has none.
/// \return The number of attributes, over all kinds of elements.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_file_attribute_count(file: *const medax_file) -> usize {
    boundary::value(0, || handle::maybe(file).map_or(0, |f| f.names.len()))
}

/// An attribute of a file by its number.
///
/// \param file The contents.
/// \param index Which attribute, below #medax_file_attribute_count.
/// \param out_attribute Receives the attribute, whose name and values are borrowed from `file`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` past the last attribute.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_file_attribute_at(
    file: *const medax_file,
    index: usize,
    out_attribute: *mut medax_attribute,
) -> medax_status {
    boundary::status(|| {
        let file = handle::get(file, "file")?;
        let out = Out::new(out_attribute, "out_attribute")?;
        out.put(attribute::at(file.soup.attributes(), &file.names, index)?);
        Ok(())
    })
}

/// The attribute of a file with the given name.
///
/// \param file The contents.
/// \param element A #medax_element: what carries the attribute.
/// \param name The name, such as `weight`; UTF-8.
/// \param out_attribute Receives the attribute, whose name and values are borrowed from `file`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` if there is none.
///
/// O(attributes). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_file_attribute(
    file: *const medax_file,
    element: u32,
    name: *const c_char,
    out_attribute: *mut medax_attribute,
) -> medax_status {
    boundary::status(|| {
        let file = handle::get(file, "file")?;
        let name = view::text(name, "name")?;
        let out = Out::new(out_attribute, "out_attribute")?;
        out.put(attribute::named(file.soup.attributes(), &file.names, element, name)?);
        Ok(())
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

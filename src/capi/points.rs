//! Points
//!
//! They are checked, merged where they coincide, and put into spatial order.
//!
//! The distinct points are the vertices of everything built from them, numbered by spatial rank:
//! the numbers depend on the set of points alone. The rows of the caller's array appear only in
//! the maps. Coordinates are in the caller's units. They must be 0 or have an absolute value
//! from 2^-160 to 2^200; there may be 2^28 rows.

use super::boundary;
use super::handle::{self, medax_job, medax_points};
use super::options::{self, flag, sized_struct};
use super::status::medax_status;
use super::view::{self, Out, medax_view_f64, medax_view_u32};
use crate::Result;
use crate::points::{Points, PointsOptions};
use std::ptr;
use std::sync::Arc;

/// What to do with rows that are not numbers, and the like.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_points_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// 1 leaves rows with a NaN or an infinity out; they map to `MEDAX_NONE`. 0, the default:
    /// they are an error.
    pub skip_non_finite: u32,
    /// Must be 0.
    pub reserved: u32,
}

sized_struct!(medax_points_options, first_size: size_of::<medax_points_options>(),
    reserved: reserved, { skip_non_finite: u32 = 0, reserved: u32 = 0 });

impl medax_points_options {
    pub(super) fn translate(&self) -> Result<PointsOptions> {
        Ok(PointsOptions { skip_non_finite: flag(self.skip_non_finite, "skip_non_finite")? })
    }
}

/// Sets points options to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_points_options_init(
    options: *mut medax_points_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// Makes points of the caller's array of doubles, which is copied.
///
/// \param xyz `count` points of three coordinates, `stride_bytes` apart; need not be aligned. Several threads read
///        them, and they must not change during the call.
///        NULL only if `count` is 0.
/// \param count The number of rows.
/// \param stride_bytes The distance between rows in bytes, at least 24; 0 stands for 24.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_points Receives the points, which the caller frees with #medax_points_free.
/// \return `MEDAX_STATUS_OK`; `NON_FINITE` or `COORDINATE_RANGE` with the row; `TOO_FEW_POINTS`
///         when no row is left; `LIMIT_EXCEEDED` past 2^28 rows; `NULL_ARGUMENT`,
///         `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(n log n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_points_create_f64(
    xyz: *const f64,
    count: usize,
    stride_bytes: usize,
    options: *const medax_points_options,
    job: *const medax_job,
    out_points: *mut *const medax_points,
) -> medax_status {
    create(xyz, count, stride_bytes, options, job, out_points)
}

/// Makes points of the caller's array of floats, which is copied; otherwise as
/// #medax_points_create_f64.
///
/// \param xyz `count` points of three coordinates, `stride_bytes` apart; need not be aligned.
///        NULL only if `count` is 0.
/// \param count The number of rows.
/// \param stride_bytes The distance between rows in bytes, at least 12; 0 stands for 12.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_points Receives the points, which the caller frees with #medax_points_free.
/// \return As #medax_points_create_f64.
///
/// O(n log n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_points_create_f32(
    xyz: *const f32,
    count: usize,
    stride_bytes: usize,
    options: *const medax_points_options,
    job: *const medax_job,
    out_points: *mut *const medax_points,
) -> medax_status {
    create(xyz, count, stride_bytes, options, job, out_points)
}

unsafe fn create<T: Copy + Into<f64>>(
    xyz: *const T,
    count: usize,
    stride_bytes: usize,
    options: *const medax_points_options,
    job: *const medax_job,
    out_points: *mut *const medax_points,
) -> medax_status {
    boundary::status(|| {
        let out = Out::new(out_points, "out_points")?;
        let options = options::read(options, "options")?.translate()?;
        let (count, row) = view::points(xyz, count, stride_bytes, "xyz")?;
        let mut own = None;
        let points = Points::by_row(count, row, options, handle::job(job, &mut own))?;
        out.put(handle::new(medax_points { points: Arc::new(points) }));
        Ok(())
    })
}

/// The distinct points in spatial order: the vertices.
///
/// \param points The points, or NULL.
/// \return n x 3 coordinates. Borrowed from `points`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_points_coords(points: *const medax_points) -> medax_view_f64 {
    let coords = || handle::maybe(points).map_or(&[][..], |p| p.points.coords());
    boundary::value(medax_view_f64::new(&[], 3), || medax_view_f64::new(coords().as_flattened(), 3))
}

/// The vertex of each row of the input.
///
/// \param points The points, or NULL.
/// \return Rows x 1: a vertex, or `MEDAX_NONE` for a row left out. Borrowed from `points`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_points_vertex_of_row(points: *const medax_points) -> medax_view_u32 {
    indices(points, Points::vertex_of_row)
}

/// The first row of the input at each vertex.
///
/// \param points The points, or NULL.
/// \return n x 1 rows. Borrowed from `points`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_points_row_of_vertex(points: *const medax_points) -> medax_view_u32 {
    indices(points, Points::row_of_vertex)
}

/// The rows of the input that repeat an earlier one.
///
/// \param points The points, or NULL.
/// \return Rows x 1: the first row with the same coordinates; `MEDAX_NONE` where the row is itself
///         the first, or was left out. Borrowed from `points`.
///
/// Made by the first call, in linear time; empty if there is no memory for it. Constant time afterwards. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_points_duplicate_of(points: *const medax_points) -> medax_view_u32 {
    indices(points, Points::duplicate_of)
}

unsafe fn indices(points: *const medax_points, read: fn(&Points) -> &[u32]) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], 1), || {
        medax_view_u32::new(handle::maybe(points).map_or(&[][..], |p| read(&p.points)), 1)
    })
}

/// The number of distinct points.
///
/// \param points The points; NULL has none.
/// \return The number of vertices.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_points_count(points: *const medax_points) -> usize {
    count(points, Points::len)
}

/// The number of rows of the input.
///
/// \param points The points; NULL has none.
/// \return The number of rows, those left out included.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_points_row_count(points: *const medax_points) -> usize {
    count(points, Points::row_count)
}

/// The number of rows of the input that repeat an earlier one.
///
/// \param points The points; NULL has none.
/// \return The number of rows that #medax_points_duplicate_of maps to another one.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_points_duplicate_count(points: *const medax_points) -> usize {
    count(points, Points::duplicate_count)
}

/// The number of rows of the input that were left out.
///
/// \param points The points; NULL has none.
/// \return The number of rows that map to no vertex.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_points_skipped_count(points: *const medax_points) -> usize {
    count(points, Points::skipped_count)
}

unsafe fn count(points: *const medax_points, read: fn(&Points) -> usize) -> usize {
    boundary::value(0, || handle::maybe(points).map_or(0, |p| read(&p.points)))
}

/// The smallest box that holds every point.
///
/// \param points The points.
/// \param out_min Receives the three least coordinates.
/// \param out_max Receives the three greatest coordinates.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_points_bounds(
    points: *const medax_points,
    out_min: *mut f64,
    out_max: *mut f64,
) -> medax_status {
    boundary::status(|| {
        let bounds = handle::get(points, "points")?.points.bounds();
        let min = Out::new(out_min.cast::<[f64; 3]>(), "out_min")?;
        let max = Out::new(out_max.cast::<[f64; 3]>(), "out_max")?;
        min.put(bounds.min);
        max.put(bounds.max);
        Ok(())
    })
}

/// One more reference to points.
///
/// \param points The points, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_points_clone(points: *const medax_points) -> *const medax_points {
    boundary::value(ptr::null(), || handle::clone(points))
}

/// Gives one reference to points back; the last one frees them.
///
/// \param points The points; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_points_free(points: *const medax_points) {
    boundary::value((), || handle::free(points));
}

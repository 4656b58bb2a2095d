//! Distance
//!
//! What of some sites is nearest to points, all that is as near, and whether points lie inside.

use super::boundary;
use super::handle::{self, medax_all_nearest, medax_job, medax_sites};
use super::status::medax_status;
use super::view::{self, Buffer, Out, medax_view_f64, medax_view_rows, medax_view_u32};
use crate::complex::Rows;
use crate::distance::{AllNearest, Nearest, Sites};
use crate::error::Result;
use crate::job::{Room, Run, Stage};
use std::ptr;

/// What is nearest to a point.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct medax_nearest {
    /// The nearest point of the boundary.
    pub point: [f64; 3],
    /// How far away it is, in input units.
    pub distance: f64,
    /// The way there, of length 1; 0 from a point of the boundary. The gradient of the negative distance, where it has one.
    pub direction: [f64; 3],
    /// The piece whose point it is, of several the least.
    pub piece: u32,
    /// The site of that piece.
    pub site: u32,
}

impl medax_nearest {
    fn new(nearest: &Nearest, sites: &Sites) -> Self {
        let Nearest { point, distance, direction, piece } = *nearest;
        let site = sites.site_of_piece()[piece as usize];
        medax_nearest { point, distance, direction, piece, site }
    }
}

/// What is nearest to each of some points.
///
/// \param sites The sites.
/// \param query_xyz `query_count` x 3 coordinates, z in the plane as well; NULL only if `query_count` is 0.
/// \param query_count The number of points.
/// \param job NULL for a default job.
/// \param out_nearest Receives `query_count` answers; the caller's buffer, NULL only if `query_count` is 0.
/// \return `MEDAX_STATUS_OK`; `NON_FINITE`, or `COORDINATE_RANGE` beyond 2^200, with the row of a query;
///         `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// About O(log n) a query. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_sites_nearest(
    sites: *const medax_sites,
    query_xyz: *const f64,
    query_count: usize,
    job: *const medax_job,
    out_nearest: *mut medax_nearest,
) -> medax_status {
    boundary::status(|| {
        let sites = &handle::get(sites, "sites")?.sites;
        let queries = view::rows(query_xyz, query_count, "query_xyz")?;
        let out = Buffer::new(out_nearest, query_count, "out_nearest")?;
        let mut own = None;
        let nearest = sites.nearest(queries, handle::job(job, &mut own))?;
        out.fill_with(nearest.iter().map(|nearest| medax_nearest::new(nearest, sites)));
        Ok(())
    })
}

/// Whether each of some points lies inside: in the plane where a ray from there crosses closed curves an odd number of times, decided
/// exactly; in space where the faces of the mesh wind round it more than half a time. Nothing lies inside of anything else.
///
/// \param sites The sites.
/// \param query_xyz `query_count` x 3 coordinates, z in the plane as well; NULL only if `query_count` is 0.
/// \param query_count The number of points.
/// \param job NULL for a default job.
/// \param out_is_inside Receives `query_count` flags, 0 or 1; the caller's buffer, NULL only if `query_count` is 0.
/// \return `MEDAX_STATUS_OK`; `NON_FINITE`, or `COORDINATE_RANGE` beyond 2^200, with the row of a query;
///         `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// About O(log n) a query, and O(n log n) once a call for a mesh. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_sites_is_inside(
    sites: *const medax_sites,
    query_xyz: *const f64,
    query_count: usize,
    job: *const medax_job,
    out_is_inside: *mut u8,
) -> medax_status {
    boundary::status(|| {
        let sites = &handle::get(sites, "sites")?.sites;
        let queries = view::rows(query_xyz, query_count, "query_xyz")?;
        let out = Buffer::new(out_is_inside, query_count, "out_is_inside")?;
        let mut own = None;
        out.fill_from(&sites.is_inside(queries, handle::job(job, &mut own))?);
        Ok(())
    })
}

/// [`AllNearest`] as columns, which C sees as they lie.
pub struct AllColumns {
    pieces: Rows,
    sites: Vec<u32>,
    points: Vec<[f64; 3]>,
    distances: Vec<f64>,
    directions: Vec<[f64; 3]>,
}

impl AllColumns {
    fn new(all: AllNearest, sites: &Sites, run: &Run<'_>) -> Result<Self> {
        run.enter(Stage::Extract)?;
        let mut room = Room::new(run);
        let AllNearest { offsets, feet } = all;
        let pieces = room.collect(feet.iter().map(|foot| foot.piece))?;
        let site = |foot: &Nearest| sites.site_of_piece()[foot.piece as usize];
        Ok(AllColumns {
            pieces: Rows::new(offsets, pieces)?,
            sites: room.collect(feet.iter().map(site))?,
            points: room.collect(feet.iter().map(|foot| foot.point))?,
            distances: room.collect(feet.iter().map(|foot| foot.distance))?,
            directions: room.collect(feet.iter().map(|foot| foot.direction))?,
        })
    }
}

/// All nearest points of the boundary, for each of some points: those of all pieces that are no farther away than the nearest one is and a
/// tolerance.
///
/// \param sites The sites.
/// \param query_xyz `query_count` x 3 coordinates, z in the plane as well; NULL only if `query_count` is 0.
/// \param query_count The number of points.
/// \param tolerance A length in input units, not negative.
/// \param job NULL for a default job.
/// \param out_all_nearest Receives the answers, which the caller frees with #medax_all_nearest_free.
/// \return `MEDAX_STATUS_OK`; `NON_FINITE`, or `COORDINATE_RANGE` beyond 2^200, with the row of a query; `INVALID_ARGUMENT` for a tolerance
///         that is negative or NaN; `LIMIT_EXCEEDED` past 2^32 - 1 nearest points in all; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`,
///         `OUT_OF_MEMORY`.
///
/// About O(log n + size) a query. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_sites_all_nearest(
    sites: *const medax_sites,
    query_xyz: *const f64,
    query_count: usize,
    tolerance: f64,
    job: *const medax_job,
    out_all_nearest: *mut *const medax_all_nearest,
) -> medax_status {
    boundary::status(|| {
        let sites = &handle::get(sites, "sites")?.sites;
        let queries = view::rows(query_xyz, query_count, "query_xyz")?;
        let out = Out::new(out_all_nearest, "out_all_nearest")?;
        let mut own = None;
        let stages = [(Stage::Query, 0.9), (Stage::Extract, 0.1)];
        let all = handle::job(job, &mut own).run(&stages, |run| {
            AllColumns::new(sites.all_nearest_in(queries, tolerance, run)?, sites, run)
        })?;
        out.put(handle::new(medax_all_nearest { all }));
        Ok(())
    })
}

/// The pieces whose points are nearest to each query.
///
/// \param all_nearest The answers, or NULL.
/// \return One row a query: pieces, which ascend. All other arrays have a row for each of these, one query's after the other's. Borrowed
///         from `all_nearest`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_all_nearest_pieces(
    all_nearest: *const medax_all_nearest,
) -> medax_view_rows {
    boundary::value(medax_view_rows::EMPTY, || {
        handle::maybe(all_nearest).map_or(medax_view_rows::EMPTY, |a| {
            medax_view_rows::new(a.all.pieces.offsets(), a.all.pieces.indices())
        })
    })
}

/// The sites of these pieces.
///
/// \param all_nearest The answers, or NULL.
/// \return m x 1 sites. Borrowed from `all_nearest`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_all_nearest_sites(
    all_nearest: *const medax_all_nearest,
) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], 1), || {
        let sites = handle::maybe(all_nearest).map_or(&[][..], |a| &a.all.sites);
        medax_view_u32::new(sites, 1)
    })
}

/// The nearest points.
///
/// \param all_nearest The answers, or NULL.
/// \return m x 3 coordinates. Borrowed from `all_nearest`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_all_nearest_points(
    all_nearest: *const medax_all_nearest,
) -> medax_view_f64 {
    floats(all_nearest, 3, |all| all.points.as_flattened())
}

/// The distances of the nearest points.
///
/// \param all_nearest The answers, or NULL.
/// \return m x 1, in input units. Borrowed from `all_nearest`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_all_nearest_distances(
    all_nearest: *const medax_all_nearest,
) -> medax_view_f64 {
    floats(all_nearest, 1, |all| &all.distances)
}

/// The ways to the nearest points.
///
/// \param all_nearest The answers, or NULL.
/// \return m x 3 coordinates: vectors of length 1, and of length 0 from a point of the boundary. Borrowed from `all_nearest`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_all_nearest_directions(
    all_nearest: *const medax_all_nearest,
) -> medax_view_f64 {
    floats(all_nearest, 3, |all| all.directions.as_flattened())
}

unsafe fn floats(
    all_nearest: *const medax_all_nearest,
    cols: usize,
    read: fn(&AllColumns) -> &[f64],
) -> medax_view_f64 {
    boundary::value(medax_view_f64::new(&[], cols), || {
        medax_view_f64::new(handle::maybe(all_nearest).map_or(&[][..], |a| read(&a.all)), cols)
    })
}

/// One more reference to answers.
///
/// \param all_nearest The answers, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_all_nearest_clone(
    all_nearest: *const medax_all_nearest,
) -> *const medax_all_nearest {
    boundary::value(ptr::null(), || handle::clone(all_nearest))
}

/// Gives one reference to answers back; the last one frees them.
///
/// \param all_nearest The answers; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_all_nearest_free(all_nearest: *const medax_all_nearest) {
    boundary::value((), || handle::free(all_nearest));
}

//! Balls
//!
//! Unions of balls, such as those of a medial axis, which are the solid again: how far points are from one, and its boundary as a mesh.
//! (Edelsbrunner 1995, The union of balls and its dual shape.)

use super::boundary;
use super::complex;
use super::handle::{self, medax_balls, medax_complex, medax_job};
use super::options::{self, sized_struct};
use super::status::medax_status;
use super::view::{self, Buffer, Out, medax_view_f64};
use crate::distance::{Balls, BoundaryOptions};
use crate::job::{Room, Stage};
use std::ptr;
use std::sync::Arc;

/// Makes balls of the caller's centres and radii, which are copied. They may overlap, lie in each other and repeat each other.
///
/// \param center_xyz `center_count` x 3 coordinates, up to 2^194 in absolute value.
/// \param center_count The number of balls, from 1 to 2^28 - 8.
/// \param radii `radius_count` radii in input units, from 2^-160 to 2^194.
/// \param radius_count As many.
/// \param job NULL for a default job.
/// \param out_balls Receives the balls, which the caller frees with #medax_balls_free.
/// \return `MEDAX_STATUS_OK`; with the row of a ball: `NON_FINITE`, `COORDINATE_RANGE`, and `INVALID_ARGUMENT` for a radius that is not
///         positive; `MISMATCH` unless each centre has a radius; `TOO_FEW_POINTS` without any; `LIMIT_EXCEEDED` for too many;
///         `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(n log n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_balls_create(
    center_xyz: *const f64,
    center_count: usize,
    radii: *const f64,
    radius_count: usize,
    job: *const medax_job,
    out_balls: *mut *const medax_balls,
) -> medax_status {
    boundary::status(|| {
        let centers = view::rows::<f64, 3>(center_xyz, center_count, "center_xyz")?;
        let radii = view::slice(radii, radius_count, "radii")?;
        let out = Out::new(out_balls, "out_balls")?;
        let mut own = None;
        let balls = handle::job(job, &mut own).run(&[(Stage::Order, 1.0)], |run| {
            let mut room = Room::new(run);
            let centers = room.collect(centers.iter().copied())?;
            Balls::new_in(centers, room.collect(radii.iter().copied())?, run)
        })?;
        out.put(handle::new(medax_balls { balls }));
        Ok(())
    })
}

/// Balls round the vertices of a complex, which carry `radius`, as those of any medial axis do. Faces and edges count for nothing.
///
/// \param complex The complex, of which a copy is made.
/// \param job NULL for a default job.
/// \param out_balls Receives the balls, which the caller frees with #medax_balls_free.
/// \return `MEDAX_STATUS_OK`; `MISMATCH` where vertices carry no `radius`; with a vertex for the row what #medax_balls_create returns.
///
/// O(n log n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_balls_of_complex(
    complex: *const medax_complex,
    job: *const medax_job,
    out_balls: *mut *const medax_balls,
) -> medax_status {
    boundary::status(|| {
        let complex = &handle::get(complex, "complex")?.complex;
        let out = Out::new(out_balls, "out_balls")?;
        let mut own = None;
        let balls = Balls::of_complex(complex, handle::job(job, &mut own))?;
        out.put(handle::new(medax_balls { balls }));
        Ok(())
    })
}

/// The number of balls.
///
/// \param balls The balls; NULL has none.
/// \return The number of balls.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_balls_count(balls: *const medax_balls) -> usize {
    boundary::value(0, || handle::maybe(balls).map_or(0, |b| b.balls.len()))
}

/// The centres.
///
/// \param balls The balls, or NULL.
/// \return n x 3 coordinates. Borrowed from `balls`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_balls_centers(balls: *const medax_balls) -> medax_view_f64 {
    floats(balls, 3, |balls| balls.centers().as_flattened())
}

/// The radii.
///
/// \param balls The balls, or NULL.
/// \return n x 1, in input units. Borrowed from `balls`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_balls_radii(balls: *const medax_balls) -> medax_view_f64 {
    floats(balls, 1, Balls::radii)
}

unsafe fn floats(
    balls: *const medax_balls,
    cols: usize,
    read: fn(&Balls) -> &[f64],
) -> medax_view_f64 {
    boundary::value(medax_view_f64::new(&[], cols), || {
        medax_view_f64::new(handle::maybe(balls).map_or(&[][..], |b| read(&b.balls)), cols)
    })
}

/// The smallest box that holds all balls.
///
/// \param balls The balls.
/// \param out_min Receives the three least coordinates.
/// \param out_max Receives the three greatest coordinates.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// O(n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_balls_bounds(
    balls: *const medax_balls,
    out_min: *mut f64,
    out_max: *mut f64,
) -> medax_status {
    boundary::status(|| {
        let balls = &handle::get(balls, "balls")?.balls;
        let min = Out::new(out_min.cast::<[f64; 3]>(), "out_min")?;
        let max = Out::new(out_max.cast::<[f64; 3]>(), "out_max")?;
        let bounds = balls.bounds();
        min.put(bounds.min);
        max.put(bounds.max);
        Ok(())
    })
}

/// For each of some points x the least of |x - c| - r over all balls: negative inside the union, 0 on its boundary, outside the distance to
/// it. Inside it is no distance, but how deep the point is in the ball in which it is deepest, which is at most that.
///
/// \param balls The balls.
/// \param query_xyz `query_count` x 3 coordinates; NULL only if `query_count` is 0.
/// \param query_count The number of points.
/// \param job NULL for a default job.
/// \param out_distances Receives `query_count` numbers in input units; the caller's buffer, NULL only if `query_count` is 0.
/// \return `MEDAX_STATUS_OK`; `NON_FINITE`, or `COORDINATE_RANGE` beyond 2^200, with the row of a query; `NULL_ARGUMENT`,
///         `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// About O(log n) a query where the radii of neighbours are alike. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_balls_distances(
    balls: *const medax_balls,
    query_xyz: *const f64,
    query_count: usize,
    job: *const medax_job,
    out_distances: *mut f64,
) -> medax_status {
    boundary::status(|| {
        let balls = &handle::get(balls, "balls")?.balls;
        let queries = view::rows(query_xyz, query_count, "query_xyz")?;
        let out = Buffer::new(out_distances, query_count, "out_distances")?;
        let mut own = None;
        out.fill(&balls.distances(queries, handle::job(job, &mut own))?);
        Ok(())
    })
}

/// How fine the boundary of a union of balls is.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_boundary_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// No point of the boundary is farther than this from a sample, in input units. 0, the default, asks for a hundredth of the diagonal of
    /// #medax_balls_bounds. On smaller balls it is halved until it is no more than the radius.
    pub spacing: f64,
}

sized_struct!(medax_boundary_options, first_size: size_of::<medax_boundary_options>(),
    reserved: none, { spacing: f64 = 0.0 });

/// Sets the options of boundaries to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_boundary_options_init(
    options: *mut medax_boundary_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// The boundary of the union as a mesh of triangles that points out of it.
///
/// The mesh is closed; each edge has two triangles, four where the mesh touches itself. Every vertex lies on the sphere of the ball that
/// its attribute `ball` names, and in no ball, up to rounding; every point of the mesh is within the spacing of the boundary. What is thinner
/// than the spacing, be it of the solid or of what lies between its parts, may be closed or cut. Balls with a radius of less than 2^-40 of
/// the largest coordinate are left out.
///
/// \param balls The balls.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_complex Receives the mesh, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for a spacing that is no length; `COORDINATE_RANGE` where all balls are left out;
///         `LIMIT_EXCEEDED` for more than 2^28 samples; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(n log n + m log m) for m samples in practice; where all balls meet, O(n^2). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_balls_boundary(
    balls: *const medax_balls,
    options: *const medax_boundary_options,
    job: *const medax_job,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let balls = &handle::get(balls, "balls")?.balls;
        let medax_boundary_options { spacing, .. } = options::read(options, "options")?;
        let out = Out::new(out_complex, "out_complex")?;
        let mut own = None;
        let options = BoundaryOptions { spacing };
        let mesh = balls.boundary(options, handle::job(job, &mut own))?;
        out.put(complex::give(Arc::new(mesh)));
        Ok(())
    })
}

/// One more reference to balls.
///
/// \param balls The balls, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_balls_clone(balls: *const medax_balls) -> *const medax_balls {
    boundary::value(ptr::null(), || handle::clone(balls))
}

/// Gives one reference to balls back; the last one frees them.
///
/// \param balls The balls; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_balls_free(balls: *const medax_balls) {
    boundary::value((), || handle::free(balls));
}

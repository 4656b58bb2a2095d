//! Poles
//!
//! The first pole of a sample is the farthest vertex of its Voronoi cell, the second the farthest one
//! on the other side. A Voronoi vertex that several samples choose is one pole. The ball round a
//! pole that passes through its samples is its polar ball. The Voronoi cell of a sample on the hull is
//! unbounded: its first pole is at infinity, and is no row of the balls.
//!
//! Poles with the far box are those of the power crust: eight points far round the sample make
//! every Voronoi cell bounded. These eight are in no count but those of #medax_poles_triangulation.

use super::boundary;
use super::complex;
use super::handle::{
    self, medax_complex, medax_dual, medax_job, medax_points, medax_poles, medax_triangulation,
};
use super::options::{self, sized_struct};
use super::status::medax_status;
use super::validation::{self, medax_validation};
use super::view::{
    self, Buffer, Out, medax_view_f64, medax_view_rows, medax_view_u8, medax_view_u32,
};
use crate::error::{Error, Result, Status};
use crate::poles::{Omit, Poles, PolesOptions};
use std::ptr;
use std::sync::Arc;

/// What is left out where the Voronoi cell of a sample is not long and thin: where one of its poles is nearer than the cell's
/// width allows for the spacing `lambda` (section 6 of the paper).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum medax_omit {
    /// Nothing.
    Nothing = 0,
    /// The pole that is too near: for noise.
    Side = 1,
    /// Both poles of the sample where one is too near: for sharp edges and corners.
    Both = 2,
}

impl From<Omit> for medax_omit {
    fn from(omit: Omit) -> Self {
        match omit {
            Omit::Nothing => medax_omit::Nothing,
            Omit::Side => medax_omit::Side,
            Omit::Both => medax_omit::Both,
        }
    }
}

/// Which poles are left out, from numbers of the caller.
pub(super) fn omission(omit: u32, lambda: f64) -> Result<PolesOptions> {
    let omit = [Omit::Nothing, Omit::Side, Omit::Both]
        .into_iter()
        .find(|&known| medax_omit::from(known) as u32 == omit)
        .ok_or_else(|| Error::new(Status::InvalidArgument, format!("{omit} is no medax_omit")))?;
    Ok(PolesOptions { omit, lambda })
}

/// The settings of poles.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_poles_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// An estimate of the spacing of the sample, relative to the local feature size, in [0, pi/4); 0, the default, to estimate it
    /// from the sample. Without effect where nothing is left out.
    pub lambda: f64,
    /// A #medax_omit: what is left out; `MEDAX_OMIT_NOTHING` by default.
    pub omit: u32,
    /// Must be 0.
    pub reserved: u32,
}

sized_struct!(medax_poles_options,
    first_size: size_of::<medax_poles_options>(), reserved: reserved,
    { lambda: f64 = 0.0, omit: u32 = 0, reserved: u32 = 0 });

impl medax_poles_options {
    fn translate(&self) -> Result<PolesOptions> {
        omission(self.omit, self.lambda)
    }
}

/// Sets poles options to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_poles_options_init(
    options: *mut medax_poles_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// Builds the poles of a sample from its Voronoi diagram.
///
/// \param dual The dual of a Delaunay triangulation.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_poles Receives the poles, which the caller frees with #medax_poles_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for the dual of a regular triangulation and for options out of range;
///         `TOO_FEW_POINTS` where all poles would be left out;
///         `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(m) for m cells. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_poles_build(
    dual: *const medax_dual,
    options: *const medax_poles_options,
    job: *const medax_job,
    out_poles: *mut *const medax_poles,
) -> medax_status {
    boundary::status(|| {
        let dual = &handle::get(dual, "dual")?.dual;
        let options = options::read(options, "options")?.translate()?;
        let out = Out::new(out_poles, "out_poles")?;
        let mut own = None;
        let poles = Poles::new(dual, options, handle::job(job, &mut own))?;
        out.put(handle::new(medax_poles { poles: Arc::new(poles) }));
        Ok(())
    })
}

/// Builds the poles of a sample with the far box: those from which a power crust is made.
///
/// \param points The sample.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_poles Receives the poles, which the caller frees with #medax_poles_free.
/// \return `MEDAX_STATUS_OK`; `TOO_FEW_POINTS` below four distinct points, or where all poles would be left out; `DEGENERATE` when all
///         lie in a plane; `COORDINATE_RANGE` where there is no room for the far box;
///         `LIMIT_EXCEEDED` past 2^30 cells; `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`,
///         `BUSY`, `OUT_OF_MEMORY`.
///
/// One Delaunay triangulation, then O(m log m) for its m cells. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_poles_build_with_far_box(
    points: *const medax_points,
    options: *const medax_poles_options,
    job: *const medax_job,
    out_poles: *mut *const medax_poles,
) -> medax_status {
    boundary::status(|| {
        let points = handle::get(points, "points")?;
        let options = options::read(options, "options")?.translate()?;
        let out = Out::new(out_poles, "out_poles")?;
        let mut own = None;
        let poles = Poles::with_far_box(&points.points, options, handle::job(job, &mut own))?;
        out.put(handle::new(medax_poles { poles: Arc::new(poles) }));
        Ok(())
    })
}

/// The triangulation whose cells' circumcentres the poles are.
///
/// \param poles The poles.
/// \param out_triangulation Receives the triangulation, which the caller frees with
///        #medax_triangulation_free. Its vertices are the samples, and after them the far box if
///        there is one.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_poles_triangulation(
    poles: *const medax_poles,
    out_triangulation: *mut *const medax_triangulation,
) -> medax_status {
    boundary::status(|| {
        let poles = &handle::get(poles, "poles")?.poles;
        let out = Out::new(out_triangulation, "out_triangulation")?;
        let triangulation = poles.triangulation().clone();
        out.put(handle::new(medax_triangulation { triangulation }));
        Ok(())
    })
}

/// Whether the poles were chosen with the far box.
///
/// \param poles The poles; NULL was not.
/// \return True for the poles of a power crust.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_poles_has_far_box(poles: *const medax_poles) -> bool {
    boundary::value(false, || handle::maybe(poles).is_some_and(|p| p.poles.has_far_box()))
}

/// The polar balls. Poles are numbered by the spatial rank of their centres.
///
/// \param poles The poles, or NULL.
/// \return p x 4: the three coordinates of the centre and the radius, in input units. Borrowed from
///         `poles`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_poles_balls(poles: *const medax_poles) -> medax_view_f64 {
    floats(poles, 4, |p| p.balls().as_flattened())
}

/// The squared radius of each polar ball, rounded once: the weight of the pole in the power
/// diagram.
///
/// \param poles The poles, or NULL.
/// \return p x 1, in squared input units. Borrowed from `poles`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_poles_radii_squared(poles: *const medax_poles) -> medax_view_f64 {
    floats(poles, 1, Poles::radii_squared)
}

/// The cell of #medax_poles_triangulation whose circumcentre each pole is.
///
/// \param poles The poles, or NULL.
/// \return p x 1 cells: the least chosen one if several have the same circumsphere. Borrowed from
///         `poles`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_poles_cell_of_pole(poles: *const medax_poles) -> medax_view_u32 {
    indices(poles, 1, Poles::cell_of_pole)
}

/// Whether the Delaunay cell of each pole has a corner of the far box: such poles are outer from the
/// start.
///
/// \param poles The poles, or NULL.
/// \return p x 1 flags, 0 or 1. Borrowed from `poles`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_poles_touches_far_box(poles: *const medax_poles) -> medax_view_u8 {
    boundary::value(medax_view_u8::of_flags(&[]), || {
        medax_view_u8::of_flags(handle::maybe(poles).map_or(&[][..], |p| p.poles.touches_far_box()))
    })
}

/// The poles of each sample.
///
/// \param poles The poles, or NULL.
/// \return n x 2: the first and second pole of each vertex of the points; `MEDAX_NONE` where there is
///         none, or it is at infinity, or left out. Borrowed from `poles`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_poles_pole_of_sample(poles: *const medax_poles) -> medax_view_u32 {
    indices(poles, 2, |p| p.pole_of_sample().as_flattened())
}

/// The samples on each polar ball, ascending: those whose Voronoi cells meet at the pole.
///
/// \param poles The poles, or NULL.
/// \return p rows of vertices of the points: four or more, or fewer where the ball touches the far box. Borrowed from `poles`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_poles_samples_on_balls(
    poles: *const medax_poles,
) -> medax_view_rows {
    boundary::value(medax_view_rows::EMPTY, || {
        handle::maybe(poles).map_or(medax_view_rows::EMPTY, |p| {
            let rows = p.poles.samples_on_balls();
            medax_view_rows::new(rows.offsets(), rows.indices())
        })
    })
}

/// The object angle of each pole: the largest angle at its centre between two samples on its ball.
///
/// \param poles The poles, or NULL.
/// \return p x 1, in [0, pi] radians; 0 where fewer than two samples are on the ball. Borrowed from `poles`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_poles_object_angles(poles: *const medax_poles) -> medax_view_f64 {
    floats(poles, 1, Poles::object_angles)
}

/// The lambda by which poles were left out.
///
/// \param poles The poles, or NULL.
/// \return As given or, if that was 0, as estimated; 0 where nothing was to be left out.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_poles_lambda(poles: *const medax_poles) -> f64 {
    boundary::value(0.0, || handle::maybe(poles).map_or(0.0, |p| p.poles.lambda()))
}

/// The unit vector from each sample towards its first pole, be it at infinity: normal to the
/// surface, on either side of it.
///
/// \param poles The poles, or NULL.
/// \return n x 3. Borrowed from `poles`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_poles_normals(poles: *const medax_poles) -> medax_view_f64 {
    floats(poles, 3, |p| p.normals().as_flattened())
}

unsafe fn floats(
    poles: *const medax_poles,
    cols: usize,
    read: fn(&Poles) -> &[f64],
) -> medax_view_f64 {
    boundary::value(medax_view_f64::new(&[], cols), || {
        medax_view_f64::new(handle::maybe(poles).map_or(&[][..], |p| read(&p.poles)), cols)
    })
}

unsafe fn indices(
    poles: *const medax_poles,
    cols: usize,
    read: fn(&Poles) -> &[u32],
) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], cols), || {
        medax_view_u32::new(handle::maybe(poles).map_or(&[][..], |p| read(&p.poles)), cols)
    })
}

/// The distance from points to the nearest pole: an estimate of the local feature size, the
/// distance to the medial axis.
///
/// \param poles The poles.
/// \param query_xyz `query_count` x 3 coordinates; NULL only if `query_count` is 0.
/// \param query_count The number of points.
/// \param job NULL for a default job.
/// \param out_distances Receives `query_count` distances in input units, infinite if all poles are
///        at infinity; the caller's buffer, NULL only if `query_count` is 0.
/// \return `MEDAX_STATUS_OK`; `NON_FINITE`, or `COORDINATE_RANGE` beyond 2^200, with the row of a query;
///         `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(log p) a query, and O(p log p) once, in the first call. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_poles_feature_size(
    poles: *const medax_poles,
    query_xyz: *const f64,
    query_count: usize,
    job: *const medax_job,
    out_distances: *mut f64,
) -> medax_status {
    boundary::status(|| {
        let poles = &handle::get(poles, "poles")?.poles;
        let queries = view::rows(query_xyz, query_count, "query_xyz")?;
        let out = Buffer::new(out_distances, query_count, "out_distances")?;
        let mut own = None;
        out.fill(&poles.feature_size(queries, handle::job(job, &mut own))?);
        Ok(())
    })
}

/// The poles as vertices with the attributes `radius` and `object_angle`, in their order, for writing.
///
/// \param poles The poles.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`.
///
/// O(n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_poles_complex(
    poles: *const medax_poles,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let poles = &handle::get(poles, "poles")?.poles;
        let out = Out::new(out_complex, "out_complex")?;
        out.put(complex::give(Arc::new(poles.to_complex()?)));
        Ok(())
    })
}

/// The samples as vertices with the attribute `normal`, for writing.
///
/// \param poles The poles.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`.
///
/// O(n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_poles_samples_complex(
    poles: *const medax_poles,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let poles = &handle::get(poles, "poles")?.poles;
        let out = Out::new(out_complex, "out_complex")?;
        out.put(complex::give(Arc::new(poles.samples_to_complex()?)));
        Ok(())
    })
}

/// Checks poles: that each is what its samples' Voronoi cells make it.
///
/// \param poles The poles.
/// \param job NULL for a default job.
/// \param out_report Filled, its `struct_size` being set.
/// \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report
///         of no version, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// As building the poles anew. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_poles_validate(
    poles: *const medax_poles,
    job: *const medax_job,
    out_report: *mut medax_validation,
) -> medax_status {
    validation::validate(job, out_report, |job| handle::get(poles, "poles")?.poles.validate(job))
}

/// One more reference to poles.
///
/// \param poles The poles, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_poles_clone(poles: *const medax_poles) -> *const medax_poles {
    boundary::value(ptr::null(), || handle::clone(poles))
}

/// Gives one reference to poles back; the last one frees them.
///
/// \param poles The poles; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_poles_free(poles: *const medax_poles) {
    boundary::value((), || handle::free(poles));
}

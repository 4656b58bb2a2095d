//! Field axis
//!
//! Points of the medial axis of sites, as dense as they are asked for, read off the gradient of the distance: APPROXMA2D in the plane,
//! APPROXMA3D in space. Circles or spheres cover what is looked at, and each is asked whether it holds a medial point
//! (#medax_sites_decide); in the plane each says what it may have missed. (Stolpner, Whitesides 2009, Medial axis approximation with
//! bounded error.)

use super::boundary;
use super::complex;
use super::handle::{self, medax_complex, medax_field_axis, medax_job, medax_sites};
use super::medial::{medax_side, side};
use super::medial_points::MedialPoints;
use super::options::{self, Report, SizedStruct, flag, sized_struct};
use super::status::medax_status;
use super::validation::{self, medax_validation};
use super::view::{self, Buffer, Out, medax_view_f64, medax_view_u32};
use crate::distance::{Cover, DecideOptions, FieldAxis, FieldOptions, Sites};
use crate::error::Result;
use crate::job::{Run, Stage};
use std::f64::consts::PI;
use std::ptr;
use std::sync::Arc;

/// Which points of the medial axis, how dense, and how near to it.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_field_axis_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// Within this distance of what of the medial axis is found there is a point, in input units. 0, the default, asks for a hundredth of
    /// #medax_sites_size.
    pub density: f64,
    /// The least object angle of a point, in radians in [0, pi]; 0 by default.
    pub object_angle: f64,
    /// The least distance of a point from the boundary, in input units. 0, the default, asks for a quarter of the density in the plane,
    /// where it bounds how fine the cover gets; in space for nothing.
    pub min_distance: f64,
    /// In the plane the largest object angle that a point may have and be missed, in radians in (0, pi); pi / 9 by default.
    pub bound: f64,
    /// Two nearest points no farther apart than this are the same, in input units. 0, the default, asks for 1e-9 of #medax_sites_size.
    pub tolerance: f64,
    /// How far a point may be from the medial axis, in input units. 0, the default, asks for 1e-6 of that size.
    pub epsilon: f64,
    /// The least corner of a box that holds what is looked at, if `has_clip` is 1. No coordinate is beyond 2^200.
    pub clip_min: [f64; 3],
    /// The largest corner of that box.
    pub clip_max: [f64; 3],
    /// 1 for that box; 0, the default, for that of the sites, if the outside is asked for as well as much larger on each side as half its
    /// diagonal is long.
    pub has_clip: u32,
    /// A #medax_side of the boundary; `MEDAX_SIDE_INNER` by default. Where there is no inside, as for open curves, all is outside.
    pub side: u32,
    /// The number of points at which each circle or sphere is looked at, from 12 to 2^20. 0, the default, asks for as many as the bound
    /// takes in the plane, for 60 in space.
    pub samples: u32,
    /// 1 to keep only what has its nearest points on two sites; 0 by default.
    pub between_sites: u32,
}

sized_struct!(medax_field_axis_options,
    first_size: size_of::<medax_field_axis_options>(), reserved: none, {
    density: f64 = 0.0,
    object_angle: f64 = 0.0,
    min_distance: f64 = 0.0,
    bound: f64 = PI / 9.0,
    tolerance: f64 = 0.0,
    epsilon: f64 = 0.0,
    clip_min: [f64; 3] = [0.0; 3],
    clip_max: [f64; 3] = [0.0; 3],
    has_clip: u32 = 0,
    side: u32 = medax_side::Inner as u32,
    samples: u32 = 0,
    between_sites: u32 = 0,
});

impl medax_field_axis_options {
    fn translate(&self) -> Result<FieldOptions> {
        let has_clip = flag(self.has_clip, "has_clip")?;
        Ok(FieldOptions {
            side: side(self.side)?,
            density: self.density,
            angle: self.object_angle,
            min_distance: self.min_distance,
            bound: self.bound,
            samples: self.samples as usize,
            clip: has_clip.then_some([self.clip_min, self.clip_max]),
            between_sites: flag(self.between_sites, "between_sites")?,
            decide: DecideOptions { tolerance: self.tolerance, epsilon: self.epsilon },
        })
    }
}

impl From<&FieldOptions> for medax_field_axis_options {
    fn from(options: &FieldOptions) -> Self {
        let [clip_min, clip_max] = options.clip.unwrap_or_default();
        medax_field_axis_options {
            density: options.density,
            object_angle: options.angle,
            min_distance: options.min_distance,
            bound: options.bound,
            tolerance: options.decide.tolerance,
            epsilon: options.decide.epsilon,
            clip_min,
            clip_max,
            has_clip: u32::from(options.clip.is_some()),
            side: medax_side::from(options.side) as u32,
            samples: u32::try_from(options.samples).unwrap_or(u32::MAX),
            between_sites: u32::from(options.between_sites),
            ..Self::DEFAULT
        }
    }
}

/// Sets the options of field axes to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_options_init(
    options: *mut medax_field_axis_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// Finds points of the medial axis.
///
/// \param sites The sites, which the result keeps alive.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_axis Receives the points, which the caller frees with #medax_field_axis_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for options out of range, and without a box for sites that are all rays and lines;
///         `LIMIT_EXCEEDED` for a density of less than 2^-20 of the box, and where the density or the least
///         distance ask for more than 2^28 circles or spheres; `NULL_ARGUMENT`,
///         `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// In the plane O(length / least distance + area / density^2) circles, in space O(area / density^2) spheres, each some queries for each
/// sample. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_build(
    sites: *const medax_sites,
    options: *const medax_field_axis_options,
    job: *const medax_job,
    out_axis: *mut *const medax_field_axis,
) -> medax_status {
    boundary::status(|| build(sites, options, job, out_axis, FieldAxis::new_in))
}

/// Finds points of the medial axis that have their nearest points on one of some pairs of sites: pieces of the Voronoi diagram of the sites.
/// Others are not looked for.
///
/// \param sites The sites, which the result keeps alive.
/// \param pairs `pair_count` x 2 sites, either first; a site with itself for the parts of the medial axis that belong to that site alone.
///        NULL only if `pair_count` is 0.
/// \param pair_count The number of pairs; with 0 there are no points.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_axis Receives the points, which the caller frees with #medax_field_axis_free.
/// \return As #medax_field_axis_build; also `INVALID_ARGUMENT` with the row of a pair that names no site.
///
/// As #medax_field_axis_build. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_between(
    sites: *const medax_sites,
    pairs: *const u32,
    pair_count: usize,
    options: *const medax_field_axis_options,
    job: *const medax_job,
    out_axis: *mut *const medax_field_axis,
) -> medax_status {
    boundary::status(|| {
        let pairs = view::rows(pairs, pair_count, "pairs")?;
        build(sites, options, job, out_axis, |sites, options, run| {
            FieldAxis::between_in(sites, pairs, options, run)
        })
    })
}

unsafe fn build(
    sites: *const medax_sites,
    options: *const medax_field_axis_options,
    job: *const medax_job,
    out_axis: *mut *const medax_field_axis,
    find: impl FnOnce(&Arc<Sites>, FieldOptions, &Run<'_>) -> Result<FieldAxis>,
) -> Result<()> {
    let sites = &handle::get(sites, "sites")?.sites;
    let options = options::read(options, "options")?.translate()?;
    let out = Out::new(out_axis, "out_axis")?;
    let mut own = None;
    let stages = [(Stage::Field, 0.98), (Stage::Extract, 0.02)];
    let (axis, points) = handle::job(job, &mut own).run(&stages, |run| {
        let axis = find(sites, options, run)?;
        run.enter(Stage::Extract)?;
        let points = MedialPoints::new(axis.points(), sites, run)?;
        Ok((axis, points))
    })?;
    out.put(handle::new(medax_field_axis { axis, points }));
    Ok(())
}

/// What distances were measured to.
///
/// \param axis The field axis.
/// \param out_sites Receives the sites, which the caller frees with #medax_sites_free.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_sites(
    axis: *const medax_field_axis,
    out_sites: *mut *const medax_sites,
) -> medax_status {
    boundary::status(|| {
        let axis = &handle::get(axis, "axis")?.axis;
        let out = Out::new(out_sites, "out_sites")?;
        out.put(handle::new(medax_sites { sites: axis.sites().clone() }));
        Ok(())
    })
}

/// What was asked for, with numbers in place of the defaults.
///
/// \param axis The field axis.
/// \param out_options Filled, its `struct_size` being set.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_resolved(
    axis: *const medax_field_axis,
    out_options: *mut medax_field_axis_options,
) -> medax_status {
    boundary::status(|| {
        let axis = &handle::get(axis, "axis")?.axis;
        let report = Report::new(out_options, "out_options")?;
        report.fill(&axis.options().into());
        Ok(())
    })
}

/// Where the points lie.
///
/// \param axis The field axis, or NULL.
/// \return m x 3 coordinates. Borrowed from `axis`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_points(axis: *const medax_field_axis) -> medax_view_f64 {
    column(axis, MedialPoints::centers)
}

/// The distances of the points from the boundary: the radii of the medial balls.
///
/// \param axis The field axis, or NULL.
/// \return m x 1, in input units. Borrowed from `axis`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_radii(axis: *const medax_field_axis) -> medax_view_f64 {
    column(axis, MedialPoints::radii)
}

/// The angles between the ways from the points to their nearest points.
///
/// \param axis The field axis, or NULL.
/// \return m x 1, in radians. Borrowed from `axis`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_object_angles(
    axis: *const medax_field_axis,
) -> medax_view_f64 {
    column(axis, MedialPoints::object_angles)
}

/// Two nearest points of the boundary for each point.
///
/// \param axis The field axis, or NULL.
/// \return m x 6 coordinates. Borrowed from `axis`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_feet(axis: *const medax_field_axis) -> medax_view_f64 {
    column(axis, MedialPoints::feet)
}

/// The pieces that have these nearest points.
///
/// \param axis The field axis, or NULL.
/// \return m x 2 pieces. Borrowed from `axis`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_pieces(axis: *const medax_field_axis) -> medax_view_u32 {
    column(axis, MedialPoints::pieces)
}

/// The sites of these pieces.
///
/// \param axis The field axis, or NULL.
/// \return m x 2 sites. Borrowed from `axis`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_sites_of_points(
    axis: *const medax_field_axis,
) -> medax_view_u32 {
    column(axis, MedialPoints::sites)
}

unsafe fn column<V>(axis: *const medax_field_axis, read: fn(Option<&MedialPoints>) -> V) -> V {
    boundary::value(read(None), || read(handle::maybe(axis).map(|a| &a.points)))
}

/// The circle or sphere in which each point was found.
///
/// \param axis The field axis, or NULL.
/// \return m x 1 covers, which ascend. Borrowed from `axis`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_cover_of_point(
    axis: *const medax_field_axis,
) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], 1), || {
        let covers = handle::maybe(axis).map_or(&[][..], |a| a.axis.cover_of_point());
        medax_view_u32::new(covers, 1)
    })
}

/// A circle in the plane or a sphere in space that was looked at, for the square or the cube in its middle.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct medax_cover {
    /// The centre.
    pub center: [f64; 3],
    /// The radius, in input units.
    pub radius: f64,
    /// Half the side of the square or cube.
    pub half: f64,
    /// In the plane the longest arc between points that were looked at; 0 in space.
    pub gap: f64,
    /// The distance of the centre from the boundary.
    pub distance: f64,
    /// The claim: the largest object angle of a point of the medial axis within the square that is at least `min_distance` from the
    /// boundary and has no point of the result within the density, in radians; 0 where there is such a point. Pi stands for no claim: in
    /// space, and where what was found did not pass the thresholds.
    pub missed_angle: f64,
    /// The number of points that it gave.
    pub found: u32,
    /// 0.
    pub reserved: u32,
}

impl From<Cover> for medax_cover {
    fn from(cover: Cover) -> Self {
        let Cover { center, radius, half, gap, distance, found, missed_angle } = cover;
        medax_cover { center, radius, half, gap, distance, missed_angle, found, reserved: 0 }
    }
}

/// The number of covers: in the plane of all circles that were looked at in the end, in space of the spheres that gave a point.
///
/// \param axis The field axis; NULL has none.
/// \return The number of covers.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_cover_count(axis: *const medax_field_axis) -> usize {
    boundary::value(0, || handle::maybe(axis).map_or(0, |a| a.axis.covers().len()))
}

/// Some of these circles or spheres.
///
/// \param axis The field axis.
/// \param first The first of them.
/// \param count How many.
/// \param out_covers Receives `count` covers; the caller's buffer, NULL only if `count` is 0.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` past the last cover; `NULL_ARGUMENT`.
///
/// O(count). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_covers(
    axis: *const medax_field_axis,
    first: usize,
    count: usize,
    out_covers: *mut medax_cover,
) -> medax_status {
    boundary::status(|| {
        let covers = handle::get(axis, "axis")?.axis.covers();
        let out = Buffer::new(out_covers, count, "out_covers")?;
        out.fill_from(&covers[view::range(first, count, covers.len(), "covers")?]);
        Ok(())
    })
}

/// What may have been missed in all.
///
/// \param axis The field axis.
/// \param out_angle Receives the largest object angle that a point beyond the least distance may have and be missed, in radians, where
///        there is a claim; or NULL.
/// \param out_unclaimed Receives the number of covers that make no claim, where it may be any: in space all; or NULL.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// O(covers). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_claim(
    axis: *const medax_field_axis,
    out_angle: *mut f64,
    out_unclaimed: *mut usize,
) -> medax_status {
    boundary::status(|| {
        let (angle, unclaimed) = handle::get(axis, "axis")?.axis.claim();
        Out::maybe(out_angle, angle);
        Out::maybe(out_unclaimed, unclaimed);
        Ok(())
    })
}

/// How often a test fired of which no point came, as may happen where it hangs on the last bits of rounding.
///
/// \param axis The field axis; NULL has none.
/// \return How often.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_unconfirmed(axis: *const medax_field_axis) -> usize {
    boundary::value(0, || handle::maybe(axis).map_or(0, |a| a.axis.unconfirmed()))
}

/// The points as vertices, with the attributes `radius`, `object_angle`, `feet` (the two nearest points), `pieces`, `sites` (of these) and
/// `missed_angle` (that of the cover), for writing.
///
/// \param axis The field axis.
/// \param job NULL for a default job.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(points). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_complex(
    axis: *const medax_field_axis,
    job: *const medax_job,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let axis = &handle::get(axis, "axis")?.axis;
        let out = Out::new(out_complex, "out_complex")?;
        let mut own = None;
        out.put(complex::give(Arc::new(axis.complex(handle::job(job, &mut own))?)));
        Ok(())
    })
}

/// The medial axis as a surface of polygons, in space, as fine as the density.
///
/// A vertex stands for each cube of the finest lattice in which a point was found; an edge of the lattice that crosses the axis makes a
/// quadrilateral of the four cubes round it, and cubes among these that have no point get one. Where only the square between two cubes meets
/// the axis, as a curve does, a loose edge joins their vertices. Every vertex is a medial point. Nothing bounds what is missed.
///
/// Vertices, faces and loose edges carry `radius`, `object_angle`, `feet` (the two nearest points), `pieces` and `sites` (of these): faces
/// and edges those of the point where the lattice crosses the axis. A face between two sites is oriented from the lesser to the larger.
///
/// \param axis The field axis.
/// \param job NULL for a default job.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` in the plane, where #medax_medial_graph_build has the arcs; `LIMIT_EXCEEDED` past 2^32 - 1
///         corners of faces; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// Some queries for each edge and square of the cubes that the axis passes. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_surface(
    axis: *const medax_field_axis,
    job: *const medax_job,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let axis = &handle::get(axis, "axis")?.axis;
        let out = Out::new(out_complex, "out_complex")?;
        let mut own = None;
        out.put(complex::give(Arc::new(axis.surface(handle::job(job, &mut own))?)));
        Ok(())
    })
}

/// Checks a field axis: that nothing is nearer to a point than its radius, and its feet are as near; its angle, thresholds, side and sites;
/// and what covers hold and claim.
///
/// \param axis The field axis.
/// \param job NULL for a default job.
/// \param out_report Filled, its `struct_size` being set.
/// \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report of no version, `CANCELLED`, `BUSY`,
///         `OUT_OF_MEMORY`.
///
/// Some queries for each point and each circle. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_validate(
    axis: *const medax_field_axis,
    job: *const medax_job,
    out_report: *mut medax_validation,
) -> medax_status {
    validation::validate(job, out_report, |job| handle::get(axis, "axis")?.axis.validate(job))
}

/// One more reference to a field axis.
///
/// \param axis The field axis, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_clone(
    axis: *const medax_field_axis,
) -> *const medax_field_axis {
    boundary::value(ptr::null(), || handle::clone(axis))
}

/// Gives one reference to a field axis back; the last one frees it.
///
/// \param axis The field axis; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_field_axis_free(axis: *const medax_field_axis) {
    boundary::value((), || handle::free(axis));
}

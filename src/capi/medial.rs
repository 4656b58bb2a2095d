//! Medial axis
//!
//! The medial axis straight from the Voronoi diagram of a sample: a Voronoi facet belongs to it if its dual Delaunay edge makes a
//! large angle with the surface at one of its ends, or is long beside the triangles of the surface there. These triangles are a
//! sample's umbrella: those at the sample whose dual Voronoi edges the tangent plane cuts. A #medax_medial has for every facet what
//! decides; a filter is a threshold on that, and to move it builds nothing again.
//! (Dey, Zhao 2004, Approximating the medial axis from the Voronoi diagram with a convergence guarantee.)

use super::boundary;
use super::complex;
use super::handle::{self, medax_complex, medax_dual, medax_job, medax_labels, medax_medial};
use super::options::{self, flag, sized_struct};
use super::status::medax_status;
use super::validation::{self, medax_validation};
use super::view::{self, Buffer, Out, medax_view_f64, medax_view_u8, medax_view_u32};
use crate::error::{Error, Result, Status};
use crate::labels::Labels;
use crate::medial::{Medial, MedialFilter, MedialOptions, MedialRule, Side};
use std::f64::consts::FRAC_PI_8;
use std::ptr;
use std::sync::Arc;

/// Which of the two conditions of the paper decide whether a facet belongs to the axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum medax_medial_rule {
    /// Either is enough: the paper's algorithm.
    AngleOrRatio = 0,
    /// The angle condition alone.
    Angle = 1,
    /// The ratio condition alone.
    Ratio = 2,
    /// Neither: all facets, those of the surface as well, for the other thresholds to choose from.
    Every = 3,
}

impl From<MedialRule> for medax_medial_rule {
    fn from(rule: MedialRule) -> Self {
        match rule {
            MedialRule::AngleOrRatio => medax_medial_rule::AngleOrRatio,
            MedialRule::Angle => medax_medial_rule::Angle,
            MedialRule::Ratio => medax_medial_rule::Ratio,
            MedialRule::Every => medax_medial_rule::Every,
        }
    }
}

/// The side of the surface on which an axis lies. The first two are those of #medax_label.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum medax_side {
    /// Facets of which every cell round the dual edge is outer.
    Outer = 0,
    /// Facets of which every cell round the dual edge is inner.
    Inner = 1,
    /// All facets, those that cross the surface as well. The only one that needs no labels.
    Both = 2,
}

impl From<Side> for medax_side {
    fn from(side: Side) -> Self {
        match side {
            Side::Outer => medax_side::Outer,
            Side::Inner => medax_side::Inner,
            Side::Both => medax_side::Both,
        }
    }
}

/// What is calculated.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_medial_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// `normal_count` x 3 coordinates: the normals of the surface at the samples, in the order of the points' vertices, in place of
    /// the vectors to their poles. Their lengths do not count, nor which way they point; a vertex whose normal is 0 has no
    /// umbrella. Copied. NULL, the default: the poles.
    pub normals: *const f64,
    /// The number of normals, which is that of the vertices; 0 without.
    pub normal_count: usize,
    /// 1 to calculate the pairwise scales too, which filters by scale need, and which cost far more than all the rest: 12 seconds for 44,000 samples with two threads; 0, the
    /// default, not to.
    pub scales: u32,
    /// Must be 0.
    pub reserved: u32,
}

sized_struct!(medax_medial_options,
    first_size: size_of::<medax_medial_options>(), reserved: reserved,
    { normals: *const f64 = ptr::null(), normal_count: usize = 0, scales: u32 = 0, reserved: u32 = 0 });

impl medax_medial_options {
    unsafe fn translate(&self) -> Result<MedialOptions> {
        let normals = match self.normals.is_null() && self.normal_count == 0 {
            true => None,
            false => Some(view::rows(self.normals, self.normal_count, "normals")?.to_vec()),
        };
        Ok(MedialOptions { normals, scales: flag(self.scales, "scales")? })
    }
}

/// Sets medial options to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_options_init(
    options: *mut medax_medial_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// Thresholds on the facets of a #medax_medial: a facet must pass all of them.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_medial_filter {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// The threshold of the angle condition, in radians in [0, pi/2); pi/8 by default, the paper's.
    pub theta: f64,
    /// The threshold of the ratio condition, not negative; 8 by default, the paper's.
    pub rho: f64,
    /// The least object angle, in radians in [0, pi]: some point of the facet must have as much; 0 by default.
    pub object_angle: f64,
    /// The least lambda, in input units: half the length of the dual edge, the radius of the smallest ball round the nearest
    /// samples of a point within the facet (Chazal, Lieutier 2005, The lambda-medial axis); 0 by default.
    pub lambda: f64,
    /// The least pairwise scale: the ball of some corner of the facet must have more; 0, the default, asks for nothing, and
    /// anything else for #medax_medial_scales.
    pub scale: f64,
    /// The least corner of a box to which the axis is clipped, if `has_clip` is 1, so that it keeps its unbounded facets. No
    /// coordinate is beyond 2^200.
    pub clip_min: [f64; 3],
    /// The largest corner of that box.
    pub clip_max: [f64; 3],
    /// 1 to clip the axis; 0, the default, not to: unbounded facets are then left out.
    pub has_clip: u32,
    /// A #medax_medial_rule: which conditions decide; `MEDAX_MEDIAL_RULE_ANGLE_OR_RATIO` by default.
    pub rule: u32,
    /// A #medax_side; `MEDAX_SIDE_INNER` by default.
    pub side: u32,
    /// Must be 0.
    pub reserved: u32,
}

sized_struct!(medax_medial_filter,
    first_size: size_of::<medax_medial_filter>(), reserved: reserved,
    { theta: f64 = FRAC_PI_8, rho: f64 = 8.0, object_angle: f64 = 0.0, lambda: f64 = 0.0, scale: f64 = 0.0,
      clip_min: [f64; 3] = [0.0; 3], clip_max: [f64; 3] = [0.0; 3], has_clip: u32 = 0,
      rule: u32 = medax_medial_rule::AngleOrRatio as u32, side: u32 = medax_side::Inner as u32, reserved: u32 = 0 });

impl medax_medial_filter {
    fn translate(&self) -> Result<MedialFilter> {
        let rule =
            [MedialRule::AngleOrRatio, MedialRule::Angle, MedialRule::Ratio, MedialRule::Every]
                .into_iter()
                .find(|&known| medax_medial_rule::from(known) as u32 == self.rule)
                .ok_or_else(|| no_such(self.rule, "medax_medial_rule"))?;
        let has_clip = flag(self.has_clip, "has_clip")?;
        Ok(MedialFilter {
            rule,
            theta: self.theta,
            rho: self.rho,
            object_angle: self.object_angle,
            lambda: self.lambda,
            scale: self.scale,
            side: side(self.side)?,
            clip: has_clip.then_some([self.clip_min, self.clip_max]),
        })
    }
}

/// The side that a #medax_side stands for.
pub(super) fn side(number: u32) -> Result<Side> {
    [Side::Outer, Side::Inner, Side::Both]
        .into_iter()
        .find(|&known| medax_side::from(known) as u32 == number)
        .ok_or_else(|| no_such(number, "medax_side"))
}

fn no_such(number: u32, name: &str) -> Error {
    Error::new(Status::InvalidArgument, format!("{number} is no {name}"))
}

/// Sets a filter to its defaults: those of the paper, for the inner axis.
///
/// \param filter The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *filter`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_filter_init(
    filter: *mut medax_medial_filter,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(filter, struct_size, "filter"))
}

/// Calculates umbrellas, conditions and attributes of all Voronoi facets of a sample.
///
/// \param dual The dual of the Delaunay triangulation, with its facets (#medax_dual_options), which the result keeps alive.
/// \param labels Labels of the triangulation's cells, with which the inner and the outer axis can be told apart; NULL for none. The
///        result keeps them alive.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_medial Receives the result, which the caller frees with #medax_medial_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for the dual of a regular triangulation, a dual without facets and, with the
///         vertex, a normal that is not finite; `MISMATCH` for labels of another triangulation, and unless there is one normal per
///         vertex; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size of the dual), and for each Delaunay edge a look at every umbrella triangle of its ends: linear on surfaces that are
/// sampled evenly, quadratic at a sample of which most others are neighbours. Scales cost a search for each cell. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_build(
    dual: *const medax_dual,
    labels: *const medax_labels,
    options: *const medax_medial_options,
    job: *const medax_job,
    out_medial: *mut *const medax_medial,
) -> medax_status {
    boundary::status(|| {
        let dual = &handle::get(dual, "dual")?.dual;
        let labels = handle::maybe(labels).map(|l| &l.labels);
        let options = options::read(options, "options")?.translate()?;
        let out = Out::new(out_medial, "out_medial")?;
        let mut own = None;
        let medial = Medial::new(dual, labels, options, handle::job(job, &mut own))?;
        out.put(handle::new(medax_medial { medial }));
        Ok(())
    })
}

/// The axis: the Voronoi facets that a filter lets pass, with their edges and vertices, as convex polygons.
///
/// Vertices are Voronoi vertices, one for all cells that share a sphere, and carry `cell`, the least of these, or `MEDAX_NONE` where
/// a box has cut, `radius`, that of the ball round them through their samples, and `scale`, NaN where a box has cut, if scales were
/// calculated. Faces are in the order of #medax_dual_facets
/// and turn counterclockwise as seen from the second sample; they carry `facet`, `samples` (the two ends of the dual edge),
/// `condition` (1 the angle condition, 2 the ratio condition, 3 both, 0 neither), `object_angle` (the least and the largest on the
/// face, in radians), `lambda` (half the length of the dual edge) and `side` (a #medax_side; `MEDAX_SIDE_BOTH` for one that crosses
/// the surface, or where there are no labels). Facets that have no area, since their cells share spheres, are no faces. Of a facet
/// that only touches the box nothing is left.
///
/// \param medial The facets with what decides.
/// \param filter NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for thresholds out of range, an inner or an outer side without labels, a scale
///         where scales were not calculated; `COORDINATE_RANGE` for a box beyond 2^200; `NULL_ARGUMENT`, `LIMIT_EXCEEDED`,
///         `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(f) for f facets, and O(size) of what passes. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_axis(
    medial: *const medax_medial,
    filter: *const medax_medial_filter,
    job: *const medax_job,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let medial = &handle::get(medial, "medial")?.medial;
        let filter = options::read(filter, "filter")?.translate()?;
        let out = Out::new(out_complex, "out_complex")?;
        let mut own = None;
        out.put(complex::give(Arc::new(medial.axis(&filter, handle::job(job, &mut own))?)));
        Ok(())
    })
}

/// The facets that a filter lets pass, unbounded ones and those without area as well.
///
/// \param medial The facets with what decides.
/// \param filter NULL for the defaults.
/// \param job NULL for a default job.
/// \param capacity The number of facets for which `out_facets` has room; that of #medax_dual_facets is always enough.
/// \param out_facets Receives the first `capacity` of the facets, which ascend; the caller's buffer, NULL only if `capacity` is 0.
/// \param out_count Receives the number of facets that pass, which may be more than `capacity`.
/// \return As #medax_medial_axis.
///
/// O(f) for f facets. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_selected(
    medial: *const medax_medial,
    filter: *const medax_medial_filter,
    job: *const medax_job,
    capacity: usize,
    out_facets: *mut u32,
    out_count: *mut usize,
) -> medax_status {
    boundary::status(|| {
        let medial = &handle::get(medial, "medial")?.medial;
        let filter = options::read(filter, "filter")?.translate()?;
        let target = Buffer::new(out_facets, capacity, "out_facets")?;
        let count = Out::new(out_count, "out_count")?;
        let mut own = None;
        let selected = medial.selected(&filter, handle::job(job, &mut own))?;
        count.put(selected.len());
        target.fill(&selected);
        Ok(())
    })
}

/// The Voronoi diagram.
///
/// \param medial The facets with what decides.
/// \param out_dual Receives the dual, which the caller frees with #medax_dual_free.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_dual(
    medial: *const medax_medial,
    out_dual: *mut *const medax_dual,
) -> medax_status {
    boundary::status(|| {
        let medial = &handle::get(medial, "medial")?.medial;
        let out = Out::new(out_dual, "out_dual")?;
        out.put(handle::new(medax_dual { dual: medial.dual().clone() }));
        Ok(())
    })
}

/// The labels that tell the inner from the outer axis.
///
/// \param medial The facets with what decides.
/// \param out_labels Receives the labels, which the caller frees with #medax_labels_free; NULL if none were given.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_labels(
    medial: *const medax_medial,
    out_labels: *mut *const medax_labels,
) -> medax_status {
    boundary::status(|| {
        let medial = &handle::get(medial, "medial")?.medial;
        let out = Out::new(out_labels, "out_labels")?;
        let give = |labels: &Arc<Labels>| handle::new(medax_labels { labels: labels.clone() });
        out.put(medial.labels().map_or(ptr::null(), give));
        Ok(())
    })
}

/// What the angle condition asks of each facet, by the two ends of its dual edge: the sine of the least angle between the edge and
/// the planes of the end's umbrella triangles. The condition holds where one of the two exceeds the sine of theta. Right to 10^-12,
/// however thin the triangles are.
///
/// \param medial The facets with what decides, or NULL.
/// \return f x 2, in the order of #medax_dual_facet_edges, in [0, 1]; minus infinity where the umbrella has the edge, or has no
///         triangle. Borrowed from `medial`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_sines(medial: *const medax_medial) -> medax_view_f64 {
    floats(medial, 2, |m| m.sines().as_flattened())
}

/// What the ratio condition asks of each facet, by the two ends of its dual edge: the length of the edge by the largest
/// circumradius of the end's umbrella triangles. The condition holds where one of the two exceeds rho. Right to 10^-12 of itself,
/// however thin the triangles are.
///
/// \param medial The facets with what decides, or NULL.
/// \return f x 2, in the order of #medax_dual_facet_edges, not negative; minus infinity where the umbrella has the edge, or has no
///         triangle. Borrowed from `medial`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_ratios(medial: *const medax_medial) -> medax_view_f64 {
    floats(medial, 2, |m| m.ratios().as_flattened())
}

/// The least and the largest distance of each facet's points from the middle of its dual edge. The object angle at a point is twice
/// the arc tangent of half the edge's length by that distance.
///
/// \param medial The facets with what decides, or NULL.
/// \return f x 2, in the order of #medax_dual_facet_edges, in input units; the largest is infinite where the facet is unbounded.
///         Borrowed from `medial`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_reaches(medial: *const medax_medial) -> medax_view_f64 {
    floats(medial, 2, |m| m.reaches().as_flattened())
}

/// For each cell the least with the same circumscribed sphere: the same Voronoi vertex.
///
/// \param medial The facets with what decides, or NULL.
/// \return m x 1 cells. Borrowed from `medial`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_least_cell(medial: *const medax_medial) -> medax_view_u32 {
    indices(medial, 1, Medial::least_cell)
}

/// The pairwise scale of each cell's ball: the least factor at which another ball of the same label, its radius grown by it, covers
/// this one, grown as well; |c - c'| / (r' - r), the least over all larger balls.
///
/// It stands for the scale axis transform (Giesen, Miklos, Pauly, Wormser 2009), where grown balls are covered by many together.
///
/// \param medial The facets with what decides, or NULL.
/// \return m x 1; infinite for the largest balls. No row unless the options asked for scales. Borrowed from `medial`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_scales(medial: *const medax_medial) -> medax_view_f64 {
    floats(medial, 1, Medial::scales)
}

/// Where the triangles of each sample's umbrella begin in #medax_medial_umbrella_rims.
///
/// \param medial The facets with what decides, or NULL.
/// \return n + 1 x 1: those of vertex v are the rows from entry v to before entry v + 1. Borrowed from `medial`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_umbrella_offsets(
    medial: *const medax_medial,
) -> medax_view_u32 {
    indices(medial, 1, |m| m.umbrellas().offsets())
}

/// The triangles of all umbrellas, one sample's after the other's.
///
/// \param medial The facets with what decides, or NULL.
/// \return t x 2: the two other vertices of each triangle, which turns counterclockwise seen from the pole, or from where the given
///         normal points. Where the umbrella is a disk they go round the sample, the least one first; otherwise they ascend.
///         Borrowed from `medial`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_umbrella_rims(medial: *const medax_medial) -> medax_view_u32 {
    indices(medial, 2, |m| m.umbrellas().rims().as_flattened())
}

/// Whether each sample's umbrella is a disk: its triangles make one ring round the sample. It may not be where the sample is on the hull.
///
/// \param medial The facets with what decides, or NULL.
/// \return n x 1 flags, 0 or 1. Borrowed from `medial`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_umbrella_is_disk(
    medial: *const medax_medial,
) -> medax_view_u8 {
    boundary::value(medax_view_u8::of_flags(&[]), || {
        let flags = handle::maybe(medial).map_or(&[][..], |m| m.medial.umbrellas().is_disk());
        medax_view_u8::of_flags(flags)
    })
}

/// The number of samples whose umbrella is no disk.
///
/// \param medial The facets with what decides; NULL has none.
/// \return The number of samples.
///
/// O(n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_torn_count(medial: *const medax_medial) -> usize {
    boundary::value(0, || handle::maybe(medial).map_or(0, |m| m.medial.umbrellas().torn_count()))
}

unsafe fn floats(
    medial: *const medax_medial,
    cols: usize,
    read: fn(&Medial) -> &[f64],
) -> medax_view_f64 {
    boundary::value(medax_view_f64::new(&[], cols), || {
        medax_view_f64::new(handle::maybe(medial).map_or(&[][..], |m| read(&m.medial)), cols)
    })
}

unsafe fn indices(
    medial: *const medax_medial,
    cols: usize,
    read: fn(&Medial) -> &[u32],
) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], cols), || {
        medax_view_u32::new(handle::maybe(medial).map_or(&[][..], |m| read(&m.medial)), cols)
    })
}

/// Checks umbrellas and conditions by other means than those that made them: round each Voronoi facet, whose polygon a tangent
/// plane must cut twice or not at all, the triangles of the umbrellas are found again.
///
/// \param medial The facets with what decides.
/// \param job NULL for a default job.
/// \param out_report Filled, its `struct_size` being set.
/// \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report
///         of no version, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// As #medax_medial_build. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_validate(
    medial: *const medax_medial,
    job: *const medax_job,
    out_report: *mut medax_validation,
) -> medax_status {
    validation::validate(job, out_report, |job| handle::get(medial, "medial")?.medial.validate(job))
}

/// One more reference to facets with what decides.
///
/// \param medial The facets, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_clone(medial: *const medax_medial) -> *const medax_medial {
    boundary::value(ptr::null(), || handle::clone(medial))
}

/// Gives one reference to facets with what decides back; the last one frees them.
///
/// \param medial The facets; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_free(medial: *const medax_medial) {
    boundary::value((), || handle::free(medial));
}

//! Power crust
//!
//! The poles are labelled inner and outer; the power diagram of their balls then falls into the solid
//! and its complement, and the power crust is the boundary between them: closed by construction,
//! made of convex polygons, and pointing out of the solid. A pole with an unbounded power cell is
//! outer, and so is one that no label reached. The power shape of a side connects its poles as the
//! regular triangulation of the balls does: an approximation of the medial axis.
//! (Amenta, Choi, Kolluri 2001, The Power Crust.)

use super::boundary;
use super::complex;
use super::handle::{
    self, medax_complex, medax_job, medax_points, medax_poles, medax_power_crust,
    medax_triangulation,
};
use super::options::{self, sized_struct};
use super::poles;
use super::status::medax_status;
use super::validation::{self, medax_validation};
use super::view::{Out, medax_view_u32, numbers};
use crate::PowerCrust;
use crate::crust::{Label, LabelRule, PowerCrustOptions};
use crate::error::{Error, Result, Status};
use std::ptr;
use std::sync::Arc;

/// The side of the surface on which a pole lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum medax_label {
    /// Outside the solid.
    Outer = 0,
    /// Inside the solid.
    Inner = 1,
}

impl From<Label> for medax_label {
    fn from(label: Label) -> Self {
        match label {
            Label::Outer => medax_label::Outer,
            Label::Inner => medax_label::Inner,
        }
    }
}

/// The label of this number.
pub(super) fn label(number: u32) -> Result<Label> {
    let is_it = |&label: &Label| medax_label::from(label) as u32 == number;
    [Label::Outer, Label::Inner]
        .into_iter()
        .find(is_it)
        .ok_or_else(|| Error::new(Status::InvalidArgument, format!("{number} is not a label")))
}

// The labels are shown as they lie in memory.
const _: () = assert!(Label::Outer as u32 == medax_label::Outer as u32);
const _: () = assert!(Label::Inner as u32 == medax_label::Inner as u32);

/// How poles are labelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum medax_label_rule {
    /// As `MEDAX_LABEL_RULE_SPREAD`; as `MEDAX_LABEL_RULE_LEAST_CONFLICT` if that leaves a conflict above 0.005.
    Auto = 0,
    /// Labels spread from the far box, the most certain first, and are never taken back (Figure 8 of the paper).
    Spread = 1,
    /// Then labels are changed until they contradict each other as little as can be found: for noise, and for samples
    /// with large gaps.
    LeastConflict = 2,
}

impl From<LabelRule> for medax_label_rule {
    fn from(rule: LabelRule) -> Self {
        match rule {
            LabelRule::Auto => medax_label_rule::Auto,
            LabelRule::Spread => medax_label_rule::Spread,
            LabelRule::LeastConflict => medax_label_rule::LeastConflict,
        }
    }
}

/// How poles are labelled, from a number of the caller.
fn label_rule(rule: u32) -> Result<LabelRule> {
    [LabelRule::Auto, LabelRule::Spread, LabelRule::LeastConflict]
        .into_iter()
        .find(|&known| medax_label_rule::from(known) as u32 == rule)
        .ok_or_else(|| {
            Error::new(Status::InvalidArgument, format!("{rule} is no medax_label_rule"))
        })
}

/// The settings of a power crust.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_power_crust_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// Neighbouring balls intersect deeply, and so lie on the same side, where -cos of the angle
    /// between their spheres exceeds this; in [0, 1], 0.4 by default.
    pub deep: f64,
    /// As in #medax_poles_options, where poles are chosen: not for #medax_power_crust_build_from_poles.
    pub lambda: f64,
    /// 1 to take the power diagram of balls whose centres are rounded to a grid, which is faster; 0, the
    /// default, not to. The step of the grid is 2^-36 of the least power of two that the longest side of the
    /// samples' box does not exceed. #medax_power_crust_regular and the shapes then have the rounded balls,
    /// #medax_power_crust_poles those that were chosen; offsets and simplified crusts are made of these.
    pub round_poles: u32,
    /// 1 to keep the shards of every sample, the vertices of the power diagram that are the sample itself but for the rounding of
    /// the balls; 0, the default, to make them one vertex, exactly where the sample is.
    pub keep_shards: u32,
    /// A #medax_omit: which poles are left out, where they are chosen: not for #medax_power_crust_build_from_poles.
    /// `MEDAX_OMIT_NOTHING` by default.
    pub omit: u32,
    /// A #medax_label_rule: how poles are labelled. `MEDAX_LABEL_RULE_AUTO` by default.
    pub label_rule: u32,
    /// Where the scanner of a one-sided scan was, if `has_viewpoint` is 1: what it sees a sample from is outside, and labels
    /// spread from there instead of from the far box.
    pub viewpoint: [f64; 3],
    /// 1 if there is a viewpoint; 0, the default, if not.
    pub has_viewpoint: u32,
    /// Must be 0.
    pub reserved: u32,
}

sized_struct!(medax_power_crust_options,
    first_size: size_of::<medax_power_crust_options>(), reserved: reserved,
    { deep: f64 = 0.4, lambda: f64 = 0.0, round_poles: u32 = 0, keep_shards: u32 = 0, omit: u32 = 0,
      label_rule: u32 = 0, viewpoint: [f64; 3] = [0.0; 3], has_viewpoint: u32 = 0, reserved: u32 = 0 });

impl medax_power_crust_options {
    fn translate(&self) -> Result<PowerCrustOptions> {
        let round_poles = options::flag(self.round_poles, "round_poles")?;
        let keep_shards = options::flag(self.keep_shards, "keep_shards")?;
        let poles = poles::omission(self.omit, self.lambda)?;
        let label_rule = label_rule(self.label_rule)?;
        let viewpoint =
            options::flag(self.has_viewpoint, "has_viewpoint")?.then_some(self.viewpoint);
        let deep = self.deep;
        Ok(PowerCrustOptions { deep, round_poles, keep_shards, label_rule, viewpoint, poles })
    }
}

/// Sets power crust options to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_options_init(
    options: *mut medax_power_crust_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// Builds the power crust of a sample.
///
/// \param points The sample.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_crust Receives the power crust, which the caller frees with #medax_power_crust_free.
/// \return As #medax_poles_build_with_far_box; also `INVALID_ARGUMENT` for options out of range.
///
/// Two triangulations: of the n samples, and of their at most 2 n poles. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_build(
    points: *const medax_points,
    options: *const medax_power_crust_options,
    job: *const medax_job,
    out_crust: *mut *const medax_power_crust,
) -> medax_status {
    boundary::status(|| {
        let points = &handle::get(points, "points")?.points;
        let options = options::read(options, "options")?.translate()?;
        let out = Out::new(out_crust, "out_crust")?;
        let mut own = None;
        let crust = PowerCrust::build(points, options, handle::job(job, &mut own))?;
        out.put(handle::new(medax_power_crust { crust: Arc::new(crust) }));
        Ok(())
    })
}

/// Builds the power crust of poles, without choosing them again.
///
/// \param poles Poles with the far box, which the power crust keeps alive.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_crust Receives the power crust, which the caller frees with #medax_power_crust_free.
/// \return As #medax_power_crust_build; also `MISMATCH` for poles without the far box.
///
/// One regular triangulation of the poles. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_build_from_poles(
    poles: *const medax_poles,
    options: *const medax_power_crust_options,
    job: *const medax_job,
    out_crust: *mut *const medax_power_crust,
) -> medax_status {
    boundary::status(|| {
        let poles = &handle::get(poles, "poles")?.poles;
        let options = options::read(options, "options")?.translate()?;
        let out = Out::new(out_crust, "out_crust")?;
        let mut own = None;
        let crust = PowerCrust::from_poles(poles, options, handle::job(job, &mut own))?;
        out.put(handle::new(medax_power_crust { crust: Arc::new(crust) }));
        Ok(())
    })
}

/// The surface: convex polygons that point out of the solid. Faces have the attributes `inner_pole`
/// and `outer_pole`. Vertices have `cell`, the cell of #medax_power_crust_regular whose orthocentre they
/// are, and `sample`: the vertex of the points that they are, or `MEDAX_NONE`. With shards merged such a vertex lies exactly where the
/// sample does, and `cell` is the least of its shards; shards that stay apart, because merging would change the topology or turn a
/// triangle over, are no sample then.
///
/// \param crust The power crust.
/// \param out_surface Receives the surface, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_surface(
    crust: *const medax_power_crust,
    out_surface: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let crust = &handle::get(crust, "crust")?.crust;
        let out = Out::new(out_surface, "out_surface")?;
        out.put(complex::give(crust.surface().clone()));
        Ok(())
    })
}

/// The power shape of one side: its poles, and the faces, edges and cells of #medax_power_crust_regular between them.
///
/// Vertices have the attributes `radius`, `pole`, `label` (a #medax_label) and `object_angle` (see #medax_poles_object_angles). Cells are
/// tetrahedra, most of them flat, and have `flatness`: the least altitude relative to the longest edge. #medax_complex_flatten
/// collapses flat ones.
///
/// \param crust The power crust.
/// \param label A #medax_label: which side.
/// \param out_shape Receives the shape, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a number that is no label.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_shape(
    crust: *const medax_power_crust,
    label: u32,
    out_shape: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let crust = &handle::get(crust, "crust")?.crust;
        let out = Out::new(out_shape, "out_shape")?;
        let shape = match self::label(label)? {
            Label::Inner => crust.inner_shape(),
            Label::Outer => crust.outer_shape(),
        };
        out.put(complex::give(shape.clone()));
        Ok(())
    })
}

/// The poles of a power crust.
///
/// \param crust The power crust.
/// \param out_poles Receives the poles, which the caller frees with #medax_poles_free.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_poles(
    crust: *const medax_power_crust,
    out_poles: *mut *const medax_poles,
) -> medax_status {
    boundary::status(|| {
        let crust = &handle::get(crust, "crust")?.crust;
        let out = Out::new(out_poles, "out_poles")?;
        out.put(handle::new(medax_poles { poles: crust.poles().clone() }));
        Ok(())
    })
}

/// The regular triangulation of the polar balls. Poles are the rows of its points:
/// #medax_triangulation_row_of_vertex names the pole of each vertex.
///
/// \param crust The power crust.
/// \param out_regular Receives the triangulation, which the caller frees with
///        #medax_triangulation_free.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_regular(
    crust: *const medax_power_crust,
    out_regular: *mut *const medax_triangulation,
) -> medax_status {
    boundary::status(|| {
        let crust = &handle::get(crust, "crust")?.crust;
        let out = Out::new(out_regular, "out_regular")?;
        out.put(handle::new(medax_triangulation { triangulation: crust.regular().clone() }));
        Ok(())
    })
}

/// The label of each pole.
///
/// \param crust The power crust, or NULL.
/// \return p x 1: a #medax_label. Borrowed from `crust`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_labels(
    crust: *const medax_power_crust,
) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], 1), || {
        let labels = handle::maybe(crust).map_or(&[][..], |c| c.crust.labels());
        medax_view_u32::new(numbers(labels), 1)
    })
}

/// The poles as vertices with the attributes `radius`, `object_angle` and `label`, in their order, for writing.
///
/// \param crust The power crust.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`.
///
/// O(n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_poles_complex(
    crust: *const medax_power_crust,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let crust = &handle::get(crust, "crust")?.crust;
        let out = Out::new(out_complex, "out_complex")?;
        out.put(complex::give(Arc::new(crust.poles_to_complex()?)));
        Ok(())
    })
}

/// The power shapes of both sides in one complex, the inner one first, with their attributes; the sides share no vertex.
///
/// \param crust The power crust.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `LIMIT_EXCEEDED` past 2^32 - 2 elements.
///
/// O(n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_both_shapes(
    crust: *const medax_power_crust,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let crust = &handle::get(crust, "crust")?.crust;
        let out = Out::new(out_complex, "out_complex")?;
        out.put(complex::give(Arc::new(crust.both_shapes()?)));
        Ok(())
    })
}

/// Whether a pole takes part in the power diagram: it is neither hidden nor a lighter duplicate of
/// another pole's centre.
///
/// \param crust The power crust; NULL has no poles.
/// \param pole The pole.
/// \return False also for a number that is no pole.
///
/// O(log p). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_is_visible(
    crust: *const medax_power_crust,
    pole: u32,
) -> bool {
    boundary::value(false, || {
        handle::maybe(crust)
            .is_some_and(|c| (pole as usize) < c.crust.labels().len() && c.crust.is_visible(pole))
    })
}

/// The number of poles that no label reached, and that are outer for that reason.
///
/// \param crust The power crust; NULL has none.
/// \return The number of poles.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_unreached_count(
    crust: *const medax_power_crust,
) -> usize {
    boundary::value(0, || handle::maybe(crust).map_or(0, |c| c.crust.unreached_count()))
}

/// The number of poles made outer because their power cells are unbounded.
///
/// \param crust The power crust; NULL has none.
/// \return The number of poles.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_forced_count(crust: *const medax_power_crust) -> usize {
    boundary::value(0, || handle::maybe(crust).map_or(0, |c| c.crust.forced_count()))
}

/// How much the labels contradict each other: the sum of the squared weights of the links that do not have the labels that they
/// ask for, divided by the number of poles. Links are samples with two poles, which ask for different labels, and
/// balls that intersect deeply, which ask for the same.
///
/// \param crust The power crust; NULL has none.
/// \return The conflict: 1e-3 and less where a sample is dense; near 0.1 the solid is a guess.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_conflict(crust: *const medax_power_crust) -> f64 {
    boundary::value(0.0, || handle::maybe(crust).map_or(0.0, |c| c.crust.conflict()))
}

/// Whether labels were changed to lessen their conflict: `MEDAX_LABEL_RULE_LEAST_CONFLICT` was asked for, or needed.
///
/// \param crust The power crust; NULL has no labels.
/// \return Whether they were.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_is_settled(crust: *const medax_power_crust) -> bool {
    boundary::value(false, || handle::maybe(crust).is_some_and(|c| c.crust.is_settled()))
}

/// Checks a power crust: the labels, that the surface is closed and is the boundary between inner and outer cells, that merging shards moved
/// vertices to their samples and turned no triangle over, the shapes.
///
/// \param crust The power crust.
/// \param job NULL for a default job.
/// \param out_report Filled, its `struct_size` being set.
/// \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report
///         of no version, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(p log p). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_validate(
    crust: *const medax_power_crust,
    job: *const medax_job,
    out_report: *mut medax_validation,
) -> medax_status {
    validation::validate(job, out_report, |job| handle::get(crust, "crust")?.crust.validate(job))
}

/// One more reference to a power crust.
///
/// \param crust The power crust, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_clone(
    crust: *const medax_power_crust,
) -> *const medax_power_crust {
    boundary::value(ptr::null(), || handle::clone(crust))
}

/// Gives one reference to a power crust back; the last one frees it.
///
/// \param crust The power crust; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_free(crust: *const medax_power_crust) {
    boundary::value((), || handle::free(crust));
}

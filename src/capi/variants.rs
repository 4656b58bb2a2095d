//! Power crusts of other balls
//!
//! Offsets, simplified power shapes and surfaces with holes are made from a power crust without starting over. Labels are kept, and so
//! are the numbers of poles: those whose balls are left out have no vertex in the regular triangulation.
//! (Amenta, Choi, Kolluri 2001, The Power Crust, section 7.)

use super::boundary;
use super::complex;
use super::handle::{self, medax_complex, medax_job, medax_power_crust, medax_simplified};
use super::options::{self, sized_struct};
use super::status::medax_status;
use super::view::{Out, medax_view_u32};
use crate::crust::{HoleOptions, SimplifyOptions};
use std::ptr;
use std::sync::Arc;

/// Builds an approximate offset surface: outside the solid for a positive distance, inside for a negative one.
///
/// The radius of every inner ball grows by the distance, that of every outer ball shrinks by it; balls whose radius falls to 0
/// vanish, and do not come back. The result is a power crust, closed, and empty where no inner ball is left. Its surface has
/// no samples among its vertices.
///
/// \param crust The power crust.
/// \param distance The signed distance, in input units.
/// \param job NULL for a default job.
/// \param out_crust Receives the power crust of the changed balls, which the caller frees with #medax_power_crust_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for a distance that is not finite; `TOO_FEW_POINTS` or `DEGENERATE` where too few balls
///         are left; `NULL_ARGUMENT`, `LIMIT_EXCEEDED`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// One regular triangulation. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_offset(
    crust: *const medax_power_crust,
    distance: f64,
    job: *const medax_job,
    out_crust: *mut *const medax_power_crust,
) -> medax_status {
    boundary::status(|| {
        let crust = &handle::get(crust, "crust")?.crust;
        let out = Out::new(out_crust, "out_crust")?;
        let mut own = None;
        let offset = crust.offset(distance, handle::job(job, &mut own))?;
        out.put(handle::new(medax_power_crust { crust: Arc::new(offset) }));
        Ok(())
    })
}

/// Builds the scale axis of one side: the axis of the union of its balls, grown by a factor, with the balls shrunk back (Giesen, Miklos,
/// Pauly, Wormser 2009). What is small beside what is near is gone.
///
/// It is the dual complex of the union, which has its homotopy type. Vertices have the attributes `radius`, `pole`, `label` and `object_angle`, as
/// those of #medax_power_crust_shape.
///
/// \param crust The power crust.
/// \param side A #medax_label.
/// \param factor The factor, at least 1; at 1 itself rounding makes voids without a size at the samples, which lie on the union's boundary.
/// \param job NULL for a default job.
/// \param out_axis Receives the axis, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for a factor below 1 or too large, or a number that is no label; `TOO_FEW_POINTS` or `DEGENERATE`
///         where there are too few balls of that side; `NULL_ARGUMENT`, `LIMIT_EXCEEDED`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// One regular triangulation. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_scale_axis(
    crust: *const medax_power_crust,
    side: u32,
    factor: f64,
    job: *const medax_job,
    out_axis: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let crust = &handle::get(crust, "crust")?.crust;
        let side = super::crust::label(side)?;
        let out = Out::new(out_axis, "out_axis")?;
        let mut own = None;
        let axis = crust.scale_axis(side, factor, handle::job(job, &mut own))?;
        out.put(complex::give(Arc::new(axis)));
        Ok(())
    })
}

/// How far a power shape is simplified.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_simplify_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// Poles go whose samples are all within this distance of each other, in input units; negative, as by default, for a hundredth
    /// of the diagonal of the samples' box.
    pub epsilon: f64,
    /// Poles go whose balls lie in that of a larger ball, grown by this, in input units; negative, as by default, for three
    /// thousandths of the diagonal.
    pub delta: f64,
}

sized_struct!(medax_simplify_options,
    first_size: size_of::<medax_simplify_options>(), reserved: none,
    { epsilon: f64 = -1.0, delta: f64 = -1.0 });

/// Sets simplify options to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_simplify_options_init(
    options: *mut medax_simplify_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// Simplifies a power crust: unstable poles go, then redundant ones, inner and outer alike, and the power diagram of what is left is
/// calculated anew.
///
/// A pole is unstable if no two samples on its ball are farther apart than epsilon; a ball that touches the far box is stable. Of
/// the others, a pole is redundant if its ball lies in that of another one of its side, which is larger, grown by delta. Balls are looked
/// at from the largest to the smallest.
///
/// \param crust The power crust.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_simplified Receives the result, which the caller frees with #medax_simplified_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for an epsilon or a delta that is not finite; `TOO_FEW_POINTS` or `DEGENERATE` where
///         too few poles are left; `NULL_ARGUMENT`, `LIMIT_EXCEEDED`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// One regular triangulation, of what is left. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_simplify(
    crust: *const medax_power_crust,
    options: *const medax_simplify_options,
    job: *const medax_job,
    out_simplified: *mut *const medax_simplified,
) -> medax_status {
    boundary::status(|| {
        let crust = &handle::get(crust, "crust")?.crust;
        let options = options::read(options, "options")?;
        let out = Out::new(out_simplified, "out_simplified")?;
        // What is not a number is not negative: the library refuses it.
        let given = |value: f64| if value < 0.0 { None } else { Some(value) };
        let options =
            SimplifyOptions { epsilon: given(options.epsilon), delta: given(options.delta) };
        let mut own = None;
        let simplified = crust.simplify(options, handle::job(job, &mut own))?;
        out.put(handle::new(medax_simplified { simplified }));
        Ok(())
    })
}

/// The power crust of the poles that are left.
///
/// \param simplified The result.
/// \param out_crust Receives the power crust, which the caller frees with #medax_power_crust_free.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_simplified_crust(
    simplified: *const medax_simplified,
    out_crust: *mut *const medax_power_crust,
) -> medax_status {
    boundary::status(|| {
        let crust = handle::get(simplified, "simplified")?.simplified.crust.clone();
        let out = Out::new(out_crust, "out_crust")?;
        out.put(handle::new(medax_power_crust { crust }));
        Ok(())
    })
}

/// The epsilon that was used.
///
/// \param simplified The result, or NULL.
/// \return In input units; 0 for NULL.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_simplified_epsilon(simplified: *const medax_simplified) -> f64 {
    boundary::value(0.0, || handle::maybe(simplified).map_or(0.0, |s| s.simplified.epsilon))
}

/// The delta that was used.
///
/// \param simplified The result, or NULL.
/// \return In input units; 0 for NULL.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_simplified_delta(simplified: *const medax_simplified) -> f64 {
    boundary::value(0.0, || handle::maybe(simplified).map_or(0.0, |s| s.simplified.delta))
}

/// The poles that were unstable.
///
/// \param simplified The result, or NULL.
/// \return Poles, ascending. Borrowed from `simplified`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_simplified_unstable(
    simplified: *const medax_simplified,
) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], 1), || {
        let unstable = handle::maybe(simplified).map_or(&[][..], |s| &s.simplified.unstable);
        medax_view_u32::new(unstable, 1)
    })
}

/// The poles that were redundant, and which pole keeps the place of each.
///
/// \param simplified The result, or NULL.
/// \return Rows of two poles, ascending: the one that went, and the one that is left, whose ball, grown by delta, holds the other's.
///         Borrowed from `simplified`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_simplified_redundant(
    simplified: *const medax_simplified,
) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], 2), || {
        let redundant = handle::maybe(simplified).map_or(&[][..], |s| &s.simplified.redundant);
        medax_view_u32::new(redundant.as_flattened(), 2)
    })
}

/// One more reference to the result of a simplification.
///
/// \param simplified The result, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_simplified_clone(
    simplified: *const medax_simplified,
) -> *const medax_simplified {
    boundary::value(ptr::null(), || handle::clone(simplified))
}

/// Gives one reference to the result of a simplification back; the last one frees it.
///
/// \param simplified The result; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_simplified_free(simplified: *const medax_simplified) {
    boundary::value((), || handle::free(simplified));
}

/// Which faces of a power crust fill holes.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_hole_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// The two balls of a face intersect deeply where -cos of the angle between their spheres exceeds this; in [0, 1], 0.1 by
    /// default.
    pub depth: f64,
    /// And both radii exceed this, in input units; 0 by default.
    pub radius: f64,
}

sized_struct!(medax_hole_options, first_size: size_of::<medax_hole_options>(), reserved: none,
    { depth: f64 = 0.1, radius: f64 = 0.0 });

/// Sets hole options to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_hole_options_init(
    options: *mut medax_hole_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// The surface of a power crust without the faces that fill holes: those between an inner and an outer ball that intersect
/// deeply and are large.
///
/// \param crust The power crust.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_surface Receives the faces that are left, which the caller frees with #medax_complex_free; #medax_complex_topology counts
///        its boundary loops.
/// \param out_left_out Receives the faces that were left out, with the attribute `face`, their numbers in the whole surface;
///        the caller frees it with #medax_complex_free. NULL if it is not wanted.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for options out of range; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_open(
    crust: *const medax_power_crust,
    options: *const medax_hole_options,
    job: *const medax_job,
    out_surface: *mut *const medax_complex,
    out_left_out: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let crust = &handle::get(crust, "crust")?.crust;
        let options = options::read(options, "options")?;
        let surface = Out::new(out_surface, "out_surface")?;
        let left_out = match out_left_out.is_null() {
            true => None,
            false => Some(Out::new(out_left_out, "out_left_out")?),
        };
        let options = HoleOptions { depth: options.depth, radius: options.radius };
        let mut own = None;
        let open = crust.open(options, handle::job(job, &mut own))?;
        surface.put(complex::give(Arc::new(open.surface)));
        if let Some(out) = left_out {
            out.put(complex::give(Arc::new(open.left_out)));
        }
        Ok(())
    })
}

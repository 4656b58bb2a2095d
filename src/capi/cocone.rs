//! Cocone
//!
//! Surfaces through the samples, made of Delaunay triangles. Cocone chooses the triangles whose dual Voronoi edges pass through the
//! tangent planes of their corners; its surface is open where the sample is too sparse. Tight Cocone marks the cells on both
//! sides of it and peels off what is outside: its surface is the boundary of the cells that are left, closed for every sample.
//! (Amenta, Choi, Dey, Leekha 2002, A simple algorithm for homeomorphic surface reconstruction; Dey, Goswami 2003, Tight Cocone.)

use super::boundary;
use super::complex;
use super::handle::{self, medax_cocone, medax_complex, medax_dual, medax_job};
use super::options::{self, sized_struct};
use super::status::medax_status;
use super::validation::{self, medax_validation};
use super::view::{Out, medax_view_u8};
use crate::cocone::{Cocone, CoconeOptions};
use crate::complex::Complex;
use std::f64::consts::{FRAC_PI_6, FRAC_PI_8};
use std::ptr;
use std::sync::Arc;

/// The settings of Cocone and Tight Cocone.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_cocone_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// How far from the tangent plane at a sample a Voronoi edge of the surface may pass, in radians between 0 and pi/2; pi/8 by default.
    pub angle: f64,
    /// How many times as far as the corners of its tangent polygon the poles of a sample are at least that is dense enough;
    /// not negative, 1.2 by default.
    pub ratio: f64,
    /// The largest angle between the pole vectors of neighbours that are dense enough, in radians between 0 and pi/2; pi/6 by
    /// default.
    pub normal_angle: f64,
}

sized_struct!(medax_cocone_options,
    first_size: size_of::<medax_cocone_options>(), reserved: none,
    { angle: f64 = FRAC_PI_8, ratio: f64 = 1.2, normal_angle: f64 = FRAC_PI_6 });

/// Sets cocone options to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_cocone_options_init(
    options: *mut medax_cocone_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// Builds both surfaces from the Voronoi diagram of a sample.
///
/// \param dual The dual of a Delaunay triangulation, which the result keeps alive.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_cocone Receives the surfaces, which the caller frees with #medax_cocone_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for a power diagram and for options out of range; `MISMATCH` for the dual of points with
///         the far box; `DEGENERATE` where no cell is inside; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(m) for m cells, besides sorting. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_cocone_build(
    dual: *const medax_dual,
    options: *const medax_cocone_options,
    job: *const medax_job,
    out_cocone: *mut *const medax_cocone,
) -> medax_status {
    boundary::status(|| {
        let dual = &handle::get(dual, "dual")?.dual;
        let asked = options::read(options, "options")?;
        let out = Out::new(out_cocone, "out_cocone")?;
        let options = CoconeOptions {
            angle: asked.angle,
            ratio: asked.ratio,
            normal_angle: asked.normal_angle,
        };
        let mut own = None;
        let cocone = Cocone::new(dual, options, handle::job(job, &mut own))?;
        out.put(handle::new(medax_cocone { cocone: Arc::new(cocone) }));
        Ok(())
    })
}

/// The watertight surface of Tight Cocone: the triangles between inner and outer cells, which point out of the solid. Every edge is in an even
/// number of them. Vertices have the attribute `sample`, the vertex of the points that they are.
///
/// \param cocone The surfaces.
/// \param out_surface Receives the surface, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_cocone_surface(
    cocone: *const medax_cocone,
    out_surface: *mut *const medax_complex,
) -> medax_status {
    surface(cocone, out_surface, Cocone::surface)
}

/// The surface of Cocone alone, which has a boundary where the sample is too sparse. Vertices have the attribute `sample`.
///
/// \param cocone The surfaces.
/// \param out_surface Receives the surface, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_cocone_open_surface(
    cocone: *const medax_cocone,
    out_surface: *mut *const medax_complex,
) -> medax_status {
    surface(cocone, out_surface, Cocone::open_surface)
}

unsafe fn surface(
    cocone: *const medax_cocone,
    out_surface: *mut *const medax_complex,
    read: fn(&Cocone) -> &Arc<Complex>,
) -> medax_status {
    boundary::status(|| {
        let cocone = &handle::get(cocone, "cocone")?.cocone;
        let out = Out::new(out_surface, "out_surface")?;
        out.put(complex::give(read(cocone).clone()));
        Ok(())
    })
}

/// Whether each cell of the triangulation is inside the watertight surface.
///
/// \param cocone The surfaces, or NULL.
/// \return m x 1 flags, 0 or 1, in the order of #medax_triangulation_cells. Borrowed from `cocone`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_cocone_is_inner(cocone: *const medax_cocone) -> medax_view_u8 {
    flags(cocone, Cocone::is_inner)
}

/// Whether each sample is too sparse beside its neighbours for Cocone to trust it.
///
/// \param cocone The surfaces, or NULL.
/// \return n x 1 flags, 0 or 1, one for each vertex of the points. Borrowed from `cocone`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_cocone_is_undersampled(
    cocone: *const medax_cocone,
) -> medax_view_u8 {
    flags(cocone, Cocone::is_undersampled)
}

/// Whether the triangles round each sample are a disk that divides inside from outside. Triangles of undersampled points count here,
/// which are not in the open surface.
///
/// \param cocone The surfaces, or NULL.
/// \return n x 1 flags, 0 or 1, one for each vertex of the points. Borrowed from `cocone`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_cocone_is_well_sampled(
    cocone: *const medax_cocone,
) -> medax_view_u8 {
    flags(cocone, Cocone::is_well_sampled)
}

unsafe fn flags(cocone: *const medax_cocone, read: fn(&Cocone) -> &[bool]) -> medax_view_u8 {
    boundary::value(medax_view_u8::of_flags(&[]), || {
        medax_view_u8::of_flags(handle::maybe(cocone).map_or(&[][..], |c| read(&c.cocone)))
    })
}

/// The number of cells that well sampled vertices mark as inner or outer. What is left of the others, when those outside are peeled off, is
/// inner.
///
/// \param cocone The surfaces; NULL has none.
/// \return The number of cells.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_cocone_marked_count(cocone: *const medax_cocone) -> usize {
    boundary::value(0, || handle::maybe(cocone).map_or(0, |c| c.cocone.marked()))
}

/// The number of samples that the watertight surface has as vertices.
///
/// \param cocone The surfaces; NULL has none.
/// \return The number of samples used; by n the share of them.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_cocone_used_count(cocone: *const medax_cocone) -> usize {
    boundary::value(0, || handle::maybe(cocone).map_or(0, |c| c.cocone.used()))
}

/// Checks the surfaces by other means than those that made them.
///
/// \param cocone The surfaces.
/// \param job NULL for a default job.
/// \param out_report Filled, its `struct_size` being set.
/// \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report
///         of no version, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(m log m). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_cocone_validate(
    cocone: *const medax_cocone,
    job: *const medax_job,
    out_report: *mut medax_validation,
) -> medax_status {
    validation::validate(job, out_report, |job| handle::get(cocone, "cocone")?.cocone.validate(job))
}

/// One more reference to surfaces.
///
/// \param cocone The surfaces, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_cocone_clone(cocone: *const medax_cocone) -> *const medax_cocone {
    boundary::value(ptr::null(), || handle::clone(cocone))
}

/// Gives one reference to surfaces back; the last one frees them.
///
/// \param cocone The surfaces; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_cocone_free(cocone: *const medax_cocone) {
    boundary::value((), || handle::free(cocone));
}

//! Flattening
//!
//! Power shapes have tetrahedra, most of them flat: these collapse to their triangles, and the homotopy type stays.

use super::boundary;
use super::complex;
use super::handle::{self, medax_complex, medax_flattened, medax_job};
use super::options::{self, sized_struct};
use super::status::medax_status;
use super::view::{Out, medax_view_u32};
use crate::complex::FlattenOptions;
use std::ptr;
use std::sync::Arc;

/// Which tetrahedra are flat.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_flatten_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// Those whose least altitude is at most this share of their longest edge, 0.1 by default: of a regular tetrahedron it is 0.816.
    /// Infinity stands for all.
    pub flatness: f64,
}

sized_struct!(medax_flatten_options, first_size: size_of::<medax_flatten_options>(),
    reserved: none, { flatness: f64 = 0.1 });

/// Sets flatten options to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flatten_options_init(
    options: *mut medax_flatten_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// Collapses flat tetrahedra to their triangles, without changing the homotopy type.
///
/// A tetrahedron goes together with a triangle that bounds no other cell; its other three triangles stay, no edge and no vertex goes.
/// That is done as long as there is a flat tetrahedron with such a triangle. At each step no point that goes is farther from what stays than
/// the altitude over that triangle; the least altitude goes first. Attributes stay.
///
/// \param complex The complex, such as a power shape.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_flattened Receives the result, which the caller frees with #medax_flattened_free.
/// \return `MEDAX_STATUS_OK`, also where flat tetrahedra are left; `INVALID_ARGUMENT` for a flatness that is negative or NaN;
///         `NULL_ARGUMENT`, `LIMIT_EXCEEDED`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(n log n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_flatten(
    complex: *const medax_complex,
    options: *const medax_flatten_options,
    job: *const medax_job,
    out_flattened: *mut *const medax_flattened,
) -> medax_status {
    boundary::status(|| {
        let complex = &handle::get(complex, "complex")?.complex;
        let out = Out::new(out_flattened, "out_flattened")?;
        let given = options::read(options, "options")?;
        let options = FlattenOptions { flatness: given.flatness };
        let mut own = None;
        let flattened = complex.flatten(options, handle::job(job, &mut own))?;
        out.put(handle::new(medax_flattened {
            complex: Arc::new(flattened.complex),
            collapses: flattened.collapses,
            left: flattened.left,
        }));
        Ok(())
    })
}

/// The complex that is left.
///
/// \param flattened The result.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flattened_complex(
    flattened: *const medax_flattened,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let complex = handle::get(flattened, "flattened")?.complex.clone();
        let out = Out::new(out_complex, "out_complex")?;
        out.put(complex::give(complex));
        Ok(())
    })
}

/// The tetrahedra that went, in order.
///
/// \param flattened The result, or NULL.
/// \return Rows of two: a tetrahedron's number among the cells of the given complex, and its vertex opposite the triangle that went with it.
///         Borrowed from `flattened`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flattened_collapses(
    flattened: *const medax_flattened,
) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], 2), || {
        let collapses = handle::maybe(flattened).map_or(&[][..], |f| &f.collapses);
        medax_view_u32::new(collapses.as_flattened(), 2)
    })
}

/// The number of flat tetrahedra that could not go, as each of their triangles bounds another cell.
///
/// \param flattened The result; NULL has none.
/// \return The number of tetrahedra.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flattened_left_count(flattened: *const medax_flattened) -> usize {
    boundary::value(0, || handle::maybe(flattened).map_or(0, |f| f.left))
}

/// One more reference to the result of a flattening.
///
/// \param flattened The result, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flattened_clone(
    flattened: *const medax_flattened,
) -> *const medax_flattened {
    boundary::value(ptr::null(), || handle::clone(flattened))
}

/// Gives one reference to the result of a flattening back; the last one frees it.
///
/// \param flattened The result; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flattened_free(flattened: *const medax_flattened) {
    boundary::value((), || handle::free(flattened));
}

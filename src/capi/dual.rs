//! Dual
//!
//! The Voronoi diagram of a Delaunay triangulation, or the power diagram of a regular one. A Voronoi
//! vertex is dual to a cell of the triangulation, an edge to a facet, a facet to an edge, a
//! Voronoi cell to a vertex. What is unbounded continues along rays, one for each facet of the hull.

use super::boundary;
use super::handle::{self, medax_dual, medax_job, medax_triangulation};
use super::options::{self, flag, sized_struct};
use super::status::medax_status;
use super::validation::{self, medax_validation};
use super::view::{Out, medax_view_f64, medax_view_rows, medax_view_u32};
use crate::Dual;
use crate::dual::{DualOptions, Facets};
use std::ptr;
use std::sync::Arc;

/// What a dual holds besides centres, squared radii and rays.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_dual_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// 1 keeps the Voronoi facets: a ring of cells for each edge. 0, the default: none.
    pub facets: u32,
    /// Must be 0.
    pub reserved: u32,
}

sized_struct!(medax_dual_options, first_size: size_of::<medax_dual_options>(),
    reserved: reserved, { facets: u32 = 0, reserved: u32 = 0 });

/// Sets dual options to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_dual_options_init(
    options: *mut medax_dual_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// Reads the dual off a triangulation.
///
/// \param triangulation The triangulation, which the dual keeps alive.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_dual Receives the dual, which the caller frees with #medax_dual_free.
/// \return `MEDAX_STATUS_OK`; `LIMIT_EXCEEDED` where the rings of facets have more than 2^32 - 1 entries
///         together; `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(m) for m cells. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_dual_build(
    triangulation: *const medax_triangulation,
    options: *const medax_dual_options,
    job: *const medax_job,
    out_dual: *mut *const medax_dual,
) -> medax_status {
    boundary::status(|| {
        let triangulation = &handle::get(triangulation, "triangulation")?.triangulation;
        let options = options::read(options, "options")?;
        let options = DualOptions { facets: flag(options.facets, "facets")? };
        let out = Out::new(out_dual, "out_dual")?;
        let mut own = None;
        let dual = Dual::new(triangulation, options, handle::job(job, &mut own))?;
        out.put(handle::new(medax_dual { dual: Arc::new(dual) }));
        Ok(())
    })
}

/// The triangulation of a dual.
///
/// \param dual The dual.
/// \param out_triangulation Receives the triangulation, which the caller frees with
///        #medax_triangulation_free.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_dual_triangulation(
    dual: *const medax_dual,
    out_triangulation: *mut *const medax_triangulation,
) -> medax_status {
    boundary::status(|| {
        let dual = &handle::get(dual, "dual")?.dual;
        let out = Out::new(out_triangulation, "out_triangulation")?;
        out.put(handle::new(medax_triangulation { triangulation: dual.triangulation().clone() }));
        Ok(())
    })
}

/// The Voronoi vertex of each cell: its circumcentre, or its orthocentre in a power diagram.
///
/// \param dual The dual, or NULL.
/// \return m x 3, in input units, correctly rounded; never NaN or infinite. Borrowed from `dual`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_dual_centers(dual: *const medax_dual) -> medax_view_f64 {
    floats(dual, 3, |d| d.centers().as_flattened())
}

/// The squared radius of each cell's sphere; negative where weights are large.
///
/// \param dual The dual, or NULL.
/// \return m x 1, in squared input units, correctly rounded; never NaN or infinite. Borrowed from
///         `dual`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_dual_radii_squared(dual: *const medax_dual) -> medax_view_f64 {
    floats(dual, 1, Dual::radii_squared)
}

/// Where the unbounded Voronoi edges begin and leave: facets of the hull.
///
/// \param dual The dual, or NULL.
/// \return r x 2, ascending: a cell, at whose centre the ray begins, and the facet 0 to 3 of that cell
///         whose plane it crosses at a right angle. Borrowed from `dual`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_dual_ray_facets(dual: *const medax_dual) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], 2), || {
        let facets = handle::maybe(dual).map_or(&[][..], |d| d.dual.rays().facets());
        medax_view_u32::new(facets.as_flattened(), 2)
    })
}

/// The directions of the unbounded Voronoi edges.
///
/// \param dual The dual, or NULL.
/// \return r x 3 unit vectors, outward. Borrowed from `dual`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_dual_ray_directions(dual: *const medax_dual) -> medax_view_f64 {
    floats(dual, 3, |d| d.rays().directions().as_flattened())
}

/// The facets of the diagram: each the ring of the centres of its cells.
///
/// \param dual The dual, or NULL.
/// \return One row a facet, in the order of #medax_dual_facet_edges: cells, each the neighbour of the
///         one before, counterclockwise round the edge from its lesser vertex to the greater. A bounded
///         facet's ring is closed and begins with its least cell. An unbounded one's is open: rays
///         continue it. No row unless the options asked for facets. Borrowed from `dual`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_dual_facets(dual: *const medax_dual) -> medax_view_rows {
    boundary::value(medax_view_rows::EMPTY, || {
        facets(dual).map_or(medax_view_rows::EMPTY, |facets| {
            medax_view_rows::new(facets.offsets(), facets.cells())
        })
    })
}

/// The edge of the triangulation to which each facet is dual.
///
/// \param dual The dual, or NULL.
/// \return f x 2 vertices, the lesser first, ascending; no row unless the options asked for facets.
///         Borrowed from `dual`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_dual_facet_edges(dual: *const medax_dual) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], 2), || {
        medax_view_u32::new(facets(dual).map_or(&[][..], |f| f.edges().as_flattened()), 2)
    })
}

/// The rays of each facet.
///
/// \param dual The dual, or NULL.
/// \return f x 2 rays: the one that comes in from infinity to the first cell, and the one that goes
///         out from the last; `MEDAX_NONE` twice for a bounded facet. No row unless the options
///         asked for facets. Borrowed from `dual`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_dual_facet_rays(dual: *const medax_dual) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], 2), || {
        medax_view_u32::new(facets(dual).map_or(&[][..], |f| f.rays().as_flattened()), 2)
    })
}

unsafe fn facets<'a>(dual: *const medax_dual) -> Option<&'a Facets> {
    handle::maybe(dual).and_then(|d| d.dual.facets())
}

unsafe fn floats(
    dual: *const medax_dual,
    cols: usize,
    read: fn(&Dual) -> &[f64],
) -> medax_view_f64 {
    boundary::value(medax_view_f64::new(&[], cols), || {
        medax_view_f64::new(handle::maybe(dual).map_or(&[][..], |d| read(&d.dual)), cols)
    })
}

/// Checks a dual: that each centre has the same power with respect to its cell's vertices, that rays are
/// normal to the hull, that rings are sound.
///
/// \param dual The dual.
/// \param job NULL for a default job.
/// \param out_report Filled, its `struct_size` being set.
/// \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report
///         of no version, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(m). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_dual_validate(
    dual: *const medax_dual,
    job: *const medax_job,
    out_report: *mut medax_validation,
) -> medax_status {
    validation::validate(job, out_report, |job| handle::get(dual, "dual")?.dual.validate(job))
}

/// One more reference to a dual.
///
/// \param dual The dual, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_dual_clone(dual: *const medax_dual) -> *const medax_dual {
    boundary::value(ptr::null(), || handle::clone(dual))
}

/// Gives one reference to a dual back; the last one frees it.
///
/// \param dual The dual; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_dual_free(dual: *const medax_dual) {
    boundary::value((), || handle::free(dual));
}

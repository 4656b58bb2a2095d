//! Sizes
//!
//! Two lengths that a power crust knows of any point. The local feature size is the distance to the medial axis, estimated by that to
//! the nearest pole: a mesh with edges in proportion to it follows the surface (Amenta, Bern 1999, Surface reconstruction by Voronoi
//! filtering). The thickness of the solid at a sample is the diameter of the sample's inner polar ball, which touches the surface there and
//! on the other side; any other point has the thickness at the nearest sample.

use super::boundary;
use super::complex;
use super::handle::{self, medax_complex, medax_job, medax_power_crust};
use super::status::medax_status;
use super::view::{self, Buffer, Out};
use std::sync::Arc;

/// The local feature size and the thickness at any points.
///
/// The feature size is the distance to the nearest pole whose ball the power crust has, inner or outer. The thickness is the diameter
/// of the inner ball of the nearest sample that has one, of several as near that of the least number; of two inner balls the larger counts. A
/// sample may have none, because its poles were left out, are both outer, or their balls vanished. Balls have the radii
/// that they have in this power crust: those of an offset the changed ones.
///
/// \param crust The power crust.
/// \param query_xyz `query_count` x 3 coordinates; NULL only if `query_count` is 0.
/// \param query_count The number of points.
/// \param job NULL for a default job.
/// \param out_feature_size Receives `query_count` lengths in input units; the caller's buffer, NULL only if `query_count` is 0.
/// \param out_thickness Receives `query_count` lengths in input units, 0 if no sample has an inner ball; the caller's buffer, NULL only if
///        `query_count` is 0.
/// \return `MEDAX_STATUS_OK`; `NON_FINITE`, or `COORDINATE_RANGE` beyond 2^200, with the row of a query;
///         `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(log n) a query, and O(n log n) once, in the first call. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_sizes_at(
    crust: *const medax_power_crust,
    query_xyz: *const f64,
    query_count: usize,
    job: *const medax_job,
    out_feature_size: *mut f64,
    out_thickness: *mut f64,
) -> medax_status {
    boundary::status(|| {
        let crust = &handle::get(crust, "crust")?.crust;
        let queries = view::rows(query_xyz, query_count, "query_xyz")?;
        let feature_size = Buffer::new(out_feature_size, query_count, "out_feature_size")?;
        let thickness = Buffer::new(out_thickness, query_count, "out_thickness")?;
        let mut own = None;
        let sizes = crust.sizes_at(queries, handle::job(job, &mut own))?;
        feature_size.fill(&sizes.feature_size);
        thickness.fill(&sizes.thickness);
        Ok(())
    })
}

/// The distinct samples as vertices, in spatial order, with the attributes `feature_size`, `thickness` and `row`, the first input row of
/// each.
///
/// \param crust The power crust.
/// \param job NULL for a default job.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(n log n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_samples_complex(
    crust: *const medax_power_crust,
    job: *const medax_job,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let crust = &handle::get(crust, "crust")?.crust;
        let out = Out::new(out_complex, "out_complex")?;
        let mut own = None;
        let samples = crust.samples_to_complex(handle::job(job, &mut own))?;
        out.put(complex::give(Arc::new(samples)));
        Ok(())
    })
}

/// A complex with the sizes at its vertices, as the attributes `feature_size` and `thickness`, which take the place of any that have
/// these names: the surface of the power crust, a part of it, or another mesh of the same thing.
///
/// \param crust The power crust.
/// \param complex The complex.
/// \param job NULL for a default job.
/// \param out_complex Receives the complex with the attributes, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`; `COORDINATE_RANGE` with a vertex beyond 2^200; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(log n) a vertex, and O(n log n) once, in the first call. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_with_sizes(
    crust: *const medax_power_crust,
    complex: *const medax_complex,
    job: *const medax_job,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let crust = &handle::get(crust, "crust")?.crust;
        let given = &handle::get(complex, "complex")?.complex;
        let out = Out::new(out_complex, "out_complex")?;
        let mut own = None;
        let sized = crust.with_sizes(given, handle::job(job, &mut own))?;
        out.put(complex::give(Arc::new(sized)));
        Ok(())
    })
}

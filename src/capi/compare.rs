//! Comparison
//!
//! How far two complexes are apart as sets of points: their faces, loose edges and cells, which are
//! solid; or their vertices, where they have none of these.

use super::boundary;
use super::handle::{self, medax_complex, medax_job};
use super::options::{self, Report, SizedStruct, sized_struct};
use super::status::medax_status;
use crate::complex::{CompareOptions, Comparison, compare};

/// The settings of a comparison.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_compare_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// The number of samples on each side, 100000 by default. With 0 the vertices serve.
    pub samples: u64,
    /// Chooses the samples, 0 by default. The same seed gives the same samples everywhere.
    pub seed: u64,
}

sized_struct!(medax_compare_options, first_size: size_of::<medax_compare_options>(),
    reserved: none, { samples: u64 = 100_000, seed: u64 = 0 });

/// Sets compare options to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_compare_options_init(
    options: *mut medax_compare_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// Distances in input units. The caller sets `struct_size`, the library the rest.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_comparison {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// The largest distance from vertices and samples of `a` to `b`: the one-sided Hausdorff distance,
    /// or a little less.
    pub a_to_b_max: f64,
    /// The mean distance from samples of `a` to `b`.
    pub a_to_b_mean: f64,
    /// The root of the mean squared distance from samples of `a` to `b`.
    pub a_to_b_rms: f64,
    /// As `a_to_b_max`, the other way.
    pub b_to_a_max: f64,
    /// As `a_to_b_mean`, the other way.
    pub b_to_a_mean: f64,
    /// As `a_to_b_rms`, the other way.
    pub b_to_a_rms: f64,
    /// The diagonal of the smallest axis-parallel box that holds both.
    pub diagonal: f64,
}

sized_struct!(medax_comparison, first_size: size_of::<medax_comparison>(), reserved: none, {
    a_to_b_max: f64 = 0.0,
    a_to_b_mean: f64 = 0.0,
    a_to_b_rms: f64 = 0.0,
    b_to_a_max: f64 = 0.0,
    b_to_a_mean: f64 = 0.0,
    b_to_a_rms: f64 = 0.0,
    diagonal: f64 = 0.0,
});

impl From<Comparison> for medax_comparison {
    fn from(found: Comparison) -> Self {
        medax_comparison {
            a_to_b_max: found.a_to_b.max,
            a_to_b_mean: found.a_to_b.mean,
            a_to_b_rms: found.a_to_b.rms,
            b_to_a_max: found.b_to_a.max,
            b_to_a_mean: found.b_to_a.mean,
            b_to_a_rms: found.b_to_a.rms,
            diagonal: found.diagonal,
            ..Self::DEFAULT
        }
    }
}

/// The distances between two complexes.
///
/// \param a The one complex.
/// \param b The other one, which may be the same.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_report Filled, its `struct_size` being set.
/// \return `MEDAX_STATUS_OK`; `TOO_FEW_POINTS` when a side has no vertex; `COORDINATE_RANGE` when a
///         distance is past the range of a double; `NULL_ARGUMENT`, `INVALID_ARGUMENT`,
///         `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O((n + samples) log n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_compare(
    a: *const medax_complex,
    b: *const medax_complex,
    options: *const medax_compare_options,
    job: *const medax_job,
    out_report: *mut medax_comparison,
) -> medax_status {
    boundary::status(|| {
        let a = &handle::get(a, "a")?.complex;
        let b = &handle::get(b, "b")?.complex;
        let given = options::read(options, "options")?;
        let samples = usize::try_from(given.samples).unwrap_or(usize::MAX);
        let options = CompareOptions { samples, seed: given.seed };
        let report = Report::new(out_report, "out_report")?;
        let mut own = None;
        report.fill(&compare(a, b, &options, handle::job(job, &mut own))?.into());
        Ok(())
    })
}

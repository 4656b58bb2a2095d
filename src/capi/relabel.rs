//! Power crusts with other labels
//!
//! Labels can be given by the host, or be told by a mesh whose inside is known. Poles and the regular triangulation stay;
//! the surface and the shapes are made anew.

use super::boundary;
use super::crust;
use super::handle::{self, medax_complex, medax_job, medax_power_crust};
use super::status::medax_status;
use super::view::{self, Out};
use crate::error::{ElementKind, Result};
use std::sync::Arc;

/// The same poles with other labels.
///
/// An inner pole with an unbounded power cell becomes outer, and is counted by #medax_power_crust_forced_count. Offsets and simplified power
/// crusts of the result keep the labels.
///
/// \param crust The power crust.
/// \param labels `label_count` values: a #medax_label for each pole, in the order of #medax_power_crust_labels.
/// \param label_count The number of labels, which is that of the poles.
/// \param job NULL for a default job.
/// \param out_crust Receives the power crust with these labels, which the caller frees with #medax_power_crust_free.
/// \return `MEDAX_STATUS_OK`; `MISMATCH` unless there is one label per pole; `INVALID_ARGUMENT` with the row of a number that is no
///         label; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size), without a triangulation. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_with_labels(
    crust: *const medax_power_crust,
    labels: *const u32,
    label_count: usize,
    job: *const medax_job,
    out_crust: *mut *const medax_power_crust,
) -> medax_status {
    boundary::status(|| {
        let crust = &handle::get(crust, "crust")?.crust;
        let numbers = view::slice(labels, label_count, "labels")?;
        let out = Out::new(out_crust, "out_crust")?;
        let label = |(row, &number): (usize, &u32)| {
            crust::label(number).map_err(|error| error.at(ElementKind::Row, row as u64))
        };
        let labels = numbers.iter().enumerate().map(label).collect::<Result<Vec<_>>>()?;
        let mut own = None;
        let relabelled = crust.with_labels(&labels, handle::job(job, &mut own))?;
        out.put(handle::new(medax_power_crust { crust: Arc::new(relabelled) }));
        Ok(())
    })
}

/// The same poles, labelled by a mesh: inner are those round whose centres its faces wind more than half a time, by
/// #medax_complex_winding_numbers.
///
/// Faces must point out of the solid, and those of voids into them; where shells overlap is inside. Holes are closed where the number passes through
/// one half. Of a mesh that is turned inside out no pole is inner, and the surface is empty: #medax_complex_orient turns it. The samples need not
/// be the mesh's vertices. The rest is as for #medax_power_crust_with_labels.
///
/// \param crust The power crust.
/// \param mesh The mesh, as a complex with faces.
/// \param job NULL for a default job.
/// \param out_crust Receives the power crust with these labels, which the caller frees with #medax_power_crust_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for a mesh without faces; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O((n + p) log n) for n triangles and p poles, without a triangulation. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_power_crust_labelled_by_mesh(
    crust: *const medax_power_crust,
    mesh: *const medax_complex,
    job: *const medax_job,
    out_crust: *mut *const medax_power_crust,
) -> medax_status {
    boundary::status(|| {
        let crust = &handle::get(crust, "crust")?.crust;
        let mesh = &handle::get(mesh, "mesh")?.complex;
        let out = Out::new(out_crust, "out_crust")?;
        let mut own = None;
        let relabelled = crust.labelled_by_mesh(mesh, handle::job(job, &mut own))?;
        out.put(handle::new(medax_power_crust { crust: Arc::new(relabelled) }));
        Ok(())
    })
}

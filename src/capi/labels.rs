//! Labels of cells
//!
//! For each cell of a Delaunay triangulation of samples whether it lies in the solid: where a mesh or a power crust tells, whether its Voronoi
//! vertex does, and not its barycentre, since flat cells in the surface are nowhere. Inner axes take these labels, wherever they come from.

use super::boundary;
use super::handle::{
    self, medax_cocone, medax_complex, medax_dual, medax_job, medax_labels, medax_power_crust,
    medax_triangulation,
};
use super::options::flag;
use super::status::medax_status;
use super::view::{self, Out, medax_view_u8};
use crate::error::{ElementKind, Result};
use crate::labels::Labels;
use std::ptr;
use std::sync::Arc;

/// Labels that the caller has found.
///
/// \param triangulation The triangulation, which the labels keep alive.
/// \param is_inner `count` flags, in the order of #medax_triangulation_cells: 1 for a cell in the solid, 0 for one outside. Copied.
/// \param count The number of flags, which is that of the cells.
/// \param out_labels Receives the labels, which the caller frees with #medax_labels_free.
/// \return `MEDAX_STATUS_OK`; `MISMATCH` unless there is one flag per cell; `INVALID_ARGUMENT` with the cell of a flag that is
///         neither; `NULL_ARGUMENT`.
///
/// O(m) for m cells. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_labels_create(
    triangulation: *const medax_triangulation,
    is_inner: *const u8,
    count: usize,
    out_labels: *mut *const medax_labels,
) -> medax_status {
    boundary::status(|| {
        let triangulation = &handle::get(triangulation, "triangulation")?.triangulation;
        let flags = view::slice(is_inner, count, "is_inner")?;
        let out = Out::new(out_labels, "out_labels")?;
        let label = |(cell, &number): (usize, &u8)| {
            flag(u32::from(number), "is_inner")
                .map_err(|error| error.at(ElementKind::Cell, cell as u64))
        };
        let is_inner = flags.iter().enumerate().map(label).collect::<Result<Vec<_>>>()?;
        out.put(give(Labels::new(triangulation, is_inner)?));
        Ok(())
    })
}

/// Labels from Tight Cocone: the cells that its watertight surface encloses are inner.
///
/// \param cocone The surfaces, whose triangulation the labels keep alive.
/// \param job NULL for a default job.
/// \param out_labels Receives the labels, which the caller frees with #medax_labels_free.
/// \return `MEDAX_STATUS_OK`; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(m) for m cells. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_labels_of_cocone(
    cocone: *const medax_cocone,
    job: *const medax_job,
    out_labels: *mut *const medax_labels,
) -> medax_status {
    boundary::status(|| {
        let cocone = &handle::get(cocone, "cocone")?.cocone;
        let out = Out::new(out_labels, "out_labels")?;
        let mut own = None;
        out.put(give(Labels::of_cocone(cocone, handle::job(job, &mut own))?));
        Ok(())
    })
}

/// Labels from a power crust of the same samples: a cell is inner where its Voronoi vertex lies in the power cell of an inner pole, in the
/// solid that the power crust bounds.
///
/// \param dual The Voronoi diagram of the samples, whose triangulation the labels keep alive.
/// \param crust The power crust.
/// \param job NULL for a default job.
/// \param out_labels Receives the labels, which the caller frees with #medax_labels_free.
/// \return `MEDAX_STATUS_OK`; `MISMATCH` for a power crust of other samples; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`,
///         `OUT_OF_MEMORY`.
///
/// About O(m) for m cells. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_labels_of_crust(
    dual: *const medax_dual,
    crust: *const medax_power_crust,
    job: *const medax_job,
    out_labels: *mut *const medax_labels,
) -> medax_status {
    boundary::status(|| {
        let dual = &handle::get(dual, "dual")?.dual;
        let crust = &handle::get(crust, "crust")?.crust;
        let out = Out::new(out_labels, "out_labels")?;
        let mut own = None;
        out.put(give(Labels::of_crust(dual, crust, handle::job(job, &mut own))?));
        Ok(())
    })
}

/// Labels from a mesh of the solid: a cell is inner where the faces wind round its Voronoi vertex more than half a time, by
/// #medax_complex_winding_numbers.
///
/// Faces must point out of the solid, and those of voids into them; small holes are bridged. The samples need not be the mesh's
/// vertices.
///
/// \param dual The Voronoi diagram of the samples, whose triangulation the labels keep alive.
/// \param mesh The mesh, as a complex with faces.
/// \param job NULL for a default job.
/// \param out_labels Receives the labels, which the caller frees with #medax_labels_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for a mesh without faces; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`,
///         `OUT_OF_MEMORY`.
///
/// O((n + m) log n) for n triangles and m cells. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_labels_of_mesh(
    dual: *const medax_dual,
    mesh: *const medax_complex,
    job: *const medax_job,
    out_labels: *mut *const medax_labels,
) -> medax_status {
    boundary::status(|| {
        let dual = &handle::get(dual, "dual")?.dual;
        let mesh = &handle::get(mesh, "mesh")?.complex;
        let out = Out::new(out_labels, "out_labels")?;
        let mut own = None;
        out.put(give(Labels::of_mesh(dual, mesh, handle::job(job, &mut own))?));
        Ok(())
    })
}

fn give(labels: Labels) -> *const medax_labels {
    handle::new(medax_labels { labels: Arc::new(labels) })
}

/// The triangulation whose cells have the labels.
///
/// \param labels The labels.
/// \param out_triangulation Receives the triangulation, which the caller frees with
///        #medax_triangulation_free.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_labels_triangulation(
    labels: *const medax_labels,
    out_triangulation: *mut *const medax_triangulation,
) -> medax_status {
    boundary::status(|| {
        let labels = &handle::get(labels, "labels")?.labels;
        let out = Out::new(out_triangulation, "out_triangulation")?;
        out.put(handle::new(medax_triangulation { triangulation: labels.triangulation().clone() }));
        Ok(())
    })
}

/// Whether each cell lies in the solid.
///
/// \param labels The labels, or NULL.
/// \return m x 1 flags, 0 or 1, in the order of #medax_triangulation_cells. Borrowed from `labels`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_labels_is_inner(labels: *const medax_labels) -> medax_view_u8 {
    boundary::value(medax_view_u8::of_flags(&[]), || {
        medax_view_u8::of_flags(handle::maybe(labels).map_or(&[][..], |l| l.labels.is_inner()))
    })
}

/// The number of cells in the solid.
///
/// \param labels The labels; NULL has none.
/// \return The number of inner cells.
///
/// O(m). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_labels_inner_count(labels: *const medax_labels) -> usize {
    boundary::value(0, || handle::maybe(labels).map_or(0, |l| l.labels.inner_count()))
}

/// In how many cells two labellings of one triangulation differ.
///
/// \param a The one.
/// \param b The other one, which may be the same; its triangulation must be the same as that of `a`, or equal to it.
/// \param out_count Receives the number of cells.
/// \return `MEDAX_STATUS_OK`; `MISMATCH` for labels of another triangulation; `NULL_ARGUMENT`.
///
/// O(m). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_labels_disagreement(
    a: *const medax_labels,
    b: *const medax_labels,
    out_count: *mut usize,
) -> medax_status {
    boundary::status(|| {
        let a = &handle::get(a, "a")?.labels;
        let b = &handle::get(b, "b")?.labels;
        let out = Out::new(out_count, "out_count")?;
        out.put(a.disagreement(b)?);
        Ok(())
    })
}

/// One more reference to labels.
///
/// \param labels The labels, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_labels_clone(labels: *const medax_labels) -> *const medax_labels {
    boundary::value(ptr::null(), || handle::clone(labels))
}

/// Gives one reference to labels back; the last one frees them.
///
/// \param labels The labels; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_labels_free(labels: *const medax_labels) {
    boundary::value((), || handle::free(labels));
}

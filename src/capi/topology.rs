//! Topology
//!
//! What a complex is as a set of elements that share others, told from its indices alone: vertices
//! that merely lie at the same place are different vertices. And what its coordinates make of that: measures, triangles that intersect.

use super::boundary;
use super::complex;
use super::handle::{self, medax_complex, medax_intersections, medax_job};
use super::options::{Report, SizedStruct, sized_struct};
use super::status::medax_status;
use super::validation::{self, medax_validation};
use super::view::{Out, medax_view_u32};
use crate::complex::Topology;
use std::ptr;
use std::sync::Arc;

/// The topology of a complex. The caller sets `struct_size`, the library the rest.
///
/// What is listed twice counts once. An edge is a pair of vertices: a side of a face, of a facet of a
/// volume cell, or a loose edge. Fields from `boundary_edges` to `oriented` tell about the
/// surface: the listed faces, without facets that belong to volume cells only.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_topology {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// The number of vertices, isolated ones included.
    pub vertices: u64,
    /// The number of vertices that no face, edge or cell uses.
    pub isolated_vertices: u64,
    /// The number of distinct edges.
    pub edges: u64,
    /// The number of distinct faces, facets of volume cells included.
    pub faces: u64,
    /// The number of distinct volume cells.
    pub cells: u64,
    /// The number of connected components, isolated vertices included.
    pub components: u64,
    /// `vertices - edges + faces - cells`.
    pub euler_characteristic: i64,
    /// The number of edges on exactly one side of a face.
    pub boundary_edges: u64,
    /// The number of curves that the boundary edges form.
    pub boundary_loops: u64,
    /// The number of edges on more than two sides of faces.
    pub nonmanifold_edges: u64,
    /// The number of vertices at which the faces are neither a disk nor a half disk.
    pub nonmanifold_vertices: u64,
    /// The genus, summed over the components; 0 unless `has_genus`.
    pub genus: u64,
    /// The Betti numbers b0, b1, b2 over Z/2 of all of the complex, cells included.
    pub betti: [u64; 3],
    /// 1 if the complex is an orientable manifold surface, so that it has a genus.
    pub has_genus: u32,
    /// 1 if there is a face, and every edge lies on an even number of sides.
    pub closed: u32,
    /// 1 if there is a face, and every edge but those of the boundary is run by its faces equally
    /// often both ways.
    pub oriented: u32,
    /// 0.
    pub reserved: u32,
}

sized_struct!(medax_topology, first_size: size_of::<medax_topology>(), reserved: none, {
    vertices: u64 = 0,
    isolated_vertices: u64 = 0,
    edges: u64 = 0,
    faces: u64 = 0,
    cells: u64 = 0,
    components: u64 = 0,
    euler_characteristic: i64 = 0,
    boundary_edges: u64 = 0,
    boundary_loops: u64 = 0,
    nonmanifold_edges: u64 = 0,
    nonmanifold_vertices: u64 = 0,
    genus: u64 = 0,
    betti: [u64; 3] = [0; 3],
    has_genus: u32 = 0,
    closed: u32 = 0,
    oriented: u32 = 0,
    reserved: u32 = 0,
});

impl From<Topology> for medax_topology {
    fn from(found: Topology) -> Self {
        medax_topology {
            vertices: found.vertices,
            isolated_vertices: found.isolated_vertices,
            edges: found.edges,
            faces: found.faces,
            cells: found.cells,
            components: found.components,
            euler_characteristic: found.euler_characteristic,
            boundary_edges: found.boundary_edges,
            boundary_loops: found.boundary_loops,
            nonmanifold_edges: found.nonmanifold_edges,
            nonmanifold_vertices: found.nonmanifold_vertices,
            genus: found.genus.unwrap_or(0),
            betti: found.betti,
            has_genus: u32::from(found.genus.is_some()),
            closed: u32::from(found.closed),
            oriented: u32::from(found.oriented),
            ..Self::DEFAULT
        }
    }
}

/// The topology of a complex.
///
/// \param complex The complex.
/// \param job NULL for a default job.
/// \param out_report Filled, its `struct_size` being set.
/// \return `MEDAX_STATUS_OK`; `LIMIT_EXCEEDED` past 2^31 - 1 sides of faces and facets;
///         `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report of no version, `CANCELLED`, `BUSY`,
///         `OUT_OF_MEMORY`.
///
/// Close to linear, unless many sheets of faces meet along seams. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_topology(
    complex: *const medax_complex,
    job: *const medax_job,
    out_report: *mut medax_topology,
) -> medax_status {
    boundary::status(|| {
        let complex = &handle::get(complex, "complex")?.complex;
        let report = Report::new(out_report, "out_report")?;
        let mut own = None;
        report.fill(&complex.topology(handle::job(job, &mut own))?.into());
        Ok(())
    })
}

/// The area of the faces and the volume that they enclose.
///
/// \param complex The complex.
/// \param job NULL for a default job.
/// \param out_area Receives the area in squared input units; or NULL.
/// \param out_volume Receives the volume in cubed input units: positive where faces point out, and with
///        a meaning for closed, oriented surfaces only; or NULL.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_measure(
    complex: *const medax_complex,
    job: *const medax_job,
    out_area: *mut f64,
    out_volume: *mut f64,
) -> medax_status {
    boundary::status(|| {
        let complex = &handle::get(complex, "complex")?.complex;
        let mut own = None;
        let found = complex.measure(handle::job(job, &mut own))?;
        Out::maybe(out_area, found.area);
        Out::maybe(out_volume, found.volume);
        Ok(())
    })
}

/// The pairs of triangles of a complex that intersect, decided exactly.
///
/// Two triangles of #medax_complex_triangles intersect if they have a point in common that is on no vertex and no edge that
/// they share, that is, that has the same vertex numbers. A triangle without area is a segment or a point.
///
/// \param complex The complex.
/// \param job NULL for a default job.
/// \param out_intersections Receives the intersections, which the caller frees with #medax_intersections_free.
/// \return `MEDAX_STATUS_OK`, also where there are none; `COORDINATE_RANGE` with a triangle's vertex that has a coordinate outside
///         2^-160 to 2^200; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(n log n + b) with b pairs of triangles whose boxes meet. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_self_intersections(
    complex: *const medax_complex,
    job: *const medax_job,
    out_intersections: *mut *const medax_intersections,
) -> medax_status {
    boundary::status(|| {
        let complex = &handle::get(complex, "complex")?.complex;
        let out = Out::new(out_intersections, "out_intersections")?;
        let mut own = None;
        let pairs = complex.self_intersections(handle::job(job, &mut own))?;
        out.put(handle::new(medax_intersections { pairs }));
        Ok(())
    })
}

/// The pairs of triangles that intersect.
///
/// \param intersections The intersections, or NULL.
/// \return i x 2 numbers of triangles, the less one first; pairs ascend. Borrowed from `intersections`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_intersections_pairs(
    intersections: *const medax_intersections,
) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], 2), || {
        let pairs = handle::maybe(intersections).map_or(&[][..], |i| &i.pairs);
        medax_view_u32::new(pairs.as_flattened(), 2)
    })
}

/// One more reference to intersections.
///
/// \param intersections The intersections, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_intersections_clone(
    intersections: *const medax_intersections,
) -> *const medax_intersections {
    boundary::value(ptr::null(), || handle::clone(intersections))
}

/// Gives one reference to intersections back; the last one frees them.
///
/// \param intersections The intersections; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_intersections_free(intersections: *const medax_intersections) {
    boundary::value((), || handle::free(intersections));
}

/// The same complex with its faces turned so that neighbours agree and solids are inside; shells
/// of voids point into the void. A turned face keeps its first vertex; attributes stay.
///
/// \param complex The complex.
/// \param job NULL for a default job.
/// \param out_oriented Receives the new complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`; `LIMIT_EXCEEDED` past 2^31 - 1 sides of faces and facets;
///         `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(n log n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_orient(
    complex: *const medax_complex,
    job: *const medax_job,
    out_oriented: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let complex = &handle::get(complex, "complex")?.complex;
        let out = Out::new(out_oriented, "out_oriented")?;
        let mut own = None;
        let oriented = complex.oriented(handle::job(job, &mut own))?;
        out.put(complex::give(Arc::new(oriented)));
        Ok(())
    })
}

/// Checks a complex: indices, rings, finite coordinates, triangles, attributes.
///
/// \param complex The complex.
/// \param job NULL for a default job.
/// \param out_report Filled, its `struct_size` being set.
/// \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report
///         of no version, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_validate(
    complex: *const medax_complex,
    job: *const medax_job,
    out_report: *mut medax_validation,
) -> medax_status {
    validation::validate(job, out_report, |job| {
        handle::get(complex, "complex")?.complex.validate(job)
    })
}

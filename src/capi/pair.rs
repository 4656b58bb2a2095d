//! Pair-mesh
//!
//! A solid between an inner structure and its boundary, in pyramids and tetrahedra, each with some vertices on either. A node pairs a vertex of
//! the boundary with an inner one; an element is a ring of nodes. With each node so far on the way from its inner vertex (t = 0) to that of the boundary
//! (t = 1), nodes and rings are a closed surface for every t. (Shaham, Shamir, Cohen-Or 2004, Medial axis based solid representation.)

use super::boundary;
use super::complex;
use super::handle::{self, medax_complex, medax_dual, medax_job, medax_labels, medax_pair};
use super::status::medax_status;
use super::validation::{self, medax_validation};
use super::view::{Buffer, Out, medax_view_f64, medax_view_rows, medax_view_u32};
use crate::complex::{Complex, Rows};
use crate::error::Result;
use crate::job::Job;
use crate::pair::PairMesh;
use std::ptr;
use std::sync::Arc;

/// The kinds of elements. (Shaham, Shamir, Cohen-Or 2004, figure 1.)
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum medax_pair_element {
    /// A pyramid with a vertex of the boundary over a face of the inner structure.
    FaceVertex = 1,
    /// A tetrahedron between an edge of the inner structure and one of the boundary.
    EdgeEdge = 2,
    /// A tetrahedron with an inner vertex over a triangle of the boundary.
    VertexFace = 3,
}

/// The pair-mesh between the inner part of a Voronoi diagram and the surface between inner and outer cells.
///
/// It always succeeds. Samples of which all cells are inner are removed, and the rest is triangulated anew. Voronoi vertices of cells that
/// share a sphere are one. Where an element would be turned inside out, inner vertices are moved, no farther than they must; a facet that is no longer
/// planar is divided into triangles round a vertex in its middle. The surface stays as it is.
///
/// \param dual The Voronoi diagram of the samples, which must have its facets.
/// \param labels Which of its cells are inner: by Tight Cocone, a power crust, a mesh, or the caller.
/// \param job NULL for a default job.
/// \param out_pair Receives the pair-mesh, which the caller frees with #medax_pair_free.
/// \return `MEDAX_STATUS_OK`; `DEGENERATE` where no cell is inner; `INVALID_ARGUMENT` for a power diagram, or one without facets; `MISMATCH`
///         for labels of another triangulation; `LIMIT_EXCEEDED` past 2^32 - 1 corners; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`,
///         `OUT_OF_MEMORY`.
///
/// O(size of the dual), besides what is mended. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_voronoi(
    dual: *const medax_dual,
    labels: *const medax_labels,
    job: *const medax_job,
    out_pair: *mut *const medax_pair,
) -> medax_status {
    boundary::status(|| {
        let dual = &handle::get(dual, "dual")?.dual;
        let labels = &handle::get(labels, "labels")?.labels;
        let out = Out::new(out_pair, "out_pair")?;
        let mut own = None;
        let pair = PairMesh::voronoi(dual, labels, handle::job(job, &mut own))?;
        out.put(handle::new(medax_pair { pair }));
        Ok(())
    })
}

/// The number of elements of a kind. Elements stand by kind: pyramids first, those over both sides of inner face `f` are `2 * f` and
/// `2 * f + 1`; then those between edges; then those over the triangles of the boundary.
///
/// \param pair The pair-mesh; NULL has none.
/// \param kind A #medax_pair_element, or 0 for all.
/// \return The number of elements; 0 for a kind that is none.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_element_count(pair: *const medax_pair, kind: u32) -> usize {
    boundary::value(0, || {
        use medax_pair_element::{EdgeEdge, FaceVertex, VertexFace};
        let kinds = [FaceVertex, EdgeEdge, VertexFace].map(|of| of as u32);
        handle::maybe(pair).map_or(0, |p| {
            let of_kinds = kinds.into_iter().zip(p.pair.counts());
            of_kinds.filter(|&(of, _)| kind == 0 || kind == of).map(|(_, count)| count).sum()
        })
    })
}

/// The vertices of the boundary.
///
/// \param pair The pair-mesh, or NULL.
/// \return n x 3 coordinates. Borrowed from `pair`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_boundary_vertices(pair: *const medax_pair) -> medax_view_f64 {
    floats(pair, 3, |pair| pair.boundary_vertices().as_flattened())
}

/// The sample that each vertex of the boundary is; `MEDAX_NONE` for one by which triangles were divided (#medax_pair_onto).
///
/// \param pair The pair-mesh, or NULL.
/// \return n x 1 vertices of the triangulation. Borrowed from `pair`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_boundary_samples(pair: *const medax_pair) -> medax_view_u32 {
    indices(pair, 1, |pair| pair.sample_of_boundary())
}

/// The inner vertices.
///
/// \param pair The pair-mesh, or NULL.
/// \return m x 3 coordinates. Borrowed from `pair`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_inner_vertices(pair: *const medax_pair) -> medax_view_f64 {
    floats(pair, 3, |pair| pair.inner_vertices().as_flattened())
}

/// The cell of which each inner vertex is the Voronoi vertex, of several the least.
///
/// \param pair The pair-mesh, or NULL.
/// \return m x 1 cells; `MEDAX_NONE` for a vertex in the middle of a facet, and throughout where samples were removed. Borrowed from `pair`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_inner_cells(pair: *const medax_pair) -> medax_view_u32 {
    indices(pair, 1, |pair| pair.cell_of_inner())
}

/// Where each inner vertex would be, had nothing been turned inside out.
///
/// \param pair The pair-mesh, or NULL.
/// \return m x 3 coordinates. Borrowed from `pair`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_voronoi_vertices(pair: *const medax_pair) -> medax_view_f64 {
    floats(pair, 3, |pair| pair.voronoi_vertices().as_flattened())
}

/// The faces of the inner structure.
///
/// \param pair The pair-mesh, or NULL.
/// \return One row a face: inner vertices, counterclockwise seen from the apex of the second of its two pyramids. Borrowed from `pair`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_inner_faces(pair: *const medax_pair) -> medax_view_rows {
    rows(pair, PairMesh::inner_faces)
}

/// The nodes.
///
/// \param pair The pair-mesh, or NULL.
/// \return k x 2: a vertex of the boundary, an inner vertex. Borrowed from `pair`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_nodes(pair: *const medax_pair) -> medax_view_u32 {
    indices(pair, 2, |pair| pair.nodes().as_flattened())
}

/// The elements, each as its nodes.
///
/// \param pair The pair-mesh, or NULL.
/// \return One row an element, counterclockwise seen from the boundary: of a pyramid its apex with each corner of its base; of an element between two edges the ends of the boundary's with the first end of the inner one, then, the other way round, with the second; of one over a triangle its corners. Borrowed from `pair`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_rings(pair: *const medax_pair) -> medax_view_rows {
    rows(pair, PairMesh::rings)
}

/// The samples inside the solid, which were removed.
///
/// \param pair The pair-mesh, or NULL.
/// \return Vertices of the triangulation, ascending. Borrowed from `pair`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_removed(pair: *const medax_pair) -> medax_view_u32 {
    indices(pair, 1, |pair| pair.removed())
}

/// The volume that the boundary encloses.
///
/// \param pair The pair-mesh; NULL encloses nothing.
/// \return The volume, in cubed input units.
///
/// O(triangles). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_enclosed_volume(pair: *const medax_pair) -> f64 {
    boundary::value(0.0, || handle::maybe(pair).map_or(0.0, |p| p.pair.enclosed_volume()))
}

/// The volume of each element; less than 0 where one is turned inside out, or by rounding where it has next to none: #medax_pair_folded decides exactly.
///
/// \param pair The pair-mesh.
/// \param job NULL for a default job.
/// \param out_volumes Receives a number for each element, in cubed input units; the caller's buffer.
/// \return `MEDAX_STATUS_OK`; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_volumes(
    pair: *const medax_pair,
    job: *const medax_job,
    out_volumes: *mut f64,
) -> medax_status {
    boundary::status(|| fill(pair, job, out_volumes, "out_volumes", PairMesh::volumes))
}

/// The centroid of each element; of one without volume the mean of its corners.
///
/// \param pair The pair-mesh.
/// \param job NULL for a default job.
/// \param out_centroids Receives 3 coordinates for each element; the caller's buffer.
/// \return `MEDAX_STATUS_OK`; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_centroids(
    pair: *const medax_pair,
    job: *const medax_job,
    out_centroids: *mut f64,
) -> medax_status {
    boundary::status(|| {
        fill(pair, job, out_centroids.cast::<[f64; 3]>(), "out_centroids", PairMesh::centroids)
    })
}

/// The shell of each element: the closed surface that it is a face of for every t. Shells are numbered from 0 as they come.
///
/// \param pair The pair-mesh.
/// \param job NULL for a default job.
/// \param out_shells Receives a number for each element; the caller's buffer.
/// \return `MEDAX_STATUS_OK`; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_shells(
    pair: *const medax_pair,
    job: *const medax_job,
    out_shells: *mut u32,
) -> medax_status {
    boundary::status(|| fill(pair, job, out_shells, "out_shells", PairMesh::shells))
}

/// The elements that are turned inside out, in part or as a whole: some tetrahedron has a volume that is exactly less than 0. None of a pair-mesh as
/// it is built, but where rounding leaves no other place; those of one that was deformed may be many.
///
/// \param pair The pair-mesh.
/// \param job NULL for a default job.
/// \param out_folded Receives these elements, ascending; the caller's buffer, with room for as many as there are elements. The rest is left as it is.
/// \param out_count Receives how many they are.
/// \return `MEDAX_STATUS_OK`; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_folded(
    pair: *const medax_pair,
    job: *const medax_job,
    out_folded: *mut u32,
    out_count: *mut usize,
) -> medax_status {
    boundary::status(|| {
        let pair = &handle::get(pair, "pair")?.pair;
        let out = Buffer::new(out_folded, pair.element_count(), "out_folded")?;
        let count = Out::new(out_count, "out_count")?;
        let mut own = None;
        let folded = pair.folded(handle::job(job, &mut own))?;
        count.put(folded.len());
        out.fill(&folded);
        Ok(())
    })
}

/// The surface on which each node is so far on the way from its inner vertex to its vertex of the boundary.
///
/// For t below 1 its vertices are the nodes and its faces the rings, the same for every t; for t = 0 it wraps the inner structure, and its two sides
/// coincide. For t = 1 it is the boundary itself, vertex for vertex. Faces are convex, and planar but for rounding. Vertices carry `sample` and `inner_vertex`, faces
/// `element` and `kind`; those of the boundary `sample` and `element`.
///
/// \param pair The pair-mesh.
/// \param t How far, in [0, 1].
/// \param job NULL for a default job.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for another t; `LIMIT_EXCEEDED` past 2^32 - 2 elements; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`,
///         `OUT_OF_MEMORY`.
///
/// O(size). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_iso_surface(
    pair: *const medax_pair,
    t: f64,
    job: *const medax_job,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| give(pair, job, out_complex, |pair, job| pair.iso_surface(t, job)))
}

/// The solid as volume cells, an element each: tetrahedra, and pyramids over faces of more than three corners.
///
/// Vertices are those of the boundary, then the inner ones, with `t` (1 on the boundary, 0 inside) and `sample`; cells carry `kind` and `volume`.
///
/// \param pair The pair-mesh.
/// \param job NULL for a default job.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`; `LIMIT_EXCEEDED` past 2^32 - 2 elements; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_solid(
    pair: *const medax_pair,
    job: *const medax_job,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| give(pair, job, out_complex, PairMesh::solid))
}

/// The boundary: triangles that point out of the solid. Vertices carry `sample`, faces `element`.
///
/// \param pair The pair-mesh.
/// \param job NULL for a default job.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`; `LIMIT_EXCEEDED` past 2^32 - 2 elements; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_boundary(
    pair: *const medax_pair,
    job: *const medax_job,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| give(pair, job, out_complex, PairMesh::boundary))
}

/// The inner structure: its faces, and the edges that belong to none. Vertices carry `cell` and `moved`, how far they are from where they would be,
/// had nothing been turned inside out; faces `samples`, those of their two pyramids; loose edges `samples`, three of those round them; faces and edges `reason`, a #medax_pair_reason.
///
/// \param pair The pair-mesh.
/// \param job NULL for a default job.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`; `LIMIT_EXCEEDED` past 2^32 - 2 elements; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_inner(
    pair: *const medax_pair,
    job: *const medax_job,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| give(pair, job, out_complex, PairMesh::inner))
}

/// Checks that the elements are a partition of the solid: their sides meet in pairs, none is turned inside out but for rounding, and their volumes sum up to what the
/// boundary encloses.
///
/// \param pair The pair-mesh.
/// \param job NULL for a default job.
/// \param out_report Filled, its `struct_size` being set.
/// \return `MEDAX_STATUS_OK`, whatever is found; `INVALID_ARGUMENT` for a report of no version; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_validate(
    pair: *const medax_pair,
    job: *const medax_job,
    out_report: *mut medax_validation,
) -> medax_status {
    validation::validate(job, out_report, |job| handle::get(pair, "pair")?.pair.validate(job))
}

/// One more reference to a pair-mesh.
///
/// \param pair The pair-mesh, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_clone(pair: *const medax_pair) -> *const medax_pair {
    boundary::value(ptr::null(), || handle::clone(pair))
}

/// Gives one reference to a pair-mesh back; the last one frees it.
///
/// \param pair The pair-mesh; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_free(pair: *const medax_pair) {
    boundary::value((), || handle::free(pair));
}

unsafe fn floats(
    pair: *const medax_pair,
    cols: usize,
    read: fn(&PairMesh) -> &[f64],
) -> medax_view_f64 {
    boundary::value(medax_view_f64::new(&[], cols), || {
        medax_view_f64::new(handle::maybe(pair).map_or(&[][..], |p| read(&p.pair)), cols)
    })
}

unsafe fn indices(
    pair: *const medax_pair,
    cols: usize,
    read: fn(&PairMesh) -> &[u32],
) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], cols), || {
        medax_view_u32::new(handle::maybe(pair).map_or(&[][..], |p| read(&p.pair)), cols)
    })
}

unsafe fn rows(pair: *const medax_pair, read: fn(&PairMesh) -> &Rows) -> medax_view_rows {
    boundary::value(medax_view_rows::EMPTY, || {
        handle::maybe(pair).map_or(medax_view_rows::EMPTY, |p| {
            let rows = read(&p.pair);
            medax_view_rows::new(rows.offsets(), rows.indices())
        })
    })
}

unsafe fn give(
    pair: *const medax_pair,
    job: *const medax_job,
    out_complex: *mut *const medax_complex,
    make: impl FnOnce(&PairMesh, &Job) -> Result<Complex>,
) -> Result<()> {
    let pair = &handle::get(pair, "pair")?.pair;
    let out = Out::new(out_complex, "out_complex")?;
    let mut own = None;
    out.put(complex::give(Arc::new(make(pair, handle::job(job, &mut own))?)));
    Ok(())
}

unsafe fn fill<T: Copy>(
    pair: *const medax_pair,
    job: *const medax_job,
    out: *mut T,
    name: &str,
    values: impl FnOnce(&PairMesh, &Job) -> Result<Vec<T>>,
) -> Result<()> {
    let pair = &handle::get(pair, "pair")?.pair;
    let out = Buffer::new(out, pair.element_count(), name)?;
    let mut own = None;
    out.fill(&values(pair, handle::job(job, &mut own))?);
    Ok(())
}

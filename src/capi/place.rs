//! Place
//!
//! Coordinates in a pair-mesh: which element holds a point, and how far it is between the inner structure and the boundary; and deformations, in
//! which each node keeps its vector.

use super::boundary;
use super::handle::{self, medax_job, medax_pair};
use super::status::medax_status;
use super::view::{self, Buffer, Out};
use crate::error::{ElementKind, Error, Result, Status};
use crate::job::Job;
use crate::pair::{PairMesh, PairPlace};

/// A point of a solid.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct medax_place {
    /// The element, or `MEDAX_NONE` for a point outside the solid.
    pub element: u32,
    /// The number of a tetrahedron of it, as #medax_pair_piece takes it.
    pub piece: u32,
    /// How much each corner of that weighs: barycentric coordinates, whose sum is 1. NaN outside.
    pub weights: [f64; 4],
    /// How far the point is on the way from the inner structure (0) to the boundary (1). NaN outside.
    pub t: f64,
}

impl From<PairPlace> for medax_place {
    fn from(PairPlace { element, piece, weights, t }: PairPlace) -> Self {
        medax_place { element, piece, weights, t }
    }
}

/// The place of each point; of several elements that share it the least. Which tetrahedron holds a point is decided exactly.
///
/// \param pair The pair-mesh.
/// \param query_xyz `query_count` x 3 coordinates; NULL only if `query_count` is 0.
/// \param query_count The number of points.
/// \param job NULL for a default job.
/// \param out_places Receives `query_count` places; the caller's buffer, NULL only if `query_count` is 0.
/// \return `MEDAX_STATUS_OK`; `NON_FINITE`, or `COORDINATE_RANGE`, with the row of a query; `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`,
///         `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size log size), then about O(log size) a query: ask for many at once. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_locate(
    pair: *const medax_pair,
    query_xyz: *const f64,
    query_count: usize,
    job: *const medax_job,
    out_places: *mut medax_place,
) -> medax_status {
    boundary::status(|| {
        let pair = &handle::get(pair, "pair")?.pair;
        let queries = view::rows(query_xyz, query_count, "query_xyz")?;
        let out = Buffer::new(out_places, query_count, "out_places")?;
        let mut own = None;
        out.fill_from(&pair.locate(queries, handle::job(job, &mut own))?);
        Ok(())
    })
}

/// The points at some places: the weighted means of the corners, whatever the weights.
///
/// \param pair The pair-mesh.
/// \param places `place_count` places, of which `t` counts for nothing; NULL only if `place_count` is 0.
/// \param place_count The number of places.
/// \param out_xyz Receives `place_count` x 3 coordinates; the caller's buffer, NULL only if `place_count` is 0.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` with the row of a place whose element or tetrahedron is not there; `NULL_ARGUMENT`.
///
/// O(places). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_positions(
    pair: *const medax_pair,
    places: *const medax_place,
    place_count: usize,
    out_xyz: *mut f64,
) -> medax_status {
    boundary::status(|| {
        let pair = &handle::get(pair, "pair")?.pair;
        let places = view::slice(places, place_count, "places")?;
        let out = Buffer::new(out_xyz.cast::<[f64; 3]>(), place_count, "out_xyz")?;
        for (row, place) in (0..).zip(places) {
            check(pair, place.element, place.piece).map_err(|e| e.at(ElementKind::Row, row))?;
        }
        out.fill_with(places.iter().map(|&medax_place { element, piece, weights, t }| {
            pair.position(&PairPlace { element, piece, weights, t })
        }));
        Ok(())
    })
}

/// The corners of a tetrahedron of an element, positively oriented. An element between two edges, or over a triangle, is one; a pyramid over k corners is k - 2,
/// its apex with a fan of its base, the same from both sides of a face.
///
/// \param pair The pair-mesh.
/// \param element The element.
/// \param piece The number of the tetrahedron.
/// \param out_corners Receives four vertices: those of the boundary count first, then the inner ones.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` with an element that is not there, or that has no such tetrahedron; `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_piece(
    pair: *const medax_pair,
    element: u32,
    piece: u32,
    out_corners: *mut u32,
) -> medax_status {
    boundary::status(|| {
        let pair = &handle::get(pair, "pair")?.pair;
        let out = Out::new(out_corners.cast::<[u32; 4]>(), "out_corners")?;
        check(pair, element, piece).map_err(|e| e.at(ElementKind::Cell, u64::from(element)))?;
        out.put(pair.piece(element, piece));
        Ok(())
    })
}

fn check(pair: &PairMesh, element: u32, piece: u32) -> Result<()> {
    if (element as usize) < pair.element_count() && piece < pair.piece_count(element) {
        return Ok(());
    }
    let message = format!("there is no tetrahedron {piece} of an element {element}");
    Err(Error::new(Status::InvalidArgument, message))
}

/// The mesh with the inner vertices at other places, and each vertex of the boundary moved by the mean of what the inner vertices of its nodes are moved by.
/// #medax_pair_folded tells which elements that turns inside out.
///
/// \param pair The pair-mesh, which stays as it is.
/// \param inner_xyz `inner_count` x 3 coordinates, one row for each inner vertex.
/// \param inner_count How many.
/// \param job NULL for a default job.
/// \param out_pair Receives the pair-mesh, which the caller frees with #medax_pair_free.
/// \return `MEDAX_STATUS_OK`; `MISMATCH` for another number of vertices; `NON_FINITE` and `COORDINATE_RANGE` with the vertex; `NULL_ARGUMENT`,
///         `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_with_inner(
    pair: *const medax_pair,
    inner_xyz: *const f64,
    inner_count: usize,
    job: *const medax_job,
    out_pair: *mut *const medax_pair,
) -> medax_status {
    boundary::status(|| {
        let places = view::rows(inner_xyz, inner_count, "inner_xyz")?;
        moved(pair, places, job, out_pair, PairMesh::with_inner)
    })
}

/// The mesh with the vertices of the boundary at other places, and each inner vertex moved by the mean of what the boundary vertices of its nodes are moved by.
///
/// \param pair The pair-mesh, which stays as it is.
/// \param boundary_xyz `boundary_count` x 3 coordinates, one row for each vertex of the boundary.
/// \param boundary_count How many.
/// \param job NULL for a default job.
/// \param out_pair Receives the pair-mesh, which the caller frees with #medax_pair_free.
/// \return As #medax_pair_with_inner.
///
/// O(size). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_with_boundary(
    pair: *const medax_pair,
    boundary_xyz: *const f64,
    boundary_count: usize,
    job: *const medax_job,
    out_pair: *mut *const medax_pair,
) -> medax_status {
    boundary::status(|| {
        let places = view::rows(boundary_xyz, boundary_count, "boundary_xyz")?;
        moved(pair, places, job, out_pair, PairMesh::with_boundary)
    })
}

unsafe fn moved(
    pair: *const medax_pair,
    places: &[[f64; 3]],
    job: *const medax_job,
    out_pair: *mut *const medax_pair,
    with: fn(&PairMesh, &[[f64; 3]], &Job) -> Result<PairMesh>,
) -> Result<()> {
    let pair = &handle::get(pair, "pair")?.pair;
    let out = Out::new(out_pair, "out_pair")?;
    let mut own = None;
    let pair = with(pair, places, handle::job(job, &mut own))?;
    out.put(handle::new(medax_pair { pair }));
    Ok(())
}

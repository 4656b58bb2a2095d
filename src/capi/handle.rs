//! Handles
//!
//! Every structure is immutable once created, and counted by reference.
//!
//! A handle is passed as `const T *` and may be used from any thread at any time; only the last
//! `free` must come last. What is built from a handle keeps what it needs of it alive, so that
//! handles may be freed in any order. Freeing NULL does nothing.

#![deny(unsafe_op_in_unsafe_fn, clippy::undocumented_unsafe_blocks)]

use super::view::null;
use crate::error::Result;
use crate::job::Job;
use std::ffi::CString;
use std::sync::Arc;

/// How to run a build: threads, memory ceiling, progress, cancel.
pub struct medax_job {
    pub(super) job: Job,
}

/// Distinct points in spatial order, with maps from and to the input's rows.
pub struct medax_points {
    pub(super) points: Arc<crate::Points>,
}

/// A Delaunay or regular triangulation: finite cells and their neighbours.
pub struct medax_triangulation {
    pub(super) triangulation: Arc<crate::Triangulation>,
}

/// The cells of each vertex of a triangulation, and its edges.
pub struct medax_incidence {
    pub(super) cells: crate::triangulation::Incidence,
    pub(super) edges: crate::triangulation::Edges,
}

/// The Voronoi or power diagram that is dual to a triangulation.
pub struct medax_dual {
    pub(super) dual: Arc<crate::Dual>,
}

/// Samples of a surface with its normals.
pub struct medax_samples {
    pub(super) samples: crate::sample::Samples,
}

/// What a file holds, before points or a complex are made of it.
pub struct medax_file {
    pub(super) soup: crate::io::Soup,
    /// The names of the attributes, terminated for C.
    pub(super) names: Vec<CString>,
}

/// Sentences about what a file did not hold, or what was left out of it.
pub struct medax_warnings {
    pub(super) texts: Vec<CString>,
}

/// The poles of a sample, and their balls.
pub struct medax_poles {
    pub(super) poles: Arc<crate::Poles>,
}

/// A power crust with all that it was made from.
pub struct medax_power_crust {
    pub(super) crust: Arc<crate::PowerCrust>,
}

/// A simplified power crust, and what became of the poles.
pub struct medax_simplified {
    pub(super) simplified: crate::crust::Simplified,
}

/// Cocone and Tight Cocone of a sample.
pub struct medax_cocone {
    pub(super) cocone: Arc<crate::Cocone>,
}

/// For each cell of a Delaunay triangulation whether it lies in the solid.
pub struct medax_labels {
    pub(super) labels: Arc<crate::labels::Labels>,
}

/// Every Voronoi facet of a sample with what decides whether it belongs to the medial axis.
pub struct medax_medial {
    pub(super) medial: crate::medial::Medial,
}

/// The flow of the distance to a sample: its critical points, and where it goes.
pub struct medax_flow {
    pub(super) flow: Arc<crate::flow::Flow>,
}

/// The unstable flow complex of a sample, and its flow DAG.
pub struct medax_flow_complex {
    pub(super) flow_complex: crate::flow::FlowComplex,
}

/// Vertices, polygons, loose edges, volume cells and named attributes: every result that can be
/// drawn or written.
pub struct medax_complex {
    pub(super) complex: Arc<crate::Complex>,
    /// The names of the attributes, terminated for C.
    pub(super) names: Vec<CString>,
}

/// Polygons with holes, open polylines, points and circles in the plane.
pub struct medax_figure {
    pub(super) figure: Arc<crate::Figure>,
}

/// The pairs of triangles of a complex that intersect.
pub struct medax_intersections {
    pub(super) pairs: Vec<[u32; 2]>,
}

/// A complex without its flat tetrahedra, and what became of them.
pub struct medax_flattened {
    pub(super) complex: Arc<crate::Complex>,
    pub(super) collapses: Vec<[u32; 2]>,
    pub(super) left: usize,
}

/// Pieces that distances are measured to: points, segments, rays, lines, circles, triangles, spheres.
pub struct medax_sites {
    pub(super) sites: Arc<crate::distance::Sites>,
}

/// All that is nearest to each of some points.
pub struct medax_all_nearest {
    pub(super) all: super::distance::AllColumns,
}

/// Points of the medial axis of sites, and where they were looked for.
pub struct medax_field_axis {
    pub(super) axis: crate::distance::FieldAxis,
    pub(super) points: super::medial_points::MedialPoints,
}

/// The medial axis of sites in the plane as a graph.
pub struct medax_medial_graph {
    pub(super) graph: crate::distance::MedialGraph,
    pub(super) points: super::medial_points::MedialPoints,
    pub(super) arcs: crate::complex::Rows,
}

/// Balls, whose union is a solid.
pub struct medax_balls {
    pub(super) balls: crate::distance::Balls,
}

/// A solid between an inner structure and its boundary.
pub struct medax_pair {
    pub(super) pair: crate::PairMesh,
}

/// Every face of every element of a pair-mesh, with its edges.
pub struct medax_half_faces {
    pub(super) half_faces: crate::pair::HalfFaces,
}

/// A type of which C holds counted references.
///
/// Any number of threads may read a handle at once.
pub(super) trait Handle: Send + Sync + 'static {}

impl Handle for medax_job {}
impl Handle for medax_points {}
impl Handle for medax_triangulation {}
impl Handle for medax_incidence {}
impl Handle for medax_dual {}
impl Handle for medax_samples {}
impl Handle for medax_file {}
impl Handle for medax_warnings {}
impl Handle for medax_poles {}
impl Handle for medax_power_crust {}
impl Handle for medax_simplified {}
impl Handle for medax_cocone {}
impl Handle for medax_labels {}
impl Handle for medax_medial {}
impl Handle for medax_flow {}
impl Handle for medax_flow_complex {}
impl Handle for medax_complex {}
impl Handle for medax_figure {}
impl Handle for medax_intersections {}
impl Handle for medax_sites {}
impl Handle for medax_all_nearest {}
impl Handle for medax_field_axis {}
impl Handle for medax_medial_graph {}
impl Handle for medax_balls {}
impl Handle for medax_pair {}
impl Handle for medax_half_faces {}
impl Handle for medax_flattened {}

/// A new handle with one reference, which the caller owns.
pub(super) fn new<T: Handle>(value: T) -> *const T {
    Arc::into_raw(Arc::new(value))
}

/// The value behind a handle that must not be NULL.
///
/// # Safety
/// `handle` is NULL or came from [`new`] and has a reference that outlives `'a`.
pub(super) unsafe fn get<'a, T: Handle>(handle: *const T, name: &str) -> Result<&'a T> {
    // SAFETY: the caller's promise.
    unsafe { handle.as_ref() }.ok_or_else(|| null(name))
}

/// The value behind a handle, if there is one.
///
/// # Safety
/// As for [`get`].
pub(super) unsafe fn maybe<'a, T: Handle>(handle: *const T) -> Option<&'a T> {
    // SAFETY: the caller's promise.
    unsafe { handle.as_ref() }
}

/// The job behind a handle; `own` becomes the one to run with if there is none.
///
/// # Safety
/// As for [`get`].
pub(super) unsafe fn job(handle: *const medax_job, own: &mut Option<Job>) -> &Job {
    // SAFETY: the caller's promise.
    match unsafe { handle.as_ref() } {
        Some(handle) => &handle.job,
        None => own.get_or_insert_default(),
    }
}

/// One more reference to the handle, which the caller owns; NULL for NULL.
///
/// # Safety
/// `handle` is NULL or came from [`new`] and has a reference.
pub(super) unsafe fn clone<T: Handle>(handle: *const T) -> *const T {
    if !handle.is_null() {
        // SAFETY: the pointer came from `Arc::into_raw` in `new`, unchanged, and the caller
        // promises a reference, so that the count is at least 1.
        unsafe { Arc::increment_strong_count(handle) };
    }
    handle
}

/// Gives one reference back; nothing for NULL.
///
/// # Safety
/// `handle` is NULL or came from [`new`] and has a reference, which is not used again.
pub(super) unsafe fn free<T: Handle>(handle: *const T) {
    if !handle.is_null() {
        // SAFETY: as in `clone`; the caller gives up the reference that this takes.
        unsafe { Arc::decrement_strong_count(handle) };
    }
}

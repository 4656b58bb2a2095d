//! Medial graph
//!
//! The medial axis of segments, points and circles in the plane, as a graph: nodes, where arcs meet or end, and arcs. It is followed along
//! the boundary, to the precision of rounding; without thresholds it has the Betti numbers of the region.

use super::boundary;
use super::complex;
use super::handle::{self, medax_complex, medax_job, medax_medial_graph, medax_sites};
use super::medial::{medax_side, side};
use super::medial_points::MedialPoints;
use super::options::{self, flag, sized_struct};
use super::status::medax_status;
use super::validation::{self, medax_validation};
use super::view::{self, Out, medax_view_f64, medax_view_rows, medax_view_u32};
use crate::complex::Rows;
use crate::distance::{GraphOptions, MedialGraph, Sites};
use crate::error::{Error, Result, Status};
use crate::job::{Room, Run, Stage};
use std::ptr;
use std::sync::Arc;

/// Which part of the axis, and how finely.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_medial_graph_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// The longest edge of an arc, in input units. 0, the default, asks for a hundredth of #medax_sites_size.
    pub spacing: f64,
    /// The least object angle, in radians in [0, pi]; 0 by default.
    pub object_angle: f64,
    /// The least distance from the boundary, in input units; 0 by default.
    pub min_distance: f64,
    /// The least corner of a box that holds what is looked at, if `has_clip` is 1; z does not count. No coordinate is beyond 2^200.
    pub clip_min: [f64; 3],
    /// The largest corner of that box.
    pub clip_max: [f64; 3],
    /// 1 for that box; 0, the default, for that of the sites, if the outside is asked for as well as much larger on each side as half its
    /// diagonal is long.
    pub has_clip: u32,
    /// A #medax_side of closed curves; `MEDAX_SIDE_INNER` by default. Without these all is outside.
    pub side: u32,
    /// 1 to keep only what has its nearest points on two sites; 0 by default.
    pub between_sites: u32,
    /// Must be 0.
    pub reserved: u32,
}

sized_struct!(medax_medial_graph_options,
    first_size: size_of::<medax_medial_graph_options>(), reserved: reserved, {
    spacing: f64 = 0.0,
    object_angle: f64 = 0.0,
    min_distance: f64 = 0.0,
    clip_min: [f64; 3] = [0.0; 3],
    clip_max: [f64; 3] = [0.0; 3],
    has_clip: u32 = 0,
    side: u32 = medax_side::Inner as u32,
    between_sites: u32 = 0,
    reserved: u32 = 0,
});

impl medax_medial_graph_options {
    fn translate(&self) -> Result<GraphOptions> {
        let has_clip = flag(self.has_clip, "has_clip")?;
        Ok(GraphOptions {
            side: side(self.side)?,
            spacing: self.spacing,
            angle: self.object_angle,
            min_distance: self.min_distance,
            between_sites: flag(self.between_sites, "between_sites")?,
            clip: has_clip.then_some([self.clip_min, self.clip_max]),
        })
    }
}

/// Sets the options of medial graphs to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_graph_options_init(
    options: *mut medax_medial_graph_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// Follows the medial axis of sites in the plane. Segments must meet in common ends only, and touch no circle, as those of a figure do.
///
/// \param sites The sites, which the result keeps alive.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_graph Receives the graph, which the caller frees with #medax_medial_graph_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for sites in space and options out of range; `UNSUPPORTED` with its row for a line or a
///         ray; `LIMIT_EXCEEDED` for a spacing of less than 2^-20 of the box; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`,
///         `OUT_OF_MEMORY`.
///
/// O((n + size) log n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_graph_build(
    sites: *const medax_sites,
    options: *const medax_medial_graph_options,
    job: *const medax_job,
    out_graph: *mut *const medax_medial_graph,
) -> medax_status {
    boundary::status(|| build(sites, options, job, out_graph, MedialGraph::new_in))
}

/// Follows the medial axis of sites in the plane, of which only what has its nearest points on one of some pairs of sites is kept.
///
/// \param sites The sites, which the result keeps alive.
/// \param pairs `pair_count` x 2 sites, either first; a site with itself for the parts of the medial axis that belong to that site alone.
///        NULL only if `pair_count` is 0.
/// \param pair_count The number of pairs; with 0 there are no arcs.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_graph Receives the graph, which the caller frees with #medax_medial_graph_free.
/// \return As #medax_medial_graph_build; also `INVALID_ARGUMENT` with the row of a pair that names no site.
///
/// As #medax_medial_graph_build. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_graph_between(
    sites: *const medax_sites,
    pairs: *const u32,
    pair_count: usize,
    options: *const medax_medial_graph_options,
    job: *const medax_job,
    out_graph: *mut *const medax_medial_graph,
) -> medax_status {
    boundary::status(|| {
        let pairs = view::rows(pairs, pair_count, "pairs")?;
        build(sites, options, job, out_graph, |sites, options, run| {
            MedialGraph::between_in(sites, pairs, options, run)
        })
    })
}

unsafe fn build(
    sites: *const medax_sites,
    options: *const medax_medial_graph_options,
    job: *const medax_job,
    out_graph: *mut *const medax_medial_graph,
    follow: impl FnOnce(&Arc<Sites>, GraphOptions, &Run<'_>) -> Result<MedialGraph>,
) -> Result<()> {
    let sites = &handle::get(sites, "sites")?.sites;
    let options = options::read(options, "options")?.translate()?;
    let out = Out::new(out_graph, "out_graph")?;
    let mut own = None;
    let stages = [(Stage::Field, 0.98), (Stage::Extract, 0.02)];
    let built = handle::job(job, &mut own).run(&stages, |run| {
        let graph = follow(sites, options, run)?;
        run.enter(Stage::Extract)?;
        let points = MedialPoints::new(graph.points(), sites, run)?;
        let arcs = rows(graph.arcs(), run)?;
        Ok(medax_medial_graph { graph, points, arcs })
    })?;
    out.put(handle::new(built));
    Ok(())
}

/// Arcs one after the other.
fn rows(arcs: &[Vec<u32>], run: &Run<'_>) -> Result<Rows> {
    let mut room = Room::new(run);
    let count = arcs.iter().map(Vec::len).sum();
    let (mut offsets, mut indices) = (room.vec(arcs.len() + 1)?, room.vec(count)?);
    offsets.push(0);
    for arc in run.watch(arcs) {
        indices.extend_from_slice(arc?);
        let end = u32::try_from(indices.len());
        offsets.push(
            end.map_err(|_| {
                Error::new(Status::LimitExceeded, "more than 2^32 - 1 points of arcs")
            })?,
        );
    }
    Rows::new(offsets, indices)
}

/// What the boundary was.
///
/// \param graph The graph.
/// \param out_sites Receives the sites, which the caller frees with #medax_sites_free.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_graph_sites(
    graph: *const medax_medial_graph,
    out_sites: *mut *const medax_sites,
) -> medax_status {
    boundary::status(|| {
        let graph = &handle::get(graph, "graph")?.graph;
        let out = Out::new(out_sites, "out_sites")?;
        out.put(handle::new(medax_sites { sites: graph.sites().clone() }));
        Ok(())
    })
}

/// The number of nodes, which are the first of the points.
///
/// \param graph The graph; NULL has none.
/// \return The number of nodes.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_graph_node_count(graph: *const medax_medial_graph) -> usize {
    boundary::value(0, || handle::maybe(graph).map_or(0, |g| g.graph.node_count()))
}

/// The arcs.
///
/// \param graph The graph, or NULL.
/// \return One row an arc: its points in order, nodes at both ends included. Where a threshold or the box cuts an arc it ends in a point
///         that is no node; a loop without nodes has its first point at its end again. Borrowed from `graph`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_graph_arcs(
    graph: *const medax_medial_graph,
) -> medax_view_rows {
    boundary::value(medax_view_rows::EMPTY, || {
        handle::maybe(graph).map_or(medax_view_rows::EMPTY, |g| {
            medax_view_rows::new(g.arcs.offsets(), g.arcs.indices())
        })
    })
}

/// How many sides of arcs have no other side that agrees with them: 0 but for figures with parts that are apart by less than a millionth of their
/// size, or with vertices that are nearly straight.
///
/// \param graph The graph; NULL has none.
/// \return How many.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_graph_torn(graph: *const medax_medial_graph) -> usize {
    boundary::value(0, || handle::maybe(graph).map_or(0, |g| g.graph.torn()))
}

/// Where the points lie: the nodes, then those between.
///
/// \param graph The graph, or NULL.
/// \return m x 3 coordinates, z being 0. Borrowed from `graph`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_graph_points(
    graph: *const medax_medial_graph,
) -> medax_view_f64 {
    column(graph, MedialPoints::centers)
}

/// The distances of the points from the boundary: the radii of the medial balls.
///
/// \param graph The graph, or NULL.
/// \return m x 1, in input units. Borrowed from `graph`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_graph_radii(
    graph: *const medax_medial_graph,
) -> medax_view_f64 {
    column(graph, MedialPoints::radii)
}

/// The angles between the ways from the points to their nearest points; of a node the largest of those of its arcs there.
///
/// \param graph The graph, or NULL.
/// \return m x 1, in radians. Borrowed from `graph`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_graph_object_angles(
    graph: *const medax_medial_graph,
) -> medax_view_f64 {
    column(graph, MedialPoints::object_angles)
}

/// Two nearest points of the boundary for each point.
///
/// \param graph The graph, or NULL.
/// \return m x 6 coordinates. Borrowed from `graph`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_graph_feet(
    graph: *const medax_medial_graph,
) -> medax_view_f64 {
    column(graph, MedialPoints::feet)
}

/// The pieces that have these nearest points.
///
/// \param graph The graph, or NULL.
/// \return m x 2 pieces. Borrowed from `graph`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_graph_pieces(
    graph: *const medax_medial_graph,
) -> medax_view_u32 {
    column(graph, MedialPoints::pieces)
}

/// The sites of these pieces.
///
/// \param graph The graph, or NULL.
/// \return m x 2 sites. Borrowed from `graph`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_graph_sites_of_points(
    graph: *const medax_medial_graph,
) -> medax_view_u32 {
    column(graph, MedialPoints::sites)
}

unsafe fn column<V>(graph: *const medax_medial_graph, read: fn(Option<&MedialPoints>) -> V) -> V {
    boundary::value(read(None), || read(handle::maybe(graph).map(|g| &g.points)))
}

/// The arcs as loose edges. Vertices are the points, with the attributes `radius`, `object_angle`, `feet` (the two nearest points),
/// `pieces`, `sites` (of these) and `is_node`; edges carry `arc`.
///
/// \param graph The graph.
/// \param job NULL for a default job.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(points). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_graph_complex(
    graph: *const medax_medial_graph,
    job: *const medax_job,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let graph = &handle::get(graph, "graph")?.graph;
        let out = Out::new(out_complex, "out_complex")?;
        let mut own = None;
        out.put(complex::give(Arc::new(graph.complex(handle::job(job, &mut own))?)));
        Ok(())
    })
}

/// Checks a medial graph: that nothing is nearer to a point than its radius; that its feet are as near, and seen under its angle; and which
/// points arcs have, and where.
///
/// \param graph The graph.
/// \param job NULL for a default job.
/// \param out_report Filled, its `struct_size` being set.
/// \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report of no version, `CANCELLED`, `BUSY`,
///         `OUT_OF_MEMORY`.
///
/// Some queries for each point. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_graph_validate(
    graph: *const medax_medial_graph,
    job: *const medax_job,
    out_report: *mut medax_validation,
) -> medax_status {
    validation::validate(job, out_report, |job| handle::get(graph, "graph")?.graph.validate(job))
}

/// One more reference to a medial graph.
///
/// \param graph The graph, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_graph_clone(
    graph: *const medax_medial_graph,
) -> *const medax_medial_graph {
    boundary::value(ptr::null(), || handle::clone(graph))
}

/// Gives one reference to a medial graph back; the last one frees it.
///
/// \param graph The graph; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_medial_graph_free(graph: *const medax_medial_graph) {
    boundary::value((), || handle::free(graph));
}

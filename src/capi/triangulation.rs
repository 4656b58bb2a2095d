//! Triangulation
//!
//! Exact Delaunay and regular triangulations. The power distance of a point x to a vertex p of
//! weight w is |x - p|^2 - w; a cell is in the regular triangulation when no other vertex has a
//! smaller power distance to the cell's orthocentre than the cell's own have. Without weights
//! that is the Delaunay triangulation. A vertex whose weight is too small for any cell is hidden.
//! Ties are broken by a symbolic perturbation, so that the cells depend on the set alone.
//!
//! Vertices are those of the points. Facet i of a cell is the one opposite its vertex i.

use super::boundary;
use super::complex;
use super::handle::{self, medax_complex, medax_job, medax_points, medax_triangulation};
use super::options::{self, sized_struct};
use super::status::medax_status;
use super::validation::{self, medax_validation};
use super::view::{self, Out, medax_view_f64, medax_view_u32};
use crate::error::{ElementKind, Error, Status};
use crate::{NONE, Triangulation};
use std::ptr;
use std::sync::Arc;

/// The settings of a triangulation: none yet but the size.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_triangulation_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
}

sized_struct!(medax_triangulation_options,
    first_size: size_of::<medax_triangulation_options>(), reserved: none, {});

/// Sets triangulation options to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_triangulation_options_init(
    options: *mut medax_triangulation_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// Builds the Delaunay triangulation of points.
///
/// \param points The points, which the triangulation keeps alive.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_triangulation Receives the triangulation, which the caller frees with
///        #medax_triangulation_free.
/// \return `MEDAX_STATUS_OK`; `TOO_FEW_POINTS` below four distinct points; `DEGENERATE` when all
///         lie in a plane; `LIMIT_EXCEEDED` past 2^30 cells; `NULL_ARGUMENT`, `INVALID_ARGUMENT`,
///         `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// Expected O(n log n) where there are O(n) cells. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_delaunay_build(
    points: *const medax_points,
    options: *const medax_triangulation_options,
    job: *const medax_job,
    out_triangulation: *mut *const medax_triangulation,
) -> medax_status {
    boundary::status(|| {
        let points = handle::get(points, "points")?;
        options::read(options, "options")?;
        let out = Out::new(out_triangulation, "out_triangulation")?;
        let mut own = None;
        let built = Triangulation::delaunay(&points.points, handle::job(job, &mut own))?;
        out.put(handle::new(medax_triangulation { triangulation: Arc::new(built) }));
        Ok(())
    })
}

/// Builds the regular triangulation of weighted points.
///
/// \param points The points, which the triangulation keeps alive.
/// \param weights `weight_count` weights in squared input units, one per row of the points' input.
///        Of rows with equal coordinates the largest weight wins. Copied.
/// \param weight_count #medax_points_row_count.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_triangulation Receives the triangulation, which the caller frees with
///        #medax_triangulation_free.
/// \return As #medax_delaunay_build; also `MISMATCH` for a wrong number of weights, `NON_FINITE` and
///         `COORDINATE_RANGE` with the row of a weight.
///
/// Expected O(n log n) where there are O(n) cells. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_regular_build(
    points: *const medax_points,
    weights: *const f64,
    weight_count: usize,
    options: *const medax_triangulation_options,
    job: *const medax_job,
    out_triangulation: *mut *const medax_triangulation,
) -> medax_status {
    boundary::status(|| {
        let points = handle::get(points, "points")?;
        let weights = view::slice(weights, weight_count, "weights")?;
        options::read(options, "options")?;
        let out = Out::new(out_triangulation, "out_triangulation")?;
        let mut own = None;
        let built = Triangulation::regular(&points.points, weights, handle::job(job, &mut own))?;
        out.put(handle::new(medax_triangulation { triangulation: Arc::new(built) }));
        Ok(())
    })
}

/// The points of a triangulation.
///
/// \param triangulation The triangulation.
/// \param out_points Receives the points, which the caller frees with #medax_points_free.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_triangulation_points(
    triangulation: *const medax_triangulation,
    out_points: *mut *const medax_points,
) -> medax_status {
    boundary::status(|| {
        let triangulation = &handle::get(triangulation, "triangulation")?.triangulation;
        let out = Out::new(out_points, "out_points")?;
        out.put(handle::new(medax_points { points: triangulation.points().clone() }));
        Ok(())
    })
}

/// The coordinates of the vertices.
///
/// \param triangulation The triangulation, or NULL.
/// \return n x 3, in input units. Borrowed from `triangulation`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_triangulation_coords(
    triangulation: *const medax_triangulation,
) -> medax_view_f64 {
    floats(triangulation, 3, |t| t.coords().as_flattened())
}

/// The weights of the vertices.
///
/// \param triangulation The triangulation, or NULL.
/// \return n x 1, in squared input units; no row for a Delaunay triangulation. Borrowed from
///         `triangulation`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_triangulation_weights(
    triangulation: *const medax_triangulation,
) -> medax_view_f64 {
    floats(triangulation, 1, Triangulation::weights)
}

/// The row of the input that each vertex stands for.
///
/// \param triangulation The triangulation, or NULL.
/// \return n x 1: the first row with the vertex's coordinates, in a regular triangulation the first
///         of the heaviest ones. Borrowed from `triangulation`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_triangulation_row_of_vertex(
    triangulation: *const medax_triangulation,
) -> medax_view_u32 {
    indices(triangulation, 1, Triangulation::row_of_vertex)
}

/// The finite cells.
///
/// \param triangulation The triangulation, or NULL.
/// \return m x 4 vertices, positively oriented: the determinant of b - a, c - a, d - a is positive.
///         The least vertex comes first, the second least next; cells ascend by their vertices.
///         Borrowed from `triangulation`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_triangulation_cells(
    triangulation: *const medax_triangulation,
) -> medax_view_u32 {
    indices(triangulation, 4, |t| t.cells().as_flattened())
}

/// The neighbours of the finite cells.
///
/// \param triangulation The triangulation, or NULL.
/// \return m x 4 cells: column i shares facet i with the cell, and is `MEDAX_NONE` on the hull.
///         Borrowed from `triangulation`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_triangulation_neighbors(
    triangulation: *const medax_triangulation,
) -> medax_view_u32 {
    indices(triangulation, 4, |t| t.neighbors().as_flattened())
}

/// The vertices that no cell uses, because their weights are too small.
///
/// \param triangulation The triangulation, or NULL.
/// \return Hidden vertices x 1, ascending. Borrowed from `triangulation`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_triangulation_hidden(
    triangulation: *const medax_triangulation,
) -> medax_view_u32 {
    indices(triangulation, 1, Triangulation::hidden)
}

unsafe fn floats(
    triangulation: *const medax_triangulation,
    cols: usize,
    read: fn(&Triangulation) -> &[f64],
) -> medax_view_f64 {
    boundary::value(medax_view_f64::new(&[], cols), || {
        let values = handle::maybe(triangulation).map_or(&[][..], |t| read(&t.triangulation));
        medax_view_f64::new(values, cols)
    })
}

unsafe fn indices(
    triangulation: *const medax_triangulation,
    cols: usize,
    read: fn(&Triangulation) -> &[u32],
) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], cols), || {
        let values = handle::maybe(triangulation).map_or(&[][..], |t| read(&t.triangulation));
        medax_view_u32::new(values, cols)
    })
}

/// A cell that holds a point. Of a point on a facet, edge or vertex, which lies in several cells,
/// the hint decides which one.
///
/// \param triangulation The triangulation.
/// \param xyz The three coordinates of the point.
/// \param hint_cell Where to begin the search; any number that is no cell stands for cell 0.
/// \param out_cell Receives the cell, or `MEDAX_NONE` outside the convex hull.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, `NON_FINITE`, `COORDINATE_RANGE`.
///
/// O(cells between the hint and the point). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_triangulation_locate(
    triangulation: *const medax_triangulation,
    xyz: *const f64,
    hint_cell: u32,
    out_cell: *mut u32,
) -> medax_status {
    boundary::status(|| {
        let triangulation = &handle::get(triangulation, "triangulation")?.triangulation;
        let points = view::rows::<f64, 3>(xyz, 1, "xyz")?;
        let out = Out::new(out_cell, "out_cell")?;
        out.put(triangulation.locate(points[0], hint_cell)?.unwrap_or(NONE));
        Ok(())
    })
}

/// The ring of cells round an edge, counterclockwise seen from `b` to `a`. A closed ring begins
/// with its least cell, one that the hull cuts begins where it has the hull behind it.
///
/// \param triangulation The triangulation.
/// \param cell A cell that has the edge, such as #medax_incidence_cell_of_edge names.
/// \param a One vertex of the edge.
/// \param b The other one.
/// \param capacity The number of cells for which `out_cells` has room.
/// \param out_cells Receives the first `capacity` cells of the ring; NULL only if `capacity` is 0.
/// \param out_count Receives the length of the ring, which may be more than `capacity`.
/// \param out_closed Receives 1 if the ring is closed, 0 if the edge lies on the hull.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` with the cell if it does not
///         have the edge.
///
/// O(length of the ring). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_triangulation_ring(
    triangulation: *const medax_triangulation,
    cell: u32,
    a: u32,
    b: u32,
    capacity: usize,
    out_cells: *mut u32,
    out_count: *mut usize,
    out_closed: *mut u32,
) -> medax_status {
    boundary::status(|| {
        let triangulation = &handle::get(triangulation, "triangulation")?.triangulation;
        let count = Out::new(out_count, "out_count")?;
        let closed = Out::new(out_closed, "out_closed")?;
        let target = view::Buffer::new(out_cells, capacity, "out_cells")?;
        let corners = triangulation.cells().get(cell as usize);
        if a == b || !corners.is_some_and(|c| c.contains(&a) && c.contains(&b)) {
            let message = format!("the cell does not have an edge from vertex {a} to {b}");
            return Err(
                Error::new(Status::InvalidArgument, message).at(ElementKind::Cell, u64::from(cell))
            );
        }
        let mut ring = Vec::new();
        closed.put(u32::from(triangulation.ring(cell, a, b, &mut ring)));
        count.put(ring.len());
        target.fill(&ring);
        Ok(())
    })
}

/// The vertices of a triangulation, hidden ones included, and its cells as tetrahedra, for writing.
/// Vertices have the attribute `row`, and `weight` where there are weights.
///
/// \param triangulation The triangulation.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `LIMIT_EXCEEDED` past 2^32 - 1
///         corners of cells.
///
/// O(n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_triangulation_complex(
    triangulation: *const medax_triangulation,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let triangulation = &handle::get(triangulation, "triangulation")?.triangulation;
        let out = Out::new(out_complex, "out_complex")?;
        out.put(complex::give(Arc::new(triangulation.to_complex()?)));
        Ok(())
    })
}

/// Checks a triangulation in exact arithmetic: order, orientation, adjacency, the empty sphere
/// or power of every facet, the convex hull, Euler's formula, the hidden vertices.
///
/// \param triangulation The triangulation.
/// \param job NULL for a default job.
/// \param out_report Filled, its `struct_size` being set.
/// \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report
///         of no version, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(m) exact predicates. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_triangulation_validate(
    triangulation: *const medax_triangulation,
    job: *const medax_job,
    out_report: *mut medax_validation,
) -> medax_status {
    validation::validate(job, out_report, |job| {
        handle::get(triangulation, "triangulation")?.triangulation.validate(job)
    })
}

/// One more reference to a triangulation.
///
/// \param triangulation The triangulation, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_triangulation_clone(
    triangulation: *const medax_triangulation,
) -> *const medax_triangulation {
    boundary::value(ptr::null(), || handle::clone(triangulation))
}

/// Gives one reference to a triangulation back; the last one frees it.
///
/// \param triangulation The triangulation; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_triangulation_free(triangulation: *const medax_triangulation) {
    boundary::value((), || handle::free(triangulation));
}

//! Flow
//!
//! The flow of the distance to a sample. From each point it runs away from the driver, the point nearest to it of the hull of its
//! nearest samples: in the direction in which the distance grows most. It stands still at the critical points, where a Delaunay
//! simplex holds its own centre and no other sample lies in its sphere. Some belong to the surface, and lie near it between its samples;
//! all others lie near the medial axis. A #medax_flow has the drivers of the faces of the Voronoi diagram and the critical points; it
//! answers where points flow, and what flows from some faces.
//! (Giesen, Ramos, Sadri 2010, Medial axis approximation and unstable flow complex.)

use super::boundary;
use super::complex;
use super::handle::{self, medax_complex, medax_dual, medax_flow, medax_job, medax_labels};
use super::options::{self, sized_struct};
use super::status::medax_status;
use super::validation::{self, medax_validation};
use super::view::{self, Buffer, Out, medax_view_f64, medax_view_u32};
use crate::error::{ElementKind, Error, Result, Status};
use crate::flow::{CriticalClass, Flow, FlowAt, FlowOptions, Simplex};
use crate::index::NONE;
use crate::job::Stage;
use std::ptr;
use std::sync::Arc;

/// Where a critical point belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum medax_critical_class {
    /// To the surface: near it, between its samples.
    Surface = 0,
    /// To the inner medial axis.
    Inner = 1,
    /// To the outer medial axis.
    Outer = 2,
}

// The classes are shown as they lie in memory.
const _: () = assert!(CriticalClass::Surface as u32 == medax_critical_class::Surface as u32);
const _: () = assert!(CriticalClass::Inner as u32 == medax_critical_class::Inner as u32);
const _: () = assert!(CriticalClass::Outer as u32 == medax_critical_class::Outer as u32);

/// A Delaunay simplex, or its dual, a face of the Voronoi diagram.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct medax_simplex {
    /// 0 for a sample, whose dual is a Voronoi cell; 1 for an edge, a Voronoi facet; 2 for a triangle, a Voronoi edge; 3 for a cell, a
    /// Voronoi vertex.
    pub dimension: u32,
    /// Which one: a vertex of the points, a row of #medax_dual_facets, of #medax_flow_triangles, of #medax_triangulation_cells.
    pub number: u32,
}

impl From<Simplex> for medax_simplex {
    fn from(simplex: Simplex) -> Self {
        medax_simplex { dimension: simplex.dimension() as u32, number: simplex.number() }
    }
}

impl medax_simplex {
    const ABSENT: Self = medax_simplex { dimension: 0, number: NONE };

    pub(super) fn translate(self) -> Result<Simplex> {
        Ok(match self.dimension {
            0 => Simplex::Sample(self.number),
            1 => Simplex::Edge(self.number),
            2 => Simplex::Triangle(self.number),
            3 => Simplex::Cell(self.number),
            dimension => {
                let message = format!("a simplex of dimension {dimension} is none of space");
                return Err(Error::new(Status::InvalidArgument, message));
            }
        })
    }
}

/// What is calculated.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_flow_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// The slope above which a critical point belongs to the medial axis and not to the surface (#medax_flow_critical_slopes), between
    /// 0 and 1; 0.5 by default.
    pub least_slope: f64,
}

sized_struct!(medax_flow_options,
    first_size: size_of::<medax_flow_options>(), reserved: none, { least_slope: f64 = 0.5 });

/// Sets flow options to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_options_init(
    options: *mut medax_flow_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// Calculates drivers and critical points of a sample from its Voronoi diagram.
///
/// \param dual The dual of the Delaunay triangulation, with its facets (#medax_dual_options), which the result keeps alive.
/// \param labels Labels of the triangulation's cells, which tell the inner from the outer medial axis. The result keeps them alive.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_flow Receives the flow, which the caller frees with #medax_flow_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for the dual of a regular triangulation, a dual without facets, and an option out
///         of range; `MISMATCH` for labels of another triangulation; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size of the dual). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_build(
    dual: *const medax_dual,
    labels: *const medax_labels,
    options: *const medax_flow_options,
    job: *const medax_job,
    out_flow: *mut *const medax_flow,
) -> medax_status {
    boundary::status(|| {
        let dual = &handle::get(dual, "dual")?.dual;
        let labels = &handle::get(labels, "labels")?.labels;
        let asked = options::read(options, "options")?;
        let out = Out::new(out_flow, "out_flow")?;
        let options = FlowOptions { least_slope: asked.least_slope };
        let mut own = None;
        let flow = Flow::new(dual, labels, options, handle::job(job, &mut own))?;
        out.put(handle::new(medax_flow { flow: Arc::new(flow) }));
        Ok(())
    })
}

/// The Voronoi diagram.
///
/// \param flow The flow.
/// \param out_dual Receives the dual, which the caller frees with #medax_dual_free.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_dual(
    flow: *const medax_flow,
    out_dual: *mut *const medax_dual,
) -> medax_status {
    boundary::status(|| {
        let flow = &handle::get(flow, "flow")?.flow;
        let out = Out::new(out_dual, "out_dual")?;
        out.put(handle::new(medax_dual { dual: flow.dual().clone() }));
        Ok(())
    })
}

/// The labels that tell the inner from the outer medial axis.
///
/// \param flow The flow.
/// \param out_labels Receives the labels, which the caller frees with #medax_labels_free.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_labels(
    flow: *const medax_flow,
    out_labels: *mut *const medax_labels,
) -> medax_status {
    boundary::status(|| {
        let flow = &handle::get(flow, "flow")?.flow;
        let out = Out::new(out_labels, "out_labels")?;
        out.put(handle::new(medax_labels { labels: flow.labels().clone() }));
        Ok(())
    })
}

/// The number of critical points, samples included.
///
/// \param flow The flow; NULL has none.
/// \return The number of rows of every array of critical points.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_critical_count(flow: *const medax_flow) -> usize {
    boundary::value(0, || handle::maybe(flow).map_or(0, |f| f.flow.critical().len()))
}

/// The simplices whose centres the critical points are: samples, edges, triangles, cells. The dimension of the simplex is the index of
/// the critical point. Of index 0, 1, 2 and 3 there are so many that c0 - c1 + c2 - c3 = 1.
///
/// \param flow The flow, or NULL.
/// \return c x 2, each row the two numbers of a #medax_simplex; rows ascend. Borrowed from `flow`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_critical_simplices(flow: *const medax_flow) -> medax_view_u32 {
    indices(flow, 2, |f| view::pairs(f.critical().simplices()))
}

/// Where the critical points lie.
///
/// \param flow The flow, or NULL.
/// \return c x 3 coordinates. Borrowed from `flow`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_critical_points(flow: *const medax_flow) -> medax_view_f64 {
    floats(flow, 3, |f| f.critical().points().as_flattened())
}

/// The distances of the critical points from the samples.
///
/// \param flow The flow, or NULL.
/// \return c x 1, in input units; 0 for samples. Borrowed from `flow`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_critical_distances(flow: *const medax_flow) -> medax_view_f64 {
    floats(flow, 1, |f| f.critical().distances())
}

/// The samples nearest to each critical point: the vertices of its simplex.
///
/// \param flow The flow, or NULL.
/// \return c x 4 vertices, one to four a row, then `MEDAX_NONE`. Borrowed from `flow`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_critical_corners(flow: *const medax_flow) -> medax_view_u32 {
    indices(flow, 4, |f| f.critical().corners().as_flattened())
}

/// What decides whether a critical point belongs to the surface: the mean, over its nearest samples, of the cosine of the angle between
/// the direction from the sample and the vector to the sample's pole, in absolute value.
///
/// \param flow The flow, or NULL.
/// \return c x 1, in [0, 1]: nearly 0 at the surface, nearly 1 at the medial axis; 0 for samples. Borrowed from `flow`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_critical_slopes(flow: *const medax_flow) -> medax_view_f64 {
    floats(flow, 1, |f| f.critical().slopes())
}

/// The distance of each critical point by that of the farthest Voronoi vertices of its nearest samples on its side of the surface, the
/// mean over these. It decides nothing.
///
/// \param flow The flow, or NULL.
/// \return c x 1, in [0, 1]: nearly 0 at the surface; nearly 1 at the inner medial axis, as at the outer where the samples are not on
///         the hull. Borrowed from `flow`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_critical_shares(flow: *const medax_flow) -> medax_view_f64 {
    floats(flow, 1, |f| f.critical().shares())
}

/// Where each critical point belongs.
///
/// \param flow The flow, or NULL.
/// \return c x 1, each a #medax_critical_class. Borrowed from `flow`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_critical_classes(flow: *const medax_flow) -> medax_view_u32 {
    indices(flow, 1, |f| view::numbers(f.critical().classes()))
}

/// The critical point of a simplex.
///
/// \param flow The flow; NULL has none.
/// \param simplex The simplex.
/// \return Its row in the arrays of critical points; `MEDAX_NONE` if it has none, or is not there.
///
/// O(log c) for c critical points. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_critical_row(
    flow: *const medax_flow,
    simplex: medax_simplex,
) -> u32 {
    boundary::value(NONE, || {
        let row = |f: &medax_flow| f.flow.critical().row_of(simplex.translate().ok()?);
        handle::maybe(flow).and_then(row).unwrap_or(NONE)
    })
}

/// How clearly the slopes divide the critical points: the largest slope of those that belong to the surface, and the least of the others.
///
/// \param flow The flow.
/// \param out_gap Receives the two slopes, the second 1 if there are no others; the wider apart, the clearer.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// O(c) for c critical points. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_gap(
    flow: *const medax_flow,
    out_gap: *mut f64,
) -> medax_status {
    boundary::status(|| {
        let flow = &handle::get(flow, "flow")?.flow;
        let out = Buffer::new(out_gap, 2, "out_gap")?;
        out.fill(&flow.critical().gap(flow.options().least_slope));
        Ok(())
    })
}

/// The critical points as vertices, samples left out, with the attributes `index`, `class` (a #medax_critical_class), `radius` (their distance
/// from the samples), `slope`, `share` and `samples` (the nearest ones, then `MEDAX_NONE`), for writing.
///
/// \param flow The flow.
/// \param job NULL for a default job.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(c) for c critical points. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_critical_complex(
    flow: *const medax_flow,
    job: *const medax_job,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let flow = &handle::get(flow, "flow")?.flow;
        let out = Out::new(out_complex, "out_complex")?;
        let mut own = None;
        let critical = flow.critical_complex(handle::job(job, &mut own))?;
        out.put(complex::give(Arc::new(critical)));
        Ok(())
    })
}

/// The triangles of the triangulation, each once.
///
/// \param flow The flow, or NULL.
/// \return t x 2: the lesser of the triangle's cells, and the slot of the cell's vertex opposite; rows ascend. Borrowed from `flow`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_triangles(flow: *const medax_flow) -> medax_view_u32 {
    indices(flow, 2, |f| f.triangles().as_flattened())
}

/// The simplex at whose centre the driver of the points inside a Voronoi edge lies: the triangle, or if that is obtuse its longest edge.
/// The driver inside a Voronoi facet is always the middle of its dual edge.
///
/// \param flow The flow.
/// \param triangle A row of #medax_flow_triangles.
/// \return The simplex; dimension 0 and number `MEDAX_NONE` for a triangle that is not there, and without a flow.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_driver_of_triangle(
    flow: *const medax_flow,
    triangle: u32,
) -> medax_simplex {
    driver(flow, triangle, |f| f.triangles().len(), Flow::driver_of_triangle)
}

/// The simplex at whose centre the driver of a Voronoi vertex lies: the cell, one of its triangles, or one of its edges.
///
/// \param flow The flow.
/// \param cell The cell.
/// \return The simplex; dimension 0 and number `MEDAX_NONE` for a cell that is not there, and without a flow.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_driver_of_cell(
    flow: *const medax_flow,
    cell: u32,
) -> medax_simplex {
    driver(flow, cell, |f| f.dual().triangulation().cells().len(), Flow::driver_of_cell)
}

unsafe fn driver(
    flow: *const medax_flow,
    number: u32,
    count: fn(&Flow) -> usize,
    read: fn(&Flow, u32) -> Simplex,
) -> medax_simplex {
    boundary::value(medax_simplex::ABSENT, || {
        let flow = handle::maybe(flow).filter(|f| (number as usize) < count(&f.flow));
        flow.map_or(medax_simplex::ABSENT, |f| read(&f.flow, number).into())
    })
}

unsafe fn floats(
    flow: *const medax_flow,
    cols: usize,
    read: fn(&Flow) -> &[f64],
) -> medax_view_f64 {
    boundary::value(medax_view_f64::new(&[], cols), || {
        medax_view_f64::new(handle::maybe(flow).map_or(&[][..], |f| read(&f.flow)), cols)
    })
}

unsafe fn indices(
    flow: *const medax_flow,
    cols: usize,
    read: fn(&Flow) -> &[u32],
) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], cols), || {
        medax_view_u32::new(handle::maybe(flow).map_or(&[][..], |f| read(&f.flow)), cols)
    })
}

/// The flow at a point.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct medax_flow_point {
    /// The simplex at whose centre the driver lies. The point lies in its Voronoi face, or on the rim of that, and flows through it.
    pub simplex: medax_simplex,
    /// The driver: the point nearest to the query of the hull of its nearest samples.
    pub driver: [f64; 3],
    /// From the driver to the point, by the distance of the point from the samples: the flow. Its length is the speed at which the
    /// distance grows, in [0, 1]; 0 at critical points.
    pub vector: [f64; 3],
    /// The distance of the point from the samples, in input units.
    pub distance: f64,
    /// The driving angle: between the directions from the point to the driver and to a nearest sample, in [0, pi/2] radians; pi/2 at
    /// critical points but samples, 0 where one sample alone is nearest.
    pub angle: f64,
}

impl From<FlowAt> for medax_flow_point {
    fn from(at: FlowAt) -> Self {
        medax_flow_point {
            simplex: at.simplex.into(),
            driver: at.driver,
            vector: at.vector,
            distance: at.distance,
            angle: at.angle,
        }
    }
}

/// The flow at each of some points.
///
/// Which samples are nearest is decided exactly. Where several are, as on the faces of the Voronoi diagram, the driver is, of the centres
/// of all simplices of these samples that hold their own, that of the largest smallest sphere. Coordinates of less than 2^-160 count as 0.
///
/// \param flow The flow.
/// \param query_xyz `query_count` x 3 coordinates; NULL only if `query_count` is 0.
/// \param query_count The number of points.
/// \param job NULL for a default job.
/// \param out_at Receives `query_count` answers; the caller's buffer, NULL only if `query_count` is 0.
/// \return `MEDAX_STATUS_OK`; `NON_FINITE`, or `COORDINATE_RANGE` beyond 2^200, with the row of a query;
///         `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(n) once a call, and for each point O(way from the one before to it, in samples). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_at(
    flow: *const medax_flow,
    query_xyz: *const f64,
    query_count: usize,
    job: *const medax_job,
    out_at: *mut medax_flow_point,
) -> medax_status {
    boundary::status(|| {
        let flow = &handle::get(flow, "flow")?.flow;
        let queries = view::rows(query_xyz, query_count, "query_xyz")?;
        let out = Buffer::new(out_at, query_count, "out_at")?;
        let mut own = None;
        out.fill_from(&flow.at(queries, handle::job(job, &mut own))?);
        Ok(())
    })
}

/// The orbits of some points: each a polyline along the flow, from the point to the critical point where it ends, or to infinity.
///
/// The complex has them as loose edges, one orbit's after the other's. Vertices carry `radius`, their distance from the samples; edges
/// `orbit`, the query, and `end`, as in `out_ends`. The first vertex of each orbit is the query; that of a query that does not flow is
/// its only one. The last one of an orbit that goes to infinity lies on its last ray, one diagonal of the samples' box from the one before.
/// The facet that an orbit comes to first, and where it leaves that, are decided exactly; where orbits cross Voronoi edges is rounded.
///
/// \param flow The flow.
/// \param query_xyz `query_count` x 3 coordinates; NULL only if `query_count` is 0.
/// \param query_count The number of points.
/// \param job NULL for a default job.
/// \param out_ends Receives for each query the row of the critical point where its orbit ends, `MEDAX_NONE` at infinity; the caller's
///        buffer of `query_count` entries, or NULL.
/// \param out_orbits Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`; `NON_FINITE`, or `COORDINATE_RANGE` beyond 2^200, with the row of a query; `LIMIT_EXCEEDED` past
///         2^32 - 1 vertices; `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// As #medax_flow_at, and O(size of the Voronoi facets that an orbit crosses). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_orbits(
    flow: *const medax_flow,
    query_xyz: *const f64,
    query_count: usize,
    job: *const medax_job,
    out_ends: *mut u32,
    out_orbits: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let flow = &handle::get(flow, "flow")?.flow;
        let queries = view::rows(query_xyz, query_count, "query_xyz")?;
        let asked = if out_ends.is_null() { 0 } else { query_count };
        let ends = Buffer::new(out_ends, asked, "out_ends")?;
        let out = Out::new(out_orbits, "out_orbits")?;
        let mut own = None;
        let stages = [(Stage::Query, 0.9), (Stage::Extract, 0.1)];
        let (orbits, complex) = handle::job(job, &mut own).run(&stages, |run| {
            let orbits = flow.orbits_in(queries, run)?;
            let complex = orbits.complex_in(run)?;
            Ok((orbits, complex))
        })?;
        ends.fill(orbits.ends());
        out.put(complex::give(Arc::new(complex)));
        Ok(())
    })
}

/// What flows from some Voronoi cells, facets, edges and vertices: these, and whatever can be reached from them.
///
/// Of the simplex of a critical point that is its unstable manifold (section 5), hairs included; of a sample that of all facets of its Voronoi
/// cell. What is unbounded is left out. Attributes are those of #medax_flow_core.
///
/// \param flow The flow.
/// \param simplices The simplices whose duals flow; NULL only if `simplex_count` is 0.
/// \param simplex_count The number of them.
/// \param job NULL for a default job.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` with the row of a simplex that is not there; `NULL_ARGUMENT`, `LIMIT_EXCEEDED`,
///         `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size of the dual), and O(size) of what is reached. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_closure(
    flow: *const medax_flow,
    simplices: *const medax_simplex,
    simplex_count: usize,
    job: *const medax_job,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let flow = &handle::get(flow, "flow")?.flow;
        let given = view::slice(simplices, simplex_count, "simplices")?;
        let out = Out::new(out_complex, "out_complex")?;
        let simplex = |(row, simplex): (usize, &medax_simplex)| {
            simplex.translate().map_err(|error| error.at(ElementKind::Row, row as u64))
        };
        let simplices = given.iter().enumerate().map(simplex).collect::<Result<Vec<_>>>()?;
        let mut own = None;
        out.put(complex::give(Arc::new(flow.closure(&simplices, handle::job(job, &mut own))?)));
        Ok(())
    })
}

/// Checks drivers and critical points by other means than those that made them.
///
/// \param flow The flow.
/// \param job NULL for a default job.
/// \param out_report Filled, its `struct_size` being set.
/// \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report
///         of no version, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size of the dual). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_validate(
    flow: *const medax_flow,
    job: *const medax_job,
    out_report: *mut medax_validation,
) -> medax_status {
    validation::validate(job, out_report, |job| handle::get(flow, "flow")?.flow.validate(job))
}

/// One more reference to a flow.
///
/// \param flow The flow, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_clone(flow: *const medax_flow) -> *const medax_flow {
    boundary::value(ptr::null(), || handle::clone(flow))
}

/// Gives one reference to a flow back; the last one frees it.
///
/// \param flow The flow; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_free(flow: *const medax_flow) {
    boundary::value((), || handle::free(flow));
}

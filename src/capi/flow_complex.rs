//! Flow complex
//!
//! The unstable flow complex of a sample: the Voronoi diagram, cut where the flow of one part runs into a part of another, so that every
//! element flows into whole elements. A vertex flows into one edge; the part of a Voronoi edge that the flow crosses into one face; every
//! other edge to its ends, and every face to its rim. These steps, and those from an element to its sides, are the flow DAG: what can be
//! reached by them from some elements is their flow closure.
//!
//! Its cells are those of the Voronoi diagram, one for each sample. Vertices are first the Voronoi vertices, one for each cell of the
//! triangulation, then points on Voronoi edges; edges first the parts of Voronoi edges, then cuts through Voronoi facets along orbits of
//! Voronoi vertices; faces the parts of Voronoi facets. Where samples are cospherical, vertices lie in one place, and edges and faces may have
//! no extent: they are told apart by the triangulation. The paper's complex is coarser: here two faces may be in the unstable manifolds of the
//! same critical points.
//!
//! On scans it has 40 to 120 faces for each sample, and takes 4 to 13 kB; for a core or a closure alone a #medax_flow is enough.
//! (Giesen, Ramos, Sadri 2010, Medial axis approximation and unstable flow complex.)

use super::attribute::medax_element;
use super::boundary;
use super::complex;
use super::flow::medax_simplex;
use super::handle::{self, medax_complex, medax_flow, medax_flow_complex, medax_job};
use super::status::medax_status;
use super::validation::{self, medax_validation};
use super::view::{self, Buffer, Out, medax_view_f64, medax_view_rows, medax_view_u32};
use crate::error::{ElementKind, Error, Result, Status};
use crate::flow::{FlowComplex, FlowElement};
use crate::job::Job;
use std::ptr;
use std::sync::Arc;

/// An element of a flow complex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct medax_flow_element {
    /// A #medax_element: `MEDAX_ELEMENT_VERTEX`, `MEDAX_ELEMENT_EDGE` or `MEDAX_ELEMENT_FACE`.
    pub kind: u32,
    /// Which one of its kind.
    pub number: u32,
}

impl From<FlowElement> for medax_flow_element {
    fn from(element: FlowElement) -> Self {
        let (kind, number) = match element {
            FlowElement::Vertex(v) => (medax_element::Vertex, v),
            FlowElement::Edge(e) => (medax_element::Edge, e),
            FlowElement::Face(f) => (medax_element::Face, f),
        };
        medax_flow_element { kind: kind as u32, number }
    }
}

impl medax_flow_element {
    fn translate(self) -> Result<FlowElement> {
        let known: [fn(u32) -> FlowElement; 3] =
            [FlowElement::Vertex, FlowElement::Edge, FlowElement::Face];
        let elements = known.map(|element| element(self.number));
        let found = elements.into_iter().find(|&element| Self::from(element) == self);
        found.ok_or_else(|| {
            let message = format!("a flow complex has no elements of kind {}", self.kind);
            Error::new(Status::InvalidArgument, message)
        })
    }
}

/// The caller's elements.
unsafe fn elements(given: *const medax_flow_element, count: usize) -> Result<Vec<FlowElement>> {
    let element = |(row, element): (usize, &medax_flow_element)| {
        element.translate().map_err(|error| error.at(ElementKind::Row, row as u64))
    };
    view::slice(given, count, "elements")?.iter().enumerate().map(element).collect()
}

/// Makes all of the flow complex.
///
/// \param flow The flow, which the result keeps alive.
/// \param job NULL for a default job.
/// \param out_flow_complex Receives the flow complex, which the caller frees with #medax_flow_complex_free.
/// \return `MEDAX_STATUS_OK`; `LIMIT_EXCEEDED` past 2^32 - 1 sides of faces; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size of the complex), besides sorting the points on each Voronoi edge. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_complex_build(
    flow: *const medax_flow,
    job: *const medax_job,
    out_flow_complex: *mut *const medax_flow_complex,
) -> medax_status {
    boundary::status(|| {
        let flow = &handle::get(flow, "flow")?.flow;
        let out = Out::new(out_flow_complex, "out_flow_complex")?;
        let mut own = None;
        let flow_complex = FlowComplex::new(flow, handle::job(job, &mut own))?;
        out.put(handle::new(medax_flow_complex { flow_complex }));
        Ok(())
    })
}

/// The flow.
///
/// \param flow_complex The flow complex.
/// \param out_flow Receives the flow, which the caller frees with #medax_flow_free.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_complex_flow(
    flow_complex: *const medax_flow_complex,
    out_flow: *mut *const medax_flow,
) -> medax_status {
    boundary::status(|| {
        let its = &handle::get(flow_complex, "flow_complex")?.flow_complex;
        let out = Out::new(out_flow, "out_flow")?;
        out.put(handle::new(medax_flow { flow: its.flow().clone() }));
        Ok(())
    })
}

/// The number of vertices.
///
/// \param flow_complex The flow complex; NULL has none.
/// \return m + k for m cells of the triangulation and k #medax_flow_complex_points.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_complex_vertex_count(
    flow_complex: *const medax_flow_complex,
) -> usize {
    boundary::value(0, || {
        handle::maybe(flow_complex).map_or(0, |its| its.flow_complex.vertex_count())
    })
}

/// The points on Voronoi edges: the vertices that come after the Voronoi vertices, which lie where #medax_dual_centers has them.
///
/// \param flow_complex The flow complex, or NULL.
/// \return k x 3 coordinates: where orbits hit Voronoi edges, then the critical points of index 2. Borrowed from `flow_complex`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_complex_points(
    flow_complex: *const medax_flow_complex,
) -> medax_view_f64 {
    boundary::value(medax_view_f64::new(&[], 3), || {
        let points = handle::maybe(flow_complex).map_or(&[][..], |its| its.flow_complex.points());
        medax_view_f64::new(points.as_flattened(), 3)
    })
}

/// The triangle on whose Voronoi edge each of the points lies.
///
/// \param flow_complex The flow complex, or NULL.
/// \return k x 1 rows of #medax_flow_triangles. Borrowed from `flow_complex`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_complex_triangle_of_point(
    flow_complex: *const medax_flow_complex,
) -> medax_view_u32 {
    indices(flow_complex, 1, FlowComplex::triangle_of_point)
}

/// The two ends of each edge.
///
/// \param flow_complex The flow complex, or NULL.
/// \return e x 2 vertices, `MEDAX_NONE` at infinity. Orbits run from the first to the second end of a cut. Borrowed from `flow_complex`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_complex_edges(
    flow_complex: *const medax_flow_complex,
) -> medax_view_u32 {
    indices(flow_complex, 2, |its| its.edges().as_flattened())
}

/// The triangle whose Voronoi edge each edge is a part of.
///
/// \param flow_complex The flow complex, or NULL.
/// \return One row of #medax_flow_triangles for each of the first edges; those beyond are cuts. Borrowed from `flow_complex`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_complex_triangle_of_edge(
    flow_complex: *const medax_flow_complex,
) -> medax_view_u32 {
    indices(flow_complex, 1, FlowComplex::triangle_of_edge)
}

/// The vertices of each face.
///
/// \param flow_complex The flow complex, or NULL.
/// \return f rows, counterclockwise seen from the second end of the facet's dual edge; `MEDAX_NONE` at infinity. Borrowed from `flow_complex`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_complex_faces(
    flow_complex: *const medax_flow_complex,
) -> medax_view_rows {
    rows(flow_complex, |its| its.faces().indices())
}

/// The edges of each face.
///
/// \param flow_complex The flow complex, or NULL.
/// \return f rows, as long as those of #medax_flow_complex_faces: at the place of a vertex the edge that begins there. Borrowed from
///         `flow_complex`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_complex_face_edges(
    flow_complex: *const medax_flow_complex,
) -> medax_view_rows {
    rows(flow_complex, FlowComplex::face_edges)
}

/// Where the faces of each Voronoi facet begin.
///
/// \param flow_complex The flow complex, or NULL.
/// \return One entry more than #medax_dual_facets has rows: the faces of facet i are those from entry i to before entry i + 1. Borrowed from
///         `flow_complex`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_complex_faces_of_facet(
    flow_complex: *const medax_flow_complex,
) -> medax_view_u32 {
    indices(flow_complex, 1, FlowComplex::faces_of_facet)
}

/// The edge into which each vertex flows.
///
/// \param flow_complex The flow complex, or NULL.
/// \return One edge for each vertex; `MEDAX_NONE` for critical points. Borrowed from `flow_complex`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_complex_edge_of_vertex(
    flow_complex: *const medax_flow_complex,
) -> medax_view_u32 {
    indices(flow_complex, 1, FlowComplex::edge_of_vertex)
}

/// The face into which each edge flows.
///
/// \param flow_complex The flow complex, or NULL.
/// \return One face for each edge; `MEDAX_NONE` for those that flow along themselves. Borrowed from `flow_complex`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_complex_face_of_edge(
    flow_complex: *const medax_flow_complex,
) -> medax_view_u32 {
    indices(flow_complex, 1, FlowComplex::face_of_edge)
}

unsafe fn indices(
    flow_complex: *const medax_flow_complex,
    cols: usize,
    read: fn(&FlowComplex) -> &[u32],
) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], cols), || {
        let its = handle::maybe(flow_complex);
        medax_view_u32::new(its.map_or(&[][..], |its| read(&its.flow_complex)), cols)
    })
}

unsafe fn rows(
    flow_complex: *const medax_flow_complex,
    read: fn(&FlowComplex) -> &[u32],
) -> medax_view_rows {
    boundary::value(medax_view_rows::EMPTY, || {
        handle::maybe(flow_complex).map_or(medax_view_rows::EMPTY, |its| {
            let its = &its.flow_complex;
            medax_view_rows::new(its.faces().offsets(), read(its))
        })
    })
}

/// The elements that a Voronoi facet, edge or vertex is made of: its faces, its parts, or the vertex; but no cuts through a facet.
///
/// \param flow_complex The flow complex.
/// \param simplex The simplex whose dual is asked for.
/// \param capacity The number of elements for which `out_elements` has room.
/// \param out_elements Receives the first `capacity` of the elements, which ascend; the caller's buffer, NULL only if `capacity` is 0.
/// \param out_count Receives the number of elements, which may be more than `capacity`.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for a simplex that is not there; `NULL_ARGUMENT`.
///
/// O(size of the answer). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_complex_elements_of(
    flow_complex: *const medax_flow_complex,
    simplex: medax_simplex,
    capacity: usize,
    out_elements: *mut medax_flow_element,
    out_count: *mut usize,
) -> medax_status {
    boundary::status(|| {
        let its = &handle::get(flow_complex, "flow_complex")?.flow_complex;
        let target = Buffer::new(out_elements, capacity, "out_elements")?;
        let count = Out::new(out_count, "out_count")?;
        let found = its.elements_of(simplex.translate()?)?;
        count.put(found.len());
        target.fill_from(&found);
        Ok(())
    })
}

/// The flow closure of some elements: those that can be reached from them by the flow DAG, these included.
///
/// \param flow_complex The flow complex.
/// \param elements The elements to begin with; NULL only if `element_count` is 0.
/// \param element_count The number of them.
/// \param job NULL for a default job.
/// \param capacity The number of elements for which `out_elements` has room.
/// \param out_elements Receives the first `capacity` of the elements of the closure: vertices, then edges, then faces, ascending; the caller's
///        buffer, NULL only if `capacity` is 0.
/// \param out_count Receives the number of elements of the closure, which may be more than `capacity`.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` with the row of an element that is not there; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`,
///         `OUT_OF_MEMORY`.
///
/// O(size of the complex). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_complex_closure(
    flow_complex: *const medax_flow_complex,
    elements: *const medax_flow_element,
    element_count: usize,
    job: *const medax_job,
    capacity: usize,
    out_elements: *mut medax_flow_element,
    out_count: *mut usize,
) -> medax_status {
    let asked = (elements, element_count);
    reached(flow_complex, asked, job, capacity, out_elements, out_count, FlowComplex::closure)
}

/// The elements from which some elements can be reached by the flow DAG, these included: all that have a part of them in their closures.
///
/// \param flow_complex The flow complex.
/// \param elements The elements to end with; NULL only if `element_count` is 0.
/// \param element_count The number of them.
/// \param job NULL for a default job.
/// \param capacity The number of elements for which `out_elements` has room.
/// \param out_elements Receives the first `capacity` of the elements upstream: vertices, then edges, then faces, ascending; the caller's
///        buffer, NULL only if `capacity` is 0.
/// \param out_count Receives the number of elements upstream, which may be more than `capacity`.
/// \return As #medax_flow_complex_closure.
///
/// O(size of the complex). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_complex_upstream(
    flow_complex: *const medax_flow_complex,
    elements: *const medax_flow_element,
    element_count: usize,
    job: *const medax_job,
    capacity: usize,
    out_elements: *mut medax_flow_element,
    out_count: *mut usize,
) -> medax_status {
    let asked = (elements, element_count);
    reached(flow_complex, asked, job, capacity, out_elements, out_count, FlowComplex::upstream)
}

unsafe fn reached(
    flow_complex: *const medax_flow_complex,
    (given, element_count): (*const medax_flow_element, usize),
    job: *const medax_job,
    capacity: usize,
    out_elements: *mut medax_flow_element,
    out_count: *mut usize,
    reach: fn(&FlowComplex, &[FlowElement], &Job) -> Result<Vec<FlowElement>>,
) -> medax_status {
    boundary::status(|| {
        let its = &handle::get(flow_complex, "flow_complex")?.flow_complex;
        let given = elements(given, element_count)?;
        let target = Buffer::new(out_elements, capacity, "out_elements")?;
        let count = Out::new(out_count, "out_count")?;
        let mut own = None;
        let found = reach(its, &given, handle::job(job, &mut own))?;
        count.put(found.len());
        target.fill_from(&found);
        Ok(())
    })
}

/// The critical points in whose unstable manifolds each of some elements lies: those whose flow closure has it.
///
/// \param flow_complex The flow complex.
/// \param elements The elements; NULL only if `element_count` is 0.
/// \param element_count The number of them.
/// \param job NULL for a default job.
/// \param out_offsets Receives `element_count` + 1 positions: the set of element i is the rows from entry i to before entry i + 1, ascending.
/// \param capacity The number of rows for which `out_rows` has room.
/// \param out_rows Receives the first `capacity` rows of all sets, one set's after the other's, as #medax_flow_critical_points has them; the
///        caller's buffer, NULL only if `capacity` is 0.
/// \param out_count Receives the number of rows of all sets, which may be more than `capacity`.
/// \return As #medax_flow_complex_closure; `LIMIT_EXCEEDED` past 2^32 - 1 rows.
///
/// O(size of the complex), and for each element O(size) of what is upstream of it. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_complex_critical_sets(
    flow_complex: *const medax_flow_complex,
    elements: *const medax_flow_element,
    element_count: usize,
    job: *const medax_job,
    out_offsets: *mut u32,
    capacity: usize,
    out_rows: *mut u32,
    out_count: *mut usize,
) -> medax_status {
    boundary::status(|| {
        let its = &handle::get(flow_complex, "flow_complex")?.flow_complex;
        let given = self::elements(elements, element_count)?;
        let offsets = Buffer::new(out_offsets, given.len() + 1, "out_offsets")?;
        let rows = Buffer::new(out_rows, capacity, "out_rows")?;
        let count = Out::new(out_count, "out_count")?;
        let mut own = None;
        let sets = its.critical_sets(&given, handle::job(job, &mut own))?;
        count.put(sets.indices().len());
        offsets.fill(sets.offsets());
        rows.fill(sets.indices());
        Ok(())
    })
}

/// All of the flow complex that is bounded, with the attributes of #medax_flow_core.
///
/// \param flow_complex The flow complex.
/// \param job NULL for a default job.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`; `NULL_ARGUMENT`, `LIMIT_EXCEEDED`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size of the complex). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_complex_complex(
    flow_complex: *const medax_flow_complex,
    job: *const medax_job,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let its = &handle::get(flow_complex, "flow_complex")?.flow_complex;
        let out = Out::new(out_complex, "out_complex")?;
        let mut own = None;
        out.put(complex::give(Arc::new(its.complex(handle::job(job, &mut own))?)));
        Ok(())
    })
}

/// Checks a flow complex by other means than those that made it.
///
/// \param flow_complex The flow complex.
/// \param job NULL for a default job.
/// \param out_report Filled, its `struct_size` being set.
/// \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report
///         of no version, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size of the complex). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_complex_validate(
    flow_complex: *const medax_flow_complex,
    job: *const medax_job,
    out_report: *mut medax_validation,
) -> medax_status {
    validation::validate(job, out_report, |job| {
        handle::get(flow_complex, "flow_complex")?.flow_complex.validate(job)
    })
}

/// One more reference to a flow complex.
///
/// \param flow_complex The flow complex, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_complex_clone(
    flow_complex: *const medax_flow_complex,
) -> *const medax_flow_complex {
    boundary::value(ptr::null(), || handle::clone(flow_complex))
}

/// Gives one reference to a flow complex back; the last one frees it.
///
/// \param flow_complex The flow complex; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_flow_complex_free(flow_complex: *const medax_flow_complex) {
    boundary::value((), || handle::free(flow_complex));
}

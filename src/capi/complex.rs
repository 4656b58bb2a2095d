//! Complex
//!
//! The one output type: vertices; faces, which are polygons; loose edges, which are no side of a
//! face; volume cells; named attributes on each of them; and the faces cut into triangles.
//!
//! Faces of a solid's surface point out of the material, those of voids included. Elements are
//! told apart by their indices, never by where they lie.

use super::attribute::{self, medax_attribute};
use super::boundary;
use super::handle::{self, medax_complex};
use super::options::{self, sized_struct};
use super::status::medax_status;
use super::view::{self, Out, medax_view_f64, medax_view_rows, medax_view_u32};
use crate::complex::{CellType, Complex, ComplexParts, Rows};
use crate::error::{ElementKind, Error, Result, Status};
use std::ffi::c_char;
use std::ptr;
use std::sync::Arc;

/// The shape of a volume cell; its vertices are in VTK's order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum medax_cell_type {
    /// Four vertices.
    Tetrahedron = 1,
    /// A quadrilateral base, then the apex: five vertices.
    Pyramid = 2,
    /// A polygonal base of any size, then the apex.
    PolygonalPyramid = 3,
}

impl From<CellType> for medax_cell_type {
    fn from(kind: CellType) -> Self {
        match kind {
            CellType::Tetrahedron => medax_cell_type::Tetrahedron,
            CellType::Pyramid => medax_cell_type::Pyramid,
            CellType::PolygonalPyramid => medax_cell_type::PolygonalPyramid,
        }
    }
}

/// The arrays from which #medax_complex_create makes a complex. Each may be NULL if its count is
/// 0; the defaults are no element at all.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_complex_parts {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// `vertex_count` x 3 coordinates.
    pub vertices: *const f64,
    /// The number of vertices.
    pub vertex_count: usize,
    /// `face_count + 1` positions in `face_indices`, the first of them 0.
    pub face_offsets: *const u32,
    /// `face_offsets[face_count]` vertices: each face a ring.
    pub face_indices: *const u32,
    /// The number of faces.
    pub face_count: usize,
    /// `edge_count` x 2 vertices of edges that are no side of a face.
    pub edges: *const u32,
    /// The number of loose edges.
    pub edge_count: usize,
    /// `cell_count + 1` positions in `cell_indices`, the first of them 0.
    pub cell_offsets: *const u32,
    /// `cell_offsets[cell_count]` vertices.
    pub cell_indices: *const u32,
    /// `cell_count` times a #medax_cell_type.
    pub cell_types: *const u32,
    /// The number of volume cells.
    pub cell_count: usize,
    /// `attribute_count` attributes.
    pub attributes: *const medax_attribute,
    /// The number of attributes.
    pub attribute_count: usize,
    /// 2 for plane results, whose z is 0 throughout, else 3; 0 stands for 3.
    pub dimension: u32,
    /// Must be 0.
    pub reserved: u32,
}

sized_struct!(medax_complex_parts, first_size: size_of::<medax_complex_parts>(),
    reserved: reserved, {
    vertices: *const f64 = ptr::null(),
    vertex_count: usize = 0,
    face_offsets: *const u32 = ptr::null(),
    face_indices: *const u32 = ptr::null(),
    face_count: usize = 0,
    edges: *const u32 = ptr::null(),
    edge_count: usize = 0,
    cell_offsets: *const u32 = ptr::null(),
    cell_indices: *const u32 = ptr::null(),
    cell_types: *const u32 = ptr::null(),
    cell_count: usize = 0,
    attributes: *const medax_attribute = ptr::null(),
    attribute_count: usize = 0,
    dimension: u32 = 0,
    reserved: u32 = 0,
});

/// Sets complex parts to none.
///
/// \param parts The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *parts`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_parts_init(
    parts: *mut medax_complex_parts,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(parts, struct_size, "parts"))
}

/// Makes a complex of the caller's arrays, which are checked and copied.
///
/// \param parts The arrays.
/// \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` or `MISMATCH` with the face, edge or cell that has
///         too few vertices or an unknown one; `NON_FINITE` with the vertex; `NULL_ARGUMENT`,
///         `LIMIT_EXCEEDED` past 2^32 - 2 elements.
///
/// O(n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_create(
    parts: *const medax_complex_parts,
    out_complex: *mut *const medax_complex,
) -> medax_status {
    boundary::status(|| {
        let out = Out::new(out_complex, "out_complex")?;
        if parts.is_null() {
            return Err(view::null("parts"));
        }
        let parts = options::read(parts, "parts")?;
        if !matches!(parts.dimension, 0 | 2 | 3) {
            let message = format!("the dimension is {}, and must be 2 or 3", parts.dimension);
            return Err(Error::new(Status::InvalidArgument, message));
        }
        let kinds = view::slice(parts.cell_types, parts.cell_count, "cell_types")?;
        let attributes = view::slice(parts.attributes, parts.attribute_count, "attributes")?;
        let complex = Complex::new(ComplexParts {
            dimension: parts.dimension,
            vertices: view::rows(parts.vertices, parts.vertex_count, "vertices")?.to_vec(),
            faces: rows(parts.face_offsets, parts.face_indices, parts.face_count, "face")?,
            edges: view::rows(parts.edges, parts.edge_count, "edges")?.to_vec(),
            cells: rows(parts.cell_offsets, parts.cell_indices, parts.cell_count, "cell")?,
            cell_types: kinds.iter().enumerate().map(cell_type).collect::<Result<_>>()?,
            attributes: attributes.iter().map(|a| attribute::read(a)).collect::<Result<_>>()?,
        })?;
        out.put(give(Arc::new(complex)));
        Ok(())
    })
}

/// A new handle on a complex.
pub(super) fn give(complex: Arc<Complex>) -> *const medax_complex {
    let names = attribute::names(complex.attributes());
    handle::new(medax_complex { complex, names })
}

/// The caller's rows of varying length.
unsafe fn rows(offsets: *const u32, indices: *const u32, count: usize, name: &str) -> Result<Rows> {
    if count == 0 {
        return Ok(Rows::default());
    }
    let ends = count.checked_add(1).ok_or_else(|| {
        Error::new(Status::InvalidArgument, format!("no memory holds {count} rows"))
    })?;
    let offsets = view::slice(offsets, ends, &format!("{name}_offsets"))?;
    let total = offsets[count] as usize;
    let indices = view::slice(indices, total, &format!("{name}_indices"))?;
    Rows::new(offsets.to_vec(), indices.to_vec())
}

fn cell_type((cell, &number): (usize, &u32)) -> Result<CellType> {
    [CellType::Tetrahedron, CellType::Pyramid, CellType::PolygonalPyramid]
        .into_iter()
        .find(|&kind| medax_cell_type::from(kind) as u32 == number)
        .ok_or_else(|| {
            Error::new(Status::InvalidArgument, format!("{number} is not a cell type"))
                .at(ElementKind::Cell, cell as u64)
        })
}

/// 2 for plane results, whose z is 0 throughout, else 3.
///
/// \param complex The complex; NULL has dimension 3.
/// \return 2 or 3.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_dimension(complex: *const medax_complex) -> u32 {
    boundary::value(3, || handle::maybe(complex).map_or(3, |c| c.complex.dimension()))
}

/// The vertices of a complex.
///
/// \param complex The complex, or NULL.
/// \return v x 3 coordinates, in input units. Borrowed from `complex`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_vertices(complex: *const medax_complex) -> medax_view_f64 {
    boundary::value(medax_view_f64::new(&[], 3), || {
        let vertices = handle::maybe(complex).map_or(&[][..], |c| c.complex.vertices());
        medax_view_f64::new(vertices.as_flattened(), 3)
    })
}

/// The faces of a complex.
///
/// \param complex The complex, or NULL.
/// \return One row a face: a ring of three vertices or more. Borrowed from `complex`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_faces(complex: *const medax_complex) -> medax_view_rows {
    row_view(complex, Complex::faces)
}

/// The loose edges of a complex: those that are no side of a face.
///
/// \param complex The complex, or NULL.
/// \return e x 2 vertices. Borrowed from `complex`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_edges(complex: *const medax_complex) -> medax_view_u32 {
    index_view(complex, 2, |c| c.edges().as_flattened())
}

/// The volume cells of a complex.
///
/// \param complex The complex, or NULL.
/// \return One row a cell: its vertices in VTK's order. Borrowed from `complex`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_cells(complex: *const medax_complex) -> medax_view_rows {
    row_view(complex, Complex::cells)
}

/// The type of each volume cell.
///
/// \param complex The complex, or NULL.
/// \return One row a cell: a #medax_cell_type. Borrowed from `complex`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_cell_types(complex: *const medax_complex) -> medax_view_u32 {
    index_view(complex, 1, |c| view::numbers(c.cell_types()))
}

/// The faces of a complex cut into triangles: a fan from each face's first vertex, with the
/// orientation of the face, in the order of the faces.
///
/// \param complex The complex, or NULL.
/// \return t x 3 vertices. Borrowed from `complex`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_triangles(complex: *const medax_complex) -> medax_view_u32 {
    index_view(complex, 3, |c| c.triangles().as_flattened())
}

/// The face that each triangle is part of.
///
/// \param complex The complex, or NULL.
/// \return t x 1 faces, ascending. Borrowed from `complex`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_face_of_triangle(
    complex: *const medax_complex,
) -> medax_view_u32 {
    index_view(complex, 1, Complex::face_of_triangle)
}

unsafe fn row_view(complex: *const medax_complex, read: fn(&Complex) -> &Rows) -> medax_view_rows {
    boundary::value(medax_view_rows::EMPTY, || {
        handle::maybe(complex).map_or(medax_view_rows::EMPTY, |c| {
            let rows = read(&c.complex);
            medax_view_rows::new(rows.offsets(), rows.indices())
        })
    })
}

unsafe fn index_view(
    complex: *const medax_complex,
    cols: usize,
    read: fn(&Complex) -> &[u32],
) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], cols), || {
        medax_view_u32::new(handle::maybe(complex).map_or(&[][..], |c| read(&c.complex)), cols)
    })
}

/// The number of attributes of a complex.
///
/// \param complex The complex; NULL has none.
/// \return The number of attributes, over all kinds of elements.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_attribute_count(complex: *const medax_complex) -> usize {
    boundary::value(0, || handle::maybe(complex).map_or(0, |c| c.names.len()))
}

/// An attribute of a complex by its number.
///
/// \param complex The complex.
/// \param index Which attribute, below #medax_complex_attribute_count.
/// \param out_attribute Receives the attribute, whose name and values are borrowed from `complex`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` past the last attribute.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_attribute_at(
    complex: *const medax_complex,
    index: usize,
    out_attribute: *mut medax_attribute,
) -> medax_status {
    boundary::status(|| {
        let complex = handle::get(complex, "complex")?;
        let out = Out::new(out_attribute, "out_attribute")?;
        out.put(attribute::at(complex.complex.attributes(), &complex.names, index)?);
        Ok(())
    })
}

/// The attribute of a complex with the given name.
///
/// \param complex The complex.
/// \param element A #medax_element: what carries the attribute.
/// \param name The name, such as `radius`; UTF-8.
/// \param out_attribute Receives the attribute, whose name and values are borrowed from `complex`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` if there is none.
///
/// O(attributes). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_attribute(
    complex: *const medax_complex,
    element: u32,
    name: *const c_char,
    out_attribute: *mut medax_attribute,
) -> medax_status {
    boundary::status(|| {
        let complex = handle::get(complex, "complex")?;
        let name = view::text(name, "name")?;
        let out = Out::new(out_attribute, "out_attribute")?;
        out.put(attribute::named(complex.complex.attributes(), &complex.names, element, name)?);
        Ok(())
    })
}

/// One more reference to a complex.
///
/// \param complex The complex, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_clone(
    complex: *const medax_complex,
) -> *const medax_complex {
    boundary::value(ptr::null(), || handle::clone(complex))
}

/// Gives one reference to a complex back; the last one frees it.
///
/// \param complex The complex; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_complex_free(complex: *const medax_complex) {
    boundary::value((), || handle::free(complex));
}

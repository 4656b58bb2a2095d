//! VTU, ParaView's unstructured grid, written only: XML with the arrays in base64. (Raw arrays would
//! be smaller, but meshio runs some of them into the next.)
//!
//! Cells are, in this order, the loose edges, the faces and the volume cells; where there are
//! none, each vertex is a cell, so that points can be seen. Attributes of edges, faces and volume
//! cells share one array per name: cells of the other kinds get NaN, or `MEDAX_NONE` where the
//! values are whole.

use super::sink::Sink;
use crate::complex::{Attribute, CellType, Complex, Element, Values};
use crate::error::Result;
use crate::index::NONE;

/// VTK's numbers for the shapes of cells.
mod shape {
    pub const VERTEX: u8 = 1;
    pub const LINE: u8 = 3;
    pub const TRIANGLE: u8 = 5;
    pub const POLYGON: u8 = 7;
    pub const QUAD: u8 = 9;
    pub const TETRAHEDRON: u8 = 10;
    pub const PYRAMID: u8 = 14;
    pub const POLYHEDRON: u8 = 42;
}

/// The kinds of elements that are VTK cells, in their order.
const CELL_KINDS: [Element; 3] = [Element::Edge, Element::Face, Element::Cell];

/// An array of the file: what its XML says, and what it holds.
struct Array<'a> {
    name: String,
    width: usize,
    data: Data<'a>,
}

enum Data<'a> {
    Coordinates,
    Connectivity,
    Ends,
    Shapes,
    Faces,
    FaceEnds,
    /// An attribute for each kind of element that is to be listed, or what stands for it.
    Values {
        is_whole: bool,
        parts: Vec<(Element, Option<&'a Attribute>)>,
    },
}

pub(super) fn write(complex: &Complex, out: &mut Sink<'_>) -> Result<()> {
    let named = |name: &str, width, data| Array { name: name.to_string(), width, data };
    let mut cells = vec![
        named("connectivity", 1, Data::Connectivity),
        named("offsets", 1, Data::Ends),
        named("types", 1, Data::Shapes),
    ];
    if complex.cell_types().contains(&CellType::PolygonalPyramid) {
        cells.push(named("faces", 1, Data::Faces));
        cells.push(named("faceoffsets", 1, Data::FaceEnds));
    }
    let sections = [
        ("PointData", attributes(complex, &[Element::Vertex])),
        ("CellData", attributes(complex, &CELL_KINDS)),
        ("Points", vec![named("Points", 3, Data::Coordinates)]),
        ("Cells", cells),
    ];
    out.text(format_args!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" \
         byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n\
         <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
        complex.vertices().len(),
        cell_count(complex),
    ))?;
    for (section, arrays) in sections {
        match arrays.iter().find(|array| section == "PointData" && SHOWN.contains(&&*array.name)) {
            Some(array) => out.text(format_args!("<{section} Scalars=\"{}\">\n", array.name))?,
            None => out.text(format_args!("<{section}>\n"))?,
        }
        for array in arrays {
            let (name, width, ty) = (escaped(&array.name), array.width, array.data.ty());
            out.text(format_args!(
                "<DataArray type=\"{ty}\" Name=\"{name}\" NumberOfComponents=\"{width}\" \
                 format=\"binary\">"
            ))?;
            out.base64(|out| {
                out.bytes(&array.bytes(complex).to_le_bytes())?;
                array.put(complex, out)
            })?;
            out.text(format_args!("</DataArray>\n"))?;
        }
        out.text(format_args!("</{section}>\n"))?;
    }
    out.text(format_args!("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"))
}

/// The attributes of vertices by which a host that opens a file colours it, until it is told otherwise.
const SHOWN: [&str; 3] = ["radius", "thickness", "t"];

/// The attributes of these kinds of elements; those that agree in all but the kind share an array.
fn attributes<'a>(complex: &'a Complex, kinds: &[Element]) -> Vec<Array<'a>> {
    let mut arrays: Vec<Array<'a>> = Vec::new();
    for attribute in complex.attributes() {
        let Some(kind) = kinds.iter().position(|kind| *kind == attribute.element()) else {
            continue;
        };
        if attribute.rows() == 0 {
            continue;
        }
        let whole = matches!(attribute.values(), Values::U32(_));
        let shares = |array: &&mut Array<'_>| match &array.data {
            Data::Values { is_whole, parts } => {
                let same = array.name == attribute.name() && array.width == attribute.width();
                same && *is_whole == whole && parts[kind].1.is_none()
            }
            _ => false,
        };
        if let Some(Array { data: Data::Values { parts, .. }, .. }) = arrays.iter_mut().find(shares)
        {
            parts[kind].1 = Some(attribute);
            continue;
        }
        let mut name = attribute.name().to_string();
        while arrays.iter().any(|array| array.name == name) {
            name.push('_');
        }
        let mut parts: Vec<(Element, Option<&Attribute>)> =
            kinds.iter().map(|kind| (*kind, None)).collect();
        parts[kind].1 = Some(attribute);
        let data = Data::Values { is_whole: whole, parts };
        arrays.push(Array { name, width: attribute.width(), data });
    }
    arrays
}

impl Data<'_> {
    fn ty(&self) -> &'static str {
        match self {
            Data::Coordinates | Data::Values { is_whole: false, .. } => "Float64",
            Data::Values { is_whole: true, .. } => "UInt32",
            Data::Shapes => "UInt8",
            _ => "Int64",
        }
    }

    fn value_bytes(&self) -> usize {
        match self.ty() {
            "UInt8" => 1,
            "UInt32" => 4,
            _ => 8,
        }
    }
}

impl Array<'_> {
    /// The bytes that the values take.
    fn bytes(&self, complex: &Complex) -> u64 {
        let values = match &self.data {
            Data::Coordinates => complex.vertices().len() * 3,
            Data::Connectivity => sum_cells(complex, |corners, _| corners.len()),
            Data::Ends | Data::Shapes | Data::FaceEnds => cell_count(complex),
            Data::Faces => sum_cells(complex, polyhedron_len),
            Data::Values { parts, .. } => {
                let rows: usize = parts.iter().map(|(kind, _)| complex.element_count(*kind)).sum();
                rows * self.width
            }
        };
        values as u64 * self.data.value_bytes() as u64
    }

    fn put(&self, complex: &Complex, out: &mut Sink<'_>) -> Result<()> {
        let mut end = 0;
        match &self.data {
            Data::Coordinates => put_f64(complex.vertices().as_flattened(), out),
            Data::Connectivity => for_cells(complex, |corners, _| {
                corners.iter().try_for_each(|&v| put_i64(v.into(), out))?;
                out.row()
            }),
            Data::Ends => for_cells(complex, |corners, _| {
                end += corners.len();
                put_i64(end as i64, out)?;
                out.row()
            }),
            Data::Shapes => for_cells(complex, |_, shape| {
                out.bytes(&[shape])?;
                out.row()
            }),
            Data::Faces => for_cells(complex, |corners, shape| {
                if shape == shape::POLYHEDRON {
                    put_polyhedron(corners, out)?;
                }
                out.row()
            }),
            Data::FaceEnds => for_cells(complex, |corners, shape| {
                end += polyhedron_len(corners, shape);
                put_i64(if shape == shape::POLYHEDRON { end as i64 } else { -1 }, out)?;
                out.row()
            }),
            Data::Values { is_whole, parts } => {
                for (kind, attribute) in parts {
                    let count = complex.element_count(*kind) * self.width;
                    match attribute.map(Attribute::values) {
                        Some(Values::F64(values)) => put_f64(values, out)?,
                        Some(Values::U32(values)) => put_u32(values.iter().copied(), out)?,
                        None if *is_whole => put_u32(std::iter::repeat_n(NONE, count), out)?,
                        None => put_f64(&vec![f64::NAN; count], out)?,
                    }
                }
                Ok(())
            }
        }
    }
}

fn put_f64(values: &[f64], out: &mut Sink<'_>) -> Result<()> {
    for value in values {
        out.bytes(&value.to_le_bytes())?;
        out.row()?;
    }
    Ok(())
}

fn put_u32(values: impl Iterator<Item = u32>, out: &mut Sink<'_>) -> Result<()> {
    for value in values {
        out.bytes(&value.to_le_bytes())?;
        out.row()?;
    }
    Ok(())
}

fn put_i64(value: i64, out: &mut Sink<'_>) -> Result<()> {
    out.bytes(&value.to_le_bytes())
}

/// Every VTK cell in order, with its shape.
fn for_cells(complex: &Complex, mut visit: impl FnMut(&[u32], u8) -> Result<()>) -> Result<()> {
    for edge in complex.edges() {
        visit(edge, shape::LINE)?;
    }
    for face in complex.faces().iter() {
        let shape = match face.len() {
            3 => shape::TRIANGLE,
            4 => shape::QUAD,
            _ => shape::POLYGON,
        };
        visit(face, shape)?;
    }
    for (corners, kind) in complex.cells().iter().zip(complex.cell_types()) {
        let shape = match kind {
            CellType::Tetrahedron => shape::TETRAHEDRON,
            CellType::Pyramid => shape::PYRAMID,
            CellType::PolygonalPyramid => shape::POLYHEDRON,
        };
        visit(corners, shape)?;
    }
    if is_points(complex) {
        (0..complex.vertices().len() as u32).try_for_each(|v| visit(&[v], shape::VERTEX))?;
    }
    Ok(())
}

fn is_points(complex: &Complex) -> bool {
    CELL_KINDS.iter().all(|kind| complex.element_count(*kind) == 0)
}

fn cell_count(complex: &Complex) -> usize {
    match is_points(complex) {
        true => complex.vertices().len(),
        false => CELL_KINDS.iter().map(|kind| complex.element_count(*kind)).sum(),
    }
}

fn sum_cells(complex: &Complex, size: impl Fn(&[u32], u8) -> usize) -> usize {
    let mut sum = 0;
    // The visitor never fails.
    let _ = for_cells(complex, |corners, shape| {
        sum += size(corners, shape);
        Ok(())
    });
    sum
}

/// How many numbers describe the faces of a polyhedron; 0 for other shapes.
fn polyhedron_len(corners: &[u32], shape: u8) -> usize {
    match shape {
        // The number of faces; the base and its length; a triangle and its length for each side.
        shape::POLYHEDRON => 1 + corners.len() + 4 * (corners.len() - 1),
        _ => 0,
    }
}

/// The faces of a pyramid whose apex is the last corner: their number, then each with its length.
/// All face outward, as VTK asks; seen from outside, the base turns the other way than it does from the apex.
fn put_polyhedron(corners: &[u32], out: &mut Sink<'_>) -> Result<()> {
    let Some((&apex, base)) = corners.split_last() else { return Ok(()) };
    put_i64(base.len() as i64 + 1, out)?;
    put_i64(base.len() as i64, out)?;
    base.iter().rev().try_for_each(|&v| put_i64(v.into(), out))?;
    for k in 0..base.len() {
        let (a, b) = (base[k], base[(k + 1) % base.len()]);
        put_i64(3, out)?;
        [a, b, apex].iter().try_for_each(|&v| put_i64(v.into(), out))?;
    }
    Ok(())
}

/// The text as an XML attribute may hold it; control characters become `_`.
fn escaped(text: &str) -> String {
    text.chars()
        .map(|c| match c {
            '&' => "&amp;".to_string(),
            '<' => "&lt;".to_string(),
            '>' => "&gt;".to_string(),
            '"' => "&quot;".to_string(),
            c if c.is_control() => "_".to_string(),
            c => c.to_string(),
        })
        .collect()
}

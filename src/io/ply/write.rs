//! Writing: vertices, faces as polygons, loose edges as `edge`, attributes as properties.

use super::names::{plain, properties};
use crate::complex::{Attribute, Complex, Element, Values};
use crate::error::Result;
use crate::io::sink::Sink;

/// The attributes of one kind of element, under names that are free.
struct Table<'a> {
    columns: Vec<(&'a Attribute, Vec<String>)>,
}

impl<'a> Table<'a> {
    /// `taken` are the names that the element's own properties have.
    fn new(complex: &'a Complex, element: Element, taken: &[&str], out: &mut Sink<'_>) -> Self {
        let mut table = Table { columns: Vec::new() };
        let mut taken: Vec<String> = taken.iter().map(|name| name.to_string()).collect();
        let of_element = || complex.attributes().iter().filter(|a| a.element() == element);
        for attribute in of_element() {
            let names = properties(attribute);
            let name = attribute.name();
            if names.iter().any(|name| name.is_empty() || taken.contains(name)) {
                out.warn(format!("attribute '{name}' was left out: its PLY name is taken"));
                continue;
            }
            let plain = plain(name);
            if plain != name {
                out.warn(format!("attribute '{name}' was written as '{plain}'"));
            }
            taken.extend(names.iter().cloned());
            table.columns.push((attribute, names));
        }
        let quality = "quality".to_string();
        let radius = of_element().find(|a| a.name() == "radius" && a.width() == 1);
        if let (Element::Vertex, Some(radius)) = (element, radius)
            && !taken.contains(&quality)
        {
            table.columns.push((radius, vec![quality]));
        }
        table
    }

    fn declare(&self, out: &mut Sink<'_>) -> Result<()> {
        for (attribute, names) in &self.columns {
            let ty = match attribute.values() {
                Values::F64(_) => "double",
                Values::U32(_) => "uint",
            };
            for name in names {
                out.text(format_args!("property {ty} {name}\n"))?;
            }
        }
        Ok(())
    }

    fn put(&self, row: usize, line: &mut Row) {
        for (attribute, names) in &self.columns {
            let range = row * names.len()..(row + 1) * names.len();
            match attribute.values() {
                Values::F64(values) => values[range].iter().for_each(|&value| line.real(value)),
                Values::U32(values) => values[range].iter().for_each(|&value| line.whole(value)),
            }
        }
    }
}

/// One row in the making, text or little endian.
struct Row {
    bytes: Vec<u8>,
    text: bool,
}

impl Row {
    fn real(&mut self, value: f64) {
        match self.text {
            true => self.word(format_args!("{value:?}")),
            false => self.bytes.extend(value.to_le_bytes()),
        }
    }

    fn whole(&mut self, value: u32) {
        match self.text {
            true => self.word(format_args!("{value}")),
            false => self.bytes.extend(value.to_le_bytes()),
        }
    }

    /// A list's length, in one byte or four.
    fn length(&mut self, length: usize, is_short: bool) {
        match self.text || !is_short {
            true => self.whole(length as u32),
            false => self.bytes.push(length as u8),
        }
    }

    fn word(&mut self, word: std::fmt::Arguments<'_>) {
        if !self.bytes.is_empty() {
            self.bytes.push(b' ');
        }
        self.bytes.extend(word.to_string().into_bytes());
    }

    fn end(&mut self, out: &mut Sink<'_>) -> Result<()> {
        if self.text {
            self.bytes.push(b'\n');
        }
        out.bytes(&self.bytes)?;
        self.bytes.clear();
        out.row()
    }
}

pub(in crate::io) fn write(complex: &Complex, text: bool, out: &mut Sink<'_>) -> Result<()> {
    let (vertices, faces, edges) = (complex.vertices(), complex.faces(), complex.edges());
    let of_vertex = Table::new(complex, Element::Vertex, &["x", "y", "z"], out);
    let corners = ["vertex_indices", "vertex_index"];
    let of_face = Table::new(complex, Element::Face, &corners, out);
    let of_edge = Table::new(complex, Element::Edge, &["vertex1", "vertex2"], out);
    let is_short = faces.iter().all(|face| face.len() <= usize::from(u8::MAX));
    let length = if is_short { "uchar" } else { "int" };
    // Signed is what other programs expect; the bytes are the same.
    let index = if i32::try_from(vertices.len()).is_ok() { "int" } else { "uint" };

    let format = if text { "ascii" } else { "binary_little_endian" };
    out.text(format_args!("ply\nformat {format} 1.0\nelement vertex {}\n", vertices.len()))?;
    out.text(format_args!("property double x\nproperty double y\nproperty double z\n"))?;
    of_vertex.declare(out)?;
    if !faces.is_empty() {
        out.text(format_args!("element face {}\n", faces.len()))?;
        out.text(format_args!("property list {length} {index} vertex_indices\n"))?;
        of_face.declare(out)?;
    }
    if !edges.is_empty() {
        out.text(format_args!("element edge {}\n", edges.len()))?;
        out.text(format_args!("property {index} vertex1\nproperty {index} vertex2\n"))?;
        of_edge.declare(out)?;
    }
    out.text(format_args!("end_header\n"))?;

    let mut row = Row { bytes: Vec::new(), text };
    for (i, xyz) in vertices.iter().enumerate() {
        xyz.iter().for_each(|&x| row.real(x));
        of_vertex.put(i, &mut row);
        row.end(out)?;
    }
    for (i, face) in faces.iter().enumerate() {
        row.length(face.len(), is_short);
        face.iter().for_each(|&vertex| row.whole(vertex));
        of_face.put(i, &mut row);
        row.end(out)?;
    }
    for (i, edge) in edges.iter().enumerate() {
        edge.iter().for_each(|&vertex| row.whole(vertex));
        of_edge.put(i, &mut row);
        row.end(out)?;
    }
    Ok(())
}

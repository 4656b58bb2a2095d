//! OFF, Geomview's Object File Format: a keyword, the counts, a vertex a line, a face a line.
//!
//! The keyword is `OFF` with any of the prefixes `ST`, `C` and `N` in that order: texture
//! coordinates, colours and normals follow the coordinates of each vertex. Counts may stand on the
//! keyword's line, and even be glued to it, as in the ModelNet data set. The `4` and `n` prefixes
//! and the binary form are not read.

use super::sink::Sink;
use super::soup::{Builder, Soup};
use super::text::{Line, Lines, Words, at_line, shown};
use crate::complex::{Attribute, Complex, Element, Values};
use crate::error::{ElementKind, Error, Result, Status};
use crate::job::Run;

/// The columns that a keyword's prefixes announce.
struct Header {
    texture: bool,
    color: bool,
    normal: bool,
}

impl Header {
    /// How many numbers may follow what is kept of a vertex. A colour has three or four, and is
    /// met without being announced.
    fn more_counts(&self) -> &'static [usize] {
        match (self.color, self.texture) {
            (false, false) => &[0, 3, 4],
            (true, false) => &[3, 4],
            (false, true) => &[2],
            (true, true) => &[5, 6],
        }
    }
}

pub(super) fn parse(bytes: &[u8], run: &Run<'_>) -> Result<Soup> {
    let mut lines = Lines::new(bytes, run);
    let first = lines.expect("the keyword OFF")?;
    let (header, mut words) = keyword(first)?;
    if words.is_at_end() {
        words = lines.expect("the counts")?.words();
    }
    let counted = (ElementKind::Line, lines.number());
    let vertex_count = words.whole("the number of vertices")?;
    let face_count = words.whole("the number of faces")?;
    if !words.is_at_end() {
        words.whole("the number of edges")?;
    }
    words.finish("the counts")?;
    lines.check_room(vertex_count, "0 0 0\n".len() as u64, "vertices")?;
    lines.check_room(face_count, "3 0 0 0\n".len() as u64, "faces")?;

    let mut builder = Builder::new(run);
    let mut normals = Vec::new();
    builder.room.reserve(&mut builder.vertices, vertex_count as usize)?;
    for _ in 0..vertex_count {
        let line = lines.expect("the last vertex")?;
        let mut words = line.words();
        builder.vertex(words.xyz()?)?;
        if header.normal {
            for name in ["nx", "ny", "nz"] {
                let value = words.f64(name)?;
                builder.room.push(&mut normals, value)?;
            }
        }
        check_rest(words, header.more_counts(), line.number, "the vertex")?;
    }
    builder.reserve_faces(face_count as usize)?;
    for _ in 0..face_count {
        let line = lines.expect("the last face")?;
        let mut words = line.words();
        let corners = words.whole("the number of corners")?;
        if corners < 3 {
            let message = format!("a face needs three corners or more, and this one has {corners}");
            return Err(at_line(line.number, message));
        }
        for _ in 0..corners {
            let vertex = words.index("a corner", vertex_count as usize)?;
            builder.corner(vertex)?;
        }
        builder.close_face()?;
        check_rest(words, &[0, 1, 3, 4], line.number, "the face")?;
    }
    lines.finish("the last face")?;
    if header.normal {
        let values = Values::F64(normals);
        builder.attributes.push(Attribute::new("normal", Element::Vertex, 3, values)?);
    }
    builder.finish(counted)
}

/// Reads the keyword, and returns what is left of its line.
fn keyword(line: Line<'_>) -> Result<(Header, Words<'_>)> {
    let text = line.bytes.trim_ascii_start();
    let word = line.words().expect("the keyword OFF")?;
    let unknown = || {
        at_line(
            line.number,
            format!("an OFF file begins with the keyword OFF, not {}", shown(word)),
        )
    };
    let end = word.windows(3).position(|w| w == b"OFF").ok_or_else(unknown)? + 3;
    let mut prefix = &word[..end - 3];
    let mut take = |letters: &[u8]| {
        let rest = prefix.strip_prefix(letters);
        prefix = rest.unwrap_or(prefix);
        rest.is_some()
    };
    let header = Header { texture: take(b"ST"), color: take(b"C"), normal: take(b"N") };
    let other_dimension = take(b"4") | take(b"n");
    if !prefix.is_empty() || !(end == word.len() || word[end].is_ascii_digit()) {
        return Err(unknown());
    }
    let words = Line { number: line.number, bytes: &text[end..] }.words();
    if other_dimension || words.clone().next() == Some(b"BINARY") {
        return Err(Error::new(
            Status::Unsupported,
            "medax reads OFF as text in three dimensions, not its binary, 4OFF and nOFF kinds",
        )
        .at(ElementKind::Line, line.number));
    }
    Ok((header, words))
}

/// Checks that the rest of a line is as many numbers as one of `counts` says.
fn check_rest(mut words: Words<'_>, counts: &[usize], line: u64, what: &str) -> Result<()> {
    let mut found = 0;
    while !words.is_at_end() {
        words.f64("a colour or texture coordinate")?;
        found += 1;
    }
    if !counts.contains(&found) {
        return Err(at_line(line, format!("{found} numbers follow {what}: too many or too few")));
    }
    Ok(())
}

pub(super) fn write(complex: &Complex, out: &mut Sink<'_>) -> Result<()> {
    let (vertices, faces) = (complex.vertices(), complex.faces());
    out.text(format_args!("OFF\n{} {} 0\n", vertices.len(), faces.len()))?;
    for [x, y, z] in vertices {
        out.text(format_args!("{x:?} {y:?} {z:?}\n"))?;
        out.row()?;
    }
    for face in faces.iter() {
        out.text(format_args!("{}", face.len()))?;
        for vertex in face {
            out.text(format_args!(" {vertex}"))?;
        }
        out.text(format_args!("\n"))?;
        out.row()?;
    }
    Ok(())
}

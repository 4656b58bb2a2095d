//! STL, stereolithography: triangles with the coordinates of their corners, and no indices.
//!
//! So equal corners are merged by position: the one place where coordinates decide what is one
//! vertex. A facet with two equal corners is left out, which keeps a closed surface closed.
//! Normals, names and the attribute bytes are passed over; several solids become one soup.
//!
//! A binary file may begin with `solid`, as a text does. Its length tells: 84 bytes and 50 a facet.

use super::sink::Sink;
use super::soup::{Builder, Soup};
use super::text::{Line, Lines, at_line, shown};
use crate::complex::Complex;
use crate::error::{ElementKind, Error, Result, Status};
use crate::job::Run;
use std::collections::HashMap;

/// The header's bytes, then those of the count.
const HEADER: usize = 80;
const START: usize = HEADER + 4;
/// A normal, three corners, two attribute bytes.
const FACET: usize = 50;
/// The facets between two reports of progress.
const TICK_FACETS: usize = 4096;

pub(super) fn parse(bytes: &[u8], run: &Run<'_>) -> Result<Soup> {
    let mut merger = Merger { builder: Builder::new(run), known: HashMap::new(), collapsed: 0 };
    let count = bytes.get(HEADER..START).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]));
    let is_whole =
        count.map(|n| START as u64 + FACET as u64 * u64::from(n)) == Some(bytes.len() as u64);
    let first_word = bytes.trim_ascii_start().get(..5).unwrap_or_default();
    let is_text = first_word.eq_ignore_ascii_case(b"solid")
        && !bytes[..bytes.len().min(1 << 10)].contains(&0);
    let counted = match count {
        _ if is_text && !is_whole => (ElementKind::Line, text(bytes, &mut merger, run)?),
        Some(count) => {
            binary(bytes, count, &mut merger, run)?;
            (ElementKind::Byte, HEADER as u64)
        }
        None => {
            let message = "the file ends here: too short for a binary STL, and no text that begins with 'solid'";
            return Err(at_byte(bytes.len(), message));
        }
    };
    merger.finish(counted)
}

fn at_byte(byte: usize, message: impl Into<String>) -> Error {
    Error::new(Status::Format, message).at(ElementKind::Byte, byte as u64)
}

fn binary(bytes: &[u8], count: u32, merger: &mut Merger<'_>, run: &Run<'_>) -> Result<()> {
    let needed = START as u64 + FACET as u64 * u64::from(count);
    if needed > bytes.len() as u64 {
        let message = format!("the file ends here, before the last of the {count} facets promised");
        return Err(at_byte(bytes.len(), message));
    }
    if needed < bytes.len() as u64 {
        let message = format!("bytes follow the last of the {count} facets promised");
        return Err(at_byte(needed as usize, message));
    }
    merger.builder.reserve_faces(count as usize)?;
    for (i, facet) in bytes[START..].chunks_exact(FACET).enumerate() {
        if i.is_multiple_of(TICK_FACETS) {
            run.tick(i, count as usize)?;
        }
        let value = |at: usize| {
            let b = &facet[at..at + 4];
            f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]]))
        };
        let corner = |k: usize| [value(12 * k), value(12 * k + 4), value(12 * k + 8)];
        merger.facet([corner(1), corner(2), corner(3)])?;
    }
    Ok(())
}

/// Reads a text, and returns the number of its last line.
fn text(bytes: &[u8], merger: &mut Merger<'_>, run: &Run<'_>) -> Result<u64> {
    let mut lines = Lines::new(bytes, run);
    while let Some(line) = lines.next_filled()? {
        check_words(line, &["solid"])?;
        loop {
            let line = lines.expect("'endsolid'")?;
            if check_words(line, &["endsolid"]).is_ok() {
                break;
            }
            check_words(line, &["facet"])?;
            check_words(lines.expect("the facet's loop")?, &["outer", "loop"])?;
            let mut corners = [[0.0; 3]; 3];
            for corner in &mut corners {
                let line = lines.expect("the facet's last corner")?;
                let mut words = check_words(line, &["vertex"])?;
                *corner = words.xyz()?;
                words.finish("the corner")?;
            }
            check_words(lines.expect("'endloop'")?, &["endloop"])?;
            check_words(lines.expect("'endfacet'")?, &["endfacet"])?;
            merger.facet(corners)?;
        }
    }
    Ok(lines.number())
}

/// Checks that the line begins with these words, in either case, and returns what follows.
fn check_words<'a>(line: Line<'a>, expected: &[&str]) -> Result<super::text::Words<'a>> {
    let mut words = line.words();
    for expected in expected {
        let word = words.expect(&format!("'{expected}'"))?;
        if !word.eq_ignore_ascii_case(expected.as_bytes()) {
            let message = format!("'{expected}' belongs here, not {}", shown(word));
            return Err(at_line(line.number, message));
        }
    }
    Ok(words)
}

/// Gives corners at equal positions one vertex.
struct Merger<'a> {
    builder: Builder<'a>,
    /// Looked up only, never walked through: vertices are numbered as they are met.
    known: HashMap<[u64; 3], u32>,
    collapsed: usize,
}

impl Merger<'_> {
    fn facet(&mut self, corners: [[f64; 3]; 3]) -> Result<()> {
        let [a, b, c] =
            [self.vertex(corners[0])?, self.vertex(corners[1])?, self.vertex(corners[2])?];
        if a == b || b == c || c == a {
            self.collapsed += 1;
            return Ok(());
        }
        self.builder.face([a, b, c])
    }

    fn vertex(&mut self, xyz: [f64; 3]) -> Result<u32> {
        // -0 + 0 is 0: the two zeros are one position.
        let key = xyz.map(|x| (x + 0.0).to_bits());
        if let Some(&vertex) = self.known.get(&key) {
            return Ok(vertex);
        }
        let limit = || Error::new(Status::LimitExceeded, "more than 2^32 - 1 vertices");
        let vertex = u32::try_from(self.builder.vertices.len()).map_err(|_| limit())?;
        self.builder.vertex(xyz)?;
        self.builder.room.insert(&mut self.known, key, vertex)?;
        Ok(vertex)
    }

    fn finish(self, counted: (ElementKind, u64)) -> Result<Soup> {
        let mut soup = self.builder.finish(counted)?;
        if self.collapsed > 0 {
            let count = self.collapsed;
            soup.warnings.push(format!("{count} facets with equal corners were left out"));
        }
        Ok(soup)
    }
}

/// Writes the triangles as binary STL, in single precision.
pub(super) fn write(complex: &Complex, out: &mut Sink<'_>) -> Result<()> {
    let triangles = complex.triangles();
    let count = u32::try_from(triangles.len())
        .map_err(|_| Error::new(Status::LimitExceeded, "STL holds at most 2^32 - 1 triangles"))?;
    let mut header = [b' '; HEADER];
    // Not `solid`, with which a text begins.
    header[..10].copy_from_slice(b"binary STL");
    out.bytes(&header)?;
    out.bytes(&count.to_le_bytes())?;
    for triangle in triangles {
        let corners = triangle.map(|v| complex.vertices()[v as usize]);
        let mut facet = [0; FACET];
        let values = std::iter::once(normal(corners)).chain(corners).flatten();
        for (value, bytes) in values.zip(facet.chunks_exact_mut(4)) {
            bytes.copy_from_slice(&(value as f32).to_le_bytes());
        }
        out.bytes(&facet)?;
        out.row()?;
    }
    Ok(())
}

/// The unit normal, or 0 where there is none.
fn normal([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let (u, v): ([f64; 3], [f64; 3]) =
        (std::array::from_fn(|i| b[i] - a[i]), std::array::from_fn(|i| c[i] - a[i]));
    let cross: [f64; 3] = std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        u[j] * v[k] - u[k] * v[j]
    });
    let length = cross.iter().map(|x| x * x).sum::<f64>().sqrt();
    if length > 0.0 && length.is_finite() { cross.map(|x| x / length) } else { [0.0; 3] }
}

//! Tables of points: XYZ, PTS and CSV (a row a line), and PWN (a count, points, normals).
//!
//! The first three columns are coordinates; the others are passed over. `#` and `//` begin a
//! comment wherever they stand. A first line of one whole number promises how many rows follow, no more and no fewer; a
//! first line that begins with the names x, y, z is passed over.

use super::sink::Sink;
use super::soup::{Builder, Soup};
use super::text::{Line, Lines, at_line, is_count, number};
use crate::complex::{Attribute, Complex, Element, Values};
use crate::error::{ElementKind, Result};
use crate::job::Run;

/// The least bytes of a row, its line end included.
const ROW_BYTES: u64 = "0 0 0\n".len() as u64;

pub(super) fn parse(bytes: &[u8], run: &Run<'_>) -> Result<Soup> {
    let mut lines = Lines::new(bytes, run);
    let mut builder = Builder::new(run);
    let (mut promised, mut is_named) = (None, false);
    let mut first_line = 0;
    while let Some(line) = next_row(&mut lines)? {
        if first_line == 0 {
            first_line = line.number;
            promised = promised_rows(line)?;
            if let Some(count) = promised {
                lines.check_room(count, ROW_BYTES, "rows")?;
            }
            is_named = names_columns(line);
            if promised.is_some() || is_named {
                continue;
            }
        }
        if promised == Some(builder.vertices.len() as u64) {
            let count = builder.vertices.len();
            return Err(at_line(line.number, format!("a row follows the {count} promised")));
        }
        builder.vertex(row(line)?)?;
    }
    let found = builder.vertices.len();
    match promised {
        Some(count) if count > found as u64 => Err(lines.ended(&format!("row {count}"))),
        None if found == 0 && !is_named => {
            Err(at_line(lines.number(), "the file ends here, and holds no row"))
        }
        _ => builder.finish((ElementKind::Line, first_line)),
    }
}

pub(super) fn parse_pwn(bytes: &[u8], run: &Run<'_>) -> Result<Soup> {
    let mut lines = Lines::new(bytes, run);
    let Some(first) = next_row(&mut lines)? else { return Err(lines.ended("the count")) };
    let count = promised_rows(first)?
        .ok_or_else(|| at_line(first.number, "a PWN file begins with the number of points"))?;
    lines.check_room(count, 2 * ROW_BYTES, "points with normals")?;
    let mut builder = Builder::new(run);
    builder.room.reserve(&mut builder.vertices, count as usize)?;
    for _ in 0..count {
        let Some(line) = next_row(&mut lines)? else { return Err(lines.ended("the last point")) };
        builder.vertex(row(line)?)?;
    }
    let mut normals = Vec::new();
    for _ in 0..count {
        let Some(line) = next_row(&mut lines)? else { return Err(lines.ended("the last normal")) };
        for x in row(line)? {
            builder.room.push(&mut normals, x)?;
        }
    }
    if let Some(line) = next_row(&mut lines)? {
        return Err(at_line(line.number, "a row follows the last normal"));
    }
    let values = Values::F64(normals);
    builder.attributes.push(Attribute::new("normal", Element::Vertex, 3, values)?);
    builder.finish((ElementKind::Line, first.number))
}

/// The next line that is neither blank nor a comment, without the comment at its end.
fn next_row<'a>(lines: &mut Lines<'a>) -> Result<Option<Line<'a>>> {
    while let Some(Line { number, bytes }) = lines.next()? {
        let begins = |i: &usize| bytes[*i] == b'#' || bytes[*i..].starts_with(b"//");
        let end = (0..bytes.len()).find(begins).unwrap_or(bytes.len());
        let bytes = bytes[..end].trim_ascii();
        if !bytes.is_empty() {
            return Ok(Some(Line { number, bytes }));
        }
    }
    Ok(None)
}

/// The count on a line that holds nothing else.
fn promised_rows(line: Line<'_>) -> Result<Option<u64>> {
    if !is_count(line.bytes) {
        return Ok(None);
    }
    line.words().whole("the number of rows").map(Some)
}

/// Whether the line names its columns x, y, z, in either case, quoted or not.
fn names_columns(line: Line<'_>) -> bool {
    let bytes = line.bytes;
    let mut words = bytes.split(|b| b" \t,;\"".contains(b)).filter(|word| !word.is_empty());
    [b"x", b"y", b"z"]
        .iter()
        .all(|name| words.next().is_some_and(|w| w.eq_ignore_ascii_case(*name)))
}

/// The first three columns. What follows the first one parts them all: a semicolon, a comma, or else white
/// space.
fn row(line: Line<'_>) -> Result<[f64; 3]> {
    let is_end = |b: &u8| b.is_ascii_whitespace() || matches!(b, b';' | b',');
    let first = line.bytes.iter().position(is_end).unwrap_or(line.bytes.len());
    let separator = match line.bytes[first..].trim_ascii_start().first() {
        Some(&separator @ (b';' | b',')) => separator,
        _ => return line.words().xyz(),
    };
    let mut columns = line.bytes.split(|&b| b == separator).map(|column| column.trim_ascii());
    let mut xyz = [0.0; 3];
    for (x, name) in xyz.iter_mut().zip(["x", "y", "z"]) {
        *x = match columns.next() {
            None => return Err(at_line(line.number, format!("the line ends before {name}"))),
            Some([]) => return Err(at_line(line.number, format!("the column of {name} is empty"))),
            Some(word) => number::<f64>(line.number, word, name)?,
        };
    }
    Ok(xyz)
}

/// Writes the vertices, with `separator` between the coordinates.
pub(super) fn write(complex: &Complex, separator: char, out: &mut Sink<'_>) -> Result<()> {
    if separator == ',' {
        out.text(format_args!("x,y,z\n"))?;
    } else if complex.vertices().is_empty() {
        // The promise of no row: a file without a byte may be one that was cut off.
        out.text(format_args!("0\n"))?;
    }
    for [x, y, z] in complex.vertices() {
        out.text(format_args!("{x:?}{separator}{y:?}{separator}{z:?}\n"))?;
        out.row()?;
    }
    Ok(())
}

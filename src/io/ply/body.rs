//! The rows behind the header, from text or binary.

use super::Type;
use super::header::{Element, Header, Kind};
use super::names::{Column, attributes};
use crate::complex;
use crate::error::{ElementKind, Error, Result, Status};
use crate::io::soup::Builder;
use crate::io::text::{Lines, Words, at_line, number, shown};
use crate::job::Run;

/// The rows between two reports of progress.
const TICK_ROWS: u64 = 4096;

/// A value as the file holds it.
#[derive(Clone, Copy)]
pub(super) enum Number {
    Whole(i64),
    Real(f64),
}

impl Number {
    /// The same value; every PLY type fits an f64 exactly.
    pub fn to_f64(self) -> f64 {
        match self {
            Number::Whole(value) => value as f64,
            Number::Real(value) => value,
        }
    }
}

/// Where rows come from.
pub(super) trait Source {
    /// The least bytes that a value takes.
    fn least_bytes(ty: Type) -> u64;
    /// How many bytes are read, of how many, counted from the file's begin.
    fn position(&self) -> (usize, usize);
    /// Checks that values which take at least `bytes` can follow, and keeps `what` for messages.
    fn begin(&mut self, bytes: u64, what: &str) -> Result<()>;
    fn begin_row(&mut self) -> Result<()>;
    fn value(&mut self, ty: Type) -> Result<Number>;
    fn skip(&mut self, ty: Type, count: u64) -> Result<()>;
    /// Checks that so many values can follow, as far as that is known.
    fn check_room(&self, ty: Type, count: u64) -> Result<()>;
    fn end_row(&mut self) -> Result<()>;
    /// Checks that nothing follows.
    fn finish(&mut self) -> Result<()>;
    /// An error about the value read last.
    fn error(&self, message: String) -> Error;
}

/// What is done with a property.
#[derive(Clone, Copy)]
enum Use {
    Skip,
    Coordinate(usize),
    End(usize),
    Corners,
    Column(usize),
}

pub(super) fn parse<S: Source>(
    header: &Header,
    mut source: S,
    builder: &mut Builder<'_>,
    run: &Run<'_>,
) -> Result<()> {
    let vertices = header.elements.iter().find(|element| element.name == "vertex");
    let vertex_count = vertices.map_or(0, |element| element.count);
    if vertices.is_none() {
        return Err(at_line(header.lines, "the header declares no element 'vertex'"));
    }
    for element in &header.elements {
        let (uses, mut columns) = plan(element)?;
        let kind = |kind: &Kind| match *kind {
            Kind::Scalar(ty) => S::least_bytes(ty),
            Kind::List { count, .. } => S::least_bytes(count),
        };
        let row_bytes: u64 = element.properties.iter().map(|p| kind(&p.kind)).sum();
        let (name, count) = (shown(element.name.as_bytes()), element.count);
        let what = format!("{count} rows of element {name}");
        source.begin(count.saturating_mul(row_bytes), &what)?;
        if row_bytes == 0 {
            continue;
        }
        // The count is checked: no more rows than bytes.
        let rows = count as usize;
        match element.name.as_str() {
            "vertex" => builder.room.reserve(&mut builder.vertices, rows)?,
            "edge" => builder.room.reserve(&mut builder.edges, rows)?,
            _ => {}
        }
        for column in &mut columns {
            column.reserve(rows, &mut builder.room)?;
        }
        for row in 0..count {
            if row.is_multiple_of(TICK_ROWS) {
                let (done, total) = source.position();
                run.tick(done, total)?;
            }
            read_row(element, &uses, vertex_count, &mut columns, &mut source, builder)?;
        }
        let kind = match element.name.as_str() {
            "vertex" => complex::Element::Vertex,
            "edge" => complex::Element::Edge,
            _ => complex::Element::Face,
        };
        builder.attributes.extend(attributes(columns, kind)?);
    }
    source.finish()
}

/// What is done with each property, and the columns to keep as attributes.
fn plan(element: &Element) -> Result<(Vec<Use>, Vec<Column>)> {
    let mut columns: Vec<Column> = Vec::new();
    let mut missing: Vec<&str> = match element.name.as_str() {
        "vertex" => vec!["x", "y", "z"],
        "edge" => vec!["vertex1", "vertex2"],
        "face" => vec!["vertex_indices"],
        _ => return Ok((vec![Use::Skip; element.properties.len()], columns)),
    };
    let wrong = |what: &str| Err(at_line(element.line, what.to_string()));
    let mut uses = Vec::new();
    for property in &element.properties {
        let name = match property.name.as_str() {
            "vertex_index" => "vertex_indices",
            name => name,
        };
        let found = missing.contains(&name);
        missing.retain(|missing| *missing != name);
        uses.push(match (name, property.kind) {
            ("vertex_indices", Kind::List { value, .. }) if found => {
                if value.is_float() {
                    return wrong("the list of a face's corners must be of a whole type");
                }
                Use::Corners
            }
            ("vertex_indices", _) if found => return wrong("the corners of a face must be a list"),
            (_, Kind::List { .. }) if found => return wrong("a coordinate or an end is a list"),
            (_, Kind::List { .. }) => Use::Skip,
            ("x", _) if found => Use::Coordinate(0),
            ("y", _) if found => Use::Coordinate(1),
            ("z", _) if found => Use::Coordinate(2),
            (_, Kind::Scalar(ty)) if found && ty.is_float() => {
                return wrong("the ends of an edge must be of a whole type");
            }
            ("vertex1", _) if found => Use::End(0),
            ("vertex2", _) if found => Use::End(1),
            (_, Kind::Scalar(ty)) => {
                columns.push(Column::new(property.name.clone(), ty));
                Use::Column(columns.len() - 1)
            }
        });
    }
    match missing.first() {
        Some(missing) if element.count > 0 => {
            let name = &element.name;
            wrong(&format!("element '{name}' has no property '{missing}'"))
        }
        _ => Ok((uses, columns)),
    }
}

fn read_row<S: Source>(
    element: &Element,
    uses: &[Use],
    vertex_count: u64,
    columns: &mut [Column],
    source: &mut S,
    builder: &mut Builder<'_>,
) -> Result<()> {
    let vertex = |source: &mut S, ty: Type| -> Result<u32> {
        let Number::Whole(index) = source.value(ty)? else { return Ok(0) };
        match u32::try_from(index) {
            Ok(vertex) if u64::from(vertex) < vertex_count => Ok(vertex),
            _ => Err(source.error(format!("there is no vertex {index} among {vertex_count}"))),
        }
    };
    let (mut xyz, mut ends) = ([0.0; 3], [0; 2]);
    source.begin_row()?;
    for (property, &use_) in element.properties.iter().zip(uses) {
        match (property.kind, use_) {
            (Kind::Scalar(ty), Use::Coordinate(axis)) => xyz[axis] = source.value(ty)?.to_f64(),
            (Kind::Scalar(ty), Use::End(end)) => ends[end] = vertex(source, ty)?,
            (Kind::Scalar(ty), Use::Column(i)) => columns[i].push(source.value(ty)?),
            (Kind::Scalar(ty), _) => source.skip(ty, 1)?,
            (Kind::List { count, value }, use_) => {
                let length = match source.value(count)? {
                    Number::Whole(length) if length >= 0 => length as u64,
                    _ => return Err(source.error("a list's length is negative".to_string())),
                };
                if !matches!(use_, Use::Corners) {
                    source.skip(value, length)?;
                    continue;
                }
                if length < 3 {
                    let message = format!("a face needs three corners or more, and has {length}");
                    return Err(source.error(message));
                }
                source.check_room(value, length)?;
                for _ in 0..length {
                    let corner = vertex(source, value)?;
                    builder.corner(corner)?;
                }
                builder.close_face()?;
            }
        }
    }
    match element.name.as_str() {
        "vertex" => builder.vertex(xyz)?,
        "edge" => builder.edge(ends)?,
        _ => {}
    }
    source.end_row()
}

/// Rows as lines of words.
pub(super) struct Text<'a> {
    lines: Lines<'a>,
    words: Words<'a>,
    line: u64,
    what: String,
    total: usize,
}

impl<'a> Text<'a> {
    pub fn new(bytes: &'a [u8], header: &Header, run: &'a Run<'a>) -> Self {
        let lines = Lines::from(bytes, header.end, header.lines, run);
        let total = bytes.len();
        Text { lines, words: Words::default(), line: header.lines, what: String::new(), total }
    }
}

impl Source for Text<'_> {
    fn least_bytes(_: Type) -> u64 {
        "0 ".len() as u64
    }

    fn position(&self) -> (usize, usize) {
        (self.lines.position(), self.total)
    }

    fn begin(&mut self, bytes: u64, what: &str) -> Result<()> {
        self.lines.check_bytes(bytes, what)?;
        self.what = format!("the last of the {what}");
        Ok(())
    }

    fn begin_row(&mut self) -> Result<()> {
        let line = self.lines.expect(&self.what)?;
        self.line = line.number;
        self.words = line.words();
        Ok(())
    }

    fn value(&mut self, ty: Type) -> Result<Number> {
        let word = self.words.expect("the last value of its row")?;
        let what = "the value";
        let Some((least, most)) = ty.range() else {
            let value = match ty {
                Type::F32 => number::<f32>(self.line, word, what),
                _ => number::<f64>(self.line, word, what),
            };
            return value.map(Number::Real);
        };
        let whole = std::str::from_utf8(word).ok().and_then(|text| text.parse().ok());
        let whole = whole.filter(|value| (least..=most).contains(value));
        whole.map(Number::Whole).ok_or_else(|| {
            at_line(self.line, format!("{} is not a whole number of its type", shown(word)))
        })
    }

    fn skip(&mut self, ty: Type, count: u64) -> Result<()> {
        (0..count).try_for_each(|_| self.value(ty).map(|_| ()))
    }

    fn check_room(&self, _: Type, _: u64) -> Result<()> {
        // The line's end tells.
        Ok(())
    }

    fn end_row(&mut self) -> Result<()> {
        self.words.finish("the last value of its row")
    }

    fn finish(&mut self) -> Result<()> {
        self.lines.finish("the last row")
    }

    fn error(&self, message: String) -> Error {
        at_line(self.line, message)
    }
}

/// Rows as bytes.
pub(super) struct Binary<'a> {
    bytes: &'a [u8],
    at: usize,
    /// Where the value read last begins.
    last: usize,
    big_endian: bool,
    what: String,
}

impl<'a> Binary<'a> {
    pub fn new(bytes: &'a [u8], header: &Header, big_endian: bool) -> Self {
        Binary { bytes, at: header.end, last: header.end, big_endian, what: String::new() }
    }

    /// The bytes of the next `count` values.
    fn take(&mut self, ty: Type, count: u64) -> Result<&'a [u8]> {
        self.check_room(ty, count)?;
        self.last = self.at;
        self.at += count as usize * ty.size();
        Ok(&self.bytes[self.last..self.at])
    }

    fn ended(&self) -> Error {
        at_byte(self.bytes.len(), format!("the file ends here, before {}", self.what))
    }
}

fn at_byte(byte: usize, message: String) -> Error {
    Error::new(Status::Format, message).at(ElementKind::Byte, byte as u64)
}

impl Source for Binary<'_> {
    fn least_bytes(ty: Type) -> u64 {
        ty.size() as u64
    }

    fn position(&self) -> (usize, usize) {
        (self.at, self.bytes.len())
    }

    fn begin(&mut self, bytes: u64, what: &str) -> Result<()> {
        self.what = format!("the last of the {what}");
        if bytes > (self.bytes.len() - self.at) as u64 {
            return Err(self.ended());
        }
        Ok(())
    }

    fn begin_row(&mut self) -> Result<()> {
        Ok(())
    }

    fn value(&mut self, ty: Type) -> Result<Number> {
        let bytes = self.take(ty, 1)?;
        // The bytes as a whole number, the first of them the lowest or the highest.
        let gather = |bits: u64, byte: &u8| bits << 8 | u64::from(*byte);
        let bits = match self.big_endian {
            true => bytes.iter().fold(0, gather),
            false => bytes.iter().rev().fold(0, gather),
        };
        Ok(match ty {
            Type::I8 => Number::Whole((bits as i8).into()),
            Type::I16 => Number::Whole((bits as i16).into()),
            Type::I32 => Number::Whole((bits as i32).into()),
            Type::U8 | Type::U16 | Type::U32 => Number::Whole(bits as i64),
            Type::F32 => Number::Real(f32::from_bits(bits as u32).into()),
            Type::F64 => Number::Real(f64::from_bits(bits)),
        })
    }

    fn skip(&mut self, ty: Type, count: u64) -> Result<()> {
        self.take(ty, count).map(|_| ())
    }

    fn check_room(&self, ty: Type, count: u64) -> Result<()> {
        // A count has 32 bits at most: the product cannot overflow.
        match count * ty.size() as u64 > (self.bytes.len() - self.at) as u64 {
            true => Err(self.ended()),
            false => Ok(()),
        }
    }

    fn end_row(&mut self) -> Result<()> {
        Ok(())
    }

    fn finish(&mut self) -> Result<()> {
        let rest = &self.bytes[self.at..];
        match rest.iter().position(|byte| !byte.is_ascii_whitespace()) {
            None => Ok(()),
            Some(_) => {
                let message = format!("{} bytes follow the last row", rest.len());
                Err(at_byte(self.at, message))
            }
        }
    }

    fn error(&self, message: String) -> Error {
        at_byte(self.last, message)
    }
}

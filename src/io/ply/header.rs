//! The header: what the file declares.

use super::Type;
use crate::error::Result;
use crate::io::text::{Lines, Words, at_line, shown};
use crate::job::Run;

/// How the rows are encoded.
#[derive(Clone, Copy)]
pub(super) enum Encoding {
    Text,
    Binary { big_endian: bool },
}

/// One kind of rows.
pub(super) struct Element {
    pub name: String,
    pub count: u64,
    pub properties: Vec<Property>,
    /// Where the element is declared.
    pub line: u64,
}

/// One column of an element.
pub(super) struct Property {
    pub name: String,
    pub kind: Kind,
}

/// The kinds of columns.
#[derive(Clone, Copy)]
pub(super) enum Kind {
    Scalar(Type),
    List { count: Type, value: Type },
}

/// A file's header.
pub(super) struct Header {
    pub encoding: Encoding,
    pub elements: Vec<Element>,
    /// Where the rows begin.
    pub end: usize,
    /// The number of the header's last line.
    pub lines: u64,
}

impl Header {
    pub fn parse(bytes: &[u8], run: &Run<'_>) -> Result<Self> {
        let mut lines = Lines::new(bytes, run);
        let first = lines.next()?.map_or(&[][..], |line| line.bytes);
        if first.trim_ascii_end() != b"ply" {
            let message = format!("a PLY file begins with the line 'ply', not {}", shown(first));
            return Err(at_line(1, message));
        }
        // A lone CR ends the lines, so that an LF behind the header is data.
        let ends_with_cr = bytes.get(3) == Some(&b'\r') && bytes.get(4) != Some(&b'\n');
        let mut encoding = None;
        let mut elements: Vec<Element> = Vec::new();
        loop {
            let line = lines.expect("'end_header'")?;
            let mut words = line.words();
            match words.next().unwrap_or_default() {
                b"comment" | b"obj_info" => continue,
                b"format" => encoding = Some(self::encoding(&mut words, line.number)?),
                b"element" => {
                    let name = words.expect("the element's name")?;
                    let count = words.whole("the number of rows")?;
                    let name = String::from_utf8_lossy(name).into_owned();
                    if elements.iter().any(|element| element.name == name) {
                        let message =
                            format!("element {} is declared twice", shown(name.as_bytes()));
                        return Err(at_line(line.number, message));
                    }
                    elements.push(Element {
                        name,
                        count,
                        properties: Vec::new(),
                        line: line.number,
                    });
                }
                b"property" => {
                    let element = elements.last_mut().ok_or_else(|| {
                        at_line(line.number, "a property stands before the first element")
                    })?;
                    let property = property(&mut words, line.number)?;
                    if element.properties.iter().any(|known| known.name == property.name) {
                        let name = shown(property.name.as_bytes());
                        let message = format!("property {name} is declared twice");
                        return Err(at_line(line.number, message));
                    }
                    element.properties.push(property);
                }
                b"end_header" => break,
                word => {
                    let message = format!("{} does not belong in a PLY header", shown(word));
                    return Err(at_line(line.number, message));
                }
            }
            words.finish("the declaration")?;
        }
        let number = lines.number();
        let encoding =
            encoding.ok_or_else(|| at_line(number, "the header ends without a format"))?;
        let mut end = lines.position();
        if ends_with_cr && bytes[..end].ends_with(b"\r\n") {
            end -= 1;
        }
        Ok(Header { encoding, elements, end, lines: number })
    }
}

fn encoding(words: &mut Words<'_>, line: u64) -> Result<Encoding> {
    let encoding = match words.expect("the format")? {
        b"ascii" => Encoding::Text,
        b"binary_little_endian" => Encoding::Binary { big_endian: false },
        b"binary_big_endian" => Encoding::Binary { big_endian: true },
        word => return Err(at_line(line, format!("{} is not a PLY format", shown(word)))),
    };
    match words.expect("the version")? {
        b"1.0" => Ok(encoding),
        word => Err(at_line(line, format!("the version of PLY must be 1.0, not {}", shown(word)))),
    }
}

fn property(words: &mut Words<'_>, line: u64) -> Result<Property> {
    let known = |word: &[u8]| {
        Type::of_name(word)
            .ok_or_else(|| at_line(line, format!("{} is not a PLY type", shown(word))))
    };
    let kind = match words.expect("the property's type")? {
        b"list" => {
            let count = known(words.expect("the type of the list's length")?)?;
            let value = known(words.expect("the type of the list's values")?)?;
            if count.is_float() {
                return Err(at_line(line, "a list's length must be of a whole type"));
            }
            Kind::List { count, value }
        }
        word => Kind::Scalar(known(word)?),
    };
    let name = words.expect("the property's name")?;
    Ok(Property { name: String::from_utf8_lossy(name).into_owned(), kind })
}

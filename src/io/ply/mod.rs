//! PLY, the Polygon File Format (Turk 1994): a header in text that declares elements and their
//! properties, then the rows of each element, as text or binary of either byte order.
//!
//! medax keeps the coordinates of `vertex`, the lists of `face`, the ends of `edge`, and their scalar
//! properties as attributes. Other elements and lists are stepped over. We parse it ourselves: the
//! crates for PLY read typed structs through `io::Read`, and name neither line nor byte.

mod body;
mod header;
mod names;
mod write;

pub(super) use write::write;

use super::soup::{Builder, Soup};
use crate::error::{ElementKind, Result};
use crate::job::Run;
use header::{Encoding, Header};

pub(super) fn parse(bytes: &[u8], run: &Run<'_>) -> Result<Soup> {
    let header = Header::parse(bytes, run)?;
    let mut builder = Builder::new(run);
    match header.encoding {
        Encoding::Text => {
            body::parse(&header, body::Text::new(bytes, &header, run), &mut builder, run)
        }
        Encoding::Binary { big_endian } => {
            body::parse(&header, body::Binary::new(bytes, &header, big_endian), &mut builder, run)
        }
    }?;
    let counted = header.elements.iter().find(|element| element.name == "vertex");
    builder.finish((ElementKind::Line, counted.map_or(header.lines, |element| element.line)))
}

/// The type of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Type {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Type {
    /// The type that a header names in either of its two vocabularies.
    fn of_name(name: &[u8]) -> Option<Self> {
        Some(match name {
            b"char" | b"int8" => Type::I8,
            b"uchar" | b"uint8" => Type::U8,
            b"short" | b"int16" => Type::I16,
            b"ushort" | b"uint16" => Type::U16,
            b"int" | b"int32" => Type::I32,
            b"uint" | b"uint32" => Type::U32,
            b"float" | b"float32" => Type::F32,
            b"double" | b"float64" => Type::F64,
            _ => return None,
        })
    }

    fn size(self) -> usize {
        match self {
            Type::I8 | Type::U8 => 1,
            Type::I16 | Type::U16 => 2,
            Type::I32 | Type::U32 | Type::F32 => 4,
            Type::F64 => 8,
        }
    }

    fn is_float(self) -> bool {
        matches!(self, Type::F32 | Type::F64)
    }

    /// The least and the greatest value of a whole type; nothing for the others.
    fn range(self) -> Option<(i64, i64)> {
        Some(match self {
            Type::I8 => (i8::MIN.into(), i8::MAX.into()),
            Type::U8 => (0, u8::MAX.into()),
            Type::I16 => (i16::MIN.into(), i16::MAX.into()),
            Type::U16 => (0, u16::MAX.into()),
            Type::I32 => (i32::MIN.into(), i32::MAX.into()),
            Type::U32 => (0, u32::MAX.into()),
            Type::F32 | Type::F64 => return None,
        })
    }
}

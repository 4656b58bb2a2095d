//! Attributes as columns: PLY properties hold one value a row, attributes may hold several.
//!
//! An attribute of width 1 is the property of its name; `normal` of width 3 is `nx`, `ny`, `nz`;
//! any other is `name_0`, `name_1` and so on. A vertex attribute `radius` is written as `quality`, too,
//! which is where MeshLab looks for it.

use super::Type;
use super::body::Number;
use crate::complex::{Attribute, Element, Values};
use crate::error::Result;
use crate::job::Room;

/// The values of one property, as they are read.
pub(super) struct Column {
    name: String,
    values: Values,
}

impl Column {
    /// A column for values of this type: what has no sign is a label, the rest are reals.
    pub fn new(name: String, ty: Type) -> Self {
        let values = match ty {
            Type::U8 | Type::U16 | Type::U32 => Values::U32(Vec::new()),
            _ => Values::F64(Vec::new()),
        };
        Column { name, values }
    }

    pub fn reserve(&mut self, rows: usize, room: &mut Room<'_>) -> Result<()> {
        match &mut self.values {
            Values::F64(values) => room.reserve(values, rows),
            Values::U32(values) => room.reserve(values, rows),
        }
    }

    pub fn push(&mut self, number: Number) {
        match (&mut self.values, number) {
            (Values::F64(values), number) => values.push(number.to_f64()),
            (Values::U32(values), Number::Whole(value)) => values.push(value as u32),
            (Values::U32(_), Number::Real(_)) => {}
        }
    }
}

/// The attributes that the columns of an element stand for.
pub(super) fn attributes(mut columns: Vec<Column>, element: Element) -> Result<Vec<Attribute>> {
    let bits = |name: &str| {
        columns.iter().find(|column| column.name == name).and_then(|column| match &column.values {
            Values::F64(values) => Some(values.iter().map(|x| x.to_bits())),
            Values::U32(_) => None,
        })
    };
    if let (Some(radius), Some(quality)) = (bits("radius"), bits("quality"))
        && radius.eq(quality)
    {
        columns.retain(|column| column.name != "quality");
    }
    let mut attributes = Vec::new();
    let mut rest = columns.as_slice();
    while let Some(first) = rest.first() {
        let (name, width) = group(rest);
        let (columns, more) = rest.split_at(width);
        rest = more;
        let values = match &first.values {
            Values::F64(_) => Values::F64(rows(columns, |values| match values {
                Values::F64(values) => values,
                Values::U32(_) => &[],
            })),
            Values::U32(_) => Values::U32(rows(columns, |values| match values {
                Values::U32(values) => values,
                Values::F64(_) => &[],
            })),
        };
        attributes.push(Attribute::new(name, element, width, values)?);
    }
    Ok(attributes)
}

/// The name and the width of the attribute that the first columns stand for.
fn group(columns: &[Column]) -> (String, usize) {
    let first = &columns[0];
    let same_kind = |column: &Column| {
        matches!(
            (&column.values, &first.values),
            (Values::F64(_), Values::F64(_)) | (Values::U32(_), Values::U32(_))
        )
    };
    let run = |name: &dyn Fn(usize) -> String| {
        let matches = columns.iter().enumerate();
        matches.take_while(|(i, column)| same_kind(column) && column.name == name(*i)).count()
    };
    let normal = ["nx", "ny", "nz"];
    if run(&|i| normal.get(i).copied().unwrap_or_default().to_string()) == 3 {
        return ("normal".to_string(), 3);
    }
    if let Some(stem) = first.name.strip_suffix("_0") {
        let width = run(&|i| format!("{stem}_{i}"));
        if width > 1 {
            return (stem.to_string(), width);
        }
    }
    (first.name.clone(), 1)
}

/// The columns side by side, row-major.
fn rows<T: Copy>(columns: &[Column], values: impl Fn(&Values) -> &[T]) -> Vec<T> {
    let columns: Vec<&[T]> = columns.iter().map(|column| values(&column.values)).collect();
    let rows = columns.first().map_or(0, |column| column.len());
    (0..rows).flat_map(|row| columns.iter().map(move |column| column[row])).collect()
}

/// The name with what PLY cannot hold made `_`: blanks, and all but printable ASCII.
pub(super) fn plain(name: &str) -> String {
    name.chars().map(|c| if c.is_ascii_graphic() && c != '#' { c } else { '_' }).collect()
}

/// The names of the properties that hold an attribute.
pub(super) fn properties(attribute: &Attribute) -> Vec<String> {
    let name = plain(attribute.name());
    match (name.as_str(), attribute.width()) {
        (_, 1) => vec![name],
        ("normal", 3) => ["nx", "ny", "nz"].map(String::from).to_vec(),
        (_, width) => (0..width).map(|i| format!("{name}_{i}")).collect(),
    }
}

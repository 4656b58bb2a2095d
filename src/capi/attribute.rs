//! Attributes
//!
//! Named values on the vertices, loose edges, faces or volume cells of a complex or a file.

use super::status::c_text;
use super::view::{self, medax_view_f64, medax_view_u32};
use crate::complex::{Attribute, Element, Values};
use crate::error::{Error, Result, Status};
use std::ffi::{CString, c_char};

/// The kinds of elements of a complex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum medax_element {
    /// A vertex.
    Vertex = 0,
    /// A loose edge.
    Edge = 1,
    /// A face.
    Face = 2,
    /// A volume cell.
    Cell = 3,
}

impl From<Element> for medax_element {
    fn from(kind: Element) -> Self {
        match kind {
            Element::Vertex => medax_element::Vertex,
            Element::Edge => medax_element::Edge,
            Element::Face => medax_element::Face,
            Element::Cell => medax_element::Cell,
        }
    }
}

/// The type of an attribute's values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum medax_value_type {
    /// Lengths, angles, coordinates.
    F64 = 0,
    /// Indices and labels.
    U32 = 1,
}

/// Values with a name on one kind of element, one row an element.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct medax_attribute {
    /// The name, such as `radius`: a terminated UTF-8 string.
    pub name: *const c_char,
    /// A #medax_element: what carries the values.
    pub element: u32,
    /// A #medax_value_type: which of the two arrays is filled.
    pub value_type: u32,
    /// The values, if they are of type `MEDAX_VALUE_TYPE_F64`; else without a row.
    pub f64_values: medax_view_f64,
    /// The values, if they are of type `MEDAX_VALUE_TYPE_U32`; else without a row.
    pub u32_values: medax_view_u32,
}

fn element(number: u32) -> Result<Element> {
    [Element::Vertex, Element::Edge, Element::Face, Element::Cell]
        .into_iter()
        .find(|&kind| medax_element::from(kind) as u32 == number)
        .ok_or_else(|| {
            Error::new(Status::InvalidArgument, format!("{number} is not a kind of element"))
        })
}

/// The caller's attribute.
pub(super) unsafe fn read(given: &medax_attribute) -> Result<Attribute> {
    let name = view::text(given.name, "attribute name")?;
    let count = |rows: usize, cols: usize| {
        rows.checked_mul(cols).ok_or_else(|| {
            Error::new(Status::InvalidArgument, format!("no memory holds attribute '{name}'"))
        })
    };
    let (f64s, u32s) = (&given.f64_values, &given.u32_values);
    let (cols, values) = if given.value_type == medax_value_type::F64 as u32 {
        let values = view::slice(f64s.data, count(f64s.rows, f64s.cols)?, name)?;
        (f64s.cols, Values::F64(values.to_vec()))
    } else if given.value_type == medax_value_type::U32 as u32 {
        let values = view::slice(u32s.data, count(u32s.rows, u32s.cols)?, name)?;
        (u32s.cols, Values::U32(values.to_vec()))
    } else {
        let message = format!("attribute '{name}' has an unknown value_type");
        return Err(Error::new(Status::InvalidArgument, message));
    };
    Attribute::new(name, element(given.element)?, cols, values)
}

/// The names of attributes, terminated for C.
pub(super) fn names(attributes: &[Attribute]) -> Vec<CString> {
    attributes.iter().map(|attribute| c_text(attribute.name())).collect()
}

/// What C sees of the attribute with this number.
pub(super) fn at(
    attributes: &[Attribute],
    names: &[CString],
    index: usize,
) -> Result<medax_attribute> {
    let (Some(attribute), Some(name)) = (attributes.get(index), names.get(index)) else {
        return Err(Error::new(Status::InvalidArgument, format!("there is no attribute {index}")));
    };
    let cols = attribute.width();
    let (value_type, f64s, u32s) = match attribute.values() {
        Values::F64(values) => (medax_value_type::F64, &values[..], &[][..]),
        Values::U32(values) => (medax_value_type::U32, &[][..], &values[..]),
    };
    Ok(medax_attribute {
        name: name.as_ptr(),
        element: medax_element::from(attribute.element()) as u32,
        value_type: value_type as u32,
        f64_values: medax_view_f64::new(f64s, cols),
        u32_values: medax_view_u32::new(u32s, cols),
    })
}

/// What C sees of the attribute with this name on this kind of element.
pub(super) fn named(
    attributes: &[Attribute],
    names: &[CString],
    element: u32,
    name: &str,
) -> Result<medax_attribute> {
    let kind = self::element(element)?;
    let index = attributes.iter().position(|a| a.element() == kind && a.name() == name);
    let index = index.ok_or_else(|| {
        let message = format!("there is no attribute '{name}' on elements of kind {element}");
        Error::new(Status::InvalidArgument, message)
    })?;
    at(attributes, names, index)
}

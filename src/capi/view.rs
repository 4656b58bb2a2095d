//! Views
//!
//! Arrays that are read where they lie.
//!
//! A view is row-major and contiguous. It borrows from the handle that gave it, and is valid
//! until the last reference to that handle is freed. A NULL handle, or an array without a row,
//! gives a view without a row, whose data is NULL.

#![deny(unsafe_op_in_unsafe_fn, clippy::undocumented_unsafe_blocks)]

use crate::error::{Error, Result, Status};
use std::ffi::{CStr, c_char};
use std::mem::MaybeUninit;
use std::ops::Range;
use std::{ptr, slice};

/// Rows of floats: row `i` is `data[i * cols]` to `data[i * cols + cols - 1]`.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct medax_view_f64 {
    /// `rows * cols` values; NULL if there are none.
    pub data: *const f64,
    /// The number of rows.
    pub rows: usize,
    /// The number of values in a row.
    pub cols: usize,
}

/// Rows of indices: row `i` is `data[i * cols]` to `data[i * cols + cols - 1]`.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct medax_view_u32 {
    /// `rows * cols` values; NULL if there are none.
    pub data: *const u32,
    /// The number of rows.
    pub rows: usize,
    /// The number of values in a row.
    pub cols: usize,
}

/// Rows of bytes, such as flags that are 0 or 1.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct medax_view_u8 {
    /// `rows * cols` values; NULL if there are none.
    pub data: *const u8,
    /// The number of rows.
    pub rows: usize,
    /// The number of values in a row.
    pub cols: usize,
}

/// Rows of varying length: row `i` is `indices[offsets[i]]` to `indices[offsets[i + 1] - 1]`.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct medax_view_rows {
    /// `rows + 1` positions in `indices`, the first of them 0; NULL for a NULL handle.
    pub offsets: *const u32,
    /// `offsets[rows]` values; NULL if there are none.
    pub indices: *const u32,
    /// The number of rows.
    pub rows: usize,
}

/// A NULL pointer rather than the dangling one of an empty slice.
fn pointer<T>(values: &[T]) -> *const T {
    if values.is_empty() { ptr::null() } else { values.as_ptr() }
}

impl medax_view_f64 {
    /// A view of `cols` values a row.
    pub(super) fn new(values: &[f64], cols: usize) -> Self {
        medax_view_f64 { data: pointer(values), rows: values.len() / cols.max(1), cols }
    }
}

impl medax_view_u32 {
    /// A view of `cols` values a row.
    pub(super) fn new(values: &[u32], cols: usize) -> Self {
        medax_view_u32 { data: pointer(values), rows: values.len() / cols.max(1), cols }
    }
}

impl medax_view_u8 {
    /// A view of flags, one a row.
    pub(super) fn of_flags(flags: &[bool]) -> Self {
        // A bool is a byte that is 0 or 1.
        medax_view_u8 { data: pointer(flags).cast(), rows: flags.len(), cols: 1 }
    }
}

/// An enum that C sees as its number.
///
/// # Safety
/// The type is a fieldless `repr(u32)` enum.
pub(super) unsafe trait Number: Copy {}

// SAFETY: fieldless and repr(u32).
unsafe impl Number for crate::complex::CellType {}
// SAFETY: fieldless and repr(u32).
unsafe impl Number for crate::figure::ChainKind {}
// SAFETY: fieldless and repr(u32).
unsafe impl Number for crate::crust::Label {}
// SAFETY: fieldless and repr(u32).
unsafe impl Number for crate::flow::CriticalClass {}

/// The numbers of the values.
pub(super) fn numbers<T: Number>(values: &[T]) -> &[u32] {
    // SAFETY: `Number` makes a value a u32 in size, alignment and contents.
    unsafe { slice::from_raw_parts(values.as_ptr().cast(), values.len()) }
}

/// An enum that C sees as two numbers: which variant it is, and the variant's own.
///
/// # Safety
/// The type is a `repr(u32)` enum of which every variant has one u32.
pub(super) unsafe trait Numbered: Copy {}

// SAFETY: repr(u32), and every variant has one u32.
unsafe impl Numbered for crate::flow::Simplex {}

/// The two numbers of each value, one value's after the other's.
pub(super) fn pairs<T: Numbered>(values: &[T]) -> &[u32] {
    const { assert!(size_of::<T>() == 8 && align_of::<T>() == align_of::<u32>()) };
    // SAFETY: a `repr(u32)` enum lies in memory as the union of structs that have the number of a variant in front,
    // then its field (RFC 2195): as `Numbered` has it two u32, with nothing between them.
    unsafe { slice::from_raw_parts(values.as_ptr().cast(), 2 * values.len()) }
}

impl medax_view_rows {
    pub(super) const EMPTY: Self =
        medax_view_rows { offsets: ptr::null(), indices: ptr::null(), rows: 0 };

    /// A view of rows that begin and end at the offsets.
    pub(super) fn new(offsets: &[u32], indices: &[u32]) -> Self {
        medax_view_rows {
            offsets: offsets.as_ptr(),
            indices: pointer(indices),
            rows: offsets.len().saturating_sub(1),
        }
    }
}

/// The error for an argument that must not be NULL.
pub(super) fn null(name: &str) -> Error {
    Error::new(Status::NullArgument, format!("the argument '{name}' is NULL"))
}

/// Where a result goes once it is there; checked before any work, so that a failing call writes
/// nothing.
pub(super) struct Out<T>(*mut T);

impl<T> Out<T> {
    /// # Safety
    /// `target` is NULL or points at room for a `T`, for as long as this value lives.
    pub(super) unsafe fn new(target: *mut T, name: &str) -> Result<Self> {
        if target.is_null() { Err(null(name)) } else { Ok(Out(target)) }
    }

    pub(super) fn put(self, value: T) {
        // SAFETY: not NULL, and promised to `new`.
        unsafe { self.0.write(value) };
    }

    /// Writes a result that the caller may not want.
    ///
    /// # Safety
    /// `target` is NULL or points at room for a `T`.
    pub(super) unsafe fn maybe(target: *mut T, value: T) {
        if !target.is_null() {
            // SAFETY: not NULL, and the caller's promise.
            unsafe { target.write(value) };
        }
    }

    /// Makes and writes a result that the caller may not want.
    ///
    /// # Safety
    /// As for [`Out::maybe`].
    pub(super) unsafe fn maybe_with(target: *mut T, make: impl FnOnce() -> T) {
        if !target.is_null() {
            // SAFETY: not NULL, and the caller's promise.
            unsafe { target.write(make()) };
        }
    }
}

/// The caller's array of `count` values, to be filled.
pub(super) struct Buffer<T> {
    target: *mut T,
    count: usize,
}

impl<T: Copy> Buffer<T> {
    /// # Safety
    /// `target` is NULL or points at room for `count` values, for as long as this value lives.
    pub(super) unsafe fn new(target: *mut T, count: usize, name: &str) -> Result<Self> {
        if target.is_null() && count != 0 {
            return Err(null(name));
        }
        check_extent::<T>(count, 1, size_of::<T>(), name)?;
        Ok(Buffer { target, count })
    }

    /// Writes the values from the front on, as many as there is room for.
    pub(super) fn fill(self, values: &[T]) {
        let count = values.len().min(self.count);
        if count != 0 {
            // SAFETY: room for as many was promised to `new`, and none of it is behind `values`,
            // which the library owns.
            unsafe { ptr::copy_nonoverlapping(values.as_ptr(), self.target, count) };
        }
    }

    /// [`Buffer::fill`] with what some values become for C.
    pub(super) fn fill_from<S: Copy + Into<T>>(self, values: &[S]) {
        self.fill_with(values.iter().map(|&value| value.into()));
    }

    /// [`Buffer::fill`] with values that are made one by one.
    pub(super) fn fill_with(self, values: impl Iterator<Item = T>) {
        for (i, value) in values.take(self.count).enumerate() {
            // SAFETY: `i` is below the count, and room for as many was promised to `new`.
            unsafe { self.target.add(i).write(value) };
        }
    }
}

/// The `count` values of the caller's array, which may be NULL if there are none.
///
/// # Safety
/// `data` is NULL or points at `count` values that stay as they are during `'a`.
pub(super) unsafe fn slice<'a, T: Copy>(
    data: *const T,
    count: usize,
    name: &str,
) -> Result<&'a [T]> {
    if count == 0 {
        return Ok(&[]);
    }
    if data.is_null() {
        return Err(null(name));
    }
    check_extent::<T>(count, 1, size_of::<T>(), name)?;
    // SAFETY: the caller's promise; not NULL, and no longer than memory can be.
    Ok(unsafe { slice::from_raw_parts(data, count) })
}

/// The `count` rows of `cols` values of the caller's array, as for [`slice`].
///
/// # Safety
/// `data` is NULL or points at `count * cols` values that stay as they are during `'a`.
pub(super) unsafe fn rows<'a, T: Copy, const COLS: usize>(
    data: *const T,
    count: usize,
    name: &str,
) -> Result<&'a [[T; COLS]]> {
    // SAFETY: the caller's promise; an array is as its elements in a row.
    unsafe { slice(data.cast::<[T; COLS]>(), count, name) }
}

/// The rows from `first` on, `count` of them, if there are as many.
pub(super) fn range(first: usize, count: usize, rows: usize, name: &str) -> Result<Range<usize>> {
    let end = first.checked_add(count).filter(|&end| end <= rows);
    end.map(|end| first..end).ok_or_else(|| {
        let message = format!("{count} {name} from {first} on are not there: there are {rows}");
        Error::new(Status::InvalidArgument, message)
    })
}

/// How many points, and which, in the caller's array, `stride` bytes apart; 0 stands for no gap.
///
/// # Safety
/// `data` is NULL or points at `count` such points, which stay as they are during `'a`.
pub(super) unsafe fn points<'a, T: Copy + Into<f64>>(
    data: *const T,
    count: usize,
    stride: usize,
    name: &str,
) -> Result<(usize, impl Fn(usize) -> [f64; 3] + Sync + use<'a, T>)> {
    let row = 3 * size_of::<T>();
    let stride = if stride == 0 { row } else { stride };
    check_extent::<T>(count, 3, stride, name)?;
    let bytes: &'a [MaybeUninit<u8>] = match (count, data.is_null()) {
        (0, _) => &[],
        (_, true) => return Err(null(name)),
        // SAFETY: the caller promises points at every stride, up to the end of the last; `check_extent` excludes an
        // overflow. What is between them may be anything.
        _ => unsafe { slice::from_raw_parts(data.cast(), (count - 1) * stride + row) },
    };
    let point = move |i: usize| {
        let point: *const [T; 3] = bytes[i * stride..][..row].as_ptr().cast();
        // SAFETY: the caller promises three values at every stride, which may leave them unaligned.
        unsafe { point.read_unaligned() }.map(Into::into)
    };
    Ok((count, point))
}

/// Errors unless `count` rows of `cols` values, `stride` bytes apart, fit into memory.
fn check_extent<T>(count: usize, cols: usize, stride: usize, name: &str) -> Result<()> {
    let row = cols * size_of::<T>();
    if stride < row {
        return Err(Error::new(
            Status::InvalidArgument,
            format!("the stride of '{name}' is {stride} bytes, less than the {row} of a row"),
        ));
    }
    if count.checked_mul(stride).is_none_or(|bytes| bytes > isize::MAX as usize) {
        return Err(Error::new(
            Status::InvalidArgument,
            format!("'{name}' cannot have {count} rows: no memory is that large"),
        ));
    }
    Ok(())
}

/// The caller's text.
///
/// # Safety
/// `text` is NULL or points at a terminated string that stays as it is during `'a`.
pub(super) unsafe fn text<'a>(text: *const c_char, name: &str) -> Result<&'a str> {
    if text.is_null() {
        return Err(null(name));
    }
    // SAFETY: not NULL, and the caller's promise.
    let bytes = unsafe { CStr::from_ptr(text) };
    bytes.to_str().map_err(|_| {
        Error::new(Status::InvalidArgument, format!("the argument '{name}' is not UTF-8"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::flow::Simplex;

    #[test]
    fn a_simplex_is_its_dimension_and_its_number() {
        let simplices = [
            Simplex::Cell(7),
            Simplex::Sample(u32::MAX),
            Simplex::Triangle(0x0102_0304),
            Simplex::Edge(0),
        ];
        assert_eq!(pairs(&simplices), [3, 7, 0, u32::MAX, 2, 0x0102_0304, 1, 0]);
        for (simplex, pair) in simplices.iter().zip(pairs(&simplices).chunks(2)) {
            assert_eq!(pair, [simplex.dimension() as u32, simplex.number()]);
        }
        assert!(pairs::<Simplex>(&[]).is_empty());
    }
}

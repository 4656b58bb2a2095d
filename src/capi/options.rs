//! Sized structs: options come in, reports go out, and either side may be of another version.

#![deny(unsafe_op_in_unsafe_fn, clippy::undocumented_unsafe_blocks)]

use super::view::null;
use crate::error::{Error, Result, Status};
use std::ptr;

/// A struct that the caller sizes. Fields are only ever appended. Only [`sized_struct`]
/// implements it.
///
/// # Safety
/// The first field is `struct_size: usize`, and every other one is [`Plain`].
pub(super) unsafe trait SizedStruct: Copy {
    /// The size in version 0.1, the least that is accepted.
    const FIRST_SIZE: usize;
    /// Every field at its default, and the size.
    const DEFAULT: Self;
    /// The fields that must be 0.
    fn reserved(&self) -> &[u32];
}

/// A type of which any bytes that a caller wrote as that type are a value.
///
/// # Safety
/// An integer, a float, a raw pointer, or an optional function.
pub(super) unsafe trait Plain: Copy {}

// SAFETY: an integer.
unsafe impl Plain for u32 {}
// SAFETY: an integer.
unsafe impl Plain for u64 {}
// SAFETY: an integer.
unsafe impl Plain for i64 {}
// SAFETY: an integer.
unsafe impl Plain for usize {}
// SAFETY: an integer.
unsafe impl Plain for std::ffi::c_char {}
// SAFETY: in a row, nothing between them.
unsafe impl<T: Plain, const N: usize> Plain for [T; N] {}
// SAFETY: a float.
unsafe impl Plain for f64 {}
// SAFETY: a raw pointer.
unsafe impl<T> Plain for *const T {}
// SAFETY: a raw pointer.
unsafe impl<T> Plain for *mut T {}
// SAFETY: an optional function: NULL is None.
unsafe impl Plain for super::job::medax_progress_callback {}

/// Implements [`SizedStruct`] for a struct, given every field but `struct_size` with its type and
/// default; refuses to compile where that would not be sound.
macro_rules! sized_struct {
    ($name:ident, first_size: $first:expr, reserved: $reserved:tt,
     { $($field:ident: $type:ty = $default:expr),* $(,)? }) => {
        // SAFETY: the constants below compile only if the size comes first and every other field,
        // none left out, is plain.
        unsafe impl $crate::capi::options::SizedStruct for $name {
            const FIRST_SIZE: usize = $first;
            const DEFAULT: Self =
                $name { struct_size: size_of::<$name>(), $($field: $default),* };
            fn reserved(&self) -> &[u32] {
                $crate::capi::options::sized_struct!(@reserved self $reserved)
            }
        }
        const _: () = assert!(std::mem::offset_of!($name, struct_size) == 0);
        const _: fn($name) = |$name { struct_size, $($field),* }| {
            fn plain<T: $crate::capi::options::Plain>(_: T) {}
            plain::<usize>(struct_size);
            $(plain::<$type>($field);)*
        };
        // A convention rather than a need: where pointers have 64 bits, nothing lies between the
        // fields.
        #[cfg(target_pointer_width = "64")]
        const _: () = assert!(size_of::<usize>() $(+ size_of::<$type>())* == size_of::<$name>());
    };
    (@reserved $self:ident none) => { &[] };
    (@reserved $self:ident $field:ident) => { std::slice::from_ref(&$self.$field) };
}
pub(super) use sized_struct;

/// No struct will grow to this size: a larger one was never initialised.
const SIZE_LIMIT: usize = 4096;

fn check_size<T: SizedStruct>(size: usize, name: &str) -> Result<()> {
    if size < T::FIRST_SIZE || size > SIZE_LIMIT || !size.is_multiple_of(align_of::<T>()) {
        return Err(Error::new(
            Status::InvalidArgument,
            format!(
                "struct_size of '{name}' is {size}, which no version has; set it to its sizeof"
            ),
        ));
    }
    Ok(())
}

/// The caller's size of a struct that must not be NULL.
///
/// # Safety
/// `sized` is NULL or points at a `size_t`.
unsafe fn size_of_callers<T: SizedStruct>(sized: *const T, name: &str) -> Result<usize> {
    if sized.is_null() {
        return Err(null(name));
    }
    // SAFETY: the caller's promise; `SizedStruct` puts the size first.
    let size = unsafe { sized.cast::<usize>().read() };
    check_size::<T>(size, name)?;
    Ok(size)
}

/// The options behind the pointer, or the defaults if it is NULL. Fields that the caller's
/// version does not know are at their defaults; fields that this version does not know must be 0.
///
/// # Safety
/// `options` is NULL or points at as many readable bytes as its `struct_size` says.
pub(super) unsafe fn read<T: SizedStruct>(options: *const T, name: &str) -> Result<T> {
    let mut value = T::DEFAULT;
    if options.is_null() {
        return Ok(value);
    }
    // SAFETY: not NULL, and the caller promises more than a size.
    let size = unsafe { size_of_callers(options, name)? };
    let known = size.min(size_of::<T>());
    // SAFETY: the caller promises `size` readable bytes, and `value` has room for `known`.
    // `SizedStruct` makes any bytes a value of it.
    unsafe { ptr::copy_nonoverlapping(options.cast::<u8>(), (&raw mut value).cast::<u8>(), known) };
    // SAFETY: within the `size` bytes that the caller promises.
    let tail = unsafe { std::slice::from_raw_parts(options.cast::<u8>().add(known), size - known) };
    if tail.iter().any(|&byte| byte != 0) {
        return Err(Error::new(
            Status::InvalidArgument,
            format!("'{name}' sets a field that this version of the library does not know"),
        ));
    }
    if value.reserved().iter().any(|&field| field != 0) {
        return Err(Error::new(
            Status::InvalidArgument,
            format!("a reserved field of '{name}' is not 0; call its init function first"),
        ));
    }
    Ok(value)
}

/// Sets the caller's struct, of the caller's size, to the defaults; what this version does not
/// know becomes 0.
///
/// # Safety
/// `options` is NULL or points at `size` writable bytes.
pub(super) unsafe fn init<T: SizedStruct>(options: *mut T, size: usize, name: &str) -> Result<()> {
    if options.is_null() {
        return Err(null(name));
    }
    check_size::<T>(size, name)?;
    // SAFETY: the caller promises `size` writable bytes.
    unsafe { write_prefix(options, &T::DEFAULT, size) };
    Ok(())
}

/// A report that the caller sized, ready to be filled.
pub(super) struct Report<T> {
    target: *mut T,
    size: usize,
}

impl<T: SizedStruct> Report<T> {
    /// Checks the caller's size.
    ///
    /// # Safety
    /// `report` is NULL or points at as many writable bytes as its `struct_size` says, for as
    /// long as this value lives.
    pub(super) unsafe fn new(report: *mut T, name: &str) -> Result<Self> {
        // SAFETY: the caller promises more than a size.
        let size = unsafe { size_of_callers(report.cast_const(), name)? };
        Ok(Report { target: report, size })
    }

    /// A report that the caller may not want, and then gives NULL for.
    ///
    /// # Safety
    /// As for [`Report::new`].
    pub(super) unsafe fn maybe(report: *mut T, name: &str) -> Result<Option<Self>> {
        if report.is_null() {
            return Ok(None);
        }
        // SAFETY: the caller's promise.
        unsafe { Report::new(report, name) }.map(Some)
    }

    /// Fills what the caller's version has; what this version does not know becomes 0.
    pub(super) fn fill(self, value: &T) {
        // SAFETY: promised to `new`.
        unsafe { write_prefix(self.target, value, self.size) };
    }
}

/// Writes as much of `value` as fits into `size` bytes, zeros after it, and `size` in front.
///
/// # Safety
/// `target` points at `size` writable bytes, at least `T::FIRST_SIZE`.
unsafe fn write_prefix<T: SizedStruct>(target: *mut T, value: &T, size: usize) {
    let bytes = target.cast::<u8>();
    let known = size.min(size_of::<T>());
    // SAFETY: `known <= size` bytes are writable, and as many are readable. The value is
    // ours, so that the two do not overlap.
    unsafe { ptr::copy_nonoverlapping(ptr::from_ref(value).cast::<u8>(), bytes, known) };
    // SAFETY: the rest of the `size` writable bytes.
    unsafe { ptr::write_bytes(bytes.add(known), 0, size - known) };
    // SAFETY: `FIRST_SIZE` holds at least the size, which `SizedStruct` puts first.
    unsafe { target.cast::<usize>().write(size) };
}

/// The truth of an option that is 0 or 1.
pub(super) fn flag(value: u32, name: &str) -> Result<bool> {
    match value {
        0 => Ok(false),
        1 => Ok(true),
        _ => Err(Error::new(
            Status::InvalidArgument,
            format!("the option '{name}' is {value}, and must be 0 or 1"),
        )),
    }
}

#[cfg(test)]
mod tests;

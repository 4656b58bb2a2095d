//! Library
//!
//! The version, the statuses, the last error of each thread.

use super::boundary;
use crate::error::{ElementKind, Error, Status};
use std::cell::RefCell;
use std::ffi::{CStr, CString, c_char};

/// What a fallible function returns. 1-19 lie with the caller or the data, 20-39 with the run,
/// 40-59 with files. Numbers are never reused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum medax_status {
    /// Success.
    Ok = 0,
    /// A pointer that must not be NULL is NULL.
    NullArgument = 1,
    /// An argument's value has no meaning here.
    InvalidArgument = 2,
    /// A coordinate or weight is NaN or infinite.
    NonFinite = 3,
    /// A coordinate or weight lies outside the range in which all predicates are exact.
    CoordinateRange = 4,
    /// Too few distinct points.
    TooFewPoints = 5,
    /// All points lie in a plane, on a line, or at one point.
    Degenerate = 6,
    /// Two arguments do not belong together, such as arrays of different lengths.
    Mismatch = 7,
    /// The job was cancelled.
    Cancelled = 20,
    /// Memory ran out, or the job's memory ceiling would have been passed.
    OutOfMemory = 21,
    /// The result would have more elements than 32-bit indices can name.
    LimitExceeded = 22,
    /// The job is already running a build.
    Busy = 23,
    /// The operating system refused to read or write a file.
    Io = 40,
    /// A file is malformed or truncated.
    Format = 41,
    /// A file is well formed but of a kind that medax does not read or write.
    Unsupported = 42,
    /// A defect in medax; please report it.
    Internal = 99,
}

use medax_status as S;

/// Every status with the class of error that it stands for, and its name.
const STATUSES: [(medax_status, Option<Status>, &CStr); 16] = [
    (S::Ok, None, c"MEDAX_STATUS_OK"),
    (S::NullArgument, Some(Status::NullArgument), c"MEDAX_STATUS_NULL_ARGUMENT"),
    (S::InvalidArgument, Some(Status::InvalidArgument), c"MEDAX_STATUS_INVALID_ARGUMENT"),
    (S::NonFinite, Some(Status::NonFinite), c"MEDAX_STATUS_NON_FINITE"),
    (S::CoordinateRange, Some(Status::CoordinateRange), c"MEDAX_STATUS_COORDINATE_RANGE"),
    (S::TooFewPoints, Some(Status::TooFewPoints), c"MEDAX_STATUS_TOO_FEW_POINTS"),
    (S::Degenerate, Some(Status::Degenerate), c"MEDAX_STATUS_DEGENERATE"),
    (S::Mismatch, Some(Status::Mismatch), c"MEDAX_STATUS_MISMATCH"),
    (S::Cancelled, Some(Status::Cancelled), c"MEDAX_STATUS_CANCELLED"),
    (S::OutOfMemory, Some(Status::OutOfMemory), c"MEDAX_STATUS_OUT_OF_MEMORY"),
    (S::LimitExceeded, Some(Status::LimitExceeded), c"MEDAX_STATUS_LIMIT_EXCEEDED"),
    (S::Busy, Some(Status::Busy), c"MEDAX_STATUS_BUSY"),
    (S::Io, Some(Status::Io), c"MEDAX_STATUS_IO"),
    (S::Format, Some(Status::Format), c"MEDAX_STATUS_FORMAT"),
    (S::Unsupported, Some(Status::Unsupported), c"MEDAX_STATUS_UNSUPPORTED"),
    (S::Internal, Some(Status::Internal), c"MEDAX_STATUS_INTERNAL"),
];

impl From<Status> for medax_status {
    fn from(status: Status) -> Self {
        let found = STATUSES.iter().find(|entry| entry.1 == Some(status));
        found.map_or(S::Internal, |entry| entry.0)
    }
}

/// The kind of the element that an error points at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum medax_error_kind {
    /// The error points at no element.
    None = 0,
    /// A row of an input array, or of a file's vertex table, from 0.
    Row = 1,
    /// A line of a text file, from 1.
    Line = 2,
    /// A byte of a binary file, from 0.
    Byte = 3,
    /// A ring of a polygon, from 0.
    Ring = 4,
    /// A face, from 0.
    Face = 5,
    /// A cell, from 0.
    Cell = 6,
    /// A vertex of a structure, from 0.
    Vertex = 7,
    /// An edge, from 0.
    Edge = 8,
    /// An open polyline of a figure, from 0.
    Polyline = 9,
    /// A circle of a figure, from 0.
    Circle = 10,
}

impl From<ElementKind> for medax_error_kind {
    fn from(kind: ElementKind) -> Self {
        match kind {
            ElementKind::Row => medax_error_kind::Row,
            ElementKind::Line => medax_error_kind::Line,
            ElementKind::Byte => medax_error_kind::Byte,
            ElementKind::Ring => medax_error_kind::Ring,
            ElementKind::Face => medax_error_kind::Face,
            ElementKind::Cell => medax_error_kind::Cell,
            ElementKind::Vertex => medax_error_kind::Vertex,
            ElementKind::Edge => medax_error_kind::Edge,
            ElementKind::Polyline => medax_error_kind::Polyline,
            ElementKind::Circle => medax_error_kind::Circle,
        }
    }
}

/// The last failure of a thread.
struct LastError {
    message: CString,
    element: Option<(ElementKind, u64)>,
}

thread_local! {
    static LAST_ERROR: RefCell<Option<LastError>> = const { RefCell::new(None) };
}

/// Keeps the error for this thread's questions, and returns its status.
pub(super) fn record(error: &Error) -> medax_status {
    let message = error.to_string().replace('\0', "\u{fffd}");
    let last =
        LastError { message: CString::new(message).unwrap_or_default(), element: error.element() };
    // A thread that is being torn down has no last error any more; the status stands.
    let _ = LAST_ERROR.try_with(|slot| slot.replace(Some(last)));
    error.status().into()
}

/// The text, terminated for C.
pub(super) fn c_text(text: &str) -> CString {
    CString::new(text.replace('\0', "\u{fffd}")).unwrap_or_default()
}

/// What `read` sees of this thread's last error, or `none`.
fn last<T>(none: T, read: impl FnOnce(&LastError) -> T) -> T {
    LAST_ERROR.try_with(|slot| slot.borrow().as_ref().map(read)).ok().flatten().unwrap_or(none)
}

/// The version of the loaded library, `major << 22 | minor << 12 | patch`; compare it with
/// `MEDAX_VERSION`, the version of this header.
///
/// \return The version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub extern "C" fn medax_version() -> u32 {
    let number = |text: &str| text.parse::<u32>().unwrap_or(0);
    number(env!("CARGO_PKG_VERSION_MAJOR")) << 22
        | number(env!("CARGO_PKG_VERSION_MINOR")) << 12
        | number(env!("CARGO_PKG_VERSION_PATCH"))
}

/// The version of the loaded library as text, such as `0.1.0`.
///
/// \return A static string; never NULL, never to be freed.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub extern "C" fn medax_version_string() -> *const c_char {
    const VERSION: &str = concat!(env!("CARGO_PKG_VERSION"), "\0");
    VERSION.as_ptr().cast()
}

/// The name of a status, such as `MEDAX_STATUS_NON_FINITE`.
///
/// \param status A status, or any other number: then the name is `MEDAX_STATUS_UNKNOWN`.
/// \return A static string; never NULL, never to be freed.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub extern "C" fn medax_status_name(status: i32) -> *const c_char {
    let found = STATUSES.iter().find(|entry| entry.0 as i32 == status);
    found.map_or(c"MEDAX_STATUS_UNKNOWN", |entry| entry.2).as_ptr()
}

/// What went wrong in this thread's last failing call: a sentence for a person.
/// A call that succeeds does not clear it.
///
/// \return UTF-8 text, empty if no call has failed; never NULL. Borrowed: valid until the next
///         failing call of this thread, or its end.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub extern "C" fn medax_last_error_message() -> *const c_char {
    boundary::value(c"".as_ptr(), || last(c"".as_ptr(), |error| error.message.as_ptr()))
}

/// The kind of the element at which this thread's last error points.
///
/// \return A #medax_error_kind; `MEDAX_ERROR_KIND_NONE` if it points at none.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub extern "C" fn medax_last_error_kind() -> u32 {
    let kind = |error: &LastError| {
        error.element.map_or(medax_error_kind::None, |(kind, _)| kind.into()) as u32
    };
    boundary::value(0, || last(0, kind))
}

/// The index of the element at which this thread's last error points.
///
/// \return The index, or `UINT64_MAX` if it points at none.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub extern "C" fn medax_last_error_index() -> u64 {
    let index = |error: &LastError| error.element.map_or(u64::MAX, |(_, index)| index);
    boundary::value(u64::MAX, || last(u64::MAX, index))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_status_keeps_its_number_and_name() {
        for (status, class, name) in STATUSES {
            let class_name = class.map_or("OK", Status::name);
            assert_eq!(name.to_str().unwrap(), format!("MEDAX_STATUS_{class_name}"));
            assert_eq!(status as i32, class.map_or(0, |class| class as i32));
            if let Some(class) = class {
                assert_eq!(medax_status::from(class), status);
            }
        }
    }

    #[test]
    fn every_kind_keeps_its_number() {
        use ElementKind::*;
        for kind in [Row, Line, Byte, Ring, Face, Cell, Vertex, Edge] {
            assert_eq!(medax_error_kind::from(kind) as u32, kind as u32);
        }
    }

    #[test]
    fn an_error_is_kept_for_its_thread_only() {
        let error = Error::new(Status::NonFinite, "no\0number").at(ElementKind::Row, 7);
        assert_eq!(record(&error), S::NonFinite);
        assert_eq!((medax_last_error_kind(), medax_last_error_index()), (1, 7));
        let text = last(String::new(), |e| e.message.to_string_lossy().into_owned());
        assert_eq!(text, "row 7: no\u{fffd}number");
        std::thread::spawn(|| {
            assert_eq!((medax_last_error_kind(), medax_last_error_index()), (0, u64::MAX));
        })
        .join()
        .unwrap();
    }
}

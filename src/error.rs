//! What can go wrong, and where: one error type for the whole crate.

use std::fmt;

/// The result of everything that can fail.
pub type Result<T> = std::result::Result<T, Error>;

/// The class of an [`Error`]. The numbers are the C ABI's and never change; 0 is success.
///
/// 1-19 lie with the caller or the data, 20-39 with the run, 40-59 with files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Status {
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

impl Status {
    /// The stable name that scripts see, such as `NON_FINITE`.
    pub fn name(self) -> &'static str {
        match self {
            Status::NullArgument => "NULL_ARGUMENT",
            Status::InvalidArgument => "INVALID_ARGUMENT",
            Status::NonFinite => "NON_FINITE",
            Status::CoordinateRange => "COORDINATE_RANGE",
            Status::TooFewPoints => "TOO_FEW_POINTS",
            Status::Degenerate => "DEGENERATE",
            Status::Mismatch => "MISMATCH",
            Status::Cancelled => "CANCELLED",
            Status::OutOfMemory => "OUT_OF_MEMORY",
            Status::LimitExceeded => "LIMIT_EXCEEDED",
            Status::Busy => "BUSY",
            Status::Io => "IO",
            Status::Format => "FORMAT",
            Status::Unsupported => "UNSUPPORTED",
            Status::Internal => "INTERNAL",
        }
    }
}

/// The kind of the element that an [`Error`] points at. The numbers are the C ABI's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum ElementKind {
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

impl ElementKind {
    /// The stable name that scripts see, such as `row`.
    pub fn name(self) -> &'static str {
        match self {
            ElementKind::Row => "row",
            ElementKind::Line => "line",
            ElementKind::Byte => "byte",
            ElementKind::Ring => "ring",
            ElementKind::Face => "face",
            ElementKind::Cell => "cell",
            ElementKind::Vertex => "vertex",
            ElementKind::Edge => "edge",
            ElementKind::Polyline => "polyline",
            ElementKind::Circle => "circle",
        }
    }
}

/// What went wrong, where, and what to do about it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    status: Status,
    message: String,
    element: Option<(ElementKind, u64)>,
}

impl Error {
    /// An error of the given class. The message is one plain sentence that says what is wrong
    /// and, where that is not obvious, what to do.
    pub fn new(status: Status, message: impl Into<String>) -> Self {
        Error { status, message: message.into(), element: None }
    }

    /// The same error, pointing at one element.
    #[must_use]
    pub fn at(mut self, kind: ElementKind, index: u64) -> Self {
        self.element = Some((kind, index));
        self
    }

    /// The class.
    pub fn status(&self) -> Status {
        self.status
    }

    /// The sentence for a person, without the element's index unless the sentence needs it.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// The offending element, if there is one.
    pub fn element(&self) -> Option<(ElementKind, u64)> {
        self.element
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.element {
            Some((kind, index)) => write!(f, "{} {index}: {}", kind.name(), self.message),
            None => f.write_str(&self.message),
        }
    }
}

impl std::error::Error for Error {}

impl From<std::io::Error> for Error {
    fn from(error: std::io::Error) -> Self {
        Error::new(Status::Io, error.to_string())
    }
}

//! Files: bytes to [`Points`] and [`Complex`], and back. No geometry.
//!
//! What each format holds is in `docs/formats.md`. Reading trusts nothing: a count is checked
//! against the bytes that are left before room is made for it, and every error names the line of a
//! text or the byte of a binary file. That is why the parsers are our own: crates for these formats
//! read streams of typed records, and say neither where a file is wrong nor how much it promises.
//! They are small, as the formats are.
//!
//! Writing goes to a file beside the given name, moved into place when it is complete. What a
//! format cannot hold is said in the returned warnings. Numbers are written so that they read back
//! to the same bits, save for STL, which has single precision only and says so.

mod file;
mod format;
mod ma;
mod obj;
mod off;
mod ply;
mod sink;
mod soup;
mod stl;
mod text;
mod vtu;
mod write;
mod xyz;

pub use format::Format;
pub use soup::Soup;
pub use write::{WriteOptions, write_complex, write_points};

use crate::complex::Complex;
use crate::error::{ElementKind, Error, Result, Status};
use crate::job::{Job, Run, Stage};
use crate::points::{Points, PointsOptions};
use std::path::Path;

/// What a file's bytes hold.
///
/// Errors: [`Status::Format`] with the line (text) or byte (binary) where the bytes are malformed or
/// end too early; [`Status::Unsupported`] for a kind that is not read;
/// [`Status::LimitExceeded`] past 2^32 - 2 rows. Cost: linear.
pub fn parse(bytes: &[u8], format: Format, job: &Job) -> Result<Soup> {
    job.run(&[(Stage::Read, 1.0)], |run| {
        run.enter(Stage::Read)?;
        parse_in(bytes, format, run)
    })
}

fn parse_in(bytes: &[u8], format: Format, run: &Run<'_>) -> Result<Soup> {
    if !format.is_read() {
        let message = format!("medax writes {} and does not read it", format.name());
        return Err(Error::new(Status::Unsupported, message));
    }
    if bytes.is_empty() {
        let error = Error::new(Status::Format, "the file is empty");
        return Err(error.at(ElementKind::Byte, 0));
    }
    match format {
        Format::Ply => ply::parse(bytes, run),
        Format::Off => off::parse(bytes, run),
        Format::Obj => obj::parse(bytes, run),
        Format::Stl => stl::parse(bytes, run),
        Format::Xyz | Format::Csv => xyz::parse(bytes, run),
        Format::Pwn => xyz::parse_pwn(bytes, run),
        Format::Ma => ma::parse(bytes, run),
        Format::Vtu => Err(Error::new(Status::Internal, "a format without a reader")),
    }
}

/// Reads a file of the format that its ending names.
///
/// Errors: as [`parse`]; [`Status::Io`] where the file cannot be read.
pub fn read(path: impl AsRef<Path>, job: &Job) -> Result<Soup> {
    job.run(&[(Stage::Read, 1.0)], |run| read_in(path.as_ref(), run))
}

fn read_in(path: &Path, run: &Run<'_>) -> Result<Soup> {
    let format = Format::of_path(path)?;
    run.enter(Stage::Read)?;
    let file = file::load(path, run)?;
    parse_in(&file.bytes, format, run)
}

/// Reads a set of points: of a mesh the vertices that it uses, see [`Soup::points`].
///
/// Errors: as [`read`] and [`Points::new`].
pub fn read_points(path: impl AsRef<Path>, options: PointsOptions, job: &Job) -> Result<Points> {
    job.run(&[(Stage::Read, 0.5), (Stage::Order, 0.5)], |run| {
        read_in(path.as_ref(), run)?.points_in(options, run)
    })
}

/// Reads a complex, see [`Soup::into_complex`].
///
/// Errors: as [`read`] and [`Soup::into_complex`].
pub fn read_complex(path: impl AsRef<Path>, job: &Job) -> Result<Complex> {
    job.run(&[(Stage::Read, 1.0)], |run| read_in(path.as_ref(), run)?.into_complex())
}

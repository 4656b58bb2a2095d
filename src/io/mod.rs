//! Files: bytes to [`Points`], [`Complex`] and [`Figure`], and back. No geometry.
//!
//! What each format holds is in `docs/formats.md`. Reading trusts nothing: a count is checked
//! against the bytes that are left before room is made for it, and every error names the line of a
//! text or the byte of a binary file. That is why the parsers are our own: crates for these formats
//! read streams of typed records, and say neither where a file is wrong nor how much it promises.
//! They are small, as the formats are. JSON is left to `serde_json`, which names the line.
//!
//! Writing goes to a file beside the given name, moved into place when it is complete, with the rights of
//! the file that it replaces. What a format cannot hold is said in the returned warnings. Numbers are written so that they read back
//! to the same bits, save for STL, which has single precision only and says so.

mod file;
mod format;
mod geojson;
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

pub use file::target;
pub use format::Format;
pub use geojson::{FeatureChoice, ReadFigureOptions, parse_figure};
pub use soup::Soup;
pub use write::{WriteOptions, write_complex, write_points};

use crate::complex::Complex;
use crate::error::{ElementKind, Error, Result, Status};
use crate::figure::Figure;
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
    if format == Format::GeoJson {
        let message =
            "a GeoJSON file holds a plane figure, not points or a complex; read it as a figure";
        return Err(Error::new(Status::Unsupported, message));
    }
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
        Format::Vtu | Format::GeoJson => {
            Err(Error::new(Status::Internal, "a format without a reader"))
        }
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

/// Reads a figure from a GeoJSON file, as [`parse_figure`] does from bytes.
///
/// Errors: as [`parse_figure`]; [`Status::Io`] where the file cannot be read; [`Status::Unsupported`] for another
/// ending.
pub fn read_figure(
    path: impl AsRef<Path>,
    options: &ReadFigureOptions,
    job: &Job,
) -> Result<Figure> {
    job.run(&[(Stage::Read, 0.5), (Stage::Order, 0.5)], |run| {
        let format = Format::of_path(&path)?;
        if format != Format::GeoJson {
            let message = format!("{} holds no plane figure; give a GeoJSON file", format.name());
            return Err(Error::new(Status::Unsupported, message));
        }
        run.enter(Stage::Read)?;
        let file = file::load(path.as_ref(), run)?;
        geojson::parse_figure_in(&file.bytes, options, run)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::JobOptions;

    /// A file of each format, long enough to report progress more than once.
    fn long_files() -> Vec<(Format, Vec<u8>)> {
        let rows = |head: &str, row: &str| (head.to_string() + &row.repeat(50_000)).into_bytes();
        let header = "element vertex 50000\nproperty char x\nproperty char y\nproperty char z\n";
        let ply = |format: &str| format!("ply\nformat {format} 1.0\n{header}end_header\n");
        let facet =
            "facet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
        let mut stl = vec![0; 80];
        stl.extend(50_000u32.to_le_bytes());
        stl.resize(84 + 50 * 50_000, 0);
        vec![
            (Format::Ply, rows(&ply("ascii"), "1 2 3\n")),
            (Format::Ply, rows(&ply("binary_big_endian"), "123")),
            (Format::Off, rows("OFF 50000 0\n", "1 2 3\n")),
            (Format::Obj, rows("", "v 1 2 3\n")),
            (Format::Stl, stl),
            (Format::Stl, rows("solid\n", facet)),
            (Format::Xyz, rows("", "1 2 3\n")),
            (Format::Csv, rows("x,y,z\n", "1,2,3\n")),
            (Format::Pwn, rows("25000\n", "1 2 3\n")),
            (Format::Ma, rows("50000 0 0\n", "v 1 2 3 4\n")),
        ]
    }

    #[test]
    fn every_reader_stops_when_it_is_cancelled() {
        for (format, bytes) in long_files() {
            let job = Job::default();
            let stopped = job.run(&[(Stage::Read, 1.0)], |run| {
                run.enter(Stage::Read)?;
                job.cancel();
                parse_in(&bytes, format, run)
            });
            assert_eq!(stopped.unwrap_err().status(), Status::Cancelled, "{format:?}");
        }
    }

    #[test]
    fn every_reader_reports_its_progress_along_the_way() {
        for (format, mut bytes) in long_files() {
            // A fault at the very end, so that nothing but the reader moves the progress. (A binary
            // STL of the right length has none.)
            if bytes.ends_with(b"\n") {
                let last = bytes.len() - 2;
                bytes[last] = b'x';
            } else if format == Format::Ply {
                bytes.push(b'x');
            } else {
                continue;
            }
            let job = Job::default();
            let error = parse(&bytes, format, &job).unwrap_err();
            assert_eq!(error.status(), Status::Format, "{format:?}");
            let progress = job.progress();
            assert!((0.5..1.0).contains(&progress), "{format:?}: {progress}");
        }
    }

    #[test]
    fn every_reader_counts_its_arrays_against_the_ceiling() {
        for (format, bytes) in long_files() {
            let options = JobOptions { memory_ceiling: 1000, ..JobOptions::default() };
            let error = parse(&bytes, format, &Job::new(options)).unwrap_err();
            assert_eq!(error.status(), Status::OutOfMemory, "{format:?}");
        }
    }
}

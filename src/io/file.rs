//! Whole files: read in pieces, and replaced in one move.

use crate::error::{Error, Result, Status};
use crate::job::{Charge, Run};
use std::fs::File;
use std::io::{self, BufWriter, Read, Write};
use std::path::{Path, PathBuf};

/// How much is read between two reports of progress.
const PIECE: usize = 4 << 20;
/// How many links after one another are followed, as by Linux.
const LINK_LIMIT: usize = 40;
/// The share of reading that goes to getting the bytes; parsing takes the rest.
const LOAD_SHARE: usize = 10;

/// A file's bytes, counted against the memory ceiling while they live.
pub(super) struct Bytes<'a> {
    pub bytes: Vec<u8>,
    _charges: Vec<Charge<'a>>,
}

pub(super) fn load<'a>(path: &Path, run: &'a Run<'a>) -> Result<Bytes<'a>> {
    let failed = |error: io::Error| failed("read", &error);
    let mut file = File::open(path).map_err(failed)?;
    // A pipe has no length; the length of a file may change while it is read.
    let length = file.metadata().map_err(failed)?.len() as usize;
    let mut charges = vec![run.charge(length as u64 + 1)?];
    // One byte more, so that the end is seen without growing.
    let mut bytes = run.try_vec(length + 1)?;
    loop {
        run.tick(bytes.len(), LOAD_SHARE * length.max(bytes.len()))?;
        if bytes.len() == bytes.capacity() {
            let extra = bytes.len().max(PIECE);
            charges.push(run.charge(extra as u64)?);
            bytes.try_reserve_exact(extra).map_err(|_| {
                Error::new(Status::OutOfMemory, format!("{extra} bytes are not to be had"))
            })?;
        }
        let room = (bytes.capacity() - bytes.len()).min(PIECE);
        let read =
            Read::by_ref(&mut file).take(room as u64).read_to_end(&mut bytes).map_err(failed)?;
        if read == 0 {
            return Ok(Bytes { bytes, _charges: charges });
        }
    }
}

/// Writes a file beside its name and moves it into place when `write` has ended well.
/// Otherwise nothing is left behind, and a file that was there before stays as it was.
pub(super) fn replace<T>(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> Result<T>,
) -> Result<T> {
    let failed = |error: io::Error| failed("written", &error);
    let target = target(path)?;
    let folder = target.parent().unwrap_or(Path::new("."));
    let replaced = target.metadata().ok().map(|there| there.permissions());
    let mut builder = tempfile::Builder::new();
    builder.prefix(".medax-").suffix(".part");
    #[cfg(unix)]
    if replaced.is_none() {
        // As for any new file; the user's mask takes its bits away.
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    // The error's own words name the file beside, which would mean nothing to anyone.
    let file = builder.tempfile_in(folder).map_err(|error| failed(error.kind().into()))?;
    let mut out = BufWriter::with_capacity(1 << 16, file);
    let written = write(&mut out).map_err(|error| match error.status() {
        Status::Io => {
            Error::new(Status::Io, format!("the file cannot be written: {}", error.message()))
        }
        _ => error,
    })?;
    let file = out.into_inner().map_err(|error| failed(error.into_error()))?;
    if let Some(permissions) = replaced {
        file.as_file().set_permissions(permissions).map_err(failed)?;
    }
    file.persist(&target).map_err(|error| failed(error.error))?;
    Ok(written)
}

/// The file that writing to `path` makes or replaces, by the one name that it has without links: two
/// paths with one target would overwrite each other.
///
/// Errors: [`Status::Io`] where the folder is not there, or something other than a file has the name.
pub fn target(path: impl AsRef<Path>) -> Result<PathBuf> {
    resolve(path.as_ref()).map_err(|error| failed("written", &error))
}

fn resolve(path: &Path) -> io::Result<PathBuf> {
    match path.metadata() {
        Ok(there) if there.is_file() => return path.canonicalize(),
        Ok(_) => return Err(io::Error::other("something other than a file has this name")),
        Err(error) if error.kind() == io::ErrorKind::NotFound => {}
        Err(error) => return Err(error),
    }
    // A link may name a file that is not there yet.
    let mut path = path.to_path_buf();
    for _ in 0..LINK_LIMIT {
        let folder = match path.parent() {
            Some(folder) if folder != Path::new("") => folder,
            _ => Path::new("."),
        };
        let Ok(next) = path.read_link() else {
            let name = path.file_name().ok_or(io::ErrorKind::InvalidInput)?;
            return Ok(folder.canonicalize()?.join(name));
        };
        path = folder.join(next);
    }
    Err(io::Error::other("its links lead to no end"))
}

/// Says what the system said. The path is the caller's to name.
fn failed(done: &str, error: &io::Error) -> Error {
    Error::new(Status::Io, format!("the file cannot be {done}: {error}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::{Job, Stage};

    #[test]
    fn a_write_that_stops_half_way_leaves_what_was_there() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        std::fs::write(&path, "old").unwrap();
        let stopped: Result<()> = replace(&path, |out| {
            out.write_all(&[b'x'; 1 << 20])?;
            assert_eq!(folder.path().read_dir().unwrap().count(), 2);
            Err(Error::new(Status::Cancelled, "stopped"))
        });
        assert_eq!(stopped.unwrap_err().status(), Status::Cancelled);
        assert_eq!(std::fs::read(&path).unwrap(), b"old");
        assert_eq!(folder.path().read_dir().unwrap().count(), 1);
    }

    #[test]
    fn a_file_is_loaded_whole_and_a_cancelled_load_stops() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.bin");
        for length in [0, 1, PIECE - 1, PIECE, 2 * PIECE + 1] {
            let bytes: Vec<u8> = (0..length).map(|i| (i % 251) as u8).collect();
            std::fs::write(&path, &bytes).unwrap();
            let plan = [(Stage::Read, 1.0)];
            let loaded = Job::default().run(&plan, |run| Ok(load(&path, run)?.bytes)).unwrap();
            assert!(loaded == bytes, "{length} bytes");
            let job = Job::default();
            let stopped = job.run(&plan, |run| {
                job.cancel();
                load(&path, run).map(|_| ())
            });
            assert_eq!(stopped.unwrap_err().status(), Status::Cancelled);
        }
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_file_without_a_length_is_loaded_whole() {
        let plan = [(Stage::Read, 1.0)];
        let path = Path::new("/proc/self/maps");
        assert_eq!(path.metadata().unwrap().len(), 0);
        let loaded = Job::default().run(&plan, |run| Ok(load(path, run)?.bytes)).unwrap();
        assert!(loaded.len() > 100);
    }
}

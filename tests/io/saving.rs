//! Files on disc: a failed or cancelled write leaves what was there.

use medax::complex::{Complex, ComplexParts, Rows};
use medax::io::{WriteOptions, read, write_complex};
use medax::{Job, JobOptions, Stage, Status};
use std::fs;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

fn triangle() -> Complex {
    let mut faces = Rows::default();
    faces.push(&[0, 1, 2]).unwrap();
    let vertices = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1e300, 0.0]];
    Complex::new(ComplexParts { vertices, faces, ..ComplexParts::default() }).unwrap()
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn a_write_replaces_the_file_and_leaves_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.off");
    fs::write(&path, "old").unwrap();
    write_complex(&path, &triangle(), WriteOptions::default(), &Job::default()).unwrap();
    assert_eq!(read(&path, &Job::default()).unwrap().faces().len(), 1);
    assert_eq!(names(folder.path()), ["a.off"]);
}

#[test]
fn a_write_that_fails_leaves_the_old_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.stl");
    fs::write(&path, "old").unwrap();
    // Past single precision.
    let error =
        write_complex(&path, &triangle(), WriteOptions::default(), &Job::default()).unwrap_err();
    assert_eq!(error.status(), Status::CoordinateRange);
    assert_eq!(fs::read(&path).unwrap(), b"old");
    assert_eq!(names(folder.path()), ["a.stl"]);
}

#[test]
fn a_write_cancelled_half_way_leaves_the_old_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.ply");
    fs::write(&path, "old").unwrap();
    // Large enough that the callback comes, which it does every 50 ms.
    let vertices = vec![[0.1, 0.2, 0.3]; 3_000_000];
    let complex = Complex::new(ComplexParts { vertices, ..ComplexParts::default() }).unwrap();
    let asked = Arc::new(AtomicBool::new(false));
    let seen = Arc::clone(&asked);
    let progress = move |_: f64, stage: Stage| {
        assert_eq!(stage, Stage::Write);
        seen.store(true, Ordering::Relaxed);
        false
    };
    let job = Job::new(JobOptions { progress: Some(Box::new(progress)), ..JobOptions::default() });
    let result = write_complex(&path, &complex, WriteOptions { text: true }, &job);
    assert!(asked.load(Ordering::Relaxed));
    assert_eq!(result.unwrap_err().status(), Status::Cancelled);
    assert!(job.progress() < 1.0);
    assert_eq!(fs::read(&path).unwrap(), b"old");
    assert_eq!(names(folder.path()), ["a.ply"]);
}

#[test]
fn a_spent_job_reads_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.off");
    let job = Job::default();
    write_complex(&path, &triangle(), WriteOptions::default(), &job).unwrap();
    job.cancel();
    assert_eq!(read(&path, &job).unwrap_err().status(), Status::Cancelled);
    let error =
        write_complex(folder.path().join("b.off"), &triangle(), WriteOptions::default(), &job);
    assert_eq!(error.unwrap_err().status(), Status::Cancelled);
    assert_eq!(names(folder.path()), ["a.off"]);
}

#[test]
fn a_ceiling_is_kept_in_reading() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.xyz");
    fs::write(&path, "1 2 3\n".repeat(10_000)).unwrap();
    let ceiling = |memory_ceiling| {
        read(&path, &Job::new(JobOptions { memory_ceiling, ..JobOptions::default() }))
    };
    assert_eq!(ceiling(100_000).unwrap_err().status(), Status::OutOfMemory);
    assert_eq!(ceiling(10_000).unwrap_err().status(), Status::OutOfMemory);
    assert_eq!(ceiling(1_000_000).unwrap().vertices().len(), 10_000);
}

#[test]
fn what_the_system_refuses_is_told_without_paths() {
    let folder = tempfile::tempdir().unwrap();
    let is_told = |error: medax::Error, done: &str| {
        assert_eq!(error.status(), Status::Io);
        let begins = format!("the file cannot be {done}: ");
        assert!(error.message().starts_with(&begins) && error.message().len() > begins.len());
        // Neither the caller's path, which the caller knows, nor that of the file beside it.
        assert!(!error.message().contains(folder.path().to_str().unwrap()), "{error}");
    };
    let missing = folder.path().join("missing.ply");
    is_told(read(&missing, &Job::default()).unwrap_err(), "read");
    let nowhere = folder.path().join("nowhere/a.ply");
    let written = write_complex(&nowhere, &triangle(), WriteOptions::default(), &Job::default());
    is_told(written.unwrap_err(), "written");
    let directory = folder.path().join("directory.ply");
    fs::create_dir(&directory).unwrap();
    is_told(read(&directory, &Job::default()).unwrap_err(), "read");
    let written = write_complex(&directory, &triangle(), WriteOptions::default(), &Job::default());
    is_told(written.unwrap_err(), "written");
}

#[cfg(unix)]
#[test]
fn links_are_followed_and_the_usual_rights_are_given() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().unwrap();
    let (target, link) = (folder.path().join("target.off"), folder.path().join("link.off"));
    fs::write(&target, "old").unwrap();
    std::os::unix::fs::symlink(&target, &link).unwrap();
    write_complex(&link, &triangle(), WriteOptions::default(), &Job::default()).unwrap();
    assert!(link.symlink_metadata().unwrap().is_symlink());
    assert_eq!(read(&target, &Job::default()).unwrap().faces().len(), 1);
    let other = folder.path().join("other");
    fs::write(&other, "").unwrap();
    let mode = |path: &Path| path.metadata().unwrap().permissions().mode();
    assert_eq!(mode(&target), mode(&other));
}

#[cfg(unix)]
#[test]
fn a_replaced_file_keeps_its_mode() {
    use std::fs::Permissions;
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().unwrap();
    // Also bits that the usual mask would take away.
    for (name, mode) in [("private.off", 0o600), ("shared.off", 0o666), ("fixed.off", 0o444)] {
        let path = folder.path().join(name);
        fs::write(&path, "old").unwrap();
        fs::set_permissions(&path, Permissions::from_mode(mode)).unwrap();
        write_complex(&path, &triangle(), WriteOptions::default(), &Job::default()).unwrap();
        assert_eq!(path.metadata().unwrap().permissions().mode() & 0o7777, mode, "{name}");
        assert_eq!(read(&path, &Job::default()).unwrap().faces().len(), 1);
    }
}

#[cfg(unix)]
#[test]
fn a_link_to_a_file_that_is_not_there_yet_is_followed() {
    use std::os::unix::fs::symlink;
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let write = |name: &str| {
        write_complex(path(name), &triangle(), WriteOptions::default(), &Job::default())
    };
    fs::create_dir(path("in")).unwrap();
    symlink("../new.off", path("in/link.off")).unwrap();
    symlink(path("in/link.off"), path("link.off")).unwrap();
    write("link.off").unwrap();
    assert!(path("link.off").is_symlink() && path("in/link.off").is_symlink());
    assert!(path("new.off").symlink_metadata().unwrap().is_file());
    assert_eq!(read(path("new.off"), &Job::default()).unwrap().faces().len(), 1);
    // Neither a loop nor a folder that is not there becomes a file.
    symlink("loop.off", path("loop.off")).unwrap();
    symlink("nowhere/a.off", path("lost.off")).unwrap();
    for name in ["loop.off", "lost.off"] {
        assert_eq!(write(name).unwrap_err().status(), Status::Io);
        assert!(path(name).is_symlink());
    }
}

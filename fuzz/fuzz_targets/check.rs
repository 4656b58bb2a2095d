//! What must hold of any bytes that are read.

use medax::io::{Format, parse};
use medax::points::PointsOptions;
use medax::{ElementKind, Job, JobOptions, Status};

/// Reads the bytes under a memory ceiling of a small multiple of their length. An error must be a
/// malformed file's and point into it; a soup must be sound, and so must what is made of it.
pub fn read(data: &[u8], format: Format) {
    let memory_ceiling = 64 * data.len() as u64 + (1 << 16);
    let job = Job::new(JobOptions { memory_ceiling, ..JobOptions::default() });
    let soup = match parse(data, format, &job) {
        Ok(soup) => soup,
        Err(error) => {
            assert!(matches!(error.status(), Status::Format | Status::Unsupported), "{error}");
            let lines = data.iter().filter(|&&b| b == b'\n' || b == b'\r').count() as u64 + 1;
            match error.element() {
                Some((ElementKind::Line, line)) => assert!((1..=lines).contains(&line), "{error}"),
                Some((ElementKind::Byte, byte)) => assert!(byte <= data.len() as u64, "{error}"),
                other => panic!("{error}: {other:?}"),
            }
            return;
        }
    };
    let count = soup.vertices().len();
    assert!(soup.faces().indices().iter().all(|&v| (v as usize) < count));
    assert!(soup.faces().iter().all(|face| face.len() >= 3));
    assert!(soup.edges().as_flattened().iter().all(|&v| (v as usize) < count));
    let job = Job::default();
    if let Ok(points) = soup.points(PointsOptions { skip_non_finite: true }, &job) {
        assert_eq!(points.row_count(), count);
    }
    let _ = soup.into_complex();
}

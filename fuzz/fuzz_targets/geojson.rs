//! GeoJSON files: read as figures, with crossings refused and accepted.
#![no_main]

use medax::figure::{Crossings, FigureOptions};
use medax::io::{ReadFigureOptions, parse_figure};
use medax::{ElementKind, Job, JobOptions, Status};

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    for crossings in [Crossings::Refuse, Crossings::Accept] {
        let memory_ceiling = 256 * data.len() as u64 + (1 << 16);
        let job = Job::new(JobOptions { memory_ceiling, ..JobOptions::default() });
        let figure = FigureOptions { crossings };
        let options = ReadFigureOptions { figure, ..ReadFigureOptions::default() };
        match parse_figure(data, &options, &job) {
            Ok(figure) => {
                let report = figure.validate(&Job::default()).expect("nobody cancels");
                assert!(report.is_valid(), "{report:?}");
            }
            Err(error) => {
                assert!(!matches!(error.status(), Status::Internal | Status::OutOfMemory), "{error}");
                let lines = data.iter().filter(|&&b| b == b'\n').count() as u64 + 1;
                match (error.status(), error.element()) {
                    (Status::Format, Some((ElementKind::Line, line))) => {
                        assert!((1..=lines).contains(&line), "{error}");
                    }
                    (Status::Format, Some((ElementKind::Byte, 0))) => assert!(data.is_empty()),
                    (Status::Format, place) => panic!("{error}: {place:?}"),
                    _ => {}
                }
            }
        }
    }
});

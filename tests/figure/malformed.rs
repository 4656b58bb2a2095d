//! Malformed GeoJSON, one fault each: the error names the line, and says what is wrong.

use medax::io::{ReadFigureOptions, parse_figure};
use medax::{ElementKind, Error, Figure, Job, JobOptions, Status};
use proptest::prelude::*;

const SAMPLE: &str = r#"{"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"name":"a","n":[1,{"x":null}]},"geometry":
{"type":"Polygon","coordinates":[[[0,0],[9.5,0],[0,9e0],[0,0]],[[1,1],[2,1],[1,2.25],[1,1]]]}},
{"type":"Feature","properties":{"radius":1.5},"geometry":{"type":"Point","coordinates":[20,20]}},
{"type":"Feature","properties":null,"geometry":{"type":"MultiLineString",
"coordinates":[[[30,0],[31,0]],[[40,0,5],[41,1,6]]]}}]}"#;

fn read(bytes: &[u8]) -> Result<Figure, Error> {
    let memory_ceiling = 128 * bytes.len() as u64 + (1 << 16);
    let job = Job::new(JobOptions { memory_ceiling, ..JobOptions::default() });
    parse_figure(bytes, &ReadFigureOptions::default(), &job)
}

fn faults(cases: &[(&str, u64, &str)]) {
    for (text, line, says) in cases {
        let error = match read(text.as_bytes()) {
            Ok(figure) => panic!("{text}: read as {figure:?}"),
            Err(error) => error,
        };
        assert_eq!(error.status(), Status::Format, "{text}: {error}");
        assert_eq!(error.element(), Some((ElementKind::Line, *line)), "{text}: {error}");
        assert!(error.message().contains(says), "{text}: {error}");
    }
}

#[test]
fn faults_of_json() {
    faults(&[
        ("\n\n{\"type\":\"Point\",", 3, "the file ends here"),
        ("{\"type\":\n\"Point\" \"coordinates\":[1,2]}", 2, "expected"),
        ("{\"type\":\"Point\",\"coordinates\":[1,\n02]}", 2, "number"),
        ("{\"type\":\"Point\",\"coordinates\":[1,\n\nNaN]}", 3, "expected value"),
        ("{\"type\":\"Point\",\"coordinates\":[1,2]}\n\n]", 3, "trailing"),
        ("{\"type\":\"Point\",\"coordinates\":[1,\n1e400]}", 2, "out of range"),
        (
            "{\"type\":\"Point\",\"coordinates\":[1,\n1e-400,\n4]}",
            2,
            "too small for double precision: '1e-400'",
        ),
        ("\n{\"type\":\"Po\x01int\"}", 2, "control character"),
        (" ", 1, "the file ends here"),
    ]);
    let error = read(b"").unwrap_err();
    assert_eq!((error.status(), error.element()), (Status::Format, Some((ElementKind::Byte, 0))));
    let error = read(b"{\"type\":\n\"\xff\"}").unwrap_err();
    assert_eq!((error.status(), error.element()), (Status::Format, Some((ElementKind::Line, 2))));
    let deep = "[".repeat(100_000);
    faults(&[
        (&format!("{{\"x\":\n{deep}"), 2, "the file ends here"),
        (&format!("{{\"coordinates\":\n{deep}"), 2, "nested too deep"),
    ]);
}

#[test]
fn faults_of_geojson() {
    let point =
        |coordinates: &str| format!("{{\"type\":\"Point\",\n\"coordinates\":{coordinates}}}");
    for (coordinates, says) in [
        ("[1]", "two numbers"),
        ("[]", "two numbers"),
        ("[[1,2]]", "1 arrays deep, and these 2"),
        ("[1,[2,3]]", "mixed"),
        ("[1,\"2\"]", "expected a number or an array"),
        ("[1,null]", "expected a number or an array"),
        ("[true,2]", "expected a number or an array"),
        ("{\"x\":1}", "expected an array of coordinates"),
        ("7", "expected an array of coordinates"),
    ] {
        faults(&[(&point(coordinates), 2, says)]);
    }
    faults(&[
        ("[]", 1, "an object of GeoJSON"),
        ("7", 1, "an object of GeoJSON"),
        ("null", 1, "an object of GeoJSON"),
        ("{}", 1, "missing field `type`"),
        ("{\"type\":7}", 1, "expected a string"),
        ("{\"type\":\"Topology\"}", 1, "'Topology' is no type of GeoJSON"),
        ("{\"type\":\"Point\"}", 1, "a Point needs coordinates"),
        ("{\"type\":\"Feature\",\"properties\":{}}", 1, "a Feature needs a geometry"),
        ("{\"type\":\"FeatureCollection\"}", 1, "a FeatureCollection needs features"),
        ("{\"type\":\"GeometryCollection\"}", 1, "a GeometryCollection needs geometries"),
        ("{\"type\":\"Point\",\n\"type\":\"Point\"}", 2, "duplicate field `type`"),
        ("{\"coordinates\":[1,2],\n\"coordinates\":[1,2]}", 2, "duplicate field `coordinates`"),
        ("{\"type\":\"Polygon\",\"coordinates\":[[1,2],\n[3,4]]}", 2, "3 arrays deep, and these 2"),
        ("{\"type\":\"Polygon\",\"coordinates\":[[[1,2]],\n[3,4]]}", 2, "nested differently"),
        ("{\"type\":\"LineString\",\"coordinates\":[[1,2],\n[]]}", 2, "two numbers"),
        ("{\"type\":\"MultiPolygon\",\"coordinates\":[[[[[1,2]]]]]}", 1, "nested too deep"),
        (
            "{\"type\":\"FeatureCollection\",\"features\":[\n{\"type\":\"Point\",\"coordinates\":[1,2]}]}",
            2,
            "must be of the type Feature",
        ),
        ("{\"type\":\"FeatureCollection\",\"features\":[\nnull]}", 2, "a feature"),
        (
            "{\"type\":\"Feature\",\"geometry\":\n{\"type\":\"Feature\",\"geometry\":null}}",
            2,
            "'Feature' is no type of GeoJSON that may stand here",
        ),
        (
            "{\"type\":\"Feature\",\"geometry\":null,\"properties\":\n7}",
            2,
            "an object of properties",
        ),
    ]);
}

/// An error must point into the file, or at what is no figure.
fn check_place(error: &Error, bytes: &[u8]) {
    let lines = bytes.iter().filter(|&&b| b == b'\n' || b == b'\r').count() as u64 + 1;
    match (error.status(), error.element()) {
        (Status::Format, Some((ElementKind::Line, line))) => {
            assert!((1..=lines).contains(&line), "{error}")
        }
        (
            Status::Format
            | Status::TooFewPoints
            | Status::InvalidArgument
            | Status::Degenerate
            | Status::CoordinateRange,
            _,
        ) => {}
        _ => panic!("{error}"),
    }
    assert!(error.message().len() < 600, "{error}");
}

#[test]
fn a_file_cut_short_anywhere_is_an_error_of_its_last_line() {
    assert!(read(SAMPLE.as_bytes()).is_ok());
    for end in 1..SAMPLE.len() {
        let error = read(&SAMPLE.as_bytes()[..end]).unwrap_err();
        assert_eq!(error.status(), Status::Format, "{error}");
        check_place(&error, &SAMPLE.as_bytes()[..end]);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, ..ProptestConfig::default() })]

    #[test]
    fn changed_bytes_are_an_error_or_sound(
        changes in prop::collection::vec((any::<prop::sample::Index>(), prop_oneof![any::<u8>(), b'0'..b'9', Just(b'['), Just(b',')]), 1..4),
    ) {
        let mut bytes = SAMPLE.as_bytes().to_vec();
        for (place, byte) in changes {
            let place = place.index(bytes.len());
            bytes[place] = byte;
        }
        match read(&bytes) {
            Ok(figure) => crate::drawing::check(&figure),
            Err(error) => check_place(&error, &bytes),
        }
    }
}

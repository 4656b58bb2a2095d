//! GeoJSON of every kind, read.

use crate::drawing::{ACCEPT, chain, check};
use medax::figure::{ChainKind, FigureOptions};
use medax::io::{
    FeatureChoice, Format, ReadFigureOptions, parse, parse_figure, read_figure, read_points,
};
use medax::points::PointsOptions;
use medax::{ElementKind, Error, Figure, Job, JobOptions, Status};

fn read(text: &str) -> Result<Figure, Error> {
    parse_figure(text.as_bytes(), &ReadFigureOptions::default(), &Job::default())
}

fn choose(text: &str, feature: FeatureChoice) -> Result<Figure, Error> {
    let options = ReadFigureOptions { feature, figure: FigureOptions::default() };
    parse_figure(text.as_bytes(), &options, &Job::default())
}

/// Parts, chains by kind, circles.
fn counts(figure: &Figure) -> (usize, [usize; 4], usize) {
    use ChainKind::*;
    let kinds = [Outer, Hole, Polyline, Point].map(|kind| figure.chain_count(kind));
    (figure.part_count(), kinds, figure.circles().len())
}

#[test]
fn every_geometry_is_read() {
    let cases = [
        (r#"{"type":"Point","coordinates":[1,2]}"#, (1, [0, 0, 0, 1], 0)),
        (r#"{"type":"MultiPoint","coordinates":[[1,2,7],[1.5,-2e0]]}"#, (2, [0, 0, 0, 2], 0)),
        (r#"{"coordinates":[[1,2],[3,4],[5,7]],"type":"LineString"}"#, (1, [0, 0, 1, 0], 0)),
        (
            r#"{"type":"MultiLineString","coordinates":[[[1,2],[3,4]],[[0,0],[0,1],[1,1]]]}"#,
            (2, [0, 0, 2, 0], 0),
        ),
        (
            r#"{"type":"Polygon","coordinates":[[[0,0],[9,0],[0,9],[0,0]],[[1,1],[2,1],[1,2],[1,1]]]}"#,
            (1, [1, 1, 0, 0], 0),
        ),
        (
            r#"{"type":"MultiPolygon","coordinates":[[[[0,0],[9,0],[0,9]]],
                [[[10,10],[20,10],[20,20]],[[15,11],[19,11],[19,14]]]]}"#,
            (2, [2, 1, 0, 0], 0),
        ),
        (
            r#"{"type":"GeometryCollection","geometries":[
                {"type":"Point","coordinates":[1,2]},
                {"type":"GeometryCollection","geometries":[{"type":"LineString","coordinates":[[5,5],[6,6]]}]}]}"#,
            (2, [0, 0, 1, 1], 0),
        ),
        (
            r#"{"type":"Feature","geometry":{"type":"Point","coordinates":[1,2]},"properties":{"radius":2}}"#,
            (1, [0; 4], 1),
        ),
        (
            r#"{"type":"Feature","properties":{"radius":0},"geometry":{"type":"Point","coordinates":[1,2]}}"#,
            (1, [0, 0, 0, 1], 0),
        ),
        (
            r#"{"type":"Feature","properties":{"radius":"2"},"geometry":{"type":"Point","coordinates":[1,2]}}"#,
            (1, [0, 0, 0, 1], 0),
        ),
        (
            r#"{"bbox":[0,0,1,1],"type":"FeatureCollection","crs":{"coordinates":[{"x":null}]},"features":[
                {"type":"Feature","id":7,"properties":null,"geometry":null},
                {"type":"Feature","properties":{"deep":{"radius":[1]}},"geometry":{"type":"Point","coordinates":[1,2]}},
                {"type":"Feature","properties":{"radius":0.5},
                 "geometry":{"type":"MultiPoint","coordinates":[[5,5],[8,8]]}}]}"#,
            (3, [0, 0, 0, 1], 2),
        ),
        // Empty coordinates are nothing.
        (
            r#"{"type":"GeometryCollection","geometries":[
                {"type":"Polygon","coordinates":[]},{"type":"MultiPolygon","coordinates":[[]]},
                {"type":"LineString","coordinates":[]},{"type":"MultiPoint","coordinates":[]},
                {"type":"MultiLineString","coordinates":[]},{"type":"Point","coordinates":[3,3]}]}"#,
            (1, [0, 0, 0, 1], 0),
        ),
    ];
    for (text, expected) in cases {
        for bom in ["", "\u{feff}"] {
            let figure = read(&format!("{bom}{text}")).unwrap_or_else(|e| panic!("{text}: {e}"));
            check(&figure);
            assert_eq!(counts(&figure), expected, "{text}");
        }
    }
}

#[test]
fn positions_come_through_to_the_bit() {
    let figure = read(
        r#"{"type":"MultiPoint","coordinates":[[0.1,-1.7976931348623157e50],[9007199254740993,5e-40],
            [12345678901234567890123,2.2250738585072011e-20],[-0,-0.0],[0e5,0.30000000000000004]]}"#,
    );
    let expected = [
        [0.1, -1.7976931348623157e50],
        [9007199254740992.0, 5e-40],
        [12345678901234567890123.0, 2.225_073_858_507_201e-20],
        [0.0, 0.0],
        [0.0, 0.30000000000000004],
    ];
    let bits =
        |points: &[[f64; 2]]| points.as_flattened().iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(figure.unwrap().vertices()), bits(&expected));
}

#[test]
fn a_feature_is_chosen_by_name_or_number() {
    let text = r#"{"type":"FeatureCollection","features":[
        {"type":"Feature","id":"first","properties":{"name":"a"},"geometry":{"type":"Point","coordinates":[0,0]}},
        {"type":"Feature","geometry":{"type":"Point","coordinates":[1,0]},"properties":{"NAME":"b"}},
        {"type":"Feature","properties":{"glyph":"c","radius":3},"geometry":{"type":"Point","coordinates":[2,0]}},
        {"type":"Feature","properties":{"id":4},"geometry":{"type":"Point","coordinates":[3,0]}},
        {"type":"Feature","properties":{"name":"a"},"geometry":{"type":"LineString","coordinates":[[4,0],[5,0]]}},
        {"type":"Feature","properties":{"name":"p"},"geometry":
          {"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1]]]}}]}"#;
    let named = |name: &str| choose(text, FeatureChoice::Named(name.to_string()));
    for (name, expected) in [
        ("a", (2, [0, 0, 1, 1], 0)),
        ("first", (1, [0, 0, 0, 1], 0)),
        ("b", (1, [0, 0, 0, 1], 0)),
        ("c", (1, [0; 4], 1)),
        ("4", (1, [0, 0, 0, 1], 0)),
        ("p", (1, [1, 0, 0, 0], 0)),
    ] {
        assert_eq!(counts(&named(name).unwrap()), expected, "{name}");
    }
    assert_eq!(chain(&named("b").unwrap(), 0), [[1.0, 0.0]]);
    let third = choose(text, FeatureChoice::Numbered(3)).unwrap();
    assert_eq!(chain(&third, 0), [[3.0, 0.0]]);
    for (choice, says) in [
        (
            FeatureChoice::Named("d".into()),
            "named 'd'; it has 6, counted from 0: first, b, c, 4, a, p",
        ),
        (FeatureChoice::Numbered(6), "number 6"),
    ] {
        let error = choose(text, choice).unwrap_err();
        assert_eq!(error.status(), Status::InvalidArgument);
        assert!(error.message().contains(says), "{error}");
    }
    // A geometry alone is number 0.
    let alone = r#"{"type":"Point","coordinates":[1,2]}"#;
    assert!(choose(alone, FeatureChoice::Numbered(0)).is_ok());
    assert!(choose(alone, FeatureChoice::Numbered(1)).is_err());
    let feature = r#"{"type":"Feature","properties":{"name":"x"},"geometry":{"type":"Point","coordinates":[1,2]}}"#;
    assert!(choose(feature, FeatureChoice::Named("x".into())).is_ok());
}

#[test]
fn what_is_no_figure_is_said_of_the_ring() {
    let bow = r#"{"type":"Polygon","coordinates":[[[0,0],[4,4],[4,0],[0,4],[0,0]]]}"#;
    let error = read(bow).unwrap_err();
    assert_eq!(error.element(), Some((medax::ElementKind::Ring, 0)), "{error}");
    let options = ReadFigureOptions { figure: ACCEPT, ..ReadFigureOptions::default() };
    let figure = parse_figure(bow.as_bytes(), &options, &Job::default()).unwrap();
    assert_eq!(figure.normalised().crossings, 1);
    let error = read(r#"{"type":"FeatureCollection","features":[]}"#).unwrap_err();
    assert_eq!(error.status(), Status::TooFewPoints, "{error}");
}

#[test]
fn a_figure_is_neither_points_nor_a_complex() {
    let text = r#"{"type":"Point","coordinates":[1,2]}"#;
    let error = parse(text.as_bytes(), Format::GeoJson, &Job::default()).unwrap_err();
    assert_eq!(error.status(), Status::Unsupported);
    assert!(error.message().contains("read it as a figure"), "{error}");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.geojson");
    std::fs::write(&path, text).unwrap();
    let job = Job::default();
    let error = read_points(&path, PointsOptions::default(), &job).unwrap_err();
    assert_eq!(error.status(), Status::Unsupported);
    let options = ReadFigureOptions::default();
    assert_eq!(read_figure(&path, &options, &job).unwrap(), read(text).unwrap());
    let error = read_figure(folder.path().join("a.ply"), &options, &job).unwrap_err();
    assert_eq!(error.status(), Status::Unsupported, "{error}");
    let error = read_figure(folder.path().join("b.geojson"), &options, &job).unwrap_err();
    assert_eq!(error.status(), Status::Io, "{error}");
}

#[test]
fn reading_counts_its_memory_and_stops() {
    let positions: Vec<String> = (0..50_000).map(|i| format!("[{i},{}]", i % 7)).collect();
    let text = format!(r#"{{"type":"LineString","coordinates":[{}]}}"#, positions.join(","));
    let options = ReadFigureOptions::default();
    let figure = parse_figure(text.as_bytes(), &options, &Job::default()).unwrap();
    assert_eq!(figure.vertices().len(), 50_000);
    let job = Job::new(JobOptions { memory_ceiling: 200_000, ..JobOptions::default() });
    let error = parse_figure(text.as_bytes(), &options, &job).unwrap_err();
    assert_eq!(error.status(), Status::OutOfMemory);
    // Cancelled from the progress callback, on the way through a text that is passed over.
    let long =
        format!(r#"{{"x":"{}","type":"Point","coordinates":[1,2]}}"#, "x".repeat(30_000_000));
    let progress = Some(Box::new(|progress: f64, _| progress < 0.05) as medax::Progress);
    let job = Job::new(JobOptions { progress, ..JobOptions::default() });
    let error = parse_figure(long.as_bytes(), &options, &job).unwrap_err();
    assert_eq!(error.status(), Status::Cancelled);
}

#[test]
fn errors_name_the_feature_where_there_are_several() {
    let feature = |properties: &str, kind: &str, coordinates: &str| {
        format!(
            r#"{{"type":"Feature","properties":{properties},"geometry":{{"type":"{kind}","coordinates":{coordinates}}}}}"#
        )
    };
    let ring = "[[[0,0],[4,0],[0,4]]]";
    let line = "[[20,0],[21,0]]";
    let sound = [
        feature(r#"{"name":"a"}"#, "Polygon", ring),
        feature("null", "LineString", line),
        feature(r#"{"id":7}"#, "Point", "[30,0]"),
        feature(r#"{"radius":1}"#, "Point", "[40,0]"),
    ];
    let said = |wrong: &str, feature: &FeatureChoice| {
        let features =
            sound.iter().map(String::as_str).chain([wrong]).collect::<Vec<_>>().join(",");
        let text = format!(r#"{{"type":"FeatureCollection","features":[{features}]}}"#);
        let options = ReadFigureOptions { feature: feature.clone(), ..Default::default() };
        let error = parse_figure(text.as_bytes(), &options, &Job::default()).unwrap_err();
        (error.message().to_string(), error.element().unwrap())
    };
    for (wrong, begins, element) in [
        (
            feature(r#"{"name":"b"}"#, "Polygon", "[[[50,0],[54,0],[58,0]]]"),
            "feature 4 'b': a ring has no area",
            (ElementKind::Ring, 1),
        ),
        (
            feature("null", "MultiLineString", "[[[50,0],[51,0]],[[60,0],[60,0]]]"),
            "feature 4: a polyline needs",
            (ElementKind::Polyline, 2),
        ),
        (feature("null", "Point", "[50,1e100]"), "feature 4: ", (ElementKind::Row, 1)),
        (
            feature(r#"{"radius":1,"name":"c"}"#, "Point", "[41.5,0]"),
            "feature 3: circle 0",
            (ElementKind::Circle, 0),
        ),
    ] {
        let (message, at) = said(&wrong, &FeatureChoice::All);
        assert!(message.starts_with(begins), "{message}");
        assert_eq!(at, element, "{message}");
    }
    // Elements are counted over the chosen features, these over the file.
    let wrong = feature(r#"{"name":"b"}"#, "Polygon", "[[[50,0],[54,0],[58,0]]]");
    let (message, at) = said(&wrong, &FeatureChoice::Named("b".into()));
    assert!(message.starts_with("feature 4 'b': "), "{message}");
    assert_eq!(at, (ElementKind::Ring, 0));
}

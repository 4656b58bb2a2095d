//! Plane complexes written as GeoJSON, and read back.

use crate::drawing::{ACCEPT, chain, check};
use medax::complex::{Attribute, ComplexParts, Element, Rows, Values};
use medax::figure::ChainKind;
use medax::io::{ReadFigureOptions, WriteOptions, read_figure, write_complex};
use medax::{Complex, Figure, Job, Status};
use serde_json::{Value, json};

/// The text, the warnings, and the figure that it reads back as.
fn written(complex: &Complex) -> (Value, Vec<String>, Figure) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.geojson");
    let job = Job::default();
    let warnings = write_complex(&path, complex, WriteOptions::default(), &job).unwrap();
    let options = ReadFigureOptions { figure: ACCEPT, ..ReadFigureOptions::default() };
    let figure = read_figure(&path, &options, &job).unwrap();
    check(&figure);
    (serde_json::from_slice(&std::fs::read(&path).unwrap()).unwrap(), warnings, figure)
}

fn plane(vertices: &[[f64; 2]]) -> ComplexParts {
    let vertices = vertices.iter().map(|&[x, y]| [x, y, 0.0]).collect();
    ComplexParts { dimension: 2, vertices, ..ComplexParts::default() }
}

#[test]
fn edges_are_joined_between_what_is_no_joint() {
    // A star of three arms at 0, of two edges, one, and a loop; a cycle apart; a point alone; a clockwise face.
    let places: Vec<[f64; 2]> =
        (0..15).map(|i| [f64::from(i) + 0.1, f64::from(i * i) / 3.0]).collect();
    let mut parts = plane(&places);
    parts.edges = vec![[2, 1], [0, 1], [3, 0], [4, 5], [5, 0], [0, 4], [7, 6], [7, 8], [6, 8]];
    parts.faces = Rows::new(vec![0, 3], vec![10, 13, 11]).unwrap();
    let radius: Vec<f64> = (0..15).map(|i| 0.1 + f64::from(i)).collect();
    let normal = (0..30).map(f64::from).collect();
    parts.attributes = vec![
        Attribute::new("radius", Element::Vertex, 1, Values::F64(radius)).unwrap(),
        Attribute::new("a \"b\"", Element::Vertex, 2, Values::F64(normal)).unwrap(),
        Attribute::new("source", Element::Edge, 1, Values::U32((100..109).collect())).unwrap(),
        Attribute::new("radius", Element::Edge, 1, Values::U32(vec![0; 9])).unwrap(),
        Attribute::new("label", Element::Face, 1, Values::U32(vec![medax::NONE])).unwrap(),
        Attribute::new("angle", Element::Face, 1, Values::F64(vec![f64::NAN])).unwrap(),
    ];
    let complex = Complex::new(parts).unwrap();
    let (text, warnings, figure) = written(&complex);
    assert_eq!(warnings, ["the edge attribute 'radius' was left out: its name is taken"]);
    let features = text["features"].as_array().unwrap();
    let line = |i: usize| {
        let found = chain(&figure, figure.chain_count(ChainKind::Outer) + i);
        let vertex = |p| places.iter().position(|q| q == p).unwrap();
        found.iter().map(vertex).collect::<Vec<_>>()
    };
    assert_eq!(line(0), [2, 1, 0]);
    assert_eq!(line(1), [3, 0]);
    assert_eq!(line(2), [0, 4, 5, 0]);
    assert_eq!(line(3), [7, 6, 8, 7]);
    assert_eq!(figure.chain_count(ChainKind::Polyline), 4);
    // Counterclockwise, with its values along.
    assert_eq!(chain(&figure, 0), [places[10], places[11], places[13]]);
    assert_eq!(figure.normalised().turned_rings, 0);
    let face = &features[0]["properties"];
    assert_eq!(face["radius"], json!([10.1, 11.1, 13.1]));
    assert_eq!((&face["label"], &face["angle"]), (&Value::Null, &Value::Null));
    let first = &features[1]["properties"];
    assert_eq!(first["radius"], json!([2.1, 1.1, 0.1]));
    assert_eq!(first["a \"b\""], json!([[4.0, 5.0], [2.0, 3.0], [0.0, 1.0]]));
    assert_eq!(first["source"], json!([100, 101]));
    // Alone, vertices with a radius are circles.
    let single: Vec<_> = features.iter().filter(|f| f["geometry"]["type"] == "Point").collect();
    assert_eq!((single.len(), figure.circles().len()), (3, 3));
    assert_eq!(single[0]["properties"]["radius"], json!(9.1));
    assert_eq!(figure.circles()[0], [places[9][0], places[9][1], 9.1]);
    assert_eq!(features.len(), 1 + 4 + 3);
}

#[test]
fn edges_are_joined_within_an_arc_only() {
    let places: Vec<[f64; 2]> = (0..6).map(|i| [f64::from(i), f64::from(i % 2)]).collect();
    let mut parts = plane(&places);
    parts.edges = vec![[0, 1], [1, 2], [2, 3], [4, 3], [4, 5]];
    let arcs = Values::U32(vec![7, 7, 9, 9, 7]);
    parts.attributes = vec![Attribute::new("arc", Element::Edge, 1, arcs).unwrap()];
    let (text, warnings, figure) = written(&Complex::new(parts).unwrap());
    assert!(warnings.is_empty(), "{warnings:?}");
    let lengths: Vec<usize> = figure.chains().iter().map(<[u32]>::len).collect();
    assert_eq!(lengths, [3, 3, 2]);
    let arcs: Vec<&Value> =
        text["features"].as_array().unwrap().iter().map(|f| &f["properties"]["arc"]).collect();
    assert_eq!(arcs, [&json!(7), &json!(9), &json!(7)]);
}

#[test]
fn what_is_written_reads_back_to_the_same_bits() {
    let mut state = 3u64;
    let mut random = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let mantissa = (state >> 11) as f64 / 9_007_199_254_740_992.0;
        (mantissa - 0.5) * 2f64.powi((state % 300) as i32 - 130)
    };
    let places: Vec<[f64; 2]> = (0..1000).map(|_| [random(), random()]).collect();
    let points = Complex::new(plane(&places)).unwrap();
    let bits = |places: &[[f64; 2]]| -> Vec<u64> {
        places.as_flattened().iter().map(|x| x.to_bits()).collect()
    };
    let (_, _, figure) = written(&points);
    assert_eq!(bits(figure.vertices()), bits(&places));
    let mut parts = plane(&places);
    parts.edges = (0..500).map(|i| [2 * i, 2 * i + 1]).collect();
    let (_, _, figure) = written(&Complex::new(parts).unwrap());
    assert_eq!(bits(figure.vertices()), bits(&places));
}

#[test]
fn a_complex_in_space_is_not_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.geojson");
    let mut parts = plane(&[[0.0, 0.0], [1.0, 0.0]]);
    parts.dimension = 3;
    let complex = Complex::new(parts).unwrap();
    let error =
        write_complex(&path, &complex, WriteOptions::default(), &Job::default()).unwrap_err();
    assert_eq!(error.status(), Status::Unsupported);
    assert!(!path.exists());
    // An empty one has no feature.
    let complex = Complex::new(plane(&[])).unwrap();
    write_complex(&path, &complex, WriteOptions::default(), &Job::default()).unwrap();
    let text: Value = serde_json::from_slice(&std::fs::read(&path).unwrap()).unwrap();
    assert_eq!(text, json!({"type": "FeatureCollection", "features": []}));
}

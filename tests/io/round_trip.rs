//! What is written reads back to the same bits, and what is left out is said.

use crate::samples::{self, Sample};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use medax::complex::{Attribute, CellType, Complex, ComplexParts, Element, Rows, Values};
use medax::io::{
    Format, WriteOptions, parse, read, read_complex, read_points, write_complex, write_points,
};
use medax::points::{Points, PointsOptions};
use medax::{Job, Status};
use proptest::prelude::*;

fn rows(faces: &[&[u32]]) -> Rows {
    let mut rows = Rows::default();
    faces.iter().for_each(|face| rows.push(face).unwrap());
    rows
}

fn attribute(name: &str, element: Element, width: usize, values: Values) -> Attribute {
    Attribute::new(name, element, width, values).unwrap()
}

/// Numbers whose digits are hard to write: the least, the greatest, halves of the last bit.
const HARD: [f64; 18] = [
    0.1,
    1.0 / 3.0,
    -0.0,
    5e-324,
    f64::MIN_POSITIVE,
    f64::MAX,
    f64::MIN,
    1e22,
    1e23,
    123_456_789.123_456_79,
    -2.225073858507201e-308,
    9007199254740993.0,
    0.3,
    1e-7,
    4.35,
    2.5e-5,
    1.7976931348623157e308,
    -1e16,
];

/// Polygons, a loose edge, and attributes of every kind but those of volume cells.
fn parts() -> ComplexParts {
    ComplexParts {
        dimension: 3,
        vertices: HARD.chunks(3).map(|v| [v[0], v[1], v[2]]).collect(),
        faces: rows(&[&[0, 1, 2], &[2, 1, 3, 4], &[4, 3, 1, 0, 2]]),
        edges: vec![[5, 0], [1, 5]],
        attributes: vec![
            attribute("radius", Element::Vertex, 1, Values::F64(HARD[..6].to_vec())),
            attribute("normal", Element::Vertex, 3, Values::F64(HARD.to_vec())),
            attribute(
                "label",
                Element::Vertex,
                1,
                Values::U32((0..6).map(|i| u32::MAX - i).collect()),
            ),
            attribute("source edge", Element::Face, 2, Values::U32(vec![1, 2, 3, 4, 5, u32::MAX])),
            attribute("object_angle", Element::Face, 1, Values::F64(vec![0.1, f64::NAN, -0.0])),
            attribute("label", Element::Edge, 1, Values::U32(vec![7, 8])),
            attribute("ends", Element::Edge, 2, Values::F64(vec![0.1, 0.2, 0.3, 0.4])),
        ],
        ..ComplexParts::default()
    }
}

fn bits(values: &Values) -> Vec<u64> {
    match values {
        Values::F64(values) => values.iter().map(|x| x.to_bits()).collect(),
        Values::U32(values) => values.iter().map(|&x| u64::from(x)).collect(),
    }
}

/// Checks that both hold the same elements, in the same order and to the last bit.
fn check_elements(a: &Complex, b: &Complex) {
    let bits = |c: &Complex| -> Vec<[u64; 3]> {
        c.vertices().iter().map(|v| v.map(f64::to_bits)).collect()
    };
    assert_eq!(bits(a), bits(b));
    assert_eq!(a.faces(), b.faces());
    assert_eq!(a.edges(), b.edges());
}

/// Checks that both have the same attributes, under names that PLY can hold.
fn check_attributes(a: &Complex, b: &Complex) {
    assert_eq!(a.attributes().len(), b.attributes().len());
    for attribute in a.attributes() {
        let name = attribute.name().replace(' ', "_");
        let twin = b.attribute(attribute.element(), &name).unwrap_or_else(|| panic!("no {name}"));
        assert_eq!(attribute.width(), twin.width(), "{name}");
        assert_eq!(
            std::mem::discriminant(attribute.values()),
            std::mem::discriminant(twin.values()),
            "{name}"
        );
        assert_eq!(self::bits(attribute.values()), self::bits(twin.values()), "{name}");
    }
}

/// Writes and reads back, and returns the warnings, too.
fn round_trip(complex: &Complex, name: &str, options: WriteOptions) -> (Complex, Vec<String>) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    let warnings = write_complex(&path, complex, options, &Job::default()).unwrap();
    (read_complex(&path, &Job::default()).unwrap(), warnings)
}

#[test]
fn ply_holds_all_but_volume_cells() {
    let complex = Complex::new(parts()).unwrap();
    for text in [false, true] {
        let (back, warnings) = round_trip(&complex, "a.ply", WriteOptions { text });
        check_elements(&complex, &back);
        check_attributes(&complex, &back);
        assert_eq!(warnings, ["attribute 'source edge' was written as 'source_edge'"]);
    }
}

#[test]
fn ply_holds_the_radius_as_quality_too() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.ply");
    let complex = Complex::new(parts()).unwrap();
    write_complex(&path, &complex, WriteOptions { text: true }, &Job::default()).unwrap();
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(
        text.contains("property double radius\n") && text.contains("property double quality\n")
    );
    let first = text.split("end_header\n").nth(1).unwrap().lines().next().unwrap();
    let words: Vec<&str> = first.split(' ').collect();
    assert_eq!((words[3], words[words.len() - 1]), ("0.1", "0.1"), "{first}");
    // A quality of its own is kept, and not overwritten.
    let mut parts = parts();
    let quality = Values::F64(vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    parts.attributes.push(attribute("quality", Element::Vertex, 1, quality));
    let complex = Complex::new(parts).unwrap();
    check_attributes(&complex, &round_trip(&complex, "a.ply", WriteOptions::default()).0);
}

#[test]
fn ply_says_which_attributes_have_no_name_left() {
    let mut parts = parts();
    for (name, element, rows) in [
        ("x", Element::Vertex, 6),
        ("", Element::Vertex, 6),
        ("radius", Element::Vertex, 6),
        ("source_edge", Element::Face, 6),
        ("vertex1", Element::Edge, 2),
    ] {
        let width = if rows == 6 && element == Element::Face { 2 } else { 1 };
        parts.attributes.push(attribute(name, element, width, Values::U32(vec![0; rows])));
    }
    let complex = Complex::new(parts).unwrap();
    let (back, warnings) = round_trip(&complex, "a.ply", WriteOptions::default());
    check_attributes(&Complex::new(self::parts()).unwrap(), &back);
    for name in ["x", "", "radius", "source_edge", "vertex1"] {
        let left_out = format!("attribute '{name}' was left out: its PLY name is taken");
        assert!(warnings.contains(&left_out), "{warnings:?}");
    }
}

#[test]
fn ply_faces_may_have_more_than_255_corners() {
    let corners: Vec<u32> = (0..300).collect();
    let complex = Complex::new(ComplexParts {
        vertices: corners.iter().map(|&v| [f64::from(v), f64::from(v * v), 0.0]).collect(),
        faces: rows(&[&corners, &[0, 1, 2]]),
        ..ComplexParts::default()
    })
    .unwrap();
    for text in [false, true] {
        check_elements(&complex, &round_trip(&complex, "a.ply", WriteOptions { text }).0);
    }
}

#[test]
fn off_and_obj_hold_polygons_and_obj_loose_edges() {
    let complex = Complex::new(parts()).unwrap();
    let (back, warnings) = round_trip(&complex, "a.obj", WriteOptions::default());
    check_elements(&complex, &back);
    assert_eq!(warnings.len(), 7, "{warnings:?}");
    assert_eq!(warnings[0], "OBJ has no place for the vertex attribute 'radius': it was left out");

    let (back, warnings) = round_trip(&complex, "a.off", WriteOptions::default());
    let without_edges = ComplexParts { edges: Vec::new(), attributes: Vec::new(), ..parts() };
    check_elements(&Complex::new(without_edges).unwrap(), &back);
    assert_eq!(warnings.len(), 6, "{warnings:?}");
    assert_eq!(warnings[0], "OFF holds no loose edges: 2 were left out");
}

#[test]
fn ma_holds_triangles_edges_and_radii() {
    let mut parts = parts();
    parts.attributes.truncate(1);
    parts.faces = rows(&[&[0, 1, 2], &[2, 1, 3]]);
    let complex = Complex::new(parts).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.ma");
    let warnings =
        write_complex(&path, &complex, WriteOptions::default(), &Job::default()).unwrap();
    assert_eq!(warnings, Vec::<String>::new());
    // All edges are listed, the sides of the faces among them, and those become sides again.
    assert!(std::fs::read_to_string(&path).unwrap().starts_with("6 7 2\n"));
    assert_eq!(read(&path, &Job::default()).unwrap().edges().len(), 7);
    let back = read_complex(&path, &Job::default()).unwrap();
    check_elements(&complex, &back);
    check_attributes(&complex, &back);

    let complex = Complex::new(self::parts()).unwrap();
    let (back, warnings) = round_trip(&complex, "a.ma", WriteOptions::default());
    assert_eq!(back.faces().len(), complex.triangles().len());
    assert_eq!(warnings.last().unwrap(), "MA holds triangles only: 2 polygons were cut up");
    let bare = Complex::new(ComplexParts { attributes: Vec::new(), ..self::parts() }).unwrap();
    let error = write_complex(&path, &bare, WriteOptions::default(), &Job::default()).unwrap_err();
    assert_eq!(error.status(), Status::Unsupported);
}

#[test]
fn what_is_empty_reads_back_and_gives_no_points() {
    let radius = attribute("radius", Element::Vertex, 1, Values::F64(Vec::new()));
    let empty = ComplexParts { attributes: vec![radius], ..ComplexParts::default() };
    let empty = Complex::new(empty).unwrap();
    for name in ["a.ply", "a.off", "a.obj", "a.xyz", "a.pts", "a.txt", "a.csv", "a.ma"] {
        for text in [false, true] {
            let (back, _) = round_trip(&empty, name, WriteOptions { text });
            check_elements(&empty, &back);
        }
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(name);
        write_complex(&path, &empty, WriteOptions::default(), &Job::default()).unwrap();
        let error = read_points(&path, PointsOptions::default(), &Job::default()).unwrap_err();
        let expected = (Status::TooFewPoints, "the file holds no point");
        assert_eq!((error.status(), error.message()), expected, "{name}");
    }
}

#[test]
fn stl_holds_triangles_in_single_precision() {
    let vertices =
        vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.5], [0.0, 0.1, 0.0], [9.0; 3]];
    let parts = ComplexParts {
        vertices: vertices.clone(),
        faces: rows(&[&[0, 1, 2, 3]]),
        edges: vec![[0, 4]],
        ..ComplexParts::default()
    };
    let complex = Complex::new(parts).unwrap();
    let (back, warnings) = round_trip(&complex, "a.stl", WriteOptions::default());
    assert_eq!(back.triangles(), [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(back.vertices()[..3], vertices[..3]);
    assert_eq!(back.vertices()[3][1], f64::from(0.1f32));
    assert_eq!(
        warnings,
        [
            "STL holds no loose edges: 1 were left out",
            "STL holds triangles only: 1 polygons were cut up",
            "STL holds faces only: 1 vertices without one were left out",
            "STL has single precision: 1 vertices were rounded",
        ]
    );
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.stl");
    for (xyz, status) in [(1e39, Status::CoordinateRange), (f64::MAX, Status::CoordinateRange)] {
        let mut vertices = vertices.clone();
        vertices[1][0] = xyz;
        let faces = rows(&[&[0, 1, 2]]);
        let far = ComplexParts { vertices, faces, ..ComplexParts::default() };
        let far = Complex::new(far).unwrap();
        let error =
            write_complex(&path, &far, WriteOptions::default(), &Job::default()).unwrap_err();
        assert_eq!(error.status(), status);
    }
}

#[test]
fn stl_normals_point_where_the_corners_turn() {
    let complex = Complex::new(ComplexParts {
        vertices: vec![
            [0.0; 3],
            [3e30, 0.0, 0.0],
            [0.0, 4e30, 0.0],
            [1e-30, 0.0, 0.0],
            [2.0, 0.0, 0.0],
        ],
        faces: rows(&[&[0, 1, 2], &[2, 1, 0], &[0, 3, 4]]),
        ..ComplexParts::default()
    })
    .unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.stl");
    write_complex(&path, &complex, WriteOptions::default(), &Job::default()).unwrap();
    let bytes = std::fs::read(&path).unwrap();
    let float = |at: usize| f32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    let normal = |facet: usize| [0, 4, 8].map(|k| float(84 + 50 * facet + k));
    assert_eq!([normal(0), normal(1), normal(2)], [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [0.0; 3]]);
}

#[test]
fn tables_hold_points() {
    let complex = Complex::new(parts()).unwrap();
    for (name, first) in [("a.xyz", "0.1 0.3333333333333333 -0.0"), ("a.csv", "x,y,z")] {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(name);
        let warnings =
            write_complex(&path, &complex, WriteOptions::default(), &Job::default()).unwrap();
        assert_eq!(warnings.len(), 5, "{warnings:?}");
        assert_eq!(std::fs::read_to_string(&path).unwrap().lines().next(), Some(first));
        let back = read_complex(&path, &Job::default()).unwrap();
        let vertices = complex.vertices().to_vec();
        let points = ComplexParts { vertices, ..ComplexParts::default() };
        check_elements(&Complex::new(points).unwrap(), &back);
    }
}

#[test]
fn points_are_written_in_vertex_order_to_every_format_that_holds_points() {
    let job = Job::default();
    let rows = [[0.1, 0.2, 0.3], [1.0, 1.0, 1.0], [0.1, 0.2, 0.3], [-1e-9, 7.0, 1e9]];
    let points = Points::new(&rows, PointsOptions::default(), &job).unwrap();
    let folder = tempfile::tempdir().unwrap();
    for name in ["a.ply", "a.off", "a.obj", "a.xyz", "a.pts", "a.txt", "a.csv"] {
        let path = folder.path().join(name);
        let warnings = write_points(&path, &points, WriteOptions::default(), &job).unwrap();
        assert_eq!(warnings, Vec::<String>::new(), "{name}");
        assert_eq!(read(&path, &job).unwrap().vertices(), points.coords(), "{name}");
    }
    for name in ["a.stl", "a.ma", "a.pwn"] {
        let path = folder.path().join(name);
        let error = write_points(&path, &points, WriteOptions::default(), &job).unwrap_err();
        assert_eq!(error.status(), Status::Unsupported, "{name}");
        assert!(!path.exists(), "{name}");
    }
}

/// The array of this name, as bytes.
fn vtu_array(xml: &str, name: &str, ty: &str) -> Vec<u8> {
    let tag = format!("<DataArray type=\"{ty}\" Name=\"{name}\" ");
    let array = xml.split(&tag).nth(1).unwrap_or_else(|| panic!("no {name}"));
    let text = array.split(['>', '<']).nth(1).unwrap();
    let bytes = STANDARD.decode(text).unwrap();
    assert_eq!(u64::from_le_bytes(bytes[..8].try_into().unwrap()) as usize, bytes.len() - 8);
    bytes[8..].to_vec()
}

#[test]
fn vtu_holds_everything() {
    let mut parts = parts();
    parts.cells = rows(&[&[0, 1, 2, 3], &[0, 1, 2, 3, 4], &[0, 1, 2, 3, 4, 5]]);
    parts.cell_types = vec![CellType::Tetrahedron, CellType::Pyramid, CellType::PolygonalPyramid];
    parts.attributes.push(attribute("label", Element::Cell, 1, Values::U32(vec![1, 2, 3])));
    parts.attributes.push(attribute("label", Element::Face, 1, Values::F64(vec![1.5, 2.5, 3.5])));
    parts.attributes.push(attribute("a<\"b&", Element::Cell, 1, Values::F64(vec![1.0, 2.0, 3.0])));
    let complex = Complex::new(parts).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.vtu");
    let warnings =
        write_complex(&path, &complex, WriteOptions::default(), &Job::default()).unwrap();
    assert_eq!(warnings, Vec::<String>::new());
    let file = std::fs::read_to_string(&path).unwrap();
    let f64s = |name: &str| -> Vec<u64> {
        let bytes = vtu_array(&file, name, "Float64");
        bytes.chunks_exact(8).map(|b| u64::from_le_bytes(b.try_into().unwrap())).collect()
    };
    let u32s = |name: &str| -> Vec<u32> {
        let bytes = vtu_array(&file, name, "UInt32");
        bytes.chunks_exact(4).map(|b| u32::from_le_bytes(b.try_into().unwrap())).collect()
    };
    let i64s = |name: &str| -> Vec<i64> {
        let bytes = vtu_array(&file, name, "Int64");
        bytes.chunks_exact(8).map(|b| i64::from_le_bytes(b.try_into().unwrap())).collect()
    };
    let hard: Vec<u64> = HARD.iter().map(|x| x.to_bits()).collect();
    assert_eq!(f64s("Points"), hard);
    assert_eq!(f64s("normal"), hard);
    assert_eq!(f64s("radius"), hard[..6]);
    // Two edges, a triangle, a quadrilateral, a pentagon, a tetrahedron and two pyramids.
    assert_eq!(vtu_array(&file, "types", "UInt8"), [3, 3, 5, 9, 7, 10, 14, 42]);
    assert_eq!(i64s("offsets"), [2, 4, 7, 11, 16, 20, 25, 31]);
    assert_eq!(i64s("connectivity")[..7], [5, 0, 1, 5, 0, 1, 2]);
    assert_eq!(
        i64s("faces"),
        [6, 5, 4, 3, 2, 1, 0, 3, 0, 1, 5, 3, 1, 2, 5, 3, 2, 3, 5, 3, 3, 4, 5, 3, 4, 0, 5]
    );
    assert_eq!(i64s("faceoffsets"), [-1, -1, -1, -1, -1, -1, -1, 27]);
    // Labels of edges and cells share an array; that of the faces is of another type.
    let none = u32::MAX;
    let cell_data = file.split("<CellData>").nth(1).unwrap();
    assert!(cell_data.contains("Name=\"label_\""), "{cell_data}");
    let labels = vtu_array(cell_data, "label", "UInt32");
    let expected: Vec<u8> =
        [7, 8, none, none, none, 1, 2, 3].iter().flat_map(|x| x.to_le_bytes()).collect();
    assert_eq!(labels, expected);
    assert_eq!(f64s("a&lt;&quot;b&amp;").len(), 8);
    let pairs = u32s("source edge");
    assert_eq!(pairs, [&[none; 4][..], &[1, 2, 3, 4, 5, none], &[none; 6]].concat());
}

#[test]
fn the_samples_hold_these_values() {
    let job = Job::default();
    for encoding in ["ascii", "binary_little_endian", "binary_big_endian"] {
        let soup = parse(&samples::ply(encoding), Format::Ply, &job).unwrap();
        // Single precision is widened exactly.
        assert_eq!(
            soup.vertices()[..3],
            [[0.5, -3.0, 0.25], [f64::from(1e10f32), 4.0, -0.5], [f64::from(-0.1f32), 5.0, 0.1],]
        );
        assert!(soup.vertices()[3][0].is_nan());
        assert_eq!(soup.faces().indices(), [0, 1, 2, 3, 2, 1]);
        assert_eq!(soup.edges(), [[0, 3]]);
        let names: Vec<(&str, Element, Values)> =
            soup.attributes().iter().map(|a| (a.name(), a.element(), a.values().clone())).collect();
        assert_eq!(
            names,
            [
                ("red", Element::Vertex, Values::U32(vec![1, 2, 3, 255])),
                ("radius", Element::Vertex, Values::F64(vec![1.0, 2.0, 3.0, 4.0])),
                ("angle", Element::Face, Values::F64(vec![0.75, -1.0])),
            ]
        );
    }
    let faces = |bytes: &[u8], format| {
        let soup = parse(bytes, format, &job).unwrap();
        (soup.vertices().to_vec(), soup.faces().indices().to_vec(), soup.edges().to_vec())
    };
    let (vertices, corners, _) = faces(samples::OFF, Format::Off);
    assert_eq!(vertices, [[0.0; 3], [1.5, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1e-3]]);
    assert_eq!(corners, [0, 1, 2, 3, 0, 2, 1]);
    let (vertices, corners, edges) = faces(samples::OBJ, Format::Obj);
    assert_eq!(vertices[2..], [[1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    assert_eq!(corners, [0, 1, 2, 2, 1, 0, 0, 1, 2, 4, 0, 1, 3]);
    assert_eq!(edges, [[3, 4], [4, 0]]);
    let stl = [&samples::stl(b"solid", &samples::QUAD)[..], samples::STL_TEXT];
    for (bytes, last) in stl.into_iter().zip([f64::from(0.1f32), 0.1]) {
        let (vertices, corners, _) = faces(bytes, Format::Stl);
        assert_eq!(vertices, [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.5], [0.0, 1.0, last]]);
        assert_eq!(corners, [0, 1, 2, 0, 2, 3]);
    }
    let (vertices, corners, edges) = faces(samples::MA, Format::Ma);
    assert_eq!(vertices[3], [0.0, 0.0, 1.0]);
    assert_eq!((corners, edges), (vec![0, 1, 2], vec![[0, 1], [2, 3]]));
    let pwn = parse(b"2\n0 0 0\n1 2 3\n0 0 1\n0 1 0\n", Format::Pwn, &job).unwrap();
    assert_eq!(pwn.attributes()[0].values(), &Values::F64(vec![0.0, 0.0, 1.0, 0.0, 1.0, 0.0]));
    assert_eq!((pwn.attributes()[0].name(), pwn.attributes()[0].width()), ("normal", 3));
    let noff = parse(b"NOFF 1 0\n0 0 0 0 0.5 1\n", Format::Off, &job).unwrap();
    assert_eq!(noff.attributes()[0].values(), &Values::F64(vec![0.0, 0.5, 1.0]));
}

#[test]
fn counts_may_be_glued_to_the_keyword_of_off() {
    let soup =
        parse(b"OFF3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2", Format::Off, &Job::default()).unwrap();
    assert_eq!((soup.vertices().len(), soup.faces().len()), (3, 1));
}

#[test]
fn line_ends_of_every_system_are_read() {
    for Sample { name, format, bytes, counts, .. } in samples::all() {
        let Ok(text) = String::from_utf8(bytes) else { continue };
        if text.contains('\0') || text.contains('\r') {
            continue;
        }
        for end in ["\r\n", "\r"] {
            let other = text.replace('\n', end);
            let soup = parse(other.as_bytes(), format, &Job::default()).unwrap();
            let found = [soup.vertices().len(), soup.faces().len(), soup.edges().len()];
            assert_eq!(found, counts, "{name} with {end:?}");
        }
    }
    // Behind a header whose lines end with CR, an LF is data.
    for end in ["\n", "\r\n", "\r"] {
        let header = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\n\
                      property uchar y\nproperty uchar z\nend_header\n";
        let mut bytes = header.replace('\n', end).into_bytes();
        bytes.extend([10, 13, 10]);
        let soup = parse(&bytes, Format::Ply, &Job::default()).unwrap();
        assert_eq!(soup.vertices(), [[10.0, 13.0, 10.0]], "{end:?}");
    }
}

#[test]
fn facets_with_equal_corners_are_left_out_and_counted() {
    let [first, second] = samples::QUAD;
    let flat = [first[0], first[1], first[0]];
    let soup =
        parse(&samples::stl(b"", &[flat, first, second]), Format::Stl, &Job::default()).unwrap();
    assert_eq!(soup.faces().len(), 2);
    assert_eq!(soup.warnings(), ["1 facets with equal corners were left out"]);
}

#[test]
fn edges_that_are_sides_are_no_loose_edges() {
    let text = "ply\nformat ascii 1.0\nelement vertex 4\nproperty int x\nproperty int y\nproperty int z\n\
                element face 1\nproperty list int int vertex_indices\n\
                element edge 5\nproperty int vertex1\nproperty int vertex2\nproperty uint a_0\nproperty uint a_1\n\
                end_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n1 0 1 2\n3 0 3 4\n0 2 5 6\n2 3 7 8\n1 0 9 9\n";
    let complex =
        parse(text.as_bytes(), Format::Ply, &Job::default()).unwrap().into_complex().unwrap();
    assert_eq!(complex.edges(), [[3, 0], [2, 3]]);
    let values = complex.attribute(Element::Edge, "a").unwrap().values();
    assert_eq!(values, &Values::U32(vec![3, 4, 7, 8]));
}

prop_compose! {
    fn complexes()(vertices in prop::collection::vec(prop::array::uniform3(finite()), 4..40))(
        faces in prop::collection::vec(ring(vertices.len()), 0..30),
        edges in prop::collection::vec(ring(vertices.len()), 0..10),
        vertices in Just(vertices),
    ) -> Complex {
        let mut rows = Rows::default();
        faces.iter().for_each(|face| rows.push(face).unwrap());
        let sides: Vec<[u32; 2]> = faces
            .iter()
            .flat_map(|f| (0..f.len()).map(|k| [f[k], f[(k + 1) % f.len()]]))
            .collect();
        let loose = edges.iter().map(|e| [e[0], e[1]]);
        let loose = loose.filter(|&[a, b]| !sides.contains(&[a, b]) && !sides.contains(&[b, a]));
        let edges = loose.collect();
        Complex::new(ComplexParts { vertices, faces: rows, edges, ..ComplexParts::default() }).unwrap()
    }
}

fn finite() -> impl Strategy<Value = f64> {
    any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite())
}

/// Three to six different vertices.
fn ring(count: usize) -> impl Strategy<Value = Vec<u32>> {
    let all: Vec<u32> = (0..count as u32).collect();
    prop::sample::subsequence(all, 3..=count.min(6)).prop_shuffle()
}

proptest! {
    #[test]
    fn any_complex_comes_back_bit_by_bit(complex in complexes()) {
        for (name, text) in [("a.ply", false), ("a.ply", true), ("a.obj", false)] {
            let (back, warnings) = round_trip(&complex, name, WriteOptions { text });
            prop_assert_eq!(warnings, Vec::<String>::new());
            check_elements(&complex, &back);
        }
    }
}

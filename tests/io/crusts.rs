//! Surfaces and shapes of power crusts in every format that is written.

use medax::complex::{Attribute, Complex, Element, FlattenOptions, Values};
use medax::io::{WriteOptions, read, read_complex, write_complex};
use medax::sample::{SampleOptions, Shape, sample};
use medax::{Job, Points, PowerCrust, Status};
use std::sync::Arc;

fn crust() -> PowerCrust {
    let job = Job::default();
    let options = SampleOptions { spacing: 0.15, ..SampleOptions::default() };
    let samples = sample(Shape::Bracket, options, &job).unwrap();
    let points = Points::new(samples.points(), Default::default(), &job).unwrap();
    PowerCrust::build(&Arc::new(points), Default::default(), &job).unwrap()
}

/// The complex that comes back, and the warnings.
fn round_trip(complex: &Complex, name: &str, text: bool) -> (Complex, Vec<String>) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    let warnings = write_complex(&path, complex, WriteOptions { text }, &Job::default()).unwrap();
    (read_complex(&path, &Job::default()).unwrap(), warnings)
}

/// The attributes of vertices, loose edges and faces, which are those that a file may hold.
fn held(complex: &Complex) -> Vec<&Attribute> {
    let of_cell = |a: &&Attribute| a.element() == Element::Cell;
    complex.attributes().iter().filter(|a| !of_cell(a)).collect()
}

/// The whole shape, and that without tetrahedra.
fn shapes(crust: &PowerCrust) -> [Complex; 4] {
    let all = FlattenOptions { flatness: f64::INFINITY };
    let flat = |shape: &Complex| shape.flatten(all, &Job::default()).unwrap().complex;
    let both = crust.both_shapes().unwrap();
    [flat(crust.inner_shape()), flat(&both), crust.inner_shape().as_ref().clone(), both]
}

#[test]
fn ply_holds_shapes_but_for_their_tetrahedra() {
    for shape in shapes(&crust()) {
        for text in [false, true] {
            let (back, warnings) = round_trip(&shape, "a.ply", text);
            assert_eq!(back.vertices(), shape.vertices());
            assert_eq!((back.faces(), back.edges()), (shape.faces(), shape.edges()));
            assert_eq!(held(&back), held(&shape));
            let cells = shape.cells().len();
            match cells {
                0 => assert_eq!(warnings, Vec::<String>::new()),
                _ => assert_eq!(
                    warnings,
                    [format!("PLY holds no volume cells: {cells} were left out")]
                ),
            }
            let names: Vec<&str> = held(&back).iter().map(|a| a.name()).collect();
            assert_eq!(names, ["radius", "pole", "label", "object_angle"]);
        }
    }
}

#[test]
fn ma_gives_the_shape_back() {
    for shape in shapes(&crust()) {
        let (back, warnings) = round_trip(&shape, "a.ma", false);
        assert_eq!(back.vertices(), shape.vertices());
        assert_eq!((back.faces(), back.edges()), (shape.faces(), shape.edges()));
        assert_eq!(back.attributes(), &shape.attributes()[..1]);
        let of =
            |name| format!("MA has no place for the vertex attribute '{name}': it was left out");
        let mut expected: Vec<String> = ["pole", "label", "object_angle"].map(of).to_vec();
        if !shape.cells().is_empty() {
            let cells = shape.cells().len();
            expected.insert(0, format!("MA holds no volume cells: {cells} were left out"));
        }
        assert_eq!(warnings, expected);
    }
}

#[test]
fn off_obj_and_stl_hold_triangles() {
    for shape in shapes(&crust()) {
        let (obj, _) = round_trip(&shape, "a.obj", false);
        assert_eq!(obj.vertices(), shape.vertices());
        assert_eq!((obj.faces(), obj.edges()), (shape.faces(), shape.edges()));
        let (off, _) = round_trip(&shape, "a.off", false);
        assert_eq!((off.vertices(), off.faces()), (shape.vertices(), shape.faces()));
        let (stl, warnings) = round_trip(&shape, "a.stl", false);
        assert_eq!(stl.faces().len(), shape.faces().len());
        for (a, b) in stl.triangles().iter().zip(shape.triangles()) {
            let [a, b] = [(&stl, a), (&shape, b)].map(|(c, t)| t.map(|v| c.vertices()[v as usize]));
            assert_eq!(a, b.map(|p| p.map(|x| f64::from(x as f32))));
        }
        assert!(warnings.iter().any(|w| w.contains("'object_angle'")), "{warnings:?}");
    }
}

#[test]
fn vtu_holds_shapes_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.vtu");
    for shape in shapes(&crust()) {
        let written = write_complex(&path, &shape, WriteOptions::default(), &Job::default());
        assert_eq!(written.unwrap(), Vec::<String>::new());
        let text = std::fs::read_to_string(&path).unwrap();
        let all = shape.edges().len() + shape.faces().len() + shape.cells().len();
        assert!(text.contains(&format!("NumberOfCells=\"{all}\"")));
        for name in ["radius", "pole", "label", "object_angle"] {
            assert_eq!(text.matches(&format!("Name=\"{name}\"")).count(), 1, "{name}");
        }
        // Without tetrahedra there is nothing to tell of them.
        let flatness = usize::from(!shape.cells().is_empty());
        assert_eq!(text.matches("Name=\"flatness\"").count(), flatness);
    }
}

#[test]
fn surfaces_go_where_there_is_room_for_them() {
    let crust = crust();
    let surface = crust.surface();
    for text in [false, true] {
        let (back, warnings) = round_trip(surface, "a.ply", text);
        assert_eq!(warnings, Vec::<String>::new());
        assert_eq!((back.vertices(), back.faces()), (surface.vertices(), surface.faces()));
        assert_eq!(held(&back), held(surface));
        let sample = back.attribute(Element::Vertex, "sample").unwrap();
        assert!(matches!(sample.values(), Values::U32(_)));
    }
    for name in ["a.off", "a.obj"] {
        let (back, _) = round_trip(surface, name, false);
        assert_eq!((back.vertices(), back.faces()), (surface.vertices(), surface.faces()));
    }
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, complex: &Complex| {
        let path = folder.path().join(name);
        write_complex(path, complex, WriteOptions::default(), &Job::default())
    };
    // No radius, no faces.
    let refused = write("a.ma", surface).unwrap_err();
    assert_eq!(refused.status(), Status::Unsupported);
    assert!(refused.message().contains("'radius'"), "{refused}");
    let poles = crust.poles_to_complex().unwrap();
    assert_eq!(write("a.stl", &poles).unwrap_err().status(), Status::Unsupported);
    write("balls.ma", &poles).unwrap();
    let soup = read(folder.path().join("balls.ma"), &Job::default()).unwrap();
    assert_eq!(soup.vertices(), poles.vertices());
}

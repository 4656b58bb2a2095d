//! Labelled triangulations: by a mesh, by a power crust and by hand.

use crate::medial::{dual_of, labels_of, samples, torus_mesh};
use crate::sets::Random;
use medax::crust::Label;
use medax::sample::Shape;
use medax::{Complex, ElementKind, Job, Labels, PowerCrust, Status};
use std::sync::Arc;

/// The share of the volume of all cells that the labels put elsewhere.
fn volume_of_disagreement(a: &Labels, b: &Labels) -> f64 {
    let t = a.triangulation();
    let volume = |cell: usize| {
        let [a, b, c, d] = t.cells()[cell].map(|v| t.coords()[v as usize]);
        let [b, c, d] = [b, c, d].map(|x| [0, 1, 2].map(|k| x[k] - a[k]));
        let n = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
        (0..3).map(|k| n[k] * d[k]).sum::<f64>() / 6.0
    };
    let cells = 0..t.cells().len();
    let all: f64 = cells.clone().map(volume).sum();
    let differ = cells.filter(|&cell| a.is_inner()[cell] != b.is_inner()[cell]);
    differ.map(volume).sum::<f64>() / all
}

#[test]
fn a_mesh_a_crust_and_the_shape_agree_on_a_dense_torus() {
    let job = Job::default();
    let mesh = torus_mesh([120, 48]);
    let dual = dual_of(mesh.vertices(), &job);
    let t = dual.triangulation();
    let by_mesh = Labels::of_mesh(&dual, &mesh, &job).unwrap();
    let crust = PowerCrust::build(t.points(), Default::default(), &job).unwrap();
    let by_crust = Labels::of_crust(&dual, &crust, &job).unwrap();
    let by_hand = labels_of(Shape::Torus, &dual);
    let cells = t.cells().len();
    for (name, a, b) in [
        ("mesh and crust", &by_mesh, &by_crust),
        ("mesh and shape", &by_mesh, &*by_hand),
        ("crust and shape", &by_crust, &*by_hand),
    ] {
        let differ = a.disagreement(b).unwrap();
        let brute = a.is_inner().iter().zip(b.is_inner()).filter(|(a, b)| a != b).count();
        assert_eq!((differ, b.disagreement(a).unwrap()), (brute, brute));
        let volume = volume_of_disagreement(a, b);
        println!("{name}: {differ} of {cells} cells, {volume:.1e} of the volume");
        // Cells that hug the surface are thin.
        assert!(100 * differ < 8 * cells && volume < 2e-3, "{name}: {differ} of {cells}");
        assert_eq!(a.disagreement(a).unwrap(), 0);
    }
    for labels in [&by_mesh, &by_crust, &by_hand] {
        let count = labels.is_inner().iter().filter(|&&inner| inner).count();
        assert_eq!(labels.inner_count(), count);
        assert!(3 * count > cells && 6 * count < 5 * cells, "{count} of {cells}");
        assert!(Arc::ptr_eq(labels.triangulation(), t));
    }
    // A cell whose Voronoi vertex is far from the surface has the label of it, whoever gave it.
    let mut deep = 0;
    for (cell, &middle) in dual.centers().iter().enumerate() {
        if Shape::Torus.value(middle).abs() > 0.05 {
            deep += 1;
            let [a, b, c] = [&by_mesh, &by_crust, &*by_hand].map(|labels| labels.is_inner()[cell]);
            assert!(a == b && b == c, "{middle:?}");
        }
    }
    assert!(8 * deep > cells, "{deep}");
}

/// Unevenly, so that some poles have very many neighbours.
#[test]
fn a_crust_labels_a_cell_by_the_pole_of_least_power() {
    let job = Job::default();
    let mut random = Random(7);
    let torus = |[a, b]: [f64; 2]| {
        let ring = 1.0 + 0.4 * b.cos();
        [ring * a.cos(), ring * a.sin(), 0.4 * b.sin()]
    };
    let rows: Vec<_> =
        (0..1500).map(|_| torus([0; 2].map(|_| std::f64::consts::TAU * random.unit()))).collect();
    let dual = dual_of(&rows, &job);
    let points = dual.triangulation().points();
    let crust = PowerCrust::build(points, Default::default(), &job).unwrap();
    let labels = Labels::of_crust(&dual, &crust, &job).unwrap();
    let regular = crust.regular();
    let mut decided = [0, 0];
    for (at, &is_inner) in dual.centers().iter().zip(labels.is_inner()) {
        let mut least = [f64::INFINITY; 2];
        for vertex in 0..regular.coords().len() as u32 {
            let pole = regular.row_of_vertex()[vertex as usize] as usize;
            let side = usize::from(crust.labels()[pole] == Label::Inner);
            let [x, y, z, weight] = regular.site(vertex);
            let square: f64 = [x, y, z].iter().zip(at).map(|(p, q)| (p - q) * (p - q)).sum();
            least[side] = least[side].min(square - weight);
        }
        // Rounded powers tell no more.
        let size: f64 = 10.0 + at.iter().map(|x| x * x).sum::<f64>();
        if (least[0] - least[1]).abs() > 1e-14 * size {
            assert_eq!(is_inner, least[1] < least[0], "{at:?}");
            decided[usize::from(is_inner)] += 1;
        }
    }
    assert!(decided[0] > 5000 && decided[1] > 5000, "{decided:?}");
    assert!(decided[0] + decided[1] > labels.is_inner().len() * 99 / 100, "{decided:?}");
}

#[test]
fn a_mesh_that_is_turned_inside_out_labels_nothing() {
    let job = Job::default();
    let mesh = torus_mesh([40, 16]);
    let dual = dual_of(mesh.vertices(), &job);
    let mut faces = medax::complex::Rows::default();
    for face in mesh.faces().iter() {
        faces.push(&face.iter().rev().copied().collect::<Vec<_>>()).unwrap();
    }
    let parts = medax::complex::ComplexParts {
        vertices: mesh.vertices().to_vec(),
        faces,
        ..Default::default()
    };
    let turned = Complex::new(parts).unwrap();
    assert_eq!(Labels::of_mesh(&dual, &turned, &job).unwrap().inner_count(), 0);
    assert!(Labels::of_mesh(&dual, &mesh, &job).unwrap().inner_count() > 0);
}

#[test]
fn bad_input_is_an_error_that_says_where() {
    let job = Job::default();
    let dual = dual_of(&samples(Shape::Torus, 0.2), &job);
    let t = dual.triangulation();
    let cells = t.cells().len();
    for count in [0, cells - 1, cells + 1] {
        let error = Labels::new(t, vec![true; count]).unwrap_err();
        let element = Some((ElementKind::Cell, count as u64));
        assert_eq!((error.status(), error.element()), (Status::Mismatch, element));
    }
    let other = dual_of(&samples(Shape::Box, 0.2), &job);
    let [a, b] = [labels_of(Shape::Torus, &dual), labels_of(Shape::Torus, &other)];
    assert_eq!(a.disagreement(&b).unwrap_err().status(), Status::Mismatch);
    let crust =
        PowerCrust::build(other.triangulation().points(), Default::default(), &job).unwrap();
    let error = Labels::of_crust(&dual, &crust, &job).unwrap_err();
    assert_eq!(error.status(), Status::Mismatch);
    let error = Labels::of_mesh(&dual, &Complex::default(), &job).unwrap_err();
    assert_eq!(error.status(), Status::InvalidArgument);
    let spent = Job::default();
    spent.cancel();
    let error = Labels::of_crust(&other, &crust, &spent).unwrap_err();
    assert_eq!(error.status(), Status::Cancelled);
    // Those of an equal triangulation are as good.
    let again = dual_of(&samples(Shape::Torus, 0.2), &job);
    assert_eq!(a.disagreement(&labels_of(Shape::Torus, &again)).unwrap(), 0);
}

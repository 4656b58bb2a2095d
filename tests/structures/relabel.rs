//! Power crusts with other labels: those that a host gives, and those that a mesh tells.

use crate::sets::{self, Random};
use medax::complex::{ComplexParts, Rows};
use medax::crust::{Label, LabelRule, PowerCrustOptions, SimplifyOptions};
use medax::sample::{SampleOptions, Shape, sample, sample_mesh};
use medax::{Complex, Job, JobOptions, Points, PowerCrust, Status};
use std::sync::Arc;

fn crust(rows: &[[f64; 3]], options: PowerCrustOptions) -> PowerCrust {
    let points = Arc::new(Points::new(rows, Default::default(), &Job::default()).unwrap());
    PowerCrust::build(&points, options, &Job::default()).unwrap()
}

/// The power crust of samples of a mesh.
fn sampled(mesh: &Complex, spacing: f64) -> PowerCrust {
    let options = SampleOptions { spacing, ..Default::default() };
    crust(sample_mesh(mesh, options, &Job::default()).unwrap().points(), Default::default())
}

fn assert_valid(crust: &PowerCrust, name: &str) {
    let report = crust.validate(&Job::default()).unwrap();
    assert!(report.is_valid(), "{name}: {report:?}");
}

/// Components and genus of the surface, which must be closed.
fn form(crust: &PowerCrust) -> (u64, Option<u64>) {
    let topology = crust.surface().topology(&Job::default()).unwrap();
    assert!(topology.closed);
    (topology.components, topology.genus)
}

/// Vertices and squares.
type Mesh = (Vec<[f64; 3]>, Vec<[u32; 4]>);

/// A sphere, from a cube's faces cut into n x n squares; pointing in if `inward`.
fn sphere(radius: f64, n: u32, inward: bool) -> Mesh {
    let (vertices, faces) = block([1.0; 3], n, inward);
    let onto = |p: [f64; 3]| {
        let length = p.iter().map(|x| x * x).sum::<f64>().sqrt();
        p.map(|x| radius * x / length)
    };
    (vertices.into_iter().map(onto).collect(), faces)
}

/// A box of this half size, each side cut into n x n squares with vertices of its own.
fn block(half: [f64; 3], n: u32, inward: bool) -> Mesh {
    let (mut vertices, mut faces) = (Vec::new(), Vec::new());
    for k in 0..3 {
        for side in [-1.0, 1.0] {
            let first = vertices.len() as u32;
            for (i, j) in (0..=n).flat_map(|i| (0..=n).map(move |j| (i, j))) {
                let at = |i: u32| 2.0 * f64::from(i) / f64::from(n) - 1.0;
                let mut p = [side; 3];
                (p[(k + 1) % 3], p[(k + 2) % 3]) = (at(i), at(j));
                vertices.push([0, 1, 2].map(|axis| half[axis] * p[axis]));
            }
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
                let a = first + i * (n + 1) + j;
                let mut face = [a, a + n + 1, a + n + 2, a + 1];
                if (side < 0.0) != inward {
                    face.reverse();
                }
                faces.push(face);
            }
        }
    }
    (vertices, faces)
}

fn complex(parts: &[Mesh]) -> Complex {
    let (mut vertices, mut rows) = (Vec::new(), Rows::default());
    for (own, faces) in parts {
        let shift = vertices.len() as u32;
        vertices.extend(own);
        faces.iter().for_each(|face| rows.push(&face.map(|v| v + shift)).unwrap());
    }
    Complex::new(ComplexParts { vertices, faces: rows, ..Default::default() }).unwrap()
}

/// Checks that the labels are those of a function that is positive outside, wherever that says so clearly.
fn assert_labels(crust: &PowerCrust, slack: f64, outside: impl Fn([f64; 3]) -> f64) {
    for (pole, &[x, y, z, _]) in crust.poles().balls().iter().enumerate() {
        let (far, label) = (outside([x, y, z]), crust.labels()[pole]);
        if far.abs() > slack {
            let expected = if far > 0.0 { Label::Outer } else { Label::Inner };
            assert_eq!(label, expected, "pole {pole} at {:?}", [x, y, z]);
        }
    }
}

fn length(p: [f64; 3]) -> f64 {
    p.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[test]
fn its_own_labels_change_nothing() {
    for round_poles in [false, true] {
        let options = PowerCrustOptions { round_poles, ..Default::default() };
        for set in sets::all(300) {
            let points =
                Arc::new(Points::new(&set.rows, Default::default(), &Job::default()).unwrap());
            let Ok(before) = PowerCrust::build(&points, options, &Job::default()) else { continue };
            let after = before.with_labels(before.labels(), &Job::default()).unwrap();
            assert_eq!(after.surface(), before.surface(), "{}", set.name);
            assert_eq!(after.inner_shape(), before.inner_shape(), "{}", set.name);
            assert_eq!(after.outer_shape(), before.outer_shape(), "{}", set.name);
            assert_eq!((after.forced_count(), after.unreached_count()), (0, 0));
            assert!(Arc::ptr_eq(after.poles(), before.poles()));
            assert!(Arc::ptr_eq(after.regular(), before.regular()));
            assert_eq!(after.options(), before.options());
        }
    }
}

#[test]
fn any_labels_give_a_closed_surface() {
    let mut random = Random(4);
    for set in sets::all(200) {
        let points = Arc::new(Points::new(&set.rows, Default::default(), &Job::default()).unwrap());
        let built = PowerCrust::build(&points, Default::default(), &Job::default());
        let Ok(before) = built else { continue };
        for share in [0.0, 0.1, 0.5, 1.0] {
            let side = |_| if random.unit() < share { Label::Inner } else { Label::Outer };
            let labels: Vec<Label> = (0..before.labels().len()).map(side).collect();
            let crust = before.with_labels(&labels, &Job::default()).unwrap();
            assert_valid(&crust, set.name);
            let changed = crust.labels().iter().zip(&labels).filter(|(a, b)| a != b);
            assert_eq!(changed.count(), crust.forced_count(), "{} {share}", set.name);
            assert_eq!(crust.unreached_count(), 0);
            assert_eq!(crust.surface().faces().is_empty(), !crust.labels().contains(&Label::Inner));
            // Poles with unbounded cells are there, and all of them are asked to be inner.
            assert!(share < 1.0 || crust.forced_count() > 0);
        }
    }
}

#[test]
fn labels_that_are_too_few_or_too_many_are_refused() {
    let crust = sampled(&complex(&[sphere(1.0, 8, false)]), 0.3);
    for count in [0, crust.labels().len() - 1, crust.labels().len() + 1] {
        let labels = vec![Label::Inner; count];
        let error = crust.with_labels(&labels, &Job::default()).unwrap_err();
        assert_eq!(error.status(), Status::Mismatch);
        assert!(error.message().contains(&count.to_string()), "{}", error.message());
    }
    let bare = Complex::new(ComplexParts { vertices: vec![[0.0; 3]; 3], ..Default::default() });
    let error = crust.labelled_by_mesh(&bare.unwrap(), &Job::default()).unwrap_err();
    assert_eq!(error.status(), Status::InvalidArgument);
    let job = Job::default();
    job.cancel();
    let error = crust.with_labels(crust.labels(), &job).unwrap_err();
    assert_eq!(error.status(), Status::Cancelled);
}

#[test]
fn a_void_is_outside_where_its_faces_say_so() {
    let shells = complex(&[sphere(1.0, 24, false), sphere(0.5, 16, true)]);
    let crust = sampled(&shells, 0.1);
    let labelled = crust.labelled_by_mesh(&shells, &Job::default()).unwrap();
    assert_valid(&labelled, "void");
    assert_eq!(form(&labelled), (2, Some(0)));
    // Chords of the mesh are 0.005 off the sphere.
    assert_labels(&labelled, 0.01, |p| (length(p) - 1.0).max(0.5 - length(p)));
    // With both shells pointing out there is no void, and no surface between.
    let full = complex(&[sphere(1.0, 24, false), sphere(0.5, 16, false)]);
    let full = crust.labelled_by_mesh(&full, &Job::default()).unwrap();
    assert_valid(&full, "full");
    assert_eq!(form(&full), (1, Some(0)));
    assert_labels(&full, 0.01, |p| length(p) - 1.0);
    // Turned inside out, or elsewhere, it holds no pole.
    let inside_out = complex(&[sphere(1.0, 24, true), sphere(0.5, 16, false)]);
    let (mut vertices, faces) = sphere(0.5, 4, false);
    vertices.iter_mut().for_each(|p| p[0] += 3.0);
    let elsewhere = complex(&[(vertices, faces)]);
    let apart = crust.labelled_by_mesh(&elsewhere, &Job::default()).unwrap();
    assert_valid(&apart, "elsewhere");
    assert!(apart.surface().vertices().len() < 100);
    let none = crust.labelled_by_mesh(&inside_out, &Job::default()).unwrap();
    assert_valid(&none, "inside out");
    assert!(!none.labels().contains(&Label::Inner) && none.surface().faces().is_empty());
}

/// The poles that are labelled otherwise than a function that is positive outside says.
fn wrong(crust: &PowerCrust, outside: impl Fn([f64; 3]) -> f64) -> usize {
    let pairs = crust.poles().balls().iter().zip(crust.labels());
    let is_wrong = |&(&[x, y, z, _], &label): &(&[f64; 4], &Label)| {
        let far = outside([x, y, z]);
        far.abs() > 0.01 && (far > 0.0) != (label == Label::Outer)
    };
    pairs.filter(is_wrong).count()
}

#[test]
fn a_mesh_tells_what_a_coarse_sample_does_not() {
    // On this knot tubes of radius 0.3 are sampled 0.25 apart: some samples have both poles outside.
    let job = Job::default();
    let take = |spacing| {
        let options = SampleOptions { spacing, ..Default::default() };
        sample(Shape::Trefoil, options, &job).unwrap()
    };
    let fine = crust(take(0.0).points(), Default::default());
    let outside = |p| Shape::Trefoil.value(p);
    assert_eq!((form(&fine), wrong(&fine, outside)), ((1, Some(1)), 0));
    let spread = PowerCrustOptions { label_rule: LabelRule::Spread, ..Default::default() };
    let coarse = crust(take(0.25).points(), spread);
    assert!(wrong(&coarse, outside) > 5 && form(&coarse) != (1, Some(1)));
    let labelled = coarse.labelled_by_mesh(fine.surface(), &job).unwrap();
    assert_valid(&labelled, "trefoil");
    assert_eq!((form(&labelled), wrong(&labelled, outside)), ((1, Some(1)), 0));
}

#[test]
fn labels_of_a_plate_are_where_its_poles_are() {
    let half = [1.0, 0.7, 0.1];
    let plate = complex(&[block(half, 4, false)]);
    let crust = sampled(&plate, 0.2);
    let outside = |[x, y, z]: [f64; 3]| {
        let off = [x.abs() - half[0], y.abs() - half[1], z.abs() - half[2]];
        off.into_iter().fold(f64::MIN, f64::max)
    };
    // The samples are as far apart as the plate is thick.
    assert!(wrong(&crust, outside) > 0);
    let labelled = crust.labelled_by_mesh(&plate, &Job::default()).unwrap();
    assert_valid(&labelled, "plate");
    assert_labels(&labelled, 1e-6, outside);
}

#[test]
fn variants_keep_the_labels() {
    let shells = complex(&[sphere(1.0, 24, false), sphere(0.5, 16, false)]);
    // The rule sees a void, the mesh none.
    let before = sampled(&shells, 0.1);
    let crust = before.labelled_by_mesh(&shells, &Job::default()).unwrap();
    let different = before.labels().iter().zip(crust.labels()).filter(|(a, b)| a != b).count();
    assert!(different > 100);
    let offset = crust.offset(0.1, &Job::default()).unwrap();
    let options = SimplifyOptions { epsilon: Some(0.05), delta: Some(0.01) };
    let simple = crust.simplify(options, &Job::default()).unwrap().crust;
    for (variant, name) in [(&offset, "offset"), (&*simple, "simplified")] {
        assert_valid(variant, name);
        assert_eq!(variant.labels(), crust.labels(), "{name}");
        assert_eq!((form(variant), variant.unreached_count()), ((1, Some(0)), 0), "{name}");
        // And back: the balls of the variant with the labels of the rule.
        let back = variant.with_labels(before.labels(), &Job::default()).unwrap();
        assert_valid(&back, name);
        assert_eq!(form(&back), (2, Some(0)), "{name}");
        assert!(Arc::ptr_eq(back.regular(), variant.regular()));
    }
}

#[test]
fn an_open_mesh_labels_as_if_it_were_closed() {
    let (vertices, mut faces) = sphere(1.0, 24, false);
    // A hole round the north pole, a quarter of the radius wide.
    faces.retain(|face| face.iter().any(|&v| vertices[v as usize][2] < 0.97));
    let open = complex(&[(vertices, faces)]);
    assert!(!open.topology(&Job::default()).unwrap().closed);
    let crust = sampled(&complex(&[sphere(1.0, 24, false)]), 0.1);
    let labelled = crust.labelled_by_mesh(&open, &Job::default()).unwrap();
    assert_valid(&labelled, "open");
    assert_eq!(form(&labelled), (1, Some(0)));
    assert_labels(&labelled, 0.1, |p| length(p) - 1.0);
}

#[test]
fn threads_change_no_label() {
    let shells = complex(&[sphere(1.0, 16, false), sphere(0.5, 12, true)]);
    let crust = sampled(&shells, 0.15);
    let by = |threads| {
        let job = Job::new(JobOptions { threads, ..JobOptions::default() });
        crust.labelled_by_mesh(&shells, &job).unwrap()
    };
    let one = by(1);
    for threads in [2, 3, 8] {
        let more = by(threads);
        assert_eq!((more.labels(), more.surface()), (one.labels(), one.surface()), "{threads}");
        assert_eq!(more.inner_shape(), one.inner_shape(), "{threads}");
    }
}

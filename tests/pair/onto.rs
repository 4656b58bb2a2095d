//! Pair-meshes of parts of the inner structure: medial axes, cores, as little as can be.

use crate::shapes::{Random, dual, dual_of, labels, mesh, sphere};
use medax::cocone::Cocone;
use medax::complex::{Attribute, ComplexParts, Element, Rows, Values};
use medax::flow::Flow;
use medax::medial::{MedialFilter, MedialRule};
use medax::pair::{PairOntoOptions, PairReason};
use medax::sample::{Shape, sample};
use medax::{Complex, ElementKind, Job, JobOptions, Labels, Medial, PairMesh, Points, Status};
use std::collections::BTreeSet;
use std::sync::Arc;

/// The pair-mesh of a built-in shape, and parts of its inner structure: MEDIAL, the core, the core extended by MEDIAL, nothing.
fn parts(shape: Shape) -> (PairMesh, Vec<(&'static str, Complex)>) {
    let job = Job::default();
    let samples = sample(shape, Default::default(), &job).unwrap();
    let dual = dual_of(Points::new(samples.points(), Default::default(), &job).unwrap());
    let cocone = Cocone::new(&dual, Default::default(), &job).unwrap();
    let labels = Arc::new(Labels::of_cocone(&cocone, &job).unwrap());
    let mesh = PairMesh::voronoi(&dual, &labels, &job).unwrap();
    let medial = Medial::new(&dual, Some(&labels), Default::default(), &job).unwrap();
    let filter = MedialFilter::default();
    let selected = medial.selected(&filter, &job).unwrap();
    let flow = Flow::new(&dual, &labels, Default::default(), &job).unwrap();
    let core = |facets: &[u32]| flow.core(Default::default(), facets, &job).unwrap().into_complex();
    let parts = vec![
        ("medial", medial.axis(&filter, &job).unwrap()),
        ("core", core(&[])),
        ("extended core", core(&selected)),
        ("nothing", Complex::new(ComplexParts::default()).unwrap()),
    ];
    (mesh, parts)
}

/// Vertices less edges plus faces of the inner structure.
fn euler(mesh: &PairMesh) -> i64 {
    let mut edges = BTreeSet::new();
    for ring in mesh.rings().iter() {
        for (&m, &n) in ring.iter().zip(ring.iter().cycle().skip(1)) {
            let [v, w] = [m, n].map(|node| mesh.nodes()[node as usize][1]);
            if v != w {
                edges.insert([v.min(w), v.max(w)]);
            }
        }
    }
    let count = mesh.inner_vertices().len() + mesh.inner_faces().len();
    count as i64 - edges.len() as i64
}

fn check(name: &str, whole: &PairMesh, less: &PairMesh, genus: u64) {
    let job = Job::default();
    let report = less.validate(&job).unwrap();
    assert!(report.is_valid(), "{name}: {report:?}");
    assert_eq!(less.folded(&job).unwrap(), [0u32; 0], "{name}");
    let [pyramids, _, over] = less.counts();
    assert_eq!(pyramids, 2 * less.inner_faces().len(), "{name}");
    assert_eq!(euler(less), 1 - genus as i64, "{name}: the inner structure's topology");
    if less.boundary_vertices().len() == whole.boundary_vertices().len() {
        assert_eq!(over, whole.counts()[2], "{name}");
        assert_eq!(less.boundary_vertices(), whole.boundary_vertices(), "{name}");
        let volumes = [less.enclosed_volume(), whole.enclosed_volume()];
        assert!((volumes[0] - volumes[1]).abs() < 1e-12 * volumes[1], "{name}: {volumes:?}");
    }
    for t in [0.001, 0.3, 0.9] {
        let surface = less.iso_surface(t, &job).unwrap().topology(&job).unwrap();
        let is_right = surface.closed && surface.oriented && surface.genus == Some(genus);
        assert!(is_right, "{name} at {t}: {surface:?}");
    }
}

/// The faces of an inner structure that were asked for, by the places of their corners.
fn asked(mesh: &PairMesh) -> BTreeSet<Vec<[u64; 3]>> {
    let reason = |face: usize| mesh.reasons().get(face).copied().unwrap_or(PairReason::Asked);
    let faces = mesh.inner_faces().iter().enumerate();
    let asked = faces.filter(|&(face, _)| reason(face) == PairReason::Asked);
    let place = |&v: &u32| mesh.inner_vertices()[v as usize].map(f64::to_bits);
    asked
        .map(|(_, corners)| {
            let mut corners: Vec<_> = corners.iter().map(place).collect();
            corners.sort_unstable();
            corners
        })
        .collect()
}

#[test]
fn parts_of_built_in_shapes_have_pair_meshes_with_their_topology() {
    for shape in [Shape::Sphere, Shape::Torus, Shape::Capsule, Shape::Ellipsoid, Shape::Box] {
        let (whole, parts) = parts(shape);
        assert_eq!(euler(&whole), 1 - i64::from(shape.genus()), "{}", shape.name());
        for (name, part) in parts {
            let name = format!("{} of {}", name, shape.name());
            let less = whole.onto(&part, Default::default(), &Job::default()).unwrap();
            check(&name, &whole, &less, shape.genus().into());
            assert!(less.inner_faces().len() < whole.inner_faces().len(), "{name}");
            assert!(asked(&less).is_subset(&asked(&whole)), "{name}: asked faces stay as they are");
        }
    }
}

/// Hardly anything stays that was not asked for: of MEDIAL's facets of a torus less than one in fifty.
#[test]
fn what_was_not_asked_for_goes() {
    let (whole, parts) = parts(Shape::Torus);
    let job = Job::default();
    let [medial, _, _, nothing] =
        <[Complex; 4]>::try_from(parts.into_iter().map(|(_, part)| part).collect::<Vec<_>>())
            .unwrap();
    let less = whole.onto(&medial, Default::default(), &job).unwrap();
    let count = asked(&less).len();
    assert!(count > 2000, "{count}");
    assert!(less.inner_faces().len() - count < count / 50, "{}", less.inner_faces().len());
    let spine = whole.onto(&nothing, Default::default(), &job).unwrap();
    assert_eq!(spine.inner_faces().len(), 0, "a torus has a closed curve");
    assert!(spine.inner_vertices().len() < 40, "{}", spine.inner_vertices().len());
}

#[test]
fn all_of_the_inner_structure_stays_when_asked_for() {
    let job = Job::default();
    let points = sphere(60, &mut Random(5));
    let dual = dual(&points);
    let labels = Arc::new(labels(&dual, |_| true));
    let whole = PairMesh::voronoi(&dual, &labels, &job).unwrap();
    let medial = Medial::new(&dual, Some(&labels), Default::default(), &job).unwrap();
    let filter = MedialFilter { rule: MedialRule::Every, ..Default::default() };
    let axis = medial.axis(&filter, &job).unwrap();
    let options = PairOntoOptions { exact: true, ..Default::default() };
    let same = whole.onto(&axis, options, &job).unwrap();
    // Loose edges were not asked for.
    assert_eq!([same.counts()[0], same.counts()[2]], [whole.counts()[0], whole.counts()[2]]);
    assert_eq!(asked(&same), asked(&whole));
}

#[test]
fn what_is_to_be_exact_fails_with_the_first_face_that_stays() {
    let (whole, parts) = parts(Shape::Capsule);
    let options = PairOntoOptions { exact: true, ..Default::default() };
    let error = whole.onto(&parts[1].1, options, &Job::default()).unwrap_err();
    assert_eq!(error.status(), Status::Degenerate);
    assert!(error.to_string().contains("Voronoi facet between samples"), "{error}");
    assert!(matches!(error.element(), Some((ElementKind::Face, _))), "{error:?}");
}

#[test]
fn divided_triangles_let_more_go_and_keep_the_boundary() {
    let (whole, parts) = parts(Shape::Capsule);
    let job = Job::default();
    let options = PairOntoOptions { subdivide: true, ..Default::default() };
    let plain = whole.onto(&parts[0].1, Default::default(), &job).unwrap();
    let divided = whole.onto(&parts[0].1, options, &job).unwrap();
    check("divided", &whole, &divided, 0);
    assert!(divided.inner_faces().len() < plain.inner_faces().len());
    let count = whole.boundary_vertices().len();
    assert!(divided.boundary_vertices().len() > count);
    assert_eq!(divided.boundary_vertices()[..count], *whole.boundary_vertices());
    assert!(divided.sample_of_boundary()[count..].iter().all(|&sample| sample == medax::NONE));
    let volumes = [divided.enclosed_volume(), whole.enclosed_volume()];
    assert!((volumes[0] - volumes[1]).abs() < 1e-12 * volumes[1], "{volumes:?}");
}

/// Nothing is asked of the solid: random cells of random points, and of cospherical ones, with samples inside.
#[test]
fn any_solid_is_collapsed_and_stays_whole() {
    let nothing = Complex::new(ComplexParts::default()).unwrap();
    let job = Job::default();
    for seed in 1..40u64 {
        let mut random = Random(seed * 7919);
        let rows: Vec<[f64; 3]> = match seed % 3 {
            0 => (0..64).map(|i| [i % 4, i / 4 % 4, i / 16].map(f64::from)).collect(),
            1 => (0..60).map(|_| random.point()).collect(),
            _ => sphere(50, &mut random),
        };
        let coin = std::cell::RefCell::new(Random(seed + 1));
        let share = [0.3, 0.6, 0.9][seed as usize / 3 % 3];
        let whole = mesh(&rows, |_| coin.borrow_mut().unit() < share);
        for subdivide in [false, true] {
            let options = PairOntoOptions { subdivide, ..Default::default() };
            let less = whole.onto(&nothing, options, &job).unwrap();
            let report = less.validate(&job).unwrap();
            assert!(report.is_valid(), "seed {seed}: {report:?}");
            assert_eq!(euler(&less), euler(&whole), "seed {seed}");
            assert!(less.inner_vertices().len() <= whole.inner_vertices().len());
        }
    }
}

#[test]
fn places_and_half_faces_are_those_of_a_part() {
    let (whole, parts) = parts(Shape::Sphere);
    let job = Job::default();
    let less = whole.onto(&parts[0].1, Default::default(), &job).unwrap();
    let mut random = Random(11);
    let queries: Vec<[f64; 3]> =
        (0..500).map(|_| random.point().map(|x| (x - 0.5) * 1.1)).collect();
    let places = less.locate(&queries, &job).unwrap();
    let whole_places = whole.locate(&queries, &job).unwrap();
    for ((place, other), query) in places.iter().zip(&whole_places).zip(&queries) {
        assert_eq!(place.element == medax::NONE, other.element == medax::NONE);
        if place.element != medax::NONE {
            let back = less.position(place);
            let away = (0..3).map(|k| (back[k] - query[k]).abs()).fold(0.0, f64::max);
            assert!(away < 1e-9, "{away}");
        }
    }
    let half_faces = less.half_faces(&job).unwrap();
    for (face, &dual) in (0u32..).zip(&half_faces.dual) {
        assert!(dual == medax::NONE || half_faces.dual[dual as usize] == face);
    }
}

#[test]
fn complexes_without_samples_are_refused() {
    let (whole, _) = parts(Shape::Sphere);
    let triangle = || ComplexParts {
        vertices: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        faces: Rows::new(vec![0, 3], vec![0, 1, 2]).unwrap(),
        ..ComplexParts::default()
    };
    let none = Complex::new(triangle()).unwrap();
    let wide = Attribute::new("samples", Element::Face, 3, Values::U32(vec![0, 1, 2])).unwrap();
    let wide = Complex::new(ComplexParts { attributes: vec![wide], ..triangle() }).unwrap();
    let loose =
        Complex::new(ComplexParts { faces: Rows::default(), edges: vec![[0, 1]], ..triangle() })
            .unwrap();
    for part in [none, wide, loose] {
        let error = whole.onto(&part, Default::default(), &Job::default()).unwrap_err();
        assert_eq!(error.status(), Status::InvalidArgument);
        assert!(error.to_string().contains("samples"), "{error}");
    }
}

/// A square bar: its axis is a line, at which four samples meet.
#[test]
fn hairs_of_cospherical_samples_stay_when_asked_for() {
    let rows: Vec<[f64; 3]> =
        (0..36).map(|i| [f64::from(i % 2), f64::from(i / 2 % 2), f64::from(i / 4)]).collect();
    let dual = dual(&rows);
    let labels = Arc::new(labels(&dual, |_| true));
    let job = Job::default();
    let whole = PairMesh::voronoi(&dual, &labels, &job).unwrap();
    let flow = Flow::new(&dual, &labels, Default::default(), &job).unwrap();
    let core = flow.core(Default::default(), &[], &job).unwrap().into_complex();
    let options = PairOntoOptions { exact: true, ..Default::default() };
    let less = whole.onto(&core, options, &job).unwrap();
    assert_eq!(less.inner(&job).unwrap().edges().len(), 7, "between eight cubes");
    assert_eq!((less.missing(), less.inner_vertices().len()), (0, 8));
    // What a pair-mesh says of its own inner structure is understood.
    let same = whole.onto(&whole.inner(&job).unwrap(), options, &job).unwrap();
    assert_eq!(same.counts(), whole.counts());
}

#[test]
fn what_is_not_there_is_counted() {
    let (whole, _) = parts(Shape::Sphere);
    let job = Job::default();
    let samples = vec![u32::MAX - 5, u32::MAX - 3];
    let samples = Attribute::new("samples", Element::Face, 2, Values::U32(samples)).unwrap();
    let part = Complex::new(ComplexParts {
        vertices: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        faces: Rows::new(vec![0, 3], vec![0, 1, 2]).unwrap(),
        attributes: vec![samples],
        ..ComplexParts::default()
    })
    .unwrap();
    assert_eq!(whole.onto(&part, Default::default(), &job).unwrap().missing(), 1);
    let options = PairOntoOptions { exact: true, ..Default::default() };
    let error = whole.onto(&part, options, &job).unwrap_err();
    assert_eq!(error.status(), Status::Degenerate);
    assert!(error.to_string().contains("1 of the Voronoi facets"), "{error}");
}

#[test]
fn parts_and_what_was_deformed_are_refused() {
    let (whole, parts) = parts(Shape::Sphere);
    let job = Job::default();
    let less = whole.onto(&parts[0].1, Default::default(), &job).unwrap();
    let moved = whole.with_inner(whole.inner_vertices(), &job).unwrap();
    for mesh in [less, moved] {
        let error = mesh.onto(&parts[3].1, Default::default(), &job).unwrap_err();
        assert_eq!(error.status(), Status::InvalidArgument);
    }
}

#[test]
fn what_is_cancelled_stops() {
    let (whole, parts) = parts(Shape::Torus);
    let job = Job::new(JobOptions::default());
    job.cancel();
    let error = whole.onto(&parts[3].1, Default::default(), &job).unwrap_err();
    assert_eq!(error.status(), Status::Cancelled);
}

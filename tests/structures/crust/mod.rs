//! Power crusts of shapes whose answer is known, and of sets that have none.

mod label;

use crate::sets::{self, Random, Set};
use medax::complex::{Element, Values};
use medax::crust::{Label, PowerCrustOptions};
use medax::dual::{Dual, DualOptions};
use medax::{Complex, Job, JobOptions, NONE, Points, Poles, PowerCrust, Status};
use std::sync::Arc;

fn points(rows: &[[f64; 3]]) -> Arc<Points> {
    Arc::new(Points::new(rows, Default::default(), &Job::default()).unwrap())
}

fn crust(rows: &[[f64; 3]]) -> PowerCrust {
    let options = PowerCrustOptions::default();
    PowerCrust::build(&points(rows), options, &Job::default()).unwrap()
}

/// The power crust of the poles' balls on a grid.
fn rounded(rows: &[[f64; 3]]) -> PowerCrust {
    let options = PowerCrustOptions { round_poles: true, ..Default::default() };
    PowerCrust::build(&points(rows), options, &Job::default()).unwrap()
}

fn assert_valid(crust: &PowerCrust, name: &str) {
    let job = Job::default();
    let report = crust.validate(&job).unwrap();
    assert!(report.is_valid(), "{name}: {report:?}");
    let report = crust.regular().validate(&job).unwrap();
    assert!(report.is_valid(), "{name}: {report:?}");
}

/// A torus about the z axis, on a grid of angles that are slightly stirred.
fn torus(major: f64, minor: f64, steps: (u32, u32)) -> Vec<[f64; 3]> {
    let mut random = Random(3);
    let mut rows = Vec::new();
    for i in 0..steps.0 {
        for j in 0..steps.1 {
            let turn = |i: u32, n: u32, r: &mut Random| {
                std::f64::consts::TAU * (f64::from(i) + 0.3 * r.unit()) / f64::from(n)
            };
            let (u, v) = (turn(i, steps.0, &mut random), turn(j, steps.1, &mut random));
            let r = major + minor * v.cos();
            rows.push([r * u.cos(), r * u.sin(), minor * v.sin()]);
        }
    }
    rows
}

#[test]
fn a_sphere_comes_out_round() {
    let mut random = Random(11);
    let rows: Vec<_> = (0..2000).map(|_| random.sphere()).collect();
    let crust = crust(&rows);
    assert_valid(&crust, "sphere");
    let topology = crust.surface().topology(&Job::default()).unwrap();
    assert!(topology.closed);
    assert_eq!((topology.components, topology.genus), (1, Some(0)));
    for p in crust.surface().vertices() {
        let r = p.iter().map(|x| x * x).sum::<f64>().sqrt();
        assert!((0.97..1.03).contains(&r), "{p:?}");
    }
    // Inner poles crowd at the centre, outer ones keep away from the sphere.
    for (ball, label) in crust.poles().balls().iter().zip(crust.labels()) {
        let r = ball[..3].iter().map(|x| x * x).sum::<f64>().sqrt();
        assert_eq!(*label == Label::Inner, r < 1.0, "{ball:?}");
        assert!(*label == Label::Outer || r < 0.2, "{ball:?}");
    }
}

#[test]
fn a_torus_keeps_its_hole() {
    let rows = torus(2.0, 0.7, (90, 40));
    let crust = crust(&rows);
    assert_valid(&crust, "torus");
    let topology = crust.surface().topology(&Job::default()).unwrap();
    assert!(topology.closed);
    assert_eq!((topology.components, topology.genus), (1, Some(1)));
    // The medial axis of the solid torus is the circle of radius 2, its balls have radius 0.7.
    for p in crust.inner_shape().vertices() {
        let off = (p[0].hypot(p[1]) - 2.0).hypot(p[2]);
        assert!(off < 0.15, "{p:?} lies {off} from the axis");
    }
    let inner = crust.inner_shape().topology(&Job::default()).unwrap();
    assert_eq!(inner.components, 1);
}

#[test]
fn two_spheres_one_within_the_other_are_a_shell() {
    let mut random = Random(5);
    let mut rows: Vec<_> = (0..3000).map(|_| random.sphere()).collect();
    rows.extend((0..1500).map(|_| random.sphere().map(|x| 0.5 * x)));
    let crust = crust(&rows);
    assert_valid(&crust, "shell");
    let topology = crust.surface().topology(&Job::default()).unwrap();
    assert_eq!((topology.components, topology.genus), (2, Some(0)));
    // The void is outside: the pole at the common centre is outer.
    for (ball, label) in crust.poles().balls().iter().zip(crust.labels()) {
        let r = ball[..3].iter().map(|x| x * x).sum::<f64>().sqrt();
        assert_eq!(*label == Label::Inner, (0.5..1.0).contains(&r), "{ball:?}");
    }
}

#[test]
fn every_kind_of_set_gives_a_closed_surface() {
    for Set { name, rows } in sets::all(300) {
        for crust in [crust(&rows), rounded(&rows)] {
            assert_valid(&crust, name);
            let topology = crust.surface().topology(&Job::default()).unwrap();
            // Between two lines there is no solid: no pole is inner.
            assert_eq!(topology.closed, name != "two lines", "{name}: {topology:?}");
            assert_eq!(topology.nonmanifold_edges, 0, "{name}");
            let triangles = crust.surface().triangulated().unwrap();
            let cut = triangles.topology(&Job::default()).unwrap();
            assert_eq!(cut.nonmanifold_edges, 0, "{name}, cut into triangles");
            assert_eq!(cut.closed, topology.closed, "{name}, cut into triangles");
            assert_eq!(topology.nonmanifold_vertices, 0, "{name}");
        }
    }
}

/// The values of an attribute of indices.
fn indices<'a>(crust: &'a PowerCrust, element: Element, name: &str) -> &'a [u32] {
    match crust.surface().attribute(element, name).unwrap().values() {
        Values::U32(values) => values,
        Values::F64(_) => panic!("{name} has floats"),
    }
}

#[test]
fn the_surface_passes_through_its_samples_once_and_exactly() {
    let mut random = Random(12);
    let ellipsoid = |u: [f64; 3]| [u[0], 0.7 * u[1], 0.4 * u[2]];
    let rows: Vec<_> = (0..3000).map(|_| ellipsoid(random.sphere())).collect();
    let options = PowerCrustOptions { keep_shards: true, ..Default::default() };
    let merged = crust(&rows);
    let whole = PowerCrust::build(&points(&rows), options, &Job::default()).unwrap();
    let samples = indices(&merged, Element::Vertex, "sample");
    let mut seen = vec![false; rows.len()];
    for (&sample, vertex) in samples.iter().zip(merged.surface().vertices()) {
        if sample != NONE {
            assert_eq!(*vertex, merged.poles().triangulation().coords()[sample as usize]);
            assert!(!std::mem::replace(&mut seen[sample as usize], true), "sample {sample} twice");
        }
    }
    // Measured: all but 3 in 100.
    let count = seen.iter().filter(|&&seen| seen).count();
    assert!(count > rows.len() * 9 / 10, "{count} of {}", rows.len());
    // A shard is near its sample, but where its cell is nearly flat, and there are more than two for each.
    let of_shards = indices(&whole, Element::Vertex, "sample");
    let shards = of_shards.iter().zip(whole.surface().vertices()).filter(|(s, _)| **s != NONE);
    let far = shards.clone().filter(|&(&sample, vertex)| {
        let at = whole.poles().triangulation().coords()[sample as usize];
        (0..3).any(|k| (at[k] - vertex[k]).abs() > 1e-6)
    });
    assert!(far.count() < count / 100);
    assert!(shards.count() > 2 * count);
    let faces = |crust: &PowerCrust| crust.surface().faces().len();
    assert!(faces(&merged) < faces(&whole) * 4 / 5);
}

/// Rows on a spiral about a sphere, each the centre of as much of it: all inner poles are the sphere's centre, but for rounding.
fn spiral(count: u32) -> Vec<[f64; 3]> {
    let golden = std::f64::consts::PI * (3.0 - 5f64.sqrt());
    let row = |i: u32| {
        let z = 1.0 - (2.0 * f64::from(i) + 1.0) / f64::from(count);
        let (sin, cos) = (golden * f64::from(i)).sin_cos();
        let radius = (1.0 - z * z).sqrt();
        [radius * cos, radius * sin, z]
    };
    (0..count).map(row).collect()
}

#[test]
fn faces_do_not_fold_where_poles_coincide_but_for_rounding() {
    let crust = crust(&spiral(2000));
    assert_valid(&crust, "spiral");
    let surface = crust.surface();
    let vertices = surface.vertices();
    let mut folded = 0.0;
    for triangle in surface.triangles() {
        // Six times the volume between it and the centre, which is 1 away or nearly so.
        let [a, b, c] = triangle.map(|v| vertices[v as usize]);
        let cross = |i: usize, j: usize| b[i] * c[j] - b[j] * c[i];
        let volume = a[0] * cross(1, 2) + a[1] * cross(2, 0) + a[2] * cross(0, 1);
        folded += (-volume).max(0.0) / 2.0;
    }
    // What turns its back is needles. Merged regardless, 0.05 of the sphere's 12.57 would.
    assert!(folded < 1e-9, "an area of {folded}");
    // Most samples are vertices nevertheless.
    let samples = indices(&crust, Element::Vertex, "sample").iter().filter(|&&s| s != NONE);
    assert!(samples.count() > 1000);
}

#[test]
fn the_order_of_rows_decides_nothing() {
    for Set { name, rows } in sets::all(250) {
        let order = sets::shuffled(rows.len(), 9);
        let shuffled: Vec<_> = order.iter().map(|&i| rows[i]).collect();
        for build in [crust, rounded] {
            let [first, second] = [build(&rows), build(&shuffled)];
            assert!(first.poles().balls() == second.poles().balls(), "{name}");
            assert!(first.labels() == second.labels(), "{name}");
            assert!(first.surface() == second.surface(), "{name}");
            assert!(first.inner_shape() == second.inner_shape(), "{name}");
            assert!(first.outer_shape() == second.outer_shape(), "{name}");
        }
    }
}

#[test]
fn scaling_by_a_power_of_two_scales_the_surface() {
    let rows = torus(2.0, 0.75, (40, 24));
    let first = crust(&rows);
    let second = crust(&rows.iter().map(|p| p.map(|x| 4.0 * x)).collect::<Vec<_>>());
    assert!(first.labels() == second.labels());
    assert!(first.surface().faces() == second.surface().faces());
    let scaled: Vec<_> = first.surface().vertices().iter().map(|p| p.map(|x| 4.0 * x)).collect();
    assert!(scaled == second.surface().vertices());
}

#[test]
fn moving_keeps_the_topology() {
    // Centres are rounded where they lie, so that moving may turn the clusters of power vertices
    // in the samples about, but nothing that can be seen.
    let rows = torus(2.0, 0.75, (60, 30));
    let moved: Vec<_> = rows.iter().map(|&[x, y, z]| [x + 100.0, y - 7.0, z + 0.3]).collect();
    let (first, second) = (crust(&rows), crust(&moved));
    let topology = |crust: &PowerCrust| crust.surface().topology(&Job::default()).unwrap();
    assert_eq!(topology(&first).genus, Some(1));
    assert_eq!(topology(&second).genus, Some(1));
    assert_eq!(first.poles().len(), second.poles().len());
    let inner = |crust: &PowerCrust| crust.labels().iter().filter(|l| **l == Label::Inner).count();
    assert_eq!(inner(&first), inner(&second));
}

/// A stage needs its own memory besides what earlier stages have left.
#[test]
fn what_each_stage_leaves_is_counted() {
    let rows = points(&torus(1.0, 0.4, (60, 30)));
    let peak = |build: &dyn Fn(&Job)| {
        let job = Job::default();
        build(&job);
        job.memory_peak() as usize
    };
    let options = PowerCrustOptions::default();
    let crust = PowerCrust::build(&rows, options, &Job::default()).unwrap();
    let (poles, regular, surface) = (crust.poles(), crust.regular(), crust.surface());
    let size = |t: &medax::Triangulation| 32 * t.cells().len() + 24 * t.coords().len();
    // While poles are chosen there are the triangulation and the centres of its cells.
    let of_poles = peak(&|job| drop(Poles::with_far_box(&rows, Default::default(), job).unwrap()));
    let least = size(poles.triangulation()) + 32 * poles.triangulation().cells().len();
    assert!(of_poles > least, "{of_poles} of {least}");
    // When the surface is done there are the regular triangulation and its edges; a number for each cell of it; and
    // of the surface rings, where they begin, two poles a face, positions and cells, triangles.
    let of_crust = peak(&|job| drop(PowerCrust::from_poles(poles, options, job).unwrap()));
    let incidence = regular.incidence(&Job::default()).unwrap();
    let edges = regular.edges(&incidence, &Job::default()).unwrap();
    let least = size(regular)
        + 12 * edges.ends.len()
        + 4 * regular.cells().len()
        + 4 * surface.faces().indices().len()
        + 12 * surface.faces().len()
        + 28 * surface.vertices().len()
        + 16 * surface.triangles().len();
    assert!(of_crust > least, "{of_crust} of {least}");
    // And all the time what the poles were chosen from.
    let of_all = peak(&|job| drop(PowerCrust::build(&rows, options, job).unwrap()));
    let least = of_crust + size(poles.triangulation());
    assert!(of_all > least, "{of_all} of {least}");
}

/// What the option promises of the balls, and that without it they are the poles'.
fn assert_rounded(crust: &PowerCrust, step: f64, name: &str) {
    let (poles, regular) = (crust.poles(), crust.regular());
    let mut own = vec![u32::MAX; poles.len()];
    for (sample, pair) in poles.pole_of_sample().iter().enumerate() {
        for &pole in pair.iter().filter(|&&pole| pole != NONE) {
            own[pole as usize] = own[pole as usize].min(sample as u32);
        }
    }
    let mut moved = 0;
    for (vertex, &pole) in regular.row_of_vertex().iter().enumerate() {
        let (ball, center) = (poles.balls()[pole as usize], regular.coords()[vertex]);
        for k in 0..3 {
            assert_eq!((center[k] / step).fract(), 0.0, "{name}, pole {pole}");
            assert!((center[k] - ball[k]).abs() <= 0.5 * step, "{name}, pole {pole}");
        }
        moved += u32::from(center != ball[..3]);
        let weight = regular.weights()[vertex];
        assert_eq!((weight / step / step).fract(), 0.0, "{name}, pole {pole}");
        let sample = poles.triangulation().coords()[own[pole as usize] as usize];
        let square: f64 = (0..3).map(|k| (center[k] - sample[k]).powi(2)).sum();
        let error = (weight - square).abs();
        assert!(error <= step * step + 4.0 * f64::EPSILON * square, "{name}, pole {pole}");
    }
    assert!(2 * moved > poles.len() as u32, "{name}: {moved} of {} poles moved", poles.len());
    for shape in [crust.inner_shape(), crust.outer_shape()] {
        let values = |name| shape.attribute(Element::Vertex, name).unwrap().values().clone();
        let (Values::F64(radii), Values::U32(of)) = (values("radius"), values("pole")) else {
            panic!("{name}: attributes of other types");
        };
        for ((center, radius), pole) in shape.vertices().iter().zip(radii).zip(of) {
            let vertex = regular.points().vertex_of_row()[pole as usize] as usize;
            assert_eq!(*center, regular.coords()[vertex], "{name}, pole {pole}");
            assert_eq!(radius, regular.weights()[vertex].sqrt(), "{name}, pole {pole}");
        }
    }
}

#[test]
fn rounding_moves_balls_by_half_a_step_and_keeps_their_samples() {
    let mut random = Random(17);
    let mut shell: Vec<_> = (0..900).map(|_| random.sphere()).collect();
    shell.extend((0..500).map(|_| random.sphere().map(|x| 0.5 * x)));
    let torus = torus(2.0, 0.75, (60, 30));
    // Their longest sides are between 4 and 8, and between 1 and 2.
    for (name, rows, side) in [("torus", torus, 8.0), ("shell", shell, 2.0)] {
        for scale in [1.0, 2f64.powi(-30), 2f64.powi(90)] {
            let rows: Vec<_> = rows.iter().map(|p| p.map(|x| scale * x)).collect();
            let (exact, rounded) = (crust(&rows), rounded(&rows));
            assert_valid(&rounded, name);
            assert_rounded(&rounded, scale * side * 2f64.powi(-36), name);
            assert!(exact.poles().balls() == rounded.poles().balls(), "{name}");
            let topology = |crust: &PowerCrust| {
                let topology = crust.surface().topology(&Job::default()).unwrap();
                (topology.closed, topology.components, topology.genus)
            };
            assert_eq!(topology(&exact), topology(&rounded), "{name}");
            assert!(exact.labels() == rounded.labels(), "{name}");
            // Without the option nothing moves.
            for (vertex, &pole) in exact.regular().row_of_vertex().iter().enumerate() {
                assert_eq!(
                    exact.regular().coords()[vertex],
                    exact.poles().balls()[pole as usize][..3]
                );
            }
            assert!(exact.options() != rounded.options());
        }
    }
}

#[test]
fn the_step_is_that_of_a_power_of_two() {
    // The longest side is 4, a power of two itself, then an ulp more.
    for (side, step) in [(4.0, 4.0), (4.0 + 4.0 * f64::EPSILON, 8.0)] {
        let mut random = Random(23);
        let mut rows: Vec<_> = (0..400).map(|_| random.sphere()).collect();
        rows.extend([[-1.0, 0.0, 0.0], [side - 1.0, 0.0, 0.0]]);
        assert_rounded(&rounded(&rows), step * 2f64.powi(-36), "sphere and a point");
    }
}

#[test]
fn rounded_poles_at_one_place_are_one() {
    // The faces of a cube, each sample moved by some 1e-13: what were one pole are several.
    let mut random = Random(31);
    let rows: Vec<_> = (0..343u32)
        .map(|i| [i % 7, i / 7 % 7, i / 49])
        .filter(|row| row.iter().any(|&x| x == 0 || x == 6))
        .map(|row| row.map(|x| f64::from(x) + 1e-13 * random.unit()))
        .collect();
    let crust = rounded(&rows);
    assert_valid(&crust, "cube");
    let regular = crust.regular();
    let merged: Vec<u32> = (0..crust.poles().len() as u32)
        .filter(|&p| regular.points().duplicate_of()[p as usize] != NONE)
        .collect();
    assert!(merged.len() > 100, "{} poles share a place", merged.len());
    let mut lighter = 0;
    for pole in merged {
        let vertex = regular.points().vertex_of_row()[pole as usize] as usize;
        lighter += u32::from(regular.row_of_vertex()[vertex] != pole);
        assert!(crust.is_visible(pole) <= (regular.row_of_vertex()[vertex] == pole));
    }
    assert!(lighter > 0);
}

#[test]
fn rounding_far_away_and_at_the_edge_of_the_range_is_sound() {
    let rows = torus(2.0, 0.75, (40, 24));
    // Coordinates themselves are coarser than the grid.
    let moved: Vec<_> = rows.iter().map(|p| p.map(|x| x + 2f64.powi(22))).collect();
    let far = rounded(&moved);
    assert_valid(&far, "far");
    let exact = crust(&moved);
    assert!(far.regular().coords() == exact.regular().coords());
    // The grid is that of the least coordinates, some hundred steps to the torus.
    let least = 2f64.powi(-160);
    let tiny: Vec<_> = rows.iter().map(|p| p.map(|x| (64.0 * x).round() * least)).collect();
    let tiny = rounded(&tiny);
    assert_valid(&tiny, "tiny");
    assert_rounded(&tiny, least, "tiny");
}

#[test]
fn bad_input_is_an_error() {
    let build = |rows: &[[f64; 3]], deep| {
        let options = PowerCrustOptions { deep, ..Default::default() };
        PowerCrust::build(&points(rows), options, &Job::default()).unwrap_err().status()
    };
    let plane: Vec<_> = (0..60).map(|i| [f64::from(i % 8), f64::from(i / 8), 0.0]).collect();
    assert_eq!(build(&plane, 0.4), Status::Degenerate);
    assert_eq!(build(&plane[..3], 0.4), Status::TooFewPoints);
    let solid = torus(2.0, 0.7, (9, 6));
    for deep in [-0.1, 1.1, f64::NAN] {
        assert_eq!(build(&solid, deep), Status::InvalidArgument);
    }
    let huge: Vec<_> = solid.iter().map(|p| p.map(|x| x * 2f64.powi(198))).collect();
    assert_eq!(build(&huge, 0.4), Status::CoordinateRange);
}

#[test]
fn errors_about_poles_do_not_blame_rows() {
    let build = |rows: &[[f64; 3]]| {
        PowerCrust::build(&points(rows), Default::default(), &Job::default()).unwrap_err()
    };
    let solid = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let flat_poles =
        [[1.0, 2.0, 2.0], [0.0, 0.0, 2.0], [1.0, 2.0, 0.0], [1.0, 0.0, 2.0], [0.0, 2.0, 2.0]];
    for (rows, status) in
        [(&solid[..], Status::TooFewPoints), (&flat_poles[..], Status::Degenerate)]
    {
        let error = build(rows);
        assert_eq!((error.status(), error.element()), (status, None));
        assert!(error.message().contains("poles"), "{error}");
    }
}

#[test]
fn without_an_inner_pole_the_surface_is_empty() {
    let rows: Vec<_> = (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from)).collect();
    let crust = crust(&rows);
    assert!(crust.labels().iter().all(|label| *label == Label::Outer));
    assert!(crust.surface().faces().is_empty());
    assert_valid(&crust, "cube");
}

/// Everything that a crust is made of, as text: floats are written so that they differ if any bit does.
fn described(rows: &[[f64; 3]], round_poles: bool, threads: usize) -> String {
    let job = Job::new(JobOptions { threads, ..Default::default() });
    let options = PowerCrustOptions { round_poles, ..Default::default() };
    let crust = PowerCrust::build(&points(rows), options, &job).unwrap();
    let (poles, regular) = (crust.poles(), crust.regular());
    let dual = Dual::new(poles.triangulation(), DualOptions { facets: true }, &job).unwrap();
    let of_poles = (poles.balls(), poles.radii_squared(), poles.cell_of_pole(), poles.normals());
    let of_samples = (poles.pole_of_sample(), poles.touches_far_box());
    let of_samples = (of_samples, poles.object_angles());
    let shapes = [crust.surface(), crust.inner_shape(), crust.outer_shape()];
    format!(
        "{dual:?} {of_poles:?} {of_samples:?} {:?} {shapes:?}",
        (regular.coords(), regular.weights(), regular.cells(), crust.labels())
    )
}

#[test]
fn threads_change_no_bit() {
    // Enough samples and cells for several parts; and all kinds of ties, too few for more than one.
    let mut random = Random(29);
    let rows: Vec<_> = (0..17_000)
        .map(|_| {
            let [x, y, z] = random.sphere();
            let bump = 1.0 + 0.01 * random.unit();
            [bump * x, 0.7 * bump * y, 0.4 * bump * z]
        })
        .collect();
    let mut sets = sets::all(120);
    sets.push(Set { name: "ellipsoid", rows });
    for Set { name, rows } in sets {
        for round_poles in [false, true] {
            let one = described(&rows, round_poles, 1);
            for threads in [2, 3, 8] {
                let many = described(&rows, round_poles, threads);
                assert!(many == one, "{name}, {threads} threads, {round_poles}");
            }
        }
    }
}

#[test]
fn shapes_carry_what_their_poles_have() {
    let noise = sets::all(300).into_iter().find(|set| set.name == "uniform").unwrap().rows;
    for rows in [torus(2.0, 0.7, (40, 24)), noise] {
        let crust = crust(&rows);
        // Where balls change their poles do not.
        let offset = crust.offset(0.01, &Job::default()).unwrap();
        for crust in [crust, offset] {
            for (side, shape) in
                [(Label::Inner, crust.inner_shape()), (Label::Outer, crust.outer_shape())]
            {
                let names: Vec<&str> = shape.attributes().iter().map(|a| a.name()).collect();
                assert_eq!(names, ["radius", "pole", "label", "object_angle", "flatness"]);
                let values = |name| shape.attribute(Element::Vertex, name).unwrap().values();
                let (Values::U32(poles), Values::F64(angles)) =
                    (values("pole"), values("object_angle"))
                else {
                    panic!("attributes of other types");
                };
                assert!(!poles.is_empty());
                assert_eq!(*values("label"), Values::U32(vec![side as u32; poles.len()]));
                for (&pole, &angle) in poles.iter().zip(angles) {
                    assert_eq!(crust.labels()[pole as usize], side);
                    assert_eq!(angle, crust.poles().object_angles()[pole as usize]);
                }
            }
            let both = crust.both_shapes().unwrap();
            for element in [Element::Vertex, Element::Cell] {
                for attribute in both.attributes().iter().filter(|a| a.element() == element) {
                    let of = |shape: &Complex| {
                        shape.attribute(element, attribute.name()).unwrap().values().clone()
                    };
                    let joined = match (of(crust.inner_shape()), of(crust.outer_shape())) {
                        (Values::F64(a), Values::F64(b)) => Values::F64([a, b].concat()),
                        (Values::U32(a), Values::U32(b)) => Values::U32([a, b].concat()),
                        _ => panic!("attributes of other types"),
                    };
                    assert_eq!(*attribute.values(), joined);
                }
            }
            assert_eq!(both.attributes().len(), 5);
        }
    }
}

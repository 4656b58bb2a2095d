//! Duals: known diagrams, geometry that must close, and `validate` over every kind of set.

use crate::sets::{self, Set};
use medax::dual::DualOptions;
use medax::{Dual, Job, NONE, Points, Triangulation};
use std::sync::Arc;

fn points(rows: &[[f64; 3]]) -> Arc<Points> {
    Arc::new(Points::new(rows, Default::default(), &Job::default()).unwrap())
}

fn dual_of(t: Triangulation) -> Dual {
    Dual::new(&Arc::new(t), DualOptions { facets: true }, &Job::default()).unwrap()
}

fn delaunay(rows: &[[f64; 3]]) -> Dual {
    dual_of(Triangulation::delaunay(&points(rows), &Job::default()).unwrap())
}

fn regular(rows: &[[f64; 3]], weights: &[f64]) -> Dual {
    dual_of(Triangulation::regular(&points(rows), weights, &Job::default()).unwrap())
}

fn assert_valid(dual: &Dual, name: &str) {
    let report = dual.validate(&Job::default()).unwrap();
    assert!(report.is_valid(), "{name}: {report:?}");
    assert!(report.checked as usize > 5 * dual.centers().len(), "{name} was not checked");
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| a[k] - b[k])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Twice the area of a polygon as a vector along its right-handed normal.
fn area(polygon: &[[f64; 3]]) -> [f64; 3] {
    let origin = polygon[0];
    polygon.windows(2).fold([0.0; 3], |sum, pair| {
        let part = cross(minus(pair[0], origin), minus(pair[1], origin));
        [0, 1, 2].map(|k| sum[k] + part[k])
    })
}

fn polygon(dual: &Dual, facet: usize) -> Vec<[f64; 3]> {
    let ring = dual.facets().unwrap().ring(facet);
    ring.iter().map(|&cell| dual.centers()[cell as usize]).collect()
}

#[test]
fn every_kind_of_set_is_valid() {
    for Set { name, rows } in sets::all(400) {
        assert_valid(&delaunay(&rows), name);
        for (kind, weights) in sets::weights(&rows) {
            assert_valid(&regular(&rows, &weights), &format!("{name}, {kind} weights"));
        }
    }
}

#[test]
fn equal_weights_change_only_the_radii() {
    let Set { rows, .. } = &sets::all(200)[0];
    let (plain, heavy) = (delaunay(rows), regular(rows, &vec![0.25; rows.len()]));
    assert_eq!(plain.centers(), heavy.centers());
    assert_eq!(plain.rays(), heavy.rays());
    assert_eq!(plain.facets(), heavy.facets());
    for (r, s) in plain.radii_squared().iter().zip(heavy.radii_squared()) {
        assert!((r - 0.25 - s).abs() <= 4.0 * f64::EPSILON * r.max(0.25), "{r} {s}");
    }
}

#[test]
fn the_diagram_of_a_lattice_is_the_lattice_of_cube_centers() {
    let rows: Vec<_> =
        (0..125).map(|i| [i % 5, i / 5 % 5, i / 25].map(|x| f64::from(x) * 2.0)).collect();
    let dual = delaunay(&rows);
    assert!(dual.radii_squared().iter().all(|&r| r == 3.0));
    assert!(dual.centers().as_flattened().iter().all(|x| x % 2.0 == 1.0));
    let coords = dual.triangulation().coords();
    let facets = dual.facets().unwrap();
    let mut squares = 0;
    for (i, &[a, b]) in facets.edges().iter().enumerate().filter(|(i, _)| !facets.is_unbounded(*i))
    {
        let along = minus(coords[b as usize], coords[a as usize]);
        // Between lattice neighbors a square of side 2, between all others nothing.
        let expected = if dot(along, along) == 4.0 { along.map(|x| 4.0 * x) } else { [0.0; 3] };
        assert_eq!(area(&polygon(&dual, i)), expected, "{along:?}");
        squares += usize::from(expected != [0.0; 3]);
    }
    // Inner edges along each of three axes.
    assert_eq!(squares, 3 * 4 * 3 * 3);
}

#[test]
fn a_tetrahedron_has_four_rays_and_six_open_facets() {
    let rows = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let dual = delaunay(&rows);
    assert_eq!((dual.centers(), dual.radii_squared()), (&[[0.5; 3]][..], &[0.75][..]));
    let mut directions = dual.rays().directions().to_vec();
    directions.sort_by(|a, b| a.partial_cmp(b).unwrap());
    let third = 1.0 / 3f64.sqrt();
    let expected = [[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0], [third; 3]];
    for (found, expected) in directions.iter().zip(expected) {
        assert!(minus(*found, expected).iter().all(|x| x.abs() < 1e-15), "{directions:?}");
    }
    let facets = dual.facets().unwrap();
    assert_eq!((facets.len(), facets.cells()), (6, &[0; 6][..]));
    for (&[a, b], &[entry, exit]) in facets.edges().iter().zip(facets.rays()) {
        // From infinity along the first ray, out along the second: a left turn seen from b.
        let [u, v] = [entry, exit].map(|ray| dual.rays().directions()[ray as usize]);
        let at = |v: u32| dual.triangulation().coords()[v as usize];
        assert!(dot(cross(u.map(|x| -x), v), minus(at(b), at(a))) > 0.0);
    }
}

#[test]
fn facets_bisect_their_edges_and_turn_round_them() {
    for Set { name, rows } in sets::all(300) {
        if !["uniform", "clustered"].contains(&name) {
            continue;
        }
        let dual = delaunay(&rows);
        let coords = dual.triangulation().coords();
        let facets = dual.facets().unwrap();
        for (i, &[a, b]) in facets.edges().iter().enumerate() {
            let polygon = polygon(&dual, i);
            let along = minus(coords[b as usize], coords[a as usize]);
            assert!(dot(area(&polygon), along) >= 0.0, "{name}: facet {i}");
        }
        // The facets of a bounded Voronoi cell close: their areas, outward, add up to nothing.
        let mut sums = vec![([0.0; 3], 0.0); coords.len()];
        for (i, edge) in facets.edges().iter().enumerate() {
            let area = area(&polygon(&dual, i));
            let length = dot(area, area).sqrt();
            for (v, sign) in [(edge[0], 1.0), (edge[1], -1.0)] {
                let (sum, total) = &mut sums[v as usize];
                *sum = [0, 1, 2].map(|k| sum[k] + sign * area[k]);
                *total += if facets.is_unbounded(i) { f64::INFINITY } else { length };
            }
        }
        let bounded = sums.iter().filter(|(_, total)| total.is_finite());
        assert!(bounded.clone().count() > 10, "{name}");
        for (sum, total) in bounded {
            assert!(dot(*sum, *sum).sqrt() <= 1e-12 * total, "{name}: {sum:?} {total}");
        }
    }
}

#[test]
fn rows_in_another_order_give_the_same_bytes() {
    for Set { name, rows } in sets::all(200) {
        let order = sets::shuffled(rows.len(), 7);
        let shuffled: Vec<_> = order.iter().map(|&i| rows[i]).collect();
        let (one, two) = (delaunay(&rows), delaunay(&shuffled));
        let bytes = |dual: &Dual| {
            let centers: Vec<u64> =
                dual.centers().as_flattened().iter().map(|x| x.to_bits()).collect();
            let radii: Vec<u64> = dual.radii_squared().iter().map(|x| x.to_bits()).collect();
            (centers, radii)
        };
        assert!(bytes(&one) == bytes(&two), "{name}");
        assert!(one.rays() == two.rays() && one.facets() == two.facets(), "{name}");
    }
}

#[test]
fn scaling_by_a_power_of_two_scales_the_diagram() {
    for Set { name, rows } in sets::all(150) {
        let scale = 2f64.powi(-77);
        let small: Vec<_> = rows.iter().map(|p| p.map(|x| x * scale)).collect();
        let (one, two) = (delaunay(&rows), delaunay(&small));
        let scaled: Vec<_> = one.centers().iter().map(|p| p.map(|x| x * scale)).collect();
        assert_eq!(scaled, two.centers(), "{name}");
        let scaled: Vec<_> = one.radii_squared().iter().map(|x| x * scale * scale).collect();
        assert_eq!(scaled, two.radii_squared(), "{name}");
        assert!(one.facets() == two.facets(), "{name}");
        assert!(one.rays() == two.rays(), "{name}");
    }
}

#[test]
fn rays_of_thin_facets_are_accurate() {
    // A tent whose faces are an ulp from degenerate triangles.
    let h = 1.0 + f64::EPSILON;
    let rows = [[0.0; 3], [1.0, 1.0, 1.0], [2.0, 2.0, 2.0 * h], [1.0, 1.5, 0.0]];
    let dual = delaunay(&rows);
    assert_valid(&dual, "tent");
    assert_eq!(dual.rays().len(), 4);
    assert!(dual.facets().unwrap().rays().iter().all(|rays| !rays.contains(&NONE)));
}

/// The first coordinate of a normal is a millionth of a millionth of the others, and an edge is so nearly
/// parallel to them that it matters.
#[test]
fn rays_are_accurate_in_their_least_coordinate() {
    let rows = [
        [1e8, -0.301877322163043, 0.0],
        [1e8, -0.0018773221630429937, 0.10000000000000002],
        [99999999.99999999, -0.0018773221630429934, 0.10000000000000002],
        [1e8, -0.3018773221630431, 0.2],
    ];
    assert_valid(&delaunay(&rows), "thin facets far away");
}

#[test]
fn without_the_option_there_are_no_facets() {
    let t = Triangulation::delaunay(&points(&sets::all(30)[0].rows), &Job::default()).unwrap();
    let dual = Dual::new(&Arc::new(t), DualOptions::default(), &Job::default()).unwrap();
    assert!(dual.facets().is_none());
    assert_eq!(dual.validate(&Job::default()).unwrap().first, None);
}

use super::*;
use crate::dual::DualOptions;
use crate::points::Points;
use crate::triangulation::Triangulation;
use std::sync::Arc;

/// A lattice, whose cells share spheres, stretched so that centres have all their bits.
fn dual(weighted: bool) -> Dual {
    let job = Job::default();
    let row = |i: usize| [i % 3, i / 3 % 3, i / 9].map(|x| x as f64 * 0.1 + 0.3);
    let points = Arc::new(Points::by_row(27, row, Default::default(), &job).unwrap());
    let t = match weighted {
        true => {
            let weights: Vec<f64> = (0..27u32).map(|i| f64::from(i * 7 % 5) * 1e-3).collect();
            Triangulation::regular(&points, &weights, &job)
        }
        false => Triangulation::delaunay(&points, &job),
    };
    Dual::new(&Arc::new(t.unwrap()), DualOptions { facets: true }, &job).unwrap()
}

fn is_valid(dual: &Dual) -> bool {
    dual.validate(&Job::default()).unwrap().is_valid()
}

#[test]
fn a_center_or_radius_a_few_ulps_off_is_noticed() {
    for dual in [dual(false), dual(true)] {
        assert!(is_valid(&dual));
        let moved = |x: f64| x * (1.0 + 4.0 * f64::EPSILON);
        for cell in 0..dual.centers.len() {
            let mut radius = dual.clone();
            radius.radii_squared[cell] = moved(radius.radii_squared[cell]) + 1e-17;
            assert!(!is_valid(&radius), "squared radius of cell {cell}");
            for axis in 0..3 {
                let mut center = dual.clone();
                center.centers[cell][axis] = moved(center.centers[cell][axis]);
                assert!(!is_valid(&center), "coordinate {axis} of cell {cell}");
                center.centers[cell][axis] = f64::NAN;
                assert!(!is_valid(&center));
            }
        }
        let mut short = dual.clone();
        short.radii_squared.pop();
        assert!(!is_valid(&short));
    }
}

#[test]
fn a_wrong_ray_is_noticed() {
    let dual = dual(false);
    for ray in 0..dual.rays.len() {
        for change in 0..5 {
            let mut dual = dual.clone();
            let direction = &mut dual.rays.directions[ray];
            match change {
                0 => *direction = direction.map(|x| -x),
                1 => *direction = direction.map(|x| x * (1.0 + 1e-14)),
                2 => direction.rotate_left(1),
                3 => *direction = direction.map(|x| x + 1e-14),
                _ => dual.rays.facets[ray][1] = (dual.rays.facets[ray][1] + 1) % 4,
            }
            assert!(!is_valid(&dual), "ray {ray}, change {change}");
        }
    }
    let mut fewer = dual.clone();
    fewer.rays.facets.pop();
    fewer.rays.directions.pop();
    assert!(!is_valid(&fewer));
    let mut more = dual.clone();
    more.rays.facets.push([0, 0]);
    more.rays.directions.push([1.0, 0.0, 0.0]);
    assert!(!is_valid(&more));
}

/// The dual with its facets changed.
fn with_facets(dual: &Dual, change: impl FnOnce(&mut Facets)) -> Dual {
    let mut dual = dual.clone();
    change(dual.facets.as_mut().unwrap());
    dual
}

#[test]
fn a_wrong_ring_is_noticed() {
    let dual = dual(false);
    let facets = dual.facets().unwrap();
    for i in 0..facets.len() {
        let (from, to) = (facets.offsets[i] as usize, facets.offsets[i + 1] as usize);
        if to - from > 1 {
            let turned = with_facets(&dual, |facets| facets.cells[from..to].rotate_left(1));
            assert!(!is_valid(&turned), "facet {i} begins elsewhere");
        }
        if to - from > 2 {
            let swapped = with_facets(&dual, |facets| facets.cells[from..to].reverse());
            assert!(!is_valid(&swapped), "facet {i} turns the other way");
        }
        let other = with_facets(&dual, |facets| facets.cells[from] = (facets.cells[from] + 1) % 8);
        assert!(!is_valid(&other), "facet {i} has another cell");
        let turned = with_facets(&dual, |facets| facets.edges[i].reverse());
        assert!(!is_valid(&turned), "edge {i} is turned round");
        let swapped = with_facets(&dual, |facets| facets.rays[i].reverse());
        assert_eq!(is_valid(&swapped), !facets.is_unbounded(i), "the rays of facet {i}");
        let opened = with_facets(&dual, |facets| facets.rays[i] = [0, 1]);
        assert!(!is_valid(&opened), "facet {i} has other rays");
    }
}

#[test]
fn missing_facets_are_noticed() {
    let dual = dual(false);
    let last = dual.facets().unwrap().offsets[dual.facets().unwrap().len() - 1];
    let fewer = with_facets(&dual, |facets| {
        facets.edges.pop();
        facets.rays.pop();
        facets.offsets.pop();
        facets.cells.truncate(last as usize);
    });
    assert!(!is_valid(&fewer));
    assert!(!is_valid(&with_facets(&dual, |facets| {
        facets.rays.pop();
    })));
    assert!(!is_valid(&with_facets(&dual, |facets| facets.cells[0] = NONE)));
    assert!(!is_valid(&with_facets(&dual, |facets| facets.offsets[1] = u32::MAX)));
}

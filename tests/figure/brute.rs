//! Crossings and places against brute force in exact rationals, on small whole numbers where everything touches.

use crate::drawing::*;
use medax::figure::ChainKind;
use num_rational::Ratio;
use proptest::prelude::*;

type Exact = Ratio<i64>;
type Spot = [Exact; 2];

/// An edge or a circle, and what it is part of.
#[derive(Clone, Debug)]
enum Curve {
    Edge { chain: usize, ends: [[i64; 2]; 2], numbers: [usize; 2], are_ends: [bool; 2] },
    Circle([i64; 3]),
}

fn edge_curves(chain: usize, vertices: &[[i64; 2]], is_ring: bool) -> Vec<Curve> {
    let mut kept: Vec<[i64; 2]> = vertices.to_vec();
    kept.dedup();
    if is_ring && kept.len() > 1 && kept.first() == kept.last() {
        kept.pop();
    }
    let (n, last) = (kept.len(), if is_ring { kept.len() } else { kept.len() - 1 });
    let edge = |i: usize| {
        let numbers = [i, (i + 1) % n];
        let are_ends = numbers.map(|k| !is_ring && (k == 0 || k + 1 == n));
        Curve::Edge { chain, ends: numbers.map(|k| kept[k]), numbers, are_ends }
    };
    (0..last).map(edge).collect()
}

/// What two segments have in common: the ends of it, one spot twice for a spot.
fn common([p, q]: [[i64; 2]; 2], [r, s]: [[i64; 2]; 2]) -> Option<[Spot; 2]> {
    let spot = |p: [i64; 2], q: [i64; 2], t: Exact| -> Spot {
        [0, 1].map(|i| Exact::from(p[i]) + t * Exact::from(q[i] - p[i]))
    };
    let (d, e, w) =
        ([q[0] - p[0], q[1] - p[1]], [s[0] - r[0], s[1] - r[1]], [r[0] - p[0], r[1] - p[1]]);
    let cross = |a: [i64; 2], b: [i64; 2]| a[0] * b[1] - a[1] * b[0];
    let within = |t: &Exact| (Exact::from(0)..=Exact::from(1)).contains(t);
    let det = cross(d, e);
    if det != 0 {
        let (t, u) = (Exact::new(cross(w, e), det), Exact::new(cross(w, d), det));
        return (within(&t) && within(&u)).then(|| [spot(p, q, t); 2]);
    }
    if cross(d, w) != 0 {
        return None;
    }
    // Along the first: where the ends of the second are.
    let along = |x: [i64; 2]| {
        let dot = (x[0] - p[0]) * d[0] + (x[1] - p[1]) * d[1];
        Exact::new(dot, d[0] * d[0] + d[1] * d[1])
    };
    let (a, b) = (along(r), along(s));
    let (from, to) = (a.min(b).max(0.into()), a.max(b).min(1.into()));
    (from <= to).then(|| [spot(p, q, from), spot(p, q, to)])
}

fn distance_2(p: [i64; 2], circle: [i64; 3]) -> i64 {
    (p[0] - circle[0]).pow(2) + (p[1] - circle[1]).pow(2)
}

/// The squared distance of a centre from a segment.
fn nearest_2([p, q]: [[i64; 2]; 2], circle: [i64; 3]) -> Exact {
    let d = [q[0] - p[0], q[1] - p[1]];
    let dot = (circle[0] - p[0]) * d[0] + (circle[1] - p[1]) * d[1];
    let t = Exact::new(dot, d[0] * d[0] + d[1] * d[1]).max(0.into()).min(1.into());
    (0..2)
        .map(|i| {
            let x = Exact::from(p[i] - circle[i]) + t * Exact::from(d[i]);
            x * x
        })
        .sum()
}

fn cross(s: &Curve, t: &Curve) -> bool {
    match (s, t) {
        (
            Curve::Edge { chain: a, ends: s, numbers: i, are_ends: x },
            Curve::Edge { chain: b, ends: t, numbers: j, are_ends: y },
        ) => {
            let Some(found) = common(*s, *t) else { return false };
            // A spot that both share by right: a vertex between them, or ends of polylines.
            let shared = |k: usize, l: usize| {
                let by_right = a == b && i[k] == j[l] || x[k] && y[l];
                by_right && s[k] == t[l] && found == [s[k].map(Exact::from); 2]
            };
            !(shared(0, 0) || shared(0, 1) || shared(1, 0) || shared(1, 1))
        }
        (Curve::Edge { ends, .. }, &Curve::Circle(c))
        | (&Curve::Circle(c), Curve::Edge { ends, .. }) => {
            let r2 = c[2] * c[2];
            let farthest = ends.iter().map(|&p| distance_2(p, c)).max().unwrap();
            nearest_2(*ends, c) <= Exact::from(r2) && farthest >= r2
        }
        (Curve::Circle(a), Curve::Circle(b)) => {
            let d2 = distance_2([a[0], a[1]], *b);
            (a[2] - b[2]).pow(2) <= d2 && d2 <= (a[2] + b[2]).pow(2)
        }
    }
}

/// Whether a vertex is in a ring: by the winding number of angles in eighths, counted at crossings of both half axes.
fn is_in(p: [i64; 2], ring: &[[i64; 2]]) -> bool {
    let mut winding = 0;
    for (i, &a) in ring.iter().enumerate() {
        let b = ring[(i + 1) % ring.len()];
        let turn = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
        if a[1] <= p[1] && b[1] > p[1] && turn > 0 {
            winding += 1;
        }
        if a[1] > p[1] && b[1] <= p[1] && turn < 0 {
            winding -= 1;
        }
    }
    winding != 0
}

/// A ring or circle as a region.
#[derive(Clone, Debug)]
enum Region {
    Ring { polygon: usize, is_hole: bool, vertices: Vec<[i64; 2]> },
    Disc([i64; 3]),
}

impl Region {
    fn holds(&self, other: &Region) -> bool {
        match (self, other) {
            (Region::Ring { vertices, .. }, Region::Ring { vertices: inner, .. }) => {
                is_in(inner[0], vertices)
            }
            // Its centre is in the ring, and the ring is not in it.
            (Region::Ring { vertices, .. }, Region::Disc(c)) => {
                is_in([c[0], c[1]], vertices) && distance_2(vertices[0], *c) > c[2] * c[2]
            }
            (Region::Disc(c), Region::Ring { vertices, .. }) => {
                distance_2(vertices[0], *c) < c[2] * c[2]
            }
            (Region::Disc(c), Region::Disc(d)) => {
                c[2] > d[2] && distance_2([d[0], d[1]], *c) < c[2] * c[2]
            }
        }
    }
}

fn misplaced(regions: &[Region]) -> u64 {
    let around = |i: usize| -> Vec<usize> {
        (0..regions.len()).filter(|&j| j != i && regions[j].holds(&regions[i])).collect()
    };
    let wrong = |&i: &usize| {
        let outside = around(i);
        // The inmost is in all the others.
        let next = outside.iter().max_by_key(|&&j| around(j).len());
        let in_disc = outside.iter().any(|&j| matches!(regions[j], Region::Disc(_)));
        in_disc
            || match (&regions[i], next.map(|&j| &regions[j])) {
                (Region::Ring { is_hole: true, polygon, .. }, next) => {
                    !matches!(next, Some(Region::Ring { is_hole: false, polygon: its, .. }) if its == polygon)
                }
                (_, None | Some(Region::Ring { is_hole: true, .. })) => false,
                _ => true,
            }
    };
    (0..regions.len()).filter(wrong).count() as u64
}

fn floats(vertices: &[[i64; 2]], scale: f64) -> Vec<Point> {
    vertices.iter().map(|p| p.map(|x| scale * x as f64)).collect()
}

type Whole = Vec<[i64; 2]>;

/// Compares a figure with brute force; nothing is compared where a chain alone is refused.
fn compare(
    polygons: &[Vec<Whole>],
    polylines: &[Whole],
    circles: &[[i64; 3]],
    scale: f64,
) -> Result<Option<(u64, u64)>, TestCaseError> {
    let drawing = Drawing {
        polygons: polygons
            .iter()
            .map(|rings| rings.iter().map(|ring| floats(ring, scale)).collect())
            .collect(),
        polylines: polylines.iter().map(|line| floats(line, scale)).collect(),
        points: Vec::new(),
        circles: circles.iter().map(|c| c.map(|x| scale * x as f64)).collect(),
    };
    let Ok(figure) = drawing.make(ACCEPT) else { return Ok(None) };
    check(&figure);
    let mut curves = Vec::new();
    let mut regions = Vec::new();
    for (polygon, rings) in polygons.iter().enumerate() {
        for (i, ring) in rings.iter().enumerate() {
            curves.extend(edge_curves(regions.len(), ring, true));
            regions.push(Region::Ring { polygon, is_hole: i > 0, vertices: ring.clone() });
        }
    }
    for (i, line) in polylines.iter().enumerate() {
        curves.extend(edge_curves(1000 + i, line, false));
    }
    curves.extend(circles.iter().map(|&c| Curve::Circle(c)));
    regions.extend(circles.iter().map(|&c| Region::Disc(c)));
    let pairs = |i: usize| curves[i + 1..].iter().filter(|t| cross(&curves[i], t)).count() as u64;
    let crossings: u64 = (0..curves.len()).map(pairs).sum();
    prop_assert_eq!(figure.normalised().crossings, crossings);
    let expected = if crossings == 0 { misplaced(&regions) } else { 0 };
    prop_assert_eq!(figure.normalised().misplaced, expected);
    prop_assert_eq!(drawing.strict().is_ok(), crossings == 0 && expected == 0);
    if crossings == 0 {
        // Outer rings run counterclockwise, by their whole area.
        for chain in 0..figure.chains().len() {
            let ring = crate::drawing::chain(&figure, chain);
            let next = |i: usize| ring[(i + 1) % ring.len()];
            let area: f64 =
                ring.iter().enumerate().map(|(i, a)| a[0] * next(i)[1] - a[1] * next(i)[0]).sum();
            match figure.kinds()[chain] {
                ChainKind::Outer => prop_assert!(area > 0.0),
                ChainKind::Hole => prop_assert!(area < 0.0),
                _ => {}
            }
        }
    }
    Ok(Some((crossings, expected)))
}

fn ring(size: i64) -> impl Strategy<Value = Whole> {
    prop::collection::vec(prop::array::uniform2(0..size), 3..7)
}

/// A triangle or quadrilateral of its own, small, so that many lie apart or in another.
fn small_ring() -> impl Strategy<Value = Whole> {
    let corner = (0..14i64, 0..14i64, 1..12i64, 1..12i64, 0..3u8);
    corner.prop_map(|(x, y, w, h, shape)| match shape {
        0 => vec![[x, y], [x + w, y], [x + w, y + h], [x, y + h]],
        1 => vec![[x, y], [x, y + h], [x + w, y]],
        _ => vec![[x, y], [x + w, y + 1], [x + 1, y + h]],
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, ..ProptestConfig::default() })]

    #[test]
    fn crossings_of_a_ring(ring in ring(5), scale in prop_oneof![Just(1.0), Just(0.5f64.powi(100)), Just(2f64.powi(150))]) {
        compare(&[vec![ring]], &[], &[], scale)?;
    }

    #[test]
    fn crossings_of_polylines_and_rings(
        rings in prop::collection::vec(ring(9), 0..2),
        lines in prop::collection::vec(prop::collection::vec(prop::array::uniform2(0..9i64), 2..5), 1..4),
    ) {
        let polygons: Vec<_> = rings.into_iter().map(|ring| vec![ring]).collect();
        compare(&polygons, &lines, &[], 1.0)?;
    }

    #[test]
    fn places_of_rings_and_circles(
        polygons in prop::collection::vec(prop::collection::vec(small_ring(), 1..3), 0..4),
        circles in prop::collection::vec((0..16i64, 0..16i64, 1..6i64), 0..4),
        scale in prop_oneof![Just(1.0), Just(0.5)],
    ) {
        let circles: Vec<[i64; 3]> = circles.into_iter().map(|(x, y, r)| [x, y, r]).collect();
        compare(&polygons, &[], &circles, scale)?;
    }
}

/// Squares and circles one in another, in any order, with any roles: nothing crosses, so that only places count.
#[test]
fn places_of_what_does_not_cross() {
    let mut state = 1u64;
    let mut random = |n: u64| {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) % n
    };
    let mut seen = [0; 2];
    for _ in 0..3000 {
        let (mut rings, mut circles) = (Vec::new(), Vec::new());
        for column in 0..2 {
            for depth in 0..1 + random(5) as i64 {
                let (x, r) = (100 * column + random(3) as i64, 40 - 8 * depth);
                match random(4) {
                    0 => circles.push([x, 0, r - 4]),
                    _ => {
                        let r = r / 2;
                        rings.push(vec![[x - r, -r], [x + r, -r], [x + r, r], [x - r, r]]);
                    }
                }
            }
        }
        let mut polygons: Vec<Vec<Whole>> = Vec::new();
        while !rings.is_empty() {
            let ring = rings.swap_remove(random(rings.len() as u64) as usize);
            match polygons.last_mut() {
                Some(rings) if random(2) == 0 => rings.push(ring),
                _ => polygons.push(vec![ring]),
            }
        }
        if let Ok(Some((0, misplaced))) = compare(&polygons, &[], &circles, 1.0) {
            seen[usize::from(misplaced > 0)] += 1;
        } else {
            compare(&polygons, &[], &circles, 1.0).unwrap();
        }
    }
    assert!(seen.iter().all(|&n| n > 100), "{seen:?}");
}

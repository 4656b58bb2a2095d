//! The flow of the distance to the samples by its definitions alone (Giesen, Ramos, Sadri, section 2): nothing of the library but the order of the coordinates. Critical points are looked
//! for among all sets of samples, orbits followed in small steps.

use crate::flow::{all_inner, dot, flow, sign, sub};
use crate::sets::Random;
use medax::flow::Flow;
use medax::{Job, NONE};
use std::collections::{BTreeMap, BTreeSet};

type Point = [f64; 3];

/// The barycentric coordinates of the centre of the smallest sphere through all the points, by Gauss's algorithm on 2 (p_j - p_0) . sum of b_i (p_i - p_0) = |p_j - p_0|^2.
fn center(points: &[Point]) -> Vec<f64> {
    let edges: Vec<Point> = points[1..].iter().map(|&p| sub(p, points[0])).collect();
    let n = edges.len();
    let mut rows: Vec<Vec<f64>> = (0..n)
        .map(|j| {
            let row = (0..n).map(|i| 2.0 * dot(edges[j], edges[i]));
            row.chain([dot(edges[j], edges[j])]).collect()
        })
        .collect();
    for i in 0..n {
        for j in 0..n {
            if i != j {
                let (factor, pivot) = (rows[j][i] / rows[i][i], rows[i].clone());
                rows[j].iter_mut().zip(pivot).for_each(|(x, y)| *x -= factor * y);
            }
        }
    }
    let others: Vec<f64> = (0..n).map(|i| rows[i][n] / rows[i][i]).collect();
    [1.0 - others.iter().sum::<f64>()].into_iter().chain(others).collect()
}

/// The centre of the smallest sphere through all the points, if their hull holds it.
pub fn held_center(points: &[Point]) -> Option<Point> {
    let weights = center(points);
    let is_held = weights.iter().all(|&w| w > 0.0);
    let at = |k: usize| points.iter().zip(&weights).map(|(p, w)| w * p[k]).sum();
    is_held.then(|| std::array::from_fn(at))
}

fn distance(a: Point, b: Point) -> f64 {
    dot(sub(a, b), sub(a, b)).sqrt()
}

/// The sets of one to four of some elements.
fn small_sets(elements: &[usize]) -> Vec<Vec<usize>> {
    let mut sets: Vec<Vec<usize>> = vec![Vec::new()];
    let mut begin = 0;
    for _ in 0..4 {
        let end = sets.len();
        for i in begin..end {
            let larger = elements.iter().filter(|&&v| sets[i].last().is_none_or(|&last| v > last));
            let larger: Vec<_> = larger.map(|&v| [&sets[i][..], &[v]].concat()).collect();
            sets.extend(larger);
        }
        begin = end;
    }
    sets.split_off(1)
}

/// A set of at most 64 samples.
struct Samples<'a>(&'a [Point]);

impl Samples<'_> {
    /// Every set of samples with the centre of its smallest sphere inside its hull, and no other sample in
    /// that sphere; and the centre.
    fn critical(&self) -> BTreeMap<Vec<usize>, Point> {
        let all: Vec<usize> = (0..self.0.len()).collect();
        let mut critical = BTreeMap::new();
        for set in small_sets(&all) {
            let corners: Vec<Point> = set.iter().map(|&v| self.0[v]).collect();
            let Some(at) = held_center(&corners) else { continue };
            let radius = distance(corners[0], at);
            let mut others = all.iter().filter(|v| !set.contains(v));
            if others.all(|&v| distance(self.0[v], at) > radius) {
                critical.insert(set, at);
            }
        }
        critical
    }

    /// The distance to the samples, and those that are so near but for a tolerance, as bits.
    fn nearest(&self, x: Point, tolerance: f64) -> (f64, u64) {
        let mut squares = [f64::INFINITY; 64];
        let mut least = f64::INFINITY;
        for (square, &p) in squares.iter_mut().zip(self.0) {
            *square = dot(sub(p, x), sub(p, x));
            least = least.min(*square);
        }
        let distance = least.sqrt();
        let most = (distance + tolerance) * (distance + tolerance);
        let bits = (0..self.0.len()).map(|v| u64::from(squares[v] <= most) << v);
        (distance, bits.sum())
    }

    /// The centre of the smallest ball that holds some samples, and the samples on whose sphere that is: one to four.
    fn smallest_ball(&self, bits: u64) -> (Point, Vec<usize>) {
        let set: Vec<usize> = (0..self.0.len()).filter(|v| bits >> v & 1 == 1).collect();
        let balls = small_sets(&set).into_iter().filter_map(|few| {
            let corners: Vec<Point> = few.iter().map(|&v| self.0[v]).collect();
            let at = held_center(&corners)?;
            let radius = distance(corners[0], at) * (1.0 + 1e-12);
            let holds_all =
                set.iter().all(|&v| few.contains(&v) || distance(self.0[v], at) <= radius);
            holds_all.then_some((at, few))
        });
        balls.min_by_key(|(_, few)| few.len()).expect("a set of points has a smallest ball")
    }

    /// The maximum where the orbit of a point ends, followed in steps of `x += step (x - d) / h`; empty at infinity, `None` if it takes too long.
    ///
    /// d is the centre of the smallest ball of the samples that are nearest but for a tolerance. It is in the hull of the samples: what has left the hull goes away from it forever.
    fn end(
        &self,
        mut x: Point,
        step: f64,
        maxima: &BTreeSet<Vec<usize>>,
        (middle, radius): (Point, f64),
    ) -> Option<Vec<usize>> {
        let (mut last, mut driver) = (0, [0.0; 3]);
        for _ in 0..1_000_000 {
            let (h, nearest) = self.nearest(x, 2.0 * step);
            if nearest != last {
                let (at, few) = self.smallest_ball(nearest);
                if maxima.contains(&few) {
                    return Some(few);
                }
                (last, driver) = (nearest, at);
            }
            let away = sub(x, driver);
            x = std::array::from_fn(|k| x[k] + step * away[k] / h);
            if distance(x, middle) > radius {
                return Some(Vec::new());
            }
        }
        None
    }
}

/// Sets of 30 points in general position: in a cube, near a sphere, on two parallel grids, all of them moved a little.
fn clouds() -> Vec<(&'static str, Vec<Point>)> {
    let mut random = Random(2010);
    let cube = (0..30).map(|_| random.cube()).collect();
    let sphere = (0..30).map(|_| {
        let radius = 0.9 + 0.2 * random.unit();
        random.sphere().map(|x| radius * x)
    });
    let sphere = sphere.collect();
    let grids = (0..30).map(|i| {
        let at = [i % 5, i / 5 % 3, 2 * (i / 15)].map(f64::from);
        let shift = random.cube();
        std::array::from_fn(|k| at[k] + 0.1 * shift[k])
    });
    vec![("cube", cube), ("sphere", sphere), ("grids", grids.collect())]
}

/// The middle and the diagonal of a box.
fn bounds(points: &[Point]) -> (Point, f64) {
    let extreme = |pick: fn(f64, f64) -> f64| -> Point {
        std::array::from_fn(|k| points.iter().map(|p| p[k]).fold(points[0][k], pick))
    };
    let (low, high) = (extreme(f64::min), extreme(f64::max));
    (std::array::from_fn(|k| (low[k] + high[k]) / 2.0), distance(low, high))
}

/// The corners of a row of the critical points.
fn corners(flow: &Flow, row: u32) -> Vec<usize> {
    let corners = flow.critical().corners()[row as usize].into_iter().filter(|&v| v != NONE);
    let mut corners: Vec<usize> = corners.map(|v| v as usize).collect();
    corners.sort_unstable();
    corners
}

#[test]
fn critical_points_are_those_of_the_definition() {
    for (name, rows) in clouds() {
        let flow = flow(&rows, all_inner, &Job::default());
        let expected = Samples(flow.dual().triangulation().coords()).critical();
        let mut count = [0; 4];
        for (row, (&at, &distance_there)) in
            (0..).zip(flow.critical().points().iter().zip(flow.critical().distances()))
        {
            let corners = corners(&flow, row);
            count[corners.len() - 1] += 1;
            let simplex = flow.critical().simplices()[row as usize];
            assert_eq!(simplex.dimension() + 1, corners.len(), "{name}");
            let there = expected.get(&corners).unwrap_or_else(|| panic!("{name}: {corners:?}"));
            assert!(distance(*there, at) < 1e-9, "{name}: {corners:?}");
            let coords = flow.dual().triangulation().coords();
            for &v in &corners {
                assert!((distance(coords[v], at) - distance_there).abs() < 1e-12, "{name}");
            }
        }
        assert_eq!(flow.critical().len(), expected.len(), "{name}");
        assert!(count.iter().all(|&count| count > 0), "{name}: {count:?}");
    }
}

/// Steps are so small that the two ends differ for one orbit in a hundred at most, and only where orbits that begin nearby end where the slow one does.
#[test]
fn orbits_end_where_small_steps_lead() {
    for (name, rows) in clouds() {
        let flow = flow(&rows, all_inner, &Job::default());
        let samples = Samples(flow.dual().triangulation().coords());
        let (middle, diagonal) = bounds(samples.0);
        let maxima = samples.critical().into_keys().filter(|set| set.len() == 4).collect();
        let mut random = Random(9);
        let starts: Vec<Point> = (0..1000)
            .map(|_| {
                let shift = random.cube();
                std::array::from_fn(|k| middle[k] + diagonal * 0.6 * (shift[k] - 0.5))
            })
            .collect();
        let ends = |starts: &[Point]| -> Vec<Vec<usize>> {
            let orbits = flow.orbits(starts, &Job::default()).unwrap();
            let end = |&end: &u32| if end == NONE { Vec::new() } else { corners(&flow, end) };
            orbits.ends().iter().map(end).collect()
        };
        let found = ends(&starts);
        let (mut missed, mut infinite) = (0, 0);
        for (&start, end) in starts.iter().zip(&found) {
            let slow = samples.end(start, 1e-4 * diagonal, &maxima, (middle, diagonal));
            let slow = slow.unwrap_or_else(|| panic!("{name}: {start:?} takes too long"));
            infinite += usize::from(slow.is_empty());
            if slow != *end {
                missed += 1;
                let nearby: Vec<Point> = (0..64)
                    .map(|_| {
                        let (direction, share) = (random.sphere(), random.unit());
                        std::array::from_fn(|k| start[k] + 1e-3 * diagonal * share * direction[k])
                    })
                    .collect();
                assert!(
                    ends(&nearby).contains(&slow),
                    "{name}: {start:?} to {slow:?}, not {end:?}"
                );
            }
        }
        assert!(missed <= starts.len() / 100, "{name}: {missed}");
        assert!((100..900).contains(&infinite), "{name}: {infinite}");
    }
}

/// No step of an orbit is left out: wherever it is looked at, the orbit runs away from the centre of the smallest ball of the nearest samples.
#[test]
fn every_segment_of_an_orbit_runs_away_from_the_driver() {
    for (name, rows) in clouds() {
        let flow = flow(&rows, all_inner, &Job::default());
        let samples = Samples(flow.dual().triangulation().coords());
        let mut random = Random(10);
        let starts: Vec<Point> = (0..1000).map(|_| random.cube()).collect();
        let orbits = flow.orbits(&starts, &Job::default()).unwrap();
        let mut balls = BTreeMap::new();
        let mut driver = |x: Point| {
            let (_, nearest) = samples.nearest(x, 1e-9);
            balls.entry(nearest).or_insert_with(|| samples.smallest_ball(nearest)).0
        };
        let mut looked = 0;
        for (row, &end) in orbits.offsets().windows(2).zip(orbits.ends()) {
            let points = &orbits.points()[row[0] as usize..row[1] as usize];
            for pair in points.windows(2) {
                let along = sub(pair[1], pair[0]);
                let length = distance(pair[1], pair[0]);
                if length < 1e-4 {
                    continue;
                }
                for share in [0.0, 0.5, 0.99] {
                    let x = std::array::from_fn(|k| pair[0][k] + share * along[k]);
                    let away = sub(x, driver(x));
                    let cosine = dot(away, along) / (dot(away, away).sqrt() * length);
                    assert!(cosine > 1.0 - 1e-9, "{name}: {x:?} along {along:?}, not {away:?}");
                    looked += 1;
                }
            }
            let last = points[points.len() - 1];
            assert!(end == NONE || distance(last, driver(last)) < 1e-9, "{name}: {last:?}");
        }
        assert!(looked > 6000, "{name}: {looked}");
    }
}

/// Asserts that critical points lie in given places, and that in each the sum of (-1)^index is a given one: where samples are on the spheres, perturbed critical points cancel but for that.
fn assert_critical(rows: &[Point], expected: &[(Point, i64)]) {
    let flow = flow(rows, all_inner, &Job::default());
    let mut sums = vec![0; expected.len()];
    for (&simplex, &at) in flow.critical().simplices().iter().zip(flow.critical().points()) {
        let place = expected.iter().position(|&(place, _)| distance(place, at) < 1e-12);
        sums[place.unwrap_or_else(|| panic!("{simplex:?} at {at:?}"))] += sign(simplex);
    }
    for (sum, &(place, expected)) in sums.into_iter().zip(expected) {
        assert_eq!(sum, expected, "at {place:?}");
    }
}

/// The middle of two points.
fn middle(p: Point, q: Point) -> Point {
    std::array::from_fn(|k| (p[k] + q[k]) / 2.0)
}

#[test]
fn a_regular_tetrahedron_has_a_critical_point_in_each_of_its_sides() {
    let rows = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    let mut expected = vec![([0.0; 3], -1)];
    for (i, &p) in rows.iter().enumerate() {
        expected.extend([(p, 1), (p.map(|x| -x / 3.0), 1)]);
        expected.extend(rows[..i].iter().map(|&q| (middle(p, q), -1)));
    }
    assert_critical(&rows, &expected);
}

/// Above the middle of the longest side of a right triangle: that side's middle is the centre of the triangle, and the centre of the cell that of another triangle. Distances
/// only grow past both.
#[test]
fn right_angles_have_no_critical_points_but_those_that_cancel() {
    let [a, b, c] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]];
    let apex = [1.0, 1.0, 4.0];
    let samples = [a, b, c, apex].map(|p| (p, 1));
    let edges = [[a, b], [a, c], [a, apex], [b, apex], [c, apex]].map(|[p, q]| (middle(p, q), -1));
    // a, b and the apex: (1, t, 4t) with 1 + 17 t^2 = 17 (1 - t)^2.
    let triangles = [[17.0, 8.0, 32.0], [8.0, 17.0, 32.0]].map(|p| (p.map(|x| x / 17.0), 1));
    // b, c and the apex, as all four: (1, 1, z) with 2 + z^2 = (4 - z)^2.
    let ties = [([1.0, 1.0, 0.0], 0), ([1.0, 1.0, 1.75], 0)];
    assert_critical(
        &[a, b, c, apex],
        &[&samples[..], &edges[..], &triangles[..], &ties[..]].concat(),
    );
}

/// Squares of radius 5 at the heights 3 and -3, the second one turned by the angle whose sine is 7/25: all eight points are on one sphere, four on each circle.
#[test]
fn two_squares_above_each_other_have_the_critical_points_of_a_prism() {
    let quarters = |p: Point| {
        let [x, y, z] = p;
        [[x, y, z], [-y, x, z], [-x, -y, z], [y, -x, z]]
    };
    let (upper, lower) = (quarters([4.0, 3.0, 3.0]), quarters([3.0, 4.0, -3.0]));
    let rows = [upper, lower].concat();
    let mut expected: Vec<(Point, i64)> = rows.iter().map(|&p| (p, 1)).collect();
    let mut add = |p: Point, sum| expected.extend(quarters(p).map(|p| (p, sum)));
    for square in [upper, lower] {
        add(middle(square[0], square[1]), -1);
    }
    // The edges between the squares, of length squared 38 and 72.
    add(middle(upper[0], lower[0]), -1);
    add(middle(upper[0], lower[3]), -1);
    // The triangles between the squares: of (4, 3, 3), (3, 4, -3) and (4, -3, -3), and what half a turn about the x axis makes of it.
    let center = [196.0, 28.0, -28.0].map(|x| x / 51.0);
    add(center, 1);
    add([center[0], -center[1], -center[2]], 1);
    expected.extend([([0.0, 0.0, 3.0], 1), ([0.0, 0.0, -3.0], 1), ([0.0; 3], -1)]);
    assert_critical(&rows, &expected);
}

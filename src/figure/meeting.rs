//! Whether edges and circles have points in common, exactly.
//!
//! # Bounds
//!
//! With u = 2^-53: a squared difference of coordinates has 3 roundings, a sum of two 4, the square of a radius 1, that of a sum or
//! difference of radii 3, and comparing takes one more: at most 5 u of the sum of what is compared, and 8 u leaves room. The squared area has an error of
//! at most 9 u m^2, where m is the sum of the absolute values of its two products, and what it is compared with 6 u of itself: 16 u leaves room. Within the range of the
//! predicates products of four differences neither overflow nor underflow. What is nearer goes to rational numbers.

use super::Point;
use crate::predicates::{Sign, UNIT, is_acute, orient2d};
use num_rational::BigRational;
use num_traits::Signed;

/// Centre and radius.
type Circle = [f64; 3];

/// What a curve has to do with another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Relation {
    /// They have no point in common.
    Apart,
    /// They have.
    Meets,
    /// They have none, and the first lies in the disc of the second.
    Within,
    /// They have none, and the second lies in the disc of the first.
    Around,
}

/// Whether two edges have a point in common.
pub(super) fn edges_meet([p, q]: [&Point; 2], [r, s]: [&Point; 2]) -> bool {
    let sides = [orient2d(p, q, r), orient2d(p, q, s)];
    if (sides[0] * sides[1]).is_positive() {
        return false;
    }
    if sides == [Sign::Zero; 2] {
        // On a line: then the edges are where their boxes are.
        return (0..2)
            .all(|i| p[i].min(q[i]) <= r[i].max(s[i]) && r[i].min(s[i]) <= p[i].max(q[i]));
    }
    !(orient2d(r, s, p) * orient2d(r, s, q)).is_positive()
}

/// Whether the edges from a common end `b` to `a` and to `c` have more than that end in common.
pub(super) fn folds(a: &Point, b: &Point, c: &Point) -> bool {
    // On a line, both are on one side of `b` if they are so in one coordinate in which `a` differs.
    let axis = usize::from(a[0] == b[0]);
    let side = |p: &Point| p[axis].total_cmp(&b[axis]);
    side(a) == side(c) && orient2d(a, b, c).is_zero()
}

/// What an edge has to do with a circle. An edge has nothing round it.
pub(super) fn edge_and_circle([p, q]: [&Point; 2], circle: &Circle) -> Relation {
    match [p, q].map(|end| side_of_circle(end, circle)) {
        // A disc is convex.
        [Sign::Negative, Sign::Negative] => Relation::Within,
        [Sign::Positive, Sign::Positive] if !enters(p, q, circle) => Relation::Apart,
        _ => Relation::Meets,
    }
}

/// What a circle has to do with another.
pub(super) fn circles(a: &Circle, b: &Circle) -> Relation {
    let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    let distance_2 = dx * dx + dy * dy;
    let compare = |radius: f64, exact: &dyn Fn() -> BigRational| {
        let difference = distance_2 - radius * radius;
        match difference.abs() > 8.0 * UNIT * (distance_2 + radius * radius) {
            true => Sign::of(difference),
            false => {
                let [dx, dy] = [0, 1].map(|i| rational(b[i]) - rational(a[i]));
                let radius = exact();
                sign(&(&dx * &dx + &dy * &dy - &radius * &radius))
            }
        }
    };
    if compare(a[2] + b[2], &|| rational(a[2]) + rational(b[2])).is_positive() {
        return Relation::Apart;
    }
    match compare(a[2] - b[2], &|| rational(a[2]) - rational(b[2])).is_negative() {
        false => Relation::Meets,
        true if a[2] < b[2] => Relation::Within,
        true => Relation::Around,
    }
}

/// Negative for a point in the disc, zero on the circle.
pub(super) fn side_of_circle(p: &Point, circle: &Circle) -> Sign {
    let [dx, dy] = [p[0] - circle[0], p[1] - circle[1]];
    let (distance_2, radius_2) = (dx * dx + dy * dy, circle[2] * circle[2]);
    let difference = distance_2 - radius_2;
    if difference.abs() > 8.0 * UNIT * (distance_2 + radius_2) {
        return Sign::of(difference);
    }
    let [dx, dy] = [0, 1].map(|i| rational(p[i]) - rational(circle[i]));
    let radius = rational(circle[2]);
    sign(&(&dx * &dx + &dy * &dy - &radius * &radius))
}

/// Whether an edge with both ends outside a disc meets it.
fn enters(p: &Point, q: &Point, circle: &Circle) -> bool {
    let raised = |p: &Point| [p[0], p[1], 0.0];
    let [a, b, c] = [raised(p), raised(q), [circle[0], circle[1], 0.0]];
    // The point of the line that is nearest to the centre is on the edge, and no farther than the radius.
    is_acute(&a, &c, &b) && is_acute(&b, &c, &a) && !line_side(p, q, circle).is_positive()
}

/// The sign of the distance of a line from a circle's centre less the radius: of the squared area of p, q and the centre, doubled, less the
/// square of the radius times that of the edge.
fn line_side(p: &Point, q: &Point, circle: &Circle) -> Sign {
    let [ex, ey] = [q[0] - p[0], q[1] - p[1]];
    let [dx, dy] = [circle[0] - p[0], circle[1] - p[1]];
    let (left, right) = (ex * dy, ey * dx);
    let (area, size) = (left - right, left.abs() + right.abs());
    let limit = circle[2] * circle[2] * (ex * ex + ey * ey);
    let difference = area * area - limit;
    if difference.abs() > 16.0 * UNIT * (size * size + limit) {
        return Sign::of(difference);
    }
    let [ex, ey] = [0, 1].map(|i| rational(q[i]) - rational(p[i]));
    let [dx, dy] = [0, 1].map(|i| rational(circle[i]) - rational(p[i]));
    let (area, radius) = (&ex * &dy - &ey * &dx, rational(circle[2]));
    let limit = &radius * &radius * (&ex * &ex + &ey * &ey);
    sign(&(&area * &area - limit))
}

/// The same number; every coordinate has one.
fn rational(x: f64) -> BigRational {
    BigRational::from_float(x).unwrap_or_default()
}

fn sign(x: &BigRational) -> Sign {
    if x.is_positive() {
        Sign::Positive
    } else if x.is_negative() {
        Sign::Negative
    } else {
        Sign::Zero
    }
}

//! Where segments and squares meet the medial axis.

use super::locate::{MedialPoint, Search};
use super::piece::Foot;
use crate::vector::{Vec3, add, dot, length, scale, sub};

/// A nearest point moves no faster than this with the point that it belongs to, but in the medial axis and beside the centres of spheres.
const FASTEST: f64 = 16.0;

/// The most quarters of a square, and quarters of these, that are looked at.
const MOST_QUARTERS: usize = 256;

/// A point, and what of the boundary is nearest to it.
type Place = (Vec3, Foot);

impl Search<'_> {
    /// Visits the points where a segment crosses the medial axis: its nearest points jump there, from the first foot to the second.
    ///
    /// Along a segment nearest points never go back. So halves of which both ends have theirs on one piece, or at one place, are no longer looked at, the others until they are as short as
    /// the tolerance: then what is far apart has jumped. Passed over is what leaves and comes back to a piece within the segment, and where the ends' nearest points
    /// are closer together than half of what a jump of the least object angle takes, or nine tenths of it in parts shorter than a hundredth of the distance.
    pub fn crossings(
        &self,
        ends: [Vec3; 2],
        least_angle: f64,
        visit: &mut impl FnMut(MedialPoint),
    ) {
        let half_chord = libm::sin(0.5 * least_angle);
        let mut waiting = vec![ends.map(|p| (p, self.sites.foot(p)))];
        while let Some([u, v]) = waiting.pop() {
            let apart = length(sub(u.0, v.0));
            if self.is_one_part(&[u, v], apart, half_chord) {
                continue;
            }
            let middle = scale(add(u.0, v.0), 0.5);
            if apart <= self.tolerance || middle == u.0 || middle == v.0 {
                visit_jump(self, &u, &v, visit);
                continue;
            }
            let middle = (middle, self.sites.foot(middle));
            waiting.extend([[middle, v], [u, middle]]);
        }
    }

    /// A point of the medial axis in a square with these corners, which go round it: a curve may pass through it, or the rim of a surface, without a side being crossed.
    ///
    /// Quarters of it are looked at, first those whose corners have their nearest points spread most, and a few hundred at most.
    pub fn in_square(&self, corners: [Vec3; 4], least_angle: f64) -> Option<MedialPoint> {
        let half_chord = libm::sin(0.5 * least_angle);
        let at = |p: Vec3| (p, self.sites.foot(p));
        let between = |p: &Place, q: &Place| at(scale(add(p.0, q.0), 0.5));
        let mut waiting = vec![corners.map(at)];
        for _ in 0..MOST_QUARTERS {
            let square = waiting.pop()?;
            let size = length(sub(square[0].0, square[2].0));
            if self.is_one_part(&square, size, half_chord) {
                continue;
            }
            let [a, b, c, d] = square;
            let middle = between(&a, &c);
            if size <= self.tolerance || middle.0 == a.0 || middle.0 == c.0 {
                let (_, u, v) = widest(&square);
                let mut found = None;
                visit_jump(self, &u, &v, &mut |point| found = Some(point));
                if found.is_some_and(|point| point.object_angle >= least_angle) {
                    return found;
                }
                continue;
            }
            let [ab, bc, cd, da] = [(a, b), (b, c), (c, d), (d, a)].map(|(p, q)| between(&p, &q));
            let mut quarters = [
                [a, ab, middle, da],
                [ab, b, bc, middle],
                [middle, bc, c, cd],
                [da, middle, cd, d],
            ];
            // The last is looked at first.
            quarters.sort_by(|s, t| spread(s).total_cmp(&spread(t)));
            waiting.extend(quarters);
        }
        None
    }

    /// Whether all these points have their nearest points on one part of the boundary, as far as can be told.
    fn is_one_part(&self, places: &[Place], size: f64, half_chord: f64) -> bool {
        let first = &places[0].1;
        if places.iter().all(|(_, foot)| foot.piece == first.piece) {
            return true;
        }
        let nearest = places.iter().map(|(_, foot)| foot.distance_squared);
        // No point between them is nearer to the boundary.
        let radius = nearest.fold(f64::INFINITY, f64::min).sqrt() - 0.5 * size;
        // What moves without a jump moves little where the points are close together.
        let share = if size < 0.01 * radius { 0.9 } else { 0.5 };
        let (width, ..) = widest(places);
        width <= self.tolerance || width < share * 2.0 * radius * half_chord
    }
}

/// How far the nearest points of some points are spread: the sum of their squared distances. Unlike the largest one it is largest where a curve passes between the points.
fn spread(places: &[Place]) -> f64 {
    let of = |p: &Place, q: &Place| {
        let apart = sub(p.1.point, q.1.point);
        dot(apart, apart)
    };
    places.iter().flat_map(|p| places.iter().map(move |q| of(p, q))).sum()
}

/// The two of some points whose nearest points are farthest apart, and how far.
fn widest(places: &[Place]) -> (f64, Place, Place) {
    let mut widest = (0.0, places[0], places[0]);
    for (i, p) in places.iter().enumerate() {
        for q in &places[i + 1..] {
            let apart = length(sub(p.1.point, q.1.point));
            if apart > widest.0 {
                widest = (apart, *p, *q);
            }
        }
    }
    widest
}

/// Visits the medial point between two points next to each other, if their nearest points are farther apart than these can account for.
fn visit_jump(search: &Search<'_>, u: &Place, v: &Place, visit: &mut impl FnMut(MedialPoint)) {
    let jump = length(sub(u.1.point, v.1.point));
    if jump > FASTEST * length(sub(u.0, v.0)).max(search.tolerance) {
        visit(search.touching(&u.1, &v.1, u.0, u.1.distance_squared.sqrt()));
    }
}

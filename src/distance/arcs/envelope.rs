//! What is opposite each place of the boundary, and where that changes.

use super::feature::Place;
use super::walk::Walks;
use crate::distance::locate::{MedialPoint, Search};
use crate::distance::piece::Foot;
use crate::error::Result;
use crate::job::Run;
use crate::points::Bounds;
use crate::vector::{Vec3, add, length, scale, sub};

/// The features that one thread follows between two reports.
const BATCH: usize = 32;
/// How often an interval is divided at most.
const DEPTH: usize = 100;
/// An interval this short holds a change and nothing else.
const SHORT: f64 = 1e-10;
/// How often intervals without any ball are divided in search of one.
const BLIND: usize = 3;

/// The medial ball that touches a place of the boundary.
#[derive(Clone, Copy, Debug)]
pub(super) struct Touch {
    pub point: MedialPoint,
    /// The feature that it touches on the other side, and where.
    pub opposite: (u32, f64),
}

/// A place where what is opposite changes: a ball that touches three features or more; or one at the rim of the box beyond which nothing is looked at.
#[derive(Clone, Copy, Debug)]
pub(super) struct Break {
    pub u: f64,
    pub center: Vec3,
    pub radius: f64,
}

/// Medial balls as seen from the boundary.
#[derive(Clone, Copy)]
pub(super) struct Envelope<'a> {
    pub search: Search<'a>,
    pub walks: &'a Walks,
    pub rim: Bounds,
    pub run: &'a Run<'a>,
}

impl Envelope<'_> {
    /// The largest ball that touches the boundary at a place of a feature from its region; `None` if its centre lies beyond the rim.
    pub fn touch(&self, feature: usize, u: f64) -> Option<Touch> {
        let place = self.walks.features[feature].place(u);
        let piece = self.walks.pieces[feature];
        let foot = Foot { point: place.at, distance_squared: 0.0, piece };
        let far = 4.0 * self.rim.diagonal();
        let point = self.search.along(&foot, place.way, [0.0, far])?;
        if !self.is_in(point.center) {
            return None;
        }
        let opposite = self.walks.find(point.feet[1], point.pieces[1], point.center)?;
        Some(Touch { point, opposite })
    }

    fn is_in(&self, p: Vec3) -> bool {
        (0..2).all(|k| self.rim.min[k] <= p[k] && p[k] <= self.rim.max[k])
    }

    /// Finds the breaks of some features, which `breaks` has for each in its order. `hints` are places of features at which balls of others touch them: where nothing else shows that something
    /// is there.
    pub fn find_breaks(
        &self,
        features: &[usize],
        hints: &[Vec<f64>],
        breaks: &mut [Vec<Break>],
    ) -> Result<()> {
        let found =
            self.run.in_steps(features.chunks(BATCH).collect(), [0.0, 0.4], |features| {
                features.iter().map(|&f| self.breaks_of(f, &hints[f])).collect::<Result<Vec<_>>>()
            })?;
        for (&feature, found) in features.iter().zip(found.into_iter().flatten()) {
            breaks[feature] = found;
        }
        Ok(())
    }

    fn breaks_of(&self, feature: usize, hints: &[f64]) -> Result<Vec<Break>> {
        let mut places: Vec<f64> = hints.iter().copied().filter(|&u| u > 0.0 && u < 1.0).collect();
        places.push(0.5);
        places.sort_by(f64::total_cmp);
        places.dedup();
        let mut breaks = Vec::new();
        let mut last = (0.0, self.at_begin(feature));
        for u in places {
            let next = (u, self.touch(feature, u).map(|touch| touch.opposite));
            self.divide(feature, last, next, [0, 0], &mut breaks)?;
            last = next;
        }
        let end = self.at_end(feature);
        self.divide(feature, last, (1.0, end), [0, 0], &mut breaks)?;
        // A change just where the next feature begins shows in neither, if rounding gives either what it had.
        if let (false, Some(end)) = (self.walks.is_corner[feature], end)
            && let Some(begin) = self.at_begin(self.walks.after(feature))
            && !self.is_smooth(begin, end)
            && !self.is_one_place(begin, end)
        {
            breaks.extend(self.break_at(feature, 1.0));
        }
        Ok(breaks)
    }

    /// What is opposite where a feature begins: in a corner the side that ends there.
    fn at_begin(&self, feature: usize) -> Option<(u32, f64)> {
        let before = self.walks.before(feature);
        match self.walks.is_corner[before] {
            true => Some((before as u32, 1.0)),
            false => self.touch(feature, 0.0).map(|touch| touch.opposite),
        }
    }

    fn at_end(&self, feature: usize) -> Option<(u32, f64)> {
        match self.walks.is_corner[feature] {
            true => Some((self.walks.after(feature) as u32, 0.0)),
            false => self.touch(feature, 1.0).map(|touch| touch.opposite),
        }
    }

    /// Finds the breaks between two places, given what is opposite there.
    fn divide(
        &self,
        feature: usize,
        low: (f64, Option<(u32, f64)>),
        high: (f64, Option<(u32, f64)>),
        [depth, blind]: [usize; 2],
        breaks: &mut Vec<Break>,
    ) -> Result<()> {
        self.run.poll()?;
        let ((u, before), (v, after)) = (low, high);
        let between = match (before, after) {
            (None, None) if blind >= BLIND => return Ok(()),
            (None, None) | (None, Some(_)) | (Some(_), None) => None,
            (Some(a), Some(b)) if self.is_smooth(b, a) => return Ok(()),
            (Some(a), Some(b)) => self.meeting(feature, [u, v], [a.0, b.0]),
        };
        if v - u <= SHORT || depth >= DEPTH {
            breaks.extend(self.break_at(feature, 0.5 * (u + v)));
            return Ok(());
        }
        let mut middle = 0.5 * (u + v);
        let mut touch = None;
        if let Some((meeting, radius)) = between {
            let met = self.touch(feature, meeting);
            if let Some(point) = met.map(|touch| touch.point)
                && (point.radius - radius).abs() <= 1e-9 * radius
                && [before, after].iter().all(|&other| self.touches(&point, other))
            {
                breaks.push(Break { u: meeting, center: point.center, radius: point.radius });
                return Ok(());
            }
            // Something else is in between, unless only the lines that bear both meet here.
            let is_new = |touch: &Touch| {
                [before, after].iter().flatten().all(|other| other.0 != touch.opposite.0)
            };
            if let Some(met) = met.filter(|met| is_new(met) && u < meeting && meeting < v) {
                (middle, touch) = (meeting, Some(met));
            }
        }
        let opposite = touch.or_else(|| self.touch(feature, middle)).map(|touch| touch.opposite);
        let blind = blind + usize::from(opposite.is_none());
        self.divide(feature, low, (middle, opposite), [depth + 1, blind], breaks)?;
        self.divide(feature, (middle, opposite), high, [depth + 1, blind], breaks)
    }

    /// Whether a ball touches a feature itself, and not only the line that bears it.
    fn touches(&self, ball: &MedialPoint, other: Option<(u32, f64)>) -> bool {
        other.is_some_and(|(other, _)| {
            let distance = self.walks.features[other as usize].distance(ball.center);
            distance <= ball.radius * (1.0 + 1e-9)
        })
    }

    fn break_at(&self, feature: usize, u: f64) -> Option<Break> {
        let touch = self.touch(feature, u).or_else(|| {
            // The rim is here: just on this side of it there is a ball.
            [u - SHORT, u + SHORT].into_iter().find_map(|u| self.touch(feature, u.clamp(0.0, 1.0)))
        })?;
        let MedialPoint { center, radius, .. } = touch.point;
        Some(Break { u, center, radius })
    }

    /// Whether the walk goes on smoothly from one place to another one that is the same feature or the next one or two.
    fn is_smooth(&self, from: (u32, f64), to: (u32, f64)) -> bool {
        let mut feature = from.0 as usize;
        for _ in 0..3 {
            if feature == to.0 as usize {
                return true;
            }
            if self.walks.is_corner[feature] {
                return false;
            }
            feature = self.walks.after(feature);
        }
        false
    }

    /// Whether two places of features are one but for rounding.
    fn is_one_place(&self, a: (u32, f64), b: (u32, f64)) -> bool {
        let [p, q] = [a, b].map(|(feature, u)| self.walks.features[feature as usize].place(u).at);
        length(sub(p, q)) <= 1e-9 * self.search.sites.size()
    }

    /// Where a ball that touches a feature touches two others, and its radius.
    fn meeting(&self, feature: usize, [u, v]: [f64; 2], others: [u32; 2]) -> Option<(f64, f64)> {
        let [a, b] = others.map(|other| &self.walks.features[other as usize]);
        let radii = |w: f64| {
            let place: Place = self.walks.features[feature].place(w);
            [a.radius_from(&place), b.radius_from(&place)]
        };
        // The first is opposite at the first end, so that its ball is the smaller one there.
        let is_first = |w: f64| {
            let [a, b] = radii(w);
            a < b
        };
        let (mut low, mut high) = (u, v);
        if !is_first(low) && !is_first(low + 1e-9 * (v - u))
            || is_first(high) && is_first(high - 1e-9 * (v - u))
        {
            return None;
        }
        loop {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            match is_first(middle) {
                true => low = middle,
                false => high = middle,
            }
        }
        let [a, b] = radii(low);
        let radius = a.min(b);
        let place = self.walks.features[feature].place(low);
        let center = add(place.at, scale(place.way, radius));
        (radius.is_finite() && self.is_in(center)).then_some((low, radius))
    }
}

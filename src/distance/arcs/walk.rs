//! Walks along the boundary, with the region on the left.

use super::feature::{Feature, angle, clockwise};
use crate::distance::piece::Piece;
use crate::distance::sites::Sites;
use crate::error::{ElementKind, Error, Result, Status};
use crate::job::{Room, Run};
use crate::vector::{Vec3, cross, dot, sub};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::ops::Range;

/// A corner less than this from straight is none: the arc that ends in it has as small an object angle, which rounding hides.
const STRAIGHT: f64 = 2e-7;
/// A point that is nearer than this share of the size to a circle is a point of it.
const ON_CIRCLE: f64 = 1e-15;

/// Closed walks round what is connected of the boundary, as features one after the other.
///
/// Invariants: `walks` are ranges of `features` that follow one another; `is_corner[i]` says that feature `i` meets the next one of its walk in a corner of less than half a turn,
/// of which the region has no fan; all other features go on into each other smoothly. `pieces[i]` is the piece of a side or a circle, for a fan one of those that end at the point.
#[derive(Clone, Debug, Default)]
pub(super) struct Walks {
    pub features: Vec<Feature>,
    pub pieces: Vec<u32>,
    pub walks: Vec<Range<usize>>,
    pub walk_of: Vec<u32>,
    pub is_corner: Vec<bool>,
    /// The two sides of each segment, the inside and the outside of each circle, or of that which a point lies on, in this order; `u32::MAX` for other pieces.
    pub of_piece: Vec<[u32; 2]>,
    /// The fans round each end of a segment, by its coordinates, which ascend.
    pub fans: Vec<(Vec3, u32)>,
}

/// A directed segment.
#[derive(Clone, Copy)]
struct HalfEdge {
    from: Vec3,
    to: Vec3,
    piece: u32,
    is_reversed: bool,
}

impl Walks {
    /// Errors: [`Status::Unsupported`] with the row of a piece for lines and rays, which have no end; those of the job.
    pub fn new(sites: &Sites, room: &mut Room<'_>, run: &Run<'_>) -> Result<Self> {
        let mut walks = Walks {
            of_piece: room.filled(sites.pieces().len(), [u32::MAX; 2])?,
            ..Walks::default()
        };
        let mut halves = Vec::new();
        let mut points = Vec::new();
        for (piece, shape) in (0..).zip(run.watch(sites.pieces())) {
            match *shape? {
                Piece::Segment([a, b]) if a != b => {
                    for (from, to, is_reversed) in [(a, b, false), (b, a, true)] {
                        room.push(&mut halves, HalfEdge { from, to, piece, is_reversed })?;
                    }
                }
                Piece::Segment([at, _]) | Piece::Point(at) => {
                    room.push(&mut points, (at, piece))?;
                }
                Piece::Sphere(center, radius) => {
                    for is_inside in [true, false] {
                        let number = walks.features.len() as u32;
                        walks.of_piece[piece as usize][usize::from(!is_inside)] = number;
                        walks.push(Feature::Circle { center, radius, is_inside }, piece, room)?;
                        walks.close(room)?;
                    }
                }
                Piece::Ray(..) | Piece::Line(..) | Piece::Triangle(_) => {
                    let message =
                        "lines and rays have no arcs: give segments that reach beyond the box";
                    let error = Error::new(Status::Unsupported, message);
                    return Err(error.at(ElementKind::Row, u64::from(piece)));
                }
            }
        }
        walks.follow(halves, room, run)?;
        walks.add_points(sites, points, room)?;
        walks.fans.sort_by(|(p, i), (q, j)| order(p, q).then(i.cmp(j)));
        Ok(walks)
    }

    /// Walks along the half-edges, each to the next one clockwise round its end.
    fn follow(
        &mut self,
        mut halves: Vec<HalfEdge>,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<()> {
        let key = |half: &HalfEdge| angle(sub(half.to, half.from));
        halves.sort_by(|a, b| {
            order(&a.from, &b.from).then(key(a).total_cmp(&key(b))).then(order(&a.to, &b.to))
        });
        // A segment that stands there twice is one.
        halves.dedup_by(|a, b| a.from == b.from && a.to == b.to);
        let star = |p: &Vec3| {
            let begin = halves.partition_point(|half| order(&half.from, p).is_lt());
            begin..begin + halves[begin..].partition_point(|half| half.from == *p)
        };
        let mut is_done = room.filled(halves.len(), false)?;
        for start in run.watch(0..halves.len()) {
            let mut at = start?;
            if is_done[at] {
                continue;
            }
            while !is_done[at] {
                is_done[at] = true;
                let half = halves[at];
                let number = self.features.len() as u32;
                self.of_piece[half.piece as usize][usize::from(half.is_reversed)] = number;
                self.push(Feature::Side { ends: [half.from, half.to] }, half.piece, room)?;
                let star = star(&half.to);
                let back = star
                    .clone()
                    .find(|&i| halves[i].to == half.from)
                    .ok_or_else(|| Error::new(Status::Internal, "a segment has no way back"))?;
                // Angles ascend counterclockwise.
                let next = if back == star.start { star.end - 1 } else { back - 1 };
                let (in_way, out) = (sub(half.from, half.to), sub(halves[next].to, half.to));
                let sector = if next == back { TAU } else { clockwise(in_way, out) };
                if sector > PI + STRAIGHT {
                    let first = angle(in_way) - FRAC_PI_2;
                    let number = self.features.len() as u32;
                    let fan = Feature::Fan { at: half.to, first, turn: sector - PI };
                    self.push(fan, half.piece, room)?;
                    room.push(&mut self.fans, (half.to, number))?;
                } else if sector < PI - STRAIGHT {
                    self.is_corner[number as usize] = true;
                }
                at = next;
            }
            self.close(room)?;
        }
        Ok(())
    }

    /// Walks round single points, each once.
    fn add_points(
        &mut self,
        sites: &Sites,
        mut points: Vec<(Vec3, u32)>,
        room: &mut Room<'_>,
    ) -> Result<()> {
        let is_circle = |piece: u32| matches!(sites.pieces()[piece as usize], Piece::Sphere(..));
        let mut feet = Vec::new();
        points.sort_by(|(p, i), (q, j)| order(p, q).then(i.cmp(j)));
        points.dedup_by(|(p, _), (q, _)| p == q);
        let mut ends: Vec<Vec3> = self.fans.iter().map(|(p, _)| *p).collect();
        ends.sort_by(order);
        for (at, piece) in points {
            // A point at which segments end is seen through their fans, if at all; one on a circle is the circle's.
            sites.feet_within(at, ON_CIRCLE * sites.size(), &mut feet);
            if let Some(circle) = feet.iter().find(|foot| is_circle(foot.piece)) {
                self.of_piece[piece as usize] = self.of_piece[circle.piece as usize];
                continue;
            }
            if ends.binary_search_by(|p| order(p, &at)).is_err() {
                let number = self.features.len() as u32;
                self.push(Feature::Fan { at, first: PI, turn: TAU }, piece, room)?;
                room.push(&mut self.fans, (at, number))?;
                self.close(room)?;
            }
        }
        Ok(())
    }

    fn push(&mut self, feature: Feature, piece: u32, room: &mut Room<'_>) -> Result<()> {
        room.push(&mut self.features, feature)?;
        room.push(&mut self.pieces, piece)?;
        room.push(&mut self.walk_of, self.walks.len() as u32)?;
        room.push(&mut self.is_corner, false)
    }

    /// Ends the walk.
    fn close(&mut self, room: &mut Room<'_>) -> Result<()> {
        let begin = self.walks.last().map_or(0, |walk| walk.end);
        room.push(&mut self.walks, begin..self.features.len())
    }

    /// The feature of the boundary that has a nearest point of a medial ball, and where on it.
    pub fn find(&self, foot: Vec3, piece: u32, center: Vec3) -> Option<(u32, f64)> {
        let begin = self.fans.partition_point(|(p, _)| order(p, &foot).is_lt());
        let fans = self.fans[begin..].iter().take_while(|(p, _)| *p == foot);
        let with = |number: u32| (number, self.features[number as usize].number(center));
        let seen = fans.map(|&(_, number)| number).find(|&number| {
            // At its ends a fan goes on into sides, and either is as good.
            self.features[number as usize].is_seen_from(center)
        });
        if let Some(fan) = seen {
            return Some(with(fan));
        }
        let [first, second] = self.of_piece[piece as usize];
        let is_second = match self.features.get(first as usize) {
            Some(Feature::Side { ends: [a, b] }) => cross(sub(*b, *a), sub(center, *a))[2] < 0.0,
            Some(Feature::Circle { center: middle, radius, .. }) => {
                let out = sub(center, *middle);
                dot(out, out) > radius * radius
            }
            Some(Feature::Fan { .. }) | None => false,
        };
        let number = if is_second { second } else { first };
        (number != u32::MAX).then(|| with(number))
    }

    /// The feature that comes before another one in its walk.
    pub fn before(&self, feature: usize) -> usize {
        let walk = &self.walks[self.walk_of[feature] as usize];
        if feature == walk.start { walk.end - 1 } else { feature - 1 }
    }

    /// The feature that comes after another one in its walk.
    pub fn after(&self, feature: usize) -> usize {
        let walk = &self.walks[self.walk_of[feature] as usize];
        if feature + 1 == walk.end { walk.start } else { feature + 1 }
    }
}

/// The lexicographic order of coordinates.
fn order(p: &Vec3, q: &Vec3) -> std::cmp::Ordering {
    p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1]))
}

//! APPROXMA2D: the plane covered with overlapping circles (Stolpner, Whitesides, section VI).

use super::bound::{largest_missed_angle, samples_for};
use super::decide::Ball;
use super::field::{Cover, FieldAxis, FieldOptions};
use super::locate::{MedialPoint, Search};
use super::pairs::SitePairs;
use super::sites::Sites;
use crate::error::{Error, Result, Status};
use crate::job::{Room, Run};
use crate::medial::Side;
use crate::vector::Vec3;
use std::f64::consts::{PI, SQRT_2};
use std::sync::Arc;

/// The squares that one thread looks at between two reports.
const BATCH: usize = 64;
/// How often a square is divided further where what was found did not pass the thresholds.
const REFINED: u32 = 4;
/// The most squares at once.
const LIMIT: usize = 1 << 28;
/// The least density, beside the box.
pub(super) const FINEST: f64 = 1.0 / (1 << 20) as f64;

/// A square that is still to be looked at.
#[derive(Clone, Copy, Debug)]
struct Square {
    center: Vec3,
    half: f64,
    /// How often it was divided for better points.
    refined: u32,
}

/// What became of a square.
enum Fate {
    Nothing,
    Divided(Square),
    Covered(Cover, Vec<MedialPoint>, usize),
}

pub(super) fn axis(
    sites: &Arc<Sites>,
    options: FieldOptions,
    pairs: SitePairs,
    run: &Run<'_>,
) -> Result<FieldAxis> {
    let samples = match options.samples {
        0 => samples_for(options.bound),
        samples => samples,
    };
    let options = FieldOptions { samples, ..options };
    let directions = sites.even_directions(samples).collect();
    let search = sites.search(options.decide)?;
    let plane = Plane { search, options, pairs: pairs.clone(), directions };
    let mut room = Room::new(run);
    let mut axis = FieldAxis {
        sites: sites.clone(),
        options,
        pairs,
        points: Vec::new(),
        cover_of_point: Vec::new(),
        covers: Vec::new(),
        unconfirmed: 0,
    };
    plane.check_density()?;
    let mut squares = plane.whole();
    while !squares.is_empty() {
        let centers: Vec<Vec3> = squares.iter().map(|square| square.center).collect();
        let is_inside = match options.side {
            Side::Both => vec![true; squares.len()],
            _ => sites.is_inside_in(&centers, run)?,
        };
        let parts: Vec<_> = squares.chunks(BATCH).zip(is_inside.chunks(BATCH)).collect();
        let fates = run.in_parallel(parts, |(squares, is_inside)| {
            run.poll()?;
            let fate = |(square, &is_inside): (&Square, &bool)| {
                let is_here = match options.side {
                    Side::Outer => !is_inside,
                    Side::Inner | Side::Both => is_inside,
                };
                plane.fate(*square, is_here)
            };
            Ok(squares.iter().zip(is_inside).map(fate).collect::<Vec<_>>())
        })?;
        let mut next = Vec::new();
        for fate in fates.into_iter().flatten() {
            match fate {
                Fate::Nothing => {}
                Fate::Divided(square) => {
                    room.grow(&mut next, 4)?;
                    next.extend(square.quarters());
                }
                Fate::Covered(cover, points, unconfirmed) => {
                    let number = axis.covers.len() as u32;
                    room.push(&mut axis.covers, cover)?;
                    for point in points {
                        room.push(&mut axis.points, point)?;
                        room.push(&mut axis.cover_of_point, number)?;
                    }
                    axis.unconfirmed += unconfirmed;
                }
            }
        }
        if next.len() > LIMIT || axis.covers.len() > LIMIT {
            let message = "the density or the least distance asks for more than 2^28 circles";
            return Err(Error::new(Status::LimitExceeded, message));
        }
        squares = next;
    }
    Ok(axis)
}

impl Square {
    fn quarters(self) -> [Square; 4] {
        let half = 0.5 * self.half;
        [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]].map(|[x, y]| Square {
            center: [self.center[0] + x * half, self.center[1] + y * half, 0.0],
            half,
            refined: self.refined,
        })
    }

    fn holds(&self, p: Vec3) -> bool {
        (0..2).all(|k| (p[k] - self.center[k]).abs() <= self.half)
    }
}

struct Plane<'a> {
    search: Search<'a>,
    options: FieldOptions,
    pairs: SitePairs,
    directions: Vec<Vec3>,
}

impl Plane<'_> {
    /// Errors: [`Status::LimitExceeded`] for a density that no one waits for.
    fn check_density(&self) -> Result<()> {
        let [min, max] = self.options.clip.unwrap_or_default();
        let longest = (max[0] - min[0]).max(max[1] - min[1]);
        match longest * FINEST > self.options.density {
            false => Ok(()),
            true => {
                let message = "the density is less than 2^-20 of the box";
                Err(Error::new(Status::LimitExceeded, message))
            }
        }
    }

    /// The box to look at, as squares in a row.
    fn whole(&self) -> Vec<Square> {
        let Some([min, max]) = self.options.clip else { return Vec::new() };
        let (width, height) = (max[0] - min[0], max[1] - min[1]);
        // A box without width may still have a boundary to look at.
        let half = (0.5 * width.min(height)).max(0.5 * width.max(height) / 1024.0);
        let count = |extent: f64| ((0.5 * extent / half).ceil() as usize).max(1);
        let (columns, rows) = (count(width), count(height));
        let center = |i: usize, j: usize| {
            [min[0] + half * (2 * i + 1) as f64, min[1] + half * (2 * j + 1) as f64, 0.0]
        };
        let places = (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j)));
        places.map(|(i, j)| Square { center: center(i, j), half, refined: 0 }).collect()
    }

    /// Drops a square, divides it, or looks at the circle round it.
    ///
    /// The circle must fit theorem 10 for every point p of the square that is as far from the boundary as is asked for: p lies in the hull of Theta, both ways from p to its nearest
    /// points leave the hull at L or more from p, and at L or more from these points; d >= 2L; and the bound on the object angle is the one that was asked for. With N points evenly
    /// spread L is at most 2 pi R / N, and the hull holds the circle of radius R cos(pi / N).
    fn fate(&self, square: Square, is_here: bool) -> Fate {
        let FieldOptions { density, min_distance, bound, samples, .. } = self.options;
        let is_between = |point: &MedialPoint| self.pairs.holds(self.search.sites, point);
        let foot = self.search.sites.foot(square.center);
        let distance = foot.distance_squared.sqrt();
        let reach = square.half * SQRT_2;
        if distance + reach < min_distance {
            return Fate::Nothing;
        }
        // No boundary comes into the square: all of it is on one side.
        if distance > reach && !is_here {
            return Fate::Nothing;
        }
        let turn = PI / samples as f64;
        let radius = reach / (libm::cos(turn) - 2.0 * turn);
        let gap = 2.0 * turn * radius;
        // The least distance of a point that the claim is for.
        let least = (distance - reach).max(min_distance);
        // Nearest points that are too near to each other to be told apart show no more than this angle. Where that is most of what is asked for, smaller circles are of no use.
        let blind = 2.0 * libm::asin((0.5 * self.search.tolerance / least).min(1.0));
        let missed = largest_missed_angle(gap, radius, least);
        let most = if 2.0 * blind <= bound { bound - blind } else { bound };
        let fits = distance >= radius + gap
            && 2.0 * radius <= density
            && missed.is_some_and(|angle| angle <= most);
        let missed = missed.map(|angle| angle + blind).filter(|&angle| angle <= bound);
        if !fits {
            return Fate::Divided(square);
        }
        let mut found: Vec<MedialPoint> = Vec::new();
        let ball = Ball { center: square.center, radius };
        let decision = self.search.examine(ball, &self.directions, |_, point| {
            found.push(point);
            is_between(&point)
        });
        let has_any = !found.is_empty();
        found.retain(|point| self.options.pass(point) && is_between(point));
        // A test that shows something that is not found then tells nothing.
        let is_open = !has_any && decision.unconfirmed > 0;
        if (has_any || is_open) && found.is_empty() && square.refined < REFINED {
            return Fate::Divided(Square { refined: square.refined + 1, ..square });
        }
        let found = chosen(found, &square);
        let missed_angle = match (has_any || is_open, found.is_empty()) {
            (true, true) => PI,
            (true, false) => 0.0,
            (false, _) => missed.unwrap_or(PI),
        };
        let cover = Cover {
            center: square.center,
            radius,
            half: square.half,
            gap: decision.gap,
            distance,
            found: found.len() as u32,
            missed_angle,
        };
        Fate::Covered(cover, found, decision.unconfirmed)
    }
}

/// Of the points of a circle one for each pair of pieces, that with the largest object angle; those in the square, and others only if there are none.
fn chosen(mut found: Vec<MedialPoint>, square: &Square) -> Vec<MedialPoint> {
    let pair = |point: &MedialPoint| {
        let [a, b] = point.pieces;
        [a.min(b), a.max(b)]
    };
    let is_out = |point: &MedialPoint| !square.holds(point.center);
    found.sort_by(|p, q| {
        let angles = || q.object_angle.total_cmp(&p.object_angle);
        let centers = || p.center.partial_cmp(&q.center).unwrap_or(std::cmp::Ordering::Equal);
        is_out(p).cmp(&is_out(q)).then(pair(p).cmp(&pair(q))).then_with(angles).then_with(centers)
    });
    if found.first().is_some_and(|p| !is_out(p)) {
        found.retain(|p| !is_out(p));
    }
    found.dedup_by_key(|point| pair(point));
    found
}

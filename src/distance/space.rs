//! APPROXMA3D: space divided into cubes, with spheres round them (Stolpner, Whitesides, section VII).

use super::decide::Ball;
use super::field::{Cover, FieldAxis, FieldOptions};
use super::locate::{MedialPoint, Search};
use super::pairs::SitePairs;
use super::piece::{Foot, Piece};
use super::sites::Sites;
use crate::error::{Error, Result, Status};
use crate::job::{Room, Run};
use crate::vector::{Vec3, add, cross, dot, length, scale, sub};
use std::f64::consts::PI;
use std::sync::Arc;

/// The points on a sphere if nobody says how many.
const SAMPLES: usize = 60;
/// The cubes that one thread looks at between two reports.
const BATCH: usize = 16;
/// How far the lattice is moved out of the middle of the box, as a share of the density: so that the axis of what is symmetric does not lie in planes of the lattice, nor in its lines.
const MOVED: Vec3 = [0.1318, 0.2071, 0.0787];
/// The most cubes at once, and the most along a side.
const LIMIT: usize = 1 << 28;

/// The cubes of one size: by their places in a lattice.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lattice {
    pub origin: Vec3,
    pub side: f64,
    /// The number of cubes along each axis.
    pub count: [u32; 3],
}

impl Lattice {
    /// The coarse cubes that fill the box to look at, and how often they are halved until their sides are no longer than the density.
    fn coarsest(options: &FieldOptions) -> Result<(Self, u32)> {
        let Some([min, max]) = options.clip else {
            return Err(Error::new(Status::Internal, "there is no box to look at"));
        };
        let extent = sub(max, min);
        let longest = extent.iter().copied().fold(0.0, f64::max);
        // Cubes of which the longest spheres are no larger than a sixteenth of the box are worth a look.
        let ratio = (longest / options.density).log2().ceil();
        if ratio > 20.0 {
            let message = "the density is less than 2^-20 of the box";
            return Err(Error::new(Status::LimitExceeded, message));
        }
        // Below 0 where the box is smaller than one cube.
        let levels = (ratio as u32).saturating_sub(3);
        let side = options.density * f64::from(1u32 << levels);
        // Room on both sides for the move.
        let count = extent.map(|x| ((x + 0.5 * options.density) / side).ceil() as u32);
        let origin = [0, 1, 2].map(|k| {
            let middle = 0.5 * (min[k] + max[k]) + MOVED[k] * options.density;
            middle - 0.5 * side * f64::from(count[k])
        });
        Ok((Lattice { origin, side, count }, levels))
    }

    /// That of the cubes that are not divided any further.
    pub fn finest(options: &FieldOptions) -> Result<Self> {
        let (mut lattice, levels) = Lattice::coarsest(options)?;
        (0..levels).for_each(|_| lattice.halve());
        Ok(lattice)
    }

    /// Divides each cube into eight.
    fn halve(&mut self) {
        self.side *= 0.5;
        self.count = self.count.map(|count| 2 * count);
    }

    /// The corner of a cube that is least in all coordinates.
    pub fn corner(&self, place: [u32; 3]) -> Vec3 {
        [0, 1, 2].map(|k| self.origin[k] + self.side * f64::from(place[k]))
    }

    /// The middle of a cube.
    pub fn middle(&self, place: [u32; 3]) -> Vec3 {
        self.corner(place).map(|x| x + 0.5 * self.side)
    }

    /// The cube that holds a point.
    pub fn place(&self, p: Vec3) -> [i64; 3] {
        [0, 1, 2].map(|k| ((p[k] - self.origin[k]) / self.side).floor() as i64)
    }
}

/// What became of a cube.
enum Fate {
    Nothing,
    Divided,
    /// A point in the cube, or, if there is none, one of the sphere outside the cube; where the boundary enters the sphere, for either of its sides.
    Found(Cover, Vec<MedialPoint>),
}

pub(super) fn axis(
    sites: &Arc<Sites>,
    options: FieldOptions,
    pairs: SitePairs,
    run: &Run<'_>,
) -> Result<FieldAxis> {
    let samples = match options.samples {
        0 => SAMPLES,
        samples => samples,
    };
    let options = FieldOptions { samples, ..options };
    let space = Space {
        search: sites.search(options.decide)?,
        options,
        pairs,
        directions: sites.even_directions(samples).collect(),
    };
    let (mut lattice, levels) = Lattice::coarsest(&options)?;
    let mut cubes = Vec::new();
    let [columns, rows, layers] = lattice.count;
    for z in 0..layers {
        for y in 0..rows {
            cubes.extend((0..columns).map(|x| [x, y, z]));
        }
    }
    let mut room = Room::new(run);
    for level in 0..=levels {
        let is_last = level == levels;
        let middles = room.collect(cubes.iter().map(|&place| lattice.middle(place)))?;
        let is_here = sites.are_on(options.side, &middles, run)?;
        let parts: Vec<_> = cubes.chunks(BATCH).zip(is_here.chunks(BATCH)).collect();
        let share = |level: u32| 0.25f64.powi((levels + 1 - level) as i32);
        let fates = run.in_steps(parts, [share(level), share(level + 1)], |(cubes, is_here)| {
            run.poll()?;
            let fate = |(&place, &is_here)| space.fate(&lattice, place, is_here, is_last);
            Ok(cubes.iter().zip(is_here).map(fate).collect::<Vec<_>>())
        })?;
        let fates = cubes.iter().zip(fates.into_iter().flatten());
        if is_last {
            let found = fates.flat_map(|(&place, fate)| match fate {
                Fate::Found(cover, points) => {
                    points.into_iter().map(|point| (place, cover, point)).collect()
                }
                _ => Vec::new(),
            });
            return space.gathered(sites, &lattice, found.collect(), run);
        }
        let mut next = Vec::new();
        for (place, _) in fates.filter(|(_, fate)| matches!(fate, Fate::Divided)) {
            room.grow(&mut next, 8)?;
            let eighth = |k: u32| [0, 1, 2].map(|axis| 2 * place[axis] + (k >> axis & 1));
            next.extend((0..8).map(eighth));
        }
        if next.len() > LIMIT {
            let message = "the density asks for more than 2^28 spheres";
            return Err(Error::new(Status::LimitExceeded, message));
        }
        cubes = next;
        lattice.halve();
    }
    Err(Error::new(Status::Internal, "the cubes have no last level"))
}

struct Space<'a> {
    search: Search<'a>,
    options: FieldOptions,
    pairs: SitePairs,
    directions: Vec<Vec3>,
}

impl Space<'_> {
    /// Drops a cube, has it divided, or finds a point in it.
    ///
    /// A sphere that the boundary enters tells nothing and is divided. Where it is small enough its points are followed away from their nearest points of the boundary all the same: the
    /// balls that are found so are medial balls, whatever else is in the sphere. So are those that touch the boundary in it from the other side: what is thinner than the cubes are may
    /// hold none of its points.
    fn fate(&self, lattice: &Lattice, place: [u32; 3], is_here: bool, is_last: bool) -> Fate {
        let center = lattice.middle(place);
        let half = 0.5 * lattice.side;
        let radius = half * 3f64.sqrt();
        let distance = self.search.sites.foot(center).distance_squared.sqrt();
        if distance + radius < self.options.min_distance {
            return Fate::Nothing;
        }
        let is_free = distance >= radius;
        if is_free && !is_here {
            return Fate::Nothing;
        }
        if !is_free && !is_last {
            return Fate::Divided;
        }
        let in_cube = |p: Vec3| (0..3).all(|k| (p[k] - center[k]).abs() <= half);
        let rank = |p: &MedialPoint| (in_cube(p.center), p.object_angle);
        let mut best: [Option<MedialPoint>; 2] = [None; 2];
        let mut keep = |point: MedialPoint| {
            let is_kept = self.options.pass(&point) && self.pairs.holds(self.search.sites, &point);
            let best = &mut best[usize::from(!is_free && self.is_behind(&point))];
            if is_kept && best.is_none_or(|best| rank(&point) > rank(&best)) {
                *best = Some(point);
            }
        };
        let mut fires = false;
        let ball = Ball { center, radius };
        self.search.examine(ball, &self.directions, |_, point| {
            fires = true;
            keep(point);
            is_last
        });
        if !is_free {
            self.examine_thin(ball, &mut keep);
        }
        match is_last {
            false if fires => Fate::Divided,
            true if best != [None; 2] => {
                let cover =
                    Cover { center, radius, half, gap: 0.0, distance, found: 1, missed_angle: PI };
                Fate::Found(cover, best.into_iter().flatten().collect())
            }
            _ => Fate::Nothing,
        }
    }

    /// Visits medial balls, no larger than a ball, that touch the boundary in it from the other side than its points see.
    fn examine_thin(&self, ball: Ball, visit: &mut impl FnMut(MedialPoint)) {
        let on_sphere = self.directions.iter().map(|&d| add(ball.center, scale(d, ball.radius)));
        let mut last: Option<Foot> = None;
        for at in [ball.center].into_iter().chain(on_sphere) {
            let foot = self.search.sites.foot(at);
            let is_within = length(sub(foot.point, ball.center)) <= ball.radius;
            let is_new = last.is_none_or(|last| !self.search.is_same(last.point, foot.point));
            if !is_within || !is_new || foot.distance_squared == 0.0 {
                continue;
            }
            last = Some(foot);
            let way = scale(sub(foot.point, at), 1.0 / foot.distance_squared.sqrt());
            let found = self.search.along(&foot, way, [0.0, 2.0 * ball.radius]);
            // On an edge the ball that touches it from behind is nothing.
            let is_of_ball = |point: &MedialPoint| {
                let away = length(sub(point.center, ball.center));
                point.radius > 4.0 * self.search.epsilon && away <= ball.radius
            };
            found.filter(is_of_ball).into_iter().for_each(&mut *visit);
        }
    }

    /// Whether a ball lies behind the triangle that it touches first.
    fn is_behind(&self, point: &MedialPoint) -> bool {
        match self.search.sites.pieces()[point.pieces[0] as usize] {
            Piece::Triangle([a, b, c]) => {
                dot(cross(sub(b, a), sub(c, a)), sub(point.center, point.feet[0])) < 0.0
            }
            _ => false,
        }
    }

    /// One point a cube: its own, or else one that a neighbour found in it.
    fn gathered(
        &self,
        sites: &Arc<Sites>,
        lattice: &Lattice,
        found: Vec<([u32; 3], Cover, MedialPoint)>,
        run: &Run<'_>,
    ) -> Result<FieldAxis> {
        let mut room = Room::new(run);
        let centers = room.collect(found.iter().map(|(_, _, point)| point.center))?;
        let is_here = sites.are_on(self.options.side, &centers, run)?;
        let [min, max] = self.options.clip.unwrap_or_default();
        let in_box = |p: Vec3| (0..3).all(|k| min[k] <= p[k] && p[k] <= max[k]);
        let mut kept: Vec<([i64; 3], bool, Cover, MedialPoint)> = room.vec(found.len())?;
        for ((place, cover, point), is_here) in found.into_iter().zip(is_here) {
            if is_here && in_box(point.center) {
                let holder = lattice.place(point.center);
                let is_own = place.map(i64::from) == holder;
                kept.push((holder, !is_own, cover, point));
            }
        }
        // A cube's own point comes first, then that with the largest angle.
        kept.sort_by(|p, q| {
            let angles = q.3.object_angle.total_cmp(&p.3.object_angle);
            (p.0, p.1).cmp(&(q.0, q.1)).then(angles)
        });
        kept.dedup_by_key(|kept| kept.0);
        Ok(FieldAxis {
            sites: sites.clone(),
            options: self.options,
            pairs: self.pairs.clone(),
            points: room.collect(kept.iter().map(|kept| kept.3))?,
            cover_of_point: room.collect(0..kept.len() as u32)?,
            covers: room.collect(kept.iter().map(|kept| kept.2))?,
            unconfirmed: 0,
        })
    }
}

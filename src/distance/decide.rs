//! Does a circle or a sphere hold a point of the medial axis? (Stolpner, Whitesides, *Medial axis approximation with bounded error*, algorithms 1 and 2.)

use super::locate::{MedialPoint, Search};
use super::piece::Foot;
use super::sites::Sites;
use crate::error::{ElementKind, Error, Result, Status};
use crate::job::{Room, Run, Stage};
use crate::vector::{Vec3, add, cross, dot, length, scale, sub};
use std::f64::consts::{PI, TAU};

/// The most directions of a decision: to sort Theta must not take long.
const MOST_DIRECTIONS: usize = 1 << 16;

/// How near is near, for the search of medial points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DecideOptions {
    /// Two nearest points of the boundary no farther apart than this, in input units, are the same, and so are the gradients that point at them; by default 1e-9 of the size of the
    /// boundary's box. 0 asks for the default.
    pub tolerance: f64,
    /// How far a point that is found may be from the medial axis, in input units; by default 1e-6 of that size. 0 asks for the default.
    pub epsilon: f64,
}

impl Default for DecideOptions {
    fn default() -> Self {
        DecideOptions { tolerance: 0.0, epsilon: 0.0 }
    }
}

/// Which test of algorithm 1 has found a medial point. The numbers are the C ABI's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum DecideTest {
    /// The gradients at a point and at its opposite differ (line 3).
    Opposite = 1,
    /// Those at two neighbours point to different sides of the line through them (line 8).
    Sides = 2,
    /// Between the opposites of two neighbours there are other points (line 13).
    Between = 3,
}

/// What is known of a circle or a sphere.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Decision {
    /// The test that found a medial point; `None` if no conclusion can be drawn: the paper's "Undetermined".
    pub test: Option<DecideTest>,
    /// A medial point in the circle or sphere; there is one exactly if a test found it.
    pub point: Option<MedialPoint>,
    /// All points at which the gradient was looked at, with their opposites: Theta. In the plane they go round counterclockwise.
    pub theta: Vec<[f64; 3]>,
    /// In the plane the longest arc between two neighbours of Theta: L, in input units. In space 0.
    pub gap: f64,
    /// How often a test fired of which no point came, as may happen where it hangs on the last bits of rounding: these do not count.
    pub unconfirmed: usize,
}

/// A point of a circle or sphere, the point of the boundary that is nearest to it, and the other point of the circle on the line through both, as an angle in the plane.
#[derive(Clone, Copy, Debug)]
struct Sample {
    at: Vec3,
    foot: Foot,
    opposite: Vec3,
}

/// A circle or a sphere.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ball {
    pub center: Vec3,
    pub radius: f64,
}

impl Sites {
    /// Whether a circle of the plane, or a sphere in space, which no part of the boundary enters, holds a point of the medial axis: the paper's DECIDEMA2D and DECIDEMA3D. `directions`
    /// are those from the centre to the points of Phi, of any length but 0: their number and distribution decide how much is found.
    ///
    /// In the plane a medial point may be missed if one of the six alternatives of theorem 10 holds ([`largest_missed_angle`](super::largest_missed_angle)); in space
    /// nothing is known. Errors: [`Status::InvalidArgument`] for a radius that is not positive, for a circle or sphere that the boundary enters, and with its row for a direction
    /// without length; [`Status::NonFinite`]; [`Status::LimitExceeded`] for more than 2^16 directions. Cost: one or two queries for each direction; the third test looks at all
    /// of Theta for each point of it whose neighbour has its opposite far away.
    pub fn decide(
        &self,
        center: [f64; 3],
        radius: f64,
        directions: &[[f64; 3]],
        options: DecideOptions,
    ) -> Result<Decision> {
        self.decide_with(center, radius, directions, options, &|| Ok(()))
    }

    /// [`Sites::decide`] as a stage of a larger build.
    pub(crate) fn decide_in(
        &self,
        center: [f64; 3],
        radius: f64,
        directions: &[[f64; 3]],
        options: DecideOptions,
        run: &Run<'_>,
    ) -> Result<Decision> {
        run.enter(Stage::Query)?;
        // What holds the points with their nearest ones, and Theta with those.
        let mut room = Room::new(run);
        room.keep(
            directions.len().saturating_mul(3 * size_of::<Sample>() + 2 * size_of::<Theta>()),
        )?;
        self.decide_with(center, radius, directions, options, &|| run.poll())
    }

    fn decide_with(
        &self,
        center: [f64; 3],
        radius: f64,
        directions: &[[f64; 3]],
        options: DecideOptions,
        poll: &dyn Fn() -> Result<()>,
    ) -> Result<Decision> {
        let wrong = |message: &str| Error::new(Status::InvalidArgument, message);
        if !center.iter().all(|x| x.is_finite()) {
            return Err(Error::new(Status::NonFinite, "a coordinate is NaN or infinite"));
        }
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(wrong("a radius is not positive"));
        }
        if self.dimension() == 2 && center[2] != 0.0 {
            return Err(wrong("a circle of the plane has a z"));
        }
        if self.foot(center).distance_squared < radius * radius {
            return Err(wrong("the boundary enters the circle or sphere"));
        }
        if directions.len() > MOST_DIRECTIONS {
            let message = format!("{} directions, of at most 2^16", directions.len());
            return Err(Error::new(Status::LimitExceeded, message));
        }
        let mut units = Vec::with_capacity(directions.len());
        for (row, &direction) in (0..).zip(directions) {
            poll()?;
            let size = length(direction);
            let lies_in = self.dimension() == 3 || direction[2] == 0.0;
            if !(size > 0.0 && size.is_finite() && lies_in) {
                return Err(wrong("a direction has no length, or leaves the plane")
                    .at(ElementKind::Row, row));
            }
            units.push(scale(direction, 1.0 / size));
        }
        let mut first = None;
        let search = self.search(options)?;
        let enough = |test, point| {
            first = Some((test, point));
            false
        };
        let mut decision = search.watched(Ball { center, radius }, &units, enough, poll)?;
        decision.test = first.map(|(test, _)| test);
        decision.point = first.map(|(_, point)| point);
        Ok(decision)
    }

    /// Directions of length 1 spread evenly, as many as are asked for. In the plane the first is that of x, and they go round counterclockwise; in space they lie on a spiral from
    /// pole to pole, each the golden angle further (Vogel 1979; Swinbank, Purser 2006, *Fibonacci grids*).
    pub fn even_directions(&self, count: usize) -> impl ExactSizeIterator<Item = [f64; 3]> {
        let on_circle = |angle: f64| [libm::cos(angle), libm::sin(angle), 0.0];
        let golden = PI * (3.0 - 5f64.sqrt());
        let dimension = self.dimension();
        let direction = move |i: usize| match dimension {
            2 => on_circle(TAU * i as f64 / count as f64),
            _ => {
                let z = 1.0 - (2 * i + 1) as f64 / count as f64;
                let r = (1.0 - z * z).sqrt();
                add(scale(on_circle(golden * i as f64), r), [0.0, 0.0, z])
            }
        };
        (0..count).map(direction)
    }

    /// A search with such options. Errors: [`Status::InvalidArgument`] for an option that is no length.
    pub(super) fn search(&self, options: DecideOptions) -> Result<Search<'_>> {
        let DecideOptions { tolerance, epsilon } = options;
        if ![tolerance, epsilon].iter().all(|x| *x >= 0.0 && x.is_finite()) {
            let message = "a tolerance is negative or not finite";
            return Err(Error::new(Status::InvalidArgument, message));
        }
        let or = |x: f64, share: f64| if x > 0.0 { x } else { share * self.size() };
        let (tolerance, epsilon) = (or(tolerance, 1e-9), or(epsilon, 1e-6));
        Ok(Search { sites: self, tolerance, epsilon, blur: 0.0 })
    }
}

impl Search<'_> {
    /// Applies the tests, and gives each medial point that they lead to, until it is enough.
    pub(super) fn examine(
        &self,
        ball: Ball,
        units: &[Vec3],
        enough: impl FnMut(DecideTest, MedialPoint) -> bool,
    ) -> Decision {
        // Without anything to poll for there is no error.
        self.watched(ball, units, enough, &|| Ok(())).unwrap_or_default()
    }

    /// The same, which calls `poll` on the way, and stops with its error.
    fn watched(
        &self,
        ball: Ball,
        units: &[Vec3],
        mut enough: impl FnMut(DecideTest, MedialPoint) -> bool,
        poll: &dyn Fn() -> Result<()>,
    ) -> Result<Decision> {
        let mut decision = Decision::default();
        let mut samples = Vec::with_capacity(units.len());
        let mut differ = 0;
        let mut goes_on = true;
        for &direction in units {
            poll()?;
            let at = add(ball.center, scale(direction, ball.radius));
            let foot = self.sites.foot(at);
            let Some((opposite, chord)) = ball.opposite(at, &foot) else {
                samples.push(Sample { at, foot, opposite: at });
                continue;
            };
            samples.push(Sample { at, foot, opposite });
            // On the way to the nearest point it stays the nearest one.
            let Some((way, range)) = chord else { continue };
            let other = self.sites.foot(opposite);
            if self.is_same(foot.point, other.point) {
                continue;
            }
            differ += 1;
            match self.along(&foot, way, range) {
                Some(point) if goes_on => goes_on = enough(DecideTest::Opposite, point),
                Some(_) => {}
                None => decision.unconfirmed += 1,
            }
            if !goes_on {
                break;
            }
        }
        let both = samples.iter().flat_map(|s| [s.at, s.opposite]);
        match self.sites.dimension() == 2 {
            true => {
                let ring = Ring::new(ball, &samples);
                decision.gap = ring.gap(ball.radius);
                decision.theta = ring.thetas.iter().map(|theta| theta.at).collect();
                // The other tests are for circles that pass the first.
                if differ == 0 {
                    self.compare_neighbors(&ring, &mut decision, &mut enough, poll)?;
                }
            }
            false => decision.theta = both.collect(),
        }
        Ok(decision)
    }

    /// The second and the third test.
    fn compare_neighbors(
        &self,
        ring: &Ring,
        decision: &mut Decision,
        enough: &mut impl FnMut(DecideTest, MedialPoint) -> bool,
        poll: &dyn Fn() -> Result<()>,
    ) -> Result<()> {
        let mut found = false;
        for (a, b) in ring.neighbors() {
            poll()?;
            // Each as seen on the way to the other, so that one sign means different sides.
            if side(a, b) * side(b, a) <= 0.0 {
                continue;
            }
            match self.between(a.at, b.at, Z) {
                Some(point) => {
                    found = true;
                    if !enough(DecideTest::Sides, point) {
                        return Ok(());
                    }
                }
                None => decision.unconfirmed += 1,
            }
        }
        if found {
            return Ok(());
        }
        for (place, (a, b)) in ring.neighbors().enumerate() {
            poll()?;
            let mut fires = false;
            for c in ring.between_opposites(place) {
                fires = true;
                let crossed = [a, b].into_iter().find(|x| side(x, c) * side(c, x) > 0.0);
                if let Some(point) = crossed.and_then(|x| self.between(x.at, c.at, Z)) {
                    fires = false;
                    if !enough(DecideTest::Between, point) {
                        return Ok(());
                    }
                    break;
                }
            }
            decision.unconfirmed += usize::from(fires);
        }
        Ok(())
    }
}

/// Across the plane.
const Z: Vec3 = [0.0, 0.0, 1.0];

/// On which side of the line from a point to another one the nearest point of the boundary lies: positive on the left.
fn side(from: &Theta, to: &Theta) -> f64 {
    dot(cross(sub(to.at, from.at), sub(from.foot.point, from.at)), Z)
}

impl Ball {
    /// The opposite of a point, and, if it lies on the way on from the nearest point of the boundary, the direction of that way and the distances of both from there. `None` if the line is
    /// tangent, so that the point is its own opposite.
    #[allow(clippy::type_complexity)]
    fn opposite(&self, at: Vec3, foot: &Foot) -> Option<(Vec3, Option<(Vec3, [f64; 2])>)> {
        let distance = foot.distance_squared.sqrt();
        if distance == 0.0 {
            return None;
        }
        let way = scale(sub(at, foot.point), 1.0 / distance);
        // Half the chord, negative on the way on.
        let half = dot(sub(at, self.center), way);
        if half.abs() <= 1e-12 * self.radius {
            return None;
        }
        let opposite = sub(at, scale(way, 2.0 * half));
        let on = (half < 0.0).then_some((way, [distance, distance - 2.0 * half]));
        Some((opposite, on))
    }
}

/// A point of Theta.
#[derive(Clone, Copy, Debug)]
struct Theta {
    at: Vec3,
    foot: Foot,
    angle: f64,
    /// The angle at which its opposite is.
    opposite: f64,
}

/// Theta, counterclockwise.
struct Ring {
    thetas: Vec<Theta>,
}

impl Ring {
    /// Where all samples have the nearest point of their opposites.
    fn new(ball: Ball, samples: &[Sample]) -> Self {
        let angle = |p: Vec3| {
            let out = sub(p, ball.center);
            libm::atan2(out[1], out[0])
        };
        let both = |sample: &Sample| {
            let (here, there) = (angle(sample.at), angle(sample.opposite));
            let foot = sample.foot;
            [
                Theta { at: sample.at, foot, angle: here, opposite: there },
                Theta { at: sample.opposite, foot, angle: there, opposite: here },
            ]
        };
        let mut thetas: Vec<Theta> = samples.iter().flat_map(both).collect();
        thetas.sort_by(|a, b| a.angle.total_cmp(&b.angle));
        thetas.dedup_by(|a, b| a.angle - b.angle <= 1e-12);
        Ring { thetas }
    }

    /// The longest arc between neighbours.
    fn gap(&self, radius: f64) -> f64 {
        let arcs = self.neighbors().map(|(a, b)| match b.angle > a.angle {
            true => b.angle - a.angle,
            false => b.angle - a.angle + TAU,
        });
        radius * arcs.fold(0.0, f64::max)
    }

    /// Each with the next.
    fn neighbors(&self) -> impl Iterator<Item = (&Theta, &Theta)> {
        self.thetas.iter().zip(self.thetas.iter().cycle().skip(1))
    }

    /// The points within the arc between the opposites of a point and the next one: of the two arcs the one without these.
    fn between_opposites(&self, place: usize) -> impl Iterator<Item = &Theta> {
        let count = self.thetas.len();
        let (a, b) = (&self.thetas[place], &self.thetas[(place + 1) % count]);
        // Seen from the first, counterclockwise: itself at 0, the next one at some angle, all else beyond.
        let turn = |angle: f64| (angle - a.angle).rem_euclid(TAU);
        let (one, other) = (turn(a.opposite), turn(b.opposite));
        let (low, high) = (one.min(other), one.max(other));
        let margin = 1e-9;
        let is_far = low > turn(b.angle) - margin;
        self.thetas.iter().filter(move |c| {
            let angle = turn(c.angle);
            is_far && angle > low + margin && angle < high - margin
        })
    }
}

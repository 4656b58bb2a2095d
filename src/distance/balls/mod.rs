//! Unions of balls: how far a point is from one, and its boundary (Stolpner, Whitesides, figure 10: a shape as the union of its medial balls). See
//! `docs/algorithms/distance.md`.

mod creases;
mod exposed;
mod hierarchy;
mod patches;
mod surface;
mod thin;

use crate::complex::{Complex, Element, Values, answers};
use crate::error::{ElementKind, Error, Result, Status};
use crate::job::{Job, Room, Run, Stage};
use crate::points::{Bounds, COORDINATE_MAX, COORDINATE_MIN, check_coordinates};
use hierarchy::Hierarchy;

/// The largest coordinate of a centre and the largest radius: so a box well round the union is in range.
const LARGEST: f64 = COORDINATE_MAX / 64.0;

/// Balls, which may overlap, lie in each other and repeat each other. The solid is their union.
///
/// Invariants: there is a ball, and at most 2^28 less 8; `centers` and `radii` have the same length; centres have coordinates in the range of [`Points`](crate::Points), up to 2^194 in absolute
/// value; radii are from 2^-160 to 2^194.
#[derive(Clone, Debug)]
pub struct Balls {
    centers: Vec<[f64; 3]>,
    radii: Vec<f64>,
    hierarchy: Hierarchy,
}

/// How fine the boundary of a union of balls is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BoundaryOptions {
    /// No point of the boundary is farther than this from a sample, in input units. 0, the default, asks for a hundredth of the diagonal of the balls' box. On smaller balls it is
    /// halved until it is no more than the radius; from there it grows by half the distance.
    pub spacing: f64,
}

impl Balls {
    /// Balls by their centres and radii.
    ///
    /// Errors: [`Status::Mismatch`] unless there are as many radii as centres; [`Status::TooFewPoints`] without any; [`Status::LimitExceeded`] for more than 2^28 less 8; with the row of the
    /// ball [`Status::NonFinite`], [`Status::InvalidArgument`] for a radius that is not positive, [`Status::CoordinateRange`] for what is out of range; those of the job. Cost: O(n log n).
    pub fn new(centers: Vec<[f64; 3]>, radii: Vec<f64>, job: &Job) -> Result<Self> {
        job.run(&[(Stage::Order, 1.0)], |run| Balls::new_in(centers, radii, run))
    }

    /// [`Balls::new`] as a stage of a larger build.
    pub(crate) fn new_in(centers: Vec<[f64; 3]>, radii: Vec<f64>, run: &Run<'_>) -> Result<Self> {
        run.enter(Stage::Order)?;
        if centers.len() != radii.len() {
            let message = format!("{} radii for {} centres", radii.len(), centers.len());
            return Err(Error::new(Status::Mismatch, message));
        }
        if centers.is_empty() {
            return Err(Error::new(Status::TooFewPoints, "there is no ball"));
        }
        if centers.len() > exposed::MOST {
            let message = format!("{} balls are more than {}", centers.len(), exposed::MOST);
            return Err(Error::new(Status::LimitExceeded, message));
        }
        for (row, ball) in run.watch(centers.iter().zip(&radii)).enumerate() {
            let (&center, &radius) = ball?;
            check(center, radius).map_err(|error| error.at(ElementKind::Row, row as u64))?;
        }
        let hierarchy = Hierarchy::new(&centers, &radii, &mut Room::new(run), run)?;
        Ok(Balls { centers, radii, hierarchy })
    }

    /// Balls round the vertices of a complex, which carry `radius`: of a medial axis, whatever it came from. Faces and edges count for nothing.
    ///
    /// Errors: [`Status::Mismatch`] where vertices carry no `radius`, one number each; those of [`Balls::new`], with the vertex for a row.
    pub fn of_complex(complex: &Complex, job: &Job) -> Result<Self> {
        job.run(&[(Stage::Order, 1.0)], |run| {
            let mut room = Room::new(run);
            let radius = complex.attribute(Element::Vertex, "radius");
            let radii = match radius.map(|radius| (radius.width(), radius.values())) {
                Some((1, Values::F64(radii))) => room.collect(radii.iter().copied())?,
                // Files hold whole numbers as such.
                Some((1, Values::U32(radii))) => {
                    room.collect(radii.iter().copied().map(f64::from))?
                }
                _ => {
                    let message = "the vertices carry no radius, so they are no balls";
                    return Err(Error::new(Status::Mismatch, message));
                }
            };
            let centers = room.collect(complex.vertices().iter().copied())?;
            Balls::new_in(centers, radii, run)
        })
    }

    /// The centres.
    pub fn centers(&self) -> &[[f64; 3]] {
        &self.centers
    }

    /// The radii, in input units.
    pub fn radii(&self) -> &[f64] {
        &self.radii
    }

    /// The number of balls.
    pub fn len(&self) -> usize {
        self.radii.len()
    }

    /// Whether there is no ball; never so.
    pub fn is_empty(&self) -> bool {
        self.radii.is_empty()
    }

    /// Whether a point is within one ball, and not on its sphere.
    fn ball_holds(&self, ball: u32, p: [f64; 3]) -> bool {
        let ball = ball as usize;
        hierarchy::signed_distance(p, self.centers[ball], self.radii[ball]) < 0.0
    }

    /// The smallest box that holds all balls.
    pub fn bounds(&self) -> Bounds {
        let corners = |(center, radius): (&[f64; 3], &f64)| {
            [center.map(|x| x - radius), center.map(|x| x + radius)]
        };
        let all = Bounds::of(self.centers.iter().zip(&self.radii).flat_map(corners));
        all.unwrap_or(Bounds { min: [0.0; 3], max: [0.0; 3] })
    }

    /// For each point the least of all |x - c| - r: negative inside the union, 0 on its boundary, outside the distance to it. Inside it is no distance, but how deep the point is in the ball in
    /// which it is deepest, which is at most that.
    ///
    /// Each is the least of what each ball by itself gives in floats, without exception. Errors: [`Status::NonFinite`] and [`Status::CoordinateRange`] with the row of a
    /// point; those of the job. Cost: about O(log n) each where the radii of neighbours are alike, divided among the job's threads.
    pub fn distances(&self, points: &[[f64; 3]], job: &Job) -> Result<Vec<f64>> {
        job.run(&[(Stage::Query, 1.0)], |run| {
            run.enter(Stage::Query)?;
            let mut room = Room::new(run);
            let answer = |p| self.hierarchy.least(p);
            answers(points, ElementKind::Row, [0.0, 1.0], &mut room, run, answer)
        })
    }

    /// The boundary of the union as a mesh of triangles that points out of it.
    ///
    /// Which balls touch the boundary, and which of them cut each other there, is read off the regular triangulation of the balls. What is left bare of each sphere is sampled, triple points first,
    /// then creases; the mesh are the facets of the samples' Delaunay triangulation between cells whose circumcentres lie in the union and others. So it is closed, and each edge
    /// has two triangles, four where the mesh touches itself; every vertex lies on its ball's sphere and in no ball, up to rounding; and every point of the mesh is within the spacing
    /// of the boundary. What is thinner than the spacing, be it of the solid or of what lies between its parts, may be closed or cut. Balls with a radius of less than 2^-40 of the largest coordinate
    /// are left out.
    ///
    /// Vertices carry `ball`, on whose sphere they lie; of several any. Errors: [`Status::InvalidArgument`] for a spacing that is no length; [`Status::CoordinateRange`] where all balls are left
    /// out; [`Status::LimitExceeded`] for more than 2^28 samples; those of the job. Cost: O(n log n + m log m) for m samples in practice; where all balls meet, O(n^2).
    pub fn boundary(&self, options: BoundaryOptions, job: &Job) -> Result<Complex> {
        let plan = [
            (Stage::Regular, 0.1),
            (Stage::Sample, 0.2),
            (Stage::Order, 0.05),
            (Stage::Triangulate, 0.25),
            (Stage::Dual, 0.1),
            (Stage::Label, 0.2),
            (Stage::Extract, 0.1),
        ];
        job.run(&plan, |run| surface::boundary(self, options, run))
    }
}

/// Errors: those of [`Balls::new`], without the row.
fn check(center: [f64; 3], radius: f64) -> Result<()> {
    if !radius.is_finite() {
        return Err(Error::new(Status::NonFinite, "a radius is NaN or infinite"));
    }
    if radius <= 0.0 {
        return Err(Error::new(Status::InvalidArgument, "a radius is not positive"));
    }
    check_coordinates(center)?;
    if !(COORDINATE_MIN..=LARGEST).contains(&radius) || center.iter().any(|x| x.abs() > LARGEST) {
        let message = "a radius lies outside [2^-160, 2^194], or a centre beyond 2^194; rescale";
        return Err(Error::new(Status::CoordinateRange, message));
    }
    Ok(())
}

//! Where points lie in the flow: their nearest samples, and their drivers.

use super::Flow;
use super::simplex::Simplex;
use super::source::Source;
use crate::error::{ElementKind, Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use crate::points::{COORDINATE_MAX, COORDINATE_MIN};
use crate::triangulation::{Descent, Incidence};
use crate::vector::{Vec3, add, length, scale, sub};

/// The queries between two reports.
const BATCH: usize = 256;

/// The flow at one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlowAt {
    /// The simplex at whose centre the driver lies. The point lies in its Voronoi face, or on the rim of that, and flows through it.
    pub simplex: Simplex,
    /// The driver: the point nearest to the query of the hull of its nearest samples, and the centre of their smallest enclosing ball.
    pub driver: [f64; 3],
    /// From the driver to the point, by the distance of the point from the samples: the flow. Its length is the speed at which the distance grows, in [0, 1]; 0 at critical
    /// points.
    pub vector: [f64; 3],
    /// The distance of the point from the samples, in input units.
    pub distance: f64,
    /// The driving angle: between the directions from the point to the driver and to a nearest sample, in [0, pi/2] radians; pi/2 at critical points but samples, 0 where one sample alone
    /// is nearest.
    pub angle: f64,
}

impl Flow {
    /// The flow at each of some points (the paper's DRIVER).
    ///
    /// Which samples are nearest is decided exactly. Where several are, as on the faces of the Voronoi diagram, the driver is, of the centres of all simplices of these samples that hold their
    /// own, that of the largest smallest sphere. Coordinates of less than [`COORDINATE_MIN`] count as 0.
    ///
    /// Errors: [`Status::NonFinite`] and [`Status::CoordinateRange`] with the row of the point; those of the job. Cost: O(n) once, and for each point O(way from the one before to
    /// it, in samples).
    pub fn at(&self, points: &[[f64; 3]], job: &Job) -> Result<Vec<FlowAt>> {
        job.run(&[(Stage::Query, 1.0)], |run| {
            run.enter(Stage::Query)?;
            let incidence = self.dual.triangulation().incidence_in(run)?;
            let source = self.source()?;
            self.for_each(points, run, |places, x| {
                Ok(source.flow_at(x, places.find(&source, &incidence, x)?))
            })
        })
    }

    /// What some work gives for each of some points, in batches that each have room of their own.
    pub(super) fn for_each<T: Send>(
        &self,
        points: &[[f64; 3]],
        run: &Run<'_>,
        work: impl Fn(&mut Places, Vec3) -> Result<T> + Sync,
    ) -> Result<Vec<T>> {
        check(points, run)?;
        let batches = points.chunks(BATCH).collect();
        let results = run.in_steps(batches, [0.1, 1.0], |points: &[Vec3]| {
            let mut room = Room::new(run);
            let mut results = room.vec(points.len())?;
            let mut places = Places::default();
            for x in points {
                run.poll()?;
                let x = x.map(|x| if x.abs() < COORDINATE_MIN { 0.0 } else { x });
                results.push(work(&mut places, x)?);
            }
            Ok((results, room))
        })?;
        let mut all = Room::new(run).vec(points.len())?;
        results.into_iter().for_each(|(results, _)| all.extend(results));
        Ok(all)
    }
}

fn check(points: &[[f64; 3]], run: &Run<'_>) -> Result<()> {
    for point in run.watch(points.iter().enumerate()) {
        let (row, point) = point?;
        let error = match point {
            _ if !point.iter().all(|x| x.is_finite()) => {
                Error::new(Status::NonFinite, "a coordinate is not finite")
            }
            _ if point.iter().any(|x| x.abs() > COORDINATE_MAX) => {
                Error::new(Status::CoordinateRange, "a coordinate lies beyond 2^200")
            }
            _ => continue,
        };
        return Err(error.at(ElementKind::Row, row as u64));
    }
    Ok(())
}

/// Finds points, each from the one before.
#[derive(Default)]
pub(super) struct Places {
    last: u32,
    /// All nearest samples.
    nearest: Vec<u32>,
}

impl Places {
    /// The simplex at whose centre the driver of a point lies.
    pub fn find(&mut self, source: &Source<'_>, incidence: &Incidence, x: Vec3) -> Result<Simplex> {
        let t = source.dual.triangulation();
        let descent = Descent::new(t, incidence);
        self.last = descent.nearest(x, self.last);
        let nearest = self.last;
        self.nearest.clear();
        self.nearest.push(nearest);
        // Cospherical samples are joined by edges that need not lead to the first one.
        let mut done = 0;
        while let Some(&v) = self.nearest.get(done) {
            done += 1;
            for &cell in incidence.cells_of(v) {
                for w in t.cells()[cell as usize] {
                    if !self.nearest.contains(&w) && descent.is_as_near(x, w, nearest) {
                        self.nearest.push(w);
                    }
                }
            }
        }
        let mut best = (Simplex::Sample(nearest), 0.0);
        if self.nearest.len() > 1 {
            for &v in &self.nearest {
                for &cell in incidence.cells_of(v) {
                    self.consider(source, cell, &mut best)?;
                }
            }
        }
        Ok(best.0)
    }

    /// Looks among the sides of a cell that have only nearest samples, and hold their own centres, for one with a larger sphere.
    fn consider(&self, source: &Source<'_>, cell: u32, best: &mut (Simplex, f64)) -> Result<()> {
        let t = source.dual.triangulation();
        let corners = t.cells()[cell as usize];
        let is_near = corners.map(|v| self.nearest.contains(&v));
        let mut offer = |simplex: Simplex| {
            let radius = source.radius(simplex);
            if radius > best.1 || (radius == best.1 && simplex < best.0) {
                *best = (simplex, radius);
            }
        };
        if is_near == [true; 4] && source.drivers.beyond[cell as usize] == 0 {
            offer(Simplex::Cell(cell));
        }
        for slot in 0..4 {
            let triangle = source.triangles.of_cell[cell as usize][slot];
            let is_in = (0..4).all(|i| i == slot || is_near[i]);
            if is_in && source.drivers.longest[triangle as usize] == NONE {
                offer(Simplex::Triangle(triangle));
            }
            for other in slot + 1..4 {
                if is_near[slot] && is_near[other] {
                    offer(Simplex::Edge(source.facet_of(corners[slot], corners[other])?));
                }
            }
        }
        Ok(())
    }
}

impl Source<'_> {
    /// The Voronoi facet of an edge.
    pub fn facet_of(&self, p: u32, q: u32) -> Result<u32> {
        match self.facets.edges().binary_search(&[p.min(q), p.max(q)]) {
            Ok(facet) => Ok(facet as u32),
            Err(_) => Err(Error::new(Status::Internal, "an edge has no Voronoi facet")),
        }
    }

    /// The centre of a simplex; of a sample the sample.
    pub fn center_of(&self, simplex: Simplex) -> Vec3 {
        let t = self.dual.triangulation();
        let at = |v: u32| t.coords()[v as usize];
        match simplex {
            Simplex::Sample(v) => at(v),
            Simplex::Edge(facet) => {
                let [p, q] = self.facets.edges()[facet as usize].map(at);
                middle(p, q)
            }
            Simplex::Triangle(triangle) => {
                let [corner, way] = self.center_of_triangle(triangle);
                add(corner, way)
            }
            Simplex::Cell(cell) => self.dual.centers()[cell as usize],
        }
    }

    /// The radius of the smallest sphere through a simplex: not from its rounded centre, of which a short edge may be at either end.
    pub fn radius(&self, simplex: Simplex) -> f64 {
        let t = self.dual.triangulation();
        let at = |v: u32| t.coords()[v as usize];
        match simplex {
            Simplex::Sample(_) => 0.0,
            Simplex::Edge(facet) => {
                let [p, q] = self.facets.edges()[facet as usize].map(at);
                0.5 * length(sub(q, p))
            }
            Simplex::Triangle(triangle) => length(self.center_of_triangle(triangle)[1]),
            Simplex::Cell(cell) => self.dual.radii_squared()[cell as usize].sqrt(),
        }
    }

    /// The flow at a point whose driver is the centre of a simplex.
    fn flow_at(&self, x: Vec3, simplex: Simplex) -> FlowAt {
        let driver = self.center_of(simplex);
        let sample = self.dual.triangulation().coords()[self.corners(simplex)[0] as usize];
        let distance = length(sub(x, sample));
        let away = sub(x, driver);
        let speed = length(away) / distance;
        let (vector, angle) = match simplex {
            // Also where the point is the sample.
            Simplex::Sample(_) if distance == 0.0 => ([0.0; 3], 0.0),
            _ => (scale(away, 1.0 / distance), libm::acos(speed.min(1.0))),
        };
        FlowAt { simplex, driver, vector, distance, angle }
    }
}

/// The middle of two points.
pub(super) fn middle(p: Vec3, q: Vec3) -> Vec3 {
    [0, 1, 2].map(|k| 0.5 * p[k] + 0.5 * q[k])
}

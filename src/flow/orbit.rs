//! Orbits: whither points flow.

use super::Flow;
use super::outline::{Corner, Outline};
use super::side::View;
use super::simplex::Simplex;
use super::source::Source;
use crate::complex::{Attribute, Complex, ComplexParts, Element, Values};
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use crate::points::Bounds;
use crate::predicates::{exit_order, is_acute};
use crate::triangulation::Incidence;
use crate::vector::{Vec3, add, dot, length, scale, sub, unit};
use std::cmp::Ordering;

/// The orbits of some points, as polylines.
///
/// Invariants: `offsets` has one entry more than orbits; the points of orbit i are the rows from entry i to before entry i + 1, at least one, the first of them where it begins.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Orbits {
    offsets: Vec<u32>,
    points: Vec<Vec3>,
    distances: Vec<f64>,
    simplices: Vec<Simplex>,
    ends: Vec<u32>,
}

impl Orbits {
    /// Where the points of each orbit begin; one entry more than orbits.
    pub fn offsets(&self) -> &[u32] {
        &self.offsets
    }

    /// The points of all orbits, one orbit's after the other's. The last one of an orbit that goes to infinity lies on its last ray, one diagonal of the samples' box from the point before.
    pub fn points(&self) -> &[[f64; 3]] {
        &self.points
    }

    /// The distance of each point from the samples, in input units.
    pub fn distances(&self) -> &[f64] {
        &self.distances
    }

    /// For each point the simplex in whose Voronoi face the orbit goes on from there, away from the simplex's centre; at an end that of the critical point; at infinity that of the point before.
    pub fn simplices(&self) -> &[Simplex] {
        &self.simplices
    }

    /// The critical point where each orbit ends, a row of [`CriticalPoints`](super::CriticalPoints); [`NONE`] at infinity.
    pub fn ends(&self) -> &[u32] {
        &self.ends
    }

    /// The number of orbits.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The orbits as loose edges, with the attributes `radius` of vertices (their distances from the samples), and `orbit` and `end` of edges (the orbit, and where it ends).
    ///
    /// Errors: those of the job. Cost: O(points).
    pub fn complex(&self, job: &Job) -> Result<Complex> {
        job.run(&[(Stage::Extract, 1.0)], |run| self.complex_in(run))
    }

    /// [`Orbits::complex`] as a stage of a larger build.
    pub(crate) fn complex_in(&self, run: &Run<'_>) -> Result<Complex> {
        run.enter(Stage::Extract)?;
        let mut room = Room::new(run);
        let count = self.points.len() - self.len();
        let mut edges = room.vec(count)?;
        let (mut orbits, mut ends) = (room.vec(count)?, room.vec(count)?);
        for (orbit, row) in run.watch((0..).zip(self.offsets.windows(2))).flatten() {
            for begin in row[0]..row[1] - 1 {
                edges.push([begin, begin + 1]);
                orbits.push(orbit);
                ends.push(self.ends[orbit as usize]);
            }
        }
        run.poll()?;
        let vertices = room.collect(self.points.iter().copied())?;
        let radii = room.collect(self.distances.iter().copied())?;
        let attributes = vec![
            Attribute::new("radius", Element::Vertex, 1, Values::F64(radii))?,
            Attribute::new("orbit", Element::Edge, 1, Values::U32(orbits))?,
            Attribute::new("end", Element::Edge, 1, Values::U32(ends))?,
        ];
        let parts = ComplexParts { vertices, edges, attributes, ..ComplexParts::default() };
        Complex::sound_in(parts, run)
    }
}

impl Flow {
    /// The orbits of some points: each a polyline to the critical point where it ends, or to infinity (the paper's ORBIT). No orbit enters a face of the Voronoi diagram
    /// twice.
    ///
    /// Decided exactly: the samples nearest to a point; the facet that its orbit comes to first, and by which edge it leaves that; where the flow goes on from a Voronoi edge, or vertex; by which edge the orbit of
    /// a Voronoi vertex leaves its facet. Rounded: where orbits cross Voronoi edges, and so by which edge they leave the facets after the first, until they come to a Voronoi edge that they follow to its end. Orbits on
    /// both sides of a Voronoi vertex part; one that passes it as near as the rounding may go the other way.
    ///
    /// Errors: [`Status::NonFinite`] and [`Status::CoordinateRange`] with the row of the point; [`Status::LimitExceeded`] past 2^32 - 1 points of orbits; those of the job. Cost: as
    /// [`Flow::at`], and O(size of the Voronoi facets that an orbit crosses).
    pub fn orbits(&self, points: &[[f64; 3]], job: &Job) -> Result<Orbits> {
        job.run(&[(Stage::Query, 1.0)], |run| self.orbits_in(points, run))
    }

    /// [`Flow::orbits`] as a stage of a larger build.
    pub(crate) fn orbits_in(&self, points: &[[f64; 3]], run: &Run<'_>) -> Result<Orbits> {
        run.enter(Stage::Query)?;
        let incidence = self.dual.triangulation().incidence_in(run)?;
        let source = self.source()?;
        let coords = self.dual.triangulation().coords().iter().copied();
        let diagonal = Bounds::of(coords).map_or(0.0, |bounds| bounds.diagonal());
        let traces = self.for_each(points, run, |places, x| {
            let simplex = places.find(&source, &incidence, x)?;
            let mut trace = Trace {
                source: &source,
                diagonal,
                outline: Outline::default(),
                points: Vec::new(),
                end: None,
            };
            trace.follow(x, simplex, &incidence)?;
            Ok((trace.points, trace.end))
        })?;
        let mut room = Room::new(run);
        let count = traces.iter().map(|(points, _)| points.len()).sum();
        if u32::try_from(count).is_err() {
            let message = "the orbits have more than 2^32 - 1 points";
            return Err(Error::new(Status::LimitExceeded, message));
        }
        let mut orbits = Orbits {
            offsets: room.vec(traces.len() + 1)?,
            points: room.vec(count)?,
            distances: room.vec(count)?,
            simplices: room.vec(count)?,
            ends: room.vec(traces.len())?,
        };
        orbits.offsets.push(0);
        for (points, end) in traces {
            for (at, simplex, distance) in points {
                orbits.points.push(at);
                orbits.simplices.push(simplex);
                orbits.distances.push(distance);
            }
            orbits.offsets.push(orbits.points.len() as u32);
            let end = end.and_then(|simplex| self.critical.row_of(simplex));
            orbits.ends.push(end.unwrap_or(NONE));
        }
        Ok(orbits)
    }
}

/// Where an orbit goes on.
enum Next {
    /// Across a facet, on the ray from its driver through a point.
    Facet(u32, Through),
    /// Along the Voronoi edge of an acute triangle.
    Edge(u32),
    /// From the Voronoi vertex of a cell.
    Vertex(u32),
    /// Nowhere: at a critical point.
    End(Simplex),
    /// On a ray in some direction.
    Infinity(Vec3),
}

/// What tells the ray across a facet.
enum Through {
    /// A Voronoi vertex.
    Vertex(u32),
    /// A point that was asked for, on the ray or between it and the line of the two samples.
    Query(Vec3),
    /// Where the orbit has come in, rounded.
    Rounded,
}

/// An orbit that is being followed.
struct Trace<'a> {
    source: &'a Source<'a>,
    diagonal: f64,
    outline: Outline,
    points: Vec<(Vec3, Simplex, f64)>,
    /// The simplex of the critical point where it ended.
    end: Option<Simplex>,
}

impl Trace<'_> {
    fn follow(&mut self, x: Vec3, simplex: Simplex, incidence: &Incidence) -> Result<()> {
        let mut at = x;
        let mut next = match simplex {
            Simplex::Sample(p) => self.leave_cell(p, x, incidence, &mut at)?,
            Simplex::Edge(facet) => Next::Facet(facet, Through::Query(x)),
            Simplex::Triangle(triangle) => Next::Edge(triangle),
            cell => Next::End(cell),
        };
        if let (Next::Facet(..) | Next::Infinity(_), Simplex::Sample(_)) = (&next, simplex) {
            self.push(x, simplex);
        }
        // No face is entered twice.
        let most = self.source.facets.len() + 2 * self.source.triangles.len();
        for _ in 0..most {
            next = match next {
                Next::Facet(facet, through) => self.cross_facet(facet, through, &mut at)?,
                Next::Edge(triangle) => self.follow_edge(triangle, &mut at),
                Next::Vertex(cell) => {
                    let driver = self.source.drivers.of_cell(self.source.triangles, cell);
                    at = self.source.dual.centers()[cell as usize];
                    match driver {
                        Simplex::Edge(facet) => Next::Facet(facet, Through::Vertex(cell)),
                        Simplex::Triangle(triangle) => Next::Edge(triangle),
                        end => Next::End(end),
                    }
                }
                Next::End(simplex) => {
                    self.push(at, simplex);
                    self.end = Some(simplex);
                    return Ok(());
                }
                Next::Infinity(direction) => {
                    if let Some(&(last, simplex, _)) = self.points.last() {
                        self.push(add(last, scale(unit(direction), self.diagonal)), simplex);
                    }
                    return Ok(());
                }
            };
        }
        Err(Error::new(Status::Internal, "the flow turns in a circle"))
    }

    /// Adds a point, but where it is the one before.
    fn push(&mut self, at: Vec3, simplex: Simplex) {
        let sample = self.source.corners(simplex)[0];
        let sample = self.source.dual.triangulation().coords()[sample as usize];
        match self.points.last_mut() {
            Some(last) if last.0 == at => last.1 = simplex,
            _ => self.points.push((at, simplex, length(sub(at, sample)))),
        }
    }

    /// Leaves the Voronoi cell of a sample p on the ray from there through x: by the facet whose plane the ray meets first.
    fn leave_cell(
        &mut self,
        p: u32,
        x: Vec3,
        incidence: &Incidence,
        at: &mut Vec3,
    ) -> Result<Next> {
        let t = self.source.dual.triangulation();
        let place = |v: u32| t.coords()[v as usize];
        let from = place(p);
        if from == x {
            return Ok(Next::End(Simplex::Sample(p)));
        }
        let mut first = NONE;
        for &cell in incidence.cells_of(p) {
            for q in t.cells()[cell as usize] {
                if q == p || q == first {
                    continue;
                }
                let order = match first {
                    NONE => Ordering::Less,
                    first => exit_order(&from, &x, &place(q), &place(first)),
                };
                if order == Ordering::Less || (order == Ordering::Equal && q < first) {
                    first = q;
                }
            }
        }
        let (along, to) = (sub(x, from), sub(place(first), from));
        if !is_acute(&from, &x, &place(first)) {
            return Ok(Next::Infinity(along));
        }
        let share = dot(to, to) / (2.0 * dot(along, to));
        *at = add(from, scale(along, share));
        Ok(Next::Facet(self.source.facet_of(p, first)?, Through::Query(x)))
    }

    /// Crosses a facet, away from the middle of its edge.
    fn cross_facet(&mut self, facet: u32, through: Through, at: &mut Vec3) -> Result<Next> {
        let simplex = Simplex::Edge(facet);
        let center = self.source.center_of(simplex);
        self.push(*at, simplex);
        self.outline.trace(self.source, facet)?;
        if *at == center && self.outline.near == 0 {
            return Ok(Next::End(simplex));
        }
        let view = View::new(self.source.dual, self.source.facets.edges()[facet as usize]);
        let outline = &self.outline;
        let x = view.to(*at);
        let side = match through {
            Through::Vertex(cell) => view.exit(outline, cell, outline.sides.len()) - 1,
            Through::Query(point) => {
                view.exit_by(outline, |corner| view.is_beyond_point(point, corner))
            }
            Through::Rounded => {
                view.exit_by(outline, |corner| view.turn(x, view.vector(corner)) > 0.0)
            }
        };
        let triangle = outline.sides[side];
        if triangle == NONE {
            return Ok(Next::Infinity(sub(*at, center)));
        }
        let share = view.share(outline, side, x, None);
        *at = view.place(outline, side, share);
        // What is rounded to a Voronoi vertex goes on as that does, which is decided exactly.
        let is_here = |corner: Corner| match corner {
            Corner::Cell(cell) => {
                (self.source.dual.centers()[cell as usize] == *at).then_some(cell)
            }
            Corner::Ray(_) => None,
        };
        if let Some(cell) = is_here(outline.corners[side]).or_else(|| is_here(outline.end(side))) {
            return Ok(Next::Vertex(cell));
        }
        Ok(match self.source.drivers.longest[triangle as usize] {
            NONE => Next::Edge(triangle),
            facet => Next::Facet(facet, Through::Rounded),
        })
    }

    /// Follows the Voronoi edge of an acute triangle.
    fn follow_edge(&mut self, triangle: u32, at: &mut Vec3) -> Next {
        let simplex = Simplex::Triangle(triangle);
        self.push(*at, simplex);
        let [cell, other] = self.source.triangles.cells(self.source.dual.triangulation(), triangle);
        let slot = self.source.triangles.sides[triangle as usize][1];
        let onward = match self.source.is_saddle(triangle) {
            true => {
                let center = self.source.center_of(simplex);
                let [here, middle] = [*at, center].map(|at| self.source.share(triangle, at));
                match here.order(&middle) {
                    Ordering::Less => false,
                    Ordering::Equal => return Next::End(simplex),
                    Ordering::Greater => true,
                }
            }
            false => self.source.drivers.beyond[cell as usize] >> slot & 1 == 1,
        };
        match (onward, other) {
            (false, _) => Next::Vertex(cell),
            (true, NONE) => {
                let ray = self.source.dual.rays().of_facet(cell, slot);
                Next::Infinity(self.source.dual.rays().directions()[ray as usize])
            }
            (true, other) => Next::Vertex(other),
        }
    }
}

impl View<'_> {
    /// The side by which a ray leaves, given whether a corner lies counterclockwise of it.
    fn exit_by(&self, outline: &Outline, is_ahead: impl Fn(Corner) -> bool) -> usize {
        if outline.near > 0 {
            let mut far = outline.sides.len();
            while far > outline.near + 1 && is_ahead(outline.corners[far - 1]) {
                far -= 1;
            }
            return far - 1;
        }
        // Round the driver: from the corners clockwise of the ray to those counterclockwise.
        let count = outline.sides.len();
        let ahead: Vec<bool> = outline.corners.iter().map(|&corner| is_ahead(corner)).collect();
        (0..count).find(|&side| !ahead[side] && ahead[(side + 1) % count]).unwrap_or(0)
    }
}

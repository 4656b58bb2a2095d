//! Critical points of the distance to the samples, and which of them belong to the surface.

use super::simplex::Simplex;
use super::source::Source;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run, parts};
use crate::labels::Labels;
use crate::medial::Side;
use crate::poles::FirstPoles;
use crate::triangulation::Incidence;
use crate::vector::{Vec3, dot, length, sub};

/// Where a critical point belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum CriticalClass {
    /// To the surface: near it, between its samples.
    Surface = 0,
    /// To the inner medial axis.
    Inner = 1,
    /// To the outer medial axis.
    Outer = 2,
}

/// The critical points of the distance to the samples.
///
/// Such a point is where a Delaunay simplex meets its dual face of the Voronoi diagram: a sample, the middle of an edge, the centre of a triangle, the centre of a
/// cell (Giesen, Ramos, Sadri, section 2); its index is the dimension of the simplex. Which do is decided exactly, with the ties that right angles and cospherical samples make broken by
/// the perturbation of the triangulation, so that c0 - c1 + c2 - c3 = 1 always.
///
/// Invariants: one row for each in every array; rows ascend by index, then by simplex: the first are the samples.
#[derive(Clone, Debug, Default)]
pub struct CriticalPoints {
    simplices: Vec<Simplex>,
    points: Vec<Vec3>,
    distances: Vec<f64>,
    corners: Vec<[u32; 4]>,
    slopes: Vec<f64>,
    shares: Vec<f64>,
    classes: Vec<CriticalClass>,
}

impl CriticalPoints {
    /// The simplex of each.
    pub fn simplices(&self) -> &[Simplex] {
        &self.simplices
    }

    /// Where each lies.
    pub fn points(&self) -> &[[f64; 3]] {
        &self.points
    }

    /// The distance of each from the samples, in input units.
    pub fn distances(&self) -> &[f64] {
        &self.distances
    }

    /// The samples nearest to each, one to four, then [`NONE`]: the vertices of its simplex.
    pub fn corners(&self) -> &[[u32; 4]] {
        &self.corners
    }

    /// For each the mean, over its nearest samples, of the cosine of the angle between the direction from the sample and the sample's pole vector, in absolute value:
    /// nearly 0 at the surface, nearly 1 at the medial axis. 0 for samples.
    pub fn slopes(&self) -> &[f64] {
        &self.slopes
    }

    /// For each its distance by that of the farthest Voronoi vertices of its nearest samples on its side of the surface, the mean over these: nearly 0 at the surface; nearly 1 at the
    /// inner medial axis, as at the outer where the samples are not on the hull. It decides nothing.
    pub fn shares(&self) -> &[f64] {
        &self.shares
    }

    /// The largest slope of those that belong to the surface by their slope, and the least of the others, 1 if there are none: the wider apart the two, the clearer
    /// the decision.
    pub fn gap(&self, least_slope: f64) -> [f64; 2] {
        let below = self.slopes.iter().filter(|&&slope| slope <= least_slope);
        let above = self.slopes.iter().filter(|&&slope| slope > least_slope);
        [below.copied().fold(0.0, f64::max), above.copied().fold(1.0, f64::min)]
    }

    /// Where each belongs.
    pub fn classes(&self) -> &[CriticalClass] {
        &self.classes
    }

    /// The number of them.
    pub fn len(&self) -> usize {
        self.simplices.len()
    }

    /// Whether there is none; never so.
    pub fn is_empty(&self) -> bool {
        self.simplices.is_empty()
    }

    /// The row of the critical point of a simplex, if it has one.
    pub fn row_of(&self, simplex: Simplex) -> Option<u32> {
        self.simplices.binary_search(&simplex).ok().map(|row| row as u32)
    }

    pub(super) fn new(source: &Source<'_>, room: &mut Room<'_>, run: &Run<'_>) -> Result<Self> {
        let t = source.dual.triangulation();
        let mut points = CriticalPoints::default();
        for v in run.watch(0..t.coords().len() as u32) {
            points.push(source, Simplex::Sample(v?), room)?;
        }
        let mut near = room.filled(source.facets.len(), false)?;
        for longest in run.watch(&source.drivers.longest) {
            if let Some(near) = near.get_mut(*longest? as usize) {
                *near = true;
            }
        }
        for (facet, near) in (0..).zip(run.watch(near)) {
            if !near? {
                points.push(source, Simplex::Edge(facet), room)?;
            }
        }
        for triangle in run.watch(0..source.triangles.len() as u32) {
            let triangle = triangle?;
            if source.is_saddle(triangle) {
                points.push(source, Simplex::Triangle(triangle), room)?;
            }
        }
        for (cell, beyond) in (0..).zip(run.watch(&source.drivers.beyond)) {
            if *beyond? == 0 {
                points.push(source, Simplex::Cell(cell), room)?;
            }
        }
        Ok(points)
    }

    fn push(&mut self, source: &Source<'_>, simplex: Simplex, room: &mut Room<'_>) -> Result<()> {
        room.push(&mut self.simplices, simplex)?;
        room.push(&mut self.points, source.center_of(simplex))?;
        room.push(&mut self.distances, source.radius(simplex))?;
        room.push(&mut self.corners, source.corners(simplex))
    }

    /// Tells apart those of the surface and those of the medial axis: these have a slope of more than so much. The cells round the Voronoi face
    /// tell inner from outer.
    pub(super) fn separate(
        &mut self,
        source: &Source<'_>,
        labels: &Labels,
        least_slope: f64,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<()> {
        let t = source.dual.triangulation();
        let incidence = t.incidence_in(run)?;
        let poles =
            FirstPoles::new(source.dual, t.coords().len(), &incidence, [0.8, 0.9], room, run)?;
        let parts = run.in_parallel(parts(self.len()), |range| {
            run.poll()?;
            let mut room = Room::new(run);
            let measures = range.map(|i| self.measure(i, source, &poles, &incidence));
            Ok((room.collect(measures)?, room))
        })?;
        self.slopes = room.vec(self.len())?;
        self.shares = room.vec(self.len())?;
        for [slope, share] in parts.iter().flat_map(|(part, _)| part) {
            self.slopes.push(*slope);
            self.shares.push(*share);
        }
        drop(parts);
        self.classes = room.vec(self.len())?;
        for i in run.watch(0..self.len()) {
            let i = i?;
            let class = match self.slopes[i] > least_slope {
                true => match source.side_of(labels, self.simplices[i]) {
                    Side::Inner => CriticalClass::Inner,
                    Side::Outer => CriticalClass::Outer,
                    Side::Both => CriticalClass::Surface,
                },
                false => CriticalClass::Surface,
            };
            self.classes.push(class);
        }
        Ok(())
    }

    /// The slope and the share of a critical point.
    fn measure(
        &self,
        i: usize,
        source: &Source<'_>,
        poles: &FirstPoles,
        incidence: &Incidence,
    ) -> [f64; 2] {
        let t = source.dual.triangulation();
        if self.simplices[i].dimension() == 0 {
            return [0.0; 2];
        }
        let (mut slope, mut share, mut count) = (0.0, 0.0, 0.0);
        for &v in self.corners[i].iter().filter(|&&v| v != NONE) {
            let s = t.coords()[v as usize];
            let center = |cell: u32| sub(source.dual.centers()[cell as usize], s);
            let pole = match poles.cells[v as usize] {
                NONE => poles.normals[v as usize],
                cell => center(cell),
            };
            let to = sub(self.points[i], s);
            // Where rounding has put the point on its sample the angle is lost.
            let size = length(to) * length(pole);
            slope += if size > 0.0 { (dot(to, pole) / size).abs() } else { 0.0 };
            let side = dot(to, pole);
            let mut farthest = self.distances[i];
            for &cell in incidence.cells_of(v) {
                let neighbors = t.neighbors()[cell as usize].iter().zip(t.cells()[cell as usize]);
                let ray = neighbors.into_iter().any(|(&c, corner)| c == NONE && corner != v);
                let center = center(cell);
                // By the sides of the plane through the sample: the pole is its normal.
                if dot(center, pole) * side > 0.0 {
                    farthest = farthest.max(if ray { f64::INFINITY } else { length(center) });
                }
            }
            share += self.distances[i] / farthest;
            count += 1.0;
        }
        [slope / count, share / count]
    }
}

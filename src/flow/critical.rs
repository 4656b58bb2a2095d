//! Critical points of the distance to the samples, and which of them belong to the surface.

use super::complex::Source;
use super::drivers::Driver;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run, parts};
use crate::labels::Labels;
use crate::poles::FirstPoles;
use crate::vector::{Vec3, add, dot, length, scale, sub};

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

/// The critical points of index 1 to 3 of the distance to the samples. Those of index 0 are the samples themselves.
///
/// Such a point is where a Delaunay simplex meets its dual face of the Voronoi diagram: the middle of an edge, the centre of a triangle, the centre of a
/// cell (Giesen, Ramos, Sadri, section 2). Which do is decided exactly, with the ties that right angles and cospherical samples make broken by
/// the perturbation of the triangulation, so that c0 - c1 + c2 - c3 = 1 always.
///
/// Invariants: one row for each in every array; rows ascend by index, then by simplex.
#[derive(Clone, Debug, Default)]
pub struct CriticalPoints {
    pub(super) drivers: Vec<Driver>,
    pub(super) points: Vec<Vec3>,
    pub(super) distances: Vec<f64>,
    pub(super) corners: Vec<[u32; 4]>,
    pub(super) slopes: Vec<f64>,
    pub(super) classes: Vec<CriticalClass>,
}

impl CriticalPoints {
    /// The simplex of each.
    pub fn drivers(&self) -> &[Driver] {
        &self.drivers
    }

    /// Where each lies.
    pub fn points(&self) -> &[[f64; 3]] {
        &self.points
    }

    /// The distance of each from the samples, in input units.
    pub fn distances(&self) -> &[f64] {
        &self.distances
    }

    /// The samples nearest to each, two, three or four, then [`NONE`]: the vertices of its simplex.
    pub fn corners(&self) -> &[[u32; 4]] {
        &self.corners
    }

    /// For each the mean, over its nearest samples, of the cosine of the angle between the direction from the sample and the sample's pole vector, in absolute value:
    /// nearly 0 at the surface, nearly 1 at the medial axis.
    pub fn slopes(&self) -> &[f64] {
        &self.slopes
    }

    /// Where each belongs.
    pub fn classes(&self) -> &[CriticalClass] {
        &self.classes
    }

    /// The number of them.
    pub fn len(&self) -> usize {
        self.drivers.len()
    }

    /// Whether there is none; never so.
    pub fn is_empty(&self) -> bool {
        self.drivers.is_empty()
    }

    pub(super) fn new(
        source: &Source<'_>,
        saddles: &[u32],
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let t = source.dual.triangulation();
        let at = |v: u32| t.coords()[v as usize];
        let mut points = CriticalPoints::default();
        let mut near = room.filled(source.facets.len(), false)?;
        for longest in run.watch(&source.drivers.longest) {
            if let Some(near) = near.get_mut(*longest? as usize) {
                *near = true;
            }
        }
        for facet in run.watch(0..source.facets.len()) {
            let facet = facet?;
            if !near[facet] {
                let [p, q] = source.facets.edges()[facet];
                let middle = scale(add(at(p), at(q)), 0.5);
                points.push(Driver::Edge(facet as u32), middle, [p, q, NONE, NONE], at(p), room)?;
            }
        }
        for &triangle in saddles {
            let [p, q, r] = source.triangles.corners(t, triangle);
            let center = source.center_of_triangle(triangle);
            points.push(Driver::Triangle(triangle), center, [p, q, r, NONE], at(p), room)?;
        }
        for cell in run.watch(0..t.cells().len() as u32) {
            let cell = cell?;
            if source.drivers.beyond[cell as usize] == 0 {
                let corners = t.cells()[cell as usize];
                let center = source.dual.centers()[cell as usize];
                points.push(Driver::Cell(cell), center, corners, at(corners[0]), room)?;
            }
        }
        Ok(points)
    }

    fn push(
        &mut self,
        driver: Driver,
        at: Vec3,
        corners: [u32; 4],
        sample: Vec3,
        room: &mut Room<'_>,
    ) -> Result<()> {
        room.push(&mut self.drivers, driver)?;
        room.push(&mut self.points, at)?;
        room.push(&mut self.distances, length(sub(at, sample)))?;
        room.push(&mut self.corners, corners)
    }

    /// Tells apart those of the surface and those of the medial axis: these have a slope of more than so much. The cells round the Voronoi face
    /// tell inner from outer.
    pub(super) fn separate(
        &mut self,
        source: &Source<'_>,
        poles: &FirstPoles,
        labels: &Labels,
        least_slope: f64,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<()> {
        let t = source.dual.triangulation();
        let slope = |i: usize| {
            let corners = self.corners[i].iter().filter(|&&v| v != NONE);
            let (mut sum, mut count) = (0.0, 0.0);
            for &v in corners {
                let s = t.coords()[v as usize];
                let pole = match poles.cells[v as usize] {
                    NONE => poles.normals[v as usize],
                    cell => sub(source.dual.centers()[cell as usize], s),
                };
                let to = sub(self.points[i], s);
                sum += (dot(to, pole) / (length(to) * length(pole))).abs();
                count += 1.0;
            }
            sum / count
        };
        let slopes = run.in_parallel(parts(self.len()), |range| {
            run.poll()?;
            let mut room = Room::new(run);
            Ok((room.collect(range.map(slope))?, room))
        })?;
        self.slopes = room.vec(self.len())?;
        for (part, _) in slopes {
            self.slopes.extend(part);
        }
        self.classes = room.vec(self.len())?;
        for i in run.watch(0..self.len()) {
            let i = i?;
            let is_inner = |cell: u32| cell != NONE && labels.is_inner()[cell as usize];
            let mut cells = Vec::new();
            match self.drivers[i] {
                Driver::Sample(_) => (),
                Driver::Edge(facet) => {
                    cells.extend_from_slice(source.facets.ring(facet as usize));
                    if source.facets.is_unbounded(facet as usize) {
                        cells.push(NONE);
                    }
                }
                Driver::Triangle(triangle) => cells.extend(source.triangles.cells(t, triangle)),
                Driver::Cell(cell) => cells.push(cell),
            }
            let inner = cells.iter().filter(|&&cell| is_inner(cell)).count();
            let class = match self.slopes[i] > least_slope {
                true if inner == cells.len() => CriticalClass::Inner,
                true if inner == 0 => CriticalClass::Outer,
                _ => CriticalClass::Surface,
            };
            self.classes.push(class);
        }
        Ok(())
    }
}

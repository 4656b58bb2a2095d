//! Local feature size and local thickness: at any point, and on the vertices of complexes.

use super::{Balls, Label, PowerCrust};
use crate::complex::{
    Attribute, Complex, ComplexParts, Element, Hierarchy, Simplex, Values, answers,
};
use crate::error::{ElementKind, Result};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use crate::poles::distances;

/// Lengths at some points, in input units.
#[derive(Clone, Debug, PartialEq)]
pub struct Sizes {
    /// The distance from each point to the nearest pole whose ball the power crust has, inner or outer: an estimate of the local
    /// feature size, the distance to the medial axis (Amenta, Bern 1999).
    pub feature_size: Vec<f64>,
    /// The diameter of the inner polar ball of the sample that is nearest to each point among those that have one; 0 if none has.
    pub thickness: Vec<f64>,
}

/// What queries search.
#[derive(Clone, Debug)]
pub(super) struct SizeIndex {
    /// The centres of the balls; `None` where these are the poles' own, which have them in a hierarchy already.
    centers: Option<Hierarchy<1>>,
    /// The samples that have an inner ball.
    samples: Hierarchy<1>,
}

impl PowerCrust {
    /// The local feature size and the thickness at any points, q x 3.
    ///
    /// Thickness is a property of the surface: that of the solid's wall between a sample and what lies opposite. So a point that is no
    /// sample takes it from the nearest sample, of several as near that of the least number. A sample may have no inner ball: its poles
    /// were left out, or are both outer, or their balls vanished; then it takes that of the nearest one that has. Where a sample has two inner
    /// balls the larger one counts. Balls have the radii that they have in this power crust, those of an offset the changed ones; with
    /// `round_poles` they are the poles' own.
    ///
    /// Errors: [`Status::NonFinite`](crate::Status::NonFinite) and, beyond 2^200, [`Status::CoordinateRange`](crate::Status::CoordinateRange) with
    /// the row of the query, and those of the job. Cost: O(log n) for each query, and O(n log n) once, on the first call.
    pub fn sizes_at(&self, queries: &[[f64; 3]], job: &Job) -> Result<Sizes> {
        job.run(&[(Stage::Query, 1.0)], |run| {
            run.enter(Stage::Query)?;
            self.sizes_in(queries, ElementKind::Row, &mut Room::new(run), run)
        })
    }

    /// The distinct samples as vertices, in spatial order, with `feature_size`, `thickness` and `row`, the first input row of each.
    ///
    /// Errors: those of the job. Cost: that of [`PowerCrust::sizes_at`] for the n samples.
    pub fn samples_to_complex(&self, job: &Job) -> Result<Complex> {
        job.run(&[(Stage::Query, 1.0)], |run| {
            run.enter(Stage::Query)?;
            let mut room = Room::new(run);
            let sizes = self.sizes_in(self.samples(), ElementKind::Vertex, &mut room, run)?;
            let mut attributes = sizes.into_attributes()?;
            let rows = self.poles.triangulation().points().row_of_vertex();
            let rows = room.collect(rows[..self.poles.sample_count()].iter().copied())?;
            attributes.push(Attribute::new("row", Element::Vertex, 1, Values::U32(rows))?);
            let vertices = room.collect(self.samples().iter().copied())?;
            Complex::sound_in(ComplexParts { vertices, attributes, ..Default::default() }, run)
        })
    }

    /// Any complex with the sizes at its vertices, as the attributes `feature_size` and `thickness`, which take the place of any that
    /// have these names: this power crust's surface, a part of it, or another mesh of the same thing.
    ///
    /// Errors: [`Status::CoordinateRange`](crate::Status::CoordinateRange) with a vertex beyond 2^200, and those of the job. Cost: that of
    /// [`PowerCrust::sizes_at`] for its vertices.
    pub fn with_sizes(&self, complex: &Complex, job: &Job) -> Result<Complex> {
        job.run(&[(Stage::Query, 1.0)], |run| {
            run.enter(Stage::Query)?;
            let mut room = Room::new(run);
            let sizes = self.sizes_in(complex.vertices(), ElementKind::Vertex, &mut room, run)?;
            complex.with_attributes_in(sizes.into_attributes()?, run)
        })
    }

    fn sizes_in(
        &self,
        queries: &[[f64; 3]],
        kind: ElementKind,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Sizes> {
        let index = match self.size_index.get() {
            Some(index) => index,
            None => {
                let index = self.size_index_in(room, run)?;
                self.size_index.get_or_init(|| index)
            }
        };
        let centers = match &index.centers {
            Some(centers) => centers,
            None => self.poles.centers_in(room, run)?,
        };
        let nearest = |query| {
            let sample = index.samples.nearest(query);
            sample.and_then(|sample| self.inner_diameter(sample as usize)).unwrap_or(0.0)
        };
        Ok(Sizes {
            feature_size: distances(centers, queries, kind, [0.2, 0.6], room, run)?,
            thickness: answers(queries, kind, [0.6, 1.0], room, run, nearest)?,
        })
    }

    fn size_index_in(&self, room: &mut Room<'_>, run: &Run<'_>) -> Result<SizeIndex> {
        let mut own = Room::new(run);
        let centers = match &self.balls {
            Balls::Poles => None,
            Balls::Changed(weights) => {
                let mut centers = Vec::new();
                for ball in run.watch(self.poles.balls().iter().zip(weights)) {
                    let (&[x, y, z, _], weight) = ball?;
                    if weight.is_some() {
                        own.push(&mut centers, Simplex { corners: [[x, y, z]], tag: 0 })?;
                    }
                }
                Some(Hierarchy::new(&centers, room, run)?)
            }
        };
        let mut samples = Vec::new();
        for sample in run.watch(self.samples().iter().enumerate()) {
            let (sample, &position) = sample?;
            if self.inner_diameter(sample).is_some() {
                own.push(&mut samples, Simplex { corners: [position], tag: sample as u32 })?;
            }
        }
        Ok(SizeIndex { centers, samples: Hierarchy::new(&samples, room, run)? })
    }

    /// The diameter of a sample's inner ball, of the larger one of two; `None` if it has none.
    fn inner_diameter(&self, sample: usize) -> Option<f64> {
        let inner = |&pole: &u32| match pole {
            NONE => None,
            pole if self.labels[pole as usize] == Label::Outer => None,
            pole => Some(2.0 * self.weight(pole as usize)?.sqrt()),
        };
        self.poles.pole_of_sample()[sample].iter().filter_map(inner).reduce(f64::max)
    }

    fn samples(&self) -> &[[f64; 3]] {
        &self.poles.triangulation().coords()[..self.poles.sample_count()]
    }
}

impl Sizes {
    /// The sizes as attributes of vertices.
    fn into_attributes(self) -> Result<Vec<Attribute>> {
        let vertex = |name, values| Attribute::new(name, Element::Vertex, 1, Values::F64(values));
        Ok(vec![vertex("feature_size", self.feature_size)?, vertex("thickness", self.thickness)?])
    }
}

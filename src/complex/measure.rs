//! Area and volume, and the sums and scales that make them reliable.

use super::closest::{cross, dot, sub};
use super::{Complex, Point};
use crate::error::Result;
use crate::job::{Job, Run, Stage};
use crate::points::{Bounds, COORDINATE_MIN};

/// The size of a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measure {
    /// The area of the faces, in squared input units.
    pub area: f64,
    /// The volume that the faces enclose, in cubed input units: positive where they point out,
    /// negative where they point in. It has a meaning for closed, oriented surfaces only.
    pub volume: f64,
}

impl Complex {
    /// The area of the faces and the volume that they enclose, both from the triangles.
    ///
    /// A value beyond the range of an f64 is infinite. Errors: those of the job. Cost: linear.
    pub fn measure(&self, job: &Job) -> Result<Measure> {
        job.run(&[(Stage::Query, 1.0)], |run| self.measure_in(run))
    }

    /// [`Complex::measure`] as a stage of a larger operation.
    pub(crate) fn measure_in(&self, run: &Run<'_>) -> Result<Measure> {
        run.enter(Stage::Query)?;
        let Some(bounds) = Bounds::of(self.vertices.iter().copied()) else {
            return Ok(Measure::default());
        };
        let frame = Frame::new(&bounds);
        let (mut area, mut volume) = (Sum::default(), Sum::default());
        for (i, t) in self.triangles.iter().enumerate() {
            if i % (1 << 14) == 0 {
                run.tick(i, self.triangles.len())?;
            }
            let [a, b, c] = t.map(|v| frame.relative(self.vertices[v as usize]));
            let normal = cross(sub(b, a), sub(c, a));
            area.add(dot(normal, normal).sqrt() / 2.0);
            volume.add(dot(a, cross(b, c)) / 6.0);
        }
        let length = 1.0 / frame.scale;
        Ok(Measure {
            area: area.value() * length * length,
            volume: volume.value() * length * length * length,
        })
    }
}

/// Coordinates of order 1, about the middle of a box: products of them neither overflow nor vanish.
pub(super) struct Frame {
    middle: Point,
    /// A power of two, so that scaling is exact.
    pub(super) scale: f64,
}

impl Frame {
    pub(super) fn new(bounds: &Bounds) -> Self {
        let corners = [bounds.min, bounds.max];
        let largest = corners.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
        // The exponent of the largest coordinate, within what keeps the scale itself normal.
        let exponent = ((largest.to_bits() >> 52) as i64 - 1023).clamp(-1021, 1021);
        let scale = f64::from_bits(((1023 - exponent) as u64) << 52);
        let middle = std::array::from_fn(|i| (bounds.min[i] * scale + bounds.max[i] * scale) / 2.0);
        Frame { middle, scale }
    }

    /// The scaled point: of order 1, and zero what is next to nothing, so that predicates are exact.
    pub(super) fn scaled(&self, p: Point) -> Point {
        p.map(|x| x * self.scale).map(|x| if x.abs() < COORDINATE_MIN { 0.0 } else { x })
    }

    /// The scaled point, seen from the middle.
    pub(super) fn relative(&self, p: Point) -> Point {
        sub(self.scaled(p), self.middle)
    }
}

/// A sum that carries its rounding errors along (Neumaier 1974, *Rundungsfehleranalyse einiger
/// Verfahren zur Summation endlicher Summen*).
#[derive(Clone, Copy, Default)]
pub(super) struct Sum {
    high: f64,
    low: f64,
}

impl Sum {
    pub(super) fn add(&mut self, x: f64) {
        let high = self.high + x;
        let lost = if self.high.abs() >= x.abs() {
            (self.high - high) + x
        } else {
            (x - high) + self.high
        };
        self.low += lost;
        self.high = high;
    }

    pub(super) fn value(self) -> f64 {
        self.high + self.low
    }
}

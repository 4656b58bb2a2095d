//! The balls whose power diagram is taken: the polar balls themselves, or the same with rounded centres.

use super::PowerCrustOptions;
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::points::{Bounds, COORDINATE_MIN, Points, PointsOptions};
use crate::poles::Poles;
use crate::predicates::double_double::Pairs;
use crate::triangulation::Triangulation;
use std::sync::Arc;

/// The step of the grid, in sides of the samples' box: 2^-36.
const STEP: f64 = f64::from_bits((1023 - 36) << 52);

/// The regular triangulation of the polar balls: weights are squared radii.
pub(super) fn triangulate(
    poles: &Poles,
    options: &PowerCrustOptions,
    run: &Run<'_>,
) -> Result<Triangulation> {
    let of_poles = |error: Error| of_poles(error, poles.len());
    let grid = options.round_poles.then(|| Grid::of(poles));
    let Some(grid) = grid else {
        return regular(
            poles,
            |pole| {
                let [x, y, z, _] = poles.balls()[pole];
                Some(([x, y, z], poles.radii_squared()[pole]))
            },
            run,
        );
    };
    let center = |pole: usize| {
        let [x, y, z, _] = poles.balls()[pole];
        Some([x, y, z].map(|x| round(x, grid.step)))
    };
    let points = Points::by_row_in(poles.len(), center, PointsOptions::default(), run);
    let points = points.map_err(of_poles)?;
    let mut room = Room::new(run);
    room.keep(points.bytes())?;
    let weights = grid.weights(poles, &points, &mut room, run)?;
    Triangulation::regular_in(&Arc::new(points), &weights, run).map_err(of_poles)
}

/// A centre and a weight.
pub(super) type Ball = ([f64; 3], f64);

/// The regular triangulation of the balls of some poles, whose numbers are the rows of its points: of all, or of those that a variant leaves.
pub(super) fn regular(
    poles: &Poles,
    ball: impl Fn(usize) -> Option<Ball> + Sync,
    run: &Run<'_>,
) -> Result<Triangulation> {
    let left = (0..poles.len()).filter(|&pole| ball(pole).is_some()).count();
    let of_poles = |error: Error| match left == poles.len() {
        true => of_poles(error, left),
        false => of_balls_left(error, left),
    };
    let center = |pole: usize| ball(pole).map(|(center, _)| center);
    let points = Points::by_row_in(poles.len(), center, PointsOptions::default(), run);
    let points = points.map_err(of_poles)?;
    let mut room = Room::new(run);
    room.keep(points.bytes())?;
    // The weights of rows that are left out count for nothing.
    let weight = |pole: usize| ball(pole).map_or(0.0, |(_, weight)| weight);
    let weights = room.collect((0..poles.len()).map(weight))?;
    Triangulation::regular_in(&Arc::new(points), &weights, run).map_err(of_poles)
}

/// An error about poles says so: they are our own rows, not the caller's, and it names no row.
fn of_poles(error: Error, poles: usize) -> Error {
    match error.status() {
        Status::CoordinateRange | Status::TooFewPoints | Status::Degenerate => Error::new(
            error.status(),
            format!(
                "the sample's {poles} poles have no power diagram ({}); sample the surface more densely",
                error.message()
            ),
        ),
        _ => error,
    }
}

/// The same where balls were left out: the sample is not at fault.
fn of_balls_left(error: Error, left: usize) -> Error {
    match error.status() {
        Status::CoordinateRange | Status::TooFewPoints | Status::Degenerate => {
            let message = error.message();
            Error::new(
                error.status(),
                format!(
                    "the {left} balls that are left have no power diagram ({message}); take a smaller offset, epsilon or delta"
                ),
            )
        }
        _ => error,
    }
}

/// The grid to which centres are rounded.
#[derive(Clone, Copy)]
pub(super) struct Grid {
    /// A power of two.
    pub step: f64,
}

impl Grid {
    /// The step is 2^-36 of the least power of two that the longest side of the samples' box
    /// does not exceed; but never finer than coordinates may be.
    pub fn of(poles: &Poles) -> Self {
        let samples = &poles.triangulation().coords()[..poles.sample_count()];
        let extent = Bounds::of(samples.iter().copied()).map_or([0.0; 3], |bounds| bounds.extent());
        let side = extent.into_iter().fold(COORDINATE_MIN, f64::max);
        // The powers of two above and below have the same bits but for the exponent's last.
        let below = f64::from_bits(side.to_bits() >> 52 << 52);
        let above = if below == side { side } else { 2.0 * below };
        Grid { step: (above * STEP).max(COORDINATE_MIN) }
    }

    /// The weights of poles whose rounded centres are the rows of `points`: the squared distances to their own
    /// samples.
    fn weights(
        self,
        poles: &Poles,
        points: &Points,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Vec<f64>> {
        let samples = own_samples(poles, room, run)?;
        let weight = |(&vertex, &sample): (&u32, &u32)| {
            let center = points.coords()[vertex as usize];
            self.weight(center, poles.triangulation().coords()[sample as usize])
        };
        room.collect(points.vertex_of_row().iter().zip(&samples).map(weight))
    }

    /// The squared distance from a rounded centre to a sample, correctly rounded but for cases that 100 bits cannot
    /// tell, then to a multiple of the squared step.
    fn weight(self, center: [f64; 3], sample: [f64; 3]) -> f64 {
        let offset = Pairs::difference(center, sample);
        let squares = offset.mul(&offset);
        let [x, y, z] = [0, 1, 2].map(|k| squares.pick([k]));
        let sum = x.add(&y).add(&z);
        round(sum.hi[0] + sum.lo[0], self.step * self.step)
    }
}

/// For each pole its own sample: the least whose pole it is.
pub(super) fn own_samples(poles: &Poles, room: &mut Room<'_>, run: &Run<'_>) -> Result<Vec<u32>> {
    // Every pole is that of a sample, and none of these is at infinity: there is a far box.
    let mut own = room.filled(poles.len(), 0)?;
    for sample in run.watch(poles.pole_of_sample().iter().enumerate().rev()) {
        let (sample, pair) = sample?;
        for &pole in pair.iter().filter(|&&pole| pole != NONE) {
            own[pole as usize] = sample as u32;
        }
    }
    Ok(own)
}

/// The nearest multiple of a power of two, of two the even one. Nothing is rounded but that: what is
/// 2^52 steps or more is a multiple already.
fn round(x: f64, step: f64) -> f64 {
    (x / step).round_ties_even() * step
}

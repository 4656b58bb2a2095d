//! Simplification of the power shape (Amenta, Choi, Kolluri 2001, section 7.3): unstable poles go, then redundant ones.

use super::PowerCrust;
use super::derive::DERIVE;
use super::surface::Shards;
use crate::complex::Rows;
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, Room, Run, parts};
use crate::sort::{float_key, sort_by_key};
use std::sync::Arc;

/// How far a power shape is simplified.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SimplifyOptions {
    /// Poles go whose samples are all within this distance of each other: how far samples may be from where they belong. In input units;
    /// `None` for a hundredth of the diagonal of the samples' box.
    pub epsilon: Option<f64>,
    /// Poles go whose balls lie in that of a larger ball, grown by this. In input units; `None` for three thousandths of the
    /// diagonal.
    pub delta: Option<f64>,
}

impl Default for SimplifyOptions {
    /// Both relative to the samples' box.
    fn default() -> Self {
        SimplifyOptions { epsilon: None, delta: None }
    }
}

/// The defaults, in diagonals of the samples' box.
const EPSILON: f64 = 0.01;
const DELTA: f64 = 0.003;

/// A simplified power crust, and what became of the poles.
#[derive(Clone, Debug)]
pub struct Simplified {
    /// The power crust of the poles that are left.
    pub crust: Arc<PowerCrust>,
    /// The epsilon and the delta, in input units.
    pub epsilon: f64,
    /// See `epsilon`.
    pub delta: f64,
    /// Poles that were unstable, ascending.
    pub unstable: Vec<u32>,
    /// Poles that were redundant, each with the one that is left and whose ball, grown by delta, holds theirs; ascending.
    pub redundant: Vec<[u32; 2]>,
}

impl PowerCrust {
    /// The power crust of fewer poles, inner and outer alike: of those that are stable, and needed for the shape.
    ///
    /// A pole is *unstable* if no two samples on its ball are farther apart than epsilon; all samples on it
    /// count, and a ball that touches the far box is stable. Of the others a pole is *redundant* if its ball lies in that of
    /// another one of its side, which is larger, grown by delta: balls are looked at from the largest to the smallest, each takes its neighbours in the
    /// power shape, and what it takes passes it on to its own neighbours. Labels are kept, the power
    /// diagram of what is left is calculated anew. Hidden poles have no neighbours, and stay if they are stable.
    ///
    /// Errors: [`Status::InvalidArgument`] for an epsilon or a delta that is negative or not finite,
    /// [`Status::TooFewPoints`] and [`Status::Degenerate`] where too few poles are left, and those of the job. Cost: one
    /// regular triangulation, of what is left.
    pub fn simplify(&self, options: SimplifyOptions, job: &Job) -> Result<Simplified> {
        let samples = &self.poles.triangulation().coords()[..self.poles.sample_count()];
        let bounds = crate::points::Bounds::of(samples.iter().copied());
        let diagonal = bounds.map_or(0.0, |bounds| bounds.diagonal());
        let epsilon = options.epsilon.unwrap_or(EPSILON * diagonal);
        let delta = options.delta.unwrap_or(DELTA * diagonal);
        for (name, value) in [("epsilon", epsilon), ("delta", delta)] {
            if !(value.is_finite() && value >= 0.0) {
                let message = format!("{name} must be finite and not negative, not {value:?}");
                return Err(Error::new(Status::InvalidArgument, message));
            }
        }
        job.run(&DERIVE, |run| {
            let mut room = Room::new(run);
            let stable = self.stable(epsilon, &mut room, run)?;
            let keeper = self.keepers(&stable, delta, &mut room, run)?;
            let weight = |pole: usize| match stable[pole] && keeper[pole] == NONE {
                true => self.weight(pole),
                false => None,
            };
            let shards = if self.options.keep_shards { Shards::Keep } else { Shards::Merge };
            let crust = self.derived_in(weight, self.shards.min(shards), run)?;
            let (mut unstable, mut redundant) = (Vec::new(), Vec::new());
            for pole in run.watch((0..self.poles.len()).filter(|&p| self.weight(p).is_some())) {
                let pole = pole?;
                if !stable[pole] {
                    room.push(&mut unstable, pole as u32)?;
                } else if keeper[pole] != NONE {
                    room.push(&mut redundant, [pole as u32, keeper[pole]])?;
                }
            }
            Ok(Simplified { crust: Arc::new(crust), epsilon, delta, unstable, redundant })
        })
    }

    /// Which poles have two samples on their balls that are farther apart than epsilon.
    fn stable(&self, epsilon: f64, room: &mut Room<'_>, run: &Run<'_>) -> Result<Vec<bool>> {
        let poles = &*self.poles;
        let coords = poles.triangulation().coords();
        let square = |a: u32, b: u32| {
            let d = [0, 1, 2].map(|k| coords[a as usize][k] - coords[b as usize][k]);
            d[0] * d[0] + d[1] * d[1] + d[2] * d[2]
        };
        let is_wide = |samples: &[u32]| {
            let Some(&first) = samples.first() else { return false };
            let from_first = samples.iter().map(|&s| square(first, s)).fold(0.0, f64::max);
            // The farthest two are at most twice as far apart as one of them is from the first.
            from_first > epsilon * epsilon
                || (4.0 * from_first > epsilon * epsilon
                    && samples.iter().enumerate().any(|(i, &a)| {
                        samples[..i].iter().any(|&b| square(a, b) > epsilon * epsilon)
                    }))
        };
        let mut stable = room.filled(poles.len(), false)?;
        let chunks = stable.chunks_mut(crate::job::PART).zip(parts(poles.len())).collect();
        run.in_parallel(chunks, |(stable, range)| {
            run.poll()?;
            for (stable, pole) in stable.iter_mut().zip(range) {
                *stable =
                    poles.touches_far_box()[pole] || is_wide(poles.samples_on_balls().row(pole));
            }
            Ok(())
        })?;
        Ok(stable)
    }

    /// For each stable pole that is redundant the pole that keeps its place, [`NONE`] for all others.
    fn keepers(
        &self,
        stable: &[bool],
        delta: f64,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Vec<u32>> {
        let balls = self.poles.balls();
        let all = 0..self.poles.len();
        let radii = room.collect(all.clone().map(|p| self.weight(p).map_or(0.0, f64::sqrt)))?;
        let radius = |pole: u32| radii[pole as usize];
        let neighbors = self.neighbors_in_shapes(room, run)?;
        let mut order = Vec::new();
        for pole in run.watch(all.filter(|&pole| stable[pole])) {
            room.push(&mut order, pole? as u32)?;
        }
        // The largest first, of equal ones the least number.
        sort_by_key(&mut order, |&pole| !float_key(radius(pole)), run)?;
        let mut keeper = room.filled(self.poles.len(), NONE)?;
        // By whom each pole was looked at last.
        let mut seen = room.filled(self.poles.len(), NONE)?;
        let (mut stack, mut looked_at) = (Vec::new(), 0);
        for keeping in run.watch(order.iter()) {
            let &keeping = keeping?;
            if keeper[keeping as usize] != NONE {
                continue;
            }
            let [x, y, z, _] = balls[keeping as usize];
            let within = radius(keeping) + delta;
            stack.extend_from_slice(neighbors.row(keeping as usize));
            seen[keeping as usize] = keeping;
            while let Some(pole) = stack.pop() {
                looked_at += 1;
                if looked_at % 4096 == 0 {
                    run.poll()?;
                }
                let p = pole as usize;
                if std::mem::replace(&mut seen[p], keeping) == keeping {
                    continue;
                }
                let d = [0, 1, 2].map(|k| balls[p][k] - [x, y, z][k]);
                let distance = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
                if radius(pole) < radius(keeping) && distance + radius(pole) <= within {
                    // What went before passes on as well.
                    if stable[p] && keeper[p] == NONE {
                        keeper[p] = keeping;
                    }
                    stack.extend_from_slice(neighbors.row(p));
                }
            }
        }
        Ok(keeper)
    }

    /// The neighbours of each pole in the power shape of its side.
    fn neighbors_in_shapes(&self, room: &mut Room<'_>, run: &Run<'_>) -> Result<Rows> {
        let regular = &*self.regular;
        let poles = regular.row_of_vertex();
        let mut pairs: Vec<u64> = Vec::new();
        for cell in run.watch(0..regular.cells().len()) {
            let cell = cell?;
            for &[i, j] in regular.edges_met(cell as u32) {
                let [p, q] = [i, j].map(|slot| poles[regular.cells()[cell][slot] as usize]);
                if self.labels[p as usize] == self.labels[q as usize] {
                    room.push(&mut pairs, u64::from(p) << 32 | u64::from(q))?;
                    room.push(&mut pairs, u64::from(q) << 32 | u64::from(p))?;
                }
            }
        }
        sort_by_key(&mut pairs, |&pair| pair, run)?;
        pairs.dedup();
        let mut offsets = room.filled(self.poles.len() + 1, 0u32)?;
        for pair in &pairs {
            offsets[(pair >> 32) as usize + 1] += 1;
        }
        for p in 0..self.poles.len() {
            offsets[p + 1] += offsets[p];
        }
        Rows::new(offsets, room.collect(pairs.iter().map(|&pair| pair as u32))?)
    }
}

//! Which poles are left out, since their samples' Voronoi cells are not long and thin (Amenta, Choi, Kolluri 2001, section 6).
//!
//! Where a sample is dense, every Voronoi vertex of it that lies off the line through its first pole is near: at an
//! angle beta to that line, at distance d, the local feature size is at least d sin(beta - lambda) / lambda (section 6.1, after Lemma 1;
//! `docs/algorithms/poles.md` has the details). A pole is no nearer than the local feature size. One that is shows that the cell is misshapen.

use super::select::Selection;
use crate::dual::Dual;
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{PART, Room, Run};

/// What is left out where the Voronoi cell of a sample is not long and thin.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u32)]
pub enum Omit {
    /// Nothing.
    #[default]
    Nothing = 0,
    /// The pole that is too near: for noise (section 6.1).
    Side = 1,
    /// Both poles of the sample where one is too near: for sharp edges and corners (section 6.2).
    Both = 2,
}

/// Which poles are chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PolesOptions {
    /// What is left out.
    pub omit: Omit,
    /// An estimate of the spacing of the sample, relative to the local feature size, in [0, pi/4); 0, the default, to estimate it from the
    /// sample.
    pub lambda: f64,
}

/// How the estimate follows from the widths of cells: so many times the median.
const WIDTHS: f64 = 3.0;
/// The least estimate, which keeps most poles of clean samples, and the largest, which leaves out most of noise: see
/// `docs/algorithms/poles.md`.
const ESTIMATES: [f64; 2] = [0.4, 0.45];

/// Leaves poles out as the options say. Returns lambda, 0 if it was not asked for.
///
/// Errors: [`Status::InvalidArgument`] for a lambda out of range, [`Status::TooFewPoints`] where every pole goes.
pub(super) fn omit(
    dual: &Dual,
    selection: &mut Selection,
    options: PolesOptions,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<f64> {
    if !(0.0..std::f64::consts::FRAC_PI_4).contains(&options.lambda) {
        let message = format!("lambda must lie in [0, pi/4), not {:?}", options.lambda);
        return Err(Error::new(Status::InvalidArgument, message));
    }
    if options.omit == Omit::Nothing {
        return Ok(0.0);
    }
    let cells = Cells { dual, samples: selection.first.len() };
    let lambda = match options.lambda {
        0.0 => cells.estimate(selection, room, run)?,
        lambda => lambda,
    };
    let (sin, cos) = libm::sincos(lambda);
    // The angle exceeds 2 lambda where across > tan(2 lambda) along.
    let slope = libm::tan(2.0 * lambda);
    let Selection { first, second, normals } = selection;
    let incidence = dual.triangulation().incidence_in(run)?;
    let chunks = first.chunks_mut(PART / 8).zip(second.chunks_mut(PART / 8));
    let chunks = chunks.zip(normals.chunks(PART / 8)).enumerate().collect();
    let omitted = run.in_steps(chunks, [0.7, 0.8], |(chunk, ((first, second), normals))| {
        run.poll()?;
        let mut omitted = 0;
        for (i, &normal) in normals.iter().enumerate() {
            let sample = chunk * (PART / 8) + i;
            let mut bound = 0.0f64;
            for &cell in incidence.cells_of(sample as u32) {
                if let Some([along, across]) = cells.seen(sample, cell, normal)
                    && across > slope * along
                {
                    bound = bound.max((across * cos - along * sin) / lambda);
                }
            }
            let is_short =
                |cell: u32| cell != NONE && dual.radii_squared()[cell as usize].sqrt() < bound;
            let short = [is_short(first[i]), is_short(second[i])];
            let both = options.omit == Omit::Both && short != [false; 2];
            for (pole, short) in [&mut first[i], &mut second[i]].into_iter().zip(short) {
                if *pole != NONE && (short || both) {
                    *pole = NONE;
                    omitted += 1;
                }
            }
        }
        Ok(omitted)
    })?;
    let omitted: usize = omitted.into_iter().sum();
    if omitted > 0 && first.iter().chain(&*second).all(|&cell| cell == NONE) {
        return Err(Error::new(
            Status::TooFewPoints,
            format!(
                "with lambda {lambda} all {omitted} poles of the sample are left out; use a larger lambda, or leave out less"
            ),
        ));
    }
    Ok(lambda)
}

/// The Voronoi cells of the samples.
struct Cells<'a> {
    dual: &'a Dual,
    samples: usize,
}

impl Cells<'_> {
    /// How far a Voronoi vertex of a sample is along the line through the first pole, and across it. `None` if it is one
    /// of the far box: how far that is tells nothing of the surface.
    fn seen(&self, sample: usize, cell: u32, normal: [f64; 3]) -> Option<[f64; 2]> {
        let t = self.dual.triangulation();
        if t.cells()[cell as usize].iter().any(|&v| v as usize >= self.samples) {
            return None;
        }
        let (center, s) = (self.dual.centers()[cell as usize], t.coords()[sample]);
        let v = [0, 1, 2].map(|k| center[k] - s[k]);
        let along = v[0] * normal[0] + v[1] * normal[1] + v[2] * normal[2];
        let across = [0, 1, 2].map(|k| v[k] - along * normal[k]);
        let square = across[0] * across[0] + across[1] * across[1] + across[2] * across[2];
        Some([along.abs(), square.sqrt()])
    }

    /// An estimate of lambda: three times the median of the cells' widths, relative to the distance of the nearer pole.
    fn estimate(&self, selection: &Selection, room: &mut Room<'_>, run: &Run<'_>) -> Result<f64> {
        let incidence = self.dual.triangulation().incidence_in(run)?;
        let mut widths = room.vec(self.samples)?;
        for sample in run.watch(0..self.samples) {
            let sample = sample?;
            let cells = [selection.first[sample], selection.second[sample]];
            let near = cells.iter().filter(|&&cell| cell != NONE);
            let near = near.map(|&cell| self.dual.radii_squared()[cell as usize].sqrt());
            let near = near.fold(f64::INFINITY, f64::min);
            let seen = incidence.cells_of(sample as u32).iter();
            let seen = seen.filter_map(|&cell| self.seen(sample, cell, selection.normals[sample]));
            let wide = seen
                .filter(|[along, across]| across > along)
                .fold(0.0f64, |wide, [_, across]| wide.max(across));
            if near.is_finite() {
                widths.push(wide / near);
            }
        }
        if widths.is_empty() {
            return Ok(ESTIMATES[1]);
        }
        let middle = widths.len() / 2;
        let (_, &mut median, _) = widths.select_nth_unstable_by(middle, f64::total_cmp);
        Ok((WIDTHS * median).clamp(ESTIMATES[0], ESTIMATES[1]))
    }
}

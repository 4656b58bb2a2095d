//! The choice of the poles of each sample.

use crate::error::Result;
use crate::index::NONE;
use crate::job::Run;
use crate::points::FAR_BOX_LEN;
use crate::predicates::{Sign, angle};
use crate::triangulation::{Incidence, Triangulation};
use std::cmp::Ordering;

/// What was chosen for each sample.
pub(super) struct Picks {
    /// The cells whose circumcentres are the first and the second pole.
    pub cells: Vec<[u32; 2]>,
    /// The unit vector towards the first pole.
    pub normals: Vec<[f64; 3]>,
}

impl Picks {
    /// Chooses among the cells of each sample in a triangulation of S and Z.
    pub fn new(
        triangulation: &Triangulation,
        incidence: &Incidence,
        centers: &[[f64; 3]],
        radii_squared: &[f64],
        run: &Run<'_>,
    ) -> Result<Self> {
        let samples = triangulation.coords().len() - FAR_BOX_LEN;
        let mut picks = Picks { cells: run.try_vec(samples)?, normals: run.try_vec(samples)? };
        // The farther first, then the lexicographically lesser centre, then the lesser cell.
        let farther = |&c: &u32, &d: &u32| -> Ordering {
            let (i, j) = (c as usize, d as usize);
            radii_squared[i]
                .total_cmp(&radii_squared[j])
                .then_with(|| lexicographic(&centers[j], &centers[i]))
                .then(d.cmp(&c))
        };
        for sample in 0..samples {
            if sample % 1024 == 0 {
                run.tick(samples / 2 + sample / 2, samples)?;
            }
            let s = &triangulation.coords()[sample];
            let cells = incidence.cells_of(sample as u32);
            let Some(first) = cells.iter().copied().max_by(farther) else {
                picks.cells.push([NONE; 2]);
                picks.normals.push([0.0; 3]);
                continue;
            };
            let p = &centers[first as usize];
            let across = |cell: &u32| angle(p, s, &centers[*cell as usize]) == Sign::Negative;
            let second = cells.iter().copied().filter(across).max_by(farther).unwrap_or(NONE);
            picks.cells.push([first, second]);
            picks.normals.push(unit(std::array::from_fn(|k| p[k] - s[k])));
        }
        Ok(picks)
    }
}

/// The lexicographic order of finite coordinates.
fn lexicographic(a: &[f64; 3], b: &[f64; 3]) -> Ordering {
    a.partial_cmp(b).unwrap_or(Ordering::Equal)
}

/// The vector of length 1 in the same direction; neither overflow nor underflow spoils it.
fn unit(v: [f64; 3]) -> [f64; 3] {
    let largest = v.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    if largest == 0.0 {
        return v;
    }
    let v = v.map(|x| x / largest);
    let length = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
    v.map(|x| x / length)
}

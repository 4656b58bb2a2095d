//! Poisson-disk thinning: of a stream of candidates keep those that are not near a kept one.

use super::Sample;
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Charge, Run};
use crate::points::POINT_LIMIT;
use crate::vector::{Vec3, dot, sub};

/// The kept samples, found again by a grid whose cells are hashed into buckets.
///
/// Invariant: no two kept samples are nearer than `spacing`; `head` has a power of two of entries, no
/// fewer than there are samples, and each sample is in the chain of its cell's bucket.
pub(super) struct Thinning<'a> {
    run: &'a Run<'a>,
    spacing: f64,
    origin: Vec3,
    /// A little more than the spacing, so that rounding cannot put two samples that are too near
    /// each other two cells apart.
    cell_size: f64,
    kept: Vec<Sample>,
    head: Vec<u32>,
    next: Vec<u32>,
    charge: Option<Charge<'a>>,
}

impl<'a> Thinning<'a> {
    pub(super) fn new(spacing: f64, origin: Vec3, run: &'a Run<'a>) -> Self {
        Thinning {
            run,
            spacing,
            origin,
            cell_size: spacing * (1.0 + 1e-9),
            kept: Vec::new(),
            head: Vec::new(),
            next: Vec::new(),
            charge: None,
        }
    }

    /// Keeps the candidate if no kept sample is nearer than the spacing. Expected cost: O(1).
    pub(super) fn offer(&mut self, candidate: Sample) -> Result<()> {
        if self.is_covered(candidate.point) {
            return Ok(());
        }
        if self.kept.len() == self.head.len() {
            self.grow()?;
        }
        let sample = self.kept.len() as u32;
        self.kept.push(candidate);
        self.next.push(NONE);
        self.link(sample);
        Ok(())
    }

    pub(super) fn into_kept(self) -> Vec<Sample> {
        self.kept
    }

    fn is_covered(&self, p: Vec3) -> bool {
        if self.kept.is_empty() {
            return false;
        }
        let [x, y, z] = self.cell(p);
        // The candidate's own cell first: most candidates end there.
        for dz in [0, -1, 1] {
            for dy in [0, -1, 1] {
                for dx in [0, -1, 1] {
                    let cell = [x.wrapping_add(dx), y.wrapping_add(dy), z.wrapping_add(dz)];
                    let mut sample = self.head[self.bucket(cell)];
                    while sample != NONE {
                        let d = sub(self.kept[sample as usize].point, p);
                        if dot(d, d) < self.spacing * self.spacing {
                            return true;
                        }
                        sample = self.next[sample as usize];
                    }
                }
            }
        }
        false
    }

    fn cell(&self, p: Vec3) -> [i64; 3] {
        std::array::from_fn(|i| ((p[i] - self.origin[i]) / self.cell_size).floor() as i64)
    }

    fn bucket(&self, cell: [i64; 3]) -> usize {
        // Odd multipliers, from the fractions of the golden ratio and of two of its kin.
        let mixed = (cell[0] as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15)
            ^ (cell[1] as u64).wrapping_mul(0xbf58_476d_1ce4_e5b9)
            ^ (cell[2] as u64).wrapping_mul(0x94d0_49bb_1331_11eb);
        let hash = (mixed ^ (mixed >> 29)).wrapping_mul(0xd6e8_feb8_6659_fd93);
        (hash >> 32) as usize & (self.head.len() - 1)
    }

    fn link(&mut self, sample: u32) {
        let bucket = self.bucket(self.cell(self.kept[sample as usize].point));
        self.next[sample as usize] = self.head[bucket];
        self.head[bucket] = sample;
    }

    /// Doubles the room and files every sample anew.
    fn grow(&mut self) -> Result<()> {
        let room = (2 * self.head.len()).max(1024);
        if room > POINT_LIMIT {
            return Err(Error::new(
                Status::LimitExceeded,
                format!("more than {} samples; ask for a larger spacing", POINT_LIMIT / 2),
            ));
        }
        let bytes = room * (size_of::<Sample>() + 2 * size_of::<u32>());
        self.charge = Some(self.run.charge(bytes as u64)?);
        let mut kept = self.run.try_vec(room)?;
        kept.append(&mut self.kept);
        self.kept = kept;
        self.head = self.run.try_vec(room)?;
        self.head.resize(room, NONE);
        let mut next = self.run.try_vec(room)?;
        next.resize(self.kept.len(), NONE);
        self.next = next;
        for sample in 0..self.kept.len() as u32 {
            if sample % 65536 == 0 {
                self.run.poll()?;
            }
            self.link(sample);
        }
        Ok(())
    }
}

//! Samples that are as far apart as the spacing asks for: of those that are too near to another the one that matters less is left out.

use crate::error::Result;
use crate::job::{Room, Run};
use crate::vector::{Vec3, dot, sub};

/// Where a sample lies: what comes first is kept first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Kind {
    /// Where three spheres meet.
    Corner,
    /// Where two do.
    Crease,
    /// On one.
    Patch,
}

/// A point of the boundary.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    pub point: Vec3,
    /// A ball on whose sphere it is.
    pub ball: u32,
    /// How often the spacing is halved here.
    pub level: u8,
    pub kind: Kind,
}

/// The spacing, and its halves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scale(pub f64);

/// How often the spacing is halved at most: down to the smallest radius beside a spacing as large as may be, or nearly.
const LEVELS: u8 = 200;

impl Scale {
    /// How often it is halved, to be no more than a length: the radius of a ball.
    pub fn level(self, length: f64) -> u8 {
        let (mut level, mut spacing) = (0, self.0);
        while spacing > length && level < LEVELS {
            spacing *= 0.5;
            level += 1;
        }
        level
    }

    /// The spacing, halved so often.
    pub fn spacing(self, level: u8) -> f64 {
        self.0 * 0.5f64.powi(i32::from(level))
    }
}

/// Keeps samples of which none is within half its spacing of one that is kept before it: corners, then creases, then the rest, the finest first.
///
/// A coarse sample may be missed by a fine one beside it, which costs a vertex. Cost: O(n) for each level.
pub(super) fn thinned(
    samples: &mut Vec<Sample>,
    sizes: Scale,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<()> {
    run.poll()?;
    samples.sort_by_key(|sample| (sample.kind, u8::MAX - sample.level));
    let mut counts = [0usize; LEVELS as usize + 1];
    samples.iter().for_each(|sample| counts[usize::from(sample.level)] += 1);
    let mut grids: Vec<(u8, Grid)> = Vec::new();
    let mut finer = 0;
    for level in (0..=LEVELS).rev().filter(|&level| counts[usize::from(level)] > 0) {
        finer += counts[usize::from(level)];
        let size = finer.next_power_of_two();
        let grid = Grid {
            side: 0.5 * sizes.spacing(level),
            heads: room.filled(size, NOTHING)?,
            entries: Vec::new(),
        };
        grids.push((level, grid));
    }
    let mut count = 0;
    for i in run.watch(0..samples.len()) {
        let sample = samples[i?];
        let own = grids.partition_point(|(level, _)| *level > sample.level);
        if grids[own].1.is_near(sample.point) {
            continue;
        }
        for (_, grid) in &mut grids[own..] {
            grid.insert(sample.point, room)?;
        }
        samples[count] = sample;
        count += 1;
    }
    samples.truncate(count);
    Ok(())
}

/// No entry.
const NOTHING: u32 = u32::MAX;

/// Points by the cubes that they lie in, which share buckets.
struct Grid {
    /// The side of a cube: what is nearer is near.
    side: f64,
    heads: Vec<u32>,
    /// Points, and the entry that was in their bucket before.
    entries: Vec<(Vec3, u32)>,
}

impl Grid {
    fn cube(&self, p: Vec3) -> [i64; 3] {
        p.map(|x| (x / self.side).floor() as i64)
    }

    /// The bucket of a cube. Cubes of a block of 64 stand together, blocks are scattered (Teschner and others 2003, *Optimized spatial hashing for collision detection of deformable objects*).
    fn bucket(&self, cube: [i64; 3]) -> usize {
        let [x, y, z] = cube.map(|i| i >> 2);
        let block =
            x.wrapping_mul(73_856_093) ^ y.wrapping_mul(19_349_663) ^ z.wrapping_mul(83_492_791);
        let place = cube.iter().fold(0, |place, i| place << 2 | (i & 3));
        (block << 6 | place) as usize & (self.heads.len() - 1)
    }

    fn is_near(&self, p: Vec3) -> bool {
        let cube = self.cube(p);
        let is_near = |dx: i64, dy: i64, dz: i64| {
            let mut entry = self.heads[self.bucket([cube[0] + dx, cube[1] + dy, cube[2] + dz])];
            while let Some(&(q, before)) = self.entries.get(entry as usize) {
                let way = sub(p, q);
                if dot(way, way) < self.side * self.side {
                    return true;
                }
                entry = before;
            }
            false
        };
        // Most often what is near is in the same cube.
        let steps = [0, -1, 1];
        steps.iter().any(|&x| steps.iter().any(|&y| steps.iter().any(|&z| is_near(x, y, z))))
    }

    fn insert(&mut self, p: Vec3, room: &mut Room<'_>) -> Result<()> {
        let bucket = self.bucket(self.cube(p));
        let entry = self.entries.len() as u32;
        room.push(&mut self.entries, (p, self.heads[bucket]))?;
        self.heads[bucket] = entry;
        Ok(())
    }
}

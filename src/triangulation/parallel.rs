//! Insertion by several threads at once (after Marot, Pellerin, Remacle 2019, section 3).
//!
//! Space is cut into boxes, one for each thread. A thread inserts a vertex of its box only if all cells in
//! conflict belong to the box: see `cells.rs`. There are no locks. What cannot be inserted is postponed to the
//! next pass, which cuts across another axis first, and in the end to one thread. The triangulation is unique, so
//! the result does not depend on who inserted what, or when.

use super::cells::{CELL_LIMIT, Cell, Cells, PIECE, Patch, Slots};
use super::partition::{Partition, axes_by_length};
use super::worker::{Dug, Worker};
use crate::error::Result;
use crate::job::{PART, Room, Run};
use crate::predicates::around::Site;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Points between two looks at the clock.
const TICK: usize = 256;
/// The fewest points that are worth a thread.
const PER_THREAD: usize = if cfg!(test) { 16 } else { 1 << 12 };
/// The fewest points that are worth a thread in another pass: their threads have their arrays already.
const PER_THREAD_AGAIN: usize = if cfg!(test) { 8 } else { 1 << 10 };
/// The most threads: a box's number is a byte.
const MOST_THREADS: usize = 255;
/// How many vertices of a box are tried to find a cell in it.
const TRIALS: usize = 16;
/// The most passes of several threads in a round.
const PASSES: usize = 4;
/// What the sides of cuts that lie below them have of their fair share of the points, in one pass after the other: what is
/// left lies near earlier cuts, and so would fair ones.
const SHARES: [f64; PASSES] = [1.0, 0.7, 1.2, 0.5];
/// How many vertices are looked at to cut space into equal parts.
const CUT_SAMPLE: usize = 1 << 13;

/// How many threads a round of so many vertices is worth.
pub(super) fn threads(vertices: usize, run: &Run<'_>) -> usize {
    run.threads().min(vertices / PER_THREAD).clamp(1, MOST_THREADS)
}

/// The steps of a stage that inserts so many vertices: one each, and for the last quarter, in which the cells are
/// brought into order.
fn steps(vertices: usize) -> usize {
    vertices + vertices / 3
}

/// The workers of one build, and how far they are.
pub(super) struct Crew<'a, S> {
    run: &'a Run<'a>,
    room: Room<'a>,
    sites: &'a [S],
    /// The axes, the longest first.
    axes: [usize; 3],
    /// At least one.
    workers: Vec<Worker>,
    /// Some cell.
    near: Cell,
    /// The points inserted.
    done: AtomicUsize,
    /// The box of each vertex; empty before the first pass of several threads.
    boxes: Vec<u8>,
}

impl<'a, S: Site> Crew<'a, S> {
    /// One worker, at the beginning.
    pub fn new(cells: &Cells<'_>, sites: &'a [S], run: &'a Run<'a>) -> Result<Self> {
        let mut room = Room::new(run);
        let axes = axes_by_length(sites.iter().map(|site| *site.position()));
        Ok(Crew {
            run,
            sites,
            axes,
            workers: vec![Worker::new(sites.len(), cells.first(), &mut room)?],
            near: cells.first(),
            done: AtomicUsize::new(0),
            boxes: Vec::new(),
            room,
        })
    }

    /// The slots that are left.
    pub fn into_slots(self) -> impl Iterator<Item = Slots> {
        self.workers.into_iter().map(Worker::into_slots)
    }

    /// Inserts vertices one after the other.
    ///
    /// Errors: those of the run and of [`Cells::hand_out`].
    pub fn insert_in_turn(
        &mut self,
        cells: &mut Cells<'_>,
        vertices: impl Iterator<Item = u32>,
    ) -> Result<()> {
        let (run, sites, worker) = (self.run, self.sites, &mut self.workers[0]);
        worker.begin(&[self.near]);
        for (i, vertex) in vertices.enumerate() {
            if i % TICK == 0 {
                run.tick(self.done.fetch_add(TICK, Ordering::Relaxed), steps(sites.len()))?;
            }
            if worker.dig::<S, false>(&mut cells.whole(), sites, vertex, run)? == Dug::Cavity {
                worker.provide(cells)?;
                worker.fill(&mut cells.whole(), vertex);
            }
        }
        self.near = worker.near();
        Ok(())
    }

    /// Inserts about `expected` vertices, given in spatial order each time that they are asked for, by several
    /// threads.
    ///
    /// Errors: as [`Crew::insert_in_turn`].
    pub fn insert_at_once<V: Iterator<Item = u32> + Send>(
        &mut self,
        cells: &mut Cells<'_>,
        vertices: impl Fn() -> V + Sync,
        expected: usize,
        threads: usize,
    ) -> Result<()> {
        let every = self.sites.len().div_ceil(CUT_SAMPLE);
        self.cut((0..self.sites.len() as u32).step_by(every), threads, 0)?;
        let mut left = self.pass(cells, vertices, expected, threads)?;
        for pass in 1..PASSES {
            let threads = threads.min(left.len() / PER_THREAD_AGAIN);
            if threads < 2 {
                break;
            }
            let every = left.len().div_ceil(CUT_SAMPLE);
            self.cut(left.iter().copied().step_by(every), threads, pass)?;
            left = self.pass(cells, || left.iter().copied(), left.len(), threads)?;
        }
        self.insert_in_turn(cells, left.into_iter())
    }

    /// One pass of several threads, each in its box. Returns the vertices that are left, in spatial order.
    fn pass<V: Iterator<Item = u32> + Send>(
        &mut self,
        cells: &mut Cells<'_>,
        vertices: impl Fn() -> V + Sync,
        expected: usize,
        threads: usize,
    ) -> Result<Vec<u32>> {
        let (run, sites) = (self.run, self.sites);
        while self.workers.len() < threads {
            self.workers.push(Worker::new(sites.len(), self.near, &mut self.room)?);
        }
        // A quarter more than so many vertices took up to now. If that is not enough, points wait for the next pass.
        let per_point = cells.len() as f64 / self.done.load(Ordering::Relaxed).max(1) as f64;
        let wanted = (1.25 * expected as f64 * per_point) as usize + threads * PIECE;
        cells.prepare(wanted.min(CELL_LIMIT - cells.len()))?;
        let mut begun = Vec::new();
        for (id, worker) in self.workers[..threads].iter_mut().enumerate() {
            // Some of all its vertices: those to insert may all lie near an earlier cut.
            let some = (0..sites.len() as u32).step_by(sites.len() / (threads * TRIALS) + 1);
            let own = some.filter(|&v| usize::from(self.boxes[v as usize]) == id);
            begun.push(begin_within(cells, sites, worker, self.near, &self.boxes, own));
        }
        let idle = self.workers.split_off(threads);
        let working = std::mem::replace(&mut self.workers, idle);
        let (boxes, done) = (&self.boxes, &self.done);
        let patches = cells.patches(boxes, threads as u8);
        let parts = working.into_iter().zip(patches).zip(&begun).enumerate();
        let work = |(id, ((mut worker, mut patch), &begun)): Part<'_>| {
            let own = vertices().filter(|&v| usize::from(boxes[v as usize]) == id);
            let mut room = Room::new(run);
            let (mut left, mut inserted) = (Vec::new(), 0);
            for (i, vertex) in own.enumerate() {
                if i % TICK == 0 {
                    // Seldom: what several threads write goes from one processor to the other each time.
                    let done = done.fetch_add(std::mem::take(&mut inserted), Ordering::Relaxed);
                    run.tick(done, steps(sites.len()))?;
                }
                if begun && worker.insert(&mut patch, sites, vertex, run)? {
                    inserted += 1;
                } else {
                    room.push(&mut left, vertex)?;
                }
            }
            done.fetch_add(inserted, Ordering::Relaxed);
            Ok((worker, left))
        };
        let results = run.in_parallel(parts.collect(), work)?;
        cells.add_taken()?;
        let mut left = Vec::new();
        let mut working = Vec::new();
        for ((worker, its), begun) in results.into_iter().zip(begun) {
            if begun {
                // Nobody else could change this cell.
                self.near = worker.near();
            }
            working.push(worker);
            self.room.grow(&mut left, its.len())?;
            left.extend(its);
        }
        working.append(&mut self.workers);
        self.workers = working;
        left.sort_unstable();
        Ok(left)
    }

    /// Cuts space into boxes for so many threads, by a sample of the vertices to insert: in each pass elsewhere, so
    /// that what was left near one's cuts is not near the next one's.
    fn cut(
        &mut self,
        sample: impl Iterator<Item = u32>,
        threads: usize,
        pass: usize,
    ) -> Result<()> {
        let mut sample: Vec<[f64; 3]> =
            sample.map(|v| *self.sites[v as usize].position()).collect();
        let (axis, share) = (self.axes[pass % 3], SHARES[pass]);
        // Nothing was cut across this axis first before.
        let first = if pass < 3 { 1.0 } else { share };
        let partition = Partition::new(&mut sample, 0..threads as u8, axis, [first, share]);
        if self.boxes.is_empty() {
            self.boxes = self.room.filled(self.sites.len(), 0)?;
        }
        let parts = self.boxes.chunks_mut(PART).zip(self.sites.chunks(PART)).collect();
        self.run.in_parallel(parts, |(boxes, sites)| {
            self.run.poll()?;
            for (of_vertex, site) in boxes.iter_mut().zip(sites) {
                *of_vertex = partition.of(site.position());
            }
            Ok(())
        })?;
        Ok(())
    }
}

/// The number of a box, who works there, and whether a cell in it was found to begin with.
type Part<'a> = (usize, ((Worker, Patch<'a>), &'a bool));

/// Makes a worker begin at cells of a box, given vertices in it. Returns whether such a cell was found.
fn begin_within<S: Site>(
    cells: &mut Cells<'_>,
    sites: &[S],
    worker: &mut Worker,
    from: Cell,
    boxes: &[u8],
    vertices: impl Iterator<Item = u32>,
) -> bool {
    let patch = cells.whole();
    let mut near = from;
    let mut found = Vec::new();
    for vertex in vertices {
        near = worker.locate(&patch, sites, near, vertex);
        let its = Some(&boxes[vertex as usize]);
        let own = patch.vertices(near).into_iter().filter(|&v| boxes.get(v as usize) == its);
        if own.count() >= 3 {
            found.push(near);
        }
    }
    let begun = !found.is_empty();
    found.push(from);
    worker.begin(&found[..found.len() - usize::from(begun)]);
    begun
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::{Job, JobOptions};
    use crate::points::Points;
    use crate::triangulation::Triangulation;
    use std::sync::Arc;

    /// Numbers in [0, 1), always the same.
    fn numbers(seed: u64) -> impl FnMut() -> f64 {
        let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
        move || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1u64 << 53) as f64
        }
    }

    /// A name, rows, and a weight per row.
    type Set = (&'static str, Vec<[f64; 3]>, Vec<f64>);

    /// Small sets of many kinds.
    fn sets() -> Vec<Set> {
        let count = if cfg!(miri) { 100 } else { 3000 };
        let mut unit = numbers(7);
        let cube: Vec<_> = (0..count).map(|_| [unit(), unit(), unit()]).collect();
        let ball = |p: &[f64; 3]| {
            let d = p.map(|x| 2.0 * x - 1.0);
            let length = d.iter().map(|x| x * x).sum::<f64>().sqrt().max(1e-3);
            d.map(|x| x / length)
        };
        let sphere = cube.iter().map(ball).collect();
        let needle = cube.iter().map(|&[x, y, z]| [1000.0 * x, y, z]).collect();
        let clusters = cube.iter().map(|p| p.map(|x| (8.0 * x).floor() + x * 1e-3)).collect();
        let lattice =
            (0..count as u32).map(|i| [i % 13, i / 13 % 13, i / 169].map(f64::from)).collect();
        let sets = [
            ("cube", cube),
            ("sphere", sphere),
            ("needle", needle),
            ("clusters", clusters),
            ("lattice", lattice),
        ];
        let sets = sets.into_iter().map(|(name, rows): (_, Vec<[f64; 3]>)| {
            let weights = rows.iter().map(|_| 0.02 * unit()).collect();
            (name, rows, weights)
        });
        sets.collect()
    }

    #[test]
    fn cells_are_the_same_whatever_the_threads() {
        for (name, rows, weights) in sets() {
            let build = |threads| {
                let job = Job::new(JobOptions { threads, ..JobOptions::default() });
                let points = Points::new(&rows, Default::default(), &job).unwrap();
                let points = Arc::new(points);
                let delaunay = Triangulation::delaunay(&points, &job).unwrap();
                let regular = Triangulation::regular(&points, &weights, &job).unwrap();
                [delaunay, regular]
                    .map(|t| (t.cells().to_vec(), t.neighbors().to_vec(), t.hidden().to_vec()))
            };
            let one = build(1);
            for threads in [2, 3, 8] {
                assert!(build(threads) == one, "{name}, {threads} threads");
            }
        }
    }

    #[test]
    fn most_points_are_inserted_at_once() {
        let (_, rows, _) = sets().swap_remove(0);
        let job = Job::new(JobOptions { threads: 2, ..JobOptions::default() });
        let points = Points::new(&rows, Default::default(), &job).unwrap();
        let sites = points.coords();
        let left = job.run(&[], |run| {
            let simplex =
                super::super::build::first_simplex(sites.len(), |v| sites[v as usize], run)?;
            let mut cells = Cells::new(simplex, sites.len(), run)?;
            let mut crew = Crew::new(&cells, sites, run)?;
            let all = || (0..sites.len() as u32).filter(|v| !simplex.contains(v));
            // Every eighth first, so that the boxes have cells.
            crew.insert_in_turn(&mut cells, all().filter(|v| v % 8 == 0))?;
            crew.cut(all(), 2, 0)?;
            crew.pass(&mut cells, || all().filter(|v| v % 8 != 0), sites.len(), 2)
        });
        let left = left.unwrap();
        assert!(left.is_sorted());
        assert!(left.len() < sites.len() / 3, "{} of {} were left", left.len(), sites.len());
    }
}

//! How to run: threads, memory ceiling, progress, cancel.
//!
//! Options say *what* to build, a [`Job`] says *how*. A job runs one build at a time; a second
//! one started meanwhile fails with [`Status::Busy`], and a cancelled job is spent.

mod room;
mod threads;

pub(crate) use room::Room;
pub(crate) use threads::{PART, parts, parts_of, pieces};

use crate::error::{Error, Result, Status};
use std::sync::atomic::{AtomicBool, AtomicU8, AtomicU64, Ordering};
use std::sync::{Mutex, OnceLock};
use std::thread::{self, ThreadId};
use std::time::{Duration, Instant};

/// Called with the progress in [0, 1] and the stage; returns `true` to go on, `false` to cancel.
pub type Progress = Box<dyn Fn(f64, Stage) -> bool + Send + Sync>;

/// The least time between two calls of a progress callback.
const CALLBACK_INTERVAL: Duration = Duration::from_millis(50);

/// What a job is doing. The numbers are the C ABI's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Stage {
    /// Nothing yet.
    Idle = 0,
    /// Reading a file.
    Read = 1,
    /// Checking, merging and ordering points.
    Order = 2,
    /// Building a Delaunay triangulation.
    Triangulate = 3,
    /// Reading the dual off a triangulation.
    Dual = 4,
    /// Choosing poles.
    Poles = 5,
    /// Building the regular triangulation of weighted points.
    Regular = 6,
    /// Labelling poles inner and outer.
    Label = 7,
    /// Extracting surfaces and shapes.
    Extract = 8,
    /// Checking a structure.
    Validate = 9,
    /// Counting components, loops and Betti numbers.
    Topology = 10,
    /// Answering a batch of queries.
    Query = 11,
    /// Taking samples of a surface.
    Sample = 12,
    /// Writing a file.
    Write = 13,
    /// Contracting edges of a surface.
    Decimate = 14,
    /// Telling which Voronoi facets belong to the medial axis.
    Medial = 15,
    /// Following the flow of the distance to the samples.
    Flow = 16,
    /// Sampling the distance to sites.
    Field = 17,
    /// Pairing the boundary of a solid with an inner structure.
    Pair = 18,
}

/// Every stage, by number.
const STAGES: [Stage; 19] = [
    Stage::Idle,
    Stage::Read,
    Stage::Order,
    Stage::Triangulate,
    Stage::Dual,
    Stage::Poles,
    Stage::Regular,
    Stage::Label,
    Stage::Extract,
    Stage::Validate,
    Stage::Topology,
    Stage::Query,
    Stage::Sample,
    Stage::Write,
    Stage::Decimate,
    Stage::Medial,
    Stage::Flow,
    Stage::Field,
    Stage::Pair,
];

impl Stage {
    /// The name that progress bars and scripts show.
    pub fn name(self) -> &'static str {
        // A C literal, so that the C ABI can hand out the same bytes.
        self.c_name().to_str().unwrap_or("")
    }

    /// The same name, terminated for C.
    pub fn c_name(self) -> &'static std::ffi::CStr {
        match self {
            Stage::Idle => c"idle",
            Stage::Read => c"read",
            Stage::Order => c"order",
            Stage::Triangulate => c"triangulate",
            Stage::Dual => c"dual",
            Stage::Poles => c"poles",
            Stage::Regular => c"regular",
            Stage::Label => c"label",
            Stage::Extract => c"extract",
            Stage::Validate => c"validate",
            Stage::Topology => c"topology",
            Stage::Query => c"query",
            Stage::Sample => c"sample",
            Stage::Write => c"write",
            Stage::Decimate => c"decimate",
            Stage::Medial => c"medial",
            Stage::Flow => c"flow",
            Stage::Field => c"field",
            Stage::Pair => c"pair",
        }
    }
}

/// How long one stage took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StageTime {
    /// The stage.
    pub stage: Stage,
    /// Elapsed seconds.
    pub wall_seconds: f64,
    /// Processor seconds of the whole process.
    pub cpu_seconds: f64,
}

/// More threads than any machine has use for: each takes memory, which no ceiling counts.
const MOST_THREADS: usize = 1024;

/// The settings of a [`Job`].
#[derive(Default)]
pub struct JobOptions {
    /// The most threads that builds may use, of which there are never more than 1,024; 0 means what the environment variable `MEDAX_THREADS` says, or
    /// one per processor. Results do not depend on it.
    pub threads: usize,
    /// The most bytes that a build's own arrays may take at once; 0 means no ceiling.
    pub memory_ceiling: u64,
    /// Called at most twenty times a second, only on the thread that called the build.
    pub progress: Option<Progress>,
}

/// How to run a build, and the handle to watch or cancel it from any thread.
///
/// Invariants: `cancelled` only ever turns true; `busy` is true exactly while a [`Run`] lives;
/// `progress` never falls during one run.
pub struct Job {
    options: JobOptions,
    busy: AtomicBool,
    cancelled: AtomicBool,
    /// The bits of the progress, an f64 in [0, 1].
    progress: AtomicU64,
    stage: AtomicU8,
    memory_used: AtomicU64,
    memory_peak: AtomicU64,
    times: Mutex<Vec<StageTime>>,
}

impl Default for Job {
    fn default() -> Self {
        Job::new(JobOptions::default())
    }
}

impl Job {
    /// A job ready to run builds.
    pub fn new(options: JobOptions) -> Self {
        Job {
            options,
            busy: AtomicBool::new(false),
            cancelled: AtomicBool::new(false),
            progress: AtomicU64::new(0),
            stage: AtomicU8::new(Stage::Idle as u8),
            memory_used: AtomicU64::new(0),
            memory_peak: AtomicU64::new(0),
            times: Mutex::new(Vec::new()),
        }
    }

    /// Asks the running build, and every later one, to stop with [`Status::Cancelled`].
    /// Any thread, idempotent, never undone.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// Whether [`Job::cancel`] was called, or the progress callback asked to stop.
    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    /// How far the running build is, or the last one came: [0, 1], never decreasing in a build.
    pub fn progress(&self) -> f64 {
        f64::from_bits(self.progress.load(Ordering::Relaxed))
    }

    /// What the running build is doing, or the last one did last.
    pub fn stage(&self) -> Stage {
        STAGES[usize::from(self.stage.load(Ordering::Relaxed))]
    }

    /// The number of threads that a build may use, at least 1.
    pub fn threads(&self) -> usize {
        match self.options.threads {
            0 => default_threads(),
            n => n.min(MOST_THREADS),
        }
    }

    /// The largest number of bytes that one build's arrays took at once.
    pub fn memory_peak(&self) -> u64 {
        self.memory_peak.load(Ordering::Relaxed)
    }

    /// The time of every stage of every build that this job has run, in order.
    pub fn times(&self) -> Vec<StageTime> {
        self.times.lock().map(|times| times.clone()).unwrap_or_default()
    }

    /// The number of stages that the builds of this job have been through.
    pub fn stage_count(&self) -> usize {
        self.times.lock().map_or(0, |times| times.len())
    }

    /// The time of one of those stages.
    pub fn stage_time(&self, index: usize) -> Option<StageTime> {
        self.times.lock().ok()?.get(index).copied()
    }

    /// Runs one build. `plan` lists its stages in order with their share of the work.
    ///
    /// Errors: [`Status::Busy`] while another build runs, [`Status::Cancelled`] on a spent job.
    pub fn run<T>(
        &self,
        plan: &[(Stage, f64)],
        build: impl FnOnce(&Run<'_>) -> Result<T>,
    ) -> Result<T> {
        if self.busy.swap(true, Ordering::Acquire) {
            return Err(Error::new(Status::Busy, "the job is already running a build"));
        }
        let run = Run::new(self, plan);
        run.poll()?;
        let built = build(&run)?;
        run.close_stage();
        run.advance_to(1.0);
        Ok(built)
    }
}

/// What `MEDAX_THREADS` says, or one thread per processor.
fn default_threads() -> usize {
    static DEFAULT: OnceLock<usize> = OnceLock::new();
    *DEFAULT.get_or_init(|| {
        let asked = std::env::var("MEDAX_THREADS").ok().and_then(|value| value.parse().ok());
        let processors = || thread::available_parallelism().map_or(1, |n| n.get());
        asked.filter(|&threads| threads > 0).unwrap_or_else(processors).min(MOST_THREADS)
    })
}

/// The part of a plan that is running.
struct Position {
    /// Index into the plan of the current stage.
    index: Option<usize>,
    /// Progress when the current stage began, and its share.
    base: f64,
    share: f64,
    stage: Option<(Stage, Instant, cpu_time::ProcessTime)>,
    last_callback: Instant,
}

/// One build under way: what the code that builds sees of its [`Job`].
pub struct Run<'a> {
    job: &'a Job,
    plan: Vec<(Stage, f64)>,
    total: f64,
    caller: ThreadId,
    position: Mutex<Position>,
}

impl<'a> Run<'a> {
    fn new(job: &'a Job, plan: &[(Stage, f64)]) -> Self {
        job.progress.store(0f64.to_bits(), Ordering::Relaxed);
        Run {
            job,
            plan: plan.to_vec(),
            total: plan.iter().map(|(_, share)| share).sum::<f64>().max(f64::MIN_POSITIVE),
            caller: thread::current().id(),
            position: Mutex::new(Position {
                index: None,
                base: 0.0,
                share: 0.0,
                stage: None,
                last_callback: Instant::now(),
            }),
        }
    }

    /// Enters a stage. Its share is that of the next entry of the plan with this stage, or none.
    pub fn enter(&self, stage: Stage) -> Result<()> {
        self.close_stage();
        self.job.stage.store(stage as u8, Ordering::Relaxed);
        if let Ok(mut position) = self.position.lock() {
            let from = position.index.map_or(0, |index| index + 1);
            let found = (from..self.plan.len()).find(|&i| self.plan[i].0 == stage);
            let before: f64 = self.plan[..found.unwrap_or(from)].iter().map(|p| p.1).sum();
            position.base = before / self.total;
            position.share = found.map_or(0.0, |i| self.plan[i].1 / self.total);
            position.index = found.or(position.index);
            position.stage = Some((stage, Instant::now(), cpu_time::ProcessTime::now()));
        }
        self.tick(0, 1)
    }

    /// Reports that `done` of `total` steps of the current stage are done, and returns
    /// [`Status::Cancelled`] if the build must stop. Call it at least every 10 ms of work.
    pub fn tick(&self, done: usize, total: usize) -> Result<()> {
        self.poll()?;
        // A build's own thread never waits here: a busy lock means that another one reports.
        let Ok(mut position) = self.position.try_lock() else { return Ok(()) };
        let fraction = done as f64 / total.max(1) as f64;
        self.advance_to(position.base + position.share * fraction.clamp(0.0, 1.0));
        let due = position.last_callback.elapsed() >= CALLBACK_INTERVAL;
        if let (true, Some(callback)) = (due, &self.job.options.progress)
            && thread::current().id() == self.caller
        {
            position.last_callback = Instant::now();
            drop(position);
            if !callback(self.job.progress(), self.job.stage()) {
                self.job.cancel();
            }
            return self.poll();
        }
        Ok(())
    }

    /// Returns [`Status::Cancelled`] if the build must stop; costs one load.
    pub fn poll(&self) -> Result<()> {
        if self.job.is_cancelled() {
            return Err(Error::new(Status::Cancelled, "the job was cancelled"));
        }
        Ok(())
    }

    /// The items of an iterator, with a [`Run::poll`] now and then: for loops whose turns are short.
    pub fn watch<I: IntoIterator>(&self, items: I) -> impl Iterator<Item = Result<I::Item>> {
        items.into_iter().enumerate().map(|(i, item)| {
            if i.is_multiple_of(1 << 14) {
                self.poll()?;
            }
            Ok(item)
        })
    }

    /// The number of threads that this build may use, at least 1.
    pub fn threads(&self) -> usize {
        self.job.threads()
    }

    /// Counts `bytes` against the memory ceiling until the returned charge is dropped.
    /// Call it before allocating.
    pub fn charge(&self, bytes: u64) -> Result<Charge<'a>> {
        let used = self.job.memory_used.fetch_add(bytes, Ordering::Relaxed) + bytes;
        let charge = Charge { job: self.job, bytes };
        let ceiling = self.job.options.memory_ceiling;
        if ceiling != 0 && used > ceiling {
            return Err(Error::new(
                Status::OutOfMemory,
                format!("the build needs {used} bytes at once, more than the ceiling of {ceiling}"),
            ));
        }
        self.job.memory_peak.fetch_max(used, Ordering::Relaxed);
        Ok(charge)
    }

    /// A vector with room for `capacity` elements, or [`Status::OutOfMemory`] instead of an abort.
    pub fn try_vec<T>(&self, capacity: usize) -> Result<Vec<T>> {
        let mut vec = Vec::new();
        let bytes = capacity.saturating_mul(size_of::<T>());
        vec.try_reserve_exact(capacity).map_err(|_| room::out_of_memory(bytes))?;
        Ok(vec)
    }

    /// A vector of equal values, or [`Status::OutOfMemory`]. Zeros take memory only where they are first changed.
    pub fn try_filled<T: Clone>(&self, len: usize, value: T) -> Result<Vec<T>> {
        // Only what the standard library fills can be had as zeros, and it aborts where there is no room: ask first.
        drop(self.try_vec::<T>(len)?);
        Ok(vec![value; len])
    }

    fn close_stage(&self) {
        let Ok(mut position) = self.position.lock() else { return };
        if let Some((stage, wall, cpu)) = position.stage.take() {
            let time = StageTime {
                stage,
                wall_seconds: wall.elapsed().as_secs_f64(),
                cpu_seconds: cpu.elapsed().as_secs_f64(),
            };
            if let Ok(mut times) = self.job.times.lock() {
                times.push(time);
            }
        }
    }

    fn advance_to(&self, progress: f64) {
        // Non-negative floats order as their bits do.
        self.job.progress.fetch_max(progress.min(1.0).to_bits(), Ordering::Relaxed);
    }
}

impl Drop for Run<'_> {
    fn drop(&mut self) {
        self.job.busy.store(false, Ordering::Release);
    }
}

/// Bytes counted against a job's memory ceiling; given back when dropped.
pub struct Charge<'a> {
    job: &'a Job,
    bytes: u64,
}

impl Drop for Charge<'_> {
    fn drop(&mut self) {
        self.job.memory_used.fetch_sub(self.bytes, Ordering::Relaxed);
    }
}

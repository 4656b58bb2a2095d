//! Job
//!
//! Options of a build say what to build; a job says how to run it: with how many threads and how
//! much memory. It tells how far it is, and cancels.
//!
//! A job runs one build at a time: a second one meanwhile fails with `MEDAX_STATUS_BUSY`. A
//! cancelled job is spent: every later build with it fails with `MEDAX_STATUS_CANCELLED`.
//! Wherever a job is asked for, NULL stands for a fresh one with default options.

use super::boundary::{self, Callback};
use super::handle::{self, medax_job};
use super::options::{self, sized_struct};
use super::status::medax_status;
use super::view::Out;
use crate::error::{Error, Status};
use crate::job::{Job, JobOptions, Progress, Stage};
use std::ffi::{c_char, c_void};
use std::ptr;

/// Called with the progress of a build on the thread that runs it, at most twenty times a second.
///
/// \param progress How far the build is, in [0, 1]; never falls during a build.
/// \param stage What the build is doing, such as `triangulate`: a static string.
/// \param payload The pointer of the job's options, untouched.
/// \return 0 to go on, anything else to cancel the job. The function must return: an exception
///         or a longjmp out of it is undefined behaviour.
pub type medax_progress_callback =
    Option<unsafe extern "C" fn(progress: f64, stage: *const c_char, payload: *mut c_void) -> i32>;

/// The settings of a job.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_job_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// The most bytes that a build's own arrays may take at once; 0, the default: no ceiling.
    pub memory_ceiling: u64,
    /// The most threads that builds may use; 0, the default: what the environment variable MEDAX_THREADS says, or
    /// one per processor. Results do not depend on it.
    pub threads: u32,
    /// Must be 0.
    pub reserved: u32,
    /// Called during builds, on the thread that runs them; NULL, the default: not called.
    pub progress: medax_progress_callback,
    /// Passed to `progress`; never read by medax. It must stay valid until the last reference
    /// to the job is freed.
    pub payload: *mut c_void,
}

sized_struct!(medax_job_options, first_size: size_of::<medax_job_options>(), reserved: reserved, {
    memory_ceiling: u64 = 0,
    threads: u32 = 0,
    reserved: u32 = 0,
    progress: medax_progress_callback = None,
    payload: *mut c_void = ptr::null_mut(),
});

/// Sets job options to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_job_options_init(
    options: *mut medax_job_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// Makes a job that waits for its first build.
///
/// \param options Threads, memory ceiling, progress callback; NULL for the defaults. Copied.
/// \param out_job Receives the job, which the caller frees with #medax_job_free.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for options of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_job_create(
    options: *const medax_job_options,
    out_job: *mut *const medax_job,
) -> medax_status {
    boundary::status(|| {
        let out = Out::new(out_job, "out_job")?;
        let options = options::read(options, "options")?;
        let progress = Callback::new(options.progress, options.payload).map(|callback| {
            let progress: Progress =
                Box::new(move |progress, stage| callback.go_on(progress, Stage::c_name(stage)));
            progress
        });
        let options = JobOptions {
            threads: options.threads as usize,
            memory_ceiling: options.memory_ceiling,
            progress,
        };
        out.put(handle::new(medax_job { job: Job::new(options) }));
        Ok(())
    })
}

/// Asks the running build of a job, and every later one, to stop: within 50 ms it returns
/// `MEDAX_STATUS_CANCELLED` and leaves nothing behind. Never undone; may be called again.
///
/// \param job The job; NULL does nothing.
///
/// Constant time, any thread. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_job_cancel(job: *const medax_job) {
    boundary::value((), || {
        if let Some(job) = handle::maybe(job) {
            job.job.cancel();
        }
    });
}

/// Whether a job was cancelled, by #medax_job_cancel or by its callback.
///
/// \param job The job; NULL is not cancelled.
/// \return True once it was cancelled.
///
/// Constant time, any thread. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_job_is_cancelled(job: *const medax_job) -> bool {
    boundary::value(false, || handle::maybe(job).is_some_and(|job| job.job.is_cancelled()))
}

/// How far the running build of a job is, or the last one came.
///
/// \param job The job; NULL is at 0.
/// \return A number in [0, 1] that never falls during a build.
///
/// Constant time, any thread. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_job_progress(job: *const medax_job) -> f64 {
    boundary::value(0.0, || handle::maybe(job).map_or(0.0, |job| job.job.progress()))
}

/// What the running build of a job is doing, or the last one did last.
///
/// \param job The job; NULL is idle.
/// \return A static string, such as `triangulate`; `idle` before the first build; never NULL.
///
/// Constant time, any thread. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_job_stage(job: *const medax_job) -> *const c_char {
    boundary::value(Stage::Idle.c_name().as_ptr(), || {
        handle::maybe(job).map_or(Stage::Idle, |job| job.job.stage()).c_name().as_ptr()
    })
}

/// The most bytes that the arrays of one build of a job took at once.
///
/// \param job The job; NULL took none.
/// \return Bytes, as counted against the memory ceiling.
///
/// Constant time, any thread. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_job_memory_peak(job: *const medax_job) -> u64 {
    boundary::value(0, || handle::maybe(job).map_or(0, |job| job.job.memory_peak()))
}

/// The number of stages that the builds of a job have been through.
///
/// \param job The job; NULL has been through none.
/// \return The number of stages whose times #medax_job_stage_time tells; it only grows.
///
/// Constant time, any thread. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_job_stage_count(job: *const medax_job) -> usize {
    boundary::value(0, || handle::maybe(job).map_or(0, |job| job.job.stage_count()))
}

/// How long a stage took.
///
/// \param job The job.
/// \param index Which stage, below #medax_job_stage_count, in the order of time.
/// \param out_stage Receives a static string, such as `triangulate`; or NULL.
/// \param out_wall_seconds Receives the elapsed seconds; or NULL.
/// \param out_cpu_seconds Receives the processor seconds of the whole process; or NULL.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT` without a job, or `INVALID_ARGUMENT` for an index
///         past the last stage.
///
/// Constant time, any thread. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_job_stage_time(
    job: *const medax_job,
    index: usize,
    out_stage: *mut *const c_char,
    out_wall_seconds: *mut f64,
    out_cpu_seconds: *mut f64,
) -> medax_status {
    boundary::status(|| {
        let time = handle::get(job, "job")?.job.stage_time(index).ok_or_else(|| {
            Error::new(Status::InvalidArgument, format!("the job has had no stage {index} yet"))
        })?;
        Out::maybe(out_stage, time.stage.c_name().as_ptr());
        Out::maybe(out_wall_seconds, time.wall_seconds);
        Out::maybe(out_cpu_seconds, time.cpu_seconds);
        Ok(())
    })
}

/// One more reference to a job.
///
/// \param job The job, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time, any thread. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_job_clone(job: *const medax_job) -> *const medax_job {
    boundary::value(ptr::null(), || handle::clone(job))
}

/// Gives one reference to a job back; the last one frees it.
///
/// \param job The job; NULL does nothing.
///
/// Any thread. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_job_free(job: *const medax_job) {
    boundary::value((), || handle::free(job));
}

//! Where Rust meets C: panics stop here, and so do those of the host's callback.

#![deny(unsafe_op_in_unsafe_fn, clippy::undocumented_unsafe_blocks)]

use super::job::medax_progress_callback;
use super::status::{medax_status, record};
use crate::error::{Error, Result, Status};
use std::cell::{Cell, RefCell};
use std::ffi::{CStr, c_char, c_void};
use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind};
use std::sync::Once;

thread_local! {
    /// How many of our entries this thread is inside of; 0 while the host's callback runs.
    static DEPTH: Cell<u32> = const { Cell::new(0) };
    /// Where and why the panic being caught was raised.
    static PANIC: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// Sets the depth for a while.
struct Depth(u32);

impl Depth {
    fn set(depth: impl FnOnce(u32) -> u32) -> Self {
        Depth(DEPTH.try_with(|cell| cell.replace(depth(cell.get()))).unwrap_or(0))
    }
}

impl Drop for Depth {
    fn drop(&mut self) {
        let _ = DEPTH.try_with(|cell| cell.set(self.0));
    }
}

/// Runs the body of a fallible entry: an error is recorded for this thread, and a panic becomes
/// `MEDAX_STATUS_INTERNAL`.
pub(super) fn status(body: impl FnOnce() -> Result<()>) -> medax_status {
    match caught(body) {
        Ok(Ok(())) => medax_status::Ok,
        Ok(Err(error)) => record(&error),
        Err(panic) => record(&Error::new(
            Status::Internal,
            format!("a defect in medax, {panic}; please report it"),
        )),
    }
}

/// Runs the body of an infallible entry; a panic gives `fallback`.
pub(super) fn value<T>(fallback: T, body: impl FnOnce() -> T) -> T {
    caught(body).unwrap_or(fallback)
}

/// Runs the body, and turns a panic into its text without a word on the host's standard error.
fn caught<T>(body: impl FnOnce() -> T) -> std::result::Result<T, String> {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let host = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |info| hook(info, &host)));
    });
    let _inside = Depth::set(|depth| depth + 1);
    // Unwind safety: handles are immutable, outputs are written last, and a job's state is
    // restored by the destructor of its run.
    catch_unwind(AssertUnwindSafe(body)).map_err(|_| {
        let noted = PANIC.try_with(|panic| panic.take()).ok().flatten();
        noted.unwrap_or_else(|| "a panic of unknown origin".into())
    })
}

/// The panic hook: takes note inside our entries, and is the host's own hook elsewhere.
fn hook(info: &PanicHookInfo<'_>, host: &dyn Fn(&PanicHookInfo<'_>)) {
    if DEPTH.try_with(|depth| depth.get() > 0) != Ok(true) {
        return host(info);
    }
    let payload = info.payload();
    let text = payload.downcast_ref::<&str>().copied();
    let text = text.or_else(|| payload.downcast_ref::<String>().map(String::as_str));
    let reason = text.unwrap_or("a panic");
    let noted = match info.location() {
        Some(place) => format!("{reason} at {}:{}", place.file(), place.line()),
        None => reason.to_string(),
    };
    let _ = PANIC.try_with(|panic| panic.replace(Some(noted)));
}

/// A callback of the host with its payload.
pub(super) struct Callback {
    function: unsafe extern "C" fn(f64, *const c_char, *mut c_void) -> i32,
    payload: *mut c_void,
}

// SAFETY: `payload` is never dereferenced here, only handed back to the host's function. The
// header tells the host that the function runs on whichever thread runs a build with the job,
// never on two at once, since a job runs one build at a time.
unsafe impl Send for Callback {}
// SAFETY: as for Send.
unsafe impl Sync for Callback {}

impl Callback {
    /// # Safety
    /// For as long as this value lives, `function` may be called with `payload` on any thread.
    pub(super) unsafe fn new(
        function: medax_progress_callback,
        payload: *mut c_void,
    ) -> Option<Self> {
        function.map(|function| Callback { function, payload })
    }

    /// Whether the host wants to go on.
    pub(super) fn go_on(&self, progress: f64, stage: &'static CStr) -> bool {
        // What the host does in its callback is its own: its panics go to its own hook.
        let _outside = Depth::set(|_| 0);
        // SAFETY: promised to `new`; `stage` is a static terminated string.
        unsafe { (self.function)(progress, stage.as_ptr(), self.payload) == 0 }
    }
}

#[cfg(test)]
mod tests;

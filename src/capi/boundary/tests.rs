use super::*;
use crate::capi::status::{medax_last_error_index, medax_last_error_message};
use std::process::Command;

/// Set in the process that [`a_panic_prints_nothing_and_the_hosts_hook_stays`] starts.
const CHILD: &str = "MEDAX_TEST_PANIC_CHILD";

fn message() -> String {
    // SAFETY: the message is a terminated string, valid until this thread's next error.
    unsafe { CStr::from_ptr(medax_last_error_message()) }.to_str().unwrap().to_string()
}

#[test]
fn a_panic_becomes_a_status() {
    assert_eq!(status(|| panic!("seven {}", 7)), medax_status::Internal);
    assert!(message().contains("seven 7 at src"), "{}", message());
    assert_eq!(medax_last_error_index(), u64::MAX);
    assert_eq!(value(3, || panic!("eight")), 3);
    assert_eq!(DEPTH.get(), 0);
    assert_eq!(status(|| Ok(())), medax_status::Ok);
}

#[test]
fn the_callback_runs_outside() {
    unsafe extern "C" fn depth(_: f64, stage: *const c_char, payload: *mut c_void) -> i32 {
        assert!(!stage.is_null() && payload.is_null());
        DEPTH.get() as i32
    }
    // SAFETY: the function takes any payload.
    let callback = unsafe { Callback::new(Some(depth), std::ptr::null_mut()) }.unwrap();
    let inside = value((0, false, 0), || (DEPTH.get(), callback.go_on(0.5, c"idle"), DEPTH.get()));
    assert_eq!(inside, (1, true, 1));
}

#[test]
fn a_panic_prints_nothing_and_the_hosts_hook_stays() {
    if std::env::var_os(CHILD).is_some() {
        assert_eq!(status(|| panic!("quiet")), medax_status::Internal);
        panic!("loud");
    }
    let name = "capi::boundary::tests::a_panic_prints_nothing_and_the_hosts_hook_stays";
    let child = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", name, "--nocapture", "--test-threads=1"])
        .env(CHILD, "1")
        .output()
        .unwrap();
    let printed = String::from_utf8_lossy(&child.stderr).into_owned()
        + &String::from_utf8_lossy(&child.stdout);
    assert!(!child.status.success() && printed.contains("loud"), "{printed}");
    assert!(!printed.contains("quiet"), "{printed}");
}

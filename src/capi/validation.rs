//! Validation
//!
//! Every structure can check itself: what it promises is looked at element by element, in exact
//! arithmetic where there is any. A report is data: to find a problem is a success.

use super::boundary;
use super::handle::{self, medax_job};
use super::options::{Report, sized_struct};
use super::status::{medax_error_kind, medax_status};
use crate::Job;
use crate::error::Result;
use crate::validation::Validation;
use std::ffi::c_char;

/// The room for the sentence in a #medax_validation, its terminator included.
const MESSAGE_SIZE: usize = 256;

/// What the check of a structure found. The caller sets `struct_size`, the library the rest.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_validation {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// The number of conditions checked.
    pub checked: u64,
    /// The number of conditions that do not hold; 0 for a sound structure.
    pub problems: u64,
    /// The index of the first offending element, or `UINT64_MAX`.
    pub first_index: u64,
    /// A #medax_error_kind: the kind of the first offending element.
    pub first_kind: u32,
    /// 0.
    pub reserved: u32,
    /// What is wrong with it: a terminated UTF-8 sentence, cut if it is too long; empty if
    /// nothing is wrong.
    pub first_message: [c_char; 256],
}

sized_struct!(medax_validation, first_size: size_of::<medax_validation>(), reserved: none, {
    checked: u64 = 0,
    problems: u64 = 0,
    first_index: u64 = u64::MAX,
    first_kind: u32 = 0,
    reserved: u32 = 0,
    first_message: [c_char; 256] = [0; 256],
});

impl From<Validation> for medax_validation {
    fn from(found: Validation) -> Self {
        let mut report = medax_validation {
            checked: found.checked,
            problems: found.problems,
            ..<Self as super::options::SizedStruct>::DEFAULT
        };
        if let Some((kind, index, message)) = found.first {
            report.first_kind = medax_error_kind::from(kind) as u32;
            report.first_index = index;
            let mut end = message.len().min(MESSAGE_SIZE - 1);
            while !message.is_char_boundary(end) {
                end -= 1;
            }
            for (to, from) in report.first_message.iter_mut().zip(message[..end].bytes()) {
                *to = from as c_char;
            }
        }
        report
    }
}

/// The body of every `validate`: checks with the job, then fills the report.
///
/// # Safety
/// As the header has it for `job` and `out_report`.
pub(super) unsafe fn validate(
    job: *const medax_job,
    out_report: *mut medax_validation,
    check: impl FnOnce(&Job) -> Result<Validation>,
) -> medax_status {
    boundary::status(|| {
        let report = Report::new(out_report, "out_report")?;
        let mut own = None;
        let found = check(handle::job(job, &mut own))?;
        report.fill(&found.into());
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::ElementKind;

    #[test]
    fn a_long_message_is_cut_between_characters() {
        let mut found = Validation::new();
        found.check(false, ElementKind::Cell, 3, || "é".repeat(200));
        let report = medax_validation::from(found);
        assert_eq!((report.first_kind, report.first_index), (6, 3));
        let bytes = report.first_message.map(|c| c as u8);
        let end = bytes.iter().position(|&b| b == 0).unwrap();
        assert_eq!(std::str::from_utf8(&bytes[..end]).unwrap(), "é".repeat(127));
    }
}

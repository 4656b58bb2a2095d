//! What the check of a structure found.

use crate::error::ElementKind;

/// The findings of a `validate`: how much was checked, and what is wrong.
///
/// Every structure's `validate` returns one. The report itself is data: a `validate` fails only
/// when its job is cancelled or memory runs out.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Validation {
    /// The number of conditions checked.
    pub checked: u64,
    /// The number of conditions that do not hold.
    pub problems: u64,
    /// The first of them: the offending element, and a sentence that says what is wrong with it.
    pub first: Option<(ElementKind, u64, String)>,
}

impl Validation {
    /// A report before the first check.
    pub fn new() -> Self {
        Validation::default()
    }

    /// Whether everything that was checked holds.
    pub fn is_valid(&self) -> bool {
        self.problems == 0
    }

    /// Records one check of an element. The message is made for the first problem only.
    pub fn check(
        &mut self,
        holds: bool,
        kind: ElementKind,
        index: u64,
        message: impl FnOnce() -> String,
    ) {
        self.checked += 1;
        if !holds {
            self.problems += 1;
            if self.first.is_none() {
                self.first = Some((kind, index, message()));
            }
        }
    }

    /// Adds the findings of a later check.
    pub fn absorb(&mut self, later: Validation) {
        self.checked += later.checked;
        self.problems += later.problems;
        self.first = self.first.take().or(later.first);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_problem_is_kept_and_all_are_counted() {
        let mut report = Validation::new();
        report.check(true, ElementKind::Cell, 0, || unreachable!("nothing is wrong"));
        assert!(report.is_valid());
        report.check(false, ElementKind::Cell, 7, || "seven".into());
        report.check(false, ElementKind::Face, 2, || unreachable!("it is not the first"));
        let mut all = Validation { checked: 3, ..Validation::new() };
        all.absorb(report.clone());
        assert_eq!(all.first, Some((ElementKind::Cell, 7, "seven".into())));
        assert_eq!((all.checked, all.problems, all.is_valid()), (6, 2, false));
        all.absorb(Validation {
            problems: 1,
            checked: 1,
            first: Some((ElementKind::Row, 1, "row".into())),
        });
        assert_eq!(all.first, report.first);
        assert_eq!(all.problems, 3);
    }
}

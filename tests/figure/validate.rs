//! Figures check themselves.

use crate::drawing::*;
use medax::Job;

#[test]
fn a_sound_figure_has_no_problem_and_a_cancelled_check_stops() {
    let figure = Drawing::polygons(&[&[&square(0.0, 0.0, 4.0), &square(1.0, 1.0, 1.0)]]);
    let figure = figure.strict().unwrap();
    check(&figure);
    let job = Job::default();
    job.cancel();
    assert_eq!(figure.validate(&job).unwrap_err().status(), medax::Status::Cancelled);
}

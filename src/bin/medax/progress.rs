//! The progress bar.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use medax::Progress;
use std::io::IsTerminal;

/// The bar's length: progress in thousandths.
const STEPS: u64 = 1000;

/// A bar on standard error, or one that draws nothing where that is no terminal or the user asks
/// for quiet.
pub struct Bar(ProgressBar);

impl Bar {
    pub fn new(quiet: bool) -> Self {
        let shown = !quiet && std::io::stderr().is_terminal();
        let target =
            if shown { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
        let bar = ProgressBar::with_draw_target(Some(STEPS), target);
        if let Ok(style) = ProgressStyle::with_template("{msg:>12} {wide_bar} {percent:>3} %") {
            bar.set_style(style);
        }
        Bar(bar)
    }

    /// What a job calls.
    pub fn callback(&self) -> Progress {
        let bar = self.0.clone();
        Box::new(move |progress, stage| {
            bar.set_message(stage.name());
            bar.set_position((progress * STEPS as f64) as u64);
            true
        })
    }

    /// Takes the bar off the screen.
    pub fn clear(&self) {
        self.0.finish_and_clear();
    }
}

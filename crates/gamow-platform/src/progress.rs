//! Progress of a command, on a terminal.

pub use indicatif::ProgressBar;
use indicatif::ProgressStyle;

use crate::messages;

/// Returns a bar of `steps` steps, called `things`: on standard error, and only if that is a terminal.
#[must_use]
pub fn bar(steps: u64, things: &'static str) -> ProgressBar {
    shown(ProgressBar::new(steps), "{bar:40} {pos}/{len} {prefix}, {eta} left{msg}", things)
}

fn shown(progress: ProgressBar, template: &str, things: &'static str) -> ProgressBar {
    if messages::is_quiet() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
    progress.with_style(style).with_prefix(things)
}

/// A count of things of which nobody knows how many there will be, shown where a [`bar`] is.
#[derive(Debug)]
pub struct Count(ProgressBar);

impl Count {
    /// Returns a count of `things`, or one that is not shown.
    #[must_use]
    pub fn new(things: &'static str, is_shown: bool) -> Self {
        let count = if is_shown { ProgressBar::no_length() } else { ProgressBar::hidden() };
        Self(shown(count, "{pos} {prefix}, {per_sec}", things))
    }

    /// Notes that there are `count`. To show each would take longer than most things do.
    pub fn note(&self, count: u64) {
        if count.is_multiple_of(1 << 14) {
            self.0.set_position(count);
        }
    }

    /// Takes the count away.
    pub fn end(self) {
        self.0.finish_and_clear();
    }
}

//! Progress of a command, on a terminal.

use std::sync::Arc;
use std::time::Duration;

pub use indicatif::ProgressBar;
use indicatif::ProgressStyle;
use relativity_core::threads::{Watch, watched};

use crate::{messages, threads};

/// Work that takes no longer than this is not shown.
const PATIENCE: Duration = Duration::from_secs(2);
/// The time from one look at work to the next.
const PERIOD: Duration = Duration::from_millis(100);
/// Steps of a bar that shows parts of a whole.
const STEPS: f64 = 1000.0;

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

/// Does `work` and shows a bar of its progress on standard error, if that is a terminal and the work takes
/// longer than two seconds. `pieces` is the number of its pieces, which are of about the same size.
pub fn shown_while<T: Send>(pieces: usize, work: impl FnOnce() -> T + Send) -> T {
    let bar = shown(ProgressBar::new(STEPS as u64), "{bar:40} {percent} %, {eta} left", "");
    if bar.is_hidden() {
        return work();
    }
    let watch = Arc::new(Watch::default());
    let look = || {
        let done = watch.pieces_done() / pieces as f64;
        // Of work that does not tell, nothing is known.
        if done > 0.0 && bar.elapsed() > PATIENCE {
            bar.set_position((STEPS * done.min(1.0)) as u64);
        }
    };
    let result = threads::beside(|| watched(&watch, work), PERIOD, look);
    bar.finish_and_clear();
    result
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

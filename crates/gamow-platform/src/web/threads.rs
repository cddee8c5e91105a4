//! Threads, of which a page has one.

pub use relativity_core::threads::{current_num_threads as count, on_half, prelude};

use super::tasks;

/// Whether there are several.
pub const ARE_SEVERAL: bool = false;

/// Runs `work` on the page's thread, after what runs there now.
pub fn spawn(work: impl FnOnce() + 'static) {
    tasks::spawn(async { work() });
}

/// Work that is done ahead: at once, as there is one thread.
#[derive(Debug)]
pub struct Ahead<T>(T);

impl<T> Ahead<T> {
    /// Does `work`.
    pub fn new(work: impl FnOnce() -> T) -> Self {
        Self(work())
    }

    /// Whether it is done.
    #[must_use]
    pub const fn is_ready(&self) -> bool {
        true
    }

    /// Returns its result.
    #[must_use]
    pub fn wait(self) -> T {
        self.0
    }
}

//! Threads, of which a page has one.

pub use relativity_core::threads::{current_num_threads as count, on_half, prelude};

use super::tasks;

/// Whether there are several.
pub const ARE_SEVERAL: bool = false;

/// Runs `work` on the page's thread, after what runs there now.
pub fn spawn(work: impl FnOnce() + 'static) {
    tasks::spawn(async { work() });
}

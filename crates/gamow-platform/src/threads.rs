//! Threads of the program.
#![expect(clippy::disallowed_methods, reason = "this is where threads are started")]

use std::time::Duration;

pub use relativity_core::threads::{current_num_threads as count, on_half, prelude};
pub use std::thread::JoinHandle;

/// Whether there are several, so that work can be done beside the window.
pub const ARE_SEVERAL: bool = true;

/// Runs `work` in a thread of its own.
pub fn spawn<T: Send + 'static>(work: impl FnOnce() -> T + Send + 'static) -> JoinHandle<T> {
    std::thread::spawn(work)
}

/// Lets this thread wait.
pub fn sleep(duration: Duration) {
    std::thread::sleep(duration);
}

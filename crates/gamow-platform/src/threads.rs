//! Threads of the program.
#![expect(clippy::disallowed_methods, reason = "this is where threads are started")]

use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::Duration;

use relativity_core::threads::ThreadPoolBuilder;

pub use relativity_core::threads::{current_num_threads as count, on_half, prelude};
pub use std::thread::JoinHandle;

/// Has all work that is spread over threads done by this `number` of them. It has an effect before any such
/// work alone.
///
/// # Errors
///
/// Threads that cannot be started.
pub fn limit(number: usize) -> anyhow::Result<()> {
    Ok(ThreadPoolBuilder::new().num_threads(number).build_global()?)
}

/// Whether there are several, so that work can be done beside the window.
pub const ARE_SEVERAL: bool = true;

/// Runs `work` in a thread of its own.
pub fn spawn<T: Send + 'static>(work: impl FnOnce() -> T + Send + 'static) -> JoinHandle<T> {
    std::thread::spawn(work)
}

/// Work that is done ahead, in a thread of its own.
#[derive(Debug)]
pub struct Ahead<T>(JoinHandle<T>);

impl<T: Send + 'static> Ahead<T> {
    /// Begins `work`.
    pub fn new(work: impl FnOnce() -> T + Send + 'static) -> Self {
        Self(spawn(work))
    }

    /// Whether it is done.
    #[must_use]
    pub fn is_ready(&self) -> bool {
        self.0.is_finished()
    }

    /// Returns its result, once it is done.
    #[must_use]
    pub fn wait(self) -> T {
        self.0.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    }
}

/// Lets this thread wait.
pub fn sleep(duration: Duration) {
    std::thread::sleep(duration);
}

/// Does `work` in a thread of its own. Until it ends, calls `meanwhile` on this thread every `period`.
pub fn beside<T: Send>(work: impl FnOnce() -> T + Send, period: Duration, mut meanwhile: impl FnMut()) -> T {
    std::thread::scope(|scope| {
        let (alive, ended) = mpsc::channel::<()>();
        let thread = scope.spawn(move || {
            let _alive = alive;
            work()
        });
        while ended.recv_timeout(period) == Err(RecvTimeoutError::Timeout) {
            meanwhile();
        }
        thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    })
}

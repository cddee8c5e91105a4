//! Threads: the one module through which this project computes on several.
//!
//! They are rayon's. Where a platform has none (`wasm32-unknown-unknown`), rayon falls back to a pool that
//! consists of the calling thread, so that the same code runs there, one task after the other. No result
//! depends on the number of threads.

pub use rayon::{ThreadPool, ThreadPoolBuilder, current_num_threads, join, prelude};

use std::sync::LazyLock;

/// A pool of half as many threads as there are; `None` where none can be started.
static HALF: LazyLock<Option<ThreadPool>> = LazyLock::new(|| {
    let threads = (current_num_threads() / 2).max(1);
    ThreadPoolBuilder::new().num_threads(threads).build().ok()
});

/// Does `work` on half of the threads, which leaves processors to what must not wait.
pub fn on_half<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    match &*HALF {
        Some(pool) => pool.install(work),
        // What has no threads does it itself.
        None => work(),
    }
}

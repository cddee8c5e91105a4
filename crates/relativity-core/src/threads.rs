//! Threads: the one module through which this project computes on several.
//!
//! They are rayon's. Where a platform has none (`wasm32-unknown-unknown`), rayon falls back to a pool that
//! consists of the calling thread, so that the same code runs there, one task after the other. No result
//! depends on the number of threads.

pub use rayon::{ThreadPool, ThreadPoolBuilder, current_num_threads, join, prelude};

use std::cell::RefCell;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, LazyLock};

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

thread_local! {
    /// The flag that stops the work of this thread.
    static STOP: RefCell<Option<Arc<AtomicBool>>> = const { RefCell::new(None) };
}

/// Does `work`, which may be given up once `stop` is true. Its result is then incomplete.
pub fn until<T>(stop: &Arc<AtomicBool>, work: impl FnOnce() -> T) -> T {
    let outer = STOP.replace(Some(Arc::clone(stop)));
    let result = work();
    STOP.set(outer);
    result
}

/// Returns a test of whether the work that this thread does by [`until`] goes on, for any thread that helps
/// with it. Other work always goes on.
pub fn goes_on() -> impl Fn() -> bool + Send + Sync {
    let stop = STOP.with_borrow(Clone::clone);
    move || !stop.as_ref().is_some_and(|stop| stop.load(Ordering::Relaxed))
}

//! Threads: the one module through which this project computes on several.
//!
//! They are rayon's. Where a platform has none (`wasm32-unknown-unknown`), rayon falls back to a pool that
//! consists of the calling thread, so that the same code runs there, one task after the other. No result
//! depends on the number of threads.

pub use rayon::{ThreadPool, ThreadPoolBuilder, current_num_threads, join, prelude};

use std::cell::RefCell;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
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

/// A watch over work that another thread does: its progress is read here, and it can be stopped from here.
#[derive(Debug, Default)]
pub struct Watch {
    is_stopped: AtomicBool,
    /// Number of pieces that were begun, of which the last one has `parts`.
    pieces: AtomicU32,
    parts: AtomicU32,
    /// Number of parts of the last piece that are done.
    done: AtomicU32,
}

impl Watch {
    /// Has the work given up at the next place where it looks at [`goes_on`].
    pub fn stop(&self) {
        self.is_stopped.store(true, Ordering::Relaxed);
    }

    /// Number of pieces of the work that are done, with the part of the last one, such as 1.25; 0 for work
    /// that does not tell.
    #[must_use]
    pub fn pieces_done(&self) -> f64 {
        let [pieces, parts, done] =
            [&self.pieces, &self.parts, &self.done].map(|count| f64::from(count.load(Ordering::Relaxed)));
        if parts > 0.0 { pieces - 1.0 + (done / parts).min(1.0) } else { 0.0 }
    }
}

thread_local! {
    /// The watch over the work of this thread.
    static WATCH: RefCell<Option<Arc<Watch>>> = const { RefCell::new(None) };
}

/// Does `work` under this `watch`. If it is given up, its result is incomplete.
pub fn watched<T>(watch: &Arc<Watch>, work: impl FnOnce() -> T) -> T {
    let outer = WATCH.replace(Some(Arc::clone(watch)));
    let result = work();
    WATCH.set(outer);
    result
}

/// Returns a test of whether the work that this thread does goes on, for any thread that helps with it. Work
/// that is not [`watched`] always does.
pub fn goes_on() -> impl Fn() -> bool + Send + Sync {
    let watch = WATCH.with_borrow(Clone::clone);
    move || !watch.as_ref().is_some_and(|watch| watch.is_stopped.load(Ordering::Relaxed))
}

/// Begins a piece of the work of this thread, such as a picture, which has this number of `parts`, such as
/// its rows. Returns a function that any thread calls when it has done one of them.
pub fn in_parts(parts: u32) -> impl Fn() + Send + Sync {
    let watch = WATCH.with_borrow(Clone::clone);
    if let Some(Watch { pieces, parts: all, done, .. }) = watch.as_deref() {
        done.store(0, Ordering::Relaxed);
        all.store(parts, Ordering::Relaxed);
        pieces.fetch_add(1, Ordering::Relaxed);
    }
    move || {
        if let Some(watch) = &watch {
            watch.done.fetch_add(1, Ordering::Relaxed);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_watch_sees_parts_that_other_threads_do() {
        use rayon::prelude::*;
        let watch = Arc::new(Watch::default());
        assert_eq!(watch.pieces_done(), 0.0);
        let seen = watched(&watch, || {
            let done = in_parts(8);
            (0..4).into_par_iter().for_each(|_| done());
            let half = watch.pieces_done();
            (0..4).into_par_iter().for_each(|_| done());
            let _next = in_parts(3);
            [half, watch.pieces_done()]
        });
        assert_eq!(seen, [0.5, 1.0]);
        // What nobody watches is counted nowhere.
        in_parts(2)();
        assert_eq!(watch.pieces_done(), 1.0);
    }

    #[test]
    fn watched_work_is_given_up_and_other_work_is_not() {
        let watch = Arc::new(Watch::default());
        watch.stop();
        let inside = watched(&watch, || std::thread::scope(|scope| scope.spawn(|| goes_on()()).join()).ok());
        assert_eq!(inside, Some(true), "a thread that was not asked to help");
        assert!(!watched(&watch, || goes_on()()));
        assert!(goes_on()());
    }
}

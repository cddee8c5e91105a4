//! Wakes a window from other threads, without keeping it alive: egui's renderer is part of a window's context
//! and owns the graphics device, which must end with the window, on its thread.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use eframe::egui::Context;

/// The window that is woken, held by whoever waits for another thread.
#[derive(Debug)]
pub struct Woken {
    ctx: Context,
    waker: Waker,
}

impl Woken {
    /// Wakes the window of `ctx`, for as long as this lives.
    #[must_use]
    pub fn new(ctx: Context) -> Self {
        let waker = Waker(Arc::new(Mutex::new(Some(ctx.clone()))));
        Self { ctx, waker }
    }

    /// Asks for a frame after this time.
    pub fn wake_after(&self, time: Duration) {
        self.ctx.request_repaint_after(time);
    }

    /// Returns a handle by which other threads ask for a frame.
    #[must_use]
    pub fn waker(&self) -> Waker {
        self.waker.clone()
    }
}

impl Drop for Woken {
    /// Waits for a thread that is asking for a frame just now: it would be the last that holds the window,
    /// and end its device.
    fn drop(&mut self) {
        let held = self.waker.window().take();
        drop(held);
    }
}

/// Asks for a frame of a window, if anybody still waits there.
#[derive(Debug, Clone)]
pub struct Waker(Arc<Mutex<Option<Context>>>);

impl Waker {
    /// Asks for a frame.
    pub fn wake(&self) {
        if let Some(ctx) = self.window().as_ref() {
            ctx.request_repaint();
        }
    }

    fn window(&self) -> MutexGuard<'_, Option<Context>> {
        // Whole whenever another thread ended.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(all(test, feature = "desktop"))]
mod tests {
    use std::sync::mpsc::channel;

    use eframe::egui::Id;
    use gamow_platform::threads;

    use super::*;

    #[test]
    fn a_thread_that_wakes_a_window_never_ends_it() {
        let ctx = Context::default();
        let owned = Arc::new(());
        let device = Arc::downgrade(&owned);
        ctx.data_mut(|data| data.insert_temp(Id::NULL, owned));
        let (begin, begun) = channel();
        ctx.set_request_repaint_callback(move |_| {
            // The window may have gone.
            let _ = begin.send(());
        });
        let woken = Woken::new(ctx.clone());
        let waker = woken.waker();
        let (end, ended) = channel();
        let thread = threads::spawn(move || {
            while ended.try_recv().is_err() {
                waker.wake();
            }
        });
        begun.recv().expect("it wakes the window");
        drop((woken, ctx));
        assert!(device.upgrade().is_none(), "the window has ended here, while the thread goes on");
        end.send(()).expect("the thread goes on");
        thread.join().expect("it ends");
    }
}

//! Wakes a window from other threads, without keeping it alive: egui's renderer is part of a window's context and owns the
//! graphics device, which must end with the window, on its thread.

use std::sync::{Arc, Weak};
use std::time::Duration;

use eframe::egui::Context;

/// The window that is woken, held by whoever waits for another thread.
#[derive(Debug, Clone)]
pub struct Woken(Arc<Context>);

impl Woken {
    /// Wakes the window of `ctx`, for as long as this lives.
    #[must_use]
    pub fn new(ctx: Context) -> Self {
        Self(Arc::new(ctx))
    }

    /// Asks for a frame after this time.
    pub fn wake_after(&self, time: Duration) {
        self.0.request_repaint_after(time);
    }

    /// Returns a handle by which other threads ask for a frame.
    #[must_use]
    pub fn waker(&self) -> Waker {
        Waker(Arc::downgrade(&self.0))
    }
}

/// Asks for a frame of a window, if anybody still waits there.
#[derive(Debug, Clone)]
pub struct Waker(Weak<Context>);

impl Waker {
    /// Asks for a frame.
    pub fn wake(&self) {
        if let Some(ctx) = self.0.upgrade() {
            ctx.request_repaint();
        }
    }
}

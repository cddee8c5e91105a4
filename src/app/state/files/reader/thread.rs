//! Files read by a thread each.

use std::sync::mpsc::{Receiver, Sender, channel};

use eframe::egui::Context;
use gamow_platform::threads;

use super::{Errand, ReadFile};
use crate::app::tools::waker::Woken;

/// The place where files are read.
pub struct Place {
    woken: Woken,
    read: Receiver<(u64, ReadFile)>,
    sender: Sender<(u64, ReadFile)>,
}

impl Place {
    /// Creates a place that requests a repaint after each file it has read.
    pub fn new(ctx: &Context) -> Self {
        let (sender, read) = channel();
        Self { woken: Woken::new(ctx.clone()), read, sender }
    }

    /// Begins the errand of this number.
    pub fn begin(&self, number: u64, errand: Errand) {
        let (sender, waker) = (self.sender.clone(), self.woken.waker());
        // Nothing waits for this thread: a disc that does not answer keeps nobody from leaving.
        threads::spawn(move || {
            if sender.send((number, errand.read())).is_ok() {
                waker.wake();
            }
        });
    }

    /// Takes the files read since the last call, with the numbers of their errands.
    pub fn finished(&self) -> Vec<(u64, ReadFile)> {
        self.read.try_iter().collect()
    }

    /// Gives up what is being read to be opened: here its thread goes on, and nobody hears of it.
    #[cfg(feature = "desktop")]
    #[expect(clippy::unused_self, reason = "a page's place has something to end")]
    pub const fn stop(&self) {}
}

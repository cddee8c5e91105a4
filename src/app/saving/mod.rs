//! Saving and copying. Whatever takes time is made by a worker thread.

mod copied;
mod fulfil;
mod work;

use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use eframe::egui::Context;

use self::work::{Job, Made};
use super::state::State;
use super::worker::{Wanted, Worker};
use crate::platform::clock::Instant;
use crate::studio::film::{Written, frame_count};

impl State {
    /// Returns the number of frames of a film in which T runs through its range once, as fast as in playback.
    #[must_use]
    pub fn film_frames(&self) -> u32 {
        frame_count(self.time_range(), self.document.settings.playback.rate)
    }
}

/// Greatest number of frames of a film.
pub const MOST_FRAMES: u32 = 5000;

/// Time within which something is made without an announcement.
const GRACE: Duration = Duration::from_millis(300);

/// Interval between two reports of progress: each costs a frame of the window.
const TOLD: Duration = Duration::from_millis(250);

/// Frames from which the size of a film is estimated.
const FEW: u32 = 5;

/// The saver, with its worker thread.
#[derive(Default)]
pub struct Saver {
    worker: Option<Worker<Job, Made>>,
    written: Arc<Mutex<Written>>,
    underway: Option<Underway>,
}

struct Underway {
    name: String,
    frames: u32,
    since: Instant,
}

/// The progress of a product.
#[derive(Debug, Clone, PartialEq)]
pub struct Progress<'a> {
    /// Name of the product.
    pub name: &'a str,
    /// Fraction of the product that is written.
    pub written: Written,
    /// Number of all the progress's frames.
    pub frames: u32,
}

impl Progress<'_> {
    /// The size of all, bytes, estimated from the frames so far; `None` before there are a few.
    #[must_use]
    pub fn expected_bytes(&self) -> Option<u64> {
        let Written { frames, .. } = self.written;
        if frames >= FEW && frames < self.frames { self.written.expected_bytes(self.frames) } else { None }
    }
}

impl Saver {
    /// Begins a `job`, which makes `frames` pictures of the product called `name`.
    fn begin(&mut self, ctx: &Context, job: Job, name: String, frames: u32) {
        *lock(&self.written) = Written::default();
        let all_written = Arc::clone(&self.written);
        let repaint = ctx.clone();
        let work = move |job: Job, wanted: &Wanted| {
            let goes_on = |written| {
                *lock(&all_written) = written;
                repaint.request_repaint_after(TOLD);
                wanted.holds()
            };
            job.made(goes_on)
        };
        self.worker.get_or_insert_with(|| Worker::new(ctx.clone(), work)).request(job);
        self.underway = Some(Underway { name, frames, since: Instant::now() });
    }

    /// Takes the finished product, once.
    fn made(&mut self) -> Option<Made> {
        let made = self.worker.as_ref()?.result()?;
        self.underway = None;
        Some(made)
    }

    /// Gives up what is being made; whether there was anything.
    fn stop(&mut self) -> bool {
        self.worker.iter().for_each(Worker::stop);
        self.underway.take().is_some()
    }

    /// Whether something is being made.
    #[must_use]
    pub const fn is_busy(&self) -> bool {
        self.underway.is_some()
    }

    /// Returns the progress, if it takes long enough to be shown.
    #[must_use]
    pub fn progress(&self, ctx: &Context) -> Option<Progress<'_>> {
        let underway = self.underway.as_ref()?;
        let rest = GRACE.saturating_sub(underway.since.elapsed());
        if !rest.is_zero() {
            ctx.request_repaint_after(rest);
            return None;
        }
        let (name, frames) = (&underway.name, underway.frames);
        Some(Progress { name, written: *lock(&self.written), frames })
    }
}

fn lock(written: &Mutex<Written>) -> std::sync::MutexGuard<'_, Written> {
    written.lock().unwrap_or_else(PoisonError::into_inner)
}

//! The fit of the selected point, kept up to date in the background while it is shown.

mod outcome;
mod plot_line;

use std::time::Duration;

use eframe::egui::Context;
use gamow_platform::clock::Instant;

pub use outcome::{FitOutcome, FitSteps, Fitted, FittedCurve, reading};

use crate::app::tools::worker::BackgroundWork;
use crate::estimate::samples::FitKey;

/// An outdated outcome is shown as such once the next has been awaited for this long; sooner, it would
/// only flicker.
const GRACE: Duration = Duration::from_millis(150);

/// The fit that is shown, and the one that is being made.
#[derive(Default)]
pub struct Fitting {
    worker: Option<BackgroundWork<FitSteps, ()>>,
    requested: Option<FitKey>,
    shown: Option<FitOutcome>,
    awaited_since: Option<Instant>,
    /// Number of fits that were requested.
    pub requests: u64,
}

impl Fitting {
    /// Requests the fit of `key`, unless that is shown or already requested.
    pub fn update(&mut self, ctx: &Context, key: FitKey) {
        self.receive();
        if self.requested.as_ref() != Some(&key) {
            let worker = self.worker.get_or_insert_with(|| BackgroundWork::new(ctx, ()));
            worker.request((), (), key.clone());
            self.requested = Some(key);
            self.requests += 1;
            self.awaited_since.get_or_insert_with(Instant::now);
        }
        if let Some(since) = self.awaited_since {
            let rest = GRACE.saturating_sub(since.elapsed());
            if !rest.is_zero() {
                ctx.request_repaint_after(rest);
            }
        }
    }

    fn receive(&mut self) {
        let Some(((), outcome)) = self.worker.as_ref().and_then(BackgroundWork::result) else { return };
        self.awaited_since = (self.requested.as_ref() != Some(&outcome.key)).then(Instant::now);
        self.shown = Some(outcome);
    }

    /// Gives up what is being made, as nobody sees it.
    pub fn rest(&mut self) {
        if self.awaited_since.take().is_some() {
            self.worker.iter().for_each(BackgroundWork::stop);
            self.requested = None;
        }
    }

    /// The newest outcome, be it outdated or not.
    #[must_use]
    pub const fn shown(&self) -> Option<&FitOutcome> {
        self.shown.as_ref()
    }

    /// Whether the newest outcome is visibly outdated.
    #[must_use]
    pub fn is_outdated(&self) -> bool {
        self.awaited_since.is_some_and(|since| since.elapsed() >= GRACE)
    }

    /// Returns whether the newest outcome is the requested one.
    #[must_use]
    pub const fn is_up_to_date(&self) -> bool {
        self.shown.is_some() && !self.is_pending()
    }

    /// Whether a fit is being made.
    #[must_use]
    pub const fn is_pending(&self) -> bool {
        self.awaited_since.is_some()
    }
}

//! Progress of a product that is being made.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use eframe::egui::Context;

use crate::studio::film::Written;

/// Interval between two reports of progress: each costs a frame of the window.
const TOLD: Duration = Duration::from_millis(250);

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
        self.written.forecast(self.frames)
    }
}

/// Reports what is written to the window; the default one, of another instance of the program, by notes.
#[derive(Default)]
pub struct Reporter(Option<(Context, Arc<Mutex<Written>>)>);

impl Reporter {
    /// Reports in `written`, and has the window look there.
    pub fn new(ctx: &Context, written: &Arc<Mutex<Written>>) -> Self {
        Self(Some((ctx.clone(), Arc::clone(written))))
    }

    /// Reports what is `written` so far.
    pub fn report(&self, written: Written) {
        let Self(Some((ctx, all_written))) = self else {
            let Written { drawn, frames, bytes } = written;
            let numbers = [drawn.into(), frames.into(), bytes].map(u64::to_le_bytes);
            return gamow_platform::note(&numbers.concat());
        };
        *lock(all_written) = written;
        ctx.request_repaint_after(TOLD);
    }

    /// Reports the progress in a `note`.
    pub fn report_note(&self, note: &[u8]) {
        if let ([drawn, frames, bytes], []) = note.as_chunks() {
            let [drawn, frames, bytes] = [drawn, frames, bytes].map(|part| u64::from_le_bytes(*part));
            self.report(Written { drawn: drawn as u32, frames: frames as u32, bytes });
        }
    }
}

/// Locks the report of what is written.
pub fn lock(written: &Mutex<Written>) -> MutexGuard<'_, Written> {
    written.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_note_is_reported_and_a_broken_one_is_not() {
        let written = Arc::default();
        let reporter = Reporter::new(&Context::default(), &written);
        let note = [5u64, 3, 1 << 40].map(u64::to_le_bytes).concat();
        reporter.report_note(&note);
        reporter.report_note(&note[..17]);
        assert_eq!(*lock(&written), Written { drawn: 5, frames: 3, bytes: 1 << 40 });
    }
}

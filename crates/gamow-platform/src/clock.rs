//! The clock of the system.
#![expect(clippy::disallowed_types, clippy::disallowed_methods, reason = "this is where the clock is read")]

use std::time::Duration;

#[cfg(feature = "desktop")]
use std::time as source;
#[cfg(not(feature = "desktop"))]
use web_time as source;

/// A moment of the wall clock, from which elapsed time is measured.
#[derive(Debug, Clone, Copy)]
pub struct Instant(source::Instant);

impl Instant {
    /// Returns the present moment.
    #[must_use]
    pub fn now() -> Self {
        Self(source::Instant::now())
    }

    /// Returns the time since the moment.
    #[must_use]
    pub fn elapsed(&self) -> Duration {
        self.0.elapsed()
    }

    /// Returns the time since the moment, milliseconds.
    #[must_use]
    pub fn elapsed_ms(&self) -> f64 {
        1e3 * self.elapsed().as_secs_f64()
    }
}

//! The clock of the system.
#![expect(clippy::disallowed_types, clippy::disallowed_methods, reason = "this is where the clock is read")]

use std::time::Duration;

/// Returns the date, milliseconds since 1970.
#[must_use]
pub fn since_1970_ms() -> u64 {
    let passed = std::time::SystemTime::now().duration_since(std::time::SystemTime::UNIX_EPOCH);
    passed.map_or(0, |passed| passed.as_millis() as u64)
}

/// A moment of the wall clock, from which elapsed time is measured.
#[derive(Debug, Clone, Copy)]
pub struct Instant(std::time::Instant);

impl Instant {
    /// Returns the present moment.
    #[must_use]
    pub fn now() -> Self {
        Self(std::time::Instant::now())
    }

    /// Returns the time since the moment.
    #[must_use]
    pub fn elapsed(&self) -> Duration {
        self.0.elapsed()
    }

    /// The same in milliseconds.
    #[must_use]
    pub fn elapsed_ms(&self) -> f64 {
        1e3 * self.elapsed().as_secs_f64()
    }
}

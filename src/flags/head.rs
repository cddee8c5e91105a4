//! Flags for the tilt and the turn of the head.

use std::ops::RangeInclusive;

use clap::Args;
use relativity_core::Baseline;

use super::within;

/// Range of tilt and turn of the head, degrees.
pub const HEAD_DEGREES: RangeInclusive<f64> = -180.0..=180.0;

/// By how much the head is tilted and turned.
#[derive(Debug, Clone, Copy, Args)]
pub struct HeadArgs {
    /// By how much the head tilts, degrees: the right eye is the higher one above 0.
    #[arg(long, value_name = "DEG", value_parser = within(HEAD_DEGREES), allow_hyphen_values = true)]
    roll: Option<f64>,
    /// By how much the head turns about the vertical, degrees: to the left above 0.
    #[arg(long, value_name = "DEG", value_parser = within(HEAD_DEGREES), allow_hyphen_values = true)]
    turn: Option<f64>,
}

impl HeadArgs {
    /// Roll and turn, degrees, where they are given.
    #[must_use]
    pub const fn degrees(&self) -> [Option<f64>; 2] {
        [self.roll, self.turn]
    }

    /// The same in radians.
    #[must_use]
    pub fn radians(&self) -> [Option<f64>; 2] {
        self.degrees().map(|angle| angle.map(f64::to_radians))
    }

    /// The eyes of this `separation`.
    #[must_use]
    pub fn baseline(&self, separation: f64) -> Baseline {
        let [roll, turn] = self.radians().map(Option::unwrap_or_default);
        Baseline { separation, roll, turn }
    }
}

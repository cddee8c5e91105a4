//! Flags for the tilt and the turn of the head.

use std::ops::RangeInclusive;

use clap::Args;
use relativity_core::Baseline;

use super::within;

/// Range of tilt and turn of the head, degrees.
pub const HEAD_DEGREES: RangeInclusive<f64> = -180.0..=180.0;

/// Tilt and turn of the head.
#[derive(Debug, Clone, Copy, Args)]
pub struct HeadArgs {
    /// Tilt of the head, degrees: above 0 the right eye is the higher one.
    #[arg(long, value_name = "DEG", value_parser = within(HEAD_DEGREES), allow_hyphen_values = true)]
    roll: Option<f64>,
    /// Turn of the head about the vertical, degrees: above 0 to the left.
    #[arg(long, value_name = "DEG", value_parser = within(HEAD_DEGREES), allow_hyphen_values = true)]
    turn: Option<f64>,
}

impl HeadArgs {
    /// Roll and turn, degrees, where they are given.
    #[must_use]
    pub const fn degrees(&self) -> [Option<f64>; 2] {
        [self.roll, self.turn]
    }

    /// Roll and turn, radians, where they are given.
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

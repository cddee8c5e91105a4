//! The second picture of one eye: what it shows otherwise than the first.

use clap::ValueEnum;
use serde::Serialize;

/// The second of two pictures of one eye.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Compare {
    /// No second picture of one eye: the pictures are those of two eyes.
    #[default]
    Off,
    /// On a ride, the left eye's picture of whoever stands where the rider is: at the same place and time, at
    /// rest on the street.
    Standing,
    /// The left eye's picture as seen.
    Seen,
    /// The left eye's picture contracted only: where everything is measured to be at T, what Gamow drew.
    Contracted,
    /// The left eye's picture at rest: what a camera that rides along photographs.
    Rest,
    /// The left eye's picture with the received intensity D², the paper's; both pictures have the exposure of
    /// the first. White bodies follow Planck's law, and so look alike in both while the Doppler effect
    /// shifts.
    Paper,
}

impl Compare {
    /// Whether there is no second picture.
    #[must_use]
    pub const fn is_off(&self) -> bool {
        matches!(self, Self::Off)
    }
}

//! The second picture of one eye: what it shows otherwise than the first.

use clap::ValueEnum;
use serde::{Serialize, Serializer};

/// The second of two pictures of one eye.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum Compare {
    /// No second picture of one eye: the pictures are those of two eyes.
    #[default]
    Off,
    /// The left eye's picture as seen.
    Seen,
    /// The left eye's picture contracted only: where everything is measured to be at T, what Gamow drew.
    Contracted,
    /// The left eye's picture at rest: what a camera that rides along photographs.
    Rest,
    /// The left eye's picture with the received intensity D², the paper's; both pictures have the exposure of the first. White bodies follow
    /// Planck's law, and so look alike in both while the Doppler effect shifts.
    Paper,
}

impl Compare {
    /// Whether there is no second picture.
    #[must_use]
    pub const fn is_off(&self) -> bool {
        matches!(self, Self::Off)
    }

    /// The name in files and flags.
    #[must_use]
    pub fn name(self) -> String {
        self.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default()
    }

    /// The choice that many `steps` further in the list of all, or back; after the last comes the first.
    #[must_use]
    pub fn further(self, steps: isize) -> Self {
        let all = Self::value_variants();
        all[(self as isize + steps).rem_euclid(all.len().cast_signed()).cast_unsigned()]
    }
}

impl Serialize for Compare {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.name())
    }
}

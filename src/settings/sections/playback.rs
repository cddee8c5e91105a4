//! The section of playback: how the observation time runs.

use std::ops::RangeInclusive;

use clap::Args;
use serde::Serialize;

use crate::flags::{OnOff, TimeRange, switch, within};

/// Slowest and fastest playback, units of T per second.
pub const RATE: RangeInclusive<f64> = 0.001..=1e6;

/// The playback of the observation time.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Playback")]
pub struct PlaybackSettings {
    /// Playback rate: units of T per second of the wall clock.
    #[arg(long, value_parser = within(RATE))]
    pub rate: f64,
    /// Whether T starts again at the end of its range.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub looping: OnOff,
    /// First and last T; `auto` fits them to the selected point: approaching, abreast, receding.
    #[arg(long, value_name = "auto|FROM,TO", allow_hyphen_values = true)]
    pub range: TimeRange,
}

impl Default for PlaybackSettings {
    fn default() -> Self {
        Self { rate: 1.0, looping: true, range: TimeRange(None) }
    }
}

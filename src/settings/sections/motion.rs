//! The section of motion: the speed, the places of the eyes, and the path.

use clap::Args;
use serde::Serialize;

use crate::flags::{HEAD_DEGREES, SpeedParameter, SpeedSetting, within};

/// Largest separation, distance and height.
pub const MAX_LENGTH: f64 = 1e6;

/// Speed, the eyes' places, and path.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Motion")]
pub struct MotionSettings {
    /// Speed of the scene along +x.
    #[command(flatten)]
    #[serde(flatten)]
    pub speed: SpeedSetting,
    /// Separation of the eyes. With the head held straight they rest at x = −d/2 (left) and x = +d/2 (right).
    #[arg(long, value_parser = within(0.0..=MAX_LENGTH), allow_hyphen_values = true)]
    pub d: f64,
    /// Tilt of the head, degrees: above 0 the right eye is the higher one, at 90 straight above the left one.
    /// Eyes above each other see a rod abreast contracted, and not turned; eyes along the motion see it
    /// turned.
    #[arg(long, value_name = "DEG", value_parser = within(HEAD_DEGREES), allow_hyphen_values = true)]
    pub roll: f64,
    /// Turn of the head about the vertical, degrees: above 0 to the left; at 90 the right eye is straight
    /// beyond the left one, along y. Lines of sight then need not meet.
    #[arg(long, value_name = "DEG", value_parser = within(HEAD_DEGREES), allow_hyphen_values = true)]
    pub turn: f64,
    /// Additional distance beyond the scene's own, along y.
    #[arg(long, value_name = "DY", value_parser = within(-MAX_LENGTH..=MAX_LENGTH), allow_hyphen_values = true)]
    pub depth_shift: f64,
    /// Additional height above the scene's own, along z.
    #[arg(long, value_name = "DZ", value_parser = within(-MAX_LENGTH..=MAX_LENGTH), allow_hyphen_values = true)]
    pub height_shift: f64,
}

impl Default for MotionSettings {
    /// The motion of the paper.
    fn default() -> Self {
        let speed = SpeedSetting::new(SpeedParameter::Beta, 0.9).expect("0.9 is a speed");
        Self { speed, d: 0.1, roll: 0.0, turn: 0.0, depth_shift: 0.0, height_shift: 0.0 }
    }
}

//! The section of the screen: how large it is, and where the viewer is.

use std::ops::RangeInclusive;

use clap::Args;
use serde::Serialize;

use crate::flags::{ScreenWidth, within};

/// Nearest and furthest that one sits from it, cm.
pub const VIEWING_CM: RangeInclusive<f64> = 5.0..=100_000.0;
/// Closest and furthest that the middles of two pictures may be, mm.
pub const PICTURE_MM: RangeInclusive<f64> = 10.0..=200.0;
/// Nearest and furthest that the lenses of a stereoscope are from the screen, mm.
pub const LENS_MM: RangeInclusive<f64> = 10.0..=500.0;

/// The screen that the pictures are seen on: an angle in the scene is another one there.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Screen")]
pub struct ScreenSettings {
    /// Width of the whole screen, centimetres: with the viewer's distance it tells at which angles the
    /// pictures are seen. `auto` assumes 96 pixels per inch, which is wrong for most projectors.
    #[arg(long, value_name = "auto|CM")]
    pub screen_width: ScreenWidth,
    /// Distance of the viewer from the screen, centimetres.
    #[arg(long, value_name = "CM", value_parser = within(VIEWING_CM))]
    pub viewing_distance: f64,
    /// Largest distance between the middles of two pictures that are fused without glasses, millimetres: no
    /// more than the distance of the viewer's pupils. In a stereoscope they are that far apart, as its lenses
    /// are.
    #[arg(long, value_name = "MM", value_parser = within(PICTURE_MM))]
    pub picture_distance: f64,
    /// Distance of a stereoscope's lenses from the screen, millimetres: with the width of the pictures it
    /// gives the angles at which they are seen.
    #[arg(long, value_name = "MM", value_parser = within(LENS_MM))]
    pub lens_to_screen: f64,
}

impl Default for ScreenSettings {
    /// A screen on a desk.
    fn default() -> Self {
        Self {
            screen_width: ScreenWidth(None),
            viewing_distance: 60.0,
            picture_distance: 60.0,
            lens_to_screen: 40.0,
        }
    }
}

/// Size of a point of the screen that `auto` assumes, cm: there are 96 of them in an inch.
const CM_PER_POINT: f64 = 2.54 / 96.0;

impl ScreenSettings {
    /// Returns the size of a point of a window on a screen of this width in points, where that is known, cm.
    #[must_use]
    pub fn cm_per_point(&self, width_points: Option<f64>) -> f64 {
        let set = self.screen_width.0.zip(width_points.filter(|points| *points >= 1.0));
        set.map_or(CM_PER_POINT, |(width, points)| width / points)
    }
}

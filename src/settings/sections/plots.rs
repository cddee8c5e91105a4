//! The section of plots: what is plotted.

use clap::{Args, ValueEnum};
use serde::Serialize;

use crate::flags::{OnOff, switch};

/// The contents of the plots, most of them against T.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PlotTab {
    /// Disparities, Δφ and Δθ or Δu and Δv: how differently the eyes see each point.
    #[default]
    Disparity,
    /// Azimuth φ and elevation θ of the selected point, for each eye.
    Angles,
    /// Doppler factor D of the selected point, for each eye.
    Doppler,
    /// Stereo gain, and how far away two eyes place the selected point.
    Stereo,
    /// Spectrum of the selected point: as its light is emitted, and as each eye receives it.
    Light,
    /// Speed and distance of the selected point, fitted to noisy disparities alone.
    Fit,
    /// Cost and error of each way to draw the views.
    Accuracy,
}

/// Coordinates of a disparity.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Coordinates {
    /// Δφ and Δθ: azimuth and elevation.
    #[default]
    Angles,
    /// Δu and Δv: the columns and rows of conformal pictures. Motion slides u by the rapidity for both eyes
    /// alike, so that Δu of a moving point is that of a resting one for eyes γd apart, dashed.
    Conformal,
}

/// The contents of the plots.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Plots")]
pub struct PlotSettings {
    /// Tab of the plots.
    #[arg(long, value_enum)]
    pub plot: PlotTab,
    /// The coordinates of the disparity plots.
    #[arg(long, value_enum)]
    pub coordinates: Coordinates,
    /// Whether the paper's approximate binocular model is plotted too, dashed: the right eye is the left one
    /// at T − ΔT, both angles measured from the left eye.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub published: OnOff,
    /// Whether the views show, while the Accuracy tab is open, how far each pixel's point is drawn from where
    /// it is seen.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub heat_map: OnOff,
}

impl PlotSettings {
    /// Whether the disparities of u and v are plotted.
    #[must_use]
    pub fn is_conformal(&self) -> bool {
        self.plot == PlotTab::Disparity && self.coordinates == Coordinates::Conformal
    }
}

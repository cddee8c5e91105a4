//! The section of the window: which parts of it are shown, their sizes and colours.

use clap::{Args, ValueEnum};
use serde::Serialize;

use crate::flags::{OnOff, Share, switch};
use crate::units::Units;

/// Whether a part of the window is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Presence {
    /// Shown if there is room.
    #[default]
    Auto,
    /// Always shown.
    On,
    /// Never shown.
    Off,
}

/// Colours of the window.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Theme {
    /// Dark on a light background.
    Light,
    /// Light on a dark background.
    #[default]
    Dark,
    /// Follows the system's theme.
    System,
}

/// The parts of the window that are shown, their sizes and colours.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Window")]
pub struct WindowSettings {
    /// The two eyes' views. Hidden views compute nothing.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub views: OnOff,
    /// The left eye's picture with the distortion undone, beside the two: by the fitted speed while the Fit
    /// tab is shown, else by the one that is set. Hidden, it costs nothing.
    #[arg(long, value_parser = switch, value_name = "on|off", num_args = 0..=1, default_missing_value = "on")]
    pub corrected: OnOff,
    /// A strip below the views that shows which wavelengths arrive from the selected point, in the whole
    /// spectrum.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub spectrum: OnOff,
    /// The sentence below the views, which describes the moment in words.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub sentence: OnOff,
    /// The map: what happens, beside what is seen. Hidden, it computes nothing.
    #[arg(long, value_enum)]
    pub map: Presence,
    /// The plots of curves over T.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub plots: OnOff,
    /// The controls beside the views.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub controls: OnOff,
    /// Few controls (speed, eye separation and T) and one plot, as in a new user's window.
    #[arg(long, value_parser = switch, value_name = "on|off", num_args = 0..=1, default_missing_value = "on")]
    pub simple: OnOff,
    /// The numbers below the controls.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub readout: OnOff,
    /// Width of the controls, as a fraction of the window's.
    #[arg(long, value_name = "auto|SHARE")]
    pub side_share: Share,
    /// Height of the map and the plots, as a fraction of theirs and the views' together.
    #[arg(long, value_name = "auto|SHARE")]
    pub strip_share: Share,
    /// Width of the map, as a fraction of its own and the plots' together.
    #[arg(long, value_name = "auto|SHARE")]
    pub map_share: Share,
    /// At each followed point in the views, a clock that shows the body's proper time as the eye sees it.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub dials: OnOff,
    /// In each view a clock that rests beside the eyes, to compare the others with; and at every clock the
    /// number of turns of its hand, since the step of a lesson began or since it showed 0.
    #[arg(long, value_parser = switch, value_name = "on|off", num_args = 0..=1, default_missing_value = "on")]
    pub resting_clock: OnOff,
    /// At each followed point in the views, how far away the eye sees it: where it was when its light left.
    #[arg(long, value_parser = switch, value_name = "on|off", num_args = 0..=1, default_missing_value = "on")]
    pub distances: OnOff,
    /// Ruler of rapidity below conformal views, and above its ticks the colours that a body passes through.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub ruler: OnOff,
    /// In conformal views, the outline of what moves where it would be seen if it were at rest. Motion slides
    /// it by the rapidity, along the arrow.
    #[arg(long, value_parser = switch, value_name = "on|off", num_args = 0..=1, default_missing_value = "on")]
    pub resting: OnOff,
    /// On a ride, darkens the edges of the views while the head turns: movement there makes people ill.
    #[arg(long, value_parser = switch, value_name = "on|off", num_args = 0..=1, default_missing_value = "on")]
    pub vignette: OnOff,
    /// The picture of the start page moves, pictures fade from one preset or layout to the next, and parts of
    /// the window move. Nothing does where the system asks for less motion.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub animations: OnOff,
    /// Units of lengths and times in the window and in saved plots. Data, states, flags and the records in
    /// pictures stay in the scene's own unit, with c = 1.
    #[arg(long, value_enum)]
    pub units: Units,
    /// Colours of the window.
    #[arg(long, value_enum)]
    pub theme: Theme,
}

impl WindowSettings {
    /// Returns these settings with few controls and words in place of numbers, as in a new user's window, or
    /// with all of both.
    #[must_use]
    pub const fn with_few(self, few: bool) -> Self {
        Self { simple: few, spectrum: !few, sentence: !few, readout: !few, ..self }
    }
}

impl Default for WindowSettings {
    fn default() -> Self {
        Self {
            views: true,
            corrected: false,
            spectrum: true,
            sentence: true,
            map: Presence::Auto,
            plots: true,
            controls: true,
            simple: false,
            readout: true,
            side_share: Share(None),
            strip_share: Share(None),
            map_share: Share(None),
            dials: true,
            resting_clock: false,
            distances: false,
            ruler: true,
            resting: false,
            vignette: false,
            animations: true,
            units: Units::Natural,
            theme: Theme::Light,
        }
    }
}

//! The flags with which the window starts in a given state.

use std::path::PathBuf;

use anyhow::Context as _;
use clap::Args;
use relativity_render::Geometry;

use super::settings::{PlotTab, Settings};
use super::speed_setting::SpeedSetting;
use super::state::State;
use crate::flags::{RendererChoice, SpeedArgs, finite_number, positive};
use crate::scene::{PRESETS, Scene};

/// Flags of the window. What is not given is as it was left, or as usual.
#[derive(Debug, Clone, Args)]
pub struct WindowArgs {
    /// What rides past: a preset, or a scene file.
    #[arg(long, default_value = PRESETS[0], value_name = "PRESET|FILE")]
    scene: String,
    #[command(flatten)]
    speed: SpeedArgs,
    /// Separation of the eyes, 0 or more.
    #[arg(long, value_parser = length, allow_hyphen_values = true)]
    d: Option<f64>,
    /// Observation time T to start at.
    #[arg(long, value_parser = finite_number, allow_hyphen_values = true)]
    time: Option<f64>,
    /// Start with T running.
    #[arg(long, conflicts_with = "paused")]
    play: bool,
    /// Start with T at rest (as it does anyway).
    #[arg(long)]
    paused: bool,
    /// What the views show.
    #[arg(long, value_enum)]
    geometry: Option<Geometry>,
    /// What draws the views.
    #[arg(long, value_enum)]
    renderer: Option<RendererChoice>,
    /// How far the mesh renderer may draw a point from where it is seen, pixels.
    #[arg(long, value_name = "PX", value_parser = positive)]
    bound_px: Option<f64>,
    /// Show the left eye's picture with the distortion undone, too.
    #[arg(long)]
    corrected: bool,
    /// What is plotted.
    #[arg(long, value_enum)]
    plot: Option<PlotArg>,
    /// Colours of the window.
    #[arg(long, value_enum)]
    theme: Option<ThemeArg>,
    /// Inner size of the window.
    #[arg(long, value_parser = size, value_name = "WIDTHxHEIGHT")]
    window_size: Option<[u32; 2]>,
    /// Draw the window once, save it as a PNG file and exit. Needs no display. Saved settings are left
    /// alone, and out.
    #[arg(long, value_name = "FILE.png")]
    pub screenshot: Option<PathBuf>,
}

#[derive(Debug, Clone, Copy, clap::ValueEnum)]
enum PlotArg {
    /// How differently the eyes see each point.
    Disparity,
    /// Azimuth and elevation for each eye.
    Angles,
    /// Doppler factor for each eye.
    Doppler,
    /// Speed and distance fitted to noisy disparities.
    Fit,
    /// What each way to draw the views costs, and how far it is off.
    Accuracy,
}

#[derive(Debug, Clone, Copy, clap::ValueEnum)]
enum ThemeArg {
    Light,
    Dark,
}

/// Inner size of the window if none is asked for, points.
const DEFAULT_SIZE: [u32; 2] = [1280, 800];

impl WindowArgs {
    /// The state to start in: `settings`, with what the flags say in place of what was left.
    pub fn state(&self, mut settings: Settings) -> anyhow::Result<State> {
        let scene = Scene::open(&self.scene)?;
        if let Some((parameter, value)) = self.speed.given() {
            settings.motion.speed = SpeedSetting::new(parameter, value)?;
        }
        settings.motion.separation = self.d.unwrap_or(settings.motion.separation);
        if let Some(choice) = self.geometry {
            settings.look.geometry = choice.of_left_eye();
            settings.look.right_as_published = choice == Geometry::Published;
        }
        settings.quality.renderer = self.renderer.unwrap_or(settings.quality.renderer);
        settings.quality.bound_px = self.bound_px.unwrap_or(settings.quality.bound_px);
        if let Some(plot) = self.plot {
            settings.plots.tab = plot.into();
        }
        settings.window.corrected |= self.corrected;
        if let Some(theme) = self.theme {
            settings.window.theme = theme.into();
        }
        let mut state = State::new(settings, scene);
        state.session.time = self.time.map_or(state.session.time, super::clock::bounded);
        state.session.playing = self.play;
        Ok(state)
    }

    /// Inner size of the window, if one is asked for.
    #[must_use]
    pub const fn window_size(&self) -> Option<[u32; 2]> {
        self.window_size
    }

    /// Inner size of the window, points.
    #[must_use]
    pub fn window_size_or_default(&self) -> [u32; 2] {
        self.window_size.unwrap_or(DEFAULT_SIZE)
    }
}

impl From<PlotArg> for PlotTab {
    fn from(plot: PlotArg) -> Self {
        match plot {
            PlotArg::Disparity => Self::Disparity,
            PlotArg::Angles => Self::Angles,
            PlotArg::Doppler => Self::Doppler,
            PlotArg::Fit => Self::Fit,
            PlotArg::Accuracy => Self::Accuracy,
        }
    }
}

impl From<ThemeArg> for eframe::egui::ThemePreference {
    fn from(theme: ThemeArg) -> Self {
        match theme {
            ThemeArg::Light => Self::Light,
            ThemeArg::Dark => Self::Dark,
        }
    }
}

fn length(text: &str) -> Result<f64, String> {
    let value = finite_number(text)?;
    if (0.0..=super::settings::MAX_LENGTH).contains(&value) {
        Ok(value)
    } else {
        Err(format!("must be between 0 and {:e}", super::settings::MAX_LENGTH))
    }
}

fn size(text: &str) -> Result<[u32; 2], String> {
    sides(text).map_err(|error| format!("{error:#}"))
}

fn sides(text: &str) -> anyhow::Result<[u32; 2]> {
    let (width, height) = text.split_once('x').context("write it like 1280x800")?;
    let side = |text: &str| -> anyhow::Result<u32> {
        let side: u16 = text.trim().parse().context("write it like 1280x800")?;
        anyhow::ensure!((64..=8192).contains(&side), "each side must be between 64 and 8192");
        Ok(u32::from(side))
    };
    Ok([side(width)?, side(height)?])
}

//! What the user sets and the program remembers: plain values in groups, one group per control section.

use eframe::egui::ThemePreference;
use relativity_core::{Curves, Model};
use relativity_render::{Colour, Geometry, MeshRenderer, Shading};
use serde::{Deserialize, Serialize};

use super::speed_setting::SpeedSetting;
use crate::accuracy::Method;
use crate::flags::{RendererChoice, SpeedParameter};

/// Everything that outlives a session.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Settings {
    /// How the scene moves, and between which eyes.
    pub motion: Motion,
    /// How the eyes look at it.
    pub look: Look,
    /// What becomes of its light.
    pub light: Light,
    /// What draws it.
    pub quality: Quality,
    /// How time runs.
    pub playback: Playback,
    /// What the plots show.
    pub plots: Plots,
    /// What is fitted to what.
    pub fit: FitSetup,
    /// Which parts of the window are shown.
    pub window: Window,
}

/// Largest separation, distance and height that can be set.
pub const MAX_LENGTH: f64 = 1e6;

/// Speed, aperture separation and path.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Motion {
    /// Speed along +x.
    pub speed: SpeedSetting,
    /// d, 0 or more.
    pub separation: f64,
    /// How much further away than the scene says, along y.
    pub depth_shift: f64,
    /// How much higher than the scene says, along z.
    pub height_shift: f64,
}

impl Default for Motion {
    fn default() -> Self {
        let speed = SpeedSetting::new(SpeedParameter::Beta, 0.9).expect("0.9 is a speed");
        Self { speed, separation: 0.1, depth_shift: 0.0, height_shift: 0.0 }
    }
}

/// Where both eyes look.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum GazeSetting {
    /// At the selected point (the mean of its two apparent directions), in parallel.
    Tracking,
    /// In one direction, in parallel.
    Fixed {
        /// From +x towards +y, radians.
        azimuth: f64,
        /// From the x-y plane, radians.
        elevation: f64,
    },
}

/// Geometry, gaze and field of view.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Look {
    /// Which geometry the views show.
    pub geometry: Geometry,
    /// Whether the right eye sees, in place of its own light cone, what the published model has it see.
    pub right_as_published: bool,
    /// Where the eyes look.
    pub gaze: GazeSetting,
    /// Horizontal field of view of each eye, degrees.
    pub fov_degrees: f64,
}

/// Field of view at start, degrees.
pub const DEFAULT_FOV_DEGREES: f64 = 60.0;

impl Default for Look {
    fn default() -> Self {
        Self {
            geometry: Geometry::Seen,
            right_as_published: false,
            gaze: GazeSetting::Tracking,
            fov_degrees: DEFAULT_FOV_DEGREES,
        }
    }
}

/// Colour, intensity, shading and background.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Light {
    /// How a wavelength becomes a colour.
    pub colour: Colour,
    /// Whether the Doppler factor shifts the wavelength.
    pub doppler_shift: bool,
    /// Exponent n of D^n, or `None` for constant intensity.
    pub intensity_exponent: Option<f64>,
    /// Exposure, in factors of 2.
    pub exposure_ev: f64,
    /// How form is shown.
    pub shading: Shading,
    /// Whether there is a sky.
    pub sky: bool,
    /// Whether there is a ground grid (where the scene has a ground).
    pub ground: bool,
}

impl Default for Light {
    fn default() -> Self {
        Self {
            colour: Colour::Visible,
            doppler_shift: true,
            intensity_exponent: Some(relativity_core::doppler::PAPER_INTENSITY_EXPONENT),
            exposure_ev: 0.0,
            shading: Shading::Form,
            sky: true,
            ground: true,
        }
    }
}

/// What draws the views: the trade of speed for accuracy.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Quality {
    /// Which renderer.
    pub renderer: RendererChoice,
    /// How far the mesh renderer may draw a point from where it is seen, pixels.
    pub bound_px: f64,
    /// Whether the views show how far their pictures are off, while the Accuracy tab does.
    pub heat_map: bool,
}

/// Finest and coarsest bound of the mesh renderer, pixels.
pub const BOUND_PX: std::ops::RangeInclusive<f64> = 0.01..=100.0;

impl Quality {
    /// The renderer with its bound.
    #[must_use]
    pub const fn method(&self) -> Method {
        match self.renderer {
            RendererChoice::Exact => Method::Exact,
            // In this order no number is an impossible bound.
            RendererChoice::Mesh => {
                Method::Mesh { bound_px: self.bound_px.max(*BOUND_PX.start()).min(*BOUND_PX.end()) }
            }
            RendererChoice::Reference => Method::Reference,
        }
    }

    /// This, with another renderer.
    #[must_use]
    pub const fn with_method(self, method: Method) -> Self {
        match method {
            Method::Exact => Self { renderer: RendererChoice::Exact, ..self },
            Method::Mesh { bound_px } => Self { renderer: RendererChoice::Mesh, bound_px, ..self },
            Method::Reference => Self { renderer: RendererChoice::Reference, ..self },
        }
    }
}

impl Default for Quality {
    fn default() -> Self {
        Self { renderer: RendererChoice::Exact, bound_px: MeshRenderer::DEFAULT_BOUND_PX, heat_map: false }
    }
}

/// How the observation time runs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Playback {
    /// Units of T per second of the wall clock.
    pub rate: f64,
    /// Whether to start again at the end.
    pub looping: bool,
    /// First and last T; `None` fits them to the selected point's passage.
    pub range: Option<[f64; 2]>,
}

impl Default for Playback {
    fn default() -> Self {
        Self { rate: 1.0, looping: true, range: None }
    }
}

/// Which quantity is plotted against T.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum PlotTab {
    /// Delta-phi and Delta-theta.
    #[default]
    Disparity,
    /// phi and theta, each eye.
    Angles,
    /// Doppler factor, each eye.
    Doppler,
    /// Speed and distance from noisy disparities.
    Fit,
    /// Cost and error of each way to draw the views.
    Accuracy,
}

/// What the plots show.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Plots {
    /// Which quantity.
    pub tab: PlotTab,
    /// Whether the published model is drawn too, dashed.
    pub published: bool,
}

/// The fit of the selected point: the samples that both eyes take, and what is fitted to them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct FitSetup {
    /// Number of samples, evenly spread over the range.
    pub samples: usize,
    /// First and last T; `None` is as plotted.
    pub range: Option<[f64; 2]>,
    /// Standard deviation of the noise, in per cent of each curve's range.
    pub noise_percent: f64,
    /// Seed of the noise and of the bootstrap.
    pub seed: u64,
    /// Which curves are fitted.
    pub curves: Curves,
    /// With which binocular model.
    pub model: Model,
    /// Whether the time of passage is unknown and x0 fitted too.
    pub fit_x0: bool,
}

impl Default for FitSetup {
    fn default() -> Self {
        Self {
            samples: 240,
            range: None,
            noise_percent: 1.0,
            seed: 1,
            curves: Curves::Both,
            model: Model::Exact,
            fit_x0: false,
        }
    }
}

/// Which parts of the window are shown, and in which colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
#[expect(clippy::struct_excessive_bools, reason = "each part is shown or not")]
pub struct Window {
    /// The two eyes' views. Hidden views compute nothing.
    pub views: bool,
    /// The left eye's picture corrected to the rest frame, beside the two. Hidden, it costs nothing.
    pub corrected: bool,
    /// The plots.
    pub plots: bool,
    /// The controls.
    pub controls: bool,
    /// The numbers below the controls.
    pub readout: bool,
    /// Light, dark, or as the system says.
    pub theme: ThemePreference,
}

impl Default for Window {
    fn default() -> Self {
        Self {
            views: true,
            corrected: false,
            plots: true,
            controls: true,
            readout: true,
            theme: ThemePreference::Dark,
        }
    }
}

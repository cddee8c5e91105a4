//! The sections of the settings: plain values, one section per group of controls.

use std::ops::RangeInclusive;

use clap::{Args, ValueEnum};
use relativity_core::doppler::BOLOMETRIC_INTENSITY_EXPONENT;
use relativity_core::{Curves, Model, PublishedVariant};
use relativity_render::{Appearance, Colour, Geometry, Method, Shading, StreetColours};
use serde::Serialize;

use crate::flags::choices::{
    Compare, GazeChoice, Layout, ProjectionChoice, RendererChoice, Size, Swapped, ZeroParallax,
};
use crate::flags::{
    Exposure, FieldOfView, Goal, HEAD_DEGREES, IntensityExponent, OnOff, ScreenWidth, Share, SpeedParameter,
    SpeedSetting, TimeRange, switch, temperature, whole_number, within,
};
use crate::units::Units;

/// Largest separation, distance and height.
pub const MAX_LENGTH: f64 = 1e6;

/// Speed, the eyes' places, and path.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Motion")]
pub struct Motion {
    /// Speed of the scene along +x.
    #[command(flatten)]
    #[serde(flatten)]
    pub speed: SpeedSetting,
    /// Separation of the eyes. With the head held straight they rest at x = -d/2 (left) and x = +d/2 (right).
    #[arg(long, value_parser = within(0.0..=MAX_LENGTH), allow_hyphen_values = true)]
    pub d: f64,
    /// Tilt of the head, degrees: above 0 the right eye is the higher one, at 90 straight above the left one. Eyes above each other see a rod
    /// abreast contracted, and not turned; eyes along the motion see it turned.
    #[arg(long, value_name = "DEG", value_parser = within(HEAD_DEGREES), allow_hyphen_values = true)]
    pub roll: f64,
    /// Turn of the head about the vertical, degrees: above 0 to the left; at 90 the right eye is straight beyond the left one, along y.
    /// Lines of sight then need not meet.
    #[arg(long, value_name = "DEG", value_parser = within(HEAD_DEGREES), allow_hyphen_values = true)]
    pub turn: f64,
    /// Additional distance beyond the scene's own, along y.
    #[arg(long, value_name = "DY", value_parser = within(-MAX_LENGTH..=MAX_LENGTH), allow_hyphen_values = true)]
    pub depth_shift: f64,
    /// Additional height above the scene's own, along z.
    #[arg(long, value_name = "DZ", value_parser = within(-MAX_LENGTH..=MAX_LENGTH), allow_hyphen_values = true)]
    pub height_shift: f64,
}

impl Default for Motion {
    /// The motion of the paper.
    fn default() -> Self {
        let speed = SpeedSetting::new(SpeedParameter::Beta, 0.9).expect("0.9 is a speed");
        Self { speed, d: 0.1, roll: 0.0, turn: 0.0, depth_shift: 0.0, height_shift: 0.0 }
    }
}

/// Narrowest and widest field of view that can be set in the window, degrees.
const FOV_DEGREES: RangeInclusive<f64> = 2.0..=150.0;
/// The widest of them in conformal pictures: u from -5.4 to 5.4.
const WIDEST_CONFORMAL: f64 = 179.5;

/// Geometry, gaze, field of view and projection.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Look")]
pub struct Look {
    /// Geometry of the views: each point where it is seen, where it is measured to be at T, or as if all were at rest.
    #[arg(long, value_enum)]
    pub geometry: Geometry,
    /// Two pictures of the left eye in place of both eyes': the first follows all other settings, the second is this one. A gaze that
    /// follows does so in each; both have one field of view. The layout must be side by side or over-under.
    #[arg(long, value_enum)]
    #[serde(skip_serializing_if = "Compare::is_off")]
    pub compare: Compare,
    /// Gaze of both eyes, in parallel: at the middle of all that moves (`whole`), at the selected point, straight ahead along y, abreast at
    /// the whole passage, or fixed: azimuth (from +x towards +y; 90 is straight ahead) and elevation in degrees.
    #[arg(long, value_name = "whole|point|ahead|passage|AZ,EL", allow_hyphen_values = true)]
    pub gaze: GazeChoice,
    /// Horizontal field of view of each eye, degrees, as it would be straight ahead; `auto` fits it to all that moves with
    /// the scene (usually 42 to 150, wider in conformal pictures), or to the whole passage, from 81 degrees left to 81 right or further; with the
    /// gaze ahead it is 110, with any other 60.
    #[arg(long, value_name = "auto|DEG", allow_hyphen_values = true)]
    pub fov: FieldOfView,
    /// Projection of lines of sight into a picture. What is measured does not depend on it.
    ///
    /// In conformal pictures and on flat screens, both eyes see a point in one row if the head is held along the motion, or the point rests;
    /// else in two: of the paper's cyclist at 0.9 c up to 25 arcmin apart as it comes to eyes turned by 20 degrees, 42 if they are tilted by
    /// 10, 65 if one is above the other.
    #[arg(long, value_enum)]
    pub projection: ProjectionChoice,
    /// Zero parallax: what has the same place in both pictures, and so appears in the plane of the screen: the selected point (or the hub
    /// that it turns about), what is infinitely far away, or what is this far ahead, 1e-9 to 1e12. Each picture is shifted as a whole; measured
    /// values do not change.
    ///
    /// It takes pictures that two eyes can fuse: not those of --projection gaze.
    #[arg(long, value_name = "point|infinity|DISTANCE", allow_hyphen_values = true)]
    pub zero_parallax: ZeroParallax,
}

/// The field of view that is used to show a point or a direction, degrees.
pub const USUAL_FOV: f64 = 60.0;
/// Field of view straight ahead, degrees: wide enough for a passing scene to be seen coming and going.
pub const FOV_AHEAD: f64 = 110.0;

impl Look {
    /// The fields of view that can be set in the window, degrees.
    #[must_use]
    pub const fn fov_range(&self) -> RangeInclusive<f64> {
        let conformal = matches!(self.projection, ProjectionChoice::Mercator);
        *FOV_DEGREES.start()..=if conformal { WIDEST_CONFORMAL } else { *FOV_DEGREES.end() }
    }

    /// The field of view, degrees, unless what is to be seen decides it.
    #[must_use]
    pub fn set_fov(&self) -> Option<f64> {
        self.fov.0.or(match self.gaze {
            GazeChoice::Whole | GazeChoice::Passage => None,
            GazeChoice::Ahead => Some(FOV_AHEAD),
            GazeChoice::Point | GazeChoice::Fixed(_) => Some(USUAL_FOV),
        })
    }
}

/// The light that bodies send, the part of it that is received, shading and background.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Light")]
pub struct Light {
    /// Light that the bodies send, and how it becomes a colour.
    #[arg(long, value_enum)]
    pub colour: Colour,
    /// Temperature of bodies that glow, in kelvin, or in degrees Celsius like 1000C.
    #[arg(long, value_name = "K", value_parser = temperature)]
    pub temperature: f64,
    /// Whether the Doppler effect shifts the wavelength: received = at rest / D.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub doppler_shift: OnOff,
    /// Exponent n of the received intensity D^n of light of one wavelength: `surface` (4, the radiance of a surface), `photons` (3, their number, or
    /// the power per unit of frequency), `paper` (2, the flux of a point source relative to what a camera riding along receives), a
    /// number from -10 to 10, or `off`.
    #[arg(long, value_name = "surface|photons|paper|N|off", allow_hyphen_values = true)]
    pub intensity_exponent: IntensityExponent,
    /// Exposure: light is multiplied by 2^EV, EV from -100 to 100; the brightest is compressed, not clipped. `auto` finds it from the speeds
    /// and the lights of the scene, so that it is steady while time runs: midway between the light at rest and the brightest that can be seen.
    ///
    /// `auto` brightens what glows by at most 6 EV, for what passes abreast. What glows at 1000 degrees Celsius and recedes at 0.9 c needs
    /// about 80.
    #[arg(long, value_name = "auto|EV", allow_hyphen_values = true)]
    pub exposure: Exposure,
    /// Whether what is received as ultraviolet or infrared keeps its form, in hatched grey (rising lines for infrared,
    /// falling ones for ultraviolet); eyes see nothing there.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub invisible: OnOff,
    /// Shading of the bodies.
    #[arg(long, value_enum)]
    pub shading: Shading,
    /// Whether what rests around the scene is drawn: its groups that do not move, such as houses and lamp posts.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub surroundings: OnOff,
    /// Whether the scene's ground is drawn: its road, or a grid of one line per unit of length. A soft shadow lies on the road where
    /// wheels touch it: exact there, since both are one event, and only suggested around it.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub ground: OnOff,
    /// Whether the sky behind the scene is a gradient; otherwise it is plain.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub sky: OnOff,
    /// Colours of road, ground, house fronts and sky as a rider sees them: their paints count as grey. Eyes at rest see them as painted.
    #[arg(long, value_enum)]
    pub street_colours: StreetColours,
    /// Whether sky and ground are light.
    #[arg(long, value_enum)]
    pub light: Daylight,
}

impl Default for Light {
    /// The intensity of a surface that shines in one wavelength, and every effect.
    fn default() -> Self {
        Self {
            colour: Colour::OneWavelength,
            temperature: Appearance::TEMPERATURE_K,
            doppler_shift: true,
            intensity_exponent: IntensityExponent(Some(BOLOMETRIC_INTENSITY_EXPONENT)),
            exposure: Exposure(None),
            invisible: true,
            shading: Shading::Form,
            surroundings: true,
            ground: true,
            sky: true,
            street_colours: StreetColours::Shifted,
            light: Daylight::Theme,
        }
    }
}

/// Whether sky and ground are light.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Daylight {
    /// Follows the window's theme; dark where there is none.
    #[default]
    Theme,
    /// Light, like a page.
    On,
    /// Dark, like a night.
    Off,
}

/// Finest and coarsest bound of the mesh renderer, pixels.
pub const BOUND_PX: RangeInclusive<f64> = 0.01..=100.0;

/// The choice of a renderer: the trade of speed for accuracy.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Quality")]
pub struct Quality {
    /// Renderer of the views.
    #[arg(long, value_enum)]
    pub renderer: RendererChoice,
    /// Greatest distance, pixels, at which the mesh renderer, where it is chosen, may draw a point from where it is seen. Coarser is faster.
    #[arg(long, value_name = "PX", value_parser = within(BOUND_PX))]
    pub bound_px: f64,
    /// Goal of the automatic renderer.
    #[command(flatten)]
    #[serde(flatten)]
    pub goal: Goal,
    /// Whether the views of the window get smoother while nothing changes: the reference draws them again, with more and more rays per pixel.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub refine: OnOff,
}

impl Default for Quality {
    fn default() -> Self {
        let bound_px = Method::DEFAULT_BOUND_PX;
        Self { renderer: RendererChoice::Auto, bound_px, goal: Goal::default(), refine: true }
    }
}

/// The layout of the eyes' pictures, and how `gamow render` makes a file of them. The window's views are as
/// large as its panes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Picture")]
pub struct Picture {
    /// Size of one eye's picture, pixels.
    #[arg(long, value_name = "WxH")]
    pub size: Size,
    /// Layout of the pictures of the two eyes. Those of an .exr file are layers of their own.
    #[arg(long, value_enum)]
    pub layout: Layout,
    /// The layouts whose two pictures are swapped, like `anaglyph,rows`: each has its own choice. `none` leaves all as described.
    #[arg(long, value_name = "none|LAYOUTS")]
    pub swapped: Swapped,
    /// Labels: a letter above each of two pictures beside or above each other, and a bar between them. Both lie outside the
    /// pictures.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub labels: OnOff,
    /// Rays per pixel of the reference renderer: N x N.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=16))]
    pub samples: u32,
}

impl Picture {
    /// The eyes that are shown (0 left, 1 right), in the order of the layout.
    #[must_use]
    pub const fn eyes(&self) -> &'static [usize] {
        self.layout.eyes(self.swapped.has(self.layout))
    }
}

impl Default for Picture {
    fn default() -> Self {
        Self {
            size: Size([960, 720]),
            layout: Layout::SideBySide,
            swapped: Swapped::default(),
            labels: true,
            samples: 3,
        }
    }
}

/// Nearest and furthest that one sits from it, cm.
pub const VIEWING_CM: RangeInclusive<f64> = 5.0..=100_000.0;
/// Closest and furthest that the middles of two pictures may be, mm.
pub const PICTURE_MM: RangeInclusive<f64> = 10.0..=200.0;

/// The screen that the pictures are seen on: an angle in the scene is another one there.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Screen")]
pub struct Screen {
    /// Width of the whole screen, centimetres: with the viewer's distance it tells at which angles the pictures are seen. `auto` assumes 96 pixels
    /// per inch, which is wrong for most projectors.
    #[arg(long, value_name = "auto|CM")]
    pub screen_width: ScreenWidth,
    /// Distance of the viewer from the screen, centimetres.
    #[arg(long, value_name = "CM", value_parser = within(VIEWING_CM))]
    pub viewing_distance: f64,
    /// Largest distance between the middles of two pictures that are fused without glasses, millimetres: no more than
    /// the distance of the viewer's pupils.
    #[arg(long, value_name = "MM", value_parser = within(PICTURE_MM))]
    pub picture_distance: f64,
}

impl Default for Screen {
    /// A screen on a desk.
    fn default() -> Self {
        Self { screen_width: ScreenWidth(None), viewing_distance: 60.0, picture_distance: 60.0 }
    }
}

/// Size of a point of the screen that `auto` assumes, cm: there are 96 of them in an inch.
const CM_PER_POINT: f64 = 2.54 / 96.0;

impl Screen {
    /// Returns the size of a point of a window on a screen of this width in points, where that is known, cm.
    #[must_use]
    pub fn cm_per_point(&self, width_points: Option<f64>) -> f64 {
        let set = self.screen_width.0.zip(width_points.filter(|points| *points >= 1.0));
        set.map_or(CM_PER_POINT, |(width, points)| width / points)
    }
}

/// Slowest and fastest playback, units of T per second.
pub const RATE: RangeInclusive<f64> = 0.001..=1e6;

/// The playback of the observation time.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Playback")]
pub struct Playback {
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

impl Default for Playback {
    fn default() -> Self {
        Self { rate: 1.0, looping: true, range: TimeRange(None) }
    }
}

/// The quantity that is plotted against T.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PlotTab {
    /// Disparities, delta-phi and delta-theta or delta-u and delta-v: how differently the eyes see each point.
    #[default]
    Disparity,
    /// Azimuth phi and elevation theta of the selected point, for each eye.
    Angles,
    /// Doppler factor D of the selected point, for each eye.
    Doppler,
    /// Stereo gain, and how far away two eyes place the selected point.
    Stereo,
    /// Speed and distance of the selected point, fitted to noisy disparities alone.
    Fit,
    /// Cost and error of each way to draw the views.
    Accuracy,
}

/// The coordinates of the disparity plots.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Coordinates {
    /// Delta-phi and delta-theta: azimuth and elevation.
    #[default]
    Angles,
    /// Delta-u and delta-v: the columns and rows of conformal pictures. Motion slides u by the rapidity for both eyes alike, so that delta-u of a
    /// moving point is that of a resting one for eyes gamma d apart, dashed.
    Conformal,
}

/// The contents of the plots.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Plots")]
pub struct Plots {
    /// Tab of the plots.
    #[arg(long, value_enum)]
    pub plot: PlotTab,
    /// The coordinates of the disparity plots.
    #[arg(long, value_enum)]
    pub coordinates: Coordinates,
    /// Whether the paper's approximate binocular model is plotted too, dashed: the right eye is the left one at T - delta-T, both angles measured
    /// from the left eye.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub published: OnOff,
    /// Whether the views show, while the Accuracy tab is open, how far each pixel's point is drawn from where it is seen.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub heat_map: OnOff,
}

impl Plots {
    /// Whether the disparities of u and v are plotted.
    #[must_use]
    pub fn is_conformal(&self) -> bool {
        self.plot == PlotTab::Disparity && self.coordinates == Coordinates::Conformal
    }
}

/// Fewest and most samples that are fitted: their fit still takes less than a second.
pub const FIT_SAMPLES: RangeInclusive<usize> = 2..=5000;
/// Range of the noise, per cent.
pub const NOISE_PERCENT: RangeInclusive<f64> = 0.0..=100.0;
/// Largest seed: up to here a field of the window, whose numbers are `f64`, holds every whole number.
pub const MAX_SEED: u64 = 1 << f64::MANTISSA_DIGITS;

/// The fit of the selected point: the samples that both eyes take, and what is fitted to them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Fit")]
pub struct FitSetup {
    /// Number of samples of each curve, evenly spread over the range of T.
    #[arg(long, value_name = "N", value_parser = samples)]
    pub fit_samples: usize,
    /// Model by which the samples are simulated: that of the views, or another.
    #[arg(long, value_enum)]
    pub data_from: DataFrom,
    /// First and last T of the samples; `auto` takes the range that the plots show.
    #[arg(long, value_name = "auto|FROM,TO", allow_hyphen_values = true)]
    pub fit_range: TimeRange,
    /// Standard deviation of the normal noise on each sample, per cent of its curve's range: of the highest value less the lowest.
    #[arg(long, value_name = "PERCENT", value_parser = within(NOISE_PERCENT))]
    pub noise_percent: f64,
    /// Seed of the noise and of the bootstrap: the same seed gives the same numbers, another seed other noise of the same strength.
    #[arg(long, value_name = "S", value_parser = seed)]
    pub seed: u64,
    /// Curves that are fitted.
    #[arg(long, value_enum)]
    pub curves: Curves,
    /// The binocular model that is fitted.
    #[arg(long, value_enum)]
    pub model: Model,
    /// Whether x0 is fitted too, the point's place at t = 0, as if the time of passage were unknown; otherwise x0 is known.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub fit_x0: OnOff,
}

impl Default for FitSetup {
    fn default() -> Self {
        Self {
            fit_samples: 240,
            data_from: DataFrom::Views,
            fit_range: TimeRange(None),
            noise_percent: 1.0,
            seed: 1,
            curves: Curves::Both,
            model: Model::Exact,
            fit_x0: false,
        }
    }
}

/// The binocular model by which simulated samples are made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum DataFrom {
    /// The model of the views, exact or one cone: the data are what the eyes see there.
    #[default]
    Views,
    /// Each eye solves its own light cone.
    Exact,
    /// Both eyes receive the events of the middle between them.
    OneCone,
    /// The paper's binocular model, which leaves out parallax: fitted by the same model, it gives the paper's own fit.
    Published,
}

impl DataFrom {
    /// The model, unless that of the views decides.
    #[must_use]
    pub const fn model(self) -> Option<Model> {
        match self {
            Self::Views => None,
            Self::Exact => Some(Model::Exact),
            Self::OneCone => Some(Model::OneCone),
            Self::Published => Some(Model::Published(PublishedVariant::AppendixA)),
        }
    }
}

fn samples(text: &str) -> Result<usize, String> {
    whole_number(text, FIT_SAMPLES)
}

fn seed(text: &str) -> Result<u64, String> {
    whole_number(text, 0..=MAX_SEED)
}

/// The face of the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Face {
    /// Where everything is at the present T, from above and from the side.
    #[default]
    Space,
    /// When everything happens: x against t, light at 45 degrees.
    Spacetime,
}

/// The frame in which the map is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Frame {
    /// Frame of the street, where eyes and houses rest.
    #[default]
    Ground,
    /// Frame of everything that moves at the scene's speed: eyes and street ride past.
    Bicycle,
    /// Frame in which whoever rides rests at this moment, counted from there: the street rides past. That of the ground while nobody rides.
    Rider,
}

/// The part of the world that the map holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Framing {
    /// The whole passage, past both eyes.
    #[default]
    Passage,
    /// The selected body, close up: in space where it is seen and where two eyes place it, with the length of a rod; in spacetime where the
    /// followed points are now, with their clocks.
    CloseUp,
}

/// The contents of the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Map")]
pub struct Map {
    /// Face of the map.
    #[arg(long, value_enum)]
    pub face: Face,
    /// The frame in which the map is drawn.
    #[arg(long, value_enum)]
    pub frame: Frame,
    /// The part of the world that the map holds.
    #[arg(long, value_enum)]
    pub framing: Framing,
}

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
pub struct Window {
    /// The two eyes' views. Hidden views compute nothing.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub views: OnOff,
    /// The left eye's picture with the distortion undone, beside the two: by the fitted speed while the Fit tab is shown, else by the one that is
    /// set. Hidden, it costs nothing.
    #[arg(long, value_parser = switch, value_name = "on|off", num_args = 0..=1, default_missing_value = "on")]
    pub corrected: OnOff,
    /// A strip below the views that shows which wavelengths arrive from the selected point, in the whole spectrum.
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
    /// In each view a clock that rests beside the eyes, to compare the others with; and at every clock the number of turns of its hand, since the
    /// step of a lesson began or since it showed 0.
    #[arg(long, value_parser = switch, value_name = "on|off", num_args = 0..=1, default_missing_value = "on")]
    pub resting_clock: OnOff,
    /// Ruler of rapidity along the lower edge of conformal views, and above it the colours that a body passes through.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub ruler: OnOff,
    /// In conformal views, the outline of what moves where it would be seen if it were at rest. Motion slides it by the rapidity, along the arrow.
    #[arg(long, value_parser = switch, value_name = "on|off", num_args = 0..=1, default_missing_value = "on")]
    pub resting: OnOff,
    /// On a ride, darkens the edges of the views while the head turns: movement there makes people ill.
    #[arg(long, value_parser = switch, value_name = "on|off", num_args = 0..=1, default_missing_value = "on")]
    pub vignette: OnOff,
    /// Units of lengths and times in the window and in saved plots. Data, states, flags and the records in pictures stay in the scene's own unit,
    /// with c = 1.
    #[arg(long, value_enum)]
    pub units: Units,
    /// Colours of the window.
    #[arg(long, value_enum)]
    pub theme: Theme,
}

impl Default for Window {
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
            ruler: true,
            resting: false,
            vignette: false,
            units: Units::Natural,
            theme: Theme::Dark,
        }
    }
}

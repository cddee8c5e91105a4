//! The settings, all together.

use std::ffi::OsString;
use std::path::Path;

use clap::Args;
use clap::builder::{OsStringValueParser, TypedValueParser as _};
use gamow_platform::files;
use serde::Serialize;

use super::error::SettingsError;
use super::ride::Riding;
use super::sections::{
    FitSettings, LightSettings, LookSettings, MapSettings, MotionSettings, PictureSettings, PlaybackSettings,
    PlotSettings, QualitySettings, ScreenSettings, WindowSettings,
};
use crate::flags::choices::{GazeChoice, Layout};
use crate::flags::{Followed, coordinates, time};
use crate::scene::PRESETS;

/// The sentence about a scene, of every flag that takes one.
pub const SCENE_HELP: &str = "Scene: a preset (street, cyclist, cube, globe, train, wheel, rods, twins, lattice, two-balls, post-office, \
    tunnel, tram, mr-tompkins, town, town-cyclist) or a scene file";

/// Everything that is set.
#[derive(Debug, Clone, PartialEq, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
pub struct Settings {
    /// Name or path of the scene.
    #[arg(long, help = SCENE_HELP, value_name = "PRESET|FILE", value_parser = OsStringValueParser::new().try_map(scene_name))]
    pub scene: String,
    /// Observation time T, -1e12 to 1e12 [default: when the tracked point is seen 45 degrees before it is
    /// abreast; 0 at rest]
    #[arg(long, value_name = "T", value_parser = time, allow_hyphen_values = true)]
    pub time: Option<f64>,
    /// The point that is tracked, at rest [default: the scene's own]
    #[arg(long, value_name = "X,Y,Z", value_parser = coordinates, allow_hyphen_values = true)]
    pub point: Option<[f64; 3]>,
    /// Points that are followed beside the scene's own, each as its place at rest and the number of its body
    /// [default: none]
    #[arg(long, value_name = "X,Y,Z@BODY;...", allow_hyphen_values = true)]
    pub points: Option<Followed>,
    /// Motion of the scene, and separation of the eyes.
    #[command(flatten)]
    pub motion: MotionSettings,
    /// Ride of the observer.
    #[command(flatten)]
    pub ride: Riding,
    /// Gaze, projection and geometry of the views.
    #[command(flatten)]
    pub look: LookSettings,
    /// Light of the bodies, and its way to a colour.
    #[command(flatten)]
    pub light: LightSettings,
    /// Renderer, and its error or time.
    #[command(flatten)]
    pub quality: QualitySettings,
    /// Layout and size of pictures.
    #[command(flatten)]
    pub picture: PictureSettings,
    /// Screen that the pictures are seen on.
    #[command(flatten)]
    pub screen: ScreenSettings,
    /// Playback of time.
    #[command(flatten)]
    pub playback: PlaybackSettings,
    /// Contents of the map.
    #[command(flatten)]
    pub map: MapSettings,
    /// Contents of the plots.
    #[command(flatten)]
    pub plots: PlotSettings,
    /// Samples and model of the fit.
    #[command(flatten)]
    pub fit: FitSettings,
    /// Parts of the window, and their sizes.
    #[command(flatten)]
    pub window: WindowSettings,
}

/// The name of a scene or its file, as it is recorded.
fn scene_name(name: OsString) -> Result<String, &'static str> {
    name.into_string().map_err(|_| NO_TEXT)
}

/// Error for the name of a scene's file that is no text.
const NO_TEXT: &str = "the file's name is not text in UTF-8, so nothing could record which scene is shown; \
    another name would be right";

impl Default for Settings {
    /// The cyclist on Gamow's street.
    fn default() -> Self {
        Self {
            scene: PRESETS[0].to_owned(),
            time: None,
            point: None,
            points: None,
            motion: MotionSettings::default(),
            ride: Riding::default(),
            look: LookSettings::default(),
            light: LightSettings::default(),
            quality: QualitySettings::default(),
            picture: PictureSettings::default(),
            screen: ScreenSettings::default(),
            playback: PlaybackSettings::default(),
            map: MapSettings::default(),
            plots: PlotSettings::default(),
            fit: FitSettings::default(),
            window: WindowSettings::default(),
        }
    }
}

impl Settings {
    /// Returns these settings with the scene in the file at `path`, as [`Self::with_scene`] does.
    ///
    /// # Errors
    /// A name that cannot be recorded.
    pub fn with_scene_file(self, path: &Path) -> Result<Self, SettingsError> {
        let unreadable =
            || SettingsError::Read { source_name: files::shown(path), reason: NO_TEXT.to_owned() };
        let scene = path.to_str().ok_or_else(unreadable)?.to_owned();
        Ok(self.with_scene(scene))
    }

    /// Returns these settings with another scene, a preset or a file. Settings that belong to a scene become
    /// defaults: where it passes, where the eyes look and ride, T, and what is done over a range of T. Speed,
    /// eyes, geometry and light stay.
    #[must_use]
    pub fn with_scene(self, scene: String) -> Self {
        let default = Self::default();
        let MotionSettings { depth_shift, height_shift, .. } = default.motion;
        let LookSettings { geometry, compare, projection, .. } = self.look;
        // All by name, so that of a new one it has to be said whether it stays.
        Self {
            scene,
            time: None,
            point: None,
            points: None,
            motion: MotionSettings { depth_shift, height_shift, ..self.motion },
            ride: Riding { push: self.ride.push, ..default.ride },
            look: LookSettings { geometry, compare, projection, ..default.look },
            light: self.light,
            quality: self.quality,
            picture: self.picture,
            screen: self.screen,
            playback: PlaybackSettings { range: default.playback.range, ..self.playback },
            map: self.map,
            plots: self.plots,
            fit: FitSettings { fit_range: default.fit.fit_range, ..self.fit },
            window: self.window,
        }
    }

    /// Returns these settings with the window, the screen and the layout of `other`, which belong to whoever
    /// looks and not to what is shown. Only a panorama brings its layout along, and a ride or a whole
    /// passage its one picture in place of two apart; each takes it away again.
    #[must_use]
    pub fn in_place_of(self, other: &Self) -> Self {
        let is_kept = self.is_in_one_picture() && !other.picture.layout.shows_two_apart();
        let layout = match (self.has_own_layout() && !is_kept, other.has_own_layout()) {
            (true, _) => self.picture.layout,
            (false, true) if !is_kept => PictureSettings::default().layout,
            (false, _) => other.picture.layout,
        };
        let picture = PictureSettings { layout, ..other.picture };
        Self { picture, ..self }.as_seen_by(other)
    }

    /// Returns these settings in the window and on the screen of a `viewer`, which no link and no picture of
    /// somebody else changes.
    #[must_use]
    pub const fn as_seen_by(mut self, viewer: &Self) -> Self {
        (self.screen, self.window) = (viewer.screen, viewer.window);
        self
    }

    /// Whether the layout belongs to what is shown.
    fn has_own_layout(&self) -> bool {
        self.is_panorama() || self.is_in_one_picture()
    }

    /// Whether it is a ride or a whole passage that one eye sees, in one large picture.
    pub(super) fn is_in_one_picture(&self) -> bool {
        let is_large = self.ride.is_on() || self.look.gaze == GazeChoice::Passage;
        is_large && self.picture.layout == Layout::Left
    }
}

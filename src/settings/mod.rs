//! The one set of settings: what the window remembers, the flags of the window and of `gamow render`, a state
//! file, and what a picture records of how it was made.
//!
//! A setting is one field here. Its name is the flag and the file's key, its doc comment the help and the
//! window's tooltip, its parser the judge of its values, wherever they come from. A section is a heading of
//! the help and a table of the file.

mod about;
mod all;
mod appearance;
mod comparison;
mod course;
mod entries;
mod error;
mod file;
mod head;
mod link;
pub mod message;
mod method;
mod observer;
mod panorama;
mod photograph;
mod presets;
mod ride;
mod rider;
mod sections;
mod start;
#[cfg(test)]
mod tests;
mod views;

pub use about::{About, about, about_all, meaning};
pub use all::{SCENE_HELP, Settings};
pub use comparison::{ComparisonError, NO_PAIR};
pub use error::{SettingsError, problem_in_one_line, problem_of_flags};
pub use file::looks_like_settings;
pub use head::Head;
pub use link::{is_link, link_of_pairs};
pub use photograph::CameraArgs;
pub use presets::{Preset, PresetGroup};
pub use ride::{AZIMUTH, ELEVATION, ON_A_RIDE, PUSH, Riding};
pub use rider::Rider;
pub use sections::{
    Coordinates, DataFrom, Daylight, FIT_SAMPLES, FitSettings, LENS_MM, LightSettings, LookSettings,
    MAX_LENGTH, MAX_SEED, MapFace, MapFrame, MapFraming, MapSettings, MotionSettings, NOISE_PERCENT,
    PICTURE_MM, PictureSettings, PlaybackSettings, PlotSettings, PlotTab, Presence, QualitySettings, RATE,
    ScreenSettings, Theme, USUAL_FOV, VIEWING_CM, WindowSettings,
};
pub use start::StartArgs;
pub use views::{Canvas, Subject};

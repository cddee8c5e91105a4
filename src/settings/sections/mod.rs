//! The sections of the settings: plain values, one section per group of controls and file.

mod fit;
mod light;
mod look;
mod map;
mod motion;
mod picture;
mod playback;
mod plots;
mod quality;
mod screen;
mod window;

pub use fit::{DataFrom, FIT_SAMPLES, FitSettings, MAX_SEED, NOISE_PERCENT};
pub use light::{Daylight, LightSettings};
pub use look::{FOV_AHEAD, LookSettings, USUAL_FOV};
pub use map::{MapFace, MapFrame, MapFraming, MapSettings};
pub use motion::{MAX_LENGTH, MotionSettings};
pub use picture::PictureSettings;
pub use playback::{PlaybackSettings, RATE};
pub use plots::{Coordinates, PlotSettings, PlotTab};
pub use quality::QualitySettings;
pub use screen::{LENS_MM, PICTURE_MM, ScreenSettings, VIEWING_CM};
pub use window::{Presence, Theme, WindowSettings};

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

pub use fit::{DataFrom, FIT_SAMPLES, FitSetup, MAX_SEED, NOISE_PERCENT};
pub use light::{Daylight, Light};
pub use look::{FOV_AHEAD, Look, USUAL_FOV};
pub use map::{Face, Frame, Framing, Map};
pub use motion::{MAX_LENGTH, Motion};
pub use picture::Picture;
pub use playback::{Playback, RATE};
pub use plots::{Coordinates, PlotTab, Plots};
pub use quality::{BOUND_PX, Quality};
pub use screen::{LENS_MM, PICTURE_MM, Screen, VIEWING_CM};
pub use window::{Presence, Theme, Window};

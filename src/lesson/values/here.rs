//! What a value is, and what it is worked out for.

use relativity_core::{Disparity, Sighting};

use super::fitted::Fit;
use crate::scene::{Scene, Track};
use crate::settings::Settings;

/// A value that lessons can tell.
pub struct Value {
    /// Its name.
    pub name: &'static str,
    /// What it is, with its unit.
    pub what: &'static str,
    /// It; `None` where it does not exist.
    pub work_out: fn(&Here) -> Option<f64>,
}

/// What a value is worked out for: a point of a scene at a T.
pub struct Here<'a> {
    /// The settings.
    pub settings: &'a Settings,
    /// The scene that they name.
    pub scene: &'a Scene,
    /// The point.
    pub track: Track,
    /// The body that it is on, if it is on one.
    pub body: Option<usize>,
    /// T.
    pub time: f64,
    /// The fit of the selected point, once it was asked for.
    pub fit: &'a Fit,
}

impl Here<'_> {
    /// What both eyes see of the point, by the model of what the views show.
    #[must_use]
    pub fn disparity(&self) -> Option<Disparity> {
        self.settings.disparity(&self.track, self.time).ok()
    }

    /// What the left eye sees of the point.
    #[must_use]
    pub fn left(&self) -> Option<Sighting> {
        Some(self.disparity()?.primary)
    }
}

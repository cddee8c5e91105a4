//! A value of a lesson, and the point it is computed for.

use relativity_core::{Disparity, Sighting};

use super::fitted::CachedFit;
use crate::scene::{Scene, Track};
use crate::settings::Settings;

/// A value that lessons can quote.
pub struct Value {
    /// Name by which a text quotes it, such as `doppler`.
    pub name: &'static str,
    /// Description of the value, with its unit.
    pub what: &'static str,
    /// Computes the value; `None` where it does not exist.
    pub work_out: fn(&Here) -> Option<f64>,
}

/// A row of a table of values.
pub const fn value(name: &'static str, what: &'static str, work_out: fn(&Here) -> Option<f64>) -> Value {
    Value { name, what, work_out }
}

/// The place that a value is computed for: a point of a scene at a T.
pub struct Here<'a> {
    /// Settings of the step, with those of the steps before.
    pub settings: &'a Settings,
    /// The scene that they name.
    pub scene: &'a Scene,
    /// Point of the scene.
    pub track: Track,
    /// The body that the point is on, if it is on one.
    pub body: Option<usize>,
    /// Observation time T.
    pub time: f64,
    /// Fit of the selected point, once it was needed.
    pub fit: &'a CachedFit,
}

impl Here<'_> {
    /// Returns the disparity of the point, by the model of the views.
    #[must_use]
    pub fn disparity(&self) -> Option<Disparity> {
        self.settings.disparity(&self.track, self.time).ok()
    }

    /// Returns the left eye's sighting of the point.
    #[must_use]
    pub fn left(&self) -> Option<Sighting> {
        Some(self.disparity()?.primary)
    }
}

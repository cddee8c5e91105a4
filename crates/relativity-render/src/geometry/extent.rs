//! The extent of a group: the box around its bodies, from whose middle they are placed.

use glam::DVec3;

/// The extent of a group: its bodies are placed from the middle of all, so that they keep their places among
/// each other however far the camera is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extent {
    /// The middle of a box around the bodies.
    pub middle: DVec3,
    /// No surface is farther from there, with room for rounding.
    pub reach: f64,
}

impl Extent {
    /// Returns the extent of a group whose bodies stay within these `boxes`, each given by its lowest and
    /// highest corner.
    pub(crate) fn new(boxes: impl IntoIterator<Item = [DVec3; 2]>) -> Self {
        let around = boxes.into_iter().reduce(|[low, high], [from, to]| [low.min(from), high.max(to)]);
        let [low, high] = around.unwrap_or([DVec3::ZERO, DVec3::ONE]);
        let middle = 0.5 * (low + high);
        Self { middle, reach: 1.001 * low.distance(middle) }
    }
}

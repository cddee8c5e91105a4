//! A straight ray whose distances count from a place on it near the bodies.
//!
//! In the rest frame a camera may be 1e30 units away (at gamma = 1e30, one unit before the event); distances
//! from there, at which f64 resolves 1e14, would not tell which of two bodies is nearer.

use glam::DVec3;

/// A ray from a camera.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray {
    /// A place on the ray: distances along it count from here.
    pub start: DVec3,
    /// Direction of the ray, a unit vector.
    pub direction: DVec3,
    /// From the camera to `start`; may be negative.
    pub from_camera: f64,
}

impl Ray {
    /// The ray from `camera` along the unit vector `direction`, counted from the camera.
    #[must_use]
    pub fn new(camera: DVec3, direction: DVec3) -> Self {
        Self { start: camera, direction, from_camera: 0.0 }
    }

    /// The ray's point nearest to `place`, from there, and how far along the ray it is.
    ///
    /// # Accuracy
    ///
    /// The rounding of a far start ends up along the ray, where it does not matter; across the ray a few
    /// units in the last place of the start's own offset are left.
    pub(crate) fn nearest_to(&self, place: DVec3) -> (DVec3, f64) {
        let mut offset = self.start - place;
        let mut distance = 0.0;
        // Each step leaves what f64 does not resolve of its length: of 1e30, 1e14, then 1e-2, then nothing.
        for _ in 0..3 {
            let step = -self.direction.dot(offset);
            offset += self.direction * step;
            distance += step;
        }
        (offset, distance)
    }

    /// Returns the ray, counted from its point nearest to `place`.
    pub(crate) fn counted_from(&self, place: DVec3) -> Self {
        let (offset, distance) = self.nearest_to(place);
        Self { start: place + offset, from_camera: self.from_camera + distance, ..*self }
    }
}

//! The axes of a picture.

use glam::DVec3;
use relativity_core::Aperture;
use relativity_core::math::{atan2, sin_cos};
use std::f64::consts::PI;

/// Steepest elevation of a gaze that follows something: at the zenith itself no horizon is level.
pub const MAX_ELEVATION: f64 = 89.5 * PI / 180.0;

/// The least part of a gaze across the baseline from which the tilt of a picture along that is found.
pub(crate) const LEAST_ACROSS: f64 = 1e-12;

/// The place of an aperture, as a vector.
pub(crate) const fn position(Aperture { x, y, z }: Aperture) -> DVec3 {
    DVec3::new(x, y, z)
}

/// Unit vectors of a camera: right, up and forward.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axes {
    /// To the right edge of the picture.
    pub right: DVec3,
    /// To its upper edge.
    pub up: DVec3,
    /// Along the optical axis, away from the camera.
    pub forward: DVec3,
}

impl Axes {
    /// Returns the axes of the picture parallel to `baseline` (a unit vector) with its axis as near to
    /// `towards` as can be.
    pub(crate) fn across(baseline: DVec3, towards: DVec3) -> Self {
        let right = baseline.normalize_or(DVec3::X);
        let part = towards - right * towards.dot(right);
        let is_told = part.length() > LEAST_ACROSS * towards.length();
        let forward = if is_told { part.normalize() } else { level_across(right).unwrap_or(DVec3::Y) };
        let up = right.cross(forward);
        // Upright; of a head on its side neither way is.
        if up.z < -1e-12 { Self { right: -right, up: -up, forward } } else { Self { right, up, forward } }
    }

    /// Returns the axes of the picture with rows along `right` and its axis along `towards`, across these; at
    /// the steepest elevation where that would turn it upside down.
    pub(crate) fn upright(right: DVec3, towards: DVec3) -> Self {
        let forward = towards.normalize();
        let Some(level) = level_across(right) else {
            return Self { right, up: right.cross(forward), forward };
        };
        let rise = right.cross(level);
        let tilt = atan2(forward.dot(rise), forward.dot(level));
        let (sine, cosine) = sin_cos(tilt.clamp(-MAX_ELEVATION, MAX_ELEVATION));
        let forward = if tilt.abs() > MAX_ELEVATION { level * cosine + rise * sine } else { forward };
        Self { right, up: right.cross(forward), forward }
    }

    /// These, turned to the right about `up` by an angle.
    pub(crate) fn turned(&self, angle: f64) -> Self {
        let Self { right, up, forward } = *self;
        let (sine, cosine) = sin_cos(angle);
        Self { right: right * cosine - forward * sine, up, forward: forward * cosine + right * sine }
    }
}

/// The level direction across `right` with which that is to the right; `None` where `right` is plumb.
pub(crate) fn level_across(right: DVec3) -> Option<DVec3> {
    DVec3::Z.cross(right).try_normalize()
}

//! The gaze of a camera, and the axes of a picture that is parallel to a baseline and has the gaze in its
//! middle.

use glam::DVec3;
use relativity_core::math::{asin, asinh, atan, atan2, hypot, sin_cos, tan};
use std::f64::consts::{FRAC_PI_2, PI};

use super::axes::{Axes, LEAST_ACROSS, MAX_ELEVATION};
use super::mercator::MOST_ASIDE;

/// A gaze: the direction of a camera's optical axis. The camera's horizon stays level.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Gaze {
    /// Azimuth from +x towards +y, radians; pi/2 looks straight ahead along +y.
    pub azimuth: f64,
    /// Elevation from the x-y plane, radians, in (-pi/2, pi/2).
    pub elevation: f64,
}

/// Greatest angle of a gaze from the plane across the baseline for which a picture stays parallel to the
/// baseline, radians: further on it would be stretched too much, and turns with the gaze.
pub const MAX_SLANT: f64 = 65.0 * PI / 180.0;
/// The farthest that a gaze can be aside for the tilt of a picture parallel to the baseline to be found,
/// radians.
const MOST_SLANT: f64 = FRAC_PI_2 - 1e-6;

impl Gaze {
    /// The gaze along +y.
    pub const STRAIGHT_AHEAD: Self = Self { azimuth: std::f64::consts::FRAC_PI_2, elevation: 0.0 };

    /// The gaze that looks along `direction` (any length above 0).
    #[must_use]
    pub fn along([x, y, z]: [f64; 3]) -> Self {
        Self { azimuth: atan2(y, x), elevation: atan2(z, hypot(x, y)) }
    }

    /// The gaze of two parallel eyes towards something that appears in these two directions (any lengths):
    /// their bisector, so that it lies as far left of the middle in one picture as right in the other. `None`
    /// for opposite directions, and inside an aperture.
    #[must_use]
    pub fn towards(directions: [DVec3; 2]) -> Option<Self> {
        let [left, right] = directions.map(DVec3::try_normalize);
        let Self { azimuth, elevation } = Self::along((left? + right?).try_normalize()?.to_array());
        Some(Self { azimuth, elevation: elevation.clamp(-MAX_ELEVATION, MAX_ELEVATION) })
    }

    /// The camera's unit vectors.
    #[must_use]
    pub fn axes(&self) -> Axes {
        let (sin_azimuth, cos_azimuth) = sin_cos(self.azimuth);
        let (sin_elevation, cos_elevation) = sin_cos(self.elevation);
        let right = DVec3::new(sin_azimuth, -cos_azimuth, 0.0);
        let forward = DVec3::new(cos_elevation * cos_azimuth, cos_elevation * sin_azimuth, sin_elevation);
        Axes { right, up: right.cross(forward), forward }
    }
}

impl Axes {
    /// Returns the axes of the picture beside `baseline` with `gaze` in its middle: parallel to the baseline,
    /// up to [`MAX_SLANT`].
    pub(crate) fn beside(baseline: DVec3, gaze: DVec3) -> Self {
        let across = Self::across(baseline, gaze);
        let slant = atan2(gaze.dot(across.right), gaze.dot(across.forward));
        across.turned(slant - slant.clamp(-MAX_SLANT, MAX_SLANT))
    }

    /// The gaze further aside than [`MAX_SLANT`] with which something along `direction`, which these are
    /// across the baseline for, is at these tangents to the right of the turned picture's axis and up.
    pub(super) fn turned_gaze_with(&self, direction: DVec3, [aside, rise]: [f64; 2]) -> Gaze {
        let off_axis = atan(aside);
        let (along, off_baseline) = (direction.dot(self.right), direction.dot(self.forward));
        // Its height over its distance along the plane through the rows, and that over its whole distance.
        let steepness = rise * sin_cos(off_axis).1;
        let height = steepness * hypot(along, off_baseline) / hypot(1.0, steepness);
        let tilt = asin((height / off_baseline.max(f64::MIN_POSITIVE)).clamp(-1.0, 1.0));
        let (sine, cosine) = sin_cos(tilt);
        let Self { right, forward, .. } = Self::upright(self.right, self.forward * cosine - self.up * sine);
        let slanted = atan2(along, direction.dot(forward)) - off_axis;
        let (least, most) = if aside > 0.0 { (MAX_SLANT, MOST_SLANT) } else { (-MOST_SLANT, -MAX_SLANT) };
        let slant = slanted + MAX_SLANT.copysign(aside);
        let (sine, cosine) = sin_cos(slant.clamp(least, most));
        Gaze::along((forward * cosine + right * sine).to_array())
    }

    /// The tangent to the right of the axis at which the picture has `gaze` in its middle, up to
    /// [`MAX_SLANT`].
    pub(crate) fn shear_towards(&self, gaze: DVec3) -> f64 {
        let (aside, depth) = (gaze.dot(self.right), gaze.dot(self.forward));
        held(if depth > LEAST_ACROSS { aside / depth } else { f64::MAX.copysign(aside) })
    }
}

/// Returns the u of `gaze` in a conformal picture, up to [`MOST_ASIDE`].
pub(super) fn aside(axes: &Axes, gaze: DVec3) -> f64 {
    let u = asinh(gaze.dot(axes.right) / hypot(gaze.dot(axes.forward), gaze.dot(axes.up)));
    // No number inside the aperture.
    if u.is_nan() { 0.0 } else { u.clamp(-MOST_ASIDE, MOST_ASIDE) }
}

/// A tangent, held at that of [`MAX_SLANT`].
pub(crate) fn held(tangent: f64) -> f64 {
    let steepest = tan(MAX_SLANT);
    tangent.clamp(-steepest, steepest)
}

//! The gaze that puts a direction at a pixel of a picture.

use glam::{DVec2, DVec3};
use relativity_core::math::{asin, atan2, hypot, sin_cos, sinh};

use super::axes::{Axes, MAX_ELEVATION};
use super::gaze::aside;
use super::mercator::MOST_ASIDE;
use super::{Camera, Gaze, Projection, held};

impl Camera {
    /// The gaze with which something along `direction` (any length above 0) appears at `pixel`, the horizon
    /// staying level; the nearest there is where that would tilt further than [`MAX_ELEVATION`]. A picture of
    /// half the sky stays as it is.
    #[must_use]
    pub fn gaze_with(&self, direction: DVec3, pixel: [f64; 2]) -> Gaze {
        match self.projection {
            Projection::Gaze => self.level_gaze_with(direction, pixel),
            Projection::Parallel { right, shift } => self.slanted_gaze_with(direction, pixel, right, shift),
            Projection::Mercator { right, shift } => self.slid_gaze_with(direction, pixel, right, shift),
            Projection::Vr180 { .. } => self.gaze,
        }
    }

    /// Returns the gaze that puts `direction` at this pixel of a picture across the gaze.
    fn level_gaze_with(&self, direction: DVec3, [u, v]: [f64; 2]) -> Gaze {
        let [width, height] = self.size.map(f64::from);
        // Right, up and forward of that pixel's line of sight.
        let (right, up, forward) = (u - 0.5 * width, 0.5 * height - v, self.focal_length_px());
        let (steepness, reach) = (atan2(up, forward), hypot(up, forward));
        let Gaze { azimuth, elevation } = Gaze::along(direction.to_array());
        // The height of the line of sight above the horizon is reach sin(elevation of the gaze + steepness).
        let height = sin_cos(elevation).0 * hypot(reach, right) / reach;
        let tilt = asin(height.clamp(-1.0, 1.0)) - steepness;
        let elevation = tilt.clamp(-MAX_ELEVATION, MAX_ELEVATION);
        Gaze { azimuth: azimuth + atan2(right, reach * sin_cos(elevation + steepness).1), elevation }
    }

    /// Returns the gaze that puts `direction` at this pixel of a picture parallel to `baseline`.
    fn slanted_gaze_with(&self, direction: DVec3, [u, v]: [f64; 2], baseline: DVec3, shift: f64) -> Gaze {
        let [width, height] = self.size.map(f64::from);
        let focal_length = self.focal_length_px();
        let (aside, rise) = ((u - 0.5 * width) / focal_length, (0.5 * height - v) / focal_length);
        // Turned about the baseline until it is at that height in the picture.
        let across = Axes::across(baseline, direction);
        let Axes { right, up, forward } = across;
        let ahead = Axes::upright(right, forward - up * rise).forward;
        let depth = direction.dot(ahead).max(f64::MIN_POSITIVE);
        let slant = direction.dot(right) / depth + shift - aside;
        if held(slant) == slant {
            return Gaze::along((ahead + right * slant).to_array());
        }
        across.turned_gaze_with(direction, [held(slant) + aside - shift, rise])
    }

    /// Returns the gaze that puts `direction` at this pixel of a conformal picture, whose content only slides
    /// as the gaze moves.
    fn slid_gaze_with(&self, direction: DVec3, [x, y]: [f64; 2], baseline: DVec3, shift: f64) -> Gaze {
        let [width, height] = self.size.map(f64::from);
        let off_middle = DVec2::new(x - 0.5 * width, 0.5 * height - y) / self.focal_length_px();
        let across = Axes::across(baseline, direction);
        let (sine, cosine) = sin_cos(-off_middle.y);
        let axes = Axes::upright(across.right, across.forward * cosine + across.up * sine);
        let u = (aside(&across, direction) - off_middle.x + shift).clamp(-MOST_ASIDE, MOST_ASIDE);
        Gaze::along((axes.forward + axes.right * sinh(u)).to_array())
    }
}

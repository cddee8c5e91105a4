//! Caps of the sky: directions about an axis, given by sine and cosine, so that no angle has to be computed.

use glam::DVec3;
use relativity_core::Speed;
use relativity_core::math::{hypot, sin_cos};

use super::cone::Cone;

/// Largest error of a cosine by rounding.
const ROUNDING: f64 = 1e-14;

/// A cap: all directions whose angle from `axis` is at most the one with this `sine` (0 or more) and
/// `cosine`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cap {
    /// Axis of the cap, a unit vector.
    pub axis: DVec3,
    pub sine: f64,
    pub cosine: f64,
}

impl Cap {
    /// The cap of every direction.
    pub const WHOLE_SKY: Self = Self { axis: DVec3::Y, sine: 0.0, cosine: -1.0 };

    /// Returns the cap of all directions to `corners`, with the great circles between them; all are unit
    /// vectors.
    pub fn around(axis: DVec3, corners: [DVec3; 4]) -> Self {
        let chord_squared =
            corners.into_iter().map(|corner| corner.distance_squared(axis)).fold(0.0, f64::max);
        let chord_squared = chord_squared * (1.0 + 1e-12);
        let cosine = 1.0 - 0.5 * chord_squared;
        if cosine < 0.0 {
            return Self::WHOLE_SKY;
        }
        Self { axis, sine: (chord_squared * (1.0 - 0.25 * chord_squared)).sqrt(), cosine }
    }

    /// Whether both share a direction, with a little to spare for rounding.
    pub fn meets(&self, other: &Self) -> bool {
        let [cosine, sine] = [
            self.cosine * other.cosine - self.sine * other.sine,
            self.sine * other.cosine + self.cosine * other.sine,
        ];
        sine < 0.0 || self.axis.dot(other.axis) >= cosine - ROUNDING
    }

    /// Returns the cap after aberration, which multiplies the tangent of half the angle from x by
    /// 1/`head_on_doppler_factor`: from the ground into the rest frame of what moves along +x. `None` if it
    /// holds -x, from where light comes from all sides then.
    ///
    /// In the plane through `axis` and x it ends at two angles psi, and those remain its ends.
    pub fn in_rest_frame(&self, speed: &Speed) -> Option<Self> {
        let DVec3 { x, y, z } = self.axis;
        let off_x = hypot(y, z);
        let middle = if x > 0.0 { off_x / (1.0 + x) } else { (1.0 - x) / off_x };
        let half = self.sine / (1.0 + self.cosine);
        if self.cosine < 0.0 || middle * half >= 1.0 - 1e-9 {
            return None;
        }
        let scale = 1.0 / speed.head_on_doppler_factor();
        let low = scale * (middle - half) / (1.0 + middle * half);
        let high = scale * (middle + half) / (1.0 - middle * half);
        let per_length = 1.0 / ((1.0 + low * low) * (1.0 + high * high)).sqrt();
        let (sine, cosine) = ((low + high) * per_length, (1.0 - low * high) * per_length);
        let across = DVec3::new(0.0, y, z) / off_x.max(f64::MIN_POSITIVE);
        Some(Self {
            axis: DVec3::X * cosine + across * sine,
            sine: (high - low) * per_length * (1.0 + 1e-12),
            cosine: (1.0 + low * high) * per_length,
        })
    }
}

impl From<Cone> for Cap {
    fn from(cone: Cone) -> Self {
        let (sine, cosine) = sin_cos(cone.half_angle);
        Self { axis: cone.axis, sine: sine.max(0.0), cosine }
    }
}

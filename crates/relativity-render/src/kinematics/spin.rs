//! The turning of bodies within their group, as parts of a wheel, and the points that they consist of.

use glam::DVec3;
use relativity_core::Turning;
use relativity_core::math;

/// The turning of a body about an axle along y, which rests in the frame of its group.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Spin {
    /// Any point of the axle, in the rest frame.
    pub hub: [f64; 3],
    /// W, the radius on which the wheel rolls, above 0. Nothing that turns with it is farther from the axle.
    pub radius: f64,
    /// Speed of the turning.
    pub turning: Turning,
}

/// A point of a body: where it is at t' = 0, and how it turns from there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MaterialPoint {
    /// Place of the point at t' = 0 by the clocks of the rest frame; at all times, if it does not turn.
    pub rest: DVec3,
    /// Turning of the point; `None` if it stays there.
    pub spin: Option<Spin>,
}

impl Spin {
    /// Returns the spin about an axle that is moved by `offset`.
    #[must_use]
    pub fn moved(self, offset: [f64; 3]) -> Self {
        Self { hub: (DVec3::from(self.hub) + DVec3::from(offset)).to_array(), ..self }
    }

    /// Returns the angular speed where the group moves at this velocity on the ground, `beta` in (-1, 1):
    /// about +y, radians per unit of the rest frame's time.
    #[must_use]
    pub fn omega(&self, beta: f64) -> f64 {
        self.turning.rim_speed(beta) / self.radius
    }

    /// From the axle to `place`, across it.
    pub(crate) fn off_axle(&self, place: DVec3) -> DVec3 {
        let [x, _, z] = self.hub;
        DVec3::new(place.x - x, 0.0, place.z - z)
    }

    /// Whether `place` is on the axle.
    pub(crate) fn is_on_axle(&self, place: DVec3) -> bool {
        self.off_axle(place) == DVec3::ZERO
    }

    /// The angle about the axle at which `place` is: radians from +x towards +z.
    #[must_use]
    pub fn angle(&self, place: DVec3) -> f64 {
        let DVec3 { x, z, .. } = self.off_axle(place);
        math::atan2(z, x)
    }

    /// Returns the place of the point that is at `rest` at t' = 0, at a time that depends on the place: from
    /// `axle_time`, that of the axle abreast of it, on by `later`, which follows from its distance from the
    /// axle and its angle at `axle_time`. The point turns at `omega`, as [`Self::omega`] has it.
    pub fn place_when(
        &self,
        rest: DVec3,
        omega: f64,
        axle_time: f64,
        later: impl FnOnce(f64, f64) -> f64,
    ) -> DVec3 {
        let off_axle = self.off_axle(rest);
        let r = math::hypot(off_axle.x, off_axle.z);
        let phase = self.angle(rest) - omega * axle_time;
        let (sine, cosine) = math::sin_cos(phase - omega * later(r, phase));
        rest - off_axle + DVec3::new(r * cosine, 0.0, r * sine)
    }

    /// Returns the place of a point of the wheel at `place` once it has turned by `angle` (radians, about +y,
    /// as a wheel does that rolls towards +x).
    #[must_use]
    pub fn turned(&self, place: DVec3, angle: f64) -> DVec3 {
        let off_axle = self.off_axle(place);
        place - off_axle + about_y(off_axle, angle)
    }
}

/// `v` turned by `angle` about +y: from z towards x.
pub(crate) fn about_y(v: DVec3, angle: f64) -> DVec3 {
    turned_by(v, math::sin_cos(angle))
}

/// The same by the angle with this sine and cosine.
pub(crate) fn turned_by(v: DVec3, (sine, cosine): (f64, f64)) -> DVec3 {
    DVec3::new(v.x * cosine + v.z * sine, v.y, v.z * cosine - v.x * sine)
}

impl MaterialPoint {
    /// Place of the point on the axle beside it, about which it turns; its own, if it does not turn.
    #[must_use]
    pub fn axle(&self) -> DVec3 {
        self.rest - self.spin.map_or(DVec3::ZERO, |spin| spin.off_axle(self.rest))
    }

    /// Returns the point moved by `offset`, and its axle with it.
    #[must_use]
    pub fn moved(self, offset: [f64; 3]) -> Self {
        Self { rest: self.rest + DVec3::from(offset), spin: self.spin.map(|spin| spin.moved(offset)) }
    }
}

impl From<DVec3> for MaterialPoint {
    fn from(rest: DVec3) -> Self {
        Self { rest, spin: None }
    }
}

impl From<[f64; 3]> for MaterialPoint {
    fn from(rest: [f64; 3]) -> Self {
        DVec3::from(rest).into()
    }
}

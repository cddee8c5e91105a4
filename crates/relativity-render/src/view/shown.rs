//! When a view shows what is somewhere in a group, and how far wheels have turned by then.

use glam::DVec3;
use relativity_core::Boost;
use relativity_core::math::{atan2, hypot};
use relativity_core::wheel::{measured_later, seen_later};

use super::Geometry;
use super::group_view::GroupView;
use crate::kinematics::spin::{MaterialPoint, Spin};

impl GroupView {
    /// When this view shows what is at `place` in the group's frame, by the clocks there: as its light left,
    /// or for [`Geometry::Contracted`] at the observation time on the ground.
    #[must_use]
    pub fn time_at(&self, place: DVec3) -> f64 {
        let Self { on_ground, origin, time, .. } = *self;
        if self.geometry == Geometry::Contracted {
            return if self.camera.velocity.is_rest() {
                Boost::from(on_ground).clock_reading(place.x, self.observation_time)
            } else {
                time - self.lag_along_motion(place - origin)
            };
        }
        self.reception.emission_time(on_ground.reflected(place).x, [place.y - origin.y, place.z - origin.z])
    }

    /// Returns the time by which the view shows what is at `from` + `step` later than what is at `from`,
    /// without the difference of both.
    pub(crate) fn later(&self, from: DVec3, step: DVec3) -> f64 {
        if self.geometry == Geometry::Contracted {
            return -self.lag_along_motion(step);
        }
        let v = from - self.origin;
        let sum = v.length() + (v + step).length();
        if sum > 0.0 { -(2.0 * v + step).dot(step) / sum } else { 0.0 }
    }

    /// Returns the time by which the view shows what is further along a ray through `place` later, per length
    /// along the unit vector `direction`.
    pub(crate) fn rate_along(&self, place: DVec3, direction: DVec3) -> f64 {
        match self.geometry {
            Geometry::Seen | Geometry::Published | Geometry::Rest => -1.0,
            Geometry::Contracted => -self.lag_along_motion(direction),
            // The ray only touches the curve of what is seen along one line of sight.
            Geometry::OneCone => -(place - self.origin).normalize_or(direction).dot(direction),
        }
    }

    /// Returns the direction, not of unit length, in which a ray along `direction` passes what is at `place`
    /// of a body that turns so, if it does: as somebody finds it who turns with the body.
    pub(crate) fn passing(&self, spin: Option<Spin>, place: DVec3, direction: DVec3) -> DVec3 {
        spin.map_or(direction, |spin| {
            let rate = spin.omega(self.on_ground.beta()) * self.rate_along(place, direction);
            direction - DVec3::Y.cross(spin.off_axle(place)) * rate
        })
    }

    /// The time by which what is measured at one time of the camera's is earlier in the group's frame, per
    /// step there.
    pub(crate) fn slowness_when_measured(&self) -> DVec3 {
        self.velocity.group_from_motion(DVec3::X) * self.velocity.speed.beta()
    }

    /// The same for this step.
    fn lag_along_motion(&self, step: DVec3) -> f64 {
        self.velocity.speed.beta() * self.velocity.motion_from_group(step).x
    }

    /// Returns the angle by which a body with this `spin` has turned since t' = 0 where it is shown at
    /// `place`.
    #[must_use]
    pub fn turn_at(&self, spin: &Spin, place: DVec3) -> f64 {
        let off_axle = spin.off_axle(place);
        let on_axle = place - off_axle;
        spin.omega(self.on_ground.beta()) * (self.time_at(on_axle) + self.later(on_axle, off_axle))
    }

    /// Returns the place of `point` in the group's frame when this view shows it.
    #[must_use]
    pub fn place_when_shown(&self, point: impl Into<MaterialPoint>) -> DVec3 {
        let MaterialPoint { rest, spin } = point.into();
        let Some(spin) = spin else { return rest };
        let off_axle = spin.off_axle(rest);
        let (on_axle, omega) = (rest - off_axle, spin.omega(self.on_ground.beta()));
        spin.place_when(rest, omega, self.time_at(on_axle), |r, phase| {
            if self.geometry == Geometry::Contracted {
                // What is across the axle alone counts.
                let DVec3 { x, z, .. } = self.slowness_when_measured();
                let (slowness, angle) = if z == 0.0 { (x, 0.0) } else { (hypot(x, z), atan2(z, x)) };
                measured_later(slowness, r, phase - angle, omega)
            } else {
                seen_later((on_axle - self.origin).to_array(), r, phase, omega)
            }
        })
    }

    /// Returns the factor by which the own motion of a body with this `spin`, seen at `place`, multiplies its
    /// Doppler factor: sqrt(1 - v^2)/(1 + v.n'), v being its velocity in the group's frame and n' the unit
    /// vector from the camera's event there. 1 in [`Geometry::Contracted`], which shows no light.
    #[must_use]
    pub fn own_doppler(&self, spin: &Spin, place: DVec3) -> f64 {
        if self.geometry == Geometry::Contracted {
            return 1.0;
        }
        let velocity = DVec3::Y.cross(spin.off_axle(place)) * spin.omega(self.on_ground.beta());
        let direction = (place - self.origin).normalize_or_zero();
        let speed = velocity.length();
        ((1.0 - speed) * (1.0 + speed)).max(0.0).sqrt() / (1.0 + velocity.dot(direction))
    }
}

//! A trial: an object with a value for each parameter, and the wheel that it may be the hub of.

use crate::domain::DomainError;
use crate::source::{SourcePoint, Turning, WheelPoint};
use crate::speed::Speed;

/// A trial object: a value for each parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Trial {
    pub speed: Speed,
    pub y: f64,
    pub z: f64,
    /// Time of passage t0.
    pub passage_time: f64,
    /// Objective x at t0.
    pub passage_x: f64,
    /// The wheel whose hub it is, and whose point is seen.
    pub rolling: Option<Rolling>,
}

impl Trial {
    /// Returns beta, y, z and x0 of the object.
    pub fn reported(&self) -> [f64; 4] {
        let beta = self.speed.beta();
        [beta, self.y, self.z, self.passage_x - beta * self.passage_time]
    }

    /// Returns the place of the object at t0.
    pub const fn point(&self) -> SourcePoint {
        SourcePoint { x0: self.passage_x, y: self.y, z: self.z }
    }
}

/// A point on a wheel of known size that rolls without slipping.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rolling {
    /// W, the radius on which the wheel rolls, above 0.
    pub radius: f64,
    /// Distance of the point from the axle, in radii, in [0, 1].
    pub rho: f64,
    /// Angle of the point at t' = 0 by the clocks of the rest frame, that is by the one which then passes the
    /// ground's origin at t = 0: from +x towards +z, radians.
    pub angle: f64,
}

impl Rolling {
    /// The point of the wheel whose hub is the trial object, t counted from its passage.
    pub(super) fn point(&self, trial: &Trial) -> WheelPoint {
        let Self { radius, rho, angle } = *self;
        // The clocks at rest with the wheel show gamma t0 less than their own time.
        let turned = trial.speed.beta() / radius * (trial.speed.gamma() * trial.passage_time);
        WheelPoint { hub: trial.point(), radius, rho, angle: angle - turned, turning: Turning::Rolling }
    }

    /// An error for what is outside the domain.
    pub(crate) fn check(&self) -> Result<(), DomainError> {
        let hub = SourcePoint { x0: 0.0, y: 0.0, z: 0.0 };
        let Self { radius, rho, angle } = *self;
        WheelPoint { hub, radius, rho, angle, turning: Turning::Rolling }.check()
    }
}

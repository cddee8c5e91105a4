//! The columns that tell how an observer moves.

use relativity_core::{Observer, ObserverVelocity, Speed};

use super::{ObservationError, check_half_turn};
use crate::flags::SpeedParameter;

/// The columns of an observer's speed, in the order of [`SpeedParameter::ALL`].
pub const OBSERVER_SPEED: [&str; 3] = ["observer_beta", "observer_gamma", "observer_rapidity"];
/// The columns of where the observer moves, radians: from +x towards +y, and up from the x-y plane.
pub const OBSERVER_DIRECTION: [&str; 2] = ["observer_azimuth", "observer_elevation"];
/// The columns of where the middle between the eyes is at T.
pub const OBSERVER_PLACE: [&str; 3] = ["observer_x", "observer_y", "observer_z"];
/// The column of what the observer's clock shows.
pub const CLOCK: &str = "clock";
/// What the columns of an observer begin with.
pub const OBSERVER_PREFIX: &str = "observer_";

/// How an observer moves, as given; what is not given is 0.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct GivenObserver {
    /// The parameter that gives the speed, and its value.
    pub speed: Option<(SpeedParameter, f64)>,
    /// Azimuth and elevation of the velocity, radians.
    pub direction: [f64; 2],
    /// Where on the ground the middle between the eyes is.
    pub place: [f64; 3],
}

impl GivenObserver {
    /// Returns the observer who is there at T = `time`.
    ///
    /// # Errors
    ///
    /// A speed or a direction out of range.
    pub fn observer(&self, time: f64) -> Result<Observer, ObservationError> {
        for (name, value) in OBSERVER_DIRECTION.into_iter().zip(self.direction) {
            check_half_turn(name, value)?;
        }
        let speed = self.speed.map_or(Ok(Speed::REST), |(parameter, value)| parameter.speed(value));
        let [azimuth, elevation] = self.direction;
        let velocity =
            ObserverVelocity::new(speed.map_err(ObservationError::ObserverSpeed)?, azimuth, elevation);
        Ok(Observer { velocity, place: self.place, time })
    }
}

/// The column of an observer's speed in this `parameter`.
#[must_use]
pub const fn observer_speed(parameter: SpeedParameter) -> &'static str {
    match parameter {
        SpeedParameter::Beta => OBSERVER_SPEED[0],
        SpeedParameter::Gamma => OBSERVER_SPEED[1],
        SpeedParameter::Rapidity => OBSERVER_SPEED[2],
    }
}

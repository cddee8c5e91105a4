//! An observer, as columns and flags describe one.

use relativity_core::{Observer, ObserverVelocity, Speed};

use super::error::{ObservationError, half_turn};
use super::names::OBSERVER_DIRECTION;
use crate::flags::GivenObserver;

impl GivenObserver {
    /// Returns the observer, who is there at T = `time`.
    ///
    /// # Errors
    ///
    /// A speed or a direction out of range.
    pub fn observer(&self, time: f64) -> Result<Observer, ObservationError> {
        let [azimuth, elevation] = OBSERVER_DIRECTION;
        let azimuth = half_turn(azimuth, self.direction[0])?;
        let elevation = half_turn(elevation, self.direction[1])?;
        let speed = self.speed.map_or(Ok(Speed::REST), |(parameter, value)| parameter.speed(value));
        let velocity =
            ObserverVelocity::new(speed.map_err(ObservationError::ObserverSpeed)?, azimuth, elevation);
        Ok(Observer { velocity, place: self.place, time })
    }
}

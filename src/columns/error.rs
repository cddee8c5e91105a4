//! Observations whose columns cannot be filled.

use std::f64::consts::PI;

use relativity_core::{DomainError, ObserverError, PairError, SpeedError, StereoError};
use thiserror::Error;

use super::names::{COLUMNS, OBSERVER_SPEED, ROLL, USUAL};

/// An observation whose columns cannot be filled.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum ObservationError {
    /// The speed is not one.
    #[error(transparent)]
    Speed(#[from] SpeedError),
    /// A coordinate or time outside the domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// The aperture separation is negative or outside the domain.
    #[error("d = {0:?} is out of range: it must be between 0 and 1e60")]
    Separation(f64),
    /// An angle that is more than half a turn.
    #[error("{name} = {value:?} is out of range: it must be between -180 and 180, in degrees")]
    Angle {
        /// The column of the angle.
        name: &'static str,
        /// Value that is out of range, degrees.
        value: f64,
    },
    /// A place on a wheel that is none.
    #[error("{name} = {value:?} is out of range: it must be {range}")]
    Wheel {
        /// The column of the value.
        name: &'static str,
        /// Value that is out of range.
        value: f64,
        /// The values that it may have, in words.
        range: &'static str,
    },
    /// A pair of eyes that the model does not know.
    #[error(transparent)]
    Pair(PairError),
    /// The observer's speed is not one.
    #[error("observer_{0}")]
    ObserverSpeed(SpeedError),
    /// An observer without a view.
    #[error(transparent)]
    Observer(ObserverError),
    /// The model has no stereo position.
    #[error(transparent)]
    Stereo(StereoError),
    /// A result that f64 cannot hold: the intensity, for a large exponent.
    #[error(
        "{column} comes out as {value}, which cannot be written; less extreme values or a smaller \
             --intensity-exponent are needed"
    )]
    NotFinite {
        /// The column that cannot be filled.
        column: &'static str,
        /// Value that the column would contain.
        value: f64,
    },
}

impl From<ObserverError> for ObservationError {
    fn from(error: ObserverError) -> Self {
        match error {
            ObserverError::Domain(error) => Self::Domain(error),
            ObserverError::Pair(error) => Self::Pair(error),
            ObserverError::Stereo(error) => Self::Stereo(error),
            ObserverError::RelativeSpeed | ObserverError::Published(_) => Self::Observer(error),
        }
    }
}

impl From<StereoError> for ObservationError {
    fn from(error: StereoError) -> Self {
        ObserverError::from(error).into()
    }
}

impl ObservationError {
    /// The column at fault.
    #[must_use]
    pub const fn column(&self) -> &'static str {
        match self {
            Self::Speed(SpeedError::Beta(_)) => "beta",
            Self::Speed(SpeedError::Gamma(_)) => "gamma",
            Self::Speed(SpeedError::Rapidity(_)) => "rapidity",
            Self::Domain(error) => error.name,
            Self::Separation(_) => "d",
            Self::Angle { name, .. } | Self::Wheel { name, .. } => name,
            Self::Pair(_) => ROLL,
            Self::ObserverSpeed(SpeedError::Beta(_)) | Self::Observer(_) => OBSERVER_SPEED[0],
            Self::ObserverSpeed(SpeedError::Gamma(_)) => OBSERVER_SPEED[1],
            Self::ObserverSpeed(SpeedError::Rapidity(_)) => OBSERVER_SPEED[2],
            Self::Stereo(_) => COLUMNS[USUAL],
            Self::NotFinite { column, .. } => column,
        }
    }
}

/// Refuses an angle, radians, that is more than half a turn.
pub(super) fn check_half_turn(name: &'static str, value: f64) -> Result<(), ObservationError> {
    let value_in_degrees = || ObservationError::Angle { name, value: value.to_degrees() };
    if (-PI..=PI).contains(&value) { Ok(()) } else { Err(value_in_degrees()) }
}

/// Returns an angle in degrees as radians; refuses one that is more than half a turn.
pub(super) fn half_turn(name: &'static str, value: f64) -> Result<f64, ObservationError> {
    let is_one = (-180.0..=180.0).contains(&value);
    if is_one { Ok(value.to_radians()) } else { Err(ObservationError::Angle { name, value }) }
}

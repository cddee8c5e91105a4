//! Reasons why there is no view.

use thiserror::Error;

use crate::domain::DomainError;
use crate::model::{Model, PairError};
use crate::speed::MAX_GAMMA;
use crate::stereo::StereoError;

/// Reasons why there is no view by a moving observer.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum ObserverError {
    /// A coordinate or time outside the domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// The point moves too fast past the observer.
    #[error("the point passes the observer with a Lorentz factor above {MAX_GAMMA:e}")]
    RelativeSpeed,
    /// A published model, which knows eyes at rest.
    #[error("the model {} has both eyes at rest: the observer cannot move", .0.name())]
    Published(Model),
    /// A pair of apertures that the model does not know.
    #[error(transparent)]
    Pair(PairError),
    /// Lines of sight that do not meet.
    #[error(transparent)]
    Stereo(StereoError),
}

impl From<PairError> for ObserverError {
    fn from(error: PairError) -> Self {
        match error {
            PairError::Domain(error) => Self::Domain(error),
            PairError::OffTheMotion(_) => Self::Pair(error),
        }
    }
}

impl From<StereoError> for ObserverError {
    fn from(error: StereoError) -> Self {
        match error {
            StereoError::Domain(error) => Self::Domain(error),
            StereoError::Published(_) | StereoError::Apart => Self::Stereo(error),
        }
    }
}

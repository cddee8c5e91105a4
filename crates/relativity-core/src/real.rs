//! The precisions that batches run in.

use crate::domain::MAX_COORDINATE;
use crate::math::Elementary;
use crate::speed::MAX_GAMMA;

/// The floating-point types that batches run in: f64 and f32.
pub trait Real: Elementary + Send + Sync + Into<f64> + sealed::Sealed {
    /// Largest magnitude of a coordinate or time.
    const MAX_COORDINATE: Self;
    /// Greatest Lorentz factor.
    const MAX_GAMMA: f64;
}

impl Real for f64 {
    const MAX_COORDINATE: Self = MAX_COORDINATE;
    const MAX_GAMMA: f64 = MAX_GAMMA;
}

/// Products of two apparent positions, (6 gamma^2 1e12)^2, stay inside f32.
impl Real for f32 {
    const MAX_COORDINATE: Self = 1e12;
    const MAX_GAMMA: f64 = 1e3;
}

/// The loops that are compiled here for both precisions, optimised, whatever the program that calls them is.
mod sealed {
    use crate::observation_batch::{DisparityColumns, Limits, ObservationColumns};

    pub trait Sealed: Sized {
        /// Writes the disparities of observations; whether all these are inside the domain.
        fn disparities(observations: &ObservationColumns<'_, Self>, out: DisparityColumns<'_, Self>) -> bool;
    }

    macro_rules! compiled_for {
        ($($number:ident)+) => {
            $(impl Sealed for $number {
                fn disparities(
                    observations: &ObservationColumns<'_, Self>,
                    out: DisparityColumns<'_, Self>,
                ) -> bool {
                    let coordinate = <Self as super::Real>::MAX_COORDINATE;
                    observations.fill(Limits { coordinate, gamma: <Self as super::Real>::MAX_GAMMA }, out)
                }
            })+
        };
    }

    compiled_for! { f32 f64 }
}

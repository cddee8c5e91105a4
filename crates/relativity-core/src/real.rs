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
    use crate::cone_pair::PointPair;

    pub trait Sealed: Sized {
        /// Writes the disparities of a point at these times; whether all times are inside the domain.
        fn disparities(
            pair: &PointPair<Self>,
            times: &[Self],
            dphi: &mut [Self],
            dtheta: &mut [Self],
        ) -> bool;
    }

    macro_rules! compiled_for {
        ($($number:ident)+) => {
            $(impl Sealed for $number {
                fn disparities(
                    pair: &PointPair<Self>,
                    times: &[Self],
                    dphi: &mut [Self],
                    dtheta: &mut [Self],
                ) -> bool {
                    pair.disparities(times, <Self as super::Real>::MAX_COORDINATE, dphi, dtheta)
                }
            })+
        };
    }

    compiled_for! { f32 f64 }
}

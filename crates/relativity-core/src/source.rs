//! What is seen: a point that moves uniformly, or one of a wheel.

use crate::apparent::SourcePoint;
use crate::wheel::WheelPoint;

/// A source of light that moves along +x.
///
/// # Examples
///
/// ```
/// use relativity_core::{Aperture, SourcePoint, Speed, Turning, WheelPoint, sighting};
/// use std::f64::consts::FRAC_PI_2;
///
/// // What is on the road rests there at any speed: it is seen where it is, in its own colour.
/// let hub = SourcePoint { x0: 0.0, y: 3.0, z: -3.0 };
/// let valve = WheelPoint { hub, radius: 1.0, rho: 1.0, angle: -FRAC_PI_2, turning: Turning::Rolling };
/// let seen = sighting(&Speed::from_beta(0.9)?, valve, Aperture::default(), 5.0)?;
/// assert!(seen.position[0].abs() < 1e-14 && (seen.distance - 5.0).abs() < 1e-14);
/// assert!((seen.doppler_factor - 1.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Source {
    /// It rests in the moving frame.
    Point(SourcePoint),
    /// It turns about an axle there.
    Wheel(WheelPoint),
}

impl Source {
    /// The same source, a point on the axle being one that does not turn.
    pub(crate) fn simplest(self) -> Self {
        match self {
            Self::Wheel(wheel) if wheel.rho == 0.0 => Self::Point(wheel.hub),
            source => source,
        }
    }

    /// The point that rests in the moving frame: the source itself, or the hub that it turns about.
    #[must_use]
    pub const fn place(&self) -> SourcePoint {
        match self {
            Self::Point(point) => *point,
            Self::Wheel(wheel) => wheel.hub,
        }
    }
}

impl From<SourcePoint> for Source {
    fn from(point: SourcePoint) -> Self {
        Self::Point(point)
    }
}

impl From<WheelPoint> for Source {
    fn from(point: WheelPoint) -> Self {
        Self::Wheel(point)
    }
}

//! The source of light: a point that moves uniformly, or a point of a wheel.

use crate::aperture::Aperture;
use crate::domain::{DomainError, MAX_COORDINATE, check, check_in};
use crate::speed::Speed;

/// A moving point, by its objective place at t = 0: its worldline is (x0 + beta t, y, z).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SourcePoint {
    /// Objective (contracted) x at t = 0.
    pub x0: f64,
    /// Depth (y).
    pub y: f64,
    /// Height (z).
    pub z: f64,
}

impl SourcePoint {
    /// Returns the same point with its coordinates measured from `aperture`.
    pub(crate) fn relative_to(self, aperture: Aperture) -> Self {
        Self { x0: self.x0 - aperture.x, y: self.y - aperture.y, z: self.z - aperture.z }
    }

    /// Returns the point with these coordinates at rest: x0 is contracted by gamma.
    ///
    /// # Examples
    ///
    /// ```
    /// use relativity_core::{SourcePoint, Speed};
    ///
    /// let speed = Speed::from_gamma(4.0)?;
    /// assert_eq!(SourcePoint::from_rest([2.0, 3.0, 1.0], &speed), SourcePoint { x0: 0.5, y: 3.0, z: 1.0 });
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn from_rest([xr, y, z]: [f64; 3], speed: &Speed) -> Self {
        Self { x0: xr / speed.gamma(), y, z }
    }
}

/// The least radius of a wheel: a length over it is at most 1e120, whose square f64 holds.
pub const MIN_RADIUS: f64 = 1e-60;

/// The speed at which a wheel turns.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Turning {
    /// Rolls without slipping: in its rest frame the ground passes its rim at the speed of the rim.
    #[default]
    Rolling,
    /// Turns with this speed of the rim in its rest frame, in (-1, 1), above 0 like a wheel that rolls
    /// towards +x.
    RimSpeed(f64),
}

impl Turning {
    /// The speed of the rim in the rest frame of a wheel that moves along x at `beta` in (-1, 1), above 0 as
    /// a wheel that rolls towards +x.
    #[must_use]
    pub const fn rim_speed(self, beta: f64) -> f64 {
        match self {
            Self::Rolling => beta,
            Self::RimSpeed(speed) => speed,
        }
    }
}

/// A material point of a wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct WheelPoint {
    /// The hub: where the axle, along y, crosses the plane in which the point turns.
    pub hub: SourcePoint,
    /// W, the radius on which it rolls, from [`MIN_RADIUS`] to [`MAX_COORDINATE`].
    pub radius: f64,
    /// Distance of the point from the axle, in radii, in [0, 1].
    pub rho: f64,
    /// Angle of the point at t' = 0 by the clocks of the rest frame: from +x towards +z, radians.
    pub angle: f64,
    /// Speed at which the wheel turns.
    pub turning: Turning,
}

impl WheelPoint {
    /// omega, radians per unit of the rest frame's time: how fast its angle falls.
    #[must_use]
    pub fn omega(&self, speed: &Speed) -> f64 {
        self.turning.rim_speed(speed.beta()) / self.radius
    }

    /// Returns the angle of the point at `proper_time`, by the clocks of the rest frame (those of
    /// [`Sighting::proper_time`](crate::Sighting)).
    #[must_use]
    pub fn angle_at(&self, speed: &Speed, proper_time: f64) -> f64 {
        self.angle - self.omega(speed) * proper_time
    }

    /// Returns an error for a wheel outside the domain; the hub is not checked.
    pub(crate) fn check(&self) -> Result<(), DomainError> {
        check_in("wheel_radius", self.radius, MIN_RADIUS..=MAX_COORDINATE)?;
        check_in("rho", self.rho, 0.0..=1.0)?;
        check("angle", self.angle)?;
        if let Turning::RimSpeed(rim) = self.turning {
            let below_light = 1.0 - f64::EPSILON / 2.0;
            check_in("rim speed", rim, -below_light..=below_light)?;
        }
        Ok(())
    }
}

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
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Source {
    /// A point at rest in the moving frame.
    Point(SourcePoint),
    /// A point that turns about an axle at rest there.
    Wheel(WheelPoint),
}

impl Source {
    /// Returns this source in its simplest form: a point on the axle does not turn.
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

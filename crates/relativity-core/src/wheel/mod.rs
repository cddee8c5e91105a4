//! Points of a wheel: they turn about an axle along y that moves along +x.
//!
//! Assembled while it turns, a wheel is in its own rest frame a rigid circle of radius W with straight, even spokes. A
//! point at rho W from the hub C is at P(t') = C + rho W (cos a, 0, sin a), a = `angle` - omega t', in that frame: it turns
//! as a wheel does that rolls towards +x. A camera event o at t0' sees it at the one t' at which
//! t0' - t' = |P(t') - o|: since |dP/dt'| = v < 1, the difference falls, and once only it is 0. What is seen is
//! what would be of a point that rests there, but for the Doppler factor: times sqrt(1 - v^2)/(1 + v.n'), n' being the unit
//! vector from o to P. A point of a rolling wheel on the road rests on the ground: D = 1.
//!
//! # Accuracy
//!
//! As [`crate::sighting`]: X, z, t, t', R, D, phi and theta of points of rolling wheels, for beta from 0.01 to 1 - 1e-9, every rho
//! and angle, wheels seen from 0.01 to 1,000 radii away; and disparities however close the apertures are. Measured
//! (`tests/oracle`, 2,000 inputs): median 0.2, 99 % 1.8, worst 3.6 units.
//!
//! Units grow with what the inputs tell: a rounding of the angle or of T moves t' by 1/(1 + v.n') times as much as at rest, at
//! most 1/(1 - v). So the colour of a point that rests on the road, D = 1, comes out within 1e-12 up to gamma = 20, and within
//! 1e-12 at every gamma up to 1e4 where its place is given.
//!
//! Derived here; not in the paper.

mod events;
mod pair;
mod root;
mod seen;

use num_traits::Float;

pub(crate) use pair::baseline;
pub use root::{MAX_STEPS, NEWTON_STEPS, measured_later, seen_later};
pub(crate) use seen::{Circle, Hub, Seen};

use crate::apparent::SourcePoint;
use crate::domain::{DomainError, MAX_COORDINATE, check, check_in};
use crate::speed::Speed;

/// The least radius of a wheel.
pub const MIN_RADIUS: f64 = 1e-60;

/// How fast a wheel turns.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Turning {
    /// It rolls without slipping: in its rest frame the ground passes its rim at the speed of the rim.
    #[default]
    Rolling,
    /// Its rim moves at this speed in its rest frame, in (-1, 1), above 0 as a wheel that rolls towards +x.
    RimSpeed(f64),
}

impl Turning {
    /// The speed of the rim in the rest frame of a wheel that moves along x at `beta` in (-1, 1), above 0 as a wheel that
    /// rolls towards +x.
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
pub struct WheelPoint {
    /// The hub: where the axle, along y, crosses the plane in which the point turns.
    pub hub: SourcePoint,
    /// W, the radius on which it rolls, from [`MIN_RADIUS`] to [`MAX_COORDINATE`].
    pub radius: f64,
    /// How far the point is from the axle, in radii, in [0, 1].
    pub rho: f64,
    /// Where it is at t' = 0 by the clocks of the rest frame: from +x towards +z, radians.
    pub angle: f64,
    /// How fast the wheel turns.
    pub turning: Turning,
}

impl WheelPoint {
    /// omega, radians per unit of the rest frame's time: how fast its angle falls.
    #[must_use]
    pub fn omega(&self, speed: &Speed) -> f64 {
        self.turning.rim_speed(speed.beta()) / self.radius
    }

    /// Its angle at `own_time`, by the clocks of the rest frame (those of [`Sighting::own_time`](crate::Sighting)).
    #[must_use]
    pub fn angle_at(&self, speed: &Speed, own_time: f64) -> f64 {
        self.angle - self.omega(speed) * own_time
    }

    /// Its circle, in the precision `F`.
    pub(crate) fn circle<F: Float>(&self, speed: &Speed) -> Circle<F> {
        let rim = self.turning.rim_speed(speed.beta());
        let [below_light, slip] = match self.turning {
            Turning::Rolling => {
                let slip = speed.beta() * (1.0 - self.rho);
                [speed.one_minus_beta() + slip, slip]
            }
            Turning::RimSpeed(rim) => [1.0, speed.beta()].map(|limit| (-self.rho).mul_add(rim.abs(), limit)),
        };
        let to = |value: f64| F::from(value).unwrap_or_else(F::infinity);
        Circle {
            r: to(self.rho * self.radius),
            angle: to(self.angle),
            omega: to(rim / self.radius),
            speed: to(self.rho * rim.abs()),
            below_light: to(below_light),
            slip: to(slip),
        }
    }

    /// An error for what is outside the domain of wheels; the hub is not looked at.
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

//! The velocity of a body past a moving observer, and axes along it on both sides.

use super::error::ObserverError;
use super::velocity::ObserverVelocity;
use crate::math;
use crate::speed::Speed;

/// The velocity of what moves along +x past an observer who moves anywhere.
///
/// Both have axes along the motion: unit vectors in the observer's axes, and unit vectors in the body's,
/// which are the ground's boosted along x. In these two the boost from the one to the other is along the
/// first axis alone, so that light seen along l in the first comes along
/// [`rest_from_ground`](crate::aberration::rest_from_ground) of l in the second.
///
/// # Examples
///
/// ```
/// use std::f64::consts::FRAC_PI_2;
///
/// use relativity_core::{ObserverVelocity, RelativeVelocity, Speed};
///
/// // To whoever rides across the street its lamps move along -y, and the rider moves along +y to them.
/// let rider = ObserverVelocity::new(Speed::from_beta(0.6)?, FRAC_PI_2, 0.0);
/// let past = RelativeVelocity::new(&Speed::REST, &rider)?;
/// assert!((past.speed().beta() - 0.6).abs() < 1e-15);
/// assert_eq!(past.observer_axes()[0], [0.0, -1.0, 0.0]);
/// assert_eq!(past.body_axes()[0], [0.0, -1.0, 0.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct RelativeVelocity {
    pub(super) speed: Speed,
    /// Unit vectors in the observer's axes: along the body's velocity, and two across it.
    pub(super) axes: [[f64; 3]; 3],
    /// Unit vectors in the body's axes: against the observer's velocity there, and two across it.
    body_axes: [[f64; 3]; 3],
    pub(super) lead: Lead,
    /// Magnitude of the proper velocity.
    pub(super) proper: f64,
}

impl RelativeVelocity {
    /// The velocity of a body that moves along +x at `speed` past an observer with this `velocity`.
    ///
    /// With v the observer's velocity, V its size, Gamma its Lorentz factor, e a unit vector along its part
    /// across x and h the sine of its angle with x, the body's proper velocity to the observer, and the
    /// observer's to the body, are
    ///
    /// ```text
    /// W = gamma beta h p + gamma Gamma (beta v_x/V - V) v/V,     p = (h, -v_x e_y/V, -v_x e_z/V)
    /// M = (gamma Gamma (v_x - beta), Gamma v_y, Gamma v_z)
    /// ```
    ///
    /// The axes are W/|W|, c x W/|W| and c on the one side, -M/|M|, -c x M/|M| and c on the other, c = x^ x
    /// e.
    ///
    /// # Errors
    ///
    /// A relative Lorentz factor above [`MAX_GAMMA`](crate::MAX_GAMMA).
    pub fn new(speed: &Speed, velocity: &ObserverVelocity) -> Result<Self, ObserverError> {
        let own = velocity.speed();
        let sine = velocity.sine();
        let lead = Lead::new(speed, velocity);
        // Its proper velocity along the observer's, and across.
        let along = speed.gamma() * own.gamma() * lead.along_observer;
        let across = speed.gamma() * speed.beta() * sine;
        let proper = math::hypot(along, across);
        if proper == 0.0 {
            return Ok(Self { speed: Speed::REST, axes: IDENTITY, body_axes: IDENTITY, lead, proper });
        }
        let relative = Speed::from_proper(proper).map_err(|_| ObserverError::RelativeSpeed)?;

        // Each part of its direction by a sum that cancels no more than the part itself does.
        let [vx, vy, vz] = velocity.direction();
        let aside = if own.gamma() < 2.0 {
            speed.beta() * vx * own.gamma_minus_one() - own.proper()
        } else {
            own.gamma() * lead.along_observer - speed.beta() * vx
        };
        let aside = speed.gamma() * aside / proper;
        let forward = [(across * sine + along * vx) / proper, aside * vy, aside * vz];
        let [ey, ez] = velocity.across_street();
        let sideways = [-aside * sine, forward[0] * ey, forward[0] * ez];
        let third = [0.0, -ez, ey];

        let (ahead, swerve) = (speed.gamma() * own.gamma() * lead.along_x, own.proper() * sine);
        let length = math::hypot(ahead, swerve);
        let (ahead, swerve) = (ahead / length, swerve / length);
        let body_axes = [[-ahead, -swerve * ey, -swerve * ez], [swerve, -ahead * ey, -ahead * ez], third];
        Ok(Self { speed: relative, axes: [forward, sideways, third], body_axes, lead, proper })
    }

    /// Magnitude of the velocity.
    #[must_use]
    pub const fn speed(&self) -> &Speed {
        &self.speed
    }

    /// Returns the axes along the motion in the observer's axes: the body moves along the first.
    #[must_use]
    pub const fn observer_axes(&self) -> [[f64; 3]; 3] {
        self.axes
    }

    /// Returns the axes along the motion in the body's own: the observer moves against the first.
    #[must_use]
    pub const fn body_axes(&self) -> [[f64; 3]; 3] {
        self.body_axes
    }
}

const IDENTITY: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The lead of one of two velocities over the other along each, at most rounding away from the truth where
/// both are near 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lead {
    /// The point's velocity along the observer's direction, less the observer's speed: beta `v_x`/V - V.
    pub along_observer: f64,
    /// The observer's velocity along x, less the point's: `v_x` - beta.
    pub along_x: f64,
}

impl Lead {
    fn new(speed: &Speed, velocity: &ObserverVelocity) -> Self {
        let (beta, own, x) = (speed.beta(), velocity.speed().beta(), velocity.direction()[0]);
        let [lag, own_lag] = [speed, velocity.speed()].map(Speed::one_minus_beta);
        // beta - V, from what both lack to the speed of light where that is less.
        let faster = if beta > 0.5 && own > 0.5 { own_lag - lag } else { beta - own };
        let aside = velocity.one_minus_x();
        if x > 0.0 {
            Self { along_observer: faster - beta * aside, along_x: -faster - own * aside }
        } else {
            Self { along_observer: beta * x - own, along_x: own * x - beta }
        }
    }
}

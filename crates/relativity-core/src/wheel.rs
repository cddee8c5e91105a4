//! Points of a wheel: they turn about an axle along y that moves along +x.
//!
//! Assembled while it turns, a wheel is in its own rest frame a rigid circle of radius W with straight, even spokes. A
//! point at rho W from the hub C is at P(t') = C + rho W (cos a, 0, sin a), a = `angle` - omega t', in that frame: it turns
//! as a wheel does that rolls towards +x. A camera event o at t0' sees it at the one t' at which
//! t0' - t' = |P(t') - o|: since |dP/dt'| < 1, g(t') = t0' - t' - |P(t') - o| falls. Times count from when the hub is
//! seen, and distances from its own, so that nothing cancels however far the camera is:
//! |P - o| - |C - o| = (2 v.q + q.q)/(|P - o| + |C - o|) with v = C - o and q = P - C.
//!
//! Derived here; not in the paper.

use num_traits::Float;

use crate::apparent::{Aperture, Sighting, SourcePoint, sighting_inside_domain};
use crate::math;
use crate::speed::Speed;

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
    /// W, the radius on which it rolls, above 0.
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
}

/// A point of a wheel as one aperture sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Seen {
    /// Where the point is when it is seen, as one that rests there would be at t = 0.
    pub place: SourcePoint,
    /// What its own motion multiplies the Doppler factor with: sqrt(1 - v^2)/(1 + v.n').
    pub own_doppler: f64,
    observation_time: f64,
}

impl WheelPoint {
    /// What `aperture` sees at `observation_time`.
    pub(crate) fn seen(&self, speed: &Speed, aperture: Aperture, observation_time: f64) -> Seen {
        let Self { hub, radius, rho, .. } = *self;
        let (gamma, omega, r) = (speed.gamma(), self.omega(speed), rho * radius);
        let seen = sighting_inside_domain(speed, hub, aperture, observation_time);
        let s = (hub.x0 - aperture.x) + speed.beta() * observation_time;
        let [x, y, z] = [gamma * s, hub.y - aperture.y, hub.z - aperture.z];
        let phase = self.angle_at(speed, seen.own_time);
        let later = seen_later([x, y, z], r, phase, omega);
        let (sine, cosine) = math::sin_cos(phase - omega * later);
        let (qx, qz) = (r * cosine, r * sine);
        let (px, pz) = (x + qx, z + qz);
        let distance = math::hypot(math::hypot(px, y), pz);
        let receding = if distance > 0.0 { omega * (px * qz - pz * qx) / distance } else { 0.0 };
        let v = omega * r;
        Seen {
            place: SourcePoint { x0: hub.x0 + qx / gamma, y: hub.y, z: hub.z + qz },
            own_doppler: ((1.0 - v) * (1.0 + v)).sqrt() / (1.0 + receding),
            observation_time,
        }
    }
}

impl Seen {
    /// All of what `aperture` sees.
    pub fn sighting(&self, speed: &Speed, aperture: Aperture) -> Sighting {
        let at_rest = sighting_inside_domain(speed, self.place, aperture, self.observation_time);
        Sighting { doppler_factor: at_rest.doppler_factor * self.own_doppler, ..at_rest }
    }
}

/// Most steps of the root's search: by Newton's method, kept inside the bracket by bisection.
pub const MAX_STEPS: u32 = 80;

/// By how much later than the hub a point `r` from it is seen, by the clocks of the rest frame: the root in [-r, r].
///
/// `hub` is from the camera's event, in the rest frame; `phase` is the point's angle when the hub is seen, which falls by
/// `omega` per unit of time. |omega r| is below 1.
#[must_use]
pub fn seen_later<F: Float>(hub: [F; 3], r: F, phase: F, omega: F) -> F {
    let [x, y, z] = hub;
    let far = math::hypot(math::hypot(x, y), z);
    root(r, |later| {
        let (sine, cosine) = math::sin_cos(phase - omega * later);
        let (qx, qz) = (r * cosine, r * sine);
        let (px, pz) = (x + qx, z + qz);
        let distance = math::hypot(math::hypot(px, y), pz);
        let sum = (distance + far).max(F::min_positive_value());
        let farther = ((x + px) * qx + (z + pz) * qz) / sum;
        // dq/dt' = omega (qz, -qx).
        let receding = omega * (px * qz - pz * qx) / distance.max(F::min_positive_value());
        (later + farther, F::one() + receding)
    })
}

/// By how much later than the hub a point `r` from it is where it is at one time of the ground, by the clocks of the rest
/// frame: the root in [-r, r] of later = -`beta q_x`, Kepler's equation. Otherwise as [`seen_later`].
#[must_use]
pub fn measured_later<F: Float>(beta: F, r: F, phase: F, omega: F) -> F {
    root(r, |later| {
        let (sine, cosine) = math::sin_cos(phase - omega * later);
        (later + beta * r * cosine, F::one() + beta * r * omega * sine)
    })
}

/// The root in [-r, r] of a function that rises there, from its value and slope.
pub(crate) fn root<F: Float>(r: F, function: impl Fn(F) -> (F, F)) -> F {
    let (mut low, mut high) = (-r, r);
    let mut at = F::zero();
    let two = F::one() + F::one();
    for _ in 0..MAX_STEPS {
        let (value, slope) = function(at);
        if value == F::zero() {
            break;
        }
        if value > F::zero() {
            high = at;
        } else {
            low = at;
        }
        let newton = at - value / slope;
        let next = if newton > low && newton < high { newton } else { (low + high) / two };
        if next == at {
            break;
        }
        at = next;
    }
    at
}

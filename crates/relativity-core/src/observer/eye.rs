//! An eye of a moving observer on the ground: its place and time there, and when the light that it receives
//! was emitted.

use super::motion::Observer;
use crate::aperture::Aperture;
use crate::math;
use crate::source::SourcePoint;
use crate::speed::Speed;
use crate::stereo::{cross, dot};

/// The terms of a sum, how large they are telling how much of it may cancel.
pub(super) type Terms = [f64; 5];

/// An eye on the ground, from the middle between both.
pub(super) struct EyeOnGround {
    /// dt, the delay of the eye's event after the middle's.
    later: f64,
    /// From the middle's place to the eye's.
    offset: [f64; 3],
    /// dt - dx and dt + dx.
    later_less_x: f64,
    later_plus_x: f64,
    /// dx - beta dt.
    x_less_motion: f64,
}

impl EyeOnGround {
    pub fn new(speed: &Speed, observer: &Observer, Aperture { x, y, z }: Aperture) -> Self {
        let velocity = &observer.velocity;
        let (own, direction, aside) = (velocity.speed(), velocity.direction(), velocity.one_minus_x());
        let [vx, ..] = direction;
        let along = dot([x, y, z], direction);
        let across = cross(direction, cross([x, y, z], direction));
        let stretched = own.gamma() * along;
        let [lag, own_lag] = [speed, own].map(Speed::one_minus_beta);
        let (v_less_x, x_less_motion) = if vx > 0.0 {
            (aside - own_lag, lag + speed.beta() * own_lag - aside)
        } else {
            (own.beta() - vx, vx - speed.beta() * own.beta())
        };
        Self {
            later: stretched * own.beta(),
            offset: std::array::from_fn(|i| across[i] + stretched * direction[i]),
            later_less_x: stretched * v_less_x - across[0],
            later_plus_x: stretched * (own.beta() + vx) + across[0],
            x_less_motion: across[0] + stretched * x_less_motion,
        }
    }

    /// Place on the ground, and T there.
    pub fn event(&self, observer: &Observer) -> (Aperture, f64) {
        let [x, y, z] = std::array::from_fn(|i| observer.place[i] + self.offset[i]);
        (Aperture { x, y, z }, observer.time + self.later)
    }

    /// The terms of t = T - R on the ground.
    pub fn by_distance(&self, observer: &Observer, line: [f64; 3], distance: f64) -> Terms {
        let own = observer.velocity.speed();
        let along = dot(line, observer.velocity.direction());
        [observer.time, self.later, -own.gamma() * distance, own.proper() * along, 0.0]
    }

    /// The terms of t, and of tau, from the light cone of the eye on the ground.
    pub fn by_light_cone(&self, speed: &Speed, observer: &Observer, point: SourcePoint) -> [Terms; 2] {
        let (beta, gamma, lag) = (speed.beta(), speed.gamma(), speed.one_minus_beta());
        let [ox, oy, oz] = observer.place;
        let time = observer.time;
        let s = ((point.x0 - ox) + beta * time) - self.x_less_motion;
        let rho = math::hypot(point.y - oy - self.offset[1], point.z - oz - self.offset[2]);
        let sum = math::hypot(s, rho / gamma) + s.abs();
        let beyond = if sum > 0.0 { rho * (rho / sum) } else { 0.0 };
        let (terms, x0, near, far) = if s <= 0.0 {
            ([time, -ox, self.later_less_x], point.x0, lag, 1.0 + beta)
        } else {
            ([time, ox, self.later_plus_x], -point.x0, 1.0 + beta, lag)
        };
        let [a, b, c] = terms.map(|term| term / near);
        let retarded_time = [a, b, c, x0 / near, -beyond];
        let [a, b, c] = terms.map(|term| gamma * far * term);
        [retarded_time, [a, b, c, gamma * x0, -beyond / gamma]]
    }
}

//! Velocity and place of an observer.

use super::velocity::ObserverVelocity;

/// An observer who moves evenly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Observer {
    /// Velocity on the ground.
    pub velocity: ObserverVelocity,
    /// Place on the ground of the middle between the eyes when the observer's clock shows 0.
    pub place: [f64; 3],
    /// T, the time of the ground's clocks there then.
    pub time: f64,
}

impl Observer {
    /// At rest at the ground's origin, whose clock shows 0 at this T.
    #[must_use]
    pub const fn at_rest(time: f64) -> Self {
        Self { velocity: ObserverVelocity::REST, place: [0.0; 3], time }
    }

    /// In the mirror in which +x is -x.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let [x, y, z] = self.place;
        Self { velocity: self.velocity.mirrored(), place: [-x, y, z], ..*self }
    }

    /// Returns the event of the observer at this time of the observer's own clock: the same observer, its clock set to 0 there.
    #[must_use]
    pub fn at(&self, proper_time: f64) -> Self {
        if proper_time == 0.0 {
            return *self;
        }
        let proper = self.velocity.proper();
        let place = std::array::from_fn(|i| self.place[i] + proper[i] * proper_time);
        Self { place, time: self.time + self.velocity.speed().gamma() * proper_time, ..*self }
    }
}

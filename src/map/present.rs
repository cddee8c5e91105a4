//! Where points are at one time of a frame: those that rest in the frame of their group, and those that turn there.

use glam::DVec3;
use relativity_core::math;
use relativity_core::wheel::measured_later;
use relativity_render::{MaterialPoint, Velocity};

/// A time of a frame, and how a group moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Present {
    /// The velocity of the group on the ground.
    pub on_ground: Velocity,
    /// Its velocity in the frame.
    pub relative: Velocity,
    /// The time by the clocks of the frame.
    pub time: f64,
}

impl Present {
    /// Where `point` is then, in the frame of its group.
    pub fn place(&self, point: MaterialPoint) -> DVec3 {
        let MaterialPoint { rest, spin } = point;
        let Some(spin) = spin else { return rest };
        let on_axle = DVec3::new(spin.hub[0], rest.y, spin.hub[2]);
        let (off, omega) = (rest - on_axle, spin.omega(self.on_ground.beta()));
        let there = self.own_time(on_axle);
        let phase = math::atan2(off.z, off.x) - omega * there;
        let later = measured_later(self.relative.beta(), math::hypot(off.x, off.z), phase, omega);
        spin.turned(rest, omega * (there + later))
    }

    /// What the clocks of the group's frame show then at `place` in it.
    pub fn own_time(&self, place: DVec3) -> f64 {
        self.time / self.relative.speed.gamma() - self.relative.beta() * place.x
    }
}

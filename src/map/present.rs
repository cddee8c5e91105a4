//! Places of points at one time of a frame: those that rest in the frame of their group, and those that turn
//! there.

use glam::DVec3;
use relativity_core::wheel::measured_later;
use relativity_core::{Aperture, Observer, Speed, Worldline};
use relativity_render::{Camera, Gaze, Geometry, MaterialPoint, Velocity, View};

/// A time of a frame, and how a group moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Present {
    /// The velocity of the group on the ground.
    pub on_ground: Velocity,
    /// Velocity of the group in the frame.
    pub relative: Velocity,
    /// The time by the clocks of the frame.
    pub time: f64,
}

impl Present {
    /// Returns the place of `point` at that time, in the frame of its group.
    pub fn place(&self, point: MaterialPoint) -> DVec3 {
        let MaterialPoint { rest, spin } = point;
        let Some(spin) = spin else { return rest };
        let on_axle = DVec3::new(spin.hub[0], rest.y, spin.hub[2]);
        let omega = spin.omega(self.on_ground.beta());
        spin.place_when(rest, omega, self.proper_time(on_axle), |r, phase| {
            measured_later(self.relative.beta(), r, phase, omega)
        })
    }

    /// Returns the time of the group's clocks at `place` in its frame.
    pub fn proper_time(&self, place: DVec3) -> f64 {
        Worldline::at_rest(self.relative, place.x).proper_time(self.time)
    }
}

/// The view of all that is at one time of the `observer`, from `place`, where the middle between the eyes is;
/// the scene's speed is `speed`.
pub(super) fn measured_by(observer: &Observer, place: DVec3, speed: Speed) -> View {
    let DVec3 { x, y, z } = place;
    let camera = Camera::new(Aperture { x, y, z }, Gaze::STRAIGHT_AHEAD, 1.0, [1, 1]);
    let camera = Camera { velocity: observer.velocity, ..camera };
    View { camera, speed, observation_time: observer.time, geometry: Geometry::Contracted }
}

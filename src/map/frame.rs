//! Events in the frame that a map is drawn in: the ground's, or one that moves against it in any direction.

use glam::DVec3;
use relativity_core::{Event, ObserverVelocity};
use relativity_render::Velocity;

/// Returns the event at this `place` and time `t` of the ground as the frame has it that moves at `frame`: its place along x, and its
/// time. Both frames have one origin, and axes that are boosted along the velocity without turning. Of a step from one event to
/// another both are differences.
#[must_use]
pub fn event_in(frame: &ObserverVelocity, place: DVec3, t: f64) -> Event {
    if let Some(along_street) = Velocity::along_street(frame) {
        return Event { x: place.x, t }.in_frame(along_street);
    }
    let ahead = DVec3::from(frame.direction());
    let along = place.dot(ahead);
    let there = Event { x: along, t }.in_frame(*frame.speed());
    Event { x: place.x + (there.x - along) * ahead.x, ..there }
}

//! Capsules that contain a shape: what its bounds in a picture are worked out from.

use glam::DVec3;

use crate::view::group_view::GroupView;

/// A tube with rounded ends in the rest frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Capsule {
    /// Centre of one end.
    pub from: DVec3,
    /// Centre of the other.
    pub to: DVec3,
    /// Radius of the tube.
    pub radius: f64,
}

impl Capsule {
    /// Returns a ball.
    pub const fn ball(centre: DVec3, radius: f64) -> Self {
        Self { from: centre, to: centre, radius }
    }

    /// A ball around some, of which there is at least one.
    pub fn ball_around(all: &[Self]) -> Self {
        let ends = || all.iter().flat_map(|capsule| [capsule.from, capsule.to]);
        let (low, high) = ends()
            .fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), end| (low.min(end), high.max(end)));
        let centre = 0.5 * (low + high);
        let reach =
            |capsule: &Self| capsule.from.distance(centre).max(capsule.to.distance(centre)) + capsule.radius;
        Self::ball(centre, all.iter().map(reach).fold(0.0, f64::max))
    }

    /// From the camera's event, in the axes along the group's motion.
    pub fn along_motion_from_camera(&self, view: &GroupView) -> Self {
        let [from, to] = [self.from, self.to].map(|end| view.along_motion_from_camera(end));
        Self { from, to, ..*self }
    }

    /// Adds balls to `out` that contain it, in its order, at most this long or no longer than wide.
    pub fn add_balls(&self, longest: f64, out: &mut Vec<Self>) {
        let length = self.from.distance(self.to);
        if length > longest && length > 2.0 * self.radius {
            for half in self.halves() {
                half.add_balls(longest, out);
            }
            return;
        }
        out.push(Self::ball(0.5 * (self.from + self.to), self.radius + 0.5 * length));
    }

    /// Returns the distance of the capsule from a place; 0 where it contains that.
    pub fn distance_from(&self, place: DVec3) -> f64 {
        let (axis, to_place) = (self.to - self.from, place - self.from);
        let along = to_place.dot(axis) / axis.length_squared().max(f64::MIN_POSITIVE);
        (to_place.distance(axis * along.clamp(0.0, 1.0)) - self.radius).max(0.0)
    }

    /// Returns both halves of the capsule.
    pub fn halves(&self) -> [Self; 2] {
        let middle = 0.5 * (self.from + self.to);
        [Self { to: middle, ..*self }, Self { from: middle, ..*self }]
    }
}

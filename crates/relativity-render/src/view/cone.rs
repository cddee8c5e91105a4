//! Cones of directions at an aperture: which part of the sky a body can be seen in.
//!
//! Aberration maps circles on the sky to circles, so the cone around a body in the rest frame becomes a
//! cone on the ground, exactly. Reference: R. Penrose, *The apparent shape of a relativistically moving
//! sphere* (1959).

use std::f64::consts::PI;

use glam::DVec3;
use relativity_core::Event;
use relativity_core::math::{asin, atan, atan2, sin_cos, tan};

use super::Geometry;
use super::group_view::GroupView;

/// A cone: all directions within `half_angle` of `axis`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    /// Axis of the cone, a unit vector.
    pub axis: DVec3,
    /// Radians, 0 to pi; pi is the whole sky.
    pub half_angle: f64,
}

impl Cone {
    /// The cone of every direction.
    pub const WHOLE_SKY: Self = Self { axis: DVec3::Y, half_angle: PI };

    /// The cone from the origin around the ball at `centre`; the whole sky from inside the ball.
    #[must_use]
    pub fn around_ball(centre: DVec3, radius: f64) -> Self {
        let distance = centre.length();
        if distance <= radius {
            return Self::WHOLE_SKY;
        }
        Self { axis: centre / distance, half_angle: asin(radius / distance) }
    }

    /// The camera's lines of sight along which `view` can see something of its group inside the rest-frame
    /// ball at `centre`.
    #[must_use]
    pub fn of_sight(view: &GroupView, centre: DVec3, radius: f64) -> Self {
        let centre = centre - view.origin;
        match view.geometry {
            Geometry::Rest => Self::around_ball(centre, radius),
            Geometry::Seen | Geometry::Published => {
                let along_motion = Self::around_ball(view.velocity.motion_from_group(centre), radius);
                let cone = along_motion.seen_from_ground(view);
                Self { axis: view.velocity.camera_from_motion(cone.axis), ..cone }
            }
            Geometry::OneCone => Self::in_one_cone(view, view.velocity.motion_from_group(centre), radius),
            // The ball is an ellipsoid to the camera, flattened along the motion: inside the ball about its
            // centre.
            Geometry::Contracted => {
                let DVec3 { x, y, z } = view.velocity.motion_from_group(centre);
                let contracted = DVec3::new(x / view.velocity.speed.gamma(), y, z);
                Self::around_ball(view.velocity.camera_from_motion(contracted), radius)
            }
        }
    }

    /// Returns the cone around a ball where both eyes have one light cone, from the `centre` in axes along
    /// the motion.
    ///
    /// What an eye is shown of a point then it sees at another time, which is off by no more than light takes
    /// to it from the middle; in between the point appears on a straight line. So the cones of both ends hold
    /// it, if convex.
    fn in_one_cone(view: &GroupView, centre: DVec3, radius: f64) -> Self {
        let speed = &view.velocity.speed;
        let eye = view.velocity.motion_from_camera(view.camera.off_middle);
        let reach = eye.length();
        let at = |delay: f64| {
            let eye = DVec3 { x: Event { x: eye.x, t: delay }.in_frame(*speed).x, ..eye };
            Self::around_ball(centre - eye, radius).seen_from_ground(view)
        };
        let cone = at(-reach).joined(&at(reach));
        Self { axis: view.velocity.camera_from_motion(cone.axis), ..cone }
    }

    /// The least cone around both; the whole sky where that is wider than half of it.
    fn joined(&self, other: &Self) -> Self {
        let between = atan2(self.axis.cross(other.axis).length(), self.axis.dot(other.axis));
        let [wide, narrow] = if self.half_angle >= other.half_angle { [self, other] } else { [other, self] };
        let half_angle = wide.half_angle.max(0.5 * (between + wide.half_angle + narrow.half_angle));
        if half_angle >= 0.5 * PI {
            return Self::WHOLE_SKY;
        }
        let (sin, cos) = sin_cos(half_angle - wide.half_angle);
        let across = (narrow.axis - wide.axis * wide.axis.dot(narrow.axis)).normalize_or_zero();
        Self { axis: wide.axis * cos + across * sin, half_angle }
    }

    /// The ground's cone of this rest-frame cone of half-angle up to pi/2, for motion along +x.
    ///
    /// In the plane through `axis` and x the cone ends at the angles psi +- `half_angle` from x, and
    /// aberration scales tan(psi/2). Angles count from the end of the x axis that is nearer, so that none
    /// reaches pi.
    fn seen_from_ground(self, view: &GroupView) -> Self {
        if self.half_angle >= PI {
            return self;
        }
        let ahead = 1f64.copysign(self.axis.x);
        let across = DVec3::new(0.0, self.axis.y, self.axis.z);
        let psi = atan2(across.length(), ahead * self.axis.x);
        let scale = if ahead > 0.0 {
            view.velocity.speed.head_on_doppler_factor()
        } else {
            1.0 / view.velocity.speed.head_on_doppler_factor()
        };
        let ground = |psi: f64| 2.0 * atan(scale * tan(0.5 * psi));
        let [low, high] = [ground(psi - self.half_angle), ground(psi + self.half_angle)];
        let (sin, cos) = sin_cos(0.5 * (low + high));
        let axis = DVec3::X * (ahead * cos) + across.normalize_or_zero() * sin;
        Self { axis, half_angle: 0.5 * (high - low) }
    }
}

//! Velocities of groups past a camera, with axes along them on both sides.
//!
//! Every formula is written for motion along +x. What is seen is brought into axes along the group's motion
//! first, and from these into the group's own axes: where the motion is along x both are the same reflection,
//! or nothing; else they are a turn each, since boosts in different directions leave frames turned
//! (`relativity_core::RelativeVelocity`).

use glam::{DMat3, DVec3};
use relativity_core::{
    MAX_GAMMA, ObserverError, ObserverVelocity, RelativeVelocity as PastObserver, Speed, aberration,
};

use super::velocity::Velocity;

/// The velocity of a group past a camera.
///
/// # Examples
///
/// ```
/// use std::f64::consts::FRAC_PI_2;
///
/// use glam::DVec3;
/// use relativity_core::{ObserverVelocity, Speed};
/// use relativity_render::{RelativeVelocity, Velocity};
///
/// // To a camera that flies upwards the street falls, and what is above is seen blueshifted.
/// let camera = ObserverVelocity::new(Speed::from_beta(0.6)?, 0.0, FRAC_PI_2);
/// let street = RelativeVelocity::new(Velocity::REST, &camera);
/// assert!((street.forward() - DVec3::NEG_Z).length() < 1e-15);
/// assert!((street.doppler_factor(DVec3::Z) - 2.0).abs() < 1e-15);
/// # Ok::<(), relativity_core::SpeedError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RelativeVelocity {
    /// Magnitude of the velocity.
    pub speed: Speed,
    axes: MotionAxes,
}

/// The axes along a motion: the group moves along the first, as the camera sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
enum MotionAxes {
    /// The axes of camera and group, with x reversed where the motion is towards -x.
    AlongX { is_backward: bool },
    /// Unit vectors, as columns, in the camera's axes and in the group's.
    Oblique { camera: DMat3, group: DMat3 },
}

impl From<Velocity> for RelativeVelocity {
    fn from(Velocity { speed, is_backward }: Velocity) -> Self {
        Self { speed, axes: MotionAxes::AlongX { is_backward } }
    }
}

impl RelativeVelocity {
    /// The velocity of what moves at `on_ground` past a camera that moves at `camera`. Two that fly apart at
    /// the greatest gamma part no faster than that.
    #[must_use]
    pub fn new(on_ground: Velocity, camera: &ObserverVelocity) -> Self {
        if let Some(camera) = Velocity::along_street(camera) {
            return on_ground.seen_from(camera).into();
        }
        Self::oblique(on_ground, camera).unwrap_or_else(|_| {
            let gamma = (0.25 * MAX_GAMMA / camera.speed().gamma()).max(1.0);
            let speed = Speed::from_gamma(gamma).unwrap_or(Speed::REST);
            let slower = Self::oblique(Velocity { speed, ..on_ground }, camera);
            slower.unwrap_or_else(|_| Velocity::REST.into())
        })
    }

    fn oblique(on_ground: Velocity, camera: &ObserverVelocity) -> Result<Self, ObserverError> {
        // The core's bodies move along +x.
        let mirrored = if on_ground.is_backward { camera.mirrored() } else { *camera };
        let past = PastObserver::new(&on_ground.speed, &mirrored)?;
        let columns = |axes: [[f64; 3]; 3]| {
            let [first, second, third] = axes.map(|axis| on_ground.reflected(axis.into()));
            DMat3::from_cols(first, second, third)
        };
        let axes =
            MotionAxes::Oblique { camera: columns(past.observer_axes()), group: columns(past.body_axes()) };
        Ok(Self { speed: *past.speed(), axes })
    }

    /// Whether it is none.
    pub(crate) fn is_rest(&self) -> bool {
        self.speed == Speed::REST
    }

    /// The velocity, if it is along x.
    pub(crate) const fn along_x(&self) -> Option<Velocity> {
        match self.axes {
            MotionAxes::AlongX { is_backward } => Some(Velocity { speed: self.speed, is_backward }),
            MotionAxes::Oblique { .. } => None,
        }
    }

    /// The unit vector along it, in the camera's axes; +x at rest.
    #[must_use]
    pub fn forward(&self) -> DVec3 {
        self.camera_from_motion(DVec3::X)
    }

    /// A vector in the camera's axes, in those along the motion.
    #[must_use]
    pub fn motion_from_camera(&self, v: DVec3) -> DVec3 {
        match self.axes {
            MotionAxes::AlongX { is_backward } => reflected(v, is_backward),
            MotionAxes::Oblique { camera, .. } => in_columns(camera, v),
        }
    }

    /// A vector in the axes along the motion, in the camera's.
    #[must_use]
    pub fn camera_from_motion(&self, v: DVec3) -> DVec3 {
        match self.axes {
            MotionAxes::AlongX { is_backward } => reflected(v, is_backward),
            MotionAxes::Oblique { camera, .. } => camera * v,
        }
    }

    /// A vector in the group's axes, in those along the motion.
    pub(crate) fn motion_from_group(&self, v: DVec3) -> DVec3 {
        match self.axes {
            MotionAxes::AlongX { is_backward } => reflected(v, is_backward),
            MotionAxes::Oblique { group, .. } => in_columns(group, v),
        }
    }

    /// A vector in the axes along the motion, in the group's.
    pub(crate) fn group_from_motion(&self, v: DVec3) -> DVec3 {
        match self.axes {
            MotionAxes::AlongX { is_backward } => reflected(v, is_backward),
            MotionAxes::Oblique { group, .. } => group * v,
        }
    }

    /// The line of sight (unit vector) in the group's frame, of the camera's.
    pub(crate) fn rest_from_ground(&self, line_of_sight: DVec3) -> DVec3 {
        let n = self.motion_from_camera(line_of_sight).to_array();
        self.group_from_motion(aberration::rest_from_ground(n, &self.speed).into())
    }

    /// Doppler factor of light from the group, received along the camera's `line_of_sight` (unit vector).
    #[must_use]
    pub fn doppler_factor(&self, line_of_sight: DVec3) -> f64 {
        aberration::doppler_factor(self.motion_from_camera(line_of_sight).to_array(), &self.speed)
    }

    /// Returns beta, 1 - beta, 1/gamma and gamma for the shaders.
    pub(crate) fn packed_speed(&self) -> [f32; 4] {
        Velocity::forward(self.speed).packed_speed()
    }

    /// Returns the axes in which the shaders have this camera's lines of sight: the camera's own where they
    /// reflect these, else those along the motion. Unit vectors of these in the camera's axes, as columns.
    pub(crate) fn sight_axes(&self) -> DMat3 {
        match self.axes {
            MotionAxes::AlongX { .. } => DMat3::IDENTITY,
            MotionAxes::Oblique { camera, .. } => camera,
        }
    }

    /// Returns -1 where the shaders reflect lines of sight to have the group move along +x, else 1.
    pub(crate) fn sign(&self) -> f64 {
        self.along_x().map_or(1.0, |velocity| velocity.direction())
    }

    /// Unit vectors along the motion in the group's axes, as columns, where the shaders turn vectors into
    /// these; none where the motion is along x.
    pub(crate) const fn oblique_axes(&self) -> Option<DMat3> {
        match self.axes {
            MotionAxes::AlongX { .. } => None,
            MotionAxes::Oblique { group, .. } => Some(group),
        }
    }
}

fn reflected(v: DVec3, is_backward: bool) -> DVec3 {
    if is_backward { DVec3 { x: -v.x, ..v } } else { v }
}

/// The products of `v` with each column.
fn in_columns(columns: DMat3, v: DVec3) -> DVec3 {
    DVec3::new(columns.x_axis.dot(v), columns.y_axis.dot(v), columns.z_axis.dot(v))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;

    /// n = [n'_across/Gamma + (n'_p - V) v]/(1 - V n'_p) onto the ground, then the same along x.
    fn through_ground(group: f64, camera: &ObserverVelocity, line: DVec3) -> (DVec3, f64) {
        let boost = |n: DVec3, v: DVec3, speed: f64| {
            let gamma = 1.0 / (1.0 - speed * speed).sqrt();
            let along = n.dot(v);
            let across = n - v * along;
            let slowed = 1.0 - speed * along;
            ((across / gamma + v * (along - speed)) / slowed, 1.0 / (gamma * slowed))
        };
        let (on_ground, camera_doppler) = boost(line, camera.direction().into(), camera.speed().beta());
        let (rest, doppler) = boost(on_ground, DVec3::X, -group);
        (rest, camera_doppler * doppler)
    }

    #[test]
    fn lines_of_sight_are_those_of_two_boosts() {
        for group in [0.0, 0.6, -0.6, 0.95] {
            let on_ground = Velocity::from_beta(group).expect("a speed");
            for (beta, azimuth, elevation) in
                [(0.9, FRAC_PI_2, 0.0), (0.5, 2.1, 0.4), (0.8, -0.3, -1.2), (0.7, 0.0, FRAC_PI_2)]
            {
                let speed = Speed::from_beta(beta).expect("a speed");
                let camera = ObserverVelocity::new(speed, azimuth, elevation);
                let past = RelativeVelocity::new(on_ground, &camera);
                for line in [[1.0, 0.0, 0.0], [-0.3, 0.9, 0.2], [0.5, -0.4, 0.8], [0.0, 0.1, -1.0]] {
                    let line = DVec3::from(line).normalize();
                    let (direction, doppler) = through_ground(group, &camera, line);
                    let found = past.rest_from_ground(line);
                    assert!(found.distance(direction) < 1e-14, "{found} for {direction}");
                    assert!((past.doppler_factor(line) / doppler - 1.0).abs() < 1e-14);
                }
            }
        }
    }

    /// Axes of both sides are unit vectors across each other.
    #[test]
    fn turns_lose_no_length_at_any_speed() {
        for gamma in [1.0 + 1e-9, 2.0, 1e3, 1e6] {
            for own in [1.0 + 1e-9, 3.0, 1e6] {
                let [speed, own] = [gamma, own].map(|gamma| Speed::from_gamma(gamma).expect("a speed"));
                for (azimuth, elevation) in [(1e-9, 0.0), (0.4, 0.3), (FRAC_PI_2, 0.0), (3.0, -1.5)] {
                    for is_backward in [false, true] {
                        let camera = ObserverVelocity::new(own, azimuth, elevation);
                        let past = RelativeVelocity::new(Velocity { speed, is_backward }, &camera);
                        let MotionAxes::Oblique { camera, group } = past.axes else { panic!("{past:?}") };
                        for axes in [camera, group] {
                            let off = axes.transpose() * axes - DMat3::IDENTITY;
                            assert!(
                                off.to_cols_array().into_iter().all(|part| part.abs() < 1e-15),
                                "{past:?}"
                            );
                        }
                    }
                }
            }
        }
    }
}

//! The street as a camera sees it that rides along: road, ground, house fronts and sky, all at rest on the
//! ground.
//!
//! They are like a group at rest, seen through the same aberration as a group of bodies. All of it is drawn
//! on the ground, from the camera's event there; only lines of sight and the size of a pixel are brought
//! there first. The shaders' `line_on_ground` and `cpu/packets/street/backdrop.rs` do the same.

use glam::{DMat3, DVec3};

use crate::camera::Camera;
use crate::kinematics::relative_velocity::RelativeVelocity;
use crate::kinematics::velocity::Velocity;
use crate::light::street_light::{DAYLIT_ROW, FALSE_ROW, StreetLight};
use crate::view::{Appearance, Geometry};

/// The street's motion against a camera, and the geometry that shows it: seen, contracted only, or at rest
/// with the camera.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct StreetSight {
    geometry: Geometry,
    velocity: RelativeVelocity,
}

/// A way to show the street, which chooses the pipeline of the last pass.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum StreetVariant {
    /// At rest with the camera.
    AtRest,
    /// Contracted only, without a Doppler effect.
    Contracted,
    /// Seen, in the colours in which it is painted.
    Painted,
    /// Seen in shifted daylight.
    Daylit,
    /// Seen in false colours.
    FalseColours,
}

impl StreetVariant {
    /// The variant of the shaders' geometry and row of tables.
    pub fn new(geometry: usize, row: usize) -> Self {
        match (geometry, row) {
            (1, _) => Self::Contracted,
            (2, _) => Self::AtRest,
            (_, DAYLIT_ROW) => Self::Daylit,
            (_, FALSE_ROW) => Self::FalseColours,
            _ => Self::Painted,
        }
    }

    /// Returns the shaders' `STREET_GEOMETRY`.
    pub fn geometry(self) -> f64 {
        match self {
            Self::Painted | Self::Daylit | Self::FalseColours => Geometry::Seen.number(),
            Self::Contracted => Geometry::Contracted.number(),
            Self::AtRest => Geometry::Rest.number(),
        }
    }

    /// Returns the shaders' `STREET_ROW`.
    pub fn row(self) -> f64 {
        match self {
            Self::Painted | Self::Contracted | Self::AtRest => 0.0,
            Self::Daylit => DAYLIT_ROW as f64,
            Self::FalseColours => FALSE_ROW as f64,
        }
    }
}

/// A line of sight on the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct GroundLine {
    /// Unit vector along the line.
    pub direction: DVec3,
    /// Distance in the camera's frame per distance on the ground.
    pub camera_per_ground: f64,
}

impl GroundLine {
    /// The part of a distance on the ground by which haze counts: the nearer of its distances in both frames.
    /// Haze is drawn so that the ground ends in the sky; it should hide neither what is far behind and seen
    /// large nor what is near ahead and seen small.
    pub fn haze_share(&self) -> f64 {
        self.camera_per_ground.min(1.0)
    }
}

impl StreetSight {
    /// Returns the street before `camera` in a view of this `geometry`.
    pub fn new(camera: &Camera, geometry: Geometry) -> Self {
        let velocity = RelativeVelocity::new(Velocity::REST, &camera.velocity);
        let geometry = match geometry {
            // A camera that rides along with the scene is shown with the street at rest about it.
            Geometry::Rest => Geometry::Rest,
            _ if velocity.is_rest() => Geometry::Rest,
            Geometry::Contracted => Geometry::Contracted,
            Geometry::Seen | Geometry::Published | Geometry::OneCone => Geometry::Seen,
        };
        Self { geometry, velocity }
    }

    /// The line on the ground of the camera's `line_of_sight` (unit vector).
    pub fn line(&self, line_of_sight: DVec3) -> GroundLine {
        match self.geometry {
            Geometry::Rest => GroundLine { direction: line_of_sight, camera_per_ground: 1.0 },
            Geometry::Contracted => {
                let stretched = self.stretched(line_of_sight);
                let length = stretched.length();
                GroundLine { direction: stretched / length, camera_per_ground: 1.0 / length }
            }
            _ => GroundLine {
                direction: self.velocity.rest_from_ground(line_of_sight),
                camera_per_ground: self.velocity.doppler_factor(line_of_sight),
            },
        }
    }

    /// The turn of a line on the ground, up to multiples of it, for a `turn` of the camera's line of sight
    /// across that.
    pub fn turn(&self, line: &GroundLine, turn: DVec3) -> DVec3 {
        self.stretched(turn) * line.camera_per_ground
    }

    /// Returns the light of the street in a picture with `appearance`: as painted where no light is seen to
    /// move.
    pub fn light(&self, appearance: &Appearance) -> StreetLight {
        if self.geometry == Geometry::Seen { StreetLight::new(appearance) } else { StreetLight::PAINTED }
    }

    /// A vector before the camera on the ground, longer by Gamma along the motion.
    fn stretched(&self, v: DVec3) -> DVec3 {
        let v = self.velocity.motion_from_camera(v);
        self.velocity.group_from_motion(DVec3 { x: self.velocity.speed.gamma() * v.x, ..v })
    }

    /// Whether the street is seen to move, otherwise than along x.
    pub fn is_oblique(&self) -> bool {
        self.geometry != Geometry::Rest && self.velocity.oblique_axes().is_some()
    }

    /// Unit vectors along its motion, as columns: in the camera's axes, where the shaders turn lines of sight
    /// into these.
    pub fn sight_axes(&self) -> DMat3 {
        self.velocity.sight_axes()
    }

    /// The same in the ground's axes.
    pub fn ground_axes(&self) -> DMat3 {
        self.velocity.oblique_axes().unwrap_or(DMat3::IDENTITY)
    }

    /// V, 1 - V, 1/Gamma and Gamma of the street against the camera, for the shaders.
    pub fn packed_speed(&self) -> [f32; 4] {
        self.velocity.packed_speed()
    }

    /// -1 if the street moves towards -x, else 1; the shaders' `GEOMETRY`; and their row of tables for this
    /// `light`.
    pub fn packed_motion(&self, light: &StreetLight) -> [f32; 4] {
        [self.velocity.sign(), self.geometry.number(), light.row() as f64, 0.0].map(|v| v as f32)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use relativity_core::{Aperture, ObserverVelocity, Speed};

    use super::*;
    use crate::camera::Gaze;
    use crate::kinematics::velocity::Motion;
    use crate::street::backdrop::Backdrop;
    use crate::view::View;

    /// Along the street, across it, upwards and aslant.
    fn velocities() -> [ObserverVelocity; 6] {
        let new = |beta, azimuth, elevation| {
            ObserverVelocity::new(Speed::from_beta(beta).expect("a speed"), azimuth, elevation)
        };
        [
            new(0.5, 0.0, 0.0),
            new(0.9, 0.0, 0.0),
            Velocity::from_beta(-0.8).expect("a speed").into(),
            new(0.9, FRAC_PI_2, 0.0),
            new(0.6, 0.0, FRAC_PI_2),
            new(0.95, 2.3, -0.4),
        ]
    }

    /// Lamps and road are one street: what touches the ground is seen where the ground is.
    #[test]
    fn a_body_and_the_ground_that_it_touches_are_seen_together() {
        let appearance = Appearance { ground_z: Some(-1.0), ..Appearance::default() };
        for geometry in [Geometry::Seen, Geometry::Contracted] {
            for velocity in velocities() {
                let camera = Camera::new(Aperture::default(), Gaze::STRAIGHT_AHEAD, 1.0, [8, 8]);
                let camera = Camera { velocity, ..camera };
                let view = View { camera, speed: Speed::REST, observation_time: 0.0, geometry };
                let backdrop = Backdrop::new(&camera, geometry, &appearance);
                let street = view.of_group(Motion::Own(Velocity::REST));
                for place in [[5.0, 3.0, -1.0], [-4.0, 2.0, -1.0], [0.0, 6.0, -1.0]] {
                    let seen = street.apparent_position(DVec3::from(place)).expect("in the domain");
                    let distance = backdrop.ground_distance(seen.normalize()).expect("it is below");
                    assert!((distance / seen.length() - 1.0).abs() < 1e-9, "{distance} for {seen}");
                }
            }
        }
    }

    /// A small turn of the camera's line of sight turns the line on the ground as two lines nearby differ.
    #[test]
    fn turns_are_those_of_lines_nearby() {
        let camera = Camera::new(Aperture::default(), Gaze::STRAIGHT_AHEAD, 1.0, [8, 8]);
        let both = [Geometry::Seen, Geometry::Contracted];
        let views = velocities().into_iter().flat_map(|velocity| both.map(|geometry| (velocity, geometry)));
        for (velocity, geometry) in views {
            let street = StreetSight::new(&Camera { velocity, ..camera }, geometry);
            for n in [DVec3::new(0.9, 0.3, 0.1), DVec3::new(-0.5, 0.6, -0.6), DVec3::Y] {
                let n = n.normalize();
                let line = street.line(n);
                for turn in [n.cross(DVec3::X), n.cross(DVec3::Z)].map(|turn| 1e-6 * turn) {
                    let across = |v: DVec3| v - line.direction * v.dot(line.direction);
                    let expected = street.line((n + turn).normalize()).direction - line.direction;
                    let found = across(street.turn(&line, turn));
                    assert!(found.distance(across(expected)) < 1e-4 * found.length(), "{found} {expected}");
                }
            }
        }
    }
}

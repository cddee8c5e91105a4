//! The orientation of a device that is held before the eyes, in the angles that browsers tell (W3C, *Device
//! Orientation and Motion*).

use glam::DVec3;
use relativity_core::math::sin_cos;

use crate::settings::Head;

/// The orientation of a device and of what its screen shows, degrees.
///
/// A device that lies on its back with its top to the north is at 0. From there it is turned by alpha about
/// the axis through its screen, then by beta about its own edge to the right, then by gamma about its own
/// edge to the top (intrinsic rotations Z-X'-Y'').
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orientation {
    /// Turn about the axis out of the screen.
    pub alpha: f64,
    /// Turn about the axis to the right of the device.
    pub beta: f64,
    /// Turn about the axis to the top of the device.
    pub gamma: f64,
    /// Turn of what is shown against the device, clockwise: 90 where the top of what is shown is at the right
    /// edge of the device.
    pub screen: f64,
}

impl Orientation {
    /// Returns the orientation with alpha, beta, gamma and the turn of the screen; `None` unless all are
    /// numbers.
    #[must_use]
    pub fn from_degrees(angles: [f64; 4]) -> Option<Self> {
        let [alpha, beta, gamma, screen] = angles;
        angles.iter().all(|angle| angle.is_finite()).then_some(Self { alpha, beta, gamma, screen })
    }

    /// Returns the head that looks at the screen straight through its back, with axes to the east, to the
    /// north and up.
    #[must_use]
    pub fn head(&self) -> Head {
        let Self { alpha, beta, gamma, screen } = *self;
        let [(sin_alpha, cos_alpha), (sin_beta, cos_beta), (sin_gamma, cos_gamma), (sin_screen, cos_screen)] =
            [alpha, beta, gamma, screen].map(|angle| sin_cos(angle.to_radians()));
        // Columns of the specification's matrix: the device's right edge, its top edge, and out of its
        // screen.
        let right = DVec3::new(
            cos_alpha * cos_gamma - sin_alpha * sin_beta * sin_gamma,
            sin_alpha * cos_gamma + cos_alpha * sin_beta * sin_gamma,
            -cos_beta * sin_gamma,
        );
        let top = DVec3::new(-cos_beta * sin_alpha, cos_alpha * cos_beta, sin_beta);
        let out = DVec3::new(
            cos_gamma * sin_alpha * sin_beta + cos_alpha * sin_gamma,
            sin_alpha * sin_gamma - cos_alpha * cos_gamma * sin_beta,
            cos_beta * cos_gamma,
        );
        Head { right: right * cos_screen - top * sin_screen, forward: -out }
    }
}

#[cfg(test)]
mod tests {
    use glam::DMat3;

    use super::*;

    const NORTH: DVec3 = DVec3::Y;
    const EAST: DVec3 = DVec3::X;
    const UP: DVec3 = DVec3::Z;

    /// Forward, to the right and up of the head before a device.
    #[track_caller]
    fn assert_pose(angles: [f64; 4], forward: DVec3, right: DVec3) {
        let head = Orientation::from_degrees(angles).expect("numbers").head();
        assert!(head.forward.distance(forward) < 1e-12, "{angles:?}: {}", head.forward);
        assert!(head.right.distance(right) < 1e-12, "{angles:?}: {}", head.right);
    }

    #[test]
    fn known_poses_look_where_they_do() {
        let half = 0.75f64.sqrt();
        // Upright: with the top up, and on its left side, with what it shows turned.
        assert_pose([0.0, 90.0, 0.0, 0.0], NORTH, EAST);
        assert_pose([90.0, 0.0, -90.0, 90.0], NORTH, EAST);
        // On its right side.
        assert_pose([270.0, 0.0, 90.0, 270.0], NORTH, EAST);
        // On its back, and tilted so that one looks up by 30 degrees.
        assert_pose([0.0, 0.0, 0.0, 0.0], -UP, EAST);
        assert_pose([0.0, 120.0, 0.0, 0.0], NORTH * half + UP * 0.5, EAST);
        // Across, 30 degrees up: past the upright, alpha and beta change by half a turn.
        assert_pose([270.0, 180.0, 60.0, 90.0], NORTH * half + UP * 0.5, EAST);
        // Turned by 90 degrees to the east.
        assert_pose([270.0, 90.0, 0.0, 0.0], EAST, -NORTH);
        assert_pose([0.0, 0.0, -90.0, 90.0], EAST, -NORTH);
        // Upright, tilted to the right by 20 degrees.
        let (sine, cosine) = sin_cos(20f64.to_radians());
        assert_pose([0.0, 90.0, 0.0, 20.0], NORTH, EAST * cosine - UP * sine);
    }

    #[test]
    fn the_matrix_is_the_product_of_three_turns() {
        for step in 0..2000 {
            let angle = |part: f64, most: f64| (f64::from(step) * part).fract() * 2.0 * most - most;
            let [alpha, beta, gamma] = [angle(0.618, 180.0), angle(0.414, 180.0), angle(0.732, 90.0)];
            let screen = 90.0 * f64::from(step % 4);
            let head = Orientation { alpha, beta, gamma, screen }.head();
            let device = DMat3::from_rotation_z(alpha.to_radians())
                * DMat3::from_rotation_x(beta.to_radians())
                * DMat3::from_rotation_y(gamma.to_radians());
            let shown = device * DMat3::from_rotation_z(-screen.to_radians());
            assert!(head.right.distance(shown * DVec3::X) < 1e-12);
            assert!(head.forward.distance(shown * -DVec3::Z) < 1e-12);
        }
    }

    #[test]
    fn what_is_no_number_is_no_orientation() {
        assert_eq!(Orientation::from_degrees([0.0, f64::NAN, 0.0, 0.0]), None);
        assert_eq!(Orientation::from_degrees([0.0, 0.0, f64::INFINITY, 0.0]), None);
    }
}

//! A stereoscope while it is shown: the head before it, and the page that it shows.

use relativity_render::Gaze;

use super::card::CardOutline;
use super::orientation::Orientation;
use crate::settings::Head;

/// Steepest gaze by dragging, radians.
const STEEPEST: f64 = 1.4;

/// A stereoscope while it is shown.
#[derive(Debug)]
pub struct Stereoscope {
    /// Page that is shown.
    pub page: StereoscopePage,
    /// Gaze that is straight before the viewer: towards what the views showed.
    pub ahead: Gaze,
    /// Orientation of the device, if it reports one.
    pub device: Option<Orientation>,
    /// Angle from the device's axes to those of the scene, to the left, radians; unset until the device is
    /// held towards what is ahead.
    pub heading: Option<f64>,
}

/// The page of a stereoscope.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StereoscopePage {
    /// The pictures alone.
    Pictures,
    /// The menu over the pictures.
    Menu,
    /// The card by which the screen is measured.
    Card(CardOutline),
}

impl Stereoscope {
    /// The stereoscope that is entered with the views' `gaze`.
    #[must_use]
    pub const fn new(gaze: Gaze) -> Self {
        Self { page: StereoscopePage::Menu, ahead: gaze, device: None, heading: None }
    }

    /// Returns the head before the screen, in the scene's axes.
    pub fn head(&mut self) -> Head {
        let Some(device) = self.device else { return Head::level(self.ahead) };
        let head = device.head();
        let heading = *self.heading.get_or_insert_with(|| self.ahead.azimuth - head.gaze().azimuth);
        head.turned(heading)
    }

    /// Has the device, as it is held, look as far aside as `gaze` does.
    pub const fn look_along(&mut self, gaze: Gaze) {
        (self.ahead, self.heading) = (gaze, None);
    }

    /// Turns the head to the left and up, by angles in radians: up only where the device reports no
    /// orientation.
    pub fn turn(&mut self, [left, up]: [f64; 2]) {
        if let Some(heading) = &mut self.heading {
            *heading += left;
        } else {
            let Gaze { azimuth, elevation } = self.ahead;
            self.ahead =
                Gaze { azimuth: azimuth + left, elevation: (elevation + up).clamp(-STEEPEST, STEEPEST) };
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;

    fn azimuth(stereoscope: &mut Stereoscope) -> f64 {
        stereoscope.head().gaze().azimuth
    }

    #[test]
    fn what_is_ahead_is_where_the_device_was_held_first_or_at_a_tap() {
        let upright = |alpha| Orientation::from_degrees([alpha, 90.0, 0.0, 0.0]);
        let mut stereoscope = Stereoscope::new(Gaze { azimuth: 1.2, elevation: 0.3 });
        assert!((azimuth(&mut stereoscope) - 1.2).abs() < 1e-12);
        stereoscope.device = upright(200.0);
        let head = stereoscope.head().gaze();
        assert!((head.azimuth - 1.2).abs() < 1e-12 && head.elevation.abs() < 1e-12);
        // To the left by a right angle.
        stereoscope.device = upright(290.0);
        assert!((azimuth(&mut stereoscope) - 1.2 - FRAC_PI_2).abs() < 1e-12);
        stereoscope.look_along(Gaze { azimuth: 0.5, elevation: 0.1 });
        assert!((azimuth(&mut stereoscope) - 0.5).abs() < 1e-12);
        stereoscope.turn([0.25, 1.0]);
        let head = stereoscope.head().gaze();
        assert!((head.azimuth - 0.75).abs() < 1e-12 && head.elevation.abs() < 1e-12);
    }

    #[test]
    fn a_finger_turns_the_head_where_the_device_does_not_tell() {
        let mut stereoscope = Stereoscope::new(Gaze::STRAIGHT_AHEAD);
        stereoscope.turn([0.2, 9.0]);
        let head = stereoscope.head().gaze();
        assert!((head.azimuth - FRAC_PI_2 - 0.2).abs() < 1e-12 && (head.elevation - STEEPEST).abs() < 1e-12);
    }
}

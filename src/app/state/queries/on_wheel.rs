//! Points of turning wheels: their place on the wheel, and their motion there.

use std::f64::consts::{PI, TAU};

use relativity_core::Source;
use relativity_render::{Geometry, View};

use crate::app::state::State;
use crate::number_text;
use crate::scene::Track;

/// The place of a point on its wheel at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OnWheel {
    /// Distance from the axle, in parts of the radius on which the wheel rolls.
    pub share: f64,
    /// Angle of the point, from +x (0) over the top (pi/2): radians, from 0 to below a turn.
    pub angle: f64,
    /// Speed about the axle, in the frame in which that rests.
    pub turning: f64,
    /// Speed on the ground.
    pub on_ground: f64,
}

impl OnWheel {
    /// The share in words.
    #[must_use]
    pub fn share_text(&self) -> String {
        format!("{} of its radius from the axle", number_text::fixed(self.share, 2))
    }
}

/// The angle of a point of a wheel, in words.
#[must_use]
pub fn angle_text(angle: f64) -> String {
    number_text::fixed(angle.to_degrees(), 1) + "°"
}

impl State {
    /// Returns the place on its wheel of the point at `track` when the clocks of its group show
    /// `proper_time`; `None` if it does not turn.
    #[must_use]
    pub fn on_wheel(&self, track: &Track, proper_time: f64) -> Option<OnWheel> {
        let velocity = self.document.settings.velocity(track.motion);
        let Source::Wheel(wheel) = velocity.reflected_source(track.point()) else { return None };
        let reflected = wheel.angle_at(&velocity.speed, proper_time);
        let angle = if velocity.is_backward { PI - reflected } else { reflected };
        Some(OnWheel {
            share: wheel.rho,
            angle: angle.rem_euclid(TAU),
            turning: wheel.omega(&velocity.speed).abs() * wheel.rho * wheel.radius,
            on_ground: wheel.speed_on_ground(&velocity.speed, reflected),
        })
    }

    /// Place of a point on its wheel as `view` shows it.
    #[must_use]
    pub fn on_wheel_in(&self, track: &Track, view: &View) -> Option<OnWheel> {
        let group = view.of_group(track.motion);
        self.on_wheel(track, group.time_at(group.place_when_shown(track.point())))
    }

    /// Describes the point at `track` where `view` shows it, if it turns: a line for each remark.
    #[must_use]
    pub fn wheel_texts(&self, track: &Track, view: &View) -> Vec<String> {
        let Some(wheel) = self.on_wheel_in(track, view) else { return Vec::new() };
        let speed = |speed| number_text::fixed(speed, 2);
        let at = format!("on the wheel {}, at {}", wheel.share_text(), angle_text(wheel.angle));
        let turning = format!("turning at {} c", speed(wheel.turning));
        if view.geometry == Geometry::Rest {
            return vec![at, turning];
        }
        vec![at, format!("{turning}, on the ground at {} c", speed(wheel.on_ground))]
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use relativity_core::Turning;
    use relativity_render::{Motion, Spin, Velocity};

    use super::*;
    use crate::settings::Settings;

    /// On the ground the lowest point of a wheel that rolls rests, the highest has the speed of the axle
    /// twice over, and the one in front moves down as fast as forward in the axle's frame.
    #[test]
    fn speeds_are_added_as_velocities_are() {
        let state = State::open(Settings::default()).expect("a preset");
        for (beta, sign) in [(0.9, 1.0), (-0.9, -1.0)] {
            let velocity = Velocity::from_beta(beta).expect("in range");
            let spin = Spin { hub: [5.0, 3.0, 2.0], radius: 0.5, turning: Turning::Rolling };
            let at = |angle: f64| {
                let (sine, cosine) = angle.sin_cos();
                let rest = [5.0 + 0.5 * cosine, 3.0, 2.0 + 0.5 * sine];
                let track = Track { rest, motion: Motion::Own(velocity), spin: Some(spin) };
                let start = state.on_wheel(&track, 0.0).expect("it turns");
                // A quarter of a turn later.
                let later = state.on_wheel(&track, FRAC_PI_2 * 0.5 / 0.9).expect("it turns");
                let turned = (later.angle - start.angle + sign * FRAC_PI_2 + PI).rem_euclid(TAU) - PI;
                assert!(turned.abs() < 1e-12, "{turned}");
                assert!((start.share - 1.0).abs() < 1e-12 && (start.turning - 0.9).abs() < 1e-12);
                start.on_ground
            };
            assert!(at(-FRAC_PI_2) < 1e-12);
            assert!((at(FRAC_PI_2) - 1.8 / 1.81).abs() < 1e-12);
            let front = (0.81 + 0.81 * 0.19_f64).sqrt();
            assert!((at(0.0) - front).abs() < 1e-12);
        }
    }
}

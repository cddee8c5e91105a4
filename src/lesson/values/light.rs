//! Values of the light that is received: its colour and its brightness.

use relativity_core::doppler::{intensity_factor, received_wavelength};
use relativity_core::{Speed, math, observation_time_when_seen_at};

use super::here::{Here, Value, value};

/// Values of the received light.
pub const VALUES: &[Value] = &[
    value(
        "received_nm",
        "wavelength that the left eye receives of its light of one wavelength, nm",
        |here| Some(received_wavelength(here.rest_nm()?, here.left()?.doppler_factor)),
    ),
    value(
        "received_kelvin",
        "temperature of the glow that the left eye receives of it as it glows, K",
        |here| Some(here.settings.light.temperature * here.left()?.doppler_factor),
    ),
    value("T_of_D_1", "when its light is received as it was sent (D = 1)", time_of_unit_doppler),
    value("D_coming", "Doppler factor of what comes straight at the eyes", |here| {
        Some(here.own_speed().head_on_doppler_factor())
    }),
    value("D_going", "Doppler factor of what goes straight away from the eyes", |here| {
        Some(1.0 / here.own_speed().head_on_doppler_factor())
    }),
    value(
        "brightness",
        "how many times as bright as at rest the left eye receives it, by the exponent that is set",
        |here| Some(intensity_factor(here.left()?.doppler_factor, here.exponent()?)),
    ),
    value(
        "coming_to_going",
        "how many times as bright it is received straight ahead of it as straight behind, by that exponent",
        |here| Some(intensity_factor(here.own_speed().head_on_doppler_factor(), 2.0 * here.exponent()?)),
    ),
    value(
        "headlight_angle",
        "arccos beta: half of the angle of the cone, on the ground, that its forward half of light goes into, degrees",
        |here| {
            let speed = here.own_speed();
            Some(math::atan2(1.0 / speed.gamma(), speed.beta()).to_degrees())
        },
    ),
];

impl Here<'_> {
    fn own_speed(&self) -> Speed {
        self.settings.velocity(self.track.motion).speed
    }

    /// The wavelength of the body that the point is on, nm.
    fn rest_nm(&self) -> Option<f64> {
        self.scene.bodies.get(self.body?)?.emission.wavelength_nm()
    }

    fn exponent(&self) -> Option<f64> {
        self.settings.light.intensity_exponent.0
    }
}

/// D = 1 is seen at x = -(gamma beta/sqrt(2 (1 + gamma))) rho from an eye that it passes at the distance rho.
fn time_of_unit_doppler(here: &Here) -> Option<f64> {
    let (speed, point, [left, _]) =
        (here.own_speed(), here.settings.carrier(&here.track), here.settings.pair());
    let passing = math::hypot(point.y - left.y, point.z - left.z);
    let lead = speed.gamma() * speed.beta() / (2.0 * (1.0 + speed.gamma())).sqrt();
    observation_time_when_seen_at(&speed, point, -lead * passing, [left; 2]).ok().flatten()
}

//! Values of a wheel that rolls at the speed of the scene.

use std::f64::consts::FRAC_PI_2;

use relativity_core::{SourcePoint, Turning, WheelPoint};

use super::here::{Here, Value, value};

/// Values of a rolling wheel.
pub const VALUES: &[Value] = &[
    value("top_speed", "speed on the ground of the top of a wheel that rolls, c", |here| {
        Some(top_speed(here))
    }),
    value("D_top", "Doppler factor of the top of a wheel that rolls, where that is seen abeam", |here| {
        let speed = here.settings.speed();
        Some(speed.inverse_gamma_squared() / (1.0 + speed.beta() * speed.beta()))
    }),
];

fn top_speed(here: &Here) -> f64 {
    let hub = SourcePoint { x0: 0.0, y: 0.0, z: 0.0 };
    let top = WheelPoint { hub, radius: 1.0, rho: 1.0, angle: FRAC_PI_2, turning: Turning::Rolling };
    top.speed_on_ground(&here.settings.speed(), top.angle)
}

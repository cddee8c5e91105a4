//! Values of a single eye, and of the speed.

use relativity_core::math;

use super::here::{Value, value};

/// Values of what one eye sees.
pub const VALUES: &[Value] = &[
    value("beta", "speed of the scene, c", |here| Some(here.settings.speed().beta())),
    value("gamma", "its Lorentz factor", |here| Some(here.settings.speed().gamma())),
    value("contraction", "1/gamma: measured length over length at rest", |here| {
        Some(1.0 / here.settings.speed().gamma())
    }),
    value("turn", "arcsin beta, by which what is small or far abeam looks turned, degrees", |here| {
        Some(math::asin(here.settings.speed().beta()).to_degrees())
    }),
    value("rapidity", "artanh beta, by which motion slides a conformal picture", |here| {
        Some(here.settings.speed().rapidity())
    }),
    value(
        "u",
        "where the left eye sees it along the motion in a conformal picture: artanh of the cosine of the angle from +x",
        |here| {
            let [x, y, z] = here.left()?.position;
            Some(math::asinh(x / math::hypot(y, z))).filter(|u| u.is_finite())
        },
    ),
    value("T", "when light is received", |here| Some(here.time)),
    value("t", "when what the left eye sees happened, by the ground's clocks", |here| {
        Some(here.left()?.retarded_time)
    }),
    value("tau", "what its own clock showed then", |here| Some(here.left()?.proper_time)),
    value("delay", "how long that light was on its way", |here| Some(here.time - here.left()?.retarded_time)),
    value("D", "Doppler factor at the left eye: received over rest frequency", |here| {
        Some(here.left()?.doppler_factor)
    }),
];

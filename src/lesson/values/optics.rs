//! Values of a single eye, and of the speed.

use relativity_core::math;

use super::here::Value;

/// Values of what one eye sees.
pub const VALUES: &[Value] = &[
    Value {
        name: "beta",
        what: "speed of the scene, c",
        work_out: |here| Some(here.settings.speed().beta()),
    },
    Value { name: "gamma", what: "its Lorentz factor", work_out: |here| Some(here.settings.speed().gamma()) },
    Value {
        name: "contraction",
        what: "1/gamma: measured length over length at rest",
        work_out: |here| Some(1.0 / here.settings.speed().gamma()),
    },
    Value {
        name: "turn",
        what: "arcsin beta, by which what is small or far abeam looks turned, degrees",
        work_out: |here| Some(math::asin(here.settings.speed().beta()).to_degrees()),
    },
    Value {
        name: "rapidity",
        what: "artanh beta, by which motion slides a conformal picture",
        work_out: |here| Some(here.settings.speed().rapidity()),
    },
    Value {
        name: "u",
        what: "where the left eye sees it along the motion in a conformal picture: artanh of the cosine of the angle from +x",
        work_out: |here| {
            let [x, y, z] = here.left()?.position;
            Some(math::asinh(x / math::hypot(y, z))).filter(|u| u.is_finite())
        },
    },
    Value { name: "T", what: "when light is received", work_out: |here| Some(here.time) },
    Value {
        name: "t",
        what: "when what the left eye sees happened, by the ground's clocks",
        work_out: |here| Some(here.left()?.retarded_time),
    },
    Value {
        name: "tau",
        what: "what its own clock showed then",
        work_out: |here| Some(here.left()?.proper_time),
    },
    Value {
        name: "delay",
        what: "how long that light was on its way",
        work_out: |here| Some(here.time - here.left()?.retarded_time),
    },
    Value {
        name: "D",
        what: "Doppler factor at the left eye: received over rest frequency",
        work_out: |here| Some(here.left()?.doppler_factor),
    },
];

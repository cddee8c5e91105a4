//! Values of a wheel that rolls at the speed of the scene.

use super::here::{Here, Value};

/// Values of a rolling wheel.
pub const VALUES: &[Value] = &[
    Value {
        name: "top_speed",
        what: "speed on the ground of the top of a wheel that rolls, c",
        work_out: |here| Some(top_speed(here)),
    },
    Value {
        name: "D_top",
        what: "Doppler factor of the top of a wheel that rolls, where that is seen abeam",
        work_out: |here| {
            let beta = here.settings.speed().beta();
            Some((1.0 - beta) * (1.0 + beta) / (1.0 + beta * beta))
        },
    },
];

/// In its own frame the rim turns with the speed of the scene.
fn top_speed(here: &Here) -> f64 {
    let beta = here.settings.speed().beta();
    2.0 * beta / (1.0 + beta * beta)
}

//! Inputs over the whole range of use, drawn towards trouble.

use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use crate::model::Parameter;
use relativity_core::Speed;

/// `10^u`, u uniform between the exponents.
pub fn log_uniform(rng: &mut ChaCha8Rng, low: f64, high: f64) -> f64 {
    10_f64.powf(rng.random_range(low..high))
}

fn signed(rng: &mut ChaCha8Rng, magnitude: f64) -> f64 {
    if rng.random() { magnitude } else { -magnitude }
}

/// A length with sign, 1e-4 to 1e6 in magnitude, sometimes far smaller or zero.
pub fn length(rng: &mut ChaCha8Rng) -> f64 {
    let magnitude = match rng.random_range(0..10) {
        0 => 0.0,
        1 => log_uniform(rng, -16.0, -4.0),
        _ => log_uniform(rng, -4.0, 6.0),
    };
    signed(rng, magnitude)
}

/// A length with sign, 1e-4 to 1e6 in magnitude, or zero: no product of two underflows in f32.
pub fn ordinary_length(rng: &mut ChaCha8Rng) -> f64 {
    let length = length(rng);
    if length.abs() < 1e-4 { 0.0 } else { length }
}

/// A length with sign, 1e-4 to 1e6 in magnitude.
pub fn nonzero_length(rng: &mut ChaCha8Rng) -> f64 {
    let magnitude = log_uniform(rng, -4.0, 6.0);
    signed(rng, magnitude)
}

/// A speed: beta from 1e-14 to 1 - 1e-15, gamma from 1 + 1e-15 to 1e12, rapidity from 1e-14 to 30.
pub fn speed(rng: &mut ChaCha8Rng) -> (Parameter, f64) {
    match rng.random_range(0..6) {
        0 => (Parameter::Beta, log_uniform(rng, -14.0, -0.001)),
        1 => (Parameter::Beta, 1.0 - log_uniform(rng, -15.0, -0.1)),
        2 => (Parameter::Gamma, 1.0 + log_uniform(rng, -15.0, 1.0)),
        3 => (Parameter::Gamma, log_uniform(rng, 0.001, 12.0)),
        4 => (Parameter::Rapidity, log_uniform(rng, -14.0, 0.0)),
        _ => (Parameter::Rapidity, rng.random_range(0.1..30.0)),
    }
}

/// A speed for f32: gamma up to 1e3.
pub fn slower_speed(rng: &mut ChaCha8Rng) -> (Parameter, f64) {
    match rng.random_range(0..4) {
        0 => (Parameter::Beta, log_uniform(rng, -14.0, -0.001)),
        1 => (Parameter::Beta, 1.0 - log_uniform(rng, -6.0, -0.1)),
        2 => (Parameter::Gamma, 1.0 + log_uniform(rng, -3.0, 2.99)),
        _ => (Parameter::Rapidity, log_uniform(rng, -3.0, 0.87)),
    }
}

/// The program's speed for a parameter.
pub fn program_speed(parameter: Parameter, value: f64) -> Speed {
    match parameter {
        Parameter::Beta => Speed::from_beta(value),
        Parameter::Gamma => Speed::from_gamma(value),
        Parameter::Rapidity => Speed::from_rapidity(value),
    }
    .expect("drawn inside the range")
}

/// `value` times 1 + delta, delta from `smallest` to 1.
pub fn near(rng: &mut ChaCha8Rng, value: f64, smallest: f64) -> f64 {
    let delta = log_uniform(rng, smallest.log10(), 0.0);
    value * (1.0 + signed(rng, delta))
}

/// An observation time for a point at `s0` (from the aperture, at t = 0), `y` and `rho` off the axis:
/// anything up to 1e10, or close to S = 0, or to X = 0 (which is T0 for a pair, nearly).
///
/// Close to the x-z plane phi jumps where X changes sign; there the time keeps 16 roundings away, since
/// fewer decide on which side of the jump the point is. With y = 0 it is not aimed at all.
pub fn time(rng: &mut ChaCha8Rng, beta: f64, [s0, y, rho]: [f64; 3], unit_roundoff: f64) -> f64 {
    let special = match rng.random_range(0..4) {
        _ if y == 0.0 => 0.0,
        0 => -s0 / beta,
        1 => rho - s0 / beta,
        _ => 0.0,
    };
    let is_jump = y.abs() < 1e-3 * (s0.abs() + rho);
    let time = near(rng, special, if is_jump { 16.0 * unit_roundoff } else { 1e-17 });
    if special != 0.0 && time.abs() <= 1e10 {
        return time;
    }
    let magnitude = log_uniform(rng, -4.0, 10.0);
    signed(rng, magnitude)
}

/// A separation of the apertures: a length, or from 1e-12 times `scale` up.
pub fn separation(rng: &mut ChaCha8Rng, scale: f64) -> f64 {
    if rng.random() || scale == 0.0 {
        log_uniform(rng, -4.0, 6.0)
    } else {
        scale * log_uniform(rng, -12.0, 0.0)
    }
}

/// A time for a point at `x0` that passes through a pair of apertures `d` apart: within an aperture, or close
/// to it.
pub fn time_inside(rng: &mut ChaCha8Rng, beta: f64, x0: f64, d: f64) -> f64 {
    let aperture = signed(rng, d / 2.0);
    let time = near(rng, (aperture - x0) / beta, 1e-17);
    if time.abs() <= 1e10 { time } else { 0.0 }
}

/// A direction, uniform or close to the axis; a unit vector as far as rounding allows.
pub fn direction(rng: &mut ChaCha8Rng, critical: f64) -> [f64; 3] {
    let cosine: f64 = match rng.random_range(0..3) {
        0 => rng.random_range(-1.0..1.0),
        1 => near(rng, critical, 1e-17).clamp(-1.0, 1.0),
        _ => signed(rng, 1.0),
    };
    let sine =
        if cosine.abs() == 1.0 { log_uniform(rng, -18.0, -1.0) } else { (1.0 - cosine * cosine).sqrt() };
    let (sin, cos) = rng.random_range(0.0..std::f64::consts::TAU).sin_cos();
    let x = if cosine.abs() == 1.0 { cosine * (1.0 - sine * sine).sqrt() } else { cosine };
    [x, sine * cos, sine * sin]
}

/// From one aperture to another, `d` or less away: in any direction but along the motion, which has cases of
/// its own; across it, or close to a direction along or across it.
pub fn baseline(rng: &mut ChaCha8Rng, d: f64) -> [f64; 3] {
    let part = |rng: &mut ChaCha8Rng| {
        let size = match rng.random_range(0..8) {
            0 => 0.0,
            1 => log_uniform(rng, -12.0, 0.0),
            _ => rng.random_range(0.1..1.0),
        };
        signed(rng, d * size)
    };
    let [x, y, z] = [part(rng), part(rng), part(rng)];
    if [y, z] == [0.0; 2] { [x, d, 0.0] } else { [x, y, z] }
}

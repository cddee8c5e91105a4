//! Points of rolling wheels.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use rand::RngExt as _;
use rand_chacha::ChaCha8Rng;
use relativity_core::{
    Aperture, MAX_ERROR_UNITS, SourcePoint, Speed, Turning, WheelPoint, disparity, sighting,
};

use crate::draw::{self, log_uniform, near, program_speed};
use crate::model::Parameter;
use crate::tally::Tally;
use crate::wheel_model::{self, Start};
use crate::{aperture_at, case, cases};

/// A speed at which a wheel can roll: beta from 0.01 to 1 - 1e-9.
fn rolling_speed(rng: &mut ChaCha8Rng) -> (Parameter, f64) {
    match rng.random_range(0..4) {
        0 => (Parameter::Beta, log_uniform(rng, -2.0, -0.001)),
        1 => (Parameter::Beta, 1.0 - log_uniform(rng, -9.0, -0.1)),
        2 => (Parameter::Gamma, log_uniform(rng, 0.01, 4.3)),
        _ => (Parameter::Rapidity, rng.random_range(0.01..10.0)),
    }
}

/// From the axle to the rim, and both.
fn rho(rng: &mut ChaCha8Rng) -> f64 {
    match rng.random_range(0..6) {
        0 => 0.0,
        1 | 2 => 1.0,
        3 => 1.0 - log_uniform(rng, -12.0, 0.0),
        _ => rng.random_range(0.0..1.0),
    }
}

pub fn wheel_at(inputs: &[f64]) -> WheelPoint {
    let &[_, x0, y, z, radius, rho, angle, ..] = inputs else { unreachable!("there are enough inputs") };
    WheelPoint { hub: SourcePoint { x0, y, z }, radius, rho, angle, turning: Turning::Rolling }
}

/// Speed parameter, x0, y, z of the hub, W, rho, angle, aperture x, y, z, T: the wheel is seen within some
/// turns of t' = 0, often on the road or at the top.
pub fn wheel_inputs(rng: &mut ChaCha8Rng) -> (Parameter, Speed, Vec<f64>) {
    let (parameter, value) = rolling_speed(rng);
    let speed = program_speed(parameter, value);
    let radius = log_uniform(rng, -2.0, 2.0);
    let rho = rho(rng);
    let angle = match rng.random_range(0..4) {
        0 => FRAC_PI_2 * f64::from(rng.random_range(-2_i32..3)),
        _ => rng.random_range(-PI..PI),
    };
    let mut length = || {
        let size = if rng.random_range(0..8) == 0 { 0.0 } else { log_uniform(rng, -2.0, 3.0) };
        if rng.random() { radius * size } else { -radius * size }
    };
    let [x0, y, z, ax, ay, az] = std::array::from_fn(|_| length());
    let omega = speed.beta() / radius;
    let turned = match rng.random_range(0..4) {
        // On the road, or at the top.
        0 => near(rng, angle + FRAC_PI_2, 1e-17),
        1 => near(rng, angle - FRAC_PI_2, 1e-17),
        _ => rng.random_range(-3.0 * TAU..3.0 * TAU),
    };
    let own = turned / omega;
    let (sine, cosine) = (angle - turned).sin_cos();
    let rest_x = speed.gamma() * x0 + rho * radius * cosine;
    let [x, t] = [rest_x + speed.beta() * own, own + speed.beta() * rest_x].map(|sum| speed.gamma() * sum);
    let distance = (x - ax).hypot(y - ay).hypot(z + rho * radius * sine - az);
    (parameter, speed, vec![value, x0, y, z, radius, rho, angle, ax, ay, az, t + distance])
}

#[test]
fn points_of_wheels_are_seen_as_accurately_as_their_inputs() {
    let names =
        ["wheel X", "wheel z", "wheel t", "wheel tau", "wheel R", "wheel D", "wheel phi", "wheel theta"];
    Tally::new(names, cases() / 4, |rng| {
        let (parameter, speed, inputs) = wheel_inputs(rng);
        let seen = sighting(&speed, wheel_at(&inputs), aperture_at(&inputs[7..]), inputs[10])
            .expect("inside the domain");
        let computed = [
            seen.position[0],
            seen.position[2],
            seen.retarded_time,
            seen.proper_time,
            seen.distance,
            seen.doppler_factor,
            seen.phi(),
            seen.theta(),
        ];
        let start = Start::default();
        case(parameter, inputs, |inputs| wheel_model::sighting(parameter, inputs, &start), computed)
    })
    .assert_within(MAX_ERROR_UNITS)
    .assert_as_documented(include_str!("../../src/wheel/mod.rs"), &names);
}

#[test]
fn disparities_of_points_of_wheels_keep_their_digits_however_close_the_apertures() {
    Tally::new(["wheel dphi", "wheel dtheta"], cases() / 4, |rng| {
        let (parameter, speed, mut inputs) = wheel_inputs(rng);
        let scale = log_uniform(rng, -12.0, 0.0);
        let secondary: Vec<f64> = inputs[7..10].iter().map(|a| a + scale * draw::length(rng)).collect();
        let [left, right]: [Aperture; 2] = [aperture_at(&inputs[7..]), aperture_at(&secondary)];
        let both = disparity(&speed, wheel_at(&inputs), left, right, inputs[10]).expect("inside the domain");
        inputs.extend(secondary);
        let starts = [Start::default(), Start::default()];
        let model = |inputs: &[_]| wheel_model::disparity(parameter, inputs, &starts);
        case(parameter, inputs, model, [both.dphi, both.dtheta])
    })
    .assert_within(MAX_ERROR_UNITS)
    .assert_as_documented(include_str!("../../src/wheel/mod.rs"), &["wheel dphi", "wheel dtheta"]);
}

//! Events along x in another frame, clocks on their worldlines, and the speed of a wheel's point on the ground.

use dashu_float::ops::Abs as _;
use rand::RngExt as _;
use rand_chacha::ChaCha8Rng;
use relativity_core::{Boost, Event, MAX_ERROR_UNITS, Speed, Worldline};

use crate::arithmetic::{Big, big, sqrt, square};
use crate::draw::{self, log_uniform, near, program_speed};
use crate::model::{self, Parameter};
use crate::tally::Tally;
use crate::wheel::{wheel_at, wheel_inputs};
use crate::{case, cases};

/// Speed parameter, x, t: often near the light that runs along x through the origin.
fn event_inputs(rng: &mut ChaCha8Rng) -> (Parameter, Speed, Vec<f64>) {
    let (parameter, value) = draw::speed(rng);
    let x = draw::length(rng);
    let t = match rng.random_range(0..3) {
        0 => near(rng, x, 1e-17),
        1 => near(rng, -x, 1e-17),
        _ => draw::length(rng),
    };
    (parameter, program_speed(parameter, value), vec![value, x, t])
}

fn boost(speed: Speed, sign: f64) -> Boost {
    Boost { speed, is_backward: sign < 0.0 }
}

#[test]
fn events_in_another_frame_keep_their_digits() {
    let names = ["x'", "t'", "t of a step"];
    for sign in [1.0, -1.0] {
        Tally::new(names, cases(), |rng| {
            let (parameter, speed, inputs) = event_inputs(rng);
            let [x, t] = [inputs[1], inputs[2]];
            let there = Event { x, t }.in_frame(boost(speed, sign));
            let step = boost(speed, sign).simultaneous_step(x);
            let model = |inputs: &[Big]| {
                let (beta, gamma) = model::speed(parameter, &inputs[0]);
                let (beta, x, t) = (beta * big(sign), &inputs[1], &inputs[2]);
                [&gamma * (x - &beta * t), &gamma * (t - &beta * x), gamma * beta * x]
            };
            case(parameter, inputs, model, [there.x, there.t, step.t])
        })
        .assert_within(MAX_ERROR_UNITS)
        .assert_as_documented(include_str!("../../src/worldline.rs"), &names);
    }
}

/// Speed parameter, x0, t, the clock's time, another x, distance of the line: often as the clock is abreast.
fn clock_inputs(rng: &mut ChaCha8Rng) -> (Parameter, Speed, Vec<f64>) {
    let (parameter, value) = draw::speed(rng);
    let speed = program_speed(parameter, value);
    let [x0, x, aside] = [(); 3].map(|()| draw::length(rng));
    let t = draw::time(rng, speed.beta(), [x0, 1.0, aside.abs()], f64::EPSILON / 2.0);
    let proper_time = draw::length(rng);
    (parameter, speed, vec![value, x0, t, proper_time, x, aside])
}

#[test]
fn clocks_on_worldlines_keep_their_digits() {
    let names = ["x", "tau", "x at tau", "t at tau", "T of reception", "t at x", "t at once"];
    for sign in [1.0, -1.0] {
        Tally::new(names, cases(), |rng| {
            let (parameter, speed, inputs) = clock_inputs(rng);
            let &[_, x0, t, proper_time, x, aside] = &inputs[..] else { unreachable!("there are six") };
            let clock = Worldline::new(boost(speed, sign), x0);
            let shown = clock.at_proper_time(proper_time);
            let computed = [
                clock.at(t).x,
                clock.proper_time(t),
                shown.x,
                shown.t,
                clock.reception(t, aside),
                clock.time_at(x).expect("it moves"),
                Event { x: x0, t }.simultaneous_at(x, boost(speed, sign)).t,
            ];
            let model = |inputs: &[Big]| {
                let (beta, gamma) = model::speed(parameter, &inputs[0]);
                let beta = beta * big(sign);
                let [_, x0, t, proper_time, x, aside] = inputs else { unreachable!("there are six") };
                let place = x0 + &beta * t;
                let shown = &gamma * (proper_time + &gamma * &beta * x0);
                [
                    place.clone(),
                    &gamma * (t - &beta * &place),
                    x0 + &beta * &shown,
                    shown,
                    t + sqrt(&(square(&place) + square(aside))),
                    (x - x0) / &beta,
                    t + beta * (x - x0),
                ]
            };
            case(parameter, inputs, model, computed)
        })
        .assert_within(MAX_ERROR_UNITS)
        .assert_as_documented(include_str!("../../src/worldline.rs"), &names);
    }
}

/// The velocity in the moving frame and that of the frame compose; the lowest point, which rests, included.
#[test]
fn speeds_of_points_of_wheels_on_the_ground_keep_their_digits() {
    let names = ["speed on the ground"];
    Tally::new(names, cases(), |rng| {
        let (_, _, wheel) = wheel_inputs(rng);
        let (parameter, value) = draw::speed(rng);
        let angle = match rng.random_range(0..3) {
            0 => near(rng, -std::f64::consts::FRAC_PI_2, 1e-17),
            1 => -std::f64::consts::FRAC_PI_2 + log_uniform(rng, -9.0, 0.0),
            _ => wheel[6],
        };
        let computed = wheel_at(&wheel).speed_on_ground(&program_speed(parameter, value), angle);
        let model = |inputs: &[Big]| {
            let (beta, gamma) = model::speed(parameter, &inputs[0]);
            let (sine, cosine) = inputs[2].sin_cos();
            let own = &beta * &inputs[1];
            let added = big(1.0) + &beta * &own * &sine;
            let along = &beta + &own * sine;
            let up = own * cosine / gamma;
            [(sqrt(&(square(&along) + square(&up))) / added).abs()]
        };
        case(parameter, vec![value, wheel[5], angle], model, [computed])
    })
    .assert_within(MAX_ERROR_UNITS)
    .assert_as_documented(include_str!("../../src/wheel/events.rs"), &names);
}

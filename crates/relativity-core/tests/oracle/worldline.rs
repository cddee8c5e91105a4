//! Events along x in another frame, clocks on their worldlines, and the speed of a wheel's point on the
//! ground.

use dashu_float::ops::Abs as _;
use rand::RngExt as _;
use rand_chacha::ChaCha8Rng;
use relativity_core::{Boost, Event, MAX_ERROR_UNITS, Reception, Speed, Worldline};

use crate::arithmetic::{Big, UNIT_F64, big, sqrt, square};
use crate::draw::{self, log_uniform, near, program_speed};
use crate::model::{self, Parameter};
use crate::tally::{Case, Tally};
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

/// Clocks and frames of every speed, each along +x or -x; half of the rapidities of a frame are within
/// roundings of the clock's.
#[test]
fn steps_of_clocks_in_another_frame_keep_their_digits() {
    let names = ["x of a tick", "t of a tick"];
    for [sign, of_frame] in [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0]] {
        Tally::new(names, cases(), |rng| {
            let (parameter, own) = draw::speed(rng);
            let frame = if parameter == Parameter::Rapidity && rng.random() {
                near(rng, own, 1e-17).clamp(0.0, 30.0)
            } else {
                std::iter::repeat_with(|| draw::speed(rng)).find(|other| other.0 == parameter).expect("one").1
            };
            let [clock, moving] = [(own, sign), (frame, of_frame)]
                .map(|(rapidity, sign)| boost(program_speed(parameter, rapidity), sign));
            let step = clock.unit_step_in(moving);
            let model = |inputs: &[Big]| {
                let [own, frame] = [0, 1].map(|i| model::speed(parameter, &inputs[i]));
                let (beta, against) = (own.0 * big(sign), frame.0 * big(of_frame));
                [&frame.1 * (&beta - &against), frame.1 * (big(1.0) - beta * against)]
            };
            // A rounding of a rapidity is as many of gamma.
            let rapidities = 1.0 + clock.speed.rapidity() + moving.speed.rapidity();
            let Case { errors, parameter, inputs } =
                case(parameter, vec![own, frame], model, [step.x, step.t]);
            Case { errors: errors.map(|units| units / rapidities), parameter, inputs }
        })
        .assert_within(MAX_ERROR_UNITS);
    }
}

/// The place and time of a reception in the frame of the source, and when light left a place there. `inputs`:
/// speed parameter, x, t, and x, y, z of the place in that frame, from the reception's own y and z.
fn reception(parameter: Parameter, inputs: &[Big]) -> [Big; 3] {
    let (beta, gamma) = model::speed(parameter, &inputs[0]);
    let [_, x, t, place, y, z] = inputs else { unreachable!("there are six") };
    let [there_x, there_t] = [&gamma * (x - &beta * t), &gamma * (t - &beta * x)];
    let away = place - &there_x;
    let distance = sqrt(&(square(&away) + square(y) + square(z)));
    [there_x, there_t.clone(), there_t - distance]
}

/// Often of a place beside the event, or of an event near a light ray through the origin.
#[test]
fn receptions_in_the_frame_of_the_source_keep_their_digits() {
    let names = ["x' of a reception", "t' of a reception", "t' of emission"];
    Tally::new(names, cases(), |rng| {
        let (parameter, speed, mut inputs) = event_inputs(rng);
        let [x, t] = [inputs[1], inputs[2]];
        let there = Reception::new(Event { x, t }, &speed);
        let [beside, y, z] = [(); 3].map(|()| draw::length(rng));
        let place = if rng.random() { beside } else { there.event().x + beside };
        inputs.extend([place, y, z]);
        let Event { x: there_x, t: there_t } = there.event();
        let emission = there.emission_time(place, [y, z]);
        let exact = reception(parameter, &inputs.iter().map(|&input| big(input)).collect::<Vec<_>>());
        let unit = UNIT_F64 * (speed.gamma() * (x.abs() + t.abs()) + place.abs() + y.abs() + z.abs());
        let off = (big(emission) - &exact[2]).abs().to_f64().value();
        let model = |inputs: &[Big]| reception(parameter, inputs);
        let Case { errors: [x, t, _], parameter, inputs } =
            case(parameter, inputs, model, [there_x, there_t, emission]);
        Case { errors: [x, t, if off == 0.0 { 0.0 } else { off / unit }], parameter, inputs }
    })
    .assert_within(MAX_ERROR_UNITS);
}

#[test]
fn times_of_emission_keep_their_digits_long_after_a_passage() {
    let names = ["t' of emission long ago"];
    Tally::new(names, cases(), |rng| {
        let (parameter, value) = draw::speed(rng);
        let eye = rng.random_range(-1.0..1.0);
        let time = log_uniform(rng, 2.0, 10.0);
        let [x, y, z] = [(); 3].map(|()| rng.random_range(-10.0..10.0));
        let there = Reception::new(Event { x: eye, t: time }, &program_speed(parameter, value));
        let model = |inputs: &[Big]| {
            let [.., emission] = reception(parameter, inputs);
            [emission]
        };
        case(parameter, vec![value, eye, time, x, y, z], model, [there.emission_time(x, [y, z])])
    })
    .assert_within(MAX_ERROR_UNITS);
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
    let names = [
        "x",
        "tau",
        "x at tau",
        "t at tau",
        "T of reception",
        "t at x",
        "t at once",
        "rest distance",
        "tau at rest x",
    ];
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
                clock.rest_distance_from(Event { x, t }),
                boost(speed, sign).clock_reading(x, t),
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
                    t + &beta * (x - x0),
                    &gamma * (place - x),
                    t / &gamma - beta * x,
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

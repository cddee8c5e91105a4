//! Views of moving eyes, by the light cone on the ground and a Lorentz transformation of what is found there.

use rand::RngExt as _;
use rand_chacha::ChaCha8Rng;
use relativity_core::{
    Aperture, Boost, Disparity, MAX_ERROR_UNITS, Model, Observer, ObserverVelocity, Stereo, Worldline,
};

use crate::arithmetic::{Big, big, sqrt, square};
use crate::draw::{self, program_speed};
use crate::model::{self, Parameter, View, difference, dot};
use crate::tally::Tally;
use crate::wheel_model::{Sight, Start, Wheel};
use crate::{aperture_at, case, cases, point_at, wheel};

/// t where the eyes' own offset on the ground, Gamma V d, dwarfs it.
const MAX_TIME_UNITS: f64 = 256.0;
/// D of a point of a wheel: a product of three factors.
const MAX_WHEEL_DOPPLER_UNITS: f64 = 16.0;
/// dphi and dtheta of a point of a wheel, from places that are transformed one by one.
const MAX_WHEEL_DISPARITY_UNITS: f64 = 1e4;
/// The Lorentz factor of wheels and of those who ride past them, up to which that holds.
const MAX_WHEEL_GAMMA: f64 = 10.0;

/// The velocity of an observer: its size V, Gamma and its direction.
struct Velocity {
    beta: Big,
    gamma: Big,
    direction: [Big; 3],
}

impl Velocity {
    /// From speed parameter, azimuth and elevation.
    fn new(parameter: Parameter, inputs: &[Big]) -> Self {
        let (beta, gamma) = model::speed(parameter, &inputs[0]);
        let ([sin_a, cos_a], [sin_e, cos_e]) = (sin_cos(&inputs[1]), sin_cos(&inputs[2]));
        Self { beta, gamma, direction: [&cos_e * cos_a, cos_e * sin_a, sin_e] }
    }

    /// From an event (`place`, `time`) in the observer's frame to the ground, both counted from one event.
    fn on_ground(&self, place: &[Big], time: &Big) -> ([Big; 3], Big) {
        let along = (0..3).map(|i| &place[i] * &self.direction[i]).fold(big(0.0), |sum, part| sum + part);
        let stretch = (&self.gamma - big(1.0)) * &along + &self.gamma * &self.beta * time;
        let there = std::array::from_fn(|i| &place[i] + &stretch * &self.direction[i]);
        (there, &self.gamma * (time + &self.beta * along))
    }

    /// From an event (`place`, `time`) on the ground to the observer's frame.
    fn in_frame(&self, place: &[Big; 3], time: &Big) -> ([Big; 3], Big) {
        let back = Self {
            beta: self.beta.clone(),
            gamma: self.gamma.clone(),
            direction: self.direction.clone().map(|part| -part),
        };
        back.on_ground(place, time)
    }

    /// The line of sight in the observer's frame, of one on the ground.
    fn seen(&self, line: &[Big; 3], distance: &Big) -> [Big; 3] {
        let along = dot(line, &self.direction);
        let stretch = (&self.gamma - big(1.0)) * along + &self.gamma * &self.beta * distance;
        std::array::from_fn(|i| &line[i] + &stretch * &self.direction[i])
    }
}

fn sin_cos(angle: &Big) -> [Big; 2] {
    [angle.sin(), angle.cos()]
}

/// `v` turned about x, y and z in turn by what `by` has beyond 1.
///
/// As inputs of 1 these stand for directions that are known to a rounding: those of the observer's axes, and
/// that of the head.
fn turned([x, y, z]: [Big; 3], by: &[Big]) -> [Big; 3] {
    let about = |a: Big, b: Big, by: &Big| {
        let [sin, cos] = sin_cos(&(by - big(1.0)));
        (&a * &cos - &b * &sin, a * sin + b * cos)
    };
    let (y, z) = about(y, z, &by[0]);
    let (z, x) = about(z, x, &by[1]);
    let (x, y) = about(x, y, &by[2]);
    [x, y, z]
}

/// Place on the ground of an eye at `aperture`, and T there, `observer` being velocity, place, T, both eyes
/// and six of 1.
fn event(velocity: &Velocity, observer: &[Big], aperture: &[Big]) -> ([Big; 3], Big) {
    let aperture = turned(std::array::from_fn(|i| aperture[i].clone()), &observer[13..16]);
    let (offset, later) = velocity.on_ground(&aperture, &big(0.0));
    (std::array::from_fn(|i| &observer[3 + i] + &offset[i]), &observer[6] + later)
}

/// The view `on_ground`, in the observer's frame.
fn in_observer_frame(velocity: &Velocity, observer: &[Big], on_ground: View) -> View {
    let line = [on_ground.x, on_ground.y, on_ground.z];
    let [x, y, z] = turned(velocity.seen(&line, &on_ground.r), &observer[16..19]);
    let r = sqrt(&(square(&x) + square(&y) + square(&z)));
    // Received over sent: a longer way in the observer's frame is a bluer light.
    let doppler = on_ground.doppler * &r / &on_ground.r;
    View { x, y, z, r, t: on_ground.t, doppler }
}

/// The view of an eye: its line of sight, D, t and tau.
fn eye(parameter: Parameter, inputs: &[Big], aperture: &[Big]) -> (View, Big) {
    let speed = model::speed(parameter, &inputs[0]);
    let observer = &inputs[4..];
    let velocity = Velocity::new(parameter, observer);
    let (place, time) = event(&velocity, observer, aperture);
    let on_ground = View::new(&speed, difference(&inputs[1..4], &place), &time);
    let proper_time = on_ground.proper_time(&speed, &inputs[1]);
    (in_observer_frame(&velocity, observer, on_ground), proper_time)
}

/// x, y, z, R, D, phi, theta, tau, t of the left eye, dphi, dtheta.
///
/// `inputs`: speed parameter, x0, y, z, observer's speed parameter, azimuth, elevation, place, T, left and
/// right eye, and six of 1.
fn disparity(parameter: Parameter, inputs: &[Big]) -> [Big; 11] {
    let (left, proper_time) = eye(parameter, inputs, &inputs[11..14]);
    let (right, _) = eye(parameter, inputs, &inputs[14..17]);
    let [dphi, dtheta] = model::angle_differences(&left, &right);
    let (phi, theta) = (left.phi(), left.theta());
    [left.x, left.y, left.z, left.r, left.doppler, phi, theta, proper_time, dphi, dtheta, left.t]
}

/// Gain, place and miss; the place from as far to the left of the left eye as the right one is to its right.
fn stereo(parameter: Parameter, inputs: &[Big]) -> [Big; 5] {
    let line = |aperture: &[Big]| {
        let (View { x, y, z, .. }, _) = eye(parameter, inputs, aperture);
        [x, y, z]
    };
    let (left, right) = (line(&inputs[11..14]), line(&inputs[14..17]));
    let baseline = difference(&inputs[14..17], &inputs[11..14]);
    model::meeting(&left, &right, &turned(baseline, &inputs[17..20]))
}

/// A speed with a Lorentz factor up to 1e6.
fn speed(rng: &mut ChaCha8Rng, parameter: Parameter) -> f64 {
    match parameter {
        Parameter::Beta if rng.random() => draw::log_uniform(rng, -12.0, -0.001),
        Parameter::Beta => 1.0 - draw::log_uniform(rng, -12.0, -0.1),
        Parameter::Gamma => draw::log_uniform(rng, 0.001, 6.0),
        Parameter::Rapidity => rng.random_range(0.1..14.5),
    }
}

/// Along the street, nearly so, or anything.
fn angle(rng: &mut ChaCha8Rng, most: f64) -> f64 {
    match rng.random_range(0..3) {
        0 => 0.0,
        1 => draw::log_uniform(rng, -9.0, 0.0),
        _ => rng.random_range(-most..most),
    }
}

/// The inputs of [`disparity`].
fn inputs(rng: &mut ChaCha8Rng) -> (Parameter, Vec<f64>) {
    let parameter = [Parameter::Beta, Parameter::Gamma, Parameter::Rapidity][rng.random_range(0..3)];
    let object = speed(rng, parameter);
    let mut inputs = vec![object];
    inputs.extend([(); 3].map(|()| draw::nonzero_length(rng)));
    // Sometimes both ride nearly alike.
    let own = if rng.random_range(0..4) == 0 { object } else { speed(rng, parameter) };
    inputs.extend([own, angle(rng, 3.1), angle(rng, 1.5)]);
    inputs.extend([(); 3].map(|()| draw::nonzero_length(rng)));
    let rho = (inputs[2] - inputs[8]).hypot(inputs[3] - inputs[9]);
    let from = [inputs[1] - inputs[7], inputs[2] - inputs[8], rho];
    inputs.push(draw::time(rng, program_speed(parameter, object).beta(), from, crate::UNIT_F64));
    let d = draw::log_uniform(rng, -4.0, 0.0);
    let [x, y, z] = draw::baseline(rng, d).map(|along| along / 2.0);
    let [x, y, z] = if rng.random_range(0..3) == 0 { [d / 2.0, 0.0, 0.0] } else { [x, y, z] };
    inputs.extend([-x, -y, -z, x, y, z]);
    inputs.extend([1.0; 6]);
    (parameter, inputs)
}

/// The observer with these inputs: speed parameter, azimuth, elevation, place, T.
fn observer(parameter: Parameter, inputs: &[f64]) -> Observer {
    let velocity = ObserverVelocity::new(program_speed(parameter, inputs[0]), inputs[1], inputs[2]);
    Observer { velocity, place: [inputs[3], inputs[4], inputs[5]], time: inputs[6] }
}

fn pair(inputs: &[f64]) -> [Aperture; 2] {
    [aperture_at(inputs), aperture_at(&inputs[3..])]
}

const NAMES: [&str; 11] = ["x", "y", "z", "R'", "D", "phi", "theta", "tau", "dphi", "dtheta", "t"];

/// The numbers of [`NAMES`].
fn columns(both: &Disparity) -> [f64; 11] {
    let seen = &both.primary;
    let ([x, y, z], phi, theta) = (seen.position, seen.phi(), seen.theta());
    let [distance, doppler] = [seen.distance, seen.doppler_factor];
    [x, y, z, distance, doppler, phi, theta, seen.proper_time, both.dphi, both.dtheta, seen.retarded_time]
}

#[test]
fn a_moving_eye_sees_as_accurately_as_its_inputs_are_known() {
    let tally = Tally::new(NAMES, cases() / 4, |rng| {
        let (parameter, inputs) = inputs(rng);
        let speed = program_speed(parameter, inputs[0]);
        let seen = observer(parameter, &inputs[4..]).disparity(
            Model::Exact,
            &speed,
            point_at(&inputs[1..]),
            pair(&inputs[11..]),
            0.0,
        );
        let computed = columns(&seen.expect("inside the domain"));
        case(parameter, inputs, |inputs| disparity(parameter, inputs), computed)
    });
    tally.assert_each_within(|name| match name {
        "t" => MAX_TIME_UNITS,
        _ => MAX_ERROR_UNITS,
    });
}

/// The eye is far from the origin, too; its inputs are those of a moving one without the velocity.
#[test]
fn an_eye_at_rest_anywhere_sees_as_accurately_as_its_inputs_are_known() {
    let tally = Tally::new(NAMES, cases() / 4, |rng| {
        let (parameter, mut inputs) = inputs(rng);
        inputs.drain(4..7);
        let speed = program_speed(parameter, inputs[0]);
        let place = [inputs[4], inputs[5], inputs[6]];
        let observer = Observer { velocity: ObserverVelocity::REST, place, time: inputs[7] };
        let seen = observer.disparity(Model::Exact, &speed, point_at(&inputs[1..]), pair(&inputs[8..]), 0.0);
        let rest = big(if matches!(parameter, Parameter::Gamma) { 1.0 } else { 0.0 });
        let model = |inputs: &[Big]| {
            let velocity = [rest.clone(), big(0.0), big(0.0)];
            disparity(parameter, &[&inputs[..4], &velocity, &inputs[4..]].concat())
        };
        case(parameter, inputs, model, columns(&seen.expect("inside the domain")))
    });
    tally.assert_within(MAX_ERROR_UNITS);
}

#[test]
fn the_stereo_position_of_moving_eyes_keeps_its_digits() {
    let names = ["rider's gain", "rider's x", "rider's y", "rider's z", "rider's miss"];
    Tally::new(names, cases() / 4, |rng| {
        loop {
            let (parameter, inputs) = inputs(rng);
            let speed = program_speed(parameter, inputs[0]);
            let pair = pair(&inputs[11..]);
            let fused = observer(parameter, &inputs[4..]).stereo(
                Model::Exact,
                &speed,
                point_at(&inputs[1..]),
                pair,
                0.0,
            );
            // What does not meet is drawn again.
            let Ok(Stereo { gain, position: [x, y, z], miss }) = fused else { continue };
            let Aperture { x: dx, y: dy, z: dz } = pair[1];
            let computed = [gain, x + 3.0 * dx, y + 3.0 * dy, z + 3.0 * dz, miss];
            return case(parameter, inputs, |inputs| stereo(parameter, inputs), computed);
        }
    })
    .assert_within(MAX_ERROR_UNITS);
}

/// A wheel's speed parameter, x0, y, z, W, rho and angle; the observer's velocity, place, T, eyes and six
/// of 1.
fn wheel_inputs(rng: &mut ChaCha8Rng) -> (Parameter, Vec<f64>) {
    let (parameter, wheel) = loop {
        let (parameter, speed, wheel) = wheel::wheel_inputs(rng);
        if speed.gamma() < MAX_WHEEL_GAMMA {
            break (parameter, wheel);
        }
    };
    let own = match parameter {
        Parameter::Beta => draw::log_uniform(rng, -2.0, -0.002),
        Parameter::Gamma => draw::log_uniform(rng, 0.001, MAX_WHEEL_GAMMA.log10()),
        Parameter::Rapidity => rng.random_range(0.01..3.0),
    };
    let [radius, time] = [wheel[4], wheel[10]];
    let mut inputs = wheel[..7].to_vec();
    inputs.extend([own, angle(rng, 3.1), angle(rng, 1.5)]);
    inputs.extend(&wheel[7..10]);
    inputs.push(time);
    let d = radius * draw::log_uniform(rng, -6.0, -1.0);
    let [x, y, z] = draw::baseline(rng, d).map(|along| along / 2.0);
    inputs.extend([-x, -y, -z, x, y, z]);
    inputs.extend([1.0; 6]);
    (parameter, inputs)
}

/// R', D, tau, phi and theta of the left eye, dphi, dtheta; `inputs` as for [`wheel_inputs`].
fn wheel_disparity(parameter: Parameter, inputs: &[Big], starts: &[Start; 2]) -> [Big; 7] {
    let turning = Wheel::new(parameter, inputs);
    let observer = &inputs[7..];
    let velocity = Velocity::new(parameter, observer);
    let seen = |aperture: &[Big], start: &Start| {
        let (place, time) = event(&velocity, observer, aperture);
        let Sight { view, proper_time } = turning.seen(&place, &time, start);
        (in_observer_frame(&velocity, observer, view), proper_time)
    };
    let (left, proper_time) = seen(&observer[7..10], &starts[0]);
    let (right, _) = seen(&observer[10..13], &starts[1]);
    let [dphi, dtheta] = model::angle_differences(&left, &right);
    let (phi, theta) = (left.phi(), left.theta());
    [left.r, left.doppler, proper_time, phi, theta, dphi, dtheta]
}

#[test]
fn a_moving_eye_sees_the_points_of_wheels() {
    let names = ["R'", "D", "tau", "phi", "theta", "dphi", "dtheta"];
    Tally::new(names, cases() / 8, |rng| {
        let (parameter, inputs) = wheel_inputs(rng);
        let speed = program_speed(parameter, inputs[0]);
        let point = wheel::wheel_at(&inputs);
        let both = observer(parameter, &inputs[7..])
            .disparity(Model::Exact, &speed, point, pair(&inputs[14..]), 0.0)
            .expect("inside the domain");
        let seen = both.primary;
        let computed = [
            seen.distance,
            seen.doppler_factor,
            seen.proper_time,
            seen.phi(),
            seen.theta(),
            both.dphi,
            both.dtheta,
        ];
        let starts = [Start::default(), Start::default()];
        case(parameter, inputs, |inputs| wheel_disparity(parameter, inputs, &starts), computed)
    })
    .assert_each_within(|name| match name {
        "D" => MAX_WHEEL_DOPPLER_UNITS,
        "dphi" | "dtheta" => MAX_WHEEL_DISPARITY_UNITS,
        _ => MAX_ERROR_UNITS,
    });
}

/// Speed parameter, azimuth, elevation, place and t of an event, often near the light that leaves the origin;
/// and three of 1.
fn event_inputs(rng: &mut ChaCha8Rng) -> (Parameter, Vec<f64>) {
    let (parameter, value) = draw::speed(rng);
    let place = [(); 3].map(|()| draw::length(rng));
    let distance = place[0].hypot(place[1]).hypot(place[2]);
    let t = match rng.random_range(0..3) {
        0 => draw::near(rng, distance, 1e-17),
        1 => draw::near(rng, -distance, 1e-17),
        _ => draw::length(rng),
    };
    let mut inputs = vec![value, angle(rng, 3.1), angle(rng, 1.5)];
    inputs.extend(place);
    inputs.extend([t, 1.0, 1.0, 1.0]);
    (parameter, inputs)
}

#[test]
fn events_in_a_frame_that_moves_anywhere_keep_their_digits() {
    let names = ["x' of any", "t' of any"];
    Tally::new(names, cases(), |rng| {
        let (parameter, inputs) = event_inputs(rng);
        let velocity = ObserverVelocity::new(program_speed(parameter, inputs[0]), inputs[1], inputs[2]);
        let there = velocity.event_at([inputs[3], inputs[4], inputs[5]], inputs[6]);
        let model = |inputs: &[Big]| {
            let velocity = Velocity::new(parameter, inputs);
            let velocity = Velocity { direction: turned(velocity.direction, &inputs[7..10]), ..velocity };
            let place = std::array::from_fn(|i| inputs[3 + i].clone());
            let ([x, ..], t) = velocity.in_frame(&place, &inputs[6]);
            [x, t]
        };
        case(parameter, inputs, model, [there.x, there.t])
    })
    .assert_within(MAX_ERROR_UNITS)
    .assert_as_documented(include_str!("../../src/observer/velocity.rs"), &names);
}

/// Speed parameter and x0, y and z of a clock, and of an observer as in [`observer`]; and three of 1.
fn clock_inputs(rng: &mut ChaCha8Rng) -> (Parameter, Vec<f64>) {
    let (parameter, mut inputs) = inputs(rng);
    inputs.truncate(11);
    inputs.extend([1.0; 3]);
    (parameter, inputs)
}

#[test]
fn the_present_of_one_who_moves_anywhere_keeps_its_digits() {
    let names = ["t of the present"];
    for sign in [1.0, -1.0] {
        Tally::new(names, cases(), |rng| {
            let (parameter, inputs) = clock_inputs(rng);
            let boost = Boost { speed: program_speed(parameter, inputs[0]), is_backward: sign < 0.0 };
            let time = observer(parameter, &inputs[4..])
                .ground_time_of(&Worldline::new(boost, inputs[1]), [inputs[2], inputs[3]]);
            // t = T + V.(r(t) - o), solved for t.
            let model = |inputs: &[Big]| {
                let (beta, _) = model::speed(parameter, &inputs[0]);
                let velocity = Velocity::new(parameter, &inputs[4..]);
                let direction = turned(velocity.direction, &inputs[11..14]).map(|part| part * &velocity.beta);
                let off = difference(&inputs[1..4], &inputs[7..10]);
                let start = &inputs[10] + dot(&off, &direction);
                [start / (big(1.0) - beta * big(sign) * &direction[0])]
            };
            case(parameter, inputs, model, [time])
        })
        .assert_within(MAX_ERROR_UNITS)
        .assert_as_documented(include_str!("../../src/observer/motion.rs"), &names);
    }
}

//! Every output of the crate against 115-digit arithmetic, over the whole range of use.
//!
//! `GAMOW_ORACLE_CASES` sets the number of cases per test; `-- --nocapture` shows the statistics.

mod arithmetic;
mod batch;
mod conformal;
mod draw;
mod model;
mod observer;
mod printed;
mod tally;
mod wheel;
mod wheel_model;
mod worldline;

use arithmetic::{Big, UNIT_F64, error_units};
use draw::program_speed;
use model::Parameter;
use rand::RngExt as _;
use rand_chacha::ChaCha8Rng;
use relativity_core::aberration::{doppler_factor, ground_from_rest, rest_from_ground};
use relativity_core::doppler::{intensity_factor, received_wavelength};
use relativity_core::{
    Aperture, MAX_ERROR_UNITS, PublishedVariant, SourcePoint, Speed, Stereo, disparity, equidistance_time,
    observation_time_when_seen_at, one_cone_disparity, printed_apparent_x, published_disparity, sighting,
    stereo,
};
use tally::{Case, Tally};

fn cases() -> u64 {
    std::env::var("GAMOW_ORACLE_CASES").map_or(600, |n| n.parse().expect("a number of cases"))
}

/// The case of `inputs`, the true values being those of `model`.
fn case<const N: usize>(
    parameter: Parameter,
    inputs: Vec<f64>,
    model: impl Fn(&[Big]) -> [Big; N],
    computed: [f64; N],
) -> Case<N> {
    let errors = error_units(model, &inputs, computed, UNIT_F64, MAX_ERROR_UNITS);
    Case { errors, parameter, inputs }
}

fn point_at(coordinates: &[f64]) -> SourcePoint {
    SourcePoint { x0: coordinates[0], y: coordinates[1], z: coordinates[2] }
}

fn aperture_at(coordinates: &[f64]) -> Aperture {
    Aperture { x: coordinates[0], y: coordinates[1], z: coordinates[2] }
}

#[test]
fn speeds_keep_their_digits() {
    let names = ["beta", "gamma", "gamma - 1", "1 - beta", "1/gamma^2", "rapidity", "head-on D"];
    Tally::new(names, cases(), |rng| {
        let (parameter, value) = draw::speed(rng);
        let speed = program_speed(parameter, value);
        let computed = [
            speed.beta(),
            speed.gamma(),
            speed.gamma_minus_one(),
            speed.one_minus_beta(),
            speed.inverse_gamma_squared(),
            speed.rapidity(),
            speed.head_on_doppler_factor(),
        ];
        case(parameter, vec![value], |inputs| model::accessors(parameter, &inputs[0]), computed)
    })
    .assert_within(MAX_ERROR_UNITS)
    .assert_as_documented(include_str!("../../src/speed.rs"), &names);
}

/// Speed parameter, x0, y, z, aperture x, y, z, T.
fn sighting_inputs(rng: &mut ChaCha8Rng) -> (Parameter, Speed, Vec<f64>) {
    let (parameter, value) = draw::speed(rng);
    let speed = program_speed(parameter, value);
    let mut inputs = vec![value];
    inputs.extend([(); 6].map(|()| draw::length(rng)));
    let rho = (inputs[2] - inputs[5]).hypot(inputs[3] - inputs[6]);
    inputs.push(draw::time(rng, speed.beta(), [inputs[1] - inputs[4], inputs[2] - inputs[5], rho], UNIT_F64));
    (parameter, speed, inputs)
}

#[test]
fn sightings_are_as_accurate_as_their_inputs() {
    let names = ["X", "t", "tau", "R", "D", "D^2", "D^3", "D^4", "wavelength", "phi", "theta"];
    let tally = Tally::new(names, cases(), |rng| {
        let (parameter, speed, mut inputs) = sighting_inputs(rng);
        let seen = sighting(&speed, point_at(&inputs[1..]), aperture_at(&inputs[4..]), inputs[7])
            .expect("inside the domain");
        inputs.push(550.0);
        let computed = [
            seen.position[0],
            seen.retarded_time,
            seen.proper_time,
            seen.distance,
            seen.doppler_factor,
            seen.intensity(2.0),
            intensity_factor(seen.doppler_factor, 3.0),
            intensity_factor(seen.doppler_factor, 4.0),
            received_wavelength(inputs[8], seen.doppler_factor),
            seen.phi(),
            seen.theta(),
        ];
        case(parameter, inputs, |inputs| model::sighting(parameter, inputs), computed)
    });
    tally.assert_within(MAX_ERROR_UNITS);
    tally.assert_as_documented(
        include_str!("../../src/apparent.rs"),
        &["X", "t", "tau", "R", "D", "phi", "theta"],
    );
    tally.assert_as_documented(include_str!("../../src/doppler.rs"), &["D^2", "D^3", "D^4", "wavelength"]);
}

#[test]
fn the_printed_formula_is_evaluated_accurately() {
    Tally::new(["X as printed"], cases(), |rng| {
        let (parameter, speed, inputs) = sighting_inputs(rng);
        let x = printed_apparent_x(&speed, point_at(&inputs[1..]), aperture_at(&inputs[4..]), inputs[7])
            .expect("inside the domain");
        case(parameter, inputs, |inputs| model::printed_x(parameter, inputs), [x])
    })
    .assert_within(MAX_ERROR_UNITS);
}

/// Speed parameter, x0, y, z, T, d.
fn pair_inputs(rng: &mut ChaCha8Rng) -> (Parameter, Speed, Vec<f64>) {
    let (parameter, value) = draw::speed(rng);
    let speed = program_speed(parameter, value);
    let [x0, y, z] = [(); 3].map(|()| draw::length(rng));
    let rho = y.hypot(z);
    let d = draw::separation(rng, rho);
    let time = draw::time(rng, speed.beta(), [x0, y, rho.hypot(d / 2.0)], UNIT_F64);
    (parameter, speed, vec![value, x0, y, z, time, d])
}

#[test]
fn disparities_of_the_papers_pair_keep_their_digits_however_close_the_apertures() {
    Tally::new(["dphi", "dtheta"], cases(), |rng| {
        let (parameter, speed, inputs) = pair_inputs(rng);
        let [left, right] = Aperture::pair(inputs[5]);
        let both =
            disparity(&speed, point_at(&inputs[1..]), left, right, inputs[4]).expect("inside the domain");
        let model = |inputs: &[_]| model::pair_disparity(parameter, inputs);
        case(parameter, inputs, model, [both.dphi, both.dtheta])
    })
    .assert_within(MAX_ERROR_UNITS)
    .assert_as_documented(include_str!("../../src/disparity.rs"), &["dphi", "dtheta"]);
}

#[test]
fn one_light_cone_for_both_keeps_its_digits_however_close_the_apertures() {
    let names = ["X_l", "X_r", "t", "D", "dphi", "dtheta"];
    Tally::new(names, cases(), |rng| {
        let (parameter, speed, mut inputs) = pair_inputs(rng);
        // Often the middle sees the point beside an aperture: but not within it, as far as roundings tell.
        if rng.random() {
            let middle = sighting(&speed, point_at(&inputs[1..]), Aperture::default(), inputs[4]);
            let x = middle.expect("inside the domain").position[0].abs();
            let is_within = inputs[2].hypot(inputs[3]) < 1e-3 * x;
            inputs[5] = draw::near(rng, 2.0 * x, if is_within { 1e-9 } else { 1e-17 });
        }
        let both = one_cone_disparity(&speed, point_at(&inputs[1..]), Aperture::pair(inputs[5]), inputs[4])
            .expect("inside the domain");
        let [left, right] = [both.primary, both.secondary];
        let [x_left, x_right] = [left, right].map(|seen| seen.position[0]);
        let computed = [x_left, x_right, left.retarded_time, right.doppler_factor, both.dphi, both.dtheta];
        case(parameter, inputs, |inputs| model::one_cone(parameter, inputs), computed)
    })
    .assert_within(MAX_ERROR_UNITS)
    .assert_as_documented(include_str!("../../src/one_cone.rs"), &names);
}

#[test]
fn disparities_of_apertures_anywhere_keep_their_digits() {
    Tally::new(["general dphi", "general dtheta"], cases(), |rng| {
        let (parameter, speed, sighting) = sighting_inputs(rng);
        let (point, primary, time) = (&sighting[1..4], &sighting[4..7], sighting[7]);
        let scale = draw::log_uniform(rng, -12.0, 0.0);
        let secondary: Vec<f64> = primary.iter().map(|a| a + scale * draw::length(rng)).collect();
        let both = disparity(&speed, point_at(point), aperture_at(primary), aperture_at(&secondary), time)
            .expect("inside the domain");
        let inputs = [&[sighting[0]], point, &[time], primary, &secondary].concat();
        case(parameter, inputs, |inputs| model::disparity(parameter, inputs), [both.dphi, both.dtheta])
    })
    .assert_within(MAX_ERROR_UNITS)
    .assert_as_documented(include_str!("../../src/disparity.rs"), &["general dphi", "general dtheta"]);
}

/// Returns the inputs of [`pair_inputs`], and also apertures that coincide, and points that pass through an
/// aperture.
fn stereo_inputs(rng: &mut ChaCha8Rng) -> (Parameter, Speed, Vec<f64>) {
    let (parameter, speed, mut inputs) = pair_inputs(rng);
    match rng.random_range(0..6) {
        0 => inputs[5] = 0.0,
        1 => {
            (inputs[2], inputs[3]) = (0.0, 0.0);
            inputs[4] = draw::time_inside(rng, speed.beta(), inputs[1], inputs[5]);
        }
        _ => {}
    }
    (parameter, speed, inputs)
}

#[test]
fn stereo_positions_keep_their_digits_however_close_the_apertures() {
    let names = ["stereo gain", "stereo x", "stereo y", "stereo z"];
    Tally::new(names, cases(), |rng| {
        let (parameter, speed, inputs) = stereo_inputs(rng);
        let fused = stereo(&speed, point_at(&inputs[1..]), Aperture::pair(inputs[5]), inputs[4])
            .expect("inside the domain");
        let [x, y, z] = fused.position;
        case(parameter, inputs, |inputs| model::stereo(parameter, inputs), [fused.gain, x, y, z])
    })
    .assert_within(MAX_ERROR_UNITS)
    .assert_as_documented(include_str!("../../src/stereo.rs"), &names);
}

/// Speed parameter, x0, y, z, T, and from one aperture to the other; the apertures.
fn baseline_inputs(rng: &mut ChaCha8Rng) -> (Parameter, Speed, Vec<f64>, [Aperture; 2]) {
    let (parameter, speed, mut inputs) = pair_inputs(rng);
    let baseline = draw::baseline(rng, inputs[5]);
    inputs.truncate(5);
    inputs.extend(baseline);
    let [x, y, z] = baseline.map(|along| along / 2.0);
    let pair = [Aperture { x: -x, y: -y, z: -z }, Aperture { x, y, z }];
    (parameter, speed, inputs, pair)
}

/// From as far to the left of the left aperture as the right one is to its right: a place near them is known
/// to the rounding of theirs.
#[test]
fn stereo_positions_of_apertures_in_any_direction_keep_their_digits() {
    let names = ["any gain", "any x", "any y", "any z", "miss"];
    Tally::new(names, cases(), |rng| {
        loop {
            let (parameter, speed, inputs, pair) = baseline_inputs(rng);
            let fused = stereo(&speed, point_at(&inputs[1..]), pair, inputs[4]);
            let apertures = pair.map(|Aperture { x, y, z }| [x, y, z]);
            let inputs = [&inputs[..5], apertures.as_flattened()].concat();
            let model = |inputs: &[_]| model::stereo_of_pair(parameter, inputs);
            // What does not meet is drawn again.
            let Ok(Stereo { gain, position: [x, y, z], miss }) = fused else { continue };
            let Aperture { x: dx, y: dy, z: dz } = pair[1];
            return case(parameter, inputs, model, [gain, x + 3.0 * dx, y + 3.0 * dy, z + 3.0 * dz, miss]);
        }
    })
    .assert_within(MAX_ERROR_UNITS)
    .assert_as_documented(include_str!("../../src/stereo.rs"), &names);
}

#[test]
fn equidistance_times_of_apertures_in_any_direction_are_accurate() {
    Tally::new(["any T0"], cases(), |rng| {
        loop {
            let (parameter, speed, mut inputs, pair) = baseline_inputs(rng);
            inputs.remove(4);
            let t0 = equidistance_time(&speed, point_at(&inputs[1..]), pair).expect("inside the domain");
            let model = |inputs: &[_]| model::equidistance_time_of_pair(parameter, inputs);
            let Some(t0) = t0 else { continue };
            return case(parameter, inputs, model, [t0]);
        }
    })
    .assert_within(MAX_ERROR_UNITS);
}

#[test]
fn equidistance_times_are_accurate() {
    Tally::new(["T0"], cases(), |rng| {
        let (parameter, speed, mut inputs) = pair_inputs(rng);
        inputs.remove(4);
        let t0 = equidistance_time(&speed, point_at(&inputs[1..]), Aperture::pair(inputs[4]))
            .expect("inside the domain")
            .expect("moving");
        case(parameter, inputs, |inputs| model::equidistance_time(parameter, inputs), [t0])
    })
    .assert_within(MAX_ERROR_UNITS)
    .assert_as_documented(include_str!("../../src/passage.rs"), &["T0"]);
}

#[test]
fn the_times_at_which_a_point_is_seen_at_a_place_are_accurate() {
    Tally::new(["T"], cases(), |rng| {
        let (parameter, speed, mut inputs) = pair_inputs(rng);
        inputs[4] = draw::length(rng);
        inputs.swap(4, 5);
        let time = observation_time_when_seen_at(
            &speed,
            point_at(&inputs[1..]),
            inputs[5],
            Aperture::pair(inputs[4]),
        )
        .expect("inside the domain")
        .expect("moving");
        case(parameter, inputs, |inputs| model::observation_time_when_seen_at(parameter, inputs), [time])
    })
    .assert_within(MAX_ERROR_UNITS)
    .assert_as_documented(include_str!("../../src/passage.rs"), &["T"]);
}

fn assert_published_is_accurate(variant: PublishedVariant, sign: f64, names: [&'static str; 6]) {
    Tally::new(names, cases(), |rng| {
        let (parameter, speed, inputs) = pair_inputs(rng);
        let both = published_disparity(&speed, point_at(&inputs[1..]), inputs[5], inputs[4], variant)
            .expect("inside the domain");
        let seen = both.secondary;
        let computed = [
            both.dphi,
            both.dtheta,
            seen.position[0],
            seen.retarded_time,
            seen.proper_time,
            seen.doppler_factor,
        ];
        case(parameter, inputs, |inputs| model::published(parameter, sign, inputs), computed)
    })
    .assert_within(MAX_ERROR_UNITS)
    .assert_as_documented(include_str!("../../src/published.rs"), &names);
}

#[test]
fn appendix_a_is_evaluated_accurately() {
    let names = [
        "Appendix A dphi",
        "Appendix A dtheta",
        "Appendix A X_S",
        "Appendix A t_S",
        "Appendix A tau_S",
        "Appendix A D_S",
    ];
    assert_published_is_accurate(PublishedVariant::AppendixA, -1.0, names);
}

#[test]
fn appendix_a_keeps_its_digits_between_the_two_zeros_of_its_elevation_disparity() {
    let inputs = vec![
        14_003.487_521_324_716,
        389.874_342_155_914_63,
        -0.073_871_063_856_676_72,
        -92_888.205_175_239_91,
        92_498.330_680_436_24,
        0.000_631_054_071_644_710_7,
    ];
    let (point, speed) = (point_at(&inputs[1..]), program_speed(Parameter::Gamma, inputs[0]));
    let both = published_disparity(&speed, point, inputs[5], inputs[4], PublishedVariant::AppendixA)
        .expect("inside the domain");
    let model = |inputs: &[_]| {
        let [_, dtheta, ..] = model::published(Parameter::Gamma, -1.0, inputs);
        [dtheta]
    };
    let [error] = case(Parameter::Gamma, inputs, model, [both.dtheta]).errors;
    assert!(error <= MAX_ERROR_UNITS, "{error} units");
}

#[test]
fn the_texts_sign_is_evaluated_accurately() {
    let names = ["text dphi", "text dtheta", "text X_S", "text t_S", "text tau_S", "text D_S"];
    assert_published_is_accurate(PublishedVariant::TextSign, 1.0, names);
}

#[test]
fn aberration_keeps_its_digits_both_ways() {
    let names = ["rest n_x", "rest n_y", "rest n_z", "D along n", "ground n_x", "ground n_y", "ground n_z"];
    Tally::new(names, cases(), |rng| {
        let (parameter, value) = draw::speed(rng);
        let speed = program_speed(parameter, value);
        let n = draw::direction(rng, -speed.beta());
        let [rx, ry, rz] = rest_from_ground(n, &speed);
        let [gx, gy, gz] = ground_from_rest(n, &speed);
        let model = |inputs: &[_]| {
            let [ax, ay, az, doppler] = model::aberration(parameter, 1.0, inputs);
            let [bx, by, bz, _] = model::aberration(parameter, -1.0, inputs);
            [ax, ay, az, doppler, bx, by, bz]
        };
        let computed = [rx, ry, rz, doppler_factor(n, &speed), gx, gy, gz];
        case(parameter, [&[value], &n[..]].concat(), model, computed)
    })
    .assert_within(MAX_ERROR_UNITS)
    .assert_as_documented(include_str!("../../src/aberration.rs"), &names);
}
